"""Names as they are compared; names and numbers as they are shown: nothing hidden, nothing lost."""

from __future__ import annotations

import unicodedata
from collections.abc import Iterable

from tsplan.limits import is_finite

_HIDDEN = frozenset({"Cc", "Cf", "Cs", "Zl", "Zp"})
"""Kinds of characters that act on a terminal or reorder a line instead of being seen."""

_JOINERS = frozenset("\u200c\u200d")  # part of the spelling of some scripts, and harmless
_DECIMALS = 6  # shown after the point, which is more than costs are usually given with
_EXACT = 1e16  # from here on not every whole number is a float


def nfc(text: str) -> str:
    r"""A text in Unicode's composed form (NFC), in which names are compared.

    >>> nfc("cafe\u0301") == "caf\u00e9"
    True
    """
    return text if text.isascii() else unicodedata.normalize("NFC", text)


def visible(text: str, keep: str = "") -> str:
    r"""The text with every character that could not be seen shown as its escape.

    Control characters, marks that reorder a line and halves of characters change what a person
    reads, or what a terminal does. Those in `keep` are left as they are.

    >>> print(visible("q\x1b[31m\n\u202e"))
    q\x1b[31m\n\u202e
    """
    if text.isascii() and text.isprintable():
        return text
    return "".join(c if c in keep or not _hidden(c) else _escaped(c) for c in text)


def _hidden(character: str) -> bool:
    return character not in _JOINERS and unicodedata.category(character) in _HIDDEN


def _escaped(character: str) -> str:
    return character.encode("unicode_escape", "surrogatepass").decode("ascii")


def number(value: float | None, infinite: str = "open") -> str:
    """A number with all its digits before the point and up to six after it; None is `infinite`.

    Small numbers keep six digits that count. Infinite ones are told in words, too.

    >>> [number(value) for value in (10000009.5, 999.999, 1234567.0, 0.00012345678, None)]
    ['10,000,009.5', '999.999', '1,234,567', '0.000123457', 'open']
    """
    if value is None or not is_finite(value):
        return "unknown" if value != value else infinite  # noqa: PLR0124  (as NaN is)
    if abs(value) >= _EXACT:
        return repr(float(value))
    if value == int(value):
        return f"{int(value):,}"
    if abs(value) < 1:
        return f"{value:.{_DECIMALS}g}"
    return f"{value:,.{_DECIMALS}f}".rstrip("0").rstrip(".")


def many(count: int, noun: str) -> str:
    """A number of things.

    >>> many(1, "step"), many(2, "agent")
    ('1 step', '2 agents')
    """
    return f"{count} {noun}{'' if count == 1 else 's'}"


def run_words(spans: Iterable[tuple[int, int]], most: int | None = None) -> str:
    """Runs of steps in words, `most` of them at most.

    >>> run_words([(1, 3), (7, 7)])
    '1..3, 7'
    """
    said = [str(first) if first == last else f"{first}..{last}" for first, last in spans]
    return ", ".join(said if most is None or len(said) <= most else [*said[:most], "..."])


def known(value: float | None) -> float | None:
    """A number as it may be told and written: what is infinite or no number is not known.

    The negative zero is told as 0.

    >>> [known(value) for value in (3.5, -0.0, float("-inf"), float("nan"), None)]
    [3.5, 0.0, None, None, None]
    """
    return value + 0.0 if value is not None and is_finite(value) else None
