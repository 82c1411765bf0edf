"""How many agents are where, and where that is more than there is room for."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from tsplan.encode.class_graph import ClassGraph
from tsplan.encode.encoded import Setting
from tsplan.milp.model import Bools, Floats, Ints
from tsplan.routing.walks import UNDER_WAY, Walk


@dataclass(frozen=True, eq=False)
class Zone:
    """States at which at most so many agents of the `able` classes may be, together, at `steps`."""

    states: Ints
    able: frozenset[int]
    steps: Ints
    most: int


@dataclass(frozen=True, eq=False)
class Room:
    """What states, groups of edges and zones hold; infinite without a limit."""

    states: Floats
    groups: Floats
    zones: tuple[Zone, ...] = ()

    @classmethod
    def of(cls, setting: Setting, zones: Sequence[Zone] = ()) -> Room:
        """The capacities of the map of a setting."""
        states = np.full(len(setting.arrays.names), np.inf)
        for state, capacity in setting.arrays.capacity:
            states[state] = capacity
        return cls(states, np.array(setting.arrays.group_capacity, dtype=np.float64), tuple(zones))


@dataclass(eq=False)
class Crowd:
    """Counts of agents at states, on groups of edges and in zones, kept up as agents come and go.

    `starting` agents count at no state at step 0, where capacities are the mission's to check.
    """

    graphs: Sequence[ClassGraph]
    room: Room
    horizon: int
    _there: Ints = field(init=False)
    _riding: Ints = field(init=False)
    _zoned: Ints = field(init=False)

    def __post_init__(self) -> None:
        steps = self.horizon + 1
        self._there = np.zeros((steps, len(self.room.states)), dtype=np.int64)
        self._riding = np.zeros((steps, len(self.room.groups)), dtype=np.int64)
        self._zoned = np.zeros((steps, len(self.room.zones)), dtype=np.int64)

    def add(self, walk: Walk, count: int = 1) -> None:
        """Count an agent in, or with -1 out."""
        steps, where = self._places(walk)
        self._there[steps, where] += count
        for step, group in self._rides(walk):
            self._riding[step, group] += count
        for number, zone in enumerate(self.room.zones):
            if walk.number in zone.able:
                self._zoned[steps[np.isin(where, zone.states)], number] += count

    def _places(self, walk: Walk) -> tuple[Ints, Ints]:
        where = walk.states(self.graphs[walk.number], self.horizon)
        steps = np.flatnonzero(where != UNDER_WAY)
        return steps, where[steps]

    def _rides(self, walk: Walk) -> list[tuple[int, int]]:
        """The steps at which an agent is on an edge of a group."""
        graph = self.graphs[walk.number]
        group = graph.group[walk.edges]
        on = np.flatnonzero(group >= 0)
        begun, lasting = walk.steps[on], graph.duration[walk.edges[on]]
        return [
            (step, held)
            for held, first, long in zip(
                group[on].tolist(), begun.tolist(), lasting.tolist(), strict=True
            )
            for step in range(first, min(first + long, self.horizon))
        ]

    def troubled(self, walks: Sequence[Walk]) -> list[int]:
        """Which of the agents, all counted in, are somewhere without room."""
        states = self._full_states(above=0)
        states[0] = False
        groups = self._riding > self.room.groups
        zones = np.zeros_like(self._zoned, dtype=np.bool_)
        for number, zone in enumerate(self.room.zones):
            zones[zone.steps, number] = self._zoned[zone.steps, number] > zone.most
        return [
            agent
            for agent, walk in enumerate(walks)
            if self._is_troubled(walk, states, groups, zones)
        ]

    def _is_troubled(self, walk: Walk, states: Bools, groups: Bools, zones: Bools) -> bool:
        steps, where = self._places(walk)
        if states[steps, where].any():
            return True
        if any(groups[step, group] for step, group in self._rides(walk)):
            return True
        return any(
            walk.number in zone.able and zones[steps[np.isin(where, zone.states)], number].any()
            for number, zone in enumerate(self.room.zones)
        )

    def _full_states(self, above: int) -> Bools:
        """States and steps at which there are more agents than would leave room for `above`."""
        return np.asarray(self._there + above > self.room.states)

    def overfull(self) -> tuple[Ints, Ints]:
        """The states and the groups of edges that are too full at some step after the first."""
        states = np.flatnonzero(self._full_states(above=0)[1:].any(axis=0))
        groups = np.flatnonzero((self._riding > self.room.groups).any(axis=0))
        return states, groups

    @property
    def excess(self) -> int:
        """By how many agents places are too full, summed over steps."""
        states = np.maximum(self._there[1:] - self.room.states, 0).sum()
        groups = np.maximum(self._riding - self.room.groups, 0).sum()
        total = states + groups
        for number, zone in enumerate(self.room.zones):
            total += np.maximum(self._zoned[zone.steps, number] - zone.most, 0).sum()
        return int(total)

    def burden(self, number: int) -> tuple[Floats, Floats]:
        """What one more agent of a class finds no room for: states at steps, and edges entered.

        Arrays (horizon + 1, states) and (horizon, edges) count the places that are full already.
        """
        graph = self.graphs[number]
        states = self._full_states(above=1).astype(np.float64)
        states[0] = 0.0
        for place, zone in enumerate(self.room.zones):
            if number in zone.able:
                full = zone.steps[self._zoned[zone.steps, place] >= zone.most]
                states[np.ix_(full, zone.states)] += 1.0
        edges = np.zeros((self.horizon, len(graph.tail)))
        grouped = np.flatnonzero(graph.group >= 0)
        if len(grouped):
            full = (self._riding[: self.horizon] + 1 > self.room.groups).astype(np.float64)
            before = np.concatenate([np.zeros((1, full.shape[1])), np.cumsum(full, axis=0)])
            begun = np.arange(self.horizon)[:, None]
            ended = np.minimum(begun + graph.duration[grouped], self.horizon)
            group = graph.group[grouped]
            edges[:, grouped] = before[ended, group] - before[begun, group]
        return states, edges
