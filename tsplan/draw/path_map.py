"""The paths of a plan over its map, side by side like the lines of an underground plan.

Every edge has a lane for each path and direction, on the right-hand side of the way, so that no
path hides another one. More paths than can be told apart become one strand for each class, as wide
as many agents use the edge. What agents carry along an edge stands beside its lanes.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from tsplan.checking.fitting import refuse_misfit
from tsplan.draw import canvas
from tsplan.draw.canvas import DARK, TINY, WHITE, Entry, Picture
from tsplan.draw.colours import lightness, mixed
from tsplan.draw.focus import WHOLE, Focus
from tsplan.draw.map import DrawnMap, arrow_heads, base, finish
from tsplan.draw.moment_map import draw_moment, moment_of
from tsplan.draw.palette import Paint, Palette, pale
from tsplan.draw.starts import draw_starts
from tsplan.draw.state_labels import StateLabel
from tsplan.draw.strands import Drawing, Pair, Passage, Strand, drawing_of, lanes_of
from tsplan.draw.text_placement import Box, direction
from tsplan.draw.tracks import Track
from tsplan.explanation.why.stock_lines import stock_lines
from tsplan.mission import Mission
from tsplan.plans.cargo_rows import loads_of
from tsplan.plans.plan import Plan
from tsplan.plans.supplies import load_words, together
from tsplan.words import visible

_GAP = 2.6  # points from lane to lane
_BROADEST = 22.0  # points that all lanes of one direction may take
_CLEAR = 4.0  # points that lanes keep from the middle of a state without a name there
_MOST_MARKS = 60  # passages up to which every arrival is marked
_STEPS = 3  # steps that are written at one passage
_LIGHT = 72.0  # lightness from which a lane needs a border
_THIN = 0.6  # of a lane's width where states are close together
_HEAD = 4.5  # points of an arrow head, more on broad lanes
_TEXT = TINY + 0.8

_APART = (1.0, 5.0)  # points from the lanes to a mark
_FURTHER = (*_APART, 8.5, 16.0)  # and to a load, which may stand below the marks
_LONGEST = 32  # characters of a line of what is carried
_FAINT = 0.3  # opacity of lines that badges stand on
_MOST_LOADS = 3  # that are written at one passage


def draw_paths(plan: Plan, mission: Mission, ax: Any = None, focus: Focus = WHOLE) -> Picture:
    """The paths on the mission's map, with the steps at which the agents arrive.

    Up to `MOST_PATHS` different paths have lines of their own, beyond that each class has one. At a
    step that is looked at, badges say who is where, and the lines are faint. Beside what happened
    the lines of what was planned are pale and dashed. Raises PlanError for a plan without paths or
    of another mission.
    """
    refuse_misfit(plan, mission)
    palette = Palette.of(mission)
    drawing = drawing_of(plan, mission, palette, focus)
    strands, joined = drawing.strands, drawing.joined
    drawn = base(palette, ax, _entries(drawing, focus), drawing.plan.replanned)
    now = focus.step is not None
    if now:
        _draw_now(drawn, mission, drawing, focus)
    else:
        draw_starts(drawn, mission, palette.classes if joined else {})
    lanes = lanes_of(strands)
    for number, strand in enumerate(strands):
        shifts = [_shift(lanes[pair], number) for pair in strand.passages]
        _draw_strand(drawn, strand, shifts, faint=now)
    if not (joined or drawn.dense or now):
        _mark_arrivals(drawn, strands, lanes)
    if not drawn.dense and not now and _few_loads(strands):
        _mark_loads(drawn, strands, lanes, joined=joined)
    moment = f", step {focus.step:g}" if focus.step is not None else ""
    return finish(drawn, f"{plan.mission.name or mission.name}: paths{moment}", lanes)


def _draw_now(drawn: DrawnMap, mission: Mission, drawing: Drawing, focus: Focus) -> None:
    """Badges at the step that is looked at, in the colours of the lines."""
    classes = drawn.palette.classes if drawing.joined else {}
    own = {
        name: strand.paint
        for strand in drawing.strands
        if not strand.planned
        for name in strand.names
    }

    def paint_of(track: Track) -> Paint:
        return classes.get(track.class_name) or own.get(track.name, Paint(WHITE))

    step, loads = focus.step or 0.0, loads_of(drawing.plan.cargo)
    stocks = stock_lines(drawing.plan, mission)
    draw_moment(drawn, moment_of(drawing.tracks, step, paint_of, loads), stocks, step)


def _shift(lane: tuple[int, ...], number: int) -> float:
    """Points from the middle of the way to a strand's lane."""
    gap = min(_GAP, _BROADEST / len(lane))
    return gap * (lane.index(number) + 0.7)


