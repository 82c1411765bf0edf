"""Names that count on, such as `scout-1`, `scout-2`, ..., kept by their first and last number.

A team of a million has a million names, and hardly more than its classes to say about them.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import accumulate, chain, pairwise
from typing import Generic, NamedTuple, Protocol, Self, TypeVar, overload

T = TypeVar("T")

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


def counterpart(part: Run, own: Run, other: Run) -> Run:
    """The names among the other ones that stand where a part stands among its own.

    >>> counterpart(Run("a-", 3, 4), Run("a-", 2, 9), Run("b-", 11, 18))
    Run(stem='b-', first=12, last=13)
    """
    begin = part.first - own.first
    return other.part(begin, begin + part.size)


class Continuing(Protocol):
    """What may go on in the next of its kind."""

    def continued(self, after: Self) -> Self | None:
        """Both as one, if the other goes on where this one ends."""


ContinuingT = TypeVar("ContinuingT", bound=Continuing)


def joined_runs(runs: Iterable[ContinuingT]) -> Iterator[ContinuingT]:
    """The same in the same order, those that continue each other as one.

    >>> list(joined_runs([Run("a-", 1, 2), Run("a-", 3, 3), Run("b")]))
    [Run(stem='a-', first=1, last=3), Run(stem='b', first=-1, last=-1)]
    """
    open_: ContinuingT | None = None
    for run in runs:
        both = None if open_ is None else open_.continued(run)
        if open_ is not None and both is None:
            yield open_
        open_ = run if both is None else both
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

    def among(self, run: Run) -> int:
        """How many names of a run are among these.

        >>> Names((Run("a-", 1, 5), Run("a-", 8, 9))).among(Run("a-", 4, 8))
        3
        """
        mine = self._by_stem.get(run.stem, [])
        first = bisect_left(mine, run.first, key=lambda own: own.last)
        end = bisect_right(mine, run.last, key=lambda own: own.first)
        both = (own.common(run) for own in mine[first:end])
        return sum(part.size for part in both if part is not None)

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


class RunMap(Generic[T]):
    """Values by names, given to many names in a row at once; what is given later counts.

    >>> made = RunMap([(Run("a-", 1, 9), "x"), (Run("a-", 4, 5), "y")])
    >>> [(f"{part.first}..{part.last}", value) for part, value in made.parts(Run("a-", 3, 11))]
    [('3..3', 'x'), ('4..5', 'y'), ('6..9', 'x'), ('10..11', None)]
    """

    def __init__(self, rows: Iterable[tuple[Run, T]] = ()) -> None:
        self._of: dict[str, list[tuple[int, int, T]]] = {}
        for names, value in rows:
            self.give(names, value)

    def __len__(self) -> int:
        return sum(last - first + 1 for mine in self._of.values() for first, last, _ in mine)

    def give(self, names: Run, value: T) -> None:
        """Give a value to some names, in place of what they have."""
        mine = self._of.setdefault(names.stem, [])
        begin = bisect_left(mine, names.first, key=lambda span: span[1])
        end = bisect_right(mine, names.last, lo=begin, key=lambda span: span[0])
        new = [(names.first, names.last, value)]
        if begin < end:
            first, _, before = mine[begin]
            _, last, after = mine[end - 1]
            new = [(first, names.first - 1, before)] * (first < names.first) + new
            new += [(names.last + 1, last, after)] * (last > names.last)
        mine[begin:end] = new

    def parts(self, names: Run) -> Iterator[tuple[Run, T | None]]:
        """The names in order, as many at a time as were given a value together; None without."""
        mine = self._of.get(names.stem, [])
        begin = names.first
        for place in range(bisect_left(mine, begin, key=lambda span: span[1]), len(mine)):
            first, last, value = mine[place]
            if first > names.last:
                break
            if first > begin:
                yield Run(names.stem, begin, first - 1), None
            yield Run(names.stem, max(first, begin), min(last, names.last)), value
            begin = last + 1
        if begin <= names.last:
            yield Run(names.stem, begin, names.last), None

    def get(self, name: str) -> T | None:
        """The value of one name."""
        return next(value for _, value in self.parts(Run.of(name)))


def overlaid(rows: Iterable[tuple[Run, T]]) -> Iterator[tuple[Run, list[T]]]:
    """Names that rows name, as many in a row as are named by the same ones, with all values.

    >>> made = overlaid([(Run("a-", 1, 5), "x"), (Run("a-", 4, 6), "y")])
    >>> [(part.first, part.last, values) for part, values in made]
    [(1, 3, ['x']), (4, 5, ['x', 'y']), (6, 6, ['y'])]
    """
    of: dict[str, list[tuple[Run, T]]] = {}
    for row in rows:
        of.setdefault(row[0].stem, []).append(row)
    for stem, mine in of.items():
        mine.sort(key=lambda row: row[0].first)
        cuts = sorted({cut for run, _ in mine for cut in (run.first, run.last + 1)})
        open_: list[tuple[Run, T]] = []
        coming = 0
        for begin, end in pairwise(cuts):
            open_ = [row for row in open_ if row[0].last >= begin]
            while coming < len(mine) and mine[coming][0].first == begin:
                open_.append(mine[coming])
                coming += 1
            if open_:
                yield Run(stem, begin, end - 1), [value for _, value in open_]


def within(place: int, size: int) -> int:
    """A place of a sequence counted from its beginning; IndexError for one outside it."""
    number = place + size if place < 0 else place
    if not 0 <= number < size:
        raise IndexError(f"place {place} of {size}")
    return number
