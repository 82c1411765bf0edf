"""Booking: which agents serve what, what is refused, and what is told of it."""

from __future__ import annotations

from dataclasses import replace
from math import inf
from pathlib import Path

import pytest

import tsplan
from tests.joint_plans import how_many
from tests.resource_missions import most_options, random_booked_mission
from tests.seeds import seed_blocks
from tests.test_resources_brute_force import MOST, compare
from tsplan import Mission
from tsplan.checking.plan_check import check
from tsplan.encode import bookings
from tsplan.encode.bookings import telling_sets
from tsplan.errors import MissionError
from tsplan.explanation.whynot.rewriting import rewritten
from tsplan.mission import load_mission, mission_from_text
from tsplan.mission.vocabulary import BOOKINGS
from tsplan.plans.summary import supply_lines
from tsplan.plans.supplies import ExecutedTask

TEXT = """\
format: tsplan-mission/1
map:
  waiting: true
  states: {yard: {}, road: {}, wall: {labels: [site, wet]}, well: {labels: [wet]}}
  edges: [{from: yard, to: road, duration: 1, both_ways: true},
    {from: road, to: wall, duration: 1, both_ways: true},
    {from: road, to: well, duration: 1, both_ways: true}]
team:
  - {class: man, count: 3, at: yard, capabilities: [lay, look]}
  - {class: eye, count: 1, at: yard, capabilities: [look]}
spec:
  language: catl
  formula: 'FORMULA'
objective: [travel]
booking: exclusive
horizon: 6
"""
LAY, LOOK, BOTH = "T(1,site,{(lay,1)})", "T(1,site,{(look,1)})", "T(1,site,{(lay,1),(look,1)})"
TWO = f"F[2,2] {LAY} && F[2,2] {LOOK}"
MOST_OPTIONS = 9
"""Executions that may be tried along a joint plan, each set of them."""


def mission(formula: str, *changes: tuple[str, str]) -> Mission:
    text = TEXT
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    return mission_from_text(text.replace("FORMULA", formula))


def travel(made: Mission, encoding: str = "tight") -> float | None:
    plan = tsplan.plan(made, encoding=encoding)
    if plan.status == "infeasible":
        return None
    assert plan.status == "optimal"
    assert plan.verified
    return plan.objective[0].value


# --- who serves what ---------------------------------------------------------------------------


@pytest.mark.parametrize("encoding", ["tight", "reference"])
@pytest.mark.parametrize(
    ("formula", "shared", "labels", "exclusive"),
    [
        (TWO, 2, 2, 4),
        (f"F[2,2] {BOTH}", 2, 2, 4),  # one task, two capabilities
        (f"F[2,2] {LAY} && F[2,2] T(2,wall,{{(lay,1)}})", 2, 4, 4),  # two labels of one state
        (f"F[2,2] {BOTH} && F[2,2] T(0,wall,{{(look,2)}})", 4, 6, 8),
        (f"G[2,3] {LAY}", 2, 2, 4),  # one task twice, and both run at step 3
        (f"F[2,2] {LAY} && F[4,4] {LOOK}", 2, 2, 2),  # one after the other
        (f"F[2,3] {LAY} && F[2,4] {LOOK}", 2, 2, 2),
        ("F[2,2] T(0,site,{(lay,3)}) && F[2,2] T(0,site,{(look,2)})", 6, 6, None),
        ("F[2,2] T(0,wet,{(lay,1)}) && F[2,2] T(0,site,{(lay,1)})", 4, 6, 6),  # wet at both states
        (f"{TWO} && F[2,2] (sum(site) >= 2)", 4, 4, 4),  # others count for what is no task
        (f"F[2,2] {LAY} && F[2,2] {LAY}", 2, 2, 2),  # one formula
    ],
)
def test_agents_serve_what_they_are_booked_for(encoding, formula, shared, labels, exclusive):
    for booking, value in zip(BOOKINGS, (shared, labels, exclusive), strict=True):
        made = mission(formula, ("exclusive", booking))
        assert travel(made, encoding) == value, booking


@pytest.mark.parametrize("encoding", ["tight", "reference"])
@pytest.mark.parametrize(("number", "status"), [(2, "optimal"), (3, "infeasible")])
def test_where_there_is_no_time_to_move_agents_are_counted(encoding, number, status):
    formula = f"T(0,yard,{{(lay,2)}}) && T(0,yard,{{(look,{number})}})"
    made = mission(formula, ("horizon: 6", "horizon: 0"))
    assert tsplan.plan(made, encoding=encoding).status == status
    labelled = replace(made, booking="per-label")
    assert tsplan.plan(labelled, encoding=encoding).status == "optimal"


def test_shared_agents_are_planned_for_as_ever():
    made = mission(TWO, ("booking: exclusive\n", ""))
    named = mission(TWO, ("exclusive", "shared"))
    assert made.goal is named.goal
    first, second = (tsplan.Problem(item).model for item in (made, named))
    assert first.size == second.size
    assert (first.matrix != second.matrix).nnz == 0
    plan = tsplan.plan(made)
    assert not plan.executions
    assert "booking" not in made.to_yaml()


