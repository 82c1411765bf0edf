"""Maps of other programs: what is read, what is dropped, and what is wrong with broken ones."""

from __future__ import annotations

import builtins
import json
import sys

import networkx as nx
import numpy as np
import pytest

from tests.command_line import ROOT
from tests.foreign_maps import (
    FILES,
    GRAPHML,
    LIF,
    NAV2,
    NODE_LINK,
    OCCUPANCY,
    OCTILE,
    RMF,
    ROOM,
    STATE_MODELS,
)
from tsplan import MapError
from tsplan.document import parse_document
from tsplan.draw.layout import places
from tsplan.ts import Edge
from tsplan.ts.builders import map_of_graph
from tsplan.ts.edges import ByClass
from tsplan.ts.io import map_files
from tsplan.ts.io.grey_image import read_grey
from tsplan.ts.io.map_files import FORMATS, format_of, load_map, map_document, save_map
from tsplan.ts.io.map_settings import MapSettings
from tsplan.ts.io.tsplan_yaml import map_to_yaml, read_own
from tsplan.ts.parallel_edges import choices
from tsplan.ts.ride_durations import Ride, steps_of


@pytest.fixture
def files(tmp_path):
    """A folder with a file of every format."""
    for name, text in {**FILES, "room.pgm": ROOM}.items():
        (tmp_path / name).write_text(text)
    return tmp_path


def read(folder, name, text=None, **said):
    path = folder / name
    if text is not None:
        path.write_text(text)
    return load_map(path, MapSettings(**said))


def refused(folder, name, text, **said):
    """The findings of a broken map, without the folder."""
    with pytest.raises(MapError) as caught:
        read(folder, name, text, **said)
    return [str(finding).replace(f"{folder}/", "") for finding in caught.value.findings]


def noted(system):
    return [note.message for note in system.notes]


def moves(system):
    return {pair: edge.duration for pair, edge in system.edges.items() if not edge.is_wait}


@pytest.mark.parametrize("name", FILES)
def test_formats_are_told_by_content_not_by_name(files, name):
    form = format_of(map_document(files / name)).name
    for suffix in ("", ".txt", ".yaml", ".json"):
        other = files / f"other{suffix}"
        other.write_text(FILES[name])
        assert format_of(map_document(other)).name == form
    assert form != FORMATS[-1].name


@pytest.mark.parametrize("name", FILES)
def test_every_map_becomes_an_own_file_and_is_read_as_the_same(files, name):
    system = read(files, name, step=2.0)
    save_map(system, files / "own.yaml")
    assert (files / "own.yaml").read_text() == map_to_yaml(system)
    again = load_map(files / "own.yaml")
    assert again == system
    assert again.step_seconds == 2.0
    origins = [state.origin for state in again.states.values()]
    assert None not in origins
    assert len(set(origins)) == len(origins)


@pytest.mark.parametrize("name", FILES)
def test_waits_are_added_unless_that_is_refused(files, name):
    waiting, restless = read(files, name), read(files, name, waiting=False)
    assert all((state, state) in waiting.edges for state in waiting.states)
    assert not any(edge.is_wait for edge in restless.edges.values())
    assert moves(waiting) == moves(restless)


def test_every_format_is_described():
    page = (ROOT / "docs" / "maps.md").read_text()
    for form in FORMATS:
        assert f"| `{form.name}`: " in page


def test_lengths_become_durations_in_one_place():
    assert steps_of(Ride(12.1 - 10.4), 1.0, 0.1) == 17
    assert steps_of(Ride(0.0), 1.0, 1.0) == 1
    assert steps_of(Ride(4, seconds=2.5), 0.5, 9.0) == 5
    assert steps_of(Ride(6, share=0.5, limit=0.25), 1.0, 1.0) == 24
    assert steps_of(Ride(6, pause=3), 4.0, 2.0) == 2
    assert steps_of(Ride(6), 1.0, {"a": 2, "default": 2}) == 3
    assert steps_of(Ride(6), 1.0, {"a": 2}) == {"a": 3}
    assert steps_of(Ride(6, limit={"a": None, "b": 0.5}), 1.0, {"a": 3}) == {"a": 2, "b": 12}


