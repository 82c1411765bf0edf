"""Literals of the tight encoding: sums of 0/1 columns of which at most one is 1.

A *choice* is a set of 0/1 columns of which exactly one is 1 where its parent literal is. A
*literal* is a sum of columns that exclude each other, so it is 0 or 1 itself; the empty literal
stands for "always". Which columns exclude each other is told by their ancestry
(`encode.exclusion`).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple, TypeAlias

import numpy as np

from tsplan.encode.exclusion import Lineage, common, exclusive, families
from tsplan.encode.running_sums import RunningSums
from tsplan.milp.model import Draft, Ints

__all__ = ["ALWAYS", "Choices", "Lineage", "Literal", "Relay", "Timed", "exclusive"]

Literal: TypeAlias = tuple[int, ...]
ALWAYS: Literal = ()
Timed: TypeAlias = tuple[Ints, Sequence[int]]  # columns of a choice and the steps they stand for


class Relay(NamedTuple):
    """Columns that exclude each other, each waiting for one of `times` in a window of its own.

    The columns are in the order of their windows: neither beginnings nor ends go back.
    """

    columns: Ints
    low: Ints
    high: Ints
    times: Ints


@dataclass(frozen=True, eq=False)
class Relayed:
    """A relay that was made: its columns, and the running totals of both sides."""

    waiting: Relay
    columns: Ints
    own: RunningSums
    theirs: RunningSums


class Choices:
    """Makes indicator columns in a draft and remembers their ancestry."""

    def __init__(self, draft: Draft) -> None:
        self._draft = draft
        self._lineage: dict[int, Lineage] = {}
        self._free: set[int] = set()
        self._count = 0
        self.columns: list[int] = []
        self.steps: list[int] = []
        self.groups: list[Ints] = []
        self.relays: list[Relayed] = []
        self.refuted = False

    def choose(self, parent: Literal, steps: Sequence[int], kind: str) -> Ints:
        """Columns of which exactly one is 1 where `parent` is 1, and none elsewhere.

        There is one for each of `steps`: when what the option stands for begins.
        """
        columns = self._options(parent, steps, kind, exactly=True)
        self.groups.append(columns)
        return columns

    def optional(self, parent: Literal, steps: Sequence[int], kind: str) -> Ints:
        """Columns of which at most one is 1 where `parent` is 1, and none elsewhere."""
        columns = self._options(parent, steps, kind, exactly=False)
        if len(columns) > 1:
            self.groups.append(columns)
        return columns

    def _options(self, parent: Literal, steps: Sequence[int], kind: str, *, exactly: bool) -> Ints:
        columns = self._draft.columns(len(steps), upper=1.0, integer=True)
        total = 0.0 if parent else 1.0
        self._draft.rows(
            np.zeros(len(columns) + len(parent), dtype=np.int64),
            np.concatenate([columns, _array(parent)]),
            np.concatenate([np.ones(len(columns)), -np.ones(len(parent))]),
            lower=total if exactly else -np.inf,
            upper=total,
            kind=kind,
        )
        above = self.lineage(parent)
        for column in columns.tolist():
            self._lineage[column] = {**above, self._count: (column, column)}
        self._count += 1
        self.columns += columns.tolist()
        self.steps += steps
        return columns

    def relay(self, waiting: Relay, kind: str) -> Ints:
        """A choice for many parents at once: one column for each of the times.

        Whichever parent is 1, exactly one time in its window is chosen. As at most one parent is 1,
        it is enough to compare running totals: no time before a window begins for a parent, and
        one for every parent whose window has ended. This says as much as a choice for each parent
        would, in the LP too (what goes from windows to times in their order can be paired), and
        has as many columns as there are times.
        """
        columns = self.choose(tuple(waiting.columns.tolist()), waiting.times.tolist(), kind)
        ones = np.ones(max(len(columns), len(waiting.columns)))
        own = RunningSums(waiting.times, columns, ones[: len(columns)])
        place = np.arange(len(waiting.columns))
        theirs = RunningSums(place, waiting.columns, ones[: len(place)])
        relayed = Relayed(waiting, columns, own, theirs)
        self.relays.append(relayed)
        self._not_before(relayed, waiting.low, kind)
        done = np.searchsorted(waiting.times, waiting.high, side="right")
        last = np.append(done[1:] > done[:-1], True) & (done < len(columns))
        self._ahead(own, waiting.high[last], theirs, place[last], kind)
        return columns

    def not_before(self, relayed: Relayed, low: Ints) -> None:
        """The windows of a relay begin no sooner than `low` says, which does not go back either."""
        self._not_before(relayed, low, "precedence")

    def _not_before(self, relayed: Relayed, low: Ints, kind: str) -> None:
        times = relayed.waiting.times
        begun = np.searchsorted(low, times, side="right")
        # of rows about the same parents the last says most; about all, the choice says it already
        last = np.append(begun[1:] > begun[:-1], True) & (begun < len(low))
        self._ahead(relayed.theirs, begun[last] - 1, relayed.own, times[last], kind)

    def _ahead(
        self, more: RunningSums, until: Ints, less: RunningSums, to: Ints, kind: str
    ) -> None:
        """The total of `more` up to `until[i]` is at least that of `less` up to `to[i]`."""
        if not len(until):
            return
        lowest = np.full(len(until), -1)
        index, columns, values = more.over(self._draft, lowest, until)
        other, taken, amounts = less.over(self._draft, lowest, to)
        self._draft.rows(
            np.concatenate([index, other]),
            np.concatenate([columns, taken]),
            np.concatenate([values, -amounts]),
            lower=np.zeros(len(until)),
            upper=np.inf,
            kind=kind,
        )

    def free(self, steps: Sequence[int]) -> Ints:
        """Columns that exclude nothing: each may be 1 whenever its own sub-formula holds."""
        columns = self._draft.columns(len(steps), upper=1.0, integer=True)
        for column in columns.tolist():
            self._lineage[column] = {self._count: (column, column)}
            self._free.add(column)
            self._count += 1
        self.columns += columns.tolist()
        self.steps += steps
        return columns

    def cover(self, columns: Ints, parent: Literal, kind: str) -> None:
        """At least one of `columns` is 1 where `parent` is 1."""
        self._draft.rows(
            np.zeros(len(columns) + len(parent), dtype=np.int64),
            np.concatenate([columns, _array(parent)]),
            np.concatenate([np.ones(len(columns)), -np.ones(len(parent))]),
            lower=0.0 if parent else 1.0,
            upper=np.inf,
            kind=kind,
        )

    def cover_windows(
        self, timed: Timed, windows: tuple[Ints, Ints], parents: Sequence[Literal], kind: str
    ) -> None:
        """At least one column of each window of times is 1 where its parent is 1."""
        columns, times = timed
        sums = RunningSums(np.asarray(times), columns, np.ones(len(columns)))
        index, members, values = sums.over(self._draft, *windows)
        above = [column for parent in parents for column in parent]
        which = np.repeat(np.arange(len(parents)), [len(parent) for parent in parents])
        self._draft.rows(
            np.concatenate([index, which]),
            np.concatenate([members, np.array(above, dtype=np.int64)]),
            np.concatenate([values, -np.ones(len(above))]),
            lower=np.array([0.0 if parent else 1.0 for parent in parents]),
            upper=np.inf,
            kind=kind,
        )

    def follow(self, before: Timed, after: Timed, gap: int, kind: str) -> None:
        """The witness of `after` comes at most `gap` steps later than that of `before`."""
        (earlier, first), (later, second) = before, after
        done = RunningSums(np.asarray(second), later, np.ones(len(later)))
        begun = RunningSums(np.asarray(first), earlier, np.ones(len(earlier)))
        self._ahead(done, np.asarray(first) + gap, begun, np.asarray(first), kind)

    def running(self, changes: RunningSums, above: Sequence[int]) -> Ints:
        """A column for every total of `changes`, which is 1 while one of `above` is at work.

        These columns may be parents of others, but nothing is decided by them.
        """
        totals = changes.chain(self._draft)
        lineage = common(self._lineage[column] for column in above)
        for column in totals.tolist():
            self._lineage[column] = lineage
            self._free.add(column)
        return totals

    def waiting(
        self, asked: Mapping[int, Sequence[Literal]], ends: Mapping[int, int], kind: str
    ) -> list[tuple[int, int]]:
        """Steps and columns that are 1 while something asked for has not come to its end.

        `asked` are the literals that begin to wait at a step, `ends` the columns that end all
        waiting at theirs.
        """
        steps = range(min(asked), max(ends, default=min(asked)))
        columns = self._draft.columns(len(steps), upper=1.0).tolist()
        rows: list[tuple[list[int], list[int]]] = []  # what is at least what, for one row each
        for place, (step, column) in enumerate(zip(steps, columns, strict=True)):
            more = [column, ends[step]] if step in ends else [column]
            before = [[columns[place - 1]]] if place else []
            rows += [(more, list(less)) for less in (*before, *asked.get(step, ()))]
            self._lineage[column] = {}
            self._free.add(column)
        index = [row for row, (more, less) in enumerate(rows) for _ in (*more, *less)]
        members = [column for more, less in rows for column in (*more, *less)]
        signs = [sign for more, less in rows for sign in [1.0] * len(more) + [-1.0] * len(less)]
        lower = np.array([0.0 if less else 1.0 for _, less in rows])
        self._draft.rows(index, members, np.array(signs), lower=lower, upper=np.inf, kind=kind)
        return list(zip(steps, columns, strict=True))

    def refute(self, literal: Literal, kind: str) -> None:
        """The literal cannot be 1; an impossible `ALWAYS` refutes the whole problem."""
        if not literal:
            self.refuted = True
            return
        zeros = np.zeros(len(literal), dtype=np.int64)
        self._draft.rows(zeros, _array(literal), 1.0, lower=0.0, upper=0.0, kind=kind)

    def lineage(self, literal: Literal) -> Lineage:
        """Choices that all columns of a literal descend from, with the options they came by."""
        return common(self._lineage[column] for column in literal)

    def ancestors(self, column: int) -> set[int]:
        """Other columns that are 1 wherever `column` is."""
        above = self._lineage[column].values()
        return {first for first, last in above if first == last} - {column}

    def families(self, columns: Iterable[int]) -> list[list[int]]:
        """Partition columns, greedily and in order, into families that exclude each other."""
        ordered = sorted(set(columns))
        bound = {c: self._lineage[c] for c in ordered if c not in self._free}
        # a free column excludes nothing, so it is a family of its own
        return families(bound) + [[column] for column in ordered if column in self._free]

    def merged(self, literals: Iterable[Literal]) -> list[Literal]:
        """Fewer literals that say the same: exclusive ones are added up.

        The result may overlap only where the same column was asked for twice.
        """
        unique = set(literals)
        if ALWAYS in unique:
            return [ALWAYS]
        if len(unique) == 1:
            return list(unique)
        columns = {column for literal in unique for column in literal}
        return [tuple(family) for family in self.families(columns)]


def _array(literal: Literal) -> Ints:
    return np.array(literal, dtype=np.int64)