def test_a_half_open_task_ends_a_step_sooner():
    formula = f"F[2,2] {LAY} && F[3,3] {LOOK}"
    assert travel(mission(formula)) == 4
    assert travel(mission(formula, ("horizon: 6", "task_interval: half-open"))) == 2


def test_sets_of_capabilities_that_say_nothing_more_are_left_out():
    one, two, both = frozenset("a"), frozenset("b"), frozenset("ab")
    assert telling_sets([one, two], "ab", 9) == [one, two]
    assert telling_sets([one, two, both], "ab", 9) == [one, two, both]
    assert telling_sets([both], "ab", 9) == [both]
    assert telling_sets([one], "ab", 9) == [one, two]  # nobody has b
    assert telling_sets([one, two, both], "ab", 2) is None


# --- all joint plans ---------------------------------------------------------------------------


@pytest.mark.parametrize("seeds", seed_blocks(range(2), range(500), 4))
@pytest.mark.parametrize("booking", BOOKINGS)
def test_tiny_missions_are_planned_as_well_as_by_all_joint_plans(seeds, booking):
    for seed in seeds:
        made = random_booked_mission(seed, booking)
        if how_many(made) <= MOST and most_options(made) <= MOST_OPTIONS:
            compare(made, 1.0)


@pytest.mark.parametrize("seeds", seed_blocks(range(500, 502), range(500, 700), 4))
def test_a_flow_says_the_same_as_sets_of_capabilities(monkeypatch, seeds):
    written = []
    flow = bookings._assigned
    monkeypatch.setattr(bookings, "_assigned", lambda *given: written.append(flow(*given)))
    for seed in seeds:
        made = random_booked_mission(seed, "exclusive", robots=4, steps=5)
        values = []
        for most in (bookings.MOST_SETS, 0):
            with monkeypatch.context() as patch:
                patch.setattr(bookings, "MOST_SETS", most)
                plans = [tsplan.plan(made, encoding=name) for name in ("tight", "reference")]
            values += [[item.value for item in plan.objective] for plan in plans]
        assert values[1:] == values[:-1], made.text
    assert written


@pytest.mark.long
def test_the_random_missions_are_of_all_kinds():
    found = []
    for seed in range(40):
        made = random_booked_mission(seed, "shared")
        found.append([travel(replace(made, booking=b, objective=("travel",))) for b in BOOKINGS])
    worth = [[inf if value is None else value for value in values] for values in found]
    assert all(values == sorted(values) for values in worth)  # who is exclusive is also by label
    assert sum(None not in values for values in found) >= 10
    assert sum(shared != labels for shared, labels, _ in found) >= 2
    assert sum(labels != exclusive for _, labels, exclusive in found) >= 5


# --- missions ----------------------------------------------------------------------------------


def test_a_mission_is_written_and_made_as_it_is_read():
    made = mission(TWO, ("exclusive", "per-label"))
    assert made.booking == "per-label"
    assert mission_from_text(made.to_yaml()) == made
    again = Mission.of(
        map=made.system,
        team=made.team,
        formula=TWO,
        objective=["travel"],
        booking="per-label",
        horizon=6,
    )
    assert again == made


def refused(text: str) -> list[str]:
    with pytest.raises(MissionError) as caught:
        mission_from_text(text)
    return [f"{f.line}:{f.column} {f.message}; {f.remedy}" for f in caught.value.findings]


@pytest.mark.parametrize(
    ("formula", "change", "place", "words"),
    [
        (TWO, ("exclusive", "exclusiv"), "15:10", "did you mean 'exclusive'"),
        (TWO, ("exclusive", "[per-label]"), "15:10", "is no way to book agents"),
        (TWO, ("horizon: 6", "delay: 1"), "16:8", "plan without delay"),
        (TWO, ("[travel]", "[delay]"), "14:13", "plan without delay"),
        (TWO, ("team:", "swarms: [{name: s, size: 2, at: yard}]\nteam:"), "16:10", "as a team"),
        (TWO, ("horizon: 6", "dynamics: expected"), "15:10", "expected numbers"),
        (TWO, ("[travel]", "[{satisfaction: weighted}]"), "13:20", "books agents, and what holds"),
        (f"! F[0,2] {LAY}", ("", ""), "13:22", "that books agents is executed or not"),
        (f"wall <=> F[0,2] {LAY}", ("", ""), "13:29", "remove the negation"),
    ],
)
def test_bad_input_has_its_place(formula, change, place, words):
    told = refused(TEXT.replace("FORMULA", formula).replace(*change, 1))
    assert any(line.startswith(f"{place} ") and words in line for line in told), told


def test_preferences_execute_nothing():
    text = TEXT.replace("  formula: 'FORMULA'", f"  must: true\n  prefer: [{{formula: '{LAY}'}}]")
    assert any("books agents, and what holds in part" in line for line in refused(text))


