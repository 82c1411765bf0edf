"""How groups split and merge: states above each other, steps across, bands as wide as many agents.

All agents at one state and step form one stack; what leaves it by different edges are bands of
their own, and bands that arrive together are one stack again. Moves are paler than stays.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

from tsplan.checking.fitting import refuse_misfit
from tsplan.draw.canvas import (
    DARK,
    LINE,
    POINTS,
    SMALL,
    TINY,
    WHITE,
    Entry,
    Picture,
    axes,
    halo,
    legend_beside,
    legend_width,
    plain,
    set_title,
    settle,
    shortened,
    text_size,
)
from tsplan.draw.matplotlib_loading import library
from tsplan.draw.palette import Paint, paints
from tsplan.draw.timeline import set_steps
from tsplan.words import visible

if TYPE_CHECKING:
    from tsplan.mission import Mission
    from tsplan.plans.agent_plans import Bundle
    from tsplan.plans.plan import Plan
    from tsplan.ts import TransitionSystem

Flow: TypeAlias = tuple[int, str, str, int]
"""`(step, source, target, count)`: so many agents enter the edge at the step, waits included."""

_WIDTH = 7.5  # inches of the steps
_LOWEST, _HIGHEST = 2.0, 8.5
FLOW_HEIGHT = 5.0  # inches that the diagram has on a page
_ROW = 0.42  # inches of a state, if there is room
_AIR = 0.35  # of the mean thickness of a row, between two rows
_LONGEST = 24  # characters of a state's name
_BEND = 0.45  # share of a band's length over which it leaves its stack straight on
_STAY, _MOVE = 1.0, 0.55  # opacity
_MOST_ORDERED = 400  # states up to which the rows are ordered by the flow

Node: TypeAlias = tuple[str, int]
Slot: TypeAlias = tuple[float, float]


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


def draw_swarm(plan: Plan, mission: Mission, ax: Any = None) -> Picture:
    """The split and merge diagram of a plan.

    Raises PlanError for a plan without paths or of another mission.
    """
    refuse_misfit(plan, mission)
    figure, ax = draw_flows(flows_of(plan), mission.system, plan.horizon, ax)
    set_title(ax, f"{plan.mission.name or mission.name}: who splits and merges where")
    return figure, ax


def draw_flows(
    flows: Mapping[str, Iterable[Flow]], system: TransitionSystem, horizon: int, ax: Any = None
) -> Picture:
    """The diagram of flows by class: every edge entered at every step, waits included.

    Durations are those of the map for the class.
    """
    bands = bands_of(flows, system)
    order = row_order(bands)
    feet, scale_height = _rows(bands, order)
    given = paints(flows)
    entries = _entries(given) if len(given) > 1 else []
    tall = min(max(_ROW * len(order), _LOWEST), _HIGHEST)
    left = max(text_size(shortened(s, _LONGEST), SMALL)[0] for s in order) / POINTS + 0.2
    figure, ax = axes(ax, _WIDTH + left + legend_width(entries, tall), tall + 0.75)
    set_steps(ax, horizon)
    ax.set_xlim(0, horizon or 1)
    ax.set_ylim(scale_height, 0)
    legend_beside(ax, entries)
    set_title(ax, f"{system.name}: who splits and merges where")
    _name_rows(ax, order, feet, bands)
    settle(figure)
    for name, paint in given.items():
        _draw_bands(ax, [b for b in bands if b.class_name == name], feet, paint, horizon)
    _write_counts(ax, bands, feet, horizon)
    return figure, ax


def flows_of(plan: Plan) -> dict[str, tuple[Flow, ...]]:
    """The flows of a plan by class: its moves, or else those of the agents' stays."""
    if plan.moves:
        return {
            name: tuple((*move[:3], move.count) for move in plan.moves[name]) for name in plan.moves
        }
    counted: dict[str, Counter[tuple[int, str, str]]] = {}
    for bundle in plan.bundles:
        counter = counted.setdefault(bundle.class_name, Counter())
        for step, source, target in _uses(bundle):
            if step < plan.horizon:
                counter[step, source, target] += len(bundle.agents)
    return {
        name: tuple((*use, count) for use, count in sorted(counter.items()))
        for name, counter in counted.items()
    }


