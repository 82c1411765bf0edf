"""Demands at one place by columns that exclude each other, as runs of steps."""

from __future__ import annotations

import itertools
from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from tsplan.encode.running_sums import RunningSums, Terms
from tsplan.milp.model import Draft, Floats, Ints

_WORTH = 4  # as in `encode.running_sums`


class Run(NamedTuple):
    """So many agents at the steps `first .. last`."""

    first: int
    last: int
    amount: float


class Pieces(NamedTuple):
    """What columns ask for: no two pieces of one column share a step."""

    column: Ints
    first: Ints
    last: Ints
    amount: Floats


@dataclass(frozen=True, eq=False)
class Family:
    """Demands at one site by literals of which at most one is 1.

    `steps` are those at which something is asked for, `base` what is asked for there in any case.
    Pieces speak of positions in `steps` and are sorted by column, then by step.
    """

    steps: Ints
    columns: Ints
    pieces: Pieces
    base: Floats

    def surplus(self, draft: Draft) -> Terms:
        """At every position what the literals ask for beyond the base, as sums of columns."""
        extra = self._beyond_base()
        written = int((extra.last - extra.first + 1).sum())
        if written <= _WORTH * (3 * len(self.steps) + 2 * len(extra.column)):
            return _expanded(extra)
        changes = RunningSums(
            np.concatenate([extra.first, extra.last + 1]),
            np.concatenate([extra.column, extra.column]),
            np.concatenate([extra.amount, -extra.amount]),
        )
        changes.chain(draft)
        every = np.arange(len(self.steps))
        return changes.known(np.zeros_like(every), every)

    def _beyond_base(self) -> Pieces:
        """The pieces without what is asked for in any case, cut where that changes."""
        if not self.base.any():
            return self.pieces
        changes = np.flatnonzero(np.diff(self.base)) + 1
        begin = np.searchsorted(changes, self.pieces.first, side="right")
        inside = np.searchsorted(changes, self.pieces.last, side="right") - begin
        which = np.repeat(np.arange(len(inside)), inside + 1)
        part = np.arange(len(which)) - np.repeat(np.cumsum(inside + 1) - inside - 1, inside + 1)
        cut = np.concatenate([changes, [0]])
        first = np.where(part, cut[begin[which] + part - 1], self.pieces.first[which])
        last = np.where(
            part < inside[which],
            cut[begin[which] + part * (part < inside[which])] - 1,
            self.pieces.last[which],
        )
        amount = self.pieces.amount[which] - self.base[first]
        more = amount > 0
        return Pieces(self.pieces.column[which][more], first[more], last[more], amount[more])

    @cached_property
    def begun(self) -> RunningSums:
        """Up to a position: the most that each column asks for by then."""
        return _rises(self.pieces)

    @cached_property
    def ending(self) -> RunningSums:
        """From a position on: the most that each column asks for from then on."""
        column, first, last, amount = self.pieces
        order = np.lexsort((-last, column))
        found = _rises(Pieces(column[order], -last[order], -first[order], amount[order]))
        return found.mirrored()

    @cached_property
    def consecutive(self) -> bool:
        """Whether each column asks for one number of agents, over consecutive steps."""
        return len(np.unique(self.pieces.column)) == len(self.pieces.column)

    def asked_within(self, low: int, high: int) -> tuple[Ints, Floats]:
        """Columns that ask for something at the positions `low .. high`, and for how much."""
        column, first, last, amount = self.pieces
        inside = (first <= high) & (last >= low)
        return column[inside], amount[inside]


def _expanded(pieces: Pieces) -> Terms:
    """A term for every position of every piece."""
    length = pieces.last - pieces.first + 1
    index = np.arange(length.sum()) - np.repeat(np.cumsum(length) - length - pieces.first, length)
    return index, np.repeat(pieces.column, length), np.repeat(pieces.amount, length)


def _rises(pieces: Pieces) -> RunningSums:
    """By how much each piece is more than all pieces of its column before."""
    if len(np.unique(pieces.column)) == len(pieces.column):
        return RunningSums(pieces.first, pieces.column, pieces.amount)
    rise = np.zeros(len(pieces.column))
    most: dict[int, float] = defaultdict(float)
    for place, (column, amount) in enumerate(
        zip(pieces.column.tolist(), pieces.amount.tolist(), strict=True)
    ):
        rise[place] = max(amount - most[column], 0.0)
        most[column] = max(amount, most[column])
    some = rise > 0
    return RunningSums(pieces.first[some], pieces.column[some], rise[some])


def apart(runs: Iterable[Run]) -> list[Run]:
    """The most of several runs at every step, as runs that share no step."""
    runs = sorted(runs)
    if len(runs) < 2:  # noqa: PLR2004
        return runs
    edges = sorted({run.first for run in runs} | {run.last + 1 for run in runs})
    found: list[Run] = []
    active: list[Run] = []
    waiting = iter([*runs, None])
    following = next(waiting)
    for first, after in itertools.pairwise(edges):
        while following is not None and following.first <= first:
            active.append(following)
            following = next(waiting)
        active = [run for run in active if run.last >= first]
        amount = max((run.amount for run in active), default=0.0)
        if not amount:
            continue
        if found and found[-1].amount == amount and found[-1].last == first - 1:
            found[-1] = found[-1]._replace(last=after - 1)
        else:
            found.append(Run(first, after - 1, amount))
    return found


def family(
    columns: Sequence[int],
    asked: Mapping[int, Sequence[Run]],
    base: Sequence[Run],
    *,
    everywhere: bool,
) -> Family:
    """A family of `columns` from the runs that each asks for, and those asked for in any case.

    Runs of one column share no step, nor do those of the base; both are in order. Without
    `everywhere` the base is left out at steps at which no column asks for anything.
    """
    runs = [run for column in columns for run in asked[column]]
    steps = _covered([*runs, *base] if everywhere else runs)
    start = np.array([run.first for run in runs], dtype=np.int64)
    first = np.searchsorted(steps, start)
    level = np.zeros(len(steps))
    for run in base:
        begin, end = np.searchsorted(steps, [run.first, run.last + 1])
        level[begin:end] = run.amount
    owner = [column for column in columns for _ in asked[column]]
    return Family(
        steps=steps,
        columns=np.array(columns, dtype=np.int64),
        pieces=Pieces(
            column=np.array(owner, dtype=np.int64),
            first=first,
            last=first + np.array([run.last for run in runs], dtype=np.int64) - start,
            amount=np.array([run.amount for run in runs], dtype=np.float64),
        ),
        base=level,
    )


def _covered(runs: Sequence[Run]) -> Ints:
    """The steps of all runs, each once."""
    low = min(run.first for run in runs)
    change = np.zeros(max(run.last for run in runs) - low + 2, dtype=np.int64)
    np.add.at(change, np.array([run.first for run in runs]) - low, 1)
    np.add.at(change, np.array([run.last for run in runs]) + 1 - low, -1)
    return np.flatnonzero(np.cumsum(change)) + low
