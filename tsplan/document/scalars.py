"""What the text of a plain YAML scalar means.

The rules are those of the YAML 1.2 core schema (section 10.3.2), with fewer booleans: only `true`,
`false`, `True` and `False`. So `NO`, `on` and `yes` stay strings and `1:30` is not 90.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import TypeAlias

from tsplan.limits import DIGITS

Scalar: TypeAlias = str | int | float | bool | None

_WORDS: dict[str, Scalar] = {
    **dict.fromkeys(("", "~", "null", "Null", "NULL")),
    **dict.fromkeys(("true", "True"), True),
    **dict.fromkeys(("false", "False"), False),
}
_INTEGER = re.compile(r"[-+]?[0-9]+\Z")
_BASED = re.compile(r"0o[0-7]+\Z|0x[0-9a-fA-F]+\Z")
_FLOAT = re.compile(r"[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?\Z")
_SPECIAL = re.compile(r"[-+]?\.(inf|Inf|INF)\Z|\.(nan|NaN|NAN)\Z")
_NUMBER_START = frozenset("+-.0123456789")


def resolve(text: str) -> Scalar:
    """The value of a plain scalar.

    >>> [resolve(text) for text in ("12", "1.5", "NO", "true", "1:30", "~")]
    [12, 1.5, 'NO', True, '1:30', None]
    """
    if text in _WORDS:
        return _WORDS[text]
    if text[0] not in _NUMBER_START:
        return text
    if len(text) <= DIGITS and text.isdigit() and text.isascii():
        return int(text)
    if _INTEGER.match(text) or _BASED.match(text):
        return _integer(text) if len(text) <= DIGITS else text
    return _real(text) if _FLOAT.match(text) or _SPECIAL.match(text) else text


def _real(text: str) -> float:
    return float(text.lower().replace(".inf", "inf").replace(".nan", "nan"))


def _boolean(text: str) -> bool:
    value = _WORDS.get(text)
    if not isinstance(value, bool):
        raise ValueError(text)  # noqa: TRY004 - the text is wrong, not a Python type
    return value


def _integer(text: str) -> int:
    if len(text) > DIGITS:
        raise ValueError(text)
    return int(text, 0) if _BASED.match(text) else int(text)


def _null(text: str) -> None:
    if text != "None" and _WORDS.get(text, text) is not None:
        raise ValueError(text)


_READERS: tuple[tuple[Callable[[str], Scalar], tuple[str, ...]], ...] = (
    (str, ("str", "timestamp", "python/str", "python/unicode")),
    (_integer, ("int", "python/int", "python/long")),
    (_real, ("float", "python/float")),
    (_boolean, ("bool", "python/bool")),
    (_null, ("null", "python/none")),
)
STANDARD = "tag:yaml.org,2002:"
TAGS = {STANDARD + word: reader for reader, words in _READERS for word in words}
"""Tags that a scalar may carry; Python's are those that its dumpers write for plain data."""
