"""Planning again: against all continuations of tiny plans, and in what is said of it."""

from __future__ import annotations

import random
from collections import Counter
from dataclasses import replace
from math import inf

import numpy as np
import pytest

import tsplan
from tests.joint_plans import SENSE, joint_plans, small_enough
from tests.seeds import seed_blocks
from tsplan import Mission, Plan
from tsplan.errors import PlanError
from tsplan.logic import TRUE
from tsplan.logic.evaluation import CountTrace, robustness
from tsplan.mission import Group, UnderWay
from tsplan.plans.moves import present, splits
from tsplan.replanning.replanner import replan
from tsplan.testing import random_mission, random_swarm_mission
from tsplan.ts.builders import grid


class Past:
    """What really happened until a step; nothing here knows `tsplan.history`."""

    def __init__(self, mission: Mission, plan: Plan, step: int) -> None:
        self.mission, self.step = mission, step
        self.states = {
            agent.id: [agent.state_at(at) for at in range(plan.horizon + 1)]
            for agent in plan.agents
        }
        self.places = {agent.id: self._place(agent) for agent in plan.agents}
        self.said: dict[str, object] = {}

    def _place(self, agent: tsplan.AgentPlan) -> str | UnderWay:
        here = agent.state_at(self.step)
        if here is not None:
            return here
        before = max((stay for stay in agent.stays if stay[0] <= self.step), default=None)
        after = [stay for stay in agent.stays if stay[0] > self.step]
        target = after[0][2] if after else agent.heading
        if before is None:
            (start,) = [each.start for each in self.mission.agents if each.id == agent.id]
            return UnderWay(start.origin, target, start.arrives - self.step)
        edge = self.mission.system.edges[before[2], target]
        lasts = edge.duration_for(agent.class_name)
        return UnderWay(before[2], target, before[1] + lasts - self.step)

    def lose(self, name: str) -> None:
        self.said.setdefault("lost", []).append(name)
        del self.places[name]

    def move(self, name: str, state: str) -> None:
        self.said.setdefault("moved", {})[name] = state
        self.places[name] = state

    def delay(self, plan: Plan, name: str, steps: int) -> bool:
        place, stays = self.places[name], plan.agent[name].stays
        if isinstance(place, UnderWay):
            self.places[name] = replace(place, arrives=place.arrives + steps)
        else:
            before, here = [*[stay for stay in stays if stay[0] <= self.step][-2:], None][:2]
            if here is None:
                return False
            for at in range(here[0], min(here[0] + steps, self.step + 1)):
                self.states[name][at] = None
            if here[0] + steps > self.step:
                self.places[name] = UnderWay(before[2], place, here[0] + steps - self.step)
        self.said.setdefault("late", {})[name] = steps
        return True

    def counts(self, capability: str | None, step: int) -> np.ndarray:
        found = np.zeros(len(self.mission.system.states))
        for agent in self.mission.agents:
            state = self.states[agent.id][step]
            if state is not None and capability in (None, *agent.capabilities):
                found[list(self.mission.system.states).index(state)] += 1
        return found

    def overfull(self, system: tsplan.TransitionSystem) -> bool:
        """Whether capacities are exceeded by who is there, which replanning puts up with."""
        try:
            self.continued(system)
        except tsplan.MissionError:
            return True
        return False

    def continued(self, system: tsplan.TransitionSystem) -> Mission:
        """A mission of those that are left, in which anything may be done."""
        of = {agent.id: agent for agent in self.mission.agents}
        team = [
            Group.of(of[name].class_name, {place: 1}, of[name].capabilities)
            for name, place in self.places.items()
        ]
        horizon = self.mission.horizon - self.step
        return replace(
            self.mission,
            system=system,
            team=tuple(team),
            formula=TRUE,
            text="",
            horizon=horizon,
            objective=(),
            prefer=(),
            delay=0,
        )


def best_continuation(past: Past, system: tsplan.TransitionSystem, formula: tsplan.Formula):
    """The best values of all ways to go on, signed to be minimised."""
    mission, found = past.mission, None
    for joint in joint_plans(past.continued(system)):
        slack = whole_slack(past, joint, formula)
        if slack < 0:
            continue
        worth = {"availability": lambda: slack, "makespan": lambda: _last(joint, past.step)}  # noqa: B023
        value = tuple(
            float(SENSE[name] * worth.get(name, lambda: joint.worth(name))())  # noqa: B023
            for name in mission.objective
        )
        found = value if found is None else min(found, value)
    return found


def whole_slack(past: Past, joint, formula: tsplan.Formula) -> float:
    """The robustness of a formula on what happened and a way to go on."""
    return float(robustness(past.mission.counting(formula), whole_trace(past, joint))[0])


