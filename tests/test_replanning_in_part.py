"""Planning again where not everything has to hold: against all ways to go on."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import tsplan
from tests.joint_plans import joint_plans, small_enough
from tests.seeds import quick, seed_blocks
from tests.test_partial_brute_force import (
    share,
    team_in_part,
    team_preferring,
    team_weighing,
    with_wholes,
)
from tests.test_progression import cut
from tests.test_replanning import Past, disturbed, whole_slack, whole_trace
from tsplan import Mission, Plan
from tsplan.errors import MissionError
from tsplan.logic import CountTrace, horizon, parse
from tsplan.logic.fraction import shares, tree_of
from tsplan.logic.unfolding import unfolded
from tsplan.logic.witness_steps import levels
from tsplan.replanning.replanner import replan
from tsplan.testing.formula_strategies import judged

Worth = tuple[Fraction, ...] | tuple[int, ...]


@quick
@given(judged("wmtl", extra=3), st.integers(1, 12))
def test_what_is_left_of_a_tree_is_worth_what_the_tree_is(case, first: int) -> None:
    _, formula, trace = case
    tree, first = tree_of(formula), min(first, trace.steps - 1)
    before, later = cut(trace, slice(first)), cut(trace, slice(first, None))
    rest = unfolded(tree, before)
    assert horizon(rest) <= max(horizon(tree) - first, 0)
    for weighted in (False, True):
        whole = shares(tree, trace, weighted=weighted)[tree][0]
        assert shares(rest, later, weighted=weighted)[rest][0] == whole
    try:
        rest = unfolded(tree, before, levels=True)
    except ValueError:
        return
    counts = [levels(*each).counts for each in ((tree, trace), (rest, later))]
    deepest = max(map(len, counts))
    assert len({(*each, *[0] * (deepest - len(each))) for each in counts}) == 1


def test_depths_are_not_told_of_windows_in_windows_that_have_begun() -> None:
    trace = CountTrace({None: np.array([[1, 1]])}, {"a": np.array([0])})
    for text in ("a U[0,5] sum(a) >= 2", "G[0,5] F[0,2] a", "F[1,5] G[0,2] (a && F[1,1] a)"):
        with pytest.raises(ValueError, match="has begun"):
            unfolded(parse(text), trace, levels=True)
    later = parse("G[3,5] (a U[0,5] sum(a) >= 2)")
    assert unfolded(later, trace, levels=True) == parse("G[1,3] (a U[0,5] sum(a) >= 2)")


def whole_worth(mission: Mission, trace: CountTrace) -> Worth:
    """What a whole trace is worth in what comes first among the objectives."""
    if mission.prefer:
        by_level: dict[int, Fraction] = defaultdict(Fraction)
        for wish in mission.prefer:
            worth = share(mission, wish.formula, trace)
            by_level[wish.level] += wish.weight * (worth if wish.partial else worth // 1)
        return tuple(by_level[level] for level in sorted(by_level, reverse=True))
    if mission.satisfaction == "weighted":
        return (share(mission, mission.formula, trace),)
    return levels(mission.tree(mission.formula), trace).counts


def told_worth(mission: Mission, plan: Plan) -> Worth:
    """What a plan says of that."""
    if mission.prefer:
        by_level: dict[int, Fraction] = defaultdict(Fraction)
        for item in plan.preferences:
            by_level[item.level] += item.worth
        return tuple(by_level[level] for level in sorted(by_level, reverse=True))
    assert plan.satisfaction is not None
    if mission.satisfaction == "weighted":
        return (plan.satisfaction.worth,)
    return tuple(item.value for item in plan.satisfaction.depths)


def best_continuation(past: Past, system: tsplan.TransitionSystem) -> Worth | None:
    mission = past.mission
    return max(
        (
            whole_worth(mission, whole_trace(past, joint))
            for joint in joint_plans(past.continued(system))
            if mission.partial or whole_slack(past, joint, mission.formula) >= 0
        ),
        default=None,
    )


def some_wholes(seed: int) -> Mission:
    return with_wholes(team_weighing(seed), seed)


@pytest.mark.parametrize("draw", [team_in_part, team_weighing, team_preferring, some_wholes])
@pytest.mark.parametrize("seeds", seed_blocks(range(4), range(1200), 12))
def test_as_much_holds_of_the_whole_as_can(
    draw: Callable[[int], Mission], seeds: list[int]
) -> None:
    for seed in seeds:
        compare(draw(seed), seed)


def compare(mission: Mission, seed: int) -> None:
    if mission.delay or "delay" in mission.objective or not small_enough(mission):
        return
    plan = tsplan.plan(mission)
    if not plan.has_paths:
        return
    past, system = disturbed(mission, plan, seed)
    if past.overfull(system) or not small_enough(past.continued(system)):
        return
    expected = best_continuation(past, system)
    if mission.partial and mission.satisfaction != "weighted" and past.step:
        try:
            made = replan(mission, plan, past.step, **past.said)
        except MissionError:
            return
    else:
        made = replan(mission, plan, past.step, **past.said)
    if expected is None:
        assert made.status == "infeasible", seed
        return
    assert (made.status, made.verified) == ("optimal", True), seed
    told = told_worth(mission, made)
    assert told[: len(expected)] == expected, seed
    assert not any(told[len(expected) :]), seed
    assert tsplan.check(mission, Plan.from_json(made.to_json())).ok, seed


def test_what_has_held_counts_on() -> None:
    mission = tsplan.mission_from_text(ROUNDS)
    plan = tsplan.plan(mission)
    assert plan.objective[0].value == pytest.approx(19 / 20)
    made = replan(mission, plan, 4, lost=["cart-1"])
    assert made.satisfaction is not None
    assert made.satisfaction.fraction == Fraction(7, 10)  # two were there at four steps of ten
    assert tsplan.check(mission, made).ok
    text = made.to_json()
    assert '"exact": "7/10"' in text
    false = text.replace('"exact": "7/10"', '"exact": "4/5"').replace(
        '"fraction": 0.7', '"fraction": 0.8'
    )
    assert not tsplan.check(mission, Plan.from_json(false)).ok


ROUNDS = """
format: tsplan-mission/1
map:
  waiting: true
  states: {p: {}, q: {}}
  edges: [{from: p, to: q, duration: 1, both_ways: true}]
team: [{class: cart, count: 2, at: p}]
spec: {language: mtl, formula: "G[0,9] sum(p) >= 2 && F[5,9] q"}
objective: [{satisfaction: weighted}, travel]
"""
