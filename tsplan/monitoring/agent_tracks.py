"""Where single agents are, and where they are taken to go from there.

An agent that is where its plan wants it goes on as planned. One that is late goes on as soon as it
can: it leaves each state at the step that the plan says, or at once where that has gone by, so that
it catches up where it would have waited. One that has strayed from its path stays where it is until
it comes back to the rest of its path, and one that is lost is nowhere from then on.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum
from typing import NamedTuple, TypeAlias

from tsplan.plans.agent_plans import Stay

Position: TypeAlias = "str | tuple[str, str] | None"
"""A state, an edge by its two ends, or None for an agent that is lost."""


class OnItsWay(Enum):
    """Somewhere between two states, on the edge that the agent's path has next."""

    ON_ITS_WAY = "on its way"


ON_ITS_WAY = OnItsWay.ON_ITS_WAY


class Future(NamedTuple):
    """Where an agent is taken to stay from some step on: at `stays`, then as its path says.

    The first of them is at the place `begin` of its path, and its path goes on from `upto` on.
    """

    stays: tuple[Stay, ...]
    begin: int
    upto: int


@dataclass(frozen=True, slots=True)
class Route:
    """The path of an agent in a plan up to a horizon; it may come from a state before step 0.

    A structure that is made of others comes from the state where it is made.
    """

    stays: tuple[Stay, ...]
    heading: str | None
    horizon: int
    coming: str | None = None

    @property
    def beginning(self) -> Track:
        """Where the agent is before its first stay."""
        return Track(self, -1, self.stays[0][0] if self.stays else self.horizon + 1)

    @property
    def end(self) -> Track:
        """Where the agent is when it has left its last stay, for good."""
        return Track(self, len(self.stays) - 1, self.horizon + 1)

    def edge(self, place: int) -> tuple[str, str] | None:
        """The edge after a stay, at place -1 that before the first; None at the end of the path."""
        if place < 0:
            target = self.stays[0][2] if self.stays else self.heading
            return None if self.coming is None or target is None else (self.coming, target)
        state = self.stays[place][2]
        if place + 1 < len(self.stays):
            return state, self.stays[place + 1][2]
        return None if self.heading is None else (state, self.heading)

    def duration(self, place: int) -> int:
        """The steps of the edge after a stay; of one that is not left in time, more than any."""
        if place + 1 < len(self.stays):
            return self.stays[place + 1][0] - self.stays[place][1]
        return self.horizon + 1

    def onwards(self, place: int, step: int, ends: int | None = None) -> Future:
        """The future of an agent that comes to a stay of its path at a step, or is there then.

        It is told until it has caught up with the path. Where that leads no farther the agent stays
        to the end, or until something is made of it at the step `ends`.
        """
        stays, begin, over = [], place, len(self.stays)
        ends = self.horizon if ends is None else ends
        planned = self.heading is not None or not over or ends == self.stays[-1][1]
        while step <= self.horizon and place < over:
            _, last, state = self.stays[place]
            leaves = max(ends if self.edge(place) is None else last, step)
            stays.append((step, min(leaves, self.horizon), state))
            step, place = leaves + self.duration(place), place + 1
            if leaves == last and planned:
                return Future(tuple(stays), begin, place)
        return Future(tuple(stays), begin, over)

    def ahead(self, future: Future, now: int, upto: int) -> set[Stay]:
        """The stays of a future from now on, up to a place of the path."""
        first = bisect_left(self.stays, now, key=lambda stay: stay[1])
        planned = self.stays[max(future.upto, first) : upto]
        return {
            (max(begin, now), last, state)
            for begin, last, state in (*future.stays, *planned)
            if last >= now
        }


@dataclass(frozen=True, slots=True)
class Track:
    """Where one agent is that is not simply following its path.

    `place` is the stay of its path that it is at, or has left last. It comes to the next one at the
    step `arrives`, where it is on the edge to there. What has `strayed` is at a state or an edge
    that the rest of its path does not lead through.
    """

    route: Route
    place: int
    arrives: int | None = None
    strayed: Position | OnItsWay = None
    lost: bool = False

    def future(self, now: int, ends: int | None = None) -> Future:
        """Where the agent is taken to stay from now on; something is made of it at step `ends`."""
        over = len(self.route.stays)
        if self.lost:
            return Future((), over, over)
        if self.strayed is not None:
            there = self.strayed
            stays = ((now, self.route.horizon, there),) if isinstance(there, str) else ()
            return Future(stays, over, over)
        if self.arrives is None:
            return self.route.onwards(self.place, now, ends)
        return self.route.onwards(self.place + 1, self.arrives, ends)

    def arrival(self, future: Future) -> int | None:
        """When the agent comes to the end of its path, by its future; None if it does not."""
        if self.lost or self.strayed is not None or self.route.heading is not None:
            return None
        if future.upto < len(self.route.stays):
            return self.route.stays[-1][0]
        complete = future.begin + len(future.stays) == len(self.route.stays)
        return future.stays[-1][0] if future.stays and complete else None


PLANNED = Future((), 0, 0)
"""The future of an agent that follows its path."""


def rolled(track: Track, future: Future, step: int) -> Track:
    """The track of an agent at a later step, where it has stayed as it was taken to."""
    if track.lost or track.strayed is not None:
        return track
    stays = future.stays if future.upto else track.route.stays
    number = bisect_right(stays, step, key=lambda stay: stay[0]) - 1
    if number < 0:
        return track
    place, last = future.begin + number, stays[number][1]
    return Track(track.route, place, last + track.route.duration(place) if step > last else None)


def seen(track: Track, position: Position | OnItsWay, now: int) -> Track:
    """The track of an agent that was tracked a step ago and is seen at a position now."""
    route, place = track.route, track.place
    if position is None:
        return Track(route, place, lost=True)
    if isinstance(position, str):
        begin = place if track.arrives is None else place + 1
        found = _first(range(begin, len(route.stays)), route, position)
        if found is None and place >= 0 and route.stays[place][2] == position:
            found = place  # has turned back
        return Track(route, place, strayed=position) if found is None else Track(route, found)
    on_way = isinstance(position, OnItsWay)
    edge = route.edge(place) if on_way else position
    places = range(place, len(route.stays))
    ahead = next((number for number in places if edge and route.edge(number) == edge), None)
    if ahead is None or (on_way and track.strayed is not None):
        return Track(route, place, strayed=position)
    arrives = track.arrives if ahead == place else None
    if arrives is None:  # it left no sooner than the last step
        arrives = now - 1 + route.duration(ahead)
    return Track(route, ahead, max(arrives, now + 1))


def _first(places: Sequence[int], route: Route, state: str) -> int | None:
    return next((number for number in places if route.stays[number][2] == state), None)