# --- Nav2 ---


def test_a_route_graph_of_nav2(files):
    system = read(files, "nav.geojson")
    assert (system.name, system.frame, system.step_seconds) == ("depot", "map", 1.0)
    assert {name: state.origin for name, state in system.states.items()} == {"0": 0, "1": 1, "2": 2}
    assert system.states["0"].labels == {"dock", "charger"}
    assert system.states["2"].at == (3.0, 4.0)
    assert moves(system) == {
        ("0", "1"): 3,
        ("1", "0"): 12,
        ("1", "2"): 8,
        ("2", "0"): 5,
        ("2", "1"): 4,
    }
    assert system.edges["2", "0"].cost == 99.0
    assert noted(system) == [
        "a node has operations, which are not planned",
        "an edge has a penalty, which is not used",
        (
            "1 more edge from '2' to '0' may cost less or be open to more: "
            "only the quickest (5 steps) is kept"
        ),
    ]
    by_class = read(files, "nav.geojson", step=2.0, speed={"cart": 0.5, "default": 1.0})
    assert moves(by_class)["0", "1"] == ByClass({"cart": 3, "default": 2})
    assert moves(by_class)["1", "0"] == 6


def test_all_that_is_wrong_with_a_route_graph_is_said_at_once(tmp_path):
    text = (
        NAV2.replace('"endid": 1, "cost"', '"endid": 17, "cost"')
        .replace('"abs_speed_limit": 0.25', '"abs_speed_limit": "fast"')
        .replace('"coordinates": [3.0, 4.0]', '"coordinates": [3.0]')
        .replace('"id": 8, "startid": 2,', '"id": 8, "startid": "2",')
        .replace('"abs_time_taken": 7.5', '"abs_time_taken": 0')
    )
    said = refused(tmp_path, "nav.geojson", text)
    assert [words.split(":")[1] for words in said] == ["8", "9", "10", "11", "14"]
    assert "coordinates: 1 entries are too few" in said[0]
    assert "no node has the id '17'; did you mean '1'?" in said[1]
    assert said[2].startswith("nav.geojson:10:105: abs_speed_limit: 'fast' is not a number")
    assert "abs_time_taken: '0' should be more than 0" in said[3]
    assert "startid: '2' is not a whole number" in said[4]
    twice = refused(tmp_path, "nav.geojson", NAV2.replace('"id": 1, "frame"', '"id": 0, "frame"'))
    assert "the id '0' is taken: it is that of the node in line 6" in twice[0]


def test_broken_json_says_where(tmp_path):
    text = NAV2.replace('"id": 1, "frame"', '"id" 1, "frame"')
    assert refused(tmp_path, "nav.geojson", text) == [
        "nav.geojson:7:43: not valid JSON: ':' is expected; look at the punctuation here"
    ]


def test_geographic_data_that_are_no_route_graph_are_refused(tmp_path):
    text = '{"type": "FeatureCollection", "features": [{"type": "Feature", "properties": {}}]}'
    assert "this is geographic data (GeoJSON)" in refused(tmp_path, "places.json", text)[0]


# --- Open-RMF ---


