"""Who can be where in time, by travel times alone: an exact small search before any LP.

Choices and covers ask for one of their columns each; columns exclude each other. A *timetable* is a
set of columns that answers everything that is asked for. Every plan has one, so a column that is in
none is 0 in all plans, and if there is none at all there is no plan. The search takes what is asked
for that leaves fewest columns open, tries each of them, and drops what it excludes (forward
checking with the smallest domain first).

Source: R. Haralick and G. Elliott, "Increasing tree search efficiency for constraint satisfaction
problems", Artificial Intelligence 14, 1980.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from tsplan.encode.rivals.rival_columns import bits

_TRIES = 10_000  # of about ten microseconds each


class Wanted(NamedTuple):
    """One of the columns `members` is 1, where one of `parents` is or in any case (None)."""

    parents: int | None
    members: int


class Timetables:
    """Finds timetables; sets of columns are the bits of numbers, as in `RivalColumns`.

    Of `tries`, each of which takes in one more column, all questions together have so many.

    >>> a, b, c, d = (1 << place for place in range(4))
    >>> either, one, two = Wanted(None, a | b), Wanted(None, c), Wanted(a, d)
    >>> Timetables([either, one, two], [b, a, d, c], a | b | c | d).ruled_out() == a | d
    True
    """

    def __init__(
        self, wanted: Sequence[Wanted], excluded: Sequence[int], possible: int, tries: int = _TRIES
    ) -> None:
        self._wanted = tuple(wanted)
        self._excluded = tuple(excluded)
        self._possible = possible
        self._tries = tries
        self._seen = 0

    def ruled_out(self) -> int | None:
        """Columns that are in no timetable; None if there is no timetable.

        Where that takes too many tries, those of which it is known.
        """
        everything = 0
        for _, members in self._wanted:
            everything |= members
        possible = self._possible
        try:
            if not self._found(0, possible):
                return None
            for place in bits(everything & possible):
                column = 1 << place
                if not (column & self._seen or self._found(column, possible & self._beside(place))):
                    possible ^= column
        except _OutOfTriesError:
            pass
        return everything & ~possible

    def _beside(self, place: int) -> int:
        """What may be 1 where one column is."""
        return ~self._excluded[place]

    def _found(self, ones: int, possible: int) -> bool:
        """Whether there is a timetable with the columns `ones`; what is in it has been seen."""
        self._tries -= 1
        if self._tries < 0:
            raise _OutOfTriesError
        fewest = self._most_pressing(ones, possible)
        if fewest is None:
            self._seen |= ones
            return True
        for place in [*bits(fewest & ~self._seen), *bits(fewest & self._seen)]:
            if self._found(ones | 1 << place, possible & self._beside(place)):
                return True
            possible &= ~(1 << place)
        return False

    def _most_pressing(self, ones: int, possible: int) -> int | None:
        """The columns left for what is asked for and has fewest; None if all is answered."""
        fewest, count = None, 0
        for parents, members in self._wanted:
            if members & ones or not (parents is None or parents & ones):
                continue
            left = members & possible
            if fewest is None or left.bit_count() < count:
                fewest, count = left, left.bit_count()
            if not left:
                break
        return fewest


class _OutOfTriesError(Exception):
    """There were not enough tries."""
