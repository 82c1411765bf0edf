"""How much of each resource lies where: a row for each resource and state, with what is taken.

A row has what lies at the state at every step. The strong band is an execution there that needs
some of it: of what is used up at the step at which it begins, of a tool as long as it runs. The
dashed line is how much of it, and the number beside the triangle, too.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise
from types import MappingProxyType
from typing import Any

import numpy as np

from tsplan.draw import canvas
from tsplan.draw.canvas import DARK, LINE, POINTS, SMALL, SOFT, Entry, Picture
from tsplan.draw.focus import HAPPENED, WHOLE, Focus
from tsplan.draw.palette import pale
from tsplan.draw.row_chart import (
    RowChart,
    foremost,
    height_of_rows,
    profile,
    row_axes,
    row_height,
)
from tsplan.draw.step_axes import (
    CHOSEN,
    HALF,
    MISSED,
    NEED,
    Prepared,
    completed,
    finish_steps,
    shade_steps,
)
from tsplan.errors import Finding, InputError
from tsplan.explanation.why.requirements import runs
from tsplan.explanation.why.stock_lines import StockLine, stock_lines
from tsplan.mission import Mission
from tsplan.plans.plan import Plan
from tsplan.words import number

_ROW = 0.5  # inches of one row
_TALL = 0.6  # of a row, what the largest amount takes
_FLOOR = 0.94  # of a row, where nothing lies
_TOP = 0.16  # of a row, where triangles and what is taken are
_INSIDE = 0.5  # of the largest amount, from which numbers stand below their line
_STOCK = "#2f5f9e"
_LINE = 1.2 * SMALL  # points of a line of words beside a row
_PLANNED = MappingProxyType({"color": pale(_STOCK), "linestyle": "--", "linewidth": 1.0})
_BEGIN = MappingProxyType({"color": DARK, "marker": "v", "markersize": 3.5})
_LITTLE = 1e-6  # amounts that the check does not tell apart


def draw_stocks(plan: Plan, mission: Mission, ax: Any = None, focus: Focus = WHOLE) -> Picture:
    """The chart of every stock that changes or is needed.

    What happened has the bands and numbers, and what was planned is a pale line then. Raises
    InputError for a mission without resources, and PlanError for a plan without paths or of another
    mission.
    """
    return completed(prepare_stocks(plan, mission, ax, focus))


def prepare_stocks(plan: Plan, mission: Mission, ax: Any, focus: Focus) -> Prepared:
    """The same, with what is left to be drawn."""
    if not mission.resources:
        what = "the mission has no resources, which the view 'stocks' shows"
        raise InputError([Finding(what, "look at the paths, or name `resources` in the mission")])
    every, planned = lines_of(plan, mission, focus)
    rows = shown_rows(every)
    hidden = len(every) - len(rows)
    more = f" ({hidden} more)" if hidden else ""
    title = f"{plan.mission.name or mission.name}: what lies where{more}"
    wide = max((_beside_width(row) for row in rows), default=0.0)
    entries = _entries(rows, executed=focus.executed is not None)
    chart = RowChart(title, [row.title for row in rows], entries, _ROW, 0.6, wide)
    figure, ax = row_axes(ax, focus.until(plan), chart)

    def fill() -> None:
        for place, row in enumerate(rows):
            _draw_row(ax, place, row, planned.get((row.state, row.resource.name)))
        finish_steps(ax, focus.step)

    return (figure, ax), fill


def lines_of(
    plan: Plan, mission: Mission, focus: Focus = WHOLE
) -> tuple[list[StockLine], Mapping[tuple[str, str], StockLine]]:
    """The stocks that change or are needed: as it happened, where known, and as it was planned."""
    planned = stock_lines(plan, mission)
    if focus.executed is None:
        return [line for line in planned if line.moves], {}
    happened = stock_lines(focus.executed, mission)
    by_name = {(line.state, line.resource.name): line for line in planned}
    known = [
        line
        for line in happened
        if line.moves or ((old := by_name.get((line.state, line.resource.name))) and old.moves)
    ]
    return known, by_name


def shown_rows(rows: Sequence[StockLine]) -> tuple[StockLine, ...]:
    """The rows in their order; of too many, those that executions need and those with the most."""
    return foremost(rows, lambda row: (not row.uses, -row.amounts.max()))


def height_of(rows: Sequence[StockLine]) -> float:
    """Inches that so many rows take."""
    return height_of_rows(len(rows), _ROW)


def _draw_row(ax: Any, place: int, row: StockLine, planned: StockLine | None) -> None:
    """One stock between `place` (above) and `place + 1` (below), and as it was `planned`."""
    before = planned.amounts if planned is not None else row.amounts
    most = max(row.amounts.max(), row.needs.max(), before.max(), _LITTLE)
    base = place + _FLOOR

    def height(amount: Any) -> Any:
        return base - _TALL * amount / most

    for first, last in runs(np.flatnonzero(row.needs > 0)):
        short = row.needs[first : last + 1] > row.amounts[first : last + 1] + _LITTLE * most
        shade_steps(ax, place, (first, last), MISSED if short.any() else CHOSEN, "execution")
    for lacking in runs(np.flatnonzero(row.amounts < -_LITTLE * most)):
        shade_steps(ax, place, lacking, MISSED, "lacking")
    ax.axhline(base, color=LINE, linewidth=0.5)
    steps, amounts = profile(np.maximum(row.amounts, 0.0))
    ax.fill_between(steps, base, height(amounts), color=_STOCK, alpha=0.28, linewidth=0)
    ax.plot(steps, height(amounts), color=_STOCK, linewidth=1.1, gid="stock")
    if planned is not None:
        steps, amounts = profile(np.maximum(planned.amounts, 0.0))
        ax.plot(steps, height(amounts), gid="planned stock", **_PLANNED)
    needed = np.where(row.needs > 0, height(row.needs), np.nan)
    for step in np.flatnonzero(row.needs > 0):
        ax.plot([step - HALF, step + HALF], [needed[step]] * 2, gid="taken", **NEED)
    _write_amounts(ax, row, most, base)
    _mark_executions(ax, place + _TOP, row)
    if row_height(ax) >= 2 * _LINE:
        _write_beside(ax, base - _TALL / 2, row)


def _write_amounts(ax: Any, row: StockLine, most: float, base: float) -> None:
    """Each amount that lies there for a while, where its number has room."""
    step_points = canvas.extent(ax)[0] / abs(ax.get_xlim()[1] - ax.get_xlim()[0])
    changes = np.flatnonzero(np.diff(row.amounts, prepend=np.nan, append=np.nan))
    for first, after in pairwise(changes.tolist()):
        amount = float(row.amounts[first])
        words = number(round(amount, 6))
        if amount <= 0 or canvas.text_size(words, SMALL)[0] > step_points * (after - first) - 2:
            continue
        inside = amount >= _INSIDE * most
        style = {"va": "top" if inside else "baseline", "fontsize": SMALL, "color": _STOCK}
        ax.annotate(
            words, ((first + after - 1) / 2, base - _TALL * amount / most), ha="center",
            xytext=(0, -1.5 if inside else 1.5), textcoords="offset points", gid="amount", **style,
        )  # fmt: skip


def _mark_executions(ax: Any, y: float, row: StockLine) -> None:
    """A triangle where executions begin, and beside it what they take, if all have room."""
    if not row.begins:
        return
    step_points = canvas.extent(ax)[0] / abs(ax.get_xlim()[1] - ax.get_xlim()[0])
    words = [number(round(taken_at(row, step), 6)) for step in row.begins]
    ends = [*row.begins[1:], len(row.amounts)]
    rooms = [(end - step) * step_points for step, end in zip(row.begins, ends, strict=True)]
    wide = [canvas.text_size(word, SMALL)[0] + 9 for word in words]
    roomy = all(width <= room for width, room in zip(wide, rooms, strict=True))
    for step, word in zip(row.begins, words, strict=True):
        ax.plot([step], [y], gid="begin", **_BEGIN)
        if roomy:
            ax.annotate(
                word, (step, y), xytext=(4, 0), textcoords="offset points", fontsize=SMALL,
                va="center", color=DARK, gid="taking",
            )  # fmt: skip


def taken_at(row: StockLine, step: int) -> float:
    """How much the executions that begin at a step take."""
    name = row.resource.name
    return float(sum(use.needs(name) for use in row.uses if use.first == step))


def _write_beside(ax: Any, y: float, row: StockLine) -> None:
    """What is taken in all, and how much there is at most and at the end, right of the row."""
    for words, shift, paint in zip(beside(row), (0.55, -0.55), (DARK, SOFT), strict=True):
        ax.annotate(
            words, (1.0, y), xycoords=("axes fraction", "data"), xytext=(4, shift * SMALL * 1.2),
            textcoords="offset points", fontsize=SMALL, va="center", color=paint,
            annotation_clip=False,
        )  # fmt: skip


def beside(row: StockLine) -> tuple[str, str]:
    """The two texts right of a row."""
    name = row.resource.name
    taken = ""
    if row.uses and row.resource.consumed:
        taken = f"{number(round(float(sum(use.needs(name) for use in row.uses)), 6))} used up"
    elif row.uses:
        taken = f"{number(round(float(row.needs.max()), 6))} in use"
    peak, end = (number(round(float(amount), 6)) for amount in (row.amounts.max(), row.staying[-1]))
    return taken, f"peak {peak}, end {end}"


def _beside_width(row: StockLine) -> float:
    """Inches that the texts right of a row take."""
    return max(canvas.text_size(text, SMALL)[0] for text in beside(row)) / POINTS + 0.1


def _entries(rows: Sequence[StockLine], *, executed: bool) -> list[Entry]:
    if not rows:
        return []
    short = any((np.maximum(row.needs, 0) > row.amounts + _LITTLE).any() for row in rows)
    used = [
        Entry.line("needed by executions", **NEED),
        Entry.patch("used up, or a tool in use", facecolor=CHOSEN),
        *([Entry.patch("not enough there", facecolor=MISSED)] if short else []),
        Entry.line("an execution begins, and takes", **_BEGIN),
    ]
    return [
        Entry.line(f"lies there{HAPPENED if executed else ''}", color=_STOCK, linewidth=1.1),
        *([Entry.line("lies there, planned", **_PLANNED)] if executed else []),
        *(used if any(row.uses for row in rows) else []),
    ]
