"""Changes: each kind of them, their least amounts, and several together."""

from __future__ import annotations

from dataclasses import replace
from math import inf

import pytest

import tsplan
from tests.explaining import check_change, check_explanation, plain
from tests.seeds import sampled
from tests.test_explain_conflicts import ROW, row
from tsplan.clock import Clock
from tsplan.explanation import Change, explain
from tsplan.explanation.whynot import oracle, team_subject
from tsplan.explanation.whynot.changes import Least, Repairs, least
from tsplan.explanation.whynot.conflicts import Finder
from tsplan.explanation.whynot.joint_repair import JointRepair
from tsplan.explanation.whynot.team_subject import Teams
from tsplan.mission import Group, Mission
from tsplan.plans.plan import Plan
from tsplan.run.problem import Problem
from tsplan.testing import random_task_mission
from tsplan.ts import Edge, State, TransitionSystem


def changes(mission: Mission) -> dict[str, Change]:
    """The changes that are offered, by their words; each is right, the smallest first."""
    made = explain(mission)
    assert [item.amount for item in made.changes] == sorted(item.amount for item in made.changes)
    for change in made.changes:
        check_change(mission, change)
        assert change.mission.objective == mission.objective
    return {change.text: change for change in made.changes}


def kinds(mission: Mission) -> set[str]:
    return {change.kind for change in changes(mission).values()}


def squeezed(**capacities: int) -> TransitionSystem:
    """The row with capacities of states."""
    states = [replace(s, capacity=capacities.get(s.name)) for s in ROW.states.values()]
    return TransitionSystem.build(states, ROW.edges.values())


def test_a_deadline_is_extended_by_the_least() -> None:
    found = changes(row("F[0,1] sum(C) >= 1"))
    change = found["extend the deadline 1 to 3 (2 steps later) in F[0,1] sum(C) >= 1"]
    assert (change.kind, change.amount) == ("extend_deadline", 2)
    assert change.mission.horizon == 3


def test_agents_are_added_where_they_are_of_use() -> None:
    found = changes(row("F[0,4] sum(C, see) >= 5"))
    assert found["add 3 agents of class a at 'p'"].kind == "add_agents"
    assert found["lower the need at 'C' from 5 to 2 agents with see in F[0,4] sum(C, see) >= 5"]


def test_nobody_asked_for_is_said_plainly() -> None:
    assert "ask for no lift at 'B' in F[0,4] sum(B, lift) >= 1" in changes(
        row("F[0,4] sum(B, lift) >= 1")
    )


def test_a_limit_is_loosened() -> None:
    text = "F[2,4] sum(B) >= 2 && G[0,5] max(B) <= 0"
    found = changes(row(text))
    assert "loosen the limit at 'B' from 0 to 2 agents in G[0,5] max(B) <= 0" in found


def test_a_task_is_shortened() -> None:
    mission = row("F[1,2] T(4, B, {(see, 2)}) && F[2,6] T(0, C, {(see, 2)})", language="catl")
    assert {"shorten_task", "extend_deadline", "add_agents"} <= kinds(mission)


def test_a_state_gets_more_room() -> None:
    mission = replace(row("F[0,9] min(B) >= 2"), system=squeezed(q=1))
    assert "raise the capacity of state 'q' from 1 to 2" in changes(mission)


def test_an_edge_gets_quicker_or_more_room() -> None:
    assert "cross the edge from 'q' to 'r' (now 2) in 1 step less" in changes(
        row("F[0,2] sum(C) >= 1")
    )
    edges = [
        replace(edge, capacity=1) if edge.pair == ("q", "r") else edge
        for edge in ROW.edges.values()
    ]
    narrow = TransitionSystem.build(ROW.states.values(), edges)
    mission = replace(row("F[0,3] sum(C) >= 2"), system=narrow)
    assert "raise the capacity of the edge from 'q' to 'r' from 1 to 2" in changes(mission)


SWARM = {"size": 10, "at": {"q": 10}, "max_subswarms": 2, "min_subswarm": 1}


def swarm(formula: str, margin: str | int | None = None, **bounds: int) -> Mission:
    return Mission.of(map=ROW, swarm={**SWARM, **bounds}, margin=margin, formula=formula)


def words(mission: Mission) -> list[str]:
    made = explain(mission)
    for change in made.changes:
        assert change.proven
        assert tsplan.plan(plain(change.mission)).has_paths
    return [change.text for change in made.changes]


@pytest.mark.long
def test_swarms_may_divide_further() -> None:
    assert words(swarm("F[2,6] (A && B && C)"))[0] == "raise max_subswarms from 2 to 3"


@pytest.mark.long
def test_sub_swarms_may_be_smaller() -> None:
    found = words(swarm("F[2,6] (A && B && C)", max_subswarms=5, min_subswarm=5))
    assert "lower min_subswarm from 5 to 3" in found
    assert "ask for no agents at 'B' in F[2,6] (A && B && C)" in found


@pytest.mark.long
def test_less_may_be_kept_to_spare() -> None:
    mission = swarm("F[2,6] (sum(A) >= 50% && sum(C) >= 30%)", margin="15%")
    assert "lower the margin from 15% to 10%" in words(mission)


