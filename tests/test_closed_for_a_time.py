"""States and edges that are closed for a time: files, plans, and what the check refuses."""

from __future__ import annotations

from dataclasses import replace

import networkx as nx
import pytest

import tsplan
from tests.explaining import check_explanation
from tests.test_brute_force import PLAIN, REFERENCE, TIGHT
from tsplan import Edge, Group, Mission, Plan, State, TransitionSystem
from tsplan.checking.plan_check import check
from tsplan.encode.preparation import prepare
from tsplan.errors import MapError, MissionError
from tsplan.mission.read import mission_from_text
from tsplan.testing import random_task_mission, with_closures, with_starts_under_way
from tsplan.ts.builders import from_networkx, grid
from tsplan.ts.closures import FOREVER
from tsplan.ts.map_lint import lint
from tsplan.ts.reachability import entries

MAP = """
format: tsplan-mission/1
map:
  waiting: true
  states: {q1: {}, q2: {closed: [[8, 9]]}, q3: {labels: [b]}}
  edges: [[q1, q2, 1], {from: q2, to: q3, duration: 2, closed: [[2, 5]], both_ways: true}]
"""
TEAM = (
    MAP
    + """
team: [{class: cart, count: 2, at: q1}]
spec: "F[0,LAST] sum(b) >= 2"
"""
)


# --- maps -----------------------------------------------------------------------------------------


def test_spans_are_read_joined_and_written() -> None:
    text = TEAM.replace("LAST", "9").replace("[[8, 9]]", "[[9, 9], [8, 8], [12, 14]]")
    mission = mission_from_text(text)
    system = mission.system
    assert system.states["q2"].closed == ((8, 9), (12, 14))
    assert system.edges["q3", "q2"].closed == system.edges["q2", "q3"].closed == ((2, 5),)
    again = mission_from_text(mission.to_yaml())
    assert again.system == system
    alone = mission_from_text(text.replace("[[2, 5]]", "[2, 5]"))
    assert alone.system == system


def test_python_and_graphs_have_the_same() -> None:
    states = [State("q1"), State("q2", closed=[[8, 9]])]
    system = TransitionSystem.build(states, [Edge("q1", "q2", 1, closed=[(2, 3), (4, 5)])])
    assert system.edges["q1", "q2"].closed == ((2, 5),)
    graph = nx.DiGraph()
    graph.add_node("q1")
    graph.add_node("q2", closed=[8, 9])
    graph.add_edge("q1", "q2", duration=1, closed=[[2, 5]])
    assert from_networkx(graph).edges["q1", "q2"].closed == ((2, 5),)
    assert from_networkx(graph).states["q2"].closed == ((8, 9),)
    assert system.later(-4).states["q2"].closed == ((4, 5),)
    assert system.later(-4).edges["q1", "q2"].closed == ((0, 1),)


@pytest.mark.parametrize(
    ("old", "new", "place", "words"),
    [
        ("[[8, 9]]", "[[9, 8]]", "5:33", "[9, 8] is not a first and a last step"),
        ("[[8, 9]]", "[[-1, 8]]", "5:33", "[-1, 8] is not a first and a last step"),
        ("[[2, 5]]", "[[2]]", "6:64", "[2] is not a first and a last step"),
        ("[[2, 5]]", "never", "6:64", "'never' is no list of spans"),
        ("[[2, 5]]", "[[2, 1.5]]", "6:64", "is not a first and a last step"),
    ],
)
def test_what_is_wrong_is_told_at_its_place(old: str, new: str, place: str, words: str) -> None:
    with pytest.raises(MissionError) as told:
        mission_from_text(TEAM.replace("LAST", "9").replace(old, new))
    assert any(f":{place}:" in str(finding) for finding in told.value.findings), str(told.value)
    assert words in str(told.value)


def test_wrong_spans_of_python_are_refused() -> None:
    for wrong in ([(3, 2)], [(True, 2)], [(0, 10**9)], 7, ["ab"]):
        with pytest.raises(MapError, match="closed"):
            TransitionSystem.build([State("q1", closed=wrong)], [])


