"""The command `export`, what it finds beside a plan, and formats that other packages add."""

from __future__ import annotations

import csv
import io
import json
import os
import re
from collections import Counter
from dataclasses import replace
from importlib.metadata import EntryPoint, EntryPoints
from pathlib import Path

import pytest

import tsplan
from tests.command_line import here
from tests.exporting import random_plan, text_of
from tests.missions import MAP, MISSION
from tests.module_missions import random_module_mission
from tests.viewing import plan_of
from tsplan import Group, Mission
from tsplan.errors import InputError
from tsplan.plans.moves import Move
from tsplan.plans.outcomes import MissionRef
from tsplan.plans.plan import Plan
from tsplan.plans.plan_file import save_plan
from tsplan.plans.policies import Choice, Policy
from tsplan.ts.builders import grid
from tsplan.ts.io.map_files import save_map
from tsplan.writers import plan_formats

PLACED = """\
waiting: true
step: 0.1
states:
  p: {labels: [A], at: [1, 2], origin: 4}
  q: {labels: [B], at: [3, 2], origin: 9}
edges: [[p, q, 1], [q, p, 1]]
"""
SWARM = """\
format: tsplan-mission/1
name: many
map: map.yaml
swarm: {size: 1200, at: {p: 1200}}
spec: {language: mtl, formula: "F[0,3] sum(B) >= 700"}
objective: [splits]
"""
FILES = {"map.yaml": MAP, "mission.yaml": MISSION, "placed.yaml": PLACED, "many.yaml": SWARM}


@pytest.fixture
def planned(folder):
    mission = tsplan.load_mission("mission.yaml")
    there_and_back = ((0, 1, "p"), (2, 3, "q"), (4, mission.horizon, "p"))
    save_plan(plan_of(mission, [(there_and_back, None)] * 2), "plan.json")
    return folder


def export(*arguments):
    return here("export", "plan.json", *arguments)


def test_the_mission_is_found_beside_the_plan(planned):
    done = export("--to", "csv", "-o", "plan.csv")
    assert done == (0, "", "")
    plan = tsplan.load_plan("plan.json")
    rows = list(csv.DictReader(io.StringIO(Path("plan.csv").read_text("utf-8"))))
    told = [(row["agent"], int(row["step"]), row["state"]) for row in rows]
    steps = range(plan.horizon + 1)
    assert told == [(a.id, step, a.state_at(step)) for a in plan.agents for step in steps]


def test_without_its_mission_a_plan_does_with_a_map(planned):
    Path("mission.yaml").unlink()
    done = export("--to", "nav2", "-o", "plan.nav2")
    assert done.code == 2
    assert "is in no YAML file beside it" in done.err
    assert export("--to", "nav2", "--map", "placed.yaml", "-o", "plan.nav2") == (0, "", "")
    data = json.loads(Path("plan.nav2").read_text())
    assert (data["step_seconds"], data["robots"][0]["nodes"]) == (0.1, [4, 9, 4])
    told = [(visit["arrive"], visit["leave"]) for visit in data["robots"][0]["visits"]]
    assert told == [(0, 0.1), (0.2, 0.3), (0.4, None)]  # and not 0.30000000000000004


def test_another_map_has_coordinates_and_ids(planned):
    assert export("--to", "geojson", "-o", "plan.geojson").code == 2
    assert not Path("plan.geojson").exists()
    given = ("--to", "geojson", "--map", "placed.yaml", "--agents", "a-2")
    assert export(*given, "-o", "plan.geojson") == (0, "", "")
    [feature] = json.loads(Path("plan.geojson").read_text())["features"]
    assert feature["properties"]["agent"] == "a-2"
    assert feature["geometry"]["coordinates"][0] == [1, 2]


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ("--to cvs -o x", "plans cannot be written as 'cvs'; did you mean 'csv'?"),
        ("--to geojson -o x", "map.yaml: the state 'p' has no coordinates"),
        ("--to nav2 -o x", "map.yaml: the state 'q' has no id of a node"),
        ("--to planviz -o x", "plan.json: the map is no grid"),
        ("--to csv -o x --agents a-1,b-2", "the plan has no agent 'b-2'"),
        ("--to csv -o x --agents ,", "',' names nobody"),
        ("--to csv -o none/x", "none/x: cannot write the export: its directory does not exist"),
        ("--to csv -o plan.json", "plan.json: cannot write the export: this file is read"),
        ("--to csv -o mission.yaml", "mission.yaml: cannot write the export: this file is read"),
        ("--to csv -o map.yaml", "map.yaml: cannot write the export: this file is read"),
        ("--to csv --map placed.yaml -o placed.yaml", "placed.yaml: cannot write the export"),
        ("--to csv --map plan.json -o x", "plan.json"),
        (
            "--to csv --map grid.yaml -o x",
            "plan.json: agent a-1 is at 'p' at step 0, which the map",
        ),
        ("--to csv --mission many.yaml -o x", "plan.json: the mission's team has no class 'a'"),
        ("-o x", "the following arguments are required: --to"),
        ("--to csv", "the following arguments are required: -o"),
    ],
)
def test_what_cannot_be_written_is_told_and_nothing_is(planned, arguments, words):
    save_map(grid(2, 2), "grid.yaml")
    before = {path.name: path.read_bytes() for path in planned.iterdir()}
    done = export(*arguments.split())
    assert (done.code, done.out) == (2, "")
    assert words in done.err
    assert "internal error" not in done.err
    assert {path.name: path.read_bytes() for path in planned.iterdir()} == before


