"""Who acts: robots in groups, and the swarms among their classes."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction
from math import ceil
from numbers import Integral
from types import MappingProxyType
from typing import Any, NamedTuple, TypeVar

from tsplan.exact import exact
from tsplan.limits import is_number
from tsplan.mission.resources import Carries, Resource, merged
from tsplan.name_runs import Run
from tsplan.words import nfc

ONE_SWARM = "swarm"
"""The class of a swarm that has no name of its own."""


@dataclass(frozen=True, slots=True, order=True)
class UnderWay:
    """A start on an edge: the agent left `origin` before, and comes to `target` at step `arrives`.

    Until then it is nowhere, and uses what room the edge has; it cannot turn. `carrying` is what
    each such agent brings of each resource. Modules that come from the state where they arrive are
    being rebuilt there, and are of their configuration then.

    >>> UnderWay("q1", "q2", arrives=3)
    UnderWay(origin='q1', target='q2', arrives=3)
    """

    origin: str
    target: str
    arrives: int
    carrying: tuple[tuple[str, float], ...] = field(default=(), repr=False)

    def __post_init__(self) -> None:
        """Bring names into the form in which they are compared."""
        object.__setattr__(self, "origin", nfc(self.origin))
        object.__setattr__(self, "target", nfc(self.target))
        object.__setattr__(self, "arrives", _whole(self.arrives))
        object.__setattr__(self, "carrying", merged(self.carrying))

    @property
    def place(self) -> str:
        """A name of the start that no state has, different for each edge and step of arrival."""
        load = "".join(f" with {amount:g} {name}" for name, amount in self.carrying)
        return f"{self.origin} to {self.target} until {self.arrives}{load}\0"

    @property
    def label(self) -> str:
        """The start as a short text."""
        return f"{self.origin} to {self.target} at {self.arrives}"

    @property
    def words(self) -> str:
        """The start in a sentence."""
        return f"on the way from '{self.origin}' to '{self.target}'"


class Agent(NamedTuple):
    """One robot of the team, before it has a path; `start` is a state, or how it is under way."""

    id: str
    class_name: str
    capabilities: frozenset[str]
    start: str | UnderWay


class Rank(NamedTuple):
    """Robots of one group that start at one state or under way, numbered one after the other.

    `group` is the place of their group in the team, and `names` are their ids.
    """

    names: Run
    class_name: str
    capabilities: frozenset[str]
    start: str | UnderWay
    group: int

    @property
    def place(self) -> str:
        """Where they start, by a name."""
        return self.start.place if isinstance(self.start, UnderWay) else self.start

    @property
    def agents(self) -> Iterator[Agent]:
        """The robots one by one."""
        return (Agent(name, *self[1:4]) for name in self.names.names())


@dataclass(frozen=True, slots=True)
class Group:
    """Robots of one class with the same capabilities: how many of them start at which state.

    `coming` are those that start under way. `carries` is what each of them carries at most: so much
    of each resource, or so much of all together. Modules of modular robots start in structures of a
    `configuration`.
    """

    class_name: str
    capabilities: frozenset[str]
    starts: tuple[tuple[str, int], ...]
    carries: Carries = field(default=(), repr=False)
    configuration: str | None = field(default=None, repr=False)
    coming: tuple[tuple[UnderWay, int], ...] = field(default=(), repr=False)

    def __post_init__(self) -> None:
        """Bring names into the form in which they are compared; name every start once."""
        object.__setattr__(self, "class_name", nfc(self.class_name))
        object.__setattr__(self, "capabilities", frozenset(map(nfc, self.capabilities)))
        object.__setattr__(self, "starts", _summed((nfc(s), n) for s, n in self.starts))
        object.__setattr__(self, "coming", _summed(self.coming))
        if isinstance(self.carries, tuple):
            object.__setattr__(self, "carries", merged(self.carries))
        if self.configuration is not None:
            object.__setattr__(self, "configuration", nfc(self.configuration))

    @property
    def all_starts(self) -> tuple[tuple[str | UnderWay, int], ...]:
        """Where they start, at states and under way, and how many."""
        return (*self.starts, *self.coming)

    @property
    def begins(self) -> tuple[tuple[str, int, int], ...]:
        """The states where robots of the group are first, the step, and how many."""
        coming = ((start.target, start.arrives, count) for start, count in self.coming)
        return (*((state, 0, count) for state, count in self.starts), *coming)

    @property
    def count(self) -> int:
        """How many robots the group has."""
        return sum(count for _, count in self.all_starts)

    @classmethod
    def of(
        cls,
        class_name: str,
        starts: Mapping[Any, int] | Iterable[tuple[str | UnderWay, int]],
        capabilities: Iterable[str] = (),
        carries: Mapping[str, float] | float = MappingProxyType({}),
        configuration: str | None = None,
    ) -> Group:
        """A group from any mapping or pairs of starts and counts.

        A start is a state, or an UnderWay for robots that are on an edge.
        What each robot carries is an amount of each resource, or one number for all together. Of
        modules, which are counted one by one, the `configuration` is that of their structures.

        >>> Group.of("scout", {"q1": 3}, ["Vis"]).count
        3
        >>> Group.of("scout", {"q1": 3, UnderWay("q1", "q2", 2): 1}).count
        4
        """
        pairs = tuple(starts.items() if isinstance(starts, Mapping) else starts)
        there = tuple((start, count) for start, count in pairs if not isinstance(start, UnderWay))
        coming = tuple((start, count) for start, count in pairs if isinstance(start, UnderWay))
        load = tuple(carries.items()) if isinstance(carries, Mapping) else carries
        return cls(class_name, frozenset(capabilities), there, load, configuration, coming)


_Start = TypeVar("_Start", str, UnderWay)


def _summed(starts: Iterable[tuple[_Start, Any]]) -> tuple[tuple[_Start, Any], ...]:
    """Starts of which each is named once, with all that start there."""
    pairs = tuple((start, _whole(count)) for start, count in starts)
    if not all(type(count) is int for _, count in pairs):
        return pairs  # the checks tell of them
    total: Counter[_Start] = Counter()
    for start, count in pairs:
        total[start] += count
    return tuple(total.items())


def with_brought(
    resources: Iterable[Resource], team: Iterable[Group], modules: Mapping[str, Any]
) -> tuple[Resource, ...]:
    """The resources with what agents of a team that start under way bring of each.

    Structures bring something, which are made of so many `modules` by their configurations.
    """
    ways = [
        (start, count // size if type(count) is int else count)
        for group in team
        for size in [modules.get(group.configuration or "", 1)]
        for start, count in group.coming
    ]
    return tuple(
        replace(
            item,
            brought=tuple(
                (start.target, start.arrives, float(exact(amount) * count))
                for start, count in ways
                for name, amount in start.carrying
                if name == item.name and amount and is_number(amount) and type(count) is int
            ),
        )
        for item in resources
    )


def _whole(value: Any) -> Any:
    """A whole number of any kind as Python's own; what is none is left to the checks."""
    return int(value) if isinstance(value, Integral) and not isinstance(value, bool) else value


