"""Whether the numbers of a mission are numbers, and of a size that can be planned.

For missions from files most of this is settled by the file's schema already, with its places; it
is here for those that are made in Python, by the same limits.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import asdict
from fractions import Fraction
from typing import Any

from tsplan.limits import (
    LARGEST,
    LEAST_WEIGHT,
    MOST_ROBOTS,
    MOST_STEPS,
    MOST_WEIGHT,
    Range,
    complaints,
)
from tsplan.mission.configuration_checks import module_number_faults
from tsplan.mission.findings import Fault, Place
from tsplan.mission.mission_parts import MissionParts
from tsplan.mission.team import SwarmRules

_COUNT = Range(1, LARGEST, whole=True)
_FROM_0 = Range(0, LARGEST, whole=True)
_STEPS = Range(0, MOST_STEPS, whole=True)
_ARRIVAL = Range(1, MOST_STEPS, whole=True)
_ROBOTS = Range(0, MOST_ROBOTS, whole=True)
_SHARE = Range(0, 1)
_WEIGHT = Range(LEAST_WEIGHT, MOST_WEIGHT)


def number_faults(mission: MissionParts) -> list[Fault]:
    """Numbers of a mission that are none, or too small or too large."""
    faults = [
        Fault(("solver", name), words, "leave it out for its default")
        for name, words in complaints(asdict(mission.solver)).items()
    ]
    found: list[tuple[Place, str | None]] = []
    for number, group in enumerate(mission.team):
        found += [
            (("team", number, "at", state), _COUNT.complaint(count))
            for state, count in group.starts
        ]
        found += [
            (("team", number, "at", start.label), complaint)
            for start, count in group.coming
            for complaint in (_COUNT.complaint(count), _ARRIVAL.complaint(start.arrives))
        ]
    for number, wish in enumerate(mission.prefer):
        place = ("spec", "prefer", number)
        found.append(((*place, "weight"), _WEIGHT.complaint(wish.weight)))
        found.append(((*place, "level"), _FROM_0.complaint(wish.level)))
    found.append((("horizon",), _STEPS.complaint(mission.horizon)))
    found += module_number_faults(mission.modular)
    if mission.swarm is not None:
        found += _swarm_numbers(mission.swarm)
    if mission.expected is not None:
        found += _margin(mission.expected.margin)
    return faults + [Fault(place, words) for place, words in found if words is not None]


def _swarm_numbers(rules: SwarmRules) -> Iterator[tuple[Place, str | None]]:
    for name, bounds in rules.each.items():
        yield ("swarms", name, "min_subswarm"), _COUNT.complaint(bounds.least)
        yield ("swarms", name, "max_subswarms"), _given(bounds.most)
    yield ("max_subswarms",), _given(rules.together)
    yield from _margin(rules.margin)


def _margin(margin: Any) -> Iterator[tuple[Place, str | None]]:
    span = _SHARE if isinstance(margin, Fraction) else _ROBOTS
    yield ("margin",), span.complaint(margin)


def _given(value: Any) -> str | None:
    """What is wrong with a bound, if there is one."""
    return None if value is None else _COUNT.complaint(value)
