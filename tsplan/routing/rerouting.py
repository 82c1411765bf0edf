"""Large-neighbourhood search for ways that leave nobody without room.

All agents go their ways, conflicts or not; then a few agents of a conflict are taken out at a time
and given their cheapest ways again, one after the other, where each place that is full costs a
penalty. What they have then is kept unless it is worse.

Source: J. Li, Z. Chen, D. Harabor, P. J. Stuckey, S. Koenig, "MAPF-LNS2: Fast repairing for
multi-agent path finding via large neighborhood search", AAAI 2022. Here agents have duties at steps
instead of goals, and places hold several.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from tsplan.clock import Clock
from tsplan.encode.encoded import Setting
from tsplan.milp.model import Floats, Ints
from tsplan.routing.crowd import Crowd, Room
from tsplan.routing.duties import Duties
from tsplan.routing.single_agent import SingleAgent
from tsplan.routing.walks import UNDER_WAY, Walk

_MOST = 8  # agents that are taken out at once: the size that the source found to be best
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


@dataclass(eq=False)
class Rerouting:
    """The ways of all agents of a setting, and what is known to be better.

    `prices` has one for each edge of each class, `duties` those of each agent. No move ends after
    step `last`, and the agents that are `still` keep their ways.
    """

    setting: Setting
    walks: list[Walk]
    duties: Sequence[Duties]
    prices: Sequence[Floats]
    room: Room
    last: int | None = None
    still: frozenset[int] = frozenset()
    seed: int = 0
    crowd: Crowd = field(init=False)

    def __post_init__(self) -> None:
        graphs = [item.graph for item in self.setting.classes]
        horizon = self.setting.horizon
        self.crowd = Crowd(graphs, self.room, horizon)
        for walk in self.walks:
            self.crowd.add(walk)
        self._random = np.random.default_rng(self.seed)
        self._alone = [SingleAgent(n, graph, horizon) for n, graph in enumerate(graphs)]
        self._noise = self._random.random((horizon + 1) * len(self.room.states) * 2) * _NOISE

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
            before = self._worth(weights)
            chosen = self._neighbourhood()
            old = [self.walks[agent] for agent in chosen]
            if not self._replanned(chosen, weights) or self._worth(weights) > before:
                self._put(chosen, old)
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
            chosen = self._dear()
            old = [self.walks[agent] for agent in chosen]
            fit = self._replanned(chosen, CLEAR) and not self.crowd.excess
            if not fit or self.price > before:
                self._put(chosen, old)
            idle = 0 if self.price < before else idle + 1
        return self.price < first

    def _worth(self, weights: Weights) -> float:
        return weights.conflict * self.crowd.excess + weights.price * self.price

    # --- which agents ----------------------------------------------------------------------------

    def _neighbourhood(self) -> list[int]:
        """An agent of a conflict, those that it is in conflict with, and who else is nearby."""
        troubled = self.crowd.troubled(self.walks)
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
        states, grouped, full = self.crowd.burden(walk.number)
        shape = states.shape
        shift = int(self._random.integers(shape[0] * shape[1]))
        noise = self._noise[shift : shift + shape[0] * shape[1]].reshape(shape)
        at = weights.conflict * states + weights.price * noise
        prices = weights.price * self.prices[walk.number]
        entering = np.tile(prices, (self.setting.horizon, 1))
        entering[:, grouped] += weights.conflict * full
        if self.last is not None:
            graph = self.setting.classes[walk.number].graph
            ends = np.arange(self.setting.horizon)[:, None] + graph.arrives
            entering[(ends > self.last) & (graph.travel > 0)] = np.inf
        alone = self._alone[walk.number]
        found = alone.cheapest(walk.start, self.duties[agent], at, entering)
        return None if found is None else found[0]
