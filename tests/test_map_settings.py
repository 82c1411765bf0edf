"""Missions on maps of other programs: speeds, labels by ids and areas, and the command."""

from __future__ import annotations

import json

import networkx as nx
import numpy as np
import pytest

import tsplan
from tests.command_line import ROOT
from tests.foreign_maps import FILES, GRAPHML, NAV2, OCTILE, ROOM, SCENARIO
from tsplan import MapError, Mission, MissionError
from tsplan.cli import main
from tsplan.ts import State, TransitionSystem
from tsplan.ts.edges import ByClass
from tsplan.ts.io.label_areas import within
from tsplan.ts.io.map_files import load_map


@pytest.fixture
def files(tmp_path, monkeypatch):
    """A folder, where one is, with a file of every format."""
    for name, text in {**FILES, "room.pgm": ROOM, "grid.scen": SCENARIO}.items():
        (tmp_path / name).write_text(text)
    monkeypatch.chdir(tmp_path)
    return tmp_path


def mission(map_, at, formula, **more):
    return {
        "format": "tsplan-mission/1",
        "map": map_,
        "team": [{"class": "cart", "count": 1, "at": at}],
        "spec": {"language": "mtl", "formula": formula},
        **more,
    }


def written(folder, *given, name="mission.yaml", **more):
    path = folder / name
    path.write_text(json.dumps(mission(*given, **more), indent=1))
    return path


def refused(path):
    with pytest.raises(MissionError) as caught:
        tsplan.load_mission(path)
    return [str(finding).replace(f"{path.parent}/", "") for finding in caught.value.findings]


MISSIONS = {
    "nav.geojson": ("0", 'F[0,20] "2"', 11),
    "rmf.yaml": ("lobby", "F[0,60] suite", 35),
    "grid.map": ("r0c0", "F[0,9] r3c1", 4),
    "graph.graphml": ("7", "F[0,9] goal", 6),
    "graph.json": ("a", "F[0,9] goal", 3),
    "models.yaml": ('"r1|empty"', "F[0,30] full", 7),
    "plant.lif": ("N1", "F[0,20] rack", 12),
    "room.yaml": ("r0c0", "F[0,9] r1c0", 1),
}


@pytest.mark.parametrize("name", FILES)
def test_missions_are_planned_on_maps_of_every_format(files, name):
    at, formula, travel = MISSIONS[name]
    path = written(files, name, at.strip('"'), formula)
    plan = tsplan.plan(tsplan.load_mission(path))
    assert plan.status == "optimal"
    assert plan.verified
    assert plan.objective[0].value == travel


def test_what_a_mission_says_of_its_map(files):
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
    system = tsplan.load_mission(written(files, said, "0", "F[0,30] far")).system
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


def test_a_capacity_is_shared_by_both_ways_of_a_road(files):
    said = {"file": "grid.map", "capacity": 1}
    system = tsplan.load_mission(written(files, said, "r0c0", "F[0,9] r0c1")).system
    assert system.edges["r0c0", "r0c1"].both_ways
    assert (
        len(system.capacity_groups) == len([e for e in system.edges.values() if not e.is_wait]) / 2
    )


def test_all_that_is_wrong_with_what_a_mission_says_is_told_with_its_place(files):
    said = {
        "file": "nav.geojson",
        "labels": {"far": [2, 9]},
        "areas": {
            "away": [[9, 9], [10, 9], [9, 10]],
            "up": {"shape": [[0, 0], [1, 0], [0, 1]], "level": "L7"},
        },
    }
    told = refused(written(files, said, "0", "F[0,30] far"))
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
    told = refused(written(files, wrong, "0", "F[0,30] far"))
    for words in (
        "step: '0' should be greater than 0",
        "speed: '-1' is no speed above 0",
        "unknown key 'sped'; did you mean 'speed'?",
        "a: '1.5' is no id of a state",
    ):
        assert any(words in each for each in told), (words, told)


def test_settings_that_mean_nothing_are_refused(files):
    (files / "own.yaml").write_text("states: {a: {}, b: {}}\nedges: [[a, b, 2]]\n")
    told = refused(
        written(
            files, {"file": "own.yaml", "speed": 2, "cell": 1, "waiting": False}, "a", "F[0,3] b"
        )
    )
    assert [w for w in told if "has no meaning for maps of this format" in w] == [
        "mission.yaml:5:12: 'speed' has no meaning for maps of this format; remove it",
        "mission.yaml:6:11: 'cell' has no meaning for maps of this format; remove it",
        "mission.yaml:7:14: 'waiting' has no meaning for maps of this format; remove it",
    ]
    said = {"file": "own.yaml", "step": 3, "waiting": True, "labels": {"B": "b"}}
    system = tsplan.load_mission(written(files, said, "a", "F[0,3] B")).system
    assert system.step_seconds == 3
    assert ("b", "b") in system.edges
    path = written(files, {"file": "nav.geojson", "cell": 1}, "0", "F[0,3] dock")
    assert any("'cell' has no meaning" in words for words in refused(path))


