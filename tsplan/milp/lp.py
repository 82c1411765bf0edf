"""A linear program that is solved again and again from its last basis, for dives and trees."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, Literal, TypeAlias

import numpy as np
import numpy.typing as npt
from scipy import sparse

from tsplan.errors import SolverError
from tsplan.milp.highs import checked, load, set_option
from tsplan.milp.model import Floats, Ints, Model
from tsplan.milp.solution import trivially_infeasible
from tsplan.process.quiet_output import hushed
from tsplan.process.watchdog import Watchdog

with hushed():
    import highspy
    from highspy import HighsModelStatus as Ended
    from highspy import HighsPresolveStatus as Presolved

LPStatus: TypeAlias = Literal["optimal", "infeasible", "cutoff", "limit", "unproven"]
_ENDS: dict[Ended, LPStatus] = {
    Ended.kOptimal: "optimal",
    Ended.kModelEmpty: "optimal",
    Ended.kInfeasible: "infeasible",
    Ended.kObjectiveBound: "cutoff",
    Ended.kObjectiveTarget: "cutoff",
    Ended.kTimeLimit: "limit",
    Ended.kInterrupt: "limit",
    Ended.kIterationLimit: "limit",
}
_LARGE = 100_000  # entries from which presolve may take seconds, in which HiGHS hears nothing
_QUIET = 0.2  # seconds that a warm solve may take before `stop` is asked in every iteration
_INFINITY = float("inf")
PATIENCE = 5.0
"""Seconds of the simplex method before an interior point method takes over."""
MOMENT = 0.2
"""The same for programs that are known to be slow by it."""


@dataclass(frozen=True, eq=False)
class LPResult:
    """The end of one LP solve; unless optimal, `objective` is infinite and the arrays are None.

    "cutoff" means that no point below the cutoff exists, "limit" that the solve was stopped,
    "unproven" that what the solver says does not follow from its multipliers; a `proof` has those
    by which it does (`tsplan.milp.proven_lp`). The arrays are made when they are first asked for:
    one value and one reduced cost per column, one dual value per row (of a minimisation: positive
    where the lower side of the row holds it up).
    """

    status: LPStatus
    objective: float
    seconds: float
    _solution: Any = field(default=None, repr=False)
    proof: Any = field(default=None, repr=False)

    @cached_property
    def values(self) -> Floats | None:
        """Values of the columns."""
        return self._array("col_value")

    @cached_property
    def reduced_costs(self) -> Floats | None:
        """Reduced costs of the columns."""
        return self._array("col_dual")

    @cached_property
    def row_duals(self) -> Floats | None:
        """Dual values of the rows."""
        return self._array("row_dual")

    def _array(self, name: str) -> Floats | None:
        if self._solution is None:
            return None
        listed = getattr(self._solution, name)
        return np.fromiter(listed, np.float64, len(listed))


class WarmLP:
    """The LP relaxation of a model, kept in HiGHS with its simplex basis.

    Integrality is ignored. `stop` is asked now and then while solving; once it is true the solve
    ends with status "limit". Changes keep the basis, so the next solve goes on from the last one
    (dual simplex after changed bounds and new rows, primal after changed costs). What the simplex
    method does not solve of a large program in so many seconds of `patience` is left to an interior
    point method, whose end is made a basis; with `degenerate` that is so from a basis, too.
    """

    def __init__(
        self,
        model: Model,
        stop: Callable[[], bool] | None = None,
        *,
        patience: float = PATIENCE,
        degenerate: bool = False,
    ) -> None:
        self._highs = load(model, relaxed=True)
        self._stop = stop
        self._cutoff = _INFINITY
        self._limit = _INFINITY
        self._watched = False
        self._warm = False
        self._large = model.size.nonzeros > _LARGE
        self._left_running = False
        # HiGHS calls a program without columns empty, whatever its rows say
        self._offset = float(model.offset)
        self._refuted = trivially_infeasible(model)
        self._patience = patience
        self._degenerate = degenerate
        self._span = model.lower, model.upper
        set_option(self._highs, "solver", "simplex")

    def bounds(
        self, columns: Ints | Sequence[int], lower: npt.ArrayLike, upper: npt.ArrayLike
    ) -> None:
        """New bounds for some columns: one number for all of them, or one for each."""
        count = len(columns)
        low, high = _spread(lower, count), _spread(upper, count)
        status = self._highs.changeColsBounds(count, _indices(columns), low, high)
        checked(status, "column bounds")

    def span(self, column: int) -> tuple[float, float]:
        """The bounds that a column had at first."""
        lower, upper = self._span
        return float(lower[column]), float(upper[column])

    def costs(self, columns: Ints, costs: npt.ArrayLike) -> None:
        """New objective coefficients for some columns."""
        count = len(columns)
        status = self._highs.changeColsCost(count, _indices(columns), _spread(costs, count))
        checked(status, "costs")

    def add_rows(self, rows: sparse.csr_array, lower: Floats, upper: Floats) -> None:
        """More rows, `lower <= rows @ x <= upper`."""
        status = self._highs.addRows(
            rows.shape[0],
            np.ascontiguousarray(lower, dtype=np.float64),
            np.ascontiguousarray(upper, dtype=np.float64),
            rows.nnz,
            _indices(rows.indptr[:-1]),
            _indices(rows.indices),
            np.ascontiguousarray(rows.data, dtype=np.float64),
        )
        checked(status, "rows")

    def delete_rows(self, rows: Ints) -> None:
        """Take rows away; those after them move up."""
        checked(self._highs.deleteRows(len(rows), _indices(rows)), "to delete rows")

    @property
    def multipliers(self) -> Floats:
        """The dual values of the rows after the last solve, however it ended."""
        listed = self._highs.getSolution().row_dual
        return np.fromiter(listed, np.float64, len(listed))

    @property
    def ray(self) -> Floats | None:
        """Multipliers that refute a program which was called infeasible, up to their sign."""
        _, known, ray = self._highs.getDualRay()
        return np.array(ray, dtype=np.float64) if known else None

    @property
    def trivially_refuted(self) -> bool:
        """Whether a row without entries asks for something."""
        return self._refuted

    def forget(self) -> None:
        """Solve from scratch the next time."""
        checked(self._highs.clearSolver(), "to forget the basis")
        self._warm = False

    @property
    def row_count(self) -> int:
        """Number of rows now."""
        return int(self._highs.getNumRow())

    def solve(self, time_limit: float | None = None, cutoff: float | None = None) -> LPResult:
        """Solve from the last basis; give up above `cutoff` or after `time_limit` seconds.

        Raises SolverError for an unbounded program and where HiGHS fails even from scratch.
        """
        began = time.perf_counter()
        if self._left_running:
            return LPResult("limit", _INFINITY, 0.0)
        if self._refuted:
            return LPResult("infeasible", _INFINITY, 0.0)
        most = _INFINITY if cutoff is None else float(cutoff)
        if most != self._cutoff:
            set_option(self._highs, "objective_bound", most)
            self._cutoff = most
        until = _INFINITY if time_limit is None else began + max(time_limit, 0.0)
        ended = self._run_by_either(until)
        if self._left_running:
            return LPResult("limit", _INFINITY, time.perf_counter() - began)
        if ended == Ended.kUnboundedOrInfeasible:
            ended = self._without_presolve(until)
        if ended not in _ENDS and ended != Ended.kUnbounded:
            # numerical trouble: forget the basis
            checked(self._highs.clearSolver(), "to forget the basis")
            ended = self._run(until)
        if ended == Ended.kInfeasible and self._presolved:
            ended = self._without_presolve(until)
        if ended not in _ENDS:
            words = self._highs.modelStatusToString(ended)
            raise SolverError(f"HiGHS could not solve a linear program: {words}")
        self._warm = True
        return self._result(ended, most, time.perf_counter() - began)

    def _run_by_either(self, until: float) -> Ended:
        """Run by the simplex method for a while, and else by an interior point method."""
        known = self._warm or not self._large
        if known and not self._degenerate:
            return self._run(until)
        if known or not self._degenerate:
            ended = self._run(until, patience=self._patience)
            if ended != Ended.kTimeLimit or self._left_running or time.perf_counter() >= until:
                return ended
        checked(self._highs.clearSolver(), "to forget the basis")
        set_option(self._highs, "solver", "ipm")
        ended = self._run(until)
        set_option(self._highs, "solver", "simplex")
        return ended

    def _result(self, ended: Ended, cutoff: float, seconds: float) -> LPResult:
        if _ENDS[ended] != "optimal":
            return LPResult(_ENDS[ended], _INFINITY, seconds)
        empty = ended == Ended.kModelEmpty
        objective = self._offset if empty else float(self._highs.getObjectiveValue())
        if objective > cutoff:
            # the bound is only looked at between iterations
            return LPResult("cutoff", _INFINITY, seconds)
        return LPResult("optimal", objective, seconds, self._highs.getSolution())

    def _run(self, until: float, patience: float = _INFINITY) -> Ended:
        """Run until it ends, the time or the patience is up, or `stop` is true.

        Asking `stop` in every iteration would slow small programs down by a third, so a warm solve
        runs without for a moment; on reaching a limit HiGHS keeps its basis.
        """
        watched = self._stop is not None and not self._warm
        patient = min(until, time.perf_counter() + patience)
        while True:
            quiet = self._stop is not None and not watched
            self._watch(on=watched)
            now = time.perf_counter()
            ended = self._once(min(patient, now + _QUIET) if quiet else patient, now, until)
            if ended != Ended.kTimeLimit or not quiet or time.perf_counter() >= patient:
                return ended
            watched = True

    def _once(self, until: float, now: float, deadline: float) -> Ended:
        highs = self._highs
        if until <= now:
            return Ended.kTimeLimit
        # HiGHS counts the seconds of all its runs together
        limit = until if until == _INFINITY else highs.getRunTime() + max(until - now, 0.0)
        if limit != self._limit:
            checked(highs.setOptionValue("time_limit", limit), "the time limit")
            self._limit = limit
        if self._large and not self._warm:
            return self._apart(deadline)
        try:
            status = highs.run()
        except KeyboardInterrupt:
            # raised in the callback, through HiGHS: what it has begun is lost
            highs.clearSolver()
            raise
        return self._status(status)

    def _apart(self, until: float) -> Ended:
        """Run attended by this thread, and leave it behind where it does not hear that it is over.

        HiGHS looks at the time and at the callback between iterations, not while it presolves.
        """
        deadline = None if until == _INFINITY else until
        ended = Watchdog(deadline, asked=self._stop or (lambda: False)).run(self._highs.run)
        if ended is None:
            self._left_running = True
            return Ended.kTimeLimit
        return self._status(ended.result)

    def _status(self, returned: highspy.HighsStatus) -> Ended:
        failed = returned == highspy.HighsStatus.kError
        return Ended.kSolveError if failed else self._highs.getModelStatus()

    @property
    def _presolved(self) -> bool:
        """Whether the last run presolved; what presolve alone calls infeasible is no proof."""
        return bool(self._highs.getModelPresolveStatus() != Presolved.kNotPresolved)

    def _without_presolve(self, until: float) -> Ended:
        set_option(self._highs, "presolve", "off")
        ended = self._run(until)
        if not self._left_running:
            set_option(self._highs, "presolve", "choose")
        return ended

    def _watch(self, *, on: bool) -> None:
        if on != self._watched:
            for callback in (self._highs.cbSimplexInterrupt, self._highs.cbIpmInterrupt):
                (callback.subscribe if on else callback.unsubscribe)(self._interrupt)
            self._watched = on

    def _interrupt(self, event: Any) -> None:
        # said either way: HiGHS remembers the last answer, from earlier solves too
        event.interrupt(self._stop is not None and self._stop())


def _indices(places: npt.ArrayLike) -> npt.NDArray[np.int32]:
    return np.ascontiguousarray(places, dtype=np.int32)


def _spread(numbers: npt.ArrayLike, count: int) -> Floats:
    return np.ascontiguousarray(np.broadcast_to(np.asarray(numbers, dtype=np.float64), (count,)))
