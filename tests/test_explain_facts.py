"""Facts: each kind of them, and that none is ever stated of a mission that has a plan."""

from __future__ import annotations

from dataclasses import replace

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import tsplan
from tests.explaining import plain
from tests.joint_plans import small_enough
from tests.test_explain_conflicts import ROW, row
from tsplan.explanation import Fact
from tsplan.explanation.whynot.context import Context
from tsplan.explanation.whynot.fact_finders import facts_of
from tsplan.mission import Group, Mission
from tsplan.testing import random_mission, random_swarm_mission, random_task_mission
from tsplan.ts import TransitionSystem

SWARM = {"size": 10, "at": {"q": 10}}


def facts(mission: Mission) -> list[Fact]:
    return list(facts_of(Context(mission)))


def only(mission: Mission) -> Fact:
    """The one fact of a mission that indeed cannot be met."""
    (fact,) = facts(mission)
    assert not tsplan.plan(plain(mission)).has_paths
    assert fact.parts
    return fact


def swarm(formula: str, **bounds: int) -> Mission:
    return Mission.of(map=ROW, swarm={**SWARM, **bounds}, formula=formula)


def test_scarcity_of_one_task_with_its_arithmetic() -> None:
    fact = only(row("F[0,4] T(1, B, {(see, 3)})", language="catl"))
    assert fact.kind == "scarcity"
    assert fact.text == "3 agents with see are needed at 'B'; the team has 2 (2 a)"
    assert (fact.place.line, fact.place.column) == (1, 8)


def test_scarcity_of_several_tasks_at_one_step() -> None:
    fact = only(row("F[0,9] (T(1, B, {(see, 2)}) && T(1, C, {(see, 1)}))", language="catl"))
    assert fact.kind == "scarcity"
    assert fact.text.startswith("at one step, ")
    assert "3 agents with see in all; the team has 2 (2 a)" in fact.text


def test_scarcity_where_an_until_changes_over() -> None:
    fact = only(row("A U[0,9] (B && sum(C) >= 2)"))
    assert fact.text.startswith("at one step, 1 agent is needed at 'B' and 2 agents are needed")


def test_a_capability_that_nobody_has() -> None:
    fact = only(row("F[0,4] sum(B, lift) >= 1"))
    assert fact.text == "1 agent with lift is needed at 'B'; the team has none"


def test_a_place_out_of_reach_in_time() -> None:
    fact = only(row("F[0,2] sum(C, see) >= 1"))
    assert fact.kind == "reach"
    assert "nobody with see can be at any C state by step 2" in fact.text
    assert "at step 3 by p > q > r" in fact.text


def test_a_place_without_a_way() -> None:
    edges = [edge for edge in ROW.edges.values() if edge.pair != ("q", "r")]
    mission = replace(row("F[0,30] min(C) >= 1"), system=_map(ROW.states.values(), edges))
    fact = only(mission)
    assert fact.kind == "reach"
    assert fact.text.endswith("there is no way for class a from 'p'")


def test_only_some_of_those_who_are_needed_come_in_time() -> None:
    team = [Group.of("a", {"p": 2}, ["see"]), Group.of("b", {"q": 1}, ["see"])]
    fact = only(row("F[0,2] sum(C, see) >= 2", team=team))
    assert "only 1 of the agents with see" in fact.text
    assert "the next is one of class a" in fact.text


def test_too_little_room_at_a_state() -> None:
    states = [replace(s, capacity=1) if s.name == "q" else s for s in ROW.states.values()]
    mission = replace(row("F[0,9] min(B) >= 2"), system=_map(states, ROW.edges.values()))
    fact = only(mission)
    assert fact.kind == "capacity"
    assert fact.text == "2 agents must be at 'B', and 'q' holds 1"


def test_a_limit_against_a_need() -> None:
    fact = only(row("F[2,4] sum(B) >= 2 && G[0,5] max(B) <= 1"))
    assert fact.kind == "contradiction"
    assert "2 agents must be at 'B' at one of the steps 2..4" in fact.text
    assert "at most 1 agent may be there during the steps 0..5" in fact.text


def test_a_limit_that_leaves_room_too_early() -> None:
    fact = only(row("F[0,4] sum(C) >= 1 && G[3,9] sum(C) <= 0"))
    assert fact.kind == "room"
    assert "nobody can see to it before step 3" in fact.text


def test_windows_that_leave_no_time_for_both() -> None:
    fact = only(row("F[0,4] G[0,1] sum(B) >= 2 && F[1,3] sum(C) >= 1"))
    assert fact.kind == "timing"
    assert "so somebody must see to both" in fact.text


