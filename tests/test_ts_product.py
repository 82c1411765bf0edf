"""Products, single steps and the lint."""

import pytest

from tsplan.errors import MapError
from tsplan.ts import Edge, State, TransitionSystem
from tsplan.ts.builders import grid
from tsplan.ts.map_lint import lint
from tsplan.ts.product import product, unit_steps
from tsplan.ts.reachability import shortest_durations

LINE = TransitionSystem.build(
    [State("a", "x", needs="fly"), State("b")], [Edge("a", "b"), Edge("b", "b")], "line"
)
RING = TransitionSystem.build([State("p", "y"), State("q")], [Edge("p", "q"), Edge("q", "p")])


def test_both_move_in_a_product():
    joint = product(LINE, RING)
    assert list(joint.states) == ["a|p", "a|q", "b|p", "b|q"]
    assert joint.states["a|p"].labels == {"x", "y"}
    assert joint.states["a|q"].needs == {"fly"}
    assert set(joint.edges) == {
        ("a|p", "b|q"),
        ("a|q", "b|p"),
        ("b|p", "b|q"),
        ("b|q", "b|p"),
    }
    assert joint.edges["a|p", "b|q"].cost == 2
    assert joint.edges["b|p", "b|q"].cost == 1


def test_a_product_of_equal_longer_durations():
    slow = TransitionSystem.build([State("a")], [Edge("a", "a", 3)])
    assert product(slow, slow).edges["a|a", "a|a"] == Edge("a|a", "a|a", 3, 0.0)


def test_products_that_are_refused():
    slow = TransitionSystem.build([State("a")], [Edge("a", "a", 3)])
    with pytest.raises(MapError, match="equally long; apply unit_steps"):
        product(LINE, slow)
    by_class = TransitionSystem.build([State("a")], [Edge("a", "a", {"k": 3})])
    with pytest.raises(MapError, match="equally long"):
        product(by_class, by_class)
    for full in (
        TransitionSystem.build([State("a", capacity=1)], [Edge("a", "a")]),
        TransitionSystem.build([State("a")], [Edge("a", "a", capacity=1)]),
    ):
        with pytest.raises(MapError, match="not defined for capacities"):
            product(full, LINE)
    # a|b + c and a + b|c would be one name
    one = TransitionSystem.build([State("a|b"), State("a")], [])
    two = TransitionSystem.build([State("c"), State("b|c")], [])
    with pytest.raises(MapError, match="defined twice"):
        product(one, two)


def test_unit_steps_keep_times_and_costs():
    system = grid(3, 3, duration=(1, 4), labels={(1, 1): "x"})
    single = unit_steps(system)
    assert {edge.duration for edge in single.edges.values()} == {1}
    assert single.labels == system.labels
    size = len(system.states)
    assert list(single.states)[:size] == list(system.states)
    assert (shortest_durations(single)[:size, :size] == shortest_durations(system)).all()
    total = sum(edge.cost_for("") for edge in system.edges.values())
    assert sum(edge.cost_for("") for edge in single.edges.values()) == total
    assert product(unit_steps(grid(1, 2, duration=3)), RING).name == "grid|"


def test_long_waits_cost_nothing_in_unit_steps():
    long = TransitionSystem.build([State("a")], [Edge("a", "a", 3)])
    single = unit_steps(long)
    assert list(single.states) == ["a", "a->a@1", "a->a@2"]
    assert all(edge.cost_for("") == 0 for edge in single.edges.values())


def test_unit_steps_of_a_class():
    system = TransitionSystem.build(
        [State("a"), State("b")],
        [Edge("a", "b", {"k": 2}, cost=7), Edge("b", "a", {"other": 1}), Edge("b", "b")],
    )
    single = unit_steps(system, "k")
    assert set(single.edges) == {("a", "a->b@1"), ("a->b@1", "b"), ("b", "b")}
    assert single.edges["a", "a->b@1"].cost == 7
    with pytest.raises(MapError, match="differs by class; name the class"):
        unit_steps(system)
    full = TransitionSystem.build([State("a")], [Edge("a", "a", 2, capacity=1)])
    with pytest.raises(MapError, match="has a capacity"):
        unit_steps(full)
    both = Edge("a", "b", both_ways=True, capacity=1)
    shared = TransitionSystem.build(LINE.states.values(), [both, both.reverse()])
    assert unit_steps(shared).edges == shared.edges


def texts(system, **more):
    return [str(finding) for finding in lint(system, **more)]


def test_lint_finds_nothing_on_a_grid():
    assert texts(grid(3, 3, labels={(0, 0): "a"}), used_labels={"a"}, starts=["r0c0"]) == []
    assert texts(grid(1, 1)) == []


def test_lint():
    system = TransitionSystem.build(
        [State("a"), State("b", "x"), State("c"), State("d", "y"), State("e")],
        [
            Edge("a", "b"),
            Edge("b", "a"),
            Edge("b", "c"),
            Edge("c", "d"),
            Edge("d", "c"),
            Edge("b", "e"),
        ],
    )
    assert texts(system, used_labels=["x", "yy"], starts=["c"]) == [
        (
            "the state 'a' cannot be reached from where agents start; "
            "add an edge that leads to it, or drop it"
        ),
        (
            "the state 'b' cannot be reached from where agents start; "
            "add an edge that leads to it, or drop it"
        ),
        (
            "the state 'e' cannot be reached from where agents start; "
            "add an edge that leads to it, or drop it"
        ),
        (
            "no edge leaves the state 'e', not even a wait; "
            "add a wait there (`waiting: true` adds one to every state)"
        ),
        (
            "nobody can wait at 'a', 'b', 'c', 'd': agents have to move on at once; "
            "add `waiting: true`, or an edge from the state to itself"
        ),
        (
            "once at 'c', 'd', an agent cannot go anywhere else; "
            "add an edge that leads back, if that is not meant"
        ),
        "the label 'y' of 'd' is not used; drop it, or use it in the formula",
        "no state carries the label 'yy'; did you mean 'y'?",
    ]
    assert len(texts(system)) == 3


def test_lint_without_starts_looks_for_any_way_in():
    system = TransitionSystem.build([State("a"), State("b")], [Edge("a", "b"), Edge("b", "b")])
    assert [text.split(";")[0] for text in texts(system)] == [
        "the state 'a' cannot be reached from any other state",
        "nobody can wait at 'a': agents have to move on at once",
        "once at 'b', an agent cannot go anywhere else",
    ]
