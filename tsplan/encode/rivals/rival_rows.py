"""Rows that say which witnesses exclude each other, and which are in no timetable.

* Columns that no timetable has are 0; where there is no timetable at all there is no plan.
* *Cliques*: of columns of several choices of which any two exclude each other at most one is 1. Of
  two choices these are the witnesses that begin in one window and those that begin in another, too
  near to each other for the way there or back. In the LP both tasks would be served half by the
  same agents; so one of them has to give way.
* *Ways out*: where witnesses of a choice exclude some of the columns that cover a window, one of
  the others is 1. Otherwise the LP spreads a little over the whole window.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from functools import reduce
from itertools import combinations
from operator import and_
from typing import NamedTuple, TypeAlias

from tsplan.encode.encoder_rules import Witnesses
from tsplan.encode.flow_network import Network
from tsplan.encode.rivals.rival_columns import RivalColumns, bits, rival_columns
from tsplan.encode.rivals.timetable import Timetables, Wanted
from tsplan.encode.selection import ALWAYS, Selection
from tsplan.encode.structure_flows import Change
from tsplan.milp.model import Block, Draft

_SHARE = 3  # of a window at least a third is excluded: rows about less say little
_MOST_ROWS = 2000  # of one kind; where there are more, LPs would take longer than they save


class _Order(NamedTuple):
    """Places of the columns of a choice in the order of their steps, and the choices above it."""

    choice: int
    places: list[int]
    above: frozenset[int]


def rival_rows(
    witnesses: Witnesses, network: Network, draft: Draft, changes: Sequence[Change] = ()
) -> None:
    """Rule out witnesses by timetables, and say which of the others exclude each other.

    The states at which agents are needed must be nodes of the map of every class
    (`encode.precedence.placed`). By `changes` structures of modules become others.
    """
    rivals = rival_columns(witnesses, network, changes)
    if rivals is None:
        return
    asked = _Asked(rivals, witnesses)
    tables = Timetables(asked.wanted(), asked.excluded(), ~rivals.impossible)
    none = None if rivals.refuted else tables.ruled_out()
    if none is None:
        witnesses.choices.refute(ALWAYS, "rivals")
        return
    none |= rivals.impossible
    if none:
        witnesses.choices.refute(tuple(rivals.chosen(none)), "rivals")
    orders = asked.orders(~none)
    for rows in (_cliques(rivals, orders), asked.ways_out(orders)):
        if len(rows) <= _MOST_ROWS:
            block = Block("rivals")
            for more, less, lower in rows:
                block.add((0, more, 1.0), (0, less, -1.0), lower=lower)
            block.write(draft)


_Row: TypeAlias = tuple[Sequence[int], Sequence[int], float]
"""Columns whose sum, less that of others, is at least a number."""


class _Asked:
    """What is asked of the columns of rivals, whose sets are the bits of numbers."""

    def __init__(self, rivals: RivalColumns, witnesses: Witnesses) -> None:
        self._rivals = rivals
        self._choices = witnesses.choices
        self._covers = witnesses.covers
        self._place = {column: place for place, column in enumerate(rivals.columns)}

    def wanted(self) -> list[Wanted]:
        """A column of each choice and each cover, and a parent of each that is chosen.

        Nothing is said of choices between columns some of which are nobody's rivals.
        """
        found = []
        for parent, columns in self._choices.exact:
            found.append(Wanted(self._under(parent), self._all(columns.tolist())))
            if parent:
                found.append(Wanted(self._known(columns.tolist()), self._all(parent)))
        for cover in self._covers:
            members = cover.columns[cover.begin : cover.end].tolist()
            found.append(Wanted(self._under(cover.selection), self._all(members)))
        return [want for want in found if want.members and want.parents != 0]

    def excluded(self) -> list[int]:
        """What each column excludes: its rivals, others of its choice, and what its window does."""
        found = list(self._rivals.excluded)
        for columns in self._choices.groups:
            mine = self._known(columns.tolist())
            for place in bits(mine):
                found[place] |= mine & ~(1 << place)
        for relayed in self._choices.relays:
            parents, low, high, times = relayed.waiting
            for parent, begin, end in zip(parents.tolist(), low, high, strict=True):
                late = relayed.columns[(times < begin) | (times > end)]
                outside = self._known(late.tolist()) if parent in self._place else 0
                for place in bits(outside):
                    found[place] |= 1 << self._place[parent]
                    found[self._place[parent]] |= 1 << place
        return found

    def orders(self, among: int) -> list[_Order]:
        """Those of some columns that are of one choice, for every choice."""
        step = dict(zip(self._choices.columns, self._choices.steps, strict=True))
        above = self._above()
        found = []
        for choice, group in enumerate(self._choices.groups):
            mine = bits(self._known(group.tolist()) & among)
            mine.sort(key=lambda place: step[self._rivals.columns[place]])
            found.append(_Order(choice, mine, frozenset(above.get(choice, ()))))
        return [order for order in found if order.places]

    def _above(self) -> dict[int, set[int]]:
        """The choices that those of a number descend from."""
        groups = self._choices.groups
        of = {column: choice for choice, group in enumerate(groups) for column in group.tolist()}
        above: dict[int, set[int]] = {}
        for parent, columns in self._choices.exact:  # parents are made before their children
            parents = {of[column] for column in parent if column in of}
            mine = parents.union(*(above.get(choice, ()) for choice in parents))
            above |= dict.fromkeys((of[column] for column in columns.tolist()), mine)
        return above

    def ways_out(self, orders: Sequence[_Order]) -> list[_Row]:
        """For witnesses of a choice that exclude much of a window: one of the rest is 1."""
        found: list[_Row] = []
        for cover in self._covers:
            members = cover.columns[cover.begin : cover.end].tolist()
            known = self._known(members)
            for order in orders:
                for run, common in _runs(order, self._rivals.excluded, known):
                    if common.bit_count() * _SHARE >= len(members):
                        lost = set(self._rivals.chosen(common))
                        rest = [column for column in members if column not in lost]
                        less = [*self._rivals.chosen(run), *cover.selection]
                        found.append((rest, less, -1.0 if cover.selection else 0.0))
        return found

    def _known(self, columns: Iterable[int]) -> int:
        """Those of some columns that are somebody's rivals."""
        return _set(self._place[column] for column in columns if column in self._place)

    def _all(self, columns: Sequence[int]) -> int:
        """Some columns if all of them are somebody's rivals, or none of them."""
        known = self._known(columns)
        return known if known.bit_count() == len(columns) else 0

    def _under(self, parent: Selection) -> int | None:
        return self._known(parent) if parent else None