def test_what_was_chosen_and_matters_is_a_warning_of_the_mission(files):
    made = tsplan.load_mission(written(files, "nav.geojson", "0", "F[0,9] dock"))
    (warning,) = made.warnings
    assert "only the quickest (5 steps) is kept" in warning.message
    assert (warning.source, warning.line) == (str(files / "nav.geojson"), 12)
    assert len(made.system.notes) == 3


def test_a_broken_or_missing_map_is_told_with_its_mission(files):
    (files / "nav.geojson").write_text(NAV2.replace('"endid": 2', '"endid": 22'))
    told = refused(written(files, {"file": "nav.geojson"}, "0", "F[0,9] dock"))
    assert any(words.startswith("nav.geojson:11:70: no node has the id '22'") for words in told)
    assert any("mission.yaml:3:9: the map cannot be used" in words for words in told)
    told = refused(written(files, {"file": "nav.geojsn"}, "0", "F[0,9] dock"))
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


def test_a_mission_on_a_foreign_map_is_saved_with_its_map(files):
    made = tsplan.load_mission(
        written(files, {"file": "rmf.yaml", "step": 2.0}, "lobby", "F[0,60] suite")
    )
    made.save(files / "own.yaml")
    again = tsplan.load_mission(files / "own.yaml")
    assert again.system == made.system
    made.save(files / "two.yaml", map_file="map.yaml")
    assert tsplan.load_mission(files / "two.yaml").system == made.system


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


def test_places_in_own_maps_are_labelled_by_their_shapes(files):
    (files / "own.yaml").write_text(
        "states: {a: {shape: [[0, 0], [2, 0], [2, 2], [0, 2]]}, b: {at: [5, 5]}, c: {}}\n"
    )
    said = {"file": "own.yaml", "waiting": True, "areas": {"A": [[0.5, 0.5], [1.5, 0.5], [1, 2]]}}
    assert tsplan.load_mission(written(files, said, "a", "A")).system.labels["A"] == ("a",)
    bare = TransitionSystem.build([State("a")], [])
    assert bare.step_seconds is None


def test_the_example_of_the_page_is_planned(files):
    page = (ROOT / "docs" / "maps.md").read_text(encoding="utf-8")
    (files / "depot.geojson").write_text(NAV2)
    (files / "page.yaml").write_text(page.partition("```yaml\n")[2].partition("```")[0])
    plan = tsplan.plan(tsplan.load_mission(files / "page.yaml"))
    assert plan.status == "optimal"


# --- the command ---


def run(capsys, *arguments):
    code = main([str(each) for each in arguments])
    out, err = capsys.readouterr()
    return code, out, err


def test_the_command_converts_and_says_what_is_dropped(files, capsys):
    code, out, err = run(
        capsys,
        "map",
        "nav.geojson",
        "-o",
        "own.yaml",
        "--step",
        2,
        "--speed",
        "cart=0.5",
        "--speed",
        1,
    )
    assert (code, err) == (0, "")
    assert out.splitlines()[:5] == [
        "nav.geojson: read as nav2, 3 states, 8 edges",
        "  a step takes 2 s",
        "  moves take 2 to 6 steps",
        "  labels: charger (1), dock (1)",
        "dropped or chosen:",
    ]
    assert "  nav.geojson:11:120: an edge has a penalty, which is not used" in out.splitlines()
    own = load_map("own.yaml")
    assert own.edges["0", "1"].duration == ByClass({"cart": 3, "default": 2})
    assert own.states["1"].origin == 1
    assert run(capsys, "map", "own.yaml")[1].startswith("own.yaml: read as tsplan, 3 states")


def test_the_report_for_programs(files, capsys):
    code, out, _ = run(capsys, "map", "rmf.yaml", "--json")
    report = json.loads(out)
    assert code == 0
    assert report["format"] == "tsplan-map-report/1"
    assert (report["read_as"], report["states"]) == ("rmf", 7)
    assert (report["levels"], report["zones"]) == (["L1", "L2"], {"hall": 1, "east": 1})
    assert report["notes"][0]["line"] == 8
    assert report["odd"] == []
    code, out, _ = run(capsys, "map", "rmf.yaml")
    assert "  levels: L1, L2\n  zones: hall (at most 1), east (at most 1)\n" in out


