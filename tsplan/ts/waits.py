"""Waiting: an edge from a state to itself. Where there is none, agents have to move on at once."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from math import inf
from typing import TypeAlias

from tsplan.ts.edges import Edge
from tsplan.ts.system import TransitionSystem

Moves: TypeAlias = Iterable[tuple[Edge, int]]
"""Edges that agents may use, each with its duration."""


def without_wait(system: TransitionSystem) -> tuple[str, ...]:
    """The states at which nobody can wait, in the order of the map."""
    return tuple(name for name in system.states if (name, name) not in system.edges)


def with_waits(system: TransitionSystem, names: Iterable[str]) -> TransitionSystem:
    """The map with waits of one step at some states that have none."""
    edges = [*system.edges.values(), *(Edge(name, name) for name in names)]
    return system.rebuilt(system.states.values(), edges)


def longest_ways(moves: Moves) -> Mapping[str, tuple[float, str]]:
    """For every state that an edge leaves, how long an agent can move on from it, and to where.

    That is infinite for a state with a way into a circle (a wait is one); the state where the
    longest way ends is only told for others. States that are not listed are ends themselves.

    >>> from tsplan.ts import Edge
    >>> longest_ways([(Edge("p", "q"), 1), (Edge("q", "r"), 2), (Edge("q", "s"), 1)])["p"]
    (3, 'r')
    """
    import networkx as nx  # noqa: PLC0415 - slow to import

    leaving: dict[str, list[tuple[str, int]]] = {}
    for edge, duration in moves:
        leaving.setdefault(edge.source, []).append((edge.target, duration))
    graph = nx.DiGraph((source, target) for source in leaving for target, _ in leaving[source])
    longest: dict[str, tuple[float, str]] = {}
    for part in nx.strongly_connected_components(graph):  # what a part leads to comes before it
        for state in part:
            circle = len(part) > 1 or graph.has_edge(state, state)
            # all that a state outside circles leads to is known by now
            ways = leaving.get(state, ()) if not circle else ()
            ends = [(steps + longest[target][0], longest[target][1]) for target, steps in ways]
            longest[state] = (inf, "") if circle else max(ends, default=(0, state))
    return {state: longest[state] for state in leaving}
