"""How groups split and merge: states above each other, steps across, bands as wide as many agents.

All agents at one state and step form one stack; what leaves it by different edges are bands of
their own, and bands that arrive together are one stack again. Moves are paler than stays.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from operator import attrgetter
from typing import Any, NamedTuple, TypeAlias

import numpy as np

from tsplan.checking.fitting import refuse_misfit
from tsplan.draw import canvas
from tsplan.draw.canvas import DARK, LINE, SMALL, Entry, Picture
from tsplan.draw.focus import WHOLE, Focus
from tsplan.draw.matplotlib_loading import library
from tsplan.draw.palette import TRAVEL, TRAVEL_STRIPE, Paint, Palette, paints
from tsplan.draw.step_axes import (
    DWELL,
    Prepared,
    completed,
    finish_steps,
    name_rows,
    names_width,
    step_axes,
)
from tsplan.draw.tracks import MoveTuple, Track, by_class, tracks
from tsplan.mission import Mission
from tsplan.plans.plan import Plan
from tsplan.ts import TransitionSystem
from tsplan.words import visible

_WIDTH = 7.5  # inches of the steps
_LOWEST, _HIGHEST = 2.0, 8.5
FLOW_HEIGHT = 4.25
"""Inches that the rows have on a page."""

_ROW = 0.42  # inches of a state, if there is room
_AIR = 0.35  # of the mean thickness of a row, between two rows
_LONGEST = 24  # characters of a state's name
_BEND = 0.45  # share of a band's length over which it leaves its stack straight on
_STAY, _MOVE = 1.0, 0.55  # opacity
_MOST_ORDERED = 400  # states up to which the rows are ordered by the flow

Node: TypeAlias = tuple[str, int]
Flows: TypeAlias = Mapping[str, Iterable[MoveTuple]]

Duration: TypeAlias = Callable[[str, str, str], int]
"""The steps that a class takes from a state to another."""

REBUILT = "being rebuilt"
"""The class of modules while they are part of no structure."""

_SOURCE, _TARGET = attrgetter("source"), attrgetter("target")


@dataclass(frozen=True)
class Band:
    """Agents of one class on one edge: from the stack at `source` to that at `target`.

    `count` agents are `offset` agents above the foot of their stacks when they leave and arrive.
    """

    class_name: str
    source: Node
    target: Node
    count: int
    leaves: int = 0
    arrives: int = 0


class Flow(NamedTuple):
    """What a diagram shows: the moves by class, up to a step, and its title."""

    moves: Flows
    horizon: int
    title: str


def draw_swarm(plan: Plan, mission: Mission, ax: Any = None, focus: Focus = WHOLE) -> Picture:
    """The split and merge diagram of a plan, or of what happened where that is given.

    Structures of modules are bands as wide as they have modules, in the colour of their
    configuration; what is being rebuilt is striped. Raises PlanError for a plan without paths or of
    another mission.
    """
    return completed(prepare_swarm(plan, mission, ax, focus))


def prepare_swarm(plan: Plan, mission: Mission, ax: Any, focus: Focus) -> Prepared:
    """The same, with what is left to be drawn; the bands are those of the chosen classes."""
    refuse_misfit(plan, mission)
    shown = plan if focus.executed is None else focus.executed
    flows = flows_of(shown, mission, focus)
    name = plan.mission.name or mission.name
    what = "what happened, " if focus.executed is not None else ""
    unit = " (modules)" if shown.structures else ""
    flow = Flow(flows, focus.until(plan), f"{name}: {what}who splits and merges where{unit}")
    paints_of = {**Palette.of(mission).classes, REBUILT: TRAVEL}
    durations = durations_of(shown, mission.system)
    return _prepared(flow, durations, {name: paints_of[name] for name in flows}, (ax, focus.step))


def draw_flows(
    flows: Flows, system: TransitionSystem, horizon: int, ax: Any = None, name: str = ""
) -> Picture:
    """The diagram of flows by class: every edge entered at every step, waits included.

    Durations are those of the map for the class; the title has the map's name if none is given.
    """
    flow = Flow(flows, horizon, f"{name or system.name}: who splits and merges where")
    return completed(_prepared(flow, map_durations(system), paints(flows), (ax, None)))


def _prepared(
    flow: Flow,
    duration: Duration,
    given: Mapping[str, Paint],
    on: tuple[Any, float | None],
) -> Prepared:
    """The axes of a diagram, on given ones, and what draws its bands; perhaps with a moment."""
    bands = bands_of(flow.moves, duration)
    order = row_order(bands)
    sizes = _sizes(bands)
    feet, middles, whole = _rows(sizes, order)
    tall = min(max(_ROW * len(order), _LOWEST), _HIGHEST)
    inches = _WIDTH + names_width(order, _LONGEST), tall
    figure, ax = step_axes(on[0], flow.horizon, inches, _entries(given) if len(given) > 1 else [])
    ax.set_ylim(whole, 0)
    words = [canvas.shortened(state, _LONGEST) for state in order]
    if not name_rows(ax, middles, words, flow.title):
        ax.set_ylabel(f"{len(order):,} states", fontsize=SMALL)

    def fill() -> None:
        for class_name, paint in given.items():
            some = [band for band in bands if band.class_name == class_name]
            _draw_bands(ax, some, feet, (paint, flow.horizon))
        _write_counts(ax, (sizes, _changed(bands, sizes)), feet, flow.horizon)
        finish_steps(ax, on[1])

    return (figure, ax), fill


def flows_of(
    plan: Plan, mission: Mission | None = None, focus: Focus = WHOLE
) -> dict[str, tuple[MoveTuple, ...]]:
    """The flows of a plan by class: the moves of swarms, and those of all other agents' stays.

    Of structures, whose classes are configurations, it is their modules that are counted; those
    that are being rebuilt are a class of their own. With a mission the classes come in the order in
    which pictures list them.
    """
    flows: dict[str, tuple[MoveTuple, ...]] = {}
    walked = (track for track in focus.chosen(tracks(plan, mission), plan) if track.ids)
    for name, group in by_class(walked).items():
        counts: Counter[tuple[int, str, str]] = Counter()
        for track in group:
            for use in _uses(track):
                counts[use] += track.width
        inside = sorted(use for use in counts if use[0] < plan.horizon)
        flows[name] = tuple((*use, counts[use]) for use in inside)
    if not focus.agents:
        flows |= dict[str, tuple[MoveTuple, ...]](plan.moves)
    else:
        flows |= {name: plan.moves[name] for name in focus.agents if name in plan.moves}
    if plan.structures and not focus.agents:
        flows[REBUILT] = tuple(_rebuilding(plan))
    if mission is not None:
        order = (*Palette.of(mission).classes, REBUILT)
        flows = {name: flows[name] for name in order if flows.get(name)}
    return flows


def _rebuilding(plan: Plan) -> Iterator[MoveTuple]:
    """The waits of modules while they are part of no structure."""
    structures = {each.id: each for each in plan.structures}
    for change in plan.rebuilt:
        begins = [structures[name].first for name in change.made if name in structures]
        modules = sum(len(structures[name].modules) for name in change.parts)
        for step in range(change.step, min(begins, default=plan.horizon)):
            yield step, change.state, change.state, modules


def map_durations(system: TransitionSystem) -> Duration:
    """How long a class takes along an edge, by the map."""

    def duration(name: str, source: str, target: str) -> int:
        edge = system.edges.get((source, target))
        return (edge.duration_for(name) if edge else None) or 1

    return duration


def durations_of(plan: Plan, system: TransitionSystem) -> Duration:
    """How long a class takes along an edge: as structures are seen to, else by the map."""
    by_map = map_durations(system)
    seen = {
        (track.class_name, here.state, there.state): there.first - here.last
        for track in (tracks(plan) if plan.structures else ())
        for here, there in pairwise(track.stops)
        if there.first <= plan.horizon
    }

    def duration(name: str, source: str, target: str) -> int:
        return seen.get((name, source, target)) or by_map(name, source, target)

    return duration


def _uses(track: Track) -> Iterator[tuple[int, str, str]]:
    """Each edge that a track enters: its step and its ends."""
    for first, last, state, _ in track.stops:
        yield from ((step, state, state) for step in range(first, last))
    for here, there in pairwise(track.stops):
        yield here.last, here.state, there.state


def bands_of(flows: Flows, duration: Duration) -> tuple[Band, ...]:
    """The bands with their places in the stacks: ordered by where they go to and come from.

    Bands of one class lie together, so that a class is one piece of every stack.
    """
    bare = []
    for name, moves in flows.items():
        for step, source, target, count in moves:
            arrival = step + duration(name, source, target)
            bare.append(Band(name, (source, step), (target, arrival), count))
    rank = {state: number for number, state in enumerate(row_order(bare))}
    classes = {name: number for number, name in enumerate(flows)}
    leaves, arrives = [0] * len(bare), [0] * len(bare)
    for offsets, near, far in ((leaves, _SOURCE, _TARGET), (arrives, _TARGET, _SOURCE)):
        filled: Counter[Node] = Counter()
        keys = [(classes[b.class_name], rank[far(b)[0]], far(b)[1]) for b in bare]
        for number in sorted(range(len(bare)), key=keys.__getitem__):
            offsets[number] = filled[near(bare[number])]
            filled[near(bare[number])] += bare[number].count
    return tuple(replace(b, leaves=leaves[n], arrives=arrives[n]) for n, b in enumerate(bare))


def row_order(bands: Sequence[Band]) -> tuple[str, ...]:
    """The states in an order that keeps those with much traffic between them together.

    It is the order of the second eigenvector of the traffic's Laplacian (Fiedler's vector), which
    is short on average over all moves; the first state visited comes above the last one.
    """
    seen = dict.fromkeys(state for b in bands for state in (b.source[0], b.target[0]))
    place = {state: number for number, state in enumerate(seen)}
    if not 2 < len(place) <= _MOST_ORDERED:  # noqa: PLR2004  (two are in order anyhow)
        return tuple(seen)
    weight = np.zeros((len(place), len(place)))
    for band in bands:
        one, other = place[band.source[0]], place[band.target[0]]
        if one != other:
            weight[one, other] += band.count
            weight[other, one] += band.count
    weight += 1e-6  # keeps separate parts apart and in order
    laplacian = np.diag(weight.sum(axis=0)) - weight
    vector = np.linalg.eigh(laplacian)[1][:, 1]
    keys = np.round(vector * (-1.0 if vector[0] > vector[-1] else 1.0), 9)
    return tuple(sorted(place, key=lambda state: (keys[place[state]], place[state])))


def _sizes(bands: Iterable[Band]) -> dict[Node, int]:
    """Agents in each stack: what leaves it, or at the end what arrived."""
    leaving: Counter[Node] = Counter()
    arriving: Counter[Node] = Counter()
    for band in bands:
        leaving[band.source] += band.count
        arriving[band.target] += band.count
    return {node: leaving[node] or arriving[node] for node in {**leaving, **arriving}}


def _rows(
    sizes: Mapping[Node, int], order: Sequence[str]
) -> tuple[dict[str, float], list[float], float]:
    """The foot of each row in agents from above, the middle of its stacks, the height of all."""
    most = dict.fromkeys(order, 0)
    for (state, _), size in sizes.items():
        most[state] = max(most[state], size)
    mean = sum(most.values()) / len(most)
    feet, y = {}, 0.0
    for state in order:
        feet[state] = y + _AIR * mean / 2
        y += max(most[state], 0.4 * mean) + _AIR * mean
    return feet, [feet[state] + most[state] / 2 for state in order], y


def _draw_bands(
    ax: Any, bands: Sequence[Band], feet: Mapping[str, float], look_of: tuple[Paint, int]
) -> None:
    """All bands of a class in its paint, up to the horizon."""
    paint, horizon = look_of
    for waits, opacity in ((True, _STAY), (False, _MOVE)):
        some = [b for b in bands if (b.source[0] == b.target[0]) == waits]
        look: dict[str, Any] = {"facecolors": paint.colour, "hatch": paint.hatch or None}
        # a line around closes the seams, and steep bands never vanish
        edge = TRAVEL_STRIPE if paint == TRAVEL else paint.colour
        look |= {"edgecolors": edge, "linewidths": 0.4, "alpha": opacity}
        kind = f"{'stays' if waits else 'moves'}:{bands[0].class_name if bands else ''}"
        look |= {"zorder": 3 if waits else 2, "gid": visible(kind)}
        canvas.add_collection(
            ax, "PathCollection", [_ribbon(b, feet, horizon) for b in some], **look
        )


def _ribbon(band: Band, feet: Mapping[str, float], horizon: int) -> Any:
    """The outline of a band: two curves that leave and arrive horizontally.

    Between `DWELL` after the step at which it leaves and as long before the one at which it arrives
    it is on the way; at the ends of time stacks are as long as at other steps.
    """
    (here, step), (there, arrival) = band.source, band.target
    begin = step or -DWELL
    end = arrival if arrival != horizon else horizon + DWELL
    x0, x1 = step + DWELL, arrival - DWELL
    y0, y1 = feet[here] + band.leaves, feet[there] + band.arrives
    a, b = x0 + _BEND * (x1 - x0), x1 - _BEND * (x1 - x0)
    low, high = y0 + band.count, y1 + band.count
    points = [(begin, y0), (x0, y0), (a, y0), (b, y1), (x1, y1), (end, y1)]
    back = [(end, high), (x1, high), (b, high), (a, low), (x0, low), (begin, low)]
    path = library("path").Path
    line, curve = path.LINETO, [path.CURVE4] * 3
    codes = [path.MOVETO, line, *curve, line, line, line, *curve, line, path.CLOSEPOLY]
    return path([*points, *back, (begin, y0)], codes)


def _write_counts(
    ax: Any, stacks: tuple[Mapping[Node, int], set[Node]], feet: Mapping[str, float], horizon: int
) -> None:
    """The size of a stack where it has changed, if the number fits into it.

    A stack of one step alone has one only if its agents have just split or met. `stacks` are all
    stacks by their sizes, and those that have just changed.
    """
    sizes, new = stacks
    width, height = canvas.extent(ax)
    across, upward = width / (horizon + 1), height / abs(np.diff(ax.get_ylim())[0])
    free: dict[str, float] = {}  # from where on a row has no number yet
    for (state, step), size in sorted(sizes.items(), key=lambda item: item[0][1]):
        if sizes.get((state, step - 1)) == size or size * upward < SMALL or step > horizon:
            continue
        text = f"{size:,}"
        wide = canvas.text_size(text, SMALL)[0] / across
        until = step
        while sizes.get((state, until + 1)) == size:
            until += 1
        begin = max(step - DWELL, free.get(state, -1.0)) + 2 / across
        if begin + wide > min(until, horizon) + DWELL:
            begin = min(max(step - wide / 2, -DWELL), horizon + DWELL - wide)
            if (state, step) not in new or begin < free.get(state, -1.0) + 2 / across:
                continue
        free[state] = begin + wide
        look = {"fontsize": SMALL, "va": "center", "color": DARK, "zorder": 5}
        ax.text(begin, feet[state] + size / 2, text, bbox=canvas.halo(), gid="size", **look)


def _changed(bands: Sequence[Band], sizes: Mapping[Node, int]) -> set[Node]:
    """The stacks that are not just another stack moved on as a whole."""
    whole = {
        band.target for band in bands if band.count == sizes[band.source] == sizes[band.target]
    }
    return set(sizes) - whole


def _entries(given: Mapping[str, Paint]) -> list[Entry]:
    style = {"edgecolor": LINE, "linewidth": 0}
    return [
        Entry.patch(name, facecolor=paint.colour, hatch=paint.hatch or None, **style)
        for name, paint in given.items()
    ]
