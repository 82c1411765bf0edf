"""Defects of earlier tools in this field, each with a mission on which it would show.

Those of formulas alone (parsing, printing, negation) have their tests beside the logic.
"""

from __future__ import annotations

import pytest

import tsplan
from tsplan.mission import Group
from tsplan.ts import Edge, State, TransitionSystem


def planned(states, edges, team, text, *, language="mtl"):
    made = [State(name, labels=frozenset(labels)) for name, labels in states.items()]
    system = TransitionSystem.build(made, [Edge(*edge) for edge in edges])
    groups = [Group.of(name, starts, has) for name, starts, has in team]
    mission = tsplan.Mission.of(
        map=system, team=groups, formula=text, language=language, objective=["availability"]
    )
    plans = [tsplan.plan(mission, encoding=encoding) for encoding in ("tight", "reference")]
    assert plans[0].status == plans[1].status
    assert plans[0].availability == plans[1].availability
    for plan in plans:
        assert not plan.has_paths or tsplan.check(mission, plan).ok
    return plans[0]


LOOPS = [("p", "p"), ("q", "q")]
BOTH = [("p", "q"), ("q", "p")]


def test_states_without_labels_hold_agents() -> None:
    states = {"p": [], "way": [], "q": ["goal"]}
    edges = [("p", "way"), ("way", "q"), ("p", "p"), ("way", "way"), ("q", "q")]
    plan = planned(states, edges, [("r", {"p": 1}, [])], "G[2,3] goal")
    assert plan.status == "optimal"


def test_until_away_from_step_0() -> None:
    states = {"p": ["a"], "q": ["b"]}
    text = "F[3,3] (a U[1,2] b) && G[0,3] a"
    plan = planned(states, LOOPS + BOTH, [("r", {"p": 1}, [])], text)
    assert plan.status == "optimal"
    assert plan.agents[0].state_at(3) == "p"


def test_limits_hold_at_every_state_of_the_label() -> None:
    states = {"p": ["a"], "q": ["a"]}
    team = [("r", {"p": 3}, ["c"])]
    assert planned(states, LOOPS, team, "G[0,2] max(a,c) <= 2").status == "infeasible"
    assert planned(states, LOOPS + BOTH, team, "G[1,2] max(a,c) <= 2").status == "optimal"


def test_an_impossible_mission_is_not_optimal_with_negative_availability() -> None:
    plan = planned({"p": ["a"]}, [("p", "p")], [("r", {"p": 1}, [])], "sum(a) >= 2")
    assert (plan.status, plan.availability) == ("infeasible", None)


@pytest.mark.parametrize("agents", [30, 45])
def test_many_agents_in_one_region(agents: int) -> None:
    plan = planned({"p": ["a"]}, [("p", "p")], [("r", {"p": agents}, [])], "G[0,1] a")
    assert plan.availability == agents - 1


@pytest.mark.parametrize(("text", "status"), [("a", "optimal"), ("b", "infeasible")])
def test_horizon_0(text: str, status: str) -> None:
    plan = planned({"p": ["a"], "q": ["b"]}, LOOPS, [("r", {"p": 1}, [])], text)
    assert (plan.horizon, plan.status) == (0, status)


def test_a_capability_nobody_has_counts_zero() -> None:
    team = [("r", {"p": 1}, ["c"])]
    text = "F[0,3] T(1, a, {(zzz,1)})"
    plan = planned({"p": ["a"]}, [("p", "p")], team, text, language="catl")
    assert plan.status == "infeasible"


def test_counts_of_two_digits_and_nested_conjunctions() -> None:
    team = [("r", {"p": 12}, ["c"])]
    text = "T(0, a, {(c,10)}) && (T(1, a, {(c,11)}) && T(1, a, {(c,12)}))"
    plan = planned({"p": ["a"]}, [("p", "p")], team, text, language="catl")
    assert plan.availability == 0


def test_a_long_wait_makes_no_ghosts() -> None:
    edges = [("p", "p", 2), ("p", "q"), ("q", "q")]
    plan = planned({"p": ["a"], "q": ["b"]}, edges, [("r", {"p": 1}, [])], "G[0,2] a")
    assert plan.status == "infeasible"
    plan = planned({"p": ["a"], "q": ["b"]}, edges, [("r", {"p": 1}, [])], "F[2,2] a")
    assert plan.agents[0].stays == ((0, 0, "p"), (2, 2, "p"))


def test_names_with_underscores() -> None:
    states = {"p_1": ["a_b"], "p_1_x": ["c__d"]}
    edges = [("p_1", "p_1"), ("p_1", "p_1_x"), ("p_1_x", "p_1_x")]
    team = [("k_1", {"p_1": 2}, ["x_y", "_z"])]
    plan = planned(states, edges, team, "F[0,2] sum(c__d, x_y) >= 1 && G[0,2] sum(a_b,_z) >= 1")
    assert plan.status == "optimal"
    assert {agent.id for agent in plan.agents} == {"k_1-1", "k_1-2"}


def test_every_agent_gets_a_path() -> None:
    states = {"p": ["a"], "q": ["b"]}
    team = [("r", {"p": 3, "q": 2}, [])]
    plan = planned(states, LOOPS + BOTH, team, "F[1,4] sum(b) >= 4 && G[0,4] a")
    assert len(plan.agents) == 5
    assert all(agent.stays[-1][1] == plan.horizon for agent in plan.agents)
