"""Where agents stand that are at one state together: slots as points around its middle."""

from __future__ import annotations

import math
from functools import cache

from tsplan.viewer.tracks import MOST_SLOTS

_SIDES = tuple((math.cos(turn * math.pi / 3), math.sin(turn * math.pi / 3)) for turn in range(2, 8))


@cache
def slot_points(most: int = MOST_SLOTS) -> tuple[tuple[float, float], ...]:
    """The places of slots in units of their distance: a middle and hexagonal rings around it.

    >>> [(round(x, 2), round(y, 2)) for x, y in slot_points()[:3]]
    [(0.0, 0.0), (1.0, 0.0), (0.5, 0.87)]
    """
    points = [(0.0, 0.0)]
    ring = 1
    while len(points) < most:
        x, y = float(ring), 0.0
        for dx, dy in _SIDES:
            for _ in range(ring):
                points.append((x, y))
                x, y = x + dx, y + dy
        ring += 1
    return tuple(points[:most])


def slots_within(radius: float) -> int:
    """How many slots there are in the rings up to a radius, in units of their distance.

    >>> slots_within(0.4), slots_within(1.0), slots_within(2.9)
    (1, 7, 19)
    """
    rings = max(0, math.floor(radius))
    return min(MOST_SLOTS, 1 + 3 * rings * (rings + 1))
