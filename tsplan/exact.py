"""Numbers as they are written: floats stand for their decimal digits; and how far two are apart."""

from __future__ import annotations

import math
from collections.abc import Iterable
from fractions import Fraction

MOST_EXACT = 2**53
"""Whole numbers up to this are told apart in double precision."""

_LEAST_OBJECTIVE = 1e-9
"""An objective nearer to 0 is taken as this, so that the gap stays a finite number."""


def exact(number: float | Fraction) -> Fraction:
    """The decimal number that a float is written as; whole numbers and fractions as they are.

    Raises ValueError for what is not finite.

    >>> exact(0.1)
    Fraction(1, 10)
    """
    return Fraction(repr(float(number))) if isinstance(number, float) else Fraction(number)


def is_lost(text: str, number: float) -> bool:
    """Whether a text writes a decimal number with digits that its float does not have.

    >>> is_lost("0.12345678901234567890", 0.12345678901234568), is_lost("1e-3", 0.001)
    (True, False)
    """
    try:
        return Fraction(text) != exact(number)
    except ValueError:  # no decimal number, such as YAML's 0x1F and 1_000
        return False


def digits(number: float | Fraction) -> str:
    """A number with as many digits as tell it from all others, whole ones without a point.

    >>> digits(10000009.0), digits(0.1), digits(float("inf"))
    ('10000009', '0.1', 'inf')
    """
    return repr(float(number)).removesuffix(".0")


def common_unit(numbers: Iterable[Fraction]) -> Fraction:
    """The largest number of which all are whole multiples; 1 if there are none but zeros.

    >>> common_unit([Fraction("2.5"), Fraction("0.75")])
    Fraction(1, 4)
    """
    given = {abs(number) for number in numbers if number}
    if not given:
        return Fraction(1)
    below = math.lcm(*(number.denominator for number in given))
    above = math.gcd(*(int(number * below) for number in given))
    return Fraction(above, below)


def relative_gap(objective: float | None, bound: float | None) -> float | None:
    """`|objective - bound| / |objective|`, None while one of them is unknown.

    >>> relative_gap(50.0, 45.0)
    0.1
    """
    if objective is None or bound is None:
        return None
    distance = abs(objective - bound)
    return 0.0 if distance == 0 else distance / max(abs(objective), _LEAST_OBJECTIVE)


class Gapped:
    """What has an objective and a bound on the best one, None while not known."""

    __slots__ = ()

    objective: float | None
    bound: float | None

    @property
    def gap(self) -> float | None:
        """How far the objective may be from the best, relative to it; None while not known."""
        return relative_gap(self.objective, self.bound)
