"""A linear program that is solved again and again from its last basis, for dives and trees."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Literal, TypeAlias

import numpy as np
from highspy import HighsModelStatus as Ended
from scipy import sparse

from tsplan.errors import SolverError
from tsplan.milp.highs import checked, load
from tsplan.milp.model import Floats, Ints, Model
from tsplan.milp.solution import Solution, Status, settled

LPStatus: TypeAlias = Literal["optimal", "infeasible", "cutoff", "limit"]
_NO_CUTOFF = float("inf")


@dataclass(frozen=True, eq=False)
class LPResult:
    """The end of one LP solve; `objective` is infinite unless it is optimal."""

    status: LPStatus
    objective: float
    values: Floats | None
    reduced_costs: Floats | None
    seconds: float


class WarmLP:
    """The LP relaxation of a model, kept in HiGHS with its simplex basis.

    Integrality is ignored. `stop` is asked now and then while solving; once it is true the solve
    ends with status "limit".
    """

    def __init__(self, model: Model, stop: Callable[[], bool] = lambda: False) -> None:
        self._highs = load(model, relaxed=True)
        self._stop = stop
        self._highs.cbSimplexInterrupt += self._interrupt
        self._known = settled(model)
        checked(self._highs.setOptionValue("solver", "simplex"), "the simplex solver")

    def _interrupt(self, event: Any) -> None:
        if self._stop():
            event.interrupt()

    def bounds(self, columns: Ints, lower: Floats, upper: Floats) -> None:
        """New bounds for some columns."""
        status = self._highs.changeColsBounds(
            len(columns), columns.astype(np.int32), lower.astype(float), upper.astype(float)
        )
        checked(status, "column bounds")

    def add_rows(self, rows: sparse.csr_array, lower: Floats, upper: Floats) -> None:
        """More rows, `lower <= rows @ x <= upper`."""
        status = self._highs.addRows(
            rows.shape[0],
            lower,
            upper,
            rows.nnz,
            rows.indptr[:-1].astype(np.int32),
            rows.indices.astype(np.int32),
            rows.data.astype(float),
        )
        checked(status, "rows")

    def solve(self, time_limit: float | None = None, cutoff: float | None = None) -> LPResult:
        """Solve from the last basis; give up above `cutoff` or after `time_limit` seconds."""
        if self._known is not None:
            return _result(self._known)
        highs = self._highs
        bound = _NO_CUTOFF if cutoff is None else float(cutoff)
        checked(highs.setOptionValue("objective_bound", bound), "the cutoff")
        # HiGHS counts the seconds of all its runs together
        limit = _NO_CUTOFF if time_limit is None else highs.getRunTime() + time_limit
        checked(highs.setOptionValue("time_limit", limit), "the time limit")
        began = time.perf_counter()
        checked(highs.run(), "the linear program")
        seconds = time.perf_counter() - began
        ended = highs.getModelStatus()
        if ended == Ended.kUnboundedOrInfeasible:
            ended = Ended.kInfeasible  # flows are bounded, so it cannot be unbounded
        if ended == Ended.kOptimal:
            solution = highs.getSolution()
            return LPResult(
                "optimal",
                highs.getObjectiveValue(),
                np.array(solution.col_value),
                np.array(solution.col_dual),
                seconds,
            )
        if ended == Ended.kInfeasible:
            return LPResult("infeasible", np.inf, None, None, seconds)
        if ended in (Ended.kObjectiveBound, Ended.kObjectiveTarget):
            return LPResult("cutoff", np.inf, None, None, seconds)
        if ended in (Ended.kTimeLimit, Ended.kInterrupt, Ended.kIterationLimit):
            return LPResult("limit", np.inf, None, None, seconds)
        raise SolverError(
            f"HiGHS could not solve a linear program: {highs.modelStatusToString(ended)}"
        )


def _result(solution: Solution) -> LPResult:
    """The result of a model that was settled before it was solved."""
    if solution.status == Status.INFEASIBLE:
        return LPResult("infeasible", np.inf, None, None, 0.0)
    return LPResult("optimal", solution.objective or 0.0, np.empty(0), np.empty(0), 0.0)
