"""Planning again with modular robots: against everything that can still be done."""

from __future__ import annotations

import random
from collections import Counter
from dataclasses import dataclass, field, replace
from functools import cache
from typing import Any

import pytest

import tsplan
from tests.module_missions import (
    Body,
    Situation,
    Spent,
    TooManyError,
    World,
    best_from,
    random_module_mission,
    worth,
)
from tests.rich_missions import random_rich_mission
from tests.seeds import seed_blocks
from tsplan import Mission, Plan
from tsplan.errors import MissionError, PlanError
from tsplan.exact import exact
from tsplan.logic import walk
from tsplan.mission import load_mission
from tsplan.plans.structures import Structure
from tsplan.replanning.replanner import replan
from tsplan.testing import with_starts_under_way


@dataclass
class Past:
    """What there was until a step by a plan, and is; nothing here knows `tsplan.history`."""

    mission: Mission
    plan: Plan
    step: int
    said: dict[str, Any] = field(default_factory=dict)

    def __post_init__(self) -> None:
        plan, step = self.plan, self.step
        self.here: dict[str, Body] = {}
        self.coming: dict[str, tuple[int, Body]] = {}
        robots = [(a.id, a.class_name, a) for a in plan.agents if not self._modular(a.class_name)]
        bodies = [(s.id, s.configuration, s) for s in plan.structures]
        for name, kind, who in (*robots, *bodies):
            if isinstance(who, Structure) and not who.first <= step <= who.last:
                continue
            at = who.state_at(step)
            if at is not None:
                self.here[name] = Body(kind, at, False)
            else:
                self.coming[name] = self._arrival(kind, who)
        for each in plan.rebuilt:
            rule = self.mission.modular.reconfigurations[each.rule]
            done = each.step + rule.duration
            if each.step < step < done:
                kinds = [kind for kind, count in rule.made for _ in range(count)]
                for number, kind in enumerate(kinds):
                    self.coming[f"made {each} {number}"] = done, Body(kind, each.state, True)

    def _modular(self, class_name: str) -> bool:
        return any(g.class_name == class_name and g.configuration for g in self.mission.team)

    def _arrival(self, kind: str, who: Any) -> tuple[int, Body]:
        after = [stay for stay in who.stays if stay[0] > self.step]
        if after:
            return after[0][0], Body(kind, after[0][2], True)
        last = who.stays[-1]
        edge = self.mission.system.edges[last[2], who.heading]
        if isinstance(who, Structure):
            steps = self.mission.modular.of[kind].steps(edge, who.class_name)
        else:
            steps = edge.duration_for(kind)
        return last[1] + steps, Body(kind, who.heading, True)

    def entries(self) -> tuple[tuple[tuple[str, str, int], ...], ...]:
        """Who was where before the step."""
        found = []
        for step in range(self.step):
            now: Counter[tuple[str, str]] = Counter()
            for each in self.plan.structures:
                if each.state_at(step) is not None:
                    now[each.configuration, each.state_at(step)] += 1
            for agent in self.plan.agents:
                if not self._modular(agent.class_name) and agent.state_at(step) is not None:
                    now[agent.class_name, agent.state_at(step)] += 1
            found.append(tuple(sorted((*where, count) for where, count in now.items())))
        return tuple(found)

    def best(self, system: tsplan.TransitionSystem) -> tuple[float, ...] | None:
        """The best of all that can be done from the step on, smaller is better."""
        mission = replace(self.mission, system=system)
        world = World(mission)
        here = tuple(sorted(self.here.values()))
        coming = tuple(sorted(self.coming.values()))
        begun = Spent(makespan=max((end for end, _ in coming), default=0))
        first = world.seen(Situation(here, coming, self.entries()))
        return best_from(world, first, begun, self.step)


def disturbed(mission: Mission, plan: Plan, seed: int) -> tuple[Past, tsplan.TransitionSystem]:
    draw = random.Random(seed)
    eventful = [each.step + 1 for each in plan.rebuilt] or [1]
    steps = [min(draw.choice(eventful), mission.horizon), draw.randint(0, mission.horizon)]
    past = Past(mission, plan, draw.choice(steps))
    kind = draw.choice(["nothing", "nothing", "lost", "moved", "late", "closed"])
    names = {each.id: each.modules[0] for each in plan.structures}
    there = [name for name in (*past.here, *past.coming) if not name.startswith("made")]
    if kind == "lost" and past.step and there and len(past.here) + len(past.coming) > 1:
        name = draw.choice(there)
        past.here.pop(name, None)
        past.coming.pop(name, None)
        past.said["lost"] = [draw.choice([name, names.get(name, name)])]
    if kind == "moved" and past.step and there:
        name = draw.choice(there)
        body = past.here.pop(name, None) or past.coming.pop(name)[1]
        able = World(mission).able(body.kind)
        fitting = [s.name for s in mission.system.states.values() if s.needs <= able]
        past.here[name] = Body(body.kind, draw.choice(fitting), False)
        past.said["moved"] = {draw.choice([name, names.get(name, name)]): past.here[name].state}
    away = [name for name in there if name in past.coming]
    if kind == "late" and away:
        name, steps_late = draw.choice(away), draw.randint(1, 2)
        end, body = past.coming[name]
        past.coming[name] = end + steps_late, body
        past.said["late"] = {draw.choice([name, names.get(name, name)]): steps_late}
    edges = dict(mission.system.edges)
    if kind == "closed":
        gone = draw.choice([pair for pair, edge in edges.items() if not edge.is_wait])
        del edges[gone]
        past.said["closed"] = [gone]
    return past, mission.system.rebuilt(mission.system.states.values(), edges.values())


