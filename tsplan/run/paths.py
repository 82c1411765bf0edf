"""From a point of a model to what a plan says of everybody: moves of swarms, paths of agents."""

from __future__ import annotations

from typing import TypedDict

import numpy as np

from tsplan.encode.encoded import Point, Setting
from tsplan.encode.policy_reading import policies_of
from tsplan.encode.read_back import carried_at, executions_of, listed, moves_of
from tsplan.plans.agent_plans import AgentPlan
from tsplan.plans.decomposition import paths_of
from tsplan.plans.loading import loading
from tsplan.plans.moves import Move
from tsplan.plans.policies import Policy
from tsplan.plans.supplies import Cargo, ExecutedTask

MOST_AGENTS = 1000
"""Agents up to which every one of a swarm gets a path; for more, `tsplan.assign` makes them."""


class Ways(TypedDict, total=False):
    """Where everybody goes, as fields of a plan."""

    agents: tuple[AgentPlan, ...]
    moves: dict[str, tuple[Move, ...]]
    executions: tuple[ExecutedTask, ...]
    cargo: tuple[Cargo, ...]
    policies: tuple[Policy, ...]


def ways_of(setting: Setting, point: Point, seed: int | None) -> Ways:
    """The moves of every swarm, and one path per agent in the order of the team; or policies.

    Those of swarms are left out where there are more than `MOST_AGENTS` agents in all.
    """
    mission = setting.mission
    if mission.expected is not None:
        return Ways(policies=tuple(policies_of(setting, point)))
    begins = np.cumsum([0, *(group.count for group in mission.team)]).tolist()
    agents: dict[int, AgentPlan] = {}
    moves: dict[str, tuple[Move, ...]] = {}
    for item, entered in moves_of(setting, point):
        made = listed(setting, item, entered)
        if item.bounds is not None:
            moves[mission.team[item.groups[0]].class_name] = made
            if mission.size > MOST_AGENTS:
                continue
        spans = (range(begins[group], begins[group + 1]) for group in item.groups)
        numbers = [number for span in spans for number in span]
        members = [mission.agents[number] for number in numbers]
        agents.update(zip(numbers, paths_of(mission, members, made, seed), strict=True))
    paths = tuple(agents[number] for number in sorted(agents))
    names = setting.arrays.names
    done = [(step, names[state], task.task) for task, state, step in executions_of(point)]
    return Ways(
        moves=moves,
        agents=paths,
        executions=tuple(ExecutedTask(task, state, step) for step, state, task in sorted(done)),
        cargo=loading(mission, paths, carried_at(setting, point)),
    )