def test_a_navigation_graph_of_rmf(files):
    system = read(files, "rmf.yaml")
    assert system.name == "hotel"
    origins = {name: state.origin for name, state in system.states.items()}
    assert origins["lobby"] == "lobby"
    assert (origins["L1_1"], origins["L2_2"]) == (1, 6)
    assert system.states["lobby"].labels == {"charger", "parking_spot", "L1"}
    assert system.states["suite"].labels == {"holding_point", "pickup", "L2"}
    assert {state.level for state in system.states.values()} == {"L1", "L2"}
    assert system.zones == {"hall": 1, "east": 1}
    assert system.zone_parts["hall"] == (("gate",), (("L1_1", "gate"), ("gate", "L1_1")))
    assert system.zone_parts["east"].states == ("lift_L1", "lift_L2")
    found = moves(system)
    assert (found["lobby", "L1_1"], found["L1_1", "lobby"]) == (2, 4)
    assert found["L1_1", "gate"] == 2 + 8  # the door opens and closes
    assert found["gate", "lift_L1"] == found["lift_L1", "gate"] == 8  # 3.3 m and 4 s
    assert found["lift_L1", "lift_L2"] == found["lift_L2", "lift_L1"] == 1
    assert found["lift_L2", "suite"] == 14  # 4.0003 m, 4 s for the door and 5 s to dock
    said = noted(system)
    assert "a lane has an orientation_constraint, which is not planned" in said
    assert "the lift 'east' has 2 levels and carries one robot at a time" in said
    assert "no vertex is in the lift 'west'" in said


def test_numbers_of_vertices_count_the_ones_that_rmf_adds_for_docks(tmp_path):
    text = RMF.replace("[2, 3, {}]", "[2, 3, {dock_name: cabin}]")
    system = read(tmp_path, "rmf.yaml", text)
    assert system.states["L2_2"].origin == 7
    assert moves(system)["gate", "lift_L1"] == 13


def test_all_that_is_wrong_with_a_navigation_graph_is_said_at_once(tmp_path):
    text = (
        RMF.replace("[2, 3, {}]", "[2, 9, {}]")
        .replace("[1.7, 0.0,", "[1.7, north,")
        .replace("speed_limit: 0.5", "speed_limit: -1")
        .replace("[5.0, 2.05,", "[5.0, 3.0,")
        .replace("- [1, 2]\n", "- [1]\n")
    )
    said = refused(tmp_path, "rmf.yaml", text)
    for words in (
        "rmf.yaml:8:30: speed_limit: '-1' should be greater than or equal to 0",
        "rmf.yaml:11:13: the level 'L1' has no vertex 9; they count from 0",
        "rmf.yaml:15:15: 1: 'north' is not a number",
        "rmf.yaml:20:9: the lift 'east' is 1.00 m away from where it was",
        "rmf.yaml:26:9: a lane is not [from, to, {...}]",
    ):
        assert any(each.startswith(words) for each in said), (words, said)


def test_a_building_of_the_traffic_editor_is_told_from_a_graph(tmp_path):
    text = "levels:\n  L1:\n    vertices: [[0, 0, 0, a]]\n    lanes: []\n    walls: []\n"
    assert "name the navigation graph that is made of it" in refused(tmp_path, "b.yaml", text)[0]


def test_levels_are_drawn_side_by_side(files):
    system = read(files, "rmf.yaml")
    where = places(system)
    left = max(where[name][0] for name, state in system.states.items() if state.level == "L1")
    right = min(where[name][0] for name, state in system.states.items() if state.level == "L2")
    assert left < right
    assert where["lobby"] == (0.0, 0.0)
    assert places(read(files, "nav.geojson"))["2"] == (3.0, 4.0)


# --- MovingAI ---


def test_a_grid_of_movingai(files):
    system = read(files, "grid.map")
    assert len(system.states) == 16
    assert system.labels == {"swamp": ("r1c3",), "water": ("r1c4", "r2c3", "r2c4")}
    assert system.states["r3c1"].origin == 16
    assert system.states["r3c1"].at == (1.5, 3.5)
    found = moves(system)
    assert ("r0c3", "r1c3") in found
    assert ("r1c3", "r1c4") not in found  # water is not entered from land
    assert ("r1c4", "r2c4") in found
    assert ("r0c0", "r1c1") not in found
    assert set(found.values()) == {1}
    assert noted(system) == [
        "robots move in four directions: diagonal moves are not used",
        "3 cells of water cannot be entered from land",
    ]
    slow = read(files, "grid.map", cell=0.5, speed=0.2)
    assert set(moves(slow).values()) == {3}
    assert slow.states["r3c1"].at == (0.75, 1.75)


