"""The map: polygons or a graph, names and labels, durations, and where the team starts."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from tsplan.draw import canvas, crosses
from tsplan.draw.canvas import DARK, LINE, SMALL, SOFT, WHITE, Entry, Picture
from tsplan.draw.edge_layout import Places, Point, spacing
from tsplan.draw.layout import bounds, links, places, usual_duration
from tsplan.draw.matplotlib_loading import library
from tsplan.draw.palette import Palette
from tsplan.draw.state_labels import DOT, StateLabel, state_labels
from tsplan.draw.text_placement import Box, Frame, Placement, direction, frame_of
from tsplan.plans.worlds import World
from tsplan.ts import TransitionSystem
from tsplan.words import visible

WIDTH = 7.0
"""Inches across the page of a map without its legend."""

_LOWEST, _HIGHEST, _TITLE = 2.2, 8.0, 0.35  # inches
_DENSE = 14.0  # points from state to state below which everything is drawn as thin as can be
_MOST_LABELS = 24  # labels that a legend can list
_SLIM = 0.42  # half the width of an arrow head, of its length
_BORDER = "#b0b0b0"


@dataclass(frozen=True)
class DrawnMap:
    """A map on its page: what was drawn where, and where there is room left for texts."""

    figure: Any
    ax: Any
    system: TransitionSystem
    palette: Palette
    where: Places
    frame: Frame
    placement: Placement
    labels: Mapping[str, StateLabel]

    @cached_property
    def dense(self) -> bool:
        """Whether states are so close together that everything is drawn thin."""
        return len(self.where) > 1 and spacing(self.where) * self.frame.scale < _DENSE

    def line(self, source: str, target: str) -> tuple[Point, Point]:
        """The straight line from one state to another."""
        return self.where[source], self.where[target]

    def write(self, text: str, centre: complex, size: float, **style: Any) -> None:
        """Write a text around a place of the page."""
        usual = {"color": DARK, "zorder": 6, "in_layout": False, "linespacing": 1.15}
        look = {"ha": "center", "va": "center", "fontsize": size, **usual, **style}
        self.ax.text(*self.frame.back(centre), canvas.plain(text), **look)

    def write_free(self, text: str, centres: Iterable[complex], size: float, **style: Any) -> bool:
        """Write a text around the first of several places where it hides nothing, if any."""
        centre = self.placement.place(text, size, centres)
        if centre is not None:
            self.write(text, centre, size, **style)
        return centre is not None


def draw_map(system: TransitionSystem, ax: Any = None) -> Picture:
    """The map: states with names, labels, shapes and colours; edges with durations above 1.

    Edges that exist in one direction only have an arrow head. What has no room is left out, least
    important first: durations, names, labels; labels that cannot be written go to a legend.
    """
    return finish(base(Palette(system), ax, ()), system.name)


def base(
    palette: Palette, ax: Any, entries: Sequence[Entry], worlds: Iterable[World] = ()
) -> DrawnMap:
    """Shapes, edges, states, what is written there, and a legend of entries and other labels.

    What is closed, by the map or by some `worlds`, is crossed out.
    """
    system = palette.system
    closed = crosses.closures(system, worlds)
    where = places(system)
    box = _box(system, where)
    tall = height_of(system)
    known = [*entries, *crosses.entries(closed), *_unmarked(system)]
    figure, ax = canvas.axes(ax, WIDTH + canvas.legend_width(known, tall - _TITLE), tall)
    frame = frame_of(ax, box)
    chosen = state_labels(system, where, frame)
    canvas.legend_beside(ax, [*known, *_unwritten(palette, chosen)])
    frame = frame_of(ax, box)
    chosen = state_labels(system, where, frame)
    free = Placement(frame.page)
    drawn = DrawnMap(figure, ax, system, palette, where, frame, free, chosen)
    _draw_shapes(drawn)
    _draw_edges(drawn)
    _draw_dots(drawn)
    _draw_labels(drawn)
    _draw_crosses(drawn, crosses.crosses(closed, lambda state: drawn.frame.at(where[state])))
    return drawn


def height_of(system: TransitionSystem) -> float:
    """Inches that a map takes."""
    left, bottom, right, top = _box(system, places(system))
    ratio = (top - bottom) / (right - left)
    return min(max(WIDTH * ratio, _LOWEST), _HIGHEST) + _TITLE


def finish(drawn: DrawnMap, title: str, used: Collection[tuple[str, str]] = ()) -> Picture:
    """Write what comes last: the title, and durations of edges not `used` where there is room."""
    usual = usual_duration(drawn.system)
    for source, target, _, text in () if drawn.dense else links(drawn.system):
        if text == usual or (source, target) in used or (target, source) in used:
            continue
        begin, end = map(drawn.frame.at, drawn.line(source, target))
        centres = [begin + (end - begin) * share for share in (0.5, 0.4, 0.6, 0.3, 0.7)]
        drawn.write_free(text, centres, SMALL, color=SOFT, bbox=canvas.halo(), zorder=5)
    canvas.set_title(drawn.ax, title)
    return drawn.figure, drawn.ax


def _box(system: TransitionSystem, where: Places) -> tuple[float, float, float, float]:
    """Left, bottom, right and top of everything that is drawn, with a margin."""
    left, bottom, right, top = bounds(system, where)
    shaped = all(state.shape for state in system.states.values())
    air = 0.02 * max(right - left, top - bottom) if shaped else 0.6 * spacing(where)
    air = air or 1.0
    return left - air, bottom - air, right + air, top + air


def _unwritten(palette: Palette, chosen: Mapping[str, StateLabel]) -> list[Entry]:
    """What the colours stand for, for labels that are not written on the map."""
    written = frozenset().union(*(label.labels for label in chosen.values()))
    labels = [label for label in palette.system.labels if label not in written]
    shown = [Entry.patch(label, **canvas.area(palette.labels[label])) for label in labels]
    return canvas.cut_entries(shown, _MOST_LABELS, " labels")


def _unmarked(system: TransitionSystem) -> list[Entry]:
    """How long the edges without a number take, unless that is one step."""
    usual = usual_duration(system)
    style = {"color": LINE, "linewidth": 0.9}
    return [] if usual == "1" else [Entry.line(f"{usual} steps if not marked", **style)]


def _draw_shapes(drawn: DrawnMap) -> None:
    """The polygons, pale and in the colour of their states."""
    edge: dict[str, Any] = {"edgecolor": _BORDER, "linewidth": 0.7, "zorder": 1}
    if drawn.dense:
        edge |= {"edgecolor": WHITE, "linewidth": 0.2}
    for name, state in drawn.system.states.items():
        if state.shape:
            paint = drawn.palette.states[name]
            look = edge | {"facecolor": paint.pale, "hatch": paint.hatch or None}
            shape = library("patches").Polygon(state.shape, gid=visible(f"state:{name}"), **look)
            drawn.ax.add_patch(shape)


def _draw_edges(drawn: DrawnMap) -> None:
    """One line for each pair of connected states; an arrow head if there is no way back."""
    width = 0.3 if drawn.dense else 0.9
    style: dict[str, Any] = {"colors": LINE, "linewidths": width, "zorder": 2, "alpha": 0.7}
    for kind in (False, True):
        found = (drawn.line(*ends) for *ends, one_way, _ in links(drawn.system) if one_way == kind)
        lines = [(begin, end) for begin, end in found if begin != end]
        gid = "one-way edges" if kind else "edges"
        canvas.add_collection(drawn.ax, "LineCollection", lines, gid=gid, **style)
        if kind and not drawn.dense:
            arrow_heads(drawn, lines, 0.62, (LINE, 4.5))


def arrow_heads(
    drawn: DrawnMap,
    lines: Sequence[tuple[Point, Point]],
    share: float,
    look: tuple[str, float],
) -> None:
    """Small triangles at a share of each line that point to its end; a colour and points long."""
    colour, size = look
    triangles = []
    for line in lines:
        begin, end = map(drawn.frame.at, line)
        middle, along = begin + (end - begin) * share, direction(end - begin) * size
        left = along * _SLIM * 1j
        corners = middle + along / 2, middle - along / 2 + left, middle - along / 2 - left
        triangles.append([drawn.frame.back(corner) for corner in corners])
    style: dict[str, Any] = {"facecolors": colour, "linewidths": 0, "zorder": 4, "gid": "heads"}
    canvas.add_collection(drawn.ax, "PolyCollection", triangles, **style)


def _draw_dots(drawn: DrawnMap) -> None:
    """A dot for each state without a shape."""
    bare = [name for name, state in drawn.system.states.items() if not state.shape]
    if not bare:
        return
    size = 2.0 if drawn.dense else DOT
    xs, ys = zip(*(drawn.where[name] for name in bare), strict=True)
    colours = [drawn.palette.states[name].colour for name in bare]
    edge = {"edgecolors": DARK, "linewidths": 0.1 if drawn.dense else 0.6}
    drawn.ax.scatter(xs, ys, s=size**2, c=colours, zorder=3, gid="states", **edge)
    for name in () if drawn.dense else bare:
        drawn.placement.take(Box.around(drawn.frame.at(drawn.where[name]), size / 2, size / 2))


def _draw_crosses(drawn: DrawnMap, found: Iterable[crosses.Cross]) -> None:
    look: dict[str, Any] = {"color": crosses.COLOUR, "gid": "closed", "bbox": canvas.halo()}
    for cross in found:
        if not drawn.write_free(cross.words, cross.centres, SMALL, **look):
            drawn.write(cross.sign, cross.centres[0], SMALL, **look)


def _draw_labels(drawn: DrawnMap) -> None:
    for name, label in drawn.labels.items():
        shaped = drawn.system.states[name].shape
        ground = drawn.palette.states[name].pale if shaped else WHITE
        for place, (text, size, centre) in enumerate(label.lines()):
            style = {} if place == 0 and label.name else {"style": "italic", "color": "#555555"}
            drawn.write(text, centre, size, bbox=canvas.halo(ground), **style)
        if label.parts:
            drawn.placement.take(label.box)