def test_more_places_than_sub_swarms() -> None:
    fact = only(swarm("F[2,6] (A && B && C)", max_subswarms=2))
    assert fact.kind == "swarm"
    assert "at 3 places ('A', 'B', 'C')" in fact.text
    assert fact.text.endswith("the swarm may be divided into 2 sub-swarms at most")


def test_sub_swarms_that_are_too_large() -> None:
    fact = only(swarm("F[2,6] (A && B && C)", min_subswarm=4))
    assert fact.text.endswith("in sub-swarms of 4 or more: 12 in all; the swarm has 10")


def test_more_sub_swarms_of_all_swarms_than_may_be() -> None:
    one = {"size": 6, "at": {"q": 6}}
    mission = Mission.of(
        map=ROW,
        swarms=[{"name": "x", **one}, {"name": "y", **one}],
        max_subswarms=2,
        formula="F[2,6] (sum(A, x) >= 2 && sum(C, x) >= 2)",
    )
    fact = only(mission)
    assert fact.text == (
        "at one step there must be 3 sub-swarms: x at 2 ('A', 'C'), y at 1 (anywhere); all swarms "
        "together may be divided into 2 sub-swarms at most"
    )
    assert not facts(
        Mission.of(
            map=ROW,
            swarms=[{"name": "x", **one}, {"name": "y", **one}],
            max_subswarms=3,
            formula="F[2,6] (sum(A, x) >= 2 && sum(C, x) >= 2)",
        )
    )


def test_a_start_that_breaks_a_bound() -> None:
    mission = Mission.of(
        map=ROW,
        swarm={"size": 10, "at": {"p": 2, "q": 8}, "max_subswarms": 1, "min_subswarm": 3},
        formula="F[0,2] B",
    )
    places, agents = (fact.text for fact in facts(mission))
    assert places.startswith("the swarm starts at 2 states, in as many sub-swarms, and ")
    assert places.endswith("at most 1 sub-swarm at a step")
    assert agents.startswith("only 2 agents of the swarm start at 'p', and ")
    assert agents.endswith("every sub-swarm of the swarm has at least 3 agents")
    assert not tsplan.plan(mission).has_paths


@pytest.mark.parametrize(
    "formula",
    [
        "F[0,2] C || F[0,9] A",  # one side is enough
        "!(F[0,2] C)",
        "F[0,2] C => B",
        "F[0,3] C",  # just in time
        "F[0,4] sum(A) >= 2 && F[0,4] sum(B) >= 2",  # one after the other
        "G[0,9] F[0,3] B",
        "F[0,1] B R[0,3] A",
        "A U[2,5] B",
    ],
)
def test_no_facts_where_there_is_a_plan(formula: str) -> None:
    mission = row(formula)
    assert tsplan.plan(mission).has_paths
    assert facts(mission) == []


def test_no_facts_of_swarms_that_can_divide() -> None:
    mission = swarm("F[2,6] (A && B && C)", max_subswarms=3, min_subswarm=3)
    assert tsplan.plan(mission).has_paths
    assert facts(mission) == []


@settings(max_examples=25, deadline=None)
@given(seed=st.integers(0, 10**6))
def test_facts_are_proofs_for_tasks(seed: int) -> None:
    mission = random_task_mission(seed)
    if facts(mission):
        assert tsplan.plan(plain(mission)).status == "infeasible"


@settings(max_examples=25, deadline=None)
@given(seed=st.integers(0, 10**6))
def test_facts_are_proofs_for_counts(seed: int) -> None:
    mission = random_mission(seed)
    if facts(mission):
        assert tsplan.plan(plain(mission)).status == "infeasible"


@settings(max_examples=25, deadline=None)
@given(seed=st.integers(0, 10**6))
def test_facts_are_proofs_for_swarms(seed: int) -> None:
    mission = random_swarm_mission(seed, fits=small_enough)
    if facts(mission):
        assert tsplan.plan(plain(mission)).status == "infeasible"


@pytest.mark.long
@settings(max_examples=3000, deadline=None)
@given(seed=st.integers(0, 10**9), kind=st.sampled_from([random_task_mission, random_mission]))
def test_facts_are_proofs_for_many(seed: int, kind) -> None:
    mission = kind(seed)
    if facts(mission):
        assert tsplan.plan(plain(mission), encoding="reference").status == "infeasible"


def _map(states, edges) -> TransitionSystem:
    return TransitionSystem.build(states, edges)
