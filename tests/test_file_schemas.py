"""JSON Schemas: they take every file that the readers take, and refuse nothing that these read."""

from __future__ import annotations

import copy
import json
import random
import re
from functools import cache
from pathlib import Path

import jsonschema
import pytest
import yaml

import tsplan
from tests.command_line import here
from tests.exporting import random_plan
from tests.module_missions import random_module_mission
from tests.rich_missions import random_rich_mission
from tests.slippery import grid_mission
from tsplan.document import parse_document, read_document
from tsplan.document.kinds import kind_of_data
from tsplan.errors import InputError
from tsplan.mission.read import mission_from_text
from tsplan.signals.signal_files import load_any_mission, signal_mission_from_text
from tsplan.starting.file_schemas import SCHEMAS, file_schema
from tsplan.sweeps.sweep_draft import load_sweep
from tsplan.testing import random_mission, random_swarm_mission
from tsplan.testing.random_signals import random_signal_mission
from tsplan.ts.io.map_files import map_from_document
from tsplan.ts.io.tsplan_yaml import map_to_yaml

ROOT = Path(__file__).parents[1]
KINDS = {
    "a mission": "mission",
    "a map": "map",
    "a mission over signals": "signals",
    "a sweep of missions": "sweep",
}
FILES = sorted(
    {*(ROOT / "environments").rglob("*.yaml"), *(ROOT / "tests" / "corpus").glob("*.yaml")}
    - {ROOT / "tests" / "corpus" / "expected.yaml"}
)


@cache
def validator(kind: str) -> jsonschema.Draft202012Validator:
    schema = json.loads(here("schema", kind).out)
    jsonschema.Draft202012Validator.check_schema(schema)
    return jsonschema.Draft202012Validator(schema)


def wrong(kind: str, data: object) -> list[str]:
    """What the schema of a kind says against some data."""
    return [f"{error.json_path}: {error.message}" for error in validator(kind).iter_errors(data)]


def test_every_shipped_file_is_taken():
    kinds = {path: KINDS[kind_of_data(read_document(path).data)] for path in FILES}
    assert set(kinds.values()) == set(KINDS.values())
    assert {p.name: w for p, k in kinds.items() if (w := wrong(k, read_document(p).data))} == {}


@pytest.mark.parametrize("page", sorted((ROOT / "docs").glob("*.md")), ids=lambda page: page.name)
def test_every_whole_file_of_the_pages_is_taken(page):
    blocks = re.findall(r"^```yaml\n(.*?)^```$", page.read_text("utf-8"), re.MULTILINE | re.DOTALL)
    for text in blocks:
        named = re.search(r"^format: tsplan-(mission|signals)/1", text, re.MULTILINE)
        if named and "spec:" in text:
            assert wrong(named[1], parse_document(text, page.name).data) == [], text


MISSION = """
format: tsplan-mission/1
map: {states: {p: {labels: [A]}, q: }, edges: [[p, q, 1], {from: q, to: p, duration: {a: 2}}]}
team: [{class: a, at: p, capabilities: [c]}]
spec: F[0,2] A
"""


def test_short_forms_are_taken():
    plain = parse_document(MISSION, "mission").data
    assert wrong("mission", plain) == []
    area = [[0, 0], [9, 0], [9, 5]]
    others = [
        {"spec": ["F[0,2] A", True], "name": 7},
        {"spec": {"language": "catl", "must": "A", "prefer": [{"formula": ["A"], "weight": 2}]}},
        {"objective": [{"satisfaction": "depth"}, "travel"], "solver": None},
        {"map": "map.yaml"},
        {"map": {"file": "m.geojson", "speed": {"a": 1}, "labels": {"A": 3}, "areas": {"B": area}}},
        {"map": {"file": "m.geojson", "areas": {"B": [{"shape": area, "level": "L1"}]}}},
        {"map": {"nodes": [{"id": 1}], "links": []}},
        {"map": {"states": {"1": None}, "edges": [[1, "1", 2.0]]}},
        {"team": [{"class": 3, "at": {"p": 2}, "carries": 4}, {"class": "b", "at": 1}]},
        {"swarm": {"size": 4, "at": "p"}, "margin": "5 %"},
    ]
    assert {str(new): w for new in others if (w := wrong("mission", {**plain, **new}))} == {}


