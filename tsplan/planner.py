"""Plan a mission: encode, solve, split into paths, and have the plan judged before it is shown."""

from __future__ import annotations

from tsplan.encode.clock import Clock
from tsplan.encode.effort import Effort
from tsplan.encode.problem import Problem, Tuning
from tsplan.encode.readout import class_flow, moves_of
from tsplan.encode.stages import Point
from tsplan.errors import Finding, MissionError
from tsplan.mission import Mission
from tsplan.results import AgentPlan, Plan, decompose
from tsplan.running import Listener, Result, Run, Settings, Tell, Ways, claimed_depths


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
    on_event: Listener | None = None,
) -> Plan:
    """Plan a mission, or a `Problem` made from one: a verified plan, or why there is none.

    `time_limit` is in seconds, `gap` relative; what is None comes from the mission. `on_event` is
    called with every `Event`; when it returns True the search stops and the best plan is kept.
    Ctrl-C does the same. `without` names ideas of the tight encoding to switch off. The plan of a
    swarm mission has its moves and sub-swarms, and the agents' paths too if there are at most
    1,000; `assign` makes them for more.

    Raises MissionError for unknown names, SolverUnavailableError for a solver that cannot be used
    and SolverError when a solver fails or a plan is refused by the independent check.
    """
    asked = Settings(solver, time_limit, gap, threads, seed)
    tuning = Tuning.named(encoding, without)
    if isinstance(mission, Mission) and mission.swarm is not None:
        from tsplan.swarming import SwarmRun  # noqa: PLC0415  (teams do not need it)

        _refuse_tuning(tuning)
        return SwarmRun(mission, asked.over(mission), on_event).plan()
    problem = mission if isinstance(mission, Problem) else Problem(mission, tuning)
    return TeamRun(problem, asked.over(problem.mission), on_event).plan()


class TeamRun(Run[Point]):
    """One planning run for a team."""

    def __init__(self, problem: Problem, settings: Settings, listener: Listener | None) -> None:
        super().__init__(problem.mission, settings, listener)
        self._problem = problem

    def prepare(self) -> None:
        """Sort the team into classes and reduce their maps."""
        self._problem.prepared(self._clock)

    def search(self, effort: Effort, clock: Clock, tell: Tell[Point]) -> Result[Point]:
        """Run all objectives of the problem."""
        outcome = self._problem.solve(effort, clock, tell)
        return Result(
            outcome.point,
            outcome.reached,
            outcome.proven,
            outcome.infeasible,
            outcome.stopped_by,
            outcome.size,
            None if outcome.point is None else claimed_depths(self._mission, outcome.levels),
            outcome.notes,
        )

    def ways(self, found: Point) -> Ways:
        """One path per agent, in the order of the team."""
        setting = self._problem.setting
        paths: dict[str, AgentPlan] = {}
        for item, moves in moves_of(setting, found.encoded, found.values, reduced=found.tight):
            flow = class_flow(setting, item, moves)
            made = decompose(flow, setting.horizon, self._settings.seed)
            paths.update((agent.id, agent) for agent in made)
        return Ways(agents=tuple(paths[agent.id] for agent in self._mission.agents))


def _refuse_tuning(tuning: Tuning) -> None:
    """Swarms have one encoding, whose ideas cannot be switched off."""
    if tuning != Tuning():
        what = "a swarm mission has one encoding, which cannot be chosen or changed"
        raise MissionError([Finding(what, "leave out the encoding and its ideas")])
