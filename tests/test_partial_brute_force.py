"""Missions met in part, and preferences, against all joint plans of tiny missions."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from math import inf
from random import Random

import pytest

import tsplan
from tests.joint_plans import SENSE, JointPlan, joint_plans, small_enough
from tests.seeds import seed_blocks
from tsplan import Mission
from tsplan.checking.plan_check import check
from tsplan.logic import (
    CountTrace,
    Formula,
    fold,
    holds,
    horizon,
    parse,
    robustness,
    translate,
)
from tsplan.logic.fraction import shares
from tsplan.logic.witness_steps import levels
from tsplan.mission import Group, Preference
from tsplan.plans.plan import Plan
from tsplan.testing import random_mission, random_swarm_mission
from tsplan.testing.random_missions import (
    LABELS,
    random_division,
    random_formula,
    wholly,
    without_capabilities,
)
from tsplan.ts import Edge, State, TransitionSystem

ORDERS = ("weighted", "hierarchical", "depth")


def team_in_part(seed: int) -> Mission:
    """A random mission that may hold in part; most of them cannot hold as a whole."""
    mission = random_mission(seed, states=4, most_agents=3, steps=5)
    others = [("travel",), ("availability", "travel"), ("travel", "availability")][seed // 3 % 3]
    return replace(mission, objective=("satisfaction", *others), satisfaction=ORDERS[seed % 3])


def team_weighing(seed: int) -> Mission:
    """The same with weights at most operators."""
    return weighing(replace(team_in_part(seed), satisfaction="weighted"), seed)


def swarms_weighing(seed: int) -> Mission:
    return weighing(replace(swarms_in_part(seed), satisfaction="weighted"), seed)


def weighing(mission: Mission, seed: int) -> Mission:
    formula = weighed(mission.formula, Random(f"weights {seed}"))
    return replace(mission, formula=formula, text=str(formula), language="wmtl")


def weighed(formula: Formula, random: Random) -> Formula:
    """The formula with weights at most operators; tasks are written out."""

    def given(node: Formula, below: tuple[Formula, ...]) -> Formula:
        made = node.over(below)
        if not hasattr(made, "weights") or random.random() < 0.2:
            return made
        count = made.high - made.low + 1 if hasattr(made, "low") else len(below)
        return replace(made, weights=[random.choice([0.4, 0.6, 1, 2]) for _ in range(count)])

    return fold(translate(formula), given)


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
    objective = ("availability", "travel") if seed % 3 == 0 else ("travel",)
    return replace(mission, prefer=made, objective=objective)


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


def with_wholes(mission: Mission, seed: int) -> Mission:
    """The same mission, some of whose parts that may hold in part count as a whole."""
    random = Random(f"as a whole {seed}")
    formula = wholly(random, mission.formula)
    prefer = [replace(wish, formula=wholly(random, wish.formula)) for wish in mission.prefer]
    return replace(mission, formula=formula, text=str(formula), prefer=tuple(prefer))


def share(mission: Mission, formula: Formula, counts: CountTrace) -> Fraction:
    tree = mission.tree(formula)
    return shares(tree, counts, weighted=True)[tree][0].fraction


def spare(mission: Mission, counts: CountTrace) -> float:
    """The least robustness of what a plan is worth something for."""
    tree = mission.tree(mission.formula)
    shared = shares(tree, counts, weighted=True)
    if mission.satisfaction == "weighted":
        return shared[tree][0].spare
    held = levels(tree, counts).pairs
    return min((shared[node][step].spare for node, step in held), default=inf)


def judge_availability(mission: Mission, plan: Plan, best: list[tuple[JointPlan, float]]) -> None:
    """None of the best joint plans has more to spare and is as good in what comes before.

    Other objectives are best for the parts that were chosen, so they are taken as they are.
    """
    names = mission.objective[: mission.objective.index("availability") + 1]
    before = [
        (item.name, SENSE[item.name] * item.value) for item in plan.objective[1 : len(names) - 1]
    ]
    found = [
        free
        for joint, free in best
        if all(SENSE[name] * joint.worth(name) <= value + 1e-6 for name, value in before)
    ]
    item = plan.objective[len(names) - 1]
    assert max(found) == (inf if item.value is None else item.value)
    assert item.bound == item.value


def compare_satisfaction(mission: Mission) -> str:
    if not small_enough(mission):
        return "too large"
    weighted = mission.satisfaction == "weighted"
    worths = []
    joints = []
    whole = False
    for joint in joint_plans(mission):
        counts = joint.trace()
        worth = share(mission, mission.formula, counts)
        if mission.language != "wmtl":
            assert (worth == 1) == bool(holds(mission.counted, counts)[0])
        whole = whole or worth == 1
        depths = None if weighted else levels(mission.tree(mission.formula), counts).counts
        worths.append((worth,) if weighted else depths)
        joints.append((joint, spare(mission, counts)))
    plan = tsplan.plan(mission)
    if not worths:
        assert plan.status == "infeasible"
        return "infeasible"
    assert plan.status == "optimal"
    assert check(mission, plan).ok
    assert plan.satisfaction is not None
    best = max(worths)
    if weighted:
        assert plan.satisfaction.worth == best[0]
        assert plan.objective[0].value == pytest.approx(float(best[0]))
        assert plan.objective[0].bound == pytest.approx(float(best[0]))
    else:
        assert tuple(item.value for item in plan.satisfaction.depths) == best
        if not whole:
            assert tuple(item.bound for item in plan.satisfaction.depths) == best
    if "availability" in mission.objective:
        equals = zip(joints, worths, strict=True)
        judge_availability(mission, plan, [made for made, worth in equals if worth == best])
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


def spare_at_preferences(mission: Mission, counts: CountTrace) -> float:
    """The least robustness of what must hold, and of the preferences that do."""
    least = float(robustness(mission.counted, counts)[0])
    for wish in mission.prefer:
        tree = mission.tree(wish.formula)
        found = shares(tree, counts)[tree][0]
        if wish.partial or found.fraction == 1:
            least = min(least, found.spare)
    return least


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
    if "availability" in mission.objective:
        equals = [
            (joint, spare_at_preferences(mission, joint.trace()))
            for worth, joint in found
            if worth == best
        ]
        judge_availability(mission, plan, equals)
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


def test_as_much_of_a_team_s_weights_as_can() -> None:
    seen = Counter(compare_satisfaction(team_weighing(seed)) for seed in range(20_000, 20_012))
    assert min(seen["part"], seen["whole"]) >= 4, seen


def test_as_much_of_a_swarm_s_weights_as_can() -> None:
    seen = Counter(compare_satisfaction(swarms_weighing(seed)) for seed in range(40_012, 40_020))
    assert min(seen["part"], seen["whole"]) >= 2, seen


def test_as_much_of_a_swarm_s_formula_holds_as_can() -> None:
    seen = Counter(compare_satisfaction(swarms_in_part(seed)) for seed in range(40_007, 40_015))
    assert min(seen["part"], seen["whole"]) >= 2, seen


def test_as_much_holds_as_can_where_parts_count_as_a_whole() -> None:
    missions = [with_wholes(team_in_part(seed), seed) for seed in range(20_100, 20_110)]
    missions += [with_wholes(team_weighing(seed), seed) for seed in range(20_110, 20_118)]
    seen = Counter(map(compare_satisfaction, missions))
    assert min(seen["part"], seen["whole"]) >= 2, seen


def test_preferences_of_teams_are_met_as_far_as_they_can_be() -> None:
    seen = Counter(compare_preferences(team_preferring(seed)) for seed in range(30_000, 30_014))
    assert seen["all"] + seen["some"] >= 2, seen
    assert seen["partial"] >= 2, seen


def test_preferences_of_swarms_are_met_as_far_as_they_can_be() -> None:
    seen = Counter(compare_preferences(swarms_preferring(seed)) for seed in range(50_019, 50_030))
    assert min(seen["some"], seen["partial"]) >= 2, seen


def test_as_much_of_what_robots_and_a_swarm_are_asked_holds_as_can() -> None:
    seen = Counter(compare_satisfaction(mixed_in_part(seed)) for seed in range(60_000, 60_012))
    assert min(seen["part"], seen["whole"]) >= 3, seen


@pytest.mark.parametrize("order", ORDERS)
@pytest.mark.parametrize("encoding", ["tight", "reference"])
def test_other_parts_that_hold_have_more_to_spare(order: str, encoding: str) -> None:
    places = [State("h"), *(State(name.lower(), frozenset(name)) for name in "ABC")]
    ways = [("h", "a", 4), ("a", "h", 3), ("h", "b", 4), ("b", "h", 1), ("h", "c", 4)]
    edges = [*(Edge(item.name, item.name) for item in places), *(Edge(*way) for way in ways)]
    mission = Mission.of(
        map=TransitionSystem.build(places, edges),
        team=[Group.of("cart", {"h": 2})],
        formula="G[2,4] sum(A) <= 1 && (F[4,5] sum(B) >= 1 && F[5,5] sum(C) >= 2)",
        language="mtl",
        objective=[{"satisfaction": order}, "availability", "makespan"],
    )
    plan = tsplan.plan(mission, encoding=encoding)
    # two at B, where one is enough, and not two at C, where two are needed
    assert plan.status == "optimal"
    assert [(item.value, item.bound) for item in plan.objective[1:]] == [(1, 1), (4, 4)]


def test_what_counts_by_depth_is_what_has_agents_to_spare() -> None:
    mission = mixed_in_part(62_741)
    plan = tsplan.plan(mission)
    # the fraction is made of another part, which has two
    assert plan.satisfaction is not None
    assert plan.satisfaction.availability == 2
    assert (plan.objective[1].name, plan.objective[1].value, plan.status) == (
        "availability",
        0,
        "optimal",
    )


def test_a_margin_of_what_must_hold_is_to_spare_as_well() -> None:
    places = [State(name.lower(), frozenset(name)) for name in "ABC"]
    edges = [*(Edge(item.name, item.name) for item in places), Edge("a", "b"), Edge("b", "c")]
    mission = Mission.of(
        map=TransitionSystem.build(places, edges),
        team=[Group.of("cart", {"a": 1})],
        swarm={"size": 8, "at": "a"},
        margin=2,
        must="F[3,4] sum(C) >= 2",
        prefer=[{"formula": "F[1,2] sum(B) >= 4"}, {"formula": "F[0,9] sum(C) >= 10"}],
        language="mtl",
        objective=["availability"],
    )
    plan = tsplan.plan(mission)
    assert plan.status == "optimal"
    # nine agents come to B for the four that are preferred, and to C for the two that must
    assert [(item.value, item.bound) for item in plan.objective] == [(1, 1), (5, 5)]


def test_preferences_of_robots_and_a_swarm_are_met_as_far_as_they_can_be() -> None:
    seen = Counter(compare_preferences(mixed_preferring(seed)) for seed in range(60_000, 60_016))
    assert seen["all"] + seen["some"] + seen["partial"] >= 4, seen


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
        for mission in (
            team_in_part(seed),
            swarms_in_part(seed + 21_000),
            mixed_in_part(seed + 40_000),
            team_weighing(seed),
            swarms_weighing(seed + 21_000),
        ):
            compare_satisfaction(mission)
            compare_satisfaction(with_wholes(mission, seed))


@pytest.mark.parametrize(
    "seeds", seed_blocks((), [*range(30_000, 30_040), *range(31_000, 32_000)], 20)
)
def test_preferences_are_met_as_far_as_they_can_be_on_many(seeds: list[int]) -> None:
    for seed in seeds:
        for mission in (
            team_preferring(seed),
            swarms_preferring(seed + 20_000),
            mixed_preferring(seed + 30_000),
        ):
            compare_preferences(mission)
            compare_preferences(with_wholes(mission, seed))