BROKEN = {
    "mission": [
        {"team": []},
        {"team": [{"class": "a", "at": "p", "colour": "red"}]},
        {"team": [{"class": "a", "at": {"p": 0}}]},
        {"spec": ""},
        {"spec": {"language": "catl"}},
        {"spec": {"language": "ltl", "formula": "A"}},
        {"spec": {"language": "catl", "formula": "A", "must": "A"}},
        {"objective": "travel"},
        {"objective": [{"satisfaction": "most"}]},
        {"map": {"states": {"p": {"label": ["A"]}}}},
        {"map": {"states": {"p": None}, "edges": [["p", "p"]]}},
        {"map": {"file": "m.yaml", "step": 0}},
        {"swarm": {"size": 1, "at": "p"}, "margin": "5"},
        {"min_subswarm": 2},
        {"horizon": -1},
        {"resources": [{"name": "brick", "at": {"p": -1}}]},
        {"format": "tsplan-mission/2"},
        {"sepc": 1},
    ],
    "signals": [
        {"signals": {}},
        {"signals": {"x": [0, 1, 2]}},
        {"signals": {"x": {"low": 0}}},
        {"controls": {"u": "1"}},
        {"dynamics": {"model": "triple-integrator"}},
        {"regions": {"goal": {"x": "all"}}},
    ],
}
WHOLE = {
    "mission": MISSION,
    "signals": "format: tsplan-signals/1\nsignals: {x: [0, 1]}\nspec: x > 0\n",
}


@pytest.mark.parametrize(
    ("kind", "change"), [(kind, change) for kind, changes in BROKEN.items() for change in changes]
)
def test_broken_files_are_refused_as_the_reader_refuses_them(kind, change):
    plain = parse_document(WHOLE[kind], kind).data
    assert wrong(kind, plain) == []
    READERS[kind](yaml.safe_dump(plain), ROOT)
    assert wrong(kind, {**plain, **change})
    with pytest.raises(InputError):
        READERS[kind](yaml.safe_dump({**plain, **change}), ROOT)


@pytest.mark.parametrize(
    "change",
    [
        {"axes": {"seeds": []}},
        {"axes": {"seeds": [-1]}},
        {"axes": {"solver": []}},
        {"repeat": 0},
        {"mission": 3},
        {"runs": [{"seeds": 1}]},
    ],
)
def test_broken_sweeps_are_refused_as_the_reader_refuses_them(change, tmp_path):
    assert here("examples", "office_rules", "-o", str(tmp_path)).code == 0
    path = tmp_path / "sweeps" / "office_rules.yaml"
    load_sweep(path)
    broken = {**read_document(path).data, **change}
    assert wrong("sweep", broken)
    path.write_text(yaml.safe_dump(broken))
    with pytest.raises(InputError):
        load_sweep(path)


READERS = {
    "mission": lambda text, folder: mission_from_text(text, "mission", folder),
    "signals": lambda text, _: signal_mission_from_text(text, "signals"),
    "map": lambda text, _: map_from_document(parse_document(text, "map")),
}
ODD = (None, True, -1, 0, 1, 2.5, "x", "3%", "", [], {}, ["a"], {"a": 1}, [1, 2], 1e30, "2")


def places(data: object, path: tuple = ()) -> list[tuple]:
    """The paths of all values below one."""
    pairs = enumerate(data) if isinstance(data, list) else ()
    pairs = data.items() if isinstance(data, dict) else pairs
    found = [((*path, key), value) for key, value in pairs]
    return [place for way, value in found for place in (way, *places(value, way))]


def changed(data: object, draw: random.Random) -> object:
    """The same with one value replaced, removed, or an unknown key beside it."""
    made = copy.deepcopy(data)
    *way, last = draw.choice(places(made))
    at = made
    for key in way:
        at = at[key]
    how = draw.choice(("set", "set", "remove", "add"))
    if how == "set" or (how == "add" and not isinstance(at, dict)):
        at[last] = copy.deepcopy(draw.choice(ODD))
    elif how == "remove":
        del at[last]
    else:
        at["no such key"] = draw.choice(ODD)
    return made


def refusals(seed: int, count: int) -> tuple[list[str], int]:
    """Changed files that a schema refuses and the reader reads, and how many it refuses."""
    draw, read_all_the_same, refused = random.Random(seed), [], 0
    small = [path for path in FILES if path.stat().st_size < 6000 and path.parent.name != "sweeps"]
    for _ in range(count):
        path = draw.choice(small)
        kind = KINDS[kind_of_data(read_document(path).data)]
        text = yaml.safe_dump(changed(yaml.safe_load(path.read_text("utf-8")), draw))
        found = wrong(kind, parse_document(text, "changed").data)
        refused += bool(found)
        try:
            if found:
                READERS[kind](text, path.parent)
                read_all_the_same.append(f"{path.name}: {found}\n{text}")
        except InputError:
            pass
    return read_all_the_same, refused


