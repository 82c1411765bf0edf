"""All joint plans of a tiny mission, enumerated one by one, and the best of them.

Nothing here knows the encoding: agents walk over the map as its edges say, sub-swarms are what is
together at a state or on an edge since the same step, and formulas are judged by their robustness.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import combinations_with_replacement, product
from math import comb, prod

import numpy as np

from tsplan import Mission
from tsplan.logic.evaluation import CountTrace, robustness
from tsplan.mission import Agent, UnderWay
from tsplan.ts import Edge

MOST_JOINT_PLANS = 3000
SENSE = {
    "availability": -1,
    "delay": -1,
    "travel": 1,
    "cost": 1,
    "makespan": 1,
    "agents": 1,
    "splits": 1,
    "moves": 1,
    "balance": -1,
}


@dataclass(frozen=True)
class Path:
    """One agent's way: its state at each step (None on the way), and what it costs."""

    states: tuple[str | None, ...]
    entered: tuple[tuple[str, str, int, int], ...]  # edge, step, duration
    travel: int
    cost: float
    makespan: int
    begun: tuple[tuple[str, str, int, int], ...] = ()  # an edge that it is on from before step 0

    @property
    def ways(self) -> tuple[tuple[str, str, int, int], ...]:
        return (*self.begun, *self.entered)


@dataclass(frozen=True)
class Groups:
    """What the paths of one swarm come to."""

    sizes: tuple[tuple[int, ...], ...]  # of the sub-swarms at each step
    splits: int
    moves: int


@dataclass(frozen=True)
class JointPlan:
    """A path for every agent, in the order of the team, and the sub-swarms of every swarm."""

    mission: Mission
    paths: tuple[Path, ...]
    swarms: dict[str, Groups]

    def trace(self, delay: int | None = None) -> CountTrace:
        delay = self.mission.delay if delay is None else delay
        return trace(self.mission, self.paths, delay)

    def worth(self, name: str) -> float:
        """The value of one objective, but for those that a formula has to be judged for."""
        groups = self.swarms.values()
        return {
            "travel": lambda: sum(path.travel for path in self.paths),
            "cost": lambda: sum(path.cost for path in self.paths),
            "makespan": lambda: max(path.makespan for path in self.paths),
            "agents": lambda: sum(path.travel > 0 or path.begun != () for path in self.paths),
            "splits": lambda: sum(item.splits for item in groups),
            "moves": lambda: sum(item.moves for item in groups),
            "balance": lambda: min(min(sizes) for item in groups for sizes in item.sizes),
        }[name]()


def paths(mission: Mission, agent: Agent) -> list[Path]:
    """Every way of one agent up to the horizon."""
    system = mission.system
    found = []

    def go(state: str, step: int, moves: tuple[tuple[str, str, int, int], ...]) -> None:
        if step >= mission.horizon:
            found.append(moves)
            return
        for edge in system.leaving(state):
            duration = edge.duration_for(agent.class_name)
            needs = edge.needs | system.states[edge.target].needs | system.states[state].needs
            if duration is None or not needs <= agent.capabilities:
                continue
            if open_for(mission, edge, step, duration):
                entered = (edge.source, edge.target, step, duration)
                go(edge.target, step + duration, (*moves, entered))

    go(*began(agent), ())
    return [walked(mission, agent, moves) for moves in found]


def open_for(mission: Mission, edge: Edge, step: int, duration: int) -> bool:
    """Whether an edge is open while somebody is on it, and where it ends when they come there."""
    shut = {k for first, last in edge.closed for k in range(first, last + 1)}
    there = {
        k
        for first, last in mission.system.states[edge.target].closed
        for k in range(first, last + 1)
    }
    return shut.isdisjoint(range(step, step + duration)) and step + duration not in there


def began(agent: Agent) -> tuple[str, int]:
    """Where an agent is first, and when."""
    if isinstance(agent.start, UnderWay):
        return agent.start.target, agent.start.arrives
    return agent.start, 0