def test_agents_of_swarms_get_their_paths(folder):
    mission = tsplan.load_mission("many.yaml")
    moves = [Move(0, "p", "p", 500), Move(0, "p", "q", 700)]
    moves += [
        Move(step, *ends, n) for step in (1, 2) for *ends, n in (("p", "p", 500), ("q", "q", 700))
    ]
    ref = MissionRef(mission.name, mission.digest)
    plan = Plan("feasible", ref, mission.horizon, "gap", moves={"swarm": tuple(moves)})
    save_plan(plan, "plan.json")
    assert not plan.agents
    assert export("--to", "csv", "-o", "plan.csv") == (0, "", "")
    rows = list(csv.DictReader(io.StringIO(Path("plan.csv").read_text("utf-8"))))
    assert {row["agent"] for row in rows} == {f"swarm-{number}" for number in range(1, 1201)}
    counts = Counter((row["state"], int(row["step"])) for row in rows)
    later = {(state, step): n for state, n in (("p", 500), ("q", 700)) for step in (1, 2, 3)}
    assert counts == {("p", 0): 1200, **later}
    Path("many.yaml").unlink()
    done = export("--to", "csv", "--map", "map.yaml", "-o", "x")
    assert done.code == 2
    assert "has the moves of swarm, and no paths of single agents; name its mission" in done.err


def test_trajectories_and_other_files_are_no_plans(planned):
    Path("plan.json").write_text('{"format": "tsplan-trajectory/1"}')
    done = export("--to", "csv", "-o", "x")
    assert done.code == 2
    assert "this is no plan" in done.err


def test_policies_have_no_paths(tmp_path):
    policy = Policy("cart", frozenset(), (Choice(0, "r0c0", "go", 1.0),), {"r0c0": (2.0, 0.5)})
    plan = Plan("feasible", MissionRef("ice", "0" * 64), 1, "gap", policies=(policy,))
    with pytest.raises(InputError, match="the plan is a policy"):
        text_of(plan, "csv", grid(1, 2), tmp_path)


def test_modules_go_as_their_structures_do(tmp_path):
    mission = random_module_mission(1)
    plan = tsplan.plan(mission)
    assert plan.structures
    for given in (mission, mission.system):
        rows = list(csv.DictReader(io.StringIO(text_of(plan, "csv", given, tmp_path))))
        told = {(row["agent"], int(row["step"])): row["state"] or None for row in rows}
        for step in range(plan.horizon + 1):
            for agent in plan.agents:
                structure = plan.structure_of(agent.id, step)
                expected = None if structure is None else structure.state_at(step)
                assert told[agent.id, step] == expected


def loud(handover):
    """A format of another package."""
    for agent, journey in handover.journeys():
        yield f"{agent.upper()} {len(journey.legs and tuple(journey.legs))}\n"


def test_other_packages_add_formats(planned, monkeypatch):
    found = [
        EntryPoint("loud", f"{__name__}:loud", plan_formats.GROUP),
        EntryPoint("lost", "no_such_module:write", plan_formats.GROUP),
        EntryPoint("csv", f"{__name__}:loud", plan_formats.GROUP),
    ]
    asked = []

    def points(*, group):
        asked.append(group)
        return EntryPoints(found)

    monkeypatch.setattr(plan_formats, "entry_points", points)
    assert export("--to", "loud", "-o", "plan.txt") == (0, "", "")
    assert Path("plan.txt").read_text() == "A-1 2\nA-2 2\n"
    assert set(asked) == {"tsplan.plan_writers"}
    done = export("--to", "lost", "-o", "x")
    assert done.code == 2
    assert "the format 'lost' of no_such_module:write cannot be loaded" in done.err
    assert "did you mean 'loud'?" in export("--to", "lout", "-o", "x").err
    assert export("--to", "csv", "-o", "plan.csv").code == 0  # the package's own comes first
    assert Path("plan.csv").read_text().startswith("agent,step")


