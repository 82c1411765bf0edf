"""Explanations of modular robots: structures must be built first, of modules that there are."""

from __future__ import annotations

from pathlib import Path

import pytest

import tsplan
from tests.explaining import check_explanation, everything, holds_without, plain
from tests.fence_missions import fence
from tests.module_missions import random_module_mission
from tests.seeds import seed_blocks
from tsplan.explanation import Fact
from tsplan.explanation.whynot.context import Context
from tsplan.explanation.whynot.fact_finders import facts_of
from tsplan.explanation.whynot.relaxing import modules_of, useful_number
from tsplan.explanation.whynot.rewriting import rewritten
from tsplan.explanation.whynot.soft_constraints import robot_entries
from tsplan.mission import Mission, mission_from_text


def only(mission: Mission) -> Fact:
    """The one fact of a mission, whose parts indeed cannot hold together."""
    (fact,) = facts_of(Context(mission))
    own = frozenset().union(*(part.constraints for part in fact.parts))
    assert not holds_without(mission, own)
    return fact


@pytest.mark.parametrize("seeds", seed_blocks([9, 16, 27, 38], [*range(40, 2000), 3, 19], 20))
def test_what_is_said_of_modular_missions_is_so(seeds: list[int]) -> None:
    explained = 0
    for seed in seeds:
        explained += check_explanation(random_module_mission(seed)).status == "explained"
    assert explained


def test_there_are_as_many_structures_as_modules_can_be() -> None:
    mission = fence(formula="F[0,12] T(2, wall, {(lift,3)})")
    assert [mission.having(name) for name in ("lift", "drill", "look", None)] == [1, 1, 5, 5]
    fact = only(mission)
    assert fact.text == (
        "3 agents with lift are needed at 'wall'; the team has 1 (5 module in structures of 3 or "
        "more)"
    )


@pytest.mark.long
def test_robots_count_beside_structures() -> None:
    team = "[{class: module, count: 6, at: dock, configuration: single}, {class: crane, at: yard, "
    team += "capabilities: [lift]}]"
    assert fence(team=team).having("lift") == 3
    fact = only(fence(formula="F[0,12] T(2, wall, {(lift,4)})", team=team))
    assert fact.text.endswith("the team has 3 (1 crane, 6 module in structures of 3 or more)")


def test_modules_that_are_too_few_for_any_structure() -> None:
    team = "[{class: module, count: 2, at: dock, configuration: single}]"
    made = check_explanation(fence(formula="F[0,12] T(2, wall, {(lift,1)})", team=team))
    assert made.facts[0].text.endswith("the team has none")
    assert "the team has 2 agents of class module" in [
        part.text for part in made.conflicts[0].parts
    ]
    assert any(change.text == "add 1 agent of class module at 'dock'" for change in made.changes)


def test_structures_must_be_built_before_they_can_be_there() -> None:
    fact = only(fence(formula="F[0,6] T(2, wall, {(lift,1)})"))
    assert fact.kind == "reach"
    assert fact.text.endswith("the first such structure of class module can be there at step 7")
    assert tsplan.plan(fence(formula="F[0,7] T(2, wall, {(lift,1)})")).has_paths


def test_structures_at_one_step_that_need_more_modules_than_there_are() -> None:
    formula = "F[0,9] (T(2, wall, {(lift,1)}) && T(2, yard, {(drill,1)}))"
    fact = only(fence(formula=formula))
    assert fact.text == (
        "at one step, 1 agent with lift is needed at 'wall' and 1 agent with drill is needed at "
        "'yard': structures of 7 modules or more in all; the team has 5 module"
    )


def test_modules_are_added_in_whole_structures() -> None:
    team = "[{class: module, count: 3, at: dock, configuration: line}]"
    made = check_explanation(fence(formula="F[0,12] T(2, wall, {(lift,2)})", team=team))
    (added,) = [change for change in made.changes if change.kind == "add_agents"]
    assert added.text == "add 3 agents of class module at 'dock'"
    assert (added.amount, added.within) == (3, 1)


def test_a_changed_file_says_how_many_modules_there_are() -> None:
    original = fence(formula="F[0,12] T(2, wall, {(lift,2)})")
    made = tsplan.explain(original)
    (added,) = [change for change in made.changes if change.kind == "add_agents"]
    text, lost = rewritten(original, added.mission, Path(), Path())
    assert not lost
    assert mission_from_text(text).team == added.mission.team
    assert "{class: module, count: 6, at: dock, configuration: single}" in text


def test_more_modules_are_of_use_than_serve_at_once() -> None:
    mission = fence(team="[{class: module, count: 3, at: dock, configuration: line}]")
    (entry,) = robot_entries(mission)
    assert modules_of(mission, mission.team[entry]) == 3
    assert useful_number(mission, entry) % 3 == 0
    assert useful_number(mission, entry) >= 4 + 1  # a ring, and one that looks


def test_structures_leave_their_depots_at_the_step_at_which_they_would_start() -> None:
    team = "[{class: module, count: 3, at: dock, configuration: line}]"
    mission = fence(formula="F[0,5] T(1, wall, {(lift,1)}) && G[0,0] max(wall) <= 0", team=team)
    assert tsplan.plan(plain(mission)).has_paths  # a line goes 3 + 2 steps
    assert holds_without(mission, everything(mission))
    late = fence(formula="F[0,4] T(1, wall, {(lift,1)}) && G[0,0] max(wall) <= 0", team=team)
    assert not holds_without(late, everything(late))
    check_explanation(late)


def test_what_serves_a_task_is_a_structure_of_modules() -> None:
    mission = fence()
    plan = tsplan.plan(mission)
    words = str(plan.explain(mission))
    assert "line-1 (module-" in words
    assert "single-" in words


def test_a_reconfiguration_is_offered_at_more_places_or_in_fewer_steps() -> None:
    original = fence(formula="F[0,6] T(2, wall, {(lift,1)})")
    made = check_explanation(original)
    offered = {change.text: change for change in made.changes if change.kind == "reconfigure"}
    assert set(offered) == {
        "rebuild 3 single into 1 line in 1 step less (now 2 steps)",
        "rebuild 1 line and 1 single into 1 ring in 2 steps less (now 3 steps)",
        "let 3 single become 1 line at 'wall', too",
        "let 3 single become 1 line everywhere",
    }
    for change in offered.values():
        text, lost = rewritten(original, change.mission, Path(), Path())
        assert not lost
        assert mission_from_text(text).modular == change.mission.modular
        assert "single: {modules: 1, capabilities: [look]}" in text  # the rest stays as it was


@pytest.mark.long
def test_no_reconfiguration_is_offered_where_none_helps() -> None:
    made = check_explanation(fence(formula="F[0,12] T(2, wall, {(lift,3)})"))
    assert "reconfigure" not in {change.kind for change in made.changes}
