"""A warm linear program whose ends are proven, whatever the solver says.

Multipliers come from the solver, and what follows from them is worked out in whole numbers
(`tsplan.milp.exact_rows`). An end that does not follow is asked for once more, from scratch; what
does not follow then either is `unproven`.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from math import inf, nextafter

import numpy as np
import numpy.typing as npt
from scipy import sparse

from tsplan.milp.exact_rows import COARSE, FINE, Bounded, ExactRows
from tsplan.milp.lp import PATIENCE, LPResult, WarmLP
from tsplan.milp.model import Floats, Ints, Model

_NEAR = 1e-7  # of a bound's size that may be lost by rounding before finer numbers are taken


@dataclass(eq=False)
class Tally:
    """How many ends of linear programs were verified, solved `again`, or stayed unproven."""

    verified: int = 0
    again: int = 0
    unproven: int = 0


class ProvenLP(WarmLP):
    """The LP relaxation of a model as `WarmLP` has it, with results that hold by their multipliers.

    An "optimal" result's `objective` is the bound that its multipliers prove. "infeasible" and
    "cutoff" are proven, or the result is "unproven". `tally` counts.
    """

    def __init__(
        self,
        model: Model,
        stop: Callable[[], bool] | None = None,
        *,
        patience: float = PATIENCE,
        degenerate: bool = False,
        tally: Tally | None = None,
    ) -> None:
        super().__init__(model, stop, patience=patience, degenerate=degenerate)
        self.tally = Tally() if tally is None else tally
        self._exact = ExactRows.of(model)
        self._low, self._high = model.lower.copy(), model.upper.copy()

    def bounds(
        self, columns: Ints | Sequence[int], lower: npt.ArrayLike, upper: npt.ArrayLike
    ) -> None:
        """New bounds for some columns: one number for all of them, or one for each."""
        super().bounds(columns, lower, upper)
        self._low[columns], self._high[columns] = lower, upper

    def costs(self, columns: Ints, costs: npt.ArrayLike) -> None:
        """New objective coefficients for some columns."""
        super().costs(columns, costs)
        vector = self._exact.model.objective.copy()
        vector[columns] = costs
        self._exact = replace(self._exact, model=self._exact.model.with_objective(vector))

    def add_rows(self, rows: sparse.csr_array, lower: Floats, upper: Floats) -> None:
        """More rows, `lower <= rows @ x <= upper`."""
        super().add_rows(rows, lower, upper)
        self._exact = self._exact.with_rows(rows, lower, upper)

    def delete_rows(self, rows: Ints) -> None:
        """Take rows away; those after them move up."""
        super().delete_rows(rows)
        kept = np.setdiff1d(np.arange(self._exact.model.matrix.shape[0]), rows)
        model = self._exact.model
        model = replace(
            model,
            matrix=model.matrix[kept],
            row_lower=model.row_lower[kept],
            row_upper=model.row_upper[kept],
            tags=(),
        )
        self._exact = ExactRows.of(model)

    def solve(self, time_limit: float | None = None, cutoff: float | None = None) -> LPResult:
        """Solve from the last basis; the end is proven, or "unproven" or "limit"."""
        began = time.perf_counter()
        result = super().solve(time_limit, cutoff)
        found = self._proven(result, cutoff)
        if found is None:
            self.tally.again += 1
            self.forget()
            left = None if time_limit is None else time_limit - (time.perf_counter() - began)
            result = super().solve(left)
            found = self._proven(result, cutoff)
        seconds = time.perf_counter() - began
        if found is None:
            self.tally.unproven += 1
            return LPResult("unproven", inf, seconds)
        self.tally.verified += found.status != "limit"
        return replace(found, seconds=seconds)

    def _proven(self, result: LPResult, cutoff: float | None) -> LPResult | None:
        """The result as far as its multipliers bear it out; None where they do not."""
        if result.status == "limit":
            return result
        if result.status == "infeasible":
            return self._without_point(result)
        best = self._bounded(self.multipliers, result)
        if best is None:
            return None
        bound = float_below(best.value + Fraction(self._exact.model.offset))
        if cutoff is not None and bound > cutoff:
            return replace(result, status="cutoff", objective=inf, proof=best.multipliers)
        if result.status != "optimal":
            return None
        return replace(result, objective=bound, proof=best.multipliers)

    def _bounded(self, duals: Floats, result: LPResult) -> Bounded | None:
        """The bound of multipliers, finer ones where rounding loses too much."""
        best = self._exact.bounded(duals, self._low, self._high)
        named = result.objective if result.status == "optimal" else None
        lost = best is None
        if best is not None and named is not None:
            size = _NEAR * max(1.0, abs(named))
            lost = named - self._exact.model.offset - float(best.value) > size
        if not lost:
            return best
        finer = self._exact.bounded(duals, self._low, self._high, digits=FINE)
        return best if finer is None else finer

    def _without_point(self, result: LPResult) -> LPResult | None:
        """That there is no point, if a ray shows it."""
        if self.trivially_refuted:
            return replace(result, proof=self._exact.empty_row())
        ray = self.ray
        if ray is None:
            return None
        scale = max(float(np.abs(ray).max(initial=0.0)), 1e-30)
        for digits in (COARSE, FINE):
            for sign in (1.0, -1.0):
                found = self._exact.bounded(
                    sign * ray / scale, self._low, self._high, priced=False, digits=digits
                )
                if found is not None and found.value > 0:
                    return replace(result, proof=found.multipliers)
        return None


def float_below(value: Fraction) -> float:
    """The largest double that is not above a number."""
    made = float(value)
    return made if Fraction(made) <= value else nextafter(made, -inf)
