"""Structures of modules in the flow network: a class of each configuration, and what couples them.

A configuration is a layer: its structures flow over a map of their own, whose durations, costs and
closed states are those of the configuration. A reconfiguration takes structures of some layers off
a state and brings structures of others there when it is done. In a layer it is an edge to nowhere
or from nowhere; a column for each reconfiguration, state and step says how often it begins, and how
many structures enter each of these edges then.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple, TypeAlias

import numpy as np

from tsplan.encode.agent_classes import (
    AgentClass,
    allowed_edges,
    arrays_of,
    begun_edges,
    starts_of,
)
from tsplan.encode.class_columns import ClassColumns
from tsplan.encode.class_graph import ClassGraph, Layer
from tsplan.encode.demand_rows import Built
from tsplan.encode.flow_network import Network
from tsplan.encode.running_sums import RunningSums, unfolded
from tsplan.limits import MOST_STEPS
from tsplan.milp.model import Draft, Floats, Ints
from tsplan.mission import Configuration, Mission
from tsplan.mission.configurations import Pool
from tsplan.ts.reachability import Lengths

PART = "structures"
"""The name of this part among those of a model."""

_NEVER = 4 * MOST_STEPS

Ends: TypeAlias = "tuple[tuple[int, int, int], ...]"
"""Classes, which of its edges to or from nowhere, and how many structures enter it."""


class Change(NamedTuple):
    """A reconfiguration at a state: by which edges of which classes structures go and come.

    `rule` is its place among those of the mission, `begin` the first step at which it can begin,
    and `end` that at which it is done then.
    """

    rule: int
    state: int
    begin: int
    end: int
    parts: Ends
    made: Ends


@dataclass(frozen=True, eq=False)
class Rebuilding:
    """The columns that say how often a change begins at a step: which change, and when it ends."""

    changes: tuple[Change, ...]
    columns: Ints
    change: Ints
    end: Ints  # the step at which it is done

    def price(self, vector: Floats, prices: Sequence[float]) -> None:
        """Set the coefficients of all columns in a vector, given one for each rule."""
        each = np.array([prices[change.rule] for change in self.changes], dtype=np.float64)
        vector[self.columns] = each[self.change]


def structure_classes(
    mission: Mission, named: Iterable[str], first: int, *, priced: bool, carrying: bool
) -> tuple[tuple[AgentClass, ...], tuple[Change, ...]]:
    """The classes of a mission's structures, numbered from `first` on, and their changes."""
    classes: list[AgentClass] = []
    changes: list[Change] = []
    for pool in mission.modular.pools(mission.team):
        layers = _Layers(mission, pool, first + len(classes))
        made = layers.changes()
        classes += layers.classes(frozenset(named), priced=priced, carrying=carrying)
        changes += made
    return tuple(classes), tuple(changes)


def first_steps(mission: Mission, pool: Pool) -> Mapping[str, Mapping[str, int]]:
    """The first step at which structures of each shape of a pool can be at each state, if ever.

    Of parts that are rebuilt together all are thought to wait for the last.
    """
    layers = _Layers(mission, pool, 0)
    layers.changes()
    return layers.first_steps()


class _HalfEdge(NamedTuple):
    """An edge to or from nowhere."""

    tail: int
    head: int
    duration: int
    begins: int


