"""Which robot of a team has which name, asked of many names in a row at once."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from tsplan.name_runs import Run

if TYPE_CHECKING:
    from tsplan.mission.team import Rank


class Roster:
    """The robots of some ranks by their names."""

    def __init__(self, ranks: Iterable[Rank]) -> None:
        self._of: dict[str, list[Rank]] = {}
        for rank in sorted(ranks, key=lambda rank: rank.names):
            self._of.setdefault(rank.names.stem, []).append(rank)

    def __contains__(self, name: str) -> bool:
        return self.rank(name) is not None

    def rank(self, name: str) -> Rank | None:
        """The rank in which a robot of this name is."""
        return next(rank for _, rank in self.parts(Run.of(name)))

    def parts(self, names: Run) -> Iterator[tuple[Run, Rank | None]]:
        """The names in order, as many at a time as are of one rank; None for those of nobody.

        >>> from tsplan.mission import Rank
        >>> roster = Roster([Rank(Run("a-", 1, 3), "a", frozenset(), "p", 0)])
        >>> [(tuple(part.names()), rank and rank.start) for part, rank in roster.parts(
        ...     Run("a-", 2, 5))]
        [(('a-2', 'a-3'), 'p'), (('a-4', 'a-5'), None)]
        """
        mine = self._of.get(names.stem, [])
        begin = names.first
        for rank in mine[max(bisect_right(mine, begin, key=lambda r: r.names.first) - 1, 0) :]:
            part = rank.names.common(Run(names.stem, begin, names.last))
            if part is None:
                if rank.names.first > names.last:
                    break
                continue
            if part.first > begin:
                yield Run(names.stem, begin, part.first - 1), None
            yield part, rank
            begin = part.last + 1
        if begin <= names.last:
            yield Run(names.stem, begin, names.last), None
