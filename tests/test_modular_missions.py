"""Missions of modular robots: what does not fit together and where; written and read again."""

from __future__ import annotations

import json

import numpy as np
import pytest

import tsplan
from tests.fence_missions import TEXT, fence
from tests.module_missions import random_module_mission
from tsplan import Mission
from tsplan.errors import MissionError
from tsplan.logic import Execution
from tsplan.mission import Configuration, Group, ModuleRules, Reconfiguration, mission_from_text
from tsplan.mission.performances import Kind, Performances
from tsplan.plans.plan import Plan

OBJECTIVE = "objective: [energy, travel]"
START = "configuration: single}"


def told(text: str) -> list[str]:
    """Everything that is wrong with a mission, each with its place."""
    with pytest.raises(MissionError) as caught:
        mission_from_text(text)
    return [f"{f.line}:{f.column} {f.message}; {f.remedy}" for f in caught.value.findings]


@pytest.mark.parametrize(
    ("old", "new", "place", "words"),
    [
        ("from: single, to: line", "from: singl, to: line", "19:12", "did you mean 'single'?"),
        ("to: {ring: 1}", "to: {rng: 1}", "21:44", "there is no configuration 'rng'"),
        ("at: [dock]", "at: [dok]", "19:59", "no state and no label 'dok'; did you mean 'dock'?"),
        ("single: 1}, to", "single: 2}, to", "21:5", "have 5 modules and 1 'ring' of 4 4; write"),
        ("from: line, to: single", "from: line, to: line", "20:5", "changes nothing; remove it"),
        (START, "configuration: singel}", "23:56", "did you mean 'single'?"),
        (START, "configuration: line}", "23:35", "'line' is made of 3; start a multiple of 3"),
        ("class: module", "class: line", "23:13", "called 'line', as a configuration is"),
        (START, START + "\n  - {class: module, at: yard}", "24:13", "here of robots; add"),
        (START, "configuration: single, carries: 2}", "23:73", "write 'carries' into the conf"),
        ("modules: 3,", "modules: 0,", "16:21", "at least 1"),
        ("modules: 3,", "modules: 2.5,", "16:21", "not a whole number"),
        ("cost: 2.0,", "cost: -2.0,", "16:52", "at least 0"),
        ("duration: 1.5", "duration: 0", "16:67", "more than 0"),
        ("duration: 2, cost: 3.0", "duration: 0, cost: 3.0", "19:40", "at least 1"),
        ("cost: 3.0", "cost: -3", "19:49", "at least 0"),
        ("cost: 3.0", "cost: much", "19:49", "not a finite number"),
        ("{ring: 1}", "{ring: 0}", "21:45", "at least 1"),
        ("drill]", "drill], carries: {brick: 2}", "17:70", "there is no resource 'brick'"),
        (OBJECTIVE, "objective: [performance]", "27:13", "add 'performance: {label: {conf"),
        (OBJECTIVE, "performance: {wal: {line: 1}}", "27:20", "did you mean 'wall'?"),
        (OBJECTIVE, "performance: {wall: {lin: 1}}", "27:27", "did you mean 'line'?"),
        (OBJECTIVE, "performance: {wall: {line: -1}}", "27:28", "at least 0"),
        (OBJECTIVE, "delay: 1", "27:8", "remove the configurations, or plan without delay"),
        (OBJECTIVE, "objective: [delay]", "27:13", "remove the configurations"),
        (OBJECTIVE, "dynamics: expected", "15:3", "leave them out, or drop 'dynamics'"),
        (OBJECTIVE, "swarm: {size: 4, at: dock}", "15:3", "describe the agents as a team"),
        ("  ring: ", "  line: ", "17:3", "the key 'line' appears twice"),
    ],
)
def test_bad_input_has_its_place(old: str, new: str, place: str, words: str) -> None:
    assert old in TEXT
    found = told(TEXT.replace(old, new))
    assert any(line.startswith(f"{place} ") and words in line for line in found), found


def test_capabilities_are_not_missed_where_configurations_cannot_be_read() -> None:
    (only,) = told(TEXT.replace("duration: 1.5", "duration: 0"))
    assert only.startswith("16:67 ")


def test_energy_without_configurations() -> None:
    with pytest.raises(MissionError, match=r"'energy' is about modular robots"):
        Mission.of(map=fence().system, team=[{"class": "a", "at": "dock"}], objective=["energy"])


