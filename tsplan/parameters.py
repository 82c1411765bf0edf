"""Parameters of Python calls, checked where they are written, so that errors name that line."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from decimal import Decimal
from fractions import Fraction
from numbers import Integral, Rational, Real
from typing import Any

from tsplan.errors import Finding, InputError, nearest
from tsplan.limits import clipped, complaints
from tsplan.words import nfc

_MOST_DIGITS = 400  # of a number, so that none is computed with for minutes; floats have 309


def refuse_options(**options: Any) -> None:
    """Raise InputError with everything that is wrong with the numbers among some options."""
    wrong = complaints(options)
    if wrong:
        remedy = "leave it out for its default"
        raise InputError(Finding(f"{name}: {words}", remedy) for name, words in wrong.items())


def step_within(step: object, last: int | None, error: type[InputError] = InputError) -> int:
    """A step 0..last (None: open) as a plain number; raises `error` for what is none.

    >>> step_within(4.0, 9)
    4
    """
    number = whole(step)
    steps = "from 0 on" if last is None else f"0..{last}"
    if number is None:
        what = f"the step {clipped(step)} is not a whole number"
        raise error([Finding(what, f"steps are the whole numbers {steps}")])
    if number < 0 or (last is not None and number > last):
        what = f"step {clipped(number)} lies outside {steps}"
        raise error([Finding(what, "choose a step up to the horizon, or set a longer horizon")])
    return number


def whole(value: object) -> int | None:
    """A whole number of any type, also `4.0`, as Python's own; None for anything else."""
    if isinstance(value, bool) or not isinstance(value, Real):
        return None
    if isinstance(value, Integral):
        return int(value)
    number = float(value)
    return int(number) if number.is_integer() else None


def finite(value: object, error: type[InputError] = InputError) -> Fraction:
    """A number exactly as it was written: of a float its shortest decimal.

    Raises `error` for truth values, infinite numbers, and what is no number.

    >>> finite(0.1)
    Fraction(1, 10)
    """
    remedy = "give a finite number"
    if isinstance(value, bool) or not isinstance(value, (Real, Decimal)):
        raise error([Finding(f"{clipped(value)} is not a number", remedy)])
    try:
        if (
            isinstance(value, Decimal)
            and value.is_finite()
            and abs(value.adjusted()) > _MOST_DIGITS
        ):
            number = None if value else Fraction(0)
        elif isinstance(value, Rational):
            number = Fraction(int(value.numerator), int(value.denominator))
        else:
            number = Fraction(value if isinstance(value, Decimal) else str(value))
    except (ValueError, OverflowError):
        raise error([Finding(f"{clipped(value)} is not a finite number", remedy)]) from None
    limit = 10**_MOST_DIGITS
    if number is None or abs(number.numerator) > limit or number.denominator > limit:
        what = f"a number has more than {_MOST_DIGITS} digits"
        raise error([Finding(what, "drop digits")])
    return number


def known_name(
    name: object, known: Sequence[Collection[str]], kind: str, error: type[InputError] = InputError
) -> str:
    """A name that one of several collections knows; raises `error` with the nearest for another.

    >>> known_name("dock", [{"dock", "door"}], "state")
    'dock'
    """
    if not isinstance(name, str):
        raise error([Finding(f"{clipped(name)} is not the name of a {kind}", "give a text")])
    name = nfc(name)  # as the names of maps and missions are
    if not any(name in words for words in known):
        remedy = nearest(name, (word for words in known for word in words))
        raise error([Finding(f"there is no {kind} '{name}'", remedy)])
    return name


def name_list(names: Iterable[object], kind: str) -> tuple[str, ...]:
    """Several names; InputError for one text in place of a list of them, and for no texts."""
    remedy = f"give a list of the names of {kind}s"
    if isinstance(names, str):
        raise InputError([Finding(f"'{names}' is one text", f"{remedy}: ['{names}']")])
    if not isinstance(names, Iterable):
        raise InputError([Finding(f"{clipped(names)} is no list", remedy)])
    listed = tuple(names)
    for name in listed:
        if not isinstance(name, str):
            raise InputError([Finding(f"{clipped(name)} is not the name of a {kind}", remedy)])
    return tuple(nfc(str(name)) for name in listed)
