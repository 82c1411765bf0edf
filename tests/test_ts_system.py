"""Transition systems as values, and what building one checks."""

import pickle

import networkx as nx
import pytest

from tsplan.errors import MapError
from tsplan.ts import ByClass, Edge, State, TransitionSystem

TWO = [State("a"), State("b")]


def messages(states, edges):
    with pytest.raises(MapError) as caught:
        TransitionSystem.build(states, edges)
    return [finding.message for finding in caught.value.findings]


def test_a_system_is_one_frozen_value():
    system = TransitionSystem.build(TWO, [Edge("a", "b", 2)], "pair")
    assert system == TransitionSystem.build(list(TWO), [Edge("a", "b", 2)], "pair")
    assert hash(system) == hash(TransitionSystem.build(TWO, [Edge("a", "b", 2)], "pair"))
    assert system != TransitionSystem.build(TWO, [Edge("a", "b", 3)], "pair")
    assert pickle.loads(pickle.dumps(system)) == system
    with pytest.raises(TypeError):
        system.states["c"] = State("c")
    with pytest.raises(AttributeError):
        system.name = "other"
    assert repr(system) == "<TransitionSystem 'pair': 2 states, 1 edges>"


def test_the_graph_is_frozen_and_carries_everything():
    edge = Edge("a", "b", {"slow": 4, "fast": 2})
    graph = TransitionSystem.build(TWO, [edge]).graph
    assert graph.nodes["a"]["state"] == State("a")
    assert graph.edges["a", "b"] == {"edge": edge, "weight": 2}
    with pytest.raises(nx.NetworkXError):
        graph.add_node("c")


def test_labels_in_the_order_of_the_states():
    states = [State("z", {"x", "y"}), State("a", "x")]
    assert TransitionSystem.build(states, []).labels == {"x": ("z", "a"), "y": ("z",)}


def test_leaving():
    system = TransitionSystem.build(TWO, [Edge("a", "b"), Edge("a", "a")])
    assert [edge.pair for edge in system.leaving("a")] == [("a", "b"), ("a", "a")]
    assert system.leaving("b") == ()


def test_capacity_groups():
    one = Edge("a", "b", 1, None, 3, frozenset(), both_ways=True)
    system = TransitionSystem.build(
        TWO, [Edge("a", "a", capacity=2), Edge("b", "b"), one.reverse(), one]
    )
    assert system.capacity_groups == ((2, (("a", "a"),)), (3, (("b", "a"), ("a", "b"))))
    two = [Edge("a", "b", capacity=1), Edge("b", "a", capacity=1)]
    assert TransitionSystem.build(TWO, two).capacity_groups == (
        (1, (("a", "b"),)),
        (1, (("b", "a"),)),
    )


def test_by_class_is_a_frozen_mapping():
    durations = ByClass({"b": 2, "a": 1})
    assert durations == ByClass({"a": 1, "b": 2})
    assert hash(durations) == hash(ByClass({"a": 1, "b": 2}))
    assert durations != 2
    assert dict(durations) == {"a": 1, "b": 2}
    assert len(durations) == 2
    assert pickle.loads(pickle.dumps(durations)) == durations
    assert hash(Edge("a", "b", {"x": 1})) == hash(Edge("a", "b", ByClass({"x": 1})))


def test_what_building_refuses():
    assert messages([], [Edge("a", "b")]) == ["the map has no states"]
    found = messages(
        [State("a", at=(1.0, float("nan"))), State("a", capacity=-1), State("c", shape=())],
        [
            Edge("a", "c", 0),
            Edge("a", "c", True),
            Edge("c", "a", 1.5),
            Edge("c", "x", {}),
            Edge("c", "c", {"k": 0}, cost=float("inf"), capacity=1.5),
        ],
    )
    assert sorted(found) == [
        "a second edge leads from 'a' to 'c'",
        "at: (1.0, nan) is not a pair of finite numbers",
        "capacity: -1 is not a whole number of at least 0",
        "capacity: 1.5 is not a whole number of at least 0",
        "cost: inf is not a finite number of at least 0",
        "duration: 0 for 'k' is not a whole number from 1 on",
        "duration: 0 is not a whole number from 1 on",
        "duration: 1.5 is not a whole number from 1 on",
        "duration: True is not a whole number from 1 on",
        "duration: no class is listed, so nobody can use this edge",
        "no state is called 'x'",
        "shape: not 3 or more pairs of finite numbers",
        "the state 'a' is defined twice",
    ]


def test_both_ways_needs_its_reverse():
    both = Edge("a", "b", 2, both_ways=True)
    assert messages(TWO, [both]) == ["the edge from 'a' to 'b' lacks its equal reverse"]
    assert len(messages(TWO, [both, Edge("b", "a", 2)])) == 1
    assert len(TransitionSystem.build(TWO, [both, both.reverse()]).edges) == 2
