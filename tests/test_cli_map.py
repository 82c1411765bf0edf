"""`tsplan map`, and what other commands make of the maps of other programs."""

from __future__ import annotations

import json

import pytest

import tsplan
from tests import foreign_maps
from tests.foreign_maps import GRAPHML, MAPS, OCTILE, SCENARIO, written
from tsplan.cli import main
from tsplan.ts.edges import ByClass
from tsplan.ts.io.map_files import load_map

FILES = foreign_maps.FILES


def run(capsys, *arguments):
    code = main([str(each) for each in arguments])
    out, err = capsys.readouterr()
    return code, out, err


def test_the_command_converts_and_says_what_is_dropped(folder, capsys):
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


def test_the_report_for_programs(folder, capsys):
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


def test_a_map_that_looks_odd_says_so(folder, capsys):
    (folder / "grid.map").write_text(
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
def test_wrong_usage_is_told_in_a_line(folder, capsys, arguments, words):
    code, out, err = run(capsys, "map", *arguments)
    assert (code, out) == (2, "")
    assert words in err


def test_a_scenario_becomes_a_mission(folder, capsys):
    arguments = ("--scenario", "grid.scen", "--robots", 2, "--capacity", 1, "-o", "mission.yaml")
    code, _, _ = run(capsys, "map", "grid.map", *arguments)
    assert code == 0
    made = tsplan.load_mission("mission.yaml")
    assert [group.starts for group in made.team] == [(("r0c0", 1),), (("r0c4", 1),)]
    assert made.system.states["r0c0"].capacity == 1
    plan = tsplan.plan(made)
    assert (plan.status, plan.objective[0].value) == ("optimal", 7 + 8)


def test_what_is_wrong_with_a_scenario(folder, capsys):
    (folder / "grid.scen").write_text(
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
    (folder / "grid.scen").write_text(SCENARIO)
    assert (
        "the scenario has 3 robots, and 4 are asked for"
        in run(capsys, "map", "grid.map", *arguments, 4)[2]
    )
    (folder / "grid.map").write_text(OCTILE.replace(".@@SW", "@@@@@").replace("..TWW", "..T.."))
    assert "no way leads from r0c0 to r3c4" in run(capsys, "map", "grid.map", *arguments, 1)[2]


def test_maps_of_other_programs_are_linted_and_shown(folder, capsys):
    pytest.importorskip("matplotlib")
    for name in MAPS:
        code, out, err = run(capsys, "lint", name)
        assert (code in (0, 1), err) == (True, ""), (name, err)
        assert out
    for name in ("graph.json", "rmf.yaml"):
        assert run(capsys, "show", name, "-o", "picture.svg")[0] == 0, name


def test_a_map_in_json_is_told_from_a_plan(folder, capsys):
    (folder / "broken.json").write_text('{"nodes": [}')
    assert run(capsys, "show", "broken.json", "-o", "p.svg")[0] == 2
    (folder / "plan.yaml").write_text(GRAPHML)
    code, _, err = run(capsys, "plan", "graph.graphml")
    assert code == 2
    assert "it can be the map of a mission: map: {file: graph.graphml}" in err


def test_missions_that_name_such_maps_are_swept_and_explained(folder, capsys):
    written(folder, {"file": "nav.geojson", "speed": 1}, "0", 'F[0,20] "2"')
    written(folder, "graph.graphml", "7", "F[0,3] goal", name="late.yaml")
    (folder / "sweep.yaml").write_text(
        "format: tsplan-sweep/1\nmission: mission.yaml\naxes: {parameters: {map.speed: [1, 2]}}\n"
    )
    assert run(capsys, "sweep", "sweep.yaml", "-o", "out.csv", "--quiet")[0] == 0
    rows = (folder / "out.csv").read_text().splitlines()
    assert len(rows) == 3
    assert all("optimal" in row for row in rows[1:])
    (folder / "other.yaml").write_text(
        "format: tsplan-sweep/1\nmission: late.yaml\naxes: {seeds: [1]}\n"
    )
    assert run(capsys, "sweep", "other.yaml", "-o", "other.csv", "--quiet")[0] == 0
    (folder / "deep").mkdir()
    code, out, _ = run(capsys, "explain", "late.yaml", "--fix", 1, "-o", "deep/fixed.yaml")
    assert code == 0
    assert "extend the deadline" in out
    assert tsplan.plan(tsplan.load_mission(folder / "deep" / "fixed.yaml")).status == "optimal"
