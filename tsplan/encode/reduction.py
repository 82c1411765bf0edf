"""Map reduction: a class's graph between the states that matter, and the way back to real paths.

Kept are the *relevant* states (those at which the formula or an extra constraint counts agents of
this class, capacities) and the start states. An edge of the reduced graph is a quickest path of the
full graph through states that are not relevant. The idea and its conditions stand in the project's
encoding notes (docs/encoding.md):

* every kept state has a unit self-loop, so that waiting can be done at either end of a shortcut;
* moves are paid by their duration, or not at all;
* a relevant state with an upper bound on its count (*limited*) also keeps the states next to it:
  an agent that must leave it may wait just outside.

Where a condition fails, `reduce` answers None and the full graph is used.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from scipy import sparse
from scipy.sparse import csgraph

from tsplan.encode.network import ClassGraph
from tsplan.milp.model import Bools, Floats, Ints


@dataclass(frozen=True, eq=False)
class Reduced:
    """A reduced graph; `paths[e]` are the full graph's edges that reduced edge e stands for."""

    graph: ClassGraph
    paths: tuple[Ints, ...]


@dataclass(frozen=True, eq=False)
class Interest:
    """Which states matter: `relevant` for any reason, `limited` because of an upper bound."""

    relevant: Bools
    limited: Bools


def whole(graph: ClassGraph) -> Reduced:
    """The full graph as its own reduction."""
    return Reduced(graph, tuple(np.arange(len(graph.tail)).reshape(-1, 1)))


def reduce(graph: ClassGraph, interest: Interest, horizon: int) -> Reduced | None:
    """The reduced graph of one class, or None where reduction would not be exact."""
    unit_wait = graph.wait & (graph.duration == 1)
    waiting = np.zeros(len(graph.start), dtype=np.bool_)
    waiting[graph.tail[unit_wait]] = True
    relevant = _with_parking(graph, interest) | _ends_of_capacities(graph)
    sources = np.flatnonzero(relevant | (graph.start > 0))
    if not waiting[sources].all():
        return None
    # an agent may leave a limited state by a move that the horizon cuts short
    longest = np.inf if interest.limited.any() else float(horizon)
    distance, before = _quickest(graph, relevant, sources, longest)
    tail, head, duration = _shortcuts(distance, sources, relevant, relevant & ~interest.limited)
    shortcuts = _paths(graph, before, sources, tail, head)
    return _assemble(graph, sources, (sources[tail], head, duration), shortcuts)


def _with_parking(graph: ClassGraph, interest: Interest) -> Bools:
    """The relevant states and, for limited ones, the states that can be entered from them."""
    relevant = interest.relevant.copy()
    relevant[graph.head[interest.limited[graph.tail]]] = True
    return relevant


def _ends_of_capacities(graph: ClassGraph) -> Bools:
    ends = np.zeros(len(graph.start), dtype=np.bool_)
    bounded = graph.group >= 0
    ends[graph.tail[bounded]] = True
    ends[graph.head[bounded]] = True
    return ends


def _quickest(
    graph: ClassGraph, relevant: Bools, sources: Ints, longest: float
) -> tuple[Floats, npt.NDArray[np.int32]]:
    """Durations and predecessors from each source over paths with no relevant state inside.

    Each source gets a copy of itself that only has its outgoing edges; relevant states have none.
    """
    count = len(graph.start)
    move = ~graph.wait & (graph.group < 0)
    tail, head, weight = graph.tail[move], graph.head[move], graph.duration[move]
    copy = np.full(count, -1)
    copy[sources] = count + np.arange(len(sources))
    through = ~relevant[tail]
    leaving = copy[tail] >= 0
    rows = np.concatenate([tail[through], copy[tail[leaving]]])
    columns = np.concatenate([head[through], head[leaving]])
    weights = np.concatenate([weight[through], weight[leaving]]).astype(np.float64)
    size = count + len(sources)
    matrix = sparse.csr_array((weights, (rows, columns)), shape=(size, size))
    distance, before = csgraph.dijkstra(
        matrix,
        indices=count + np.arange(len(sources)),
        limit=longest,
        return_predecessors=True,
    )
    return distance, before


def _shortcuts(
    distance: Floats, sources: Ints, relevant: Bools, free: Bools
) -> tuple[Ints, Ints, Ints]:
    """Pairs (position of the source, target state) worth an edge, and their durations.

    A pair is left out where passing through a free state between them is as quick: stopping there
    for no time is always allowed and changes nothing.
    """
    kept = np.flatnonzero(relevant)
    direct = distance[:, kept]
    via = np.flatnonzero(free)
    position = np.full(len(relevant), -1)
    position[sources] = np.arange(len(sources))
    worth = np.isfinite(direct) & (kept[None, :] != sources[:, None])
    for middle in via:
        detour = distance[:, middle][:, None] + distance[position[middle], kept][None, :]
        apart = (sources[:, None] != middle) & (kept[None, :] != middle)
        worth &= ~(apart & (detour <= direct))
    tail, target = np.nonzero(worth)
    return tail, kept[target], direct[tail, target].astype(np.int64)


def _paths(
    graph: ClassGraph, before: npt.NDArray[np.int32], sources: Ints, tail: Ints, head: Ints
) -> list[Ints]:
    """The full graph's edges of every shortcut, in order."""
    count = len(graph.start)
    edge_of = {
        pair: edge
        for edge, pair in enumerate(zip(graph.tail.tolist(), graph.head.tolist(), strict=True))
    }
    paths = []
    for source, target in zip(tail.tolist(), head.tolist(), strict=True):
        edges = []
        state = target
        while state < count:
            previous = int(before[source, state])
            origin = previous if previous < count else int(sources[source])
            edges.append(edge_of[origin, state])
            state = previous
        paths.append(np.array(edges[::-1], dtype=np.int64))
    return paths


def _assemble(
    graph: ClassGraph, sources: Ints, moves: tuple[Ints, Ints, Ints], shortcuts: Sequence[Ints]
) -> Reduced:
    """Unit waits, edges with a capacity of their own, and shortcuts as one graph."""
    kept = np.zeros(len(graph.start), dtype=np.bool_)
    kept[sources] = True
    own = np.flatnonzero(
        (graph.wait & (graph.duration == 1) & kept[graph.tail]) | (graph.group >= 0)
    )
    tail, head, duration = moves
    cost = np.array([graph.cost[path].sum() for path in shortcuts], dtype=np.float64)
    joined = ClassGraph(
        capabilities=graph.capabilities,
        start=graph.start,
        tail=np.concatenate([graph.tail[own], tail]),
        head=np.concatenate([graph.head[own], head]),
        duration=np.concatenate([graph.duration[own], duration]),
        cost=np.concatenate([graph.cost[own], cost]),
        group=np.concatenate([graph.group[own], np.full(len(tail), -1)]),
    )
    return Reduced(joined, (*own.reshape(-1, 1), *shortcuts))
