"""Ways between the states that matter that are quick or cheap: none is both slower and dearer.

Where an objective pays for moves otherwise than by the step, a quickest way may cost more than a
slower one. All ways are kept of which no other is as quick and as cheap, found by searching
backwards from each relevant state in the order of time; a way that comes to a state later counts
only where it is cheaper than all before.

Source: P. Hansen, "Bicriterion path problems", in Multiple Criteria Decision Making Theory and
Application, Springer 1980.
"""

from __future__ import annotations

from heapq import heappop, heappush
from typing import NamedTuple

import numpy as np

from tsplan.clock import Clock
from tsplan.encode.class_graph import ClassGraph
from tsplan.encode.shortcuts import Kept
from tsplan.milp.model import Floats, Ints

_MANY = 30  # ways looked at for each edge from which on the whole map is as good


class _Label(NamedTuple):
    """A way to the goal: what it takes and costs, where it begins, its first edge, and the rest."""

    steps: int
    price: float
    state: int
    edge: int
    rest: int


def cheap_ways(
    graph: ClassGraph, kept: Kept, toll: Floats, longest: float, clock: Clock
) -> tuple[Ints, Ints, list[Ints]] | None:
    """Tails, heads and ways (edges in order) of at most `longest` steps, or None for too many.

    `toll` is what each edge costs. Raises Halted when the clock is over.
    """
    moves = np.flatnonzero(~graph.wait & ~kept.single & ~graph.begun)
    into: list[list[tuple[int, int, float, int]]] = [[] for _ in kept.relevant]
    ends = graph.tail[moves], graph.duration[moves], toll[moves], moves, graph.head[moves]
    for tail, steps, price, edge, head in zip(*(part.tolist() for part in ends), strict=True):
        into[head].append((tail, steps, price, edge))
    wanted = np.zeros(len(kept.relevant), dtype=np.bool_)
    wanted[kept.sources] = True
    found: list[tuple[int, int, Ints]] = []
    for goal in np.flatnonzero(kept.relevant).tolist():
        clock.check()
        labels = _labels(goal, into, kept.relevant.tolist(), longest, _MANY * len(graph.tail))
        if labels is None:
            return None
        found += (
            (label.state, goal, _way(labels, label))
            for label in labels
            if wanted[label.state] and label.state != goal
        )
    found.sort(key=lambda way: way[:2])
    tails, heads = ([way[end] for way in found] for end in (0, 1))
    return (
        np.array(tails, dtype=np.int64),
        np.array(heads, dtype=np.int64),
        [way for _, _, way in found],
    )


def _labels(
    goal: int,
    into: list[list[tuple[int, int, float, int]]],
    closed: list[bool],
    longest: float,
    most: int,
) -> list[_Label] | None:
    """The ways to a goal that no other is as good as, in the order of time; None for too many."""
    labels: list[_Label] = []
    cheapest: dict[int, float] = {}
    heap = [_Label(0, 0.0, goal, -1, -1)]
    while heap:
        label = heappop(heap)
        if label.price >= cheapest.get(label.state, np.inf):
            continue
        cheapest[label.state] = label.price
        labels.append(label)
        if closed[label.state] and label.state != goal:  # ways begin there, and pass no such state
            continue
        for tail, steps, price, edge in into[label.state]:
            made = _Label(label.steps + steps, label.price + price, tail, edge, len(labels) - 1)
            if made.steps <= longest and tail != goal:
                heappush(heap, made)
        if len(heap) > most:
            return None
    return labels


def _way(labels: list[_Label], label: _Label) -> Ints:
    """The edges of a way."""
    edges = []
    while label.rest >= 0:
        edges.append(label.edge)
        label = labels[label.rest]
    return np.array(edges, dtype=np.int64)
