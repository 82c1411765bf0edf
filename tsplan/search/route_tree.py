"""Routes whose appointments begin at one step for all: a tree over the windows of appointments.

Each route of a linear program keeps its appointments in their windows, but two of them may keep one
at different steps. Where no step is right for both, the window is split in between, and each half
has a bound of its own. The least one holds for all plans.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from heapq import heappop, heappush
from itertools import accumulate

import numpy as np

from tsplan.clock import Clock
from tsplan.milp.model import Floats
from tsplan.search.in_turns import in_turns
from tsplan.search.route_bound import Key, RouteBound, Stops, Windows

_PLUNGE = 8  # of so many parts one is split until its routes meet


@dataclass(frozen=True, order=True)
class _Part:
    """Windows with their bound, and the routes that the program uses in them."""

    bound: float
    number: int
    windows: Windows = field(compare=False)
    used: Sequence[Key] = field(compare=False)


@dataclass(eq=False)
class RouteTree:
    """Raises the bound of all routes by splitting windows.

    `windows` are those that were split last, and `met` those in which all routes of the program can
    keep their appointments together, if there have been any.
    """

    routes: RouteBound
    windows: Windows
    met: Windows | None = field(default=None, init=False)
    _number: int = field(default=0, init=False)

    def raised(self, clock: Clock, enough: Callable[[], float]) -> Iterator[float]:
        """Better bounds, or the same again after some work; up to what is `enough`.

        The part with the least bound is split; now and then its better half is, too, and so on
        until all routes in it can keep their appointments together.
        """
        best = 0.0
        for bound in self.routes.raised(clock, self.windows):
            best = bound
            yield best
        opened = [_Part(best, 0, self.windows, self.routes.used)]
        closed, turn = np.inf, 0
        while opened and opened[0].bound < min(closed, enough()) and not clock.over:
            part: _Part | None = heappop(opened)
            plunging = turn % _PLUNGE == 0
            turn += 1
            while part is not None and not clock.over:
                self.windows = part.windows
                halves = split(part.windows, [self.routes.stops(route) for route in part.used])
                if halves is None:
                    closed, self.met = min(closed, part.bound), part.windows
                    break
                near, far = sorted(self._halves(part, halves, clock, enough))
                heappush(opened, far)
                part = near
                if not plunging or near.bound >= enough():
                    heappush(opened, near)
                    part = None
                least = min([closed, opened[0].bound, *([] if part is None else [part.bound])])
                best = max(best, least)
                yield best
            else:
                if part is not None:
                    heappush(opened, part)
            best = max(best, min([closed, *(each.bound for each in opened[:1])]))
            yield best

    def _halves(
        self,
        part: _Part,
        halves: Sequence[Windows],
        clock: Clock,
        enough: Callable[[], float],
    ) -> Iterator[_Part]:
        """Both halves of a part, each with its own bound."""
        for windows in halves:
            bound = part.bound
            for more in self.routes.raised(clock, windows):
                bound = max(bound, more)
                if bound >= enough():
                    break
            self._number += 1
            yield _Part(bound, self._number, windows, self.routes.used)


def highest(trees: Sequence[Iterator[float]]) -> Iterator[float]:
    """The highest bound so far of several trees, each of which gets as much time as the others."""
    return accumulate(in_turns(*trees), max)


def split(windows: Windows, routes: Sequence[Stops]) -> tuple[Windows, Windows] | None:
    """The windows with one of them in two parts, so that not all routes are in time in either.

    None where all of them can keep their appointments together.
    """
    soonest, latest = _spans(windows, routes, together=False)
    if (soonest <= latest).all():
        soonest, latest = _spans(windows, routes, together=True)
    apart = soonest - latest
    apart[np.equal(windows.first, windows.last)] = 0.0
    number = int(apart.argmax())
    if apart[number] <= 0:
        return None
    first, last = windows.first[number], windows.last[number]
    step = int(np.clip((soonest[number] + latest[number]) // 2, first, last - 1))
    return windows.cut(number, first, step), windows.cut(number, step + 1, last)


def _spans(windows: Windows, routes: Sequence[Stops], *, together: bool) -> tuple[Floats, Floats]:
    """When each appointment can begin at soonest and at latest for its routes.

    Each route is looked at by itself, or `together`: what makes one late does so to all.
    """
    first, last = (np.array(side, dtype=np.float64) for side in (windows.first, windows.last))
    soonest, latest = first.copy(), last.copy()
    for _ in range(len(first) if together else 1):
        before = soonest.copy(), latest.copy()
        for route in routes:
            now = 0.0
            for number, steps in zip(route.numbers, route.soonest, strict=True):
                now = max(now + steps, (soonest if together else first)[number])
                soonest[number] = max(soonest[number], now)
            now = np.inf
            for number, steps in zip(route.numbers[::-1], route.soonest[::-1], strict=True):
                now = min(now, (latest if together else last)[number])
                latest[number] = min(latest[number], now)
                now -= steps
        soonest, latest = np.minimum(soonest, last + 1), np.maximum(latest, first - 1)
        if np.array_equal(before, (soonest, latest)):
            break
    return soonest, latest