@pytest.mark.parametrize("seeds", seed_blocks(range(7), range(2000), 10))
def test_structures_go_on_as_well_as_can_be(seeds: list[int]) -> None:
    for seed in seeds:
        compare(random_module_mission(seed), seed)


def compare(mission: Mission, seed: int) -> None:
    plan = tsplan.plan(mission)
    if not plan.has_paths:
        return
    past, system = disturbed(mission, plan, seed)
    full = Counter(body.state for body in past.here.values())
    rooms = ((full[s.name], s.capacity) for s in mission.system.states.values())
    if any(most is not None and there > most for there, most in rooms):
        return
    try:
        expected = past.best(system)
    except TooManyError:
        return
    made = replan(mission, plan, past.step, **past.said)
    if expected is None:
        assert made.status == "infeasible", (seed, past.step, past.said)
        return
    assert (made.status, made.verified) == ("optimal", True), (seed, past.step, past.said)
    values = {item.name: item.value for item in made.objective}
    assert worth(mission, values) == pytest.approx(expected), (seed, past.step, past.said)
    read = Plan.from_json(made.to_json())
    assert tsplan.check(mission, read).ok, seed
    for step in range(past.step):  # history stays
        assert read.state_at(step).items() >= plan.state_at(step).items(), seed
    again = replan(mission, read, past.step)
    assert worth(mission, {item.name: item.value for item in again.objective}) == worth(
        mission, values
    ), seed


@pytest.mark.parametrize("seeds", seed_blocks([0, 1, 2, 3, 15], range(4, 600), 6))
def test_everything_mixed_goes_on(seeds: list[int]) -> None:
    for seed in seeds:
        mission = random_rich_mission(seed)
        if "performance" in mission.objective:
            continue
        plan = tsplan.plan(mission)
        for step in range(0, mission.horizon + 1, 2) if plan.status == "optimal" else ():
            made = replan(mission, plan, step)
            assert made.has_paths, (seed, step)
            assert tsplan.check(mission, Plan.from_json(made.to_json())).ok, (seed, step)


@pytest.mark.parametrize("seeds", seed_blocks([0, 1, 2, 162], range(4, 400), 4))
def test_what_structures_bring_from_the_start_goes_on(seeds: list[int]) -> None:
    for seed in seeds:
        mission = with_starts_under_way(random_rich_mission(seed), seed)
        if "performance" in mission.objective:
            continue
        plan = tsplan.plan(mission)
        tasks = {str(node): node for node in walk(mission.formula)}
        if plan.status == "optimal":  # those on one edge arrive when each of them does
            first = tsplan.rest_mission(mission, plan, 0)
            starts = [Counter() for _ in range(2)]
            for count, team in zip(starts, (mission.team, first.team), strict=True):
                for way, number in (each for group in team for each in group.coming):
                    count[way] += number
            assert starts[0] == starts[1], seed
        for step in range(mission.horizon + 1) if plan.status == "optimal" else ():
            made = replan(mission, plan, step)
            assert made.has_paths, (seed, step)
            rest = tsplan.rest_mission(mission, plan, step)
            for before, after in zip(mission.resources, rest.resources, strict=True):
                spent = sum(
                    exact(dict(tasks[each.task].resources).get(before.name, 0.0))
                    for each in plan.executions
                    if each.step < step and before.consumed
                )
                assert after.total == before.total - spent, (seed, step)
            assert tsplan.check(mission, Plan.from_json(made.to_json())).ok, (seed, step)


@cache
def fence() -> tuple[Mission, Plan]:
    mission = load_mission("environments/fence_build.yaml")
    return mission, tsplan.plan(mission)


def test_a_fence_is_built_on() -> None:
    mission, plan = fence()
    energy = [replan(mission, plan, step).value("energy") for step in (0, 5, 9, 15)]
    assert energy == [32, 21, 11, 0]


def test_what_is_told_of_modules_and_cannot_be_is_refused() -> None:
    mission, plan = fence()
    made = next(each for each in plan.structures if each.first)
    with pytest.raises(PlanError, match="no agent 'line-99'"):
        replan(mission, plan, 3, lost=["line-99"])
    with pytest.raises(PlanError, match="say it once"):
        replan(mission, plan, made.first, lost=[made.id, made.modules[0]])
    with pytest.raises(MissionError, match="stability"):
        replan(mission, plan, 3, objective=["stability"])
