"""Missions of robots and swarms: facts, conflicts and changes go by the class."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from random import Random

import pytest

from tests.explaining import check_explanation
from tests.joint_plans import small_enough
from tests.seeds import long, sampled
from tests.test_explain_conflicts import ROW
from tsplan import Mission
from tsplan.errors import MissionError
from tsplan.explanation import SoftConstraint, explain
from tsplan.explanation.whynot.rewriting import rewritten
from tsplan.explanation.whynot.soft_constraints import named_facts
from tsplan.logic import conjunction, parse
from tsplan.logic.text import quoted
from tsplan.mission import Group, mission_from_text
from tsplan.testing.random_missions import random_swarm_mission

SWARM = {"size": 3, "at": {"q": 3}, "max_subswarms": 2, "min_subswarm": 1}
ALL_PLACES = "F[2,4] (sum(A,swarm) >= 1 && sum(B,swarm) >= 1 && sum(C,swarm) >= 1)"


def mixed(formula: str) -> Mission:
    """Two carts at one end of the row, and a swarm of three in its middle."""
    carts = [Group.of("cart", {"p": 2}, ["lift"])]
    return Mission.of(map=ROW, team=carts, swarm=SWARM, formula=formula, language="mtl")


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
        long("F[0,2] sum(C,lift) >= 1", {"formula", "start"}, "add 1 agent of class cart at 'q'"),
        long(ALL_PLACES, {"formula", "swarm"}, "raise max_subswarms from 2 to 3"),
        (
            "G[0,4] sum(B) <= 2 && F[0,4] sum(C,lift) >= 1",
            {"formula"},
            "loosen the limit at 'B' from 2 to 3 agents in G[0,4] sum(B) <= 2",
        ),
    ],
)
def test_conflicts_and_changes(formula: str, kinds: set[str], change: str) -> None:
    made = check_explanation(mixed(formula))
    assert made.status == "explained"
    assert {part.kind for part in made.conflicts[0].parts} == kinds
    assert change in [item.text for item in made.changes]


def test_robots_and_swarms_change_together() -> None:
    made = check_explanation(mixed(f"F[0,2] sum(C,lift) >= 3 && {ALL_PLACES}"))
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
swarm: {size: 3, at: {q: 3}, max_subswarms: 2}  # fish
spec: {language: mtl, formula: FORMULA}
"""


@pytest.mark.parametrize("formula", ["F[0,2] sum(C,lift) >= 3", long(ALL_PLACES)])
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


def random_mixed(seed: int) -> Mission | None:
    """A small random mission of swarms with one or two robots beside them, and a task for these."""
    random = Random(f"mixed {seed}")
    swarms = random_swarm_mission(seed, fits=small_enough)
    states = list(swarms.system.states)
    robots = Group.of("cart", {random.choice(states): random.randint(1, 2)}, ["lift"])
    last = random.randint(0, 3)
    label = quoted(random.choice(sorted(swarms.system.labels)))
    task = parse(f"F[0,{last}] sum({label},lift) >= {random.randint(1, 2)}")
    formula = conjunction([swarms.formula, task])
    team, steps = (robots, *swarms.team), max(swarms.horizon, last)
    try:
        return replace(swarms, team=team, formula=formula, text=str(formula), horizon=steps)
    except MissionError:
        return None  # a start over a state's capacity, or where a robot may not be


@pytest.mark.parametrize("seed", sampled(range(80), range(1)))
def test_random_missions_of_robots_and_swarms(seed: int) -> None:
    mission = random_mixed(seed)
    if mission is not None:
        check_explanation(mission)