def test_nobody_starts_or_arrives_where_it_is_closed() -> None:
    text = TEAM.replace("LAST", "9")
    with pytest.raises(MissionError, match="'q1' is closed at step 0, and 2 robots start there"):
        mission_from_text(text.replace("{q1: {}", "{q1: {closed: [[0, 3]]}"))
    begun = text.replace("at: q1", "at: {from: q1, to: q2, arrives: 8}")
    with pytest.raises(MissionError, match="come to 'q2' at step 8, when it is closed"):
        mission_from_text(begun)


def test_what_knows_no_time_refuses_closed_places() -> None:
    text = TEAM.replace("LAST", "9")
    modular = text.replace(
        "team: [{", "configurations: {a: {modules: 1}}\nteam: [{configuration: a, "
    )
    with pytest.raises(MissionError, match="not planned for structures"):
        mission_from_text(modular)
    system = mission_from_text(text).system
    with pytest.raises(MapError, match="closed for a time"):
        tsplan.unit_steps(system)
    with pytest.raises(MapError, match="not defined for places that are closed"):
        tsplan.product(system, system)


def test_gaps_that_are_too_short_look_odd() -> None:
    edge = Edge("q1", "q2", 3, closed=((2, 4), (7, 9)))
    system = TransitionSystem.build([State("q1"), State("q2")], [edge, edge.reverse()])
    told = [finding.message for finding in lint(system)]
    assert any("'q1' to 'q2'" in words and "steps 5 to 6" in words for words in told)


def test_when_an_edge_may_be_entered() -> None:
    states = [State("q1", closed=((3, 3),)), State("q2", closed=((8, 9),))]
    edge = Edge("q1", "q2", 2, closed=((13, 14),))
    system = TransitionSystem.build(states, [edge])
    for step in range(30):
        open_ = step != 3 and step + 2 not in (8, 9) and not {step, step + 1} & {13, 14}
        assert open_ is any(a <= step <= b for a, b in entries(system, edge, 2))
    assert entries(system, edge, 2)[-1][1] == FOREVER


# --- plans ----------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("last", "status", "arrives"), [(9, "infeasible", 0), (12, "optimal", 12), (8, "infeasible", 0)]
)
def test_agents_wait_until_it_opens(last: int, status: str, arrives: int) -> None:
    """The edge opens at step 6, too late to be over it before the state behind them closes."""
    text = TEAM.replace("LAST", str(last)).replace("[[8, 9]]", "[[6, 9]]")
    for encoding in ("tight", "reference"):
        plan = tsplan.plan(mission_from_text(text), encoding=encoding)
        assert plan.status == status
        assert plan.verified == plan.has_paths
        for agent in plan.agents:
            assert agent.stays[-1][0] == arrives
            assert all(agent.state_at(step) != "q2" for step in range(6, 10))


def forged(*stays: tuple[int, int, str], heading: str | None = None) -> list[str]:
    """What the check finds of a plan in which both agents go that way."""
    mission = mission_from_text(TEAM.replace("LAST", "9").replace("sum(b) >= 2", "true"))
    plan = tsplan.plan(mission)
    first, *others = plan.agents
    agents = (replace(first, stays=stays, heading=heading), *others)
    report = check(mission, replace(plan, agents=agents, objective=(), availability=None))
    return [finding.message for finding in report.findings]


def test_the_check_keeps_agents_out_of_closed_places() -> None:
    at_q2 = "at q2, which is closed from step 8 to 9"
    assert any(at_q2 in words for words in forged((0, 0, "q1"), (1, 9, "q2")))
    on_edge = "on the edge from q2 to q3, which is closed from step 2 to 5"
    for left in (1, 2, 5):
        stays = (0, 0, "q1"), (1, left, "q2"), (left + 2, 9, "q3")
        assert any(on_edge in words for words in forged(*stays))
    assert not any("closed" in words for words in forged((0, 0, "q1"), (1, 6, "q2"), (8, 9, "q3")))


