"""What robots carry and tasks use: resources and where they lie at first.

Amounts lie at states and stay there without a robot. They move along edges that are no waits with
robots that enter the same edge at the same step, at most what these carry; loading and unloading
take no time. A task with resources is executed: its amounts lie at the state at that step, and are
gone afterwards, or in use until its interval ends.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from math import floor
from typing import TypeAlias

from tsplan.exact import exact
from tsplan.limits import is_number
from tsplan.words import nfc

Amounts: TypeAlias = "tuple[tuple[str, float], ...]"
"""Names, of resources or states, with an amount each."""

Carries: TypeAlias = "Amounts | float"
"""What one robot carries at most: so much of each resource, or so much of all together."""


@dataclass(frozen=True, slots=True)
class Resource:
    """Something that lies at states, is carried by robots and needed by tasks.

    `at` has the amounts at step 0 by state, and `brought` what agents that start under way bring:
    a state, a step and an amount; a mission takes these from its team. One that is `indivisible`
    comes in whole pieces; one that is not `consumed` is a tool: used, not used up.
    """

    name: str
    at: Amounts
    indivisible: bool = False
    consumed: bool = True
    brought: tuple[tuple[str, int, float], ...] = field(default=(), repr=False)

    def __post_init__(self) -> None:
        """Bring names into the form in which they are compared; name every state once."""
        object.__setattr__(self, "name", nfc(self.name))
        object.__setattr__(self, "at", merged(self.at))

    @classmethod
    def of(
        cls,
        name: str,
        at: Mapping[str, float] | Iterable[tuple[str, float]],
        *,
        indivisible: bool = False,
        consumed: bool = True,
    ) -> Resource:
        """A resource from any mapping or pairs of states and amounts.

        >>> Resource.of("brick", {"yard": 10, "depot": 4}, indivisible=True).total
        Fraction(14, 1)
        """
        pairs = at.items() if isinstance(at, Mapping) else at
        return cls(name, tuple(pairs), indivisible, consumed)

    @property
    def total(self) -> Fraction:
        """How much of it there is, exactly."""
        return sum((exact(amount) for _, _, amount in self.sources), Fraction(0))

    @property
    def sources(self) -> tuple[tuple[str, int, float], ...]:
        """Where, from which step on and how much of it there is before anybody moves any."""
        return (*((state, 0, amount) for state, amount in self.at), *self.brought)


def merged(pairs: Iterable[tuple[str, float]]) -> Amounts:
    """Every name once, in the order in which they come, amounts added up exactly."""
    given = tuple((nfc(name), amount) for name, amount in pairs)
    if not all(is_number(amount) for _, amount in given):
        return given  # the checks tell of others
    total: dict[str, Fraction] = {}
    for name, amount in given:
        total[name] = total.get(name, Fraction(0)) + exact(float(amount))
    return tuple((name, float(amount)) for name, amount in total.items())


def most_carried(carries: Carries, resource: Resource) -> Fraction:
    """How much of a resource one robot carries at most, if it carries nothing else.

    >>> brick = Resource.of("brick", {"yard": 9}, indivisible=True)
    >>> most_carried((("brick", 2.0),), brick), most_carried(3.5, brick), most_carried((), brick)
    (Fraction(2, 1), Fraction(3, 1), Fraction(0, 1))
    """
    own = compartment(carries, resource)
    if own is not None or isinstance(carries, tuple):
        return own or Fraction(0)
    room = exact(carries)
    return Fraction(floor(room)) if resource.indivisible else room


def compartment(carries: Carries, resource: Resource) -> Fraction | None:
    """How much of a resource one robot carries whatever else it carries; None for one hold."""
    if not isinstance(carries, tuple):
        return None
    room = exact(dict(carries).get(resource.name, 0.0))
    return Fraction(floor(room)) if resource.indivisible else room
