"""Tasks for Open-RMF: valid by its schemas, and doing what the plan says."""

from __future__ import annotations

import json
from collections import Counter
from dataclasses import replace

import jsonschema
import pytest

import tsplan
from tests.deliveries import building, site
from tests.exporting import STEP, random_plan, text_of, visits
from tests.module_missions import random_module_mission
from tests.resource_missions import random_resource_mission
from tests.rmf_schemas import ROBOT_TASK_REQUEST
from tests.viewing import mission_on, plan_of
from tsplan import Group, Mission
from tsplan.errors import PlanError
from tsplan.logic import Task, walk
from tsplan.mission import Resource
from tsplan.plans.supplies import Cargo
from tsplan.ts import State, TransitionSystem

VALIDATOR = jsonschema.Draft202012Validator(ROBOT_TASK_REQUEST)


def requests(plan, system, folder, **given):
    """The requests for the robots, each of them valid."""
    made = json.loads(text_of(plan, "rmf", system, folder, **given))
    for request in made:
        VALIDATOR.validate(request)
    return made


def activities(request):
    """The categories of a request's phases with their descriptions."""
    phases = request["request"]["description"]["phases"]
    return [(each["activity"]["category"], each["activity"]["description"]) for each in phases]


def test_the_schema_refuses_what_rmf_refuses(tmp_path):
    mission, plan = building()
    good, *_ = requests(plan, mission, tmp_path, agents=["man-1"])
    for change in (
        lambda bad: bad.pop("fleet"),
        lambda bad: bad["request"].pop("category"),
        lambda bad: bad["request"]["description"]["phases"][0]["activity"].pop("description"),
        lambda bad: bad["request"]["description"]["phases"][0]["activity"].update(description=-1),
        lambda bad: bad["request"]["description"]["phases"].clear(),
    ):
        bad = json.loads(json.dumps(good))
        change(bad)
        with pytest.raises(jsonschema.ValidationError):
            VALIDATOR.validate(bad)


@pytest.mark.parametrize("seed", range(8))
def test_robots_go_where_the_plan_says_and_wait_as_long(seed, tmp_path):
    mission, plan = random_plan(seed)
    told = requests(plan, mission, tmp_path)
    for agent, request in zip(plan.agents, told, strict=True):
        assert (request["robot"], request["fleet"]) == (agent.id, agent.class_name)
        assert request["request"]["description"]["detail"] == mission.name
        expected = []
        for state, first, last in visits(agent):
            expected.append(("go", mission.system.states[state].origin))
            if last > first:
                expected.append(("wait", first, last))
        done = []
        for category, what in activities(request):
            if category == "go_to_place":
                done.append(("go", what))
                continue
            assert (category, what["category"]) == ("perform_action", "wait")
            when = what["description"]
            done.append(("wait", when["from_step"], when["until_step"]))
            assert (when["from"], when["until"]) == tuple(STEP * step for step in done[-1][1:])
            millis = 1000 * STEP * (when["until_step"] - when["from_step"])
            assert what["unix_millis_action_duration_estimate"] == millis
        if agent.heading is not None:  # what ends after the plan comes last
            place = mission.system.states[agent.heading].origin
            if agent.heading == agent.stays[-1][2]:
                assert done[-1][0] == "wait"
                assert done[-1][2] > plan.horizon
                done.pop()
                if expected[-1][0] == "wait":
                    expected.pop()
            else:
                assert done.pop() == ("go", place)
        assert done == expected


def without_water(mission, plan):
    """The plan of the building site, its cart bringing whole litres."""
    cargo = [replace(item, amount=2.0) if item.resource == "water" else item for item in plan.cargo]
    return replace(plan, cargo=tuple(cargo))


