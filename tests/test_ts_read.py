"""Reading maps: the own format, LOMAP's, and everything that can be wrong with them."""

import pytest

from tests.missions import findings
from tsplan.document import parse_document
from tsplan.errors import InputError, MapError
from tsplan.ts import ByClass, Edge, State
from tsplan.ts.io.map_files import load_map, map_from_document


def read(text):
    return map_from_document(parse_document(text, "m.yaml"))


def wrong(text):
    return findings(read, text)


FARM = """
name: farm
waiting: true
states:
  q1: {labels: [blue, wet], at: [2.2, 8], shape: [[0,7],[4.5,7],[4.5,10]], color: blue, capacity: 4}
  q2: {labels: []}
  3:
  q4: {needs: [fly]}
edges:
  - [q1, q2, 2.0]
  - [q2, q2, 3]
  - {from: q2, to: 3, duration: 2, cost: 3.5, capacity: 1, both_ways: true}
  - {from: q1, to: q4, duration: {scout: 1, default: 3}, needs: [fly]}
  - [3, q4, {heavy: 2}]
"""


def test_the_own_format():
    farm = read(FARM)
    corners = ((0.0, 7.0), (4.5, 7.0), (4.5, 10.0))
    assert farm.name == "farm"
    assert list(farm.states) == ["q1", "q2", "3", "q4"]
    assert farm.states["q1"] == State(
        "q1", frozenset(("blue", "wet")), (2.2, 8.0), corners, "blue", 4
    )
    assert farm.states["q4"].needs == {"fly"}
    assert farm.edges["q1", "q2"] == Edge("q1", "q2", 2)
    assert farm.edges["q2", "3"] == Edge("q2", "3", 2, 3.5, 1, frozenset(), both_ways=True)
    assert farm.edges["3", "q2"] == farm.edges["q2", "3"].reverse()
    assert farm.capacity_groups == ((1, (("q2", "3"), ("3", "q2"))),)
    assert farm.labels == {"blue": ("q1",), "wet": ("q1",)}


def test_the_length_of_a_step_and_original_ids():
    text = "step: 0.5\nstates: {a: {origin: 17}, b: {origin: '17'}, c: {}}\nedges: []"
    system = read(text)
    assert system.step_seconds == 0.5
    assert [state.origin for state in system.states.values()] == [17, "17", None]
    faulty = "step: 0\nstates: {a: {origin: 1.5}, b: {origin: true}}\nedges: []"
    assert [line.split(":")[1:3] for line in wrong(faulty)] == [
        ["1", "7"],
        ["2", "22"],
        ["2", "40"],
    ]


def test_waiting_adds_a_wait_where_there_is_none():
    farm = read(FARM)
    assert farm.edges["q1", "q1"] == Edge("q1", "q1", 1)
    assert farm.edges["q2", "q2"].duration == 3
    assert ("q1", "q1") not in read(FARM.replace("waiting: true\n", "")).edges


def test_durations_and_costs_by_class():
    farm = read(FARM)
    edge = farm.edges["q1", "q4"]
    assert edge.duration == ByClass({"scout": 1, "default": 3})
    assert (edge.duration_for("scout"), edge.duration_for("heavy")) == (1, 3)
    assert farm.edges["3", "q4"].duration_for("scout") is None
    assert farm.edges["3", "q4"].cost_for("scout") == float("inf")
    assert farm.edges["3", "q4"].cost_for("heavy") == 2
    assert farm.edges["q2", "3"].cost_for("heavy") == 3.5
    assert farm.edges["q2", "q2"].cost_for("heavy") == 0


