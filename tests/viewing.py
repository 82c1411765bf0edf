"""Missions and plans for the tests of pictures and pages."""

from __future__ import annotations

import tsplan
from tests.walks import walking
from tsplan.plans.agent_plans import AgentPlan
from tsplan.plans.outcomes import MissionRef, Status
from tsplan.plans.plan import Plan
from tsplan.stopping import StoppedBy
from tsplan.ts import Edge, State

HOSTILE = (
    "<script>window.caught = 1</script>",
    "</script><img src=x onerror='window.caught = 2'>",
    "\"quotes\" & 'more' <!-- {{data}}",
    "中文 κόσμος \u2028 עברית 🚀",
    "${window.caught = 3}` \\u003c $x^2$",
)

HORIZON = 14
NAMES = ("p", "q", "r", "s", "t")


def system(names, duration=1):
    """A ring of states, each with a label of its own."""
    states = [State(name, frozenset({name}), at=(3.0 * n, n % 2)) for n, name in enumerate(names)]
    waits = [Edge(name, name) for name in names]
    pairs = list(zip(names, [*names[1:], names[0]], strict=True))
    moves = [edge for a, b in pairs for edge in (Edge(a, b, duration), Edge(b, a, duration))]
    return tsplan.TransitionSystem.build(states, [*waits, *moves], "ring")


def mission_on(system, team, formula, horizon):
    return tsplan.Mission.of(
        map=system, team=team, formula=formula, language="mtl", horizon=horizon, name="test"
    )


def scouts_and_heavies():
    """A mission of two classes on a ring of NAMES, and a plan in which they wander to HORIZON."""
    team = [
        {"class": "scout", "count": 4, "at": {"p": 3, "r": 1}, "capabilities": ["see"]},
        {"class": "heavy", "count": 3, "at": "q", "capabilities": ["lift"]},
    ]
    formula = "F[0,9] (sum(q) >= 1) && G[0,12] (sum(r) <= 7)"
    mission = mission_on(system(NAMES, duration=3), team, formula, HORIZON)
    return mission, walking(mission, 5)


def plan_of(mission, paths):
    """A plan from the stays of every agent, `(stays, heading)`, in the order of the team."""
    agents = tuple(
        AgentPlan(agent.id, agent.class_name, agent.capabilities, tuple(stays), heading)
        for agent, (stays, heading) in zip(mission.agents, paths, strict=True)
    )
    return Plan(
        status=Status.FEASIBLE,
        stopped_by=StoppedBy.GAP,
        mission=MissionRef(mission.name, mission.digest),
        horizon=mission.horizon,
        agents=agents,
    )
