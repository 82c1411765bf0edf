"""Plans made of random walks over any map, for what looks at plans and does not find them."""

from __future__ import annotations

from pathlib import Path
from random import Random

from tsplan import Mission, load_mission, save_plan
from tsplan.mission import Group
from tsplan.plans.agent_plans import AgentPlan
from tsplan.plans.outcomes import MissionRef
from tsplan.plans.plan import Plan

ENVIRONMENTS = Path(__file__).parents[1] / "environments"


def walk(mission, agent, random):
    """A path over the map that the agent may take: stays up to the horizon, and where it heads."""
    system, horizon = mission.system, mission.horizon
    stays, step, state = [], 0, agent.start
    while True:
        able = [
            edge
            for edge in system.leaving(state)
            if not edge.is_wait
            and edge.needs <= agent.capabilities
            and system.states[edge.target].needs <= agent.capabilities
            and edge.duration_for(agent.class_name)
        ]
        last = min(horizon, step + random.choice([0, 0, 1, 3, 8]))
        if last == horizon or not able:
            return (*stays, (step, horizon, state)), None
        stays.append((step, last, state))
        edge = random.choice(able)
        step, state = last + edge.duration_for(agent.class_name), edge.target
        if step > horizon:
            return tuple(stays), state


def walking(mission, seed=0, still=0.0):
    """A plan in which every agent wanders; a share of them stays where it is."""
    random = Random(seed)
    agents = []
    for agent in mission.agents:
        stays, heading = walk(mission, agent, random)
        if random.random() < still:
            stays, heading = ((0, mission.horizon, agent.start),), None
        agents.append(AgentPlan(agent.id, agent.class_name, agent.capabilities, stays, heading))
    name = MissionRef(mission.name, mission.digest)
    return Plan("feasible", name, mission.horizon, "gap", agents=tuple(agents))


def wandering(system, team, horizon=20, name="walks"):
    """A mission that asks for little, and a plan of random walks for it."""
    label = next(iter(system.labels))
    mission = Mission.of(
        map=system,
        team=[Group.of(class_name, starts, able) for class_name, starts, able in team],
        formula=f'F[0,{horizon}] sum("{label}") >= 1'.replace("\\", "\\\\"),
        language="mtl",
        horizon=horizon,
        name=name,
    )
    return mission, walking(mission)


def write_walks(folder):
    """A shipped mission with its map, plan.json and what became of it, trace.json, in a folder."""
    for name in ("farm.yaml", "farm_harvest.yaml"):
        (folder / name).write_bytes((ENVIRONMENTS / name).read_bytes())
    mission = load_mission(folder / "farm_harvest.yaml")
    save_plan(walking(mission), folder / "plan.json")
    save_plan(walking(mission, 3), folder / "trace.json")