def test_a_map_of_the_league_has_stations(tmp_path):
    text = OCTILE.replace("type octile\n", "type octile\r\n").replace("..TWW", "..TES")
    system = read(tmp_path, "kiva.map", text.replace(".@@SW", ".@@.."))
    assert system.labels == {"emitter": ("r2c3",), "service": ("r2c4",)}


def test_all_that_is_wrong_with_a_grid_is_said_at_once(tmp_path):
    text = OCTILE.replace("height 4", "height 7").replace(".@@SW", ".@@S").replace("@....", "@..x.")
    assert refused(tmp_path, "grid.map", text) == [
        "grid.map:2:8: the map has 4 rows, and its height is 7; correct one of them",
        "grid.map:6:1: this row has 4 cells, and the width is 5; correct one of them",
        (
            "grid.map:8:1: 'x' (column 4) is no kind of cell; "
            "known: . G S W E are cells, @ O T are blocked"
        ),
    ]
    wide = refused(tmp_path, "grid.map", OCTILE.replace("width 5", "width five"))
    assert wide[0].startswith("grid.map:3:7: width: 'five' is no whole number")
    assert (
        "the map has no states"
        in refused(tmp_path, "grid.map", "type octile\nheight 1\nwidth 1\nmap\n@\n")[0]
    )


# --- GraphML and node-link JSON ---


def test_a_graph_in_graphml(files):
    system = read(files, "graph.graphml")
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


def test_node_link_json(files):
    system = read(files, "graph.json")
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


# --- occupancy grids ---


def test_an_occupancy_grid_is_one_of_larger_cells(files):
    system = read(files, "room.yaml")
    assert list(system.states) == ["r0c0", "r1c0"]  # 1 m wide, free in all their dots
    assert system.states["r0c0"].at == (-0.5, 3.5)
    assert system.states["r1c0"].at == (-0.5, 2.5)
    assert system.frame == "map"
    assert "2 x 2 cells of 1 m (2 x 2 dots), 2 of them free" in noted(system)[0]
    fine = read(files, "room.yaml", cell=0.5, speed=0.25)
    assert len(fine.states) == 18
    assert set(moves(fine).values()) == {2}
    assert "r1c3" not in fine.states  # black
    assert "r2c2" not in fine.states  # grey: unknown
    assert fine.states["r0c4"].at == (1.25, 3.75)


def test_a_grid_may_be_turned_and_negated(tmp_path):
    (tmp_path / "room.pgm").write_bytes(b"P5 2 1 255\n\x00\xff")
    text = OCCUPANCY.replace("negate: 0", "negate: 1").replace(
        "2.0, 0.0]", "2.0, 1.5707963267948966]"
    )
    system = read(tmp_path, "room.yaml", text, cell=0.5)
    assert list(system.states) == ["r0c0"]
    assert system.states["r0c0"].at == pytest.approx((-1.25, 2.25))


@pytest.mark.parametrize(
    ("picture", "words"),
    [
        (b"P5 2 2 255\n\x00\x00", "not a whole PGM picture: it has 2 of its 4 dots"),
        (b"P5 2 x", "not a whole PGM picture: its height is missing"),
        (b"P2 0 4 255\n", "not a whole PGM picture: it is 0 x 4 with values up to 255"),
        (b"P2 2 1 255\n1 dot", "not a whole PGM picture"),
        (b"hello", "not a picture"),
    ],
)
def test_broken_pictures_are_told_at_their_name(tmp_path, picture, words):
    (tmp_path / "room.pgm").write_bytes(picture)
    said = refused(tmp_path, "room.yaml", OCCUPANCY)
    assert said[0].startswith(f"room.yaml:1:8: the picture 'room.pgm': {words}")


