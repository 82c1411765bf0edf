"""Plans that agents walk along at random, and worlds in which they are late, lost or elsewhere.

Nothing here knows the monitor: agents are moved on step by step.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from random import Random

import numpy as np

from tsplan.logic import CountTrace, conjunction, horizon, parse
from tsplan.mission import Agent, Mission
from tsplan.plans.agent_plans import AgentPlan, joined
from tsplan.plans.count_traces import count_trace
from tsplan.plans.outcomes import MissionRef, Status
from tsplan.plans.plan import Plan
from tsplan.stopping import StoppedBy
from tsplan.testing import random_mission
from tsplan.testing.random_missions import random_formula

CAPABILITIES = (None, "u", "v")


def followed_mission(seed: int, *, steps: int = 14) -> Mission:
    """A mission with two or three conjuncts over a longer horizon than they ask for."""
    random = Random(f"followed {seed}")
    base = random_mission(seed, states=5, most_agents=5)
    parts = [parse(random_formula(random, 3)) for _ in range(random.choice([1, 2, 3]))]
    parts = [part for part in parts if horizon(part) <= steps] or [parse("F[0,9] a")]
    formula = conjunction(parts)
    return replace(
        base,
        formula=formula,
        text=str(formula),
        language="mtl",
        horizon=max(horizon(formula), steps),
        task_interval="closed",
        objective=(),
    )


def walked_plan(mission: Mission, random: Random) -> Plan:
    """A plan in which every agent takes edges at random."""
    agents = tuple(_walk(mission, agent, random) for agent in mission.agents)
    ref = MissionRef(mission.name, mission.digest)
    return Plan(Status.FEASIBLE, ref, mission.horizon, StoppedBy.GAP, agents=agents)


def _walk(mission: Mission, agent: Agent, random: Random) -> AgentPlan:
    state, step, heading = agent.start, 0, None
    stays = [(0, 0, state)]
    while step < mission.horizon:
        edges = [
            edge
            for edge in mission.system.leaving(state)
            if edge.duration_for(agent.class_name) is not None
        ]
        if not edges:  # nobody leaves from here, and nobody can wait: it is on no edge at all
            stays[-1] = (stays[-1][0], mission.horizon, state)
            break
        edge = random.choice([*edges, *(edge for edge in edges if edge.is_wait)])
        step += edge.duration_for(agent.class_name) or 0
        state = edge.target
        if step <= mission.horizon:
            stays.append((step, step, state))
        else:
            heading = state
    kept = tuple(joined(stays))
    return AgentPlan(agent.id, agent.class_name, agent.capabilities, kept, heading)


@dataclass(frozen=True)
class Walker:
    """An agent at a stay of its path since a step, or on the edge after it, or lost."""

    path: AgentPlan
    horizon: int
    place: int = 0
    arrives: int | None = None  # at the next stay, where it is on its way
    lost: bool = False

    @property
    def state(self) -> str | None:
        """Where it is, if it is at a state."""
        return None if self.lost or self.arrives is not None else self.path.stays[self.place][2]

    @property
    def position(self) -> object:
        """The same as monitors are told."""
        if self.lost or self.arrives is None:
            return self.state
        return self.path.stays[self.place][2], self._target(self.place)

    def step(self, now: int, *, late: bool = False) -> Walker:
        """Where it is at step `now`, having been here a step ago; later than it could if `late`."""
        if self.lost:
            return self
        if self.arrives is not None:
            if self.arrives > now:
                return self
            return replace(self, arrives=now + 1) if late else self._at(self.place + 1)
        last = self.path.stays[self.place][1]
        target = self._target(self.place)
        if target is None or last > now - 1 or late:
            return self
        if self.place + 1 == len(self.path.stays):
            return replace(self, arrives=now + self.horizon)
        arrives = now - 1 + self.path.stays[self.place + 1][0] - last
        return self._at(self.place + 1) if arrives <= now else replace(self, arrives=arrives)

    def _at(self, place: int) -> Walker:
        return replace(self, place=place, arrives=None)

    def _target(self, place: int) -> str | None:
        ahead = self.path.stays[place + 1 :]
        return ahead[0][2] if ahead else self.path.heading


def onwards(walkers: list[Walker], now: int) -> list[list[str | None]]:
    """The states of all at the steps after `now`, if nothing else happens; one list a step."""
    found = []
    for step in range(now + 1, walkers[0].horizon + 1):
        walkers = [walker.step(step) for walker in walkers]
        found.append([walker.state for walker in walkers])
    return found


def counted(mission: Mission, columns: list[list[str | None]]) -> CountTrace:
    """The counts of the mission's agents at states, by one list of states a step."""
    row = {state: number for number, state in enumerate(mission.system.states)}
    counts = {name: np.zeros((len(row), len(columns)), dtype=int) for name in CAPABILITIES}
    for step, states in enumerate(columns):
        for agent, state in zip(mission.agents, states, strict=True):
            for name in CAPABILITIES:
                if state is not None and (name is None or name in agent.capabilities):
                    counts[name][row[state], step] += 1
    return count_trace(mission.system, counts)
