"""Values as YAML in flow style, so that each state and each edge of a map takes one line.

Sets and tuples carry the tags under which LOMAP's files have them.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping
from collections.abc import Set as AbstractSet
from functools import lru_cache
from types import MappingProxyType
from typing import Any

from tsplan.limits import DIGITS

_SAFE = re.compile(r"[A-Za-z_][A-Za-z0-9_.-]*\Z")
# words that some YAML reader, of version 1.1 or 1.2, takes for something else than text
_TAKEN = frozenset(("y", "n", "yes", "no", "on", "off", "true", "false", "null", "none"))
_LONGEST = 10**DIGITS
_WIDEST = 1e16  # up to here a whole float has no more digits than it says


def word(text: str) -> str:
    """A string, in quotes where it could be read as something else.

    >>> word("q1"), word("12"), word("no")
    ('q1', '"12"', '"no"')
    """
    if _SAFE.match(text) and text.lower() not in _TAKEN:
        return text
    return '"' + "".join(map(_character, text)) + '"'


_key = lru_cache(maxsize=256)(word)  # the same few again and again


def _character(char: str) -> str:
    if char.isprintable() and char not in '"\\':
        return char
    return '\\"' if char == '"' else char.encode("unicode_escape").decode("ascii")


def short(value: Any) -> Any:
    """A number without needless digits, which may cost a float its point; tuples as lists.

    >>> flow([short(number) for number in (2.0, 1e-5, 1e300)]), short((1.0, 2.5))
    ('[2, 1.0e-05, 1.0e+300]', [1, 2.5])
    """
    if isinstance(value, float):
        return int(value) if value.is_integer() and abs(value) < _WIDEST else value
    if isinstance(value, tuple):
        return list(map(short, value))
    if isinstance(value, int) and abs(value) >= _LONGEST:
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
    write = _WRITERS.get(type(value))
    if write is None:  # of a class below or beside one of these
        kinds = (kind for kind in _KINDS if isinstance(value, kind))
        write = _KINDS.get(next(kinds, object), repr)
    return write(value)


def _list(value: Iterable[Any]) -> str:
    return "[" + ", ".join(map(flow, value)) + "]"


def _mapping(value: Mapping[str, Any]) -> str:
    return "{" + ", ".join(f"{_key(key)}: {flow(part)}" for key, part in value.items()) + "}"


def _set(value: AbstractSet[Any]) -> str:
    return "!!set {" + ", ".join(f"{member}: null" for member in sorted(map(flow, value))) + "}"


_KINDS: Mapping[type[Any], Callable[[Any], str]] = MappingProxyType(
    {
        str: word,
        float: _real,
        list: _list,
        tuple: lambda value: "!!python/tuple " + _list(value),
        Mapping: _mapping,
        AbstractSet: _set,
    }
)
_WRITERS: Mapping[type[Any], Callable[[Any], str]] = MappingProxyType(
    {
        **_KINDS,
        int: repr,
        bool: lambda value: "true" if value else "false",
        type(None): lambda _: "null",
        dict: _mapping,
    }
)
"""How values of a class are written; asked for by the class itself, as maps have many of them."""
