"""Selections of the tight encoding: sums of 0/1 columns of which at most one is 1.

A *choice* is a set of 0/1 columns of which exactly one is 1 where its parent selection is. A
*selection* is a sum of columns that exclude each other, so it is 0 or 1 itself; the empty selection
stands for "always". Which columns exclude each other is told by their ancestry
(`encode.exclusion`).
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple, TypeAlias

import numpy as np

from tsplan.encode.exclusion import Ancestry, common, exclusive, families
from tsplan.encode.running_sums import RunningSums
from tsplan.encode.step_runs import ALWAYS, Selection, Span, by_column
from tsplan.milp.model import INFINITY, Block, Draft, Ints

__all__ = ["ALWAYS", "Ancestry", "Relay", "Selection", "SelectionColumns", "Timed", "exclusive"]

Timed: TypeAlias = tuple[Ints, Sequence[int]]  # columns of a choice and the steps they stand for

_WRITTEN = 4  # selections written out for each change of who asks


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


class SelectionColumns:
    """Makes indicator columns in a draft and remembers their ancestry."""

    def __init__(self, draft: Draft) -> None:
        self._draft = draft
        self._ancestry: dict[int, Ancestry] = {}
        self._free: set[int] = set()
        self._count = 0
        self.columns: list[int] = []
        self.steps: list[int] = []
        self.groups: list[Ints] = []
        self.exact: list[tuple[Selection, Ints]] = []
        self.relays: list[Relayed] = []
        self.refuted = False
        self._impossible: set[int] = set()

    # --- columns ---------------------------------------------------------------------------------

    def choose(
        self, parent: Selection, steps: Sequence[int], kind: str, *, exactly: bool = True
    ) -> Ints:
        """Columns of which exactly one (else: at most one) is 1 where `parent` is, none elsewhere.

        There is one for each of `steps`: when what the option stands for begins.
        """
        columns = self._decided(steps)
        one = 0.0 if parent else 1.0
        self._total(columns, parent, one if exactly else -INFINITY, one, kind)
        above = self.ancestry(parent)
        for column in columns.tolist():
            self._ancestry[column] = {**above, self._count: (column, column)}
        self._count += 1
        if exactly:
            self.exact.append((parent, columns))
        if exactly or len(columns) > 1:
            self.groups.append(columns)
        return columns

    def free(self, steps: Sequence[int]) -> Ints:
        """Columns that exclude nothing: each may be 1 whenever its own sub-formula holds."""
        columns = self._decided(steps)
        for column in columns.tolist():
            self._ancestry[column] = {self._count: (column, column)}
            self._count += 1
        self._free.update(columns.tolist())
        return columns

    def _decided(self, steps: Sequence[int]) -> Ints:
        columns = self._draft.columns(len(steps), upper=1.0, integer=True)
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
        place = np.arange(len(waiting.columns))
        own, theirs = RunningSums(waiting.times, columns), RunningSums(place, waiting.columns)
        relayed = Relayed(waiting, columns, own, theirs)
        self.relays.append(relayed)
        self.not_before(relayed, waiting.low, kind)
        done = np.searchsorted(waiting.times, waiting.high, side="right")
        last = np.append(done[1:] > done[:-1], True) & (done < len(columns))
        self._ahead(own, waiting.high[last], theirs, place[last], kind)
        return columns

    def not_before(self, relayed: Relayed, low: Ints, kind: str = "precedence") -> None:
        """The windows of a relay begin no sooner than `low` says, which does not go back either."""
        times = relayed.waiting.times
        begun = np.searchsorted(low, times, side="right")
        # of rows about the same parents the last says most; about all, the choice says it already
        last = np.append(begun[1:] > begun[:-1], True) & (begun < len(low))
        self._ahead(relayed.theirs, begun[last] - 1, relayed.own, times[last], kind)

    def running(self, changes: RunningSums, above: Sequence[int]) -> list[Span]:
        """The totals of `changes`, each as a selection for as long as it lasts.

        A total is 1 while one of `above` is at work, and 0 otherwise. Its column may be a parent
        of others, but nothing is decided by it.
        """
        totals = changes.chain(self._draft).tolist()
        self._ancestry |= dict.fromkeys(totals, self.ancestry(above))
        self._free.update(totals)
        first = changes.positions.tolist()
        runs = zip(first, first[1:], totals, strict=False)
        return [Span(begin, after - 1, (total,)) for begin, after, total in runs]

    def waiting(
        self, asked: Mapping[int, Sequence[Selection]], ends: Mapping[int, int], kind: str
    ) -> list[tuple[int, int]]:
        """Steps and columns that are 1 while something asked for has not come to its end.

        `asked` are the selections that begin to wait at a step, `ends` the columns that end all
        waiting at theirs.
        """
        steps = range(min(asked), max(ends, default=min(asked)))
        columns = self._draft.columns(len(steps), upper=1.0).tolist()
        rows = Block(kind)
        before: Sequence[Selection] = ()
        for step, column in zip(steps, columns, strict=True):
            more = [column, ends[step]] if step in ends else [column]
            for less in (*before, *asked.get(step, ())):
                rows.add((0, more, 1.0), (0, less, -1.0), lower=0.0 if less else 1.0)
            before = [(column,)]
        rows.write(self._draft)
        self._ancestry |= {column: {} for column in columns}
        self._free.update(columns)
        return list(zip(steps, columns, strict=True))

    # --- rows ------------------------------------------------------------------------------------

    def _total(
        self, columns: Ints, parent: Selection, lower: float, upper: float, kind: str
    ) -> None:
        """Bounds on the sum of `columns` less the parent."""
        terms = (0, columns, 1.0), (0, parent, -1.0)
        self._draft.sums(*terms, lower=lower, upper=upper, kind=kind)

    def cover(self, columns: Ints, parent: Selection, kind: str) -> None:
        """At least one of `columns` is 1 where `parent` is 1."""
        self._total(columns, parent, 0.0 if parent else 1.0, INFINITY, kind)

    def cover_windows(
        self, timed: Timed, windows: tuple[Ints, Ints], parents: Sequence[Selection], kind: str
    ) -> None:
        """At least one column of each window of times is 1 where its parent is 1."""
        columns, times = timed
        sums = RunningSums(times, columns).over(self._draft, *windows)
        lower = np.array([0.0 if parent else 1.0 for parent in parents])
        self._draft.sums(sums, less(parents), lower=lower, kind=kind)

    def follow(self, before: Timed, after: Timed, gap: int, kind: str) -> None:
        """The witness of `after` comes at most `gap` steps later than that of `before`."""
        (earlier, first), (later, second) = before, after
        begun, done = RunningSums(first, earlier), RunningSums(second, later)
        self._ahead(done, np.asarray(first) + gap, begun, np.asarray(first), kind)

    def _ahead(
        self, more: RunningSums, until: Ints, less: RunningSums, to: Ints, kind: str
    ) -> None:
        """The total of `more` up to `until[i]` is at least that of `less` up to `to[i]`."""
        if not len(until):
            return
        lowest = np.full(len(until), -1)
        ahead = more.over(self._draft, lowest, until)
        index, columns, values = less.over(self._draft, lowest, to)
        self._draft.sums(ahead, (index, columns, -values), count=len(until), kind=kind)

    def refute(self, selection: Selection, kind: str) -> None:
        """The selection cannot be 1; an impossible `ALWAYS` refutes the whole problem."""
        if selection:
            self._draft.sums((0, selection, 1.0), upper=0.0, kind=kind)
            self._impossible.update(selection)
        else:
            self.refuted = True

    def settle(self, others: Collection[Selection]) -> None:
        """Refute the problem if it needs a column of a choice that has impossible ones alone.

        Those are the refuted ones, others that are told, and what needs a column of such a choice.
        """
        self.refuted = self.refuted or ALWAYS in others
        impossible = self._impossible.union(*others)
        for parent, columns in reversed(self.exact):  # parents are made before their children
            if impossible.issuperset(columns.tolist()):
                self.refuted = self.refuted or not parent
                impossible.update(parent)

    # --- ancestry --------------------------------------------------------------------------------

    def ancestry(self, selection: Iterable[int]) -> Ancestry:
        """Choices that all columns of a selection descend from, with the options they came by."""
        return common(self._ancestry[column] for column in selection)

    def ancestors(self, column: int) -> set[int]:
        """Other columns that are 1 wherever `column` is."""
        above = self._ancestry[column].values()
        return {first for first, last in above if first == last} - {column}

    def families(self, columns: Iterable[int]) -> list[list[int]]:
        """Partition columns, greedily and in order, into families that exclude each other."""
        ordered = sorted(set(columns))
        bound = {c: self._ancestry[c] for c in ordered if c not in self._free}
        # a free column excludes nothing, so it is a family of its own
        return families(bound) + [[column] for column in ordered if column in self._free]

    def merged(self, selections: Iterable[Selection]) -> list[Selection]:
        """Fewer selections that say the same: exclusive ones are added up.

        The result may overlap only where the same column was asked for twice.
        """
        unique = set(selections)
        if ALWAYS in unique:
            return [ALWAYS]
        if len(unique) == 1:
            return list(unique)
        columns = {column for selection in unique for column in selection}
        return [tuple(family) for family in self.families(columns)]

    def by_step(self, spans: Sequence[Span]) -> list[tuple[int, Selection]]:
        """Every step with each of its selections, exclusive ones added up; steps are in order.

        Where the selections of all steps together would be far longer than the list of who begins
        and ends, each family of exclusive columns has a column for its running total instead.
        """
        if not spans:
            return []
        written = sum((last - first + 1) * len(selection) for first, last, selection in spans)
        changes = sum(len(selection) for _, _, selection in spans)
        steps = max(span.last for span in spans) - min(span.first for span in spans) + 1
        long = written > _WRITTEN * (2 * changes + 3 * steps)
        found: dict[int, list[Selection]] = defaultdict(list)
        for first, last, selection in self._as_totals(spans) if long else spans:
            for step in range(first, last + 1):
                found[step].append(selection)
        return [
            (step, selection)
            for step in sorted(found)
            for selection in (found[step] if long else self.merged(found[step]))
        ]

    def _as_totals(self, spans: Sequence[Span]) -> list[Span]:
        """The spans by `ALWAYS`, and for each family of exclusive columns its running totals."""
        asked = by_column(spans)
        found = asked.pop(ALWAYS, [])
        for family in self.families(column for (column,) in asked):
            mine = [span for column in family for span in asked[(column,)]]
            if len(mine) == 1:
                found += mine
                continue
            first, last, columns = np.array([(*ends, column) for *ends, (column,) in mine]).T
            ends = np.concatenate([first, last + 1])
            changes = RunningSums(ends, np.tile(columns, 2), np.repeat([1.0, -1.0], len(mine)))
            totals = self.running(changes, columns.tolist())
            at = np.array([span.first for span in totals])
            busy = np.searchsorted(np.sort(first), at, "right") > np.searchsorted(np.sort(last), at)
            found += [span for span, some in zip(totals, busy.tolist(), strict=True) if some]
        return found


def less(selections: Sequence[Selection]) -> tuple[Ints, Ints, float]:
    """The terms that take a selection each from as many rows."""
    index = np.repeat(np.arange(len(selections)), [len(selection) for selection in selections])
    columns = [column for selection in selections for column in selection]
    return index, np.array(columns, dtype=np.int64), -1.0
