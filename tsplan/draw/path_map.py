"""The paths of a plan over its map, side by side like the lines of an underground plan.

Every edge has a lane for each path and direction, on the right-hand side of the way, so that no
path hides another one. More paths than can be told apart become one strand for each class, as wide
as many agents use the edge.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import TYPE_CHECKING, Any

from tsplan.checking.fitting import refuse_misfit
from tsplan.draw.canvas import DARK, TINY, WHITE, Entry, Picture, set_title, text_size
from tsplan.draw.colours import lightness, mixed
from tsplan.draw.map import Scene, arrow_heads, base, finish
from tsplan.draw.matplotlib_loading import library
from tsplan.draw.palette import HUES, STROKES, Paint, Palette, paints
from tsplan.draw.starts import draw_starts
from tsplan.draw.state_labels import Sign
from tsplan.draw.text_placement import Box, Point
from tsplan.plans.summary import names
from tsplan.words import visible

if TYPE_CHECKING:
    from tsplan.mission import Mission
    from tsplan.plans.agent_plans import Bundle
    from tsplan.plans.plan import Plan

MOST_PATHS = len(HUES) * len(STROKES) - 8
"""Distinct paths that are drawn one by one; more cannot be told apart."""

_GAP = 2.6  # points from lane to lane
_BROADEST = 22.0  # points that all lanes of one direction may take
_CLEAR = 4.0  # points that lanes keep from the middle of a state without a name there
_MOST_MARKS = 60  # passages up to which every arrival is marked
_STEPS = 3  # steps that are written at one passage
_LIGHT = 72.0  # lightness from which a lane needs a border
_THIN = 0.6  # of a lane's width where states are close together
_HEAD = 4.5  # points of an arrow head, more on broad lanes
_TEXT = TINY + 0.8

Pair = tuple[str, str]


@dataclass
class Passage:
    """Uses of an edge by one strand: how many agents in all, and the steps at which they arrive."""

    agents: int = 0
    arrivals: list[int] = field(default_factory=list)
    resting: list[int] = field(default_factory=list)


@dataclass(frozen=True)
class Strand:
    """One line on the map: a path that agents share, or all paths of a class."""

    words: str
    paint: Paint
    agents: int
    passages: Mapping[Pair, Passage]


def draw_paths(plan: Plan, mission: Mission, ax: Any = None) -> Picture:
    """The paths on the mission's map, with the steps at which the agents arrive.

    Up to `MOST_PATHS` different paths have lines of their own, beyond that each class has one.
    Raises PlanError for a plan without paths or of another mission.
    """
    refuse_misfit(plan, mission)
    palette = Palette.of(mission)
    strands, joined = strands_of(plan, palette)
    scene = base(palette, ax, _entries(plan, strands, joined=joined))
    draw_starts(scene, mission, palette.classes if joined else {})
    lanes = lanes_of(strands)
    for number, strand in enumerate(strands):
        _draw_strand(scene, strand, [_shift(lanes[pair], number) for pair in strand.passages])
    if not joined and not scene.dense:
        _mark_arrivals(scene, strands, lanes)
    finish(scene, lanes)
    set_title(scene.ax, f"{plan.mission.name or mission.name}: paths")
    return scene.figure, scene.ax


def strands_of(plan: Plan, palette: Palette) -> tuple[tuple[Strand, ...], bool]:
    """The lines to draw, one for each path that leaves its start or, joined, for each class.

    The second value says whether they are joined.
    """
    moving = [bundle for bundle in plan.bundles if any(_moves(bundle))]
    if len(moving) <= MOST_PATHS:
        given = paints(str(number) for number in range(len(moving)))
        return tuple(
            Strand(
                names([plan.agents[place].id for place in bundle.agents], most=1),
                given[str(number)],
                len(bundle.agents),
                _passages([bundle]),
            )
            for number, bundle in enumerate(moving)
        ), False
    by_class: dict[str, list[Bundle]] = {}
    for bundle in moving:
        by_class.setdefault(bundle.class_name, []).append(bundle)
    return tuple(
        Strand(
            f"{sum(len(b.agents) for b in group):,} {name} on {len(group):,} paths",
            palette.classes[name],
            sum(len(b.agents) for b in group),
            _passages(group),
        )
        for name, group in by_class.items()
    ), True


def lanes_of(strands: Sequence[Strand]) -> Mapping[Pair, tuple[int, ...]]:
    """The numbers of the strands on each directed edge, from the middle of the way outwards."""
    lanes: dict[Pair, list[int]] = {}
    for number, strand in enumerate(strands):
        for pair in strand.passages:
            lanes.setdefault(pair, []).append(number)
    return {pair: tuple(numbers) for pair, numbers in lanes.items()}


def _moves(bundle: Bundle) -> Iterator[tuple[Pair, int | None, bool]]:
    """The moves of a path: the edge, the step of arrival, and whether it rests there."""
    for (_, _, source), (arrival, last, target) in pairwise(bundle.stays):
        if source != target:
            yield (source, target), arrival, last > arrival
    final = bundle.stays[-1][2]
    if bundle.heading is not None and bundle.heading != final:
        yield (final, bundle.heading), None, False


def _passages(group: Sequence[Bundle]) -> Mapping[Pair, Passage]:
    found: dict[Pair, Passage] = {}
    for bundle in group:
        for pair, arrival, rests in _moves(bundle):
            passage = found.setdefault(pair, Passage())
            passage.agents += len(bundle.agents)
            if arrival is not None:
                passage.arrivals.append(arrival)
                if rests or arrival == bundle.stays[-1][0]:
                    passage.resting.append(arrival)
    return found


def _shift(lane: tuple[int, ...], number: int) -> float:
    """Points from the middle of the way to a strand's lane."""
    gap = min(_GAP, _BROADEST / len(lane))
    return gap * (lane.index(number) + 0.7)


