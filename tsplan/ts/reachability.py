"""What agents can reach on a map, and how fast."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence
from typing import TypeAlias

import numpy as np
import numpy.typing as npt
from scipy import sparse
from scipy.sparse import csgraph

from tsplan.ts.closures import Closed, closed_at, outside
from tsplan.ts.edges import Edge
from tsplan.ts.system import TransitionSystem

Floats: TypeAlias = npt.NDArray[np.float64]
Ints: TypeAlias = npt.NDArray[np.int64]


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
    number, lengths = _numbered(system, class_name, capabilities)
    sources = [number[name] for name in ([starts] if isinstance(starts, str) else starts)]
    if not sources:
        return ()
    distances = lengths.nearest(sources).tolist()
    return tuple(name for name, far in zip(system.states, distances, strict=True) if far < np.inf)


class Lengths:
    """Lengths of edges between numbered states, for Dijkstra's algorithm as scipy has it.

    >>> Lengths(3, np.array([0, 0, 1]), np.array([1, 1, 2]), np.array([7, 4, 1])).distances([0])
    array([[0., 4., 5.]])
    """

    def __init__(self, count: int, tail: Ints, head: Ints, length: Ints | Floats) -> None:
        edge = quickest(tail, head, length)  # a sparse matrix would add parallel ones up
        entries = length[edge].astype(np.float64), (tail[edge], head[edge])
        self._matrix = sparse.csr_array(entries, shape=(count, count))

    def distances(
        self, sources: Sequence[int] | Ints | None = None, *, limit: float = np.inf
    ) -> Floats:
        """The length of the shortest way from each source (or state) to every state.

        It is infinite where there is none of at most `limit`.
        """
        indices = None if sources is None else np.asarray(sources, dtype=np.intp)
        lengths = csgraph.dijkstra(self._matrix, indices=indices, limit=limit)
        return np.asarray(lengths, dtype=np.float64)

    def nearest(self, sources: Sequence[int] | Ints, *, limit: float = np.inf) -> Floats:
        """The length of the shortest way from any of the sources to every state."""
        indices = np.asarray(sources, dtype=np.intp)
        lengths = csgraph.dijkstra(self._matrix, indices=indices, min_only=True, limit=limit)
        return np.asarray(lengths, dtype=np.float64)

    def ways(self, source: int, *, limit: float = np.inf) -> tuple[Floats, npt.NDArray[np.int32]]:
        """As `distances` from one state, and which state comes last before each on such a way."""
        lengths, before = csgraph.dijkstra(
            self._matrix, indices=[source], limit=limit, return_predecessors=True
        )
        return lengths[0], before[0]


def quickest(tail: Ints, head: Ints, length: Ints | Floats) -> Ints:
    """The edges without those that others between the same states undercut, by tail and head."""
    order = np.lexsort((length, head, tail))
    tail, head = tail[order], head[order]
    first = np.ones(len(order), dtype=np.bool_)
    first[1:] = (tail[1:] != tail[:-1]) | (head[1:] != head[:-1])
    return order[first]


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
    number, lengths = _numbered(system, class_name, capabilities)
    return lengths.distances(None if starts is None else [number[name] for name in starts])


def entries(system: TransitionSystem, edge: Edge, duration: int) -> Closed:
    """The steps at which an edge may be entered that takes so long, as spans in order.

    From entering on until the step before it arrives an agent is on the edge, which must be open;
    and so must be the state that it leaves then, and the one where it arrives. An open end is
    `FOREVER`.
    """
    source, target = system.states[edge.source].closed, system.states[edge.target].closed
    barred = [(first - duration + 1, last) for first, last in edge.closed]
    barred += [*source, *((first - duration, last - duration) for first, last in target)]
    return outside(sorted(barred))


def first_arrivals(
    system: TransitionSystem,
    start: tuple[str, int, int],
    class_name: str,
    capabilities: frozenset[str],
) -> dict[str, float]:
    """When an agent can be at each state at the earliest; infinite if never up to the last step.

    `start` is the state where it is, at which step, and the last step. It waits only where and when
    it may.

    >>> from tsplan.ts import State
    >>> gate = Edge("in", "out", 1, closed=((1, 3),))
    >>> system = TransitionSystem.build([State("in"), State("out")], [Edge("in", "in"), gate])
    >>> first_arrivals(system, ("in", 1, 9), "cart", frozenset())
    {'in': 1.0, 'out': 5.0}
    """
    state, begin, horizon = start
    leaving: dict[str, list[tuple[str, int, Closed]]] = {}
    for edge, duration in usable(system, class_name, capabilities):
        spans_open = entries(system, edge, duration)
        leaving.setdefault(edge.source, []).append((edge.target, duration, spans_open))
    there: dict[int, set[str]] = {begin: {state}}
    first = dict.fromkeys(system.states, np.inf)
    for step in range(begin, horizon + 1):
        for here in there.pop(step, ()):
            first[here] = min(first[here], float(step))
            for target, duration, spans_open in leaving.get(here, ()):
                if closed_at(spans_open, step, step):
                    there.setdefault(step + duration, set()).add(target)
    return first


def _numbered(
    system: TransitionSystem, class_name: str | None, capabilities: Collection[str] | None
) -> tuple[dict[str, int], Lengths]:
    """The numbers of the states, and the durations between them of the moves that are usable."""
    number = {name: index for index, name in enumerate(system.states)}
    moves = [
        (number[edge.source], number[edge.target], duration)
        for edge, duration in usable(system, class_name, capabilities)
        if not edge.is_wait
    ]
    tail, head, duration = np.array(moves, dtype=np.int64).reshape(-1, 3).T
    return number, Lengths(len(number), tail, head, duration)
