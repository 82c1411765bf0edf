"""Whole agents from fractional flows, once the witnesses are fixed.

Each class is then a network flow of its own, and what is left fractional is how several classes
share a task: half an agent of each. Raising one such share to the next whole number settles the
others along the same paths, so a few warm LPs are enough where an integer program of all flows
may take minutes. It is a heuristic: the point it finds need not be the best one, and it may find
none.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tsplan.clock import Clock
from tsplan.encode.encoded import Encoded
from tsplan.milp.confirmation import tried
from tsplan.milp.lp import WarmLP
from tsplan.milp.model import Floats, Ints, Model
from tsplan.milp.target import Target
from tsplan.search.dive import fractional
from tsplan.search.effort import Effort

_LEAST_TRIES = 20
_SECONDS = 5.0  # for one attempt


@dataclass(frozen=True, eq=False)
class Wholes:
    """Makes points of whole agents from points with parts of them, for one search."""

    encoded: Encoded
    target: Target
    effort: Effort
    clock: Clock

    def near(self, lp: WarmLP, model: Model, values: Floats) -> Floats | None:
        """A point of whole agents by rounding; `lp` is the relaxation of the model."""
        encoded = self.encoded
        if not len(fractional(values, encoded.flows)):
            return values
        rounding = Rounding(lp, model, encoded.indicators, encoded.flows)
        return rounding.whole(values, self.clock.within(_SECONDS))

    def best(self, model: Model, values: Floats, start: Floats | None) -> Floats | None:
        """The best point with the witnesses of `values`, if the solver finds it soon."""
        logic = self.encoded.indicators
        return self._fixed(model, logic, values[logic], start)

    def carrying(self, model: Model, flows: Floats, start: Floats | None) -> Floats | None:
        """The best point with the given flows, if there is one."""
        return self._fixed(model, self.encoded.flows, flows, start)

    def _fixed(
        self, model: Model, columns: Ints, values: Floats, start: Floats | None
    ) -> Floats | None:
        lower, upper = model.lower.copy(), model.upper.copy()
        lower[columns] = upper[columns] = np.round(values)
        options = self.effort.options(self.clock.within(_SECONDS), self.target, start)
        return tried(self.effort.solver, model.with_bounds(lower, upper), options)


@dataclass(frozen=True, eq=False)
class Rounding:
    """Makes the flows of points of one model whole; `lp` is its warm relaxation."""

    lp: WarmLP
    model: Model
    indicators: Ints
    flows: Ints

    def whole(self, values: Floats, clock: Clock) -> Floats | None:
        """A point with the witnesses of `values` and whole flows, or None.

        The LP's bounds are restored before returning.
        """
        fixed = np.round(values[self.indicators])
        self.lp.bounds(self.indicators, fixed, fixed)
        raised: dict[int, tuple[float, float]] = {}
        try:
            return self._raise(raised, clock)
        finally:
            columns = np.concatenate([self.indicators, np.array(list(raised), dtype=np.int64)])
            self.lp.bounds(columns, self.model.lower[columns], self.model.upper[columns])

    def _raise(self, bounds: dict[int, tuple[float, float]], clock: Clock) -> Floats | None:
        """Raise the flow nearest below a whole number; lower it where that is impossible."""
        last: tuple[int, float, float] | None = None
        tries = max(_LEAST_TRIES, len(self.flows) // 1000)
        for _ in range(tries):
            result = self.lp.solve(time_limit=clock.left)
            if result.status == "optimal":
                assert result.values is not None
                column = self._next(result.values)
                if column is None:
                    return result.values
                low, high = bounds.get(column, (self.model.lower[column], self.model.upper[column]))
                value = float(result.values[column])
                last = (column, low, float(np.floor(value)))
                self._bound(bounds, column, float(np.ceil(value)), high)
            elif result.status == "infeasible" and last is not None:
                self._bound(bounds, *last)
                last = None
            else:
                break
        return None

    def _next(self, values: Floats) -> int | None:
        """The fractional flow that lacks least to a whole number."""
        open_ = fractional(values, self.flows)
        if not len(open_):
            return None
        part = values[open_] - np.floor(values[open_])
        return int(open_[np.argmax(part)])

    def _bound(
        self, bounds: dict[int, tuple[float, float]], column: int, low: float, high: float
    ) -> None:
        bounds[column] = (low, high)
        self.lp.bounds(np.array([column]), np.array([low]), np.array([high]))
