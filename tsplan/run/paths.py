"""From a point of a model to what a plan says of everybody: moves of swarms, paths of agents."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TypedDict

import numpy as np

from tsplan.encode.agent_classes import AgentClass
from tsplan.encode.encoded import Point, Setting
from tsplan.encode.policy_reading import policies_of
from tsplan.encode.read_back import (
    carried_at,
    executions_of,
    listed,
    modules_at,
    moves_of,
    node_names,
)
from tsplan.mission import Agent
from tsplan.plans.agent_plans import AgentPlan, joined
from tsplan.plans.decomposition import decompose, paths_of
from tsplan.plans.loading import loading
from tsplan.plans.moves import Move
from tsplan.plans.policies import Policy
from tsplan.plans.structure_paths import module_plan, structures_of
from tsplan.plans.structures import Rebuilt, Structure, module_paths
from tsplan.plans.supplies import Cargo, ExecutedTask

MOST_AGENTS = 1000
"""Agents up to which every one of a swarm gets a path; for more, `tsplan.assign` makes them."""


class Ways(TypedDict, total=False):
    """Where everybody goes, and how late that may be, as fields of a plan."""

    agents: tuple[AgentPlan, ...]
    moves: dict[str, tuple[Move, ...]]
    executions: tuple[ExecutedTask, ...]
    structures: tuple[Structure, ...]
    rebuilt: tuple[Rebuilt, ...]
    cargo: tuple[Cargo, ...]
    policies: tuple[Policy, ...]
    delay: int | None


def _promised(setting: Setting, point: Point) -> int | None:
    """How late agents may be, where the mission says anything of that."""
    mission = setting.mission
    if not mission.delay and "delay" not in mission.objective:
        return None
    return point.encoded.setting.delay


def _by_nodes(
    setting: Setting,
    item: AgentClass,
    members: Sequence[Agent],
    moves: Sequence[Move],
    seed: int | None,
) -> tuple[AgentPlan, ...]:
    """The paths of a class whose map has modes, so that its agents count as its flow does."""
    graph, names = item.graph, node_names(setting, item)
    assert graph.modes is not None
    ends = (graph.tail.tolist(), graph.head.tolist(), graph.duration.tolist())
    durations = {(names[tail], names[head]): d for tail, head, d in zip(*ends, strict=True)}
    states = (setting.arrays.names[place] for place in graph.modes.place.tolist())
    state = dict(zip(names, states, strict=True))
    made = decompose(members, moves, durations, setting.horizon, seed)
    return tuple(
        replace(
            agent,
            stays=tuple(joined((*span, state[node]) for *span, node in agent.stays)),
            heading=None if agent.heading is None else state[agent.heading],
        )
        for agent in made
    )


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
    for item, entered in moves_of(point):
        if item.shape is not None:
            continue
        made = listed(setting, item, entered)
        if item.bounds is not None:
            moves[mission.team[item.groups[0]].class_name] = made
            if mission.size > MOST_AGENTS:
                continue
        spans = (range(begins[group], begins[group + 1]) for group in item.groups)
        numbers = [number for span in spans for number in span]
        members = [mission.agents[number] for number in numbers]
        if item.graph.modes is None or item.bounds is not None:
            late = item.graph.modes is not None
            walked = paths_of(mission, members, made, seed, late=late)
        else:
            walked = _by_nodes(setting, item, members, made, seed)
        agents.update(zip(numbers, walked, strict=True))
    structures, rebuilt = structures_of(mission, modules_at(setting, point))
    modules = module_paths(structures)
    for number, group in enumerate(mission.team):
        for member in range(begins[number], begins[number + 1]) if group.configuration else ():
            agent = mission.agents[member]
            agents[member] = module_plan(agent, modules[agent.id])
    paths = tuple(agents[number] for number in sorted(agents))
    names = setting.arrays.names
    done = [(step, names[state], task.task) for task, state, step in executions_of(point)]
    return Ways(
        moves=moves,
        agents=paths,
        executions=tuple(ExecutedTask(task, state, step) for step, state, task in sorted(done)),
        structures=structures,
        rebuilt=rebuilt,
        delay=_promised(setting, point),
        cargo=loading(mission, (*paths, *structures), carried_at(setting, point)),
    )
