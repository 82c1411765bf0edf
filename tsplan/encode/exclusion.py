"""Which indicator columns can never be 1 together, told by the choices that they descend from.

A *choice* has numbered options, its columns, of which at most one is 1. A column's *ancestry* names
the choices above it and the options it may have come by: the first and the last of them, since the
options that lead to one place are a run of steps nearly always (what lies between is taken to be
among them, which claims less). Two columns exclude each other when the options they came by at
some choice lie apart.
"""

from __future__ import annotations

from bisect import bisect_left
from collections import defaultdict
from collections.abc import Iterable, Mapping
from itertools import islice
from typing import TypeAlias

Ancestry: TypeAlias = dict[int, tuple[int, int]]
"""Choice: the first and the last of the options that lead here."""

_MOST_FAMILIES = 64  # that a column is compared with; it is no loss to begin one more
_MOST_MEMBERS = 256  # of one family that a column is compared with one by one


def exclusive(first: Ancestry, second: Ancestry) -> bool:
    """Whether two ancestries diverge at some choice."""
    return any(
        first[key][1] < second[key][0] or second[key][1] < first[key][0]
        for key in first.keys() & second.keys()
    )


def common(ancestries: Iterable[Ancestry]) -> Ancestry:
    """What holds of all ancestries: choices above each of them, with the options of any."""
    found: Ancestry | None = None
    for ancestry in ancestries:
        if found is None:
            found = dict(ancestry)
        elif found is not ancestry:
            found = {
                key: (min(found[key][0], ancestry[key][0]), max(found[key][1], ancestry[key][1]))
                for key in found.keys() & ancestry.keys()
            }
    return found or {}


def families(ancestries: Mapping[int, Ancestry]) -> list[list[int]]:
    """Partition columns, greedily and in order, into families that exclude each other."""
    found: list[_Family] = []
    sharing: dict[int, list[int]] = defaultdict(list)  # choice: families all of which came by it
    for column, ancestry in ancestries.items():
        near = {n for key in ancestry for n in islice(sharing.get(key, ()), _MOST_FAMILIES)}
        for number in sorted(near):
            if found[number].takes(ancestry, ancestries):
                lost = found[number].add(column, ancestry)
                for key in lost:
                    sharing[key].remove(number)
                break
        else:
            found.append(_Family(column, ancestry))
            for key in ancestry:
                sharing[key].append(len(found) - 1)
    return [family.members for family in found]


class _Family:
    """Columns that exclude each other, found again by the options they descend from."""

    def __init__(self, column: int, ancestry: Ancestry) -> None:
        self.members = [column]
        self._ways = {key: _Ways(options, column) for key, options in ancestry.items()}

    def add(self, column: int, ancestry: Ancestry) -> set[int]:
        """Take in a column that all members exclude; the choices that are no longer shared."""
        self.members.append(column)
        lost = self._ways.keys() - ancestry.keys()
        for key in lost:
            del self._ways[key]
        for key, ways in self._ways.items():
            ways.add(ancestry[key], column)
        return lost

    def takes(self, ancestry: Ancestry, ancestries: Mapping[int, Ancestry]) -> bool:
        """Whether all members are seen to exclude a column.

        Members that went another way at a choice which all of them came by do so for sure.
        """
        fewest = self.members
        for key in self._ways.keys() & ancestry.keys():
            near = self._ways[key].near(ancestry[key])
            if len(near) < len(fewest):
                fewest = near
            if not fewest:
                return True
        if len(fewest) > _MOST_MEMBERS:
            return False
        return all(exclusive(ancestries[member], ancestry) for member in fewest)


class _Ways:
    """Runs of options of one choice that lie apart, and the members that came by each."""

    def __init__(self, options: tuple[int, int], column: int) -> None:
        self._first, self._last = [options[0]], [options[1]]
        self._members = [[column]]

    def _touched(self, options: tuple[int, int]) -> slice:
        begin = bisect_left(self._last, options[0])
        end = begin
        while end < len(self._first) and self._first[end] <= options[1]:
            end += 1
        return slice(begin, end)

    def near(self, options: tuple[int, int]) -> list[int]:
        """The members whose options may be among these."""
        runs = self._members[self._touched(options)]
        return runs[0] if len(runs) == 1 else [member for run in runs for member in run]

    def add(self, options: tuple[int, int], column: int) -> None:
        """Note a member; runs that now touch become one."""
        where = self._touched(options)
        first = min([options[0], *self._first[where]])
        last = max([options[1], *self._last[where]])
        members = self.near(options) if where.stop > where.start else []
        members.append(column)
        self._first[where], self._last[where] = [first], [last]
        self._members[where] = [members]
