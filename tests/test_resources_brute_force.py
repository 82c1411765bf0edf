"""Missions with resources: the planner against all joint plans with all that can be carried."""

from __future__ import annotations

from math import inf

import pytest

import tsplan
from tests.joint_plans import how_many
from tests.resource_missions import SENSE, best, random_resource_mission
from tests.seeds import seed_blocks
from tsplan import Mission

MOST = 400
"""Joint plans of a mission, each with all that can be done with its resources."""


def signed(mission: Mission, plan: tsplan.Plan) -> tuple[float, ...]:
    values = {item.name: inf if item.value is None else item.value for item in plan.objective}
    return tuple(SENSE[name] * values[name] for name in mission.objective)


def compare(mission: Mission, unit: float) -> None:
    expected = best(mission, unit)
    for encoding in ("tight", "reference"):
        plan = tsplan.plan(mission, encoding=encoding)
        if expected is None:
            assert plan.status == "infeasible", (encoding, mission.text)
            continue
        assert plan.status == "optimal"
        assert plan.verified
        assert signed(mission, plan) == pytest.approx(expected, abs=1e-5), encoding
        assert tsplan.Plan.from_json(plan.to_json()) == plan


@pytest.mark.parametrize("seeds", seed_blocks(range(20, 27), [*range(20), *range(20, 1000)], 10))
def test_whole_pieces_are_planned_as_well_as_by_all_joint_plans(seeds: list[int]) -> None:
    for seed in seeds:
        mission = random_resource_mission(seed, most=2)
        if how_many(mission) <= MOST:
            compare(mission, 1.0)


@pytest.mark.parametrize("seeds", seed_blocks(range(2000, 2003), range(2000, 2500), 10))
def test_any_amounts_are_planned_as_well_as_by_all_joint_plans(seeds: list[int]) -> None:
    for seed in seeds:
        mission = random_resource_mission(seed, most=2, parted=True)
        if how_many(mission) <= MOST:
            compare(mission, 0.5)


@pytest.mark.parametrize("seeds", seed_blocks(range(3010, 3012), range(3010, 3500), 10))
def test_robots_that_cannot_wait_everywhere_are_planned_as_well(seeds: list[int]) -> None:
    for seed in seeds:
        mission = random_resource_mission(seed, most=2, restless=True)
        if how_many(mission) <= MOST:
            compare(mission, 1.0)
