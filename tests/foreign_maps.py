"""Small maps as other programs write them: the same structure, of our own making."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from tsplan import MapError
from tsplan.ts import TransitionSystem
from tsplan.ts.io.map_files import load_map
from tsplan.ts.io.map_settings import MapSettings

NAV2 = """{
	"type": "FeatureCollection",
	"name": "depot",
	"crs": {"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::3857"}},
	"features": [
		{"type": "Feature", "properties": {"id": 0, "frame": "map", "metadata": {"name": "dock", "charger": true, "lights": 2}}, "geometry": {"type": "Point", "coordinates": [0.0, 0.0]}},
		{"type": "Feature", "properties": {"id": 1, "frame": "map"}, "geometry": {"type": "Point", "coordinates": [3.0, 0.0]}},
		{"type": "Feature", "properties": {"id": 2, "frame": "map", "operations": {"stop": {"type": "stop", "trigger": "NODE", "metadata": {"wait_for": 5.0}}}}, "geometry": {"type": "Point", "coordinates": [3.0, 4.0]}},
		{"type": "Feature", "properties": {"id": 3, "startid": 0, "endid": 1, "cost": 0.0, "overridable": true}, "geometry": {"type": "MultiLineString"}},
		{"type": "Feature", "properties": {"id": 4, "startid": 1, "endid": 0, "metadata": {"abs_speed_limit": 0.25}}, "geometry": {"type": "MultiLineString", "coordinates": []}},
		{"type": "Feature", "properties": {"id": 5, "startid": 1, "endid": 2, "metadata": {"abs_time_taken": 7.5, "penalty": 3}}, "geometry": {"type": "LineString"}},
		{"type": "Feature", "properties": {"id": 6, "startid": 2, "endid": 0, "metadata": {"speed_limit": 50.0}}, "geometry": {"type": "LineString"}},
		{"type": "Feature", "properties": {"id": 7, "startid": 2, "endid": 0, "cost": 99.0, "overridable": false}, "geometry": {"type": "LineString"}},
		{"type": "Feature", "properties": {"id": 8, "startid": 2, "endid": 1}, "geometry": {"type": "LineString"}}
	]
}
"""  # noqa: E501

RMF = """\
building_name: hotel
doors:
  front: {endpoints: [[1, 0], [1, 1]], map: L1}
levels:
  L1:
    lanes:
      - [0, 1, {speed_limit: 0}]
      - [1, 0, {speed_limit: 0.5, orientation_constraint: forward}]
      - [1, 2, {door_name: front, mutex: hall}]
      - [2, 1, {door_name: front, mutex: hall}]
      - [2, 3, {}]
      - [3, 2, {}]
    vertices:
      - [0.0, 0.0, {name: lobby, is_charger: true, is_parking_spot: true}]
      - [1.7, 0.0, {name: ""}]
      - [1.7, 2.0, {name: gate, mutex: hall}]
      - [5.0, 2.0, {name: lift_L1, lift: east}]
  L2:
    vertices:
      - [5.0, 2.05, {name: lift_L2, lift: east}]
      - [9.0, 2.0, {name: suite, is_holding_point: true, pickup_dispenser: minibar}]
      - [9.0, 5.0, {}]
    lanes:
      - [0, 1, {dock_name: bed}]
      - [1, 0, {}]
      - [1, 2]
      - [2, 1]
lifts:
  east: {position: [5.0, 2.0, 0.0], dims: [1.5, 1.5]}
  west: {position: [0.0, 9.0, 0.0], dims: [1.5, 1.5]}
"""

OCTILE = """\
type octile
height 4
width 5
map
.....
.@@SW
..TWW
@....
"""

SCENARIO = """\
version 1
0\tgrid.map\t5\t4\t0\t0\t4\t3\t6.0
0\tgrid.map\t5\t4\t4\t0\t1\t3\t5.5
0\tgrid.map\t5\t4\t2\t3\t0\t2\t3.0
"""

GRAPHML = """\
<?xml version='1.0' encoding='utf-8'?>
<graphml xmlns="http://graphml.graphdrawing.org/xmlns">
  <key id="d0" for="node" attr.name="x" attr.type="double" />
  <key id="d1" for="node" attr.name="y" attr.type="double" />
  <key id="d2" for="node" attr.name="labels" attr.type="string"><default>place</default></key>
  <key id="d3" for="edge" attr.name="weight" attr.type="double" />
  <graph edgedefault="undirected">
    <node id="7"><data key="d0">0.0</data><data key="d1">0.0</data></node>
    <node id="8">
      <data key="d0">3.0</data><data key="d1">4.0</data><data key="d2">goal, far</data>
    </node>
    <node id="9"><data key="d0">3.0</data><data key="d1">0.0</data></node>
    <edge source="7" target="8"><data key="d3">5.5</data></edge>
    <edge source="8" target="9" />
    <edge source="9" target="7" directed="true"><data key="d3">2.0</data></edge>
  </graph>
