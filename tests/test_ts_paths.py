"""Reachability and shortest durations."""

import math

import networkx as nx
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.seeds import quick
from tsplan.ts import Edge, State, TransitionSystem
from tsplan.ts.builders import grid
from tsplan.ts.reachability import reachable, shortest_durations

STATES = [State("a"), State("b"), State("c", needs={"fly"}), State("d")]
EDGES = [
    Edge("a", "b", {"slow": 5, "fast": 2}),
    Edge("b", "c", 1),
    Edge("c", "d", 1),
    Edge("a", "d", 9, needs={"swim"}),
    Edge("b", "b", 3),
]
TOWN = TransitionSystem.build(STATES, EDGES)


def test_reachable():
    assert reachable(TOWN, "b") == ("b", "c", "d")
    assert reachable(TOWN, ["d", "b"]) == ("b", "c", "d")
    assert reachable(TOWN, "a", capabilities=()) == ("a", "b")
    assert reachable(TOWN, "a", capabilities={"swim"}) == ("a", "b", "d")
    assert reachable(TOWN, "a", "crawler", {"swim"}) == ("a", "d")
    assert reachable(TOWN, []) == ()
    with pytest.raises(KeyError):
        reachable(TOWN, "x")


def test_shortest_durations():
    inf = math.inf
    assert shortest_durations(TOWN, ["a"]).tolist() == [[0, 2, 3, 4]]
    assert shortest_durations(TOWN, ["a"], class_name="slow").tolist() == [[0, 5, 6, 7]]
    assert shortest_durations(TOWN, ["a"], class_name="x").tolist() == [[0, inf, inf, 9]]
    assert shortest_durations(TOWN, capabilities=[]).tolist()[1] == [inf, 0, inf, inf]
    assert shortest_durations(TOWN).shape == (4, 4)


@quick
@given(st.integers(1, 5), st.integers(1, 5), st.integers(0, 1000))
def test_shortest_durations_agree_with_networkx(rows, columns, seed):
    system = grid(rows, columns, duration=(1, 4), seed=seed)
    number = {name: index for index, name in enumerate(system.states)}
    expected = np.full((len(number), len(number)), np.inf)
    for source, lengths in nx.all_pairs_dijkstra_path_length(system.graph):
        for target, length in lengths.items():
            expected[number[source], number[target]] = length
    assert np.array_equal(shortest_durations(system), expected)
