"""The planner against all joint plans of tiny missions, enumerated one by one."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import product
from math import inf, prod

import numpy as np
import pytest

import tsplan
from tests.random_missions import random_mission
from tsplan import Mission
from tsplan.logic.evaluation import CountTrace, robustness
from tsplan.mission import Agent

MOST_JOINT_PLANS = 3000
SENSE = {"availability": -1, "travel": 1, "cost": 1, "makespan": 1, "agents": 1}


@dataclass(frozen=True)
class Path:
    """One agent's way: its state at each step (None on the way), and what it costs."""

    states: tuple[str | None, ...]
    entered: tuple[tuple[str, str, int, int], ...]  # edge, step, duration
    travel: int
    cost: float
    makespan: int


def paths(mission: Mission, agent: Agent) -> list[Path]:
    """Every way of one agent up to the horizon."""
    system = mission.system
    found = []

    def go(state: str, step: int, moves: tuple[tuple[str, str, int, int], ...]) -> None:
        if step >= mission.horizon:
            found.append(moves)
            return
        for edge in system.leaving(state):
            duration = edge.duration_for(agent.class_name)
            needs = edge.needs | system.states[edge.target].needs | system.states[state].needs
            if duration is not None and needs <= agent.capabilities:
                entered = (edge.source, edge.target, step, duration)
                go(edge.target, step + duration, (*moves, entered))

    go(agent.start, 0, ())
    return [walked(mission, agent, moves) for moves in found]


def walked(mission: Mission, agent: Agent, moves: tuple[tuple[str, str, int, int], ...]) -> Path:
    states: list[str | None] = [None] * (mission.horizon + 1)
    states[0] = agent.start
    travel, cost, makespan = 0, 0.0, 0
    for source, target, step, duration in moves:
        if step + duration <= mission.horizon:
            states[step + duration] = target
        edge = mission.system.edges[source, target]
        cost += edge.cost_for(agent.class_name)
        if source != target:
            travel += duration
            makespan = max(makespan, step + duration)
    return Path(tuple(states), moves, travel, cost, makespan)


def within_capacity(mission: Mission, joint: tuple[Path, ...]) -> bool:
    for name, state in mission.system.states.items():
        if state.capacity is not None:
            for step in range(mission.horizon + 1):
                if sum(path.states[step] == name for path in joint) > state.capacity:
                    return False
    for capacity, pairs in mission.system.capacity_groups:
        load: Counter[int] = Counter()
        for path in joint:
            for source, target, step, duration in path.entered:
                if (source, target) in pairs:
                    load.update(range(step, min(step + duration, mission.horizon)))
        if any(count > capacity for count in load.values()):
            return False
    return True


def trace(mission: Mission, joint: tuple[Path, ...]) -> CountTrace:
    names = list(mission.system.states)
    counts = {None: np.zeros((len(names), mission.horizon + 1))}
    for agent, path in zip(mission.agents, joint, strict=True):
        for step, state in enumerate(path.states):
            for capability in (None, *agent.capabilities):
                table = counts.setdefault(capability, np.zeros_like(counts[None]))
                if state is not None:
                    table[names.index(state), step] += 1
    labels = {
        label: np.array([names.index(name) for name in carriers])
        for label, carriers in mission.system.labels.items()
    }
    return CountTrace(counts, labels)


def values(mission: Mission) -> Iterator[tuple[float, ...]]:
    """The objective values, signed to be minimised, of every joint plan that holds."""
    ways = [paths(mission, agent) for agent in mission.agents]
    for joint in product(*ways):
        if not within_capacity(mission, joint):
            continue
        availability = float(robustness(mission.formula, trace(mission, joint))[0])
        if availability < 0:
            continue
        worth = {
            "availability": availability,
            "travel": sum(path.travel for path in joint),
            "cost": sum(path.cost for path in joint),
            "makespan": max(path.makespan for path in joint),
            "agents": sum(path.travel > 0 for path in joint),
        }
        yield tuple(SENSE[name] * worth[name] for name in mission.objective)


def small_enough(mission: Mission) -> bool:
    return prod(len(paths(mission, agent)) for agent in mission.agents) <= MOST_JOINT_PLANS


def compare(seed: int) -> None:
    mission = random_mission(seed, states=4, most_agents=3, steps=5)
    if not small_enough(mission):
        return
    best = min(values(mission), default=None)
    for encoding in ("tight", "reference"):
        plan = tsplan.plan(mission, encoding=encoding)
        if best is None:
            assert plan.status == "infeasible"
            continue
        assert plan.status == "optimal"
        found = tuple(
            SENSE[item.name] * (inf if item.value is None else item.value)
            for item in plan.objective
        )
        assert found == pytest.approx(best, abs=1e-6)


@pytest.mark.parametrize("block", range(10))
def test_the_planner_finds_what_brute_force_finds(block: int) -> None:
    for seed in range(10_000 + 8 * block, 10_008 + 8 * block):
        compare(seed)


@pytest.mark.long
@pytest.mark.parametrize("block", range(100))
def test_the_planner_finds_what_brute_force_finds_on_many(block: int) -> None:
    for seed in range(11_000 + 10 * block, 11_010 + 10 * block):
        compare(seed)


def test_the_enumeration_covers_most_of_the_missions() -> None:
    missions = [
        random_mission(seed, states=4, most_agents=3, steps=5) for seed in range(10_000, 10_080)
    ]
    assert sum(small_enough(mission) for mission in missions) >= 40
