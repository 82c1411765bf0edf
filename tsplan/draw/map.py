"""Pictures of maps, missions and plans (matplotlib, the `plot` extra).

Every function takes `ax=None` and returns `(figure, axes)`.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from itertools import pairwise
from typing import TYPE_CHECKING, Any, TypeAlias

from tsplan.errors import TsplanError

if TYPE_CHECKING:
    from tsplan.mission import Mission
    from tsplan.results.plan import Bundle, Plan
    from tsplan.ts import TransitionSystem

Places: TypeAlias = Mapping[str, tuple[float, float]]
Picture: TypeAlias = "tuple[Any, Any]"

MOST_PATHS = 24
"""Distinct paths that are drawn; more cannot be told apart."""

_PLAIN = "#d9d9d9"
_EDGE = "#8c8c8c"


class PlotUnavailableError(TsplanError, RuntimeError):
    """Drawing needs matplotlib, which is not installed."""


def pyplot() -> Any:
    """Matplotlib's pyplot; raises PlotUnavailableError with the remedy if it is missing."""
    try:
        from matplotlib import pyplot as plt  # noqa: PLC0415  (an extra, slow to import)
    except ImportError:
        raise PlotUnavailableError(
            "drawing needs matplotlib, which is not installed; pip install 'tsplan[plot]'"
        ) from None
    return plt


def places(system: TransitionSystem) -> Places:
    """Coordinates of every state: its own, its shape's middle, or a place on a spring layout."""
    known = {name: state.at for name, state in system.states.items() if state.at is not None}
    for name, state in system.states.items():
        if name not in known and state.shape:
            xs, ys = zip(*state.shape, strict=True)
            known[name] = (sum(xs) / len(xs), sum(ys) / len(ys))
    if len(known) == len(system.states):
        return known
    if known:
        return _beside(known, list(system.states))
    import networkx as nx  # noqa: PLC0415  (slow to import)

    layout = nx.spring_layout(system.graph.to_undirected(), seed=0, iterations=100)
    return {name: (float(x), float(y)) for name, (x, y) in layout.items()}


def _beside(known: dict[str, tuple[float, float]], states: list[str]) -> Places:
    """States without a place in a column to the right of those with one."""
    right = max(x for x, _ in known.values())
    top = max(y for _, y in known.values())
    step = max(1.0, (top - min(y for _, y in known.values())) / max(1, len(states)))
    missing = [name for name in states if name not in known]
    return known | {name: (right + step, top - step * n) for n, name in enumerate(missing)}


def draw_map(system: TransitionSystem, ax: Any = None) -> Picture:
    """The map: states with their labels, shapes and colours; edges with durations above 1."""
    figure, ax = _axes(ax)
    where = places(system)
    _shapes(system, ax)
    drawn: set[tuple[str, str]] = set()
    for (source, target), edge in system.edges.items():
        if source == target or (source, target) in drawn:
            continue
        both = (target, source) in system.edges
        drawn |= {(source, target), (target, source)} if both else {(source, target)}
        _arrow(ax, where[source], where[target], "-" if both else "-|>", _EDGE)
        duration = edge.duration
        if duration != 1:
            words = duration if isinstance(duration, int) else _per_class(duration)
            middle = [(a + b) / 2 for a, b in zip(where[source], where[target], strict=True)]
            ax.annotate(str(words), middle, fontsize=7, color="#555555")
    _states(system, where, ax)
    ax.set_title(system.name)
    ax.set_aspect("equal", adjustable="datalim")
    ax.margins(0.1)
    ax.axis("off")
    return figure, ax


def draw_mission(mission: Mission, ax: Any = None) -> Picture:
    """The map with how many robots of each class start where."""
    figure, ax = draw_map(mission.system, ax)
    where = places(mission.system)
    starts: dict[str, list[str]] = {}
    for group in mission.team:
        for state, count in group.starts:
            starts.setdefault(state, []).append(f"{count} {group.class_name}")
    for state, words in starts.items():
        ax.annotate(
            "\n".join(words),
            where[state],
            xytext=(9, -9),
            textcoords="offset points",
            va="top",
            fontsize=8,
            weight="bold",
            color="#b30000",
        )
    ax.set_title(mission.name or mission.system.name)
    return figure, ax


