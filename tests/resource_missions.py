"""Random missions whose tasks are executed, and the best of all joint plans of the tiny ones.

They have resources, or agents that are booked for tasks, or both. Nothing of the brute force knows
the encoding: agents walk as edges say, and at every step each choice of executions and of loads is
tried. Whether the agents at a state are enough for all that runs there is found by trying one agent
after the other for one need after the other.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise, product
from math import inf
from random import Random

import numpy as np

from tests.joint_plans import JointPlan, joint_plans
from tsplan import Mission
from tsplan.logic import Task, walk
from tsplan.logic.evaluation import robustness
from tsplan.logic.traces import CountTrace
from tsplan.mission import Resource, UnderWay
from tsplan.mission.vocabulary import Booking
from tsplan.ts import Edge, State, TransitionSystem

SENSE = {"availability": -1, "travel": 1, "haulage": 1, "reserve": -1, "agents": 1, "makespan": 1}


def random_resource_mission(
    seed: int,
    *,
    states: int = 3,
    robots: int = 3,
    steps: int = 4,
    most: int = 3,
    parted: bool = False,
    restless: bool = False,
) -> Mission:
    """A mission with one or two resources, of which there are `most` at a state.

    With `parted`, any amounts of one resource may be carried, in halves at the start; `restless`
    robots can wait at some states alone.
    """
    random = Random(seed)
    names = [f"s{number}" for number in range(states)]
    labels = {name: set(random.choice(["a", "b", ""])) for name in names}
    labels[names[0]], labels[names[-1]] = {"a"}, {"b"}
    system = _map(random, labels, restless=restless)
    resources = _resources(random, names, most, parted=parted)
    team, left = [], random.randint(1, robots)
    while left:
        count = random.randint(1, left)
        left -= count
        member = {
            "class": f"k{len(team)}",
            "count": count,
            "at": random.choice(names),
            "capabilities": random.choice([["u"], ["u", "v"], ["u", "v"]]),
        }
        carries = _carries(random, [r["name"] for r in resources], parted=parted)
        team.append(member if carries is None else {**member, "carries": carries})
    horizon = random.randint(steps - 1, steps)
    stocked = {state for item in resources for state in item["at"]}
    dry = "".join(c for c in "ab" if not any(c in labels[state] for state in stocked))
    objective = random.sample(list(SENSE), random.choice([1, 2, 2, 3]))
    return Mission.of(
        map=system,
        team=team,
        resources=resources,
        formula=_formula(random, resources, (dry or "ab"), horizon),
        objective=objective,
        horizon=horizon,
    )


def random_booked_mission(
    seed: int, booking: Booking, *, robots: int = 3, steps: int = 3
) -> Mission:
    """A mission of three states that asks for several tasks at once; some have resources, too."""
    random = Random(seed)
    names = ["s0", "s1", "s2"]
    labels = {name: set(random.choice(["a", "", ""])) for name in names}
    labels["s2"] = {"a", "b"}
    system = _map(random, labels, back=0.15)
    resources = _resources(random, names, 2, parted=False) if random.random() < 0.2 else []
    team = []
    for number in range(random.choice([robots - 1, robots, robots])):
        able = random.choice([["u", "v"], ["u", "v"], ["u"], ["v", "w"], ["u", "v", "w"]])
        at = random.choice(["s0", "s1", "s2"])
        team.append({"class": f"k{number}", "at": at, "capabilities": able})
        if resources:
            team[-1]["carries"] = random.choice([1, 2])
    objective = random.sample(["availability", "travel", "makespan", "agents"], 2)
    return Mission.of(
        map=system,
        team=team,
        resources=resources,
        booking=booking,
        formula=_tasks_at_once(random, [item["name"] for item in resources], steps),
        objective=objective,
        horizon=steps,
    )


def _tasks_at_once(random: Random, resources: list[str], horizon: int) -> str:
    """Tasks that get in each other's way, and counts that do not care."""

    def task(longest: int = 1) -> str:
        names = random.sample("uv", random.choice([1, 1, 1, 2]))
        needs = ",".join(f"({name},{random.choice([1, 1, 1, 1, 2])})" for name in names)
        label = random.choice(["b", "b", "s2", "s2", "a"])
        amounts = (
            f",{{({random.choice(resources)},1)}}" if resources and random.random() < 0.5 else ""
        )
        return f"T({random.randint(0, longest)},{label},{{{needs}}}{amounts})"

    def part() -> str:
        last, kind = horizon - 1, random.random()
        if kind < 0.5:
            return f"F[0,{last}] {task()}"
        if kind < 0.6:
            return f"G[{last},{last + (random.random() < 0.3)}] {task(0)}"
        if kind < 0.8:
            return f"F[{last - 1},{last}] ({task()} && {task()})"
        if kind < 0.85:
            return f"({task(0)} || F[0,{last}] {task()})"
        if kind < 0.92:
            return f"((sum(s2) <= 1) U[0,{last}] {task()})"
        return f"(!(sum(s2,u) >= 1) || F[0,{last}] {task()})"

    return " && ".join(part() for _ in range(random.choice([1, 2, 2, 3])))


