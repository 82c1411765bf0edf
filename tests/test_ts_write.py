"""Maps written and read again are the same maps."""

import string
from dataclasses import replace

import pytest
import yaml
from hypothesis import given
from hypothesis import strategies as st

from tests.seeds import quick
from tests.test_ts_read import FARM, ROBOT, read
from tsplan.document.flow_style import flow
from tsplan.errors import MapError
from tsplan.ts import Edge, State, TransitionSystem
from tsplan.ts.builders import grid
from tsplan.ts.io.lomap import lomap_to_yaml
from tsplan.ts.io.map_files import load_map, map_text, save_map
from tsplan.ts.io.tsplan_yaml import map_to_yaml

NUMBERS = st.floats(-1e6, 1e6)
POINTS = st.tuples(NUMBERS, NUMBERS)
NAMES = st.text(st.characters(codec="utf-8"), min_size=1, max_size=6) | st.sampled_from(
    ["no", "1", "01", "1.0", "true", "~", "a: b", "- x", "'", '"', "\\", "(1, 2)", " x ", "#c", "é"]
)
WORDS = st.frozensets(NAMES, max_size=3)


@st.composite
def edges(draw, names):
    chosen = draw(st.lists(st.tuples(st.sampled_from(names), st.sampled_from(names)), unique=True))
    found = {}
    classes = st.dictionaries(NAMES, st.integers(1, 9), min_size=1, max_size=2)
    for source, target in chosen:
        if (source, target) in found:
            continue
        edge = Edge(
            source,
            target,
            draw(st.integers(1, 9) | classes),
            draw(st.none() | st.floats(0, 100)),
            draw(st.none() | st.integers(0, 5)),
            draw(WORDS),
            both_ways=source != target and (target, source) not in found and draw(st.booleans()),
        )
        found[source, target] = edge
        if edge.both_ways:
            found[target, source] = edge.reverse()
    return list(found.values())


@st.composite
def systems(draw):
    names = draw(st.lists(NAMES, min_size=1, max_size=5, unique=True))
    states = [
        State(
            name,
            draw(WORDS),
            draw(st.none() | POINTS),
            draw(st.none() | st.lists(POINTS, min_size=3, max_size=4).map(tuple)),
            draw(st.none() | NAMES),
            draw(st.none() | st.integers(0, 5)),
            draw(WORDS),
        )
        for name in names
    ]
    return TransitionSystem.build(states, draw(edges(names)), draw(st.just("") | NAMES))


@quick
@given(systems())
def test_the_own_format_round_trip(system):
    again = read(map_to_yaml(system))
    assert again == system
    assert list(again.states) == list(system.states)


@quick
@given(systems(), st.none() | st.integers() | NAMES, st.none() | st.floats(1e-6, 1e6))
def test_origins_and_seconds_of_steps_are_kept_in_the_own_format(system, origin, seconds):
    states = [replace(state, origin=origin) for state in system.states.values()]
    told = TransitionSystem.build(states, system.edges.values(), step_seconds=seconds)
    assert read(map_to_yaml(told)) == told


@quick
@given(systems())
def test_lomaps_format_round_trip(system):
    again = read(lomap_to_yaml(system))
    assert again == system
    assert lomap_to_yaml(again) == lomap_to_yaml(system)


@pytest.mark.parametrize("text", [FARM, ROBOT, ROBOT.replace("directed: false", "directed: true")])
def test_examples_round_trip(text):
    system = read(text)
    assert read(map_to_yaml(system)) == system
    again = read(lomap_to_yaml(system))
    assert again == system
    if system.extras is not None:
        assert again.extras == system.extras


def test_lomap_output_is_what_yaml_readers_expect():
    class Reader(yaml.SafeLoader):
        pass

    Reader.add_constructor("!Ts", lambda loader, node: loader.construct_mapping(node, deep=True))
    Reader.add_constructor(
        "tag:yaml.org,2002:python/tuple",
        lambda loader, node: tuple(loader.construct_sequence(node, deep=True)),
    )
    data = yaml.load(lomap_to_yaml(read(ROBOT)), Reader)
    assert data["graph"]["nodes"]["u1"]["prop"] == {"up", "down"}
    assert data["graph"]["nodes"]["u1"]["location"] == (1, 2.5)
    assert (2, 3) in data["graph"]["nodes"]
    assert 1 in data["graph"]["nodes"]
    assert ["u1", "u2", {"control": "lf", "weight": 2}] in data["graph"]["edges"]
    assert data["directed"] is False
    assert data["final"] == {"g"}


def test_saving_keeps_the_format(tmp_path):
    for text, start in ((FARM, "name: farm"), (ROBOT, "!Ts")):
        system = read(text)
        save_map(system, tmp_path / "map.yaml")
        assert (tmp_path / "map.yaml").read_text(encoding="utf-8").startswith(start)
        assert load_map(tmp_path / "map.yaml") == system


def test_a_map_is_written_whole_or_not_at_all(tmp_path):
    system = read(FARM)
    with pytest.raises(MapError, match=r"nowhere.*: cannot write: .*; choose another file"):
        save_map(system, tmp_path / "nowhere" / "map.yaml")
    save_map(system, tmp_path / "map.yaml")
    assert [path.name for path in tmp_path.iterdir()] == ["map.yaml"]
    assert map_text(system) == map_to_yaml(system)


def test_edges_that_go_both_ways_are_written_once():
    text = map_to_yaml(read(FARM))
    assert text.count("both_ways") == 1
    assert "[q1, q2, 2]" in text


def test_states_without_edges():
    lonely = TransitionSystem.build([State("a")], [])
    assert read(map_to_yaml(lonely)) == lonely
    assert read(lomap_to_yaml(lonely)) == lonely


def test_grids_round_trip():
    system = grid(3, 4, blocked={(1, 1)}, labels={(0, 0): "a"}, duration=(1, 3))
    assert read(map_to_yaml(system)) == system


@quick
@given(st.text(string.printable) | st.floats() | st.booleans() | st.none() | st.integers())
def test_any_scalar_survives_other_readers(value):
    again = yaml.safe_load(flow(value))
    assert again == value or (value != value and again != again)  # noqa: PLR0124 - nan
