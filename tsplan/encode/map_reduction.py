"""Map reduction: a class's graph between the states that matter, and the way back to real paths.

Kept are the *relevant* states (those at which the formula or an extra constraint counts agents of
this class, capacities) and the start states. An edge of the reduced graph is a quickest path of the
full graph through states that are not relevant. The idea and its conditions stand in the project's
encoding notes (docs/encoding.md):

* every kept state has a unit self-loop, so that waiting can be done at either end of a shortcut;
* moves are paid by their duration, or not at all; where they are paid otherwise, and waiting is
  free, all ways are kept of which no other is as quick and as cheap (`cheap_ways`);
* a relevant state with an upper bound on its count (*limited*) also keeps the states next to it:
  an agent that must leave it may wait just outside;
* edges that may not be entered at all steps stay as they are, with both their ends, and states
  where nobody can wait at some step are limited.

Where a condition fails, `reduce` answers None and the full graph is used.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from tsplan.clock import Clock
from tsplan.encode.cheap_ways import cheap_ways
from tsplan.encode.class_graph import ClassGraph
from tsplan.encode.detours import detours
from tsplan.encode.shortcuts import Kept, shortcuts
from tsplan.milp.model import Bools, Floats, Ints
from tsplan.ts.closures import FOREVER

_CROWDED = 2  # shortcuts for each edge of the full graph: fewer are worth their shorter ways


@dataclass(frozen=True, eq=False)
class Reduced:
    """A reduced graph; `paths[e]` are the full graph's edges that reduced edge e stands for."""

    graph: ClassGraph
    paths: tuple[Ints, ...]


@dataclass(frozen=True, eq=False)
class Interest:
    """Which states matter: `relevant` for any reason, `limited` because of an upper bound.

    `narrow` ones have a capacity; it matters only to ways with a detour of at most `slack`. Edges
    that are `watched` are counted by themselves; they leave limited states. `tolls` are what edges
    cost, each in a sense of its own, where quick ways may not be the best.
    """

    relevant: Bools
    limited: Bools
    narrow: Bools
    watched: Bools
    tolls: tuple[Floats, ...] = ()
    slack: float = np.inf

    def within_slack(self, graph: ClassGraph) -> Interest:
        """The states that matter, the narrow ones among them and those next to these."""
        relevant, limited = self.relevant.copy(), self.limited.copy()
        relevant[graph.head[graph.begun]] = True  # moves go on from where the begun ones end
        # agents that must leave a limited state may wait in those next to it
        relevant[graph.head[limited[graph.tail]]] = True
        bounded = (graph.group >= 0) | graph.timed
        narrow = self.narrow.copy()
        narrow[graph.tail[bounded & graph.wait]] = True  # who may not wait there waits next to it
        if narrow.any() or bounded.any():
            around = narrow.copy()
            around[graph.head[narrow[graph.tail]]] = True
            around[graph.tail[bounded]] = around[graph.head[bounded]] = True
            if np.isfinite(self.slack):
                around &= detours(graph, relevant | (graph.start > 0)) <= self.slack
            relevant |= around
            limited |= narrow & around
        return replace(self, relevant=relevant, limited=limited)


def whole(graph: ClassGraph) -> Reduced:
    """The full graph as its own reduction."""
    return Reduced(graph, tuple(np.arange(len(graph.tail)).reshape(-1, 1)))


