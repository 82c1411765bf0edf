"""Weights that steer what holds of a formula: in missions of robots, and over signals."""

from __future__ import annotations

import json
from dataclasses import replace
from fractions import Fraction
from itertools import product
from random import Random

import numpy as np
import pytest

import tsplan
from tests.seeds import seed_blocks
from tsplan.checking.plan_check import check
from tsplan.errors import MissionError
from tsplan.logic import And, Formula, Or, SignalTrace, horizon, linear, parse
from tsplan.logic.fraction import fraction, tree_of
from tsplan.logic.witness_steps import satisfied
from tsplan.mission import mission_from_text
from tsplan.plans.plan import Plan
from tsplan.plans.summary import satisfaction_lines
from tsplan.signals import free_signals

TEXT = """\
format: tsplan-mission/1
name: errand
map:
  waiting: true
  states: {home: {}, near: {labels: [near]}, far: {labels: [far]}}
  edges:
    - {from: home, to: near, duration: 1, both_ways: true}
    - {from: home, to: far, duration: 3, both_ways: true}
team: [{class: cart, count: 1, at: home}]
spec:
  language: wmtl
  formula: 'F[0,STEPS] near ||^w F[0,STEPS] far'
  weights: {w: [0.4, 0.6]}
objective: [{satisfaction: ORDER}, travel]
"""


def errand(steps: int = 3, order: str = "weighted"):
    return mission_from_text(TEXT.replace("STEPS", str(steps)).replace("ORDER", order))


def values(plan: Plan) -> dict[str, float | None]:
    return {item.name: item.value for item in plan.objective}


def test_the_better_alternative_is_worth_a_longer_way():
    plan = tsplan.plan(errand())
    assert (plan.status, plan.verified) == ("optimal", True)
    assert values(plan) == {"satisfaction": 1, "travel": 3}
    assert (plan.satisfaction.preference, plan.satisfaction.fraction) == (1, 1)


def test_the_other_one_holds_as_well_but_counts_less():
    mission = errand(steps=2)
    plan = tsplan.plan(mission)
    assert (plan.satisfaction.preference, plan.satisfaction.fraction) == (Fraction(2, 3), 1)
    assert plan.objective[0].value == plan.objective[0].bound == pytest.approx(2 / 3)
    assert values(plan)["travel"] == 1
    assert check(mission, plan).ok
    assert satisfaction_lines(plan)[0] == "  satisfied: 1, preference 2/3 (weighted)"
    told = json.loads(plan.to_json())["satisfaction"]
    assert (told["preference"], told["exact"], told["fraction"]) == ("2/3", "1", 1)
    assert Plan.from_json(plan.to_json()) == plan


def test_a_plan_that_claims_more_is_refused():
    mission = errand(steps=2)
    plan = tsplan.plan(mission)
    for claim in (Fraction(1), None):
        forged = replace(plan, satisfaction=replace(plan.satisfaction, preference=claim))
        told = [finding.message for finding in check(mission, forged).findings]
        assert any("has 2/3" in words for words in told), told


def test_preferred_formulas_may_have_weights_in_part():
    text = TEXT.replace("STEPS", "2").replace(
        "formula: 'F", "prefer:\n  - {partial: true, weight: 3, formula: 'F"
    )
    text = text.replace("far'", "far'}").replace("{satisfaction: ORDER}, ", "")
    mission = mission_from_text(text)
    plan = tsplan.plan(mission)
    (wish,) = plan.preferences
    assert (wish.preference, wish.fraction, wish.worth) == (Fraction(2, 3), 1, 2)
    assert values(plan) == {"preferences": 2, "travel": 1}
    assert check(mission, plan).ok
    assert Plan.from_json(plan.to_json()) == plan


def test_weights_do_not_count_in_orders_by_depth():
    for order in ("hierarchical", "depth"):
        with pytest.raises(MissionError, match=f"no effect in the order '{order}'") as caught:
            errand(order=order)
        (found,) = caught.value.findings
        assert "{satisfaction: weighted}" in found.remedy
        assert found.line == 12


@pytest.mark.parametrize(
    ("text", "pairs"),
    [
        ("(x >= 4) ||^[1, 2] (x >= 1)", [("x >= 1", 0)]),
        ("(x >= 1) ||^[1, 2] (x >= 1)", [("x >= 1", 0)]),
        ("(x >= 4) ||^2 (x >= 1)", [("x >= 4 ||^2 x >= 1", 0)]),
        ("F[0,3]^[1, 1, 3, 2] x >= 2", [("x >= 2", 2)]),
        ("G[0,1]^[1, 2] x >= 1", [("G[0,1]^[1, 2] x >= 1", 0)]),
        ("(x >= 1) U[0,2]^[1, 2, 3] (x >= 2)", [("x >= 1", 0), ("x >= 1", 1), ("x >= 2", 2)]),
    ],
)
def test_of_alternatives_that_count_differently_the_one_that_holds_is_demanded(text, pairs):
    trace = SignalTrace({"x": np.array([1.0, 4, 2, 5])})
    found = satisfied(tree_of(parse(text, "wstl")), trace)
    assert set(found) == {(parse(part, "wstl"), step) for part, step in pairs}


# --- signals ---

SIDES = [
    linear({name: 1}, sign, bound) for name in "xy" for sign, bound in (("<=", 0.5), (">=", 1.5))
]


SQUARE = free_signals(x=(0, 2), y=(0, 2))


def random_wish(random: Random, depth: int) -> Formula:
    """A formula with weights over sides that exclude each other, of at most two steps ahead."""
    if not depth:
        return random.choice(SIDES)

    def weights(count: int) -> list[float]:
        return [random.choice([0.4, 0.6, 1, 2]) for _ in range(count)]

    kind, window = random.randrange(5), (0, 1)
    below = [random_wish(random, depth - 1) for _ in range(random.choice([2, 3]))]
    if kind < 2:
        return (And, Or)[kind](tuple(below), weights(len(below)))
    if kind == 2:
        return below[0].until(below[1], *window, weights(2))
    return (below[0].always, below[0].eventually)[kind - 3](*window, weights(2))


def most_preferred(formula: Formula) -> Fraction:
    """By trying a value on either side of every bound at every step."""
    steps = horizon(formula) + 1
    best = Fraction(0)
    for values in product((0.0, 2.0), repeat=2 * steps):
        trace = SignalTrace({"x": values[:steps], "y": values[steps:]})
        best = max(best, fraction(formula, trace, weighted=True))
    return best


def preferred_most(seed: int) -> Fraction:
    """What synthesis has to find, and does."""
    formula = random_wish(Random(seed), 1 + seed % 2) & random_wish(Random(-seed - 1), 2)
    best = most_preferred(formula)
    found = tsplan.synthesise(
        formula, SQUARE, objective=[{"satisfaction": "weighted"}, "robustness"]
    )
    assert (found.status, found.verified) == ("optimal", True)
    assert found.preference == pytest.approx(float(best))
    assert found.objective[0].value == found.objective[0].bound == found.preference
    assert found.fraction == pytest.approx(float(fraction(formula, found.trace())))
    return best


def test_what_is_preferred_of_signals_is_found():
    assert len({preferred_most(seed) for seed in range(8)}) >= 3


@pytest.mark.parametrize("seeds", seed_blocks((), range(8, 400), 12))
def test_what_is_preferred_of_signals_is_found_on_many(seeds):
    for seed in seeds:
        preferred_most(seed)


def test_a_solver_that_misses_a_border_by_rounding_loses_nothing():
    assert preferred_most(301) == Fraction(23, 26)