def test_what_is_carried_is_picked_up_and_dropped_off(tmp_path):
    mission, plan = building()
    plan = without_water(mission, plan)
    man, _, cart = requests(plan, site(), tmp_path)
    load = [{"sku": "brick", "quantity": 1}, {"sku": "drill", "quantity": 1}]
    assert [what for what in activities(man) if what[0] != "perform_action"] == [
        ("go_to_place", "yard"),
        ("pickup", {"place": "yard", "payload": load}),
        ("go_to_place", "wall"),
        ("dropoff", {"place": "wall", "payload": load}),
    ]
    water = [{"sku": "water", "quantity": 2}]
    kinds = [
        (kind, what["place"] if kind in ("pickup", "dropoff") else None)
        for kind, what in activities(cart)
    ]
    # the cart waits in the yard, only comes by the wall, and stays in the garden
    assert kinds == [
        ("go_to_place", None),
        ("perform_action", None),
        ("pickup", "yard"),
        ("go_to_place", None),
        ("go_to_place", None),
        ("dropoff", "garden"),
        ("perform_action", None),
    ]
    assert all(what["payload"] == water for kind, what in activities(cart) if kind == "pickup")


@pytest.mark.parametrize("stays", [True, False])
def test_where_a_robot_stays_its_load_is_there_for_all(stays, tmp_path):
    system = site()
    mission = mission_on(system, [Group.of("cart", {"yard": 1})], "F[0,7] garden", 7)
    left = 4 if stays else 3
    plan = plan_of(mission, [(((0, 1, "yard"), (3, left, "wall"), (left + 1, 7, "garden")), None)])
    loads = {1: {"brick": 2.0, "drill": 1.0}, left: {"brick": 3.0, "water": 1.0}}
    cargo = [Cargo("cart-1", step, *load) for step in loads for load in loads[step].items()]
    [request] = requests(replace(plan, cargo=tuple(cargo)), system, tmp_path)
    done = [
        (kind, {item["sku"]: item["quantity"] for item in what["payload"]})
        for kind, what in activities(request)
        if kind in ("pickup", "dropoff") and what["place"] == "wall"
    ]
    if stays:
        assert done == [
            ("dropoff", {"brick": 2, "drill": 1}),
            ("pickup", {"brick": 3, "water": 1}),
        ]
    else:
        assert done == [("dropoff", {"drill": 1}), ("pickup", {"brick": 1, "water": 1})]


def test_parts_of_pieces_are_refused(tmp_path):
    mission, plan = building()
    with pytest.raises(PlanError) as caught:
        text_of(plan, "rmf", mission.system, tmp_path)
    [finding] = caught.value.findings
    assert finding.message == "parts of 'water' are carried, and RMF carries whole pieces"
    men = requests(plan, mission, tmp_path, agents=["man-1", "man-2"])
    assert [request["robot"] for request in men] == ["man-1", "man-2"]


def transfers(plan, mission, folder):
    """What robots drop and what they pick up, by step, resource and state."""
    dropped, taken = Counter(), Counter()
    for request in requests(plan, mission, folder):
        agent = plan.agent[request["robot"]]
        stops = iter(visits(agent))
        for kind, what in activities(request):
            if kind == "go_to_place":
                place, first, last = next(stops, (agent.heading, plan.horizon + 1, None))
                assert place == what
            elif kind in ("pickup", "dropoff"):
                assert what["place"] == place
                for item in what["payload"]:
                    moved, step = (taken, last) if kind == "pickup" else (dropped, first)
                    moved[step, item["sku"], place] += item["quantity"]
    return dropped, taken


def needed(mission, plan):
    """What executions use up, and what tools they hold, by step, resource and state."""
    tasks = {str(node): node for node in walk(mission.formula) if isinstance(node, Task)}
    used_up = {item.name for item in mission.resources if item.consumed}
    used, held = Counter(), Counter()
    for done in plan.executions:
        task = tasks[done.task]
        for resource, amount in task.resources:
            if resource in used_up:
                used[done.step, resource, done.state] += amount
            else:
                steps = range(done.step, done.step + task.duration + 1)
                held.update({(step, resource, done.state): amount for step in steps})
    return used, held