def test_configurations_without_modules_are_a_warning() -> None:
    mission = mission_from_text(TEXT.replace(START, "capabilities: [look, lift]}"))
    (warning,) = mission.warnings
    assert warning.message.startswith("no class of the team is made of modules")
    assert tsplan.plan(mission).structures == ()


def test_two_configurations_of_one_name() -> None:
    twice = ModuleRules((Configuration("a", 1), Configuration("a", 2)))
    with pytest.raises(MissionError, match="two configurations are called 'a'"):
        Mission(
            **{**vars_of(fence(team="[{class: module, count: 1, at: dock}]")), "modular": twice}
        )


def vars_of(mission: Mission) -> dict[str, object]:
    """The fields that a mission is made of, without objectives."""
    names = (name for name in Mission.__dataclass_fields__)
    return {name: getattr(mission, name) for name in names} | {"objective": ()}


def test_a_mission_is_written_and_made_as_it_is_read() -> None:
    text = TEXT.replace("drill]}", "drill], carries: {brick: 2}}")
    text += "resources: [{name: brick, at: {dock: 2}, indivisible: true}]\n"
    text += "performance: {wall: {line: 1, ring: 3}}\n"
    mission = mission_from_text(text)
    assert mission_from_text(mission.to_yaml()) == mission
    again = Mission.of(
        name="fence",
        map=mission.system,
        resources=mission.resources,
        configurations={
            "single": {"modules": 1, "capabilities": ["look"]},
            "line": Configuration("line", 3, frozenset({"lift"}), 2.0, 1.5),
            "ring": {"modules": 4, "capabilities": ["lift", "drill"], "carries": {"brick": 2}},
        },
        reconfigure=[
            {"from": "single", "to": "line", "duration": 2, "cost": 3.0, "at": ["dock"]},
            Reconfiguration((("line", 1),), (("single", 3),), 1, 1.0),
            {"from": {"line": 1, "single": 1}, "to": {"ring": 1}, "duration": 3, "cost": 4.0},
        ],
        performance={"wall": {"line": 1, "ring": 3}},
        team=[Group.of("module", {"dock": 5}, configuration="single")],
        formula=mission.text,
        objective=["energy", "travel"],
    )
    assert again == mission


@pytest.mark.parametrize("seed", range(12))
def test_random_missions_and_their_plans_are_read_as_they_are_written(seed: int) -> None:
    mission = random_module_mission(seed)
    again = mission_from_text(mission.to_yaml())
    assert (again.modular, again.team, again.formula) == (
        mission.modular,
        mission.team,
        mission.formula,
    )
    plan = tsplan.plan(again)
    assert Plan.from_json(plan.to_json()) == plan
    if plan.has_paths:
        data = json.loads(plan.to_json())
        assert len(data["structures"]) == len(plan.structures)
        assert tsplan.check(again, plan).ok


def test_performance_at_a_label_without_a_task_is_a_warning() -> None:
    mission = mission_from_text(TEXT + "performance: {lane: {line: 1}}\n")
    (warning,) = mission.warnings
    assert warning.message == "the formula asks for no task at 'lane'"
    assert (warning.line, warning.column) == (28, 21)


def test_a_configuration_that_is_named_twice_is_named_once() -> None:
    twice = Reconfiguration((("single", 1), ("single", 2)), (("line", 1),), 2, 3.0, ("dock",))
    mission = fence()
    rules = mission.modular.reconfigurations
    assert twice == rules[0]
    assert {twice: 1}[rules[0]] == 1


def test_who_does_best_serves_each_one_need() -> None:
    rules = ModuleRules(performance=(("wall", (("line", 1.0), ("ring", 2.5), ("mast", 2.0))),))
    task = Execution("", "wall", (("lift", 2), ("drill", 1)), (), 1)
    line = Kind("line", frozenset({"lift"}))
    ring = Kind("ring", frozenset({"lift", "drill"}))
    mast = Kind("mast", frozenset({"drill"}))
    there = {line: [3, 3, 0], ring: [1, 2, 2], mast: [1, 1, 1]}
    done = Performances(rules).done(task, {kind: np.array(n) for kind, n in there.items()})
    # a ring at first, then two: they lift, the mast drills, and lines lift what is left
    assert (done * float(Performances(rules).unit)).tolist() == [2.5 + 2 + 1, 2 * 2.5 + 2]
