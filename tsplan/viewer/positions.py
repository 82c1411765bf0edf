"""Where agents stand that are at one state together: slots, and their points around its middle.

Slots are small numbers that no other agent at the state has at the same time, so that a picture can
give each one a place of its own and keep it there for the whole stay.
"""

from __future__ import annotations

import cmath
import math
from collections import defaultdict
from collections.abc import Sequence
from dataclasses import replace
from functools import cache

from tsplan.draw.tracks import Track

MOST_SLOTS = 127
"""Agents at one state that get a place of their own; more are shown as a number anyway."""

_SIDES = tuple(cmath.rect(1, turn * math.pi / 3) for turn in range(2, 8))


def with_slots(found: Sequence[Track]) -> tuple[Track, ...]:
    """The tracks with slots: at each state the first free ones, in the order of arrival."""
    placed = [list(track.stops) for track in found]
    visits: defaultdict[str, list[tuple[int, int, int]]] = defaultdict(list)
    for number, path in enumerate(placed):
        for place, stop in enumerate(path):
            visits[stop.state].append((stop.first, number, place))
    for arrivals in visits.values():
        taken: list[tuple[int, int, int]] = []  # slots from .. to (excluded), until this step
        for first, number, place in sorted(arrivals):
            taken = [entry for entry in taken if entry[2] >= first]
            stop, count = placed[number][place], found[number].count
            slot = _free(taken, count)
            if slot + count <= MOST_SLOTS:
                taken = sorted([*taken, (slot, slot + count, stop.last)])
            placed[number][place] = stop._replace(slot=slot)
    return tuple(replace(track, stops=tuple(p)) for track, p in zip(found, placed, strict=True))


def _free(taken: Sequence[tuple[int, int, int]], wanted: int) -> int:
    """The first of `wanted` free slots in a row."""
    slot = 0
    for begin, end, _ in taken:
        if slot + wanted <= begin:
            return slot
        slot = max(slot, end)
    return slot


@cache
def slot_points(most: int = MOST_SLOTS) -> tuple[complex, ...]:
    """The places of slots in units of their distance: a middle and hexagonal rings around it.

    >>> [complex(round(at.real, 2), round(at.imag, 2)) for at in slot_points()[:3]]
    [0j, (1+0j), (0.5+0.87j)]
    """
    points = [0j]
    for ring in range(1, most):
        at = complex(ring)
        for side in _SIDES:
            points += (at + side * step for step in range(ring))
            at += side * ring
        if len(points) >= most:
            break
    return tuple(points[:most])


def slots_within(radius: float) -> int:
    """How many slots there are in the rings up to a radius, in units of their distance.

    >>> slots_within(0.4), slots_within(1.0), slots_within(2.9)
    (1, 7, 19)
    """
    rings = max(0, math.floor(radius))
    return min(MOST_SLOTS, 1 + 3 * rings * (rings + 1))
