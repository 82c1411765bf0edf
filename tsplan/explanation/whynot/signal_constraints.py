"""What a mission over signals consists of, and the mission without some of that.

A part of the formula is replaced by true. A bound is not taken away but moved far out, and a start
widened as much: which side of an infinite range a signal is on is no choice that a solver can make.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from math import isfinite
from typing import TYPE_CHECKING, Any

import numpy as np

from tsplan.explanation.explanation import SoftConstraint
from tsplan.explanation.part_words import Wording
from tsplan.explanation.whynot.occurrences import without
from tsplan.explanation.whynot.signal_numbers import MAX, MIN, alike, scale, with_sides
from tsplan.explanation.whynot.soft_constraints import occurrence_of
from tsplan.logic import Formula, fold, positive
from tsplan.logic.text import number_text
from tsplan.signals.copies import prefixed
from tsplan.signals.equalities import TOLERANCE, approximate

if TYPE_CHECKING:
    from tsplan.document import Path
    from tsplan.signals.linear_system import Range, System
    from tsplan.signals.signal_mission import SignalMission

_FAR = 10.0
"""How often the largest number of a mission goes into how far out a bound is moved."""


def signal_bounds(mission: SignalMission) -> tuple[SoftConstraint, ...]:
    """Everything that bounds trajectories beside the formula, what matters most to people first.

    Where signals begin, the ends of controls, limits, the ends of signals. The dynamics stay. Ends
    that several robots share are one.
    """
    system = mission.system
    return (
        *(SoftConstraint("start", (name,)) for name in system.signals if name in system.initial),
        *(SoftConstraint("control", key) for key in _sides(mission, system.controls)),
        *(SoftConstraint("limit", (number,)) for number in range(len(system.limits))),
        *(SoftConstraint("signal", key) for key in _sides(mission, system.signals)),
    )


def _sides(mission: SignalMission, names: Iterable[str]) -> Iterator[tuple[str, int]]:
    """The ends there are: names with which of the two."""
    ranges = {**mission.system.signals, **mission.system.controls}
    for name in names:
        if alike(mission, name)[0] == name:
            yield from ((name, place) for place in (MIN, MAX) if isfinite(ranges[name][place]))


def far(mission: SignalMission, name: str) -> float:
    """How far out a bound is moved that is left out.

    A control may be so large that it moves a signal as far in one step, whatever its factor.
    """
    much, system = _FAR * scale(mission), mission.system
    if name in system.signals or system.dynamics is None:
        return much
    a, b, _ = system.dynamics.arrays
    column = np.abs(b[:, list(system.controls).index(name)])
    least = column[column > 0].min(initial=1.0)
    return float(much * (1 + np.abs(a).sum(axis=1).max()) / least)


def near(formula: Formula, system: System) -> Formula:
    """A formula in the normal form that a planner demands, in which equations are a little wide."""
    return positive(approximate(formula, system, TOLERANCE / 2))


def bare(mission: SignalMission, formula: Formula, system: System, **more: Any) -> SignalMission:
    """A mission of another formula and system that asks for no more than that the formula holds.

    Weights are left out: they change by how much a formula holds, not whether it does.
    """

    def unweighted(node: Formula, below: tuple[Formula, ...]) -> Formula:
        made = node.over(below)
        plain = getattr(made, "weights", None) is None
        return made if plain else replace(made, weights=None)  # type: ignore[type-var]

    return replace(
        mission,
        formula=fold(formula, unweighted),
        system=system,
        objective=(),
        satisfaction=None,
        prefer=(),
        weights={},
        regions={},
        copies=(),
        parts=(),
        text="",
        origin=None,
        warnings=(),
        digest="",
        **more,
    )


def relaxed_signals(mission: SignalMission, gone: Iterable[SoftConstraint]) -> SignalMission:
    """The mission without some of its constraints, and without anything to optimise."""
    dropped = list(gone)
    parts = [occurrence_of(item) for item in dropped if item.kind == "formula"]
    return bare(mission, without(mission.formula, parts), _looser(mission, dropped))


def _looser(mission: SignalMission, gone: list[SoftConstraint]) -> System:
    system = mission.system
    limits = {item.key[0] for item in gone if item.kind == "limit"}
    starts = {item.key[0] for item in gone if item.kind == "start"}
    sides = [
        (name, place, system_side(system, name)[place] + (-1, 1)[place] * far(mission, name))
        for key, place in (item.key for item in gone if item.kind in ("control", "signal"))
        for name in alike(mission, key)
    ]
    made = with_sides(system, sides)
    wide = {name: _wider(system.initial[name], far(mission, name), made, name) for name in starts}
    initial = {**system.initial, **wide}
    kept = tuple(limit for number, limit in enumerate(system.limits) if number not in limits)
    return replace(made, initial=initial, limits=kept)


def system_side(system: System, name: str) -> Range:
    """The bounds of a signal or control."""
    return system.signals[name] if name in system.signals else system.controls[name]


def _wider(begins: Range, much: float, system: System, name: str) -> Range:
    """Where a signal may begin that may begin almost anywhere in its bounds."""
    low, high = system.signals[name]
    return max(begins[MIN] - much, low), min(begins[MAX] + much, high)


@dataclass(frozen=True)
class SignalWording(Wording):
    """Words and places for what bounds trajectories."""

    mission: SignalMission

    def path(self, constraint: SoftConstraint) -> Path | None:
        """Where the mission file says a bound."""
        assert self.mission.origin is not None
        data = self.mission.origin.data
        kind, (key, *which) = constraint
        if kind == "limit":
            return ("limits", key) if len(data.get("limits", ())) == self._limits else ("limits",)
        copy, name = self._base(key)
        if kind == "start" and copy and name in data["copies"][copy].get("initial", {}):
            return ("copies", copy, "initial", name)
        path = ("controls" if kind == "control" else "signals", name)
        entry = data[path[0]][name]
        if not isinstance(entry, dict):
            return (*path, which[0]) if which else path
        word = ("min", "max")[which[0]] if which else "initial"
        return (*path, word) if word in entry else path

    @property
    def _limits(self) -> int:
        return len(self.mission.system.limits)

    def _base(self, name: str) -> tuple[str, str]:
        """The robot that a signal is one of, and what it is called of a single one."""
        for copy in self.mission.copies:
            begin = prefixed(copy, "")
            if name.startswith(begin):
                return copy, name[len(begin) :]
        return "", name

    def bound_text(self, constraint: SoftConstraint) -> str:
        """A bound beside the formula in words."""
        kind, (key, *which) = constraint
        system = self.mission.system
        if kind == "limit":
            return f"the limit {system.limits[key]}"
        if kind == "start":
            low, high = system.initial[key]
            first, last = number_text(low), number_text(high)
            return f"{key} begins at {first}" if low == high else f"{key} begins at {first}..{last}"
        names = ", ".join(alike(self.mission, key))
        verb = "is" if names == key else "are"
        most = "at least" if which[0] == MIN else "at most"
        return f"{names} {verb} {most} {number_text(system_side(system, key)[which[0]])}"
