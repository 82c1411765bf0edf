"""Counting atoms as bounds on the number of agents in sets of states.

`sum` bounds the set of all states with the label; `min ... >=` and `max ... <=` bound each state on
its own (all of them must hold); `min ... <=` and `max ... >=` ask for one state (any of them).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeAlias

from tsplan.encode.agent_classes import MapArrays
from tsplan.logic import Count
from tsplan.ts import TransitionSystem

Site: TypeAlias = tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Bound:
    """At least (or, if `upper`, at most) `amount` agents with a capability at a set of states."""

    states: Site
    capability: str | None
    upper: bool
    amount: int


@dataclass(frozen=True, slots=True)
class Requirement:
    """Bounds that must all hold, or of which one must."""

    bounds: tuple[Bound, ...]
    every: bool


def requirement(
    atom: Count, system: TransitionSystem, arrays: MapArrays, level: int = 0
) -> Requirement:
    """The bounds an atom means, tightened by `level` (availability at least `level`)."""
    states = tuple(arrays.states_with(system, atom.label).tolist())
    upper = atom.relation == "<="
    if atom.relation not in (">=", "<=") or not isinstance(atom.bound, int):
        raise ValueError(f"'{atom}' is not in positive normal form")
    amount = atom.bound - level if upper else atom.bound + level
    sites = (states,) if atom.function == "sum" else tuple((state,) for state in states)
    bounds = tuple(Bound(site, atom.capability, upper, amount) for site in sites)
    each = atom.function == "sum" or (atom.function == "max") == upper
    return Requirement(bounds, each)
