"""What a plan says about how much of its mission it satisfies."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction


@dataclass(frozen=True, slots=True)
class Node:
    """One part of a formula, as text, `depth` levels below the whole.

    `fraction` is how much of it holds, `first` and `last` the steps between which its atoms are
    looked at. A node that is not `counted` is an alternative to one that holds more.
    """

    text: str
    depth: int
    first: int
    last: int
    fraction: Fraction
    counted: bool = True

    @property
    def met(self) -> bool:
        """Whether the part holds."""
        return self.fraction == 1


@dataclass(frozen=True, slots=True)
class Depth:
    """How many parts of one depth hold at their steps without any part around them holding.

    `bound` is what no plan can exceed that does as well at the depths above.
    """

    depth: int
    value: int
    bound: int | None = None


@dataclass(frozen=True, slots=True)
class Satisfaction:
    """How much of a mission's formula a plan satisfies, in the mission's `order`.

    `fraction` and `nodes` (parents before their children) tell how much of the whole and of each
    part holds. `availability` is the least number of agents to spare at what is satisfied, None
    where nothing can fail. `depths` counts what holds for the orders that go by depth. What is
    still to be computed from the paths is None or empty.
    """

    order: str
    fraction: Fraction | None = None
    availability: float | None = None
    depths: tuple[Depth, ...] = ()
    nodes: tuple[Node, ...] = ()


@dataclass(frozen=True, slots=True)
class Fulfilment:
    """What became of one preferred formula; `fraction` and `nodes` are as in `Satisfaction`."""

    name: str
    weight: Fraction
    level: int
    partial: bool
    fraction: Fraction
    nodes: tuple[Node, ...] = ()

    @property
    def met(self) -> bool:
        """Whether the formula holds."""
        return self.fraction == 1

    @property
    def worth(self) -> Fraction:
        """What the plan gains by it."""
        return self.weight * (self.fraction if self.partial else Fraction(self.met))