class _Layers:
    """The layers of the modules that can be in one structure."""

    def __init__(self, mission: Mission, pool: Pool, first: int) -> None:
        self._mission = mission
        self._pool = pool
        self._first = first
        self._arrays = arrays_of(mission.system, mission.team)
        self._group = mission.team[pool.groups[0]]
        self._able = [self._group.capabilities | shape.capabilities for shape in pool.shapes]
        steps = [
            self._durations(shape, able)
            for shape, able in zip(pool.shapes, self._able, strict=True)
        ]
        self._edges = [np.flatnonzero(each) for each in steps]
        self._steps = [each[used] for each, used in zip(steps, self._edges, strict=True)]
        self._starts = [self._start(shape) for shape in pool.shapes]
        self._half: list[list[_HalfEdge]] = [[] for _ in pool.shapes]
        self._reach = [np.where(start > 0, 0, _NEVER) for start in self._starts]
        # who is being rebuilt uses no room, so it is on no edge of the map
        ways = {ends: n for n, ends in enumerate(mission.system.edges) if ends[0] != ends[1]}
        self._begun = [begun_edges(start, self._arrays, ways) for start in self._starts]

    def _durations(self, shape: Configuration, able: frozenset[str]) -> Ints:
        """Steps that each edge takes; 0 where the structures cannot go."""
        edges = self._mission.system.edges.values()
        name = self._group.class_name
        steps = np.array([shape.steps(edge, name) or 0 for edge in edges], dtype=np.int64)
        return np.where(allowed_edges(self._mission.system, able), steps, 0)

    def _start(self, shape: Configuration) -> Ints:
        """How many structures of a configuration start at each state."""
        start = np.zeros(len(self._arrays.names), dtype=np.int64)
        for number in self._pool.groups:
            group = self._mission.team[number]
            if group.configuration == shape.name:
                start += starts_of(self._mission.modular.structures(group), self._arrays)
        return start

    def _closed(self, shape: int, state: str) -> bool:
        return not self._mission.system.states[state].needs <= self._able[shape]

    def _possible(self) -> Iterator[tuple[int, str, dict[str, list[tuple[int, int]]]]]:
        """Every rule at every state where it may be done: its sides by layers and counts."""
        number = {shape.name: place for place, shape in enumerate(self._pool.shapes)}
        system = self._mission.system
        for rule, each in enumerate(self._mission.modular.reconfigurations):
            sides = {"parts": each.parts, "made": each.made}
            if any(name not in number for side in sides.values() for name, _ in side):
                continue
            if self._mission.modular.modules(each.parts) > self._pool.count:
                continue
            counts = {
                key: [(number[name], count) for name, count in side] for key, side in sides.items()
            }
            named = {s for name in each.at for s in (name, *system.labels.get(name, ()))}
            for state in system.states:
                able = not any(self._closed(shape, state) for shape, _ in counts["made"])
                if able and (not each.at or state in named):
                    yield rule, state, counts

    def changes(self) -> list[Change]:
        """The changes that can ever begin; the layers then know their edges to and from nowhere."""
        every = list(self._possible())
        self._settle(every)
        found = []
        for rule, state, counts in every:
            place = self._arrays.number[state]
            begin = max(int(self._reach[shape][place]) for shape, _ in counts["parts"])
            if begin >= _NEVER:
                continue
            steps = self._mission.modular.reconfigurations[rule].duration
            nowhere = len(self._arrays.names)
            parts, made = (
                self._half_edges(counts[key], _HalfEdge(*ends, steps, begin))
                for key, ends in (("parts", (place, nowhere)), ("made", (nowhere, place)))
            )
            found.append(Change(rule, place, begin, begin + steps, parts, made))
        return found

    def first_steps(self) -> dict[str, dict[str, int]]:
        """When each layer can be where, as it is settled."""
        names = self._mission.system.states  # without the places of those under way behind them
        rows = (dict(zip(names, row.tolist(), strict=False)) for row in self._reach)
        return {
            shape.name: {state: step for state, step in row.items() if step < _NEVER}
            for shape, row in zip(self._pool.shapes, rows, strict=True)
        }

    def _half_edges(self, side: Sequence[tuple[int, int]], made: _HalfEdge) -> Ends:
        """One more edge to or from nowhere of each layer of a side."""
        found = []
        for shape, count in side:
            found.append((self._first + shape, len(self._half[shape]), count))
            self._half[shape].append(made)
        return tuple(found)

    def _settle(
        self, every: Sequence[tuple[int, str, Mapping[str, Sequence[tuple[int, int]]]]]
    ) -> None:
        """The first step at which structures of each layer can be at each state."""
        rules = self._mission.modular.reconfigurations
        settled = False
        while not settled:
            before = [reach.copy() for reach in self._reach]
            for reach, edges, steps in zip(self._reach, self._edges, self._steps, strict=True):
                ends = reach[self._arrays.tail[edges]] + steps
                np.minimum.at(reach, self._arrays.head[edges], np.minimum(ends, _NEVER))
            for reach, begun in zip(self._reach, self._begun, strict=True):
                np.minimum.at(reach, begun["head"], begun["duration"])
            for rule, state, counts in every:
                place = self._arrays.number[state]
                begin = max(int(self._reach[shape][place]) for shape, _ in counts["parts"])
                for shape, _ in counts["made"] if begin < _NEVER else ():
                    end = begin + rules[rule].duration
                    self._reach[shape][place] = min(self._reach[shape][place], end)
            settled = all(map(np.array_equal, before, self._reach))

    def classes(self, named: frozenset[str], *, priced: bool, carrying: bool) -> list[AgentClass]:
        """The classes of the layers."""
        shapes = range(len(self._pool.shapes))
        return [
            AgentClass(
                self._graph(shape, named, priced=priced, carrying=carrying),
                self._pool.groups,
                shape=self._pool.shapes[shape].name,
            )
            for shape in shapes
        ]

    def _graph(
        self, shape: int, named: frozenset[str], *, priced: bool, carrying: bool
    ) -> ClassGraph:
        made, edges, arrays = self._pool.shapes[shape], self._edges[shape], self._arrays
        half = np.array(self._half[shape], dtype=np.int64).reshape(-1, 4)
        none, begun = np.zeros(len(half)), self._begun[shape]
        rides = len(edges) + len(begun["tail"])
        reach = np.append(self._reach[shape], _NEVER)
        tail = np.concatenate([arrays.tail[edges], begun["tail"], half[:, 0]])
        costs = self._costs(made, edges) if priced else np.zeros(len(edges))
        return ClassGraph(
            capabilities=self._able[shape] & named,
            start=np.append(self._starts[shape], 0),
            tail=tail,
            head=np.concatenate([arrays.head[edges], begun["head"], half[:, 1]]),
            duration=np.concatenate([self._steps[shape], begun["duration"], half[:, 2]]),
            cost=np.concatenate([costs, begun["cost"], none]),
            risk=np.concatenate([arrays.risk[edges], begun["risk"], none]),
            group=np.concatenate([arrays.group[edges], begun["group"], np.full(len(half), -1)]),
            carries=made.carries if carrying else (),
            coming=begun["tail"],
            layer=Layer(
                rides=rides,
                reach=reach,
                begins=np.concatenate([reach[tail[:rides]], half[:, 3]]),
                modules=made.modules,
                most=self._pool.count // made.modules,
                pool=self._pool.groups[0],
            ),
        )

    def _costs(self, shape: Configuration, edges: Ints) -> Floats:
        """Cost of every edge, as a whole number of the mission's cost units."""
        every, unit = list(self._mission.system.edges.values()), self._mission.cost_unit
        name = self._group.class_name
        return np.array([float(shape.price(every[edge], name) / unit) for edge in edges.tolist()])


