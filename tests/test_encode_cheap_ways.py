"""Ways that are quick or cheap, against all ways there are."""

from __future__ import annotations

from itertools import pairwise
from random import Random

import numpy as np
import pytest

import tsplan
from tsplan import Mission
from tsplan.clock import Clock
from tsplan.encode.cheap_ways import cheap_ways
from tsplan.encode.class_graph import ClassGraph
from tsplan.encode.shortcuts import Kept
from tsplan.ts import Edge, State, TransitionSystem

STATES = 6


def random_graph(random: Random) -> tuple[ClassGraph, Kept]:
    edges = [(state, state, 1, 0) for state in range(STATES)]
    edges += [
        (tail, head, random.randint(1, 4), random.randint(0, 5))
        for tail in range(STATES)
        for head in range(STATES)
        if tail != head and random.random() < 0.5
    ]
    tail, head, duration, cost = (np.array(part) for part in zip(*edges, strict=True))
    none = np.zeros(len(edges))
    start = np.eye(1, STATES, dtype=np.int64)[0]
    group = np.full(len(edges), -1)
    made = ClassGraph(frozenset(), start, tail, head, duration, cost.astype(float), none, group)
    relevant = np.array([random.random() < 0.4 for _ in range(STATES)])
    return made, Kept(np.flatnonzero(relevant | (start > 0)), relevant, relevant, group >= 0)


def all_ways(graph: ClassGraph, kept: Kept, goal: int, source: int) -> set[tuple[int, float]]:
    """What all ways through states that do not matter take and cost, the best of them."""
    found = set()

    def go(state: int, steps: int, price: float, seen: frozenset[int]) -> None:
        for edge in np.flatnonzero((graph.tail == state) & ~graph.wait).tolist():
            head = int(graph.head[edge])
            now = steps + int(graph.duration[edge]), price + float(graph.cost[edge])
            if head == goal:
                found.add(now)
            elif head not in seen and not kept.relevant[head]:
                go(head, *now, seen | {head})

    go(source, 0, 0.0, frozenset({source}))
    better = {
        one
        for one in found
        for two in found
        if two != one and two[0] <= one[0] and two[1] <= one[1]
    }
    return found - better


@pytest.mark.parametrize("seed", range(40))
def test_ways_are_those_that_no_other_is_as_good_as(seed: int) -> None:
    graph, kept = random_graph(Random(seed))
    tails, heads, ways = cheap_ways(graph, kept, graph.cost, np.inf, Clock())
    found = {}
    for tail, head, way in zip(tails.tolist(), heads.tolist(), ways, strict=True):
        ends = list(zip(graph.tail[way].tolist(), graph.head[way].tolist(), strict=True))
        assert ends[0][0] == tail
        assert ends[-1][1] == head
        assert all(one[1] == two[0] for one, two in pairwise(ends))
        value = int(graph.duration[way].sum()), float(graph.cost[way].sum())
        assert value not in found.setdefault((tail, head), set())
        found[tail, head].add(value)
    expected = {
        (source, goal): ways
        for goal in np.flatnonzero(kept.relevant).tolist()
        for source in kept.sources.tolist()
        if source != goal and (ways := all_ways(graph, kept, goal, source))
    }
    assert found == expected


def test_a_slow_way_is_taken_where_it_is_cheap_and_there_is_time() -> None:
    system = TransitionSystem.build(
        [State("dock"), State("toll"), State("lane"), State("gate", frozenset({"gate"}))],
        [
            *(Edge(name, name) for name in ("dock", "toll", "lane", "gate")),
            Edge("dock", "toll", 1, cost=5),
            Edge("toll", "gate", 1, cost=5),
            Edge("dock", "lane", 2, cost=1),
            Edge("lane", "gate", 2, cost=1),
        ],
    )

    def cost(last: int) -> float | None:
        made = Mission.of(
            map=system,
            team=[{"class": "cart", "at": "dock", "capabilities": ["carry"]}],
            formula=f"F[0,{last}] T(0, gate, {{(carry, 1)}})",
            objective=["cost"],
        )
        plan = tsplan.plan(made)
        assert plan.size.columns < 30  # neither lane nor toll is a node
        return plan.objective[0].value

    assert [cost(3), cost(4)] == [10, 2]
