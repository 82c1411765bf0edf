"""What every rule of the tight encoding does: hand requirements on, and choose between options."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np

from tsplan.encode.robustness_bound import OptimisticBound
from tsplan.encode.selection import Relay, Selection, SelectionColumns
from tsplan.encode.step_runs import Span, by_column, joined, steps_of
from tsplan.logic import Formula
from tsplan.milp.model import Ints

_MANY = 3  # strides; of fewer steps none is left out


@dataclass(frozen=True, slots=True)
class Demand:
    """`bound` must hold at the steps `first .. last` where `selection` is 1.

    It is in the form that the encoder of its atom gives it.
    """

    bound: Any
    first: int
    last: int
    selection: Selection

    @property
    def step(self) -> int:
        """The step of a demand that lasts no longer than one."""
        return self.first


@dataclass(frozen=True, eq=False)
class Cover:
    """At least one of `columns[begin:end]` is 1 where `selection` is 1 (F under an always)."""

    columns: Ints
    begin: int
    end: int
    selection: Selection


@dataclass(eq=False)
class Witnesses:
    """What a formula asks of the agents, as demands under selections.

    Of `visits` it is enough that they hold at some step of theirs, for one agent. `executions` are
    the demands that tasks be executed.
    """

    choices: SelectionColumns
    demands: list[Demand] = field(default_factory=list)
    covers: list[Cover] = field(default_factory=list)
    visits: list[Demand] = field(default_factory=list)
    executions: list[Demand] = field(default_factory=list)

    @cached_property
    def stepwise(self) -> list[Demand]:
        """What is demanded step by step, exclusive selections added up."""
        asked: dict[Any, list[Span]] = defaultdict(list)
        for need in self.demands:
            asked[need.bound].append(Span(need.first, need.last, need.selection))
        return [
            Demand(bound, step, step, selection)
            for bound, spans in asked.items()
            for step, selection in self.choices.by_step(joined(spans))
        ]


class Asker:
    """Gathers what is required of each formula, under the selections of one set of choices."""

    def __init__(
        self, choices: SelectionColumns, optimistic: OptimisticBound, stride: int = 1
    ) -> None:
        self._requests: dict[Formula, list[Span]] = defaultdict(list)
        self._stride = stride
        self.choices = choices
        self.optimistic = optimistic

    def ask(self, node: Formula, span: Span) -> None:
        """Require a formula at all steps of a span; what cannot hold refutes the selection.

        What holds in any case is not asked for.
        """
        if self.optimistic.possible_throughout(node, span.first, span.last):
            for first, last in self.optimistic.uncertain(node, span.first, span.last):
                self._requests[node].append(Span(first, last, span.selection))
        else:
            self.choices.refute(span.selection, "impossible")

    def ask_at(self, node: Formula, options: Iterable[tuple[int, Selection]]) -> None:
        """Require a formula at each of some steps, under a selection each."""
        for step, selection in options:
            self.ask(node, Span(step, step, selection))

    def asked(self, node: Formula) -> list[Span]:
        """Everything that is required of a formula by those that have it as a part."""
        return joined(self._requests.pop(node, []))

    def times(self, node: Formula, runs: Iterable[tuple[int, int]]) -> list[int]:
        """The steps of several runs at which a formula may hold, in order, each once.

        With a stride only every so many of them, and the last, where they are many.
        """
        steps = steps_of((first, last) for first, last in runs if first <= last).tolist()
        able = [step for step in steps if self.optimistic.possible(node, step)]
        if self._stride > 1 and len(able) > _MANY * self._stride:
            return [step for step in able if step % self._stride == 0 or step == able[-1]]
        return able

    def options(self, selection: Selection, steps: Sequence[int], kind: str) -> list[Selection]:
        """One selection per option, by the steps they begin; a single one needs no column."""
        if not steps:
            self.choices.refute(selection, kind)
            return []
        if len(steps) == 1:
            return [selection]
        return [(column,) for column in self.choices.choose(selection, list(steps), kind).tolist()]

    def families(self, once: Sequence[Span]) -> list[list[Span]]:
        """Spans of one column each, in families that exclude each other; `ALWAYS` on its own."""
        of = {span.selection[0]: span for span in once if span.selection}
        found = [sorted(of[column] for column in family) for family in self.choices.families(of)]
        return [*([span] for span in once if not span.selection), *found]

    def relayed(
        self, family: Sequence[Span], window: Ints, times: Sequence[int], kind: str
    ) -> list[tuple[int, Selection]]:
        """One witness at one of `times` for the spans of a family, each in a window of its own."""
        low, high = window.T
        served = np.searchsorted(times, low) < np.searchsorted(times, high, side="right")
        for place in np.flatnonzero(~served).tolist():
            self.choices.refute(family[place].selection, kind)
        if not served.any():
            return []
        selections = [family[place].selection for place in np.flatnonzero(served).tolist()]
        parents = tuple(column for selection in selections for column in selection)
        low, high = low[served], high[served]
        if len(times) == 1 or (low[0] == low[-1] and high[0] == high[-1]):
            options = self.options(parents, times, kind)
        else:
            each = [len(selection) for selection in selections]
            columns, at = np.array(parents, dtype=np.int64), np.array(times, dtype=np.int64)
            waiting = Relay(columns, np.repeat(low, each), np.repeat(high, each), at)
            options = [(column,) for column in self.choices.relay(waiting, kind).tolist()]
        return list(zip(times, options, strict=True))

    def shared(
        self, node: Formula, requests: Sequence[tuple[int, Selection]], window: Ints, kind: str
    ) -> dict[int, int]:
        """Witnesses shared between requests, one at least in the window of each.

        The column of every step at which the formula may hold; it is required there.
        """
        times = self.times(node, window.tolist())
        columns = self.choices.free(times)
        selections = [selection for _, selection in requests]
        self.choices.cover_windows((columns, times), (window[:, 0], window[:, 1]), selections, kind)
        found = dict(zip(times, columns.tolist(), strict=True))
        self.ask_at(node, [(time, (column,)) for time, column in found.items()])
        return found


def sorted_out(spans: Iterable[Span]) -> tuple[list[Span], dict[Selection, list[Span]]]:
    """Columns that ask at one step only, and the spans of those that ask at several."""
    asked = by_column(spans)
    again = {
        selection: runs
        for selection, runs in asked.items()
        if len(runs) > 1 or runs[0].first < runs[0].last
    }
    return [runs[0] for selection, runs in asked.items() if selection not in again], again
