"""True bounds of linear programs, in whole numbers, from whatever multipliers a solver names.

For any multipliers y of the rows of `row_lower <= A x <= row_upper`, `lower <= x <= upper`, every
point of the program is worth at least

    y b(y) + sum over the columns of min(d_j lower_j, d_j upper_j),    d = c - A^T y,

where b(y) is the lower side of a row whose multiplier is positive and its upper side elsewhere. So
a solver may be wrong about y as it likes: what follows from it is weaker then, and never untrue.
With c = 0 and a bound above zero the program has no point. Multipliers are rounded to multiples of
2^-20 here, so that all of this is one sparse product in 64-bit integers; where these would not do,
Python's own take their place.

Sources: A. Neumaier, O. Shcherbina, "Safe bounds in linear and mixed-integer linear programming",
Mathematical Programming 99, 2004; W. Cook, T. Koch, D. E. Steffy, K. Wolter, "A hybrid
branch-and-bound approach for exact rational mixed-integer programming", Mathematical Programming
Computation 5, 2013.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from math import isinf, nextafter
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt
from scipy import sparse

from tsplan.milp.model import INFINITY, Bools, Floats, Ints, Model

COARSE = 20
"""Binary digits after the point that multipliers are rounded to at first."""
FINE = 44
"""The same where that is too coarse."""

_SAFE = 2.0**61  # sums of 64-bit integers stay below this by their estimate in doubles
_EXACT = 2.0**52  # doubles hold all whole numbers below
_DIGITS = 1074  # binary digits after the point that a double has at most

Wholes: TypeAlias = npt.NDArray[Any]
"""Whole numbers: 64-bit integers, or Python's own where these do not hold them."""


@dataclass(frozen=True, eq=False)
class Multipliers:
    """Multipliers of the rows that have one: `numbers / 2**digits`, of the rows as they stand.

    `priced` says that they bound the objective; without, they show that there is no point.
    """

    rows: Ints
    numbers: Wholes
    digits: int
    priced: bool = True

    def fractions(self) -> list[tuple[int, Fraction]]:
        """The rows with their multipliers."""
        whole = 1 << self.digits
        pairs = zip(self.rows.tolist(), self.numbers.tolist(), strict=True)
        return [(row, Fraction(number, whole)) for row, number in pairs]


@dataclass(frozen=True, eq=False)
class Bounded:
    """What multipliers say: no point of the program is worth less than `value`."""

    value: Fraction
    multipliers: Multipliers


class _Scaled:
    """Numbers times a power of two, so that all of them are whole."""

    def __init__(self, numbers: Floats) -> None:
        finite = np.where(np.isfinite(numbers), numbers, 0.0)
        self.digits = _digits(finite)
        scaled = finite * 2.0**self.digits if self.digits < _DIGITS else np.full(1, np.inf)
        self.small = bool((np.abs(scaled) < _SAFE).all())
        self.numbers: Wholes = (
            scaled.astype(np.int64)
            if self.small
            else np.array([int(Fraction(n) * 2**self.digits) for n in finite.tolist()], object)
        )


def _digits(numbers: Floats) -> int:
    """How many binary digits after the point are enough for all of some numbers."""
    if np.array_equal(numbers, np.rint(numbers)):
        return 0
    most = max(Fraction(number).denominator for number in numbers[numbers != np.rint(numbers)])
    return most.bit_length() - 1


