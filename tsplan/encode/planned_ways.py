"""The ways of a plan that is known already, as flows of a model: where a search may begin.

Nothing rests on them: flows that are none of a model's are found out, and then nothing is known.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, NamedTuple, TypeAlias

import numpy as np

from tsplan.encode.map_reduction import whole
from tsplan.name_runs import RunMap
from tsplan.plans.bundles import Agents

if TYPE_CHECKING:
    from tsplan.encode.class_graph import ClassGraph
    from tsplan.encode.encoded import Encoded, Setting
    from tsplan.encode.map_reduction import Reduced
    from tsplan.milp.model import Floats
    from tsplan.plans.bundles import Bundle
    from tsplan.plans.plan import Plan

Entries: TypeAlias = "list[tuple[int, int]]"
"""Edges of a map, and the step at which each is entered, in order."""


class Planned(NamedTuple):
    """Agents of a class, by its number, that begin at a state and go one way."""

    number: int
    start: int
    agents: int
    entries: Entries


def planned_ways(setting: Setting, plan: Plan) -> list[Planned]:
    """The ways of a plan's agents, as far as the maps of their classes have them.

    Where a path cannot be followed any further its agents wait, and so do agents that the plan
    does not know.
    """
    paths, state = RunMap(Agents.of(plan.agents).stretches), setting.arrays.number
    found = []
    for number, item in enumerate(setting.classes):
        follow = Following(item.graph, setting.horizon, state)
        for rank in setting.mission.ranks:
            if rank.group not in item.groups:
                continue
            start = state[rank.place]
            for part, path in paths.parts(rank.names):
                found.append(Planned(number, start, part.size, follow.entries(start, path)))
    return found


def planned_flows(encoded: Encoded, ways: Sequence[Planned], *, tight: bool) -> Floats | None:
    """The values of a model's flow columns if all go these ways; None where they cannot.

    Those of the `tight` encoding are on reduced maps. None, too, where agents move together, may
    be late or rebuilt, or end where nobody knows.
    """
    setting = encoded.setting
    graphs = [item.graph for item in setting.classes]
    if encoded.swarms or any(graph.modes or graph.layer or graph.outcomes for graph in graphs):
        return None
    values = np.zeros(encoded.model.size.columns)
    shorts = setting.reduced if tight else map(whole, graphs)
    lifting = [_Lifting(*each) for each in zip(graphs, shorts, strict=True)]
    for way in ways:
        columns = encoded.network.classes[way.number]
        for edge, step in lifting[way.number].entries(way, setting.horizon):
            if not columns.first[edge] <= step <= columns.last[edge]:
                return None
            values[columns.offset[edge] + step - columns.first[edge]] += way.agents
    return values[encoded.flows]


@dataclass(frozen=True)
class Following:
    """Follows paths on the map of a class, given the numbers of the states."""

    graph: ClassGraph
    horizon: int
    state: Mapping[str, int]

    @cached_property
    def _edges(self) -> dict[tuple[int, int], tuple[int, int]]:
        ends = zip(*(a.tolist() for a in (self.graph.tail, self.graph.head)), strict=True)
        durations = self.graph.duration.tolist()
        return {pair: (edge, durations[edge]) for edge, pair in enumerate(ends)}

    def entries(self, start: int, path: Bundle | None) -> Entries:
        """The edges that an agent enters which begins at a state and takes a path.

        Where that cannot be followed any further it waits.
        """
        made, where, _ = self._followed(start, path)
        return made + self._waiting(where, self._end(made), self.horizon)

    def whole(self, start: int, path: Bundle) -> Entries | None:
        """The same of a path that can be followed to its end, else None."""
        made, where, whole = self._followed(start, path)
        waits = self._waiting(where, self._end(made), self.horizon)
        if not whole or self._end(made + waits) < self.horizon:
            return None
        return [entry for entry in made + waits if entry[1] < self.horizon]

    def _followed(self, start: int, path: Bundle | None) -> tuple[Entries, int, bool]:
        """The edges up to the last arrival, where that is, and whether the path ends there."""
        made: Entries = []
        where, step = start, 0
        if start in self.graph.coming:
            (edge,) = np.flatnonzero(self.graph.tail == start).tolist()
            made.append((edge, 0))
            where, step = int(self.graph.head[edge]), int(self.graph.duration[edge])
        for target, depart, arrive in () if path is None else self._rides(path):
            made += self._waiting(where, step, depart)
            edge, duration = self._edges.get((where, target), (-1, 0))
            if edge < 0 or depart < step or (arrive is not None and depart + duration != arrive):
                return made, where, False
            made.append((edge, depart))
            where, step = target, depart + duration
        return made, where, True

    def _end(self, entries: Entries) -> int:
        """When an agent has left the last of some edges."""
        if not entries:
            return 0
        edge, step = entries[-1]
        return step + int(self.graph.duration[edge])

    def _rides(self, path: Bundle) -> Iterator[tuple[int, int, int | None]]:
        """Where a path goes, when it leaves for there and when it arrives."""
        for before, after in zip(path.stays, path.stays[1:], strict=False):
            yield self.state.get(after[2], -1), before[1], after[0]
        if path.heading is not None and path.stays and path.stays[-1][1] < self.horizon:
            yield self.state.get(path.heading, -1), path.stays[-1][1], None

    def _waiting(self, where: int, step: int, until: int) -> Entries:
        edge, duration = self._edges.get((where, where), (-1, 1))
        return [] if edge < 0 else [(edge, when) for when in range(step, until, duration)]


class _Lifting:
    """Turns ways on the map of a class into ways on its reduced map."""

    def __init__(self, graph: ClassGraph, short: Reduced) -> None:
        self._graph = graph
        self._same = short.graph is graph
        self._kept = {*short.graph.tail.tolist(), *short.graph.head.tolist()}
        self._paths = {tuple(path.tolist()): edge for edge, path in enumerate(short.paths)}
        self._between: dict[tuple[int, int], list[tuple[int, int]]] = {}
        ends = zip(short.graph.tail.tolist(), short.graph.head.tolist(), strict=True)
        for edge, (pair, lasts) in enumerate(zip(ends, short.graph.duration.tolist(), strict=True)):
            self._between.setdefault(pair, []).append((lasts, edge))

    def entries(self, way: Planned, horizon: int) -> Entries:
        """The reduced edges that are entered, and when."""
        return way.entries if self._same else list(self._lifted(way, horizon))

    def _lifted(self, way: Planned, horizon: int) -> Iterator[tuple[int, int]]:
        graph = self._graph
        where, since, path = way.start, 0, []
        for edge, step in way.entries:
            head, arrive = int(graph.head[edge]), step + int(graph.duration[edge])
            path.append(edge)
            if head in self._kept:
                yield from self._ride((where, head), tuple(path), since, arrive)
                where, since, path = head, arrive, []
        yield from self._waiting(where, since, horizon)

    def _ride(
        self, ends: tuple[int, int], path: tuple[int, ...], since: int, arrive: int
    ) -> Iterator[tuple[int, int]]:
        """Waits and the edge by which one goes from one kept state to another in some time."""
        if path in self._paths:
            yield self._paths[path], since
            return
        fitting = [each for each in self._between.get(ends, ()) if each[0] <= arrive - since]
        if not fitting:
            yield -1, since
            return
        lasts, edge = min(fitting)
        yield from self._waiting(ends[0], since, arrive - lasts)
        yield edge, arrive - lasts

    def _waiting(self, where: int, step: int, until: int) -> Iterator[tuple[int, int]]:
        (_, edge), *_ = self._between.get((where, where), [(1, -1)])
        return ((edge, when) for when in range(step, until))
