"""Random missions of modular robots, and the best of everything that the tiny ones can do.

Nothing of the brute force knows the encoding: at every step each choice of reconfigurations and of
edges for all structures is tried, and formulas are judged by their robustness.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import combinations_with_replacement, pairwise, product
from math import inf
from random import Random
from typing import Any, NamedTuple

import numpy as np

from tsplan import Mission
from tsplan.exact import exact
from tsplan.logic import Always, And, Eventually, Formula, Or, Task, translate
from tsplan.logic.evaluation import holds, robustness
from tsplan.logic.traces import CountTrace
from tsplan.ts import Edge, State, TransitionSystem

SENSE = {
    "availability": -1,
    "travel": 1,
    "cost": 1,
    "energy": 1,
    "makespan": 1,
    "agents": 1,
    "performance": -1,
}
MOST = 60_000
"""Situations of a mission up to which everything that can be done is tried."""

SHAPES = {
    "one": {"modules": 1, "capabilities": ["u"]},
    "duo": {"modules": 2, "capabilities": ["v"]},
    "trio": {"modules": 3, "capabilities": ["u", "v"]},
}
RULES = [
    {"from": "one", "to": "duo"},
    {"from": "duo", "to": "one"},
    {"from": "one", "to": "trio"},
    {"from": {"duo": 1, "one": 1}, "to": "trio"},
    {"from": "trio", "to": {"one": 1, "duo": 1}},
    {"from": "trio", "to": "one"},
]


def random_module_mission(seed: int, *, steps: int = 4, modules: int = 4, **others: Any) -> Mission:
    """A mission of at most so many modules on three states; `others` are keys of its own."""
    random = Random(seed)
    names = ["p", "q", "r"]
    edges = {(name, name): 1 for name in names}
    for ends in (*pairwise(names), *pairwise(reversed(names))):
        edges[ends] = random.choice([1, 1, 2])
    states = [
        State(
            name,
            frozenset({{"p": "a", "r": "b"}.get(name, random.choice("ab"))}),
            capacity=random.choice([None, None, None, 2, 3]) if name != "p" else None,
            needs=frozenset({"v"}) if name == "r" and random.random() < 0.15 else frozenset(),
        )
        for name in names
    ]
    made = [
        Edge(*ends, duration, cost=random.choice([None, None, 0.5, 2]))
        for ends, duration in edges.items()
    ]
    shapes = {name: dict(shape) for name, shape in SHAPES.items()}
    for shape in shapes.values():
        shape["cost"] = random.choice([1, 1, 2, 0.5])
        shape["duration"] = random.choice([1, 1, 1, 1.5, 0.5])
    rules = [
        {
            **rule,
            "duration": random.choice([1, 1, 1, 2]),
            "cost": random.choice([0, 1, 2.5]),
            **({"at": [random.choice([*names, "a"])]} if random.random() < 0.4 else {}),
        }
        for rule in random.sample(RULES, random.randint(2, 5))
    ]
    horizon = random.randint(steps - 1, steps)
    count = random.randint(2, modules)
    kind = random.choice([name for name, s in SHAPES.items() if not count % int(str(s["modules"]))])
    team: list[dict[str, Any]] = [
        {"class": "cube", "count": count, "at": "p", "configuration": kind},
    ]
    if random.random() < 0.25:
        team.append({"class": "cart", "at": random.choice("pq"), "capabilities": ["u"]})
    named = [name for name in SENSE if name != "performance"]
    objective = random.sample(named, random.choice([1, 2, 2, 3]))
    if "performance" in others:
        objective.insert(random.randint(0, len(objective)), "performance")
    return Mission.of(
        map=TransitionSystem.build(states, made),
        team=team,
        configurations=shapes,
        reconfigure=rules,
        formula=_formula(random, horizon),
        objective=objective,
        horizon=horizon,
        **others,
    )


def _formula(random: Random, horizon: int) -> str:
    def part() -> str:
        first = random.randint(0, horizon - 1)
        last = random.choice([random.randint(first, horizon - 1), horizon - 1])
        who = random.choice(["u", "v"])
        needs = f"{{({who}, {random.choice([1, 1, 1, 2])})}}"
        task = f"T({random.randint(0, 1)}, {random.choice('ab')}, {needs})"
        return random.choice(
            [
                f"F[{first},{last}] {task}",
                f"F[{first},{last}] {task}",
                f"G[{first},{first}] F[0,{last - first}] {task}",
                f"F[{first},{last}] sum({random.choice('ab')}, {who}) >= {random.randint(1, 2)}",
                f"G[{first},{last}] sum({random.choice('ab')}) <= {random.randint(1, 3)}",
                f"{random.choice(['', '', '!'])}({task})",
            ]
        )

    parts = [part() for _ in range(random.choice([1, 2, 2, 3]))]
    return f" {random.choice(['&&', '&&', '||'])} ".join(f"({each})" for each in parts)


class Body(NamedTuple):
    """A structure or robot: what it is, where it is or will be, and whether it has ever moved."""

    kind: str
    state: str
    moved: bool


class Spent(NamedTuple):
    """What has been spent so far."""

    travel: int = 0
    cost: Fraction = Fraction(0)
    energy: Fraction = Fraction(0)
    makespan: int = 0

    def and_also(self, other: Spent) -> Spent:
        return Spent(
            self.travel + other.travel,
            self.cost + other.cost,
            self.energy + other.energy,
            max(self.makespan, other.makespan),
        )


@dataclass(frozen=True)
class Situation:
    """Who is at states, who comes later (with the step), and who was where at earlier steps."""

    here: tuple[Body, ...]
    coming: tuple[tuple[int, Body], ...]
    past: tuple[tuple[tuple[str, str, int], ...], ...] = ()


class TooManyError(Exception):
    """There is more that a mission can do than is tried."""


class World:
    """What the bodies of a mission can do; there is one class of modules, and robots."""

    def __init__(self, mission: Mission) -> None:
        self.mission = mission
        self.shapes = mission.modular.of
        self.robots = {g.class_name: g for g in mission.team if g.configuration is None}
        (self.group,) = [g for g in mission.team if g.configuration]

    def able(self, kind: str) -> frozenset[str]:
        if kind in self.robots:
            return self.robots[kind].capabilities
        return self.group.capabilities | self.shapes[kind].capabilities

    def modules(self, kind: str) -> int:
        return 1 if kind in self.robots else self.shapes[kind].modules

    def begin(self) -> Situation:
        bodies = [
            Body(group.configuration or group.class_name, state, False)
            for group in map(self.mission.modular.structures, self.mission.team)
            for state, count in group.starts
            for _ in range(count)
        ]
        coming = [
            (way.arrives, Body(group.configuration or group.class_name, way.target, True))
            for group in map(self.mission.modular.structures, self.mission.team)
            for way, count in group.coming
            for _ in range(count)
        ]
        return self.seen(Situation(tuple(sorted(bodies)), tuple(sorted(coming))))

    def begun(self) -> Spent:
        """What is spent by those that are under way at first: when the last of them arrives."""
        ends = [
            way.arrives
            for group in self.mission.team
            for way, _ in group.coming
            if group.configuration or way.origin != way.target
        ]
        return Spent(makespan=max(ends, default=0))

    def seen(self, situation: Situation) -> Situation:
        """The situation with who is where now among what was."""
        now = Counter((body.kind, body.state) for body in situation.here)
        entry = tuple(sorted((*where, count) for where, count in now.items()))
        return replace(situation, past=(*situation.past, entry))

    def ways(self, body: Body, step: int) -> Iterator[tuple[int, Body, Spent]]:
        """Every edge that a body may enter: when it is where, and what that costs."""
        system, able = self.mission.system, self.able(body.kind)
        robot = body.kind in self.robots
        name = body.kind if robot else self.group.class_name
        for edge in system.leaving(body.state):
            if not edge.needs | system.states[edge.target].needs <= able:
                continue
            steps = edge.duration_for(name)
            assert steps is not None
            cost = exact(edge.cost_for(name))
            if not robot:
                shape = self.shapes[body.kind]
                cost *= exact(shape.cost)
                if not edge.is_wait:
                    steps = -int(-(steps * exact(shape.duration)) // 1)
            wait = edge.is_wait
            spent = Spent(0 if wait else steps, cost, cost, 0 if wait else step + steps)
            yield step + steps, Body(body.kind, edge.target, body.moved or not wait), spent

    def rebuildings(
        self, here: Counter[Body], step: int, first: int = 0
    ) -> Iterator[tuple[Counter[Body], list[tuple[int, Body]], Spent]]:
        """Every choice of reconfigurations: who is left, who comes, what that costs."""
        yield here, [], Spent()
        places = [
            (rule, state)
            for rule in self.mission.modular.reconfigurations
            for state in self.mission.system.states
        ]
        for number in range(first, len(places)):
            rule, state = places[number]
            if rule.at and not {state, *self.mission.system.states[state].labels} & set(rule.at):
                continue
            if any(self.mission.system.states[state].needs - self.able(k) for k, _ in rule.made):
                continue
            end = step + rule.duration
            parts = sum(count for _, count in rule.parts)
            own = Spent(parts * rule.duration, Fraction(0), exact(rule.cost), end)
            made = [(end, Body(k, state, True)) for k, count in rule.made for _ in range(count)]
            for left in self._without(here, list(rule.parts), state):
                for rest, coming, spent in self.rebuildings(left, step, number):
                    yield rest, [*made, *coming], own.and_also(spent)

    def _without(
        self, here: Counter[Body], parts: list[tuple[str, int]], state: str
    ) -> Iterator[Counter[Body]]:
        """Who is left when parts are taken, of those that have moved or not."""
        if not parts:
            yield here
            return
        (kind, count), *others = parts
        new, old = Body(kind, state, False), Body(kind, state, True)
        for some in range(count + 1):
            if here[new] >= some and here[old] >= count - some:
                left = here.copy()
                left[new] -= some
                left[old] -= count - some
                yield from self._without(left, others, state)

    def steps(self, situation: Situation, step: int) -> Iterator[tuple[Situation, Spent]]:
        """Every situation that may come one step later."""
        for left, made, first in self.rebuildings(Counter(situation.here), step):
            groups = [(body, count) for body, count in left.items() if count]
            options = [
                list(combinations_with_replacement(list(self.ways(body, step)), count))
                for body, count in groups
            ]
            for choice in product(*options):
                gone = [way for ways in choice for way in ways]
                spent = first
                for _, _, own in gone:
                    spent = spent.and_also(own)
                coming = [*situation.coming, *made, *((end, body) for end, body, _ in gone)]
                here = tuple(sorted(body for end, body in coming if end == step + 1))
                later = tuple(sorted(item for item in coming if item[0] > step + 1))
                if self._fits(here):
                    yield self.seen(Situation(here, later, situation.past)), spent

    def _fits(self, here: tuple[Body, ...]) -> bool:
        count = Counter(body.state for body in here)
        capacity = ((count[s.name], s.capacity) for s in self.mission.system.states.values())
        return all(most is None or number <= most for number, most in capacity)

    def value(self, node: Formula, step: int, past: Past) -> float:
        """What the best way to meet a formula is worth at a step, by its definition."""
        window = range(step + getattr(node, "low", 0), step + getattr(node, "high", 0) + 1)
        match node:
            case And():
                return sum(self.value(child, step, past) for child in node.children)
            case Or():
                return max(self.value(child, step, past) for child in node.children)
            case Always():
                return sum(self.value(node.child, late, past) for late in window)
            case Eventually():
                return max(self.value(node.child, late, past) for late in window)
            case Task():
                done = self.done(node, step, past)
                return done if self.truth(node, step, past) else -inf
        return 0.0 if self.truth(node, step, past) else -inf

    def truth(self, node: Formula, step: int, past: Past) -> bool:
        return bool(holds(translate(node), self.trace(past))[step])

    def done(self, task: Task, step: int, past: Past) -> float:
        """The best of all choices of who serves which need of a task at each of its states."""
        worth = dict(dict(self.mission.modular.performance).get(task.label, ()))
        total = 0.0
        for state in self.mission.system.labels[task.label]:
            there = [
                {kind: count for kind, where, count in entry if where == state}
                for entry in past[step : step + task.duration + 1]
            ]
            bodies = [
                kind
                for kind in self.shapes
                for _ in range(min(entry.get(kind, 0) for entry in there))
            ]
            needs = [None, *(name for name, _ in task.needs)]
            total += max(
                sum(worth.get(kind, 0.0) for kind, need in zip(bodies, choice, strict=True) if need)
                for choice in product(needs, repeat=len(bodies))
                if all(choice.count(name) <= number for name, number in task.needs)
                and all(
                    need is None or need in self.able(kind)
                    for kind, need in zip(bodies, choice, strict=True)
                )
            )
        return total

    def trace(self, past: tuple[tuple[tuple[str, str, int], ...], ...]) -> CountTrace:
        """The counts of everything that was."""
        names = list(self.mission.system.states)
        kinds = [*self.shapes, *self.robots]
        able = {name for kind in kinds for name in self.able(kind)}
        shape = len(names), self.mission.horizon + 1
        counts: dict[str | None, Any] = {name: np.zeros(shape) for name in (None, *able)}
        for step, entry in enumerate(past):
            for kind, state, count in entry:
                for name in (None, *self.able(kind)):
                    counts[name][names.index(state), step] += count
        labels = {
            label: np.array([names.index(state) for state in states])
            for label, states in self.mission.system.labels.items()
        }
        return CountTrace(counts, labels)


Past = tuple[tuple[tuple[str, str, int], ...], ...]


def best(mission: Mission) -> tuple[float, ...] | None:
    """The best values of a mission's objectives, smaller is better; None if there is no plan.

    Raises TooManyError.
    """
    world = World(mission)
    return best_from(world, world.begin(), world.begun())


def best_from(
    world: World, first: Situation, begun: Spent, begin: int = 0
) -> tuple[float, ...] | None:
    """The best of all that may come after a situation at a step, with what is spent before."""
    mission = world.mission
    reached: dict[Situation, set[Spent]] = {first: {begun}}
    for step in range(begin, mission.horizon):
        later: dict[Situation, set[Spent]] = {}
        for situation, spents in reached.items():
            for after, own in world.steps(situation, step):
                later.setdefault(after, set()).update(each.and_also(own) for each in spents)
                if len(later) > MOST:
                    raise TooManyError
        reached = later
    slack: dict[Any, float] = {}
    found = None
    everybody = [*first.here, *(body for _, body in first.coming)]
    size = sum(world.modules(body.kind) for body in everybody)
    for situation, spents in reached.items():
        if situation.past not in slack:
            trace = world.trace(situation.past)
            slack[situation.past] = float(robustness(mission.counted, trace)[0])
        if slack[situation.past] < 0:
            continue
        bodies = [*situation.here, *(body for _, body in situation.coming)]
        idle = sum(world.modules(body.kind) for body in bodies if not body.moved)
        known = {"availability": slack[situation.past], "agents": size - idle}
        if "performance" in mission.objective:
            known["performance"] = world.value(mission.formula, 0, situation.past)
        for spent in spents:
            values = {**spent._asdict(), **known}
            mine = tuple(SENSE[name] * float(values[name]) for name in mission.objective)
            found = mine if found is None else min(found, mine)
    return found


def worth(mission: Mission, values: dict[str, float | None]) -> tuple[float, ...]:
    """What a plan's objectives come to, smaller is better."""
    return tuple(
        SENSE[name] * (inf if values[name] is None else float(values[name] or 0))
        for name in mission.objective
    )
