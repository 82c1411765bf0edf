"""What a search minimises, and what its values are in the objective's own unit.

A target counts in whole units wherever that is possible: a cost of 2.5 and one of 0.75 become 10
and 3 quarters. Then two plans differ by nothing or by a whole unit, values are exact in double
precision up to 2^53, and a bound that lies above one whole number proves the next. What a linear
program says is only believed as far as its arithmetic reaches: where that is coarser than a unit,
the bound is lowered by as much, and nothing is proven that is not so.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

import numpy as np

from tsplan.exact import MOST_EXACT, common_unit
from tsplan.milp.model import INFINITY, Floats, Model

_ONE, _ZERO = Fraction(1), Fraction(0)
_HALF = 0.5
# An LP's objective comes from a basis that is factorised in doubles: on 6,000 random missions with
# costs up to 1e10 units its errors stayed below these two, absolute and relative to the largest
# number in it (brute force and recomputed values were the judges).
_ABSOLUTE, _RELATIVE = 1e-5, 1e-10
_MARGIN = 1e-4  # by which a cutoff lies above the values of interest
CLOSED = 1e-6
"""Relative distance of two values of a sum of floats that count as equal."""


@dataclass(frozen=True, eq=False)
class Target:
    """A linear function of columns that is minimised.

    A point of value v is worth `constant + unit * v` in the objective's own unit; a negative unit
    stands for what is maximised. `step` is the least distance between the values of two plans: 1
    where all of them are whole, 0 where nothing is known.
    """

    vector: Floats
    unit: Fraction = _ONE
    constant: Fraction = _ZERO
    step: float = 1.0

    @classmethod
    def of(
        cls,
        terms: Mapping[int, Fraction],
        count: int,
        constant: Fraction = _ZERO,
        *,
        most: int = 1,
        maximise: bool = False,
        unit: Fraction | None = None,
    ) -> Target:
        """The target of an exact sum over `count` columns, in the largest unit that fits it.

        No column is more than `most`. All columns are whole, or the values of plans are known to
        be whole multiples of a given `unit`, but for the constant. Sums that do not fit double
        precision as whole numbers are taken as they are, with an unknown step.

        >>> target = Target.of({0: Fraction("2.5"), 2: Fraction("0.75")}, 3)
        >>> target.vector.tolist(), target.own(13.0)
        ([10.0, 0.0, 3.0], 3.25)
        """
        sign = -1 if maximise else 1
        unit = common_unit(terms.values()) if unit is None else unit
        exact = sum(abs(value / unit) for value in terms.values()) * most <= MOST_EXACT
        unit, step = (unit, 1.0) if exact else (_ONE, 0.0)
        vector = np.zeros(count)
        for column, value in terms.items():
            vector[column] = float(sign * value / unit)
        return cls(vector, sign * unit, constant, step)

    def value(self, values: Floats) -> float:
        """What a point comes to."""
        found = float(self.vector @ values)
        return float(round(found)) if self.step else found

    def own(self, value: float) -> float:
        """A value in the objective's own unit, to the last digit that a float has."""
        if not math.isfinite(value):
            return value if self.unit > 0 else -value
        if self.step:
            return float(self.constant + self.unit * Fraction(value))
        return float(self.constant) + float(self.unit) * value

    def minimised(self, own: float) -> float:
        """What is minimised at a value in the objective's own unit."""
        value = (own - float(self.constant)) / float(self.unit)
        return float(round(value)) if self.step else value

    def of_own(self, value: Fraction) -> float:
        """The value of points that are worth so much, the inverse of `own`."""
        return float((value - self.constant) / self.unit)

    # --- what is believed of linear programs ---------------------------------------------------

    def doubt(self, value: float) -> float:
        """By how much the objective of a linear program near `value` may be wrong."""
        return max(_ABSOLUTE, _RELATIVE * max(abs(value), self._largest))

    def proven(self, bound: float) -> float:
        """The value below which no plan is, given what a linear program or a solver says."""
        if not math.isfinite(bound):
            return bound
        if not self.step:
            return bound
        return float(np.ceil(bound - self.doubt(bound))) + 0.0  # not -0.0

    def cutoff(self, value: float) -> float:
        """What is above this cannot hold a plan that is better than `value`."""
        if not self.step:
            return value - self._slack(value) / 2
        return value - self.step + 2 * self.doubt(value) + _MARGIN

    def better(self, value: float, known: float) -> bool:
        """Whether a value is better than a known one."""
        return value < known - (_HALF if self.step else 0.0)

    def closed(self, value: float, bound: float) -> bool:
        """Whether a bound proves a value; floats count as equal within 1e-6 of their size."""
        return bound >= value - self._slack(value)

    def refutes(self, value: float, bound: float) -> bool:
        """Whether a point of this value shows that the bound is wrong."""
        return value < bound - self._slack(value)

    @property
    def absolute_gap(self) -> float:
        """The gap at which a solver may end: no plan lies in between."""
        return max(self.step - 2 * (self.doubt(0.0) + _MARGIN), 0.0)

    def kept(self, model: Model, value: float, kind: str) -> Model:
        """The model of those points that are no worse than `value`."""
        return model.with_row(self.vector, -INFINITY, value + self._slack(value), kind)

    def _slack(self, value: float) -> float:
        """Less than this is no difference: half a step, or what floats are not told apart by."""
        return _HALF if self.step else CLOSED * max(1.0, abs(value))

    @cached_property
    def _largest(self) -> float:
        return float(np.abs(self.vector).max(initial=0.0))