def _ends(scene: Scene, pair: Pair, shift: float) -> tuple[Point, Point]:
    """A lane's two ends on the page: beside the middle of the way, clear of both states' names."""
    (x0, y0), (x1, y1) = (scene.frame.at(scene.where[name]) for name in pair)
    length = math.hypot(x1 - x0, y1 - y0) or 1.0
    along = ((x1 - x0) / length, (y1 - y0) / length)
    right, up = along[1] * shift, -along[0] * shift
    most = 0.0 if scene.dense else 0.4 * length
    begin = min(_clearance(scene.signs[pair[0]], (x0, y0), along), most)
    end = min(_clearance(scene.signs[pair[1]], (x1, y1), (-along[0], -along[1])), most)
    return (
        (x0 + along[0] * begin + right, y0 + along[1] * begin + up),
        (x1 - along[0] * end + right, y1 - along[1] * end + up),
    )


def _clearance(sign: Sign, centre: Point, along: Point) -> float:
    """How far a lane keeps from the middle of a state: until it has left the state's sign."""
    box, (x, y), (right, up) = sign.box, centre, along
    if not sign.parts or not Box(x, y, x, y).inside(box):
        return _CLEAR
    across = ((box.right if right > 0 else box.left) - x) / right if right else math.inf
    upward = ((box.top if up > 0 else box.bottom) - y) / up if up else math.inf
    return min(across, upward) + 1.5


def _draw_strand(scene: Scene, strand: Strand, shifts: Sequence[float]) -> None:
    """All lanes of a strand, and their arrow heads."""
    lines = []
    for pair, shift in zip(strand.passages, shifts, strict=True):
        begin, end = _ends(scene, pair, shift)
        lines.append((scene.frame.back(begin), scene.frame.back(end)))
    thin = _THIN if scene.dense else 1.0
    widths = [thin * _width(passage.agents) for passage in strand.passages.values()]
    for colour, more, layer in _layers(strand.paint):
        lanes = library("collections").LineCollection(
            lines,
            colors=colour,
            linestyles=strand.paint.stroke,
            linewidths=[width + more for width in widths],
            zorder=layer,
            gid=visible(f"path:{strand.words}"),
        )
        scene.ax.add_collection(lanes, autolim=False)
    if not scene.dense:
        head = max(_HEAD, 2.0 * max(widths, default=0.0))
        arrow_heads(scene, lines, 0.93, (strand.paint.colour, head))


