"""Routes whose appointments begin at one step for all: a tree over the windows of appointments.

Each route of a linear program keeps its appointments in their windows, but two of them may keep one
at different steps. Where no step is right for both, the window is split in between, and each half
has a bound of its own. The least one holds for all plans.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from heapq import heappop, heappush

import numpy as np

from tsplan.clock import Clock
from tsplan.milp.model import Floats
from tsplan.search.route_bound import RouteBound, Stops, Windows


@dataclass(frozen=True, eq=False)
class RouteTree:
    """Raises the bound of all routes by splitting windows."""

    routes: RouteBound

    def raised(self, clock: Clock, enough: Callable[[], float]) -> Iterator[float]:
        """Better bounds, or the same again after some work; up to what is `enough`."""
        windows = Windows.of(self.routes.agenda)
        best = 0.0
        for bound in self.routes.raised(clock, windows):
            best = bound
            yield best
        opened = [(best, 0, windows, self.routes.used)]
        number = 0
        while opened and not clock.over:
            bound, _, windows, used = heappop(opened)
            parts = split(windows, [self.routes.stops(route) for route in used])
            if parts is None:
                return
            for part in parts:
                own = bound
                for more in self.routes.raised(clock, part):
                    own = max(own, more)
                    if own >= enough():
                        break
                number += 1
                heappush(opened, (own, number, part, self.routes.used))
            best = max(best, opened[0][0])
            yield best


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