@dataclass(frozen=True, slots=True)
class SwarmBounds:
    """How a swarm may divide: at most `most` sub-swarms (None: any number) of `least` or more."""

    most: int | None = None
    least: int = 1


@dataclass(frozen=True)
class SwarmRules:
    """What makes classes of the team swarms, each of which moves as sub-swarms.

    `each` has the bounds of every swarm by its class name; other classes are ordinary robots.
    `together` bounds the sub-swarms of all swarms at one step, and `margin` is the head-room by
    which the counts of a plan are kept away from what the formula needs: a Fraction is one of the
    agents that are counted, a whole number is of agents. `Mission.goal` is tightened by it already.
    """

    each: Mapping[str, SwarmBounds] = field(hash=False)
    together: int | None = None
    margin: Fraction | int = Fraction(0)

    def __post_init__(self) -> None:
        """Bring names into the form in which they are compared."""
        object.__setattr__(self, "each", {nfc(name): item for name, item in self.each.items()})

    def spare(self, agents: int) -> int:
        """The head-room, in agents, of a demand on a swarm of so many `agents`.

        >>> SwarmRules({}, margin=Fraction(1, 20)).spare(130)
        7
        """
        return _spare(self.margin, agents)


@dataclass(frozen=True, slots=True)
class Expectation:
    """What is asked of policies, where moves are uncertain and expected numbers are planned.

    With a `deterministic` policy all agents of a class take one action at a state and step. The
    `margin` is head-room of expected numbers, as that of swarms is of numbers.
    """

    deterministic: bool = False
    margin: Fraction | int = Fraction(0)

    def spare(self, agents: int) -> int:
        """The head-room, in agents, of a demand on so many `agents`."""
        return _spare(self.margin, agents)


def _spare(margin: Fraction | int, agents: int) -> int:
    return margin if isinstance(margin, int) else ceil(margin * agents)
