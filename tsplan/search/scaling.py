"""What is maximised where not everything can hold: one target a level, or several depths in one."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from math import prod

import numpy as np

from tsplan.encode.encoded import Encoded
from tsplan.encode.expressions import Expression
from tsplan.milp.model import INFINITY
from tsplan.milp.target import Target

MOST_UNITS = 20_000
"""Depths are settled together up to so many outcomes, which the solver's own search tells apart."""

_HALF = 0.5


def aim_at(total: Expression, units: int, columns: int) -> Target:
    """A sum that is to be as large as possible; its values are multiples of one over `units`."""
    unit = Fraction(1, units)
    return Target.of(dict(total.terms), columns, total.constant, maximise=True, unit=unit)


def below(encoded: Encoded, target: Target, value: Fraction) -> Encoded:
    """The model of those plans that reach less than `value`, where that can be told apart."""
    if not target.step:
        return encoded
    least = target.of_own(value) + _HALF
    model = encoded.model.with_row(target.vector, least, INFINITY, "less")
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


def by_depth(claims: Sequence[np.ndarray[tuple[int], np.dtype[np.int64]]], columns: int) -> Target:
    """The claims of several depths, one of a depth worth more than all of the deeper ones."""
    vector = np.zeros(columns)
    weight = 1
    for members in reversed(claims):
        vector[members] = -float(weight)
        weight *= len(members) + 1
    return Target(vector, Fraction(-1))
