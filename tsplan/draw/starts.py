"""Where the team starts: a badge with a number for each class at each of its start states."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING

from tsplan.draw.canvas import DARK, SMALL, WHITE, Entry
from tsplan.draw.map import Scene
from tsplan.draw.matplotlib_loading import library
from tsplan.draw.palette import Paint, Palette
from tsplan.draw.text_placement import Box, Point

if TYPE_CHECKING:
    from tsplan.mission import Mission

_BADGE = 11.0  # points across a badge
_APART = _BADGE + 2  # points from badge to badge
_DOT = 12.0  # square points of the ring around one robot
_WHITE = Paint(WHITE)
_UNITS = ("", "k", "M", "G", "T", "P", "E")


def class_entries(mission: Mission, palette: Palette) -> list[Entry]:
    """A legend of the classes: how many robots each has, and what they can do."""
    counts: dict[str, int] = {}
    able: dict[str, dict[str, None]] = {}
    for group in mission.team:
        counts[group.class_name] = counts.get(group.class_name, 0) + group.count
        able.setdefault(group.class_name, {}).update(dict.fromkeys(sorted(group.capabilities)))
    return [
        Entry(
            library("lines").Line2D(
                [],
                [],
                linestyle="none",
                marker="o",
                markersize=8,
                markeredgecolor=DARK,
                markeredgewidth=0.6,
                color=palette.classes[name].colour,
            ),
            f"{count:,} {name}" + (f" ({', '.join(able[name])})" if able[name] else ""),
        )
        for name, count in counts.items()
    ]


def draw_starts(scene: Scene, mission: Mission, paints: Mapping[str, Paint]) -> None:
    """A badge with the number of robots of each class at each state where some start.

    `paints` has the colours of the classes; those without one are white.
    """
    starts: dict[str, dict[str, int]] = {}
    for group in mission.team:
        for state, count in group.starts:
            there = starts.setdefault(state, {})
            if count:
                there[group.class_name] = there.get(group.class_name, 0) + count
    rows = _rows(scene, starts)
    if rows is None:
        _draw_dots(scene, starts)
        return
    for state, (x, y) in rows.items():
        for place, (name, count) in enumerate(starts[state].items()):
            left = x + (place - (len(starts[state]) - 1) / 2) * _APART
            _badge(scene, (left, y), count, paints.get(name, _WHITE))


def _rows(scene: Scene, starts: Mapping[str, Mapping[str, int]]) -> dict[str, Point] | None:
    """The centre of each state's row of badges; None if they would lie on each other."""
    if scene.dense:
        return None
    found: dict[str, Point] = {}
    for state, there in starts.items():
        centre = _row_at(scene, state, len(there))
        if centre is None:
            return None
        found[state] = centre
    return found


def _row_at(scene: Scene, state: str, number: int) -> Point | None:
    """A free place for a row of badges, which takes it: below a state's sign, above, beside it."""
    x = scene.frame.at(scene.where[state])[0]
    sign = scene.signs[state]
    across, up = number * _APART / 2, _BADGE / 2 + 1
    below, above = sign.box.bottom - up, sign.box.top + up
    right, left = sign.box.right + across + 1, sign.box.left - across - 1
    for centre in ((x, below), (x, above), (right, sign.centre[1]), (left, sign.centre[1])):
        row = Box(centre[0] - across, centre[1] - up, centre[0] + across, centre[1] + up)
        if scene.room.free(row):
            scene.room.take(row)
            return centre
    return None


def _draw_dots(scene: Scene, starts: Mapping[str, Mapping[str, int]]) -> None:
    """A ring at each state where robots start, larger for more of them, without numbers."""
    counts = [sum(there.values()) for there in starts.values()]
    scene.ax.scatter(
        [scene.where[state][0] for state in starts],
        [scene.where[state][1] for state in starts],
        s=[_DOT * math.sqrt(count) for count in counts],
        facecolors="none",
        edgecolors=DARK,
        linewidths=0.7,
        zorder=7,
        gid="starts",
    )


def three_digits(count: int) -> str:
    """A number as short as a badge is: the legend has all its digits.

    >>> three_digits(999), three_digits(1234), three_digits(999_999), three_digits(45_600_000)
    ('999', '1.23k', '1M', '45.6M')
    """
    size, unit = float(count), 0
    while size >= (999.5 if unit else 1000):
        size, unit = size / 1000, unit + 1
    return f"{size:.3g}{_UNITS[unit]}"


def _badge(scene: Scene, centre: Point, count: int, paint: Paint) -> None:
    """A disc with a number; its outline tells it from everything else on the map."""
    text = three_digits(count)
    size = SMALL if len(text) < 3 else SMALL * 2.4 / len(text)  # noqa: PLR2004  (as above)
    x, y = scene.frame.back(centre)
    scene.ax.plot(
        [x],
        [y],
        marker="o",
        markersize=_BADGE,
        color=paint.colour,
        markeredgecolor=DARK,
        markeredgewidth=0.7,
        zorder=7,
        clip_on=False,
        gid="start",
    )
    scene.write(text, centre, size, color=paint.ink, zorder=8, weight="bold")