def _uses(bundle: Bundle) -> Iterator[tuple[int, str, str]]:
    """Each edge that a path enters: its step and its ends."""
    for first, last, state in bundle.stays:
        yield from ((step, state, state) for step in range(first, last))
    for (_, left, source), (_, _, target) in pairwise(bundle.stays):
        yield left, source, target
    if bundle.heading is not None:
        yield bundle.stays[-1][1], bundle.stays[-1][2], bundle.heading


def bands_of(flows: Mapping[str, Iterable[Flow]], system: TransitionSystem) -> tuple[Band, ...]:
    """The bands with their places in the stacks: ordered by where they go to and come from.

    Bands of one class lie together, so that a class is one piece of every stack.
    """
    bare = [
        Band(
            name, (source, step), (target, step + _duration(system, name, (source, target))), count
        )
        for name, moves in flows.items()
        for step, source, target, count in moves
    ]
    rank = {state: number for number, state in enumerate(row_order(bare))}
    classes = {name: number for number, name in enumerate(flows)}

    def stacked(near: str, far: str) -> dict[int, int]:
        """For each band, how many agents lie before it in its stack at its `near` end."""
        filled: Counter[Node] = Counter()
        offsets = {}
        ranked = sorted(
            range(len(bare)),
            key=lambda n: (
                classes[bare[n].class_name],
                rank[getattr(bare[n], far)[0]],
                getattr(bare[n], far)[1],
            ),
        )
        for number in ranked:
            node = getattr(bare[number], near)
            offsets[number] = filled[node]
            filled[node] += bare[number].count
        return offsets

    leaves, arrives = stacked("source", "target"), stacked("target", "source")
    return tuple(
        Band(b.class_name, b.source, b.target, b.count, leaves[n], arrives[n])
        for n, b in enumerate(bare)
    )


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


def _duration(system: TransitionSystem, name: str, ends: tuple[str, str]) -> int:
    edge = system.edges.get(ends)
    return (edge.duration_for(name) if edge else None) or 1


def _sizes(bands: Iterable[Band]) -> dict[Node, int]:
    """Agents in each stack: what leaves it, or at the end what arrived."""
    leaving: Counter[Node] = Counter()
    arriving: Counter[Node] = Counter()
    for band in bands:
        leaving[band.source] += band.count
        arriving[band.target] += band.count
    return {node: leaving[node] or arriving[node] for node in {**leaving, **arriving}}


def _rows(bands: Sequence[Band], order: Sequence[str]) -> tuple[dict[str, float], float]:
    """The foot of each row in agents from above, and the height of all rows."""
    most = dict.fromkeys(order, 0)
    for (state, _), size in _sizes(bands).items():
        most[state] = max(most[state], size)
    mean = sum(most.values()) / len(most)
    feet, y = {}, 0.0
    for state in order:
        feet[state] = y + _AIR * mean / 2
        y += max(most[state], 0.4 * mean) + _AIR * mean
    return feet, y


def _name_rows(
    ax: Any, order: Sequence[str], feet: Mapping[str, float], bands: Sequence[Band]
) -> None:
    """The names of the states at the middle of their largest stack, if there is room for all."""
    most: dict[str, int] = {}
    for (state, _), size in _sizes(bands).items():
        most[state] = max(most.get(state, 0), size)
    tall = ax.get_window_extent().height / ax.figure.dpi * POINTS / len(order)
    if tall < TINY * 1.15:
        ax.set_yticks([])
        ax.set_ylabel(f"{len(order):,} states", fontsize=SMALL)
        return
    middles = [feet[state] + most[state] / 2 for state in order]
    words = [plain(shortened(state, _LONGEST)) for state in order]
    ax.set_yticks(middles, words, fontsize=min(SMALL, tall / 1.15))
    ax.tick_params(axis="y", length=0)


