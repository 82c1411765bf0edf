"""Values of the objectives, computed from the agents' paths.

Waits are self-loops. `travel` sums the durations of all other moves and `cost` the costs of all
moves; a move entered before the horizon counts whole even if it ends after it. `makespan` is the
step at which the last move that is not a wait arrives (0 without one, perhaps beyond the
horizon), `agents` the number of agents that ever make one.
"""

from __future__ import annotations

from types import MappingProxyType
from typing import TYPE_CHECKING, TypeAlias

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Mapping

    from tsplan.results.legs import Leg
    from tsplan.results.plan import Bundle

Journey: TypeAlias = "tuple[Bundle, tuple[Leg, ...]]"


def travel(journeys: Iterable[Journey]) -> float:
    """Steps that all agents together spend on moves."""
    return sum(
        len(bundle.agents) * (leg.left - leg.entered)
        for bundle, legs in journeys
        for leg in legs
        if not leg.edge.is_wait
    )


def cost(journeys: Iterable[Journey]) -> float:
    """Summed costs of every edge that every agent enters, waits included."""
    return sum(
        len(bundle.agents) * leg.times * leg.edge.cost_for(bundle.class_name)
        for bundle, legs in journeys
        for leg in legs
    )


def makespan(journeys: Iterable[Journey]) -> float:
    """The step at which the last move arrives."""
    return max(
        (leg.left for _, legs in journeys for leg in legs if not leg.edge.is_wait), default=0
    )


def agents(journeys: Iterable[Journey]) -> float:
    """How many agents ever move."""
    return sum(
        len(bundle.agents) for bundle, legs in journeys if any(not leg.edge.is_wait for leg in legs)
    )


MEASURES: Mapping[str, Callable[[Iterable[Journey]], float]] = MappingProxyType(
    {"travel": travel, "cost": cost, "makespan": makespan, "agents": agents}
)
"""Every objective that paths alone determine; `availability` needs the formula too."""
