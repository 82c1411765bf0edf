"""Plan a mission: encode, solve, split into paths, and have the plan judged before it is shown."""

from __future__ import annotations

from dataclasses import replace
from os import PathLike
from pathlib import Path

from tsplan.milp.solver_choice import SolverChoice
from tsplan.mission import Mission
from tsplan.plans.plan import Plan
from tsplan.process.quiet_output import Hear
from tsplan.run.certificate_files import refuse_without, write_certificates
from tsplan.run.mission_run import MissionRun
from tsplan.run.problem import Problem, Tuning
from tsplan.run.run import Listener


def plan(
    mission: Mission | Problem,
    *,
    time_limit: float | None = None,
    solver: str | None = None,
    gap: float | None = None,
    threads: int | None = None,
    seed: int | None = None,
    encoding: str = "tight",
    without: tuple[str, ...] = (),
    start: Plan | None = None,
    on_event: Listener | None = None,
    on_log: Hear | None = None,
    certified: bool = False,
    certificate: str | PathLike[str] | None = None,
) -> Plan:
    """Plan a mission, or a `Problem` made from one: a verified plan, or why there is none.

    `time_limit` is in seconds, `gap` relative; what is None comes from the mission. `on_event` is
    called with every `Event`; when it returns True the search stops and the best plan is kept.
    Ctrl-C does the same. What `on_event` raises ends the search and is raised here. `on_log` hears
    what the solver says. `without` names methods of the tight encoding to switch off. The search
    begins with the paths of a plan to `start` with, see `Problem.start_from`. A `certified` plan
    takes no solver's word for a proof: what the own search tree does not prove in exact arithmetic
    stays open. With a `certificate` it is such a plan, and what proves it is written to that file
    in the VIPR format; of several objectives to numbered ones. The plan of a swarm mission has its
    moves and sub-swarms, and the agents' paths too if there are at most 1,000; `assign` makes them
    for more.

    Raises MissionError for unknown names, InputError for numbers out of range,
    SolverUnavailableError for a solver that cannot be used, and SolverError when a solver fails or
    a plan is refused by the independent check.
    """
    choice = SolverChoice(solver, time_limit, gap, threads, seed).checked()
    tuning = Tuning.named(encoding, without)
    problem = mission if isinstance(mission, Problem) else Problem(mission, tuning)
    if start is not None:
        problem = problem.tuned(problem.tuning)
        problem.start_from(start)
    run = MissionRun(problem, choice, on_event, on_log, certified=certified)
    if certificate is None:
        return run.result().with_mission(problem.mission)
    refuse_without(problem)
    run.alone, run.proofs = True, []
    made = run.result()
    told = write_certificates(problem.mission, made, run.proofs, Path(certificate))
    return replace(made, notes=(*made.notes, *told)).with_mission(problem.mission)
