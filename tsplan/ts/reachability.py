"""What agents can reach on a map, and how fast."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence
from typing import TypeAlias

import numpy as np
import numpy.typing as npt
from scipy import sparse
from scipy.sparse import csgraph

from tsplan.ts.edges import Edge
from tsplan.ts.system import TransitionSystem

Floats: TypeAlias = npt.NDArray[np.float64]


def usable(
    system: TransitionSystem,
    class_name: str | None = None,
    capabilities: Collection[str] | None = None,
) -> Iterator[tuple[Edge, int]]:
    """The edges that an agent may use, each with its duration.

    Parameters
    ----------
    system
        The map.
    class_name
        The agent's class. Without it, an edge takes as long as for its quickest class.
    capabilities
        What the agent is capable of. Without it, no edge or state is closed for lack of any.

    """
    able = None if capabilities is None else frozenset(capabilities)
    closed = {
        name
        for name, state in system.states.items()
        if able is not None and not state.needs <= able
    }
    for edge in system.edges.values():
        if able is not None and not edge.needs <= able:
            continue
        if edge.source in closed or edge.target in closed:
            continue
        duration = edge.shortest() if class_name is None else edge.duration_for(class_name)
        if duration is not None:
            yield edge, duration


def reachable(
    system: TransitionSystem,
    starts: str | Iterable[str],
    class_name: str | None = None,
    capabilities: Collection[str] | None = None,
) -> tuple[str, ...]:
    """The states that an agent at one of `starts` can ever be at, in the order of the map.

    Capacities and other agents are not looked at. See `usable` for the last two arguments.

    Raises
    ------
    KeyError
        A start is not a state of the map.

    """
    todo = [starts] if isinstance(starts, str) else list(starts)
    for name in todo:
        system.states[name]
    following: dict[str, list[str]] = {}
    for edge, _ in usable(system, class_name, capabilities):
        following.setdefault(edge.source, []).append(edge.target)
    found = set(todo)
    while todo:
        for target in following.get(todo.pop(), ()):
            if target not in found:
                found.add(target)
                todo.append(target)
    return tuple(name for name in system.states if name in found)


def shortest_durations(
    system: TransitionSystem,
    starts: Sequence[str] | None = None,
    *,
    class_name: str | None = None,
    capabilities: Collection[str] | None = None,
) -> Floats:
    """Fewest steps from each start to every state, by Dijkstra's algorithm (scipy).

    Returns an array of shape (starts, states), both in their order, infinite where there is no
    way. Without `starts`, every state is one. See `usable` for the other arguments.

    >>> from tsplan.ts.builders import grid
    >>> shortest_durations(grid(1, 3), ["r0c0"])
    array([[0., 1., 2.]])
    """
    number = {name: index for index, name in enumerate(system.states)}
    chosen = [(e, w) for e, w in usable(system, class_name, capabilities) if not e.is_wait]
    tails = [number[edge.source] for edge, _ in chosen]
    heads = [number[edge.target] for edge, _ in chosen]
    durations = np.array([duration for _, duration in chosen], dtype=np.float64)
    size = len(number)
    graph = sparse.csr_array((durations, (tails, heads)), shape=(size, size))
    rows = None if starts is None else np.array([number[name] for name in starts], dtype=np.intp)
    return np.asarray(csgraph.dijkstra(graph, indices=rows), dtype=np.float64)
