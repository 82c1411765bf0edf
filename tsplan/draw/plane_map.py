"""Two signals as a plane: regions, and the path of every robot with its steps.

Regions that the formula wants left alone are hatched, those that it wants entered are coloured;
robots of one kind, the copies `a_x`, `a_y` and `b_x`, `b_y` of `x` and `y`, have a path each.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Any, TypeAlias

import numpy as np

from tsplan.draw import canvas
from tsplan.draw.canvas import DARK, POINTS, SMALL, TINY, WHITE, Entry, Picture
from tsplan.draw.matplotlib_loading import library
from tsplan.draw.palette import HUES, Paint, paints
from tsplan.draw.signal_chart import title_of
from tsplan.draw.text_placement import Box, Placement
from tsplan.errors import Finding, InputError, nearest
from tsplan.logic import Always, And, Formula, Linear, Or, positive, walk
from tsplan.milp.model import Floats
from tsplan.signals.region import Region
from tsplan.signals.signal_mission import SignalMission
from tsplan.signals.trajectory import Trajectory

Axes: TypeAlias = tuple[str, str]
Sides: TypeAlias = tuple[float, float, float, float]

_SIZE = 5.0  # inches of the longer side
_REST = 0.8  # inches of title and names of the axes
_SLIMMEST = 0.3  # shorter side, of the longer one
_ALIKE = 4.0  # one range is at most so many times the other where both are of one scale
_AIR = 0.04  # of the whole, around it
_NEAR = 3.0  # bounds are shown that are within so many times what else there is
_AVOIDED, _PLAIN = "#9a9a9a", "#f2f2f2"
_MOST_POINTS = 200  # steps up to which each has a point
_AWAY = 7.0  # points from a point to the number of its step


@dataclass(frozen=True)
class Place:
    """A region as it lies in the plane: its corners, and whether it is wanted (None: neither).

    `regions` are the mission's that lie there, one for each robot that has it.
    """

    name: str
    sides: Sides
    wanted: bool | None
    regions: tuple[str, ...]


def draw_plane(
    trajectory: Trajectory | None,
    mission: SignalMission | None = None,
    plane: Axes | None = None,
    ax: Any = None,
) -> Picture:
    """The plane of two signals, with regions and paths; the figure and its axes.

    Without names of signals the plane is that of the first region that has two, else of the first
    two signals. Raises InputError for signals that are unknown.
    """
    across, up = chosen = plane or plane_of(trajectory, mission)
    paths = paths_of(trajectory, mission, chosen)
    places = places_of(mission, chosen) if mission is not None else ()
    left, bottom, right, top = box = frame_of_plane(paths, places, mission, chosen)
    ratio = (top - bottom) / (right - left)
    equal = 1 / _ALIKE <= ratio <= _ALIKE
    wide, tall = _inches(ratio if equal else 0.6)
    entries = _entries(paths, places)
    figure, ax = canvas.axes(ax, wide + _REST + canvas.legend_width(entries, tall), tall + _REST)
    ax.set(xlim=(left, right), ylim=(bottom, top))
    ax.set_aspect("equal" if equal else "auto", adjustable="box")
    ax.tick_params(labelsize=SMALL, length=2.5, width=0.6)
    for name, set_label in ((across, ax.set_xlabel), (up, ax.set_ylabel)):
        set_label(canvas.plain(canvas.shortened(name, 30)), fontsize=SMALL + 1)
    for spine in ax.spines.values():
        spine.set(linewidth=0.6, color="#b0b0b0")
    canvas.set_title(ax, title_of(trajectory, mission, f"{across} and {up}"))
    canvas.legend_beside(ax, entries)
    canvas.settle(figure)
    ax.apply_aspect()
    _draw_places(ax, places, box)
    _draw_paths(ax, paths, places)
    return figure, ax


def height_of(trajectory: Trajectory | None, mission: SignalMission | None) -> float:
    """Inches that the usual plane takes."""
    chosen = plane_of(trajectory, mission)
    paths = paths_of(trajectory, mission, chosen)
    places = places_of(mission, chosen) if mission is not None else ()
    left, bottom, right, top = frame_of_plane(paths, places, mission, chosen)
    ratio = (top - bottom) / (right - left)
    return _inches(ratio if 1 / _ALIKE <= ratio <= _ALIKE else 0.6)[1] + _REST


def _inches(ratio: float) -> tuple[float, float]:
    return min(_SIZE, _SIZE / ratio), max(min(_SIZE, _SIZE * ratio), _SLIMMEST * _SIZE)


# --- what there is -------------------------------------------------------------------------------


def plane_of(trajectory: Trajectory | None, mission: SignalMission | None) -> Axes:
    """The signals of the usual plane.

    Raises InputError where there is only one signal.
    """
    names = _signals(trajectory, mission)
    if len(names) < 2:  # noqa: PLR2004  (a plane)
        what = f"a plane needs two signals, and there is only '{names[0]}'"
        raise InputError([Finding(what, "look at the signals over time")])
    regions = mission.regions.values() if mission is not None else ()
    flat = ([name for name in region.axes if robots_in(names, (name, name))] for region in regions)
    across, up, *_ = next((axes for axes in flat if len(axes) > 1), names)
    for prefix in _prefixes(names, across, up):  # of robots the names that they share
        return across.removeprefix(prefix), up.removeprefix(prefix)
    return across, up


def _prefixes(names: list[str], across: str, up: str) -> Iterator[str]:
    """How the names of one robot begin, if others have the same two signals."""
    common = across[
        : next((n for n, (a, b) in enumerate(zip(across, up, strict=False)) if a != b), 0)
    ]
    prefix = common[: common.rfind("_") + 1]
    ends = across.removeprefix(prefix), up.removeprefix(prefix)
    if prefix and len(robots_in(names, ends)) > 1:
        yield prefix


def robots_in(names: list[str], plane: Axes) -> list[str]:
    """The prefixes with which both signals exist: one empty, or one for each robot."""
    across, up = plane
    if across in names and up in names:
        return [""]
    ends = [name.removesuffix(across) for name in names if name.endswith(f"_{across}")]
    return [prefix for prefix in ends if prefix + up in names]


def _signals(trajectory: Trajectory | None, mission: SignalMission | None) -> list[str]:
    if trajectory is not None and trajectory.has_signals:
        return [*trajectory.signals]
    return [*mission.system.signals] if mission is not None else []


def paths_of(
    trajectory: Trajectory | None, mission: SignalMission | None, plane: Axes
) -> dict[str, Floats]:
    """The path of each robot (2, T+1) by its name, that of a single one by none.

    Without a trajectory a path is where the robot begins, as far as that is known. Raises
    InputError for signals that are unknown.
    """
    names = _signals(trajectory, mission)
    prefixes = robots_in(names, plane)
    for name in plane if not prefixes else ():
        if name not in names:
            raise InputError([Finding(f"there is no signal '{name}'", nearest(name, names))])
    found = {}
    for prefix in prefixes:
        pair = [prefix + name for name in plane]
        if trajectory is not None and trajectory.has_signals:
            found[prefix.rstrip("_")] = np.array([trajectory[name] for name in pair])
        elif mission is not None:
            begins = [mission.system.begins(name) for name in pair]
            if all(low == high for low, high in begins):
                found[prefix.rstrip("_")] = np.array([[low] for low, _ in begins])
    return found


def places_of(mission: SignalMission, plane: Axes) -> tuple[Place, ...]:
    """The regions in a plane, those of several robots once; larger ones first."""
    formulas = (mission.formula, *(soft.formula for soft in mission.prefer))
    nodes = [node for formula in formulas for node in walk(positive(formula))]
    joined = [(type(node), _sides_of(node)) for node in nodes if isinstance(node, And | Or)]
    joined += [(And, _sides_of(node)) for node in nodes if isinstance(node, Linear)]
    found: dict[Sides, Place] = {}
    for prefix in robots_in([*mission.system.signals], plane):
        for name, region in mission.regions.items():
            axes = of_robot(region, prefix)
            pair = [axes.get(prefix + axis, (-np.inf, np.inf)) for axis in plane]
            if np.isfinite(pair).any():
                (left, right), (bottom, top) = pair
                sides = (left, bottom, right, top)
                wanted = _wanted(axes, joined)
                known = found.get(sides, Place(name.removeprefix(prefix), sides, wanted, ()))
                wanted = wanted if known.wanted is None else known.wanted
                regions = tuple(dict.fromkeys((*known.regions, name)))
                found[sides] = replace(known, wanted=wanted, regions=regions)
    return tuple(sorted(found.values(), key=lambda place: -_area(place)))


def of_robot(region: Region, prefix: str) -> dict[str, tuple[float, float]]:
    """A region's sides by the signals of one robot: `x` stands for the `a_x` of each."""
    return {
        name if name.startswith(prefix) else prefix + name: ends
        for name, ends in region.axes.items()
    }


