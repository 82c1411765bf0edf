"""A bound on what agents that keep appointments pay at least, by routes of single agents.

Whoever serves a need is at one of its places at one step of its window, so every agent of a plan
has a route by the places of the needs that it serves, and pays for the ways in between at least. So
many routes visit every need as it asks for, no more begin at a place than agents do, and no place
has more visitors of one appointment than it holds. The linear program of all routes says what they
cost at least; those that matter are found as they are needed. Its dual values give a bound that
holds whatever they are: what all needs are worth, less what routes are worth more than they cost.

Source: J. Desrosiers, F. Soumis, M. Desrochers, "Routing with time windows by column generation",
Networks 14, 1984; the bound is that of L. S. Lasdon, "Optimization theory for large systems", 1970.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import combinations, product
from typing import TypeAlias

import numpy as np

from tsplan.clock import Clock
from tsplan.encode.objective_kinds import StageObjective
from tsplan.encode.priced_objectives import Priced
from tsplan.milp.lp import WarmLP
from tsplan.milp.model import INFINITY, Draft, Floats, Ints
from tsplan.routing.appointments import Agenda
from tsplan.routing.distances import Distances
from tsplan.routing.routes import Pricing, Visits
from tsplan.routing.tours import Tours

MOST_NEEDS = 62
"""Needs up to which routes are looked for: sets of them are whole numbers of 64 bits."""

_DEAR = 4.0  # what a need costs that no route serves, in longest ways
_NEAR = 0.7  # of the best prices so far in those that are tried
_CLOSE = 1e-6  # by which the program may be above the bound


@dataclass(frozen=True, eq=False)
class Windows:
    """The first and the last step at which each appointment may begin."""

    first: tuple[int, ...]
    last: tuple[int, ...]

    def cut(self, number: int, first: int, last: int) -> Windows:
        """With another window for one appointment."""
        sides = (self.first, first), (self.last, last)
        cut = ((*side[:number], step, *side[number + 1 :]) for side, step in sides)
        return Windows(*cut)

    @classmethod
    def of(cls, agenda: Agenda) -> Windows:
        """What the agenda says."""
        first, last = zip(*((item.first, item.last) for item in agenda.appointments), strict=True)
        return cls(first, last)


Key: TypeAlias = tuple[int, int, tuple[int, ...]]
"""A route: the number of a class, the place where it starts, and visits in order."""


@dataclass(frozen=True, eq=False)
class Stops:
    """The appointments of a route, and how long after the one before each is at soonest.

    The first of them is after step 0. It is the beginnings of appointments that are told apart.
    """

    numbers: tuple[int, ...]
    soonest: tuple[float, ...]


@dataclass(frozen=True, eq=False)
class Worth:
    """What serving needs is worth, and places that are limited, which is at most 0."""

    needs: Floats
    places: Floats

    def mixed(self, other: Worth, part: float) -> Worth:
        """A part of another, and the rest of this."""
        needs = part * other.needs + (1 - part) * self.needs
        return Worth(needs, part * other.places + (1 - part) * self.places)


@dataclass(eq=False)
class RouteBound:
    """The program of routes that keep an agenda, of `room` in states."""

    agenda: Agenda
    distances: Distances
    room: Mapping[int, int]
    used: list[Key] = field(default_factory=list, init=False)  # of the last program's solution

    def __post_init__(self) -> None:
        """Number the visits, and the rows of needs, of starts and of places."""
        agenda, distances = self.agenda, self.distances
        numbered = list(enumerate(agenda.needs))
        self._of = [n for n, item in enumerate(agenda.appointments) for _ in item.needs]
        every = [(number, state) for number, need in numbered for state in need.states]
        self._need = np.array([number for number, _ in every], dtype=np.int64)
        self._place = distances.places([state for _, state in every])
        self._begun = Counter(zip(distances.kind.tolist(), distances.begin.tolist(), strict=True))
        places = self._limited(every)
        self._rows = {key: row for row, key in enumerate(dict.fromkeys(places.values()))}
        self._limit = np.array([self.room[state] for _, _, state in self._rows], dtype=np.float64)
        self._full = np.full(len(every), -1)
        for visit, key in places.items():
            self._full[visit] = self._rows[key]
        self._routes: dict[Key, float] = {}

    def _limited(self, every: Sequence[tuple[int, int]]) -> dict[int, tuple[int, int, int]]:
        """The appointment (or need), step after its beginning and state of visits that are limited.

        Agents that serve two needs are counted twice, so then each need is limited by itself.
        """
        found = {}
        for visit, (number, state) in enumerate(every):
            item = self.agenda.appointments[self._of[number]]
            if state not in self.room:
                continue
            apart = not any(one.able & other.able for one, other in combinations(item.needs, 2))
            group = -1 - self._of[number] if apart else number
            found[visit] = group, self.agenda.needs[number].after[0], state
        return found

    # --- the program -----------------------------------------------------------------------------

    def begin_with(self, tours: Tours) -> None:
        """Know the routes of some tours."""
        number = {(self._need[v], self._place[v]): v for v in range(len(self._need))}
        first = np.searchsorted(self._of, np.arange(len(self.agenda.appointments))).tolist()
        routes: dict[int, list[int]] = {}
        for each in tours.order:
            for place, group in enumerate(tours.serving[each]):
                for agent, state in group:
                    visit = number[first[each] + place, self.distances.place[state]]
                    routes.setdefault(agent, []).append(visit)
        for agent, visits in routes.items():
            self._add(int(self.distances.kind[agent]), int(self.distances.begin[agent]), visits)

    def _add(self, kind: int, start: int, visits: Sequence[int]) -> bool:
        """Know one more route; False if it is known."""
        key = kind, start, tuple(visits)
        if key in self._routes:
            return False
        places = [start, *self._place[list(visits)].tolist()]
        self._routes[key] = float(self.distances.prices[kind, places[:-1], places[1:]].sum())
        return True

    def raised(self, clock: Clock, windows: Windows) -> Iterator[float]:
        """Better and better bounds, until the program is solved or the time is up.

        They are bounds of plans whose appointments begin within `windows`.
        """
        pricings = self._pricings(windows)
        for kind, (mine, pricing) in pricings.items():
            for start, visit in product(pricing.starts.tolist(), mine.tolist()):
                self._add(kind, start, [visit])
        best = 0.0
        centre = Worth(0.0 * self._many, 0.0 * self._limit)
        while not clock.over:
            solved = self._solved(windows, clock)
            if solved is None:
                return
            value, worth = solved
            for near in (_NEAR, 0.0):  # prices near the best so far change less
                tried = worth.mixed(centre, near)
                bound, new = self._priced(pricings, tried)
                if bound > best:
                    best, centre = bound, tried
                    yield best
                if new:
                    break
            if not new or best >= value - _CLOSE:
                return

    def _priced(
        self, pricings: Mapping[int, tuple[Ints, Pricing]], tried: Worth
    ) -> tuple[float, bool]:
        """The bound that some prices give, and whether routes come up that the program lacks."""
        visits = tried.needs[self._need]
        visits += np.where(self._full < 0, 0.0, np.append(tried.places, 0.0)[self._full])
        bound = float(self._many @ tried.needs) + float(self._limit @ tried.places)
        new = False
        for kind, (mine, pricing) in pricings.items():
            least, routes = pricing.cheapest(visits[mine])
            counts = np.array([self._begun[kind, start] for start in pricing.starts.tolist()])
            bound += float(counts @ least)
            for route in routes:
                new = self._add(kind, route.start, mine[list(route.visits)].tolist()) or new
        return bound, new

    @property
    def _many(self) -> Floats:
        return np.array([need.many for need in self.agenda.needs], dtype=np.float64)

    def _pricings(self, windows: Windows) -> dict[int, tuple[Ints, Pricing]]:
        """Of every class its visits and what finds routes by them."""
        found = {}
        needs, of = self.agenda.needs, np.array(self._of)
        after = np.array([need.after[0] for need in needs])
        first = (np.array(windows.first)[of] + after)[self._need].astype(np.float64)
        last = (np.array(windows.last)[of] + after)[self._need].astype(np.float64)
        visits = Visits(self._need, self._place, first, last)
        for kind in sorted({kind for kind, _ in self._begun}):
            able = [number for number, need in enumerate(needs) if kind in need.able]
            mine = np.flatnonzero(np.isin(self._need, able))
            starts = np.array([start for of_kind, start in self._begun if of_kind == kind])
            if len(mine):
                steps, prices = self.distances.steps[kind], self.distances.prices[kind]
                found[kind] = mine, Pricing(visits.some(mine), starts, steps, prices)
        return found

    def _solved(self, windows: Windows, clock: Clock) -> tuple[float, Worth] | None:
        """The value of the program of the routes that are known, and what rows are worth."""
        kept = [key for key in self._routes if self._in_time(key, windows)]
        needs, starts = len(self.agenda.needs), {key: n for n, key in enumerate(self._begun)}
        draft = Draft()
        columns = draft.columns(len(kept) + needs)
        visits = np.array([visit for _, _, route in kept for visit in route], dtype=np.int64)
        by = np.repeat(np.arange(len(kept)), [len(route) for _, _, route in kept])
        row = np.concatenate([self._need[visits], np.arange(needs)])
        column = np.concatenate([by, columns[len(kept) :]])
        draft.rows(row, column, 1.0, lower=self._many, upper=INFINITY, kind="needs")
        counts = np.array(list(self._begun.values()), dtype=np.float64)
        row = np.array([starts[kind, start] for kind, start, _ in kept], dtype=np.int64)
        draft.rows(row, np.arange(len(kept)), 1.0, lower=-INFINITY, upper=counts, kind="starts")
        full = np.flatnonzero(self._full[visits] >= 0)
        row = self._full[visits[full]]
        if len(self._limit):
            draft.rows(row, by[full], 1.0, lower=-INFINITY, upper=self._limit, kind="places")
        finite = self.distances.prices[np.isfinite(self.distances.prices)]
        dear = _DEAR * float(finite.max(initial=1.0)) + 1.0
        costs = np.array([*(self._routes[key] for key in kept), *([dear] * needs)])
        solved = WarmLP(draft.build().with_objective(costs), clock.stop).solve(clock.left)
        duals, values = solved.row_duals, solved.values
        if duals is None or values is None:
            return None
        self.used = [kept[n] for n in np.flatnonzero(values[: len(kept)] > _CLOSE).tolist()]
        of_needs, _, of_places = np.split(duals, [needs, needs + len(counts)])
        return solved.objective, Worth(np.maximum(of_needs, 0.0), np.minimum(of_places, 0.0))

    def stops(self, route: Key) -> Stops:
        """The appointments of a route, and how far they are from each other in time.

        It is counted from where the agent is wanted at one of them, not for how long.
        """
        kind, place, visits = route
        numbers, soonest, before = [], [], 0
        for visit in visits:
            need = int(self._need[visit])
            after, there = self.agenda.needs[need].after[0], int(self._place[visit])
            numbers.append(self._of[need])
            soonest.append(float(self.distances.steps[kind, place, there]) + before - after)
            place, before = there, after
        return Stops(tuple(numbers), tuple(soonest))

    def _in_time(self, route: Key, windows: Windows) -> bool:
        """Whether an agent can follow a route within the windows."""
        stops, now = self.stops(route), 0.0
        for number, steps in zip(stops.numbers, stops.soonest, strict=True):
            now = max(now + steps, windows.first[number])
            if now > windows.last[number]:
                return False
        return True


def boundable(
    objectives: Sequence[StageObjective], prices: Sequence[Floats], agenda: Agenda
) -> bool:
    """Whether routes say something of the first objective, in which edges have these prices."""
    priced = len(objectives) == 1 and isinstance(objectives[0], Priced)
    paid = all((price >= 0).all() for price in prices)
    return priced and paid and len(agenda.needs) <= MOST_NEEDS
