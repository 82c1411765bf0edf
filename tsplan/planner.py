"""Plan a mission: encode, solve, split into paths, and have the plan judged before it is shown."""

from __future__ import annotations

import signal
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from types import FrameType

from tsplan.encode.clock import Clock
from tsplan.encode.problem import Problem, Tuning
from tsplan.encode.readout import class_flow, moves_of
from tsplan.encode.search import Effort
from tsplan.encode.stages import Outcome, Point
from tsplan.events import Bound, Event, Incumbent, Stage
from tsplan.milp.solver import solver as solver_named
from tsplan.mission import Mission
from tsplan.results import (
    AgentPlan,
    MissionRef,
    ModelSize,
    ObjectiveValue,
    Plan,
    SolverUse,
    Status,
    StoppedBy,
    Timings,
    certify,
    decompose,
)

Listener = Callable[[Event], "bool | None"]


@dataclass(frozen=True)
class Settings:
    """How long and how hard to search, and with what; None leaves it to the mission or default."""

    solver: str | None = None
    time_limit: float | None = None
    gap: float | None = None
    threads: int | None = None
    seed: int | None = None
    log: Callable[[str], None] | None = None

    def over(self, mission: Mission) -> Settings:
        """These settings, filled up with what the mission asks for."""
        asked = mission.solver
        return Settings(
            solver=self.solver or asked.name or "highs",
            time_limit=asked.time_limit if self.time_limit is None else self.time_limit,
            gap=(asked.gap if self.gap is None else self.gap) or 0.0,
            threads=asked.threads if self.threads is None else self.threads,
            seed=asked.seed if self.seed is None else self.seed,
            log=self.log,
        )


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
    Ctrl-C does the same. `without` names ideas of the tight encoding to switch off.

    Raises MissionError for unknown names, SolverUnavailableError for a solver that cannot be used
    and SolverError when a solver fails or a plan is refused by the independent check.
    """
    problem = mission if isinstance(mission, Problem) else None
    if problem is None:
        assert isinstance(mission, Mission)
        problem = Problem(mission, Tuning.named(encoding, without))
    settings = Settings(solver, time_limit, gap, threads, seed).over(problem.mission)
    return Run(problem, settings, on_event).plan()


class Run:
    """One planning run."""

    def __init__(self, problem: Problem, settings: Settings, listener: Listener | None) -> None:
        self._problem = problem
        self._settings = settings
        self._listener = listener
        self._stopped = False
        self._clock = Clock(settings.time_limit, lambda: self._stopped)
        self._seconds = {"reduce": 0.0, "solve": 0.0, "extract": 0.0, "verify": 0.0}

    def plan(self) -> Plan:
        """Run all stages and certify what they found."""
        settings = self._settings
        chosen = solver_named(settings.solver or "highs")
        availability = chosen.availability()
        effort = Effort(
            solver=chosen,
            gap=settings.gap or 0.0,
            threads=settings.threads,
            seed=settings.seed,
            log=settings.log,
        )
        began = time.perf_counter()
        _ = self._problem.setting
        self._seconds["reduce"] = time.perf_counter() - began
        began = time.perf_counter()
        with on_interrupt(self._stop):
            outcome = self._problem.solve(effort, self._clock, self._tell)
        self._seconds["solve"] = time.perf_counter() - began
        return self._finished(
            outcome, SolverUse(chosen.name, availability.version or "", self._options())
        )

    def _stop(self) -> None:
        self._stopped = True

    def _options(self) -> dict[str, object]:
        asked = {
            "time_limit": self._settings.time_limit,
            "gap": self._settings.gap,
            "threads": self._settings.threads,
            "seed": self._settings.seed,
        }
        return {name: value for name, value in asked.items() if value is not None}

    def _tell(
        self, stage: str, point: Point | None, value: float | None, bound: float | None
    ) -> None:
        if self._listener is None:
            return
        elapsed = self._clock.elapsed
        event: Event
        if point is not None:
            event = Incumbent(stage, value, bound, elapsed, lambda: self._provisional(point))
        elif value is None and bound is None:
            event = Stage(stage, elapsed)
        else:
            event = Bound(stage, value, bound, elapsed)
        if self._listener(event):
            self._stopped = True

    def _agents(self, point: Point) -> tuple[AgentPlan, ...]:
        """One path per agent, in the order of the team."""
        setting = self._problem.setting
        paths: dict[str, AgentPlan] = {}
        for item, moves in moves_of(setting, point.encoded, point.values, reduced=point.tight):
            flow = class_flow(setting, item, moves)
            made = decompose(flow, setting.horizon, self._settings.seed)
            paths.update((agent.id, agent) for agent in made)
        return tuple(paths[agent.id] for agent in self._problem.mission.agents)

    def _provisional(self, point: Point) -> Plan:
        """The verified plan of a point found on the way."""
        mission = self._problem.mission
        found = Plan(
            status=Status.FEASIBLE,
            stopped_by=StoppedBy.INTERRUPT,
            mission=MissionRef(mission.name, mission.digest),
            horizon=mission.horizon,
            agents=self._agents(point),
        )
        return certify(mission, found)

    def _finished(self, outcome: Outcome, used: SolverUse) -> Plan:
        mission = self._problem.mission
        began = time.perf_counter()
        agents = () if outcome.point is None else self._agents(outcome.point)
        self._seconds["extract"] = time.perf_counter() - began
        stopped = None if outcome.stopped_by is None else StoppedBy(outcome.stopped_by.value)
        if outcome.point is not None:
            status = Status.OPTIMAL if outcome.proven else Status.FEASIBLE
        else:
            status = Status.INFEASIBLE if outcome.infeasible else Status.NO_PLAN_FOUND
        reached = [ObjectiveValue(r.name, r.value, r.bound) for r in outcome.reached]
        made = Plan(
            status=status,
            stopped_by=stopped,
            mission=MissionRef(mission.name, mission.digest),
            horizon=mission.horizon,
            objective=tuple(item for item in reached if item.name != "own"),
            notes=tuple(_own(item) for item in reached if item.name == "own"),
            agents=agents,
            solver=used,
            size=self._size(outcome),
        )
        return self._certified(made)

    def _size(self, outcome: Outcome) -> ModelSize:
        system = self._problem.mission.system
        return ModelSize(*outcome.size, states=len(system.states), edges=len(system.edges))

    def _certified(self, made: Plan) -> Plan:
        """The plan after the independent check, with the seconds of each stage."""
        began = time.perf_counter()
        checked = certify(self._problem.mission, made) if made.has_paths else made
        self._seconds["verify"] = time.perf_counter() - began
        return replace(checked, timings=Timings(**self._seconds, total=self._clock.elapsed))


def _own(item: ObjectiveValue) -> str:
    """A user's own objective in words: the check cannot know what it means."""
    bound = "open" if item.bound is None else f"{item.bound:g}"
    value = "open" if item.value is None else f"{item.value:g}"
    return f"own objective {value} (bound {bound})"


@contextmanager
def on_interrupt(stop: Callable[[], None]) -> Iterator[None]:
    """Ctrl-C asks the search to stop and keep its best plan; a second one interrupts for good."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    former = signal.getsignal(signal.SIGINT)

    def first(_number: int, _frame: FrameType | None) -> None:
        stop()
        signal.signal(signal.SIGINT, former)

    signal.signal(signal.SIGINT, first)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, former)
