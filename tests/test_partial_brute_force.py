"""Missions met in part, and preferences, against all joint plans of tiny missions."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from random import Random

import pytest

import tsplan
from tests.joint_plans import JointPlan, joint_plans, small_enough
from tests.seeds import seed_blocks
from tsplan import Mission
from tsplan.checking.plan_check import check
from tsplan.logic import CountTrace, Formula, holds, horizon, parse
from tsplan.logic.fraction import shares
from tsplan.logic.witness_steps import levels
from tsplan.mission import Preference
from tsplan.testing import random_mission, random_swarm_mission
from tsplan.testing.random_missions import (
    LABELS,
    random_division,
    random_formula,
    without_capabilities,
)

ORDERS = ("weighted", "hierarchical", "depth")


def team_in_part(seed: int) -> Mission:
    """A random mission that may hold in part; most of them cannot hold as a whole."""
    mission = random_mission(seed, states=4, most_agents=3, steps=5)
    return replace(mission, objective=("satisfaction", "travel"), satisfaction=ORDERS[seed % 3])


def rival_text(random: Random) -> str:
    """Parts that swarms of few agents and few sub-swarms cannot all have."""
    parts = [random_division(random), random_formula(random, 1)]
    label = random.choice(LABELS)
    parts.append(random.choice([f"G[1,3] {label}", f"F[0,2] (sum({label}) >= 60%)", f"!{label}"]))
    return " && ".join(f"({part})" for part in random.sample(parts, random.randint(2, 3)))


def short_enough(mission: Mission, text: Callable[[], str]) -> tuple[Formula, str]:
    """The first text that the mission's steps are enough for, as a formula."""
    while True:
        made = text() if len(mission.team) > 1 else without_capabilities(text())
        formula = parse(made, "mtl")
        if horizon(formula) <= mission.horizon:
            return formula, made


def swarms_in_part(seed: int) -> Mission:
    """A tiny mission of swarms that may hold in part; most of them cannot hold as a whole."""
    random = Random(f"in part {seed}")
    mission = random_swarm_mission(seed, fits=small_enough)
    formula, text = short_enough(mission, lambda: rival_text(random))
    objective = ("satisfaction", *mission.objective)
    made = replace(mission, formula=formula, text=text, objective=objective)
    return replace(made, satisfaction=ORDERS[seed % 3])


def wishes(mission: Mission, random: Random, text: Callable[[], str]) -> tuple[Preference, ...]:
    """Up to four preferences at up to two levels."""
    made = []
    while len(made) < random.randint(1, 4):
        formula, said = short_enough(mission, text)
        weight = Fraction(random.choice(["1", "2", "3", "0.5", "0.3"]))
        name, level = f"wish {len(made)}", random.choice([0, 0, 1])
        made.append(Preference(formula, said, weight, name, level, random.random() < 0.4))
    return tuple(made)


def team_preferring(seed: int) -> Mission:
    random = Random(seed)
    mission = random_mission(seed, states=3, most_agents=2, steps=4)
    made = wishes(mission, random, lambda: random_formula(random, random.randint(0, 2)))
    return replace(mission, prefer=made, objective=("travel",))


def swarms_preferring(seed: int) -> Mission:
    random = Random(f"prefer {seed}")
    mission = random_swarm_mission(seed, fits=small_enough)
    made = wishes(mission, random, lambda: random_formula(random, random.randint(0, 2)))
    return replace(mission, prefer=made)


def mixed_in_part(seed: int) -> Mission:
    """Robots and a swarm whose formula may hold in part, with any objectives after that."""
    mission = random_mission(seed, states=4, most_agents=2, steps=4, mixed=True)
    objective = ("satisfaction", *mission.objective)
    return replace(mission, objective=objective, satisfaction=ORDERS[seed % 3])


def mixed_preferring(seed: int) -> Mission:
    random = Random(f"mixed {seed}")
    mission = random_mission(seed, states=3, most_agents=2, steps=4, mixed=True)
    made = wishes(mission, random, lambda: random_formula(random, random.randint(0, 2)))
    return replace(mission, prefer=made)


def share(mission: Mission, formula: Formula, counts: CountTrace) -> Fraction:
    tree = mission.tree(formula)
    return shares(tree, counts)[tree][0].fraction


def compare_satisfaction(mission: Mission) -> str:
    if not small_enough(mission):
        return "too large"
    weighted = mission.satisfaction == "weighted"
    worths = []
    whole = False
    for joint in joint_plans(mission):
        counts = joint.trace()
        worth = share(mission, mission.formula, counts)
        assert (worth == 1) == bool(holds(mission.counted, counts)[0])
        whole = whole or worth == 1
        depths = None if weighted else levels(mission.tree(mission.formula), counts).counts
        worths.append((worth,) if weighted else depths)
    plan = tsplan.plan(mission)
    if not worths:
        assert plan.status == "infeasible"
        return "infeasible"
    assert plan.status == "optimal"
    assert check(mission, plan).ok
    assert plan.satisfaction is not None
    best = max(worths)
    if weighted:
        assert plan.satisfaction.fraction == best[0]
        assert plan.objective[0].bound == pytest.approx(float(best[0]))
    else:
        assert tuple(item.value for item in plan.satisfaction.depths) == best
        if not whole:
            assert tuple(item.bound for item in plan.satisfaction.depths) == best
    if whole:
        assert (plan.satisfaction.fraction, plan.objective[0].bound) == (1, 1)
        return "whole"
    return "part"


