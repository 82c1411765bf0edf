"""Swarms as weighted tokens that travel: the cheapest way to make some stops.

What a token costs by the stops that it makes is read off a table (`token_tours`), how many agents
tokens may have is told by `token_weights`, and who makes which stops by `token_service`. All of it
is a relaxation: tokens know nothing of each other but the stops that they share.
"""

from __future__ import annotations

from collections.abc import Container, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import permutations

import numpy as np

from tsplan.encode.agent_classes import AgentClass
from tsplan.encode.capability_mask import is_counted
from tsplan.encode.class_graph import ClassGraph
from tsplan.encode.encoded import Setting
from tsplan.encode.groups.token_flow import Track, track_of
from tsplan.encode.groups.token_service import Servants, Service, Task
from tsplan.encode.groups.token_stops import Limit, Steps, Stop
from tsplan.encode.groups.token_tours import Call, Journey, Tours, Way
from tsplan.encode.groups.token_weights import Origin, Wanted, Weighting
from tsplan.encode.map_reduction import Reduced, reduce, whole
from tsplan.encode.preparation import interest
from tsplan.encode.priced_objectives import Priced
from tsplan.milp.model import Bools, Floats, Ints

_ENTRIES = 6_000_000  # of all tables together, at eight bytes each
_CALLS = 12
_TINY = 1e-6


@dataclass(frozen=True, eq=False)
class Traveller:
    """One swarm: its map between the states that matter, and what its edges cost an agent.

    `states` are those of the map, by its nodes.
    """

    graph: ClassGraph
    reduced: Reduced
    least: int
    price: Floats
    states: Ints

    def counts(self, capability: str | None) -> bool:
        """Whether the agents have a capability."""
        return is_counted(capability, self.graph.capabilities)

    def nodes(self, states: Sequence[int]) -> tuple[int, ...]:
        """The nodes of those of some states that are on the map."""
        return tuple(np.flatnonzero(np.isin(self.states, list(states))).tolist())

    def journey(self, state: int, barred: Bools) -> Journey:
        """The way of a token from a state."""
        short = self.reduced.graph
        return Journey(
            start=int(np.searchsorted(self.states, state)),
            tail=np.searchsorted(self.states, short.tail),
            head=np.searchsorted(self.states, short.head),
            duration=short.duration,
            price=self.price,
            barred=barred,
        )


@dataclass(frozen=True, eq=False)
class Shared:
    """Who makes which stops: the price of that, the tokens' agents and their ways.

    `at` has the state of every token at every step, or -1.
    """

    price: float
    weighting: Weighting
    ways: tuple[Way, ...]
    at: Ints