def _width(agents: int) -> float:
    """Points of a lane with so many agents."""
    return 1.2 + 0.8 * math.log10(agents)


def _layers(paint: Paint) -> list[tuple[str, float, float]]:
    """Colour, extra width and layer of what is drawn for a lane.

    Light colours have a thin grey border, or they would drown in pale shapes.
    """
    border = [("#808080", 0.6, 3.9)] if lightness(paint.colour) >= _LIGHT else []
    return [*border, (paint.colour, 0.0, 4.0)]


def _mark_arrivals(
    scene: Scene, strands: Sequence[Strand], lanes: Mapping[Pair, tuple[int, ...]]
) -> None:
    """The steps of arrival beside the lanes, where there is room."""
    every = sum(len(strand.passages) for strand in strands) <= _MOST_MARKS
    for strand in strands:
        light = lightness(strand.paint.colour) >= _LIGHT
        colour = mixed(strand.paint.colour, "#000000", 0.55 if light else 0.35)
        for pair, passage in strand.passages.items():
            steps = passage.arrivals if every else passage.resting
            if not steps:
                continue
            text = ",".join(str(step) for step in sorted(set(steps))[:_STEPS])
            text += "\u2026" if len(set(steps)) > _STEPS else ""
            spots = _beside(scene, pair, _shift(lanes[pair], lanes[pair][-1]), text)
            if found := scene.room.place(text, _TEXT, spots):
                scene.write(text, found, _TEXT, color=colour, zorder=5, gid="arrival")


def _beside(scene: Scene, pair: Pair, outermost: float, text: str) -> Iterator[Point]:
    """Places for a mark: outside all lanes of the way, nearest to the arrival first."""
    (x0, y0), (x1, y1) = (scene.frame.at(scene.where[name]) for name in pair)
    length = math.hypot(x1 - x0, y1 - y0) or 1.0
    width, height = text_size(text, _TEXT)
    # half of the text, seen across the way
    reach = (width * abs(y1 - y0) + height * abs(x1 - x0)) / length / 2
    for more in (1.0, 5.0):
        begin, end = _ends(scene, pair, outermost + reach + more)
        for share in (0.8, 0.65, 0.5, 0.35, 0.2):
            yield (begin[0] + (end[0] - begin[0]) * share, begin[1] + (end[1] - begin[1]) * share)


def _entries(plan: Plan, strands: Sequence[Strand], *, joined: bool) -> list[Entry]:
    """The legend: each strand, the agents that never move, and what the numbers are."""
    shown = [
        Entry(
            library("lines").Line2D(
                [], [], color=s.paint.colour, linestyle=s.paint.stroke,
                linewidth=_width(s.agents),
            ),
            s.words,
        )
        for s in strands
    ]  # fmt: skip
    badge = library("lines").Line2D(
        [], [], linestyle="none", marker="o", markersize=8, color=WHITE, markeredgecolor=DARK
    )
    shown.append(Entry(badge, "agents that start there"))
    idle = len(plan.agents) - sum(strand.agents for strand in strands)
    if idle:
        never = "never moves" if idle == 1 else "never move"
        shown.append(Entry(library("lines").Line2D([], [], linestyle="none"), f"{idle:,} {never}"))
    if strands:
        what = "the more agents, the wider" if joined else "numbers: steps of arrival"
        shown.append(Entry(library("lines").Line2D([], [], linestyle="none"), what))
    return shown
