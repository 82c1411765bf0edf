"""Matplotlib without its global state: figures of our own, text sizes, what everything shares."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import Any, NamedTuple, TypeAlias

from tsplan.draw.matplotlib_loading import lacking, library
from tsplan.draw.palette import TRAVEL, TRAVEL_STRIPE, Paint
from tsplan.words import visible

Picture: TypeAlias = "tuple[Any, Any]"
"""A matplotlib figure and its axes."""

TEXT = 8.0
"""Points of ordinary text; `SMALL` of marks, `TINY` of the least that can be read."""
SMALL, TINY = 6.5, 5.0

LINE, DARK, WHITE = "#8c8c8c", "#333333", "#ffffff"
SOFT = "#666666"
"""Words of less weight: the palest grey that can be read well on white, and so does its mirror on a
dark ground."""

POINTS = 72.0  # points of an inch

_LARGE = 100.0  # points, at which letters are measured
_FIXED = 65536.0  # one in the font library's fixed-point numbers
_LONGEST = 40  # characters of a legend's entry


class Entry(NamedTuple):
    """One line of a legend: a matplotlib artist to show and what it means."""

    handle: Any
    words: str

    @classmethod
    def line(cls, words: str, **style: Any) -> Entry:
        """An entry with a line, or with a marker alone where the style names one."""
        style = {"linestyle": "none"} | style if "marker" in style else style
        return cls(library("lines").Line2D([], [], **style), words)

    @classmethod
    def patch(cls, words: str, **style: Any) -> Entry:
        """An entry with a small area."""
        return cls(library("patches").Patch(**style), words)

    @classmethod
    def nothing(cls, words: str) -> Entry:
        """An entry of words alone."""
        return cls.line(words, linestyle="none")


def cut_entries(entries: Sequence[Entry], most: int, rest: str = "") -> list[Entry]:
    """The first entries, and how many more there are."""
    more = len(entries) - most
    hidden = [Entry.patch(f"and {more} more{rest}", alpha=0)] if more > 0 else []
    return [*entries[:most], *hidden]


def figure_class() -> Any:
    """Matplotlib's Figure; raises PlotUnavailableError with the remedy if it is missing."""
    return library("figure").Figure


def new_figure(width: float, height: float) -> Any:
    """An empty figure of so many inches that no other code knows of."""
    return figure_class()(figsize=(width, height), layout="constrained")


def axes(ax: Any, width: float, height: float) -> Picture:
    """The given axes and their figure (or part of one), or new ones of so many inches."""
    if ax is not None:
        return ax.figure, ax
    figure = new_figure(width, height)
    return figure, figure.add_subplot()


def plain(text: str) -> str:
    """A text of one or more lines that matplotlib shows as it is.

    No part of it is read as a formula of TeX, and what could not be seen is shown as its escape.
    """
    return visible(text, "\n").replace("$", r"\$")


def text_size(text: str, size: float) -> tuple[float, float]:
    """Width and height of a text of one or more lines, in points."""
    lines = text.split("\n")
    widest = max(sum(map(_advance, line)) for line in lines)
    return widest * size, 1.25 * size * len(lines)


@lru_cache(maxsize=5000)
def _advance(letter: str) -> float:
    """How far a letter of the usual font moves the pen, as a share of the font's size."""
    fonts = library("font_manager")
    font = fonts.get_font(fonts.findfont(fonts.FontProperties()))
    if not font.get_char_index(ord(letter)):
        return 1.0  # a letter that the font lacks, mostly a wide one
    font.set_size(_LARGE, POINTS)
    return float(font.load_char(ord(letter)).linearHoriAdvance) / _FIXED / _LARGE


def area(paint: Paint) -> dict[str, Any]:
    """How a patch of a paint is filled: face, stripes and edge, for any matplotlib patch."""
    stripe = TRAVEL_STRIPE if paint == TRAVEL else paint.ink
    return {
        "facecolor": paint.colour,
        "hatch": paint.hatch or None,
        "edgecolor": stripe if paint.hatch else WHITE,
        "linewidth": 0.0 if paint.hatch else 0.6,
    }


def add_collection(ax: Any, kind: str, shapes: Sequence[Any], **style: Any) -> Any:
    """Many shapes at once; the axes keep the limits they have."""
    made = getattr(library("collections"), kind)(shapes, **style)
    ax.add_collection(made, autolim=False)
    return made


def extent(ax: Any) -> tuple[float, float]:
    """Width and height of axes on the page, in points."""
    box = ax.get_window_extent()
    return box.width * POINTS / ax.figure.dpi, box.height * POINTS / ax.figure.dpi


def set_title(ax: Any, words: str) -> None:
    """A title above the left end of the axes."""
    ax.set_title(plain(shortened(words, 2 * _LONGEST)), fontsize=TEXT + 1.5, loc="left")


def legend_width(entries: Sequence[Entry], height: float) -> float:
    """Inches that a legend of these entries takes beside axes of so many inches."""
    if not entries:
        return 0.0
    widest = max(text_size(shortened(entry.words, _LONGEST), SMALL)[0] for entry in entries)
    columns = -(-len(entries) // _legend_rows(height * POINTS))
    return columns * (widest + 4.5 * SMALL) / POINTS + 0.1


def _legend_rows(points: float) -> int:
    return max(4, int(points / (1.7 * SMALL)) - 1)


def legend_beside(ax: Any, entries: Sequence[Entry], gap: float = 0.0) -> None:
    """A legend right of the axes, in as many columns as it takes to be no taller than these.

    `gap` is in inches.
    """
    if not entries:
        return
    shift = library("transforms").ScaledTranslation(gap + 0.08, 0, ax.figure.dpi_scale_trans)
    rows = _legend_rows(extent(ax)[1])
    place = {"loc": "upper left", "bbox_to_anchor": (1, 1), "bbox_transform": ax.transAxes + shift}
    look = {"frameon": False, "borderaxespad": 0.0, "handlelength": 2.0, "alignment": "left"}
    # matplotlib leaves out words that begin with an underscore, so the words are set below
    names, columns = ["?"] * len(entries), -(-len(entries) // rows)
    handles = [entry.handle for entry in entries]
    legend = ax.legend(handles, names, fontsize=SMALL, ncols=columns, **place, **look)
    for text, entry in zip(legend.get_texts(), entries, strict=True):
        text.set_text(plain(shortened(entry.words, _LONGEST)))


def shortened(words: str, longest: int) -> str:
    """One line of words, every character to be seen, cut to a number with a sign that they are."""
    words = visible(words)
    return words if len(words) <= longest else words[: longest - 1] + "\u2026"


def settle(figure: Any) -> None:
    """Let the figure find its layout now, so that sizes on the page are known."""
    whole = figure.figure  # that of a part of a figure is the figure it is in
    engine = whole.get_layout_engine()
    if engine is not None:
        with lacking():  # what is missing is told when the picture is written
            engine.execute(whole)


def halo(ground: str = WHITE) -> dict[str, Any]:
    """What hides the lines behind a text."""
    return {"boxstyle": "round,pad=0.1", "facecolor": ground, "edgecolor": "none", "alpha": 0.85}