def _map(
    random: Random, labels: dict[str, set[str]], back: float = 1.0, *, restless: bool = False
) -> TransitionSystem:
    """A chain of states with these labels, and perhaps a shortcut from end to end.

    One can also go back along an edge of it, or perhaps so. If `restless` there are states at which
    nobody can wait.
    """
    names = list(labels)
    edges = {(name, name): 1 for name in names}
    for source, target in pairwise(names):
        edges[source, target] = random.choice([1, 1, 1, 2])
        if back == 1.0 or random.random() < back:
            edges[target, source] = random.choice([1, 1, 1, 2])
    if random.random() < 0.4:
        edges[names[0], names[-1]] = random.choice([1, 2, 3])
    for name in names if restless else ():
        if random.random() < 0.6:
            del edges[name, name]
    return TransitionSystem.build(
        [State(name, frozenset(found)) for name, found in labels.items()],
        [Edge(*ends, duration) for ends, duration in edges.items()],
    )


def _resources(random: Random, names: list[str], most: int, *, parted: bool) -> list[dict]:
    scale = 0.5 if parted else 1
    return [
        {
            "name": name,
            "at": {
                s: scale * random.randint(1, most)
                for s in random.sample(names, random.choice([1, 1, 2]))
            },
            "indivisible": not parted,
            "consumed": random.random() < 0.7,
        }
        for name in (["x"] if parted else random.choice([["x"], ["x", "y"]]))
    ]


def _carries(random: Random, names: list[str], *, parted: bool) -> object:
    kind = random.random()
    if kind < 0.1:
        return None
    if parted:
        return random.choice([0.5, 1.0, {"x": 0.5}, {"x": 1.5}])
    if kind < 0.5:
        return random.choice([1, 2, 1.5])
    return {name: random.choice([1, 1, 2, 1.7]) for name in names if random.random() < 0.8}


def _formula(random: Random, resources: list[dict], dry: str, horizon: int) -> str:
    """Tasks, mostly where nothing lies."""
    names = [item["name"] for item in resources]
    scale = 1 if resources[0]["indivisible"] else 0.5

    def task(longest: int = 1) -> str:
        duration = min(longest, random.choice([0, 0, 1]))
        needs = random.choice(["{(u,1)}", "{(u,1)}", "{(v,1)}", "{}", "{}"])
        chosen = random.sample(names, random.randint(1, len(names)))
        amounts = ",".join(f"({name},{scale * random.choice([1, 1, 1, 2]):g})" for name in chosen)
        label = random.choice(dry if random.random() < 0.7 else "ab")
        return f"T({duration},{label},{needs},{{{amounts}}})"

    def part() -> str:
        last = horizon - 1
        kind = random.random()
        if kind < 0.55:
            return f"F[0,{last}] {task()}"
        if kind < 0.7:
            return f"G[{last},{last + (random.random() < 0.3)}] {task(0)}"
        if kind < 0.8:
            return f"(F[0,{last}] {task()} || F[0,{last}] {task()})"
        if kind < 0.9:
            return f"(T(0,{random.choice('ab')},{{(u,1)}}) U[0,{last}] {task()})"
        return f"(T(0,b,{{(v,2)}}) => F[0,{last}] {task()})"

    return " && ".join(part() for _ in range(random.choice([1, 1, 1, 2])))


# --- brute force -----------------------------------------------------------------------------


@dataclass(frozen=True)
class Done:
    """What became of the resources of one joint plan."""

    executed: frozenset[tuple[str, str, int]]  # task, state, step
    haulage: float
    reserve: float


@dataclass(frozen=True)
class Now:
    """What there is at a step: `coming` is (step, resource, state, pieces, robot)."""

    lying: tuple[tuple[int, ...], ...]  # by resource and state
    coming: frozenset[tuple[int, int, int, int, int]]
    done: Done