_Half: TypeAlias = "tuple[tuple[tuple[str, float], ...], str, float]"
"""The terms of a comparison, which way it looks, and its bound."""


def _sides_of(node: Formula) -> frozenset[_Half]:
    """The comparisons that a node joins, or that it is; one throughout some steps counts as one."""
    parts = node.children or (node,)
    single = (part.child if isinstance(part, Always) else part for part in parts)
    return frozenset(
        (part.terms, part.relation[0], part.bound) for part in single if isinstance(part, Linear)
    )


def _wanted(
    axes: Mapping[str, tuple[float, float]],
    joined: Sequence[tuple[type[Formula], frozenset[_Half]]],
) -> bool | None:
    """Whether the formula asks to be in a region; None if it asks for neither.

    To be in it is to be on the inner side of all its ends, to be out of it beyond any of them.
    """
    ends = [(name, *end) for name, (a, b) in axes.items() for end in ((a, ">", "<"), (b, "<", ">"))]
    inside = {(((name, 1.0),), sign, bound) for name, bound, sign, _ in ends}
    outside = {(((name, 1.0),), other, bound) for name, bound, _, other in ends}
    if any(kind is And and inside <= halves for kind, halves in joined):
        return True
    return False if any(kind is Or and outside <= halves for kind, halves in joined) else None