def draw_plan(plan: Plan, mission: Mission | None = None, ax: Any = None) -> Picture:
    """The paths on the mission's map, thicker for more agents; without a mission, a timetable."""
    if mission is None:
        return draw_timetable(plan, ax)
    figure, ax = draw_mission(mission, ax)
    where = places(mission.system)
    colors = pyplot().get_cmap("tab20")
    for number, bundle in enumerate(_moving(plan)[:MOST_PATHS]):
        color = colors(number % 20)
        bend = 0.08 + 0.03 * (number % 6)
        stops = [state for *_, state in bundle.stays] + ([bundle.heading] if bundle.heading else [])
        width = 1.2 + math.log10(len(bundle.agents))
        for source, target in pairwise(stops):
            if source != target:
                _arrow(ax, where[source], where[target], "-|>", color, bend=bend, width=width)
        ax.plot([], [], color=color, linewidth=width, label=_legend(plan, bundle))
    if any(_moving(plan)):
        ax.legend(fontsize=7, loc="best")
    ax.set_title(f"{plan.mission.name}: {plan.status.replace('_', ' ')}")
    return figure, ax


def draw_timetable(plan: Plan, ax: Any = None) -> Picture:
    """When each group of agents on one path is at which state; gaps are travel."""
    figure, ax = _axes(ax)
    colors = pyplot().get_cmap("tab20")
    number = {state: place for place, state in enumerate(plan.states)}
    shown = plan.bundles[:MOST_PATHS]
    for row, bundle in enumerate(shown):
        for first, last, state in bundle.stays:
            ax.barh(row, last - first + 1, left=first - 0.5, color=colors(number[state] % 20))
            ax.text(first - 0.4, row, state, va="center", fontsize=7, clip_on=True)
    ax.set_yticks(range(len(shown)), [_legend(plan, bundle) for bundle in shown], fontsize=7)
    ax.invert_yaxis()
    ax.set_xlabel("step")
    hidden = len(plan.bundles) - len(shown)
    more = f" ({hidden} more paths)" if hidden else ""
    ax.set_title(f"{plan.mission.name}: {plan.status.replace('_', ' ')}{more}")
    return figure, ax


def _moving(plan: Plan) -> list[Bundle]:
    return [b for b in plan.bundles if len({s for *_, s in b.stays} | {b.heading} - {None}) > 1]


def _legend(plan: Plan, bundle: Bundle) -> str:
    from tsplan.results.summary import names  # noqa: PLC0415  (only for words)

    return names([plan.agents[place].id for place in bundle.agents], most=1)


def _axes(ax: Any) -> Picture:
    if ax is not None:
        return ax.figure, ax
    figure, made = pyplot().subplots(figsize=(9, 7), layout="constrained")
    return figure, made


def _shapes(system: TransitionSystem, ax: Any) -> None:
    from matplotlib.patches import Polygon  # noqa: PLC0415  (an extra, slow to import)

    for state in system.states.values():
        if state.shape:
            color = _color(state.color, state.labels)
            ax.add_patch(Polygon(state.shape, facecolor=color, alpha=0.25, edgecolor=_EDGE))
            ax.update_datalim(state.shape)


def _states(system: TransitionSystem, where: Places, ax: Any) -> None:
    size = max(30.0, 400.0 / math.sqrt(len(system.states)))
    for name, state in system.states.items():
        x, y = where[name]
        color = _color(state.color, state.labels)
        ax.scatter([x], [y], s=size, color=color, edgecolors="#333333", linewidths=0.6, zorder=3)
        words = name + (f"\n{', '.join(sorted(state.labels))}" if state.labels else "")
        ax.annotate(words, (x, y), xytext=(5, 5), textcoords="offset points", fontsize=7, zorder=4)


def _color(given: str | None, labels: frozenset[str]) -> str:
    """The state's colour, a label that names one, or plain grey."""
    from matplotlib.colors import is_color_like  # noqa: PLC0415  (an extra, slow to import)

    for word in (given, *sorted(labels)):
        if word is not None and len(word) > 1 and is_color_like(word):
            return word
    return _PLAIN


def _per_class(duration: Mapping[str, int]) -> str:
    """The range of the durations; every class would not fit on an edge."""
    least, most = min(duration.values()), max(duration.values())
    return str(least) if least == most else f"{least}-{most}"


def _arrow(
    ax: Any,
    begin: tuple[float, float],
    end: tuple[float, float],
    style: str,
    color: Any,
    *,
    bend: float = 0.0,
    width: float = 0.8,
) -> None:
    ax.annotate(
        "",
        end,
        xytext=begin,
        arrowprops={
            "arrowstyle": style,
            "color": color,
            "linewidth": width,
            "shrinkA": 6,
            "shrinkB": 6,
            "connectionstyle": f"arc3,rad={bend}",
        },
    )