class Depot:
    """Everything that can be done with the resources along given paths, in whole units."""

    def __init__(self, mission: Mission, plan: JointPlan, unit: float) -> None:
        self.mission, self.plan, self.unit = mission, plan, unit
        self.states = list(mission.system.states)
        self.tasks = {
            str(node): node
            for node in walk(mission.formula)
            if isinstance(node, Task) and (node.resources or mission.booking != "shared")
        }
        self.carries = [group.carries for group in mission.team for _ in range(group.count)]
        self.staffed = plan.trace().counts

    def outcomes(self) -> set[Done]:
        now = {Now(self.begin(), self.brought(), Done(frozenset(), 0.0, inf))}
        for step in range(self.mission.horizon + 1):
            there = {self.arrived(here, step) for here in now}
            now = {after for here in there for after in self.executions(here, step)}
            if step < self.mission.horizon:
                now = {after for here in now for after in self.departures(here, step)}
        return {here.done for here in now}

    def begin(self) -> tuple[tuple[int, ...], ...]:
        return tuple(
            tuple(round(dict(item.at).get(state, 0) / self.unit) for state in self.states)
            for item in self.mission.resources
        )

    def brought(self) -> frozenset[tuple[int, int, int, int, int]]:
        """What agents bring that start under way."""
        number = {item.name: r for r, item in enumerate(self.mission.resources)}
        return frozenset(
            (
                start.arrives,
                number[name],
                self.states.index(start.target),
                round(amount / self.unit),
                robot,
            )
            for robot, agent in enumerate(self.mission.agents)
            if isinstance(start := agent.start, UnderWay)
            for name, amount in start.carrying
        )

    def needs(self, task: Task, name: str) -> int:
        return round(dict(task.resources).get(name, 0) / self.unit)

    def able(self, task: Task, state: str, step: int) -> bool:
        row, last = self.states.index(state), step + task.duration
        return last <= self.mission.horizon and all(
            name in self.staffed and self.staffed[name][row, step : last + 1].min() >= number
            for name, number in task.needs
        )

    def options(self, step: int) -> list[tuple[str, str]]:
        """Tasks and states that have their robots, were they shared."""
        return [
            (text, state)
            for text, task in self.tasks.items()
            for state in self.mission.system.labels[task.label]
            if self.able(task, state, step)
        ]

    def loads(self, robot: int) -> list[tuple[int, ...]]:
        carries, resources = self.carries[robot], self.mission.resources
        if isinstance(carries, tuple):
            rooms = [int(dict(carries).get(item.name, 0) / self.unit + 1e-9) for item in resources]
            return list(product(*(range(room + 1) for room in rooms)))
        room = int(carries / self.unit + 1e-9)
        every = product(range(room + 1), repeat=len(resources))
        return [load for load in every if sum(load) <= room]

    def executions(self, here: Now, step: int) -> Iterator[Now]:
        options = self.options(step)
        for chosen in product([False, True], repeat=len(options)):
            made = {(*option, step) for option, so in zip(options, chosen, strict=True) if so}
            if not self.served(here.done.executed | made, step):
                continue
            after = self.executed(here, frozenset(made), step)
            if after is not None:
                yield after

    def served(self, executed: frozenset[tuple[str, str, int]], begin: int) -> bool:
        """Whether agents are enough for all that runs from a step on, as they are booked."""
        if self.mission.booking == "shared":
            return True
        for step, state in product(range(begin, self.mission.horizon + 1), self.states):
            running = [
                task
                for text, at, begun in executed
                for task in [self.tasks[text]]
                if at == state and begun <= step <= begun + task.duration
            ]
            pairs = zip(self.mission.agents, self.plan.paths, strict=True)
            here = [agent.capabilities for agent, path in pairs if path.states[step] == state]
            if not (seated if self.mission.booking == "exclusive" else labelled)(running, here):
                return False
        return True

    def executed(self, here: Now, made: frozenset[tuple[str, str, int]], step: int) -> Now | None:
        lying, least = [list(row) for row in here.lying], here.done.reserve
        for r, item in enumerate(self.mission.resources):
            for s, state in enumerate(self.states):
                asked = self.asked(item, state, step, here.done.executed | made)
                left = lying[r][s] - asked
                if left < 0:
                    return None
                if any(self.needs(self.tasks[t], item.name) for t, at, _ in made if at == state):
                    least = min(least, left)
                if item.consumed:
                    lying[r][s] = left
        done = Done(here.done.executed | made, here.done.haulage, least)
        return Now(tuple(map(tuple, lying)), here.coming, done)

    def asked(
        self, item: Resource, state: str, step: int, executed: frozenset[tuple[str, str, int]]
    ) -> int:
        """What is used up at a step, or the tools in use."""
        return sum(
            self.needs(self.tasks[text], item.name)
            for text, at, begun in executed
            if at == state
            and begun <= step <= begun + (0 if item.consumed else self.tasks[text].duration)
        )

    def departures(self, here: Now, step: int) -> Iterator[Now]:
        movers = [
            (number, edge)
            for number, path in enumerate(self.plan.paths)
            for edge in path.entered
            if edge[2] == step and edge[0] != edge[1] and self.carries[number] != ()
        ]
        for chosen in product(*(self.loads(number) for number, _ in movers)):
            lying = [list(row) for row in here.lying]
            coming, haulage = set(here.coming), here.done.haulage
            for (number, (source, target, _, duration)), load in zip(movers, chosen, strict=True):
                at, to = self.states.index(source), self.states.index(target)
                for r, pieces in enumerate(load):
                    lying[r][at] -= pieces
                    haulage += pieces * duration
                    coming |= {(step + duration, r, to, pieces, number)} if pieces else set()
            if min(map(min, lying), default=0) >= 0:
                done = Done(here.done.executed, haulage, here.done.reserve)
                yield Now(tuple(map(tuple, lying)), frozenset(coming), done)

    def arrived(self, here: Now, step: int) -> Now:
        lying = [list(row) for row in here.lying]
        for _, r, s, pieces, _ in (item for item in here.coming if item[0] == step):
            lying[r][s] += pieces
        coming = frozenset(item for item in here.coming if item[0] > step)
        return Now(tuple(map(tuple, lying)), coming, here.done)


