"""A trajectory in words, for people."""

from __future__ import annotations

from textwrap import shorten
from typing import TYPE_CHECKING

from tsplan.plans.summary import objective_line, outcome, proof_lines, seen, text_of, work_lines
from tsplan.words import known, number

if TYPE_CHECKING:
    from collections.abc import Iterator

    from tsplan.signals.trajectory import PartValue, Trajectory

MOST_PARTS, MOST_SIGNALS = 40, 40
"""Parts of a formula, and signals, that are listed; the rest is only counted."""

_LONGEST = 80  # letters of a part


def trajectory_lines(trajectory: Trajectory) -> list[str]:
    """The lines of a trajectory's summary: outcome, objectives, parts, signals, work."""
    name = trajectory.mission.name or "signals"
    title = f"{name}: {outcome(trajectory, 'trajectory')}"
    lines = [title, *(f"  {note}" for note in trajectory.notes)]
    if trajectory.has_signals:
        lines += [f"  {fact}" for fact in trajectory_facts(trajectory)]
        lines += proof_lines(trajectory.objective)
        lines += [*_part_lines(trajectory.parts), "", *_signal_lines(trajectory), ""]
    return [*seen(lines), *work_lines(trajectory)]


def trajectory_words(trajectory: Trajectory) -> str:
    """The summary as one text."""
    return text_of(trajectory_lines(trajectory))


def trajectory_facts(trajectory: Trajectory) -> Iterator[str]:
    """What the trajectory is worth: its objectives, robustness of both kinds, what holds of it."""
    yield from (objective_line(item, noun="trajectory") for item in trajectory.objective)
    told = {item.name for item in trajectory.objective}
    if "robustness" not in told:
        yield f"robustness {number(trajectory.robustness, 'unbounded')}"
    if trajectory.agm is not None:
        yield f"arithmetic-geometric mean robustness {number(trajectory.agm)}"
    for name in ("fraction", "preference"):
        value = getattr(trajectory, name)
        if value is not None:
            yield f"{'satisfied' if name == 'fraction' else name} {number(value)}"


def _part_lines(parts: tuple[PartValue, ...]) -> Iterator[str]:
    """Each part with its robustness, or how much of it holds."""
    for part in parts[:MOST_PARTS]:
        slack = known(part.robustness)
        words = f"robustness {number(slack, 'unbounded')}"
        if part.fraction < 1:
            words = f"{number(part.fraction)} met, {words}" if part.fraction else f"fails, {words}"
        yield f"    {shorten(part.text, _LONGEST, placeholder=' ...')}: {words}"
    if len(parts) > MOST_PARTS:
        yield f"    ... and {len(parts) - MOST_PARTS:,} more parts"


def _signal_lines(trajectory: Trajectory) -> Iterator[str]:
    """Where every signal and control begins and ends, and between what it stays."""
    rows: list[tuple[str, ...]] = [("", "begins", "ends", "least", "greatest")]
    for name, row in [*trajectory.signals.items(), *trajectory.controls.items()]:
        if row:
            ends = (row[0], row[-1], min(row), max(row))
            rows.append((name, *(f"{value:.6g}" for value in ends)))
    hidden, rows = rows[MOST_SIGNALS + 1 :], rows[: MOST_SIGNALS + 1]
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    for name, *values in rows:
        cells = (value.rjust(width) for value, width in zip(values, widths[1:], strict=True))
        yield "  ".join(["", name.ljust(widths[0]), *cells])
    if hidden:
        yield f"  ... and {len(hidden):,} more; the JSON trajectory has them all"
