"""Missions on maps of other programs: speeds, labels by ids and areas, graphs of networkx."""

from __future__ import annotations

import networkx as nx
import numpy as np
import pytest

import tsplan
from tests import foreign_maps
from tests.command_line import ROOT
from tests.foreign_maps import MAPS, NAV2, written
from tsplan import MapError, Mission, MissionError
from tsplan.ts import State, TransitionSystem
from tsplan.ts.edges import ByClass
from tsplan.ts.io.label_areas import within

FILES = foreign_maps.FILES


def refused(path):
    with pytest.raises(MissionError) as caught:
        tsplan.load_mission(path)
    return [str(finding).replace(f"{path.parent}/", "") for finding in caught.value.findings]


MISSIONS = {
    "nav.geojson": ("0", 'F[0,20] "2"', 11),
    "rmf.yaml": ("lobby", "F[0,36] suite", 35),
    "grid.map": ("r0c0", "F[0,9] r3c1", 4),
    "graph.graphml": ("7", "F[0,9] goal", 6),
    "graph.json": ("a", "F[0,9] goal", 3),
    "models.yaml": ('"r1|empty"', "F[0,30] full", 7),
    "plant.lif": ("N1", "F[0,20] rack", 12),
    "room.yaml": ("r0c0", "F[0,9] r1c0", 1),
}


@pytest.mark.parametrize("name", MAPS)
def test_missions_are_planned_on_maps_of_every_format(folder, name):
    at, formula, travel = MISSIONS[name]
    path = written(folder, name, at.strip('"'), formula)
    plan = tsplan.plan(tsplan.load_mission(path))
    assert plan.status == "optimal"
    assert plan.verified
    assert plan.objective[0].value == travel


def test_what_a_mission_says_of_its_map(folder):
    said = {
        "file": "nav.geojson",
        "step": 2.0,
        "speed": {"cart": 0.5, "default": 1},
        "capacity": 1,
        "labels": {"far": [2], "ends": ["0", 2]},
        "areas": {
            "low": [[-1, -1], [4, -1], [4, 1], [-1, 1]],
            "far": [{"shape": [[0, 0], [1, 0], [0, 1]]}, {"shape": [[2, 0], [3, -1], [3, 0]]}],
        },
    }
    system = tsplan.load_mission(written(folder, said, "0", "F[0,30] far")).system
    assert system.step_seconds == 2.0
    assert system.edges["0", "1"].duration == ByClass({"cart": 3, "default": 2})
    labels = {name: system.labels[name] for name in ("far", "ends", "low")}
    assert labels == {"far": ("0", "1", "2"), "ends": ("0", "2"), "low": ("0", "1")}
    assert system.states["0"].capacity == system.edges["0", "1"].capacity == 1
    assert not system.edges["0", "1"].both_ways  # back it takes another time
    made = Mission.of(
        map=said, team=[{"class": "cart", "at": "0"}], language="mtl", formula="F[0,30] far"
    )
    assert made.system == system
    assert tsplan.Mission is Mission


def test_a_capacity_is_shared_by_both_ways_of_a_road(folder):
    said = {"file": "grid.map", "capacity": 1}
    system = tsplan.load_mission(written(folder, said, "r0c0", "F[0,9] r0c1")).system
    assert system.edges["r0c0", "r0c1"].both_ways
    assert (
        len(system.capacity_groups) == len([e for e in system.edges.values() if not e.is_wait]) / 2
    )


def test_all_that_is_wrong_with_what_a_mission_says_is_told_with_its_place(folder):
    said = {
        "file": "nav.geojson",
        "labels": {"far": [2, 9]},
        "areas": {
            "away": [[9, 9], [10, 9], [9, 10]],
            "up": {"shape": [[0, 0], [1, 0], [0, 1]], "level": "L7"},
        },
    }
    told = refused(written(folder, said, "0", "F[0,30] far"))
    assert (
        "mission.yaml:8:5: no state of the map has the name or id '9'; known: 0, 1, 2, dock"
        not in told
    )
    assert any(
        words.startswith("mission.yaml:8:5: no state of the map has the name or id '9'")
        for words in told
    )
    assert any(
        "no state lies in this area of 'away'; its states lie in x 0..3, y 0..4" in w for w in told
    )
    assert any("the map has no level 'L7'" in words for words in told)
    wrong = {
        "file": "nav.geojson",
        "step": 0,
        "speed": {"cart": -1},
        "sped": 1,
        "labels": {"a": 1.5},
    }
    told = refused(written(folder, wrong, "0", "F[0,30] far"))
    for words in (
        "step: '0' should be greater than 0",
        "speed: '-1' is no speed above 0",
        "unknown key 'sped'; did you mean 'speed'?",
        "a: '1.5' is no id of a state",
    ):
        assert any(words in each for each in told), (words, told)


def test_settings_that_mean_nothing_are_refused(folder):
    (folder / "own.yaml").write_text("states: {a: {}, b: {}}\nedges: [[a, b, 2]]\n")
    told = refused(
        written(
            folder, {"file": "own.yaml", "speed": 2, "cell": 1, "waiting": False}, "a", "F[0,3] b"
        )
    )
    assert [w for w in told if "has no meaning for maps of this format" in w] == [
        "mission.yaml:5:12: 'speed' has no meaning for maps of this format; remove it",
        "mission.yaml:6:11: 'cell' has no meaning for maps of this format; remove it",
        "mission.yaml:7:14: 'waiting' has no meaning for maps of this format; remove it",
    ]
    said = {"file": "own.yaml", "step": 3, "waiting": True, "labels": {"B": "b"}}
    system = tsplan.load_mission(written(folder, said, "a", "F[0,3] B")).system
    assert system.step_seconds == 3
    assert ("b", "b") in system.edges
    path = written(folder, {"file": "nav.geojson", "cell": 1}, "0", "F[0,3] dock")
    assert any("'cell' has no meaning" in words for words in refused(path))


