"""Badges on a map: discs with a number of agents, side by side where there are several."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

from tsplan.draw.canvas import DARK, SMALL
from tsplan.draw.map import DrawnMap
from tsplan.draw.palette import Paint
from tsplan.draw.text_placement import Box

BADGE = 11.0
"""Points across a badge."""

_APART = BADGE + 2  # points from badge to badge
_DOT = 12.0  # square points of the ring around one robot
_UNITS = ("", "k", "M", "G", "T", "P", "E")


class Badge(NamedTuple):
    """So many agents, in a colour."""

    number: int
    paint: Paint


def draw_badges(drawn: DrawnMap, rows: Mapping[str, Sequence[Badge]], kind: str) -> None:
    """The badges at each state, or rings without numbers at all where some have no room."""
    places = (
        {}
        if drawn.dense
        else {state: _row_at(drawn, state, len(row)) for state, row in rows.items()}
    )
    if drawn.dense or None in places.values():  # some would lie on each other
        _draw_rings(drawn, rows, f"{kind}s")
        return
    for state, middle in places.items():
        for place, badge in enumerate(rows[state]):
            shift = (place - (len(rows[state]) - 1) / 2) * _APART
            draw_badge(drawn, (middle or 0) + shift, badge, kind)


def draw_badge(drawn: DrawnMap, centre: complex, badge: Badge, kind: str) -> None:
    """A disc with a number; its outline tells it from everything else on the map."""
    text = three_digits(badge.number)
    size = SMALL if len(text) < 3 else SMALL * 2.4 / len(text)  # noqa: PLR2004  (as above)
    x, y = drawn.frame.back(centre)
    edge = {"markeredgecolor": DARK, "markeredgewidth": 0.7, "clip_on": False, "zorder": 7}
    colour, ink = badge.paint.colour, badge.paint.ink
    drawn.ax.plot([x], [y], marker="o", markersize=BADGE, color=colour, gid=kind, **edge)
    drawn.write(text, centre, size, color=ink, zorder=8, weight="bold")


def place_badge(drawn: DrawnMap, centres: Iterable[complex]) -> complex | None:
    """The first of several places where a badge hides nothing, which it takes."""
    return drawn.placement.first(centres, lambda at: Box.around(at, BADGE / 2, BADGE / 2))


def _row_at(drawn: DrawnMap, state: str, number: int) -> complex | None:
    """A free place for a row of badges, which takes it: below a state's name, above, beside it."""
    label = drawn.labels[state]
    across, up = number * _APART / 2, BADGE / 2 + 1
    x, y = drawn.frame.at(drawn.where[state]).real, label.centre.imag
    centres = (
        complex(x, label.box.bottom - up),
        complex(x, label.box.top + up),
        complex(label.box.right + across + 1, y),
        complex(label.box.left - across - 1, y),
    )
    return drawn.placement.first(centres, lambda centre: Box.around(centre, across, up))


def _draw_rings(drawn: DrawnMap, rows: Mapping[str, Sequence[Badge]], kind: str) -> None:
    """A ring at each state where agents are, larger for more of them, without numbers."""
    if not rows:
        return
    sizes = [_DOT * math.sqrt(sum(badge.number for badge in row)) for row in rows.values()]
    style = {"facecolors": "none", "edgecolors": DARK, "linewidths": 0.7, "zorder": 7}
    xs, ys = zip(*(drawn.where[state] for state in rows), strict=True)
    drawn.ax.scatter(xs, ys, s=sizes, gid=kind, **style)


def three_digits(count: int) -> str:
    """A number as short as a badge is: the legend has all its digits.

    >>> three_digits(999), three_digits(1234), three_digits(999_999), three_digits(45_600_000)
    ('999', '1.23k', '1M', '45.6M')
    """
    size, unit = float(count), 0
    while size >= (999.5 if unit else 1000):
        size, unit = size / 1000, unit + 1
    return f"{size:.3g}{_UNITS[unit]}"
