"""An explanation for people: the formula with its conflicting parts marked, a table of changes."""

from __future__ import annotations

from dataclasses import astuple, dataclass, field
from textwrap import wrap
from typing import TYPE_CHECKING

from tsplan.explanation.explanation import (
    Change,
    Conflict,
    Cut,
    Explanation,
    Fact,
    Found,
    Likely,
    Part,
    Status,
)
from tsplan.logic.text import number_text
from tsplan.words import visible

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from rich.console import Console

    from tsplan.signals.result_check import AnyMission


WIDTH = 100
"""Columns of an explanation where there is no terminal to ask."""

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
_TITLES = {
    "facts": "facts that forbid every plan:",
    "tight": "what is tight:",
    "changes": "changes after which there is a plan:",
    "likely conflict": "likely in the way, not proven:",
    "likely change": "likely to help, not proven:",
}
_ROOM, _ROOM_OF_REALS = 23, 28  # columns of a table of changes beside their words
_STAGES = {
    "facts": "there may be more facts",
    "conflicts": "there may be other conflicts, or smaller ones",
    "changes": "there may be more changes, or smaller ones",
    "tight": "more may be tight",
    "slack": "there may be more slack",
}


def print_explanation(explanation: Explanation, mission: AnyMission, console: Console) -> None:
    """Print everything that an explanation says."""
    report = Report(mission, console, several=len(explanation.conflicts) > 1)
    for line in report.lines_until(explanation):
        report.say(line)


def explanation_words(explanation: Explanation, mission: AnyMission) -> str:
    """The same as one text, of `WIDTH` columns."""
    lines = lines_of(explanation, mission, WIDTH)
    return "\n".join(visible(line, "\n") for line in lines)


def lines_of(explanation: Explanation, mission: AnyMission, width: int) -> Iterator[str]:
    """The same, line by line; sentences are folded to a width."""
    from rich.console import Console  # noqa: PLC0415  (slow to import)

    several = len(explanation.conflicts) > 1
    return Report(mission, Console(width=width), several=several).lines_until(explanation)


@dataclass(eq=False)
class Report:
    """Prints what is found while it is found, each kind below a title of its own.

    With `several` conflicts they are numbered. `tell` is made to be heard by `explain`:

    >>> import io
    >>> import tsplan
    >>> from rich.console import Console
    >>> from tsplan.explanation.report import Report
    >>> mission, printed = tsplan.load_mission("mission.yaml"), io.StringIO()
    >>> report = Report(mission, Console(file=printed, width=80))
    >>> made = tsplan.explain(mission, on_found=report.tell)
    >>> printed.getvalue().splitlines()[0].endswith("there is a plan")
    True
    >>> report.finish(made)  # what is likely, what was cut short, and how long it took
    """

    mission: AnyMission
    console: Console
    several: bool = False
    known: Explanation = field(init=False)
    _headed: bool = field(default=False, init=False)
    _title: str = field(default="", init=False)

    def __post_init__(self) -> None:
        self.known = Explanation(Status.NO_ANSWER, self.mission.name)

    def say(self, line: str) -> None:
        """Print a line, and do not hold it back."""
        self.console.out(visible(line, "\n"), highlight=False)

    def tell(self, item: Found) -> None:
        """Print something that was found."""
        for line in self.lines(item):
            self.say(line)

    def finish(self, explanation: Explanation) -> None:
        """Print what is said at the end alone."""
        for line in self.last_lines(explanation):
            self.say(line)

    def lines_until(self, explanation: Explanation) -> Iterator[str]:
        """All lines of an explanation."""
        known = explanation.facts, explanation.conflicts, _as_found(explanation)
        told: tuple[Found, ...] = (*known[0], *known[1], *known[2])
        if explanation.status is not Status.NO_ANSWER:
            yield from self.lines(explanation.status)
        for item in told:
            yield from self.lines(item)
        yield from self.last_lines(explanation)

    def lines(self, item: Found) -> Iterator[str]:
        """What is said of something that was found; of what is likely, nothing before the end."""
        self.known = self.known.with_found(item)
        width = self.console.width
        match item:
            case Status():
                self._headed = True
                yield from _outcome(self.mission, item, "")
            case Fact():
                feasible = self.known.status is Status.FEASIBLE
                yield from self._below("tight" if feasible else "facts")
                yield from _folded(item, width)
            case Conflict():
                self._title = ""
                yield f"\n{_conflict_title(item, len(self.known.conflicts) * self.several)}"
                yield from _conflict_lines(self.mission, item, width)
            case Change():
                if self._title != "changes":
                    yield from self._below("changes")
                    yield _row(("fix", "change", "by", "least"), self._room)
                yield from _change_lines(item, self._room)

    @property
    def _room(self) -> int:
        """Columns for the words of a change; of real numbers it is said how exact a proof is."""
        team = hasattr(self.mission, "team")
        return max(self.console.width - (_ROOM if team else _ROOM_OF_REALS), _ROOM)

    def _below(self, title: str) -> Iterator[str]:
        if title != self._title:
            self._title = title
            yield f"\n{_TITLES[title]}"

    def last_lines(self, explanation: Explanation) -> Iterator[str]:
        """What is likely, the order of the changes, what was cut short, and the time."""
        if not self._headed:
            yield from _outcome(self.mission, explanation.status, _why_open(explanation))
        amounts = [change.amount for change in _as_found(explanation)]
        if amounts != sorted(amounts):
            yield f"\nthe smallest first: {', '.join(str(c.fix) for c in explanation.changes)}"
        for item in explanation.likely:
            yield from self._below(f"likely {item.kind}")
            yield from _folded(item, self.console.width)
        for line in _shortened(explanation):
            yield f"\n{line}"
        yield f"\n  {explanation.timings.get('total', 0.0):.2f} s"


