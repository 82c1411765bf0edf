"""Better points from few of the moves: those that some linear program takes, or a known point.

Of the many moves that a model has, good plans take those that its linear programs take, too. An
integer program of these alone is small: first with the witnesses of the known point, then with all
of them. Linear programs with other witnesses and with prices that are changed a little bring more
moves (kernel search: Angelelli, Mansini and Speranza, 2010). Nothing here proves anything.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from tsplan.clock import Clock
from tsplan.encode.encoded import Encoded
from tsplan.milp.confirmation import tried
from tsplan.milp.lp import WarmLP
from tsplan.milp.model import Bools, Floats, Model
from tsplan.milp.target import Target
from tsplan.search.dive import TOLERANCE
from tsplan.search.effort import Effort

_HELD, _FREE = 2.0, 4.0  # seconds for a program with held witnesses, and with all of them
_ROUNDS = 3  # without a gain, in a row
_CHANGE = 0.3  # of a price at most
_LITTLE = 0.01  # more for a move at most, where prices say nothing of moves


@dataclass(frozen=True, eq=False)
class Kernel:
    """Looks for points of one model at which a target is less than at a known one."""

    encoded: Encoded
    target: Target
    effort: Effort
    clock: Clock

    def better(self, values: Floats) -> Iterator[Floats]:
        """Better and better points than the known one, as long as there is any gain."""
        model = self.encoded.model.with_objective(self.target.vector)
        random = np.random.default_rng(0)
        taken = self._taken(model) | (values > TOLERANCE)
        idle = 0
        while idle < _ROUNDS and not self.clock.over:
            before = values
            taken |= self._taken(self._held(model, values))
            for held, seconds in ((True, _HELD), (False, _FREE)):
                values = self._best(taken, values, seconds, held=held)
            if values is not before:
                yield values
            idle = idle + 1 if values is before else 0
            price = self.target.vector * (1 + _CHANGE * random.uniform(-1, 1, len(values)))
            price[self.encoded.moves] += _LITTLE * random.random(len(self.encoded.moves))
            taken |= self._taken(model.with_objective(price))

    def _held(self, model: Model, values: Floats) -> Model:
        """The model with the witnesses of a point."""
        return model.with_fixed(self.encoded.indicators, values[self.encoded.indicators])

    def _taken(self, model: Model) -> Bools:
        """The columns that the linear program of a model takes."""
        found = WarmLP(model, self.clock.stop).solve(time_limit=self.clock.left).values
        return np.zeros(len(model.lower), dtype=np.bool_) if found is None else found > TOLERANCE

    def _best(self, taken: Bools, values: Floats, seconds: float, *, held: bool) -> Floats:
        """The best point of these moves, perhaps with the witnesses of a point."""
        encoded, target = self.encoded, self.target
        model = encoded.model.with_objective(target.vector)
        model = self._held(model, values) if held else model
        upper = model.upper.copy()
        upper[encoded.moves[~taken[encoded.moves]]] = 0.0
        options = self.effort.options(self.clock.within(seconds), target, values)
        found = tried(self.effort.solver, model.with_bounds(model.lower, upper), options)
        if found is None or not target.better(target.value(found), target.value(values)):
            return values
        return found
