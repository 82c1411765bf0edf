"""When the robots of a team can be where, at the earliest, one by one and on their own."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from math import inf
from typing import TYPE_CHECKING, NamedTuple

from tsplan.ts.reachability import shortest_durations, usable

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    from tsplan.mission import Group, Mission


class Arrival(NamedTuple):
    """Robots of one entry of the team that can be somewhere from `step` on (inf: never)."""

    step: float
    robots: int
    entry: int
    start: str


@dataclass(frozen=True)
class Arrivals:
    """Earliest arrivals on the map of one mission; what is computed is kept.

    `pause` is called before what takes long, and raises where the work is to end.
    """

    mission: Mission
    pause: Callable[[], None] = lambda: None
    _known: dict[tuple[str, frozenset[str], str], npt.NDArray[np.float64]] = field(
        default_factory=dict
    )

    def within(self, states: tuple[str, ...], capability: str | None) -> list[Arrival]:
        """Everybody with a capability, those first that can be at the nearest state first."""
        return sorted(
            Arrival(min(self.between(group, start, state) for state in states), count, entry, start)
            for entry, group in enumerate(self.mission.team)
            if capability is None or capability in group.capabilities
            for start, count in group.starts
        )

    def durations(self, group: Group, start: str) -> npt.NDArray[np.float64]:
        """Fewest steps from a state to every state, for robots like those of a group."""
        key = (group.class_name, group.capabilities, start)
        if key not in self._known:
            self.pause()
            self._known[key] = shortest_durations(
                self.mission.system,
                [start],
                class_name=group.class_name,
                capabilities=group.capabilities,
            )[0]
        return self._known[key]

    def between(self, group: Group, start: str, target: str) -> float:
        """Fewest steps from one state to another, for robots like those of a group."""
        return float(self.durations(group, start)[self._places[target]])

    def way(self, group: Group, start: str, target: str) -> list[str]:
        """The states of a quickest way; empty where there is none."""
        distance = dict(zip(self._places, self.durations(group, start), strict=True))
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

    @cached_property
    def _places(self) -> Mapping[str, int]:
        return {name: number for number, name in enumerate(self.mission.system.states)}


def latest_of(arrivals: list[Arrival], amount: int) -> float:
    """The step from which `amount` robots can be there; inf if they never can."""
    if amount <= 0:
        return 0.0
    for item in arrivals:
        amount -= item.robots
        if amount <= 0:
            return item.step
    return inf
