"""Values as YAML in flow style, so that each state and each edge of a map takes one line.

Sets and tuples carry the tags under which LOMAP's files have them.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from collections.abc import Set as AbstractSet
from typing import Any

from tsplan.limits import DIGITS

_SAFE = re.compile(r"[A-Za-z_][A-Za-z0-9_.-]*\Z")
# words that some YAML reader, of version 1.1 or 1.2, takes for something else than text
_TAKEN = frozenset(("y", "n", "yes", "no", "on", "off", "true", "false", "null", "none"))
_WIDEST = 1e16  # up to here a whole float has no more digits than it says


def word(text: str) -> str:
    """A string, in quotes where it could be read as something else.

    >>> word("q1"), word("12"), word("no")
    ('q1', '"12"', '"no"')
    """
    if _SAFE.match(text) and text.lower() not in _TAKEN:
        return text
    return '"' + "".join(map(_character, text)) + '"'


def _character(char: str) -> str:
    if char.isprintable() and char not in '"\\':
        return char
    return '\\"' if char == '"' else char.encode("unicode_escape").decode("ascii")


def short(value: Any) -> Any:
    """A number without needless digits, which may cost a float its point; tuples as lists.

    >>> flow([short(number) for number in (2.0, 1e-5, 1e300)]), short((1.0, 2.5))
    ('[2, 1.0e-05, 1.0e+300]', [1, 2.5])
    """
    if isinstance(value, tuple):
        return list(map(short, value))
    if isinstance(value, float) and value.is_integer() and abs(value) < _WIDEST:
        return int(value)
    if isinstance(value, int) and abs(value) >= 10**DIGITS:
        return float(value)  # more digits are not read as a number
    return value


def given(**fields: Any) -> dict[str, Any]:
    """The fields that say something: all but None and what is empty.

    >>> given(capacity=0, color=None, needs=[])
    {'capacity': 0}
    """
    return {key: value for key, value in fields.items() if value or value == 0}


def _real(value: float) -> str:
    """A number that YAML 1.1 reads as one too: with a point before any exponent."""
    text = repr(value)
    if "e" in text and "." not in text:
        return text.replace("e", ".0e")
    return {"inf": ".inf", "-inf": "-.inf", "nan": ".nan"}.get(text, text)


def flow(value: Any) -> str:
    """Any plain value on one line; tuples and sets with their tags.

    >>> flow({"labels": ["a", "b c"], "at": (1, 2.5)})
    '{labels: [a, "b c"], at: !!python/tuple [1, 2.5]}'
    """
    if isinstance(value, str):
        return word(value)
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{word(key)}: {flow(part)}" for key, part in value.items()) + "}"
    if isinstance(value, tuple):
        return "!!python/tuple " + flow(list(value))
    if isinstance(value, list):
        return "[" + ", ".join(map(flow, value)) + "]"
    if isinstance(value, AbstractSet):
        return "!!set {" + ", ".join(f"{member}: null" for member in sorted(map(flow, value))) + "}"
    return _plain(value)


def _plain(value: Any) -> str:
    if value is None:
        return "null"
    if isinstance(value, bool):
        return "true" if value else "false"
    return _real(value) if isinstance(value, float) else repr(value)