def walked(mission: Mission, agent: Agent, moves: tuple[tuple[str, str, int, int], ...]) -> Path:
    states: list[str | None] = [None] * (mission.horizon + 1)
    state, first = began(agent)
    if first <= mission.horizon:
        states[first] = state
    travel, cost, makespan, begun = 0, 0.0, 0, ()
    if isinstance(agent.start, UnderWay):
        begun = ((agent.start.origin, state, -1, first + 1),)
        makespan = first if agent.start.origin != state else 0
    for source, target, step, duration in moves:
        if step + duration <= mission.horizon:
            states[step + duration] = target
        edge = mission.system.edges[source, target]
        cost += edge.cost_for(agent.class_name)
        if source != target:
            travel += duration
            makespan = max(makespan, step + duration)
    return Path(tuple(states), moves, travel, cost, makespan, begun)


def within_capacity(mission: Mission, joint: tuple[Path, ...]) -> bool:
    for name, state in mission.system.states.items():
        if state.capacity is not None:
            for step in range(mission.horizon + 1):
                if sum(path.states[step] == name for path in joint) > state.capacity:
                    return False
    for capacity, pairs in mission.system.capacity_groups:
        load: Counter[int] = Counter()
        for path in joint:
            for source, target, step, duration in path.ways:
                if (source, target) in pairs:
                    load.update(range(step, min(step + duration, mission.horizon)))
        if any(count > capacity for count in load.values()):
            return False
    return all(
        sum(in_zone(mission, path, zone, step) for path in joint) <= capacity
        for zone, capacity in mission.system.zones.items()
        for step in range(mission.horizon + 1)
    )


def in_zone(mission: Mission, path: Path, zone: str, step: int) -> bool:
    """Whether an agent is at a state of a zone, or has left for an edge of it and not arrived."""
    system, here = mission.system, path.states[step]
    inside = here is not None and system.states[here].zone == zone
    return inside or any(
        (source, target) in system.edges
        and system.edges[source, target].zone == zone
        and begun <= step < begun + duration
        for source, target, begun, duration in path.ways
    )


class Counts:
    """Who is where for certain, and who may be, by capability, state and step."""

    def __init__(self, mission: Mission) -> None:
        self.mission = mission
        self.names = list(mission.system.states)
        self.steps = mission.horizon + 1
        able = {name for agent in mission.agents for name in agent.capabilities}
        shape = len(self.names), self.steps
        self.sure, self.most = ({n: np.zeros(shape) for n in (None, *able)} for _ in range(2))

    def add(self, agent: Agent, state: str | None, step: int, sure: int = 1, most: int = 1) -> None:
        if state is None or step >= self.steps:
            return
        for name in (None, *agent.capabilities):
            self.sure[name][self.names.index(state), step] += sure
            self.most[name][self.names.index(state), step] += most

    def add_robot(self, agent: Agent, path: Path, delay: int) -> None:
        """By its own places in every window."""
        for step in range(self.steps):
            window = set(path.states[max(0, step - delay) : step + 1])
            for state in window:
                self.add(agent, state, step, sure=len(window) == 1)

    def add_swarm(self, agent: Agent, joint: tuple[Path, ...], delay: int) -> None:
        """By the moves of all: who came last leaves first, and nobody is taken to come back."""
        waits: Counter[tuple[str, int]] = Counter()
        for path in joint:
            for step, state in enumerate(path.states):
                self.add(agent, state, step, sure=step == 0 or not delay)
            for source, target, step, duration in path.entered:
                if source == target and duration == 1:
                    waits[source, step] += 1
                    continue
                for ago in range(1, delay + 1):
                    self.add(agent, source, step + ago, sure=0)
        for state, step in product(self.names, range(1, self.steps if delay else 0)):
            stood = [waits[state, before] for before in range(max(0, step - delay), step)]
            self.add(agent, state, step, sure=min(stood), most=0)


def trace(mission: Mission, joint: tuple[Path, ...], delay: int = 0) -> CountTrace:
    """Who is where; of agents that may be late, who is there for certain and who may be."""
    found = Counts(mission)
    for agent, path in zip(mission.agents, joint, strict=True):
        if mission.group_bounds(agent.class_name) is None:
            found.add_robot(agent, path, delay)
    for name in () if mission.swarm is None else mission.swarm.each:
        (agent, *_) = mission.members({name})
        found.add_swarm(agent, _of_class(mission, joint, name), delay)
    names = found.names
    labels = {
        label: np.array([names.index(name) for name in carriers])
        for label, carriers in mission.system.labels.items()
    }
    return CountTrace(found.sure, labels, most=found.most if delay else {})


