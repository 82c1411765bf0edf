"""Who is where when: a row for each agent, or each path, or each class of a large team.

A stay covers every step at which the agent is at its state, so a bar from 2 to 5 means steps 2, 3,
4 and 5; the way between two stays is hatched, from shortly after the one to shortly before the
other step. Swarms whose agents have no paths have a row for
each group, as long as it lasts. Modules have a strip below their bars that shows in what structures
they are.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import accumulate
from typing import Any, NamedTuple

import numpy as np

from tsplan.checking.fitting import refuse_misfit, refuse_pathless
from tsplan.draw import canvas
from tsplan.draw.canvas import DARK, LINE, SMALL, Entry, Picture
from tsplan.draw.focus import WHOLE, Focus
from tsplan.draw.palette import PLAIN, TRAVEL, Paint, Palette, paints
from tsplan.draw.step_axes import (
    DWELL,
    HALF,
    Prepared,
    completed,
    finish_steps,
    name_rows,
    names_width,
    step_axes,
)
from tsplan.draw.timeline_rows import Row, paired, rows_of
from tsplan.draw.tracks import Track, agents_of, by_class, tracks
from tsplan.errors import Finding, PlanError
from tsplan.mission import Mission
from tsplan.plans.plan import Plan
from tsplan.plans.presence import interval_counts
from tsplan.words import visible

_WIDTH = 7.0  # inches of the steps
_ROW = 0.21  # inches of one row
_PAIR = 0.3  # and of one with what was planned, too
_BAND = 1.1  # inches of a class's band
_LONGEST = 26  # characters of a row's name
_MOST_ENTRIES = 20
_THICK = 0.82  # of a row
_STRIP = 0.27  # of a bar, for the structure that a module is part of
_PALE = 0.45  # opacity of what was planned


class Slot(NamedTuple):
    """Which part of a row bars take: from its middle down to theirs, and their height."""

    middle: float
    height: float

    @property
    def strip(self) -> float:
        """The height at their foot for the structure that a module is part of."""
        return self.height * _STRIP


_ALL = Slot(0.0, _THICK)
_EXECUTED, _PLANNED = Slot(-0.13, 0.56), Slot(0.29, 0.22)


@dataclass(frozen=True)
class Key:
    """What a colour stands for: labels, or a state of a plan without a map."""

    words: str
    paint: Paint


Keys = Mapping[str, Key]

IDLE = Key("never moving", PLAIN)
"""What stands for the states of those who never move, where they have one row."""


def draw_timeline(
    plan: Plan, mission: Mission | None = None, ax: Any = None, focus: Focus = WHOLE
) -> Picture:
    """When each agent, path, group or class is where.

    With the mission, colours stand for labels, as on the map; without it, for states. Where it is
    known what happened, that has the bars, and what was planned a thin pale one below each. Raises
    PlanError for a plan without paths or of another mission.
    """
    return completed(prepare_timeline(plan, mission, ax, focus))


def prepare_timeline(plan: Plan, mission: Mission | None, ax: Any, focus: Focus) -> Prepared:
    """The same, with what is left to be drawn."""
    rows, moving = table_of(plan, mission, focus)
    horizon = focus.until(plan)
    before = planned_tracks(plan, mission, focus)
    keys = keys_of([*moving, *before], horizon, mission)
    classes = by_class(moving)
    words = [canvas.shortened(row.shown.name, _LONGEST) for row in rows] or [
        f"{canvas.shortened(name, _LONGEST)}\n{agents_of(group):,} agents"
        for name, group in classes.items()
    ]
    shapes = shapes_of(moving, mission) if rows else {}
    entries = [*_entries(moving, horizon, keys), *_shape_entries(shapes)]
    if before:
        entries.append(Entry.nothing("pale, below: planned"))
    left = names_width([row.shown.name for row in rows] or list(classes), _LONGEST)
    figure, ax = step_axes(ax, horizon, (_WIDTH + left, rows_height(rows, moving)), entries)
    ax.set_ylim(len(words) - HALF, -HALF)
    what = "who is where" if rows else "how many are where"
    name_rows(ax, range(len(words)), words, f"{plan.mission.name}: {what}")

    def fill() -> None:
        if rows:
            _draw_rows(ax, rows, keys, horizon)
            _draw_lives(ax, rows, shapes, horizon)
        elif before:
            _draw_bands(ax, moving, keys, (horizon, _EXECUTED, False))
            _draw_bands(ax, before, keys, (horizon, _PLANNED, True))
        else:
            _draw_bands(ax, moving, keys, (horizon, _ALL, False))
        finish_steps(ax, focus.step)

    return (figure, ax), fill


def table_of(
    plan: Plan, mission: Mission | None, focus: Focus = WHOLE
) -> tuple[tuple[Row, ...], tuple[Track, ...]]:
    """The rows of a timeline, none where classes have bands, and all tracks that it shows.

    Raises PlanError for a plan without paths or of another mission.
    """
    shown = plan if focus.executed is None else focus.executed
    if mission is None:
        refuse_pathless(shown)
    else:
        refuse_misfit(shown, mission)
    moving = focus.chosen(tracks(shown, mission, modules=True), shown)
    if not moving:
        what = "the plan has no paths of single agents, which a timeline shows"
        raise PlanError([Finding(what, "look at its flow, or make paths: plan --agents")])
    rows = rows_of(shown, moving)
    if focus.executed is None:
        return tuple(Row(row) for row in rows), moving
    return paired(rows, planned_tracks(plan, mission, focus)), moving


def planned_tracks(plan: Plan, mission: Mission | None, focus: Focus) -> tuple[Track, ...]:
    """What was planned, where what happened is shown beside it."""
    if focus.executed is None:
        return ()
    return focus.chosen(tracks(plan, mission, modules=True), plan)


def height_of(plan: Plan, mission: Mission | None = None, focus: Focus = WHOLE) -> float:
    """Inches that the rows of a plan take."""
    return rows_height(*table_of(plan, mission, focus))


def rows_height(rows: Sequence[Row], moving: Sequence[Track]) -> float:
    """Inches that some rows take, or the bands of the classes where there are none."""
    row = _ROW if not any(row.planned for row in rows) else _PAIR
    return max(row * len(rows) + 0.1 if rows else _BAND * len(by_class(moving)), 0.8)


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


def _draw_rows(ax: Any, rows: Sequence[Row], keys: Keys, horizon: int) -> None:
    ends = accumulate(Counter(row.shown.class_name for row in rows).values())
    for end in [*ends][:-1]:
        ax.axhline(end - HALF, color=LINE, linewidth=0.5)
    tall = canvas.extent(ax)[1] / len(rows)
    for place, row in enumerate(rows):
        slot = _slot(row)
        if row.planned is not None:
            _draw_track(ax, row.planned, keys, (place, _PLANNED, horizon))
        size = min(SMALL, 0.75 * tall * slot.height / _THICK)
        _draw_track(ax, row.shown, keys, (place, slot, horizon))
        if size >= SMALL * 0.7:
            above = slot.strip / 2 if row.shown.lives else 0
            _write_stays(ax, row.shown, keys, (place + slot.middle - above, size, horizon))


def _slot(row: Row) -> Slot:
    """Which part of a row the bars of what happened take."""
    return _ALL if row.planned is None else _EXECUTED


def _draw_track(ax: Any, row: Track, keys: Keys, where: tuple[int, Slot, int]) -> None:
    """The bars of a row: what happened in their colours, and what was planned paler."""
    place, slot, horizon = where
    style = {"height": slot.height}
    if slot is _PLANNED:
        style |= {"alpha": _PALE}
    said = "planned " if slot is _PLANNED else ""
    for reach in way_reaches(row, horizon):
        _bar(ax, place + slot.middle, reach, TRAVEL, f"{said}on the way", **style)
    for state, reach in stay_reaches(row, horizon):
        paint = keys.get(state, IDLE).paint
        _bar(ax, place + slot.middle, reach, paint, f"{said}{state}", **style)


def way_reaches(row: Track, horizon: int) -> Iterator[tuple[float, float]]:
    """From when to when they are on the way, for each way; at the end to the end of the axis."""
    for left, come in row.journeys(horizon):
        yield left + DWELL, come - DWELL if come <= horizon else horizon + HALF


def stay_reaches(row: Track, horizon: int) -> Iterator[tuple[str, tuple[float, float]]]:
    """The state of each stay, and from when to when its bar reaches.

    At the ends of time a bar reaches the end of the axis, and a group that splits or meets others
    where it stays reaches them.
    """
    end = min(row.end - 1, horizon)
    for first, last, state, _ in row.stops:
        if first > end:
            return
        if last >= horizon:
            until = horizon + HALF
        else:
            until = row.end - DWELL if last > end else last + DWELL
        yield state, (first - (DWELL if first else HALF), until)


def _write_stays(ax: Any, row: Track, keys: Keys, where: tuple[float, float, int]) -> None:
    """The names of states on the bars that have room for them."""
    place, size, horizon = where
    across = canvas.extent(ax)[0] / abs(ax.get_xlim()[1] - ax.get_xlim()[0])
    for state, (begin, end) in stay_reaches(row, horizon):
        words = visible(state)
        if canvas.text_size(words, size)[0] < across * (end - begin) - 3:
            look = {"fontsize": size, "color": keys.get(state, IDLE).paint.ink}
            look |= {"ha": "center", "va": "center_baseline"}
            ax.text((begin + end) / 2, place, canvas.plain(words), **look)


def shapes_of(found: Iterable[Track], mission: Mission | None = None) -> Mapping[str, Paint]:
    """What each configuration of the structures that modules are part of is painted as."""
    names = dict.fromkeys(life.configuration for track in found for life in track.lives)
    given = paints(names) if mission is None else Palette.of(mission).classes
    return {name: given[name] for name in names}


def _draw_lives(ax: Any, rows: Sequence[Row], shapes: Mapping[str, Paint], horizon: int) -> None:
    """A strip at the foot of each module's bars, in the colour of the structure it is part of."""
    for place, row in enumerate(rows):
        slot = _slot(row)
        for life in row.shown.lives:
            paint = shapes[life.configuration]
            below = place + slot.middle + (slot.height - slot.strip) / 2
            begin = life.first - (DWELL if life.first else HALF)
            end = life.last + (DWELL if life.last < horizon else HALF)
            _bar(ax, below, (begin, end), paint, life.id, height=slot.strip)


