"""What the planner tells while it works."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, TypeAlias

from tsplan.exact import Gapped

if TYPE_CHECKING:
    from collections.abc import Callable

FINISHING = "paths and check"
"""The name of the last stage: the search is over, and its plan is made ready."""


@dataclass(frozen=True, slots=True)
class Stage:
    """A stage of the work begins; `elapsed` is in seconds since planning began."""

    name: str
    elapsed: float


@dataclass(frozen=True, slots=True)
class _News(Gapped):
    stage: str
    objective: float | None
    bound: float | None
    elapsed: float


@dataclass(frozen=True, slots=True)
class Incumbent(_News):
    """A better plan was found. Calling `plan` makes it, which costs time for large teams."""

    plan: Callable[[], Any] | None = field(default=None, compare=False)


@dataclass(frozen=True, slots=True)
class Bound(_News):
    """More is known about how good a plan can be."""


Event: TypeAlias = Stage | Incumbent | Bound
