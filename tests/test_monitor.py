"""The monitor against whole traces, progression and agents that are moved on step by step."""

from __future__ import annotations

from dataclasses import replace
from math import inf
from random import Random

import numpy as np
import pytest

import tsplan
from tests.fleet_worlds import Walker, counted, followed_mission, onwards, walked_plan
from tests.seeds import seed_blocks
from tsplan.errors import InputError, PlanError
from tsplan.logic import And, holds, progress, robustness
from tsplan.logic.settled import settled
from tsplan.mission import mission_from_text
from tsplan.monitoring.monitor import Monitor
from tsplan.monitoring.part_formulas import parts_of


class World:
    """A plan that is carried out, with delays and losses, beside a monitor that is told of it."""

    def __init__(self, seed: int, *, late: float = 0.15, loss: float = 0.02):
        self.random = Random(seed)
        self.late, self.loss = late, loss
        self.mission = followed_mission(seed)
        self.plan = walked_plan(self.mission, self.random)
        self.monitor = Monitor(self.mission, self.plan)
        self.walkers = [Walker(agent, self.mission.horizon) for agent in self.plan.agents]
        self.columns: list[list[str | None]] = []

    def step(self, now: int):
        """Let a step go by and tell the monitor of what it does not expect, or of everything."""
        if now:
            self.walkers = [
                replace(walker, lost=walker.lost or self.random.random() < self.loss).step(
                    now, late=self.random.random() < self.late
                )
                for walker in self.walkers
            ]
        self.columns.append([walker.state for walker in self.walkers])
        names = [agent.id for agent in self.plan.agents]
        told = {n: w.position for n, w in zip(names, self.walkers, strict=True)}
        return self.monitor.update(now, told)

    @property
    def so_far(self):
        return counted(self.mission, self.columns)

    def expected(self, pause: int = 0):
        """The trace if all agents stop for so long and then go on."""
        now = len(self.columns) - 1
        rest = [self.columns[-1]] * pause + onwards(self.walkers, now)
        return counted(self.mission, [*self.columns, *rest][: self.mission.horizon + 1])


def follow(seed: int) -> None:
    world = World(seed)
    parts = parts_of(world.mission)
    goal = And(tuple(p.goal for p in parts)) if len(parts) > 1 else parts[0].goal
    agents = world.mission.size
    for now in range(world.mission.horizon + 1):
        verdict = world.step(now)
        rest = world.expected()
        assert verdict.slack.agents == robustness(goal, rest)[0], (seed, now)
        assert verdict.works is bool(holds(goal, rest)[0])
        for part, said in zip(parts, verdict.parts, strict=True):
            assert said.slack.agents == robustness(part.goal, rest)[0]
            known = settled(progress(part.goal, world.so_far))
            if known is not None and said.truth == "open":
                raise AssertionError(f"{part.text} is decided at {now} in mission {seed}")
            if said.truth != "open":
                judge_early(world, part.goal, said.truth == "holds", agents)
        if 0 <= verdict.slack.steps < inf:
            for pause in range(int(verdict.slack.steps) + 1):
                assert holds(goal, world.expected(pause))[0], (seed, now, pause)
        elif verdict.slack.steps == inf:
            assert all(holds(goal, world.expected(pause))[0] for pause in range(20))
    whole = world.so_far
    for part, said in zip(parts, verdict.parts, strict=True):
        assert said.truth == ("holds" if holds(part.goal, whole)[0] else "violated")
    assert verdict.truth == ("holds" if holds(goal, whole)[0] else "violated")


def judge_early(world: World, goal, truth: bool, agents: int) -> None:
    """No continuation in which agents that are left are anywhere undoes what is decided."""
    states = [*world.mission.system.states, None]
    for _ in range(3):
        rest = [
            [None if w.lost else world.random.choice(states) for w in world.walkers]
            for _ in range(world.mission.horizon + 1 - len(world.columns))
        ]
        trace = counted(world.mission, [*world.columns, *rest])
        assert bool(holds(goal, trace)[0]) is truth


@pytest.mark.parametrize("seeds", seed_blocks(range(24), range(24, 2000), 8))
def test_verdicts_are_those_of_whole_traces_and_never_too_early(seeds):
    for seed in seeds:
        follow(seed)
