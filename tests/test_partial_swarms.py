"""Swarms whose formula may hold in part, and their preferences, against all joint plans."""

from __future__ import annotations

from collections import Counter, defaultdict
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from random import Random

import pytest

import tsplan
from tests.random_missions import LABELS, random_text
from tests.test_brute_force import trace
from tests.test_swarm_brute import dividing_text, possible, random_swarms
from tsplan import Mission
from tsplan.checking.plan_check import check
from tsplan.logic import CountTrace, holds, horizon, parse
from tsplan.logic.fraction import shares
from tsplan.logic.witness_steps import levels
from tsplan.mission import Preference
from tsplan.plans.plan import Plan
from tsplan.plans.summary import satisfaction_lines
from tsplan.ts import Edge, State, TransitionSystem

ORDERS = ("weighted", "hierarchical", "depth")


def rival_text(random: Random) -> str:
    """Parts that swarms of few agents and few sub-swarms cannot all have."""
    parts = [dividing_text(random), random_text(random, 1)]
    label = random.choice(LABELS)
    parts.append(random.choice([f"G[1,3] {label}", f"F[0,2] (sum({label}) >= 60%)", f"!{label}"]))
    return " && ".join(f"({part})" for part in random.sample(parts, random.randint(2, 3)))


def swarms_in_part(seed: int) -> Mission | None:
    """A tiny mission of swarms that may hold in part; most of them cannot hold as a whole."""
    random = Random(f"in part {seed}")
    mission = random_swarms(seed)
    if mission is None:
        return None
    names = [group.class_name for group in mission.team]
    text = rival_text(random)
    if len(names) == 1:
        text = text.replace(",v", "").replace(",u", "")
    formula = parse(text, "mtl")
    if horizon(formula) > mission.horizon:
        return None
    objective = ("satisfaction", *mission.objective)
    made = replace(mission, formula=formula, text=text, objective=objective)
    return replace(made, satisfaction=ORDERS[seed % 3])


def share(mission: Mission, counts: CountTrace) -> Fraction:
    tree = mission.tree(mission.formula)
    return shares(tree, counts)[tree][0].fraction


def compare_satisfaction(seed: int) -> str:
    mission = swarms_in_part(seed)
    if mission is None:
        return "too large"
    weighted = mission.satisfaction == "weighted"
    tree = mission.tree(mission.formula)
    worths = []
    for joint, _ in possible(mission):
        counts = trace(mission, joint)
        worth = share(mission, counts)
        assert (worth == 1) == bool(holds(mission.counted, counts)[0])
        worths.append((worth,) if weighted else levels(tree, counts).counts)
    plan = tsplan.plan(mission)
    if not worths:
        assert plan.status == "infeasible", seed
        return "infeasible"
    assert plan.status == "optimal", seed
    assert check(mission, plan).ok, seed
    assert plan.satisfaction is not None
    best = max(worths)
    if weighted:
        assert plan.satisfaction.fraction == best[0], seed
        assert plan.objective[0].bound == pytest.approx(float(best[0]))
    else:
        assert tuple(item.value for item in plan.satisfaction.depths) == best, seed
    if best[0] == 1:
        assert (plan.satisfaction.fraction, plan.objective[0].bound) == (1, 1)
        return "whole"
    return "part"


@pytest.mark.parametrize("block", range(1))
def test_as_much_of_a_swarm_s_formula_holds_as_can(block: int) -> None:
    seen = Counter(map(compare_satisfaction, range(40_000 + 40 * block, 40_040 + 40 * block)))
    assert seen["part"] >= 3, seen


def test_both_kinds_of_swarm_missions_occur() -> None:
    seen = Counter(map(compare_satisfaction, range(41_000, 41_060)))
    assert min(seen["part"], seen["whole"]) >= 2, seen


@pytest.mark.long
@pytest.mark.parametrize("block", range(100))
def test_as_much_of_a_swarm_s_formula_holds_as_can_on_many(block: int) -> None:
    for seed in range(42_000 + 20 * block, 42_020 + 20 * block):
        compare_satisfaction(seed)


