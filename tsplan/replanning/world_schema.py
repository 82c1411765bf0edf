"""The shape of a file `tsplan-world/1`: what is different at a step from what was planned.

Everything in it has the short forms that people write: places are states or pairs of states, and
what is closed for a time says until when.
"""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import BeforeValidator, Field

from tsplan.document.fields import complaint, shown
from tsplan.document.written import Written
from tsplan.limits import LARGEST, MOST_STEPS
from tsplan.mission.entry_fields import Amount, Count, Name
from tsplan.mission.mission_schema import Part
from tsplan.plans.worlds import Closed, Newcomers, OnEdge, Opened, Room, World

_Step = Annotated[int, Field(strict=True, ge=0, le=MOST_STEPS)]
_Count = Annotated[int, Field(strict=True, ge=0, le=LARGEST)]
_Steps = Annotated[int, Field(strict=True, ge=1, le=MOST_STEPS)]
_ENDS = 2


def _place(value: Any) -> Any:
    """A state, or the two ends of an edge."""
    if isinstance(value, list | tuple) and len(value) == _ENDS and all(map(_is_name, value)):
        return (str(value[0]), str(value[1]))
    if not _is_name(value):
        raise complaint(f"{shown(value)} is no place", "write a state, or an edge as in [q1, q2]")
    return str(value)


def _is_name(value: Any) -> bool:
    return isinstance(value, str | int) and not isinstance(value, bool) and value != ""


_Pair = Annotated[list[Name], Field(min_length=2, max_length=2)]
_Place = Annotated[Any, BeforeValidator(_place), Written(Name | _Pair)]


class WayEntry(Part):
    """On which edge somebody is, and when it comes to its end."""

    source: Name = Field(alias="from")
    target: Name = Field(alias="to")
    arrives: _Step


class NewcomersEntry(Part):
    """Agents that join."""

    class_name: Name = Field(alias="class")
    at: Name
    count: Count = 1
    capabilities: list[Name] = Field(default_factory=list)


class ClosedEntry(Part):
    """A place that is closed, for good or until a step is over."""

    place: _Place
    until: _Step | None = None


class OpenedEntry(Part):
    """An edge that is there from now on, or takes as long from now on."""

    source: Name = Field(alias="from")
    target: Name = Field(alias="to")
    duration: _Steps | dict[Name, _Steps] = 1


class RoomEntry(Part):
    """For how many agents a place has room."""

    place: _Place
    capacity: Annotated[int, Field(strict=True, ge=0, le=LARGEST)]


def _alone(value: Any) -> Any:
    """A place by itself is closed for good."""
    return value if isinstance(value, dict) else {"place": value}


_Closed = Annotated[ClosedEntry, BeforeValidator(_alone), Written(ClosedEntry | Name | _Pair)]


class WorldFile(Part):
    """What is different; see `tsplan.plans.worlds.World`."""

    format: Literal["tsplan-world/1"] = "tsplan-world/1"
    step: _Step | None = None
    lost: list[Name] = Field(default_factory=list)
    moved: dict[Name, WayEntry | Name] = Field(default_factory=dict)
    late: dict[Name, _Steps] = Field(default_factory=dict)
    numbers: dict[Name, dict[Name, _Count]] = Field(default_factory=dict)
    stocks: dict[Name, dict[Name, Amount]] = Field(default_factory=dict)
    added: list[NewcomersEntry] = Field(default_factory=list)
    closed: list[_Closed] = Field(default_factory=list)
    opened: list[OpenedEntry] = Field(default_factory=list)
    capacities: list[RoomEntry] = Field(default_factory=list)
    demanded: list[Name] = Field(default_factory=list)
    withdrawn: list[Name] = Field(default_factory=list)
    deadlines: dict[Name, _Step] = Field(default_factory=dict)

    def world(self, step: int) -> World:
        """The world at a step."""
        ways = {name: _way(place) for name, place in self.moved.items()}
        return World(
            step,
            lost=tuple(self.lost),
            moved=ways,
            late=self.late,
            numbers=self.numbers,
            stocks=self.stocks,
            added=tuple(
                Newcomers(each.class_name, each.at, each.count, frozenset(each.capabilities))
                for each in self.added
            ),
            closed=tuple(Closed(each.place, each.until) for each in self.closed),
            opened=tuple(Opened(each.source, each.target, each.duration) for each in self.opened),
            capacities=tuple(Room(each.place, each.capacity) for each in self.capacities),
            demanded=tuple(self.demanded),
            withdrawn=tuple(self.withdrawn),
            deadlines=self.deadlines,
        )


def _way(place: WayEntry | str) -> OnEdge | str:
    return place if isinstance(place, str) else OnEdge(place.source, place.target, place.arrives)
