"""Demands at one place by columns that exclude each other, as runs of steps."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from tsplan.encode.running_sums import RunningSums, Sums, chain_pays, unfolded
from tsplan.encode.step_runs import Run, steps_of
from tsplan.milp.model import Draft, Floats, Ints


class Pieces(NamedTuple):
    """What columns ask for: no two pieces of one column share a step."""

    column: Ints
    first: Ints
    last: Ints
    amount: Floats

    def taken(self, which: Ints) -> Pieces:
        """Some of the pieces, or all in another order."""
        return Pieces(self.column[which], self.first[which], self.last[which], self.amount[which])


@dataclass(frozen=True, eq=False)
class Family:
    """Demands at one site by selections of which at most one is 1.

    `steps` are those at which something is asked for, `base` what is asked for there in any case.
    Pieces speak of positions in `steps` and are sorted by column, then by step.
    """

    steps: Ints
    columns: Ints
    pieces: Pieces
    base: Floats

    def surplus(self, draft: Draft) -> Sums:
        """At every position what the selections ask for beyond the base, as sums of columns."""
        column, first, last, amount = self._beyond_base()
        length = last - first + 1
        if not chain_pays(int(length.sum()), len(self.steps), len(column)):
            piece, position = unfolded(first, length)
            return position, column[piece], amount[piece]
        ends = np.concatenate([first, last + 1])
        changes = RunningSums(ends, np.tile(column, 2), np.concatenate([amount, -amount]))
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
        which, cut = unfolded(begin, inside + 1)
        column, first, last, amount = self.pieces.taken(which)
        borders = np.concatenate([[0], changes, [len(self.steps)]])
        first, last = np.maximum(first, borders[cut]), np.minimum(last, borders[cut + 1] - 1)
        found = Pieces(column, first, last, amount - self.base[first])
        return found.taken(np.flatnonzero(found.amount > 0))

    @cached_property
    def begun(self) -> RunningSums:
        """Up to a position: the most that each column asks for by then."""
        return _rises(self.pieces)

    @cached_property
    def ending(self) -> RunningSums:
        """From a position on: the most that each column asks for from then on."""
        column, first, last, amount = self.pieces
        order = np.lexsort((-last, column))
        return _rises(Pieces(column, -last, -first, amount).taken(order)).mirrored()

    @cached_property
    def consecutive(self) -> bool:
        """Whether each column asks for one number of agents, over consecutive steps."""
        return len(np.unique(self.pieces.column)) == len(self.pieces.column)

    def asked_within(self, low: int, high: int) -> tuple[Ints, Floats]:
        """Columns that ask for something at the positions `low .. high`, and for how much."""
        column, first, last, amount = self.pieces
        inside = (first <= high) & (last >= low)
        return column[inside], amount[inside]


def _rises(pieces: Pieces) -> RunningSums:
    """By how much each piece is more than all pieces of its column before."""
    if len(np.unique(pieces.column)) == len(pieces.column):
        return RunningSums(pieces.first, pieces.column, pieces.amount)
    rise = np.zeros(len(pieces.amount))
    most: dict[int, float] = defaultdict(float)
    for place, (column, _, _, amount) in enumerate(
        zip(*(part.tolist() for part in pieces), strict=True)
    ):
        rise[place] = max(amount - most[column], 0.0)
        most[column] = max(amount, most[column])
    some = rise > 0
    return RunningSums(pieces.first[some], pieces.column[some], rise[some])


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
    owned = [(column, *run) for column in columns for run in asked[column]]
    runs = [(first, last) for _, first, last, _ in owned]
    steps = steps_of([*runs, *(run[:2] for run in base)] if everywhere else runs)
    level = np.zeros(len(steps))
    for run in base:
        begin, end = np.searchsorted(steps, [run.first, run.last + 1])
        level[begin:end] = run.amount
    column, start, end, amount = np.array(owned, dtype=np.float64).reshape(-1, 4).T
    first = np.searchsorted(steps, start)
    return Family(
        steps=steps,
        columns=np.array(columns, dtype=np.int64),
        pieces=Pieces(
            column=column.astype(np.int64),
            first=first,
            last=first + (end - start).astype(np.int64),
            amount=amount,
        ),
        base=level,
    )