def _ends(drawn: DrawnMap, pair: Pair, shift: float) -> tuple[complex, complex]:
    """A lane's two ends on the page: beside the middle of the way, clear of both states' names."""
    start, goal = map(drawn.frame.at, drawn.line(*pair))
    along, side = direction(goal - start), -1j * shift * direction(goal - start)
    most = 0.0 if drawn.dense else 0.4 * abs(goal - start)
    begin = min(_clearance(drawn.labels[pair[0]], start, along), most)
    end = min(_clearance(drawn.labels[pair[1]], goal, -along), most)
    return start + along * begin + side, goal - along * end + side


def _clearance(label: StateLabel, centre: complex, along: complex) -> float:
    """How far a lane keeps from the middle of a state: until it has left the state's label."""
    box, x, y, right, up = label.box, centre.real, centre.imag, along.real, along.imag
    if not label.parts or not Box(x, y, x, y).inside(box):
        return _CLEAR
    across = ((box.right if right > 0 else box.left) - x) / right if right else math.inf
    upward = ((box.top if up > 0 else box.bottom) - y) / up if up else math.inf
    return min(across, upward) + 1.5


def _draw_strand(
    drawn: DrawnMap, strand: Strand, shifts: Sequence[float], *, faint: bool = False
) -> None:
    """All lanes of a strand, and their arrow heads."""
    ends = (_ends(drawn, *lane) for lane in zip(strand.passages, shifts, strict=True))
    lines = [(drawn.frame.back(begin), drawn.frame.back(end)) for begin, end in ends]
    thin = _THIN if drawn.dense else 1.0
    widths = [thin * _width(passage.agents) for passage in strand.passages.values()]
    style: dict[str, Any] = {
        "linestyles": strand.stroke,
        "gid": visible(f"{'planned' if strand.planned else 'path'}:{strand.words}"),
        "alpha": _FAINT if faint else None,
    }
    layers = [(strand.colour, 0.0, 4.0)]
    if (
        lightness(strand.colour) >= _LIGHT and not strand.planned
    ):  # a thin grey border, or it drowns in pale shapes
        layers.insert(0, ("#808080", 0.6, 3.9))
    for colour, more, layer in layers:
        style |= {"colors": colour, "linewidths": [width + more for width in widths]}
        canvas.add_collection(drawn.ax, "LineCollection", lines, zorder=layer, **style)
    if not drawn.dense and not faint:
        head = max(_HEAD, 2.0 * max(widths, default=0.0))
        arrow_heads(drawn, lines, 0.93, (strand.colour, head))


def _width(agents: int) -> float:
    """Points of a lane with so many agents."""
    return 1.2 + 0.8 * math.log10(agents)


def _mark_arrivals(
    drawn: DrawnMap, strands: Sequence[Strand], lanes: Mapping[Pair, tuple[int, ...]]
) -> None:
    """The steps of arrival beside the lanes, where there is room."""
    real = [strand for strand in strands if not strand.planned]
    every = sum(len(strand.passages) for strand in real) <= _MOST_MARKS
    for strand in real:
        colour = _ink(strand)
        for pair, passage in strand.passages.items():
            steps = sorted({step for step, rests in passage.arrivals if rests or every})
            if not steps:
                continue
            text = ",".join(map(str, steps[:_STEPS])) + ("\u2026" if len(steps) > _STEPS else "")
            centres = _beside(drawn, pair, _shift(lanes[pair], lanes[pair][-1]), text)
            drawn.write_free(text, centres, _TEXT, color=colour, zorder=5, gid="arrival")


def _ink(strand: Strand) -> str:
    """The colour of what is written beside a strand: its own, dark enough to be read."""
    light = lightness(strand.paint.colour) >= _LIGHT
    return mixed(strand.paint.colour, "#000000", 0.55 if light else 0.35)


def _few_loads(strands: Sequence[Strand]) -> bool:
    """Whether something is carried, along so few ways that all of them can say so."""
    real = [strand for strand in strands if not strand.planned]
    return 0 < sum(bool(p.loads) for s in real for p in s.passages.values()) <= _MOST_MARKS


