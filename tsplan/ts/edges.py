"""What a transition system is made of: states, edges, and durations that differ by class."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any, TypeAlias

from tsplan.ts.closures import Closed, spans
from tsplan.words import nfc

NOTHING: frozenset[str] = frozenset()

RISKS = 1_000_000
"""Parts of a unit in which risks are told apart, so that their sums are exact."""

# the key of a per-class mapping that stands for every class it does not list
DEFAULT = "default"


Pair: TypeAlias = tuple[str, str]
"""The names of both ends of an edge."""


class ByClass(Mapping[str, int]):
    """A frozen mapping from class names to whole numbers; the key `default` covers the others.

    >>> durations = ByClass({"heavy": 3, "default": 1})
    >>> durations.of("heavy"), durations.of("scout"), ByClass({"heavy": 3}).of("scout")
    (3, 1, None)
    """

    __slots__ = ("_entries",)

    def __init__(self, entries: Mapping[str, int] | Iterable[tuple[str, int]]) -> None:
        self._entries = {_spelled(name): value for name, value in dict(entries).items()}

    def __getitem__(self, class_name: str) -> int:
        return self._entries[class_name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._entries)

    def __len__(self) -> int:
        return len(self._entries)

    def __hash__(self) -> int:
        return hash(frozenset(self._entries.items()))

    def __eq__(self, other: object) -> bool:
        if isinstance(other, ByClass):
            return self._entries == other._entries
        return NotImplemented

    def __repr__(self) -> str:
        return f"ByClass({self._entries!r})"

    def of(self, class_name: str) -> int | None:
        """The number of a class, else the default, else None."""
        return self._entries.get(class_name, self._entries.get(DEFAULT))


Duration: TypeAlias = int | Mapping[str, int]


@dataclass(frozen=True, slots=True)
class State:
    """A place where agents can be.

    `at` and `shape` (a polygon) are coordinates for drawing, in any unit; `level` is the storey
    they are of. `capacity` bounds the agents here at each step, and `zone` names the zone of the
    map whose capacity this state shares. Only agents with all capabilities of `needs` may be here.
    Nobody may be here at the steps of the spans `closed`, such as `((4, 9),)`.
    `origin` is what the state is called in the file that its map was converted from.
    """

    name: str
    labels: frozenset[str] = NOTHING
    at: tuple[float, float] | None = None
    shape: tuple[tuple[float, float], ...] | None = None
    color: str | None = None
    capacity: int | None = None
    needs: frozenset[str] = NOTHING
    zone: str | None = None
    level: str | None = None
    origin: str | int | None = None
    closed: Closed = ()

    def __post_init__(self) -> None:
        """Freeze what was given as another collection; a single word is one label."""
        object.__setattr__(self, "name", _spelled(self.name))
        for word in ("color", "zone", "level", "origin"):
            if getattr(self, word) is not None:
                object.__setattr__(self, word, _spelled(getattr(self, word)))
        if self.labels is not NOTHING:
            object.__setattr__(self, "labels", words(self.labels))
        if self.needs is not NOTHING:
            object.__setattr__(self, "needs", words(self.needs))
        if self.closed != ():
            object.__setattr__(self, "closed", spans(self.closed))


@dataclass(frozen=True, slots=True)
class Edge:
    """A move from one state to another, or a wait where both are the same.

    An agent that enters the edge at step k arrives at step k + duration and is at no state in
    between. `cost` is per use; without it, a move costs its duration and a wait nothing.
    `capacity` bounds the agents that have entered and not yet arrived. The two directions of an
    edge written `both_ways` share that capacity. Or the edge shares the capacity of the map's
    `zone` of that name. Only agents with all of `needs` may use it.
    `success` is how likely an agent that enters arrives, above 0 and at most 1. Nobody may be on
    the edge at the steps of the spans `closed`, from entering on until the step before arriving.
    """

    source: str
    target: str
    duration: Duration = 1
    cost: float | None = None
    capacity: int | None = None
    needs: frozenset[str] = NOTHING
    both_ways: bool = False
    success: float = 1.0
    zone: str | None = None
    closed: Closed = ()

    def __post_init__(self) -> None:
        """Freeze what was given as another collection."""
        if self.closed != ():
            object.__setattr__(self, "closed", spans(self.closed))
        if self.zone is not None:
            object.__setattr__(self, "zone", _spelled(self.zone))
        object.__setattr__(self, "source", _spelled(self.source))
        object.__setattr__(self, "target", _spelled(self.target))
        if type(self.duration) is not int and isinstance(self.duration, Mapping):
            object.__setattr__(self, "duration", ByClass(self.duration))
        if self.needs is not NOTHING:
            object.__setattr__(self, "needs", words(self.needs))

    @property
    def pair(self) -> Pair:
        """The names of both ends, by which a transition system finds the edge."""
        return self.source, self.target

    @property
    def is_wait(self) -> bool:
        """Whether the edge leads back to where it starts."""
        return self.source == self.target

    def duration_for(self, class_name: str) -> int | None:
        """Steps that a class needs for this edge; None where the class cannot use it."""
        if isinstance(self.duration, ByClass):
            return self.duration.of(class_name)
        assert isinstance(self.duration, int)
        return self.duration

    def cost_for(self, class_name: str) -> float:
        """Cost of one use by a class; infinite where the class cannot use the edge."""
        if self.cost is not None:
            return self.cost
        if self.is_wait:
            return 0.0
        duration = self.duration_for(class_name)
        return math.inf if duration is None else float(duration)

    @property
    def risk(self) -> Fraction:
        """-log(success) in millionths: summed over moves, the less the more likely all succeed.

        >>> Edge("a", "b", success=0.98).risk
        Fraction(20203, 1000000)
        """
        return Fraction(round(-math.log(self.success) * RISKS), RISKS)

    def shortest(self) -> int | None:
        """Steps that the quickest class needs; None where the edge lists no class at all."""
        if isinstance(self.duration, Mapping):
            return min(self.duration.values(), default=None)
        return self.duration

    def reverse(self) -> Edge:
        """The same edge in the other direction."""
        return replace(self, source=self.target, target=self.source)


def missing_waits(states: Iterable[State], edges: Iterable[Edge]) -> list[Edge]:
    """A wait of one step for every state that has none."""
    waiting = {edge.source for edge in edges if edge.is_wait}
    return [Edge(state.name, state.name) for state in states if state.name not in waiting]


def words(given: Iterable[str]) -> frozenset[str]:
    """A set of words, in the form in which names are compared; one string is one word."""
    return frozenset(map(_spelled, (given,) if isinstance(given, str) else given))


def _spelled(name: Any) -> Any:
    """A name in the form in which names are compared; what is no text is left to the checks."""
    return nfc(name) if isinstance(name, str) else name
