"""The independent check accepts what is right and refuses every kind of tampering."""

from __future__ import annotations

from dataclasses import replace

import pytest

from tsplan.checking.plan_check import certify, check, objective_values
from tsplan.errors import SolverError
from tsplan.mission import Group, Mission
from tsplan.plans.agent_plans import AgentPlan
from tsplan.plans.outcomes import MissionRef, ObjectiveValue
from tsplan.plans.plan import Plan
from tsplan.ts import Edge, State, TransitionSystem

# p and q may hold two agents; one agent at a time may be between them; r is for flyers only
SYSTEM = TransitionSystem.build(
    [
        State("p", capacity=3),
        State("q", frozenset({"goal"}), capacity=2),
        State("r", frozenset({"air"}), needs=frozenset({"fly"})),
    ],
    [
        Edge("p", "p"),
        Edge("q", "q"),
        Edge("p", "q", {"slow": 3, "default": 2}, capacity=1, both_ways=True),
        Edge("q", "p", {"slow": 3, "default": 2}, capacity=1, both_ways=True),
        Edge("p", "r", 1, cost=2.5, needs=frozenset({"fly"})),
        Edge("r", "r", 2),
        Edge("r", "q", 4),
    ],
)
SEE = frozenset({"see"})
FLY = frozenset({"fly", "see"})
TEAM = (Group("fast", SEE, (("p", 2),)), Group("slow", FLY, (("q", 1),)))
HOME = ((0, 6, "p"),)
GO = ((0, 0, "p"), (2, 6, "q"))
SLOW = ((0, 6, "q"),)


def mission(formula="F[0,6] sum(goal, see) >= 2", **options):
    return Mission.of(map=SYSTEM, team=TEAM, formula=formula, language="mtl", **options)


def agent(number, stays, class_name="fast", able=SEE, heading=None):
    return AgentPlan(f"{class_name}-{number}", class_name, able, stays, heading)


def plan(*agents, **changes):
    made = Plan(
        "optimal",
        MissionRef("m", ""),
        6,
        objective=(ObjectiveValue("travel", 2, 2),),
        availability=0,
        agents=agents or (agent(1, GO), agent(2, HOME), agent(1, SLOW, "slow", FLY)),
    )
    return replace(made, **changes)


def refused(made, words, given=None):
    report = check(given or mission(), made)
    assert not report.ok
    assert words in "\n".join(str(finding) for finding in report.findings)
    assert not report.facts


def test_a_right_plan_is_accepted():
    report = check(mission(), plan())
    assert report.ok, report.findings
    assert report.availability == 0
    assert dict(report.values) == {
        "availability": 0,
        "travel": 2,
        "cost": 2,
        "makespan": 2,
        "risk": 0,
        "agents": 1,
    }
    assert any("formula holds" in fact for fact in report.facts)


def test_certify_marks_fills_in_and_refuses():
    bare = plan(availability=None, objective=())
    made = certify(mission(objective=("availability", "cost")), bare)
    assert made.verified
    assert made.availability == 0
    assert made.objective == (ObjectiveValue("availability", 0), ObjectiveValue("cost", 2))
    with pytest.raises(SolverError, match="formula does not hold"):
        certify(mission("G[0,6] sum(goal) >= 2"), bare)
    none = Plan("infeasible", MissionRef("m", ""), 6)
    assert certify(mission(), none) is none


