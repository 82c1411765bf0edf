"""What a plan says about how much of its mission it satisfies."""

from __future__ import annotations

from dataclasses import dataclass, field
from fractions import Fraction
from typing import Literal, TypeAlias

from tsplan.plans.records import OPTIONAL, Exact, Finite, Portion, Record, Weight, Whole

Order: TypeAlias = Literal["weighted", "hierarchical", "depth"]


@dataclass(frozen=True, slots=True)
class Node(Portion):
    """One part of a formula, as text, `depth` levels below the whole.

    `fraction` is how much of it holds, `steps` the first and the last one at which its atoms are
    looked at. A node that is not `counted` is an alternative to one that holds more.
    """

    text: str
    depth: Whole
    steps: tuple[Whole, Whole]
    fraction: Exact
    counted: bool = True

    @property
    def met(self) -> bool:
        """Whether the part holds."""
        return self.fraction == 1


@dataclass(frozen=True, slots=True)
class Depth(Record):
    """How many parts of one depth hold at their steps without any part around them holding.

    `bound` is what no plan can exceed that does as well at the depths above.
    """

    depth: Whole
    value: Whole
    bound: Whole | None = None


@dataclass(frozen=True, slots=True)
class Satisfaction(Portion):
    """How much of a mission's formula a plan satisfies, in the mission's `order`.

    `fraction` and `nodes` (parents before their children) tell how much of the whole and of each
    part holds, and `preference` how much the formula's weights prefer that, if it has any.
    `availability` is the least number of agents to spare at what is satisfied, None
    where nothing can fail. `depths` counts what holds for the orders that go by depth. What is
    still to be computed from the paths is None or empty.
    """

    order: Order
    fraction: Exact | None = None
    availability: Finite | None = None
    depths: tuple[Depth, ...] = ()
    nodes: tuple[Node, ...] = ()
    preference: Exact | None = field(default=None, metadata=OPTIONAL)

    @property
    def worth(self) -> Fraction | None:
        """What the plan gains by it."""
        return self.fraction if self.preference is None else self.preference


@dataclass(frozen=True, slots=True)
class PreferenceSatisfaction(Portion):
    """What became of one preferred formula; its parts are as in `Satisfaction`."""

    name: str
    weight: Weight
    level: Whole
    partial: bool
    fraction: Exact
    nodes: tuple[Node, ...] = ()
    preference: Exact | None = field(default=None, metadata=OPTIONAL)

    @property
    def met(self) -> bool:
        """Whether the formula holds."""
        return self.fraction == 1

    @property
    def worth(self) -> Fraction:
        """What the plan gains by it."""
        share = self.fraction if self.preference is None else self.preference
        return self.weight * (share if self.partial else Fraction(self.met))