def _area(place: Place) -> float:
    left, bottom, right, top = place.sides
    return (right - left) * (top - bottom)


def frame_of_plane(
    paths: Mapping[str, Floats],
    places: tuple[Place, ...],
    mission: SignalMission | None,
    plane: Axes,
) -> Sides:
    """Left, bottom, right and top of everything, with a margin; bounds that are near are in it."""
    ends: list[tuple[float, float]] = []
    names = [*mission.system.signals] if mission is not None else []
    for axis in (0, 1):
        seen = [float(value) for path in paths.values() for value in path[axis]]
        seen += [p.sides[n] for p in places for n in (axis, axis + 2) if np.isfinite(p.sides[n])]
        bounds = [
            end
            for prefix in robots_in(names, plane)
            for end in mission.system.signals[prefix + plane[axis]]  # type: ignore[union-attr]
            if np.isfinite(end)
        ]
        low, high = min(seen or bounds or [0.0]), max(seen or bounds or [1.0])
        room = _NEAR * (high - low)
        near = [end for end in bounds if low - room <= end <= high + room]
        low, high = min([low, *near]), max([high, *near])
        air = _AIR * (high - low) or 0.5
        ends.append((low - air, high + air))
    (left, right), (bottom, top) = ends
    return left, bottom, right, top


# --- drawing -------------------------------------------------------------------------------------


def _paint(place: Place, given: Mapping[str, Paint]) -> dict[str, Any]:
    if place.wanted is None:
        return {"facecolor": _PLAIN, "edgecolor": DARK, "linewidth": 0.5}
    if not place.wanted:
        return {"facecolor": "#dcdcdc", "edgecolor": _AVOIDED, "hatch": "////", "linewidth": 0.6}
    return {"facecolor": given[place.name].pale, "edgecolor": DARK, "linewidth": 0.5}


def _paints_of(places: tuple[Place, ...]) -> Mapping[str, Paint]:
    return paints((place.name for place in places if place.wanted), HUES[::-1])


def _draw_places(ax: Any, places: tuple[Place, ...], box: Sides) -> None:
    given = _paints_of(places)
    for place in places:
        left, bottom = (max(a, b) for a, b in zip(place.sides[:2], box[:2], strict=True))
        right, top = (min(a, b) for a, b in zip(place.sides[2:], box[2:], strict=True))
        shape = library("patches").Rectangle(
            (left, bottom), right - left, top - bottom, zorder=1, **_paint(place, given)
        )
        shape.set_gid(f"region:{place.name}")
        ax.add_patch(shape)