def preferring(seed: int) -> Mission | None:
    """A tiny mission of swarms with up to four preferences at up to two levels."""
    random = Random(f"prefer {seed}")
    mission = random_swarms(seed)
    if mission is None:
        return None
    single = len(mission.team) == 1
    wishes = []
    for number in range(random.randint(1, 4)):
        text = random_text(random, random.randint(0, 2))
        text = text.replace(",v", "").replace(",u", "") if single else text
        formula = parse(text, "mtl")
        if horizon(formula) > mission.horizon:
            return None
        weight = Fraction(random.choice(["1", "2", "3", "0.5", "0.3"]))
        level, partial = random.choice([0, 0, 1]), random.random() < 0.4
        wishes.append(Preference(formula, text, weight, f"wish {number}", level, partial))
    return replace(mission, prefer=tuple(wishes))


def gains(mission: Mission, counts: CountTrace) -> tuple[Fraction, ...]:
    """What is gained at each level, the highest first."""
    by_level: dict[int, Fraction] = defaultdict(Fraction)
    for wish in mission.prefer:
        tree = mission.tree(wish.formula)
        worth = shares(tree, counts)[tree][0].fraction
        by_level[wish.level] += wish.weight * (worth if wish.partial else worth // 1)
    return tuple(by_level[level] for level in sorted(by_level, reverse=True))


def compare_preferences(seed: int) -> str:
    mission = preferring(seed)
    if mission is None:
        return "too large"
    worths = [
        gains(mission, counts)
        for joint, _ in possible(mission)
        for counts in [trace(mission, joint)]
        if holds(mission.counted, counts)[0]
    ]
    plan = tsplan.plan(mission)
    if not worths:
        assert plan.status == "infeasible", seed
        return "infeasible"
    assert plan.status == "optimal", seed
    assert check(mission, plan).ok, seed
    made: dict[int, Fraction] = defaultdict(Fraction)
    for item in plan.preferences:
        made[item.level] += item.worth
    assert tuple(made[level] for level in sorted(made, reverse=True)) == max(worths), seed
    assert plan.objective[0].value == pytest.approx(float(sum(max(worths))))
    assert plan.objective[0].bound == pytest.approx(float(sum(max(worths))))
    return "some" if plan.preferences and not all(i.met for i in plan.preferences) else "all"


@pytest.mark.parametrize("block", range(2))
def test_preferences_of_swarms_are_met_as_far_as_they_can_be(block: int) -> None:
    seen = Counter(map(compare_preferences, range(50_000 + 40 * block, 50_040 + 40 * block)))
    assert seen["some"] >= 2, seen


@pytest.mark.long
@pytest.mark.parametrize("block", range(50))
def test_preferences_of_swarms_are_met_as_far_as_they_can_be_on_many(block: int) -> None:
    for seed in range(51_000 + 20 * block, 51_020 + 20 * block):
        compare_preferences(seed)


REEF = Path(__file__).parent.parent / "environments" / "reef_watch.yaml"


def test_plans_of_swarms_say_what_holds_and_are_read_again() -> None:
    mission = tsplan.load_mission(REEF)
    plan = tsplan.plan(mission)
    copy = Plan.from_json(plan.to_json())
    assert copy.satisfaction == plan.satisfaction
    assert check(mission, copy).ok
    assert plan.satisfaction is not None
    told = {node.text: node.fraction for node in plan.satisfaction.nodes}
    watched = [told[f"sum({place}) >= 25%"] for place in ("kelp", "wreck", "sand")]
    assert sum(watched) == 2  # two groups, at two of three places at every step
    assert told["F[12,16] (sum(harbour) >= 100%)"] == 1
    assert satisfaction_lines(plan)[0] == "  satisfied: 5/6 (weighted)"
    better = replace(plan.satisfaction, fraction=Fraction(1))
    refused = check(mission, replace(plan, satisfaction=better))
    assert any("claims satisfaction 1" in str(finding) for finding in refused.findings)


def test_a_margin_is_kept_by_what_must_hold_alone() -> None:
    system = TransitionSystem.build(
        [State("p", frozenset({"A"})), State("q", frozenset({"B"}))],
        [Edge("p", "p"), Edge("q", "q"), Edge("p", "q"), Edge("q", "p")],
    )
    mission = Mission.of(
        map=system,
        swarm={"size": 20, "at": {"p": 20}},
        margin=2,
        must="F[2,2] sum(B) >= 50%",
        prefer=[{"formula": "F[2,2] sum(A) >= 8", "name": "eight"}, {"formula": "G[2,2] sum(A)>8"}],
    )
    plan = tsplan.plan(mission)
    assert plan.status == "optimal"
    assert check(mission, plan).ok
    assert [item.met for item in plan.preferences] == [True, False]
    assert plan.availability == 2
