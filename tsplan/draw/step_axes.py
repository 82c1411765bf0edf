"""Axes for charts over the steps of a plan: steps across, named rows down, a legend beside."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from types import MappingProxyType
from typing import Any, TypeAlias

from tsplan.draw import canvas
from tsplan.draw.canvas import DARK, POINTS, SMALL, TINY, Entry, Picture
from tsplan.draw.matplotlib_loading import library

REST = 0.75
"""Inches that the title and the steps take above and below the rows."""

TITLE = 0.45
"""Inches that the title takes above the rows, with some air, where others say the steps."""

HALF = 0.5
"""From a step to the end of the time that stands for it."""

DWELL = 0.35
"""So long before and after a step pictures show what is so at the step; between two steps, who
moves from one state to another is on the way, in every picture of the same plan."""

Prepared: TypeAlias = "tuple[Picture, Callable[[], None]]"
"""A picture with its names and its legend, and what draws the rest once the layout is known."""

WINDOW, CHOSEN, MISSED = "#ececec", "#bcd3ee", "#f4c3bd"
"""Behind steps at which a formula can ask for something, holds by it, or fails by it."""

NEED = MappingProxyType({"color": DARK, "linestyle": (0, (4, 2)), "linewidth": 0.9})
"""The line of what is asked for."""

_MOST_TICKS = 14

NOW = MappingProxyType({"color": "#0b62c4", "linewidth": 1.1, "zorder": 7})
"""The line of the step that is looked at."""

HAIR = "#e4e4e4"


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
    ax.tick_params(axis="x", labelsize=SMALL, length=2.5, width=0.6)
    ax.set_xlabel("step", fontsize=SMALL)
    for side in ("top", "right", "left"):
        ax.spines[side].set_visible(False)
    ax.spines["bottom"].set_linewidth(0.6)
    canvas.legend_beside(ax, entries, beside)
    return figure, ax


def completed(prepared: Prepared) -> Picture:
    """A picture by itself: its layout is found, and the rest is drawn."""
    picture, fill = prepared
    canvas.settle(picture[0])
    fill()
    return picture


def name_rows(ax: Any, middles: Sequence[float], words: Sequence[str], title: str) -> bool:
    """The names of the rows at their middles, without marks, and the title above them all.

    Where rows are too narrow for letters that can be read there are no names; returns whether there
    are.
    """
    lines = sum(word.count("\n") + 1 for word in words) or 1
    size = min(SMALL, canvas.extent(ax)[1] / lines / 1.15)
    named = size >= TINY  # all names or none
    shown = [canvas.plain(word) for word in words] if named else []
    ax.set_yticks(middles if named else (), shown, fontsize=size)
    ax.tick_params(axis="y", length=0)
    canvas.set_title(ax, title)
    return named


def finish_steps(ax: Any, step: float | None) -> None:
    """As many steps below a chart as have room, and a line at the one that is looked at, if any."""
    last = canvas.text_size(f"{ax.get_xlim()[1]:.0f}", SMALL)[0]
    room = int(canvas.extent(ax)[0] / (last + SMALL))
    ax.xaxis.set_major_locator(
        library("ticker").MaxNLocator(nbins=max(1, min(_MOST_TICKS, room)), integer=True)
    )
    if step is not None:
        ax.axvline(step, gid="now", **NOW)


def share_steps(charts: Sequence[Any]) -> None:
    """Charts below each other get one axis of steps, below the last, and thin lines up from it."""
    for ax in charts:
        ax.grid(visible=True, axis="x", color=HAIR, linewidth=0.5)
        ax.set_axisbelow(True)
    for ax in charts[:-1]:
        ax.tick_params(axis="x", length=0, labelbottom=False)
        ax.set_xlabel("")
        ax.spines["bottom"].set_visible(False)


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