def whole_trace(past: Past, joint) -> CountTrace:
    """What happened and a way to go on."""
    mission, later = past.mission, joint.trace(0)
    shape = len(mission.system.states), past.step
    whole = {
        name: np.concatenate(
            [
                np.array([past.counts(name, at) for at in range(past.step)]).T.reshape(shape),
                later.counts.get(name, np.zeros_like(later.counts[None])),
            ],
            axis=1,
        )
        for name in (None, *mission.capabilities)
    }
    return CountTrace(whole, later.labels)


def _last(joint, step: int) -> int:
    last = joint.worth("makespan")
    return last + step if last else 0


def small(seed: int) -> Mission:
    return random_mission(seed, states=4, most_agents=3, steps=5)


def disturbed(mission: Mission, plan: Plan, seed: int) -> tuple[Past, tsplan.TransitionSystem]:
    draw = random.Random(seed)
    past = Past(mission, plan, draw.randint(0, min(4, mission.horizon)))
    names = [agent.id for agent in plan.agents]
    kind = draw.choice(["nothing", "lost", "moved", "late", "late", "closed", "shut", "slow"])
    if kind == "lost" and len(names) > 1 and past.step:
        past.lose(draw.choice(names))
    if kind == "moved" and past.step:
        name = draw.choice(names)
        able = plan.agent[name].capabilities
        fitting = [s.name for s in mission.system.states.values() if s.needs <= able]
        past.move(name, draw.choice(fitting))
    if kind == "late" and past.step:
        for name in draw.sample(names, len(names)):
            if past.delay(plan, name, draw.randint(1, 3)):
                break
    edges = dict(mission.system.edges)
    rides = [pair for pair, edge in edges.items() if not edge.is_wait]
    if kind == "closed" and rides:
        gone = draw.choice(rides)
        del edges[gone]
        past.said["closed"] = [gone]
    if kind == "shut" and rides:
        pair, until = draw.choice(rides), past.step + draw.randint(0, 3)
        edges[pair] = replace(edges[pair], closed=((0, until - past.step),))
        past.said["closed"] = [{"place": pair, "until": until}]
    if kind == "slow" and rides:
        pair = draw.choice(rides)
        edges[pair] = replace(edges[pair], duration=3)
        past.said["opened"] = [{"from": pair[0], "to": pair[1], "duration": 3}]
    system = mission.system.rebuilt(mission.system.states.values(), edges.values())
    return past, system


def comparable(mission: Mission) -> bool:
    return not (mission.delay or "delay" in mission.objective or mission.partial or mission.prefer)


@pytest.mark.parametrize("seeds", seed_blocks(range(10), range(4000), 20))
def test_what_is_planned_again_is_the_best_of_all_continuations(seeds: list[int]) -> None:
    for seed in seeds:
        mission = small(seed)
        if not comparable(mission):
            continue
        plan = tsplan.plan(mission)
        if not plan.has_paths:
            continue
        past, system = disturbed(mission, plan, seed)
        if past.overfull(system) or not small_enough(past.continued(system)):
            continue
        expected = best_continuation(past, system, mission.formula)
        made = replan(mission, plan, past.step, **past.said)
        if expected is None:
            assert made.status == "infeasible", seed
            continue
        assert (made.status, made.verified) == ("optimal", True), seed
        found = [
            (item.name, SENSE[item.name] * (inf if item.value is None else item.value), item.bound)
            for item in made.objective
        ]
        assert tuple(value for _, value, _ in found) == pytest.approx(expected, abs=1e-6), seed
        assert tsplan.check(mission, Plan.from_json(made.to_json())).ok, seed


def changed(plan: Plan, made: Plan, past: Past) -> int:
    """How many go on otherwise that could go on as planned."""
    free = [
        name
        for name in past.places
        if name not in {**past.said.get("moved", {}), **past.said.get("late", {})}
    ]
    return sum(
        any(
            plan.agent[name].state_at(at) != made.agent[name].state_at(at)
            for at in range(past.step, plan.horizon + 1)
        )
        for name in free
    )


