"""Bounds that know of agents who have to be together: a tree over the windows of errands.

Each route runs an errand somewhere in its window, some early and some late. In a plan all who run
it are there at one step: in the early half of the window, or in the late one. Each half has a bound
of its own, and the lesser of the two is one of all plans. So the window is halved whose halves
seem to cost most, and always where the bound is least.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from heapq import heappop, heappush
from typing import NamedTuple

import numpy as np

from tsplan.milp.model import Floats
from tsplan.search.routes.cheapest_routes import Route
from tsplan.search.routes.errands import Errand
from tsplan.search.routes.route_program import Routed, RouteProgram

_NEAR = 5e-4  # of its value, between a program and its bound
_MIDDLE = 0.25  # of a window is left on each side of where it is halved, at least
_POOL = 3_000  # routes that a part goes on with
_FREE = 0.01  # what an agent counts for an errand that costs nothing yet
_LITTLE = 1e-6


@dataclass(frozen=True, order=True)
class _Part:
    """Windows with their bound, and what the program has come to in them."""

    bound: int
    number: int
    errands: tuple[Errand, ...] = field(compare=False)
    routed: Routed = field(compare=False)


class _Split(NamedTuple):
    """An errand whose window is halved, the last step of the early half, and what that may gain."""

    errand: int
    step: int
    worth: float


@dataclass(eq=False)
class _Learnt:
    """What halving each errand was thought to gain so far, and what it did gain.

    Both begin with what is usual of all errands.
    """

    thought: dict[int, float] = field(default_factory=dict)
    gained: dict[int, float] = field(default_factory=dict)

    def hear(self, split: _Split, gain: float) -> None:
        """What the lesser half of a split has gained."""
        self.thought[split.errand] = self.thought.get(split.errand, 0.0) + split.worth
        self.gained[split.errand] = self.gained.get(split.errand, 0.0) + gain

    def share(self, errand: int) -> float:
        """What halving an errand gains, as a part of what it is thought to gain."""
        if not self.thought:
            return 1.0
        usual = sum(self.gained.values()) / sum(self.thought.values())
        trust = sum(self.thought.values()) / len(self.thought)
        thought, gained = self.thought.get(errand, 0.0), self.gained.get(errand, 0.0)
        return (gained + usual * trust) / (thought + trust)


@dataclass(eq=False)
class WindowTree:
    """Raises the bound of a program, of which no more than `most` values may be remembered."""

    program: RouteProgram
    most: int
    _number: int = field(default=0, init=False)
    _learnt: _Learnt = field(default_factory=_Learnt, init=False)

    def raised(self, routed: Routed, enough: Callable[[], float]) -> Iterator[int]:
        """Better bounds than that of what the program has come to, up to what is `enough`."""
        closed = np.inf
        parts = [_Part(routed.bound, 0, self.program.errands, routed)]
        while parts and parts[0].bound < min(closed, enough()) and not self.program.clock.over:
            part = heappop(parts)
            split = _split(part, self._learnt)
            if split is None:  # all may be run together
                closed = min(closed, part.bound)
                continue
            halves = [self._solved(part, half, enough()) for half in _halves(part.errands, split)]
            self._learnt.hear(split, min(half.bound for half in halves) - part.bound)
            for half in halves:
                heappush(parts, half)
            yield int(min(parts[0].bound, closed))

    def _solved(self, part: _Part, errands: tuple[Errand, ...], enough: float) -> _Part:
        """Some narrower windows than those of a part."""
        program = self.program
        program.narrowed(errands, _kept(part.routed), part.errands)
        near = max(_NEAR * part.bound, 1.0)
        routed = program.solve(near, enough)
        if routed.bound < enough and program.remember(routed, self.most):
            routed = program.solve(near, enough)
        self._number += 1
        return _Part(max(routed.bound, part.bound), self._number, errands, routed)


def _kept(routed: Routed) -> list[Route]:
    """The last routes of a program and all those that are used; none that run an errand twice."""
    order = np.argsort(routed.used > _LITTLE, kind="stable")[-_POOL:]
    routes = (routed.routes[place] for place in order.tolist())
    return [route for route in routes if not route.repeats]


def _halves(
    errands: tuple[Errand, ...], split: _Split
) -> tuple[tuple[Errand, ...], tuple[Errand, ...]]:
    """The errands with one that begins by a step, and with one that begins after it."""
    number, errand = split.errand, errands[split.errand]
    before, after = errands[:number], errands[number + 1 :]
    low, high = errand.ends
    return (
        (*before, errand.within(low, split.step), *after),
        (*before, errand.within(split.step + 1, high), *after),
    )


def _split(part: _Part, learnt: _Learnt) -> _Split | None:
    """What seems to gain most; None where all errands may be run together."""
    early, late = _run(part)
    best, found = 0.0, None
    for number, errand in enumerate(part.errands):
        price = float(part.routed.prices[number]) + _FREE
        worth = _lacking(errand.amount, early[number], late[number]) * price
        if len(worth) and worth.max() > _LITTLE:
            gain = float(worth.max()) * (learnt.share(number) + _LITTLE)
            if gain > best:
                best = gain
                step = errand.ends[0] + int(worth.argmax())
                found = _Split(number, step, float(worth.max()))
    return found


def _run(part: _Part) -> tuple[list[Floats], list[Floats]]:
    """For each errand how many run it so far, and beyond, for each step of its window."""
    early, late = ([np.zeros(max(e.ends[1] - e.ends[0], 0)) for e in part.errands] for _ in "el")
    routed = part.routed
    for place in np.flatnonzero(routed.used > _LITTLE).tolist():
        route, used = routed.routes[place], float(routed.used[place])
        shares: dict[int, float] = {}
        for (_, number), share in route.credits.items():
            shares[number] = max(shares.get(number, 0.0), share)
        for number, share in shares.items():
            errand = part.errands[number]
            soonest, latest = _span(errand, route)
            early[number][max(soonest - errand.ends[0], 0) :] += used * share
            late[number][: max(latest - errand.ends[0], 0)] += used * share
    return early, late


def _lacking(amount: int, early: Floats, late: Floats) -> Floats:
    """How many agents are lacking in the half that lacks less, for each place to halve at."""
    count = len(early)
    side = int(_MIDDLE * count)
    worth = np.minimum(amount - early, amount - late)
    worth[:side] = worth[count - side :] = 0.0
    return np.maximum(worth, 0.0)


def _span(errand: Errand, route: Route) -> tuple[int, int]:
    """The first and the last step at which an errand may begin that a route takes part in."""
    low, high = errand.ends
    soonest, latest = high, low
    for node, since, until in route.stays:
        if node in errand.states and until >= errand.first and since <= errand.last:
            lacking = max(errand.stay - (until - since + 1), 0)
            soonest = min(soonest, max(since - lacking, low))
            latest = max(latest, min(until - errand.stay + 1 + lacking, high))
    return soonest, latest
