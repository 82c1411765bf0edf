"""Axes for charts over the steps of a plan: steps across, named rows down, a legend beside."""

from __future__ import annotations

from collections.abc import Sequence
from types import MappingProxyType
from typing import Any

from tsplan.draw import canvas
from tsplan.draw.canvas import DARK, POINTS, SMALL, Entry, Picture
from tsplan.draw.matplotlib_loading import library

REST = 0.75
"""Inches that the title and the steps take above and below the rows."""

HALF = 0.5
"""From a step to the end of the time that stands for it."""

WINDOW, CHOSEN, MISSED = "#ececec", "#bcd3ee", "#f4c3bd"
"""Behind steps at which a formula can ask for something, holds by it, or fails by it."""

NEED = MappingProxyType({"color": DARK, "linestyle": (0, (4, 2)), "linewidth": 0.9})
"""The line of what is asked for."""


def step_axes(
    ax: Any,
    horizon: int,
    inches: tuple[float, float],
    entries: Sequence[Entry],
    beside: float = 0,
) -> Picture:
    """Axes of steps 0..horizon, with no frame but the axis of the steps, and their legend.

    `inches` are the width without the legend and the height of the rows; `beside` is how many of
    the width lie between the axes and the legend.
    """
    across, tall = inches
    figure, ax = canvas.axes(ax, across + canvas.legend_width(entries, tall), tall + REST)
    ax.set_xlim(-HALF, horizon + HALF)
    ax.xaxis.set_major_locator(library("ticker").MaxNLocator(nbins=14, integer=True))
    ax.tick_params(axis="x", labelsize=SMALL, length=2.5, width=0.6)
    ax.set_xlabel("step", fontsize=SMALL)
    for side in ("top", "right", "left"):
        ax.spines[side].set_visible(False)
    ax.spines["bottom"].set_linewidth(0.6)
    canvas.legend_beside(ax, entries, beside)
    return figure, ax


def name_rows(
    ax: Any, middles: Sequence[float], words: Sequence[str], title: str, size: float = SMALL
) -> None:
    """The names of the rows at their middles, without marks, and the title above them all."""
    ax.set_yticks(middles, [canvas.plain(word) for word in words], fontsize=size)
    ax.tick_params(axis="y", length=0)
    canvas.set_title(ax, title)


def shade_steps(ax: Any, place: int, steps: tuple[int, int], colour: str, meaning: str) -> None:
    """A band behind a row between `place` (above) and `place + 1` over some steps."""
    first, last = steps
    corner, look = (first - HALF, place + 0.04), {"facecolor": colour, "linewidth": 0}
    across = last - first + 1
    shade = library("patches").Rectangle(corner, across, 0.9, gid=meaning, zorder=0.5, **look)
    ax.add_patch(shade)


def names_width(words: Sequence[str], longest: int) -> float:
    """Inches that the names of rows take beside the axes, shortened to a number of characters."""
    return (
        max(canvas.text_size(canvas.shortened(w, longest), SMALL)[0] for w in words) / POINTS + 0.2
    )
