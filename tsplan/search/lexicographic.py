"""Objectives one after the other: the first matters most, and what is reached is kept.

This is the order of the work, whatever is planned: some point is found first, then each objective
is settled among those points that lose nothing of the ones before. A stage that is halted, or
whose solver fails, leaves the best point known and the bounds proven so far.
"""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from typing import Generic, Protocol, TypeAlias, TypeVar

from tsplan.clock import Clock, Halted
from tsplan.errors import SolverError
from tsplan.milp.model import Floats
from tsplan.plans.outcomes import CERTIFIED, ObjectiveValue, Status
from tsplan.stopping import StoppedBy


class _Named(Protocol):
    @property
    def name(self) -> str: ...


PointT = TypeVar("PointT")
AimT = TypeVar("AimT", bound=_Named)
GivenT = TypeVar("GivenT")

Tell: TypeAlias = Callable[[str, "PointT | None", "float | None", "float | None"], None]
"""Hears of a stage, a point, the value of the best plan and a bound, in the objective's unit."""


@dataclass(frozen=True, eq=False)
class Found:
    """The best point known, a true lower bound, and whether the search was carried to its end.

    `objective` and `bound` are values of the target. `proven` without values means that there is
    no point, with values that none is better; a search that was `stopped_by` a gap is not. What is
    `certified` was worked out exactly, and rests on no solver being right, but on the encoding, and
    on what is named of it in `rests`.
    """

    values: Floats | None
    objective: float | None
    bound: float
    proven: bool
    stopped_by: StoppedBy | None = None
    certified: bool = False
    rests: frozenset[str] = frozenset()


@dataclass(frozen=True, eq=False)
class Outcome(Generic[PointT]):
    """How a search ended: the best point, what is proven of each objective, the model's size.

    `size` counts columns, integer columns, rows and nonzeros; `levels` has what an objective
    consists of that is settled in steps. That there is no point may be `certified`, and `rests` on
    something, as with `Found`.
    """

    point: PointT | None = None
    reached: tuple[ObjectiveValue, ...] = ()
    proven: bool = False
    infeasible: bool = False
    stopped_by: StoppedBy | None = None
    size: tuple[int, int, int, int] = (0, 0, 0, 0)
    levels: tuple[ObjectiveValue, ...] = ()
    notes: tuple[str, ...] = ()
    certified: bool = False
    rests: frozenset[str] = frozenset()

    @property
    def status(self) -> Status:
        """What is known."""
        if self.point is not None:
            return Status.OPTIMAL if self.proven else Status.FEASIBLE
        return Status.INFEASIBLE if self.infeasible else Status.NO_PLAN_FOUND


class Lexicographic(ABC, Generic[PointT, AimT]):
    """Settles objectives in order; a kind of problem says how each of them is.

    `point` is the best one known, `size` that of the model of all points.
    """

    objectives: tuple[AimT, ...]
    clock: Clock

    def __init__(self, clock: Clock) -> None:
        self.clock = clock
        self.point: PointT | None = None
        self.size = (0, 0, 0, 0)
        self._stopped: StoppedBy | None = None
        self._notes: list[str] = []
        self._backing: dict[str, frozenset[str]] = {}  # what the certified bounds rest on

    @abstractmethod
    def opened(self, opening: AimT | None) -> Found:
        """Any point; by way of the first objective where that may find one."""

    @abstractmethod
    def settled(self, objective: AimT, done: Found | None) -> float | None:
        """Settle one objective and keep what it reached; its bound. It may be `done` already."""

    @abstractmethod
    def worth(self, objective: AimT, point: PointT) -> float:
        """What a point is worth in an objective's own unit."""

    @property
    def opening(self) -> AimT | None:
        """The first objective, where some point is found by settling it at once."""
        return None

    def told_bound(self, objective: AimT, value: float, bound: float | None) -> float | None:
        """What is told of a bound, given what the last point is worth."""
        return bound

    def finished(self, point: PointT) -> PointT:
        """The point with what is left to decide at the end."""
        return point

    def run(self) -> Outcome[PointT]:
        """All stages until the time is up; the best point known is kept throughout."""
        opening = self.opening
        found = self.guarded("first plan", lambda: self.opened(opening))
        if self.point is None:
            outcome = self._outcome((), infeasible=found is not None and found.proven)
            known = found or Found(None, None, -math.inf, proven=False)
            return replace(outcome, certified=known.certified, rests=known.rests)
        reached = []
        for number, objective in enumerate(self.objectives):
            done = found if number == 0 and opening is not None else None
            bound = self.guarded(objective.name, partial(self.settled, objective, done))
            reached.append(self._bounded(objective.name, bound))
        return self._outcome(tuple(reached), infeasible=False)

    def backed(self, name: str, found: Found) -> None:
        """Remember what the bound of an objective rests on, if it is certified."""
        self._backing.pop(name, None)
        if found.certified:
            self._backing[name] = found.rests

    def _bounded(self, name: str, bound: float | None) -> ObjectiveValue:
        if bound is None or name not in self._backing:
            return ObjectiveValue(name, None, bound)
        return ObjectiveValue(name, None, bound, CERTIFIED, tuple(sorted(self._backing[name])))

    def _outcome(self, reached: tuple[ObjectiveValue, ...], *, infeasible: bool) -> Outcome[PointT]:
        point = self.point
        if point is not None:
            point = self.point = self.guarded("sizes", partial(self.finished, point)) or point
            worths = [self.worth(objective, point) for objective in self.objectives[: len(reached)]]
            reached = tuple(
                replace(item, value=value, bound=self.told_bound(objective, value, item.bound))
                for item, objective, value in zip(reached, self.objectives, worths, strict=False)
            )
        proven = point is not None and all(item.proven for item in reached)
        stopped = None
        if not proven and not infeasible:
            stopped = self._stopped or self.clock.stopped_by or StoppedBy.PRECISION
        notes = tuple(self._notes)
        return Outcome(point, reached, proven, infeasible, stopped, self.size, notes=notes)

    def guarded(self, name: str, stage: Callable[[], GivenT]) -> GivenT | None:
        """One stage; where it is halted or the solver fails, the point that is known is kept."""
        try:
            return stage()
        except Halted as halted:
            self.stopping(halted.reason)
            self._notes += [halted.words] if halted.words else []
        except SolverError as error:
            if self.point is None:
                raise
            self._notes.append(f"{name} is not proven: {error}")
            self.stopping(StoppedBy.PRECISION)
        return None

    def stopping(self, reason: StoppedBy | None) -> None:
        """Remember why something was not settled; the first reason counts."""
        self._stopped = self._stopped or reason

    def noted(self, words: str) -> None:
        """Tell something to the reader of the plan."""
        self._notes.append(words)
