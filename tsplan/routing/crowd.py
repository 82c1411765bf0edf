"""How many agents are where, and where that is more than there is room for."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TypeAlias

import numpy as np

from tsplan.encode.class_graph import ClassGraph
from tsplan.encode.encoded import Setting
from tsplan.milp.model import Bools, Floats, Ints
from tsplan.routing.walks import UNDER_WAY, Walk

_MANY = np.iinfo(np.int64).max // 2  # agents that there never are

Entries: TypeAlias = tuple[Ints, Ints, Floats]
"""Rows and columns of a table, and what is there."""


@dataclass(frozen=True, eq=False)
class Quota:
    """States at which at most so many agents of the `able` classes may be, together, at `steps`."""

    states: Ints
    able: frozenset[int]
    steps: Ints
    most: int


@dataclass(frozen=True, eq=False)
class Room:
    """What states, groups of edges and quotas hold; more than all agents without a limit.

    Groups are those of the map, its zones among them; `zone` is that of each state, or -1.
    """

    states: Ints
    groups: Ints
    zone: Ints
    quotas: tuple[Quota, ...] = ()

    @classmethod
    def of(cls, setting: Setting, quotas: Sequence[Quota] = ()) -> Room:
        """The capacities of the map of a setting."""
        states = np.full(len(setting.arrays.names), _MANY)
        for state, capacity in setting.arrays.capacity:
            states[state] = capacity
        zone = np.full(len(states), -1)
        for group, members in setting.arrays.zone_states.items():
            zone[members] = group
        groups = np.array(setting.arrays.group_capacity, dtype=np.int64)
        return cls(states, groups, zone, tuple(quotas))


@dataclass(eq=False)
class Crowd:
    """Counts of agents at states, on groups of edges and in quotas, kept up as agents come and go.

    `starting` agents count at no state at step 0, where capacities are the mission's to check.
    """

    graphs: Sequence[ClassGraph]
    room: Room
    horizon: int
    _there: Ints = field(init=False)
    _riding: Ints = field(init=False)
    _counted: Ints = field(init=False)
    _edges: dict[int, tuple[Ints, Ints]] = field(default_factory=dict, init=False)

    def __post_init__(self) -> None:
        steps = self.horizon + 1
        self._zoned = np.flatnonzero(self.room.zone >= 0)
        self._there = np.zeros((steps, len(self.room.states)), dtype=np.int64)
        self._riding = np.zeros((steps, len(self.room.groups)), dtype=np.int64)
        self._counted = np.zeros((steps, len(self.room.quotas)), dtype=np.int64)

    def add(self, walk: Walk, count: int = 1) -> None:
        """Count an agent in, or with -1 out."""
        steps, where = self._places(walk)
        self._there[steps, where] += count
        for step, group in self._rides(walk):
            self._riding[step, group] += count
        for number, quota in enumerate(self.room.quotas):
            if walk.number in quota.able:
                self._counted[steps[np.isin(where, quota.states)], number] += count

    def _places(self, walk: Walk) -> tuple[Ints, Ints]:
        where = walk.states(self.graphs[walk.number], self.horizon)
        steps = np.flatnonzero(where != UNDER_WAY)
        return steps, where[steps]

    def _rides(self, walk: Walk) -> list[tuple[int, int]]:
        """The steps at which an agent is on an edge of a group, or at a state of a zone.

        Whoever leaves a state of a zone is counted there, and on the edge from the next step on.
        """
        graph, zones = self.graphs[walk.number], set(self.room.zone.tolist())
        on = np.flatnonzero(graph.group[walk.edges] >= 0)
        edges = walk.edges[on]
        groups = graph.group[edges].tolist()
        begun = (walk.steps[on] + self._from_inside(graph, edges)).tolist()
        ends = (walk.steps[on] + graph.duration[edges]).tolist()
        found = [
            (step, group)
            for group, first, end in zip(groups, begun, ends, strict=True)
            for step in range(first, min(end, self.horizon + (group in zones)))
        ]
        steps, where = self._places(walk)
        zone = self.room.zone[where]
        inside = zone >= 0
        return found + list(zip(steps[inside].tolist(), zone[inside].tolist(), strict=True))

    def _from_inside(self, graph: ClassGraph, edges: Ints) -> Bools:
        """Whether edges leave a state of the zone that they are in themselves."""
        zone = self.room.zone[graph.tail[edges]]
        return np.asarray((zone >= 0) & (zone == graph.group[edges]))

    def troubled(self, walks: Sequence[Walk]) -> list[int]:
        """Which of the agents, all counted in, are somewhere without room."""
        states = self._full_states(above=0)
        states[0] = False
        groups = self._riding > self.room.groups
        quotas = np.zeros_like(self._counted, dtype=np.bool_)
        for number, quota in enumerate(self.room.quotas):
            quotas[quota.steps, number] = self._counted[quota.steps, number] > quota.most
        return [
            agent
            for agent, walk in enumerate(walks)
            if self._is_troubled(walk, states, groups, quotas)
        ]

    def _is_troubled(self, walk: Walk, states: Bools, groups: Bools, quotas: Bools) -> bool:
        steps, where = self._places(walk)
        if states[steps, where].any():
            return True
        if any(groups[step, group] for step, group in self._rides(walk)):
            return True
        return any(
            walk.number in quota.able and quotas[steps[np.isin(where, quota.states)], number].any()
            for number, quota in enumerate(self.room.quotas)
        )

    def _full_states(self, above: int) -> Bools:
        """States and steps at which there are more agents than would leave room for `above`."""
        return np.asarray(self._there + above > self.room.states)

    def overfull(self) -> tuple[list[int], list[int]]:
        """The states and the groups of edges that are too full at some step after the first."""
        states = np.flatnonzero(self._full_states(above=0)[1:].any(axis=0))
        groups = np.flatnonzero((self._riding > self.room.groups).any(axis=0))
        return states.tolist(), groups.tolist()

    @property
    def excess(self) -> int:
        """By how many agents places are too full, summed over steps."""
        states = np.maximum(self._there[1:] - self.room.states, 0).sum()
        groups = np.maximum(self._riding - self.room.groups, 0).sum()
        total = states + groups
        for number, quota in enumerate(self.room.quotas):
            total += np.maximum(self._counted[quota.steps, number] - quota.most, 0).sum()
        return int(total)

    def burden(self, number: int) -> tuple[Entries, Entries]:
        """What one more agent of a class finds no room for: states at steps, and edges entered.

        Steps, states (or edges of the class) and how many of the places there are full already.
        """
        step, state = _nonzero(self._full_states(above=1)[1:])
        states = [(step + 1, state)]
        for place, quota in enumerate(self.room.quotas):
            if number in quota.able:
                full = quota.steps[self._counted[quota.steps, place] >= quota.most]
                states.append(tuple(part.ravel() for part in np.meshgrid(full, quota.states)))
        full = self._riding >= self.room.groups
        if self._zoned.size:
            step, zoned = _nonzero(full[:, self.room.zone[self._zoned]])
            states.append((step, self._zoned[zoned]))
        at = np.concatenate([part[0] for part in states])
        where = np.concatenate([part[1] for part in states])
        return (at, where, np.ones(len(at))), self._burdened(number, full)

    def _burdened(self, number: int, full: Bools) -> Entries:
        """The edges that lead through full groups, and how many of their steps do."""
        graph, (single, several) = self.graphs[number], self._grouped(number)
        step, group = _nonzero(full[: self.horizon])
        edges = single[group]
        place, column = _nonzero(edges >= 0)
        found = [(step[place], edges[place, column], np.ones(len(place)))]
        if len(several):
            inside = self._from_inside(graph, several)
            before = np.concatenate([np.zeros((1, full.shape[1])), np.cumsum(full, axis=0)])
            begun, group = np.arange(self.horizon)[:, None], graph.group[several]
            ended = np.minimum(begun + graph.duration[several], self.horizon)
            count = before[ended, group] - before[begun + inside, group]
            step, column = _nonzero(count)
            found.append((step, several[column], count[step, column]))
        steps, entered, counts = (np.concatenate(parts) for parts in zip(*found, strict=True))
        return steps, entered, counts

    def _grouped(self, number: int) -> tuple[Ints, Ints]:
        """The edges of a class in every group that last a step, filled up with -1; all others."""
        if number not in self._edges:
            graph = self.graphs[number]
            grouped = np.flatnonzero(graph.group >= 0)
            lasting = (graph.duration[grouped] > 1) | self._from_inside(graph, grouped)
            single = grouped[~lasting]
            single = single[np.argsort(graph.group[single], kind="stable")]
            groups = graph.group[single]
            begin = np.searchsorted(groups, np.arange(len(self.room.groups) + 1))
            table = np.full((len(self.room.groups), int(np.diff(begin).max(initial=0))), -1)
            table[groups, np.arange(len(groups)) - begin[groups]] = single
            self._edges[number] = table, grouped[lasting]
        return self._edges[number]


def _nonzero(table: Bools | Ints) -> tuple[Ints, Ints]:
    """Rows and columns of what is not zero, faster than numpy finds them in two dimensions."""
    rows, columns = np.divmod(np.flatnonzero(table), max(table.shape[1], 1))
    return rows, columns
