"""Why resources are not there in time, and what would help: proven, and said in numbers."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from random import Random

import pytest

import tsplan
from tests.explaining import check_explanation, possible
from tests.resource_missions import best, random_resource_mission
from tests.seeds import seed_blocks
from tsplan import Mission
from tsplan.explanation import explain
from tsplan.explanation.whynot.changes import applied
from tsplan.explanation.whynot.context import Context
from tsplan.explanation.whynot.fact_finders import facts_of
from tsplan.explanation.whynot.haulage_bounds import HaulageBounds
from tsplan.explanation.whynot.mission_numbers import Number
from tsplan.explanation.whynot.occurrences import Occurrence, occurrences, without
from tsplan.explanation.whynot.relaxing import relaxed
from tsplan.explanation.whynot.rewriting import rewritten
from tsplan.explanation.whynot.shortages import gathering
from tsplan.explanation.whynot.soft_constraints import named_facts
from tsplan.logic import parse
from tsplan.mission import mission_from_text

TEXT = """\
format: tsplan-mission/1
name: site
map:
  waiting: true
  states: {yard: {}, road: {}, wall: {labels: [site]}, tower: {labels: [site]}}
  edges: [{from: yard, to: road, duration: 1, both_ways: true},
    {from: road, to: wall, duration: 1, both_ways: true},
    {from: road, to: tower, duration: 2, both_ways: true}]
resources:
  - {name: brick, at: {yard: 6}, indivisible: true}    # in the yard
  - {name: water, at: {yard: 2.5}}
  - {name: drill, at: {yard: 1}, indivisible: true, consumed: false}
team:
  - {class: man, count: 2, at: yard, capabilities: [lay], carries: {brick: 1, water: 0.5, drill: 1}}
spec:
  language: catl
  formula: 'FORMULA'
