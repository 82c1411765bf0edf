"""Boxes in the space of one to three signals, and the formulas to be in or out of them."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from types import MappingProxyType
from typing import Any

from tsplan.logic import Formula, conjunction, disjunction, linear

MOST_AXES = 3


class Region:
    """A closed box: from where to where it reaches along each of one to three signals.

    Raises ValueError for no axes, too many, and for one that ends before it begins.

    >>> goal = Region(x=(7, 8), y=(8, 9))
    >>> print(goal.inside())
    x >= 7 && x <= 8 && y >= 8 && y <= 9
    >>> print(goal.outside())
    x <= 7 || x >= 8 || y <= 8 || y >= 9
    """

    __slots__ = ("axes",)
    axes: Mapping[str, tuple[float, float]]

    def __init__(self, **axes: tuple[float, float]) -> None:
        if not 1 <= len(axes) <= MOST_AXES:
            raise ValueError(f"a region has 1 to {MOST_AXES} axes, not {len(axes)}")
        for name, (low, high) in axes.items():
            if not low <= high:
                raise ValueError(f"the region's axis '{name}' ends before it begins")
        bounds = {name: (float(low), float(high)) for name, (low, high) in axes.items()}
        object.__setattr__(self, "axes", MappingProxyType(bounds))

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"a region is frozen; '{name}' cannot be set")

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Region) and dict(self.axes) == dict(other.axes)

    def __hash__(self) -> int:
        return hash(tuple(self.axes.items()))

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickle by the axes, as nothing can be set in a region."""
        return partial(Region, **self.axes), ()

    def __repr__(self) -> str:
        return f"Region({', '.join(f'{name}={ends}' for name, ends in self.axes.items())})"

    def _sides(self) -> list[tuple[Formula, Formula]]:
        """What holds inside and what outside of each side."""
        sides: list[tuple[Formula, Formula]] = []
        for name, (low, high) in self.axes.items():
            sides.append((linear({name: 1}, ">=", low), linear({name: 1}, "<=", low)))
            sides.append((linear({name: 1}, "<=", high), linear({name: 1}, ">=", high)))
        return sides

    def inside(self) -> Formula:
        """In the box, its border included."""
        return conjunction(inside for inside, _ in self._sides())

    def outside(self) -> Formula:
        """Beyond some side of the box, or on it."""
        return disjunction(outside for _, outside in self._sides())

    def clear(self) -> Formula:
        """Beyond one and the same side now and at the next step: the way between stays out."""
        return disjunction(outside.always(0, 1) for _, outside in self._sides())
