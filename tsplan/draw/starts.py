"""Where the team starts: a badge with a number for each class at each of its start states.

What lies at a state at first is written there, too.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping
from typing import Any

from tsplan.draw import canvas
from tsplan.draw.badges import BADGE, Badge, draw_badges
from tsplan.draw.canvas import DARK, SMALL, WHITE, Entry, Picture
from tsplan.draw.map import DrawnMap, base, finish
from tsplan.draw.palette import Paint, Palette, classes_of
from tsplan.mission import Mission
from tsplan.plans.supplies import Loads, load_words
from tsplan.words import visible

_WHITE = Paint(WHITE)


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
    """What lies where at step 0."""
    there: dict[str, Loads] = {}
    for resource in mission.resources:
        for state, amount in resource.at:
            if amount:
                there.setdefault(state, {})[resource.name] = amount
    write_stocks(drawn, there, "first stock")


def write_stocks(drawn: DrawnMap, there: Mapping[str, Loads], kind: str) -> None:
    """What lies at each state, at all of them or, where one has no room for it, at none."""
    words = {state: visible(load_words(load, "\n"), "\n") for state, load in there.items()}
    placed = {
        state: drawn.placement.place(text, SMALL, _around(drawn, state, text))
        for state, text in ({} if drawn.dense else words).items()
    }
    for state, centre in {} if None in placed.values() else placed.items():
        ground = drawn.palette.states[state].pale if drawn.system.states[state].shape else WHITE
        style = {"bbox": canvas.halo(ground), "gid": kind}
        drawn.write(words[state], centre or 0, SMALL, **style)


def _around(drawn: DrawnMap, state: str, text: str) -> Iterator[complex]:
    """Places for a text: below a state's name and badges, above, right, left."""
    label = drawn.labels[state]
    wide, tall = canvas.text_size(text, SMALL)
    x, y = drawn.frame.at(drawn.where[state]).real, label.centre.imag
    for more in (1.0, BADGE + 3):
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
    rows = {
        state: [Badge(count, paints.get(name, _WHITE)) for name, count in there.items()]
        for state, there in starts.items()
    }
    draw_badges(drawn, rows, "start")
