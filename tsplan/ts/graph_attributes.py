"""Attributes of nodes and edges, in graphs of any source, as fields of states and edges."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping
from numbers import Integral, Real
from types import MappingProxyType
from typing import Any, NamedTuple, TypeAlias

from tsplan.limits import clipped, is_number
from tsplan.ts.edges import NOTHING
from tsplan.ts.validity import Fault

_NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d{1,3})?")

Names: TypeAlias = Mapping[str, tuple[str, ...]]
"""What the attributes of a field may be called, where they are not called as the field."""

USUAL: Names = MappingProxyType(
    {
        "labels": ("labels", "label", "prop"),
        "at": ("at", "pos", "position", "location"),
        "color": ("color", "colour"),
    }
)
"""What tools call attributes."""

LENGTHS = ("length", "distance", "dist", "weight")
"""Attributes of edges that are taken for metres, where there is no duration in steps."""


class Misfit(NamedTuple):
    """An attribute that is not what its field may be."""

    attribute: str
    message: str
    remedy: str


def fields_of(
    data: Mapping[str, Any], converters: Converters, names: Names
) -> tuple[dict[str, Any], list[Misfit]]:
    """The fields that the attributes of a node or an edge give, and those that do not fit.

    Coordinates may be two attributes, `x` and `y`.
    """
    fields: dict[str, Any] = {}
    misfits: list[Misfit] = []
    for field, converted in converters.items():
        name = attribute_of(field, data, names)
        if name in data:
            value = converted(data[name])
        elif field == "at" and "at" in names and "x" in data and "y" in data:
            name, value = "x", converted((data["x"], data["y"]))
        else:
            continue
        if isinstance(value, Fault):
            misfits.append(Misfit(name, f"{clipped(data[name])} is {value.what}", value.remedy))
        else:
            fields[field] = value
    return fields, misfits


def attribute_of(field: str, data: Mapping[str, Any], names: Names) -> str:
    """What the attribute of a field is called: the first of its names that is there."""
    known = names.get(field, (field,))
    return next((name for name in known if name in data), known[0])


def length_of(data: Mapping[str, Any], names: Iterable[str]) -> tuple[float | None, list[Misfit]]:
    """The length of an edge in metres, None where it has none."""
    for name in names:
        if name in data:
            value = number_of(data[name])
            if is_number(value) and value >= 0:
                return float(value), []
            what = f"{clipped(data[name])} is no length of at least 0"
            return None, [Misfit(name, what, "write metres, as in 2.5")]
    return None, []


def _words(value: Any) -> frozenset[str] | Fault:
    """One word, or a collection of words; None and empty ones are none."""
    if value is None or isinstance(value, str):
        return frozenset((value,)) if value else NOTHING
    if isinstance(value, Iterable) and not isinstance(value, bytes | Mapping):
        words = tuple(value)
        if all(isinstance(word, str) for word in words):
            return frozenset(word for word in words if word)
    remedy = "write it as 'door' or ['door', 'exit']"
    return Fault("neither a text nor a collection of texts", remedy)


def _text(value: Any) -> str | Fault | None:
    if value is None or isinstance(value, str):
        return value
    return Fault("not a text", "write it as 'tan' or '#d2b48c'")


def _steps(value: Any) -> Any:
    """A number, or one for each class."""
    if isinstance(value, Mapping):
        return {name: number_of(steps) for name, steps in value.items()}
    return number_of(value)


def _numbers(value: Any) -> Any:
    """Collections of collections of numbers as tuples; what is none is left for the checks."""
    if isinstance(value, str | Mapping) or not isinstance(value, Iterable):
        return value
    return tuple(_numbers(number_of(member)) for member in value)


def _spans(value: Any) -> Any:
    """Spans of steps, or one of them; None is none."""
    found = () if value is None else _numbers(value)
    alone = isinstance(found, tuple) and found and not any(isinstance(v, tuple) for v in found)
    return (found,) if alone else found


def number_of(value: Any) -> Any:
    """A number of any type, or the text of one, as Python's own; whole ones as int.

    Anything else is left for the checks to refuse.
    """
    if isinstance(value, str):
        written = value.strip()
        value = float(written) if _NUMBER.fullmatch(written) else value
    if isinstance(value, bool) or not isinstance(value, Real):
        return value
    if isinstance(value, Integral):
        return int(value)
    number = float(value)
    return int(number) if number.is_integer() else number


Converters: TypeAlias = Mapping[str, Callable[[Any], Any]]
OF_STATES: Converters = {
    "labels": _words,
    "at": _numbers,
    "shape": _numbers,
    "color": _text,
    "capacity": number_of,
    "needs": _words,
    "zone": _text,
    "level": _text,
    "closed": _spans,
}
OF_EDGES: Converters = {
    "duration": _steps,
    "cost": number_of,
    "success": number_of,
    "capacity": number_of,
    "needs": _words,
    "zone": _text,
    "closed": _spans,
}
"""The fields that attributes give, each with what makes it of a value."""
