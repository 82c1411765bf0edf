"""Charts with a row for each of several things over the steps of a plan: axes, and which rows."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, TypeAlias, TypeVar

import numpy as np
import numpy.typing as npt

from tsplan.draw import canvas
from tsplan.draw.canvas import POINTS, SMALL, Entry, Picture
from tsplan.draw.step_axes import DWELL, HALF, name_rows, step_axes

T = TypeVar("T")
Numbers: TypeAlias = npt.NDArray[np.float64]

MOST_ROWS = 40
"""Rows that are drawn; of more, those that matter most."""

_WIDTH = 6.0  # inches of the steps
_LONGEST = 36  # characters of a row's name


@dataclass(frozen=True)
class RowChart:
    """What a chart of rows shows: their names and the `title`, and the legend's `entries`.

    `tall` is the height of a row in inches, `middle` where in it the name is, and `beside` how many
    inches the words behind the rows take.
    """

    title: str
    names: Sequence[str]
    entries: Sequence[Entry]
    tall: float
    middle: float
    beside: float


def row_axes(ax: Any, horizon: int, chart: RowChart) -> Picture:
    """The axes of a chart, with its names in place; row n lies between n and n + 1."""
    words = [canvas.shortened(name, _LONGEST) for name in chart.names]
    left = max((canvas.text_size(word, SMALL)[0] for word in words), default=0.0) / POINTS
    inches = _WIDTH + left + chart.beside, height_of_rows(len(words), chart.tall)
    figure, ax = step_axes(ax, horizon, inches, chart.entries, chart.beside)
    ax.set_ylim(len(words) or 1, 0)
    name_rows(ax, [place + chart.middle for place in range(len(words))], words, chart.title)
    return figure, ax


def foremost(rows: Sequence[T], rank: Callable[[T], tuple[Any, ...]]) -> tuple[T, ...]:
    """The rows in their order; of too many, those that come first by their rank.

    >>> foremost(range(42), lambda number: (-number,))[:2]
    (2, 3)
    """
    if len(rows) <= MOST_ROWS:
        return tuple(rows)
    first = sorted(range(len(rows)), key=lambda n: (*rank(rows[n]), n))
    return tuple(rows[n] for n in sorted(first[:MOST_ROWS]))


def row_height(ax: Any) -> float:
    """Points that a row of a chart takes."""
    rows = abs(ax.get_ylim()[0] - ax.get_ylim()[1])
    return float(canvas.extent(ax)[1] / rows)


def height_of_rows(count: int, tall: float) -> float:
    """Inches that so many rows take."""
    return max(tall * min(count, MOST_ROWS), 0.8)


def profile(values: Any) -> tuple[Numbers, Numbers]:
    """A line over the steps: level around each step, and between two from the one to the other.

    So no value is said of the time at which those who move are on the way.

    >>> [numbers.round(2).tolist() for numbers in profile([1, 3])]
    [[-0.5, 0.35, 0.65, 1.5], [1.0, 1.0, 3.0, 3.0]]
    """
    steps = np.arange(len(values))
    places = np.stack([steps - DWELL, steps + DWELL], axis=1).ravel()
    places[0], places[-1] = -HALF, len(values) - HALF
    return places, np.repeat(np.asarray(values, dtype=np.float64), 2)
