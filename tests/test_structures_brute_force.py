"""Missions of modular robots: the planner against everything that the modules can do."""

from __future__ import annotations

from typing import Any

import pytest

import tsplan
from tests.module_missions import TooManyError, best, random_module_mission, worth
from tests.seeds import seed_blocks

PERFORMANCE = {"a": {"one": 1, "duo": 0.5, "trio": 2.5}, "b": {"duo": 2, "trio": 1}}


def compare(seed: int, **others: Any) -> None:
    mission = random_module_mission(seed, **others)
    try:
        expected = best(mission)
    except TooManyError:
        return
    for encoding in ("tight", "reference"):
        plan = tsplan.plan(mission, encoding=encoding)
        if expected is None:
            assert plan.status == "infeasible", (seed, encoding, mission.text)
            continue
        assert plan.status == "optimal", (seed, encoding, mission.text)
        values = {item.name: item.value for item in plan.objective}
        assert worth(mission, values) == pytest.approx(expected, abs=1e-9), (seed, encoding)
        assert tsplan.check(mission, plan).ok
        assert tsplan.Plan.from_json(plan.to_json()) == plan


@pytest.mark.parametrize("seeds", seed_blocks([1, 4, 5], range(2000), 8))
def test_structures_are_planned_as_well_as_by_trying_everything(seeds: list[int]) -> None:
    for seed in seeds:
        compare(seed)


@pytest.mark.parametrize("seeds", seed_blocks(range(3000, 3002), range(3000, 3300), 8))
def test_structures_perform_as_well_as_by_trying_everything(seeds: list[int]) -> None:
    for seed in seeds:
        compare(seed, steps=3, performance=PERFORMANCE)
