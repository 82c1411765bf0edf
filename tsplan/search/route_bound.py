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
from tsplan.milp.model import INFINITY, Draft, Floats, Ints, Model
from tsplan.routing.appointments import Agenda
from tsplan.routing.calls import MOST, apart, calls_of, joined
from tsplan.routing.distances import Distances
from tsplan.routing.routes import Pricing, Visits
from tsplan.routing.tours import Tours

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
    """The program of routes that keep an agenda, of `room` in states.

    All prices of plans are multiples of `unit`, if it is not 0. Without `ends` nobody is asked to
    stay: that is solved sooner, and says less.
    """

    agenda: Agenda
    distances: Distances
    room: Mapping[int, int]
    unit: float = 0.0
    ends: bool = True
    used: list[Key] = field(default_factory=list, init=False)  # of the last program's solution

    def __post_init__(self) -> None:
        """Number the visits, and the rows of needs, of starts and of places."""
        distances = self.distances
        self.calls = calls_of(self.agenda, ends=self.ends)
        self._apart = apart(self.calls)
        self._of = [call.appointment for call in self.calls]
        every = [(n, state) for n, call in enumerate(self.calls) for state in call.need.states]
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
        """The appointment (or call), step after its beginning and state of visits that are limited.

        Agents that answer two calls are counted twice, so then each call is limited by itself.
        """
        found = {}
        for visit, (number, state) in enumerate(every):
            call = self.calls[number]
            if state not in self.room:
                continue
            needs = [
                other.need
                for other in self.calls
                if (other.appointment, other.after) == (call.appointment, call.after)
            ]
            single = not any(one.able & other.able for one, other in combinations(needs, 2))
            group = -1 - call.appointment if single else number
            found[visit] = group, call.after, state
        return found

    # --- the program -----------------------------------------------------------------------------

    def begin_with(self, tours: Tours) -> None:
        """Know the routes of some tours."""
        number = {(self._need[v], self._place[v]): v for v in range(len(self._need))}
        routes: dict[int, list[int]] = {}
        for each in tours.order:
            items = zip(self.agenda.appointments[each].needs, tours.serving[each], strict=True)
            agents = dict(items)
            for call in sorted(self._calls(each), key=lambda call: self.calls[call].after):
                for agent, state in agents[self.calls[call].need]:
                    visit = number[call, self.distances.place[state]]
                    routes.setdefault(agent, []).append(visit)
        for agent, visits in routes.items():
            self._add(int(self.distances.kind[agent]), int(self.distances.begin[agent]), visits)

    def _calls(self, appointment: int) -> list[int]:
        """The numbers of the calls of an appointment."""
        return [number for number, of in enumerate(self._of) if of == appointment]

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
        best, centre = 0.0, Worth(0.0 * self._many, 0.0 * self._limit)
        while not clock.over:
            solved = self._solved(windows, clock)
            if solved is None:
                return
            value, worth = solved
            if self._hurried(pricings, worth.mixed(centre, _NEAR)):
                continue
            for near in (_NEAR, 0.0):  # prices near the best so far change less
                tried = worth.mixed(centre, near)
                bound, new = self._priced(pricings, tried)
                if bound > best:
                    best, centre = bound, tried
                    yield self._whole(best)
                if new:
                    break
            if not new or self._whole(best) >= value - _CLOSE:
                return

    def _whole(self, bound: float) -> float:
        """The least price of a plan that is not below a bound."""
        return bound if not self.unit else float(np.ceil(bound / self.unit - _CLOSE)) * self.unit

    def _hurried(self, pricings: Mapping[int, tuple[Ints, Pricing]], tried: Worth) -> bool:
        """Whether the program gets routes that it lacks, of those that are soon found."""
        visits, new = self._visits(tried), False
        for kind, (mine, pricing) in pricings.items():
            for route in pricing.some(visits[mine]):
                new = self._add(kind, route.start, mine[list(route.visits)].tolist()) or new
        return new

    def _priced(
        self, pricings: Mapping[int, tuple[Ints, Pricing]], tried: Worth
    ) -> tuple[float, bool]:
        """The bound that some prices give, and whether routes come up that the program lacks."""
        visits = self._visits(tried)
        bound = float(self._many @ tried.needs) + float(self._limit @ tried.places)
        new = False
        for kind, (mine, pricing) in pricings.items():
            least, routes = pricing.cheapest(visits[mine])
            counts = np.array([self._begun[kind, start] for start in pricing.starts.tolist()])
            bound += float(counts @ least)
            for route in routes:
                new = self._add(kind, route.start, mine[list(route.visits)].tolist()) or new
        return bound, new

    def _visits(self, tried: Worth) -> Floats:
        """What each visit is worth."""
        return np.asarray(
            tried.needs[self._need]
            + np.where(self._full < 0, 0.0, np.append(tried.places, 0.0)[self._full])
        )

    @property
    def _many(self) -> Floats:
        return np.array([call.need.many for call in self.calls], dtype=np.float64)

    def _pricings(self, windows: Windows) -> dict[int, tuple[Ints, Pricing]]:
        """Of every class its visits and what finds routes by them."""
        found = {}
        of = np.array(self._of)
        after = np.array([call.after for call in self.calls])
        first = (np.array(windows.first)[of] + after)[self._need].astype(np.float64)
        last = (np.array(windows.last)[of] + after)[self._need].astype(np.float64)
        visits = Visits(self._need, self._place, first, last)
        for kind in sorted({kind for kind, _ in self._begun}):
            able = [n for n, call in enumerate(self.calls) if kind in call.need.able]
            mine = np.flatnonzero(np.isin(self._need, able))
            starts = np.array([start for of_kind, start in self._begun if of_kind == kind])
            if len(mine):
                steps, prices = self.distances.steps[kind], self.distances.prices[kind]
                same = joined(self.calls, kind, self.distances)
                found[kind] = (
                    mine,
                    Pricing(visits.some(mine), starts, steps, prices, self._apart, same),
                )
        return found

    def _solved(self, windows: Windows, clock: Clock) -> tuple[float, Worth] | None:
        """The value of the program of the routes that are known, and what rows are worth."""
        kept = self.known(windows)
        program = self.program(kept)
        solved = WarmLP(program, clock.stop).solve(clock.left)
        duals, values = solved.row_duals, solved.values
        if duals is None or values is None:
            return None
        self.used = [kept[n] for n in np.flatnonzero(values[: len(kept)] > _CLOSE).tolist()]
        needs, starts = len(self.calls), len(self._begun)
        of_needs, _, of_places = np.split(duals, [needs, needs + starts])
        return solved.objective, Worth(np.maximum(of_needs, 0.0), np.minimum(of_places, 0.0))

    def known(self, windows: Windows) -> list[Key]:
        """The routes that are known and can be followed within windows."""
        return [key for key in self._routes if self._in_time(key, windows)]

    def program(self, kept: Sequence[Key], *, whole: bool = False) -> Model:
        """The program of some routes; calls can be left unanswered at a high price.

        Routes come first in it, as fractions or `whole`.
        """
        needs, starts = len(self.calls), {key: n for n, key in enumerate(self._begun)}
        draft = Draft()
        columns = draft.columns(len(kept) + needs, integer=whole)
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
        return draft.build().with_objective(costs)

    def stops(self, route: Key) -> Stops:
        """The appointments of a route, and how far they are from each other in time.

        It is counted from where the agent is wanted at one of them, not for how long.
        """
        kind, place, visits = route
        numbers, soonest, before, last = [], [], 0, -1
        for visit in visits:
            call = int(self._need[visit])
            after, there = self.calls[call].after, int(self._place[visit])
            steps = float(self.distances.steps[kind, place, there])
            if last >= 0:
                steps = max(steps, float(self._apart[last, call]))
            numbers.append(self._of[call])
            soonest.append(steps + before - after)
            place, before, last = there, after, call
        return Stops(tuple(numbers), tuple(soonest))

    def price(self, route: Key) -> float:
        """What a route that is known costs."""
        return self._routes[route]

    def answers(self, route: Key) -> list[int]:
        """The calls that a route answers, by their numbers."""
        return [int(call) for call in self._need[list(route[2])]]

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
    return priced and paid and len(agenda.needs) <= MOST
