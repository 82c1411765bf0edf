"""Large-neighbourhood search for ways that leave nobody without room.

All agents go their ways, conflicts or not; then a few agents of a conflict are taken out at a time
and given their cheapest ways again, one after the other, where each place that is full costs a
penalty. What they have then is kept unless it is worse.

Source: J. Li, Z. Chen, D. Harabor, P. J. Stuckey, S. Koenig, "MAPF-LNS2: Fast repairing for
multi-agent path finding via large neighborhood search", AAAI 2022. Here agents have duties at steps
instead of goals, and places hold several.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from tsplan.clock import Clock
from tsplan.encode.encoded import Setting
from tsplan.milp.model import Floats, Ints
from tsplan.routing.appointments import Need
from tsplan.routing.crowd import Crowd, Room
from tsplan.routing.duties import Duties
from tsplan.routing.engagements import Engagements, Member
from tsplan.routing.single_agent import SingleAgent
from tsplan.routing.walks import UNDER_WAY, Walk

_MOST = 8  # agents that are taken out at once: the size that the source found to be best
_PLAIN = 0.5  # of all attempts: without other appointments
_LATER, _STEP = 0.6, 0.3  # of these: at another step, which is near
_TAILS = 0.3  # of all changes: of all later appointments, too
_ALONE = 0.5  # of these changes: nobody else gives way to them
_ABOUT, _NEXT = 10, 0.35  # steps around an appointment; how often it is the next that comes
_NOISE = 1e-7  # by which equally cheap ways are told apart, at random


@dataclass(frozen=True)
class Weights:
    """What a conflict costs beside the prices of edges, which are whole numbers."""

    conflict: float
    price: float


CHEAP = Weights(conflict=1e-4, price=1.0)
"""Ways that cost least alone, and of those the ones with the fewest conflicts."""

CLEAR = Weights(conflict=1.0, price=1e-6)
"""Ways with the fewest conflicts, and of those the cheapest."""


@dataclass(frozen=True)
class Change:
    """Agents that get new ways, and perhaps other appointments."""

    agents: list[int]
    engaged: Engagements | None = None


@dataclass(eq=False)
class Rerouting:
    """The ways of all agents of a setting, and what is known to be better.

    `prices` has one for each edge of each class, `duties` those of each agent. No move ends after
    step `last`, and the agents that are `still` keep their ways.
    """

    setting: Setting
    walks: list[Walk]
    duties: list[Duties]
    prices: Sequence[Floats]
    room: Room
    last: int | None = None
    still: frozenset[int] = frozenset()
    seed: int = 0
    engaged: Engagements | None = None
    crowd: Crowd = field(init=False)

    def __post_init__(self) -> None:
        graphs = [item.graph for item in self.setting.classes]
        horizon = self.setting.horizon
        self.crowd = Crowd(graphs, self.room, horizon)
        for walk in self.walks:
            self.crowd.add(walk)
        self._random = np.random.default_rng(self.seed)
        self._alone = self._maps()
        self._far: dict[tuple[int, tuple[int, ...]], Floats] = {}
        self._noise = self._random.random((horizon + 1) * len(self.room.states) * 2) * _NOISE

    def _maps(self) -> list[SingleAgent]:
        """The map of every class; where those of several are the same there is one for all."""
        found: dict[tuple[bytes, ...], SingleAgent] = {}
        maps = []
        for number, (item, prices) in enumerate(
            zip(self.setting.classes, self.prices, strict=True)
        ):
            graph = item.graph
            parts = graph.tail, graph.head, graph.duration, prices
            key = tuple(np.ascontiguousarray(part).tobytes() for part in parts)
            made = SingleAgent(number, graph, self.setting.horizon, prices, self.last)
            maps.append(found.setdefault(key, made))
        return maps

    def begin(self) -> bool:
        """Give all agents with duties their ways, by when the first is; False if one has none."""
        busy = [agent for agent, duties in enumerate(self.duties) if duties]
        busy.sort(key=lambda agent: min(self.duties[agent]))
        return all(self._replanned([agent], CLEAR) for agent in busy)

    @property
    def price(self) -> float:
        """What all ways cost together."""
        return float(sum(self._price(walk) for walk in self.walks))

    def _price(self, walk: Walk) -> float:
        return float(self.prices[walk.number][walk.edges].sum())

    def repair(self, weights: Weights, clock: Clock, patience: int) -> bool:
        """Look for ways without conflicts; True if there are none left.

        It ends after so many attempts in a row that did not help.
        """
        idle = 0
        best = self._worth(weights)
        while self.crowd.excess and idle < patience and not clock.over:
            troubled = self.crowd.troubled(self.walks)
            change = self._change(troubled) or Change(self._neighbourhood(troubled))
            if not change.agents:
                break
            before = self._worth(weights)
            undo = self._tried(change, weights)
            if undo is not None and self._worth(weights) > before:
                undo()
            better = self._worth(weights)
            idle = 0 if better < best else idle + 1
            best = min(best, better)
        return not self.crowd.excess

    def improve(self, clock: Clock, patience: int, least: float = -np.inf) -> bool:
        """Make ways without conflicts cheaper, until they cost no more than `least` together.

        It ends after so many attempts in a row that did not help; True if any did.
        """
        idle, first = 0, self.price
        while self.price > least and idle < patience and not clock.over:
            before = self.price
            change = self._change(range(len(self.walks))) or Change(self._dear())
            undo = self._tried(change, CLEAR)
            if undo is not None and (self.crowd.excess or self.price > before):
                undo()
            idle = 0 if self.price < before else idle + 1
        return self.price < first

    def _worth(self, weights: Weights) -> float:
        return weights.conflict * self.crowd.excess + weights.price * self.price

    def _tried(self, change: Change, weights: Weights) -> Callable[[], None] | None:
        """Make a change; what takes it back, or None where it cannot be made."""
        agents = change.agents
        old = [self.walks[agent] for agent in agents]
        owed, engaged = [self.duties[agent] for agent in agents], self.engaged

        def undo() -> None:
            self._put(agents, old)
            self.engaged = engaged
            for agent, duties in zip(agents, owed, strict=True):
                self.duties[agent] = duties

        if change.engaged is not None:
            self.engaged = change.engaged
            for agent in agents:
                self.duties[agent] = change.engaged.duties(agent)
        if self._replanned(agents, weights):
            return undo
        undo()
        return None

    # --- other appointments ----------------------------------------------------------------------

    def _change(self, agents: Sequence[int]) -> Change | None:
        """An appointment of some agents at another step, or with another agent."""
        engaged, random = self.engaged, self._random
        if engaged is None or random.random() < _PLAIN:
            return None
        numbers = sorted({number for agent in agents for number, _ in engaged.of(agent)})
        if not numbers:
            return None
        number = int(random.choice(numbers))
        if random.random() < _LATER:
            return self._moved(engaged, number)
        return self._relieved(engaged, number)

    def _moved(self, engaged: Engagements, number: int) -> Change | None:
        """An appointment at another step, not far from its own, and perhaps all later ones, too."""
        apart = int(self._random.choice((-1, 1)) * self._random.geometric(_STEP))
        numbers = [number]
        if self._random.random() < _TAILS:
            numbers = [n for n, time in enumerate(engaged.times) if time >= engaged.times[number]]
        begun = engaged.shifted(numbers, apart)
        if begun is None:
            return None
        agents = {agent for number in numbers for agent in engaged.agents(number)}
        return self._with_others(sorted(agents), begun)

    def _relieved(self, engaged: Engagements, number: int) -> Change | None:
        """Another agent at an appointment, and perhaps at all later ones, too."""
        item, time = engaged.agenda.appointments[number], engaged.times[number]
        place = int(self._random.integers(len(item.needs)))
        one = int(self._random.choice(engaged.serving[number][place]))
        other = self._other(item.needs[place], time, engaged.agents(number))
        if other is None:
            return None
        until = self.setting.horizon if self._random.random() < _TAILS else time
        members = [Member(agent, self.walks[agent].number) for agent in (one, other)]
        swapped = engaged.swapped(members[0], members[1], time, until)
        return None if swapped is None else self._with_others([one, other], swapped)

    def _with_others(self, agents: list[int], engaged: Engagements) -> Change:
        """A change that some more agents may give way to."""
        if self._random.random() < _ALONE:
            return Change(agents, engaged)
        near = [agent for agent in self._meeting(agents[0]) if agent not in agents]
        self._random.shuffle(near)
        return Change(agents + near[: max(_MOST - len(agents), 1) // 2], engaged)

    def _other(self, need: Need, time: int, busy: Sequence[int]) -> int | None:
        """An agent that could come as well; rather one that is near then."""
        able = [
            agent
            for agent, walk in enumerate(self.walks)
            if walk.number in need.able and agent not in busy and agent not in self.still
        ]
        if not able:
            return None
        about = slice(max(time - _ABOUT, 0), time + _ABOUT)

        def far(agent: int) -> float:
            walk = self.walks[agent]
            where = self._states(walk)[about]
            return float(
                self._from(walk.number, need.states)[where[where != UNDER_WAY]].min(initial=np.inf)
            )

        able.sort(key=far)
        return able[min(int(self._random.geometric(_NEXT)) - 1, len(able) - 1)]

    def _from(self, number: int, states: tuple[int, ...]) -> Floats:
        """How far every state is from some states, for agents of a class."""
        if (number, states) not in self._far:
            lengths = self.setting.classes[number].graph.lengths
            self._far[number, states] = lengths.nearest(np.array(states))
        return self._far[number, states]

    # --- which agents ----------------------------------------------------------------------------

    def _neighbourhood(self, troubled: Sequence[int]) -> list[int]:
        """An agent of a conflict, those that it is in conflict with, and who else is nearby."""
        free = [agent for agent in troubled if agent not in self.still]
        if not free:
            return []
        seed = int(self._random.choice(free))
        near = self._meeting(seed)
        known = set(troubled)
        first = [agent for agent in near if agent in known]
        others = [agent for agent in near if agent not in known]
        self._random.shuffle(first)
        self._random.shuffle(others)
        size = int(self._random.integers(2, _MOST + 1))
        return [seed, *first, *others][:size]

    def _dear(self) -> list[int]:
        """An agent that might go more cheaply, and some that it meets."""
        seed = int(self._random.integers(len(self.walks)))
        near = self._meeting(seed)
        self._random.shuffle(near)
        return [seed, *near][: int(self._random.integers(2, _MOST + 1))]

    def _meeting(self, agent: int) -> list[int]:
        """The other agents that are where an agent would go at about the same time."""
        walk = self.walks[agent]
        found = self._cheapest(agent, Weights(0.0, 1.0))
        ideal = walk if found is None else found
        places = {state for way in (walk, ideal) for state in self._states(way).tolist()}
        places.discard(UNDER_WAY)
        mask = np.zeros(len(self.room.states) + 1, dtype=np.bool_)
        mask[list(places)] = True
        return [
            other
            for other, way in enumerate(self.walks)
            if other != agent and other not in self.still and mask[self._states(way)].any()
        ]

    def _states(self, walk: Walk) -> Ints:
        graph = self.setting.classes[walk.number].graph
        return walk.states(graph, self.setting.horizon)

    # --- their ways ------------------------------------------------------------------------------

    def _put(self, agents: Sequence[int], walks: Sequence[Walk]) -> None:
        for agent, walk in zip(agents, walks, strict=True):
            self.crowd.add(self.walks[agent], -1)
            self.walks[agent] = walk
            self.crowd.add(walk)

    def _replanned(self, agents: Sequence[int], weights: Weights) -> bool:
        """Give agents new ways in a random order; False where one has none, its old one stays."""
        order = list(agents)
        self._random.shuffle(order)
        for agent in order:
            self.crowd.add(self.walks[agent], -1)
        whole = True
        for agent in order:
            found = self._cheapest(agent, weights)
            whole = whole and found is not None
            if found is not None:
                self.walks[agent] = found
            self.crowd.add(self.walks[agent])
        return whole

    def _cheapest(self, agent: int, weights: Weights) -> Walk | None:
        """The cheapest way of an agent among those that are counted in."""
        walk = self.walks[agent]
        (step, state, many), (when, edge, full) = self.crowd.burden(walk.number)
        shape = self.setting.horizon + 1, len(self.room.states)
        shift = int(self._random.integers(shape[0] * shape[1]))
        at = self._noise[shift : shift + shape[0] * shape[1]].reshape(shape).copy()
        penalty = weights.conflict / weights.price
        np.add.at(at, (step, state), penalty * many)
        alone = self._alone[walk.number]
        found = alone.cheapest(walk.start, self.duties[agent], at, (when, edge, penalty * full))
        return None if found is None else replace(found[0], number=walk.number)
