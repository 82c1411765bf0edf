"""What is maximised, scaled so that solvers count it in whole units where that is possible."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from math import prod

import numpy as np

from tsplan.encode.build import Encoded
from tsplan.encode.partial.sums import Sum
from tsplan.milp.model import INFINITY, Floats

MOST_UNITS = 20_000
"""Values are counted in whole units up to this many; solvers tell so many apart for sure."""

_FINE = 10_000  # units per 1 where the true ones would be smaller
_HALF = 0.5


@dataclass(frozen=True, eq=False)
class Aim:
    """A sum to be maximised, as an objective that is minimised.

    `scale` units make 1; if `step` is 1 all values of the objective are whole but for a constant.
    """

    vector: Floats
    constant: Fraction
    scale: int
    step: float

    @classmethod
    def of(cls, total: Sum, units: int, most: Fraction, columns: int) -> Aim:
        """A sum that is at most `most` and whose values are multiples of one over `units`."""
        exact = units * most <= MOST_UNITS
        scale = units if exact else _FINE
        return cls(-total.vector(columns, scale), total.constant, scale, float(exact))

    def shown(self, objective: float) -> float:
        """The sum's value from that of the objective."""
        if self.step:
            return float((self.constant * self.scale - round(objective)) / self.scale)
        return float(self.constant) - objective / self.scale

    def below(self, encoded: Encoded, value: Fraction) -> Encoded:
        """The model of those plans that reach less than `value`."""
        if not self.step:
            return encoded
        least = float((self.constant - value) * self.scale) + _HALF
        return replace(encoded, model=encoded.model.with_row(self.vector, least, INFINITY, "less"))

    def kept(self, encoded: Encoded, objective: float) -> Encoded:
        """The model of those plans that reach as much as one with this objective."""
        slack = _HALF if self.step else 1e-6 * max(1.0, abs(objective))
        model = encoded.model.with_row(self.vector, -INFINITY, objective + slack, "kept")
        return replace(encoded, model=model)


def chunks(counts: Sequence[int], *, together: bool) -> list[tuple[int, ...]]:
    """Depths that are settled in one go, for the numbers of claims at each depth.

    Several go together only while exact weights tell all their outcomes apart. Depths without
    claims are left out.

    >>> chunks([1, 6, 0, 30, 900, 900], together=True)
    [(0, 1, 3), (4,), (5,)]
    """
    found: list[tuple[int, ...]] = []
    for depth, count in enumerate(counts):
        if not count:
            continue
        last = found[-1] if found else ()
        outcomes = prod(counts[d] + 1 for d in last) * (count + 1)
        if together and last and outcomes <= MOST_UNITS:
            found[-1] = (*last, depth)
        else:
            found.append((depth,))
    return found


def by_depth(claims: Sequence[np.ndarray[tuple[int], np.dtype[np.int64]]], columns: int) -> Aim:
    """The claims of several depths, one of a depth worth more than all of the deeper ones."""
    vector = np.zeros(columns)
    weight = 1
    for members in reversed(claims):
        vector[members] = -float(weight)
        weight *= len(members) + 1
    return Aim(vector, Fraction(0), 1, 1.0)
