"""What the world was found to be at a step of a plan, and what is different from then on."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Annotated, TypeAlias

from pydantic import Field

from tsplan.limits import MOST_STEPS
from tsplan.plans.agent_plans import Stay
from tsplan.plans.records import OPTIONAL, Positive, Record, Whole, Word
from tsplan.plans.supplies import Amount

Place: TypeAlias = Word | tuple[Word, Word]
"""A state, or the two ends of an edge."""

Late: TypeAlias = Annotated[int, Field(strict=True, ge=1, le=MOST_STEPS)]


@dataclass(frozen=True, slots=True)
class OnEdge(Record):
    """Somebody is on the way from a state to another, and arrives there at a step of the plan."""

    source: Word
    target: Word
    arrives: Whole


@dataclass(frozen=True, slots=True)
class Newcomers(Record):
    """Agents of one class that join at a state, with numbers that go on where the class's end."""

    class_name: Word
    at: Word
    count: Positive = 1
    capabilities: frozenset[Word] = field(default=frozenset(), metadata=OPTIONAL)


@dataclass(frozen=True, slots=True)
class Closed(Record):
    """A state or an edge that nobody may enter any more, or not before step `until` is over."""

    place: Place
    until: Whole | None = field(default=None, metadata=OPTIONAL)


@dataclass(frozen=True, slots=True)
class Opened(Record):
    """An edge that is there from now on, or takes another duration from now on."""

    source: Word
    target: Word
    duration: Late | Mapping[Word, Late] = 1


@dataclass(frozen=True, slots=True)
class Room(Record):
    """For how many agents a state or an edge has room from now on."""

    place: Place
    capacity: Whole


@dataclass(frozen=True, slots=True)
class Ahead(Record):
    """Where an agent was to be from a step on, and where it was to be heading at the end."""

    stays: tuple[Stay, ...]
    heading: Word | None = field(default=None, metadata=OPTIONAL)


@dataclass(frozen=True, slots=True)
class World(Record):
    """What is known at step `step` of a plan: who is elsewhere than planned, and what has changed.

    Agents that are not named are where the plan has them. `lost` ones are gone for good and count
    nowhere from now on; `moved` are at another state, or on an edge; `late` ones arrive, or have
    arrived, so many steps after they should by the move that is or was their last. Of swarms, by
    their names, `numbers` say how many are at states where there are not as many as planned, and of
    resources `stocks` say how much lies at states where there is not as much. `added` agents join.

    From now on states and edges are `closed`, `opened` or have other `capacities`; the formulas
    `demanded` have to hold, judged at this step, and those `withdrawn`, by the text of a part of
    the mission, have not. `deadlines` give the last step of the outermost window of a part, by its
    text, counted as there. The rest is planned for an `objective`, if any is named, else for that
    of the mission. Where that asks for stability, `former` is what agents were to do from this
    step on that do something else now.
    """

    step: Annotated[int, Field(strict=True, ge=0, le=MOST_STEPS)]
    lost: tuple[Word, ...] = field(default=(), metadata=OPTIONAL)
    moved: Mapping[Word, Word | OnEdge] = field(default_factory=dict, metadata=OPTIONAL)
    late: Mapping[Word, Late] = field(default_factory=dict, metadata=OPTIONAL)
    numbers: Mapping[Word, Mapping[Word, Whole]] = field(default_factory=dict, metadata=OPTIONAL)
    stocks: Mapping[Word, Mapping[Word, Amount]] = field(default_factory=dict, metadata=OPTIONAL)
    added: tuple[Newcomers, ...] = field(default=(), metadata=OPTIONAL)
    closed: tuple[Closed, ...] = field(default=(), metadata=OPTIONAL)
    opened: tuple[Opened, ...] = field(default=(), metadata=OPTIONAL)
    capacities: tuple[Room, ...] = field(default=(), metadata=OPTIONAL)
    demanded: tuple[Word, ...] = field(default=(), metadata=OPTIONAL)
    withdrawn: tuple[Word, ...] = field(default=(), metadata=OPTIONAL)
    deadlines: Mapping[Word, Whole] = field(default_factory=dict, metadata=OPTIONAL)
    objective: tuple[Word, ...] = field(default=(), metadata=OPTIONAL)
    former: Mapping[Word, Ahead] = field(default_factory=dict, metadata=OPTIONAL)