def _cliques(rivals: RivalColumns, orders: Sequence[_Order]) -> list[_Row]:
    """Of columns of which any two exclude each other at most one is 1.

    How far a choice lies behind those that it descends from is said elsewhere
    (`encode.precedence`).
    """
    every = [_set(order.places) for order in orders]
    found: dict[int, None] = {}
    for one, other in combinations(range(len(orders)), 2):
        if orders[one].choice in orders[other].above or orders[other].choice in orders[one].above:
            continue
        for run, common in _runs(orders[one], rivals.excluded, every[other]):
            found[_grown(run | common, rivals.excluded, every)] = None
    return [((), rivals.chosen(clique), -1.0) for clique in found]


def _grown(clique: int, excluded: Sequence[int], every: Sequence[int]) -> int:
    """A clique with what all of it excludes, choice after choice."""
    common = reduce(and_, (excluded[place] for place in bits(clique)))
    for mine in every:
        more = common & mine
        clique |= more
        common = reduce(and_, (excluded[place] for place in bits(more)), common)
    return clique


def _runs(order: _Order, excluded: Sequence[int], among: int) -> Iterator[tuple[int, int]]:
    """Runs of columns that exclude some `among` others, and those that all of them exclude.

    Only runs that would exclude less if they were longer.
    """
    places = order.places
    for begin in range(len(places)):
        common = among
        for end in range(begin, len(places)):
            common &= excluded[places[end]]
            if not common:
                break
            beside = [*places[end + 1 : end + 2], *places[max(begin - 1, 0) : begin]]
            if all(common & ~excluded[place] for place in beside):
                yield _set(places[begin : end + 1]), common


def _set(places: Iterable[int]) -> int:
    return sum(1 << place for place in places)
