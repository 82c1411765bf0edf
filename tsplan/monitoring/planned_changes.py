"""What is planned to change at which step, for all agents at once."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

Codes: TypeAlias = npt.NDArray[np.int64]


class Change(NamedTuple):
    """Agents that go one way are somewhere else from a step on: a state by its number, or away."""

    step: int
    way: int
    code: int


class PlannedChanges:
    """Changes in the order of steps; each way has the rows of some agents.

    >>> table = PlannedChanges([Change(2, 0, 5), Change(1, 1, 4), Change(2, 1, 3)], [[0], [2, 7]])
    >>> [part.tolist() for part in table.at(2)]
    [[0, 2, 7], [5, 3, 3]]
    """

    def __init__(self, changes: Iterable[Change], ways: Sequence[Sequence[int]]) -> None:
        table = np.array(list(changes), dtype=np.int64).reshape(-1, 3)
        table = table[np.argsort(table[:, 0], kind="stable")]
        self._steps, self._ways, self._codes = table.T
        self._sizes = np.array([len(rows) for rows in ways], dtype=np.int64)
        self._begins = np.cumsum(self._sizes) - self._sizes
        self._rows = np.array([row for rows in ways for row in rows], dtype=np.int64)

    def at(self, step: int) -> tuple[Codes, Codes]:
        """The rows of all agents for which something changes at a step, and where each is then."""
        begin, end = np.searchsorted(self._steps, [step, step + 1]).tolist()
        ways, codes = self._ways[begin:end], self._codes[begin:end]
        sizes = self._sizes[ways]
        within = np.arange(int(sizes.sum())) - np.repeat(np.cumsum(sizes) - sizes, sizes)
        return self._rows[np.repeat(self._begins[ways], sizes) + within], np.repeat(codes, sizes)