</graphml>
"""

NODE_LINK = json.dumps(
    {
        "directed": True,
        "multigraph": True,
        "graph": {"name": "yard"},
        "nodes": [
            {"id": "a", "labels": ["start"], "pos": [0, 0]},
            {"id": "b", "labels": ["goal"], "pos": [4, 0], "capacity": 2},
            {"id": 3, "pos": [4, 3]},
        ],
        "links": [
            {"source": "a", "target": "b", "key": 0, "weight": 2.5},
            {"source": "a", "target": "b", "key": 1, "weight": 7},
            {"source": "b", "target": 3, "key": 0, "duration": 4},
            {"source": 3, "target": "a", "key": 0},
        ],
    },
    indent=1,
)

STATE_MODELS = """\
state_dim: ["region", "load"]
state_models:
    region:
        ts_type: "2d_pose_region"
        initial: "r1"
        nodes:
            r1:
                attr: {type: "square", pose: [[0,0], [0]], length: 1}
                connected_to: {r2: "goto_r2"}
            r2: {attr: {type: "station", pose: [[1,1], [0]]}, connected_to: {r1: "goto_r1"}}
    load:
        ts_type: "robot_load"
        initial: "empty"
        nodes:
            empty: {connected_to: {full: "pick"}}
            full: {connected_to: {empty: "drop"}}
actions:
    goto_r1: {type: "move", weight: 10}
    goto_r2: {type: "move", weight: 5, attr: {region: r2}}
    pick: {type: "load_pick", weight: 2, guard: "r2"}
    drop: {type: "load_drop", weight: 2, guard: "r1 && !empty || r2 && empty"}
"""

LIF = json.dumps(
    {
        "metaInformation": {"projectIdentification": "plant", "lifVersion": "1.0.0"},
        "layouts": [
            {
                "layoutId": "hall",
                "layoutLevelId": "0",
                "nodes": [
                    {"nodeId": "N1", "nodePosition": {"x": 0.0, "y": 0.0}},
                    {"nodeId": "N2", "nodeName": "press", "nodePosition": {"x": 6.0, "y": 0.0}},
                ],
                "edges": [
                    {
                        "edgeId": "E1",
                        "startNodeId": "N1",
                        "endNodeId": "N2",
                        "vehicleTypeEdgeProperties": [
                            {
                                "vehicleTypeId": "lifter",
                                "maxSpeed": 0.5,
                                "trajectory": {"degree": 1},
                            },
                            {"vehicleTypeId": "tugger", "maxSpeed": 2.0},
                        ],
                    },
                    {
                        "edgeId": "E2",
                        "startNodeId": "N2",
                        "endNodeId": "N1",
                        "vehicleTypeEdgeProperties": [{"vehicleTypeId": "lifter"}],
                    },
                ],
                "stations": [
                    {"stationId": "S1", "stationName": "rack", "interactionNodeIds": ["N2"]}
                ],
            }
        ],
    },
    indent=1,
)

OCCUPANCY = """\
image: room.pgm
resolution: 0.5
origin: [-1.0, 2.0, 0.0]
negate: 0
occupied_thresh: 0.65
free_thresh: 0.196
"""

ROOM = """\
P2
# four by six dots, the right column is cut off
5 4
255
254 254 254 254 254
254 254 254   0 254
254 254 205 254 254
254 254 254 254 254
"""

MAPS = {
    "nav.geojson": NAV2,
    "rmf.yaml": RMF,
    "grid.map": OCTILE,
    "graph.graphml": GRAPHML,
    "graph.json": NODE_LINK,
    "models.yaml": STATE_MODELS,
    "plant.lif": LIF,
    "room.yaml": OCCUPANCY,
}
"""A map of every format, by the name of its file."""

FILES = {**MAPS, "room.pgm": ROOM, "grid.scen": SCENARIO}
"""The maps, and what belongs to them."""


def read(folder: Path, name: str, text: str | None = None, **said: Any) -> TransitionSystem:
    """The map of a file, which is written first if there is a text."""
    path = folder / name
    if text is not None:
        path.write_text(text)
    return load_map(path, MapSettings(**said))


def refused(folder: Path, name: str, text: str, **said: Any) -> list[str]:
    """The findings of a broken map, without the folder."""
    with pytest.raises(MapError) as caught:
        read(folder, name, text, **said)
    return [str(finding).replace(f"{folder}/", "") for finding in caught.value.findings]


def noted(system: TransitionSystem) -> list[str]:
    """What was dropped or chosen."""
    return [note.message for note in system.notes]


def moves(system: TransitionSystem) -> dict[tuple[str, str], Any]:
    """The durations of all moves."""
    return {pair: edge.duration for pair, edge in system.edges.items() if not edge.is_wait}


def written(
    folder: Path, map_: Any, at: str, formula: str, name: str = "mission.yaml", **more: Any
) -> Path:
    """The file of a mission of one robot."""
    mission = {
        "format": "tsplan-mission/1",
        "map": map_,
        "team": [{"class": "cart", "count": 1, "at": at}],
        "spec": {"language": "mtl", "formula": formula},
        **more,
    }
    path = folder / name
    path.write_text(json.dumps(mission, indent=1))
    return path