def test_what_is_wrong_with_an_occupancy_grid(files, tmp_path):
    assert (
        "there is no such file" in refused(tmp_path, "o.yaml", OCCUPANCY.replace("room.", "no."))[0]
    )
    text = OCCUPANCY.replace("0.5\n", "0\n").replace("[-1.0, 2.0, 0.0]", "[-1.0]")
    said = refused(tmp_path, "o.yaml", text)
    assert len(said) == 2
    (files / "room.pgm").write_bytes(b"P5 1001 1000 255\n" + b"\xff" * 1_001_000)
    large = refused(files, "room.yaml", OCCUPANCY, cell=0.5)
    assert "room.yaml:2:13: 1,001,000 cells of 0.5 m are more than 1,000,000" in large[0]


def test_pictures_of_all_kinds_are_the_same(tmp_path, monkeypatch):
    image = pytest.importorskip("PIL.Image")
    dots = np.array([[0, 128, 255], [255, 1, 2]], dtype=np.uint8)
    image.fromarray(dots).save(tmp_path / "a.png")
    image.fromarray(dots).save(tmp_path / "a.pgm")
    image.fromarray(dots.astype(np.uint16) * 257).save(tmp_path / "b.png")
    raw = dots.astype(">u2") * np.uint16(257)
    (tmp_path / "b.pgm").write_bytes(b"P5\n3 2\n65535\n" + raw.astype(">u2").tobytes())
    for name in ("a.png", "a.pgm", "b.png", "b.pgm"):
        assert np.allclose(read_grey(tmp_path / name), dots / 255, atol=1e-5), name
    found = builtins.__import__

    def without_pillow(name, *others):
        if name.startswith("PIL"):
            raise ImportError(name)
        return found(name, *others)

    monkeypatch.setattr(builtins, "__import__", without_pillow)
    for name in [name for name in sys.modules if name.startswith("PIL")]:
        monkeypatch.delitem(sys.modules, name)
    (tmp_path / "room.pgm").write_bytes((tmp_path / "a.png").read_bytes())
    said = refused(tmp_path, "room.yaml", OCCUPANCY)
    assert "this is a PNG picture; save it as PGM, or install tsplan[plot]" in said[0]


# --- KTH's state models ---


def test_state_models_are_multiplied(files):
    system = read(files, "models.yaml")
    assert list(system.states) == ["r1|empty", "r1|full", "r2|empty", "r2|full"]
    assert system.states["r2|full"].labels == {"r2", "full"}
    assert system.states["r2|full"].at == (1.0, 1.0)
    assert moves(system) == {
        ("r1|empty", "r2|empty"): 5,
        ("r1|full", "r2|full"): 5,
        ("r2|empty", "r1|empty"): 10,
        ("r2|full", "r1|full"): 10,
        ("r2|empty", "r2|full"): 2,
        ("r1|full", "r1|empty"): 2,
    }
    assert "the robot of the file starts at 'r1|empty'" in noted(system)
    assert moves(read(files, "models.yaml", step=2.0))["r1|empty", "r2|empty"] == 3


def test_all_that_is_wrong_with_state_models_is_said_at_once(tmp_path):
    text = (
        STATE_MODELS.replace('"pick"}', '"pik"}')
        .replace('{r1: "goto_r1"}', '{r9: "goto_r1"}')
        .replace("r1 && !empty || r2 && empty", "F[0,3] r1")
    )
    assert refused(tmp_path, "models.yaml", text) == [
        "models.yaml:10:78: no node of 'region' is called 'r9'; did you mean 'r2'?",
        "models.yaml:15:42: there is no action 'pik'; did you mean 'pick'?",
        "models.yaml:21:49: the guard 'F[0,3] r1' is not made of nodes, !, && and ||; write it so",
    ]
    lost = read(tmp_path, "models.yaml", STATE_MODELS.replace('"load"]', '"lod"]'))
    assert noted(lost)[0] == "there is no state model 'lod', so it is left out"
    assert "it names no state model" in str(
        refused(tmp_path, "models.yaml", STATE_MODELS.replace('["region", "load"]', "[x]"))
    )


