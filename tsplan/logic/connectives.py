"""How operators join the values of their operands: by the least and greatest, or by means.

All values are arrays (..., steps), as in `tsplan.logic.windows`. Every family of rules joins the
parts of `and` and `or`, the steps of a window, and the change-over of until and release.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import reduce
from itertools import accumulate, islice
from types import MappingProxyType
from typing import NamedTuple, Protocol, TypeVar

import numpy as np

from tsplan.logic.nodes import Always, And, Eventually, Formula, Or, Release, Switch, Until, Window
from tsplan.logic.weight_values import Weights
from tsplan.logic.weights import Factors, Weighting, factors
from tsplan.logic.windows import Choose, Values, switched, windowed, windowed_sums

T = TypeVar("T")


class Connectives(Protocol):
    """One family of rules."""

    def joined(
        self, kind: type[Formula], parts: Sequence[Values], weights: Weights = None
    ) -> Values:
        """All or some of several parts, over the steps that all of them have."""

    def over_window(self, node: Window, values: Values) -> Values:
        """The child over the window from every step on."""

    def over_switch(self, node: Switch, left: Values, right: Values) -> Values:
        """The change-over from left to right in the window from every step on."""


_CHOICES: Mapping[type[Formula], tuple[Choose, ...]] = MappingProxyType(
    {
        And: (np.minimum,),
        Or: (np.maximum,),
        Eventually: (np.maximum,),
        Always: (np.minimum,),
        Until: (np.maximum, np.minimum),
        Release: (np.minimum, np.maximum),
    }
)
"""What an operator takes of the values of its operands; until and release at the best change-over
the worst on the way to it, and the other way round."""


class Extremes:
    """The least where all are asked for, the greatest where some are; weights do not matter.

    Minimum and maximum serve Boolean values as well, on which they are "and" and "or".
    """

    def joined(
        self, kind: type[Formula], parts: Sequence[Values], weights: Weights = None
    ) -> Values:
        """The least or the greatest of several parts."""
        return reduce(_CHOICES[kind][0], _aligned(parts))

    def over_window(self, node: Window, values: Values) -> Values:
        """The least or the greatest over the window."""
        return windowed(values, node.low, node.high, *_CHOICES[type(node)])

    def over_switch(self, node: Switch, left: Values, right: Values) -> Values:
        """The worst up to the best change-over, or the best up to the worst."""
        return switched((left, right), (node.low, node.high), *_CHOICES[type(node)])


EXTREMES = Extremes()


@dataclass(frozen=True)
class Scaled(Extremes):
    """The same, of parts that are multiplied by the factors of their weights if they have any."""

    weighting: Weighting

    def joined(
        self, kind: type[Formula], parts: Sequence[Values], weights: Weights = None
    ) -> Values:
        """The least or the greatest of several parts."""
        if weights is None:
            return super().joined(kind, parts)
        scales = factors(kind, weights, self.weighting)
        return reduce(_CHOICES[kind][0], map(_scaled, _aligned(parts), scales))

    def over_window(self, node: Window, values: Values) -> Values:
        """The least or the greatest over the window."""
        if node.weights is None:
            return super().over_window(node, values)
        return self.joined(type(node), _window(node, values), node.weights)

    def over_switch(self, node: Switch, left: Values, right: Values) -> Values:
        """The best or the worst change-over, of which the right side is scaled."""
        if node.weights is None:
            return super().over_switch(node, left, right)
        best, worst = _CHOICES[type(node)]
        before, there = _sides(node, left, right)
        scales = factors(type(node), node.weights, self.weighting)
        return reduce(best, _changes(before, map(_scaled, there, scales), node.low, worst))


def _scaled(values: Values, by: Factors) -> Values:
    if by.satisfied == by.violated:
        return values * by.satisfied
    return values * np.where(values >= 0, by.satisfied, by.violated)


class Means:
    """Means, so that every part counts: arithmetic-geometric mean robustness, in [-1, 1].

    All of m parts are worth the geometric mean of 1 + value, less 1, where every value is positive;
    elsewhere the mean of the negative parts, others counting 0. Some of them are worth the negative
    of what all of their negatives are. Until takes some of the change-overs, each being all of the
    right side there and the left side at each step before; release is its dual. Weights are those
    of the means.

    Source: N. Mehdipour, C.-I. Vasile and C. Belta, "Arithmetic-Geometric Mean Robustness for
    Control from Signal Temporal Logic Specifications", ACC 2019; until and release by their
    definitions.
    """

    def joined(
        self, kind: type[Formula], parts: Sequence[Values], weights: Weights = None
    ) -> Values:
        """All or some of several parts."""
        return _mean(_aligned(parts), _sign(kind), weights)

    def over_window(self, node: Window, values: Values) -> Values:
        """All or some steps of the window."""
        if node.weights is not None:
            return self.joined(type(node), _window(node, values), node.weights)
        sign, ends = _sign(type(node)), (node.low, node.high)
        least, logs, lows = _gathered(sign * values)
        sums = windowed_sums(logs, *ends), windowed_sums(lows, *ends)
        whole = _Gathered(windowed(least, *ends, np.minimum), *sums)
        return whole.mean(node.high - node.low + 1) * sign

    def over_switch(self, node: Switch, left: Values, right: Values) -> Values:
        """Some change-overs in the window, or for release what it is the dual of."""
        sign = -_sign(type(node))
        before, there = (map(_gathered, each) for each in _sides(node, sign * left, sign * right))
        changes = _changes(before, there, node.low, _Gathered.beside)
        each = (change.mean(step + 1) for step, change in enumerate(changes, node.low))
        return _mean(each, _sign(Until), node.weights) * sign


class _Gathered(NamedTuple):
    """What decides the mean of all of several values: three arrays (..., steps)."""

    least: Values
    logs: Values  # the sum of log(1 + value) over positive values
    lows: Values  # the sum of negative values

    def beside(self, other: _Gathered) -> _Gathered:
        """The values of both together."""
        least = np.minimum(self.least, other.least)
        return _Gathered(least, self.logs + other.logs, self.lows + other.lows)

    def mean(self, total: float) -> Values:
        """The mean of all values, which weigh so much together."""
        mean = np.where(self.least > 0, np.expm1(self.logs / total), self.lows / total)
        return np.clip(mean, -1.0, 1.0)  # rounding may step over


def _gathered(values: Values, weight: float = 1.0) -> _Gathered:
    logs, lows = np.log1p(np.maximum(values, 0.0)), np.minimum(values, 0.0)
    return _Gathered(values, weight * logs, weight * lows)


def _sign(kind: type[Formula]) -> int:
    """1 for what joins all of its parts, -1 for some: all of their negatives, negated."""
    return 1 if _CHOICES[kind][0] is np.minimum else -1


def _mean(parts: Iterable[Values], sign: int, weights: Weights) -> Values:
    """All (sign 1) or some (sign -1) of values that are made one after the other."""
    given = iter(weights or ())
    total, found = 0.0, None
    for values in parts:
        weight = next(given, 1.0)
        own = _gathered(sign * values, weight)
        total, found = total + weight, own if found is None else found.beside(own)
    assert found is not None
    return found.mean(total) * sign


def _window(node: Window, values: Values) -> list[Values]:
    """The values at each step of the window, over the steps from which all of it is there."""
    return _slices(values, range(node.low, node.high + 1), values.shape[-1] - node.high)


def _sides(node: Switch, left: Values, right: Values) -> tuple[list[Values], list[Values]]:
    """The left side at each step before the last change-over, the right at each change-over."""
    steps = right.shape[-1] - node.high
    if node.high:  # or else the left side does not matter
        steps = min(steps, left.shape[-1] + 1 - node.high)
    window = range(node.low, node.high + 1)
    return _slices(left, range(node.high), steps), _slices(right, window, steps)


def _changes(
    left: Iterable[T], right: Iterable[T], low: int, worst: Callable[[T, T], T]
) -> Iterator[T]:
    """For each change-over in a window, the right side there and the left side at steps before."""
    changes, before = iter(right), islice(accumulate(left, worst), max(low - 1, 0), None)
    if not low:
        yield next(changes)
    yield from map(worst, before, changes)


def _slices(values: Values, starts: range, steps: int) -> list[Values]:
    """So many steps from each start on; none where a part that does not matter is too short."""
    return [values[..., start : start + max(steps, 0)] for start in starts]


def _aligned(arrays: Sequence[Values]) -> list[Values]:
    """The arrays over the steps that all of them have."""
    length = min(array.shape[-1] for array in arrays)
    return [array[..., :length] for array in arrays]
