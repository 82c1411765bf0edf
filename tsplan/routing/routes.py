"""The cheapest routes of single agents by appointments, each of which is worth something.

A route goes by places at which needs want somebody, each in the window of steps that its
appointment allows. Labels are made backwards from the ends of routes, all of one length at once:
what the rest of the route costs, and when the agent has to be there at the latest. Routes may come
by a need again if that is far from what they came by since; so they are a relaxation of what agents
can do.

Source: R. Baldacci, A. Mingozzi, R. Roberti, "New route relaxation and pricing strategies for the
vehicle routing problem", Operations Research 59, 2011 (ng-routes).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from tsplan.milp.model import Floats, Ints

_MOST = 50_000  # labels of one length; more of them are told apart by less
_SAME = 1e-9  # costs that are told apart no more
_EACH = 8  # routes from one start that are told
_FEW = 1_000  # labels of one length that are followed in a hurry
_BITS = 62  # of a whole number


@dataclass(frozen=True, eq=False)
class Visits:
    """Places at which one agent may serve a need: `need` and `place`, from `first` to `last`."""

    need: Ints
    place: Ints
    first: Floats
    last: Floats

    def some(self, kept: Ints) -> Visits:
        """Some of the visits."""
        return Visits(self.need[kept], self.place[kept], self.first[kept], self.last[kept])


class Route(NamedTuple):
    """What a route costs, less what its visits are worth, and these in order."""

    reduced: float
    start: int
    visits: tuple[int, ...]


@dataclass(frozen=True, eq=False)
class _Labels:
    """Ends of routes of one length; `parent` are the positions of the rest in the one before."""

    memory: Ints
    visit: Ints
    cost: Floats
    latest: Floats
    parent: Ints

    def some(self, kept: Ints) -> _Labels:
        ints = self.memory[kept], self.visit[kept]
        return _Labels(*ints, self.cost[kept], self.latest[kept], self.parent[kept])


@dataclass(frozen=True, eq=False)
class Pricing:
    """Routes of one class from some `starts`, places whose distances are given in two tables.

    From one need to another an agent takes as many steps as they are `apart`, too. Of needs that
    are the `same` one follows the other, or there is only one of them on a route.
    """

    visits: Visits
    starts: Ints
    steps: Floats
    prices: Floats
    apart: Floats
    same: Ints
    _near: Ints = field(init=False)

    def __post_init__(self) -> None:
        """Sort the needs by how near they are to each other, those that are the same as one."""
        of = self.same[self.visits.need]
        order = np.argsort(of, kind="stable")
        places = self.visits.place[order]
        table = self.prices[np.ix_(places, places)]
        begin = np.searchsorted(of[order], np.unique(of))
        table = np.minimum.reduceat(np.minimum.reduceat(table, begin, axis=0), begin, axis=1)
        np.fill_diagonal(table, -1.0)
        object.__setattr__(self, "_near", np.argsort(table, axis=1, kind="stable"))

    def some(self, worth: Floats) -> list[Route]:
        """Some routes of a reduced cost below 0, in a hurry: there may be others."""
        found = self._layers(worth, np.flatnonzero(worth > _SAME), 8, hurried=True)
        return [] if found is None else self._told(found)[1]

    def cheapest(self, worth: Floats) -> tuple[Floats, list[Route]]:
        """The least reduced cost of a route from every start, at most 0, and some that have less.

        `worth` is what each visit is worth.
        """
        good = np.flatnonzero(worth > _SAME)
        for memory in (8, 4, 1):
            found = self._layers(worth, good, memory)
            if found is not None:
                return self._told(found)
        raise AssertionError("routes without a memory are few")

    def _layers(
        self, worth: Floats, good: Ints, memory: int, *, hurried: bool = False
    ) -> list[_Labels] | None:
        """Labels by the length of their routes; None if they are too many, or else only the best.

        The latter where it is `hurried`.
        """
        visits = self.visits.some(good)
        same = self.same[visits.need]
        of = np.searchsorted(np.unique(self.same[self.visits.need]), same)
        bit = np.left_shift(1, np.arange(len(self._near)) % 63)
        known = np.array([bit[near[:memory]].sum() for near in self._near], dtype=np.int64)
        steps, prices = (table[np.ix_(visits.place, visits.place)] for table in self._tables)
        steps = np.maximum(steps, self.apart[np.ix_(visits.need, visits.need)])
        soonest = self.steps[np.ix_(self.starts, visits.place)].min(axis=0, initial=np.inf)
        earliest = np.maximum(visits.first, soonest)
        now = np.flatnonzero(earliest <= visits.last)
        labels = _Labels(bit[of[now]], now, -worth[good[now]], visits.last[now], now)
        layers = [labels]
        after = (same[:, None] == same) & (visits.need[:, None] != visits.need)
        for _ in range(1, len(np.unique(self.visits.need))):
            new = (labels.memory[:, None] & bit[of]) == 0
            row, visit = np.nonzero(new | after[labels.visit])
            rest = labels.visit[row]
            latest = np.minimum(visits.last[visit], labels.latest[row] - steps[visit, rest])
            kept = np.flatnonzero(latest >= earliest[visit])
            row, visit, rest = row[kept], visit[kept], rest[kept]
            cost = labels.cost[row] + prices[visit, rest] - worth[good[visit]]
            remembered = (labels.memory[row] & known[of[visit]]) | bit[of[visit]]
            labels = _best(_Labels(remembered, visit, cost, latest[kept], row))
            if hurried and len(labels.visit) > _FEW:
                labels = labels.some(np.argpartition(labels.cost, _FEW)[:_FEW])
            if len(labels.visit) > _MOST and memory > 1:
                return None
            if not len(labels.visit):
                break
            layers.append(labels)
        return [_Labels(each.memory, good[each.visit], *_rest(each)) for each in layers]

    @property
    def _tables(self) -> tuple[Floats, Floats]:
        return self.steps, self.prices

    def _told(self, layers: list[_Labels]) -> tuple[Floats, list[Route]]:
        least = np.zeros(len(self.starts))
        routes: list[Route] = []
        for number, start in enumerate(self.starts.tolist()):
            found: list[tuple[float, int, int]] = []
            for length, labels in enumerate(layers):
                place = self.visits.place[labels.visit]
                late = self.steps[start, place] > labels.latest
                cost = np.where(late, np.inf, self.prices[start, place] + labels.cost)
                best = np.argsort(cost, kind="stable")[:_EACH]
                found += [(float(cost[n]), length, n) for n in best.tolist() if cost[n] < -_SAME]
            found.sort()
            least[number] = found[0][0] if found else 0.0
            for reduced, length, label in found[:_EACH]:
                routes.append(Route(reduced, start, tuple(_followed(layers, length, label))))
        return least, routes


def _rest(labels: _Labels) -> tuple[Floats, Floats, Ints]:
    return labels.cost, labels.latest, labels.parent


def _followed(layers: list[_Labels], length: int, label: int) -> Iterator[int]:
    for labels in layers[length::-1]:
        yield int(labels.visit[label])
        label = int(labels.parent[label])


def _keys(labels: _Labels) -> list[Ints]:
    """By what labels are told apart: one number for visit and memory where that is large enough."""
    most, known = int(labels.visit.max(initial=0)), int(labels.memory.max(initial=0))
    if most.bit_length() + known.bit_length() > _BITS:
        return [labels.visit, labels.memory]
    return [labels.memory << most.bit_length() | labels.visit]


def _best(labels: _Labels) -> _Labels:
    """Without labels that another of the same visit and memory undercuts in cost and time."""
    order = np.lexsort((-labels.latest, labels.cost, *_keys(labels)))
    labels = labels.some(order)
    if not len(order):
        return labels
    new = np.ones(len(order), dtype=np.bool_)
    same = (labels.memory[1:] == labels.memory[:-1]) & (labels.visit[1:] == labels.visit[:-1])
    new[1:] = ~same
    shift = np.cumsum(new) * (2.0 * float(np.abs(labels.latest).max()) + 1.0)
    most = np.maximum.accumulate(labels.latest + shift)
    kept = new.copy()
    kept[1:] |= (labels.latest + shift)[1:] > most[:-1]
    return labels.some(np.flatnonzero(kept))
