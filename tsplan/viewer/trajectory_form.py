"""How trajectories show themselves in a notebook: facts, and signals over time as SVG."""

from __future__ import annotations

from itertools import chain
from typing import TYPE_CHECKING, Any

from tsplan.draw.palette import paints
from tsplan.plans.summary import outcome
from tsplan.signals.trajectory_summary import trajectory_facts
from tsplan.viewer import svg
from tsplan.viewer.notebook import facts_table, step_numbers
from tsplan.words import number

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from tsplan.signals.trajectory import Trajectory, Values

MOST_ROWS = 12
"""Signals and controls that are drawn."""

_WIDTH = 640.0
_ROW, _GAP = 44.0, 10.0  # pixels of one signal, and between two
_SMALL = 9.0


def trajectory_html(trajectory: Trajectory) -> str:
    """A trajectory: what is known about it, and its signals over time."""
    facts = [
        ("mission", trajectory.mission.name or "signals"),
        ("outcome", outcome(trajectory, "trajectory")),
    ]
    if trajectory.has_signals:
        facts += [("value", fact) for fact in trajectory_facts(trajectory)]
    facts.append(("horizon", f"{trajectory.horizon} steps"))
    facts += [("note", note) for note in trajectory.notes]
    drawn = signals_svg(trajectory) if trajectory.has_signals else ""
    return svg.element("div", facts_table(facts) + drawn)


def signals_svg(trajectory: Trajectory) -> str:
    """Each signal, then each control, in a row of its own with its least and greatest value."""
    every = list(chain(trajectory.signals.items(), trajectory.controls.items()))
    every = [(name, row) for name, row in every if row]
    rows, hidden = every[:MOST_ROWS], every[MOST_ROWS:]
    colours = paints(name for name, _ in rows)
    ends = {name: (number(min(row)), number(max(row))) for name, row in rows}
    left = max(svg.width_of(name) for name, _ in rows) + 12
    left += max(svg.width_of(word, _SMALL) for pair in ends.values() for word in pair) + 8
    step = (_WIDTH - left - 20) / max(1, trajectory.horizon)
    parts: list[str] = []
    for place, (name, row) in enumerate(rows):
        top = 12 + place * (_ROW + _GAP)
        box = (left, top, step)
        parts += _row(row, box, colours[name].colour, control=name in trajectory.controls)
        parts.append(svg.text(name, 4, top + _ROW / 2 + 4))
        for word, y in zip(ends[name], (top + _ROW + 3, top + 6), strict=True):
            if word != ends[name][0] or y > top + _ROW:
                parts.append(svg.text(word, left - 6, y, _SMALL, text_anchor="end"))
    bottom = 12 + len(rows) * (_ROW + _GAP)
    parts += step_numbers(trajectory.horizon, left - step / 2, step, bottom)
    if hidden:
        parts.append(svg.text(f"... and {len(hidden):,} more", 4, bottom + 28))
    title = f"{trajectory.mission.name}: signals over time"
    return svg.picture(parts, _WIDTH, bottom + (36 if hidden else 18), title)


def _row(
    row: Values, box: tuple[float, float, float], colour: str, *, control: bool
) -> Iterator[str]:
    """The line of one signal in its row, on a ground line; a control lasts until the next step."""
    left, top, step = box
    low, high = min(row), max(row)
    scale = _ROW / ((high - low) or 1.0)

    def points(values: Sequence[float]) -> Iterator[str]:
        for number_, value in enumerate(values):
            x, y = left + number_ * step, top + _ROW - (value - low) * scale
            yield f"{x:.1f} {y:.1f}"
            if control:
                yield f"{x + step:.1f} {y:.1f}"

    ground = f"M{left:.1f} {top + _ROW:.1f}h{(len(row) - (not control)) * step:.1f}"
    yield svg.element("path", d=ground, stroke="#d0d0d0", stroke_width=0.7)
    look: dict[str, Any] = {"stroke": colour, "stroke_width": 1.8, "fill": "none"}
    yield svg.element("path", d="M" + "L".join(points(row)), stroke_linejoin="round", **look)
