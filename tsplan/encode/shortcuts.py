"""Quickest ways between the states that matter, those left out that pass through another of them.

A shortcut from one kept state to another goes through states that are not relevant. It is left out
where passing through a *free* kept state between them is as quick: stopping there for no time is
always allowed and changes nothing.

Both are found at once, by searching backwards from each relevant state. Durations are multiplied by
a number greater than there are free states, and leaving a free state costs one less: of ways that
take equally long the one through free states is found, and the remainder of its length tells.
Beyond the free states around its goal a search finds nothing else, so it is stopped there: searches
from many goals look at their surroundings only. For fewer goals compiled code is faster though it
looks at the whole map.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from heapq import heappop, heappush
from typing import TypeAlias

import numpy as np

from tsplan.clock import Clock
from tsplan.encode.class_graph import ClassGraph
from tsplan.milp.model import Bools, Ints
from tsplan.ts.reachability import Lengths, quickest

_CROWDED = 40  # states for each goal below which searches nearby are faster than compiled code

Found: TypeAlias = tuple[int, list[int]]
"""A kept state, and the edges of the way from there to a goal."""


@dataclass(frozen=True, eq=False)
class Kept:
    """The kept states (`sources`); ways may not pass `relevant` ones, `free` may be stopped at.

    Edges that are `single` stay as they are, and are parts of no way.
    """

    sources: Ints
    relevant: Bools
    free: Bools
    single: Bools


@dataclass(frozen=True, eq=False)
class _Moves:
    """The moves of a graph, the quickest of parallel ones; `weight` is the scaled duration."""

    tail: Ints
    head: Ints
    edge: Ints
    weight: Ints
    scale: int
    longest: float


def shortcuts(
    graph: ClassGraph, kept: Kept, longest: float, clock: Clock
) -> tuple[Ints, Ints, list[Ints]]:
    """Tails, heads and ways (edges in order) of all shortcuts that take at most `longest` steps.

    Raises Halted when the clock is over.
    """
    moves = _moves(graph, kept, longest)
    goals = np.flatnonzero(kept.relevant)
    crowded = len(goals) * _CROWDED > len(kept.relevant)
    searches = _nearby if crowded else _on_the_whole_map
    tails: list[int] = []
    heads: list[int] = []
    paths: list[Ints] = []
    for goal, found in searches(moves, kept, goals):
        clock.check()
        for source, path in sorted(found):
            tails.append(source)
            heads.append(goal)
            paths.append(np.array(path, dtype=np.int64))
    order = np.lexsort((heads, tails))
    tail, head = np.array(tails, dtype=np.int64), np.array(heads, dtype=np.int64)
    return tail[order], head[order], [paths[place] for place in order.tolist()]


def _moves(graph: ClassGraph, kept: Kept, longest: float) -> _Moves:
    move = np.flatnonzero(~graph.wait & ~kept.single & ~graph.begun)
    edge = move[quickest(graph.tail[move], graph.head[move], graph.duration[move])]
    scale = int(kept.free.sum()) + 2
    return _Moves(
        graph.tail[edge], graph.head[edge], edge, graph.duration[edge] * scale, scale, longest
    )


def _on_the_whole_map(moves: _Moves, kept: Kept, goals: Ints) -> Iterator[tuple[int, list[Found]]]:
    """Each goal gets a copy of itself that only has the moves into it; no way leaves the others."""
    count = len(kept.relevant)
    copy = np.full(count, -1)
    copy[goals] = count + np.arange(len(goals))
    through = ~kept.relevant[moves.head] | kept.free[moves.head]
    into = copy[moves.head] >= 0
    rows = np.concatenate([moves.head[through], copy[moves.head[into]]])
    columns = np.concatenate([moves.tail[through], moves.tail[into]])
    weights = np.concatenate(
        [moves.weight[through] - kept.free[moves.head[through]], moves.weight[into]]
    )
    lengths = Lengths(count + len(goals), rows, columns, weights)
    key = moves.tail * count + moves.head
    for number, goal in enumerate(goals.tolist()):
        distance, after = lengths.ways(count + number, limit=moves.longest * moves.scale)
        length = distance[kept.sources]
        length[np.isinf(length)] = 0.5  # no whole number: there is no way
        direct = (length % moves.scale == 0) & (kept.sources != goal)
        found = []
        for source in kept.sources[direct].tolist():
            way = [source]
            while way[-1] < count:
                way.append(int(after[way[-1]]))
            way[-1] = goal
            states = np.array(way)
            edges = moves.edge[np.searchsorted(key, states[:-1] * count + states[1:])]
            found.append((source, edges.tolist()))
        yield goal, found


def _nearby(moves: _Moves, kept: Kept, goals: Ints) -> Iterator[tuple[int, list[Found]]]:
    """Searches that stop where every way goes through a free state."""
    into: list[list[tuple[int, int, int]]] = [[] for _ in range(len(kept.relevant))]
    columns = moves.tail.tolist(), moves.weight.tolist(), moves.edge.tolist()
    for head, *move in zip(moves.head.tolist(), *columns, strict=True):
        into[head].append((move[0], move[1], move[2]))
    closed = (kept.relevant & ~kept.free).tolist()
    less = kept.free.astype(np.int64).tolist()
    asked = np.zeros(len(kept.relevant), dtype=np.bool_)
    asked[kept.sources] = True
    wanted = asked.tolist()
    scale, limit = moves.scale, moves.longest * moves.scale
    for goal in goals.tolist():
        length = {goal: 0}
        after: dict[int, tuple[int, int]] = {}
        reached: list[int] = []
        heap = [(0, goal)]
        direct = 1  # entries in the heap of ways through no free state
        while direct:
            far, state = heappop(heap)
            direct -= far % scale == 0
            if far > length[state]:
                continue
            if far % scale == 0 and wanted[state] and state != goal:
                reached.append(state)
            if state != goal:
                if closed[state]:
                    continue
                far -= less[state]
            for tail, weight, edge in into[state]:
                further = far + weight
                if further <= limit and further < length.get(tail, limit + 1):
                    length[tail] = further
                    after[tail] = (state, edge)
                    heappush(heap, (further, tail))
                    direct += further % scale == 0
        yield goal, [(source, _way(after, source, goal)) for source in reached]


def _way(after: dict[int, tuple[int, int]], state: int, goal: int) -> list[int]:
    path = []
    while state != goal:
        state, edge = after[state]
        path.append(edge)
    return path
