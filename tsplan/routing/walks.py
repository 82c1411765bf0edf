"""The way of every single agent of a point, and the point that a set of ways is."""

from __future__ import annotations

from collections import defaultdict, deque
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from tsplan.encode.class_columns import ClassColumns
from tsplan.encode.class_graph import ClassGraph
from tsplan.encode.encoded import Encoded, Point, Setting
from tsplan.encode.flow_network import Network, laid_out
from tsplan.encode.map_reduction import Reduced
from tsplan.encode.memory import Watch
from tsplan.encode.planned_ways import Planned
from tsplan.encode.read_back import Moves, moves_of
from tsplan.milp.model import Draft, Floats, Ints

UNDER_WAY = -1
"""Stands for the state of an agent that is on an edge."""


@dataclass(frozen=True, eq=False)
class Walk:
    """The way of one agent of a class: the edges of the class's map that it enters, and when.

    `number` is that of the class, `start` the agent's first state. Waits are edges, too.
    """

    number: int
    start: int
    edges: Ints
    steps: Ints

    def states(self, graph: ClassGraph, horizon: int) -> Ints:
        """Where the agent is at each of the steps 0..horizon; UNDER_WAY on edges."""
        where = np.full(horizon + 1, UNDER_WAY)
        where[0] = self.start
        ends = self.steps + graph.duration[self.edges]
        inside = ends <= horizon
        where[ends[inside]] = graph.head[self.edges[inside]]
        return where


def walks_of(point: Point) -> list[Walk]:
    """The ways of all agents of a point, class by class; whoever came first leaves first."""
    setting = point.encoded.setting
    return [
        walk
        for number, (item, moves) in enumerate(moves_of(point))
        for walk in _class_walks(number, item.graph, moves, setting.horizon)
    ]


def _class_walks(number: int, graph: ClassGraph, moves: Moves, horizon: int) -> list[Walk]:
    entered: list[list[tuple[int, int]]] = [[] for _ in range(horizon)]
    for edge, step, count in sorted(zip(*(part.tolist() for part in moves), strict=True)):
        entered[step].append((edge, count))
    tail, head, duration = graph.tail.tolist(), graph.head.tolist(), graph.duration.tolist()
    edges: list[list[int]] = []
    steps: list[list[int]] = []
    present: list[dict[int, deque[int]]] = [defaultdict(deque) for _ in range(horizon + 1)]
    starts: list[int] = []
    for state in np.flatnonzero(graph.start).tolist():
        for _ in range(int(graph.start[state])):
            present[0][state].append(len(starts))
            starts.append(state)
            edges.append([])
            steps.append([])
    for step, leaving in enumerate(entered):
        for edge, count in leaving:
            for _ in range(count):
                agent = present[step][tail[edge]].popleft()
                edges[agent].append(edge)
                steps[agent].append(step)
                if step + duration[edge] <= horizon:
                    present[step + duration[edge]][head[edge]].append(agent)
    return [
        Walk(number, start, np.array(mine, dtype=np.int64), np.array(when, dtype=np.int64))
        for start, mine, when in zip(starts, edges, steps, strict=True)
    ]


def walks_along(ways: Sequence[Planned]) -> list[Walk]:
    """The ways of single agents."""
    found = []
    for way in ways:
        edges, steps = np.array(way.entries, dtype=np.int64).reshape(-1, 2).T
        found += [Walk(way.number, way.start, edges, steps)] * way.agents
    return found


def point_of(setting: Setting, walks: Sequence[Walk], level: int) -> Point:
    """The point in which agents go these ways: of a network with no other edge in it.

    Its model has the flows alone, since whoever reads a point reads its moves.
    """
    draft = Draft(Watch(setting.clock))
    reduced: list[Reduced] = []
    laid: list[ClassColumns] = []
    counts: list[Floats] = []
    for number, item in enumerate(setting.classes):
        mine = [walk for walk in walks if walk.number == number]
        edge = np.concatenate([*(walk.edges for walk in mine), np.empty(0, dtype=np.int64)])
        step = np.concatenate([*(walk.steps for walk in mine), np.empty(0, dtype=np.int64)])
        used, place = np.unique(edge, return_inverse=True)
        first = np.full(len(used), setting.horizon)
        last = np.full(len(used), -1)
        np.minimum.at(first, place, step)
        np.maximum.at(last, place, step)
        graph = replace(item.graph.among(used), entries=(first, last))
        columns = laid_out(graph, setting.horizon, draft, upper=float(graph.agents))
        taken = np.zeros(int(np.maximum(columns.last - columns.first + 1, 0).sum()))
        base = int(columns.offset[0]) if len(used) else 0
        np.add.at(taken, columns.offset[place] - base + step - columns.first[place], 1.0)
        reduced.append(Reduced(graph, tuple(used.reshape(-1, 1))))
        laid.append(columns)
        counts.append(taken)
    values = np.concatenate([*counts, np.empty(0)])
    encoded = Encoded(
        setting=replace(setting, reduced=tuple(reduced), level=level),
        model=draft.build(),
        network=Network(tuple(laid), setting.horizon),
        indicators=np.empty(0, dtype=np.int64),
        flows=np.arange(len(values)),
        level=level,
    )
    return Point(encoded, values, tight=True)