def rebuilding(changes: Sequence[Change], network: Network, draft: Draft) -> Rebuilding:
    """The columns of all changes, and the rows by which structures go and come."""
    spans = np.zeros(len(changes), dtype=np.int64)
    most = np.zeros(len(changes))
    for number, change in enumerate(changes):
        sides = [(network.classes[where], half, count) for where, half, count in change.parts]
        item, half, _ = sides[0]  # all of these edges are entered at the same steps
        spans[number] = max(int(item.last[item.graph.half(half)]) - change.begin + 1, 0)
        most[number] = min(each.graph.agents // count for each, _, count in sides)
    place = np.cumsum(spans) - spans
    columns = draft.columns(int(spans.sum()), upper=np.repeat(most, spans), integer=True)
    for number, change in enumerate(changes):
        every = np.arange(spans[number])
        begun = columns[place[number] + every]
        for where, half, count in (*change.parts, *change.made):
            item = network.classes[where]
            entered = int(item.offset[item.graph.half(half)]) + every
            terms = (every, entered, 1.0), (every, begun, -float(count))
            draft.sums(*terms, lower=0.0, upper=0.0, count=len(every), kind="rebuilt")
    which, step = unfolded(np.array([change.end for change in changes], dtype=np.int64), spans)
    return Rebuilding(tuple(changes), columns, which, step)


def growth_rows(
    rebuilt: Rebuilding, network: Network, needs: Iterable[Built], draft: Draft
) -> None:
    """Growth cuts: modules in large structures must have come to where they are needed.

    Whoever serves a demand is of a configuration that can, and of at least so many modules. Of all
    configurations of at least that many, as many modules as the demand needs were at its states
    from the start on, or have come there, or have come into such structures there. In the LP a
    little of a structure would else be taken apart and put together again for every witness.
    """
    for need in needs:
        able = network.having(need.capability)
        layers = [item.graph.layer for item in able if item.graph.layer is not None]
        if len(layers) < len(able) or len({layer.pool for layer in layers}) > 1:
            continue
        least = min(layer.modules for layer in layers)
        pool = [
            c for c in network.classes if c.graph.layer and c.graph.layer.pool == layers[0].pool
        ]
        surroundings = _surroundings(pool, need.states)
        for size in sorted({c.graph.modules for c in pool if c.graph.modules <= least}):
            large = [c.graph.modules if c in pool else 0 for c in network.classes]
            large = [modules if modules >= size else 0 for modules in large]
            grown, begun = _growth(rebuilt, network, large, need.states)
            places = np.arange(len(need.asked.steps))
            zeros, asked_last = np.zeros_like(places), need.asked.steps[-1:]
            come = grown.over(draft, zeros, need.asked.steps)
            row, column, amount = need.asked.begun.over(draft, zeros, places)
            terms = come, (row, column, -float(least) * amount)
            draft.sums(*terms, lower=-float(begun), count=len(places), kind="growth")
            for around in surroundings:
                grown, begun = _growth(rebuilt, network, large, around)
                come = grown.over(draft, zeros[-1:], asked_last)
                row, column, amount = need.asked.begun.over(draft, zeros[-1:], places[-1:])
                terms = come, (row, column, -float(least) * amount)
                draft.sums(*terms, lower=-float(begun), kind="growth")


def _surroundings(pool: Sequence[ClassColumns], states: Sequence[int]) -> list[list[int]]:
    """The states around some, nearer and farther ones, up to where modules begin."""
    graphs = [item.graph.among(item.graph.rides) for item in pool]
    tail, head, steps = (
        np.concatenate([getattr(graph, name) for graph in graphs])
        for name in ("tail", "head", "duration")
    )
    far = Lengths(graphs[0].states, head, tail, steps).nearest(states)
    begins = sum(item.graph.start for item in pool) > 0
    nearest = far[begins].min(initial=np.inf)
    radii = np.unique(far[(far > 0) & (far < nearest)])
    return [np.flatnonzero(far <= radius).tolist() for radius in radii]


def _growth(
    rebuilt: Rebuilding, network: Network, large: Sequence[int], states: Sequence[int]
) -> tuple[RunningSums, int]:
    """Modules that come into large structures at some states, and those that begin there.

    `large` has the modules of the structures of each class that count.
    """
    gains = np.array([_gain(change, large, states) for change in rebuilt.changes], dtype=np.float64)
    mine = gains[rebuilt.change] > 0
    ends, columns = [rebuilt.end[mine]], [rebuilt.columns[mine]]
    values = [gains[rebuilt.change[mine]]]
    site, steps, begun = np.array(states), np.arange(network.horizon + 1), 0
    for item, modules in zip(network.classes, large, strict=True):
        if modules:
            position, column = item.riding(site, steps)
            ends, columns = [*ends, position], [*columns, column]
            values.append(np.full(len(column), float(modules)))
            begun += modules * int(item.graph.start[site].sum())
    grown = RunningSums(np.concatenate(ends), np.concatenate(columns), np.concatenate(values))
    return grown, begun


def _gain(change: Change, large: Sequence[int], states: Sequence[int]) -> int:
    """How many modules more are in large structures at some states after a change, if any."""
    if change.state not in states:
        return 0
    made = sum(count * large[where] for where, _, count in change.made)
    return max(made - sum(count * large[where] for where, _, count in change.parts), 0)
