"""Good plans early: a dive settles when things happen, a small model decides what is done then.

The steps of the witnesses are taken from an LP-guided dive and held, and the solver finds the best
whole agents for them; then one or two choices at a time are freed and the others are held (large
neighbourhood search: Shaw, 1998). Of many choices those are freed together that are settled for
steps close to each other: they compete for the same agents. Nothing here proves anything but that
a plan exists.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np

from tsplan.clock import Clock
from tsplan.encode.encoded import Encoded
from tsplan.milp.confirmation import tried
from tsplan.milp.lp import WarmLP
from tsplan.milp.model import Floats, Ints, Model
from tsplan.milp.target import Target
from tsplan.search.dive import dive
from tsplan.search.effort import Effort

_FIRST = 2.0  # seconds for the first small model
_EACH = 1.0  # seconds for one with a freed choice
_ALL = 4.0  # seconds for all of them
_HALF = 0.5
_MANY = 12  # choices from which on there are too many pairs
_BLOCKS = 4, 8, 16  # choices that are freed together of many


@dataclass(eq=False)
class Improving:
    """Looks for a point of one model at which a target is small."""

    encoded: Encoded
    target: Target
    effort: Effort
    clock: Clock

    def best(self, known: Floats | None = None) -> Floats | None:
        """A good point, `known` or better; None if none was found."""
        if self.encoded.refuted:
            return known
        model = self.encoded.model.with_objective(self.target.vector)
        lp = WarmLP(model, self.clock.stop)
        root = lp.solve(time_limit=self.clock.left)
        if root.status != "optimal":
            return known
        bound = self.target.proven(root.objective)
        point = known
        if point is None or not self._best(point, bound):
            turns = 20 + len(self.encoded.indicators) // 10
            clock = self.clock.within(_FIRST)
            dived = dive(lp, self.encoded.indicators, root, clock, turns=turns)
            if dived.values is not None:
                found = self._held(model, dived.values, (), point, _FIRST)
                point = point if found is None else found
        return point if point is None else self._rounds(model, point, bound)

    def _rounds(self, model: Model, point: Floats, bound: float) -> Floats:
        """Free a few choices at a time until that gains nothing or time is up."""
        improving = replace(self, clock=self.clock.within(_ALL))
        for better in improving.steps(model, point, _EACH):
            point = better
            if self._best(point, bound):
                break
        return point

    def steps(self, model: Model, point: Floats, seconds: float) -> Iterator[Floats]:
        """Better and better points than a known one of the model, in so many seconds for each."""
        waiting = deque(self._neighbourhoods(point))
        tried = 0
        while tried < len(waiting) and not self.clock.over:
            found = self._held(model, point, waiting[0], point, seconds)
            waiting.rotate(-1)
            tried = 0 if found is not None else tried + 1
            if found is not None:
                point = found
                yield point

    def _neighbourhoods(self, point: Floats) -> Iterator[Sequence[int]]:
        """Choices to free together: single ones and pairs, of many those of steps near each other.

        Blocks overlap by half.
        """
        choices = range(len(self.encoded.choices))
        if len(choices) < _MANY:
            yield from combinations(choices, 1)
            yield from combinations(choices, 2)
            return
        order = sorted(choices, key=lambda number: self._settled(number, point))
        for size in (size for size in _BLOCKS if size < len(order)):
            for begin in range(0, len(order) - size // 2, size // 2):
                yield order[begin : begin + size]

    def _settled(self, number: int, point: Floats) -> float:
        """The step that a choice is settled for; those that nothing asks for come last."""
        group = self.encoded.choices[number]
        chosen = group[point[group] > _HALF]
        place = np.searchsorted(self.encoded.indicators, chosen)
        return float(self.encoded.steps[place].min(initial=self.encoded.setting.horizon + 1))

    def _held(
        self,
        model: Model,
        values: Floats,
        freed: Sequence[int],
        known: Floats | None,
        seconds: float,
    ) -> Floats | None:
        """The best point with the choices of `values` but for some; None if it is not better."""
        lower, upper = model.lower.copy(), model.upper.copy()
        for number, group in enumerate(self.encoded.choices):
            if number not in freed:
                _hold(group, values, lower, upper)
        options = replace(
            self.effort.limited(self.clock.within(seconds)),
            absolute_gap=self.target.absolute_gap,
            cutoff=None if known is None else self.target.cutoff(self._value(known)),
        )
        found = tried(self.effort.solver, model.with_bounds(lower, upper), options)
        if found is None or known is None:
            return found
        return found if self.target.better(self._value(found), self._value(known)) else None

    def _value(self, point: Floats) -> float:
        return self.target.value(point)

    def _best(self, point: Floats, bound: float) -> bool:
        """Whether no point can be better."""
        return self.target.closed(self._value(point), bound)


def _hold(group: Ints, values: Floats, lower: Floats, upper: Floats) -> None:
    """Only what is chosen may be chosen; not choosing it stays possible."""
    upper[group] = np.where(values[group] > _HALF, upper[group], lower[group])
