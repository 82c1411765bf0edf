"""Plans and maps to be exported, and what becomes of an agent at every step."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from random import Random
from typing import Any

import tsplan
from tests.viewing import mission_on, plan_of
from tsplan import Group, Mission
from tsplan.plans.agent_plans import AgentPlan, Stay
from tsplan.plans.plan import Plan
from tsplan.ts import Edge, State, TransitionSystem

STEP = 2.5  # seconds
NAMES = ("yard", "dock 1", 'the "hall" <&>', "τέλος, πύλη", "7", "ünder\ttab", "'")


def random_map(random: Random) -> TransitionSystem:
    """A map of some states with ids and coordinates, which a circle of moves connects."""
    names = NAMES[: random.randint(2, len(NAMES))]
    numbers = random.sample(range(1000), len(names))
    states = [
        State(
            name,
            frozenset({"goal"}) if name == names[-1] else frozenset(),
            (random.randint(-9, 9) / 4, random.randint(-9, 9) / 4),
            origin=number,
        )
        for name, number in zip(names, numbers, strict=True)
    ]
    ways = dict.fromkeys(zip(names, [*names[1:], names[0]], strict=True))
    ways |= dict.fromkeys(tuple(random.sample(names, 2)) for _ in names)
    edges = [Edge(*ends, random.choice([1, 2, 5, {"cart": 3, "default": 1}])) for ends in ways]
    edges += [Edge(name, name, random.choice([1, 1, 1, 2])) for name in names]
    return TransitionSystem.build(states, edges, "random", step_seconds=STEP)


def random_plan(seed: int) -> tuple[Mission, Plan]:
    """A mission and a plan in which everybody wanders."""
    random = Random(seed)
    system = random_map(random)
    horizon, start = random.choice([3, 12, 30]), next(iter(system.states))
    team = [Group.of(name, {start: 2}) for name in ("cart", 'drone, "fast"')]
    mission = mission_on(system, team, f"F[0,{horizon}] sum(goal) >= 0", horizon)
    paths = [
        random_walk(system, agent.class_name, start, horizon, random) for agent in mission.agents
    ]
    return mission, plan_of(mission, paths)


def random_walk(
    system: TransitionSystem, class_name: str, state: str, horizon: int, random: Random
) -> tuple[tuple[Stay, ...], str | None]:
    """The stays of an agent that takes any edge, waits of several steps too, and its heading."""
    stays, step = [(0, 0, state)], 0
    while step < horizon:
        edge = random.choice(system.leaving(stays[-1][2]))
        step += edge.duration_for(class_name) or 0
        if step > horizon:
            return tuple(stays), edge.target
        if edge.is_wait and edge.duration == 1:
            stays[-1] = (stays[-1][0], step, edge.target)
        else:
            stays.append((step, step, edge.target))
    return tuple(stays), None


def text_of(plan: Plan, to: str, system: Any, folder: Path, **given: Any) -> str:
    """What a plan is written as."""
    file = folder / f"plan.{to}"
    tsplan.export(plan, file, to=to, map=system, **given)
    return file.read_text("utf-8")


def arrival(system: TransitionSystem, agent: AgentPlan) -> int | None:
    """When an agent is where it is heading."""
    _, left, state = agent.stays[-1]
    if agent.heading is None:
        return None
    return left + system.edges[state, agent.heading].duration_for(agent.class_name)


def visits(agent: AgentPlan) -> Iterator[tuple[str, int, int]]:
    """Where an agent is from when until when, waits of any length included."""
    state, first, last = agent.stays[0][2], agent.stays[0][0], agent.stays[0][1]
    for begin, end, other in agent.stays[1:]:
        if other != state:
            yield state, first, last
            state, first = other, begin
        last = end
    yield state, first, last
