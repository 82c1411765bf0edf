"""The formula beside the map of a moving picture, each part with how much of it is fulfilled."""

from __future__ import annotations

import textwrap
from collections.abc import Iterable, Sequence
from itertools import zip_longest
from typing import TYPE_CHECKING, Any, TypeAlias

from tsplan.draw.matplotlib_loading import library
from tsplan.viewer.formula_rows import Part
from tsplan.words import visible

if TYPE_CHECKING:
    from matplotlib.figure import Figure

LegendLine: TypeAlias = tuple[str, str, str]
"""What a mark stands for, its colour and its shape (matplotlib's letter)."""

MOST_ROWS = 9
"""Parts of the formula that are shown; the others are only counted."""

_INK, _SOFT, _LINE = "#1b222c", "#5a6675", "#d9dee6"
_GOOD, _BAD, _TIME = "#117a43", "#b3261e", "#0b62c4"
_LINES = 3  # of one part's text


class StatusPanel:
    """The part of a figure to the right of `left` (a share of the width), and the time below.

    `what` are the title and the horizon.
    """

    def __init__(self, figure: Figure, what: tuple[str, int], left: float) -> None:
        self._figure = figure
        self._horizon = what[1]
        self._width = float(figure.bbox.width)
        self._left = left * self._width
        self._rows: list[tuple[Part, Any, Any, Any]] = []
        letters = int((self._width - self._left - 24) / 8.4)
        title = textwrap.shorten(visible(what[0]), 2 * letters, placeholder="...")
        self._below = float(figure.bbox.height) - 16
        self._put(self._left, self._below, textwrap.fill(title, letters), 11, weight="bold")
        self._below -= 21 * len(textwrap.wrap(title, letters)) + 2
        self._clock = self._put(self._left, self._below, "", 9.5, color=_SOFT, animated=True)
        self._below -= 30
        self._done = self._time_bar()

    def _put(self, x: float, y: float, words: str, size: float, **looks: Any) -> Any:
        looks = {"va": "top", "color": _INK, "transform": None, "parse_math": False} | looks
        return self._figure.text(x, y, words, fontsize=size, **looks)

    def _line(self, xs: Sequence[float], ys: Sequence[float], **looks: Any) -> Any:
        return self._add(library("lines").Line2D(xs, ys, **looks))

    def _add(self, artist: Any) -> Any:
        """Put an artist on the figure, placed in dots."""
        artist.set_transform(None)
        self._figure.add_artist(artist)
        return artist

    def _time_bar(self) -> Any:
        """The whole time as a line along the bottom; what is over of it is painted anew."""
        self._bar = (18.0, self._width - 18.0)
        looks: dict[str, Any] = {"linewidth": 4, "solid_capstyle": "round"}
        self._line(self._bar, (18.0, 18.0), color=_LINE, **looks)
        return self._line((18.0, 18.0), (18.0, 18.0), color=_TIME, animated=True, **looks)

    def show(self, parts: Sequence[Part]) -> None:
        """List the outermost parts of each formula."""
        rows = [
            part
            for part, after in zip_longest(parts, parts[1:])
            if part.depth == 1 or (part.depth == 0 and (after is None or after.depth == 0))
        ]
        room = self._below - 120
        for number, part in enumerate(rows):
            words = self._wrapped(part.text)
            height = 13.5 * (words.count("\n") + 1) + 9
            room -= height
            if number == MOST_ROWS or room < 0:
                more = f"and {len(rows) - number} more parts"
                self._put(self._left + 22, self._below, more, 8.5, color=_SOFT)
                self._below -= 22
                return
            self._row(part, words)
            self._below -= height

    def _wrapped(self, text: str) -> str:
        letters = max(8, int((self._width - self._left - 36) / 7.15))
        lines = textwrap.wrap(visible(text), letters)
        if len(lines) > _LINES:
            lines = [*lines[: _LINES - 1], lines[_LINES - 1][: letters - 3] + "..."]
        return "\n".join(lines)

    def _row(self, part: Part, words: str) -> None:
        x, y = self._left + 8, self._below - 7
        self._put(self._left + 22, self._below, words, 8.5, family="monospace")
        wedge = library("patches").Wedge
        self._add(wedge((x, y), 7, 0, 360, width=2.5, color=_LINE, linewidth=0))
        done = wedge((x, y), 7, 90, 90, width=2.5, color=_GOOD, linewidth=0, animated=True)
        self._add(done)
        looks: dict[str, Any] = {"color": "white", "linewidth": 1.6, "animated": True}
        check = self._line((x - 3.2, x - 0.8, x + 3.6), (y, y - 2.8, y + 3.2), **looks)
        xs, ys = (x - 3, x + 3, x, x - 3, x + 3), (y - 3, y + 3, y, y + 3, y - 3)
        self._rows.append((part, done, check, self._line(xs, ys, **looks)))

    def legend(self, classes: Iterable[LegendLine]) -> None:
        """The classes' marks, below the formula."""
        y = self._below - 14
        for words, color, marker in classes:
            if y < 40:  # noqa: PLR2004  (dots above the time bar)
                return
            self._line([self._left + 8], [y], color=color, marker=marker)
            shown = textwrap.shorten(visible(words), 40)
            self._put(self._left + 22, y, shown, 8.5, va="center_baseline")
            y -= 17

    def paint(self, time: float) -> None:
        """Paint what depends on the time onto the figure's canvas."""
        self._clock.set_text(f"step {int(time + 1e-9)} of {self._horizon}")
        left, right = self._bar
        self._done.set_xdata((left, left + (right - left) * time / max(1, self._horizon)))
        for artist in (self._clock, self._done):
            self._figure.draw_artist(artist)
        for part, done, check, cross in self._rows:
            failed = part.failed is not None and time >= part.failed
            share = 1.0 if failed else part.share(time)
            done.set_theta1(90 - 360 * share)
            done.set_width(7 if share == 1.0 else 2.5)
            done.set_color(_BAD if failed else _GOOD)
            if share:
                self._figure.draw_artist(done)
            if share == 1.0:
                self._figure.draw_artist(cross if failed else check)
