"""What is asked of a solver and what it answers, in terms no solver owns."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from typing import TypeAlias

import numpy as np

from tsplan.milp.model import Floats, Model


class Status(StrEnum):
    """What is known about a model when its solver ends."""

    OPTIMAL = "optimal"
    FEASIBLE = "feasible"
    INFEASIBLE = "infeasible"
    UNKNOWN = "unknown"


class StoppedBy(StrEnum):
    """What ended a solve before its question was settled."""

    TIME_LIMIT = "time_limit"
    GAP = "gap"
    INTERRUPT = "interrupt"
    MEMORY = "memory"


_LIMITS = frozenset({StoppedBy.TIME_LIMIT, StoppedBy.INTERRUPT, StoppedBy.MEMORY})
_POSSIBLE: Mapping[Status, frozenset[StoppedBy | None]] = {
    Status.OPTIMAL: frozenset({None}),
    Status.FEASIBLE: frozenset({*_LIMITS, StoppedBy.GAP, None}),
    Status.INFEASIBLE: frozenset({None}),
    Status.UNKNOWN: _LIMITS,
}


@dataclass(frozen=True, eq=False)
class Solution:
    """The end of a solve. `bound` is a true lower bound on the objective of the model solved.

    FEASIBLE without a `stopped_by` is the answer to `Options.first`. Raises ValueError for a
    status that contradicts what stopped the solve or whether there are values.
    """

    status: Status
    stopped_by: StoppedBy | None = None
    values: Floats | None = None
    objective: float | None = None
    bound: float | None = None
    seconds: float = 0.0
    nodes: int = 0

    def __post_init__(self) -> None:
        if self.stopped_by not in _POSSIBLE[self.status]:
            raise ValueError(f"{self.status} cannot have been stopped by {self.stopped_by}")
        if (self.values is not None) != (self.status in (Status.OPTIMAL, Status.FEASIBLE)):
            raise ValueError(f"{self.status} and values do not go together")


@dataclass(frozen=True, eq=False)
class Options:
    """How to solve one model. Limits in seconds; gaps as the field defines them.

    `first` stops at the first feasible point, `cutoff` asks only for points below it, `start` is a
    known point. `extra` goes to the solver under its own names.
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
    extra: Mapping[str, object] = field(default_factory=dict)


@dataclass(frozen=True, eq=False)
class Progress:
    """Where a running solve is. `values` are set when a new incumbent can be handed over."""

    objective: float | None
    bound: float | None
    elapsed: float
    values: Floats | None = None


Watcher: TypeAlias = Callable[[Progress], bool]
"""Called while solving; returning True asks the solver to stop and keep its best point."""


def settled(model: Model) -> Solution | None:
    """The solution of a model that its rows' constants or its lack of columns settle, else None.

    Solvers and modelling layers differ in what they make of rows without entries.
    """
    empty = np.diff(model.matrix.indptr) == 0
    if bool(((model.row_lower > 0) | (model.row_upper < 0))[empty].any()):
        return Solution(Status.INFEASIBLE)
    if not model.size.columns:
        return Solution(Status.OPTIMAL, None, np.empty(0), model.offset, model.offset)
    return None