@dataclass(frozen=True, eq=False)
class ExactRows:
    """The rows of a model as they are, in whole numbers; all numbers have a common denominator.

    `most` has a finite upper bound of every column that has one: its own, or what an equation with
    columns before it leaves it.
    """

    model: Model
    most: Floats

    @classmethod
    def of(cls, model: Model) -> ExactRows:
        """The rows of a model; bounds that equations imply are found once."""
        return cls(model, implied_most(model))

    def with_rows(self, rows: sparse.csr_array, lower: Floats, upper: Floats) -> ExactRows:
        """With more rows, which come last."""
        return replace(self, model=self.model.with_rows(rows, lower, upper, "more"))

    def bounded(
        self,
        duals: Floats,
        lower: Floats,
        upper: Floats,
        *,
        priced: bool = True,
        digits: int = COARSE,
    ) -> Bounded | None:
        """What multipliers, rounded, say of the columns between such bounds; None for nothing.

        `priced` asks about the objective, otherwise it is taken as zero.
        """
        duals = np.where(np.isfinite(duals), duals, 0.0)
        rows = np.flatnonzero(np.where(duals > 0, self._held_below, self._held_above))
        scaled = np.rint(duals[rows] * 2.0**digits)
        some = scaled != 0
        rows, scaled = rows[some], scaled[some]
        numbers: Wholes
        if (np.abs(scaled) < _SAFE).all():
            numbers = scaled.astype(np.int64)
        else:
            numbers = np.array([int(number) for number in scaled.tolist()], dtype=object)
        given = Multipliers(rows, numbers, digits, priced)
        value = self.value(given, lower, upper)
        return None if value is None else Bounded(value, given)

    def empty_row(self) -> Multipliers | None:
        """The multiplier of a row without entries that asks for something, which refutes all."""
        model = self.model
        empty = np.diff(model.matrix.indptr) == 0
        for sign, broken in ((1, model.row_lower > 0), (-1, model.row_upper < 0)):
            rows = np.flatnonzero(empty & broken)[:1]
            if len(rows):
                return Multipliers(rows, np.array([sign]), 0, priced=False)
        return None

    def value(self, given: Multipliers, lower: Floats, upper: Floats) -> Fraction | None:
        """The bound that multipliers give between such bounds of the columns, minus the offset."""
        reduced = self.reduced(given)
        bounds = np.where(reduced > 0, lower, np.minimum(upper, self.most))
        bounds = np.where(reduced == 0, 0.0, bounds)
        if not np.isfinite(bounds).all():
            return None
        ends = _Scaled(bounds)
        side = self._sides(given)
        total = _dot(reduced, ends.numbers)
        return Fraction(total, 1 << (self.digits + given.digits + ends.digits)) + side

    def reduced(self, given: Multipliers) -> Wholes:
        """Reduced costs of all columns, times 2 to the power of the digits of both."""
        reach = float(np.abs(given.numbers).max(initial=0)) * self._widest
        costs = self._costs.astype(np.float64)
        most = float(np.abs(costs).max(initial=0.0)) * 2.0**given.digits
        if self.whole and reach + most < _SAFE:
            weights = np.zeros(self.model.matrix.shape[0], dtype=np.int64)
            weights[given.rows] = given.numbers
            product: Wholes = self._transposed @ weights
            paid: Wholes = self._costs << given.digits
        else:
            product = self._long_product(given)
            paid = np.array([cost << given.digits for cost in self._costs.tolist()], dtype=object)
        return paid - product if given.priced else -product

    def _long_product(self, given: Multipliers) -> Wholes:
        """The rows times their multipliers in Python's integers."""
        found = [0] * self.model.matrix.shape[1]
        matrix, entries = self.model.matrix, self._entries.numbers
        further = self.digits - self._entries.digits
        weights = (int(number) << further for number in given.numbers.tolist())
        for row, number in zip(given.rows.tolist(), weights, strict=True):
            for place in range(int(matrix.indptr[row]), int(matrix.indptr[row + 1])):
                found[int(matrix.indices[place])] += number * int(entries[place])
        return np.array(found, dtype=object)

    def _sides(self, given: Multipliers) -> Fraction:
        """The sides of the rows times their multipliers."""
        rows = given.rows
        sides = np.where(given.numbers > 0, self.model.row_lower[rows], self.model.row_upper[rows])
        ends = _Scaled(sides)
        return Fraction(_dot(given.numbers, ends.numbers), 1 << (given.digits + ends.digits))

    @cached_property
    def digits(self) -> int:
        """Binary digits after the point that entries and costs have in common."""
        return max(self._entries.digits, _Scaled(self.model.objective).digits)

    @cached_property
    def _entries(self) -> _Scaled:
        return _Scaled(self.model.matrix.data)

    @cached_property
    def _costs(self) -> Wholes:
        made = _Scaled(self.model.objective)
        further = self.digits - made.digits
        if made.small and not further:
            return made.numbers
        return np.array([int(number) << further for number in made.numbers.tolist()], dtype=object)

    @cached_property
    def whole(self) -> bool:
        """Whether entries and costs are whole and fit 64-bit integers."""
        return self._entries.small and self.digits == 0 and self._costs.dtype != object

    @cached_property
    def _transposed(self) -> sparse.csc_array:
        matrix = self.model.matrix
        return sparse.csr_array(
            (self._entries.numbers, matrix.indices, matrix.indptr), shape=matrix.shape
        ).T

    @cached_property
    def _widest(self) -> float:
        """The largest sum of the entries' sizes in a column."""
        matrix = self.model.matrix
        sums = np.bincount(matrix.indices, np.abs(matrix.data), minlength=1)
        return float(sums.max(initial=0.0))

    @cached_property
    def _held_below(self) -> Bools:
        return np.isfinite(self.model.row_lower)

    @cached_property
    def _held_above(self) -> Bools:
        return np.isfinite(self.model.row_upper)


