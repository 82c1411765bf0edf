"""What plans for weaker questions keep of what was left out: it answers other questions."""

from __future__ import annotations

from random import Random

import pytest

import tsplan
from tests.seeds import sampled
from tsplan.clock import Clock
from tsplan.explanation.explanation import SoftConstraint
from tsplan.explanation.whynot.conflicts import Finder
from tsplan.explanation.whynot.fulfilment import broken_by
from tsplan.explanation.whynot.oracle import Oracle
from tsplan.explanation.whynot.relaxing import relaxed
from tsplan.explanation.whynot.soft_constraints import formula_groups, named_facts
from tsplan.explanation.whynot.team_subject import Teams
from tsplan.run.problem import Problem, Tuning
from tsplan.testing import random_mission, random_swarm_mission
from tsplan.testing.random_missions import random_task_mission

REFERENCE = Tuning.named("reference")


def mission(seed: int) -> tsplan.Mission:
    if seed % 3 == 0:
        return random_swarm_mission(seed)
    if seed % 3 == 1:
        return random_mission(seed, states=4, most_agents=3, steps=6)
    return random_task_mission(seed)


def of_reference(asked: tsplan.Mission | Problem) -> Problem:
    problem = asked if isinstance(asked, Problem) else Problem(asked)
    return problem.tuned(REFERENCE)


def answers_more(seed: int) -> bool:
    """Whether a plan keeps something that was left out; what it breaks at most can be met without.

    That is proven once more, by the reference encoding.
    """
    chosen, random = mission(seed), Random(seed)
    groups = formula_groups(chosen)
    every = [*(part for group in groups for part in group), *named_facts(chosen)]
    gone = frozenset(random.sample(every, random.randint(1, len(every))))
    question = relaxed(chosen, gone)
    plan = tsplan.plan(question)
    if not plan.has_paths:
        return False
    broken = broken_by(chosen, groups, gone, question, plan)
    assert broken <= gone
    if broken < gone:
        assert tsplan.plan(of_reference(relaxed(chosen, broken))).has_paths, (seed, gone - broken)
    return broken < gone


@pytest.mark.parametrize("seed", sampled(range(1200), range(8)))
def test_what_a_plan_keeps_can_be_met_beside_the_rest(seed: int) -> None:
    answers_more(seed)


def test_who_is_late_is_in_the_way_of_a_limit_that_is_put_back():
    """Where the limit was left out robots may leave their depot late, and with it they may not."""
    assert not answers_more(425)


def test_many_plans_keep_more_than_was_asked():
    assert sum(answers_more(seed) for seed in range(15)) >= 3


def two_rooms() -> tsplan.Mission:
    """Four tasks of which two are too much for one cart; the others hold by the way."""
    yard = tsplan.grid(1, 5, labels={(0, 0): "west", (0, 4): "east", (0, 2): "middle"})
    formula = "F[0,3] west && F[0,4] middle && F[0,4] east && F[0,9] east"
    return tsplan.Mission.of(map=yard, team={"cart": {"r0c2": 1}}, formula=formula, language="mtl")


def test_parts_that_hold_by_the_way_are_put_back():
    chosen = two_rooms()
    groups = formula_groups(chosen)
    gone = frozenset(part for group in groups[:2] for part in group)
    question = relaxed(chosen, gone)
    broken = broken_by(chosen, groups, gone, question, tsplan.plan(question))
    assert broken == frozenset(groups[0])


def test_robots_at_home_keep_number_and_start():
    chosen = two_rooms()
    groups = formula_groups(chosen)
    home = frozenset({SoftConstraint("team", (0,)), SoftConstraint("start", (0,))})
    gone = frozenset(groups[0]) | home
    question = relaxed(chosen, gone)
    plan = tsplan.plan(question)
    assert broken_by(chosen, groups, gone, question, plan) <= gone
    more = relaxed(chosen, home)
    assert broken_by(chosen, groups, home, more, tsplan.plan(more))


def test_a_question_answered_by_an_earlier_plan_takes_no_solve():
    oracle = Oracle(Teams(two_rooms()), Clock(None))
    finder = Finder(oracle)
    (first, second, *_) = finder.groups
    assert oracle.without(first | second) is True
    assert oracle.without(first) is True
    assert oracle.solves == 1
