"""The map as it is at each step, after what has been closed, opened and made narrower."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, TypeAlias

from tsplan.errors import Finding, MapError, PlanError, nearest
from tsplan.plans.worlds import OnEdge, World
from tsplan.ts import Edge, State, TransitionSystem
from tsplan.ts.edges import ByClass, Pair

if TYPE_CHECKING:
    from collections.abc import Iterator

    from tsplan.plans.worlds import Place


Pace: TypeAlias = Callable[[Edge], "int | None"]
"""How many steps somebody needs for an edge; None if it cannot take it."""


@dataclass(frozen=True)
class Maps:
    """A map and the worlds that have changed it, in the order of their steps."""

    system: TransitionSystem
    worlds: tuple[World, ...] = ()

    @cached_property
    def _made(self) -> tuple[tuple[int, TransitionSystem], ...]:
        made = [(0, self.system)]
        for world in self.worlds:
            made.append((world.step, changed(made[-1][1], world)))
        return tuple(made)

    def at(self, step: int) -> TransitionSystem:
        """The map for who sets out at a step; what is closed for a time is open in it."""
        return next(system for first, system in reversed(self._made) if first <= step)

    @property
    def edges(self) -> frozenset[tuple[str, str]]:
        """All edges that there have been."""
        return frozenset(pair for _, system in self._made for pair in system.edges)

    def ride(self, who: str, pace: Pace, ends: tuple[str, str], step: int) -> OnEdge:
        """How somebody who enters an edge at a step is under way on it, by how long edges take.

        Raises PlanError where the map has no such edge for it.
        """
        edge = self.at(step).edges.get(ends)
        duration = None if edge is None else pace(edge)
        if duration is None:
            what = f"{who} goes from {ends[0]} to {ends[1]} at step {step}"
            remedy = "say where it is, with 'moved'"
            raise PlanError([Finding(f"{what}, and the map has no such edge for it", remedy)])
        return OnEdge(*ends, step + duration)

    def known_state(self, name: str, who: str) -> None:
        """Raise PlanError for a state that the map does not have."""
        if name not in self.system.states:
            what = f"{who} is said to be at '{name}', which the map does not have"
            raise PlanError([Finding(what, nearest(name, self.system.states))])

    def from_step(self, step: int) -> TransitionSystem:
        """The map from a step on, which is its step 0, with what is closed for a time."""
        system = self.at(step).later(-step)
        edges = dict(system.edges)
        for ends, until in self._shut(step):
            if ends in edges:
                spans = (*edges[ends].closed, (0, until - step))
                edges[ends] = replace(edges[ends], closed=spans)
        if edges == dict(system.edges):
            return system
        return _rebuilt(system, system.states, edges)

    def _shut(self, step: int) -> Iterator[tuple[tuple[str, str], int]]:
        """The edges that are closed for a time at a step, and the last step of that."""
        for world in self.worlds:
            for closed in world.closed:
                if closed.until is not None and closed.until >= step:
                    for ends in _entered(self.at(step), closed.place):
                        yield ends, closed.until


def changed(system: TransitionSystem, world: World) -> TransitionSystem:
    """The map as a world leaves it, but for what is closed for a time only.

    Raises PlanError for states and edges that are not there, and what no map can be.
    """
    if not (world.opened or world.closed or world.capacities):
        return system
    findings = [*_unknown(system, world)]
    if findings:
        raise PlanError(findings)
    edges, states = _passable(system, world), dict(system.states)
    for room in world.capacities:
        if isinstance(room.place, str):
            states[room.place] = replace(states[room.place], capacity=room.capacity)
        elif room.place in edges:
            edges[room.place] = replace(edges[room.place], capacity=room.capacity)
    return _rebuilt(system, states, edges)


def _rebuilt(
    system: TransitionSystem, states: Mapping[str, State], edges: Mapping[Pair, Edge]
) -> TransitionSystem:
    """The map with other states and edges; PlanError for what no map can be.

    The directions of an edge that are not alike any more share their capacity as a zone.
    """
    made, zones = dict(edges), dict(system.zones)
    for pair, edge in edges.items():
        back = edges.get(pair[::-1])
        if not edge.both_ways or back == edge.reverse():
            continue
        made[pair] = replace(edge, both_ways=False)
        if edge.capacity is not None and back is not None:
            zone = " and ".join(sorted(pair))
            zones[zone] = min(edge.capacity, back.capacity or edge.capacity)
            made[pair] = replace(made[pair], zone=zone, capacity=None)
    try:
        return replace(system, zones=zones).rebuilt(states.values(), made.values())
    except MapError as error:
        raise PlanError(error.findings) from None


def _passable(system: TransitionSystem, world: World) -> dict[Pair, Edge]:
    """The edges that there are, with their durations."""
    edges = dict(system.edges)
    for new in world.opened:
        old = edges.get((new.source, new.target), Edge(new.source, new.target))
        duration = ByClass(new.duration) if isinstance(new.duration, Mapping) else new.duration
        edges[old.pair] = replace(old, duration=duration)
    for closed in world.closed:
        if closed.until is None:
            for ends in _entered(system, closed.place):
                edges.pop(ends, None)
    return edges


def _entered(system: TransitionSystem, place: Place) -> list[tuple[str, str]]:
    """The edges by which a place is entered: an edge itself, or those that lead to a state."""
    if not isinstance(place, str):
        return [place]
    return [edge.pair for edge in system.edges.values() if edge.target == place != edge.source]


def _unknown(system: TransitionSystem, world: World) -> Iterator[Finding]:
    """States and edges that the map does not have."""
    new = {(each.source, each.target) for each in world.opened}
    for ends in new:
        yield from _strange(system, ends, "is opened")
    places: Sequence[tuple[Place, str]] = [
        *((closed.place, "is closed") for closed in world.closed),
        *((room.place, "has another capacity") for room in world.capacities),
    ]
    for place, what in places:
        if isinstance(place, str):
            yield from _strange(system, (place,), what)
        elif place not in system.edges and place not in new:
            words = f"an edge from {place[0]} to {place[1]} {what}, and the map has none"
            yield Finding(words, "name the states in the order in which the edge leads")


def _strange(system: TransitionSystem, names: Sequence[str], what: str) -> Iterator[Finding]:
    for name in names:
        if name not in system.states:
            words = f"'{name}' {what}, and the map has no such state"
            yield Finding(words, nearest(name, system.states))
