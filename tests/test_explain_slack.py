"""What is tight about missions that can be met: availability, deadlines, bounds of swarms."""

from __future__ import annotations

from dataclasses import replace

import pytest

import tsplan
from tests.explaining import plain
from tests.seeds import sampled
from tests.test_explain_conflicts import ROW, row
from tsplan.explanation import explain
from tsplan.explanation.why.tightness import tightened
from tsplan.logic import Eventually
from tsplan.mission import Mission
from tsplan.testing import random_task_mission


def said(mission: Mission, kind: str, *, slack: bool = True) -> list[str]:
    made = explain(mission, slack=slack)
    assert made.status == "feasible"
    assert made.conflicts == ()
    assert made.changes == ()
    return [fact.text for fact in made.facts if fact.kind == kind]


def test_deadlines_close_as_soon_as_they_can() -> None:
    assert said(row("F[0,9] sum(C) >= 2 && F[0,3] C && F[2,8] A"), "slack") == [
        "the deadline 9 could be 6 steps sooner, at 3, in F[0,9] sum(C) >= 2",
        "the deadline 3 cannot be a step sooner, in F[0,3] C",
        "the deadline 8 could be 6 steps sooner, at 2, in F[2,8] A",
    ]


def test_slack_is_only_looked_for_where_it_is_asked_for() -> None:
    assert said(row("F[0,9] C"), "slack", slack=False) == []


@pytest.mark.parametrize("seed", sampled(range(6), range(1)))
def test_a_deadline_a_step_sooner_than_said_cannot_be_met(seed: int) -> None:
    mission = row(f"F[0,{3 + seed}] C && F[{seed},9] G[0,{seed}] sum(A) >= 1 && F[0,9] B")
    first = mission.formula.children[0]
    assert isinstance(first, Eventually)
    text = said(mission, "slack")[0]
    high = 3 if seed else first.high
    assert (f"at {high}," in text) == (seed > 0)
    sooner = replace(first, high=2)
    changed = replace(mission, formula=sooner, text=str(sooner))
    assert tsplan.plan(plain(changed)).status == "infeasible"


def test_what_holds_availability_down_is_named_with_place_and_step() -> None:
    top, *atoms = said(row("F[3,3] sum(C, see) >= 1"), "tight")
    assert top.startswith("the most robust plans have 1 agent to spare (availability 1)")
    assert "the team has 2 agents of class a" in top
    (atom,) = atoms
    assert "2 agents with see at 'C' at step 3, at least 1 asked for" in atom


@pytest.mark.long
def test_the_most_robust_plan_has_no_more_to_spare() -> None:
    met = 0
    for seed in range(25):
        mission = random_task_mission(seed + 900)
        if not tsplan.plan(plain(mission)).has_paths:
            continue
        made = explain(mission)
        met += 1
        best = tsplan.plan(replace(mission, objective=("availability",)))
        if best.availability is None or best.availability == float("inf"):
            continue
        level = int(best.availability)
        assert f"availability {level})" in made.facts[0].text
        for spare, expected in ((level, True), (level + 1, False)):
            formula = tightened(mission, spare)
            harder = replace(mission, formula=formula, text=str(formula), objective=())
            assert tsplan.plan(harder, encoding="reference").has_paths is expected
    assert met >= 2


def test_bounds_of_swarms() -> None:
    mission = Mission.of(
        map=ROW,
        swarm={"size": 10, "at": {"q": 10}, "max_subswarms": 4, "min_subswarm": 2},
        formula="F[2,6] (A && B && C)",
    )
    deadline, most, least = said(mission, "slack")
    assert deadline.startswith("the deadline 6 could be 4 steps sooner, at 2")
    assert most == "the swarm has at most 4 sub-swarms at a step: it could be 3"
    assert least == "every sub-swarm of the swarm has at least 2 agents: it could be 3"
    assert said(mission, "tight") == []


def test_a_mission_that_asks_for_nothing() -> None:
    assert said(row("true"), "tight") == []
