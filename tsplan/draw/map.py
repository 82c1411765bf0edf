"""The map: polygons or a graph, names and labels, durations, and where the team starts."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

from tsplan.draw.canvas import (
    DARK,
    LINE,
    SMALL,
    WHITE,
    Entry,
    Picture,
    area,
    axes,
    halo,
    legend_beside,
    legend_width,
    plain,
    set_title,
)
from tsplan.draw.layout import Places, places, spacing
from tsplan.draw.matplotlib_loading import library
from tsplan.draw.palette import Palette
from tsplan.draw.state_labels import Sign, signs
from tsplan.draw.text_placement import Box, Frame, Point, Room, frame_of
from tsplan.words import visible

if TYPE_CHECKING:
    from tsplan.mission import Mission
    from tsplan.ts import TransitionSystem
    from tsplan.ts.edges import Duration

WIDTH = 7.0
"""Inches across the page of a map without its legend."""

_LOWEST, _HIGHEST, _TITLE = 2.2, 8.0, 0.35  # inches
_DOT = 5.0  # points across a state's dot
_DENSE = 14.0  # points from state to state below which everything is drawn as thin as can be
_MOST_LABELS = 24  # labels that a legend can list
_SLIM = 0.42  # half the width of an arrow head, of its length
_BORDER = "#b0b0b0"


@dataclass(frozen=True)
class Scene:
    """A map on its page: what was drawn where, and where there is room left for texts."""

    figure: Any
    ax: Any
    system: TransitionSystem
    palette: Palette
    where: Places
    frame: Frame
    room: Room
    signs: Mapping[str, Sign]

    @cached_property
    def dense(self) -> bool:
        """Whether states are so close together that everything is drawn thin."""
        return len(self.where) > 1 and spacing(self.where) * self.frame.scale < _DENSE

    def write(self, text: str, centre: Point, size: float, **style: Any) -> None:
        """Write a text around a point of the page."""
        x, y = self.frame.back(centre)
        self.ax.text(
            x,
            y,
            plain(text),
            fontsize=size,
            ha="center",
            va="center",
            **{"color": DARK, "zorder": 6, "in_layout": False, "linespacing": 1.15, **style},
        )


def draw_map(system: TransitionSystem, ax: Any = None) -> Picture:
    """The map: states with names, labels, shapes and colours; edges with durations above 1.

    Edges that exist in one direction only have an arrow head. What has no room is left out, least
    important first: durations, names, labels; labels that cannot be written go to a legend.
    """
    scene = base(Palette(system), ax, ())
    finish(scene)
    set_title(scene.ax, system.name)
    return scene.figure, scene.ax


def draw_mission(mission: Mission, ax: Any = None) -> Picture:
    """The map with how many robots of each class start where."""
    from tsplan.draw.starts import class_entries, draw_starts  # noqa: PLC0415  (imports this)

    palette = Palette.of(mission)
    scene = base(palette, ax, class_entries(mission, palette))
    draw_starts(scene, mission, palette.classes)
    finish(scene)
    set_title(scene.ax, mission.name or mission.system.name)
    return scene.figure, scene.ax


def base(palette: Palette, ax: Any, entries: Sequence[Entry]) -> Scene:
    """Shapes, edges, states and their signs, with a legend of the entries and unwritten labels."""
    system = palette.system
    where = places(system)
    box = _box(system, where)
    tall = height_of(system)
    known = [*entries, *_unmarked(system)]
    figure, ax = axes(ax, WIDTH + legend_width(known, tall - _TITLE), tall)
    frame = frame_of(ax, box)
    chosen = signs(system, where, frame)
    legend_beside(ax, [*known, *_unwritten(palette, chosen)])
    frame = frame_of(ax, box)
    chosen = signs(system, where, frame)
    scene = Scene(figure, ax, system, palette, where, frame, Room(frame.page), chosen)
    _draw_shapes(scene)
    _draw_edges(scene)
    _draw_dots(scene)
    _draw_signs(scene)
    return scene


def height_of(system: TransitionSystem) -> float:
    """Inches that a map takes."""
    left, bottom, right, top = _box(system, places(system))
    ratio = (top - bottom) / (right - left)
    return min(max(WIDTH * ratio, _LOWEST), _HIGHEST) + _TITLE


def finish(scene: Scene, used: Collection[tuple[str, str]] = ()) -> None:
    """Write what comes last, where there is still room: the durations of edges not `used`."""
    if scene.dense:
        return
    usual = usual_duration(scene.system)
    for (source, target), text in _durations(scene.system):
        if text == usual or (source, target) in used or (target, source) in used:
            continue
        begin, end = scene.frame.at(scene.where[source]), scene.frame.at(scene.where[target])
        centres = [_between(begin, end, share) for share in (0.5, 0.4, 0.6, 0.3, 0.7)]
        if found := scene.room.place(text, SMALL, centres):
            scene.write(text, found, SMALL, color="#666666", bbox=halo(), zorder=5)


def duration_words(there: Duration, back: Duration) -> str:
    """A duration as it is written on an edge: one number, or a range where classes or ways differ.

    >>> duration_words(2, 2), duration_words(1, 3), duration_words({"a": 1, "default": 2}, 2)
    ('2', '1-3', '1-2')
    """
    every = [n for d in (there, back) for n in (d.values() if isinstance(d, Mapping) else (d,))]
    least, most = min(every), max(every)
    return str(least) if least == most else f"{least}-{most}"


def _box(system: TransitionSystem, where: Places) -> tuple[float, float, float, float]:
    """Left, bottom, right and top of everything that is drawn, with a margin."""
    corners = [point for state in system.states.values() for point in state.shape or ()]
    points = [*where.values(), *corners]
    xs, ys = [p[0] for p in points], [p[1] for p in points]
    shaped = all(state.shape for state in system.states.values())
    air = 0.02 * max(max(xs) - min(xs), max(ys) - min(ys)) if shaped else 0.6 * spacing(where)
    air = air or 1.0
    return min(xs) - air, min(ys) - air, max(xs) + air, max(ys) + air


def _unwritten(palette: Palette, chosen: Mapping[str, Sign]) -> list[Entry]:
    """What the colours stand for, for labels that are not written on the map."""
    patch = library("patches").Patch
    written = frozenset().union(*(sign.labels for sign in chosen.values()))
    labels = [label for label in palette.system.labels if label not in written]
    shown = [Entry(patch(**area(palette.labels[label])), label) for label in labels[:_MOST_LABELS]]
    if len(labels) > _MOST_LABELS:
        shown.append(Entry(patch(alpha=0), f"and {len(labels) - _MOST_LABELS} more labels"))
    return shown


def _unmarked(system: TransitionSystem) -> list[Entry]:
    """How long the edges without a number take, unless that is one step."""
    usual = usual_duration(system)
    if usual == "1":
        return []
    words = f"{usual} steps if not marked"
    return [Entry(library("lines").Line2D([], [], color=LINE, linewidth=0.9), words)]


def usual_duration(system: TransitionSystem) -> str:
    """The words of the duration of most edges, which are not repeated on each; else one step."""
    words = Counter(words for _, words in _durations(system))
    most, number = words.most_common(1)[0] if words else ("1", 1)
    return most if 2 * number > words.total() else "1"


def _durations(system: TransitionSystem) -> Iterator[tuple[tuple[str, str], str]]:
    """Every pair of connected states once, with the words of its durations."""
    for (source, target), edge in system.edges.items():
        back = system.edges.get((target, source))
        if source != target and (back is None or source < target):
            yield (source, target), duration_words(edge.duration, (back or edge).duration)


def _draw_shapes(scene: Scene) -> None:
    """The polygons, pale and in the colour of their states."""
    width = 0.2 if scene.dense else 0.7
    for name, state in scene.system.states.items():
        if state.shape:
            paint = scene.palette.states[name]
            scene.ax.add_patch(
                library("patches").Polygon(
                    state.shape,
                    facecolor=paint.pale,
                    edgecolor=WHITE if scene.dense else _BORDER,
                    hatch=paint.hatch or None,
                    linewidth=width,
                    zorder=1,
                    gid=visible(f"state:{name}"),
                )
            )


def _draw_edges(scene: Scene) -> None:
    """One line for each pair of connected states; an arrow head if there is no way back."""
    both, single = [], []
    for source, target in scene.system.edges:
        line = (scene.where[source], scene.where[target])
        if source == target or line[0] == line[1]:
            continue
        if (target, source) not in scene.system.edges:
            single.append(line)
        elif source < target:
            both.append(line)
    width = 0.3 if scene.dense else 0.9
    style: dict[str, Any] = {"colors": LINE, "linewidths": width, "zorder": 2, "alpha": 0.7}
    for lines, gid in ((both, "edges"), (single, "one-way edges")):
        drawn = library("collections").LineCollection(lines, gid=gid, **style)
        scene.ax.add_collection(drawn, autolim=False)
    if not scene.dense:
        arrow_heads(scene, single, 0.62, (LINE, 4.5))


def arrow_heads(
    scene: Scene,
    lines: Sequence[tuple[Point, Point]],
    share: float,
    look: tuple[str, float],
) -> None:
    """Small triangles at a share of each line that point to its end; a colour and points long."""
    colour, size = look
    triangles = []
    for begin, end in lines:
        (x0, y0), (x1, y1) = scene.frame.at(begin), scene.frame.at(end)
        length = math.hypot(x1 - x0, y1 - y0) or 1.0
        right, up = (x1 - x0) / length * size, (y1 - y0) / length * size
        x, y = _between((x0, y0), (x1, y1), share)
        corners = (
            (x + right / 2, y + up / 2),
            (x - right / 2 - up * _SLIM, y - up / 2 + right * _SLIM),
            (x - right / 2 + up * _SLIM, y - up / 2 - right * _SLIM),
        )
        triangles.append([scene.frame.back(corner) for corner in corners])
    style: dict[str, Any] = {"facecolors": colour, "linewidths": 0, "zorder": 4, "gid": "heads"}
    heads = library("collections").PolyCollection(triangles, **style)
    scene.ax.add_collection(heads, autolim=False)


def _draw_dots(scene: Scene) -> None:
    """A dot for each state without a shape."""
    bare = [name for name, state in scene.system.states.items() if not state.shape]
    if not bare:
        return
    size = _DOT if not scene.dense else 2.0
    scene.ax.scatter(
        [scene.where[name][0] for name in bare],
        [scene.where[name][1] for name in bare],
        s=size**2,
        c=[scene.palette.states[name].colour for name in bare],
        edgecolors=DARK,
        linewidths=0.1 if scene.dense else 0.6,
        zorder=3,
        gid="states",
    )
    if not scene.dense:
        for name in bare:
            x, y = scene.frame.at(scene.where[name])
            scene.room.take(Box(x - size / 2, y - size / 2, x + size / 2, y + size / 2))


def _draw_signs(scene: Scene) -> None:
    for name, sign in scene.signs.items():
        shaped = scene.system.states[name].shape
        ground = scene.palette.states[name].pale if shaped else WHITE
        for place, (text, size, centre) in enumerate(sign.lines()):
            style = {} if place == 0 and sign.name else {"style": "italic", "color": "#555555"}
            scene.write(text, centre, size, bbox=halo(ground), **style)
        if sign.parts:
            scene.room.take(sign.box)


def _between(begin: Point, end: Point, share: float) -> Point:
    return begin[0] + (end[0] - begin[0]) * share, begin[1] + (end[1] - begin[1]) * share
