"""From what is carried along edges to what every robot carries.

Robots that enter an edge at one step share what is carried along it, each within what it carries.
That is always possible: whole pieces go to robots one after the other until each has as many as it
can carry, and what may be parted fills what room is left.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from math import floor
from typing import TYPE_CHECKING, NamedTuple, TypeAlias

from tsplan.mission.resources import compartment
from tsplan.name_runs import Run, RunMap
from tsplan.plans.cargo_rows import CargoRow, CargoRows
from tsplan.plans.structures import Structure

if TYPE_CHECKING:
    from tsplan.mission import Mission, Resource
    from tsplan.mission.resources import Carries
    from tsplan.plans.bundles import Agents, Bundle
    from tsplan.plans.supplies import Loads

Walker: TypeAlias = "Bundle | Structure"
"""Who carries something on the way: agents on one path, or a structure."""

LEAST = 1e-7
"""Less than this is nothing: it is what solvers forgive."""

_PARTS = 10**9  # of a unit, in which amounts are told


class Carried(NamedTuple):
    """An amount of a resource along an edge entered at a step, by robots with or without a hold."""

    source: str
    target: str
    step: int
    duration: int
    held: bool
    resource: Resource
    amount: float


_Lane: TypeAlias = tuple[int, str, str, int]
"""A step and the edge that is entered then: from where, to where, how long it takes."""


@dataclass(frozen=True)
class _Robots:
    """Robots on an edge that can carry the same each, came with the same and are loaded alike."""

    names: Run
    carries: Carries
    earlier: Loads
    loaded: Loads = field(default_factory=dict)

    def room(self, resource: Resource) -> float:
        """How much of a resource each can still be loaded with."""
        carries, taken = self.carries, self.loaded
        if isinstance(carries, tuple):
            return float(compartment(carries, resource) or 0) - taken.get(resource.name, 0.0)
        room = float(str(carries)) - sum(taken.values())
        return float(floor(room + LEAST)) if resource.indivisible else room

    def has(self, resource: Resource) -> float:
        """How much of it each came with."""
        return self.earlier.get(resource.name, 0.0)

    def filled(self, resource: Resource, parts: int) -> tuple[list[_Robots], int]:
        """They when so much is loaded on one after the other, and how much is left then."""
        room = round(self.room(resource) * _PARTS)
        if room < 1 or parts < 1:
            return [self], parts
        full = min(parts // room, self.names.size)
        left = parts - full * room
        counts = [(full, room), (int(full < self.names.size), left)]
        counts.append((self.names.size - sum(count for count, _ in counts), 0))
        found, begin = [], 0
        for count, each in counts:
            names, amount = self.names.part(begin, begin + count), each / _PARTS
            begin += count
            own = {resource.name: amount} if amount > LEAST else {}
            if count:
                found.append(replace(self, names=names, loaded={**self.loaded, **own}))
        return found, left if full == self.names.size else 0


def loading(
    mission: Mission,
    agents: Agents,
    structures: Sequence[Structure],
    carried: Iterable[Carried],
) -> CargoRows:
    """The cargo of every agent, in the order of time: who has some of a resource keeps it."""
    lanes: dict[tuple[_Lane, bool], list[Carried]] = defaultdict(list)
    for item in carried:
        if item.amount > LEAST:
            lane = item.step, item.source, item.target, item.duration
            lanes[lane, item.held].append(item)
    entering = _entering(agents, structures, {lane for lane, _ in lanes})
    latest: RunMap[Loads] = RunMap()
    found: list[CargoRow] = []
    for (lane, held), items in sorted(lanes.items(), key=lambda entry: entry[0][0]):
        robots = [
            _Robots(part, carries, earlier or {})
            for names, who in entering[lane]
            for row, carries in _able(mission, names, who)
            if carries != () and isinstance(carries, tuple) is not held
            for part, earlier in latest.parts(row)
        ]
        for item in sorted(items, key=lambda item: not item.resource.indivisible):
            robots = _shared(item, robots)
        for each in robots:
            latest.give(each.names, each.loaded)
        loads = (each for each in robots if each.loaded)
        found += [
            CargoRow(each.names, lane[0], *load) for each in loads for load in each.loaded.items()
        ]
    return CargoRows.joined(found)


def _able(mission: Mission, names: Run, who: Walker) -> Iterator[tuple[Run, Carries]]:
    """What robots can carry each, as many in a row as can carry the same."""
    if isinstance(who, Structure):
        yield names, mission.modular.of[who.configuration].carries
        return
    for part, rank in mission.roster.parts(names):
        yield part, () if rank is None else mission.team[rank.group].carries


def _shared(item: Carried, robots: Sequence[_Robots]) -> list[_Robots]:
    """Robots once an amount is loaded on them, on those that came with some of it first."""
    resource = item.resource
    amount = float(round(item.amount)) if resource.indivisible else item.amount
    left = round(amount * _PARTS)
    found: dict[int, list[_Robots]] = {}
    for place in sorted(range(len(robots)), key=lambda place: -robots[place].has(resource)):
        found[place], left = robots[place].filled(resource, left)
    return [each for place in range(len(robots)) for each in found[place]]


def _entering(
    agents: Agents, structures: Iterable[Structure], lanes: set[_Lane]
) -> Mapping[_Lane, Sequence[tuple[Run, Walker]]]:
    """Who enters which of some lanes, in the order of the plan; on the way at the end, none."""
    taken = {id(path): [lane for lane in _ways(path) if lane in lanes] for path in agents.bundles}
    found: dict[_Lane, list[tuple[Run, Walker]]] = defaultdict(list)
    for names, path in agents.stretches:
        for lane in taken[id(path)]:
            found[lane].append((names, path))
    for each in structures:
        for lane in _ways(each):
            if lane in lanes:
                found[lane].append((Run.of(each.id), each))
    return found


def _ways(who: Walker) -> Iterator[_Lane]:
    """The edges that somebody enters and has left by the horizon."""
    for (_, left, source), (come, _, target) in zip(who.stays, who.stays[1:], strict=False):
        yield left, source, target, come - left