@pytest.mark.long
def test_of_a_share_hundredths_are_given_up() -> None:
    mission = swarm("F[2,6] (sum(A) >= 70% && sum(C) >= 40%)")
    found = words(mission)
    assert "lower the need at 'C' from 40% to 30% in F[2,6] (sum(A) >= 70% && sum(C) >= 40%)" in (
        found
    )


@pytest.mark.long
def test_several_changes_where_one_does_not_do() -> None:
    mission = row("F[0,1] sum(C) >= 1 && F[4,9] sum(A) >= 4 && G[2,3] sum(B) >= 3", language="mtl")
    found = explain(mission).changes
    assert found
    for change in found:
        assert len(change.steps) > 1
        assert "; and " in change.text
        check_change(mission, change)


def test_the_least_total_of_several_changes() -> None:
    mission = row("F[0,2] sum(C) >= 1 && F[0,1] sum(C) >= 1 && F[0,9] sum(A, lift) >= 1")
    fewest, deadline = explain(mission).changes
    assert "extend" not in fewest.text
    assert deadline.amount == 1 + 1 + 1  # a deadline and two needs, rather than two deadlines
    check_change(mission, fewest)
    check_change(mission, deadline)


@pytest.mark.parametrize("seed", sampled([16, 7, 15, 25], [16]))
def test_there_is_always_a_way_out(seed: int) -> None:
    """These needed ways to go that were not gathered, or agents that were in the way of limits."""
    made = check_explanation(random_task_mission(seed))
    assert made.changes


def test_doubling_and_bisection() -> None:
    for wanted in range(1, 40):
        asked: list[int] = []

        def enough(amount: int, wanted: int = wanted, asked: list[int] = asked) -> bool:
            asked.append(amount)
            return amount >= wanted

        assert least(enough, 50) == Least(wanted, proven=True)
        assert len(asked) <= 12
    assert least(lambda _: False, 50) is None
    assert least(lambda amount: True if amount > 6 else None, 50) == Least(7, proven=False)


def test_more_agents_never_start_where_there_is_no_room() -> None:
    mission = replace(row("F[0,4] sum(A) >= 5"), system=squeezed(p=3))
    for change in changes(mission).values():
        for edit, _ in change.steps:
            assert edit.kind != "add_agents" or edit.number.key[1] != "p"


def test_a_class_that_cannot_be_somewhere_is_not_added_there() -> None:
    states = [
        replace(s, needs=frozenset({"fly"})) if s.name == "r" else s for s in ROW.states.values()
    ]
    system = TransitionSystem.build(states, ROW.edges.values())
    team = [Group.of("a", {"p": 2}, ["see"]), Group.of("b", {"p": 1}, ["fly", "see"])]
    mission = replace(row("F[0,4] sum(C, see) >= 2", team=team), system=system)
    found = changes(mission)
    assert any("class b" in text for text in found)
    assert not any("class a" in text for text in found)


@pytest.mark.long
def test_deadlines_of_short_missions_are_first_moved_a_little(monkeypatch) -> None:
    asked: list[int] = []

    def plan(problem: Mission | Problem, **options: object) -> Plan:
        asked.append((problem.mission if isinstance(problem, Problem) else problem).horizon)
        return tsplan.plan(problem, **options)

    monkeypatch.setattr(team_subject, "plan", plan)
    made = explain(row("F[0,2] sum(C) >= 2 && F[0,1] sum(B) >= 3 && G[0,3] max(B) <= 1"))
    first, second = sorted(made.changes, key=lambda change: change.fix)
    assert first.text == (
        "ask for no agents at 'C' in F[0,2] sum(C) >= 2; and lower the need at 'B' from 3 to 1 "
        "agent in F[0,1] sum(B) >= 3"
    )
    assert second.text == (
        "lower the need at 'B' from 3 to 1 agent in F[0,1] sum(B) >= 3; and extend the deadline 2 "
        "to 4 (2 steps later) in F[0,2] sum(C) >= 2"
    )
    assert max(asked) == 3 + 8  # a proof over a long horizon takes its time


def test_deadlines_that_must_move_far_do() -> None:
    edges = [*(Edge(name, name) for name in "pqr"), Edge("p", "q", 20), Edge("q", "r", 2)]
    states = [State(name, labels={name.upper()}) for name in "pqr"]
    mission = Mission.of(
        map=TransitionSystem.build(states, edges),
        team=[Group.of("a", {"p": 2}, ["see"])],
        formula="F[0,3] sum(R) >= 2 && F[0,3] sum(Q) >= 2",
        language="mtl",
    )
    asked = oracle.Oracle(Teams(mission), Clock())
    finder = Finder(asked)
    core = finder.within(finder.everything)
    assert core is not None
    repairs = Repairs(asked, finder.everything, [core.constraints])
    several = JointRepair(asked, repairs)
    assert several._gathered(core.constraints, ["extend_deadline"], 8) == []
    far = several._gathered(core.constraints, ["extend_deadline"], inf)
    assert [edit.kind for edit, _ in far] == ["extend_deadline", "extend_deadline"]
    assert several._ways(core.constraints)
