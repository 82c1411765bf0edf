"""Edges entered at a step, by which robots can carry something, and how much room they have.

There is one lane for all classes that take an edge in the same time; classes with a compartment for
each resource and those with one hold have lanes of their own.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from math import floor

import numpy as np

from tsplan.encode.flow_network import Network
from tsplan.milp.model import Bools, Floats, Ints
from tsplan.mission import Resource
from tsplan.mission.resources import Carries, compartment


@dataclass(frozen=True, eq=False)
class Lanes:
    """Edges entered at a step, each once for all classes that take it in the same time."""

    tail: Ints
    head: Ints
    duration: Ints
    step: Ints
    held: bool  # whether these robots have one hold

    @property
    def end(self) -> Ints:
        """The step at which each is left."""
        return self.step + self.duration

    def at(self, places: Ints | Bools) -> Lanes:
        """Some of them."""
        ends = self.tail[places], self.head[places]
        return Lanes(*ends, self.duration[places], self.step[places], self.held)


@dataclass(frozen=True, eq=False)
class LaneTable:
    """Lanes, and the flow columns on them: lane, column and class of each."""

    lanes: Lanes
    lane: Ints
    column: Ints
    group: Ints
    carries: tuple[Carries, ...]  # of each class

    @property
    def parted(self) -> bool:
        """Whether some hold is no whole number."""
        return any(item != floor(item) for item in self.carries if not isinstance(item, tuple))

    def rooms_of(self, resource: Resource | None, *, pieces: bool) -> Floats:
        """What a robot of each class carries of a resource, or in its one hold."""
        found = []
        for item in self.carries:
            room = 0.0
            if isinstance(item, tuple) and resource is not None:
                room = float(compartment(item, resource) or 0)
            elif not isinstance(item, tuple) and resource is None:
                room = float(floor(item)) if pieces else item
            found.append(room)
        return np.array(found)

    def room(self, resource: Resource) -> Floats:
        """The most that one robot of those on each lane carries of a resource."""
        most = self.rooms_of(None if self.lanes.held else resource, pieces=resource.indivisible)
        found = np.zeros(len(self.lanes.step))
        np.maximum.at(found, self.lane, most[self.group])
        return found


def lane_table(network: Network, *, held: bool) -> LaneTable:
    """The lanes of the classes with one hold, or of those with compartments."""
    parts = []
    for number, item in enumerate(network.classes):
        if item.graph.carries == () or isinstance(item.graph.carries, tuple) is held:
            continue
        edge, step, column = item.unrolled()
        graph = item.graph
        rides = np.isin(edge, graph.rides)
        chosen = np.flatnonzero((graph.tail[edge] != graph.head[edge]) & rides)
        edge, step, column = edge[chosen], step[chosen], column[chosen]
        keys = np.stack([graph.tail[edge], graph.head[edge], graph.duration[edge], step])
        parts.append((keys, column, np.full(len(column), number)))
    keys = np.concatenate([*(key for key, _, _ in parts), np.empty((4, 0), dtype=np.int64)], axis=1)
    lanes, lane = np.unique(keys, axis=1, return_inverse=True)
    return LaneTable(
        Lanes(lanes[0], lanes[1], lanes[2], lanes[3], held),
        lane.reshape(-1),
        joined(column for _, column, _ in parts),
        joined(group for _, _, group in parts),
        tuple(item.graph.carries for item in network.classes),
    )


def joined(parts: Iterable[Ints]) -> Ints:
    """Arrays of numbers one after the other, perhaps none."""
    return np.concatenate([*parts, np.empty(0, dtype=np.int64)])
