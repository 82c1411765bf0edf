"""Missions of robots and swarms: facts, conflicts and changes go by the class."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

import tsplan
from tests.explaining import elements, plain
from tests.test_explain_conflicts import ROW
from tsplan import Mission
from tsplan.explanation import Explanation, SoftConstraint, explain
from tsplan.explanation.whynot.relaxing import relaxed
from tsplan.explanation.whynot.rewriting import rewritten
from tsplan.explanation.whynot.soft_constraints import formula_groups, named_facts
from tsplan.mission import Group, mission_from_text

SWARM = {"size": 6, "at": {"q": 6}, "max_subswarms": 2, "min_subswarm": 1}
ALL_PLACES = "F[2,6] (sum(A,swarm) >= 1 && sum(B,swarm) >= 1 && sum(C,swarm) >= 1)"


def mixed(formula: str) -> Mission:
    """Two carts at one end of the row, and a swarm of six in its middle."""
    carts = [Group.of("cart", {"p": 2}, ["lift"])]
    return Mission.of(map=ROW, team=carts, swarm=SWARM, formula=formula, language="mtl")


def possible(mission: Mission, kept: frozenset[SoftConstraint]) -> bool:
    """Whether there is a plan with some soft constraints alone."""
    groups = formula_groups(mission)
    every = frozenset(item for group in groups for item in group) | {*named_facts(mission)}
    plan = tsplan.plan(relaxed(mission, every - kept), time_limit=60)
    assert plan.status in ("optimal", "feasible", "infeasible")
    return plan.has_paths


def checked(mission: Mission) -> Explanation:
    """An explanation whose conflict is minimal and whose changes do and are least."""
    made = explain(mission)
    for conflict in made.conflicts:
        core = elements(conflict)
        assert conflict.minimal
        assert not possible(mission, core)
        assert all(possible(mission, core - {item}) for item in core)
    for change in made.changes:
        assert change.proven
        assert tsplan.plan(plain(change.mission)).has_paths
        less = change.steps[0][0].applied(mission, change.amount - 1)
        assert len(change.steps) > 1 or not tsplan.plan(plain(less)).has_paths
    return made


def test_soft_constraints_go_by_the_class() -> None:
    assert named_facts(mixed("F[0,6] C")) == (
        SoftConstraint("team", (0,)),
        SoftConstraint("start", (0,)),
        SoftConstraint("swarm", ("swarm", "most")),
    )


@pytest.mark.parametrize(
    ("formula", "kinds", "change"),
    [
        ("F[0,4] sum(C,lift) >= 3", {"formula", "team"}, "add 1 agent of class cart at 'p'"),
        ("F[0,2] sum(C,lift) >= 1", {"formula", "start"}, "add 1 agent of class cart at 'q'"),
        (ALL_PLACES, {"formula", "swarm"}, "raise max_subswarms from 2 to 3"),
        (
            "G[0,9] sum(B) <= 3 && F[0,6] sum(C,lift) >= 1",
            {"formula"},
            "loosen the limit at 'B' from 3 to 6 agents in G[0,9] sum(B) <= 3",
        ),
    ],
)
def test_conflicts_and_changes(formula: str, kinds: set[str], change: str) -> None:
    made = checked(mixed(formula))
    assert made.status == "explained"
    assert {part.kind for part in made.conflicts[0].parts} == kinds
    assert change in [item.text for item in made.changes]


def test_robots_and_swarms_change_together() -> None:
    made = checked(mixed(f"F[0,2] sum(C,lift) >= 3 && {ALL_PLACES}"))
    (change,) = made.changes
    assert {edit.number.kind for edit, _ in change.steps} == {"formula", "swarm"}


def test_facts() -> None:
    (scarce,) = explain(mixed("F[0,4] sum(C,lift) >= 3")).facts
    assert scarce.text.endswith("the team has 2 (2 cart)")
    (split,) = explain(mixed(ALL_PLACES)).facts
    assert "the swarm may be divided into 2 sub-swarms at most" in split.text


def test_what_can_be_met_is_told_tight_for_both() -> None:
    made = explain(mixed("F[0,6] (sum(C,lift) >= 1 && sum(A,swarm) >= 2)"), slack=True)
    said = [fact.text for fact in made.facts]
    assert "the deadline 6 could be 3 steps sooner, at 3" in " ".join(said)
    assert "the swarm has at most 2 sub-swarms at a step: it could be 1" in said


TEXT = """\
format: tsplan-mission/1
map:
  waiting: true
  states: {p: {labels: [A]}, q: {labels: [B]}, r: {labels: [C]}}
  edges:
    - {from: p, to: q, duration: 1, both_ways: true}
    - {from: q, to: r, duration: 2, both_ways: true}
team:
  - {class: cart, count: 2, at: p, capabilities: [lift]}  # carts
swarm: {size: 6, at: {q: 6}, max_subswarms: 2}  # fish
spec: {language: mtl, formula: FORMULA}
"""


@pytest.mark.parametrize("formula", ["F[0,2] sum(C,lift) >= 3", ALL_PLACES])
def test_a_changed_file_is_read_as_the_changed_mission(formula: str) -> None:
    original = mission_from_text(TEXT.replace("FORMULA", f'"{formula}"'))
    made = explain(original)
    assert made.changes
    assert all(part.place.line for conflict in made.conflicts for part in conflict.parts)
    for change in made.changes:
        text, lost = rewritten(original, change.mission, Path(), Path())
        assert lost == (len(change.mission.team) > len(original.team))  # the team anew
        read = mission_from_text(text)
        assert replace(read, digest="", origin=None) == replace(
            change.mission, origin=None, text=read.text
        )
