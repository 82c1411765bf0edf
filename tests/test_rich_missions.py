"""Missions with everything mixed: the tight encoding and the reference agree."""

from __future__ import annotations

import pytest

import tsplan
from tests.rich_missions import random_rich_mission
from tests.seeds import seed_blocks
from tsplan.search import stages


@pytest.mark.parametrize("seeds", seed_blocks(range(9), range(2000), 10))
def test_encodings_agree_on_missions_with_everything(seeds: list[int]) -> None:
    for seed in seeds:
        mission = random_rich_mission(seed)
        tight, plain = (tsplan.plan(mission, encoding=name) for name in ("tight", "reference"))
        assert tight.status == plain.status, (seed, mission.text)
        assert tight.status in ("optimal", "infeasible"), (seed, mission.text)
        values = [[item.value for item in plan.objective] for plan in (tight, plain)]
        assert values[0] == pytest.approx(values[1], abs=1e-5), (seed, mission.text)


@pytest.mark.parametrize("seeds", seed_blocks(range(4000, 4005), range(4000, 5000), 10))
def test_straight_ways_cost_no_better_plan_of_anything(monkeypatch, seeds: list[int]) -> None:
    monkeypatch.setattr(stages, "LARGE", -1)
    for seed in seeds:
        mission = random_rich_mission(seed)
        short, whole = (tsplan.plan(mission, without=names) for names in ((), ("straight",)))
        assert short.status == whole.status, (seed, mission.text)
        values = [[item.value for item in plan.objective] for plan in (short, whole)]
        assert values[0] == pytest.approx(values[1], abs=1e-5), (seed, mission.text)
