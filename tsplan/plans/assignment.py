"""From the moves of swarms to one path per agent."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from tsplan.checking.plan_check import certify
from tsplan.checking.swarm_check import read_moves
from tsplan.errors import Finding, PlanError
from tsplan.limits import refuse_options
from tsplan.plans.decomposition import ClassFlow, decompose

if TYPE_CHECKING:
    from tsplan.mission import Agent, Mission
    from tsplan.plans.moves import Move
    from tsplan.plans.plan import AgentPlan, Plan
    from tsplan.ts import TransitionSystem


def assign(mission: Mission, plan: Plan, *, seed: int | None = None) -> Plan:
    """The plan of a swarm mission with a path for every agent, judged by the independent check.

    The paths together make exactly the plan's moves. They are the same for equal plans and seeds;
    another seed gives them to other agents. Raises PlanError for a plan without moves or with
    moves that the mission does not allow, and SolverError if the check refuses the plan.
    """
    if not plan.moves:
        what = "the plan has no moves of swarms to make paths of"
        raise PlanError([Finding(what, "plan a mission with a swarm")])
    refuse_options(seed=seed)
    _, problems = read_moves(mission, plan.moves)
    if problems:
        raise PlanError(Finding(words, "name the mission that was planned") for words in problems)
    return certify(mission, replace(plan, agents=agents_of(mission, plan.moves, seed)))


def agents_of(
    mission: Mission, moves: Mapping[str, Sequence[Move]], seed: int | None = None
) -> tuple[AgentPlan, ...]:
    """One path per agent, in the order of the mission; `moves` must fit the mission."""
    members: dict[str, list[Agent]] = {name: [] for name in moves}
    for agent in mission.agents:
        members.setdefault(agent.class_name, []).append(agent)
    made: list[AgentPlan] = []
    for group in mission.team:
        name = group.class_name
        flow = _flow(mission.system, members[name], moves.get(name, ()))
        made += decompose(flow, mission.horizon, seed)
    return tuple(made)


def _flow(system: TransitionSystem, members: Sequence[Agent], moves: Sequence[Move]) -> ClassFlow:
    """The moves of one swarm as a flow that can be decomposed into paths."""
    swarm = members[0].class_name
    pairs = sorted({(move.source, move.target) for move in moves})
    number = {pair: place for place, pair in enumerate(pairs)}
    entries = [(number[move.source, move.target], move.step, move.count) for move in moves]
    columns = np.array(entries, dtype=np.int64).reshape(-1, 3).T
    return ClassFlow(
        members=members,
        edges=[(*pair, system.edges[pair].duration_for(swarm) or 0) for pair in pairs],
        edge=columns[0],
        step=columns[1],
        count=columns[2],
    )