def _draw_bands(
    ax: Any, bands: Sequence[Band], feet: Mapping[str, float], paint: Paint, horizon: int
) -> None:

    for waits, opacity in ((True, _STAY), (False, _MOVE)):
        some = [b for b in bands if (b.source[0] == b.target[0]) == waits]
        shapes = library("collections").PathCollection(
            [_ribbon(band, feet) for band in some],
            facecolors=paint.colour,
            edgecolors=paint.colour,
            linewidths=0.4,  # closes the seams, and steep bands never vanish
            hatch=paint.hatch or None,
            alpha=opacity,
            gid=visible(f"{'stays' if waits else 'moves'}:{bands[0].class_name if bands else ''}"),
        )
        shapes.set_zorder(3 if waits else 2)
        ax.add_collection(shapes, autolim=False)


def _ribbon(band: Band, feet: Mapping[str, float]) -> Any:
    """The outline of a band: two curves that leave and arrive horizontally."""
    x0, x1 = band.source[1], band.target[1]
    y0, y1 = feet[band.source[0]] + band.leaves, feet[band.target[0]] + band.arrives
    a, b = x0 + _BEND * (x1 - x0), x1 - _BEND * (x1 - x0)
    low, high = y0 + band.count, y1 + band.count
    points = [(x0, y0), (a, y0), (b, y1), (x1, y1), (x1, high), (b, high), (a, low), (x0, low)]
    path = library("path").Path
    curve, line = path.CURVE4, path.LINETO
    return path(
        [*points, (x0, y0)],
        [path.MOVETO, curve, curve, curve, line, curve, curve, curve, path.CLOSEPOLY],
    )


def _write_counts(ax: Any, bands: Sequence[Band], feet: Mapping[str, float], horizon: int) -> None:
    """The size of a stack where it has changed, if the number fits into it.

    A stack of one step alone has one only if its agents have just split or met.
    """
    extent = ax.get_window_extent()
    points = POINTS / ax.figure.dpi
    across = extent.width * points / (horizon or 1)
    upward = extent.height * points / abs(np.diff(ax.get_ylim())[0])
    sizes = _sizes(bands)
    new = _changed(bands, sizes)
    room: dict[str, float] = {}
    for (state, step), size in sorted(sizes.items(), key=lambda item: item[0][1]):
        if sizes.get((state, step - 1)) == size or size * upward < SMALL or step > horizon:
            continue
        text = f"{size:,}"
        width = text_size(text, SMALL)[0] / across
        until = step
        while sizes.get((state, until + 1)) == size:
            until += 1
        begin = max(step, room.get(state, -1.0)) + 2 / across
        if begin + width > min(until, horizon):
            begin = min(max(step - width / 2, 2 / across), horizon - width - 2 / across)
            if (state, step) not in new or begin < room.get(state, -1.0) + 2 / across:
                continue
        room[state] = begin + width
        ax.text(
            begin, feet[state] + size / 2, text, fontsize=SMALL, va="center", color=DARK, zorder=5,
            bbox=halo(WHITE), gid="size",
        )  # fmt: skip


def _changed(bands: Sequence[Band], sizes: Mapping[Node, int]) -> set[Node]:
    """The stacks that are not just another stack moved on as a whole."""
    whole = {
        band.target for band in bands if band.count == sizes[band.source] == sizes[band.target]
    }
    return set(sizes) - whole


def _entries(given: Mapping[str, Paint]) -> list[Entry]:

    patch = library("patches").Patch
    return [
        Entry(patch(facecolor=p.colour, hatch=p.hatch or None, edgecolor=LINE, linewidth=0), name)
        for name, p in given.items()
    ]
