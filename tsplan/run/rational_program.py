"""A small linear program over the rational numbers, solved exactly.

The simplex method with dictionaries and Bland's rule, by which it ends (R. G. Bland, "New finite
pivoting rules for the simplex method", Mathematics of Operations Research 2, 1977; the form is that
of V. Chvatal, "Linear Programming", 1983). It is made for a handful of columns: what solvers find
in floats is a hint at best where a value has to be exact.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import NamedTuple

_ZERO, _ONE = Fraction(0), Fraction(1)


class Row(NamedTuple):
    """`lower <= factors @ x <= upper`; None bounds nothing."""

    factors: Sequence[Fraction]
    lower: Fraction | None
    upper: Fraction | None


def least(
    costs: Sequence[Fraction], rows: Sequence[Row], most: Sequence[Fraction]
) -> list[Fraction] | None:
    """The columns between 0 and `most` of least cost that keep all rows; None if there are none.

    >>> half, third = Fraction(1, 2), Fraction(1, 3)
    >>> found = least([_ONE, _ONE], [Row([_ONE, half], third, None)], [Fraction(1, 4)] * 2)
    >>> [str(value) for value in found]
    ['1/4', '1/6']
    """
    sides = [([*row.factors], row.upper) for row in rows if row.upper is not None]
    sides += [([-f for f in row.factors], -row.lower) for row in rows if row.lower is not None]
    for place, bound in enumerate(most):
        sides.append(([_ONE if place == each else _ZERO for each in range(len(most))], bound))
    made = _Dictionary([bound for _, bound in sides], [factors for factors, _ in sides], len(costs))
    return made.values() if made.opened() and made.maximised([-cost for cost in costs]) else None


class _Dictionary:
    """Each basic variable as a constant less a sum of the others; variable 0 is an artificial one.

    Variables 1.. are the columns, those behind them the slack of each row.
    """

    def __init__(self, bounds: list[Fraction], factors: list[list[Fraction]], columns: int) -> None:
        self._columns = columns
        self._bound = bounds
        self._rows = [[-_ONE, *row] for row in factors]
        self._others = list(range(columns + 1))
        self._basic = list(range(columns + 1, columns + 1 + len(bounds)))

    def opened(self) -> bool:
        """Go to a point, by way of the least artificial variable; whether there is one."""
        worst = min(range(len(self._bound)), key=self._bound.__getitem__)
        if self._bound[worst] < 0:
            self._pivot(worst, 0)
            self._climb({0: -_ONE})
        if 0 in self._basic:
            row = self._basic.index(0)
            if self._bound[row]:
                return False
            place = next((n for n, factor in enumerate(self._rows[row]) if factor), None)
            if place is None:
                del self._rows[row], self._bound[row], self._basic[row]
            else:
                self._pivot(row, place)
        if 0 in self._others:
            place = self._others.index(0)
            del self._others[place]
            for entries in self._rows:
                del entries[place]
        return True

    def maximised(self, gains: Sequence[Fraction]) -> bool:
        """Go to the point of the greatest gain, which every column is bounded for."""
        self._climb({column + 1: gain for column, gain in enumerate(gains)})
        return True

    def values(self) -> list[Fraction]:
        """The columns at the point."""
        known = dict(zip(self._basic, self._bound, strict=True))
        return [known.get(column + 1, _ZERO) for column in range(self._columns)]

    def _climb(self, gains: dict[int, Fraction]) -> None:
        while True:
            entering = self._entering(gains)
            if entering is None:
                return
            ratios = [
                (self._bound[row] / entries[entering], self._basic[row], row)
                for row, entries in enumerate(self._rows)
                if entries[entering] > 0
            ]
            self._pivot(min(ratios)[2], entering)

    def _entering(self, gains: dict[int, Fraction]) -> int | None:
        """The first of the other variables that gains something by growing."""
        basic = [(row, gains[name]) for row, name in enumerate(self._basic) if gains.get(name)]
        able = []
        for place, name in enumerate(self._others):
            gain = gains.get(name, _ZERO)
            gain -= sum((g * self._rows[row][place] for row, g in basic), _ZERO)
            if gain > 0:
                able.append((name, place))
        return min(able)[1] if able else None

    def _pivot(self, row: int, place: int) -> None:
        """Let another variable take the place of a basic one."""
        entries, factor = self._rows[row], self._rows[row][place]
        new = [entry / factor for entry in entries]
        new[place] = 1 / factor
        bound = self._bound[row] / factor
        for other, theirs in enumerate(self._rows):
            weight = theirs[place]
            if other != row and weight:
                self._bound[other] -= weight * bound
                mixed = [mine - weight * its for mine, its in zip(theirs, new, strict=True)]
                mixed[place] = -weight * new[place]
                self._rows[other] = mixed
        self._rows[row], self._bound[row] = new, bound
        self._basic[row], self._others[place] = self._others[place], self._basic[row]
