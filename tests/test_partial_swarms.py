"""Plans of swarms that may hold in part: what they say, and what a margin is a margin of."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import tsplan
from tsplan import Mission
from tsplan.checking.plan_check import check
from tsplan.plans.plan import Plan
from tsplan.plans.summary import satisfaction_lines
from tsplan.ts import Edge, State, TransitionSystem

REEF = Path(__file__).parent.parent / "environments" / "reef_watch.yaml"


def test_plans_of_swarms_say_what_holds_and_are_read_again() -> None:
    mission = tsplan.load_mission(REEF)
    plan = tsplan.plan(mission)
    copy = Plan.from_json(plan.to_json())
    assert copy.satisfaction == plan.satisfaction
    assert check(mission, copy).ok
    assert plan.satisfaction is not None
    told = {node.text: node.fraction for node in plan.satisfaction.nodes}
    watched = [told[f"sum({place}) >= 25%"] for place in ("kelp", "wreck", "sand")]
    assert sum(watched) == 2  # two groups, at two of three places at every step
    assert told["F[12,16] (sum(harbour) >= 100%)"] == 1
    assert satisfaction_lines(plan)[0] == "  satisfied: 5/6 (weighted)"
    better = replace(plan.satisfaction, fraction=Fraction(1))
    refused = check(mission, replace(plan, satisfaction=better))
    assert any("claims satisfaction 1" in str(finding) for finding in refused.findings)


def test_a_margin_is_kept_by_what_must_hold_alone() -> None:
    system = TransitionSystem.build(
        [State("p", frozenset({"A"})), State("q", frozenset({"B"}))],
        [Edge("p", "p"), Edge("q", "q"), Edge("p", "q"), Edge("q", "p")],
    )
    mission = Mission.of(
        map=system,
        swarm={"size": 20, "at": {"p": 20}},
        margin=2,
        must="F[2,2] sum(B) >= 50%",
        prefer=[{"formula": "F[2,2] sum(A) >= 8", "name": "eight"}, {"formula": "G[2,2] sum(A)>8"}],
    )
    plan = tsplan.plan(mission)
    assert plan.status == "optimal"
    assert check(mission, plan).ok
    assert [item.met for item in plan.preferences] == [True, False]
    assert plan.availability == 2
