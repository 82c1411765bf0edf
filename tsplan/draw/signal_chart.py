"""Signals and controls over the steps, against what the formula asks of them.

Pale grey is when the formula can ask for a predicate, blue where the trajectory satisfies the
formula by it, on the side of the threshold that is asked for, and red where it comes nearest to
that but fails. The dashed line is the threshold. A predicate over several signals has a panel of
its own, with the value that it compares.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any, TypeAlias

import numpy as np

from tsplan.draw import canvas
from tsplan.draw.canvas import LINE, POINTS, SMALL, WHITE, Entry
from tsplan.draw.matplotlib_loading import library
from tsplan.draw.palette import Paint, paints
from tsplan.draw.step_axes import CHOSEN, HALF, MISSED, NEED, REST, WINDOW, step_axes
from tsplan.errors import Finding, InputError, nearest
from tsplan.explanation.why.predicate_demands import PredicateDemand, predicate_demands
from tsplan.logic.time_horizon import Span
from tsplan.milp.model import Floats
from tsplan.signals.signal_mission import SignalMission
from tsplan.signals.trajectory import Trajectory
from tsplan.words import number

MOST_PANELS = 16
"""Panels that are drawn; what else there is can be named."""

_WIDTH = 6.5  # inches of the steps
_TALL, _TALLER = 0.75, 1.2  # inches of one panel, and of one with thresholds
_AIR = 0.08  # of a panel's range, above and below
_LONGEST = 24  # characters of a panel's name
_MOST_POINTS = 120  # steps up to which each has a point
_BOUND = MappingProxyType({"color": LINE, "linewidth": 0.7, "linestyle": ":"})
_SIGNS = MappingProxyType({">=": "\u2265", "<=": "\u2264", "!=": "\u2260"})
_RISING, _FALLING = (">=", ">"), ("<=", "<")

Bounds: TypeAlias = tuple[float, float]


@dataclass(frozen=True)
class Mark:
    """A predicate in its panel: the threshold in the panel's unit."""

    demand: PredicateDemand
    threshold: float

    @property
    def words(self) -> str:
        """Relation and threshold."""
        relation = self.demand.atom.relation
        return f"{_SIGNS.get(relation, relation)} {number(self.threshold)}"


@dataclass(frozen=True)
class Panel:
    """Lines on one axis: rows of values by name, the bounds of them all, and thresholds.

    A row has a value for each step, or for each but the last, as controls have.
    """

    rows: tuple[tuple[str, Floats], ...]
    bounds: Bounds | None = None
    marks: tuple[Mark, ...] = ()


def draw_signals(
    trajectory: Trajectory | None,
    mission: SignalMission | None = None,
    names: Iterable[str] = (),
    ax: Any = None,
    *,
    on: Any = None,
) -> tuple[Any, Any]:
    """Signals, expressions and controls, each in a panel; the figure and its axes, one a panel.

    `names` chooses some; on a given `ax` all of them are drawn together, without thresholds where
    they are several. Without a trajectory there is what the mission asks for. Raises InputError
    for a name that is unknown. A whole figure may be given as `on`.
    """
    panels = panels_of(trajectory, mission, tuple(names))
    if ax is not None:
        rows = tuple(row for panel in panels for row in panel.rows)
        one = panels[0] if len(panels) == 1 else Panel(rows)
        return _finished(ax.figure, [ax], [one], title_of(trajectory, mission))
    shown = panels[:MOST_PANELS]
    figure = on if on is not None else canvas.new_figure(_width(shown), height_of(shown))
    more = f" ({len(panels) - len(shown)} more)" if len(panels) > len(shown) else ""
    return draw_panels(figure, shown, title_of(trajectory, mission) + more)


def draw_panels(figure: Any, panels: Sequence[Panel], title: str) -> tuple[Any, tuple[Any, ...]]:
    """Panels below each other on a figure, or a part of one, and their axes."""
    style = {"height_ratios": [_tall(panel) for panel in panels]}
    grid = figure.subplots(len(panels), 1, sharex=True, squeeze=False, gridspec_kw=style)
    return _finished(figure, list(grid[:, 0]), panels, title)


