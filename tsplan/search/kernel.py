"""Better points from few of the moves: those that some linear program takes, or a known point.

Of the many moves that a model has, good plans take those that its linear programs take, too. An
integer program of these alone is small: first with the witnesses of the known point, then with all
of them. Linear programs with other witnesses and with prices that are changed a little bring more
moves (kernel search: Angelelli, Mansini and Speranza, 2010). Nothing here proves anything.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tsplan.clock import Clock
from tsplan.encode.encoded import Encoded
from tsplan.milp.confirmation import tried
from tsplan.milp.lp import WarmLP
from tsplan.milp.model import Bools, Floats
from tsplan.milp.target import Target
from tsplan.search.dive import TOLERANCE
from tsplan.search.effort import Effort

_HELD, _FREE = 2.0, 4.0  # seconds for a program with held witnesses, and with all of them
_ROUNDS = 3  # without a gain, in a row
_CHANGE = 0.3  # of a price at most


@dataclass(frozen=True, eq=False)
class Kernel:
    """Looks for points of one model at which a target is less than at a known one."""

    encoded: Encoded
    target: Target
    effort: Effort
    clock: Clock

    def better(self, values: Floats) -> Floats:
        """The best point found, the known one if there is no better one."""
        model = self.encoded.model.with_objective(self.target.vector)
        lp = WarmLP(model, self.clock.stop)
        random = np.random.default_rng(0)
        taken = self._taken(lp) | (values > TOLERANCE)
        idle = 0
        while idle < _ROUNDS and not self.clock.over:
            before = values
            taken |= self._taken(lp, values)
            for held, seconds in ((True, _HELD), (False, _FREE)):
                values = self._best(taken, values, seconds, held=held)
            idle = 0 if self.target.value(values) < self.target.value(before) else idle + 1
            price = self.target.vector * (1 + _CHANGE * random.uniform(-1, 1, len(values)))
            lp.costs(np.arange(len(price)), price)
            taken |= self._taken(lp)
            lp.costs(np.arange(len(price)), self.target.vector)
        return values

    def _taken(self, lp: WarmLP, held: Floats | None = None) -> Bools:
        """The columns that a linear program takes, perhaps with the witnesses of a point."""
        model, indicators = self.encoded.model, self.encoded.indicators
        if held is not None:
            fixed = np.round(held[indicators])
            lp.bounds(indicators, fixed, fixed)
        found = lp.solve(time_limit=self.clock.left).values
        if held is not None:
            lp.bounds(indicators, model.lower[indicators], model.upper[indicators])
        return np.zeros(len(model.lower), dtype=np.bool_) if found is None else found > TOLERANCE

    def _best(self, taken: Bools, values: Floats, seconds: float, *, held: bool) -> Floats:
        """The best point of these moves, perhaps with the witnesses of a point."""
        encoded, target = self.encoded, self.target
        model = encoded.model.with_objective(target.vector)
        if held:
            model = model.with_fixed(encoded.indicators, values[encoded.indicators])
        upper = model.upper.copy()
        upper[encoded.moves[~taken[encoded.moves]]] = 0.0
        options = self.effort.options(self.clock.within(seconds), target, values)
        found = tried(self.effort.solver, model.with_bounds(model.lower, upper), options)
        if found is None or not target.better(target.value(found), target.value(values)):
            return values
        return found