class Travellers:
    """The swarms of a setting that are in so many parts more than at step 0 at most."""

    def __init__(self, setting: Setting, objective: Priced, splits: int) -> None:
        self._horizon = setting.horizon
        swarms = [item for item in setting.classes if item.bounds is not None]
        self._each = [_traveller(setting, item, objective) for item in swarms]
        starts = [(n, s) for n, one in enumerate(self._each) for s in _starts(one)]
        two = splits == 1 and len(starts) == 1  # both of them are groups
        self.splits = splits
        self.origins = [
            Origin(n, s, int(self._each[n].graph.start[s]), self._each[n].least if two else 1)
            for n, s in starts
        ]

    @property
    def tokens(self) -> int:
        """How many tokens there are at most."""
        return len(self.origins) + self.splits

    def wanted(self, stop: Stop) -> Wanted:
        """How many agents of which swarms: whoever of a swarm is there is a sub-swarm."""
        (_, capability), amount, _ = stop
        able = [n for n, one in enumerate(self._each) if one.counts(capability)]
        least = min((self._each[n].least for n in able), default=0)
        return Wanted(max(amount, least), frozenset(able))

    def shared(
        self,
        stops: Sequence[Stop],
        apart: Container[tuple[Stop, Stop]],
        limits: Sequence[Limit],
        weightings: Sequence[Weighting],
        below: float,
    ) -> Shared | None:
        """The cheapest way to make some stops, if it costs less than a price.

        Pairs that are kept `apart` are made by different tokens.
        """
        calls: list[tuple[Stop, tuple[Steps, ...]]] = []
        tasks = list(self._tasks(stops, calls))
        barred = [self._barred(one, limits) for one in self._each]
        tours = [
            Tours(
                self._each[swarm].journey(state, barred[swarm]),
                [Call(self._each[swarm].nodes(stop.place[0]), runs) for stop, runs in calls],
            )
            for swarm, state, _, _ in self.origins
        ]
        forbidden = _both(tasks, apart, len(calls))
        costs = [np.where(forbidden, np.inf, tour.costs) for tour in tours]
        swarms = [origin.swarm for origin in self.origins]
        best: tuple[Service, Weighting] | None = None
        for weighting in weightings:
            pairs = list(zip(weighting.origins, weighting.weights.tolist(), strict=True))
            prices = [weight * costs[origin] for origin, weight in pairs]
            of = [swarms[origin] for origin, _ in pairs]
            found = Servants(weighting, of, prices).cheapest(tasks, below)
            if found is not None:
                best, below = (found, weighting), found.price
        if best is None:
            return None
        service, weighting = best
        pairs = list(zip(weighting.origins, service.calls, strict=True))
        ways = tuple(tours[origin].way(made) for origin, made in pairs)
        at = [
            np.where(way.at < 0, -1, self._each[swarms[origin]].states[way.at])
            for way, origin in zip(ways, weighting.origins, strict=True)
        ]
        return Shared(service.price, weighting, ways, np.array(at))

    def tracks(self, shared: Shared) -> list[Track]:
        """The edges of every swarm's map that its tokens enter, and when."""
        found = []
        for number, one in enumerate(self._each):
            pairs = zip(shared.weighting.origins, shared.ways, strict=True)
            mine = [way for origin, way in pairs if self.origins[origin].swarm == number]
            edge = np.concatenate([way.edge for way in mine])
            step = np.concatenate([way.step for way in mine])
            found.append(track_of(one.reduced, one.graph, edge, step))
        return found

    def makes(self, shared: Shared, stop: Stop) -> bool:
        """Whether enough agents are there at all steps of some run of a stop."""
        amount, able = self.wanted(stop)
        mine = [self.origins[n].swarm in able for n in shared.weighting.origins]
        there = np.isin(shared.at[mine], list(stop.place[0]))
        agents = shared.weighting.weights[mine] @ there
        return any((agents[a : b + 1] > amount - _TINY).all() for a, b in stop.runs)

    def _tasks(
        self, stops: Sequence[Stop], calls: list[tuple[Stop, tuple[Steps, ...]]]
    ) -> Iterator[Task]:
        """Stops as calls, which are listed; where these would be too many, not all stops.

        Who is there may change in a stop that lasts: then two tokens come by at least. In one at
        several states agents may go from one to the other, so nothing is known but its beginning.
        """
        nodes = max((len(one.states) for one in self._each), default=1)
        size = (self._horizon + 1) * nodes * len(self.origins)
        room = int(np.log2(max(_ENTRIES / size, 1.0)))
        most = min(room, _CALLS)
        for stop in sorted(stops, key=lambda stop: (-stop.amount, stop.runs)):
            wanted, runs = self.wanted(stop), stop.runs
            lasts = stop.lasting and len(stop.place[0]) == 1
            if stop.lasting and not lasts:
                runs = tuple(dict.fromkeys((first, first) for first, _ in runs))
            changing = lasts and self.tokens > 1
            if len(calls) + 1 + changing > most:
                continue
            calls.append((stop, runs))
            alone = together = 1 << len(calls) - 1
            if changing:
                steps = {step for first, last in runs for step in range(first, last + 1)}
                calls.append((stop, tuple((step, step) for step in sorted(steps))))
                together = 1 << len(calls) - 1
            yield Task(stop, alone, together, wanted, changing)

    def _barred(self, one: Traveller, limits: Sequence[Limit]) -> Bools:
        """Where not even one sub-swarm may be."""
        barred = np.zeros((self._horizon + 1, len(one.states)), dtype=np.bool_)
        for (states, capability), amount, (first, last) in limits:
            if one.counts(capability) and amount < one.least:
                barred[first : last + 1, list(one.nodes(states))] = True
        return barred


def _both(tasks: Sequence[Task], apart: Container[tuple[Stop, Stop]], calls: int) -> Bools:
    """Sets of calls with two that are kept apart."""
    sets = np.arange(1 << calls)
    forbidden = np.zeros(len(sets), dtype=np.bool_)
    for one, other in permutations(tasks, 2):
        if (one.stop, other.stop) in apart:
            both = one.alone | other.alone
            forbidden |= sets & both == both
    return forbidden


def _starts(one: Traveller) -> list[int]:
    return np.flatnonzero(one.graph.start).tolist()


def _traveller(setting: Setting, item: AgentClass, objective: Priced) -> Traveller:
    assert item.bounds is not None
    toll = objective.toll(item.graph)
    graph = item.graph.timeless  # a relaxation, as the rest
    matters = interest(setting, graph)
    matters = replace(matters, tolls=() if toll is None else (toll,))
    reduced = reduce(graph, matters, setting.horizon, setting.clock) or whole(graph)
    short = reduced.graph
    states = np.unique(np.concatenate([short.tail, short.head, np.flatnonzero(short.start)]))
    price = np.asarray(objective.price(short), dtype=np.float64)
    return Traveller(graph, reduced, item.bounds.least, price, states)
