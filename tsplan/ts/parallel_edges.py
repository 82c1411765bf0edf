"""Several edges from one state to another: which one stands for them, and what that loses."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

from tsplan.limits import is_number
from tsplan.ts.edges import DEFAULT, Edge, Pair
from tsplan.words import many


class Choice(NamedTuple):
    """The number of the edge that is kept, and those that are not.

    Nothing is lost (`whole`) where no agent could do better by one of the others.
    """

    kept: int
    dropped: tuple[int, ...]
    whole: bool

    def words(self, edges: Sequence[Edge]) -> tuple[str, str]:
        """What is said of the choice, and what to do about it where something is lost."""
        edge = edges[self.kept]
        more = f"{many(len(self.dropped), 'more edge')} from '{edge.source}' to '{edge.target}'"
        if self.whole:
            return f"{more} can do nothing better than the one that is kept", ""
        steps = many(edge.shortest() or 0, "step")
        what = f"{more} may cost less or be open to more: only the quickest ({steps}) is kept"
        return what, "put a node on the way where both matter"


def choices(edges: Sequence[Edge]) -> Iterator[Choice]:
    """One choice for each pair of states between which there are several edges.

    None where one of them is no edge that could be compared.
    """
    between: dict[Pair, list[int]] = {}
    for number, edge in enumerate(edges):
        between.setdefault(edge.pair, []).append(number)
    for numbers in between.values():
        if len(numbers) > 1 and all(_comparable(edges[number]) for number in numbers):
            kept = min(numbers, key=lambda number: (_slowest(edges[number]), number))
            others = tuple(number for number in numbers if number != kept)
            whole = all(_as_good(edges[kept], edges[other]) for other in others)
            yield Choice(kept, others, whole)


def chosen(edges: Sequence[Edge], made: Sequence[Choice]) -> dict[int, Edge]:
    """The edges that are kept, by their numbers.

    One whose reverse is no longer the same edge does not go both ways any more.
    """
    gone = {number for choice in made for number in choice.dropped}
    left = {number: edge for number, edge in enumerate(edges) if number not in gone}
    known = {edge.pair: edge for edge in left.values()}
    return {
        number: edge
        if not edge.both_ways or known.get(edge.pair[::-1]) == edge.reverse()
        else replace(edge, both_ways=False)
        for number, edge in left.items()
    }


def _comparable(edge: Edge) -> bool:
    steps = edge.duration.values() if isinstance(edge.duration, Mapping) else [edge.duration]
    others = [number for number in (edge.cost, edge.capacity) if number is not None]
    return all(type(each) is int for each in steps) and all(map(is_number, [*others, edge.success]))


def _classes(*edges: Edge) -> set[str]:
    durations = [edge.duration for edge in edges if isinstance(edge.duration, Mapping)]
    return {DEFAULT, *(name for duration in durations for name in duration)}


def _slowest(edge: Edge) -> tuple[float, float]:
    """The steps of the slowest class, then the cost: less is better."""
    names = _classes(edge)
    steps = [edge.duration_for(name) for name in names]
    return max(math.inf if each is None else each for each in steps), edge.cost_for(DEFAULT)


def _as_good(one: Edge, other: Edge) -> bool:
    """Whether whoever can take the other edge does as well by this one."""
    for name in _classes(one, other):
        steps, theirs = one.duration_for(name), other.duration_for(name)
        if theirs is not None and (steps is None or steps > theirs):
            return False
        if theirs is not None and one.cost_for(name) > other.cost_for(name):
            return False
    free = one.capacity is None and one.zone is None and not one.closed
    return free and one.needs <= other.needs and one.success >= other.success
