"""Forged plans of modular robots: each is refused, and the message says what is wrong."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

import tsplan
from tests.fence_missions import fence
from tests.refusing import refused
from tsplan.checking.plan_check import check
from tsplan.mission import Mission
from tsplan.plans.plan import Plan
from tsplan.plans.structures import Rebuilt, Structure, module_paths
from tsplan.plans.supplies import Cargo


@pytest.fixture(scope="module")
def mission() -> Mission:
    return fence()


@pytest.fixture(scope="module")
def plan(mission: Mission) -> Plan:
    """single-3..5 become line-1 at the dock at step 0, and that goes to the wall."""
    found = tsplan.plan(mission)
    assert check(mission, found).ok
    assert [each.made for each in found.rebuilt] == [("line-1",)]
    return found


def changed(plan: Plan, name: str, **values: Any) -> Plan:
    """The plan with one structure changed, and the paths of all modules with it."""
    assert any(each.id == name for each in plan.structures)
    made = tuple(replace(each, **values) if each.id == name else each for each in plan.structures)
    return followed(replace(plan, structures=made))


def followed(plan: Plan) -> Plan:
    """The plan with modules where its structures are, so that only these are wrong."""
    paths = module_paths(plan.structures)
    return replace(
        plan,
        agents=tuple(
            replace(agent, stays=paths[agent.id].stays, heading=paths[agent.id].heading)
            if agent.id in paths
            else agent
            for agent in plan.agents
        ),
    )


def rebuilt(plan: Plan, **values: Any) -> Plan:
    (only,) = plan.rebuilt
    return replace(plan, rebuilt=(replace(only, **values),))


def body(plan: Plan, name: str) -> Structure:
    return next(each for each in plan.structures if each.id == name)


def test_a_structure_in_two_places(mission: Mission, plan: Plan) -> None:
    two = ((2, 5, "dock"), (5, 14, "wall"))
    refused(mission, changed(plan, "line-1", stays=two), "structure line-1")
    twice = replace(plan, structures=(*plan.structures, body(plan, "line-1")))
    refused(mission, twice, "structure line-1 is there twice")


def test_a_module_in_two_structures(mission: Mission, plan: Plan) -> None:
    taken = body(plan, "single-1").modules
    refused(mission, changed(plan, "single-2", modules=taken), "module-1 is in 2 structures")
    refused(mission, changed(plan, "single-2", modules=taken), "module-2 is in 0 structures")


def test_a_structure_of_too_few_modules(mission: Mission, plan: Plan) -> None:
    line = body(plan, "line-1")
    few = changed(plan, "line-1", modules=line.modules[:2])
    refused(mission, few, "structure line-1 is a line of 2 modules instead of 3")
    same = changed(plan, "line-1", modules=line.modules[:1] * 3)
    refused(mission, same, "is a line of 1 modules instead of 3")
    strange = changed(plan, "line-1", modules=(*line.modules[:2], "module-9"))
    refused(mission, strange, "is made of module-9, which is no module of the mission")


def test_a_structure_that_is_none(mission: Mission, plan: Plan) -> None:
    refused(mission, changed(plan, "line-1", configuration="row"), "is a 'row', which the mission")
    able = changed(plan, "line-1", capabilities=frozenset({"lift", "drill"}))
    refused(mission, able, "structure line-1 has other capabilities in the mission")
    refused(mission, changed(plan, "line-1", class_name="cube"), "is of class cube, and its modul")
    other = body(plan, "single-2")
    named = replace(
        plan,
        structures=tuple(
            replace(each, id="module-2") if each is other else each for each in plan.structures
        ),
    )
    refused(mission, named, "structure module-2 is called as a module is")


def test_a_structure_that_is_too_quick(mission: Mission, plan: Plan) -> None:
    quick = ((2, 2, "dock"), (4, 4, "lane"), (6, 14, "wall"))  # a line takes 3 steps to the lane
    refused(mission, changed(plan, "line-1", stays=quick), "structure line-1")


def test_a_structure_that_starts_elsewhere(mission: Mission, plan: Plan) -> None:
    there = changed(plan, "single-1", stays=((0, 14, "yard"),))
    refused(mission, there, "structure single-1 starts at yard, and module-1 at dock")
    shape = {"configuration": "line", "capabilities": frozenset({"lift"})}
    three = changed(plan, "single-1", modules=("module-1", "module-3", "module-4"), **shape)
    refused(mission, three, "is there at the start, where module-1 is in a single")


def test_a_reconfiguration_that_is_too_quick(mission: Mission, plan: Plan) -> None:
    stays = ((1, 2, "dock"), *body(plan, "line-1").stays[1:])
    early = changed(plan, "line-1", first=1, stays=stays)
    refused(mission, early, "at step 0 is not there at step 2, when that is done")


def test_a_reconfiguration_at_a_wrong_state(mission: Mission, plan: Plan) -> None:
    refused(mission, rebuilt(plan, state="lane"), "is rebuilt where the mission does not allow")
    refused(mission, rebuilt(plan, state="lane"), "at lane at step 0 has parts that are not there")
    refused(mission, rebuilt(plan, state="moon"), "is rebuilt where the mission does not allow")


def test_a_reconfiguration_of_no_rule(mission: Mission, plan: Plan) -> None:
    words = "follows reconfiguration 7, and the mission has 3"
    refused(mission, rebuilt(plan, rule=7), words)
    refused(mission, rebuilt(plan, rule=1), "goes in as other structures than the mission says")
    refused(mission, rebuilt(plan, rule=1), "comes out as other structures than the mission says")


def test_a_reconfiguration_of_strangers(mission: Mission, plan: Plan) -> None:
    parts = ("single-3", "single-4", "single-77")
    refused(mission, rebuilt(plan, parts=parts), "is of structure single-77, which is not there")
    twice = replace(plan, rebuilt=plan.rebuilt * 2)
    refused(mission, twice, "structure line-1 is made 2 times from others")
    refused(mission, twice, "structure single-3 is rebuilt 2 times")


def test_a_structure_from_nowhere(mission: Mission, plan: Plan) -> None:
    refused(mission, replace(plan, rebuilt=()), "structure line-1 is made 0 times from others")
    refused(mission, replace(plan, rebuilt=()), "structure single-3 is rebuilt 0 times after 0")


def test_other_modules_come_out(mission: Mission, plan: Plan) -> None:
    other = changed(plan, "line-1", modules=("module-1", "module-4", "module-5"))
    refused(mission, other, "has other modules afterwards")


def test_what_is_not_done_and_yet_there_or_done_and_not_there(mission: Mission, plan: Plan) -> None:
    lost = rebuilt(plan, made=())
    refused(mission, lost, "comes out as other structures than the mission says")
    late = Rebuilt(plan.horizon, "dock", 0, ("single-1",))
    ended = replace(plan, rebuilt=(*plan.rebuilt, late))
    refused(mission, ended, f"begins at the end of the plan, {plan.horizon}")


def test_a_structure_that_ends_before_it_is_rebuilt(mission: Mission, plan: Plan) -> None:
    stays = ((0, 3, "dock"),)
    refused(mission, changed(plan, "single-1", last=3, stays=stays), "single-1 is rebuilt 0 times")
    refused(mission, changed(plan, "single-1", last=3), "structure single-1")
    refused(mission, changed(plan, "single-1", last=99), "from step 0 to 99 of 14")


def test_modules_elsewhere_than_their_structures(mission: Mission, plan: Plan) -> None:
    first, *rest = plan.agents
    away = replace(plan, agents=(replace(first, stays=((0, 14, "yard"),)), *rest))
    refused(mission, away, "module-1 is elsewhere than the structures that it is part of")
    gone = replace(plan, structures=(), rebuilt=())
    refused(mission, gone, "module-1 is in 0 structures at the start")


def test_structures_without_modules_in_the_mission(plan: Plan) -> None:
    robots = fence(
        team="[{class: module, count: 5, at: dock, capabilities: [look, lift]}]",
        objective="[travel]",
    )
    own = tsplan.plan(robots)
    forged = replace(own, structures=plan.structures, rebuilt=plan.rebuilt)
    refused(robots, forged, "the plan has structures, and the mission has no modules")


def test_cargo_over_what_a_structure_carries() -> None:
    mission = fence(
        configurations="{single: {modules: 1}, line: {modules: 3, carries: {brick: 2}}}",
        reconfigure="[{from: single, to: line, duration: 2}]",
        resources="[{name: brick, at: {dock: 9}, indivisible: true}]",
        formula="F[0,12] T(0, wall, {}, {(brick, 2)})",
    )
    plan = tsplan.plan(mission)
    assert check(mission, plan).ok
    heavy = tuple(replace(each, amount=3.0) for each in plan.cargo)
    assert all(isinstance(each, Cargo) for each in heavy)
    assert heavy
    refused(mission, replace(plan, cargo=heavy), "line-1", "3")
    single = tuple(replace(each, agent="single-1") for each in plan.cargo)
    refused(mission, replace(plan, cargo=single), "single-1")


def test_wrong_values_of_objectives_are_refused(mission: Mission, plan: Plan) -> None:
    less = tuple(
        replace(item, value=(item.value or 0) - 1) if item.name == "energy" else item
        for item in plan.objective
    )
    refused(mission, replace(plan, objective=less), "energy")
