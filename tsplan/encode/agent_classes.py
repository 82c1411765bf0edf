"""From a mission's team to classes of interchangeable agents, each with its own graph.

Two groups of robots fall into one class when nothing in the problem tells them apart: they share
the capabilities that the problem names and move over the map in the same way. A swarm is a class of
its own, with bounds on the groups in which its agents move.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from types import MappingProxyType
from typing import Any

import numpy as np

from tsplan.encode.class_graph import ClassGraph, Outcomes
from tsplan.encode.map_memory import kept
from tsplan.exact import exact
from tsplan.milp.model import Bools, Floats, Ints
from tsplan.mission import Group, SwarmBounds, UnderWay
from tsplan.ts import TransitionSystem
from tsplan.ts.actions import Action
from tsplan.ts.edges import RISKS
from tsplan.ts.reachability import entries


@dataclass(frozen=True, eq=False)
class MapArrays:
    """A transition system as arrays: states and edges by number.

    Behind the states there is a place for every start under way, which none of the edges leads to;
    `coming` has their numbers.
    """

    names: tuple[str, ...]
    number: Mapping[str, int]
    tail: Ints
    head: Ints
    group: Ints
    risk: Floats
    capacity: tuple[tuple[int, int], ...]  # (state, most agents there)
    group_capacity: tuple[int, ...]
    zone_states: Mapping[int, Ints]  # the states that share the capacity of a group with its edges
    coming: tuple[UnderWay, ...] = ()

    @property
    def begun(self) -> Ints:
        """The numbers of the places of starts under way."""
        return np.arange(len(self.names) - len(self.coming), len(self.names))

    def states_with(self, system: TransitionSystem, label: str) -> Ints:
        """Numbers of the states that carry a label."""
        return np.array([self.number[name] for name in system.labels[label]], dtype=np.int64)


@dataclass(frozen=True, eq=False)
class AgentClass:
    """Interchangeable agents: their graph, and which groups of the team they are.

    A swarm has `bounds` on the sub-swarms in which its agents move; other agents move one by one.
    Structures of modules are of a `shape`, the name of their configuration.
    """

    graph: ClassGraph
    groups: tuple[int, ...]  # positions in the mission's team
    bounds: SwarmBounds | None = None
    shape: str | None = None

    def joined(self, start: Ints, group: int) -> AgentClass:
        """The class with the agents of one more group."""
        graph = replace(self.graph, start=self.graph.start + start)
        return replace(self, graph=graph, groups=(*self.groups, group))


_NONE: Mapping[str, SwarmBounds] = MappingProxyType({})


def arrays_of(system: TransitionSystem, team: Iterable[Group]) -> MapArrays:
    """The arrays of a map, with the places of the starts under way of a team."""
    coming = dict.fromkeys(start for group in team for start, _ in group.coming)
    arrays = map_arrays(system)
    if not coming:
        return arrays
    names = (*arrays.names, *(start.place for start in coming))
    number = {name: index for index, name in enumerate(names)}
    return replace(arrays, names=names, number=number, coming=tuple(coming))


@kept(16)
def map_arrays(system: TransitionSystem) -> MapArrays:
    """The arrays of a map; kept, since several problems may be posed on one map."""
    names = tuple(system.states)
    number = {name: index for index, name in enumerate(names)}
    pairs = list(system.edges)
    group = np.full(len(pairs), -1, dtype=np.int64)
    position = {pair: index for index, pair in enumerate(pairs)}
    zones = system.zone_parts
    groups = [*system.capacity_groups, *((system.zones[z], zones[z].edges) for z in zones)]
    for index, (_, members) in enumerate(groups):
        for pair in members:
            group[position[pair]] = index
    return MapArrays(
        names=names,
        number=number,
        tail=np.array([number[source] for source, _ in pairs], dtype=np.int64),
        head=np.array([number[target] for _, target in pairs], dtype=np.int64),
        group=group,
        risk=np.array([float(edge.risk * RISKS) for edge in system.edges.values()]),
        capacity=tuple(
            (number[state.name], state.capacity)
            for state in system.states.values()
            if state.capacity is not None
        ),
        group_capacity=tuple(capacity for capacity, _ in groups),
        zone_states={
            len(system.capacity_groups) + index: np.array(
                [number[name] for name in part.states], dtype=np.int64
            )
            for index, part in enumerate(zones.values())
        },
    )


@kept(64)
def _durations(system: TransitionSystem, class_name: str) -> Ints:
    """Duration of every edge for one class name; 0 where the class cannot go."""
    edges = system.edges.values()
    return np.array([edge.duration_for(class_name) or 0 for edge in edges], dtype=np.int64)


@kept(64)
def _costs(system: TransitionSystem, class_name: str, unit: Fraction) -> Floats:
    """Cost of every edge for one class name, as a whole number of units."""
    able = (edge.duration_for(class_name) is not None for edge in system.edges.values())
    return np.array(
        [
            float(exact(edge.cost_for(class_name)) / unit) if usable else 0.0
            for edge, usable in zip(system.edges.values(), able, strict=True)
        ],
        dtype=np.float64,
    )


@kept(64)
def allowed_edges(system: TransitionSystem, capabilities: frozenset[str]) -> Bools:
    """Which edges agents with these capabilities may use, by the needs of edges and states."""
    closed = {s.name for s in system.states.values() if s.needs and not s.needs <= capabilities}
    return np.array(
        [
            (not edge.needs or edge.needs <= capabilities)
            and (not closed or (edge.source not in closed and edge.target not in closed))
            for edge in system.edges.values()
        ],
        dtype=np.bool_,
    )


def agent_classes(
    system: TransitionSystem,
    team: Sequence[Group],
    named: Iterable[str],
    *,
    bounds: Mapping[str, SwarmBounds] = _NONE,
    unit: Fraction | None = None,
    carrying: bool = False,
    apart: bool = False,
) -> tuple[AgentClass, ...]:
    """The classes of the robots of a team, given the capabilities that the problem names.

    `bounds` are those of the swarms by their class names. The graphs have costs in a `unit` where
    these matter, and zeros otherwise; what robots carry tells them apart where there is anything to
    carry (`carrying`).
    Classes of different names are told `apart` where they may not share a policy.
    """
    if system.actions:
        return action_classes(system, team, named, apart=apart)
    arrays = arrays_of(system, team)
    known = frozenset(named)
    needed = _needed(system)
    classes: dict[object, AgentClass] = {}
    for index, group in enumerate(team):
        if group.configuration is not None:  # modules act as structures
            continue
        durations = _durations(system, group.class_name)
        costs = np.zeros(len(durations)) if unit is None else _costs(system, group.class_name, unit)
        usable = np.where(allowed_edges(system, group.capabilities & needed), durations, 0)
        swarm = bounds.get(group.class_name)
        carries = group.carries if carrying else ()
        alike = (group.capabilities & known, carries, usable.tobytes(), costs.tobytes())
        key = alike if swarm is None else group.class_name
        start = starts_of(group, arrays)
        if key in classes:
            classes[key] = classes[key].joined(start, index)
            continue
        chosen, windows = _windows(system, usable)
        graph = ClassGraph(
            capabilities=group.capabilities & known,
            start=start,
            tail=arrays.tail[chosen],
            head=arrays.head[chosen],
            duration=usable[chosen],
            cost=costs[chosen],
            risk=arrays.risk[chosen],
            group=arrays.group[chosen],
            carries=carries,
            entries=windows,
        )
        classes[key] = AgentClass(graph, (index,), swarm)
    ways = {pair: place for place, pair in enumerate(system.edges)}
    return tuple(
        replace(item, graph=_with_begun(item.graph, arrays, ways)) for item in classes.values()
    )


def _windows(system: TransitionSystem, usable: Ints) -> tuple[Ints, tuple[Ints, Ints] | None]:
    """The edges that a class can use, and when each may be entered, if places close for a time.

    An edge that may be entered in several spans of steps is there once for each of them.
    """
    chosen = np.flatnonzero(usable)
    if not system.timed:
        return chosen, None
    edges = list(system.edges.values())
    spans = [entries(system, edges[place], int(usable[place])) for place in chosen.tolist()]
    listed = [span for each in spans for span in each]
    first, last = np.array(listed, dtype=np.int64).reshape(-1, 2).T
    return np.repeat(chosen, [len(each) for each in spans]), (first, last)


def _with_begun(
    graph: ClassGraph, arrays: MapArrays, ways: Mapping[tuple[str, str], int]
) -> ClassGraph:
    """The graph with an edge for every start under way of its agents, entered at step 0.

    The moves are paid for already. They use what room the edge has, if there is one still.
    """
    more = begun_edges(graph.start, arrays, ways)
    if not len(more["tail"]):
        return graph
    joined: dict[str, Any] = {
        name: np.concatenate([getattr(graph, name), more[name]]) for name in more
    }
    if graph.entries is not None:
        at_once = np.zeros(len(more["tail"]), dtype=np.int64)
        joined["entries"] = tuple(np.concatenate([each, at_once]) for each in graph.entries)
    return replace(graph, coming=more["tail"], **joined)


def begun_edges(
    start: Ints, arrays: MapArrays, ways: Mapping[tuple[str, str], int]
) -> dict[str, Any]:
    """An edge for every start under way of a class: the arrays that a graph has of edges."""
    mine = [place for place in arrays.begun.tolist() if start[place]]
    starts = [arrays.coming[place - int(arrays.begun[0])] for place in mine]
    edges = [ways.get((start.origin, start.target), -1) for start in starts]
    free = np.zeros(len(mine))
    return {
        "tail": np.array(mine, dtype=np.int64),
        "head": np.array([arrays.number[start.target] for start in starts], dtype=np.int64),
        "duration": np.array([start.arrives for start in starts], dtype=np.int64),
        "cost": free,
        "risk": free,
        "group": np.array([arrays.group[edge] if edge >= 0 else -1 for edge in edges], np.int64),
    }


def starts_of(group: Group, arrays: MapArrays) -> Ints:
    """How many agents of a group start at each state, and at the places of those under way."""
    start = np.zeros(len(arrays.names), dtype=np.int64)
    for state, count in group.starts:
        start[arrays.number[state]] += count
    for way, count in group.coming:
        start[arrays.number[way.place]] += count
    return start


def action_classes(
    system: TransitionSystem, team: Sequence[Group], named: Iterable[str], *, apart: bool
) -> tuple[AgentClass, ...]:
    """The classes of a team on a map of uncertain actions, whose edges are the actions."""
    arrays = map_arrays(system)
    known, needed = frozenset(named), _needed(system)
    classes: dict[object, AgentClass] = {}
    for index, group in enumerate(team):
        start = starts_of(group, arrays)
        able = group.capabilities & (known | needed)
        key = able, group.class_name if apart else None
        if key in classes:
            old = classes[key]
            graph = replace(old.graph, start=old.graph.start + start)
            classes[key] = replace(old, graph=graph, groups=(*old.groups, index))
        else:
            graph = _action_graph(system, group.capabilities, start)
            graph = replace(graph, capabilities=group.capabilities & known)
            classes[key] = AgentClass(graph, (index,))
    return tuple(classes.values())


def usable_actions(system: TransitionSystem, capabilities: frozenset[str]) -> tuple[Action, ...]:
    """The actions that lead agents with these capabilities nowhere that they may not be."""
    closed = {s.name for s in system.states.values() if s.needs and not s.needs <= capabilities}
    return tuple(
        action
        for action in system.actions.values()
        if action.state not in closed and closed.isdisjoint(state for state, _ in action.possible)
    )


def _action_graph(
    system: TransitionSystem, capabilities: frozenset[str], start: Ints
) -> ClassGraph:
    """The graph of the actions that agents may take, and the edges that end it."""
    number, unit = map_arrays(system).number, float(system.cost_unit)
    actions = usable_actions(system, capabilities)
    states = np.arange(len(number))
    drawn = [
        (edge, number[state], chance)
        for edge, action in enumerate(actions)
        for state, chance in action.possible
    ]
    edge, head, chance = zip(*drawn, strict=True) if drawn else ((), (), ())
    none = np.zeros(len(states))
    size = len(actions) + len(states)
    ends = [(number[action.state], number[action.aim]) for action in actions]
    tail, aim = zip(*ends, strict=True) if ends else ((), ())
    return ClassGraph(
        capabilities=capabilities,
        start=start,
        tail=np.concatenate([np.array(tail, dtype=np.int64), states]),
        head=np.concatenate([np.array(aim, dtype=np.int64), states]),
        duration=np.array([*(a.duration for a in actions), *np.ones_like(states)], dtype=np.int64),
        cost=np.concatenate([[action.price / unit for action in actions], none]),
        risk=np.zeros(size),
        group=np.full(size, -1, dtype=np.int64),
        outcomes=Outcomes(
            np.array(edge, dtype=np.int64),
            np.array(head, dtype=np.int64),
            np.array(chance, dtype=np.float64),
            np.arange(size) >= len(actions),
        ),
    )


def _needed(system: TransitionSystem) -> frozenset[str]:
    """Every capability that some state or edge asks for."""
    edges = (edge.needs for edge in system.edges.values() if edge.needs)
    states = (state.needs for state in system.states.values() if state.needs)
    return frozenset().union(*edges, *states)