class _Page:
    """Where points of the plane lie on the page, in points, and what is taken there."""

    def __init__(self, ax: Any) -> None:
        self.ax = ax
        width, height = canvas.extent(ax)
        self.free = Placement(Box(0.0, 0.0, width, height))

    def at(self, x: float, y: float) -> complex:
        """A point of the plane on the page."""
        box, dots = self.ax.get_window_extent(), self.ax.transData.transform((x, y))
        scale = POINTS / float(self.ax.figure.dpi)
        return complex(dots[0] - box.x0, dots[1] - box.y0) * scale

    def back(self, place: complex) -> tuple[float, float]:
        """A place on the page in the plane."""
        box, scale = self.ax.get_window_extent(), self.ax.figure.dpi / POINTS
        dots = box.x0 + place.real * scale, box.y0 + place.imag * scale
        x, y = self.ax.transData.inverted().transform(dots)
        return float(x), float(y)

    def write(self, text: str, middle: complex, shifts: list[complex], size: float) -> bool:
        """Write a text at the first free place around a middle."""
        where = self.free.place(text, size, [middle + shift for shift in shifts])
        if where is None:
            return False
        self.ax.text(
            *self.back(where), canvas.plain(text), fontsize=size, ha="center", va="center",
            color=DARK, zorder=6, bbox=canvas.halo(), gid="text", in_layout=False,
        )  # fmt: skip
        return True


def _draw_paths(ax: Any, paths: Mapping[str, Floats], places: tuple[Place, ...]) -> None:
    page, given = _Page(ax), paints(paths)
    for name, path in paths.items():
        look: dict[str, Any] = {"color": given[name].colour, "zorder": 4}
        points = {"marker": "o", "markersize": 2.8} if path.shape[1] <= _MOST_POINTS else {}
        ax.plot(*path, linewidth=1.4, gid=f"path:{name}", **points, **look)
        ends = {"marker": "o", "markersize": 7, "markeredgewidth": 1.6, "linestyle": "none"}
        edge = {**look, **ends, "markeredgecolor": look["color"], "zorder": 4.5}
        ax.plot(*path[:, :1], gid="start", **{**edge, "color": WHITE})
        for x, y in path.T if points else path.T[[0, -1]]:
            page.free.take(Box.around(page.at(x, y), 2.0, 2.0))
    for place in places:
        _write_name(page, place)
    for path in paths.values():
        _write_steps(page, path)


def _write_name(page: _Page, place: Place) -> None:
    """A region's name in its middle, or beside it."""
    (left, right), (bottom, top) = page.ax.get_xlim(), page.ax.get_ylim()
    sides = place.sides
    x0, x1 = max(sides[0], left), min(sides[2], right)
    y0, y1 = max(sides[1], bottom), min(sides[3], top)
    low, high = page.at(x0, y0), page.at(x1, y1)
    middle, half = (low + high) / 2, (high - low) / 2
    text = canvas.shortened(place.name, 20)
    out = half.imag + SMALL
    inner = [0j, 0.6j * half.imag, -0.6j * half.imag, 0.5 * half.real + 0j, -0.5 * half.real + 0j]
    page.write(text, middle, [*inner, 1j * out, -1j * out], SMALL)


def _write_steps(page: _Page, path: Floats) -> None:
    """The numbers of steps beside the path, the last first, the others as far as there is room."""
    middles = [page.at(x, y) for x, y in path.T]
    last = len(middles) - 1
    order = dict.fromkeys([last, 0, *range(0, last, 5), *range(last)])
    stays = {n for n, (a, b) in enumerate(pairwise(middles)) if abs(b - a) < 1}
    turns = [np.exp(0.25j * np.pi * n) * _AWAY for n in (2, 6, 1, 7, 3, 5, 0, 4)]
    for step in order:
        if step not in stays:
            page.write(str(step), middles[step], [complex(turn) for turn in turns], TINY + 0.8)


def _entries(paths: Mapping[str, Floats], places: tuple[Place, ...]) -> list[Entry]:
    given, shown = paints(paths), []
    moved = any(path.shape[1] > 1 for path in paths.values())
    if moved:
        names = [(name or "path", given[name].colour) for name in paths]
        shown = [Entry.line(name, color=colour, linewidth=1.4) for name, colour in names]
    if paths:
        look = {"marker": "o", "markersize": 6, "color": WHITE, "markeredgecolor": DARK}
        shown.append(Entry.line("start", **look))
    colours = _paints_of(places)
    for wanted, words in ((True, "to be in"), (False, "to be out of"), (None, "not asked for")):
        first = next((place for place in places if place.wanted is wanted), None)
        if first is not None:
            shown.append(Entry.patch(words, **_paint(first, colours)))
    if moved:
        shown.append(Entry.nothing("numbers: steps"))
    return shown
