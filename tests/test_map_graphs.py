"""Maps as graphs: GraphML, node-link JSON, and graphs of networkx themselves."""

from __future__ import annotations

import json

import networkx as nx
import pytest

from tests import foreign_maps
from tests.foreign_maps import (
    GRAPHML,
    NODE_LINK,
    moves,
    noted,
    read,
    refused,
)
from tsplan.ts import Edge
from tsplan.ts.builders import map_of_graph
from tsplan.ts.edges import ByClass
from tsplan.ts.io.map_files import load_map
from tsplan.ts.parallel_edges import choices

FILES = foreign_maps.FILES


# --- GraphML and node-link JSON ---


def test_a_graph_in_graphml(folder):
    system = read(folder, "graph.graphml")
    assert system.labels == {"place": ("7", "9"), "goal": ("8",), "far": ("8",)}
    assert moves(system) == {
        ("7", "8"): 6,
        ("8", "7"): 6,
        ("8", "9"): 4,
        ("9", "8"): 4,
        ("9", "7"): 2,
    }
    assert system.edges["7", "8"].both_ways
    assert system.states["8"].at == (3.0, 4.0)


def test_graphml_is_read_as_networkx_writes_it(tmp_path):
    graph = nx.MultiDiGraph(name="")
    graph.add_node("a", x=1.5, y=2.0, label="dock")
    graph.add_node("b", capacity=2)
    graph.add_edge("a", "b", length=2.5, duration=4)
    graph.add_edge("a", "b", length=2.5, success=0.5)
    nx.write_graphml(graph, tmp_path / "g.graphml")
    system = load_map(tmp_path / "g.graphml")
    assert system.states["a"].labels == {"dock"}
    assert system.states["b"].capacity == 2
    assert system.edges["a", "b"] == Edge("a", "b", 3, success=0.5)
    assert "only the quickest (3 steps) is kept" in noted(system)[0]


@pytest.mark.parametrize("key", ["links", "edges"])
def test_node_link_json_is_read_as_networkx_writes_it(tmp_path, key):
    graph = nx.Graph()
    graph.add_node((0, 1), labels=["dock"])
    graph.add_edge((0, 1), 5, weight=2.0)
    (tmp_path / "g.json").write_text(json.dumps(nx.node_link_data(graph, edges=key)))
    system = load_map(tmp_path / "g.json")
    assert moves(system) == {("(0, 1)", "5"): 2, ("5", "(0, 1)"): 2}
    assert [state.origin for state in system.states.values()] == [None, 5]


def test_node_link_json(folder):
    system = read(folder, "graph.json")
    assert system.name == "yard"
    assert moves(system) == {("a", "b"): 3, ("b", "3"): 4, ("3", "a"): 5}
    assert system.states["3"].origin == 3
    assert noted(system) == [
        "1 more edge from 'a' to 'b' can do nothing better than the one that is kept"
    ]


def test_all_that_is_wrong_with_a_graph_is_said_at_once(tmp_path):
    text = (
        NODE_LINK.replace('"target": 3', '"target": 4')
        .replace('"capacity": 2', '"capacity": "two"')
        .replace('"weight": 7', '"weight": -7')
        .replace('"id": "a",', '"name": "a",')
    )
    said = refused(tmp_path, "graph.json", text)
    assert any("'id' is missing; write each as {id: ...}" in words for words in said)
    assert any("capacity: two is not a whole number" in words for words in said)
    assert any("weight: -7 is no length of at least 0" in words for words in said)
    assert any("no node has the id '4'; known: 3, b" in words for words in said)
    assert all(words.split(":")[1].isdigit() for words in said)


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("</graph>", "</grap>", "graph.graphml:16:5: not valid XML: mismatched tag"),
        ('<node id="7">', "<node>", "graph.graphml:8:5: this node has no id; write id='...'"),
        ('target="9" />', "/>", "graph.graphml:14:5: this edge has no target"),
        ('key="d3">5.5', 'key="d9">5.5', "graph.graphml:13:33: no key has the id 'd9'"),
        ("5.5", "long", "graph.graphml:13:33: weight: 'long' is not of the type double"),
        ('target="9" />', 'target="19" />', "graph.graphml:14:5: no node has the id '19'"),
        ("<edge source", "<hyperedge/><edge source", "graph.graphml:13:5: this is a hyperedge"),
        (
            "<graphml",
            '<!DOCTYPE g [<!ENTITY a "aaa">]><graphml',
            "graph.graphml:2:25: XML entities are not read; remove them",
        ),
    ],
)
def test_broken_graphml_says_where(tmp_path, old, new, words):
    said = refused(tmp_path, "graph.graphml", GRAPHML.replace(old, new, 1))
    assert words in said[0]


# --- graphs of networkx ---


def test_a_multigraph_keeps_the_best_of_parallel_edges():
    graph = nx.MultiDiGraph()
    graph.add_edge("a", "b", duration=3)
    graph.add_edge("a", "b", duration=2, cost=9.0)
    graph.add_edge("a", "b", duration=2, cost=1.0)
    system = map_of_graph(graph)
    assert system.edges["a", "b"] == Edge("a", "b", 2, 1.0)
    assert not system.notes[0].remedy
    graph.add_edge("a", "b", duration=9, cost=0.5)
    (note,) = map_of_graph(graph).notes
    assert "3 more edges from 'a' to 'b' may cost less" in note.message
    assert note.remedy == "put a node on the way where both matter"


def test_an_undirected_multigraph_keeps_a_road_both_ways():
    graph = nx.MultiGraph()
    graph.add_edge("a", "b", length=4, capacity=1)
    graph.add_edge("a", "b", length=2.5)
    system = map_of_graph(graph)
    assert moves(system) == {("a", "b"): 3, ("b", "a"): 3}
    assert system.edges["a", "b"].both_ways


def test_which_parallel_edge_is_as_good_for_everybody():
    edges = [
        Edge("a", "b", ByClass({"cart": 2, "default": 3})),
        Edge("a", "b", 3, needs=frozenset({"fly"})),
        Edge("c", "d", 2, capacity=1),
        Edge("c", "d", 2),
        Edge("e", "f", ByClass({"cart": 2})),
        Edge("e", "f", 2, 7.0),
        Edge("g", "h", 1, needs=frozenset({"fly"})),
        Edge("g", "h", 2),
    ]
    found = {edges[choice.kept].source: (choice.kept, choice.whole) for choice in choices(edges)}
    assert found == {"a": (0, True), "c": (2, False), "e": (5, False), "g": (6, False)}