def _mark_loads(
    drawn: DrawnMap,
    strands: Sequence[Strand],
    lanes: Mapping[Pair, tuple[int, ...]],
    *,
    joined: bool,
) -> None:
    """What is carried along each way, beside its lanes where there is room, in one line or more."""
    for strand in (strand for strand in strands if not strand.planned):
        style: dict[str, Any] = {
            "color": _ink(strand),
            "zorder": 5,
            "gid": "load",
            "bbox": canvas.halo(),
        }
        for pair, passage in strand.passages.items():
            outermost = _shift(lanes[pair], lanes[pair][-1])
            for text in load_texts(passage, joined=joined):
                centres = _beside(drawn, pair, outermost, text, _FURTHER)
                if drawn.write_free(text, centres, _TEXT, **style):
                    break


def load_texts(passage: Passage, *, joined: bool = False) -> tuple[str, ...]:
    r"""What is carried along a way, in one line and in more.

    Where it is not always the same the steps of arrival are said; of paths that are `joined`, how
    much it is in all.

    >>> load_texts(Passage(1, [(4, True)], {4: {"brick": 2.0, "drill": 1.0}}))
    ('2 brick, 1 drill', '2 brick\n1 drill')
    >>> two = Passage(1, [(4, True), (8, True)], {4: {"brick": 1.0}, 8: {"brick": 2.0}})
    >>> load_texts(two), load_texts(two, joined=True)
    (('4: 1 brick\n8: 2 brick',), ('3 brick',))
    """
    loads = sorted(passage.loads.items())
    same = {step for step, _ in passage.arrivals} <= set(passage.loads)
    if same and len({load_words(load) for _, load in loads}) == 1:
        load = loads[0][1]
    elif joined and loads:
        load = together(load for _, load in loads)
    else:
        said = [f"{step}: {load_words(load)}" for step, load in loads[:_MOST_LOADS]]
        said += ["\u2026"] if len(loads) > _MOST_LOADS else []
        return ("\n".join(canvas.shortened(line, _LONGEST) for line in said),) if said else ()
    lines = [canvas.shortened(load_words({name: load[name]}), _LONGEST) for name in load]
    whole = load_words(load)
    return tuple(dict.fromkeys(([whole] if len(whole) <= _LONGEST else []) + ["\n".join(lines)]))


def _beside(
    drawn: DrawnMap, pair: Pair, outermost: float, text: str, apart: Sequence[float] = _APART
) -> Iterator[complex]:
    """Places for a mark: outside all lanes of the way, nearest to the arrival first."""
    start, goal = map(drawn.frame.at, drawn.line(*pair))
    along = direction(goal - start)
    width, height = canvas.text_size(text, _TEXT)
    # half of the text, seen across the way
    reach = (width * abs(along.imag) + height * abs(along.real)) / 2
    for more in apart:
        begin, end = _ends(drawn, pair, outermost + reach + more)
        yield from (begin + (end - begin) * share for share in (0.8, 0.65, 0.5, 0.35, 0.2))


def _entries(drawing: Drawing, focus: Focus) -> list[Entry]:
    """The legend: each strand, the agents that never move, and what the numbers are."""
    strands, joined, moving = drawing.strands, drawing.joined, drawing.tracks
    real = [strand for strand in strands if not strand.planned]
    shown = []
    for strand in real:
        look = {"color": strand.colour, "linestyle": strand.stroke}
        shown.append(Entry.line(strand.words, linewidth=_width(strand.agents), **look))
    if len(real) < len(strands):
        dashed = {"color": pale(DARK), "linestyle": "--"}
        shown.append(Entry.line("planned", linewidth=_width(1), **dashed))
    badge = {"marker": "o", "markersize": 8, "color": WHITE, "markeredgecolor": DARK}
    where = "that start there" if focus.step is None else f"there at step {focus.step:g}"
    shown.append(Entry.line(f"agents {where}", **badge))
    end = max((track.end for track in moving), default=0)
    whole = (
        track for track in moving if track.ids and (track.stops[0].first, track.end) == (0, end)
    )
    idle = sum(track.count for track in whole if not track.moves)
    if idle:
        shown.append(Entry.nothing(f"{idle:,} never {'moves' if idle == 1 else 'move'}"))
    if any(track.modules for track in moving):
        shown.append(Entry.nothing("of a structure: (its modules)"))
    return [*shown, *(_number_entries(real, joined=joined) if focus.step is None else ())]


def _number_entries(strands: Sequence[Strand], *, joined: bool) -> Iterator[Entry]:
    """What the numbers beside the lines are."""
    if strands:
        yield Entry.nothing("the more agents, the wider" if joined else "numbers: steps of arrival")
    if _few_loads(strands):
        what = "all that is carried" if joined else "what is carried"
        yield Entry.nothing(f"numbers with names: {what}")
