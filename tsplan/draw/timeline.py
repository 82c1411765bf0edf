"""Who is where when: a row for each agent, or each path, or each class of a large team.

A stay covers every step at which the agent is at its state, so a bar from 2 to 5 means steps 2, 3,
4 and 5; the way between two stays is hatched. Swarms whose agents have no paths have a row for
each group, as long as it lasts. Modules have a strip below their bars that shows in what structures
they are.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import accumulate
from typing import Any

import numpy as np

from tsplan.checking.fitting import refuse_misfit, refuse_pathless
from tsplan.draw import canvas
from tsplan.draw.canvas import DARK, LINE, SMALL, Entry, Picture
from tsplan.draw.palette import PLAIN, TRAVEL, Paint, Palette, paints
from tsplan.draw.step_axes import HALF, name_rows, names_width, step_axes
from tsplan.draw.tracks import Track, agents_of, by_class, single, tracks
from tsplan.errors import Finding, PlanError
from tsplan.mission import Mission
from tsplan.plans.plan import Plan
from tsplan.plans.presence import interval_counts
from tsplan.words import visible

MOST_AGENTS = 24
"""Agents up to which each has a row of its own."""

MOST_PATHS = 60
"""Different paths up to which each has a row; beyond, each class has one band."""

_WIDTH = 7.0  # inches of the steps
_ROW = 0.21  # inches of one row
_BAND = 1.1  # inches of a class's band
_LONGEST = 26  # characters of a row's name
_MOST_ENTRIES = 20
_THICK = 0.82  # of a row
_STRIP = 0.22  # of a row, for the structure that a module is part of


@dataclass(frozen=True)
class Key:
    """What a colour stands for: labels, or a state of a plan without a map."""

    words: str
    paint: Paint


Keys = Mapping[str, Key]


def draw_timeline(plan: Plan, mission: Mission | None = None, ax: Any = None) -> Picture:
    """When each agent, path, group or class is where.

    With the mission, colours stand for labels, as on the map; without it, for states. Raises
    PlanError for a plan without paths or of another mission.
    """
    if mission is None:
        refuse_pathless(plan)
    else:
        refuse_misfit(plan, mission)
    moving = tracks(plan, mission, modules=True)
    if not moving:
        what = "the plan has no paths of single agents, which a timeline shows"
        raise PlanError([Finding(what, "look at its flow, or make paths: plan --agents")])
    keys = keys_of(moving, plan.horizon, mission)
    rows = rows_of(plan, moving)
    classes = by_class(moving)
    words = [canvas.shortened(row.name, _LONGEST) for row in rows] or [
        f"{canvas.shortened(name, _LONGEST)}\n{agents_of(group):,} agents"
        for name, group in classes.items()
    ]
    shapes = shapes_of(moving, mission) if rows else {}
    entries = [*_entries(moving, plan.horizon, keys), *_shape_entries(shapes)]
    left = names_width([row.name for row in rows] or list(classes), _LONGEST)
    inches = _WIDTH + left, height_of(plan, moving)
    figure, ax = step_axes(ax, plan.horizon, inches, entries)
    ax.set_ylim(len(words) - HALF, -HALF)
    what = "who is where" if rows else "how many are where"
    name_rows(ax, range(len(words)), words, f"{plan.mission.name}: {what}")
    canvas.settle(figure)
    if rows:
        _draw_rows(ax, rows, keys, plan.horizon)
        _draw_lives(ax, rows, shapes)
    else:
        _draw_bands(ax, moving, keys, plan.horizon)
    return figure, ax


def rows_of(plan: Plan, moving: Sequence[Track]) -> tuple[Track, ...]:
    """The rows, class by class; none for a team with too many paths."""
    if sum(len(track.ids) or 1 for track in moving) <= MOST_AGENTS:
        alone = tuple(single(moving))
        order = {name: place for place, name in enumerate(by_class(moving))}
        place = {agent.id: place for place, agent in enumerate(plan.agents)}
        return tuple(
            sorted(alone, key=lambda t: (order[t.class_name], place.get(t.name, len(place))))
        )
    return path_rows(moving) if len(moving) <= MOST_PATHS else ()


def path_rows(moving: Sequence[Track]) -> tuple[Track, ...]:
    """A row for each track, named by its first agents and their number."""
    return tuple(
        replace(track, name=f"{track.short} ({track.count})") if len(track.ids) > 1 else track
        for track in moving
    )


def height_of(plan: Plan, moving: Sequence[Track]) -> float:
    """Inches that the rows of a plan take."""
    rows = rows_of(plan, moving)
    return max(_ROW * len(rows) + 0.1 if rows else _BAND * len(by_class(moving)), 0.8)


def keys_of(moving: Sequence[Track], horizon: int, mission: Mission | None) -> Keys:
    """What each state of the tracks is painted as.

    With a mission, states that look the same on the map have one key, named by the labels that all
    of them have.
    """
    states = sorted({stop.state for track in moving for stop in track.stays(horizon)})
    if mission is None:
        given = paints(states)
        return {state: Key(state, given[state].soft) for state in states}
    painted = Palette.of(mission).states
    labels = {state: mission.system.states[state].labels for state in states}
    alike: dict[Paint, list[frozenset[str]]] = {}
    for state in states:
        if labels[state]:
            alike.setdefault(painted[state], []).append(labels[state])
    named = {}
    for paint, sets in alike.items():
        words = frozenset.intersection(*sets) or frozenset.union(*sets)
        named[paint] = Key(", ".join(sorted(words)), paint.soft)
    nowhere = Key("no label", PLAIN)
    return {state: named[painted[state]] if labels[state] else nowhere for state in states}


def _draw_rows(ax: Any, rows: Sequence[Track], keys: Keys, horizon: int) -> None:
    ends = accumulate(Counter(row.class_name for row in rows).values())
    for end in [*ends][:-1]:
        ax.axhline(end - HALF, color=LINE, linewidth=0.5)
    width, height = canvas.extent(ax)
    across, tall = width / (horizon + 1), height / len(rows)
    size = min(SMALL, 0.75 * tall)
    for place, row in enumerate(rows):
        for first, last in row.ways(horizon):
            _bar(ax, place, (first, last), TRAVEL, "on the way")
        for first, last, state, _ in row.stays(horizon):
            _bar(ax, place, (first, last), keys[state].paint, state)
            words, room = visible(state), across * (last - first + 1) - 3
            if size >= SMALL * 0.7 and canvas.text_size(words, size)[0] < room:
                look = {"fontsize": size, "color": keys[state].paint.ink}
                look |= {"ha": "center", "va": "center_baseline"}
                above = place - _STRIP / 2 * bool(row.lives)
                ax.text((first + last) / 2, above, canvas.plain(words), **look)


def shapes_of(found: Iterable[Track], mission: Mission | None = None) -> Mapping[str, Paint]:
    """What each configuration of the structures that modules are part of is painted as."""
    names = dict.fromkeys(life.configuration for track in found for life in track.lives)
    given = paints(names) if mission is None else Palette.of(mission).classes
    return {name: given[name] for name in names}


def _draw_lives(ax: Any, rows: Sequence[Track], shapes: Mapping[str, Paint]) -> None:
    """A strip below each module's bars, in the colour of the structure that it is part of."""
    for place, row in enumerate(rows):
        for life in row.lives:
            paint, below = shapes[life.configuration], place + (_THICK - _STRIP) / 2
            _bar(ax, below, life[:2], paint, life.id, height=_STRIP)