@pytest.mark.parametrize(
    ("stays", "words"),
    [
        (((0, 0, "p"), (1, 6, "q")), "in 1 steps instead of 2"),
        (((0, 0, "p"), (3, 6, "q")), "in 3 steps instead of 2"),
        (((0, 0, "p"), (2, 2, "q"), (6, 6, "r")), "no such edge"),
        (((0, 0, "p"), (1, 1, "r"), (5, 6, "q")), "at step 1, which needs fly"),
        (((0, 0, "p"), (1, 1, "r"), (5, 6, "q")), "an edge that needs fly"),
        (((0, 3, "p"), (3, 6, "q")), "elsewhere until step 3"),
        (((0, 4, "p"), (2, 6, "q")), "elsewhere until step 4"),
        (((2, 6, "p"),), "first seen at step 2"),
        (((0, 9, "p"),), "beyond the horizon"),
        (((3, 0, "p"),), "before it comes"),
        (((0, 6, "moon"),), "which the map does not have"),
        ((), "no stays"),
        (((0, 6, "q"),), "starts at p, not at q"),
        (((0, 4, "p"),), "nowhere after step 4: no edge is long enough"),
        (((0, 0, "p"), (2, 3, "q")), "nowhere after step 3"),
    ],
)
def test_impossible_paths_are_refused(stays, words):
    refused(plan(agent(1, stays), agent(2, HOME), agent(1, SLOW, "slow", FLY)), words)


def test_a_wait_needs_a_loop_of_one_step():
    path = ((0, 0, "q"), (3, 3, "p"), (4, 6, "r"))
    refused(plan(agent(1, GO), agent(2, HOME), agent(1, path, "slow", FLY)), "instead of 2")


@pytest.mark.parametrize(
    ("heading", "words"),
    [("q", "does not arrive at step 5"), ("r", "an edge that needs fly"), ("moon", "no such edge")],
)
def test_a_heading_must_be_possible(heading, words):
    made = agent(2, ((0, 3, "p"),), heading=heading)
    refused(plan(agent(1, GO), made, agent(1, SLOW, "slow", FLY)), words)


def test_a_heading_after_arrival_is_refused():
    made = agent(2, HOME, heading="q")
    refused(plan(agent(1, GO), made, agent(1, SLOW, "slow", FLY)), "also heads for q")


def test_travelling_at_the_end_is_fine_and_counts_whole():
    late = agent(2, ((0, 5, "p"),), heading="q")
    agents = (agent(1, GO), late, agent(1, SLOW, "slow", FLY))
    assert check(mission(), plan(*agents, objective=(ObjectiveValue("travel", 4, 4),))).ok
    assert objective_values(mission(), plan(*agents))["makespan"] == 7
    # only one edge is long enough, so the heading need not be named
    silent = (agents[0], replace(late, heading=None), agents[2])
    assert objective_values(mission(), plan(*silent))["travel"] == 4


@pytest.mark.parametrize(
    ("agents", "words"),
    [
        ((agent(1, GO), agent(2, HOME)), "agent slow-1 has no path"),
        (
            (agent(1, GO), agent(2, HOME), agent(3, HOME), agent(1, SLOW, "slow", FLY)),
            "fast-3 is not in the team",
        ),
        (
            (agent(1, GO), agent(1, GO), agent(2, HOME), agent(1, SLOW, "slow", FLY)),
            "fast-1 is there twice",
        ),
        ((agent(1, GO), agent(2, HOME), agent(1, SLOW, "slow", SEE)), "other capabilities"),
        (
            (replace(agent(1, GO), class_name="slow"), agent(2, HOME), agent(1, SLOW, "slow", FLY)),
            "fast-1 is of class fast",
        ),
    ],
)
def test_lost_and_ghost_agents_are_refused(agents, words):
    refused(plan(*agents), words)


def test_crowded_states_are_refused():
    both = (agent(1, GO), agent(2, ((0, 2, "p"), (4, 6, "q"))), agent(1, SLOW, "slow", FLY))
    made = plan(*both, objective=(ObjectiveValue("travel", 4, 4),), availability=1)
    refused(made, "3 agents are at q at step 4, which holds 2")


def test_crowded_edges_are_refused_over_both_directions():
    path = ((0, 0, "q"), (3, 6, "p"))
    made = plan(agent(1, GO), agent(2, HOME), agent(1, path, "slow", FLY))
    refused(
        made, "2 agents are on the edge from p to q and back at step 1", mission("true", horizon=6)
    )


