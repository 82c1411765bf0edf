"""Planning again from the command line: files, options, what is shown, and what is wrong."""

from __future__ import annotations

import json
from dataclasses import replace

import pytest
import yaml
from jsonschema import Draft202012Validator

import tsplan
from tests.command_line import here
from tests.seeds import sampled

MISSION = """\
format: tsplan-mission/1
name: rounds
map:
  waiting: true
  states:
    base: {labels: [home], at: [0, 0]}
    hall-a: {at: [1, 0]}
    north: {labels: [rooms], at: [1, 1]}
    south: {labels: [rooms], at: [1, -1]}
  edges:
    - {from: base, to: hall-a, duration: 1, both_ways: true}
    - {from: hall-a, to: north, duration: 2, both_ways: true}
    - {from: hall-a, to: south, duration: 2, both_ways: true}
    - {from: north, to: south, duration: 3, both_ways: true}
team: [{class: cart, count: 3, at: base}]
spec: {language: mtl, formula: ["F[0,12] min(rooms) >= 1", "F[14,24] sum(home) >= 2"]}
objective: [availability, travel]
"""
WORLD = """\
format: tsplan-world/1
step: 2
lost: [cart-3]
moved: {cart-1: base, cart-2: {from: hall-a, to: north, arrives: 5}}
closed: [[hall-a, south], {place: [south, hall-a], until: 9}]
capacities: [{place: hall-a, capacity: 2}]
added: [{class: cart, at: south}]
demanded: ["F[0,20] sum(rooms) >= 2"]
withdrawn: ["F[0,12] min(rooms) >= 1"]
deadlines: {"F[14,24] sum(home) >= 2": 26}
"""


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """A folder with a mission, its plan and a world."""
    (tmp_path / "mission.yaml").write_text(MISSION, encoding="utf-8")
    (tmp_path / "world.yaml").write_text(WORLD, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    tsplan.save_plan(tsplan.plan("mission.yaml"), tmp_path / "plan.json")
    return tmp_path


def test_what_happened_is_said_by_options(folder) -> None:
    given = ["replan", "mission.yaml", "plan.json", "--at", "3", "-o", "new.json", "--quiet"]
    done = here(*given, "--late", "cart-2=2", "--lost", "cart-1", "--closed", "hall-a-south@6")
    assert (done.code, done.out, done.err) == (0, "", "")
    made = tsplan.load_plan("new.json")
    (world,) = made.replanned
    assert (world.step, world.lost, world.late) == (3, ("cart-1",), {"cart-2": 2})
    places = {closed.place: closed.until for closed in world.closed}
    assert places == {("hall-a", "south"): 6, ("south", "hall-a"): 6}
    judged = here("check", "mission.yaml", "new.json")
    assert judged.code == 0
    assert judged.out.startswith("what happened before step 3 is taken as the plan tells it")


def test_what_happened_is_said_by_a_file(folder) -> None:
    given = ["mission.yaml", "plan.json", "--world", "world.yaml", "-o", "new.json"]
    done = here("replan", *given, "--rest", "rest.yaml")
    assert done.code == 0
    assert "planned again at step 2: cart-3 lost; cart-1 at base;" in done.out
    made = tsplan.load_plan("new.json")
    assert made.horizon == 26
    assert made.agent["cart-4"].stays[0][::2] == (2, "south")
    assert here("check", "mission.yaml", "new.json").code == 0
    rest = tsplan.load_mission("rest.yaml")
    assert rest.horizon == 24
    assert tsplan.plan(rest).value("travel") == made.value("travel")


def test_the_schema_of_worlds_takes_and_refuses_them() -> None:
    schema = Draft202012Validator(json.loads(here("schema", "world").out))
    good = yaml.safe_load(WORLD)
    assert not [*schema.iter_errors(good)]
    for key, value in {"step": -1, "lost": "cart-1", "closed": [[1]], "gone": []}.items():
        assert [*schema.iter_errors({**good, key: value})], key


def test_it_is_planned_again_again(folder) -> None:
    first = ["replan", "mission.yaml", "plan.json", "--at", "3", "--lost", "cart-3"]
    assert here(*first, "-o", "first.json", "--quiet").code == 0
    second = ["replan", "mission.yaml", "first.json", "--at", "6", "--late", "cart-2=1"]
    assert here(*second, "-o", "second.json", "--quiet").code == 0
    made = tsplan.load_plan("second.json")
    assert [world.step for world in made.replanned] == [3, 6]
    assert here("check", "mission.yaml", "second.json").code == 0
    back = here("replan", "mission.yaml", "second.json", "--at", "4")
    assert (back.code, "replanned at step 6 before" in back.err) == (2, True)


def test_where_nothing_can_be_saved_it_is_said_why(folder) -> None:
    given = ["replan", "mission.yaml", "plan.json", "--at", "13", "--lost", "cart-2,cart-3"]
    done = here(*given, "-o", "new.json")
    assert done.code == 3
    assert "why nothing can be saved (its step 0 is step 13 of the plan):" in done.out
    assert "changes after which there is a plan" in done.out
    assert not (folder / "new.json").exists()


def test_a_part_that_cannot_hold_any_more_is_named(folder) -> None:
    gone = tsplan.replan("mission.yaml", idle_plan(), 14, lost=["cart-1"])
    assert gone.status == "infeasible"
    assert gone.notes == ("cannot hold any more: F[0,12] (min(rooms) >= 1)",)
    assert gone.timings.solve == 0


def idle_plan() -> tsplan.Plan:
    """A plan by which nobody comes to the rooms: as it was, not as it should be."""
    plan = tsplan.load_plan("plan.json")
    stays = ((0, 24, "base"),)
    agents = [replace(agent, stays=stays) for agent in plan.agents]
    return replace(plan, agents=agents, verified=False)


@pytest.mark.parametrize(
    "view", sampled(["page", "paths", "timeline", "requirements"], ["paths", "timeline"])
)
def test_what_happened_is_shown(folder, view: str) -> None:
    pytest.importorskip("matplotlib")
    happened = {"late": {"cart-2": 3}, "withdrawn": ["F[0,12] min(rooms) >= 1"]}
    made = tsplan.replan("mission.yaml", "plan.json", 3, **happened, lost=["cart-3"])
    tsplan.save_plan(made, "new.json")
    given = ["--mission", "mission.yaml", "--view", view, "-o", "new.png"]
    assert here("show", "new.json", *given).code == 0
    assert here("show", "plan.json", "--executed", "new.json", *given).code == 0


def test_what_happened_is_viewed_and_handed_over(folder) -> None:
    happened = {"late": {"cart-2": 3}, "withdrawn": ["F[0,12] min(rooms) >= 1"]}
    made = tsplan.replan("mission.yaml", "plan.json", 3, **happened, lost=["cart-3"])
    tsplan.save_plan(made, "new.json")
    of = ["--mission", "mission.yaml"]
    assert here("view", "new.json", *of, "-o", "new.html").code == 0
    assert here("view", "plan.json", *of, "--executed", "new.json", "-o", "both.html").code == 0
    assert here("show", "new.json", *of, "--why").code == 0
    assert here("export", "new.json", *of, "--to", "csv", "-o", "new.csv").code == 0
    rows = (folder / "new.csv").read_text().splitlines()
    assert len(rows) > 1


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (["--at", "3", "--lost", "cart-9"], "the plan has no agent 'cart-9'"),
        (["--at", "99"], "99"),
        (["--lost", "cart-1"], "add --at STEP"),
        (["--at", "3", "--moved", "cart-1"], "write a name, an equals sign and a value"),
        (["--at", "3", "--moved", "cart-1=mars"], "which the map does not have"),
        (["--at", "3", "--moved", "cart-1=base-north@9@"], "is no place of the map"),
        (["--at", "3", "--closed", "nowhere"], "neither a state nor an edge"),
        (["--at", "3", "--late", "cart-1=soon"], "cart-1: 'soon' is not a whole number"),
        (["--at", "3", "--lost", "cart-1", "--late", "cart-1=1"], "lost and late"),
        (["--at", "3", "--withdraw", "F[0,1] home"], "the mission has no part 'F[0,1] home'"),
        (["--at", "3", "--deadline", "F[14,24] sum(home) >= 2=9"], "before its window begins"),
        (["--at", "3", "--demand", "F[0,1"], "F[0,1"),
        (["--at", "3", "--world", "world.yaml"], "the world is of step 2"),
        (["--at", "3", "--objective", "speed"], "unknown objective 'speed'"),
        (["--at", "3", "-o", "plan.json"], "read by the same command"),
    ],
)
def test_what_is_wrong_is_told(folder, options: list[str], words: str) -> None:
    done = here("replan", "mission.yaml", "plan.json", *options)
    assert done.code == 2, done
    assert words in done.err


def test_a_world_that_is_none_is_told_with_its_places(folder) -> None:
    (folder / "bad.yaml").write_text("step: 2\nlost: cart-1\nclosed: [{until: 3}]\ngone: [x]\n")
    done = here("replan", "mission.yaml", "plan.json", "--world", "bad.yaml")
    assert done.code == 2
    assert "bad.yaml:2:7:" in done.err
    assert "bad.yaml:4:1: unknown key 'gone'" in done.err
    assert "'place' is missing" in done.err


def test_forged_histories_are_refused(folder) -> None:
    mission = tsplan.load_mission("mission.yaml")
    made = tsplan.replan(mission, "plan.json", 3, lost=["cart-3"])
    text = made.to_json()
    for old, new in (
        ('"cart-1"', '"cart-7"'),
        ('[0, 0, "base"]', '[0, 0, "north"]'),
    ):
        if old not in text:
            continue
        forged = tsplan.Plan.from_json(text.replace(old, new))
        assert not tsplan.check(mission, forged).ok, old
