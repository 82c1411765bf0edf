"""Both encodings, with each switch on and off, agree on random missions with all operators."""

from __future__ import annotations

import random
from dataclasses import replace
from functools import cache

import pytest

import tsplan
from tests.seeds import sampled, seed_blocks
from tsplan.encode.agent_classes import map_arrays
from tsplan.encode.switches import Switch
from tsplan.plans.plan import Plan
from tsplan.testing import random_mission

MOST = 20  # maps of which arrays are kept, and some more


def answer(plan: Plan) -> tuple[str, tuple[tuple[str, float | None], ...]]:
    """What must not depend on the encoding."""
    assert plan.status in ("optimal", "infeasible"), plan.status
    assert plan.verified == (plan.status == "optimal")
    for item in plan.objective:
        assert item.value == item.bound or item.value == pytest.approx(item.bound, abs=1e-4)
    rounded = tuple(
        (item.name, None if item.value is None else round(item.value, 4)) for item in plan.objective
    )
    return str(plan.status), rounded


def agree(seed: int) -> None:
    mission = random_mission(seed)
    expected = answer(tsplan.plan(mission, encoding="reference"))
    assert answer(tsplan.plan(mission)) == expected


@pytest.mark.parametrize("seed", sampled(range(2060), range(10)))
def test_tight_and_reference_agree(seed: int) -> None:
    agree(seed)


@cache
def all_switched_on(seed: int) -> tuple[object, ...]:
    return answer(tsplan.plan(random_mission(seed)))


@pytest.mark.parametrize("switch", list(Switch))
@pytest.mark.parametrize(
    "seeds", seed_blocks(range(100, 102), [*range(100, 112), *range(3000, 3200)], 12)
)
def test_switching_a_switch_off_changes_no_answer(switch: Switch, seeds: list[int]) -> None:
    for seed in seeds:
        switched = tsplan.plan(random_mission(seed), without=(switch.value,))
        assert answer(switched) == all_switched_on(seed)


def test_without_any_idea() -> None:
    names = tuple(switch.value for switch in Switch)
    for seed in range(120, 140):
        mission = random_mission(seed)
        assert answer(tsplan.plan(mission, without=names)) == answer(tsplan.plan(mission))


@pytest.mark.parametrize("seeds", seed_blocks(range(12), range(12, 400), 12))
def test_a_map_in_another_order_is_planned_as_well(seeds: list[int]) -> None:
    """Some arrays of maps are kept for longer than others, but always in the same order."""
    for seed in seeds:
        mission, draw = random_mission(seed, states=4, most_agents=4, steps=6), random.Random(seed)
        system = mission.system
        states, edges = (list(each.values()) for each in (system.states, system.edges))
        draw.shuffle(states)
        draw.shuffle(edges)
        other = replace(mission, system=system.rebuilt(states, edges))
        assert other.system == system
        expected = answer(tsplan.plan(mission))
        for number in range(MOST):  # so that the first arrays are forgotten
            map_arrays(replace(system, name=f"map {number}"))
        assert answer(tsplan.plan(other)) == expected, seed
