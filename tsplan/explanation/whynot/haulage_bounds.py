"""How much of a resource can be at a state by a step, at most.

Whatever comes to a state comes with a robot that enters it with a load. A robot enters it for the
first time no sooner than it and some of the resource can be at a state before it, and again no
sooner than it can leave and come back. So there are only so many loads, and each is at most what a
robot carries. Robots may hand things over on the way: that does not make more loads.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from math import inf
from typing import TYPE_CHECKING, NamedTuple

from tsplan.exact import exact
from tsplan.mission.resources import most_carried
from tsplan.ts.reachability import usable

if TYPE_CHECKING:
    from tsplan.explanation.whynot.context import Context
    from tsplan.mission import Group, Resource
    from tsplan.ts import Edge


class Bringing(NamedTuple):
    """Robots of a class that can come with so many loads each, of so much at most."""

    class_name: str
    robots: int
    loads: int
    room: Fraction

    @property
    def amount(self) -> Fraction:
        """What they bring at most."""
        return self.robots * self.loads * self.room


class Most(NamedTuple):
    """What can be at a state at most: what lies there, and what is brought or lies elsewhere.

    Where structures carry some, `brought` is None: nothing bounds that but what lies elsewhere.
    """

    lying: Fraction
    elsewhere: Fraction
    brought: tuple[Bringing, ...] | None

    @property
    def amount(self) -> Fraction:
        """How much that is."""
        if self.brought is None:
            return self.lying + self.elsewhere
        carried = sum((item.amount for item in self.brought), Fraction(0))
        return self.lying + min(self.elsewhere, carried)


@dataclass(frozen=True)
class HaulageBounds:
    """What can be carried of one resource, by when robots can be where."""

    context: Context
    resource: Resource

    def most(self, state: str, step: int) -> Most:
        """How much of the resource can be at a state by a step, at most."""
        lying = sum(
            (exact(n) for at, first, n in self.resource.sources if at == state and first <= step),
            Fraction(0),
        )
        carriers = self.context.carriers(self.resource)
        if any(group.configuration is not None for _, group in carriers):
            return Most(lying, self.resource.total - lying, None)
        brought = (
            Bringing(
                group.class_name,
                count,
                self._loads(group, start, state, step - first),
                most_carried(group.carries, self.resource),
            )
            for _, group in carriers
            for start, first, count in group.begins
            if count and first <= step
        )
        able = tuple(item for item in brought if item.loads)
        return Most(lying, self.resource.total - lying, able)

    def _loads(self, group: Group, start: str, state: str, step: int) -> int:
        """How often a robot can enter a state with a load by a step."""
        ways = [
            (edge.source, duration) for edge, duration in self._moves(group) if edge.target == state
        ]
        distance = self.context.distances(group, start)
        first = min((max(self._since[u], distance[u]) + d for u, d in ways), default=inf)
        if first > step:
            return 0
        back = self.context.distances(group, state)
        again = min((back[u] + d for u, d in ways), default=inf)
        return 1 + (0 if again == inf else int((step - first) // again))

    def _moves(self, group: Group) -> Iterator[tuple[Edge, int]]:
        every = usable(self.context.mission.system, group.class_name, group.capabilities)
        return ((edge, duration) for edge, duration in every if not edge.is_wait)

    @cached_property
    def _since(self) -> dict[str, float]:
        """The first step at which some of the resource can be at each state."""
        found = dict.fromkeys(self.context.mission.system.states, inf)
        for state, step, amount in self.resource.sources:
            found[state] = min(found[state], step) if amount else found[state]
        able = []
        for _, group in self.context.carriers(self.resource):
            rows = [(self.context.distances(group, s), k) for s, k, n in group.begins if n]
            here = {state: min((row[state] + k for row, k in rows), default=inf) for state in found}
            able += [(edge, duration, here[edge.source]) for edge, duration in self._moves(group)]
        settled = False
        while not settled:
            self.context.pause()
            settled = True
            for edge, duration, robot in able:
                come = max(found[edge.source], robot) + duration
                if come < found[edge.target]:
                    found[edge.target] = come
                    settled = False
        return found