def test_a_move_that_ends_after_the_horizon_ends_where_it_is_open() -> None:
    text = TEAM.replace("LAST", "7").replace("{labels: [b]}", "{labels: [b], closed: [[9, 9]]}")
    text = text.replace("sum(b) >= 2", "true").replace("[[8, 9]]", "[[8, 20]]")
    text = text.replace("spec:", "horizon: 8\nspec:") + " && G[8,8] sum(q1) <= 0"
    # all have to leave q1, and cannot be at q2 then; on the edge they would arrive too early
    mission = mission_from_text(text.replace('true"', "true").replace(" <= 0", ' <= 0"'))
    for encoding in ("tight", "reference"):
        plan = tsplan.plan(mission, encoding=encoding)
        assert plan.status == "optimal"
        assert {agent.stays[-1][2] for agent in plan.agents} == {"q3"}


def test_those_under_way_are_let_through() -> None:
    begun = TEAM.replace("LAST", "3").replace("at: q1", "at: {from: q2, to: q3, arrives: 3}")
    plan = tsplan.plan(mission_from_text(begun))
    assert (plan.status, plan.verified) == ("optimal", True)


def test_maps_with_a_door_are_reduced() -> None:
    wide = grid(12, 12, labels={(11, 11): "a"})
    doors = {("r0c5", "r0c6"), ("r0c6", "r0c5")}
    edges = [replace(e, closed=((3, 9),)) if e.pair in doors else e for e in wide.edges.values()]
    system = wide.rebuilt(wide.states.values(), edges)
    mission = Mission.of(
        map=system, team=[Group.of("k", {"r0c0": 2})], formula="F[0,40] a", language="mtl"
    )
    (short,) = prepare(mission).reduced
    assert len(short.graph.tail) < len(wide.edges) / 4
    assert short.graph.timed.sum() >= 2
    assert tsplan.plan(mission).value("travel") == 22


def test_reasons_name_what_is_closed_and_offer_to_open_it() -> None:
    mission = mission_from_text(TEAM.replace("LAST", "7"))
    told = " ".join(str(tsplan.explain(mission)).split())
    assert "the edge from 'q2' to 'q3' is closed from step 2 to 5" in told
    assert "open the edge from 'q2' to 'q3', which is closed from step 2 to 5" in told
    assert "at step 8" in told


NOWHERE = """
format: tsplan-mission/1
map:
  states: {q1: {}, q2: {labels: [b], needs: [fly]}, q3: {needs: [fly]}}
  edges: [[q2, q2, 1], {from: q2, to: q3, duration: 1, closed: [[1, 1]]}]
team: [{class: cart, count: 2, at: q1}, {class: drone, at: q2, capabilities: [fly]}]
spec: "F[0,2] b"
"""
NOT_YET = """
format: tsplan-mission/1
map:
  states: {q1: {}, q2: {}}
  edges: [[q1, q1, 1], [q1, q2, 3], {from: q2, to: q1, duration: 1, closed: [[0, 0], [3, 3]]}]
swarms: [{name: u, size: 2, at: {q2: 2}}, {name: v, size: 1, at: {q2: 1}}]
spec: "F[3,4] (sum(q1,u) >= 2)"
"""


@pytest.mark.parametrize("options", [TIGHT, REFERENCE, PLAIN])
@pytest.mark.parametrize("text", [NOWHERE, NOT_YET])
def test_those_who_may_not_wait_may_have_nowhere_to_go(
    text: str, options: dict[str, object]
) -> None:
    plan = tsplan.plan(mission_from_text(text), **options)
    assert plan.status is tsplan.Status.INFEASIBLE


def test_plans_are_read_as_ever() -> None:
    plan = tsplan.plan(mission_from_text(TEAM.replace("LAST", "12")))
    assert Plan.from_json(plan.to_json()) == plan


@pytest.mark.long
@pytest.mark.parametrize("block", range(20))
def test_reasons_are_true(block: int) -> None:
    for seed in range(10 * block, 10 * block + 10):
        check_explanation(with_closures(random_task_mission(seed), seed))
        check_explanation(with_starts_under_way(random_task_mission(seed), seed))
