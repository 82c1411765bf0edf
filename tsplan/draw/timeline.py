"""Who is where when: a row for each agent, or each path, or each class of a large team.

A stay covers every step at which the agent is at its state, so a bar from 2 to 5 means steps 2, 3,
4 and 5; the way between two stays is hatched.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import groupby, pairwise
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np
import numpy.typing as npt

from tsplan.checking.fitting import refuse_misfit, refuse_pathless
from tsplan.draw.canvas import (
    DARK,
    LINE,
    POINTS,
    SMALL,
    Entry,
    Picture,
    area,
    axes,
    legend_beside,
    legend_width,
    plain,
    set_title,
    settle,
    shortened,
    text_size,
)
from tsplan.draw.matplotlib_loading import library
from tsplan.draw.palette import PLAIN, TRAVEL, Paint, Palette, paints
from tsplan.errors import Finding, PlanError
from tsplan.plans.presence import of_bundles, state_counts
from tsplan.plans.summary import names
from tsplan.words import visible

if TYPE_CHECKING:
    from tsplan.mission import Mission
    from tsplan.plans.agent_plans import Bundle
    from tsplan.plans.plan import Plan

MOST_AGENTS = 24
"""Agents up to which each has a row of its own."""

MOST_PATHS = 60
"""Different paths up to which each has a row; beyond, each class has one band."""

_WIDTH = 7.0  # inches of the steps
_ROW = 0.21  # inches of one row
_REST = 0.75  # inches of title and steps
_BAND = 1.1  # inches of a class's band
_LONGEST = 26  # characters of a row's name
_MOST_ENTRIES = 20
_HALF = 0.5
_THICK = 0.82  # of a row

Ints: TypeAlias = npt.NDArray[np.int64]


@dataclass(frozen=True)
class Row:
    """One row: a name and the path of the agents it stands for."""

    words: str
    class_name: str
    bundle: Bundle


@dataclass(frozen=True)
class Key:
    """What a colour stands for: labels, or a state of a plan without a map."""

    words: str
    paint: Paint


def draw_timeline(plan: Plan, mission: Mission | None = None, ax: Any = None) -> Picture:
    """When each agent, path or class is where.

    With the mission, colours stand for labels, as on the map; without it, for states. Raises
    PlanError for a plan without paths or of another mission.
    """
    if mission is None:
        refuse_pathless(plan)
    else:
        refuse_misfit(plan, mission)
    if not plan.agents:
        what = "the plan has no paths of single agents, which a timeline shows"
        raise PlanError([Finding(what, "look at its flow, or make paths: plan --agents")])
    keys = keys_of(plan, mission)
    rows = rows_of(plan)
    entries = _entries(plan, keys)
    left = _margin([row.words for row in rows] if rows else _class_names(plan))
    tall = height_of(plan)
    figure, ax = axes(ax, _WIDTH + left + legend_width(entries, tall - _REST), tall)
    set_steps(ax, plan.horizon)
    if rows:
        _set_rows(ax, rows)
    else:
        _set_bands(ax, plan)
    legend_beside(ax, entries)
    set_title(ax, f"{plan.mission.name}: {'who is where' if rows else 'how many are where'}")
    settle(figure)
    if rows:
        _draw_rows(ax, rows, keys, plan.horizon)
    else:
        _draw_bands(ax, plan, keys)
    return figure, ax


def rows_of(plan: Plan) -> tuple[Row, ...]:
    """The rows, class by class in the order of the team; none for a team with too many paths."""
    order = {name: number for number, name in enumerate(_class_names(plan))}
    bundles = sorted(plan.bundles, key=lambda b: (order[b.class_name], b.agents[0]))
    if len(plan.agents) <= MOST_AGENTS:
        single = [(place, bundle) for bundle in bundles for place in bundle.agents]
        single.sort(key=lambda item: (order[item[1].class_name], item[0]))
        return tuple(
            Row(plan.agents[place].id, bundle.class_name, bundle) for place, bundle in single
        )
    if len(bundles) > MOST_PATHS:
        return ()
    return tuple(Row(_joined(plan, bundle), bundle.class_name, bundle) for bundle in bundles)


def height_of(plan: Plan) -> float:
    """Inches that the timeline of a plan takes."""
    rows = rows_of(plan)
    tall = _ROW * len(rows) + 0.1 if rows else _BAND * len(_class_names(plan))
    return max(tall, 0.8) + _REST


def keys_of(plan: Plan, mission: Mission | None) -> dict[str, Key]:
    """What each state of the plan is painted as.

    With a mission, states that look the same on the map have one key, named by the labels that all
    of them have.
    """
    if mission is None:
        given = paints(plan.states)
        return {state: Key(state, given[state].soft) for state in plan.states}
    painted = Palette.of(mission).states
    labels = {state: mission.system.states[state].labels for state in plan.states}
    shared: dict[Paint, frozenset[str]] = {}
    every: dict[Paint, frozenset[str]] = {}
    for state in plan.states:
        if labels[state]:
            paint = painted[state]
            shared[paint] = shared.get(paint, labels[state]) & labels[state]
            every[paint] = every.get(paint, labels[state]) | labels[state]
    named = {
        paint: Key(", ".join(sorted(shared[paint] or every[paint])), paint.soft) for paint in shared
    }
    nowhere = Key("no label", PLAIN)
    return {state: named[painted[state]] if labels[state] else nowhere for state in plan.states}


def _class_names(plan: Plan) -> list[str]:
    return list(dict.fromkeys(bundle.class_name for bundle in plan.bundles))


def _joined(plan: Plan, bundle: Bundle) -> str:
    words = names([plan.agents[place].id for place in bundle.agents], most=1)
    return words if len(bundle.agents) == 1 else f"{words} ({len(bundle.agents)})"


def _margin(words: Sequence[str]) -> float:
    """Inches that the names of the rows take."""
    return max(text_size(shortened(w, _LONGEST), SMALL)[0] for w in words) / POINTS + 0.2


def set_steps(ax: Any, horizon: int) -> None:
    """Steps 0..horizon across the axes, and no frame but the axis of the steps."""
    ax.set_xlim(-_HALF, horizon + _HALF)
    ax.xaxis.set_major_locator(library("ticker").MaxNLocator(nbins=14, integer=True))
    ax.tick_params(axis="x", labelsize=SMALL, length=2.5, width=0.6)
    ax.set_xlabel("step", fontsize=SMALL)
    for side in ("top", "right", "left"):
        ax.spines[side].set_visible(False)
    ax.spines["bottom"].set_linewidth(0.6)


def _set_rows(ax: Any, rows: Sequence[Row]) -> None:
    ax.set_ylim(len(rows) - _HALF, -_HALF)
    words = [plain(shortened(row.words, _LONGEST)) for row in rows]
    ax.set_yticks(range(len(rows)), words, fontsize=SMALL)
    ax.tick_params(axis="y", length=0)
    ends = [sum(1 for _ in group) for _, group in groupby(rows, key=lambda row: row.class_name)]
    for end in np.cumsum(ends)[:-1]:
        ax.axhline(end - _HALF, color=LINE, linewidth=0.5)


def _draw_rows(ax: Any, rows: Sequence[Row], keys: dict[str, Key], horizon: int) -> None:
    extent = ax.get_window_extent()
    points = POINTS / ax.figure.dpi
    across, tall = extent.width * points / (horizon + 1), extent.height * points / len(rows)
    size = min(SMALL, 0.75 * tall)
    for place, row in enumerate(rows):
        for first, last in ways(row.bundle, horizon):
            _bar(ax, place, (first, last), TRAVEL, "on the way")
        for first, last, state in row.bundle.stays:
            _bar(ax, place, (first, last), keys[state].paint, state)
            words = visible(state)
            if size >= SMALL * 0.7 and text_size(words, size)[0] + 3 < across * (last - first + 1):
                ax.text(
                    (first + last) / 2, place, plain(words), fontsize=size, ha="center",
                    va="center_baseline", color=keys[state].paint.ink,
                )  # fmt: skip


def _bar(ax: Any, place: int, steps: tuple[float, float], paint: Paint, meaning: str) -> None:
    ax.barh(
        place,
        steps[1] - steps[0] + 1,
        left=steps[0] - _HALF,
        height=_THICK,
        gid=visible(meaning),
        **area(paint),
    )


def ways(bundle: Bundle, horizon: int) -> Iterator[tuple[int, int]]:
    """The steps, first and last, at which a path is on the way."""
    for (_, left, _), (arrived, _, _) in pairwise(bundle.stays):
        if arrived > left + 1:
            yield left + 1, arrived - 1
    if bundle.stays[-1][1] < horizon:
        yield bundle.stays[-1][1] + 1, horizon


def _set_bands(ax: Any, plan: Plan) -> None:
    classes = _class_names(plan)
    ax.set_ylim(len(classes) - _HALF, -_HALF)
    counts = {
        name: sum(len(b.agents) for b in plan.bundles if b.class_name == name) for name in classes
    }
    words = [
        plain(f"{shortened(name, _LONGEST)}\n{count:,} agents") for name, count in counts.items()
    ]
    ax.set_yticks(range(len(classes)), words, fontsize=SMALL)
    ax.tick_params(axis="y", length=0)


def _draw_bands(ax: Any, plan: Plan, keys: dict[str, Key]) -> None:
    """One band for each class: its share at the states of each colour, the rest on the way."""
    edges = np.arange(plan.horizon + 2) - _HALF
    for place, name in enumerate(_class_names(plan)):
        group = [bundle for bundle in plan.bundles if bundle.class_name == name]
        everybody = sum(len(bundle.agents) for bundle in group)
        floor = np.zeros(plan.horizon + 1)
        for words, paint, counts in [*_shares(group, keys, plan.horizon), ("", TRAVEL, None)]:
            share = 1.0 - floor if counts is None else counts / everybody
            low, high = (place + _THICK * (_HALF - part) for part in (floor, floor + share))
            floor = floor + share
            if not share.any():
                continue
            style = area(paint) | {"linewidth": 0.3, "edgecolor": area(paint)["edgecolor"]}
            ax.fill_between(
                edges, np.append(low, low[-1]), np.append(high, high[-1]), step="post",
                gid=visible(f"{name}: {words or 'on the way'}"), **style,
            )  # fmt: skip


def _shares(
    group: Sequence[Bundle], keys: dict[str, Key], horizon: int
) -> Iterator[tuple[str, Paint, Ints]]:
    """How many agents of a class are at the states of each key, at every step."""
    states: dict[Key, list[str]] = {}
    for state, key in keys.items():
        states.setdefault(key, []).append(state)
    for key, members in states.items():
        yield key.words, key.paint, state_counts(of_bundles(group), members, horizon).sum(axis=0)


def _entries(plan: Plan, keys: dict[str, Key]) -> list[Entry]:
    """What the colours stand for, and the hatch of the ways."""
    patch = library("patches").Patch
    listed = sorted(dict.fromkeys(keys.values()), key=lambda key: key.paint == PLAIN)
    shown = [Entry(patch(**_framed(key.paint)), key.words) for key in listed[:_MOST_ENTRIES]]
    if len(listed) > _MOST_ENTRIES:
        shown.append(Entry(patch(alpha=0), f"and {len(listed) - _MOST_ENTRIES} more"))
    if any(True for bundle in plan.bundles for _ in ways(bundle, plan.horizon)):
        shown.append(Entry(patch(**_framed(TRAVEL)), "on the way"))
    return shown


def _framed(paint: Paint) -> dict[str, Any]:
    return area(paint) | ({} if paint.hatch else {"edgecolor": DARK, "linewidth": 0.3})