def most_options(mission: Mission) -> int:
    """At how many steps and states tasks could be executed in one joint plan, at most."""
    plans = (Depot(mission, plan, 1.0) for plan in joint_plans(mission))
    steps = range(mission.horizon + 1)
    return max(sum(len(depot.options(step)) for step in steps) for depot in plans)


def seated(running: list[Task], agents: list[frozenset[str]]) -> bool:
    """Whether every need gets an agent of its own, by trying."""
    seats = [name for task in running for name, number in task.needs for _ in range(number)]

    def filled(place: int, free: tuple[int, ...]) -> bool:
        return place == len(seats) or any(
            seats[place] in agents[one] and filled(place + 1, tuple(n for n in free if n != one))
            for one in free
        )

    return len(seats) <= len(agents) and filled(0, tuple(range(len(agents))))


def labelled(running: list[Task], agents: list[frozenset[str]]) -> bool:
    """Whether every label can have its largest need of each capability by itself."""
    for name in {name for task in running for name, _ in task.needs}:
        largest = {
            label: max(dict(task.needs).get(name, 0) for task in running if task.label == label)
            for label in {task.label for task in running}
        }
        if sum(largest.values()) > sum(name in able for able in agents):
            return False
    return True


def worth_judging(mission: Mission, outcomes: set[Done]) -> Iterator[Done]:
    """The outcomes; where nothing is moved, only those that execute as much as can be."""
    if mission.resources:
        yield from outcomes
        return
    by_size = sorted(outcomes, key=lambda done: -len(done.executed))
    most: list[frozenset[tuple[str, str, int]]] = []
    for done in by_size:
        if not any(done.executed <= other for other in most):
            most.append(done.executed)
            yield done


def best(mission: Mission, unit: float = 1.0) -> tuple[float, ...] | None:
    """The best objective values, signed to be minimised; None if there is no plan."""
    found = None
    states = list(mission.system.states)
    for plan in joint_plans(mission):
        counts = plan.trace()
        judged: dict[frozenset[tuple[str, str, int]], float] = {}
        for done in worth_judging(mission, Depot(mission, plan, unit).outcomes()):
            if done.executed not in judged:
                tables: dict[str, np.ndarray] = {}
                for text, state, step in done.executed:
                    table = tables.setdefault(
                        text, np.zeros((len(states), mission.horizon + 1), bool)
                    )
                    table[states.index(state), step] = True
                trace = CountTrace(counts.counts, counts.labels, tables)
                judged[done.executed] = float(robustness(mission.counted, trace)[0])
            spare = judged[done.executed]
            if spare < 0:
                continue
            own = {
                "availability": spare,
                "haulage": done.haulage * unit,
                "reserve": done.reserve * unit,
            }
            value = tuple(
                float(SENSE[name] * (own[name] if name in own else plan.worth(name)))
                for name in mission.objective
            )
            found = value if found is None else min(found, value)
    return found
