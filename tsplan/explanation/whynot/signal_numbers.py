"""The numbers of a mission over signals beside its formula: how each is read and put."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from fractions import Fraction
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

from tsplan.logic import Linear, walk
from tsplan.signals.copies import prefixed

if TYPE_CHECKING:
    from tsplan.signals.linear_system import Range, System, Terms
    from tsplan.signals.signal_mission import SignalMission

MIN, MAX = 0, 1
"""The places of the two ends of a range."""

_FINE = 1e-6  # of the range of a value: how far it is told where it may be any number


def alike(mission: SignalMission, name: str) -> tuple[str, ...]:
    """A signal or control, and what it is of the other robots that have the same bounds."""
    for copy in mission.copies:
        begin = prefixed(copy, "")
        if name.startswith(begin):
            return tuple(prefixed(other, name[len(begin) :]) for other in mission.copies)
    return (name,)


def grain(width: float) -> Fraction:
    """The step in which a real number of a range is moved: a power of ten, a millionth of it.

    >>> grain(9.0), grain(2000.0)
    (Fraction(1, 1000000), Fraction(1, 1000))
    """
    return Fraction(10) ** math.floor(math.log10(_FINE * width) + _FINE)


def width_of(mission: SignalMission, terms: Terms) -> float:
    """How far a sum can be from its least to its greatest value, for all that its bounds say."""
    total = 0.0
    for name, factor in terms:
        low, high = _ranges(mission.system)[name]
        total += abs(factor) * (high - low if math.isfinite(high - low) else scale(mission))
    return total or scale(mission)


def scale(mission: SignalMission) -> float:
    """The largest number that a mission names: bounds, beginnings, thresholds and limits."""
    system = mission.system
    named = [end for ends in (*_ranges(system).values(), *system.initial.values()) for end in ends]
    named += [limit.bound for limit in system.limits]
    named += () if system.dynamics is None else system.dynamics.d
    for node in walk(mission.formula):
        if isinstance(node, Linear) and node.terms:
            named.append(node.bound / min(abs(factor) for _, factor in node.terms))
    return max((abs(number) for number in named if math.isfinite(number)), default=0.0) or 1.0


def _ranges(system: System) -> Mapping[str, Range]:
    return {**system.signals, **system.controls}


def with_end(ends: Range, place: int, value: float) -> Range:
    """A range with another end."""
    return (value, ends[MAX]) if place == MIN else (ends[MIN], value)


def with_sides(system: System, sides: Iterable[tuple[str, int, float]]) -> System:
    """A system with other bounds of signals and controls: names, which end, and what it is."""
    signals, controls = dict(system.signals), dict(system.controls)
    for name, place, value in sides:
        ranges = signals if name in signals else controls
        ranges[name] = with_end(ranges[name], place, value)
    return replace(system, signals=signals, controls=controls)


def _changed(mission: SignalMission, **fields: Any) -> SignalMission:
    return replace(mission, warnings=(), **fields)


def _side(mission: SignalMission, name: str, place: int) -> float:
    return float(_ranges(mission.system)[name][place])


def _put_side(mission: SignalMission, value: float, name: str, place: int) -> SignalMission:
    sides = [(one, place, value) for one in alike(mission, name)]
    return _changed(mission, system=with_sides(mission.system, sides))


def _begin(mission: SignalMission, name: str, place: int) -> float:
    return float(mission.system.initial[name][place])


def _put_begin(mission: SignalMission, value: float, name: str, place: int) -> SignalMission:
    system = mission.system
    begins = with_end(system.initial[name], place, value)
    system = replace(system, initial={**system.initial, name: begins})
    return _changed(mission, system=system)


def _limit(mission: SignalMission, number: int) -> float:
    return float(mission.system.limits[number].bound)


def _put_limit(mission: SignalMission, value: float, number: int) -> SignalMission:
    limits = list(mission.system.limits)
    limits[number] = replace(limits[number], bound=value)
    return _changed(mission, system=replace(mission.system, limits=tuple(limits)))


def _last(mission: SignalMission) -> int:
    return mission.horizon


def _put_last(mission: SignalMission, value: int) -> SignalMission:
    return _changed(mission, horizon=value)


ACCESS: Mapping[str, tuple[Callable[..., Any], Callable[..., Any]]] = MappingProxyType(
    {
        "side": (_side, _put_side),
        "begin": (_begin, _put_begin),
        "limit": (_limit, _put_limit),
        "last": (_last, _put_last),
    }
)
