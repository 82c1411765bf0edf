"""Formulas with parts that are known by their margins are planned for exactly."""

from __future__ import annotations

import random
from collections import Counter
from dataclasses import replace

import pytest

import tsplan
from tests.joint_plans import small_enough
from tests.module_missions import TooManyError, random_module_mission, worth
from tests.module_missions import best as best_of_modules
from tests.seeds import sampled, seed_blocks
from tests.slippery import grid_mission
from tests.test_brute_force import PLAIN, REFERENCE, TIGHT, compare
from tests.test_encode_agree import answer
from tests.test_partial_brute_force import (
    compare_satisfaction,
    swarms_in_part,
    team_in_part,
    team_weighing,
)
from tests.test_structures_brute_force import PERFORMANCE
from tsplan import Mission
from tsplan.logic import Count, Formula, Known, Task, fold, parse, tighten
from tsplan.logic.margin import shifted
from tsplan.mission import mission_from_text
from tsplan.testing import random_mission, random_swarm_mission

NEAR = "G[9,9] (sum(goal) >= 1)"


def with_known(mission: Mission, seed: int) -> Mission:
    """The mission with known margins beside or in place of some of its atoms."""
    drawn = random.Random(seed)

    def known(node: Formula, below: tuple[Formula, ...]) -> Formula:
        made = node.over(below)
        if not isinstance(node, Count | Task) or drawn.random() < 0.3:
            return made
        margin = Known(drawn.choice([-2, -1, 0, 0, 1, 2]))
        return drawn.choice(
            [margin | made, margin & made, margin, made & Known(abs(margin.margin))]
        )

    formula = fold(mission.formula, known)
    return replace(mission, formula=formula, text=str(formula))


def small_team(seed: int) -> Mission:
    made = random_mission(seed, states=4, most_agents=3, steps=5, mixed=seed % 3 == 0)
    if "availability" not in made.objective:
        made = replace(made, objective=("availability", *made.objective))
    return with_known(made, seed)


@pytest.mark.parametrize("seeds", seed_blocks(range(6), range(1000), 6))
def test_teams_do_as_well_as_the_best_of_all_joint_plans(seeds):
    for mission in filter(small_enough, map(small_team, seeds)):
        compare(mission, TIGHT, REFERENCE, PLAIN)


@pytest.mark.parametrize("seeds", seed_blocks(range(4), range(4, 200), 4))
def test_swarms_do_as_well_as_the_best_of_all_joint_plans(seeds):
    for seed in seeds:
        mission = with_known(random_swarm_mission(seed, fits=small_enough), seed)
        compare(mission, TIGHT, REFERENCE)


@pytest.mark.parametrize("seeds", seed_blocks(range(2), range(2, 200), 1))
def test_both_encodings_agree_on_larger_missions(seeds):
    for seed in seeds:
        mission = with_known(random_mission(seed), seed)
        assert answer(tsplan.plan(mission)) == answer(tsplan.plan(mission, encoding="reference"))


def test_as_much_holds_as_can_where_formulas_may_hold_in_part():
    found = Counter(
        compare_satisfaction(with_known(made, seed))
        for seed in range(3)
        for made in (team_in_part(seed), swarms_in_part(seed), team_weighing(seed))
    )
    assert min(found["part"], found["whole"]) >= 2, found


@pytest.mark.parametrize("encoding", ["tight", "reference"])
@pytest.mark.parametrize(
    ("formula", "availability"),
    [
        (f"{NEAR}", 1.7430748),
        (f"known(0) && {NEAR}", 0),
        (f"known(1) && {NEAR}", 1),
        (f"known(3) && {NEAR}", 1.7430748),
        (f"known(1) || {NEAR}", 1.7430748),
        (f"known(3) || {NEAR}", 3),
        ("known(-1) || F[7,9] (sum(goal) >= 1 && known(1))", 1),
        ("known(2)", 2),
        (f"known(-1) && {NEAR}", None),
    ],
)
def test_expected_numbers_have_no_more_to_spare_than_is_known(encoding, formula, availability):
    plan = tsplan.plan(grid_mission(4, 3, formula), encoding=encoding)
    assert plan.verified == (availability is not None)
    assert plan.availability == pytest.approx(availability, abs=1e-6)


@pytest.mark.parametrize("seed", sampled(range(3000, 3100), range(3000, 3004)))
def test_structures_perform_as_well_as_by_trying_everything(seed):
    mission = with_known(random_module_mission(seed, steps=3, performance=PERFORMANCE), seed)
    try:
        expected = best_of_modules(mission)
    except TooManyError:
        return
    for encoding in ("tight", "reference"):
        plan = tsplan.plan(mission, encoding=encoding)
        assert plan.verified == (expected is not None)
        values = {item.name: item.value for item in plan.objective}
        if expected is not None:
            assert worth(mission, values) == pytest.approx(expected, abs=1e-9)


FERRY = """\
format: tsplan-mission/1
map: {waiting: true, states: {p: {labels: [a]}, q: {labels: [b]}}, edges: [[p, q, 1]]}
team: [{class: k, count: 3, at: p}]
spec: {language: mtl, formula: 'FORMULA'}
objective: [availability, travel]
"""


@pytest.mark.parametrize("encoding", ["tight", "reference"])
@pytest.mark.parametrize(
    ("formula", "availability", "travel"),
    [
        ("known(0) || F[0,3] b", 2, 3),
        ("known(1) && F[0,3] b", 1, 2),
        ("known(4) || F[0,3] b", 4, 0),
        ("G[0,2] (known(1) || sum(b) >= 2)", 1, 0),
        ("F[0,2] (known(-1) || sum(b) >= 2)", 1, 3),
        ("!known(-2) && F[0,3] b", 1, 2),
    ],
)
def test_what_is_known_bounds_the_availability(encoding, formula, availability, travel):
    plan = tsplan.plan(mission_from_text(FERRY.replace("FORMULA", formula)), encoding=encoding)
    assert plan.verified
    assert (plan.availability, plan.value("travel")) == (availability, travel)


def test_known_margins_are_shifted_and_need_no_head_room():
    formula = parse("known(3) && sum(a) >= 4")
    assert str(shifted(formula, 2)) == "known(1) && sum(a) >= 6"
    assert str(tighten(formula, lambda _: 9, lambda _: 2)) == "known(3) && sum(a) >= 6"
    assert str(tighten(formula, lambda _: 9, lambda _: 0, level=1)) == "known(2) && sum(a) >= 5"