def _dot(left: Wholes, right: Wholes) -> int:
    """The sum of products, in Python's integers where 64 bits may be too few."""
    sizes = np.abs(left.astype(np.float64)) @ np.abs(right.astype(np.float64))
    if object not in (left.dtype, right.dtype) and sizes < _SAFE:
        return int(left @ right)
    return sum(a * b for a, b in zip(left.tolist(), right.tolist(), strict=True) if a and b)


def implied_most(model: Model) -> Floats:
    """Upper bounds of the columns, those without one bounded by the equations that define them.

    Such a column is the last without a bound in an equation; what the columns before it can come to
    at most is what it can be. Running totals and counts are of this kind.
    """
    most = model.upper.copy()
    for column, row, end in defining_rows(model):
        most[column] = implied_end(model, most, column, row, end)
    return most


def defining_rows(model: Model) -> list[tuple[int, int, int]]:
    """Columns without an upper bound, in order, with a row that may give one, and their place."""
    matrix = model.matrix
    loose = np.isinf(model.upper)
    if not loose.any():
        return []
    entries = np.flatnonzero(loose[matrix.indices])
    rows = np.searchsorted(matrix.indptr, entries, side="right") - 1
    entries = entries[model.row_lower[rows] == model.row_upper[rows]]
    rows = np.searchsorted(matrix.indptr, entries, side="right") - 1
    order = np.lexsort((matrix.indices[entries], rows))
    entries, rows = entries[order], rows[order]
    last = np.append(rows[1:] != rows[:-1], True)[: len(rows)]
    found: dict[int, tuple[int, int]] = {}
    for entry, row in zip(entries[last].tolist(), rows[last].tolist(), strict=True):
        found.setdefault(int(matrix.indices[entry]), (row, entry))
    return [(column, *found[column]) for column in sorted(found)]


def implied_end(model: Model, most: Floats, column: int, row: int, entry: int) -> float:
    """What an equation leaves a column at most, rounded up where a double does not hold it."""
    matrix = model.matrix
    begin, end = int(matrix.indptr[row]), int(matrix.indptr[row + 1])
    own = float(matrix.data[entry])
    if own not in (1.0, -1.0):
        return INFINITY
    parts = [(own, float(model.row_lower[row]))]
    for place in range(begin, end):
        if place != entry:
            other, factor = int(matrix.indices[place]), -own * float(matrix.data[place])
            parts.append((factor, float(most[other] if factor > 0 else model.lower[other])))
    if any(isinf(bound) for _, bound in parts):
        return INFINITY
    sizes = sum(abs(factor * bound) for factor, bound in parts)
    if sizes < _EXACT and all(f.is_integer() and b.is_integer() for f, b in parts):
        return sum(factor * bound for factor, bound in parts)
    return nextafter(float(sum(Fraction(f) * Fraction(b) for f, b in parts)), INFINITY)
