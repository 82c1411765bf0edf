"""Maps built in Python."""

import networkx as nx
import numpy as np
import pytest

import tsplan
from tsplan.errors import MapError
from tsplan.ts import ByClass, Edge
from tsplan.ts.builders import cell_name, from_networkx, grid


def test_a_grid_connects_neighbours_and_waits():
    system = grid(2, 3, labels={(0, 0): "home", (1, 2): ("goal", "wet")})
    assert len(system.states) == 6
    assert len(system.edges) == 6 + 2 * 7
    assert system.labels == {"home": ("r0c0",), "goal": ("r1c2",), "wet": ("r1c2",)}
    assert system.states["r1c2"].at == (2.5, 1.5)
    assert system.states["r1c2"].shape == ((2, 1), (3, 1), (3, 2), (2, 2))
    assert ("r0c0", "r1c1") not in system.edges


def test_blocked_cells_are_left_out():
    system = grid(3, 3, blocked={(1, 1)})
    assert cell_name(1, 1) not in system.states
    assert all("r1c1" not in pair for pair in system.edges)
    with pytest.raises(MapError, match="no states"):
        grid(1, 1, blocked={(0, 0)})


def test_durations_of_a_grid():
    assert {e.duration for e in grid(3, 3, duration=4).edges.values() if not e.is_wait} == {4}
    with pytest.raises(MapError, match="duration: 0 is not"):
        grid(2, 2, duration=0)
    with pytest.raises(MapError, match="duration: 0 is not"):
        grid(9, 9, duration=(0, 1))
    drawn = grid(8, 8, duration=(1, 3), seed=5)
    assert {e.duration for e in drawn.edges.values()} == {1, 2, 3}
    assert drawn == grid(8, 8, duration=(1, 3), seed=5)
    assert drawn != grid(8, 8, duration=(1, 3), seed=6)
    assert any(e.duration != drawn.edges[e.target, e.source].duration for e in drawn.edges.values())
    assert all(e.duration == 1 for e in drawn.edges.values() if e.is_wait)


def test_a_grid_without_waits():
    assert not any(edge.is_wait for edge in grid(2, 2, waits=False).edges.values())


def test_from_a_directed_graph():
    graph = nx.DiGraph(name="town")
    graph.add_node(1, labels=["a", "b"], at=(0, 1), capacity=2)
    graph.add_edge(1, 2, duration=np.int64(3), cost=1.5)
    graph.add_edge(2, 1, duration=2.0, needs="fly")
    graph.add_edge(2, 2, duration={"heavy": 2.0})
    system = from_networkx(graph, waits=True)
    assert system.name == "town"
    assert system.states["1"].labels == {"a", "b"}
    assert system.states["1"].at == (0.0, 1.0)
    assert system.edges["1", "2"] == Edge("1", "2", 3, 1.5)
    assert system.edges["2", "1"] == Edge("2", "1", 2, needs=frozenset(("fly",)))
    assert system.edges["2", "2"].duration == ByClass({"heavy": 2})
    assert system.edges["1", "1"] == Edge("1", "1")


def test_from_an_undirected_graph_with_other_attribute_names():
    graph = nx.Graph()
    graph.add_node("x", prop="red", pos=(1, 2))
    graph.add_edge("x", "y", weight=2)
    graph.add_edge("y", "y", weight=1)
    system = from_networkx(graph, labels="prop", at="pos", duration="weight")
    assert system.labels == {"red": ("x",)}
    assert system.edges["x", "y"].both_ways
    assert system.edges["y", "x"].duration == 2
    assert not system.edges["y", "y"].both_ways


def test_graphs_that_are_no_maps():
    graph = nx.MultiDiGraph([("a", "b"), ("a", "b")])
    with pytest.raises(MapError, match="a second edge"):
        from_networkx(graph)
    with pytest.raises(MapError, match="slow is not"):
        from_networkx(nx.DiGraph([("a", "b", {"duration": "slow"})]))
    with pytest.raises(MapError, match="True is not"):
        from_networkx(nx.DiGraph([("a", "b", {"duration": True})]))


def test_numbers_of_graphs_may_be_texts_or_of_numpy():
    graph = nx.DiGraph()
    graph.add_node("a", at=("1", " 2.5 "), capacity="3")
    graph.add_node(
        "b", at=np.array([1, 2]), shape=[("0", "0"), (1, 0), (0, 1)], capacity=np.int8(2)
    )
    graph.add_edge("a", "b", weight="2", cost="1.5", capacity=np.int64(4))
    graph.add_edge("b", "a", weight={"heavy": "3", "default": np.float64(2)}, cost=np.int32(7))
    system = from_networkx(graph, duration="weight")
    assert system.states["a"].at == (1, 2.5)
    assert system.states["a"].capacity == 3
    assert system.states["b"].at == (1, 2)
    assert system.states["b"].shape == ((0, 0), (1, 0), (0, 1))
    assert system.edges["a", "b"] == Edge("a", "b", 2, 1.5, 4)
    assert system.edges["b", "a"] == Edge("b", "a", ByClass({"heavy": 3, "default": 2}), 7)


def test_what_is_wrong_about_a_graph_names_node_and_attribute():
    graph = nx.Graph()
    graph.add_node("a", labels=3, at=("1", "x"), color=7)
    graph.add_node("b", labels=["dock", 3], shape=5, capacity="many", needs={"fly": True})
    graph.add_edge("b", "a", weight="2.5", cost="free", needs=1)
    with pytest.raises(MapError) as caught:
        from_networkx(graph, duration="weight", labels="labels")
    said = [str(finding).split(";")[0] for finding in caught.value.findings]
    assert sorted(said) == [
        "edge from 'a' to 'b', attribute 'cost': cost: free is not a finite number of at least 0",
        "edge from 'a' to 'b', attribute 'needs': 1 is neither a text nor a collection of texts",
        "edge from 'a' to 'b', attribute 'weight': duration: 2.5 is not a whole number from 1 on",
        "node 'a', attribute 'at': at: (1, 'x') is not a pair of finite numbers",
        "node 'a', attribute 'color': 7 is not a text",
        "node 'a', attribute 'labels': 3 is neither a text nor a collection of texts",
        "node 'b', attribute 'capacity': capacity: many is not a whole number of at least 0",
        "node 'b', attribute 'labels': ['dock', 3] is neither a text nor a collection of texts",
        "node 'b', attribute 'needs': {'fly': True} is neither a text nor a collection of texts",
        "node 'b', attribute 'shape': shape: not 3 or more pairs of finite numbers",
    ]


def test_a_graph_and_back():
    system = grid(3, 3, duration=(1, 3))
    graph = nx.DiGraph(system.graph)
    again = from_networkx(graph, duration="weight", name="grid")
    assert again.edges == system.edges


@pytest.mark.long
def test_large_grids_are_built():
    assert len(grid(200, 200).states) == 40_000


def test_what_a_map_is_called_is_one_however_it_is_composed():
    made, read = "Caf\u0065\u0301 \uf900", "Caf\u00e9 \u8c48"  # as files read it
    system = tsplan.TransitionSystem.build([tsplan.State("a", color=made)], [], made)
    assert (system.name, system.states["a"].color) == (read, read)