def groups(mission: Mission, joint: tuple[Path, ...]) -> Groups:
    """Sub-swarms at each step, by definition: at one state, or on one edge since the same step."""
    sizes = []
    for step in range(mission.horizon + 1):
        there: Counter[object] = Counter()
        for path in joint:
            state = path.states[step]
            inside = [e for e in path.ways if e[2] < step < e[2] + e[3]]
            there[state if state is not None else inside[0]] += 1
        sizes.append(tuple(there.values()))
    entered = {edge for path in joint for edge in path.entered}
    left = {(source, step) for source, _, step, _ in entered}
    moves = sum(source != target for source, target, _, _ in entered)
    return Groups(tuple(sizes), len(entered) - len(left), moves)


def within_bounds(mission: Mission, swarms: dict[str, Groups]) -> bool:
    rules = mission.swarm
    if rules is None:
        return True
    for name, found in swarms.items():
        bounds = rules.each[name]
        for sizes in found.sizes:
            if bounds.most is not None and len(sizes) > bounds.most:
                return False
            if min(sizes) < bounds.least:
                return False
    if rules.together is None:
        return True
    steps = zip(*(found.sizes for found in swarms.values()), strict=True)
    return all(sum(map(len, sizes)) <= rules.together for sizes in steps)


def alike(mission: Mission) -> list[list[int]]:
    """The numbers of agents that can be exchanged for one another."""
    found: dict[tuple[str, str, frozenset[str]], list[int]] = {}
    for number, agent in enumerate(mission.agents):
        key = agent.class_name, agent.start, agent.capabilities
        found.setdefault(key, []).append(number)
    return list(found.values())


def how_many(mission: Mission) -> int:
    """How many joint plans there are, agents that are alike not told apart."""
    counts = []
    for numbers in alike(mission):
        ways = len(paths(mission, mission.agents[numbers[0]]))
        counts.append(comb(ways + len(numbers) - 1, len(numbers)))
    return prod(counts)


def small_enough(mission: Mission) -> bool:
    return how_many(mission) <= MOST_JOINT_PLANS


def joint_plans(mission: Mission) -> Iterator[JointPlan]:
    """Every joint plan that keeps bounds and capacities, whatever becomes of the formula."""
    kinds = alike(mission)
    ways = [
        combinations_with_replacement(paths(mission, mission.agents[numbers[0]]), len(numbers))
        for numbers in kinds
    ]
    swarms = [] if mission.swarm is None else list(mission.swarm.each)
    for choice in product(*ways):
        chosen = {
            number: path
            for numbers, part in zip(kinds, choice, strict=True)
            for number, path in zip(numbers, part, strict=True)
        }
        joint = tuple(chosen[number] for number in range(mission.size))
        of = {name: groups(mission, _of_class(mission, joint, name)) for name in swarms}
        if within_bounds(mission, of) and within_capacity(mission, joint):
            yield JointPlan(mission, joint, of)


def _of_class(mission: Mission, joint: tuple[Path, ...], name: str) -> tuple[Path, ...]:
    pairs = zip(joint, mission.agents, strict=True)
    return tuple(path for path, agent in pairs if agent.class_name == name)


def best(mission: Mission) -> tuple[float, ...] | None:
    """The best objective values, signed to be minimised; None if there is no plan."""
    found = None
    longest = mission.horizon if "delay" in mission.objective else mission.delay
    for plan, delay in product(joint_plans(mission), range(mission.delay, longest + 1)):
        own = {"delay": delay}
        if "availability" in mission.objective:
            own["availability"] = float(robustness(mission.counted, plan.trace(delay))[0])
        value = tuple(
            float(SENSE[name] * (own[name] if name in own else plan.worth(name)))
            for name in mission.objective
        )
        if (found is None or value < found) and holds(mission, plan, delay):
            found = value
    return found


def holds(mission: Mission, plan: JointPlan, delay: int | None = None) -> bool:
    """Whether the formula holds, as it was written and with its margin."""
    counts = plan.trace(delay)
    if float(robustness(mission.counted, counts)[0]) < 0:
        return False
    return mission.swarm is None or float(robustness(mission.goal, counts)[0]) >= 0
