"""Whole routes whose agents meet: who keeps which appointment, and when.

The routes that a linear program has come to know are a good choice for plans, too. An integer
program of these alone says who goes where ("price and branch"); with the appointments begun as
early as all routes allow there are times. Prices that chance has changed a little bring others,
and ways that are taken to last longer leave time for going around each other.
"""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import ceil

import numpy as np

from tsplan.clock import Clock
from tsplan.milp.confirmation import tried
from tsplan.milp.model import Floats
from tsplan.milp.target import Target
from tsplan.routing.appointments import Appointment
from tsplan.routing.engagements import Serving
from tsplan.search.effort import Effort
from tsplan.search.route_bound import Key, RouteBound, Windows
from tsplan.search.route_tree import RouteTree

_CHANGED = 0.03  # part of a price that chance adds at most
_HALF = 0.5
_SECONDS = 5.0  # for one integer program, or for windows in which routes can meet
_ROUNDS = 100  # after which times that are still put off are put off for ever
_SPARE = 10.0  # steps that are worth a whole way of spare time, however short the way


@dataclass(frozen=True, eq=False)
class Meeting:
    """When each appointment begins, and the agents that keep it."""

    times: tuple[int, ...]
    serving: tuple[Serving, ...]


@dataclass(frozen=True, eq=False)
class MetRoutes:
    """Looks for whole routes among those that a program knows."""

    routes: RouteBound
    effort: Effort

    def chosen(self, windows: Windows, clock: Clock, seed: int) -> Counter[Key] | None:
        """Routes that answer all calls within windows, how often each; `seed` is that of chance.

        With a seed of 0 they are the cheapest. None where none are found soon.
        """
        known = self.routes.known(windows)
        model = self.routes.program(known, whole=True)
        vector = model.objective.copy()
        if seed:
            vector *= 1 + _CHANGED * np.random.default_rng(seed).random(len(vector))
        options = self.effort.options(clock.within(_SECONDS), Target(vector, step=0.0))
        values = tried(self.effort.solver, model.with_objective(vector), options)
        if values is None or (values[len(known) :] > _HALF).any():
            return None
        return self._counted(known, values)

    def _counted(self, known: Sequence[Key], values: Floats) -> Counter[Key]:
        whole = np.round(values[: len(known)]).astype(np.int64)
        return Counter(
            {known[place]: int(whole[place]) for place in np.flatnonzero(whole).tolist()}
        )

    def about(self, times: Sequence[int], apart: int, clock: Clock, enough: float) -> Windows:
        """Windows within so many steps about some times in which routes can meet, if that is soon.

        Only routes below a price of `enough` are of interest.
        """
        first, last = zip(*((each.first, each.last) for each in self._items), strict=True)
        narrow = Windows(
            tuple(max(low, time - apart) for low, time in zip(first, times, strict=True)),
            tuple(min(high, time + apart) for high, time in zip(last, times, strict=True)),
        )
        tree = RouteTree(self.routes, narrow)
        for _ in tree.raised(clock.within(_SECONDS), lambda: enough):
            if tree.met is not None:
                break
        return tree.met or tree.windows

    @property
    def _items(self) -> Sequence[Appointment]:
        return self.routes.agenda.appointments

    def price(self, chosen: Mapping[Key, int]) -> float:
        """What some routes cost."""
        return sum(self.routes.price(route) * many for route, many in chosen.items())

    def meeting(self, chosen: Mapping[Key, int], spare: float) -> Meeting | None:
        """The earliest times at which agents on these routes can meet; None if they cannot.

        Ways are taken to last longer by a part `spare` of them, and by ten times as many steps.
        """
        windows = Windows.of(self.routes.agenda)
        ways = [self._way(route, spare) for route in chosen]
        times = list(windows.first)
        for _ in range(_ROUNDS):
            before = list(times)
            for way in ways:
                now = 0
                for number, steps in way:
                    now = times[number] = max(now + steps, times[number])
            if any(time > last for time, last in zip(times, windows.last, strict=True)):
                return None
            if times == before:
                return Meeting(tuple(times), self._serving(chosen))
        return None

    def _way(self, route: Key, spare: float) -> list[tuple[int, int]]:
        """The appointments of a route, and how long each is after the one before."""
        stops = self.routes.stops(route)
        found, before = [], -1
        for number, steps in zip(stops.numbers, stops.soonest, strict=True):
            longer = spare * (max(steps, 0.0) + _SPARE) if number != before else 0.0
            found.append((number, ceil(steps + longer)))
            before = number
        return found

    def _serving(self, chosen: Mapping[Key, int]) -> tuple[Serving, ...]:
        """Who is there when each need begins; nobody is appointed who would be one too many."""
        agents, calls = self._agents(), self.routes.calls
        given: dict[int, list[int]] = defaultdict(list)
        for route, times in chosen.items():
            for _ in range(times):
                agent = agents[route[:2]].pop()
                for number in self.routes.answers(route):
                    group = given[number]
                    if agent not in group and len(group) < calls[number].need.many:
                        group.append(agent)
        items = self.routes.agenda.appointments
        serving: list[list[tuple[int, ...]]] = [[] for _ in items]
        for number, call in enumerate(calls):
            if call.after == call.need.after[0]:
                serving[call.appointment].append(tuple(given[number]))
        return tuple(tuple(groups) for groups in serving)

    def _agents(self) -> dict[tuple[int, int], list[int]]:
        """The agents of each class that begin at each place."""
        distances = self.routes.distances
        found: dict[tuple[int, int], list[int]] = defaultdict(list)
        begun = zip(distances.kind.tolist(), distances.begin.tolist(), strict=True)
        for agent, key in enumerate(begun):
            found[key].append(agent)
        return found
