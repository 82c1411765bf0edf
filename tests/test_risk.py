"""Moves that may fail: the probability that none does is exact, measured and maximised."""

from __future__ import annotations

import math
from itertools import product

import networkx as nx
import pytest

import tsplan
from tsplan.errors import MapError
from tsplan.mission.read import mission_from_text
from tsplan.ts import Edge, State, TransitionSystem

TEXT = """\
format: tsplan-mission/1
map:
  waiting: true
  states: {a: {}, b: {}, c: {labels: [goal]}}
  edges:
    - {from: a, to: c, duration: 1, success: 0.8}
    - {from: a, to: b, duration: 2, success: 0.99}
    - {from: b, to: c, duration: 2, success: 0.98}
team: [{class: cart, count: 2, at: a}]
spec: {language: mtl, formula: "F[0,6] sum(goal) >= 2"}
objective: [%s]
"""


@pytest.mark.parametrize("encoding", ["tight", "reference"])
def test_the_safest_ways_are_taken(encoding):
    plan = tsplan.plan(mission_from_text(TEXT % "risk, travel"), encoding=encoding)
    risk, travel = plan.objective
    assert plan.status == "optimal"
    assert risk.value == risk.bound == pytest.approx(-2 * math.log(0.99 * 0.98), abs=4e-6)
    assert travel.value == 8
    plan = tsplan.plan(mission_from_text(TEXT % "travel, risk"), encoding=encoding)
    assert [item.value for item in plan.objective] == [2, pytest.approx(0.446288)]


def test_the_summary_tells_the_probability(capsys):
    from tsplan.plans.summary import objective_line  # noqa: PLC0415 - needs rich

    plan = tsplan.plan(mission_from_text(TEXT % "risk"))
    assert "probability 0.9413" in objective_line(plan.objective[0])


def test_the_least_risk_is_that_of_the_safest_way():
    for seed in range(12):
        graph = nx.gnp_random_graph(7, 0.4, seed=seed, directed=True)
        chances = {pair: 0.5 + (13 * n + seed) % 50 / 100 for n, pair in enumerate(graph.edges)}
        states = [State(str(n), labels={"goal"} if n == 6 else frozenset()) for n in graph]
        edges = [Edge(str(a), str(b), success=p) for (a, b), p in chances.items()]
        edges += [Edge(str(n), str(n)) for n in graph]
        system = TransitionSystem.build(states, edges, "random")
        mission = tsplan.Mission.of(
            map=system,
            team=[tsplan.Group.of("cart", {"0": 1})],
            formula="F[0,5] goal",
            language="mtl",
            objective=["risk"],
        )
        plan = tsplan.plan(mission)
        ways = [
            sum(
                system.edges[str(a), str(b)].risk for a, b in zip((0, *way), (*way, 6), strict=True)
            )
            for size in range(5)
            for way in product(range(7), repeat=size)
            if all(graph.has_edge(a, b) for a, b in zip((0, *way), (*way, 6), strict=True))
        ]
        if not ways:
            assert plan.status == "infeasible"
        else:
            assert plan.objective[0].value == float(min(ways))


@pytest.mark.parametrize("wrong", [0, -0.5, 1.5, "sure", True])
def test_what_is_no_probability_is_refused(wrong):
    with pytest.raises(MapError, match="success"):
        TransitionSystem.build([State("a")], [Edge("a", "a", success=wrong)], "wrong")
    with pytest.raises(tsplan.TsplanError, match="success"):
        mission_from_text((TEXT % "risk").replace("0.99", str(wrong).lower()))


def test_success_is_written_and_read_back():
    mission = mission_from_text(TEXT % "risk")
    again = mission_from_text(mission.to_yaml())
    assert again.system.edges["a", "b"].success == 0.99
    assert "success" not in tsplan.plan(again).to_json()
