"""Where texts go: a text is placed where it hides no other, or not at all.

A place on the page is a complex number, in points: across and up, so that ways are differences, and
turning a way to its left is multiplying it by `1j`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import Any, NamedTuple, TypeVar

from tsplan.draw.canvas import extent, settle, text_size
from tsplan.draw.edge_layout import Point

T = TypeVar("T")

_CELL = 40.0  # points; texts are looked up by the cells they touch


class Box(NamedTuple):
    """A rectangle in points."""

    left: float
    bottom: float
    right: float
    top: float

    @classmethod
    def around(cls, centre: complex, across: float, up: float) -> Box:
        """A rectangle by its centre and half its width and height."""
        x, y = centre.real, centre.imag
        return cls(x - across, y - up, x + across, y + up)

    def meets(self, other: Box) -> bool:
        """Whether two rectangles share any area."""
        across = self.left < other.right and other.left < self.right
        return across and self.bottom < other.top and other.bottom < self.top

    def inside(self, other: Box) -> bool:
        """Whether this rectangle lies within another one."""
        across = self.left >= other.left and self.right <= other.right
        return across and self.bottom >= other.bottom and self.top <= other.top


class Frame(NamedTuple):
    """How data coordinates lie on the page: `scale` points for one unit, the same both ways."""

    left: float
    bottom: float
    right: float
    top: float
    scale: float

    def at(self, point: Point) -> complex:
        """A point of the data on the page."""
        return complex(point[0] - self.left, point[1] - self.bottom) * self.scale

    def back(self, place: complex) -> Point:
        """A place on the page in data coordinates."""
        return self.left + place.real / self.scale, self.bottom + place.imag / self.scale

    @property
    def page(self) -> Box:
        """The whole frame in points."""
        corner = self.at((self.right, self.top))
        return Box(0.0, 0.0, corner.real, corner.imag)


def frame_of(ax: Any, box: tuple[float, float, float, float]) -> Frame:
    """Set the axes to show a box (left, bottom, right, top) of the data, undistorted."""
    left, bottom, right, top = box
    ax.set_xlim(left, right)
    ax.set_ylim(bottom, top)
    ax.set_aspect("equal", adjustable="box")
    ax.axis("off")
    settle(ax.figure)
    width, height = extent(ax)
    return Frame(*box, min(width / (right - left), height / (top - bottom)))


def direction(way: complex) -> complex:
    """A step of length 1 along a way; none along a way of no length."""
    return way / (abs(way) or 1.0)


class Placement:
    """What is taken on the page, in points."""

    def __init__(self, page: Box) -> None:
        self._page = page
        self._taken: dict[tuple[int, int], list[Box]] = {}

    def free(self, box: Box) -> bool:
        """Whether a box lies on the page and hides nothing."""
        if not box.inside(self._page):
            return False
        return not any(box.meets(o) for cell in _cells(box) for o in self._taken.get(cell, ()))

    def take(self, box: Box) -> None:
        """Mark a box as taken."""
        for cell in _cells(box):
            self._taken.setdefault(cell, []).append(box)

    def first(self, options: Iterable[T], box_of: Callable[[T], Box]) -> T | None:
        """The first of several options whose box is free, which is then taken; None without."""
        for option in options:
            box = box_of(option)
            if self.free(box):
                self.take(box)
                return option
        return None

    def place(self, text: str, size: float, centres: Iterable[complex]) -> complex | None:
        """The first of several centres where a text fits with a little air."""
        width, height = text_size(text, size)
        return self.first(centres, lambda at: Box.around(at, width / 2 + 1, height / 2 + 0.5))


def _cells(box: Box) -> Iterator[tuple[int, int]]:
    for x in range(int(box.left // _CELL), int(box.right // _CELL) + 1):
        for y in range(int(box.bottom // _CELL), int(box.top // _CELL) + 1):
            yield x, y