def gains(mission: Mission, joint: JointPlan) -> tuple[Fraction, ...]:
    """What is gained at each level, the highest first."""
    by_level: dict[int, Fraction] = defaultdict(Fraction)
    for wish in mission.prefer:
        worth = share(mission, wish.formula, joint.trace())
        by_level[wish.level] += wish.weight * (worth if wish.partial else worth // 1)
    return tuple(by_level[level] for level in sorted(by_level, reverse=True))


def compare_preferences(mission: Mission) -> str:
    if not small_enough(mission):
        return "too large"
    found = [
        (gains(mission, joint), joint)
        for joint in joint_plans(mission)
        if holds(mission.counted, joint.trace())[0]
    ]
    plan = tsplan.plan(mission)
    if not found:
        assert plan.status == "infeasible"
        return "infeasible"
    assert plan.status == "optimal"
    assert check(mission, plan).ok
    best = max(worth for worth, _ in found)
    made: dict[int, Fraction] = defaultdict(Fraction)
    for item in plan.preferences:
        made[item.level] += item.worth
    assert tuple(made[level] for level in sorted(made, reverse=True)) == best
    assert plan.objective[0].value == pytest.approx(float(sum(best)))
    assert plan.objective[0].bound == pytest.approx(float(sum(best)))
    if any(wish.partial for wish in mission.prefer):
        return "partial"
    if mission.objective[1:2] == ("travel",):
        met = [
            wish.formula
            for wish, item in zip(mission.prefer, plan.preferences, strict=True)
            if item.met
        ]
        least = min(
            joint.worth("travel")
            for _, joint in found
            if all(holds(mission.tree(formula), joint.trace())[0] for formula in met)
        )
        assert plan.objective[1].value == least
    return "all" if all(item.met for item in plan.preferences) else "some"


def test_as_much_of_a_team_s_formula_holds_as_can() -> None:
    seen = Counter(compare_satisfaction(team_in_part(seed)) for seed in range(20_000, 20_017))
    assert min(seen["part"], seen["whole"]) >= 4, seen


def test_as_much_of_a_swarm_s_formula_holds_as_can() -> None:
    seen = Counter(compare_satisfaction(swarms_in_part(seed)) for seed in range(40_004, 40_029))
    assert min(seen["part"], seen["whole"]) >= 4, seen


def test_preferences_of_teams_are_met_as_far_as_they_can_be() -> None:
    seen = Counter(compare_preferences(team_preferring(seed)) for seed in range(30_000, 30_040))
    assert seen["all"] + seen["some"] >= 5, seen
    assert seen["partial"] >= 5, seen


def test_preferences_of_swarms_are_met_as_far_as_they_can_be() -> None:
    seen = Counter(compare_preferences(swarms_preferring(seed)) for seed in range(50_000, 50_040))
    assert min(seen["some"], seen["partial"]) >= 2, seen


def test_as_much_of_what_robots_and_a_swarm_are_asked_holds_as_can() -> None:
    seen = Counter(compare_satisfaction(mixed_in_part(seed)) for seed in range(60_000, 60_014))
    assert min(seen["part"], seen["whole"]) >= 3, seen


def test_other_parts_that_hold_have_more_to_spare() -> None:
    mission = mixed_in_part(62_741)
    plan = tsplan.plan(mission)
    assert (plan.objective[1].name, plan.objective[1].value) == ("availability", 2)
    assert plan.objective[1].bound is None or plan.objective[1].bound >= 2


def test_preferences_of_robots_and_a_swarm_are_met_as_far_as_they_can_be() -> None:
    seen = Counter(compare_preferences(mixed_preferring(seed)) for seed in range(60_000, 60_040))
    assert seen["all"] + seen["some"] + seen["partial"] >= 10, seen


@pytest.mark.parametrize(
    "seeds",
    seed_blocks(
        (),
        [
            *range(19_000, 19_040),
            *range(20_000, 20_040),
            *range(21_000, 23_000),
            *range(41_000, 41_060),
        ],
        20,
    ),
)
def test_as_much_holds_as_can_on_many(seeds: list[int]) -> None:
    for seed in seeds:
        compare_satisfaction(team_in_part(seed))
        compare_satisfaction(swarms_in_part(seed + 21_000))
        compare_satisfaction(mixed_in_part(seed + 40_000))


@pytest.mark.parametrize("seeds", seed_blocks((), range(31_000, 32_000), 20))
def test_preferences_are_met_as_far_as_they_can_be_on_many(seeds: list[int]) -> None:
    for seed in seeds:
        compare_preferences(team_preferring(seed))
        compare_preferences(swarms_preferring(seed + 20_000))
        compare_preferences(mixed_preferring(seed + 30_000))