horizon: 9
"""


def mission(formula: str, **changes: str) -> Mission:
    text = TEXT.replace("FORMULA", formula)
    for old, new in changes.items():
        assert old in text
        text = text.replace(old, new)
    return mission_from_text(text)


@pytest.mark.parametrize(
    ("formula", "fact"),
    [
        (
            "F[0,9] T(0,wall,{},{(brick,4)}) && F[0,9] T(0,tower,{},{(brick,3)})",
            (
                "7 brick in all are used up (4 at 'wall' and 3 at 'tower'); "
                "there are 6 brick, at 'yard'"
            ),
        ),
        (
            "F[0,8] T(0,site,{},{(brick,4)})",
            (
                "8 brick in all are used up (4 at each of the 2 states 'site'); "
                "there are 6 brick, at 'yard'"
            ),
        ),
        (
            "F[0,8] T(0,site,{},{(drill,1)})",
            (
                "2 drill in use at one step (1 at each of the 2 states 'site'); "
                "there is 1 drill, at 'yard'"
            ),
        ),
        (
            "F[0,2] T(0,wall,{},{(brick,3)})",
            (
                "3 brick must be at 'wall' by step 2; at most 2 can be: "
                "2 agents of class man with one load of 1"
            ),
        ),
        (
            "G[2,4] T(0,wall,{},{(water,0.75)})",
            (
                "2.25 water must be at 'wall' by step 4 for 3 executions; at most 2 can be: "
                "2 agents of class man with 2 loads of 0.5"
            ),
        ),
        (
            "F[0,1] T(0,tower,{},{(drill,1)})",
            (
                "1 drill must be at 'tower' by step 1; 0 can be: "
                "nobody can come there with any by then"
            ),
        ),
    ],
)
def test_what_cannot_be_there_is_said_in_numbers(formula: str, fact: str) -> None:
    """Without any solve."""
    assert fact in [found.text for found in facts_of(Context(mission(formula)))]


def test_where_the_bound_is_not_sharp_a_solve_says_what_can_be() -> None:
    """Two loads a man would do for four, but only one comes back in time for another."""
    made = mission("F[0,4] T(0,wall,{},{(brick,4)})")
    assert not list(facts_of(Context(made)))
    (fact,) = explain(made).facts
    assert fact.text == "4 brick must be at 'wall' by step 4, and 3 can be"
    assert (fact.kind, fact.place.line) == ("delivery", 17)


def test_a_task_that_is_asked_for_twice_is_paid_once() -> None:
    task = "T(0,wall,{},{(brick,4)})"
    assert explain(mission(f"F[0,9] {task} && F[3,9] {task}")).status == "feasible"


def test_a_conflict_names_who_carries_what_and_changes_are_the_least_that_do() -> None:
    made = mission("F[0,4] T(0,wall,{(lay,1)},{(brick,4)})")
    found = check_explanation(made)
    changes = {change.text: change for change in found.changes}
    told = "F[0,4] T(0,wall,{(lay,1)},{(brick,4)})"
    assert changes.keys() == {
        f"extend the deadline 4 to 6 (2 steps later) in {told}",
        "add 1 agent of class man at 'yard'",
        "let each agent of class man carry 2 brick (now 1)",
        f"lower the need at 'wall' from 4 to 3 brick in {told}",
    }
    assert all(change.proven for change in changes.values())
    (conflict,) = found.conflicts
    assert [part.text for part in conflict.parts] == [
        "(brick,4) in F[0,4] T(0,wall,{(lay,1)},{(brick,4)})",
        "the team has 2 agents of class man",
        "each agent of class man carries at most 1 brick and 0.5 water and 1 drill",
        "there are 6 brick, at 'yard'",
    ]
    assert [part.place.line for part in conflict.parts] == [17, 14, 14, 10]


def test_more_of_it_at_its_place() -> None:
    made = check_explanation(mission("F[0,9] T(0,wall,{},{(drill,2)})"))
    kinds = {change.kind: change for change in made.changes}
    assert kinds["add_stock"].text == "add 1 drill at 'yard'"
    assert "stock" in {part.kind for part in made.conflicts[0].parts}


def test_one_hold_is_one_number() -> None:
    made = mission("F[0,2] T(0,wall,{},{(brick,3)})", **{"{brick: 1, water: 0.5, drill: 1}": "1"})
    (change,) = [change for change in explain(made).changes if change.kind == "carry_more"]
    assert change.text == "let each agent of class man carry 2 of all resources together (now 1)"
    assert (change.amount, change.proven) == (1.0, True)


def test_amounts_that_may_be_parted_move_by_their_unit() -> None:
    made = explain(mission("F[0,2] T(0,wall,{},{(water,1.75)})"))
    changes = {change.kind: change for change in made.changes}
    more = changes["carry_more"]
    assert more.text == "let each agent of class man carry 1 water (now 0.5)"
    assert (more.amount, more.within, more.proven) == (0.5, 0.25, True)
    less = changes["lower_need"]
    assert (less.amount, less.proven) == (0.75, True)
    assert possible(less.mission)
    ((edit, steps),) = less.steps
    assert not possible(applied(mission("F[0,2] T(0,wall,{},{(water,1.75)})"), [(edit, steps - 1)]))


def test_changed_files_say_the_amounts() -> None:
    made = mission("F[0,2] T(0,wall,{(lay,1)},{(brick,3)})")
    short = mission("F[0,9] T(0,wall,{(lay,1)},{(brick,7)})", **{"brick: 1": "brick: 4"})
    changes = [(made, change) for change in explain(made).changes]
    changes += [(short, change) for change in explain(short).changes if change.kind == "add_stock"]
    kinds = {change.kind for _, change in changes}
    assert kinds >= {"carry_more", "add_stock", "lower_need", "add_agents"}
    for original, change in changes:
        text, lost = rewritten(original, change.mission, Path(), Path())
        assert not lost
        assert ".0" not in text
        read = mission_from_text(text)
        assert read.formula is change.mission.formula
        assert read.resources == change.mission.resources
        assert read.team == change.mission.team


def test_more_agents_carry_as_the_others_do() -> None:
    made = mission("F[0,2] T(0,wall,{},{(brick,3)})")
    for state in ("yard", "road"):
        added = Number("agents", (0, state)).put(made, 3)
        assert {group.carries for group in added.team} == {made.team[0].carries}
    for gone in ("team", "start"):
        (item,) = [one for one in named_facts(made) if one.kind == gone]
        carriers = relaxed(made, {item}).mission.team  # type: ignore[union-attr]
        assert [group.carries for group in carriers] == [made.team[0].carries]


def test_needs_and_amounts_are_parts_of_their_own() -> None:
    text = "F[0,3] T(1,wall,{(lay,1)},{(brick,4),(drill,1)})"
    root = parse(text, language="catl")
    parts = occurrences(root, ())
    assert parts == tuple(Occurrence((0,), number) for number in range(3))
    assert str(without(root, parts[1:2])) == "F[0,3] T(1,wall,{(lay,1)},{(drill,1)})"
    assert str(without(root, parts[1:])) == "F[0,3] T(1,wall,{(lay,1)})"
    assert str(without(root, parts)) == "F[0,3] true"


def test_a_task_written_twice_asks_for_less_in_both_places_or_in_none() -> None:
    task = "T(0,wall,{},{(brick,4),(drill,1)})"
    root = parse(f"F[0,3] {task} && F[0,5] {task}", language="catl")
    first, second = Occurrence((0, 0), 0), Occurrence((1, 0), 0)
    assert without(root, [first]) is root
    assert str(without(root, [first, second])).count("brick") == 0
    # where one is left out as a whole, the other may ask for less alone
    gone = without(root, [Occurrence((0, 0)), second])
    assert str(gone) == "F[0,3] true && F[0,5] T(0,wall,{},{(drill,1)})"


def test_what_is_tight_is_told_of_tasks_below_an_implication() -> None:
    made = mission("(T(0,wall,{(lay,2)}) => F[0,4] T(0,wall,{(lay,1)},{(brick,1)}))")
    assert explain(made).status == "feasible"


# --- bounds and optima -------------------------------------------------------------------------

TINY = {"states": 3, "robots": 2, "steps": 4}


@pytest.mark.parametrize("seeds", seed_blocks(range(4), range(200), 8))
def test_what_can_be_gathered_is_the_optimum_and_within_its_bound(seeds: list[int]) -> None:
    for seed in seeds:
        random = Random(seed)
        made = random_resource_mission(seed, **TINY)
        resource = random.choice(made.resources)
        state = random.choice(sorted(made.system.states))
        step = random.randint(1, 3)
        asked = gathering(made, resource.name, (state, step), Fraction(1))
        plan, by_hand = tsplan.plan(asked), best(asked)
        assert (by_hand is not None) == plan.has_paths
        most = 0.0 if by_hand is None else 1.0 - by_hand[0]
        if by_hand is not None:
            assert plan.objective[0].value == plan.objective[0].bound == most - 1
        assert HaulageBounds(Context(made), resource).most(state, step).amount >= most


@pytest.mark.parametrize("seeds", seed_blocks([5, 60], [*range(100, 300), 2, 79], 10))
def test_everything_that_is_said_is_so(seeds: list[int]) -> None:
    for seed in seeds:
        made = random_resource_mission(seed)
        scarce = tuple(
            replace(item, at=tuple((state, min(amount, 1.0)) for state, amount in item.at))
            for item in made.resources
        )
        check_explanation(replace(made, objective=(), resources=scarce))
