"""Sequences that are kept by what many items in a row have in common."""

from __future__ import annotations

from abc import abstractmethod
from bisect import bisect_right
from collections.abc import Iterator, Sequence
from functools import cached_property
from itertools import accumulate
from typing import Any, Generic, TypeVar, overload

from tsplan.name_runs import Run, within

ItemT = TypeVar("ItemT")


class Unfolded(Sequence[ItemT], Generic[ItemT]):
    """One item for every name of some runs; each is made when it is looked at.

    It is equal to any sequence of the same items, and what it makes of equal items is equal.
    """

    @property
    @abstractmethod
    def order(self) -> tuple[tuple[Any, ...], ...]:
        """Rows that begin with a run of names, in the order of the items."""

    @abstractmethod
    def made(self, row: Any, name: str) -> ItemT:
        """The item of a row for a name."""

    @cached_property
    def _ends(self) -> tuple[int, ...]:
        return tuple(accumulate(row[0].size for row in self.order))

    def __len__(self) -> int:
        return self._ends[-1] if self.order else 0

    @overload
    def __getitem__(self, place: int) -> ItemT: ...
    @overload
    def __getitem__(self, place: slice) -> tuple[ItemT, ...]: ...
    def __getitem__(self, place: int | slice) -> ItemT | tuple[ItemT, ...]:
        if isinstance(place, slice):
            return tuple(self[n] for n in range(*place.indices(len(self))))
        number = within(place, len(self))
        row = self.order[at := bisect_right(self._ends, number)]
        names: Run = row[0]
        return self.made(row, names.name(number - self._ends[at] + names.size))

    def __iter__(self) -> Iterator[ItemT]:
        return (self.made(row, name) for row in self.order for name in row[0].names())

    def __eq__(self, other: object) -> bool:
        if isinstance(other, type(self)):
            return self.order == other.order
        if not isinstance(other, tuple | list):
            return NotImplemented
        return len(self) == len(other) and all(a == b for a, b in zip(self, other, strict=True))

    def __hash__(self) -> int:
        return hash(tuple(self))  # as equal tuples have it