def height_of(panels: Sequence[Panel]) -> float:
    """Inches that panels take."""
    return sum(map(_tall, panels)) + REST


def _tall(panel: Panel) -> float:
    return _TALLER if panel.marks else _TALL


def panels_of(
    trajectory: Trajectory | None, mission: SignalMission | None, names: Sequence[str] = ()
) -> list[Panel]:
    """The panels: signals, expressions that the formula compares, controls."""
    found: dict[str, Panel] = {}
    demands = predicate_demands(mission, trajectory) if mission is not None else ()
    signals, controls = _rows(trajectory, mission)
    for name, row in signals.items():
        found[name] = Panel(((name, row),), _bounds(mission, name))
    for demand in demands:
        if len(demand.atom.terms) > 1:
            said = str(demand.atom).partition(f" {demand.atom.relation} ")[0]
            rows = [(signals | controls)[term] for term, _ in demand.atom.terms]
            steps = min(map(len, rows))
            total = sum(
                f * row[:steps] for (_, f), row in zip(demand.atom.terms, rows, strict=True)
            )
            found.setdefault(said, Panel(((said, np.asarray(total)),)))
    for name, row in controls.items():
        found[name] = Panel(((name, row),), _bounds(mission, name))
    for demand in demands:
        key, factor = _place(demand)
        mark = Mark(demand, demand.atom.bound / factor)
        panel = found[key]
        found[key] = Panel(panel.rows, panel.bounds, (*panel.marks, mark))
    for name in names:
        if name not in found:
            raise InputError([Finding(f"there is no signal '{name}'", nearest(name, found))])
    return [found[name] for name in names or found]


def _place(demand: PredicateDemand) -> tuple[str, float]:
    """The panel of a predicate, and the factor that its threshold has there."""
    if len(demand.atom.terms) == 1:
        return demand.atom.terms[0]
    return str(demand.atom).partition(f" {demand.atom.relation} ")[0], 1.0


def _rows(
    trajectory: Trajectory | None, mission: SignalMission | None
) -> tuple[dict[str, Floats], dict[str, Floats]]:
    if trajectory is not None:
        kinds = trajectory.signals, trajectory.controls
        return tuple({name: trajectory[name] for name in kind} for kind in kinds)  # type: ignore[return-value]
    assert mission is not None
    system, nothing = mission.system, np.full(mission.horizon + 1, np.nan)
    return dict.fromkeys(system.signals, nothing), dict.fromkeys(system.controls, nothing[:-1])


def _bounds(mission: SignalMission | None, name: str) -> Bounds | None:
    if mission is None:
        return None
    system = mission.system
    return {**system.signals, **system.controls}.get(name)


# --- drawing -------------------------------------------------------------------------------------


def title_of(
    trajectory: Trajectory | None, mission: SignalMission | None, what: str = "signals over time"
) -> str:
    """What a picture shows, and of which mission as far as it has a name."""
    name = (trajectory and trajectory.mission.name) or (mission and mission.name)
    return f"{name}: {what}" if name else what


def _width(panels: Sequence[Panel]) -> float:
    return _WIDTH + _beside(panels) + canvas.legend_width(_entries(panels), height_of(panels))


def _beside(panels: Sequence[Panel]) -> float:
    """Inches that the thresholds take right of the panels."""
    words = [mark.words for panel in panels for mark in panel.marks]
    return max((canvas.text_size(word, SMALL)[0] for word in words), default=0.0) / POINTS + 0.1


def _finished(
    figure: Any, every: list[Any], panels: Sequence[Panel], title: str
) -> tuple[Any, tuple[Any, ...]]:
    horizon = max(len(row) for panel in panels for _, row in panel.rows) - 1
    entries = _entries(panels)
    for ax, panel in zip(every, panels, strict=True):
        _set_axes(ax, panel, horizon, last=ax is every[-1])
    canvas.set_title(every[0], title)
    canvas.legend_beside(every[0], entries, _beside(panels))
    figure.align_ylabels(every)
    canvas.settle(figure)
    for ax, panel in zip(every, panels, strict=True):
        _draw_marks(ax, panel.marks)
        _draw_rows(ax, panel, horizon)
    return figure, tuple(every)


