"""Minimum and maximum over sliding windows of steps, and the change-over of until and release.

All arrays are (..., steps). Entry t of a result speaks about the steps from t on; a result ends
where its window would leave the array. Windows grow by doubling, so their cost is logarithmic in
their length. `best` and `worst` are maximum and minimum for "some step" readings and exchanged for
their duals; on Boolean arrays NumPy's maximum and minimum are "or" and "and".
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy.typing as npt

Values: TypeAlias = npt.NDArray[Any]
Choose: TypeAlias = Callable[[Values, Values], Values]


def windowed(values: Values, low: int, high: int, choose: Choose) -> Values:
    """`choose` over `values[t+low .. t+high]` for every t; `choose` is np.minimum or np.maximum.

    >>> import numpy as np
    >>> windowed(np.array([3, 1, 4, 1, 5]), 1, 2, np.maximum)
    array([4, 4, 5])
    """
    result, length, wanted = values[..., low:], 1, high - low + 1
    while length < wanted:
        shift = min(length, wanted - length)  # windows may overlap: minimum and maximum allow it
        result = choose(result[..., :-shift], result[..., shift:])
        length += shift
    return result


def windowed_sums(values: Values, low: int, high: int) -> Values:
    """The sum of `values[t+low .. t+high]` for every t.

    Windows are put together of parts that do not overlap, which rounds less than differences of
    running sums do.

    >>> import numpy as np
    >>> windowed_sums(np.array([3, 1, 4, 1, 5]), 0, 2)
    array([ 8,  6, 10])
    """
    power, width, wanted = values[..., low:], 1, high - low + 1
    steps, at, result = max(values.shape[-1] - high, 0), 0, None
    while True:
        if wanted & width:
            part = power[..., at : at + steps]
            at, result = at + width, part if result is None else result + part
        if 2 * width > wanted:
            return result if result is not None else power
        power, width = power[..., :-width] + power[..., width:], 2 * width


@dataclass(frozen=True, eq=False)
class _Stretch:
    """A stretch of `length` candidate steps for the change-over, from every step t on.

    `throughout[t]`: the left side at all of t .. t+length-1. `reached[t]`: the best change-over
    at one of these steps.
    """

    length: int
    throughout: Values
    reached: Values


def switched(
    sides: tuple[Values, ...], interval: tuple[int, int], best: Choose, worst: Choose
) -> Values:
    """Change over at the best s in t+low .. t+high: worst of right at s and left at t .. s-1.

    Until with (np.maximum, np.minimum), release with the two exchanged.

    >>> import numpy as np
    >>> sides = np.array([9, 9, 1, 9]), np.array([0, 0, 5, 7])
    >>> switched(sides, (0, 2), np.maximum, np.minimum)
    array([5, 5])
    """
    (left, right), (low, high) = sides, interval
    reached = _grown(left, right, high - low + 1, best, worst).reached
    if not low:
        return reached
    before, after = _aligned(windowed(left, 0, low - 1, worst), reached[..., low:])
    return worst(before, after)


def _grown(left: Values, right: Values, wanted: int, best: Choose, worst: Choose) -> _Stretch:
    """A stretch of the wanted length: stretches are joined as in exponentiation by squaring."""
    power = _Stretch(1, left, right)
    result = None
    while True:
        if wanted & 1:
            result = power if result is None else _joined(result, power, best, worst)
        wanted >>= 1
        if not wanted:
            return result if result is not None else power
        power = _joined(power, power, best, worst)


def _joined(first: _Stretch, second: _Stretch, best: Choose, worst: Choose) -> _Stretch:
    """One stretch after the other: change over in the first, or get through it to the second."""
    throughout, later = _aligned(first.throughout, second.reached[..., first.length :])
    change, later = _aligned(first.reached, worst(throughout, later))
    both, rest = _aligned(first.throughout, second.throughout[..., first.length :])
    return _Stretch(first.length + second.length, worst(both, rest), best(change, later))


def _aligned(first: Values, second: Values) -> tuple[Values, Values]:
    """Both arrays over the steps that both have."""
    length = min(first.shape[-1], second.shape[-1])
    return first[..., :length], second[..., :length]