def test_everything_wrong_is_found_at_once():
    text = """name: x
wating: true
states:
  q1: {labels: a, at: [1, x]}
  q2: {labels: [1], capacity: 1.5, at: [1], shape: [[1, 2]]}
  q3: 5
edges:
  - [q1, q7, 1]
  - [q1, q2, 1.5]
  - [q1, q2]
  - {from: q2, to: q1, duration: 0, cost: -3.5, bothways: true}
  - [q2, q3, 1]
  - [q2, q3, 2]
  - {from: q3, to: q9, duration: {a: 0}}
  - {from: q9, to: q3, duration: 1, both_ways: true}
  - {from: q1, to: q1, duration: 1, both_ways: true}
"""
    assert wrong(text) == [
        "m.yaml:2:1: unknown key 'wating'; did you mean 'waiting'?",
        "m.yaml:4:16: labels: 'a' is not a list; write it as [a, b]",
        "m.yaml:4:27: at: 'x' is not a finite number; write one, as in 1.5",
        "m.yaml:5:17: labels: '1' is not text; put it in quotes",
        "m.yaml:5:31: capacity: '1.5' is not a whole number; write one, as in 3",
        "m.yaml:5:40: entry 2 is missing; add it",
        "m.yaml:5:52: shape: 1 entries are too few; write at least 3",
        "m.yaml:6:7: q3: '5' is not a mapping; write it as {key: value}",
        "m.yaml:8:10: no state is called 'q7'; did you mean 'q3'?",
        (
            "m.yaml:9:14: duration: '1.5' is not a whole number from 1 on; "
            "durations are whole numbers of steps, at least 1"
        ),
        (
            "m.yaml:10:5: an edge is [from, to, duration], not 2 entries; "
            "write three, or {from: a, to: b, duration: 1, ...}"
        ),
        (
            "m.yaml:11:34: duration: '0' is not a whole number from 1 on; "
            "durations are whole numbers of steps, at least 1"
        ),
        (
            "m.yaml:11:43: cost: '-3.5' should be greater than or equal to 0; "
            "use a number that is at least 0"
        ),
        "m.yaml:11:49: unknown key 'bothways'; did you mean 'both_ways'?",
        (
            "m.yaml:13:5: a second edge leads from 'q2' to 'q3', the first in line 12; "
            "keep one, or put a state between"
        ),
        (
            "m.yaml:14:34: duration: '0' is not a whole number from 1 on; "
            "durations are whole numbers of steps, at least 1"
        ),
        "m.yaml:15:12: no state is called 'q9'; did you mean 'q3'?",
        "m.yaml:16:48: the edge from 'q1' to itself cannot go both ways; drop both_ways",
    ]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("", "m.yaml:1:1: the map is empty"),
        ("states: {}", "m.yaml:1:9: the map has no states; add at least one state"),
        ("edges: []", "m.yaml:1:1: 'states' is missing"),
        ("states: {a: {shape: [[0, 0], [1, 0], [1]]}}", "m.yaml:1:38: entry 2 is missing"),
        ("states: [a]", "m.yaml:1:9: states: a list is not a mapping"),
        ("- a", "m.yaml:1:1: a list is not a mapping"),
        ("a map", "m.yaml:1:1: 'a map' is not a mapping"),
        ("states: {'': {}}", "m.yaml:1:10: '' cannot be the name of a state"),
        ("states: {a: {at: [1, .inf]}}", "m.yaml:1:22: at: 'inf' is not a finite number"),
        ("states: {a: }\nedges: [[a, a, '1']]", "m.yaml:2:16: duration: '1' is not a whole"),
        ("states: {a: }\nedges: [[a, a, true]]", "m.yaml:2:16: duration: 'true' is not a whole"),
        (
            "states: {a: }\nedges: [[a, [a], 1]]",
            "m.yaml:2:13: edge: a list is not the name of a state",
        ),
        ("states: {a: }\nedges: [[a, a, {}]]", "m.yaml:2:16: duration: no class is listed"),
        ("states: {a: }\nwaiting: yes", "m.yaml:2:10: waiting: 'yes' is neither true nor false"),
        (
            (
                "states: {a: , b: }\nedges:\n- {from: a, to: b, duration: 1, both_ways: true}\n"
                "- [b, a, 1]"
            ),
            "m.yaml:4:3: a second edge leads from 'b' to 'a', the first in line 3",
        ),
    ],
)
def test_one_thing_wrong(text, expected):
    [finding] = wrong(text)
    assert finding.startswith(expected)


def test_a_map_inside_another_document():
    document = parse_document("map: {states: {a: {lables: []}}}", "mission.yaml")
    with pytest.raises(MapError, match=r"mission\.yaml:1:20: unknown key 'lables'"):
        map_from_document(document, ("map",))


def test_a_map_file_that_is_missing(tmp_path):
    with pytest.raises(MapError, match="no such file"):
        load_map(tmp_path / "none.yaml")


