"""What every planning run does, whatever it plans: time, events, Ctrl-C, judging, bookkeeping."""

from __future__ import annotations

import math
import signal
import threading
import time
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from types import FrameType
from typing import Generic, TypedDict, TypeVar

from tsplan.encode.clock import Clock, Halted
from tsplan.encode.effort import Effort
from tsplan.encode.stages import Reached
from tsplan.events import Bound, Event, Incumbent, Stage
from tsplan.exact import digits
from tsplan.milp.solution import StoppedBy as Stopped
from tsplan.milp.solver import solver as solver_named
from tsplan.mission import Mission
from tsplan.results import (
    AgentPlan,
    MissionRef,
    ModelSize,
    Move,
    ObjectiveValue,
    Plan,
    SolverUse,
    Status,
    StoppedBy,
    Timings,
    certify,
)
from tsplan.results.satisfaction import Depth, Satisfaction

FoundT = TypeVar("FoundT")
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


@dataclass(frozen=True)
class Result(Generic[FoundT]):
    """How a search ended: what it found, what is proven, and the size of its model.

    `size` counts columns, integer columns, rows and nonzeros. `satisfaction` has what is proven
    about a formula that may hold in part; the check fills in what holds.
    """

    found: FoundT | None
    reached: tuple[Reached, ...]
    proven: bool
    infeasible: bool
    stopped_by: Stopped | None
    size: tuple[int, int, int, int]
    satisfaction: Satisfaction | None = None
    notes: tuple[str, ...] = ()

    @property
    def status(self) -> Status:
        """What is known."""
        if self.found is not None:
            return Status.OPTIMAL if self.proven else Status.FEASIBLE
        return Status.INFEASIBLE if self.infeasible else Status.NO_PLAN_FOUND


class Ways(TypedDict, total=False):
    """Where everybody goes, as fields of a plan."""

    agents: tuple[AgentPlan, ...]
    moves: dict[str, tuple[Move, ...]]


Tell = Callable[[str, FoundT | None, float | None, float | None], None]


class Run(ABC, Generic[FoundT]):
    """One planning run. What it searches, and how that becomes paths, is said by each kind."""

    def __init__(self, mission: Mission, settings: Settings, listener: Listener | None) -> None:
        self._mission = mission
        self._settings = settings
        self._listener = listener
        self._stopped = False
        self._found: FoundT | None = None
        self._clock = Clock(settings.time_limit, lambda: self._stopped)
        self._seconds = {"reduce": 0.0, "build": 0.0, "solve": 0.0, "extract": 0.0, "verify": 0.0}

    @abstractmethod
    def prepare(self) -> None:
        """Make what the search needs."""

    @abstractmethod
    def search(self, effort: Effort, clock: Clock, tell: Tell[FoundT]) -> Result[FoundT]:
        """Run all objectives; `tell` hears of stages, of what is found, and of bounds."""

    @abstractmethod
    def ways(self, found: FoundT) -> Ways:
        """Where everybody goes by what was found."""

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
        used = SolverUse(chosen.name, availability.version or "", self._options())
        # to the end: what was found is made into paths and checked after the first Ctrl-C too
        with on_interrupt(self._stop):
            return self._finished(self._searched(effort), used)

    def _searched(self, effort: Effort) -> Result[FoundT]:
        """What the search finds; where it was halted, the last that was heard of."""
        began = time.perf_counter()
        try:
            self.prepare()
            self._seconds["reduce"] = time.perf_counter() - began
            began = time.perf_counter()
            return self.search(effort, self._clock, self._tell)
        except Halted as halted:
            reached = tuple(Reached(name, None, None) for name in self._mission.objective)
            return Result(
                self._found,
                reached if self._found is not None else (),
                proven=False,
                infeasible=False,
                stopped_by=halted.reason,
                size=(0, 0, 0, 0),
                notes=(halted.words,) if halted.words else (),
            )
        finally:
            built = self._seconds["build"] = self._clock.spent.get("build", 0.0)
            self._seconds["solve"] = time.perf_counter() - began - built

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
        self, stage: str, found: FoundT | None, value: float | None, bound: float | None
    ) -> None:
        self._found = self._found if found is None else found
        if self._listener is None:
            return
        elapsed = self._clock.elapsed
        event: Event
        if found is not None:
            event = Incumbent(stage, value, bound, elapsed, lambda: self._provisional(found))
        elif value is None and bound is None:
            event = Stage(stage, elapsed)
        else:
            event = Bound(stage, value, bound, elapsed)
        if self._listener(event):
            self._stopped = True

    def _provisional(self, found: FoundT) -> Plan:
        """The verified plan of something found on the way."""
        mission = self._mission
        made = Plan(
            status=Status.FEASIBLE,
            stopped_by=StoppedBy.INTERRUPT,
            mission=MissionRef(mission.name, mission.digest),
            horizon=mission.horizon,
            **self.ways(found),
        )
        return certify(mission, made)

    def _finished(self, result: Result[FoundT], used: SolverUse) -> Plan:
        mission = self._mission
        began = time.perf_counter()
        ways = Ways() if result.found is None else self.ways(result.found)
        self._seconds["extract"] = time.perf_counter() - began
        # values are those that the check measures on the paths
        reached = [ObjectiveValue(r.name, None, known(r.bound)) for r in result.reached]
        made = Plan(
            status=result.status,
            stopped_by=None if result.stopped_by is None else StoppedBy(result.stopped_by.value),
            mission=MissionRef(mission.name, mission.digest),
            horizon=mission.horizon,
            objective=tuple(item for item in reached if item.name != "own"),
            satisfaction=result.satisfaction,
            notes=(*(_own(item) for item in result.reached if item.name == "own"), *result.notes),
            solver=used,
            size=ModelSize(
                *result.size, states=len(mission.system.states), edges=len(mission.system.edges)
            ),
            **ways,
        )
        return self._certified(made)

    def _certified(self, made: Plan) -> Plan:
        """The plan after the independent check, with the seconds of each stage."""
        began = time.perf_counter()
        checked = certify(self._mission, made) if made.has_paths else made
        self._seconds["verify"] = time.perf_counter() - began
        return replace(checked, timings=Timings(**self._seconds, total=self._clock.elapsed))


def known(value: float | None) -> float | None:
    """A number that can be told: what is infinite or undefined is not known, and -0.0 is 0."""
    return value + 0.0 if value is not None and math.isfinite(value) else None


def _own(item: Reached) -> str:
    """A user's own objective in words: the check cannot know what it means."""
    value, bound = (
        "open" if number is None else digits(number)
        for number in (known(item.value), known(item.bound))
    )
    return f"own objective {value} (bound {bound})"


def claimed_depths(mission: Mission, levels: Iterable[Reached]) -> Satisfaction | None:
    """What is proven about the depths of a formula; the check fills in what holds."""
    if not mission.partial:
        return None
    depths = (
        Depth(int(level.name), 0, None if level.bound is None else round(level.bound))
        for level in levels
    )
    return Satisfaction(mission.satisfaction, depths=tuple(depths))


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
