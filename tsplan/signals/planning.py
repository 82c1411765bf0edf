"""Planning missions of either kind, for teams and over signals, or of a file."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any, TypedDict, Unpack, overload

from tsplan.errors import Finding, InputError
from tsplan.mission import Mission
from tsplan.run.planner import plan as plan_team
from tsplan.run.problem import Problem
from tsplan.run.progress_line import ProgressDisplay
from tsplan.signals.signal_files import load_any_mission
from tsplan.signals.signal_mission import SignalMission
from tsplan.signals.synthesis import Synthesis
from tsplan.signals.synthesiser import synthesise_mission

if TYPE_CHECKING:
    from os import PathLike

    from tsplan.plans.plan import Plan
    from tsplan.process.quiet_output import Hear
    from tsplan.run.run import Listener
    from tsplan.signals.trajectory import Trajectory


class Options(TypedDict, total=False):
    """How to plan; what is missing or None comes from the mission."""

    time_limit: float | None
    solver: str | None
    gap: float | None
    threads: int | None
    seed: int | None
    encoding: str
    without: tuple[str, ...]
    start: Plan | None
    on_event: Listener | None
    on_log: Hear | None
    certified: bool
    certificate: str | PathLike[str] | None


@overload
def plan(
    mission: Mission | Problem, *, progress: bool = False, **options: Unpack[Options]
) -> Plan: ...


@overload
def plan(
    mission: SignalMission | Synthesis, *, progress: bool = False, **options: Unpack[Options]
) -> Trajectory: ...


@overload
def plan(
    mission: str | Path, *, progress: bool = False, **options: Unpack[Options]
) -> Plan | Trajectory: ...


def plan(
    mission: Mission | Problem | SignalMission | Synthesis | str | Path,
    *,
    progress: bool = False,
    **options: Unpack[Options],
) -> Plan | Trajectory:
    """Plan a mission, or the file of one: a verified plan, or why there is none.

    A mission for a team, or a `Problem` made from one, gives a `Plan`; one over signals, or a
    `Synthesis`, a `Trajectory`. Both know their mission.

    With `progress` a line below the notebook's cell, or on stderr, says how far the search is.
    `time_limit` is in seconds, `gap` relative, `solver` the name of one, `threads` and `seed` are
    for it; what is not given comes from the mission. `on_event` is called with every `Event`; when
    it returns True the search stops and the best plan is kept. Ctrl-C does the same. What
    `on_event` raises ends the search and is raised here. `on_log` hears what the solver says of
    each integer program, so `on_log=print` shows it. `encoding` is `tight` or `reference`;
    `without` names methods of the tight one to switch off. The search for the plan of a team
    begins with the paths of a plan to `start` with, of this mission or of one like it. A
    `certified` plan of a team takes no solver's word for a proof, and with a `certificate` what
    proves it is written to that file, or to numbered ones (docs/certificates.md). The plan of a
    swarm mission has its moves and sub-swarms, and the agents' paths too if there are at most
    1,000; `assign` makes them for more.

    Raises MissionError for a file with mistakes and for unknown names, InputError for numbers out
    of range, SolverUnavailableError for a solver that cannot be used, and SolverError when a solver
    fails or a plan is refused by the independent check.

    >>> import tsplan
    >>> found = tsplan.plan("mission.yaml")
    >>> found.status.value, found.value("travel"), found.value("agents")
    ('optimal', 2.0, 1.0)
    """
    if isinstance(mission, str | Path):
        mission = load_any_mission(mission)
    if progress:
        with ProgressDisplay(options.get("on_event")) as shown:
            return _planned(mission, {**options, "on_event": shown})
    return _planned(mission, options)


def _planned(
    mission: Mission | Problem | SignalMission | Synthesis, options: Options
) -> Plan | Trajectory:
    if isinstance(mission, SignalMission | Synthesis):
        given: dict[str, Any] = {**options}
        if given.pop("start", None) is not None:
            what = "a plan to start with is one of a team, and this mission is over signals"
            raise InputError([Finding(what, "leave 'start' out")])
        return synthesise_mission(mission, **given)
    return plan_team(mission, **options)
