"""Sums over runs of positions, written out or read off a chain of running totals.

Many rows of an encoding add up what lies in a window: the witnesses that begin by some step, those
that end after another. Written out, T windows over T positions have T x T entries. A chain of
auxiliary columns, each the one before and what is new, has three entries a position, and every
window is then the difference of two. The chain costs columns, so short sums are written out.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeAlias

import numpy as np

from tsplan.milp.model import Draft, Floats, Ints

Sums: TypeAlias = tuple[Ints, Ints, Floats]
"""Terms of several sums: which sum, which column, and its factor."""

_WORTH = 4  # entries written out for each that the chain needs: columns are dearer than entries


def unfolded(first: Ints, length: Ints) -> tuple[Ints, Ints]:
    """Every position of the runs that begin at `first` and are `length` long, and whose it is.

    >>> run, position = unfolded(np.array([5, 0]), np.array([2, 3]))
    >>> run.tolist(), position.tolist()
    ([0, 0, 1, 1, 1], [5, 6, 0, 1, 2])
    """
    run = np.repeat(np.arange(len(length)), length)
    return run, np.arange(len(run)) + (first - np.cumsum(length) + length)[run]


def chain_pays(written: int, changes: int, sums: int) -> bool:
    """Whether a chain over so many changes is far shorter than so many entries written out."""
    return written > _WORTH * (3 * changes + 2 * sums)


class RunningSums:
    """Sums of `value * column` over entries at positions; entries may share a position."""

    def __init__(
        self, position: Ints | Sequence[int], column: Ints, value: Floats | float = 1.0
    ) -> None:
        order = np.argsort(position, kind="stable")
        self._position = np.asarray(position)[order]
        self._column = np.asarray(column)[order]
        self._value = np.broadcast_to(np.asarray(value, dtype=np.float64), order.shape)[order]
        self.positions, self._place = np.unique(self._position, return_inverse=True)
        self._chain: Ints | None = None

    def mirrored(self) -> RunningSums:
        """The same entries at the positions on the other side of 0."""
        return RunningSums(-self._position, self._column, self._value)

    @property
    def chained(self) -> bool:
        """Whether there are columns of running totals."""
        return self._chain is not None

    def over(self, draft: Draft, low: Ints, high: Ints) -> Sums:
        """The sums over the positions `low[i] .. high[i]`, by a chain where that is far shorter."""
        begin, end = self._runs(low, high)
        if chain_pays(int((end - begin).sum()), len(self._position), len(begin)):
            self.chain(draft)
        return self.known(low, high)

    def known(self, low: Ints, high: Ints) -> Sums:
        """The same sums with the columns there are."""
        begin, end = self._runs(low, high)
        if self._chain is None:
            index, entry = unfolded(begin, end - begin)
            return index, self._column[entry], self._value[entry]
        last, before = np.flatnonzero(end > begin), np.flatnonzero((end > begin) & (begin > 0))
        return (
            np.concatenate([last, before]),
            self._chain[self._place[np.concatenate([end[last], begin[before]]) - 1]],
            np.repeat([1.0, -1.0], [len(last), len(before)]),
        )

    def chain(self, draft: Draft) -> Ints:
        """The running total up to and with each of `positions`, as columns."""
        if self._chain is None:
            self._chain = draft.columns(len(self.positions))
            draft.define(
                self._chain,
                (np.arange(1, len(self._chain)), self._chain[:-1], 1.0),
                (self._place, self._column, self._value),
                kind="running total",
            )
        return self._chain

    def _runs(self, low: Ints, high: Ints) -> tuple[Ints, Ints]:
        """Where the entries of each sum begin and end."""
        begin = np.searchsorted(self._position, low, side="left")
        end = np.searchsorted(self._position, high, side="right")
        return begin, np.maximum(end, begin)
