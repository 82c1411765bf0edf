"""Missions met in part, and preferences, against all joint plans of tiny missions."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from itertools import product
from random import Random

import pytest

import tsplan
from tests.random_missions import random_mission, random_text
from tests.test_brute_force import Path, paths, small_enough, trace, within_capacity
from tsplan import Mission
from tsplan.checking.plan_check import check
from tsplan.logic import CountTrace, holds, horizon, parse
from tsplan.logic.fraction import fraction, tree_of
from tsplan.logic.witness_steps import levels
from tsplan.mission import Preference

ORDERS = ("weighted", "hierarchical", "depth")


def partial_mission(seed: int, order: str) -> Mission:
    """A random mission that may hold in part; most of them cannot hold as a whole."""
    mission = random_mission(seed, states=4, most_agents=3, steps=5)
    return replace(mission, objective=("satisfaction", "travel"), satisfaction=order)


def joint_plans(mission: Mission) -> Iterator[tuple[tuple[Path, ...], CountTrace]]:
    ways = [paths(mission, agent) for agent in mission.agents]
    for joint in product(*ways):
        if within_capacity(mission, joint):
            yield joint, trace(mission, joint)


def compare_satisfaction(seed: int) -> str:
    mission = partial_mission(seed, ORDERS[seed % 3])
    if not small_enough(mission):
        return "too large"
    tree = tree_of(mission.formula)
    worths = []
    whole = False
    for _, counts in joint_plans(mission):
        worth = fraction(mission.formula, counts)
        assert (worth == 1) == bool(holds(mission.formula, counts)[0])
        whole = whole or worth == 1
        worths.append((worth,) if seed % 3 == 0 else levels(tree, counts).counts)
    plan = tsplan.plan(mission)
    if not worths:
        assert plan.status == "infeasible"
        return "infeasible"
    assert plan.status == "optimal", seed
    assert check(mission, plan).ok
    assert plan.satisfaction is not None
    if seed % 3 == 0:
        assert plan.satisfaction.fraction == max(worths)[0]
        assert plan.objective[0].bound == pytest.approx(float(max(worths)[0]))
    else:
        assert tuple(item.value for item in plan.satisfaction.depths) == max(worths)
        if not whole:
            assert tuple(item.bound for item in plan.satisfaction.depths) == max(worths)
    if whole:
        assert (plan.satisfaction.fraction, plan.objective[0].bound) == (1, 1)
        return "whole"
    return "part"


def test_as_much_holds_as_can_hold() -> None:
    seen = [compare_satisfaction(seed) for seed in range(20_000, 20_030)]
    assert seen.count("part") >= 4
    assert seen.count("whole") >= 4


@pytest.mark.long
@pytest.mark.parametrize("block", range(100))
def test_as_much_holds_as_can_hold_on_many(block: int) -> None:
    for seed in range(21_000 + 20 * block, 21_020 + 20 * block):
        compare_satisfaction(seed)


def preferring(seed: int) -> Mission:
    """A random mission with up to four preferences at up to two levels."""
    random = Random(seed)
    mission = random_mission(seed, states=3, most_agents=2, steps=4)
    wishes = []
    while len(wishes) < random.randint(1, 4):
        text = random_text(random, random.randint(0, 2))
        formula = parse(text, "mtl")
        if horizon(formula) <= mission.horizon:
            weight = Fraction(random.choice(["1", "2", "3", "0.5", "0.3"]))
            name, level = f"wish {len(wishes)}", random.choice([0, 0, 1])
            partial = random.random() < 0.4
            wishes.append(Preference(formula, text, weight, name, level, partial))
    return replace(mission, prefer=tuple(wishes), objective=("travel",))


def gains(mission: Mission, counts: CountTrace) -> tuple[Fraction, ...]:
    """What is gained at each level, the highest first."""
    by_level: dict[int, Fraction] = defaultdict(Fraction)
    for wish in mission.prefer:
        share = fraction(wish.formula, counts)
        by_level[wish.level] += wish.weight * (share if wish.partial else share // 1)
    return tuple(by_level[level] for level in sorted(by_level, reverse=True))


def compare_preferences(seed: int) -> str:
    mission = preferring(seed)
    if not small_enough(mission):
        return "too large"
    found = [
        (gains(mission, counts), joint, counts)
        for joint, counts in joint_plans(mission)
        if holds(mission.formula, counts)[0]
    ]
    plan = tsplan.plan(mission)
    if not found:
        assert plan.status == "infeasible"
        return "infeasible"
    assert plan.status == "optimal"
    assert check(mission, plan).ok
    best = max(worth for worth, _, _ in found)
    made: dict[int, Fraction] = defaultdict(Fraction)
    for item in plan.preferences:
        made[item.level] += item.worth
    assert tuple(made[level] for level in sorted(made, reverse=True)) == best, seed
    assert plan.objective[0].value == pytest.approx(float(sum(best)))
    assert plan.objective[0].bound == pytest.approx(float(sum(best)))
    if any(wish.partial for wish in mission.prefer):
        return "partial"
    met = [w.formula for w, item in zip(mission.prefer, plan.preferences, strict=True) if item.met]
    least = min(
        sum(path.travel for path in joint)
        for _, joint, counts in found
        if all(holds(formula, counts)[0] for formula in met)
    )
    assert plan.objective[1].value == least
    return "whole"


def test_preferences_are_met_as_far_as_they_can_be() -> None:
    seen = [compare_preferences(seed) for seed in range(30_000, 30_040)]
    assert seen.count("whole") >= 5
    assert seen.count("partial") >= 5


@pytest.mark.long
@pytest.mark.parametrize("block", range(50))
def test_preferences_are_met_as_far_as_they_can_be_on_many(block: int) -> None:
    for seed in range(31_000 + 20 * block, 31_020 + 20 * block):
        compare_preferences(seed)
