"""The monitor of modular robots against structures that are moved on step by step."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from math import inf
from random import Random

import numpy as np
import pytest

import tsplan
from tests.command_line import ROOT
from tests.fleet_worlds import Walker
from tests.module_missions import random_module_mission
from tests.seeds import seed_blocks
from tests.test_monitor import late
from tsplan.logic import And, holds, parse, robustness
from tsplan.logic.traces import CountTrace
from tsplan.milp.model import Ints
from tsplan.mission import Mission
from tsplan.monitoring.monitor import Monitor
from tsplan.monitoring.part_formulas import parts_of
from tsplan.plans.agent_plans import AgentPlan
from tsplan.plans.count_traces import count_trace
from tsplan.plans.plan import Plan
from tsplan.plans.structures import Rebuilt, Structure
from tsplan.testing import with_starts_under_way


@dataclass(frozen=True)
class Body:
    """A robot or structure: walking, or not there before a step, coming from a state.

    `comes` is None for what is not being made, or has not begun to come.
    """

    walker: Walker
    comes: float | None = None
    origin: str = ""
    gone: bool = False
    modules: tuple[str, ...] = ()

    @property
    def state(self) -> str | None:
        return None if self.gone or self.comes is not None else self.walker.state

    @property
    def waits(self) -> bool:
        """Whether it is where it goes last."""
        path, walker = self.walker.path, self.walker
        there = self.comes is None and walker.arrives is None and not self.gone
        return there and walker.place == len(path.stays) - 1 and path.heading is None

    @property
    def position(self) -> object:
        if self.comes is not None and not self.walker.lost:
            stays, heading = self.walker.path.stays, self.walker.path.heading
            return self.origin, stays[0][2] if stays else heading
        return self.walker.position

    def step(self, now: int, *, held: bool) -> Body:
        if self.comes is None or self.walker.lost:
            return replace(self, walker=self.walker.step(now, late=held))
        if self.comes > now:
            return self
        return replace(self, comes=now + 1) if held else replace(self, comes=None)


@dataclass
class Bodies:
    """Everybody, and what is to be rebuilt still."""

    mission: Mission
    here: dict[str, Body]
    rebuilt: list[tuple[Rebuilt, dict[str, int]]]
    columns: list[Counter[tuple[frozenset[str], str]]] = field(default_factory=list)

    @classmethod
    def of(cls, mission: Mission, plan: Plan) -> Bodies:
        here = {}
        robots = [path for bundle in plan.robots for path in map(plan.agent.get, bundle.agents)]
        for each in (*robots, *plan.structures):
            assert each is not None
            modules = each.modules if isinstance(each, Structure) else ()
            path = AgentPlan(each.id, each.class_name, each.capabilities, each.stays, each.heading)
            begins = each.first if isinstance(each, Structure) else 0
            coming = each.coming or (each.stays[0][2] if begins else "")
            comes = (each.stays[0][0] if each.stays else inf) if coming else None
            walker = Walker(path, mission.horizon)
            here[each.id] = Body(walker, inf if begins else comes, coming, modules=modules)
        first = {each.id: each.first for each in plan.structures}
        rebuilt = [(r, {name: first[name] - r.step for name in r.made}) for r in plan.rebuilt]
        return cls(mission, here, rebuilt)

    def copy(self) -> Bodies:
        return Bodies(self.mission, dict(self.here), list(self.rebuilt), list(self.columns))

    def step(self, now: int, held: Iterable[str] = (), lost: Iterable[str] = ()) -> None:
        """Let a step go by; who is held does not go on, and what it is part of is not rebuilt."""
        for name in lost:
            body = self.here[name]
            self.here[name] = replace(body, walker=replace(body.walker, lost=True))
        begun = [
            (r, made)
            for r, made in self.rebuilt
            if r.step <= now - 1 < self.mission.horizon
            and all(self.here[p].waits and self.here[p].state is not None for p in r.parts)
            and not set(r.parts) & set(held)
        ]
        for r, made in begun:
            self.rebuilt.remove((r, made))
            for part in r.parts:
                self.here[part] = replace(self.here[part], gone=True)
            for name, steps in made.items():
                self.here[name] = replace(self.here[name], comes=now - 1 + steps)
        for name, body in self.here.items():
            self.here[name] = body.step(now, held=name in held)

    def note(self) -> None:
        """Write down who is where."""
        there = (body for body in self.here.values() if body.state is not None)
        self.columns.append(Counter((b.walker.path.capabilities, str(b.state)) for b in there))

    @property
    def trace(self) -> CountTrace:
        row = {state: number for number, state in enumerate(self.mission.system.states)}
        names = (None, *self.mission.capabilities)
        counts = {name: np.zeros((len(row), len(self.columns)), dtype=int) for name in names}
        for step, there in enumerate(self.columns):
            for (able, state), count in there.items():
                for name in names:
                    counts[name][row[state], step] += count * (name is None or name in able)
        return count_trace(self.mission.system, counts)

    def expected(self, pause: int = 0) -> CountTrace:
        """The trace if all stop for so long and then go on."""
        other = self.copy()
        now = len(self.columns) - 1
        other.columns += [self.columns[-1]] * pause
        for step in range(now + 1, self.mission.horizon + 1):
            other.step(step)
            other.note()
        return other.trace if not pause else _cut(other, self.mission.horizon + 1)

    def told(self, random: Random) -> dict[str, object]:
        """What a monitor is told: of structures by their ids, or by a module."""
        found: dict[str, object] = {}
        for name, body in self.here.items():
            if body.gone:
                if random.random() < 0.2:
                    state = body.walker.path.stays[-1][2]
                    found[name] = state, state
            elif body.comes != inf or body.walker.lost:
                by_module = body.modules and not body.waits and body.comes is None
                found[random.choice(body.modules) if by_module else name] = body.position
        return found

    def codes(self, monitor: Monitor) -> Ints:
        """The same as an array."""
        number = {state: place for place, state in enumerate(monitor.states)}
        bodies = [self.here[name] for name in monitor.agents]
        return np.array(
            [-2 if b.walker.lost else -1 if b.state is None else number[b.state] for b in bodies]
        )


def _cut(bodies: Bodies, steps: int) -> CountTrace:
    return replace(bodies, columns=bodies.columns[:steps]).trace


def follow(mission: Mission, seed: int, *, tardy: float = 0.2, loss: float = 0.02) -> int:
    plan = tsplan.plan(mission)
    if not plan.has_paths:
        return 0
    random, monitor, bodies = Random(seed), Monitor(mission, plan), Bodies.of(mission, plan)
    other = Monitor(mission, plan)
    parts = parts_of(mission)
    goal = And(tuple(p.goal for p in parts)) if len(parts) > 1 else parts[0].goal
    for now in range(mission.horizon + 1):
        if now:
            names = [name for name, body in bodies.here.items() if not body.gone]
            held = {name for name in names if random.random() < tardy}
            alive = [n for n in names if bodies.here[n].comes != inf]
            bodies.step(now, held, [name for name in alive if random.random() < loss])
        bodies.note()
        verdict = monitor.update(now, bodies.told(random))
        assert other.update(now, bodies.codes(other)) == verdict
        rest = bodies.expected()
        assert verdict.slack.agents == robustness(goal, rest)[0], (seed, now)
        assert verdict.works is bool(holds(goal, rest)[0])
        assert verdict.slack.steps == late(goal, rest, now), (seed, now)
        for part, said in zip(parts, verdict.parts, strict=True):
            assert said.slack.agents == robustness(part.goal, rest)[0]
            if said.truth != "open":
                judge_early(bodies, part.goal, random, truth=said.truth == "holds")
    assert verdict.truth == ("holds" if holds(goal, bodies.trace)[0] else "violated")
    return len(plan.rebuilt)


def judge_early(bodies: Bodies, goal: tsplan.Formula, random: Random, *, truth: bool) -> None:
    """No other bodies of those that are left, anywhere, undo what is decided."""
    states, (pool, *_) = (
        list(bodies.mission.system.states),
        bodies.mission.modular.pools(bodies.mission.team),
    )
    alive = [body for body in bodies.here.values() if not body.walker.lost and not body.gone]
    lost = {m for body in bodies.here.values() if body.walker.lost for m in body.modules}
    modules = {m for body in bodies.here.values() for m in body.modules} - lost
    for _ in range(3):
        other = bodies.copy()
        while len(other.columns) <= bodies.mission.horizon:
            left = len(modules)
            there = [body.walker.path.capabilities for body in alive if not body.modules]
            while left and random.random() < 0.9:
                fitting = [each for each in pool.shapes if each.modules <= left]
                if not fitting:
                    break
                shape = random.choice(fitting)
                left -= shape.modules
                there.append(shape.capabilities)
            column = Counter((able, random.choice(states)) for able in there)
            other.columns.append(column)
        assert bool(holds(goal, other.trace)[0]) is truth


@pytest.mark.parametrize("seeds", seed_blocks(range(14), range(2000), 20))
def test_verdicts_are_those_of_whole_traces_and_never_too_early(seeds: list[int]) -> None:
    for seed in seeds:
        mission = random_module_mission(seed, steps=6, modules=5)
        if seed % 4 == 0:
            mission = with_starts_under_way(mission, seed)
        follow(mission, seed)


POSTS = "F[0,14] sum(north,set) >= 1 && F[0,18] sum(rail,lift) >= 1 && F[6,16] G[0,3] gate"


@pytest.mark.parametrize("seeds", seed_blocks(range(2), range(200), 5))
def test_long_ways_over_several_structures(seeds: list[int]) -> None:
    fence = tsplan.load_mission(ROOT / "environments" / "fence_build.yaml")
    formula = parse(POSTS)
    mission = replace(fence, formula=formula, text=POSTS, language="mtl", objective=("energy",))
    for seed in seeds:
        assert follow(mission, seed, tardy=0.1, loss=0.003) >= 2