def test_a_failure_on_the_way_leaves_the_old_file(planned, monkeypatch):
    def half(handover):
        yield "half"
        raise tsplan.PlanError([tsplan.Finding("no more", "", None)])

    monkeypatch.setattr(plan_formats, "FORMATS", {"half": half})
    Path("x").write_text("old")
    assert export("--to", "half", "-o", "x").code == 2
    assert Path("x").read_text() == "old"
    assert not [path for path in planned.iterdir() if path.name.endswith(".part")]


@pytest.mark.skipif(not Path("/dev/null").exists(), reason="needs devices that are files")
def test_devices_are_written_directly(planned):
    assert export("--to", "csv", "-o", os.devnull) == (0, "", "")
    assert Path(os.devnull).is_char_device()


def test_from_python_the_map_may_be_a_mission_a_map_or_a_file(planned):
    plan, mission = tsplan.load_plan("plan.json"), tsplan.load_mission("mission.yaml")
    texts = {
        text_of(plan, "rmf", given, planned)
        for given in (mission, mission.system, "map.yaml", Path("map.yaml"))
    }
    assert len(texts) == 1
    with pytest.raises(tsplan.PlanError):
        text_of(
            plan,
            "rmf",
            Mission.of(
                map="map.yaml", team=[Group.of("b", {"p": 1})], formula="F[0,1] B", language="mtl"
            ),
            planned,
        )


def test_halves_of_letters_are_escaped(tmp_path):
    mission, plan = random_plan(3)
    odd = replace(plan.agents[0], id="caf\udce9")
    plan = replace(plan, agents=(odd, *plan.agents[1:]))
    request, *_ = json.loads(text_of(plan, "rmf", mission, tmp_path))
    assert request["robot"] == odd.id
    assert text_of(plan, "csv", mission, tmp_path).splitlines()[1].startswith("caf\\udce9,0,")


def test_the_written_plan_and_the_read_one_are_exported_alike(tmp_path):
    mission, plan = random_plan(4)
    save_plan(plan, tmp_path / "plan.json")
    again = tsplan.load_plan(tmp_path / "plan.json")
    for to in ("csv", "geojson", "graphml", "nav2", "rmf"):
        assert text_of(plan, to, mission, tmp_path) == text_of(again, to, mission, tmp_path)


PAGE = (Path(tsplan.__file__).parents[1] / "docs" / "export.md").read_text(encoding="utf-8")


def blocks(language):
    """The blocks of the page in a language."""
    return re.findall(rf"^```{language}\n(.*?)^```$", PAGE, re.MULTILINE | re.DOTALL)


def test_the_page_shows_what_is_written(tmp_path, monkeypatch):
    [shown], [own] = blocks("json"), blocks("yaml")
    hall = "  hall: {at: [4, 7.5], origin: 4}\n"
    (tmp_path / "map.yaml").write_text(f"waiting: true\n{own}{hall}edges: [[dock, hall, 2]]\n")
    mission = Mission.of(
        map=tmp_path / "map.yaml", team=[Group.of("scout", {"dock": 1})], formula="F[0,8] dock"
    )
    plan = plan_of(mission, [(((0, 3, "dock"), (5, 8, "hall")), None)])
    assert json.loads(text_of(plan, "nav2", mission, tmp_path))["robots"] == [json.loads(shown)]
    *_, code = blocks("python")
    named = {}
    exec(code, named)
    monkeypatch.setattr(plan_formats, "FORMATS", {"fleet": named["write"]})
    text = text_of(plan, "fleet", mission, tmp_path)
    assert text == "scout-1 0.0 (2.0, 7.5)\nscout-1 2.5 (4.0, 7.5)\n"


def test_the_page_names_every_format():
    listed = re.findall(r"^\| `(\w+)` \|", PAGE, re.MULTILINE)
    assert listed == list(plan_formats.FORMATS)
    told = here("export", "--help").out
    assert all(name in told for name in plan_formats.FORMATS)
