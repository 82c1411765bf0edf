"""From metres and seconds to steps: the one place where lengths become durations."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import lru_cache
from math import ceil
from typing import TypeAlias

from tsplan.exact import exact
from tsplan.ts.edges import DEFAULT

NANOMETRES = 9
"""Decimals of a metre to which lengths are taken, so that 12.1 - 10.4 is 1.7."""

Speed: TypeAlias = float | Mapping[str, float]
"""Metres a second: of everybody, or of each class by its name (`default` for all others)."""


@dataclass(frozen=True, slots=True)
class Ride:
    """One way along an edge: a length in metres, or the `seconds` that it takes whoever drives.

    Robots drive at a `share` of their speed there, and not faster than `limit`, in metres a second;
    a mapping has the limit of each class that may go there (None without one), and no other may.
    `pause` has further seconds, as for a door that opens.
    """

    length: float = 0.0
    seconds: float | None = None
    limit: float | Mapping[str, float | None] | None = None
    share: float = 1.0
    pause: float = 0.0


def steps_of(ride: Ride, step: float, speed: Speed) -> int | dict[str, int]:
    """How many steps of so many seconds a ride takes, at least one; by class where they differ.

    A robot enters the next edge at the next step after it has arrived, so parts of steps are
    rounded up: ceil(length / (speed x step)).

    >>> steps_of(Ride(length=1.1), 1.0, 0.1), steps_of(Ride(length=3), 2.0, {"a": 1, "b": 0.5})
    (11, {'a': 2, 'b': 3})
    >>> steps_of(Ride(length=3, limit=0.5, pause=8), 2.0, 1.0)
    7
    """
    speeds = speed if isinstance(speed, Mapping) else {DEFAULT: speed}
    if isinstance(ride.limit, Mapping):
        slowest = min(speeds.values())
        return {
            name: _steps(ride, limit, step, speeds.get(name, speeds.get(DEFAULT, slowest)))
            for name, limit in ride.limit.items()
        }
    each = {name: _steps(ride, ride.limit, step, own) for name, own in speeds.items()}
    if DEFAULT in each and len(set(each.values())) == 1:
        return each[DEFAULT]
    return each


def _steps(ride: Ride, limit: float | None, step: float, speed: float) -> int:
    alike = ride if ride.limit is None else replace(ride, limit=None)
    return _exact_steps(alike, limit, step, speed)


@lru_cache(maxsize=1024)  # the edges of a grid are all alike
def _exact_steps(ride: Ride, limit: float | None, step: float, speed: float) -> int:
    pace = exact(speed) * exact(ride.share)
    pace = pace if limit is None else min(pace, exact(limit))
    seconds = (
        exact(round(ride.length, NANOMETRES)) / pace
        if ride.seconds is None
        else exact(ride.seconds)
    )
    whole: Fraction = (seconds + exact(ride.pause)) / exact(step)
    return max(1, ceil(whole))