def _set_axes(ax: Any, panel: Panel, horizon: int, *, last: bool) -> None:
    step_axes(ax, horizon, (_WIDTH, _tall(panel)), ())
    ax.set_xlabel("step" if last else "", fontsize=SMALL)
    ax.tick_params(axis="x", labelbottom=last)
    ax.tick_params(axis="y", labelsize=SMALL, length=2.5, width=0.6)
    ax.yaxis.set_major_locator(library("ticker").MaxNLocator(nbins=3, min_n_ticks=2))
    ax.spines["left"].set_visible(True)
    ax.spines["left"].set_linewidth(0.6)
    ax.set_ylim(*_range(panel))
    words = canvas.plain(canvas.shortened(_name(panel), _LONGEST))
    ax.set_ylabel(words, fontsize=SMALL + 1, rotation=0, ha="right", va="center")


def _name(panel: Panel) -> str:
    return panel.rows[0][0] if len(panel.rows) == 1 else ""


def _range(panel: Panel) -> Bounds:
    """What the axis shows: values and thresholds, and bounds that are near to them."""
    seen = [mark.threshold for mark in panel.marks]
    for _, row in panel.rows:
        inside = row[np.isfinite(row)]
        seen += [float(inside.min()), float(inside.max())] if inside.size else []
    ends = [end for end in panel.bounds or () if np.isfinite(end)]
    seen = seen or ends or [0.0]
    low, high = min(seen), max(seen)
    across = high - low or 1.0
    near = [end for end in ends if low - across <= end <= high + across]
    low, high = min([low, *near]), max([high, *near])
    air = _AIR * ((high - low) or 1.0)
    return low - air, high + air


def _draw_rows(ax: Any, panel: Panel, horizon: int) -> None:
    for end in panel.bounds or ():
        ax.axhline(end, gid="bound", zorder=1.5, **_BOUND)
    given: dict[str, Paint] = dict(paints(name for name, _ in panel.rows))
    for name, row in panel.rows:
        look: dict[str, Any] = {"color": given[name].colour, "linewidth": 1.3, "zorder": 3}
        if len(row) <= horizon:  # a control, which lasts from its step to the next
            ends = np.append(row, row[-1:])
            ax.step(np.arange(len(ends)), ends, where="post", gid=name, **look)
            continue
        points = {"marker": "o", "markersize": 2.6} if len(row) <= _MOST_POINTS else {}
        ax.plot(np.arange(len(row)), row, gid=name, **points, **look)


def _draw_marks(ax: Any, marks: Sequence[Mark]) -> None:
    """Windows behind everything, then what settles the formula, then the thresholds."""
    for mark in marks:
        for steps in merged(mark.demand.windows):
            _shade(ax, steps, ax.get_ylim(), (WINDOW, "window", 0.4))
    for fails, paint, meaning in ((False, CHOSEN, "chosen"), (True, MISSED, "missed")):
        asked = [mark for mark in marks if mark.demand.fails is fails]
        for steps, values in accepted(asked, ax.get_ylim()):
            _shade(ax, steps, values, (paint, meaning, 0.6 + 0.1 * fails))
    asked_at: dict[float, list[Span]] = {}
    for mark in marks:
        asked_at.setdefault(mark.threshold, []).extend(mark.demand.windows)
    for threshold, windows in asked_at.items():
        for first, last in merged(windows):
            ends = [first - HALF, last + HALF]
            ax.plot(ends, [threshold] * 2, gid="threshold", zorder=2, **NEED)
    _write_thresholds(ax, marks)


