"""What carries out a plan, seen step by step: robots, or what stands for them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple, Protocol, TypeAlias

from tsplan.plans.worlds import Closed, OnEdge, Opened, World

Sighting: TypeAlias = str | tuple[str, str] | None
"""Where somebody is seen: at a state, on an edge given by its ends, or nowhere any more (lost)."""


class MoveOrder(NamedTuple):
    """An agent is to set out from one state to another, and should arrive at a step."""

    agent: str
    source: str
    target: str
    arrives: int


@dataclass(frozen=True)
class Seen:
    """What is seen at a step: where agents are, and what is closed and opened from then on.

    Agents that are not named are where they should be by their orders.
    """

    step: int
    places: Mapping[str, Sighting] = field(default_factory=dict)
    closed: tuple[Closed, ...] = ()
    opened: tuple[Opened, ...] = ()


class Fleet(Protocol):
    """Robots that take orders and are seen at every step."""

    def begin(self, step: int, places: Mapping[str, str | OnEdge]) -> None:
        """Make ready to go on from a step, at which agents are at these places."""

    def advance(self, step: int, orders: Sequence[MoveOrder]) -> Seen:
        """Carry out the orders of a step; what is seen at the next one."""

    def end(self) -> None:
        """There is nothing more to do."""


def difference(step: int, planned: Mapping[str, str | OnEdge], seen: Seen) -> World | None:
    """How the world differs from what was planned for a step; None where it does not.

    `planned` has everybody who is not lost.
    """
    lost: list[str] = []
    moved: dict[str, str | OnEdge] = {}
    late: dict[str, int] = {}
    for name, place in seen.places.items():
        if name not in planned:
            continue
        wanted = planned[name]
        if place is None:
            lost.append(name)
        elif isinstance(place, str):
            if place != wanted:
                moved[name] = place
        elif isinstance(wanted, OnEdge) and (wanted.source, wanted.target) == place:
            continue
        elif wanted == place[1]:  # it should have come there, and has not yet
            late[name] = 1
        else:
            moved[name] = OnEdge(*place, step + 1)
    if not (lost or moved or late or seen.closed or seen.opened):
        return None
    return World(step, tuple(lost), moved, late, closed=seen.closed, opened=seen.opened)