def test_a_map_that_looks_odd_says_so(files, capsys):
    (files / "grid.map").write_text(
        OCTILE.replace(".@@SW", ".@@@.").replace("..TWW", "..TTT").replace(".....", "....@")
    )
    out = run(capsys, "map", "grid.map")[1]
    assert "looks odd:\n" in out
    code, out, err = run(capsys, "map", "grid.map", "--json", "-o", "nowhere/own.yaml")
    assert (code, out) == (2, "")
    assert "cannot write the map: its directory does not exist" in err


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("nav.geojson", "--cell", "2"), "--cell: 'cell' has no meaning for maps of this format"),
        (("none.geojson",), "none.geojson: there is no such file"),
        (("nav.geojson", "-o", "nav.geojson"), "this file is read by the same command"),
        (("nav.geojson", "--step", "0"), "0.0 is not above 0"),
        (("nav.geojson", "--speed", "cart=x"), "'x' is not a number"),
        (("grid.map", "--robots", "2"), "--scenario and --robots need each other"),
    ],
)
def test_wrong_usage_is_told_in_a_line(files, capsys, arguments, words):
    code, out, err = run(capsys, "map", *arguments)
    assert (code, out) == (2, "")
    assert words in err


def test_a_scenario_becomes_a_mission(files, capsys):
    arguments = ("--scenario", "grid.scen", "--robots", 2, "--capacity", 1, "-o", "mission.yaml")
    code, _, _ = run(capsys, "map", "grid.map", *arguments)
    assert code == 0
    made = tsplan.load_mission("mission.yaml")
    assert [group.starts for group in made.team] == [(("r0c0", 1),), (("r0c4", 1),)]
    assert made.system.states["r0c0"].capacity == 1
    plan = tsplan.plan(made)
    assert (plan.status, plan.objective[0].value) == ("optimal", 7 + 8)


def test_what_is_wrong_with_a_scenario(files, capsys):
    (files / "grid.scen").write_text(
        SCENARIO.replace("version 1", "version 9")
        .replace("\t4\t3\t6.0", "\t4\t9\t6.0")
        .replace("\t5.5", "")
    )
    arguments = ("--scenario", "grid.scen", "-o", "mission.yaml", "--robots")
    code, _, err = run(capsys, "map", "grid.map", *arguments, 2)
    assert code == 2
    assert err.splitlines() == [
        "grid.scen:1:1: this is no scenario of version 1; its first line is 'version 1'",
        "grid.scen:2:1: there is no free cell r9c4; name the map of the scenario",
        "grid.scen:3:1: this line has 8 columns; a robot has 9",
    ]
    (files / "grid.scen").write_text(SCENARIO)
    assert (
        "the scenario has 3 robots, and 4 are asked for"
        in run(capsys, "map", "grid.map", *arguments, 4)[2]
    )
    (files / "grid.map").write_text(OCTILE.replace(".@@SW", "@@@@@").replace("..TWW", "..T.."))
    assert "no way leads from r0c0 to r3c4" in run(capsys, "map", "grid.map", *arguments, 1)[2]


def test_maps_of_other_programs_are_linted_and_shown(files, capsys):
    pytest.importorskip("matplotlib")
    for name in FILES:
        code, out, err = run(capsys, "lint", name)
        assert (code in (0, 1), err) == (True, ""), (name, err)
        assert out
        assert run(capsys, "show", name, "-o", "picture.svg")[0] == 0, name


def test_a_map_in_json_is_told_from_a_plan(files, capsys):
    (files / "broken.json").write_text('{"nodes": [}')
    assert run(capsys, "show", "broken.json", "-o", "p.svg")[0] == 2
    (files / "plan.yaml").write_text(GRAPHML)
    code, _, err = run(capsys, "plan", "graph.graphml")
    assert code == 2
    assert "it can be the map of a mission: map: {file: graph.graphml}" in err


def test_missions_that_name_such_maps_are_swept_and_explained(files, capsys):
    written(files, {"file": "nav.geojson", "speed": 1}, "0", 'F[0,20] "2"')
    written(files, "graph.graphml", "7", "F[0,3] goal", name="late.yaml")
    (files / "sweep.yaml").write_text(
        "format: tsplan-sweep/1\nmission: mission.yaml\naxes: {parameters: {map.speed: [1, 2]}}\n"
    )
    assert run(capsys, "sweep", "sweep.yaml", "-o", "out.csv", "--quiet")[0] == 0
    rows = (files / "out.csv").read_text().splitlines()
    assert len(rows) == 3
    assert all("optimal" in row for row in rows[1:])
    (files / "other.yaml").write_text(
        "format: tsplan-sweep/1\nmission: late.yaml\naxes: {seeds: [1]}\n"
    )
    assert run(capsys, "sweep", "other.yaml", "-o", "other.csv", "--quiet")[0] == 0
    (files / "deep").mkdir()
    code, out, _ = run(capsys, "explain", "late.yaml", "--fix", 1, "-o", "deep/fixed.yaml")
    assert code == 0
    assert "extend the deadline" in out
    assert tsplan.plan(tsplan.load_mission(files / "deep" / "fixed.yaml")).status == "optimal"
