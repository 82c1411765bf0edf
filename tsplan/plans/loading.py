"""From what is carried along edges to what every robot carries.

Robots that enter an edge at one step share what is carried along it, each within what it carries.
That is always possible: whole pieces go to robots one after the other until each has as many as it
can carry, and what may be parted fills what room is left.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from math import floor
from typing import TYPE_CHECKING, NamedTuple, TypeAlias

from tsplan.mission.resources import compartment
from tsplan.plans.structures import Structure
from tsplan.plans.supplies import Cargo

if TYPE_CHECKING:
    from tsplan.mission import Mission, Resource
    from tsplan.plans.agent_plans import AgentPlan
    from tsplan.plans.bundles import Agents

Walker: TypeAlias = "AgentPlan | Structure"
"""Who carries something on its way."""

LEAST = 1e-7
"""Less than this is nothing: it is what solvers forgive."""

_DIGITS = 9


class Carried(NamedTuple):
    """An amount of a resource along an edge entered at a step, by robots with or without a hold."""

    source: str
    target: str
    step: int
    duration: int
    held: bool
    resource: Resource
    amount: float


class _Robot:
    """A robot on an edge, and how much room it has left."""

    def __init__(self, name: str, carries: object, earlier: Mapping[str, float]) -> None:
        self.name = name
        self.loaded: dict[str, float] = {}
        self._carries = carries
        self._earlier = earlier

    def room(self, resource: Resource) -> float:
        """How much of a resource can still be loaded."""
        carries, taken = self._carries, self.loaded
        if isinstance(carries, tuple):
            return float(compartment(carries, resource) or 0) - taken.get(resource.name, 0.0)
        room = float(str(carries)) - sum(taken.values())
        return float(floor(room + LEAST)) if resource.indivisible else room

    def has(self, resource: Resource) -> float:
        """How much of it this robot came with."""
        return self._earlier.get(resource.name, 0.0)


def loading(
    mission: Mission,
    agents: Agents,
    structures: Sequence[Structure],
    carried: Iterable[Carried],
) -> tuple[Cargo, ...]:
    """The cargo of every agent, in the order of time: who has some of a resource keeps it."""
    carried = tuple(carried)
    if not carried:
        return ()
    walkers: tuple[Walker, ...] = (*agents, *structures)
    shapes = mission.modular.of
    carries = {
        agent.id: shapes[agent.configuration].carries
        if isinstance(agent, Structure)
        else mission.loads[agent.id]
        for agent in walkers
    }
    entering = _entering(walkers)
    lanes: dict[tuple[int, str, str, int, bool], list[Carried]] = defaultdict(list)
    for item in carried:
        if item.amount > LEAST:
            lanes[item.step, item.source, item.target, item.duration, item.held].append(item)
    latest: dict[str, dict[str, float]] = {}
    found: list[Cargo] = []
    for (step, source, target, duration, held), items in sorted(lanes.items(), key=_order):
        robots = [
            _Robot(name, carries[name], latest.get(name, {}))
            for name in entering[step, source, target, duration]
            if carries[name] != () and isinstance(carries[name], tuple) is not held
        ]
        for item in sorted(items, key=lambda item: not item.resource.indivisible):
            _share(item, robots)
        for robot in robots:
            latest[robot.name] = robot.loaded
            found += [Cargo(robot.name, step, *load) for load in robot.loaded.items()]
    return tuple(found)


def _order(lane: tuple[tuple[int, str, str, int, bool], object]) -> tuple[int, str, str, int, bool]:
    return lane[0]


def _share(item: Carried, robots: Iterable[_Robot]) -> None:
    """Load an amount on robots, on those that came with some of it first."""
    resource, left = item.resource, item.amount
    left = float(round(left)) if resource.indivisible else round(left, _DIGITS)
    for robot in sorted(robots, key=lambda robot: -robot.has(resource)):
        load = round(min(left, robot.room(resource)), _DIGITS)
        if load > LEAST:
            robot.loaded[resource.name] = load
            left = round(left - load, _DIGITS)


def _entering(agents: Iterable[Walker]) -> dict[tuple[int, str, str, int], list[str]]:
    """The agents that enter an edge at a step and take so long; on the way at the end, none."""
    found: dict[tuple[int, str, str, int], list[str]] = defaultdict(list)
    for agent in agents:
        for (_, left, source), (come, _, target) in zip(agent.stays, agent.stays[1:], strict=False):
            found[left, source, target, come - left].append(agent.id)
    return found
