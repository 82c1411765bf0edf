"""What every rule of the tight encoding does: hand requirements on, and choose between options."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from tsplan.encode.count_atoms import Bound
from tsplan.encode.robustness_bound import Outlook
from tsplan.encode.selection import ALWAYS, Choices, Literal, Relay
from tsplan.encode.step_runs import Span, by_column, by_step, joined
from tsplan.logic import Formula
from tsplan.milp.model import Ints


@dataclass(frozen=True, slots=True)
class Demand:
    """`bound` must hold at `step` where `literal` is 1."""

    bound: Bound
    step: int
    literal: Literal


@dataclass(frozen=True, slots=True)
class Lasting:
    """`bound` must hold at the steps `first .. last` where `literal` is 1."""

    bound: Bound
    first: int
    last: int
    literal: Literal


@dataclass(frozen=True, eq=False)
class Cover:
    """At least one of `columns[begin:end]` is 1 where `literal` is 1 (F under an always)."""

    columns: Ints
    begin: int
    end: int
    literal: Literal


@dataclass(frozen=True, slots=True)
class Visit:
    """One agent of `bound` must be there at some step of `first .. last` where `literal` is 1."""

    bound: Bound
    first: int
    last: int
    literal: Literal


@dataclass(eq=False)
class Witnesses:
    """What a formula asks of the agents, as demands under literals."""

    choices: Choices
    lasting: list[Lasting] = field(default_factory=list)
    covers: list[Cover] = field(default_factory=list)
    visits: list[Visit] = field(default_factory=list)

    @cached_property
    def demands(self) -> list[Demand]:
        """What is demanded step by step, exclusive literals added up."""
        asked: dict[Bound, list[Span]] = defaultdict(list)
        for need in self.lasting:
            asked[need.bound].append(Span(need.first, need.last, need.literal))
        return [
            Demand(bound, step, literal)
            for bound, spans in asked.items()
            for step, literals in by_step(joined(spans), self.choices).items()
            for literal in literals
        ]


class Asker:
    """Gathers what is required of each formula, under the literals of one set of choices."""

    def __init__(self, choices: Choices, outlook: Outlook) -> None:
        self._requests: dict[Formula, list[Span]] = defaultdict(list)
        self.choices = choices
        self.outlook = outlook

    def ask(self, node: Formula, span: Span) -> None:
        """Require a formula at all steps of a span; what cannot hold refutes the literal."""
        if self.outlook.possible_throughout(node, span.first, span.last):
            self._requests[node].append(span)
        else:
            self.choices.refute(span.literal, "impossible")

    def asked(self, node: Formula) -> list[Span]:
        """Everything that is required of a formula by those that have it as a part."""
        return joined(self._requests.pop(node, []))

    def options(self, literal: Literal, steps: Sequence[int], kind: str) -> list[Literal]:
        """One literal per option, by the steps they begin; a single one needs no column."""
        if not steps:
            self.choices.refute(literal, kind)
            return []
        if len(steps) == 1:
            return [literal]
        return [(column,) for column in self.choices.choose(literal, list(steps), kind).tolist()]

    def each(self, spans: Sequence[Span]) -> list[tuple[int, Literal]]:
        """Every step with each of its literals, exclusive ones added up."""
        found = by_step(spans, self.choices)
        return [(step, literal) for step, literals in found.items() for literal in literals]

    def families(self, once: Sequence[Span]) -> list[list[Span]]:
        """Spans of one column each, in families that exclude each other; `ALWAYS` on its own."""
        by_column = {span.literal[0]: span for span in once if span.literal}
        families = self.choices.families(by_column)
        found = [sorted(by_column[column] for column in family) for family in families]
        return [*([span] for span in once if not span.literal), *found]

    def relayed(
        self, family: Sequence[Span], window: Ints, times: Sequence[int], kind: str
    ) -> list[tuple[int, Literal]]:
        """One witness at one of `times` for the spans of a family, each in a window of its own."""
        low, high = window.T
        served = np.searchsorted(times, low) < np.searchsorted(times, high, side="right")
        for place in np.flatnonzero(~served).tolist():
            self.choices.refute(family[place].literal, kind)
        if not served.any():
            return []
        literals = [family[place].literal for place in np.flatnonzero(served).tolist()]
        parents = tuple(column for literal in literals for column in literal)
        low, high = low[served], high[served]
        if len(times) == 1 or (low[0] == low[-1] and high[0] == high[-1]):
            options = self.options(parents, times, kind)
        else:
            columns = np.array(parents, dtype=np.int64)
            each = [len(literal) for literal in literals]
            spread = np.repeat(low, each), np.repeat(high, each)
            waiting = Relay(columns, *spread, np.array(times, dtype=np.int64))
            options = [(column,) for column in self.choices.relay(waiting, kind).tolist()]
        return list(zip(times, options, strict=True))

    def union(self, runs: Iterable[tuple[int, int]]) -> list[int]:
        """The steps of several runs, in order, each once."""
        found = joined(Span(first, last, ALWAYS) for first, last in runs)
        return [step for first, last, _ in found for step in range(first, last + 1)]


def sorted_out(spans: Iterable[Span]) -> tuple[list[Span], dict[Literal, list[Span]]]:
    """Columns that ask at one step only, and the spans of those that ask at several."""
    asked: dict[Literal, list[Span]] = defaultdict(list)
    for span in by_column(spans):
        asked[span.literal].append(span)
    once = [runs[0] for runs in asked.values() if len(runs) == 1 and runs[0].first == runs[0].last]
    again = {
        literal: runs
        for literal, runs in asked.items()
        if len(runs) > 1 or runs[0].first < runs[0].last
    }
    return once, again
