"""Sums over runs of positions, written out or read off a chain of running totals.

Many rows of an encoding add up what lies in a window: the witnesses that begin by some step, those
that end after another. Written out, T windows over T positions have T x T entries. A chain of
auxiliary columns, each the one before and what is new, has three entries a position, and every
window is then the difference of two. The chain costs columns, so short sums are written out.
"""

from __future__ import annotations

from typing import TypeAlias

import numpy as np

from tsplan.milp.model import Draft, Floats, Ints

Terms: TypeAlias = tuple[Ints, Ints, Floats]
"""Triplets: which sum, which column, and its coefficient."""

_WORTH = 4  # entries written out for each that the chain needs: columns are dearer than entries


class RunningSums:
    """Sums of `value * column` over entries at positions; entries may share a position."""

    def __init__(self, position: Ints, column: Ints, value: Floats) -> None:
        order = np.argsort(position, kind="stable")
        self._position = np.asarray(position)[order]
        self._column = np.asarray(column)[order]
        self._value = np.asarray(value, dtype=np.float64)[order]
        self.positions, self._place = np.unique(self._position, return_inverse=True)
        self._chain: Ints | None = None

    def mirrored(self) -> RunningSums:
        """The same entries at the positions on the other side of 0."""
        return RunningSums(-self._position, self._column, self._value)

    @property
    def chained(self) -> bool:
        """Whether there are columns of running totals."""
        return self._chain is not None

    def over(self, draft: Draft, low: Ints, high: Ints) -> Terms:
        """The sums over the positions `low[i] .. high[i]`, by a chain where that is far shorter."""
        begin, end = self._runs(low, high)
        written = int((end - begin).sum())
        if self._chain is None and written > _WORTH * (3 * len(self._position) + 2 * len(begin)):
            self.chain(draft)
        return self.known(low, high)

    def known(self, low: Ints, high: Ints) -> Terms:
        """The same sums with the columns there are."""
        begin, end = self._runs(low, high)
        if self._chain is None:
            count = end - begin
            index = np.repeat(np.arange(len(begin)), count)
            entry = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count - begin, count)
            return index, self._column[entry], self._value[entry]
        last, before = np.flatnonzero(end > begin), np.flatnonzero((end > begin) & (begin > 0))
        return (
            np.concatenate([last, before]),
            self._chain[self._place[np.concatenate([end[last], begin[before]]) - 1]],
            np.concatenate([np.ones(len(last)), -np.ones(len(before))]),
        )

    def chain(self, draft: Draft) -> Ints:
        """The running total up to and with each of `positions`, as columns."""
        if self._chain is None:
            count = len(self.positions)
            self._chain = draft.columns(count)
            own, after = np.arange(count), np.arange(1, count)
            draft.rows(
                np.concatenate([own, after, self._place]),
                np.concatenate([self._chain, self._chain[:-1], self._column]),
                np.concatenate([np.ones(count), -np.ones(len(after)), -self._value]),
                lower=np.zeros(count),
                upper=0.0,
                kind="running total",
            )
        return self._chain

    def _runs(self, low: Ints, high: Ints) -> tuple[Ints, Ints]:
        """Where the entries of each sum begin and end."""
        begin = np.searchsorted(self._position, low, side="left")
        end = np.searchsorted(self._position, high, side="right")
        return begin, np.maximum(end, begin)
