"""What worlds say, in words."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from tsplan.plans.worlds import OnEdge
from tsplan.words import many, number

if TYPE_CHECKING:
    from tsplan.plans.worlds import Opened, Place, World

_SHOWN = 4  # of one kind that are named


def world_line(world: World) -> str:
    """When it was planned again, and for what.

    >>> from tsplan.plans.worlds import World
    >>> world_line(World(12, lost=("scout-2",), late={"heavy-1": 3}))
    'planned again at step 12: scout-2 lost; heavy-1 3 steps late'
    """
    said = "; ".join(_said(world))
    return f"planned again at step {world.step}{f': {said}' if said else ''}"


def _said(world: World) -> Iterator[str]:
    yield from _some((f"{name} lost" for name in world.lost), len(world.lost))
    yield from _some((f"{n} {_moved(at)}" for n, at in world.moved.items()), len(world.moved))
    late = (f"{name} {many(steps, 'step')} late" for name, steps in world.late.items())
    yield from _some(late, len(world.late))
    yield from (
        f"{count} of {swarm} at {state}"
        for swarm, numbers in world.numbers.items()
        for state, count in numbers.items()
    )
    yield from (
        f"{number(amount)} {name} at {state}"
        for name, amounts in world.stocks.items()
        for state, amount in amounts.items()
    )
    yield from (f"{g.count} {g.class_name} more at {g.at}" for g in world.added)
    closed = (
        f"{place_words(each.place)} closed{'' if each.until is None else f' until {each.until}'}"
        for each in world.closed
    )
    yield from _some(closed, len(world.closed))
    yield from _some((_opened(each) for each in world.opened), len(world.opened))
    rooms = (f"room for {each.capacity} {_where(each.place)}" for each in world.capacities)
    yield from _some(rooms, len(world.capacities))
    yield from (f"demanded {text}" for text in world.demanded)
    yield from (f"withdrawn {text}" for text in world.withdrawn)
    yield from (f"until {step}: {text}" for text, step in world.deadlines.items())


def _some(words: Iterator[str], count: int) -> Iterator[str]:
    """The first of several, and how many more there are."""
    yield from (word for word, _ in zip(words, range(_SHOWN), strict=False))
    if count > _SHOWN:
        yield f"and {count - _SHOWN} more"


def place_words(place: Place) -> str:
    """A state, or an edge by its ends."""
    return place if isinstance(place, str) else f"{place[0]} to {place[1]}"


def _where(place: Place) -> str:
    return f"at {place}" if isinstance(place, str) else f"on {place_words(place)}"


def _moved(place: str | OnEdge) -> str:
    if isinstance(place, OnEdge):
        return f"between {place.source} and {place.target} until {place.arrives}"
    return f"at {place}"


def _opened(edge: Opened) -> str:
    steps = edge.duration
    lasts = "other durations" if isinstance(steps, Mapping) else many(steps, "step")
    return f"{edge.source} to {edge.target} open, {lasts}"
