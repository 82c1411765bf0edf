"""Boxes in the space of one to three signals, and the formulas to be in or out of them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import partial
from types import MappingProxyType
from typing import Any

from tsplan.logic import Formula, boxes


class Region(Mapping[str, tuple[float, float]]):
    """A closed box: from where to where it reaches along each of one to three signals.

    As a mapping it has the ends by their axes.

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
        object.__setattr__(self, "axes", MappingProxyType(boxes.checked(axes)))

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

    def __getitem__(self, axis: str) -> tuple[float, float]:
        return self.axes[axis]

    def __iter__(self) -> Iterator[str]:
        return iter(self.axes)

    def __len__(self) -> int:
        return len(self.axes)

    def inside(self) -> Formula:
        """In the box, its border included."""
        return boxes.inside(self.axes)

    def outside(self) -> Formula:
        """Beyond some side of the box, or on it."""
        return boxes.outside(self.axes)

    def clear(self) -> Formula:
        """Beyond one and the same side now and at the next step: the way between stays out."""
        return boxes.clear(self.axes)
