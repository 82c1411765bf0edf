"""What the planner tells while it works."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, TypeAlias

from tsplan.gap import relative_gap

if TYPE_CHECKING:
    from collections.abc import Callable

    from tsplan.plans.plan import Plan

FINISHING = "paths and check"
"""The name of the last stage: the search is over, and its plan is made ready."""


@dataclass(frozen=True, slots=True)
class Stage:
    """A stage of the work begins; `elapsed` is in seconds since planning began."""

    name: str
    elapsed: float


@dataclass(frozen=True, slots=True)
class Incumbent:
    """A better plan was found. Calling `plan` makes its paths, which costs time for large teams."""

    stage: str
    objective: float | None
    bound: float | None
    elapsed: float
    plan: Callable[[], Plan] | None = field(default=None, compare=False)

    @property
    def gap(self) -> float | None:
        """Relative distance between objective and bound."""
        return relative_gap(self.objective, self.bound)


@dataclass(frozen=True, slots=True)
class Bound:
    """More is known about how good a plan can be."""

    stage: str
    objective: float | None
    bound: float | None
    elapsed: float

    @property
    def gap(self) -> float | None:
        """Relative distance between objective and bound."""
        return relative_gap(self.objective, self.bound)


Event: TypeAlias = Stage | Incumbent | Bound
