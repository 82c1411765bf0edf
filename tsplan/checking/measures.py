"""Values of the objectives, computed from the agents' paths.

Waits are self-loops. `travel` sums the durations of all other moves and `cost` the costs of all
moves; a move entered before the horizon counts whole even if it ends after it. `makespan` is the
step at which the last move that is not a wait arrives (0 without one, perhaps beyond the
horizon), `agents` the number of agents that ever make one. All of them are exact: costs are the
decimal numbers that the map's file writes.
"""

from __future__ import annotations

from fractions import Fraction
from types import MappingProxyType
from typing import TYPE_CHECKING, TypeAlias

from tsplan.exact import exact

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Mapping

    from tsplan.checking.path_segments import Leg
    from tsplan.plans.plan import Bundle

Journey: TypeAlias = "tuple[Bundle, tuple[Leg, ...]]"


def travel(journeys: Iterable[Journey]) -> int:
    """Steps that all agents together spend on moves."""
    return sum(
        len(bundle.agents) * (leg.left - leg.entered)
        for bundle, legs in journeys
        for leg in legs
        if not leg.edge.is_wait
    )


def cost(journeys: Iterable[Journey]) -> Fraction:
    """Summed costs of every edge that every agent enters, waits included."""
    costs = (
        len(bundle.agents) * leg.times * exact(leg.edge.cost_for(bundle.class_name))
        for bundle, legs in journeys
        for leg in legs
    )
    return sum(costs, Fraction(0))


def makespan(journeys: Iterable[Journey]) -> int:
    """The step at which the last move arrives."""
    return max(
        (leg.left for _, legs in journeys for leg in legs if not leg.edge.is_wait), default=0
    )


def agents(journeys: Iterable[Journey]) -> int:
    """How many agents ever move."""
    return sum(
        len(bundle.agents) for bundle, legs in journeys if any(not leg.edge.is_wait for leg in legs)
    )


MEASURES: Mapping[str, Callable[[Iterable[Journey]], int | Fraction]] = MappingProxyType(
    {"travel": travel, "cost": cost, "makespan": makespan, "agents": agents}
)
"""Every objective that paths alone determine; `availability` needs the formula too."""
