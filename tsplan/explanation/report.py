"""An explanation for people: the formula with its conflicting parts marked, a table of changes."""

from __future__ import annotations

from dataclasses import astuple
from textwrap import wrap
from typing import TYPE_CHECKING

from tsplan.explanation.explanation import (
    Conflict,
    Cut,
    Explanation,
    Fact,
    Part,
    Status,
)
from tsplan.logic.text import number_text
from tsplan.words import visible

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from rich.console import Console
    from rich.table import Table

    from tsplan.signals.result_check import AnyMission


_OUTCOME = {
    Status.EXPLAINED: "there is no plan",
    Status.FEASIBLE: "there is a plan",
    Status.NO_ANSWER: "whether there is a plan stays open",
}
_REASONS: dict[Cut, str] = {
    "interrupt": "it was interrupted",
    "time_limit": "the time was up",
    "memory": "memory was short",
    "precision": "the solver was not precise enough",
    "patience": "some questions took too long",
}
_STAGES = {
    "facts": "there may be more facts",
    "conflicts": "there may be other conflicts, or smaller ones",
    "changes": "there may be more changes, or smaller ones",
    "tight": "more may be tight",
    "slack": "there may be more slack",
}


def print_explanation(explanation: Explanation, mission: AnyMission, console: Console) -> None:
    """Print everything that an explanation says."""
    for line in lines_of(explanation, mission, console.width):
        console.out(visible(line, "\n"), highlight=False)
    if explanation.changes:
        console.out("\nchanges after which there is a plan:", highlight=False)
        with console.capture() as text:
            console.print(_changes(explanation), highlight=False, markup=False)
        for line in text.get().splitlines():
            console.out(line.rstrip(), highlight=False)
    for line in _shortened(explanation):
        console.out(f"\n{line}", highlight=False)
    console.out(f"\n  {explanation.timings.get('total', 0.0):.2f} s", highlight=False)


def _shortened(explanation: Explanation) -> Iterator[str]:
    """What was cut short, and why, a line for each reason."""
    if explanation.status is Status.NO_ANSWER:
        return  # the outcome says so
    for reason, words in _REASONS.items():
        found = [_STAGES[stage] for stage, why in explanation.cut.items() if why == reason]
        if found:
            yield f"{words}: {'; '.join(found)}"


def lines_of(explanation: Explanation, mission: AnyMission, width: int) -> Iterator[str]:
    """Outcome, facts and conflicts, line by line; sentences are folded to a width."""
    outcome = _OUTCOME[explanation.status]
    if explanation.status is Status.NO_ANSWER:
        why = {*explanation.cut.values()} & {"interrupt", "precision"}
        outcome += f"; {_REASONS[min(why)]}" if why else "; try a longer time limit"
    yield f"{explanation.name or 'mission'}: {outcome}"
    if mission.partial and explanation.status is Status.EXPLAINED:
        yield "  by which all of it holds; `tsplan plan` does as much of it as can be done"
    if explanation.facts:
        feasible = explanation.status is Status.FEASIBLE
        yield "\nwhat is tight:" if feasible else "\nfacts that forbid every plan:"
        for fact in explanation.facts:
            yield from _folded(fact, width)
    text = mission.text if mission.origin is None else mission.origin.content
    for number, conflict in enumerate(explanation.conflicts, start=1):
        yield f"\n{_title(conflict, number, explanation)}"
        yield from _marked(text, [part for part in conflict.parts if part.kind == "formula"])
        for part in conflict.parts:
            if part.kind != "formula":
                yield from _folded(part, width)


def _title(conflict: Conflict, number: int, explanation: Explanation) -> str:
    which = f"conflict {number}" if len(explanation.conflicts) > 1 else "conflict"
    if not conflict.minimal:
        why = _REASONS[explanation.cut.get("conflicts", "patience")]
        return f"{which}: these cannot hold together (not proven minimal: {why})"
    if len(conflict.parts) == 1:
        return f"{which}: this alone cannot hold"
    return f"{which}: these cannot hold together, and without any one of them the rest can"


def _folded(item: Fact | Part, width: int) -> list[str]:
    """A sentence with its place, its further lines indented."""
    place = item.place
    return wrap(
        f"{'' if place.line is None else f'{place.line}:{place.column}: '}{item.text}",
        width,
        initial_indent="  ",
        subsequent_indent="      ",
        break_long_words=False,
        break_on_hyphens=False,
    )


def _marked(content: str, parts: Sequence[Part]) -> Iterator[str]:
    """The lines of a text that parts stand in, each with a line of marks below."""
    lines = content.splitlines()
    marks: dict[int, set[int]] = {}
    for part in parts:
        line, column, end_line, end_column = astuple(part.place)
        if line is None or end_line is None:
            yield f"  {part.text}"
            continue
        for number in range(line, min(end_line, len(lines)) + 1):
            text = lines[number - 1]
            first = column if number == line else len(text) - len(text.lstrip()) + 1
            last = end_column if number == end_line else len(text.rstrip()) + 1
            marks.setdefault(number, set()).update(range(first or 1, last or 1))
    width = len(str(max(marks, default=0)))
    for number in sorted(marks):
        text = lines[number - 1]
        below = "".join("^" if n in marks[number] else " " for n in range(1, len(text) + 1))
        yield f"  {number:>{width}} | {text}"
        yield f"  {'':>{width}} | {below.rstrip()}"


def _changes(explanation: Explanation) -> Table:
    from rich.table import Table  # noqa: PLC0415  (slow to import)
    from rich.text import Text  # noqa: PLC0415

    table = Table(box=None, pad_edge=False, show_edge=False, padding=(0, 1))
    table.add_column("fix", justify="right")
    table.add_column("change", overflow="fold", ratio=1)
    table.add_column("by", justify="right")
    table.add_column("least")
    for number, change in enumerate(explanation.changes, start=1):
        sure = "proven" if change.proven else "not proven"
        if change.proven and change.within < 1:
            sure = f"{sure} to {number_text(change.within)}"
        cells = (str(number), visible(change.text), number_text(change.amount), sure)
        table.add_row(*map(Text, cells))  # as a text, no part of it is read as rich's own marks
    return table
