"""Room for who is there: what has happened is a fact, whatever capacities say."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tsplan.mission import Group
    from tsplan.ts import Edge, State, TransitionSystem


def with_present_room(system: TransitionSystem, team: Iterable[Group]) -> TransitionSystem:
    """The map in which states, edges and zones hold at least those that start there.

    The same map where they do.
    """
    team = tuple(team)
    at: Counter[str] = Counter()
    on: Counter[tuple[str, str]] = Counter()
    for group in team:
        for state, count in group.starts:
            at[state] += count
        for way, count in group.coming:
            if group.configuration is None or way.origin != way.target:  # else it is rebuilt
                on[way.origin, way.target] += count
    inside = Counter({name: _inside(system, name, at, on) for name in system.zones})
    states = tuple(_state(state, at[state.name]) for state in system.states.values())
    edges = tuple(_edges(system, on))
    zones = {name: max(most, inside[name]) for name, most in system.zones.items()}
    if (states, edges, zones) == (
        tuple(system.states.values()),
        tuple(system.edges.values()),
        dict(system.zones),
    ):
        return system
    return replace(system, zones=zones).rebuilt(states, edges)


def _state(state: State, there: int) -> State:
    full = state.capacity is not None and state.capacity < there
    return replace(state, capacity=there) if full else state


def _edges(system: TransitionSystem, on: Counter[tuple[str, str]]) -> Iterator[Edge]:
    for pair, edge in system.edges.items():
        there = on[pair] + (on[pair[::-1]] if edge.both_ways and not edge.is_wait else 0)
        full = edge.capacity is not None and edge.capacity < there
        yield replace(edge, capacity=there) if full else edge


def _inside(
    system: TransitionSystem, name: str, at: Counter[str], on: Counter[tuple[str, str]]
) -> int:
    """How many are in a zone."""
    states, edges = system.zone_parts[name]
    return sum(at[state] for state in states) + sum(on[pair] for pair in edges)
