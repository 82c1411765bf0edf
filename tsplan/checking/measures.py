"""What every objective is worth in a plan: a register of measures of traffic.

Waits are self-loops. A move entered before the horizon counts whole even if it ends after it. All
values are exact: costs are the decimal numbers that the map's file writes.
"""

from __future__ import annotations

import math
from fractions import Fraction
from types import MappingProxyType
from typing import TYPE_CHECKING, TypeAlias

import numpy as np

from tsplan.checking.satisfaction_check import slack_of
from tsplan.exact import exact
from tsplan.mission.objectives import OBJECTIVES, objectives_for
from tsplan.mission.performances import Kind, Performances, performance_of
from tsplan.name_runs import Names, RunMap
from tsplan.plans.moves import splits
from tsplan.plans.presence import Presence, state_counts

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from tsplan.checking.traffic import Traffic
    from tsplan.milp.model import Floats

Number: TypeAlias = Fraction | float
Measure: TypeAlias = "Callable[[Traffic], Number | None]"


def availability(traffic: Traffic) -> float:
    """Agents that may fail at all that holds: what must, and what may and does."""
    return slack_of(traffic.mission, traffic.trace, traffic.availability)


def satisfaction(traffic: Traffic) -> Fraction | None:
    """How much of the formula holds, or is preferred, where it need not hold as a whole."""
    return None if traffic.satisfaction is None else traffic.satisfaction.worth


def preferences(traffic: Traffic) -> Fraction | None:
    """What the preferences that hold are worth together."""
    if not traffic.mission.prefer:
        return None
    return sum((item.worth for item in traffic.preferences), Fraction(0))


def delay(traffic: Traffic) -> int | None:
    """How many steps late every agent may be."""
    mission = traffic.mission
    return traffic.delay if mission.delay or "delay" in mission.objective else None


def travel(traffic: Traffic) -> int:
    """Steps that all agents together spend on moves, and structures on being rebuilt."""
    rebuilt = sum(item.parts * (item.done - item.begun) for item in traffic.rebuilds)
    return rebuilt + sum(item.agents * (item.left - item.entered) for item in traffic.away)


def cost(traffic: Traffic) -> Fraction:
    """Summed costs of every edge that every agent enters, waits included."""
    costs = (
        class_traffic.factor
        * item.agents
        * item.times
        * exact(item.edge.cost_for(class_traffic.class_name))
        for class_traffic in traffic.classes
        for item in class_traffic.segments
    )
    return sum(costs, Fraction(0))


def energy(traffic: Traffic) -> Fraction | None:
    """Costs of every edge that is entered, and of everything that is rebuilt."""
    if not traffic.mission.modular.configurations:
        return None
    return cost(traffic) + sum(exact(item.rule.cost) for item in traffic.rebuilds)


def performance(traffic: Traffic) -> Fraction | None:
    """What the best way to meet the formula is worth, by how well structures do it."""
    mission, states = traffic.mission, tuple(traffic.mission.system.states)
    if not mission.modular.performance or mission.partial:
        return None
    there: dict[Kind, Floats] = {}
    for item in traffic.classes:
        for able in {presence.capabilities for presence in item.present if item.shape}:
            mine = (presence for presence in item.present if presence.capabilities == able)
            count = state_counts(mine, states, traffic.horizon).astype(np.float64)
            kind = Kind(item.shape, able)
            there[kind] = count + there.get(kind, 0.0)
    value = performance_of(mission, traffic.trace, there)
    if not math.isfinite(value):
        return None  # the formula does not hold
    return Performances(mission.modular).unit * Fraction(value)


def risk(traffic: Traffic) -> Fraction:
    """-log of the probability that no move fails, each edge's in millionths."""
    risks = (item.agents * item.times * item.edge.risk for item in traffic.segments)
    return sum(risks, Fraction(0))


def haulage(traffic: Traffic) -> Fraction | None:
    """Amounts times the steps they are moved."""
    return traffic.ledger.haulage if traffic.mission.resources else None