def test_what_was_chosen_and_matters_is_a_warning_of_the_mission(folder):
    made = tsplan.load_mission(written(folder, "nav.geojson", "0", "F[0,9] dock"))
    (warning,) = made.warnings
    assert "only the quickest (5 steps) is kept" in warning.message
    assert (warning.source, warning.line) == (str(folder / "nav.geojson"), 12)
    assert len(made.system.notes) == 3


def test_a_broken_or_missing_map_is_told_with_its_mission(folder):
    (folder / "nav.geojson").write_text(NAV2.replace('"endid": 2', '"endid": 22'))
    told = refused(written(folder, {"file": "nav.geojson"}, "0", "F[0,9] dock"))
    assert any(words.startswith("nav.geojson:11:70: no node has the id '22'") for words in told)
    assert any("mission.yaml:3:9: the map cannot be used" in words for words in told)
    told = refused(written(folder, {"file": "nav.geojsn"}, "0", "F[0,9] dock"))
    assert any("there is no such file; did you mean" in words for words in told)


def test_graphs_of_networkx_are_maps_of_missions():
    team = [{"class": "cart", "count": 1, "at": "a"}]
    for kind in (nx.DiGraph, nx.MultiDiGraph, nx.Graph, nx.MultiGraph):
        graph = kind(name="yard")
        graph.add_node("b", label="goal", pos=(np.float64(1), 2))
        graph.add_edge("a", "b", weight="2.5")
        made = Mission.of(map=graph, team=team, language="mtl", formula="F[0,9] goal")
        assert made.system.edges["a", "b"].duration == 3
        assert made.system.states["b"].at == (1, 2)
        plan = tsplan.plan(made)
        assert (plan.status, plan.objective[0].value) == ("optimal", 3)
    graph.add_edge("a", "b", duration="soon")
    with pytest.raises(MapError, match="edge from 'a' to 'b', attribute 'duration'"):
        Mission.of(map=graph, team=team, language="mtl", formula="F[0,9] goal")
    with pytest.raises(MissionError, match="give a TransitionSystem, a networkx graph or the path"):
        Mission.of(map=3, team=team, formula="F[0,9] goal")


def test_a_mission_on_a_graph_warns_of_what_is_lost():
    graph = nx.MultiDiGraph()
    graph.add_edge("a", "b", duration=2)
    graph.add_edge("a", "b", duration=3, cost=0.5)
    team = [{"class": "cart", "count": 1, "at": "a"}]
    made = Mission.of(map=graph, team=team, language="mtl", formula="F[0,9] b")
    assert "only the quickest (2 steps) is kept" in made.warnings[0].message


def test_a_mission_on_a_foreign_map_is_saved_with_its_map(folder):
    made = tsplan.load_mission(
        written(folder, {"file": "rmf.yaml", "step": 2.0}, "lobby", "F[0,60] suite")
    )
    made.save(folder / "own.yaml")
    again = tsplan.load_mission(folder / "own.yaml")
    assert again.system == made.system
    made.save(folder / "two.yaml", map_file="map.yaml")
    assert tsplan.load_mission(folder / "two.yaml").system == made.system


def test_points_in_polygons():
    corners = ((0, 0), (4, 0), (4, 4), (2, 2), (0, 4))  # with a dent
    points = np.array([[1, 1], [2, 3], [2, 2], [3, 3.5], [4, 2], [0, 0], [5, 0], [-1, 4], [2, 1]])
    assert within(points, corners).tolist() == [
        True,
        False,
        True,
        False,
        True,
        True,
        False,
        False,
        True,
    ]
    rng = np.random.default_rng(1)
    cloud = rng.uniform(-1, 5, (500, 2))
    x, y = cloud.T
    square = (x >= 0) & (x <= 4) & (y >= 0) & (y <= 4)
    dent = (y > x) & (y > 4 - x)
    assert (within(cloud, corners) == square & ~dent).all()
    assert (within(cloud, corners[::-1]) == square & ~dent).all()


def test_places_in_own_maps_are_labelled_by_their_shapes(folder):
    (folder / "own.yaml").write_text(
        "states: {a: {shape: [[0, 0], [2, 0], [2, 2], [0, 2]]}, b: {at: [5, 5]}, c: {}}\n"
    )
    said = {"file": "own.yaml", "waiting": True, "areas": {"A": [[0.5, 0.5], [1.5, 0.5], [1, 2]]}}
    assert tsplan.load_mission(written(folder, said, "a", "A")).system.labels["A"] == ("a",)
    bare = TransitionSystem.build([State("a")], [])
    assert bare.step_seconds is None


def test_the_example_of_the_page_is_planned(folder):
    page = (ROOT / "docs" / "maps.md").read_text(encoding="utf-8")
    (folder / "depot.geojson").write_text(NAV2)
    (folder / "page.yaml").write_text(page.partition("```yaml\n")[2].partition("```")[0])
    plan = tsplan.plan(tsplan.load_mission(folder / "page.yaml"))
    assert plan.status == "optimal"
