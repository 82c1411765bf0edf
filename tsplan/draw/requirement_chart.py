"""What the formula asks and what the plan gives: a row for each atom, count against need.

The pale band is when the formula can ask for the atom, the strong one when the plan satisfies the
formula by it, and red where it comes nearest to that but fails; a triangle marks where such a run
begins. The dashed line is the need.
"""

from __future__ import annotations

from collections.abc import Sequence
from types import MappingProxyType
from typing import Any

from tsplan.draw import canvas
from tsplan.draw.canvas import DARK, LINE, POINTS, SMALL, SOFT, Entry, Picture
from tsplan.draw.focus import HAPPENED, WHOLE, Focus
from tsplan.draw.palette import BAD, GOOD, pale
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
    MISSED,
    NEED,
    WINDOW,
    Prepared,
    completed,
    finish_steps,
    shade_steps,
)
from tsplan.explanation.why.requirements import Requirement, measured, trace_of
from tsplan.mission import Mission
from tsplan.plans.plan import Plan
from tsplan.words import number

_ROW = 0.42  # inches of one row
_TALL = 0.78  # of a row, what the largest count takes
_COUNT = "#2f5f9e"
_LINE = 1.2 * SMALL  # points of a line of words beside a row
_PLANNED = MappingProxyType({"color": pale(_COUNT), "linestyle": "--", "linewidth": 1.0})
_WITNESS = MappingProxyType({"color": DARK, "marker": "v", "markersize": 3.5})


def draw_requirements(
    plan: Plan, mission: Mission, ax: Any = None, focus: Focus = WHOLE
) -> Picture:
    """The chart of all atoms of the mission's goal and of what it prefers.

    Where it is known what happened, it is that which is judged, and what was planned is a pale
    line. Raises PlanError for a plan without paths or of another mission.
    """
    return completed(prepare_requirements(plan, mission, ax, focus))


def prepare_requirements(plan: Plan, mission: Mission, ax: Any, focus: Focus) -> Prepared:
    """The same, with what is left to be drawn."""
    every = (focus.executed or plan).requirements(mission)
    rows = shown_rows(every)
    hidden = len(every) - len(rows)
    more = f" ({hidden} more with agents to spare)" if hidden else ""
    title = f"{plan.mission.name or mission.name}: count against need{more}"
    wide = max((_beside(row)[2] for row in rows), default=0.0)
    planned = [planned_counts(plan, mission, row) if focus.executed else None for row in rows]
    entries = _entries(rows, executed=focus.executed is not None)
    chart = RowChart(title, [row.title for row in rows], entries, _ROW, 0.55, wide)
    figure, ax = row_axes(ax, focus.until(plan), chart)

    def fill() -> None:
        for place, (row, counts) in enumerate(zip(rows, planned, strict=True)):
            _draw_row(ax, place, row, counts)
        finish_steps(ax, focus.step)

    return (figure, ax), fill


def planned_counts(plan: Plan, mission: Mission, row: Requirement) -> Any:
    """What a plan gives at every step of what a row of another plan counts."""
    return measured(row.atom, trace_of(plan, mission, row.atom))


def shown_rows(rows: Sequence[Requirement]) -> tuple[Requirement, ...]:
    """The rows in the order of the formula; of too many, those with the least to spare."""
    return foremost(rows, lambda row: (row.slack is None, row.slack or 0.0))


def height_of(rows: Sequence[Requirement]) -> float:
    """Inches that so many rows take."""
    return height_of_rows(len(rows), _ROW)


def _draw_row(ax: Any, place: int, row: Requirement, planned: Any) -> None:
    """One atom between `place` (above) and `place + 1` (below), and perhaps what was `planned`."""
    before = row.counts if planned is None else planned
    most = max(int(row.counts.max()), int(before.max()), row.bound, 1)
    base = place + 0.94

    def height(count: Any) -> Any:
        return base - _TALL * count / most

    for first, last in row.windows:
        shade_steps(ax, place, (first, last), WINDOW, "window")
    paint, meaning = (MISSED, "missed") if _fails(row) else (CHOSEN, "chosen")
    for first, last in row.witness_steps:
        shade_steps(ax, place, (first, last), paint, meaning)
        ax.plot([first], [place + 0.1], gid="witness", **_WITNESS)
    ax.axhline(base, color=LINE, linewidth=0.5)
    steps, counts = profile(row.counts)
    ax.fill_between(steps, base, height(counts), color=_COUNT, alpha=0.28, linewidth=0)
    ax.plot(steps, height(counts), color=_COUNT, linewidth=1.1, gid="count")
    if planned is not None:
        steps, counts = profile(planned)
        ax.plot(steps, height(counts), gid="planned count", **_PLANNED)
    ends = ax.get_xlim()
    ax.plot(ends, [height(row.bound)] * 2, gid="need", **NEED)
    if row_height(ax) >= 2 * _LINE:
        _write_spare(ax, base - _TALL / 2, row)


def _fails(row: Requirement) -> bool:
    return row.slack is not None and row.slack < 0


def _write_spare(ax: Any, y: float, row: Requirement) -> None:
    """How many agents there are to spare, and the largest count, right of the row."""
    spare, most, _ = _beside(row)
    colour = SOFT if row.slack is None else (GOOD if row.slack >= 0 else BAD)
    for words, shift, paint in ((spare, -0.55, colour), (most, 0.55, SOFT)):
        ax.annotate(
            words, (1.0, y), xycoords=("axes fraction", "data"), xytext=(4, -shift * SMALL * 1.2),
            textcoords="offset points", fontsize=SMALL, va="center", color=paint,
            annotation_clip=False,
        )  # fmt: skip


def _beside(row: Requirement) -> tuple[str, str, float]:
    """The two texts right of a row, and the inches they take."""
    spare = row.slack
    if spare is None:
        words = "not used"
    else:
        size = number(round(abs(spare), 2))
        words = f"{size} to spare" if spare >= 0 else f"{size} missing"
    most = f"peak {number(round(float(row.counts.max()), 2))}"
    wide = max(canvas.text_size(text, SMALL)[0] for text in (words, most))
    return words, most, wide / POINTS + 0.1


def _entries(rows: Sequence[Requirement], *, executed: bool) -> list[Entry]:
    if not rows:
        return []
    failing = [_fails(row) for row in rows]
    return [
        Entry.line(f"agents counted{HAPPENED if executed else ''}", color=_COUNT, linewidth=1.1),
        *([Entry.line("agents counted, planned", **_PLANNED)] if executed else []),
        Entry.line("need", **NEED),
        Entry.patch("can be asked for", facecolor=WINDOW),
        *([] if all(failing) else [Entry.patch("satisfied here", facecolor=CHOSEN)]),
        *([Entry.patch("missed here", facecolor=MISSED)] if any(failing) else []),
        Entry.line("witness", **_WITNESS),
    ]