# --- LIF ---


def test_a_layout_of_lif(files):
    system = read(files, "plant.lif")
    assert system.name == "plant"
    assert system.states["N2"].labels == {"press", "rack", "S1"}
    assert system.states["N1"].level is None
    assert moves(system) == {
        ("N1", "N2"): ByClass({"lifter": 12, "tugger": 6, "default": 12}),
        ("N2", "N1"): ByClass({"lifter": 6}),
    }
    fast = read(files, "plant.lif", speed={"lifter": 1.0, "default": 4.0})
    assert moves(fast)["N1", "N2"] == ByClass({"lifter": 12, "tugger": 3, "default": 12})
    assert noted(system) == ["an edge has trajectory, which is not planned"]


def test_a_layout_of_two_levels_in_the_second_version(tmp_path):
    def level(name, node, edges):
        properties = [{"mobileRobotTypes": [{"manufacturer": "M", "seriesName": "S"}]}]
        return {
            "originId": f"o{name}",
            "layouts": [
                {
                    "layoutId": f"l{name}",
                    "layoutLevelId": name,
                    "nodes": [{"nodeId": node, "nodePosition": {"x": 0, "y": int(name)}}],
                    "edges": [
                        {
                            "edgeId": one + two,
                            "startNodeId": one,
                            "endNodeId": two,
                            "mobileRobotTypeEdgeProperties": properties,
                        }
                        for one, two in edges
                    ],
                }
            ],
        }

    data = {
        "metaInformation": {"lifId": "x", "lifVersion": "2.0.0"},
        "origins": [level("0", "A", [("A", "B")]), level("3", "B", [("B", "A")])],
    }
    system = read(tmp_path, "two.json", json.dumps(data))
    assert moves(system) == {("A", "B"): 3, ("B", "A"): 3}
    assert (system.states["B"].level, system.states["B"].labels) == ("3", {"3"})


def test_all_that_is_wrong_with_a_layout_is_said_at_once(tmp_path):
    text = (
        LIF.replace('"lifVersion": "1.0.0"', '"lifVersion": "7.1"')
        .replace('"endNodeId": "N1"', '"endNodeId": "N7"')
        .replace('"maxSpeed": 2.0', '"maxSpeed": 0')
        .replace('"interactionNodeIds": [\n      "N2"', '"interactionNodeIds": [\n      "N3"')
    )
    said = refused(tmp_path, "plant.lif", text)
    assert any("4:17: the version 7.1 is not known; known: 0.x, 1.x and 2.x" in w for w in said)
    assert any("no node has the id 'N3'" in words for words in said)
    assert any("no node has the id 'N7'; did you mean 'N2'?" in words for words in said)
    assert any("maxSpeed: '0' should be greater than 0" in words for words in said)


# --- formats of other packages ---


def test_other_packages_add_formats(tmp_path, monkeypatch):
    def read_line(document, path, settings):
        return read_own(parse_document("states: {a: {}, b: {}}", "inner"))

    class Point:
        name = "line"

        def load(self):
            if broken:
                raise ImportError("no module named line")
            return map_files.MapFormat(
                "line",
                lambda document, path: document.at(path) == "a line",
                read_line,
                opens=lambda *_: None,
            )

    def points(group):
        assert group == "tsplan.map_readers"
        return [Point()]

    broken = False
    monkeypatch.setattr(map_files, "entry_points", points)
    map_files.added_formats.cache_clear()
    try:
        assert list(read(tmp_path, "line.txt", "a line\n").states) == ["a", "b"]
        broken = True
        map_files.added_formats.cache_clear()
        assert "the map reader 'line' cannot be loaded: no module" in str(
            refused(tmp_path, "line.txt", "a line\n")
        )
    finally:
        map_files.added_formats.cache_clear()