def reduce(graph: ClassGraph, interest: Interest, horizon: int, clock: Clock) -> Reduced | None:
    """The reduced graph of one class, or None where reduction would not be exact.

    Where the states that matter lie around a hub there may be far more pairs of them than edges;
    then the full graph is its own reduction. The edges by which structures are rebuilt stay as they
    are. Raises Halted when the clock is over.
    """
    if graph.layer is None:
        return _reduced(graph, interest, horizon, clock)
    rides = graph.layer.rides
    nowhere = np.zeros(1, dtype=np.bool_)
    every = Interest(
        np.append(interest.relevant, nowhere),
        np.append(interest.limited, nowhere),
        np.append(interest.narrow, nowhere),
        interest.watched[:rides],
        tuple(toll[:rides] for toll in interest.tolls),
    )
    short = _reduced(graph.among(graph.rides), every, horizon, clock)
    if short is None:
        return None
    half = np.arange(rides, len(graph.tail))
    return Reduced(short.graph.with_edges_of(graph, half), (*short.paths, *half.reshape(-1, 1)))


def _reduced(graph: ClassGraph, interest: Interest, horizon: int, clock: Clock) -> Reduced | None:
    unit_wait = graph.still & (graph.duration == 1)
    waiting = np.zeros(len(graph.start), dtype=np.bool_)
    waiting[graph.tail[unit_wait]] = True
    waiting[graph.coming] = True  # nobody stays there
    interest = interest.within_slack(graph)
    relevant = interest.relevant
    sources = np.flatnonzero(relevant | (graph.start > 0))
    if not waiting[sources].all():
        return None
    # an agent may leave a limited state by a move that the horizon cuts short
    longest = np.inf if interest.limited.any() else float(horizon)
    single = (graph.group >= 0) | interest.watched | graph.timed
    kept = Kept(sources, relevant, relevant & ~interest.limited, single)
    if interest.tolls:
        (toll,) = interest.tolls
        if toll[graph.still].any():  # where agents wait matters
            return None
        found = cheap_ways(graph, kept, toll, longest, clock)
        if found is None:
            return whole(graph) if waiting.all() else None
        tail, head, paths = found
    else:
        tail, head, paths = shortcuts(graph, kept, longest, clock)
    if len(paths) > _CROWDED * len(graph.tail) and waiting.all():
        return whole(graph)
    return _assemble(graph, kept, (tail, head), paths)


def _joined_entries(graph: ClassGraph, own: Ints, ways: int) -> tuple[Ints, Ints] | None:
    """When edges of its own and shortcuts, which are always open, may be entered."""
    if graph.entries is None:
        return None
    first, last = graph.entries
    always = np.zeros(ways, dtype=np.int64)
    return np.concatenate([first[own], always]), np.concatenate([last[own], always + FOREVER])


def _assemble(
    graph: ClassGraph, kept: Kept, ends: tuple[Ints, Ints], paths: Sequence[Ints]
) -> Reduced:
    """Unit waits, edges that stay as they are, and shortcuts as one graph."""
    there = np.zeros(len(graph.start), dtype=np.bool_)
    there[kept.sources] = True
    inside = there[graph.tail] & there[graph.head]
    waits = graph.wait & (graph.duration == 1) & there[graph.tail]
    own = np.flatnonzero(waits | (kept.single & inside) | graph.begun)
    tail, head = ends
    duration = np.array([graph.duration[path].sum() for path in paths], dtype=np.int64)
    cost = np.array([graph.cost[path].sum() for path in paths], dtype=np.float64)
    risk = np.array([graph.risk[path].sum() for path in paths], dtype=np.float64)
    joined = ClassGraph(
        capabilities=graph.capabilities,
        start=graph.start,
        tail=np.concatenate([graph.tail[own], tail]),
        head=np.concatenate([graph.head[own], head]),
        duration=np.concatenate([graph.duration[own], duration]),
        cost=np.concatenate([graph.cost[own], cost]),
        risk=np.concatenate([graph.risk[own], risk]),
        group=np.concatenate([graph.group[own], np.full(len(tail), -1)]),
        carries=graph.carries,
        coming=graph.coming,
        entries=_joined_entries(graph, own, len(tail)),
    )
    every = (*own.reshape(-1, 1), *paths)
    if graph.modes is not None:
        joined = replace(joined, modes=graph.modes.along(every, graph.duration))
    return Reduced(joined, every)
