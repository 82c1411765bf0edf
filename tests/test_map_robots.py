"""Maps of robots' programs: Nav2, Open-RMF, KTH's state models and LIF."""

from __future__ import annotations

import json

from tests import foreign_maps
from tests.foreign_maps import (
    LIF,
    NAV2,
    RMF,
    STATE_MODELS,
    moves,
    noted,
    read,
    refused,
)
from tsplan.draw.layout import places
from tsplan.ts.edges import ByClass

FILES = foreign_maps.FILES


# --- Nav2 ---


def test_a_route_graph_of_nav2(folder):
    system = read(folder, "nav.geojson")
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
    by_class = read(folder, "nav.geojson", step=2.0, speed={"cart": 0.5, "default": 1.0})
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


def test_a_navigation_graph_of_rmf(folder):
    system = read(folder, "rmf.yaml")
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
    assert {pair for pair in system.zone_parts["east"].edges if "lift_L1" in pair} == {
        ("gate", "lift_L1"),
        ("lift_L1", "gate"),
        ("lift_L1", "lift_L2"),
        ("lift_L2", "lift_L1"),
    }
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


def test_levels_are_drawn_side_by_side(folder):
    system = read(folder, "rmf.yaml")
    where = places(system)
    left = max(where[name][0] for name, state in system.states.items() if state.level == "L1")
    right = min(where[name][0] for name, state in system.states.items() if state.level == "L2")
    assert left < right
    assert where["lobby"] == (0.0, 0.0)
    assert places(read(folder, "nav.geojson"))["2"] == (3.0, 4.0)


# --- KTH's state models ---


def test_state_models_are_multiplied(folder):
    system = read(folder, "models.yaml")
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
    assert moves(read(folder, "models.yaml", step=2.0))["r1|empty", "r2|empty"] == 3


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


def test_a_layout_of_lif(folder):
    system = read(folder, "plant.lif")
    assert system.name == "plant"
    assert system.states["N2"].labels == {"press", "rack", "S1"}
    assert system.states["N1"].level is None
    assert moves(system) == {
        ("N1", "N2"): ByClass({"lifter": 12, "tugger": 6, "default": 12}),
        ("N2", "N1"): ByClass({"lifter": 6}),
    }
    fast = read(folder, "plant.lif", speed={"lifter": 1.0, "default": 4.0})
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