def reserve(traffic: Traffic) -> Fraction | float | None:
    """The least amount left at an execution beside what it needs."""
    return traffic.ledger.reserve if traffic.mission.resources else None


def makespan(traffic: Traffic) -> int:
    """The step at which the last move or reconfiguration ends, perhaps beyond the horizon."""
    ends = (item.done for item in traffic.rebuilds)
    begun = traffic.mission.begun_until
    return max((begun, *ends, *(item.left for item in traffic.away)))


def agents(traffic: Traffic) -> int:
    """How many agents ever move."""
    return sum(class_traffic.moving for class_traffic in traffic.classes)


def stability(traffic: Traffic) -> int | None:
    """How many agents do not go on as they were to."""
    if not _of_changes(traffic):
        return None
    paths = RunMap(
        (run, bundle)
        for item in traffic.classes
        for bundle in item.bundles
        for run in Names.of(bundle.agents).runs
    )
    return sum(
        part.size
        for each in traffic.mission.intended
        for part, path in paths.parts(each.names)
        if path is None or (path.stays, path.heading) != each[1:]
    )


def _of_changes(traffic: Traffic) -> bool:
    """Whether it matters what was to be done before the mission was planned again."""
    return bool(traffic.mission.intended) or any(
        name in traffic.mission.objective for name in ("stability", "deviation")
    )


def deviation(traffic: Traffic) -> int | None:
    """Agents that are missing where some were to be, added up over the steps."""
    if not _of_changes(traffic):
        return None
    intended = traffic.mission.intended
    present = [
        Presence(state, first, last, each.names.size, frozenset())
        for each in intended
        for first, last, state in each.stays
    ]
    states = tuple({presence.state for presence in present})
    asked = state_counts(present, states, traffic.horizon)
    return int(np.maximum(asked - traffic.counts(states), 0).sum())


def split(traffic: Traffic) -> int:
    """How often sub-swarms split: agents that leave by j edges, waits too, split j-1 times."""
    return sum(splits(moves) for moves in traffic.moves.values())


def moves(traffic: Traffic) -> int:
    """How often a sub-swarm enters an edge that is no wait."""
    return sum(not move.is_wait for moves in traffic.moves.values() for move in moves)


def balance(traffic: Traffic) -> int | None:
    """The size of the smallest sub-swarm at any step."""
    return min((group.size for group in traffic.groups), default=None)


_REGISTER: dict[str, Measure] = {
    "satisfaction": satisfaction,
    "preferences": preferences,
    "availability": availability,
    "delay": delay,
    "travel": travel,
    "cost": cost,
    "energy": energy,
    "performance": performance,
    "risk": risk,
    "haulage": haulage,
    "reserve": reserve,
    "makespan": makespan,
    "agents": agents,
    "stability": stability,
    "deviation": deviation,
    "splits": split,
    "moves": moves,
    "balance": balance,
}

MEASURES: Mapping[str, Measure] = MappingProxyType(_REGISTER)
"""The measure of every objective by its name."""


def register_measure(name: str, measure: Measure) -> None:
    """Say what a registered objective is worth in a plan.

    The measure gets the traffic of a plan (`tsplan.checking.traffic.Traffic`) and returns a whole
    number, a Fraction, an infinite float, or None where the mission has no such thing. Raises
    ValueError for a name without an objective and for one that has a measure.
    """
    if name not in OBJECTIVES:
        raise ValueError(f"there is no objective '{name}' to measure")
    if name in _REGISTER:
        raise ValueError(f"the objective '{name}' has a measure already")
    _REGISTER[name] = measure


def measured(traffic: Traffic) -> dict[str, Number]:
    """The value of every objective that the mission of some traffic may name; all are exact."""
    mission = traffic.mission
    named = objectives_for(swarms=mission.swarm is not None, expected=mission.expected is not None)
    values = {name: measure(traffic) for name, measure in MEASURES.items() if name in named}
    return {
        name: Fraction(value) if not isinstance(value, float) else value
        for name, value in values.items()
        if value is not None
    }