def test_the_capacity_of_a_wait_counts_those_who_wait():
    loop = TransitionSystem.build(
        [State("p", frozenset({"goal"}))], [Edge("p", "p", 1, capacity=1)]
    )
    given = Mission.of(map=loop, team=[Group("a", SEE, (("p", 2),))], formula="G[0,2] goal")
    paths = tuple(agent(n, ((0, 2, "p"),), "a") for n in (1, 2))
    refused(plan(*paths, horizon=2), "which holds 1", given)


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"availability": 1}, "claims availability 1 and has 0"),
        ({"availability": None}, "claims availability None"),
        ({"objective": (ObjectiveValue("travel", 1, 1),)}, "claims travel 1 and has 2"),
        ({"objective": (ObjectiveValue("travel", 2, 3),)}, "better than its bound 3"),
        ({"objective": (ObjectiveValue("travel", 2, 1),)}, "called optimal at 2 with the bound 1"),
        ({"objective": (ObjectiveValue("cost", 2, 2),)}, "objectives are cost"),
        ({"objective": ()}, "objectives are none"),
        ({"horizon": 7}, "ends at step 7 and the mission at step 6"),
    ],
)
def test_false_claims_are_refused(changes, words):
    refused(plan(**changes), words)


def test_a_bound_may_be_open_or_loose_without_optimality():
    loose = {"objective": (ObjectiveValue("travel", 2, 1),), "status": "feasible"}
    assert check(mission(), plan(**loose, stopped_by="gap")).ok
    open_ = {"objective": (ObjectiveValue("travel", 2, None),), "status": "feasible"}
    assert check(mission(), plan(**open_, stopped_by="gap")).ok


def test_optimality_needs_the_bound_that_proves_it():
    refused(plan(objective=(ObjectiveValue("travel", 2, None),)), "no bound proves it")
    refused(plan(objective=(ObjectiveValue("travel", 2, 1),)), "optimal at 2 with the bound 1")


@pytest.mark.parametrize(
    ("formula", "availability"),
    [
        ("F[0,6] sum(goal, see) >= 3", -1),
        ("G[0,6] sum(goal) <= 1", -1),
        ("F[0,1] sum(goal) >= 2", -1),
        ("!(F[2,6] sum(goal, fly) >= 1)", -1),
        ("goal && sum(air) != 0", -1),
    ],
)
def test_a_formula_that_does_not_hold_is_refused(formula, availability):
    given = mission(formula, horizon=6)
    refused(plan(availability=availability), "formula does not hold", given)


def test_plans_without_paths_are_refused():
    refused(Plan("infeasible", MissionRef("m", ""), 6), "no paths to check")


def test_findings_are_many_but_not_endless():
    given = Mission.of(
        map=SYSTEM, team=[Group("bird", FLY, (("r", 100),))], formula="true", horizon=6
    )
    ghosts = tuple(agent(n, HOME, "ghost") for n in range(1, 100, 2))
    report = check(given, plan(*ghosts))
    assert 2 < len(report.findings) < 30
    assert report.findings[-1].message.startswith("and ")


def test_half_open_tasks_are_judged_half_open():
    # both see q only at steps 2..6; with [0,d] the task would need step 7
    task = {"formula": "F[2,2] T(5, goal, {(see, 2)})", "language": "catl", "horizon": 7}
    closed = Mission.of(map=SYSTEM, team=TEAM, **task)
    half = Mission.of(map=SYSTEM, team=TEAM, **task, task_interval="half-open")
    leaves = ((0, 0, "p"), (2, 6, "q"))
    agents = (agent(1, leaves, heading="p"), agent(2, ((0, 7, "p"),)))
    made = plan(*agents, agent(1, ((0, 7, "q"),), "slow", FLY), horizon=7)
    moved = replace(made, objective=(ObjectiveValue("travel", 4, 4),))
    assert check(half, moved).ok, check(half, moved).findings
    refused(moved, "formula does not hold", closed)
