"""The journey of one agent through its plan: where it stays, and where it is going at the end."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import pairwise
from typing import NamedTuple, TypeAlias

from tsplan.plans.agent_plans import Stay
from tsplan.ts.state_places import Point

Places: TypeAlias = Callable[[str], Point | None]
"""The coordinates of a state, by its name, if it has any."""


class Stop(NamedTuple):
    """At a state at every step `first`..`last`.

    `last` is None for a stop that only begins after the plan has ended, and `first` where nobody
    knows when.
    """

    state: str
    first: int | None
    last: int | None


class Leg(NamedTuple):
    """On the way from one state to another, left at step `left`; `arrives` None as in a stop."""

    source: str
    target: str
    left: int
    arrives: int | None


@dataclass(frozen=True, eq=False, slots=True)
class Journey:
    """The way of an agent, and of all others of its class that go the same way.

    An agent that is still travelling at the horizon has the state `heading` before it, where it
    arrives at the step `arrival`, if that is known. One that is on an edge when the plan begins has
    the state `coming` behind it, and nobody knows when it left that.
    """

    class_name: str
    stays: tuple[Stay, ...]
    heading: str | None = None
    arrival: int | None = None
    coming: str | None = None

    @property
    def stops(self) -> tuple[Stop, ...]:
        """Every stay, and at the end the state that the agent is heading for.

        >>> Journey("cart", ((0, 1, "p"),), "q", 4).stops
        (Stop(state='p', first=0, last=1), Stop(state='q', first=4, last=None))
        """
        stops = tuple(Stop(state, first, last) for first, last, state in self.stays)
        return stops if self.heading is None else (*stops, Stop(self.heading, self.arrival, None))

    @property
    def visits(self) -> tuple[Stop, ...]:
        """The stops, those at one state that follow each other as one: what is between is a wait.

        >>> Journey("cart", ((0, 0, "p"), (2, 3, "p")), "q", 7).visits
        (Stop(state='p', first=0, last=3), Stop(state='q', first=7, last=None))
        """
        visits: list[Stop] = []
        for stop in self.stops:
            if visits and visits[-1].state == stop.state:
                over = stop.first if stop.last is None else stop.last
                visits[-1] = visits[-1]._replace(last=over)
            else:
                visits.append(stop)
        return tuple(visits)

    @property
    def legs(self) -> Iterator[Leg]:
        """What lies between the stops, one fewer than these."""
        for here, there in pairwise(self.stops):
            assert here.last is not None, "only the last stop may be open"
            yield Leg(here.state, there.state, here.last, there.first)

    @property
    def states(self) -> frozenset[str]:
        """The states that the agent comes to or is heading for."""
        return frozenset(stop.state for stop in self.stops)

    def state_at(self, step: int) -> str | None:
        """The state at a step; None while the agent is travelling."""
        place = self._stay(step)
        if place < 0:
            return None
        first, last, state = self.stays[place]
        return state if first <= step <= last else None

    def latest(self, step: int) -> str:
        """The state at a step or, of an agent that is travelling, the one that it has left."""
        place = self._stay(step)
        return str(self.coming) if place < 0 else self.stays[place][2]

    def position_at(self, step: int, places: Places) -> Point | None:
        """The coordinates at a step, on an edge on the straight line between both of its ends.

        None where an end has none, or where nobody knows when the edge is at its end.
        """
        place = self._stay(step)
        if place < 0:
            return None
        _, left, state = self.stays[place]
        here = places(state)
        if step <= left or here is None:
            return here
        target, arrives, _ = self.stops[place + 1] if self._goes_on(place) else Stop("", None, None)
        there = None if arrives is None else places(target)
        if arrives is None or there is None:
            return None
        share = (step - left) / (arrives - left)
        return here[0] + share * (there[0] - here[0]), here[1] + share * (there[1] - here[1])

    def _stay(self, step: int) -> int:
        """The number of the last stay that has begun at a step; -1 before the first of them."""
        return bisect_right(self.stays, step, key=lambda stay: stay[0]) - 1

    def _goes_on(self, place: int) -> bool:
        return place + 1 < len(self.stays) or self.heading is not None
