"""Tasks for Open-RMF: valid by its schemas, and doing what the plan says."""

from __future__ import annotations

import json
from collections import Counter
from dataclasses import replace
from itertools import groupby

import jsonschema
import pytest

import tsplan
from tests.deliveries import building, site
from tests.exporting import STEP, random_plan, text_of, visits
from tests.module_missions import random_module_mission
from tests.rmf_schemas import ROBOT_TASK_REQUEST
from tests.viewing import mission_on, plan_of
from tsplan import Group, Mission
from tsplan.errors import PlanError
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


def test_nobody_takes_what_is_not_there(tmp_path):
    """What is picked up and dropped off makes the stocks of a planned mission, step by step."""
    mission = Mission.of(
        map=site(),
        team=[Group.of("man", {"yard": 2, "wall": 1}, ["lay"], carries={"brick": 1, "drill": 1})],
        resources=[
            Resource.of("brick", {"yard": 4, "wall": 1}, indivisible=True),
            Resource.of("drill", {"yard": 1}, indivisible=True, consumed=False),
        ],
        formula="F[0,6] T(1,wall,{(lay,1)},{(brick,3),(drill,1)}) "
        "&& F[8,12] T(1,garden,{(lay,1)},{(brick,1),(drill,1)})",
        objective=["haulage", "travel"],
        name="two jobs",
    )
    plan = tsplan.plan(mission)
    lying = Counter({("brick", "yard"): 4, ("brick", "wall"): 1, ("drill", "yard"): 1})
    events = []
    for request in requests(plan, mission, tmp_path):
        step, place = 0, None
        agent = plan.agent[request["robot"]]
        stops = iter(visits(agent))
        for kind, what in activities(request):
            if kind == "go_to_place":
                place, first, last = next(stops)
                assert place == what
            elif kind in ("pickup", "dropoff"):
                assert what["place"] == place
                step, sign = (last, -1) if kind == "pickup" else (first, 1)
                events += [
                    (step, -sign, item["sku"], place, sign * item["quantity"])
                    for item in what["payload"]
                ]
    for done in plan.executions:  # at a step what has come is there, and what leaves is not
        bricks = 3 if "wall" in done.task else 1
        events.append((done.step, 2, "brick", done.state, -bricks))
    assert events
    for step, group in groupby(sorted(events), key=lambda event: event[0]):
        for _, _, resource, state, amount in group:
            lying[resource, state] += amount
            assert lying[resource, state] >= 0, (step, resource, state)
    final = {(line.resource, line.state): line.at(plan.horizon) for line in plan.stocks}
    ended = Counter({(d.task, d.state): 1 for d in plan.executions if d.step == plan.horizon})
    assert not ended
    assert {key: n for key, n in lying.items() if n} == {key: n for key, n in final.items() if n}


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
