"""Missions of modular robots: the planner against everything that the modules can do."""

from __future__ import annotations

import pytest

import tsplan
from tests.module_missions import TooManyError, best, random_module_mission, worth
from tests.seeds import seed_blocks


@pytest.mark.parametrize("seeds", seed_blocks(range(40), range(40, 2000), 10))
def test_structures_are_planned_as_well_as_by_trying_everything(seeds: list[int]) -> None:
    for seed in seeds:
        mission = random_module_mission(seed)
        try:
            expected = best(mission)
        except TooManyError:
            continue
        for encoding in ("tight", "reference"):
            plan = tsplan.plan(mission, encoding=encoding)
            if expected is None:
                assert plan.status == "infeasible", (seed, encoding, mission.text)
                continue
            assert plan.status == "optimal", (seed, encoding, mission.text)
            values = {item.name: item.value for item in plan.objective}
            assert worth(mission, values) == pytest.approx(expected, abs=1e-9), (seed, encoding)
            assert tsplan.check(mission, plan).accepted
            assert tsplan.Plan.from_json(plan.to_json()) == plan