def _as_found(explanation: Explanation) -> list[Change]:
    """The changes in the order in which they were found."""
    return sorted(explanation.changes, key=lambda item: item.fix)


def _why_open(explanation: Explanation) -> str:
    """Why it stays open whether there is a plan."""
    if explanation.status is not Status.NO_ANSWER:
        return ""
    why = {*explanation.cut.values()} & {"interrupt", "precision"}
    return f"; {_REASONS[min(why)]}" if why else "; try a longer time limit"


def _outcome(mission: AnyMission, status: Status, why: str) -> Iterator[str]:
    yield f"{mission.name or 'mission'}: {_OUTCOME[status]}{why}"
    if mission.partial and status is Status.EXPLAINED:
        yield "  by which all of it holds; `tsplan plan` does as much of it as can be done"


def _shortened(explanation: Explanation) -> Iterator[str]:
    """What was cut short, and why, a line for each reason."""
    if explanation.status is Status.NO_ANSWER:
        return  # the outcome says so
    for reason, words in _REASONS.items():
        found = [_STAGES[stage] for stage, why in explanation.cut.items() if why == reason]
        if found:
            yield f"{words}: {'; '.join(found)}"


def _conflict_title(conflict: Conflict, number: int) -> str:
    which = f"conflict {number}" if number else "conflict"
    which = f"certified {which}" if conflict.certified else which
    if not conflict.minimal:
        return f"{which}: these cannot hold together (likely not all of them: not proven minimal)"
    if len(conflict.parts) == 1:
        return f"{which}: this alone cannot hold"
    return f"{which}: these cannot hold together, and without any one of them the rest can"


def _conflict_lines(mission: AnyMission, conflict: Conflict, width: int) -> Iterator[str]:
    text = mission.text if mission.origin is None else mission.origin.content
    yield from _marked(text, [part for part in conflict.parts if part.kind == "formula"])
    for part in conflict.parts:
        if part.kind != "formula":
            yield from _folded(part, width)


def _folded(item: Fact | Part | Likely, width: int) -> list[str]:
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


def _change_lines(change: Change, room: int) -> Iterator[str]:
    """A change as lines of a table."""
    sure = "proven" if change.proven else "not proven"
    if change.proven and change.within < 1:
        sure = f"{sure} to {number_text(change.within)}"
    first, *more = wrap(visible(change.text), room, break_on_hyphens=False) or [""]
    yield _row((str(change.fix or 1), first, number_text(change.amount), sure), room)
    for line in more:
        yield _row(("", line, "", ""), room)


def _row(cells: tuple[str, str, str, str], room: int) -> str:
    fix, change, by, least = cells
    return f"{fix:>3}  {change:<{room}}  {by:>4}  {least}".rstrip()
