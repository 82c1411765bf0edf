"""What is asked of a solver and what it answers, in terms no solver owns."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from typing import TypeAlias

import numpy as np

from tsplan.exact import Gapped
from tsplan.milp.model import Floats, Model
from tsplan.process.grace_period import NATIVE, GracePeriod
from tsplan.stopping import StoppedBy


class Status(StrEnum):
    """What is known about a model when its solver ends."""

    OPTIMAL = "optimal"
    FEASIBLE = "feasible"
    INFEASIBLE = "infeasible"
    UNKNOWN = "unknown"


_SOLVERS = frozenset(StoppedBy) - {StoppedBy.WINDOW}  # what may stop one solve
_POSSIBLE: Mapping[Status, frozenset[StoppedBy | None]] = {
    Status.OPTIMAL: frozenset({None}),
    Status.FEASIBLE: frozenset({*_SOLVERS, None}),
    Status.INFEASIBLE: frozenset({None}),
    Status.UNKNOWN: _SOLVERS - {StoppedBy.GAP},
}
_ROUNDING = 1e-9


@dataclass(frozen=True, eq=False)
class Solution(Gapped):
    """The end of a solve. `bound` is a true lower bound on the objective of the model solved.

    FEASIBLE without a `stopped_by` is the answer to `Options.first`. INFEASIBLE means that no
    point exists or, with a cutoff, that none beats it. `seconds` is wall-clock time, loading
    included.

    Raises ValueError for a status that contradicts what stopped the solve or what is known: values
    and objective come together and only with OPTIMAL and FEASIBLE, OPTIMAL has a bound, INFEASIBLE
    has none, and no bound is above the objective.

    `silent` says that the solver names no bound of its own, so that `bound` is but its word.
    """

    status: Status
    stopped_by: StoppedBy | None = None
    values: Floats | None = None
    objective: float | None = None
    bound: float | None = None
    seconds: float = 0.0
    nodes: int = 0
    silent: bool = False

    def __post_init__(self) -> None:
        if self.stopped_by not in _POSSIBLE[self.status]:
            raise ValueError(f"{self.status} cannot have been stopped by {self.stopped_by}")
        found = self.status in (Status.OPTIMAL, Status.FEASIBLE)
        if (self.values is not None) != found or (self.objective is not None) != found:
            raise ValueError(f"{self.status} and these values and objective do not go together")
        if self.bound is None:
            if self.status is Status.OPTIMAL:
                raise ValueError("an optimal solution and no bound do not go together")
            return
        if self.status is Status.INFEASIBLE or not math.isfinite(self.bound):
            raise ValueError(f"{self.status} and the bound {self.bound} do not go together")
        if self.objective is not None and self.bound > self.objective + _ROUNDING:
            raise ValueError("a bound above the objective and a point do not go together")


@dataclass(frozen=True, eq=False)
class Options:
    """How to solve one model.

    `time_limit` is in wall-clock seconds from the call on, loading included. The solve may end
    with a relative `gap` (FEASIBLE, stopped by the gap); a gap of at most `absolute_gap` counts as
    none (OPTIMAL), which suits objectives whose values are known to be whole. `threads` None leaves
    the number to the solver, `seed` None its own order. `first` stops at the first feasible point.
    `cutoff` asks only for points below it. `start` is a point believed feasible; if it is, it is
    never lost. `log` gets the solver's lines. `stop` is asked about every 0.1 seconds and stops
    the solve when it returns True. Native code that does not stop within `grace` is left behind.
    Without `presolve` the model is solved as it stands. `extra` goes to the solver under its own
    names.

    Raises ValueError for numbers that mean nothing.
    """

    time_limit: float | None = None
    gap: float = 0.0
    absolute_gap: float = 0.0
    threads: int | None = None
    seed: int | None = None
    first: bool = False
    cutoff: float | None = None
    start: Floats | None = None
    log: Callable[[str], None] | None = None
    stop: Callable[[], bool] | None = None
    presolve: bool = True
    grace: GracePeriod = NATIVE
    extra: Mapping[str, object] = field(default_factory=dict)

    def __post_init__(self) -> None:
        for name in ("time_limit", "gap", "absolute_gap", "cutoff"):
            if math.isnan(getattr(self, name) or 0.0):
                raise ValueError(f"{name} is not a number")
        if self.gap < 0 or self.absolute_gap < 0:
            raise ValueError("a gap cannot be negative")
        if self.threads is not None and self.threads < 1:
            raise ValueError("at least one thread is needed")
        if self.seed is not None and not 0 <= self.seed < 2**31:
            raise ValueError("a seed lies between 0 and 2147483647")


@dataclass(frozen=True, eq=False)
class Progress(Gapped):
    """Where a running solve is. `values` are set when a new incumbent can be handed over."""

    objective: float | None
    bound: float | None
    elapsed: float
    values: Floats | None = None


Watcher: TypeAlias = Callable[[Progress], bool]
"""Called with news in the thread that called `solve`; True asks to stop and keep the best point."""


def presolved(model: Model) -> Solution | None:
    """The solution of a model that needs no solver, else None.

    Solvers and modelling layers differ in what they make of rows without entries, of contradictory
    bounds and of models without columns.
    """
    contradictory = (model.row_lower > model.row_upper).any() or (model.lower > model.upper).any()
    if bool(contradictory) or trivially_infeasible(model):
        return Solution(Status.INFEASIBLE)
    if not model.size.columns:
        return Solution(Status.OPTIMAL, None, np.empty(0), model.offset, model.offset)
    return None


def trivially_infeasible(model: Model) -> bool:
    """Whether a row without entries has bounds that zero does not meet."""
    empty = np.diff(model.matrix.indptr) == 0
    return bool((((model.row_lower > 0) | (model.row_upper < 0)) & empty).any())