ROBOT = """!Ts
name: robot
multi: true
directed: false
init: [u1]
final: !!set {g}
battery: 7
graph:
  nodes:
    1: {}
    u1: {prop: !!set {up, down: null}, location: !!python/tuple [1, 2.5], color: red}
    u2: {prop: [a, 5], position: [1, 2, 3], height: 4}
    u3: {prop: word, shape: box}
    g: {prop: {x: null}, shape: [[0, 0], [1, 0], [1, 1]]}
    ? !!python/tuple [2, 3]
    : {prop: !!python/unicode 'p'}
  edges:
  - [u1, u2, {control: lf, weight: 2}]
  - [u2, u1, {control: rf, weight: 2}]
  - [u2, 1, {weight: 3.0}]
  - [1, 1, {weight: 1}]
  - [1, !!python/tuple [2, 3]]
"""


def test_lomaps_format():
    robot = read(ROBOT)
    assert list(robot.states) == ["1", "u1", "u2", "u3", "g", "(2, 3)"]
    assert robot.states["u1"] == State("u1", frozenset(("up", "down")), (1.0, 2.5), color="red")
    assert robot.states["u2"].labels == {"a", "5"}
    assert robot.states["u2"].at == (1.0, 2.0)
    assert robot.states["u3"].labels == {"word"}
    assert robot.states["u3"].shape is None
    assert robot.states["g"].shape == ((0.0, 0.0), (1.0, 0.0), (1.0, 1.0))
    assert robot.states["(2, 3)"].labels == {"p"}


def test_undirected_edges_are_doubled():
    edges = read(ROBOT).edges
    assert edges["u1", "u2"] == Edge("u1", "u2", 2, both_ways=True)
    assert edges["1", "u2"] == Edge("1", "u2", 3, both_ways=True)
    assert edges["1", "1"] == Edge("1", "1", 1)
    assert edges["(2, 3)", "1"].duration == 1
    assert len(edges) == 7
    directed = read(ROBOT.replace("directed: false", "directed: true")).edges
    assert len(directed) == 5
    assert not directed["u1", "u2"].both_ways


def test_what_lomap_knows_beyond_planning_is_kept():
    extras = read(ROBOT).extras
    assert extras.system["attributes"] == {
        "multi": True,
        "init": ["u1"],
        "final": frozenset(("g",)),
        "battery": 7,
    }
    assert extras.states["u2"] == {"position": [1, 2, 3], "height": 4}
    assert extras.states["u3"] == {"shape": "box"}
    assert extras.edges["u1", "u2"] == ({"control": "lf"}, {"control": "rf"})


def test_what_is_wrong_in_lomaps_format():
    text = """!Ts
graph:
  nodes:
    1: {}
    2: {tsplan: {capacity: x}}
  edges:
  - [1, 2, {weight: 1.5}]
  - [1, 3, {weight: 1}]
  - [1, 2, {weight: 2}]
  - [1]
  - [2, 1, {weight: a}]
"""
    assert wrong(text) == [
        "m.yaml:5:28: capacity: 'x' is not a whole number; write one, as in 3",
        (
            "m.yaml:7:21: duration: 1.5 is not a whole number from 1 on; "
            "durations are whole numbers of steps, at least 1"
        ),
        "m.yaml:8:9: no state is called '3'; known: 1, 2",
        (
            "m.yaml:9:5: a second edge leads from '1' to '2', the first in line 7; "
            "keep one, or put a state between"
        ),
        "m.yaml:10:5: an edge is not [from, to, {weight: ...}]; write it so",
        (
            "m.yaml:11:21: duration: a is not a whole number from 1 on; "
            "durations are whole numbers of steps, at least 1"
        ),
    ]
    assert "no states" in wrong("!Ts\ngraph: {nodes: {}}")[0]
    assert "'graph' is missing" in wrong("!Ts\nname: x\n")[0]
    with pytest.raises(InputError, match=r"m\.yaml:1:1: the tag"):
        read("!!python/object:lomap.Ts {graph: {}}")


def test_places_of_undirected_edges_are_those_of_their_ends():
    text = """!Ts
directed: false
graph:
  nodes: {a: {}, b: {}}
  edges:
  - [a, c, {weight: 1}]
  - [d, b, {weight: 0}]
"""
    assert [finding.split(";")[0] for finding in findings(read, text)] == [
        "m.yaml:6:9: no state is called 'c'",
        "m.yaml:7:6: no state is called 'd'",
        "m.yaml:7:21: duration: 0 is not a whole number from 1 on",
    ]