def accepted(marks: Sequence[Mark], within: Bounds) -> list[tuple[Span, Bounds]]:
    """Where the formula rests on predicates: runs of steps, and the values that all accept."""
    sides: dict[int, Bounds] = {}
    for mark in marks:
        side = _side(mark, within)
        for first, last in mark.demand.witness_steps:
            for step in range(first, last + 1):
                low, high = sides.get(step, within)
                sides[step] = max(low, side[0]), min(high, side[1])
    found: list[tuple[Span, Bounds]] = []
    for step, side in sorted(sides.items()):
        if found and found[-1][1] == side and found[-1][0][1] == step - 1:
            found[-1] = (found[-1][0][0], step), side
        elif side[0] <= side[1]:
            found.append(((step, step), side))
    return found


def _side(mark: Mark, within: Bounds) -> Bounds:
    """The values that a predicate accepts."""
    relation = mark.demand.atom.relation
    if relation in _RISING:
        return mark.threshold, within[1]
    return (within[0], mark.threshold) if relation in _FALLING else within


def _shade(ax: Any, steps: Span, values: Bounds, paint: tuple[str, str, float]) -> None:
    (first, last), (low, high), (colour, meaning, layer) = steps, values, paint
    look = {"facecolor": colour, "linewidth": 0, "zorder": layer, "gid": meaning}
    corner, across = (first - HALF, low), last - first + 2 * HALF
    ax.add_patch(library("patches").Rectangle(corner, across, high - low, **look))


def merged(spans: Iterable[Span]) -> list[Span]:
    """Spans of steps that meet or follow each other as one.

    >>> merged([(3, 5), (0, 2), (9, 9)])
    [(0, 5), (9, 9)]
    """
    joined: list[Span] = []
    for first, last in sorted(spans):
        if joined and first <= joined[-1][1] + 1:
            joined[-1] = joined[-1][0], max(last, joined[-1][1])
        else:
            joined.append((first, last))
    return joined


def _write_thresholds(ax: Any, marks: Sequence[Mark]) -> None:
    """Relations and thresholds right of the panel, moved apart where they would hide each other."""
    low, high = ax.get_ylim()
    line = 1.2 * SMALL * (high - low) / canvas.extent(ax)[1]
    written = sorted({(mark.threshold, mark.words) for mark in marks})
    written = written[: int((high - low) / line) + 1]
    places = spread([at for at, _ in written], line, high)
    for place, (_, words) in zip(places, written, strict=True):
        ax.annotate(
            canvas.plain(words), (1.0, place), xycoords=("axes fraction", "data"), xytext=(4, 0),
            textcoords="offset points", fontsize=SMALL, va="center", annotation_clip=False,
        )  # fmt: skip


def spread(wanted: Sequence[float], apart: float, most: float) -> list[float]:
    """Places in the order of those wanted, so far apart, and below `most` as far as that goes.

    >>> spread([1.0, 1.5, 9.5], 1.0, 9.0)
    [1.0, 2.0, 9.0]
    """
    places: list[float] = []
    for at in wanted:
        places.append(max([at, *(last + apart for last in places[-1:])]))
    for place in reversed(range(len(places))):
        places[place] = min(places[place], most)
        most = places[place] - apart
    return places


def _entries(panels: Sequence[Panel]) -> list[Entry]:
    marks = [mark.demand for panel in panels for mark in panel.marks]
    rows = [row for panel in panels for row in panel.rows]
    several = any(len(panel.rows) > 1 for panel in panels)
    shown = []
    if several:
        shown += [
            Entry.line(name, color=p.colour) for name, p in paints(n for n, _ in rows).items()
        ]
    if marks:
        shown += [
            Entry.line("threshold", **NEED),
            Entry.patch("can be asked for", facecolor=WINDOW, edgecolor=WHITE),
        ]
    if any(demand.witness_steps and not demand.fails for demand in marks):
        shown.append(Entry.patch("satisfied here", facecolor=CHOSEN))
    if any(demand.fails for demand in marks):
        shown.append(Entry.patch("missed here", facecolor=MISSED))
    if any(panel.bounds and np.isfinite(panel.bounds).any() for panel in panels):
        shown.append(Entry.line("bound", **_BOUND))
    return shown
