"""What carries out a plan, seen step by step: robots, or what stands for them."""

from __future__ import annotations

from collections.abc import Container, Mapping, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple, Protocol, TypeAlias

from tsplan.plans.worlds import Closed, OnEdge, Opened, World

Sighting: TypeAlias = str | tuple[str, str] | None
"""Where somebody is seen: at a state, on an edge given by its ends, or nowhere any more (lost)."""


class MoveOrder(NamedTuple):
    """An agent or structure is to set out for another state, and should arrive at a step."""

    agent: str
    source: str
    target: str
    arrives: int


class Assembly(NamedTuple):
    """Modules that are, or become, one structure of a configuration."""

    structure: str
    configuration: str
    modules: tuple[str, ...]


class RebuildOrder(NamedTuple):
    """Structures at a state are to become others there, which should be done at a step.

    Until then it is those that are `made` that are seen, on the way from the state to itself. Where
    that is not done by the end of the plan there are none.
    """

    state: str
    parts: tuple[str, ...]
    made: tuple[Assembly, ...]
    done: int


Order: TypeAlias = MoveOrder | RebuildOrder
"""What is to begin at a step."""


@dataclass(frozen=True)
class Seen:
    """What is seen at a step: where agents are, and what is closed and opened from then on.

    Modules are seen as the structures that they are, or become. Who is not named is where it
    should be by its orders.
    """

    step: int
    places: Mapping[str, Sighting] = field(default_factory=dict)
    closed: tuple[Closed, ...] = ()
    opened: tuple[Opened, ...] = ()


class Fleet(Protocol):
    """Robots that take orders and are seen at every step."""

    def begin(
        self, step: int, places: Mapping[str, str | OnEdge], built: Sequence[Assembly] = ()
    ) -> None:
        """Make ready to go on from a step, at which agents and structures are at these places."""

    def advance(self, step: int, orders: Sequence[Order]) -> Seen:
        """Carry out the orders of a step; what is seen at the next one."""

    def end(self) -> None:
        """There is nothing more to do."""


def difference(
    step: int,
    planned: Mapping[str, str | OnEdge],
    seen: Seen,
    rebuilt: Container[str] = frozenset(),
) -> World | None:
    """How the world differs from what was planned for a step; None where it does not.

    `planned` has everybody who is not lost, and `rebuilt` are those that are part of others by
    then: where they are seen, that has not begun.
    """
    lost: list[str] = []
    moved: dict[str, str | OnEdge] = {}
    late: dict[str, int] = {}
    for name, place in seen.places.items():
        is_going_in = isinstance(place, tuple) and place[0] == place[1]
        if name not in planned and (name not in rebuilt or is_going_in):
            continue
        wanted = planned.get(name)
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
