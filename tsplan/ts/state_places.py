"""Where a state is on the plane, as far as its map says."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import TypeAlias

from tsplan.ts.edges import State

Point: TypeAlias = tuple[float, float]
"""Coordinates in the unit of the map."""

_FLAT = 1e-9  # of an area: below it a polygon has no centroid


def own_place(state: State) -> Point | None:
    """The coordinates that a state brings along: `at`, else the centre of its shape, else None.

    >>> own_place(State("hall", shape=((0, 0), (2, 0), (2, 2), (0, 2)))), own_place(State("yard"))
    ((1.0, 1.0), None)
    """
    if state.at is not None:
        return float(state.at[0]), float(state.at[1])
    return centroid(state.shape) if state.shape else None


def centroid(shape: Sequence[Point]) -> Point:
    """The centre of a polygon's area; of a degenerate one, the mean of its corners.

    >>> centroid([(0, 0), (6, 0), (0, 3)])
    (2.0, 1.0)
    """
    area = x = y = 0.0
    for (x0, y0), (x1, y1) in pairwise([*shape, shape[0]]):
        cross = x0 * y1 - x1 * y0
        area += cross
        x += (x0 + x1) * cross
        y += (y0 + y1) * cross
    extent = max(max(p) for p in shape) - min(min(p) for p in shape)
    if abs(area) <= _FLAT * max(extent * extent, 1.0):
        return sum(p[0] for p in shape) / len(shape), sum(p[1] for p in shape) / len(shape)
    return x / (3 * area), y / (3 * area)
