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
class Rounding:
    """Makes points of whole agents from points with parts of them, for one search."""

    encoded: Encoded
    target: Target
    effort: Effort
    clock: Clock

    def near(self, lp: WarmLP, model: Model, values: Floats) -> Floats | None:
        """A point with the same witnesses and whole agents, or None.

        `lp` is the relaxation of the model; its bounds are restored before returning.
        """
        indicators, flows = self.encoded.indicators, self.encoded.repaired
        if not len(fractional(values, flows)):
            return values
        fixed = np.round(values[indicators])
        lp.bounds(indicators, fixed, fixed)
        raised: dict[int, tuple[float, float]] = {}
        try:
            return _raised(lp, model, flows, raised, self.clock.within(_SECONDS))
        finally:
            columns = np.concatenate([indicators, np.array(list(raised), dtype=np.int64)])
            lp.bounds(columns, model.lower[columns], model.upper[columns])

    def best(self, model: Model, values: Floats, start: Floats | None) -> Floats | None:
        """The best point with the witnesses of `values`, if the solver finds it soon."""
        indicators = self.encoded.indicators
        return self._tried(model.with_fixed(indicators, values[indicators]), start)

    def carrying(self, model: Model, flows: Floats, start: Floats | None) -> Floats | None:
        """The best point with the given flows, if there is one."""
        return self._tried(model.with_fixed(self.encoded.flows, flows), start)

    def _tried(self, model: Model, start: Floats | None) -> Floats | None:
        options = self.effort.options(self.clock.within(_SECONDS), self.target, start)
        return tried(self.effort.solver, model, options)


def _raised(
    lp: WarmLP,
    model: Model,
    flows: Ints,
    bounds: dict[int, tuple[float, float]],
    clock: Clock,
) -> Floats | None:
    """Raise the flow nearest below a whole number; lower it where that is impossible.

    `bounds` are filled in with what the flows are held between.
    """
    last: tuple[int, float, float] | None = None
    for _ in range(max(_LEAST_TRIES, len(flows) // 1000)):
        result = lp.solve(time_limit=clock.left)
        if result.status == "optimal":
            assert result.values is not None
            open_ = fractional(result.values, flows)
            if not len(open_):
                return result.values
            part = result.values[open_] % 1.0
            column = int(open_[np.argmax(part)])  # the one that lacks least to a whole number
            low, high = bounds.get(column, (model.lower[column], model.upper[column]))
            value = float(result.values[column])
            last = (column, low, float(np.floor(value)))
            bounds[column] = float(np.ceil(value)), high
        elif result.status == "infeasible" and last is not None:
            column, low, high = last
            bounds[column] = low, high
            last = None
        else:
            break
        lp.bounds([column], *bounds[column])
    return None