def at_step(amounts, step):
    """The amounts of a step by the rest of their keys."""
    return {tuple(what): amount for (when, *what), amount in amounts.items() if when == step}


def supplied(mission, plan, folder):
    """Nobody takes what is not there, tasks have what they need, and what is left is the plan's."""
    lying = Counter({(item.name, state): n for item in mission.resources for state, n in item.at})
    dropped, taken = transfers(plan, mission, folder)
    used, held = needed(mission, plan)
    for step in range(plan.horizon + 1):
        lying.update(at_step(dropped, step))
        # a tool may leave at the last step at which it is held, what is used up may not
        assert all(lying[what] >= n for what, n in at_step(held, step).items())
        lying.subtract(at_step(taken, step))
        lying.subtract(at_step(used, step))
        assert min(lying.values()) >= 0
    # what is used up or carried away at the last step lies there in the plan
    final = Counter({(line.resource, line.state): line.at(plan.horizon) for line in plan.stocks})
    final.subtract(at_step(used, plan.horizon))
    assert {what: n for what, n in lying.items() if n} == {w: n for w, n in final.items() if n}
    return len(taken)


def two_jobs():
    """Bricks and a drill for a wall, and then the same drill for the garden."""
    return Mission.of(
        map=site(),
        team=[Group.of("man", {"yard": 2, "wall": 1}, ["lay"], carries={"brick": 1, "drill": 1})],
        resources=[
            Resource.of("brick", {"yard": 4, "wall": 1}, indivisible=True),
            Resource.of("drill", {"yard": 1}, indivisible=True, consumed=False),
        ],
        formula="F[0,6] T(1,wall,{(lay,1)},{(brick,3),(drill,1)}) "
        "&& F[8,12] T(1,garden,{(lay,1)},{(brick,1),(drill,1)})",
        objective=["haulage", "travel"],
    )


def test_what_robots_pick_up_and_drop_is_what_tasks_need(tmp_path):
    mission = two_jobs()
    assert supplied(mission, tsplan.plan(mission), tmp_path) >= 3


@pytest.mark.long
def test_the_same_of_random_missions(tmp_path):
    moved = 0
    for seed in range(150):
        mission = random_resource_mission(seed, states=4, robots=4, steps=6, most=4)
        plan = tsplan.plan(mission)
        if plan.has_paths:
            moved += supplied(mission, plan, tmp_path) > 0
    assert moved > 20


def test_waypoints_have_their_original_names_or_numbers(tmp_path):
    origins = {"a": "lounge", "b": 4, "c": None, "d": -1}
    states = [State(name, frozenset({name}), origin=origin) for name, origin in origins.items()]
    edges = [tsplan.Edge(one, two) for one in origins for two in origins]
    system = TransitionSystem.build(states, edges)
    mission = mission_on(system, [Group.of("cart", {"a": 1})], "F[0,3] sum(d) >= 1", 3)
    path = tuple((step, step, name) for step, name in enumerate("abcd"))
    [request] = requests(plan_of(mission, [(path, None)]), mission, tmp_path)
    assert [what for _, what in activities(request)] == ["lounge", 4, "c", "d"]


def test_robots_that_are_built_together_are_refused(tmp_path):
    mission = random_module_mission(1)
    plan = tsplan.plan(mission)
    assert plan.structures
    with pytest.raises(PlanError, match="RMF knows no robots that are"):
        text_of(plan, "rmf", mission, tmp_path)


def test_a_load_is_told_of_its_own_robot_alone(tmp_path):
    mission, plan = building()
    cargo = (Cargo("man-2", 0, "brick", 1.0),)
    first, second, _ = requests(replace(plan, cargo=cargo), mission.system, tmp_path)
    assert "pickup" not in dict(activities(first))
    assert dict(activities(second))["pickup"]["payload"] == [{"sku": "brick", "quantity": 1}]
