"""One mission as the finders of facts see it: what it asks for, and who can be where when."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from math import inf
from typing import TYPE_CHECKING, NamedTuple

from tsplan.encode.structure_flows import first_steps
from tsplan.explanation.explanation import Fact, PartKind, SoftConstraint
from tsplan.explanation.part_words import TeamWording
from tsplan.explanation.whynot.module_builders import Builder
from tsplan.explanation.whynot.soft_constraints import of_occurrence
from tsplan.explanation.whynot.unconditional_demands import (
    AmountDemand,
    Demand,
    amount_demands,
    demands,
)
from tsplan.mission.resources import most_carried
from tsplan.ts.reachability import first_arrivals, shortest_durations, usable

if TYPE_CHECKING:
    from tsplan.mission import Group, Mission, Resource
    from tsplan.mission.configurations import Pool


class Arrival(NamedTuple):
    """Robots of one entry of the team that can be somewhere from `step` on (inf: never).

    Of modules it is as many structures as there can be at once, and there is no one `start`.
    """

    step: float
    robots: int
    entry: int
    start: str


def able(mission: Mission, capability: str | None) -> Iterator[tuple[int, Group]]:
    """The entries of the team with a capability; all of them for None.

    Modules have those of all that they could become if there were enough of them.
    """
    team, rules = mission.team, mission.modular
    modules = {
        number
        for pool in rules.pools(team, enough=True)
        if rules.able(team[pool.groups[0]], pool, capability)
        for number in pool.groups
    }
    for number, group in enumerate(team):
        robots = group.configuration is None
        if number in modules or (robots and capability in (None, *group.capabilities)):
            yield number, group


def latest_of(arrivals: list[Arrival], amount: int) -> float:
    """The step from which `amount` robots can be there; inf if they never can."""
    if amount <= 0:
        return 0.0
    for item in arrivals:
        amount -= item.robots
        if amount <= 0:
            return item.step
    return inf


@dataclass(frozen=True)
class Context:
    """One mission as the finders see it; what is computed is kept.

    `pause` is called between parts of the work, and raises where that is to end.
    """

    mission: Mission
    pause: Callable[[], None] = lambda: None
    _distances: dict[tuple[str, frozenset[str], str], Mapping[str, float]] = field(
        default_factory=dict
    )
    _first: dict[tuple[str, frozenset[str], str, int], Mapping[str, float]] = field(
        default_factory=dict
    )

    @cached_property
    def wording(self) -> TeamWording:
        """Words and places for the parts of the mission."""
        return TeamWording(self.mission)

    @cached_property
    def all_demands(self) -> tuple[Demand, ...]:
        """What the formula asks for in any case."""
        return demands(self.mission)

    @cached_property
    def needs(self) -> tuple[Demand, ...]:
        """The lower bounds among the demands that ask for somebody."""
        return tuple(item for item in self.all_demands if not item.upper and item.amount > 0)

    @cached_property
    def amounts(self) -> tuple[AmountDemand, ...]:
        """The amounts of resources that the formula asks for in any case."""
        return amount_demands(self.mission)

    @cached_property
    def limits(self) -> tuple[Demand, ...]:
        """The upper bounds among the demands."""
        return tuple(item for item in self.all_demands if item.upper)

    def distances(self, group: Group, start: str) -> Mapping[str, float]:
        """Fewest steps from a state to every state, for robots like those of a group."""
        key = (group.class_name, group.capabilities, start)
        if key not in self._distances:
            self.pause()
            (row,) = shortest_durations(
                self.mission.system,
                [start],
                class_name=group.class_name,
                capabilities=group.capabilities,
            ).tolist()
            self._distances[key] = dict(zip(self.mission.system.states, row, strict=True))
        return self._distances[key]

    def first_steps(self, group: Group, start: str, step: int) -> Mapping[str, float]:
        """When robots like those of a group can be where, that are at a state at a step.

        Where places are closed for a time that is told for some time after the horizon.
        """
        if not self.mission.system.timed:
            return {state: step + far for state, far in self.distances(group, start).items()}
        key = (group.class_name, group.capabilities, start, step)
        if key not in self._first:
            self.pause()
            far = (steps for steps in self.distances(group, start).values() if steps < inf)
            last = 2 * self.mission.horizon + int(max(far))
            self._first[key] = first_arrivals(
                self.mission.system,
                (start, step, max(last, step)),
                group.class_name,
                group.capabilities,
            )
        return self._first[key]

    def way(self, group: Group, start: str, target: str) -> list[str]:
        """The states of a quickest way; empty where there is none."""
        distance = self.distances(group, start)
        if distance[target] == inf:
            return []
        into: dict[str, list[tuple[str, int]]] = {}
        for edge, duration in usable(self.mission.system, group.class_name, group.capabilities):
            if not edge.is_wait:
                into.setdefault(edge.target, []).append((edge.source, duration))
        states = [target]
        while states[-1] != start:
            before = into[states[-1]]
            here = distance[states[-1]]
            states.append(next(s for s, duration in before if distance[s] + duration == here))
        return states[::-1]

    def arrivals(self, states: tuple[str, ...], capability: str | None) -> list[Arrival]:
        """Everybody with a capability, those first that can be at the nearest state first."""
        robots = (
            Arrival(
                min(self.first_steps(group, start, step)[s] for s in states), count, entry, start
            )
            for entry, group in able(self.mission, capability)
            if group.configuration is None
            for start, step, count in group.begins
        )
        structures = (
            Arrival(item.first(states), item.most, item.pool.groups[0], "")
            for item in self.builders(capability)
        )
        return sorted([*robots, *structures])

    def builders(self, capability: str | None) -> list[Builder]:
        """The modules that can be structures with a capability, as far as there are enough."""
        found = (Builder.of(self.mission, *each, capability) for each in self._first_steps)
        return [item for item in found if item.shapes]

    @cached_property
    def _first_steps(self) -> list[tuple[Pool, Mapping[str, Mapping[str, int]]]]:
        """All modules, and when their structures can be where."""
        pools = self.mission.modular.pools(self.mission.team)
        return [(pool, first_steps(self.mission, pool)) for pool in pools]

    def places(self, need: Demand) -> list[tuple[str, list[Arrival]]]:
        """The states at which a need must be met, or one for all of them, and who comes there."""
        together = need.reach == "together"
        sites = [need.states] if together else [(state,) for state in need.states]
        return [(site[0], self.arrivals(site, need.capability)) for site in sites]

    def ready(self, need: Demand) -> float:
        """The earliest step at which a need can begin to be met, by travel times alone."""
        steps = [latest_of(arrivals, need.amount) for _, arrivals in self.places(need)]
        return min(steps) if need.reach == "one" else max(steps)

    def fact(
        self,
        kind: str,
        text: str,
        demands: Iterable[Demand | AmountDemand],
        *others: SoftConstraint,
    ) -> Fact:
        """A fact about demands or other constraints; it stands where the first of them does."""
        parts = list(dict.fromkeys(demand.occurrence for demand in demands))
        said = self.wording.parts({*map(of_occurrence, parts), *others})
        place = self.wording.sources.place(parts[0]) if parts else said[0].place
        return Fact(kind, text, place, said)

    def team(self, capability: str | None, *kinds: PartKind) -> list[SoftConstraint]:
        """The constraints of the team's entries with a capability."""
        entries = able(self.mission, capability)
        return [item for number, _ in entries for item in self.entry(number, *kinds)]

    def entry(self, number: int, *kinds: PartKind) -> list[SoftConstraint]:
        """The constraints of one entry of the team, its size and its start; swarms have none."""
        robots = self.mission.group_bounds(self.mission.team[number].class_name) is None
        return [SoftConstraint(kind, (number,)) for kind in kinds or ("team", "start") if robots]

    def carriers(self, resource: Resource) -> list[tuple[int, Group]]:
        """The entries of the team whose robots, or structures, carry some of a resource."""
        mission, found = self.mission, []
        pools = mission.modular.pools(mission.team, enough=True)
        shapes = {number: pool.shapes for pool in pools for number in pool.groups}
        for number, group in enumerate(mission.team):
            who = shapes.get(number, (group,))
            if any(most_carried(each.carries, resource) for each in who):
                found.append((number, group))
        return found

    def carrying(self, resource: Resource) -> list[SoftConstraint]:
        """The constraints of a resource, of all who carry it, and that others carry none."""
        able = {number for number, _ in self.carriers(resource)}
        own = [
            item
            for number, group in enumerate(self.mission.team)
            if group.carries or number in able
            for item in self.entry(
                number,
                *(("carries",) if group.carries else ()),
                *(("team", "start") if number in able else ()),
            )
        ]
        return [SoftConstraint("stock", (resource.name,)), *own]

    def having(self, capability: str | None) -> str:
        """How many the team has with a capability, and in which classes."""
        counts: Counter[str] = Counter()
        for _, group in able(self.mission, capability):
            if group.configuration is None:
                counts[group.class_name] += group.count
        inside = [f"{count} {name}" for name, count in counts.items()]
        inside += [item.words for item in self.builders(capability)]
        total = self.mission.having(capability)
        return f"{total} ({', '.join(inside)})" if inside else "none"
