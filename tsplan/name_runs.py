"""Names that count on, such as `scout-1`, `scout-2`, ..., kept by their first and last number.

A team of a million has a million names, and hardly more than its classes to say about them.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import accumulate, chain
from typing import NamedTuple, overload

_DIGITS = "0123456789"
_LONGEST = 15  # digits of a number
_NONE = -1  # in place of the number of a name without one


class Run(NamedTuple):
    """The names `stem` + n for every n of `first..last`; a single name without a number is a stem.

    A stem that is counted on does not end with a digit, so no two runs make one name twice.

    >>> list(Run("a-", 9, 11).names())
    ['a-9', 'a-10', 'a-11']
    """

    stem: str
    first: int = _NONE
    last: int = _NONE

    @classmethod
    def of(cls, name: str) -> Run:
        """A name by itself.

        >>> Run.of("a-7"), Run.of("a-07")
        (Run(stem='a-', first=7, last=7), Run(stem='a-07', first=-1, last=-1))
        """
        stem = name.rstrip(_DIGITS)
        digits = name[len(stem) :]
        if not 0 < len(digits) <= _LONGEST or (digits[0] == "0" and digits != "0"):
            return cls(name)
        number = int(digits)
        return cls(stem, number, number)

    @property
    def size(self) -> int:
        """How many names there are."""
        return self.last - self.first + 1

    @property
    def counted(self) -> bool:
        """Whether the names have numbers."""
        return self.first != _NONE

    def name(self, place: int = 0) -> str:
        """The name at a place, from 0 on."""
        return f"{self.stem}{self.first + place}" if self.counted else self.stem

    def names(self) -> Iterator[str]:
        """All names in a row."""
        if not self.counted:
            return iter((self.stem,))
        return (f"{self.stem}{number}" for number in range(self.first, self.last + 1))

    def part(self, begin: int, end: int) -> Run:
        """The names at the places from `begin` to before `end`.

        >>> Run("a-", 1, 9).part(2, 4)
        Run(stem='a-', first=3, last=4)
        """
        return Run(self.stem, self.first + begin, self.first + end - 1) if self.counted else self

    def continued(self, after: Run) -> Run | None:
        """Both runs as one, if the other goes on where this one ends."""
        if self.stem == after.stem and after.first == self.last + 1 and self.counted:
            return Run(self.stem, self.first, after.last)
        return None

    def common(self, other: Run) -> Run | None:
        """The names that are in both.

        >>> Run("a-", 1, 5).common(Run("a-", 4, 9))
        Run(stem='a-', first=4, last=5)
        """
        first, last = max(self.first, other.first), min(self.last, other.last)
        return Run(self.stem, first, last) if self.stem == other.stem and first <= last else None


def joined_runs(runs: Iterable[Run]) -> Iterator[Run]:
    """The same names in the same order, in as few runs as can be."""
    open_: Run | None = None
    for run in runs:
        both = None if open_ is None else open_.continued(run)
        if open_ is not None and both is None:
            yield open_
        open_ = both or run
    if open_ is not None:
        yield open_


@dataclass(frozen=True, eq=False, repr=False)
class Names(Sequence[str]):
    """Names in an order, in as few runs as can be; equal to any sequence of the same names.

    >>> Names.of(["a-1", "a-2", "b"]) == ("a-1", "a-2", "b")
    True
    """

    runs: tuple[Run, ...]

    @classmethod
    def of(cls, names: Sequence[str]) -> Names:
        """The names of any sequence."""
        if isinstance(names, Names):
            return names
        return cls(tuple(joined_runs(map(Run.of, names))))

    @classmethod
    def joined(cls, runs: Iterable[Run]) -> Names:
        """The names of some runs, one after the other."""
        return cls(tuple(joined_runs(runs)))

    @cached_property
    def _ends(self) -> tuple[int, ...]:
        return tuple(accumulate(run.size for run in self.runs))

    @cached_property
    def _by_stem(self) -> dict[str, list[Run]]:
        """The same names, sorted, those of overlapping runs once."""
        found: dict[str, list[Run]] = {}
        for run in sorted(self.runs):
            mine = found.setdefault(run.stem, [])
            if mine and run.first <= mine[-1].last:
                mine[-1] = Run(run.stem, mine[-1].first, max(mine[-1].last, run.last))
            else:
                mine.append(run)
        return found

    def __len__(self) -> int:
        return self._ends[-1] if self.runs else 0

    @overload
    def __getitem__(self, place: int) -> str: ...
    @overload
    def __getitem__(self, place: slice) -> tuple[str, ...]: ...
    def __getitem__(self, place: int | slice) -> str | tuple[str, ...]:
        if isinstance(place, slice):
            return tuple(self[n] for n in range(*place.indices(len(self))))
        number = within(place, len(self))
        run = bisect_right(self._ends, number)
        return self.runs[run].name(number - self._ends[run] + self.runs[run].size)

    def __iter__(self) -> Iterator[str]:
        return chain.from_iterable(run.names() for run in self.runs)

    def __contains__(self, name: object) -> bool:
        if not isinstance(name, str):
            return False
        one = Run.of(name)
        mine = self._by_stem.get(one.stem, [])
        place = bisect_right(mine, one.first, key=lambda run: run.first) - 1
        return place >= 0 and one.first <= mine[place].last

    def __eq__(self, other: object) -> bool:
        if isinstance(other, Names):
            return self.runs == other.runs
        if not isinstance(other, tuple | list):
            return NotImplemented
        return len(self) == len(other) and all(a == b for a, b in zip(self, other, strict=True))

    def __hash__(self) -> int:
        return hash(tuple(self))  # as equal tuples have it

    def __repr__(self) -> str:
        return f"Names({', '.join(map(repr, self.runs))})"


def within(place: int, size: int) -> int:
    """A place of a sequence counted from its beginning; IndexError for one outside it."""
    number = place + size if place < 0 else place
    if not 0 <= number < size:
        raise IndexError(f"place {place} of {size}")
    return number
