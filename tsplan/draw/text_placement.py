"""Where texts go: a text is placed where it hides no other, or not at all."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any, TypeAlias

from tsplan.draw.canvas import extent, settle, text_size

Point: TypeAlias = tuple[float, float]

_CELL = 40.0  # points; texts are looked up by the cells they touch


@dataclass(frozen=True, slots=True)
class Box:
    """A rectangle in points."""

    left: float
    bottom: float
    right: float
    top: float

    @classmethod
    def around(cls, centre: Point, across: float, up: float) -> Box:
        """A rectangle by its centre and half its width and height."""
        x, y = centre
        return cls(x - across, y - up, x + across, y + up)

    def meets(self, other: Box) -> bool:
        """Whether two rectangles share any area."""
        return (
            self.left < other.right
            and other.left < self.right
            and self.bottom < other.top
            and other.bottom < self.top
        )

    def inside(self, other: Box) -> bool:
        """Whether this rectangle lies within another one."""
        return (
            self.left >= other.left
            and self.right <= other.right
            and self.bottom >= other.bottom
            and self.top <= other.top
        )


@dataclass(frozen=True, slots=True)
class Frame:
    """How data coordinates lie on the page: `scale` points for one unit, the same both ways."""

    left: float
    bottom: float
    right: float
    top: float
    scale: float

    def at(self, point: Point) -> Point:
        """A point of the data in points of the page."""
        return (point[0] - self.left) * self.scale, (point[1] - self.bottom) * self.scale

    def back(self, point: Point) -> Point:
        """A point of the page in data coordinates."""
        return self.left + point[0] / self.scale, self.bottom + point[1] / self.scale

    @property
    def page(self) -> Box:
        """The whole frame in points."""
        width, height = self.right - self.left, self.top - self.bottom
        return Box(0.0, 0.0, width * self.scale, height * self.scale)


def frame_of(ax: Any, box: tuple[float, float, float, float]) -> Frame:
    """Set the axes to show a box (left, bottom, right, top) of the data, undistorted."""
    left, bottom, right, top = box
    ax.set_xlim(left, right)
    ax.set_ylim(bottom, top)
    ax.set_aspect("equal", adjustable="box")
    ax.axis("off")
    settle(ax.figure)
    width, height = extent(ax)
    scale = min(width / (right - left), height / (top - bottom))
    return Frame(left, bottom, right, top, scale)


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

    def place(self, text: str, size: float, centres: Iterable[Point]) -> Point | None:
        """The first of several centres where a text fits, then taken; None if there is none."""
        for centre in centres:
            box = text_box(text, size, centre)
            if self.free(box):
                self.take(box)
                return centre
        return None


def text_box(text: str, size: float, centre: Point) -> Box:
    """The rectangle of a text around its centre, with a little air."""
    width, height = text_size(text, size)
    return Box.around(centre, width / 2 + 1, height / 2 + 0.5)


def between(begin: Point, end: Point, share: float) -> Point:
    """The point at a share of the way from one point to another."""
    return begin[0] + (end[0] - begin[0]) * share, begin[1] + (end[1] - begin[1]) * share


def direction(begin: Point, end: Point) -> tuple[Point, float]:
    """A step of length 1 on the way from one point to another, and how long the way is."""
    right, up = end[0] - begin[0], end[1] - begin[1]
    length = math.hypot(right, up) or 1.0
    return (right / length, up / length), length


def _cells(box: Box) -> Iterable[tuple[int, int]]:
    for x in range(int(box.left // _CELL), int(box.right // _CELL) + 1):
        for y in range(int(box.bottom // _CELL), int(box.top // _CELL) + 1):
            yield x, y