@pytest.mark.parametrize("seeds", seed_blocks(range(10), range(2000), 20))
def test_as_few_as_can_be_go_on_otherwise(seeds: list[int]) -> None:
    for seed in seeds:
        mission = replace(small(seed), objective=("stability",))
        if not comparable(mission):
            continue
        plan = tsplan.plan(replace(mission, objective=("travel",)))
        if not plan.has_paths:
            continue
        past, system = disturbed(mission, plan, seed)
        if past.overfull(system) or not small_enough(past.continued(system)):
            continue
        expected = fewest_changes(past, system, plan)
        made = replan(mission, plan, past.step, **past.said)
        assert (expected is None) == (not made.has_paths), seed
        if expected is not None:
            assert changed(plan, made, past) == made.value("stability") == expected[0], seed
            assert made.value("deviation") == expected[1], seed
            assert tsplan.check(mission, Plan.from_json(made.to_json())).ok, seed


def fewest_changes(past: Past, system: tsplan.TransitionSystem, plan: Plan):
    """The least number of robots that go on otherwise, and then of places that lack robots."""
    mission, found = past.mission, None
    continued = past.continued(system)
    names = list(past.places)
    told = {**past.said.get("moved", {}), **past.said.get("late", {})}
    steps = range(past.step, mission.horizon + 1)
    wanted = {
        name: tuple(plan.agent[name].state_at(at) for at in steps)
        for name in names
        if name not in told
    }
    asked = Counter(
        (state, at) for states in wanted.values() for at, state in enumerate(states) if state
    )
    of = {agent.id: agent for agent in mission.agents}
    for joint in joint_plans(continued):
        if whole_slack(past, joint, mission.formula) < 0:
            continue
        kinds = {}
        for agent, path in zip(continued.agents, joint.paths, strict=True):
            key = agent.class_name, agent.start, agent.capabilities
            kinds.setdefault(key, []).append(path.states)
        kept = 0
        for name, states in wanted.items():
            mine = kinds.get((of[name].class_name, past.places[name], of[name].capabilities), [])
            if states in mine:
                mine.remove(states)
                kept += 1
        there = Counter(
            (state, at) for path in joint.paths for at, state in enumerate(path.states) if state
        )
        missing = sum(max(count - there[place], 0) for place, count in asked.items())
        value = (len(wanted) - kept, missing)
        found = value if found is None else min(found, value)
    return found


@pytest.mark.parametrize("seeds", seed_blocks(range(20_000, 20_006), range(20_000, 20_800), 30))
def test_swarms_go_on_as_well_as_planned(seeds: list[int]) -> None:
    for seed in seeds:
        mission = random_swarm_mission(seed)
        if mission.partial or mission.prefer or mission.delay or "delay" in mission.objective:
            continue
        plan = tsplan.plan(mission, time_limit=5)
        if plan.status != "optimal" or not mission.horizon:
            continue
        step = seed % mission.horizon
        made = replan(mission, plan, step, options={"time_limit": 20})
        assert made.has_paths, seed
        assert tsplan.check(mission, Plan.from_json(made.to_json())).ok, seed
        spent = {
            "travel": sum(
                move.count * mission.system.edges[move.source, move.target].duration_for(name)
                for name, moves in plan.moves.items()
                for move in moves
                if move.step < step and not move.is_wait
            ),
            "splits": sum(
                splits([move for move in moves if move.step < step])
                for moves in plan.moves.values()
            ),
            "moves": sum(
                move.step < step and not move.is_wait
                for moves in plan.moves.values()
                for move in moves
            ),
        }
        first = plan.objective[0] if plan.objective else None
        if first is not None and first.name in spent and made.status == "optimal":
            assert made.value(first.name) + spent[first.name] == first.value, seed
        if first is not None and first.name == "availability":
            assert made.value("availability") == first.value, seed


def test_numbers_of_a_swarm_that_strayed() -> None:
    mission = tsplan.Mission.of(
        map=grid(1, 4, labels={(0, 3): "far"}),
        swarm={"size": 10, "at": "r0c0"},
        formula="F[0,8] far >= 6",
    )
    plan = tsplan.plan(mission)
    step = 2
    at = {state: count for (state, when), count in there(mission, plan).items() if when == step}
    (state, count), *_ = at.items()
    made = replan(mission, plan, step, numbers={"swarm": {state: count - 4}})
    assert made.has_paths
    assert tsplan.check(mission, made).ok
    gone = replan(mission, plan, step, numbers={"swarm": {state: 5}})
    assert gone.status == "infeasible"
    with pytest.raises(PlanError, match="no swarm 'bees'"):
        replan(mission, plan, step, numbers={"bees": {state: 5}})
    with pytest.raises(PlanError, match="nobody of swarm is left"):
        replan(mission, plan, step, numbers={"swarm": {state: 0}})


def there(mission: Mission, plan: Plan) -> dict[tuple[str, int], int]:
    durations = dict.fromkeys(mission.system.edges, 1)
    return present({"r0c0": 10}, plan.moves["swarm"], durations, mission.horizon)
