"""Where the team starts: a badge with a number for each class at each of its start states.

What lies at a state at first is written there, too.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator, Mapping
from typing import Any

from tsplan.draw import canvas
from tsplan.draw.canvas import DARK, SMALL, WHITE, Entry, Picture
from tsplan.draw.map import DrawnMap, base, finish
from tsplan.draw.palette import Paint, Palette, classes_of
from tsplan.draw.text_placement import Box
from tsplan.mission import Mission
from tsplan.plans.supplies import Loads, load_words
from tsplan.words import visible

_BADGE = 11.0  # points across a badge
_APART = _BADGE + 2  # points from badge to badge
_DOT = 12.0  # square points of the ring around one robot
_WHITE = Paint(WHITE)
_UNITS = ("", "k", "M", "G", "T", "P", "E")


def draw_mission(mission: Mission, ax: Any = None) -> Picture:
    """The map with how many robots of each class start where."""
    palette = Palette.of(mission)
    drawn = base(palette, ax, [*class_entries(mission, palette), *_resource_entries(mission)])
    draw_starts(drawn, mission, palette.classes)
    _write_first_stocks(drawn, mission)
    return finish(drawn, mission.name or mission.system.name)


def class_entries(mission: Mission, palette: Palette) -> list[Entry]:
    """A legend of the classes: how many robots each has, and what they can do."""
    badge = {"marker": "o", "markersize": 8, "markeredgecolor": DARK, "markeredgewidth": 0.6}
    shown = []
    for name, group in classes_of(mission).items():
        able = f" ({', '.join(group.capabilities)})" if group.capabilities else ""
        colour = palette.classes[name].colour
        shown.append(Entry.line(f"{group.words(name)}{able}", color=colour, **badge))
    return shown


def _resource_entries(mission: Mission) -> list[Entry]:
    """A legend of the resources: how much there is of each, and whether it is used up."""
    return [
        Entry.nothing(
            load_words({item.name: float(item.total)}) + ("" if item.consumed else " (tool)")
        )
        for item in mission.resources
    ]


def _write_first_stocks(drawn: DrawnMap, mission: Mission) -> None:
    """What lies where at step 0, at all states or, where one has no room for it, at none."""
    there: dict[str, Loads] = {}
    for resource in mission.resources:
        for state, amount in resource.at:
            if amount:
                there.setdefault(state, {})[resource.name] = amount
    words = {state: visible(load_words(load, "\n"), "\n") for state, load in there.items()}
    placed = {
        state: drawn.placement.place(text, SMALL, _around(drawn, state, text))
        for state, text in ({} if drawn.dense else words).items()
    }
    for state, centre in {} if None in placed.values() else placed.items():
        ground = drawn.palette.states[state].pale if drawn.system.states[state].shape else WHITE
        style = {"bbox": canvas.halo(ground), "gid": "first stock"}
        drawn.write(words[state], centre or 0, SMALL, **style)


def _around(drawn: DrawnMap, state: str, text: str) -> Iterator[complex]:
    """Places for a text: below a state's name and badges, above, right, left."""
    label = drawn.labels[state]
    wide, tall = canvas.text_size(text, SMALL)
    x, y = drawn.frame.at(drawn.where[state]).real, label.centre.imag
    for more in (1.0, _BADGE + 3):
        yield complex(x, label.box.bottom - tall / 2 - more)
        yield complex(x, label.box.top + tall / 2 + more)
    yield complex(label.box.right + wide / 2 + 3, y)
    yield complex(label.box.left - wide / 2 - 3, y)


def draw_starts(drawn: DrawnMap, mission: Mission, paints: Mapping[str, Paint]) -> None:
    """A badge with the number of robots of each class at each state where some start.

    Modules start as structures of a configuration, which have a badge as a class has.

    `paints` has the colours of the classes; those without one are white.
    """
    starts: dict[str, Counter[str]] = {}
    for group in mission.team:
        for state, count in mission.modular.structures(group).starts:
            there = starts.setdefault(state, Counter())
            if count:
                there[group.configuration or group.class_name] += count
    rows = (
        {}
        if drawn.dense
        else {state: _row_at(drawn, state, len(starts[state])) for state in starts}
    )
    if drawn.dense or None in rows.values():  # some would lie on each other
        _draw_rings(drawn, starts)
        return
    for state, middle in rows.items():
        for place, (name, count) in enumerate(starts[state].items()):
            shift = (place - (len(starts[state]) - 1) / 2) * _APART
            _badge(drawn, (middle or 0) + shift, count, paints.get(name, _WHITE))


def _row_at(drawn: DrawnMap, state: str, number: int) -> complex | None:
    """A free place for a row of badges, which takes it: below a state's name, above, beside it."""
    label = drawn.labels[state]
    across, up = number * _APART / 2, _BADGE / 2 + 1
    x, y = drawn.frame.at(drawn.where[state]).real, label.centre.imag
    centres = (
        complex(x, label.box.bottom - up),
        complex(x, label.box.top + up),
        complex(label.box.right + across + 1, y),
        complex(label.box.left - across - 1, y),
    )
    return drawn.placement.first(centres, lambda centre: Box.around(centre, across, up))


def _draw_rings(drawn: DrawnMap, starts: Mapping[str, Mapping[str, int]]) -> None:
    """A ring at each state where robots start, larger for more of them, without numbers."""
    sizes = [_DOT * math.sqrt(sum(there.values())) for there in starts.values()]
    style = {"facecolors": "none", "edgecolors": DARK, "linewidths": 0.7, "zorder": 7}
    xs, ys = zip(*(drawn.where[state] for state in starts), strict=True)
    drawn.ax.scatter(xs, ys, s=sizes, gid="starts", **style)


def three_digits(count: int) -> str:
    """A number as short as a badge is: the legend has all its digits.

    >>> three_digits(999), three_digits(1234), three_digits(999_999), three_digits(45_600_000)
    ('999', '1.23k', '1M', '45.6M')
    """
    size, unit = float(count), 0
    while size >= (999.5 if unit else 1000):
        size, unit = size / 1000, unit + 1
    return f"{size:.3g}{_UNITS[unit]}"


def _badge(drawn: DrawnMap, centre: complex, count: int, paint: Paint) -> None:
    """A disc with a number; its outline tells it from everything else on the map."""
    text = three_digits(count)
    size = SMALL if len(text) < 3 else SMALL * 2.4 / len(text)  # noqa: PLR2004  (as above)
    x, y = drawn.frame.back(centre)
    edge = {"markeredgecolor": DARK, "markeredgewidth": 0.7, "clip_on": False, "zorder": 7}
    drawn.ax.plot([x], [y], marker="o", markersize=_BADGE, color=paint.colour, gid="start", **edge)
    drawn.write(text, centre, size, color=paint.ink, zorder=8, weight="bold")