@pytest.mark.parametrize("encoding", ["tight", "reference"])
def test_what_is_preferred_counts_whoever_is_there(encoding):
    wishes = "[{formula: 'F[2,2] sum(yard) >= 2', weight: 2}, {formula: 'F[2,2] sum(wall) >= 4'}]"
    text = TEXT.replace("  formula: 'FORMULA'", f"  must: '{TWO}'\n  prefer: {wishes}")
    plan = tsplan.plan(mission_from_text(text), encoding=encoding)
    assert [item.met for item in plan.preferences] == [True, False]
    assert plan.objective[1].value == 4


def test_a_booking_of_nothing_is_warned_of():
    (warning,) = mission("F[0,3] sum(wall) >= 1").warnings
    assert "no task is in the formula" in str(warning)
    assert not mission(TWO).warnings


def test_an_unknown_word_is_refused_wherever_it_comes_from():
    with pytest.raises(MissionError, match="did you mean 'exclusive'"):
        replace(mission(TWO), booking="exclusives")


# --- plans -------------------------------------------------------------------------------------


def test_a_plan_says_what_it_executes():
    made = mission(TWO)
    plan = tsplan.plan(made)
    assert plan.executions == (ExecutedTask(LAY, "wall", 2), ExecutedTask(LOOK, "wall", 2))
    assert tsplan.Plan.from_json(plan.to_json()) == plan
    assert any(
        "2 executions" in fact and "no other task" in fact for fact in check(made, plan).facts
    )
    assert f"  executed at wall at step 2: {LAY}" in supply_lines(plan)
    assert "met at 2" in str(plan.explain(made))


@pytest.mark.parametrize(
    ("formula", "booking", "words"),
    [
        (TWO, "exclusive", "1 with lay, 1 with look are needed, each agent for one task, and 1"),
        (f"F[2,2] {BOTH}", "exclusive", "each agent for one task, and 1 of these 2"),
        (f"G[2,3] {LAY}", "exclusive", "at step 3: 2 with lay are needed"),
        (f"F[2,2] {LAY} && F[2,2] T(2,wall,{{(lay,1)}})", "per-label", "1 for site and 1 for wall"),
    ],
)
def test_plans_with_too_few_agents_are_refused(formula, booking, words):
    made = mission(formula, ("exclusive", booking))
    shared = replace(made, booking="shared")
    plan = tsplan.plan(made)
    few = tsplan.plan(shared)
    forged = replace(few, mission=plan.mission, executions=plan.executions)
    assert check(made, plan).ok
    report = check(made, forged)
    assert any(words in str(finding) for finding in report.findings), report.findings


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"executions": ()}, "does not hold"),
        ({"executions": (ExecutedTask(LAY, "wall", 2),)}, "does not hold"),
        ({"executions": (ExecutedTask("T(9,site,{(lay,1)})", "wall", 2),)}, "no such task"),
        ({"executions": (ExecutedTask(LAY, "well", 2),)}, "does not have the label"),
        ({"executions": (ExecutedTask(LAY, "wall", 6),)}, "beyond the horizon"),
        ({"executions": (ExecutedTask(LAY, "wall", 0),)}, "0 agents for lay"),
    ],
)
def test_forged_executions_are_refused(change, words):
    made = mission(TWO)
    report = check(made, replace(tsplan.plan(made), **change))
    assert any(words in str(finding) for finding in report.findings), report.findings


def test_executions_of_shared_agents_are_none_of_the_mission():
    made = mission(TWO, ("exclusive", "shared"))
    plan = replace(tsplan.plan(made), executions=(ExecutedTask(LAY, "wall", 2),))
    assert "no such task" in str(check(made, plan).findings)


# --- explanations ------------------------------------------------------------------------------


def test_to_share_agents_is_a_proven_change(tmp_path):
    made = mission(
        TWO, ("count: 3, ", ""), ("  - {class: eye, count: 1, at: yard, cap", "  # {cap")
    )
    explained = tsplan.explain(made)
    (conflict,) = explained.conflicts
    assert "booking" in {part.kind for part in conflict.parts}
    change = next(item for item in explained.changes if item.kind == "share_agents")
    assert change.proven
    assert tsplan.plan(change.mission).status == "optimal"
    text = rewritten(made, change.mission, tmp_path, tmp_path).text
    assert text == made.origin.content.replace("exclusive", "shared")
    added = next(item for item in explained.changes if item.kind == "add_agents")
    assert added.proven


def test_what_is_tight_is_told_of_agents_that_are_booked():
    explained = tsplan.explain(replace(mission(TWO), objective=("availability",)))
    assert explained.status == "feasible"
    assert "availability 2" in explained.facts[0].text  # told of the shared counts


def test_the_shipped_mission_costs_more_than_with_shared_agents():
    made = load_mission(Path(__file__).parents[1] / "environments" / "site_booked.yaml")
    values = [travel(replace(made, booking=booking)) for booking in BOOKINGS]
    assert values == [7, 7, 10]
