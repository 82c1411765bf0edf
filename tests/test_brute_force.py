"""The planner against all joint plans of tiny missions: teams, swarms with their groups, both."""

from __future__ import annotations

from math import inf

import pytest

import tsplan
from tests.joint_plans import SENSE, best, small_enough
from tests.seeds import seed_blocks
from tsplan import Mission
from tsplan.encode.switches import Switch
from tsplan.testing import random_mission, random_swarm_mission
from tsplan.testing.random_missions import SWARM


def small_team(seed: int) -> Mission:
    return random_mission(seed, states=4, most_agents=3, steps=5)


def small_swarms(seed: int) -> Mission:
    return random_swarm_mission(seed, fits=small_enough)


def small_mixed(seed: int) -> Mission:
    return random_mission(seed, states=4, most_agents=2, steps=4, mixed=True)


TIGHT, REFERENCE = {"encoding": "tight"}, {"encoding": "reference"}
PLAIN = {"without": tuple(switch.value for switch in Switch)}


def compare(mission: Mission, *ways: dict[str, object]) -> None:
    expected = best(mission)
    for way in ways:
        plan = tsplan.plan(mission, **way)
        if expected is None:
            assert plan.status == "infeasible"
            continue
        assert plan.status == "optimal"
        assert plan.verified
        for said in (
            [(item.name, item.value) for item in plan.objective],
            [(item.name, item.bound) for item in plan.objective],
        ):
            # availability is infinite where nothing is asked of the agents
            found = tuple(SENSE[name] * (inf if value is None else value) for name, value in said)
            assert found == pytest.approx(expected, abs=1e-6)


@pytest.mark.parametrize(
    "seeds",
    seed_blocks(range(10_000, 10_010), [*range(10_000, 10_080), *range(11_000, 12_000)], 10),
)
def test_teams_do_as_well_as_the_best_of_all_joint_plans(seeds: list[int]) -> None:
    for mission in map(small_team, seeds):
        if small_enough(mission):
            compare(mission, TIGHT, REFERENCE)


@pytest.mark.parametrize(
    "seeds",
    seed_blocks(range(30_000, 30_005), [*range(30_000, 30_120), *range(31_000, 33_000)], 20),
)
def test_swarms_do_as_well_as_the_best_of_all_joint_plans(seeds: list[int]) -> None:
    for mission in map(small_swarms, seeds):
        compare(mission, TIGHT)


@pytest.mark.parametrize(
    "seeds",
    seed_blocks(range(30_200, 30_205), [*range(30_200, 30_240), *range(33_000, 34_000)], 10),
)
def test_swarms_do_as_well_by_the_reference_and_without_ideas(seeds: list[int]) -> None:
    for mission in map(small_swarms, seeds):
        compare(mission, REFERENCE, PLAIN)


@pytest.mark.parametrize(
    "seeds",
    seed_blocks(range(50_000, 50_005), [*range(50_000, 50_120), *range(51_000, 53_000)], 20),
)
def test_robots_and_a_swarm_do_as_well_as_the_best_of_all_joint_plans(seeds: list[int]) -> None:
    for mission in map(small_mixed, seeds):
        if small_enough(mission):
            compare(mission, TIGHT, REFERENCE)


def test_the_enumeration_covers_most_of_the_teams() -> None:
    assert sum(small_enough(small_team(seed)) for seed in range(10_000, 10_080)) >= 40


@pytest.mark.long
def test_the_random_swarms_are_of_all_kinds() -> None:
    plans = [tsplan.plan(small_swarms(seed)) for seed in range(30_000, 30_060)]
    assert sum(plan.status == "infeasible" for plan in plans) >= 5
    values = [item.value for plan in plans for item in plan.objective if item.name == "splits"]
    assert max(value for value in values if value is not None) >= 1


@pytest.mark.long
def test_the_random_mixed_missions_are_of_all_kinds() -> None:
    made = [mission for seed in range(50_000, 50_120) if small_enough(mission := small_mixed(seed))]
    assert len(made) >= 40
    assert all(set(mission.swarm.each) == {SWARM} and len(mission.team) > 1 for mission in made)
    assert sum(f",{SWARM})" in mission.text for mission in made) >= 10
    plans = [tsplan.plan(mission) for mission in made[:20]]
    assert 3 <= sum(plan.status == "infeasible" for plan in plans) <= 15
