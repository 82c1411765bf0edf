"""What every planning run does, whatever it plans: time, events, Ctrl-C, judging, bookkeeping."""

from __future__ import annotations

import gc
import time
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from typing import Generic, TypedDict, TypeVar

from tsplan.checking.plan_check import certify
from tsplan.milp.solver import solver as solver_named
from tsplan.milp.solver_choice import DEFAULT_CHOICE, SolverChoice
from tsplan.mission import Mission
from tsplan.plans.moves import Move
from tsplan.plans.plan import (
    AgentPlan,
    MissionRef,
    ModelSize,
    ObjectiveValue,
    Plan,
    SolverUse,
    Status,
    Timings,
)
from tsplan.plans.satisfaction import Depth, Satisfaction
from tsplan.process.interrupt import on_interrupt
from tsplan.process.quiet_output import audible, hushed_alone
from tsplan.run.events import FINISHING, Bound, Event, Incumbent, Stage
from tsplan.search.clock import Clock, Halted
from tsplan.search.effort import Effort
from tsplan.search.lexicographic import Reached
from tsplan.stopping import StoppedBy, true_reason
from tsplan.words import known

FoundT = TypeVar("FoundT")
Listener = Callable[[Event], "bool | None"]


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
    stopped_by: StoppedBy | None
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

    def __init__(self, mission: Mission, choice: SolverChoice, listener: Listener | None) -> None:
        self._mission = mission
        self._choice = choice.over(mission.solver).over(DEFAULT_CHOICE)
        self._listener = listener
        self._stopped: float | None = None  # seconds after which it was asked to stop
        self._newest: FoundT | None = None
        self._clock = Clock(self._choice.time_limit, lambda: self._stopped is not None)
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
        """Run all stages and certify what they found.

        Ctrl-C and the listener ask every stage to end with what is known. Where memory runs out,
        the best plan known is certified, with that as the reason.
        """
        with on_interrupt(self._stop), hushed_alone():
            return self._planned()

    def _planned(self) -> Plan:
        solver = solver_named(self._choice.name or "")
        version = solver.availability().version or ""
        used = SolverUse(solver.name, version, self._choice.numbers)
        result = self._searched(Effort(solver, self._choice))
        with _uncollected():
            return self._finished(result, used)

    def _searched(self, effort: Effort) -> Result[FoundT]:
        """What the search finds; where it was halted, the last that was heard of."""
        began = time.perf_counter()
        try:
            self.prepare()
            self._seconds["reduce"] = time.perf_counter() - began
            began = time.perf_counter()
            return self.search(effort, self._clock, self._tell)
        except Halted as halted:
            return self._halted(halted.reason, halted.words)
        except MemoryError:
            # what was being built is gone with the error, so there is room again
            return self._halted(StoppedBy.MEMORY)
        finally:
            built = self._seconds["build"] = self._clock.spent.get("build", 0.0)
            self._seconds["solve"] = time.perf_counter() - began - built

    def _halted(self, reason: StoppedBy, words: str = "") -> Result[FoundT]:
        """The last plan that was heard of, if any, and why there is no more."""
        return Result(
            self._newest,
            reached=(),
            proven=False,
            infeasible=False,
            stopped_by=reason,
            size=(0, 0, 0, 0),
            notes=(words,) if words else (),
        )

    def _stop(self) -> None:
        if self._stopped is None:
            self._stopped = self._clock.elapsed

    def _tell(
        self, stage: str, found: FoundT | None, value: float | None, bound: float | None
    ) -> None:
        """The gate through which all news pass: what is infinite is not known out there."""
        if found is not None:
            self._newest = found
        if self._listener is None:
            return
        elapsed = self._clock.elapsed
        value, bound = known(value), known(bound)
        event: Event
        if found is not None:
            event = Incumbent(stage, value, bound, elapsed, lambda: self._provisional(found))
        elif value is None and bound is None:
            event = Stage(stage, elapsed)
        else:
            event = Bound(stage, value, bound, elapsed)
        if audible(self._listener)(event):
            self._stop()

    def _provisional(self, found: FoundT) -> Plan:
        """The verified plan of something found on the way."""
        mission = self._mission
        made = Plan(
            status=Status.FEASIBLE,
            stopped_by=StoppedBy.INTERRUPT,
            mission=MissionRef(mission.name, mission.digest),
            horizon=mission.horizon,
            objective=self._open(),
            **self.ways(found),
        )
        return certify(mission, made)

    def _open(self) -> tuple[ObjectiveValue, ...]:
        """The objectives of the mission, nothing known of them: the check fills their values in."""
        mission = self._mission
        return tuple(ObjectiveValue(name, None, None) for name in mission.objective)

    def _finished(self, result: Result[FoundT], used: SolverUse) -> Plan:
        mission = self._mission
        if result.found is not None:
            self._tell(FINISHING, None, None, None)
        began = time.perf_counter()
        ways = Ways() if result.found is None else self.ways(result.found)
        self._seconds["extract"] = time.perf_counter() - began
        # values are those that the check measures on the paths
        reached = [ObjectiveValue(r.name, None, known(r.bound)) for r in result.reached]
        if result.found is not None and not reached:
            reached = list(self._open())
        made = Plan(
            status=result.status,
            stopped_by=true_reason(result.stopped_by, self._stopped, self._clock.limit),
            mission=MissionRef(mission.name, mission.digest),
            horizon=mission.horizon,
            objective=tuple(item for item in reached if item.name != "own"),
            satisfaction=result.satisfaction,
            notes=result.notes,
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
def _uncollected() -> Iterator[None]:
    """Without the garbage collector: of millions of paths that stay it would search all, often."""
    enabled = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if enabled:
            gc.enable()