def _shape_entries(shapes: Mapping[str, Paint]) -> list[Entry]:
    """What the strips below the bars stand for."""
    shown = [Entry.patch(f"in a {name}", **_framed(paint)) for name, paint in shapes.items()]
    return [*shown, Entry.nothing("gaps: being rebuilt")] if shown else []


def _bar(
    ax: Any,
    place: float,
    reach: tuple[float, float],
    paint: Paint,
    meaning: str,
    **look: float,
) -> None:
    begin, end = reach
    style = canvas.area(paint) | {"gid": visible(meaning)} | look
    ax.barh(place, end - begin, left=begin, **style)


def _draw_bands(
    ax: Any, moving: Sequence[Track], keys: Keys, where: tuple[int, Slot, bool]
) -> None:
    """One band for each class: its share at the states of each colour, the rest on the way.

    Between two steps, which are columns of their own, only those are at a state who stay there.
    """
    horizon, slot, planned = where
    moments = 2 * horizon
    steps = np.arange(horizon + 1)
    edges = np.stack([steps - DWELL, steps + DWELL], axis=1).ravel()
    edges[0], edges[-1] = -HALF, horizon + HALF
    row = {key: number for number, key in enumerate(dict.fromkeys(keys.values()))}
    for place, (name, group) in enumerate(by_class(moving).items()):
        everybody = agents_of(group)
        intervals = (
            (row[keys[state]], 2 * first, 2 * last, track.count)
            for track in group
            for first, last, state, _ in track.stays(horizon)
        )
        counts = interval_counts(intervals, len(row), moments)
        floor = np.zeros(moments + 1, dtype=np.int64)
        away = Key("on the way", TRAVEL), everybody - counts.sum(axis=0)
        foot = place + slot.middle + slot.height / 2
        for key, there in [*zip(row, counts, strict=True), away]:
            low, high = (foot - slot.height * n / everybody for n in (floor, floor + there))
            floor = floor + there
            if there.any():
                low, high = np.append(low, low[-1]), np.append(high, high[-1])
                look = canvas.area(key.paint) | {"linewidth": 0.3, "step": "post"}
                look |= {"alpha": _PALE} if planned else {}
                ax.fill_between(edges, low, high, gid=visible(f"{name}: {key.words}"), **look)


def _entries(moving: Sequence[Track], horizon: int, keys: Keys) -> list[Entry]:
    """What the colours stand for, and the hatch of the ways."""
    listed = sorted(dict.fromkeys(keys.values()), key=lambda key: key.paint == PLAIN)
    shown = [Entry.patch(key.words, **_framed(key.paint)) for key in listed]
    shown = canvas.cut_entries(shown, _MOST_ENTRIES)
    if any(True for track in moving for _ in track.journeys(horizon)):
        shown.append(Entry.patch("on the way", **_framed(TRAVEL)))
    return shown


def _framed(paint: Paint) -> dict[str, Any]:
    return canvas.area(paint) | ({} if paint.hatch else {"edgecolor": DARK, "linewidth": 0.3})
