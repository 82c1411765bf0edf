"""Boxes in the space of a few signals, and the formulas to be in one, out of it or clear of it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from math import isfinite
from types import MappingProxyType
from typing import TypeAlias

from tsplan.logic.atoms import Relation, linear
from tsplan.logic.nodes import Formula, conjunction, disjunction

MOST_AXES = 3

Box: TypeAlias = "Mapping[str, tuple[float, float]]"
"""From where to where a closed box reaches along each of its axes, which are signals."""

Compare: TypeAlias = "Callable[[str, Relation, float], Formula]"
"""How an axis, a relation and an end become a formula."""


def checked(axes: Box) -> dict[str, tuple[float, float]]:
    """A box with floats as ends.

    Raises ValueError for no axes, too many, and one that is not finite or ends before it begins.
    """
    if not 1 <= len(axes) <= MOST_AXES:
        raise ValueError(f"a region has 1 to {MOST_AXES} axes, not {len(axes)}")
    for name, (low, high) in axes.items():
        if not (isfinite(low) and isfinite(high)):
            raise ValueError(f"the region's axis '{name}' has an end that is not finite")
        if not low <= high:
            raise ValueError(f"the region's axis '{name}' ends before it begins")
    return {name: (float(low), float(high)) for name, (low, high) in axes.items()}


def _signal(name: str, relation: Relation, end: float) -> Formula:
    return linear({name: 1}, relation, end)


def inside(axes: Box, compare: Compare = _signal) -> Formula:
    """In the box, its border included."""
    return conjunction(part for part, _ in _sides(axes, compare))


def outside(axes: Box, compare: Compare = _signal) -> Formula:
    """Beyond some side of the box, or on it."""
    return disjunction(part for _, part in _sides(axes, compare))


def clear(axes: Box, compare: Compare = _signal) -> Formula:
    """Beyond one and the same side now and at the next step: the way between stays out."""
    return disjunction(part.always(0, 1) for _, part in _sides(axes, compare))


def _sides(axes: Box, compare: Compare) -> Iterator[tuple[Formula, Formula]]:
    """What holds inside and what outside of each side."""
    for name, (low, high) in axes.items():
        yield compare(name, ">=", low), compare(name, "<=", low)
        yield compare(name, "<=", high), compare(name, ">=", high)


PLACES: Mapping[str, Callable[[Box, Compare], Formula]] = MappingProxyType(
    {"in": inside, "out": outside, "clear": clear}
)
"""What can be said of a box, by the words of formulas."""
