"""Numbers as written: exact, and bounded so that no text costs more than its length."""

from __future__ import annotations

from decimal import Decimal, InvalidOperation
from fractions import Fraction
from numbers import Rational

from tsplan.limits import LARGEST

_FINEST = 400  # digits after it; more than a float can tell apart


def exact(text: str) -> Fraction | None:
    """The number that a text such as `5.`, `.7` or `1e1` means; None if it is out of all range.

    >>> exact("1e1"), exact("5."), exact(".7"), exact("1e999")
    (Fraction(10, 1), Fraction(5, 1), Fraction(7, 10), None)
    """
    try:
        number = Decimal(text)
    except InvalidOperation:  # an exponent of 19 digits or more
        return None
    exponent = number.as_tuple().exponent
    if not isinstance(exponent, int) or exponent < -_FINEST or number.adjusted() > _FINEST:
        return None
    return Fraction(number)


def written(value: float) -> Fraction:
    """A number, exact as it is written: 0.1 is a tenth.

    Raises OverflowError or ValueError for one that is not finite.

    >>> written(0.1), written(2)
    (Fraction(1, 10), Fraction(2, 1))
    """
    return Fraction(value if isinstance(value, Rational) else repr(float(value)))


def whole(value: Fraction | None) -> int | None:
    """The number if it is whole and not absurdly large."""
    if value is None or value.denominator != 1 or abs(value) > LARGEST:
        return None
    return value.numerator
