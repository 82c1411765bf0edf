"""How long the runs of a sweep took, by the values of each axis."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence
from statistics import median
from types import MappingProxyType
from typing import Any

from tsplan.draw.matplotlib_loading import library
from tsplan.errors import Finding, InputError
from tsplan.exact_json import canonical
from tsplan.limits import is_number
from tsplan.sweeps.sweep_rows import SweepRow
from tsplan.sweeps.sweep_summary import shown_value, varied_axes

MOST_AXES = 6
"""Axes that are drawn, one beside the other."""

_WIDE, _HIGH = 4.2, 3.6  # inches for each axis
_ACROSS = 3  # axes in a row
_LEAST = 6.0  # inches, for the legend
_FEW = 8  # numbers that are all written below the axis
_BARS = MappingProxyType({"linestyle": "", "marker": "_", "markersize": 18})  # of what is no number
_LONGEST = 24  # letters of a value below the axis
_COLOURS = {
    "optimal": "#2f5f9e",
    "feasible": "#c98a1b",
    "infeasible": "#7a4f9a",
    "no_plan_found": "#8a8a8a",
    "failed": "#b23b3b",
}


def draw_sweep(rows: Sequence[SweepRow]) -> tuple[Any, list[Any]]:
    """Seconds of each run by the values of each axis, a line through their medians.

    Numbers stand where they belong on their axis, other values side by side. Returns the figure
    and its axes. Raises InputError without any row, PlotUnavailableError without matplotlib.
    """
    if not rows:
        raise InputError([Finding("there is no result to draw", "let some runs end first")])
    axes = varied_axes(rows)[:MOST_AXES]
    across = min(len(axes), _ACROSS)
    down = -(-len(axes) // across)
    size = (max(_WIDE * across, _LEAST), _HIGH * down)
    figure = library("figure").Figure(figsize=size, layout="constrained")
    fields = list(figure.subplots(down, across, squeeze=False, sharey=True).flat)
    handles: dict[str, Any] = {}
    for place, ax in enumerate(fields):
        if place >= len(axes):
            ax.remove()
            continue
        _draw_axis(ax, axes[place], [row for row in rows if axes[place] in row.axes])
        ax.set_yscale("log")
        if place % across == 0:
            ax.set_ylabel("seconds of a run")
        handles.update({label: handle for handle, label in zip(*_legend(ax), strict=True)})
    figure.legend(
        handles.values(), handles, loc="outside upper center", ncols=len(handles), frameon=False
    )
    return figure, fields[: len(axes)]


def _legend(ax: Any) -> tuple[list[Any], list[str]]:
    handles, labels = ax.get_legend_handles_labels()
    return handles, labels


def _draw_axis(ax: Any, axis: str, rows: Sequence[SweepRow]) -> None:
    """The dots of one axis, coloured by how the runs ended."""
    values = {canonical(row.axes[axis]): row.axes[axis] for row in rows}
    numeric = all(map(is_number, values.values()))
    keys = sorted(values, key=values.__getitem__) if numeric else list(values)
    places = {key: values[key] if numeric else n for n, key in enumerate(keys)}
    dots: dict[str, list[tuple[float, float]]] = defaultdict(list)
    times: dict[str, list[float]] = defaultdict(list)
    for row in rows:
        key, seconds = canonical(row.axes[axis]), row.get("seconds.wall")
        if seconds is not None:
            dots["failed" if row.failed else str(row["status"])].append((places[key], seconds))
            if not row.failed:
                times[key].append(seconds)
    middle = [(places[key], median(times[key])) for key in keys if times[key]]
    if middle:
        look = {"color": "#555555", "linewidth": 1, "label": "median (but for failed)"}
        ax.plot(*zip(*middle, strict=True), **(look if numeric else {**look, **_BARS}))
    for end, colour in _COLOURS.items():
        if dots[end]:
            x, y = zip(*dots[end], strict=True)
            ax.scatter(x, y, s=18, color=colour, alpha=0.7, label=end, zorder=3)
    ax.set_xlabel(shown_value(axis))
    if numeric and len(keys) <= _FEW:
        ax.set_xticks([values[key] for key in keys])
    if not numeric:
        names = [shown_value(values[key])[:_LONGEST] for key in keys]
        ax.set_xticks(range(len(keys)), names, rotation=30, ha="right", fontsize=8)
    ax.spines[["top", "right"]].set_visible(False)
