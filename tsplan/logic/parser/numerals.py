"""Numbers as written: exact, and bounded so that no text costs more than its length."""

from __future__ import annotations

from decimal import Decimal, InvalidOperation
from fractions import Fraction

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


def whole(value: Fraction | None) -> int | None:
    """The number if it is whole and not absurdly large."""
    if value is None or value.denominator != 1 or abs(value) > LARGEST:
        return None
    return value.numerator