def test_what_a_schema_refuses_the_reader_refuses():
    read_all_the_same, refused = refusals(seed=1, count=40)
    assert read_all_the_same == []
    assert refused > 15


@pytest.mark.long
@pytest.mark.parametrize("seed", range(2, 6))
def test_what_a_schema_refuses_the_reader_refuses_on_many(seed):
    read_all_the_same, refused = refusals(seed, count=1000)
    assert read_all_the_same == []
    assert refused > 300


MAKERS = (
    ("mission", random_mission),
    ("mission", random_swarm_mission),
    ("mission", random_rich_mission),
    ("mission", random_module_mission),
    ("signals", random_signal_mission),
)


@pytest.mark.parametrize(("kind", "make"), MAKERS, ids=lambda one: getattr(one, "__name__", one))
def test_missions_are_taken_as_they_are_written(kind, make):
    for seed in range(6):
        text = make(seed).to_yaml()
        assert wrong(kind, parse_document(text, "written").data) == [], text


def test_plans_are_taken_as_they_are_written():
    for seed in range(6):
        mission, plan = random_plan(seed)
        assert wrong("plan", json.loads(plan.to_json())) == []
        assert wrong("map", parse_document(map_to_yaml(mission.system), "map").data) == []


PLANNED = (
    "tests/corpus/team_cost.yaml",
    "tests/corpus/infeasible_time.yaml",
    "tests/corpus/mixed_splits.yaml",
    "tests/corpus/partial_depth.yaml",
    "tests/corpus/partial_weighted.yaml",
    "tests/corpus/preferences_swarm.yaml",
    "environments/site_late.yaml",
    "environments/signals/weights_always.yaml",
)


@pytest.mark.parametrize("name", PLANNED)
def test_every_plan_and_trajectory_is_taken(name):
    mission = load_any_mission(ROOT / name)
    solve = tsplan.plan if isinstance(mission, tsplan.Mission) else tsplan.synthesise
    result = json.loads(solve(mission).to_json())
    kind = result["format"].removeprefix("tsplan-").removesuffix("/1")
    assert wrong(kind, result) == []
    for change in ({"status": "fine"}, {"horizon": -1}, {"format": "tsplan-map/1"}, {"odd": 1}):
        assert wrong(kind, {**result, **change})
    del result["mission"]
    assert wrong(kind, result)


def test_a_trajectory_that_holds_in_part_is_taken():
    text = WHOLE["signals"] + "objective: [{satisfaction: depth}, robustness]\n"
    result = json.loads(tsplan.synthesise(signal_mission_from_text(text)).to_json())
    assert result["depths"]
    assert wrong("trajectory", result) == []
    result["depths"] = [{"depth": 0}]
    assert wrong("trajectory", result)


def test_plans_of_policies_and_bundles_are_taken():
    plan = tsplan.plan(grid_mission(3, 2, "F[0,6] goal"))
    assert plan.policies
    assert wrong("plan", json.loads(plan.to_json())) == []
    agent = {
        "ids": [["a-", 1, 5, 0], ["solo", None, None, 5]],
        "class": "a",
        "stays": [[0, 1, "p"]],
    }
    bundles = {
        "format": "tsplan-plan/1",
        "status": "feasible",
        "stopped_by": "gap",
        "mission": {"name": "", "sha256": ""},
        "horizon": 1,
        "agents": [agent],
        "cargo": [{"agents": ["a-", 1, 5], "step": 0, "resource": "brick", "amount": 2}],
    }
    assert len(tsplan.Plan.from_json(json.dumps(bundles)).agents) == 6
    assert wrong("plan", bundles) == []
    agent["ids"][0][1] = "1"
    assert wrong("plan", bundles)


def test_schemas_say_what_they_are_of_and_know_no_infinite_number():
    for kind in SCHEMAS:
        schema = file_schema(kind)
        assert schema["title"] == f"tsplan {kind}"
        json.dumps(schema, allow_nan=False)
        assert not re.search(r'"(ge|gt|le|lt)":', json.dumps(schema))


@pytest.mark.parametrize("kind", ["mission", "map", "signals", "sweep", "world"])
def test_every_key_that_people_write_is_explained(kind):
    schema = file_schema(kind)
    for name, model in {"": schema, **schema["$defs"]}.items():
        for key, value in model.get("properties", {}).items():
            assert value.get("description"), f"{name}.{key} has no words in key_words.py"


def test_a_schema_is_written_to_a_file(tmp_path):
    assert here("schema", "map", "-o", str(tmp_path / "map.json")).code == 0
    assert (tmp_path / "map.json").read_text("utf-8") == here("schema", "map").out
    assert here("schema", "map", "-o", str(tmp_path / "none" / "map.json")).code == 2