def _shape_entries(shapes: Mapping[str, Paint]) -> list[Entry]:
    """What the strips below the bars stand for."""
    shown = [Entry.patch(f"in a {name}", **_framed(paint)) for name, paint in shapes.items()]
    return [*shown, Entry.nothing("gaps: being rebuilt")] if shown else []


def _bar(
    ax: Any,
    place: float,
    steps: tuple[float, float],
    paint: Paint,
    meaning: str,
    *,
    height: float = _THICK,
) -> None:
    first, last = steps
    style = canvas.area(paint) | {"height": height, "gid": visible(meaning)}
    ax.barh(place, last - first + 1, left=first - HALF, **style)


def _draw_bands(ax: Any, moving: Sequence[Track], keys: Keys, horizon: int) -> None:
    """One band for each class: its share at the states of each colour, the rest on the way."""
    edges = np.arange(horizon + 2) - HALF
    row = {key: number for number, key in enumerate(dict.fromkeys(keys.values()))}
    for place, (name, group) in enumerate(by_class(moving).items()):
        everybody = agents_of(group)
        intervals = (
            (row[keys[state]], first, last, track.count)
            for track in group
            for first, last, state, _ in track.stays(horizon)
        )
        counts = interval_counts(intervals, len(row), horizon)
        floor = np.zeros(horizon + 1, dtype=np.int64)
        away = Key("on the way", TRAVEL), everybody - counts.sum(axis=0)
        for key, there in [*zip(row, counts, strict=True), away]:
            low, high = (place + _THICK * (HALF - n / everybody) for n in (floor, floor + there))
            floor = floor + there
            if there.any():
                low, high = np.append(low, low[-1]), np.append(high, high[-1])
                look = canvas.area(key.paint) | {"linewidth": 0.3, "step": "post"}
                ax.fill_between(edges, low, high, gid=visible(f"{name}: {key.words}"), **look)


def _entries(moving: Sequence[Track], horizon: int, keys: Keys) -> list[Entry]:
    """What the colours stand for, and the hatch of the ways."""
    listed = sorted(dict.fromkeys(keys.values()), key=lambda key: key.paint == PLAIN)
    shown = [Entry.patch(key.words, **_framed(key.paint)) for key in listed]
    shown = canvas.cut_entries(shown, _MOST_ENTRIES)
    if any(True for track in moving for _ in track.ways(horizon)):
        shown.append(Entry.patch("on the way", **_framed(TRAVEL)))
    return shown


def _framed(paint: Paint) -> dict[str, Any]:
    return canvas.area(paint) | ({} if paint.hatch else {"edgecolor": DARK, "linewidth": 0.3})
