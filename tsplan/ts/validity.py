"""What makes states and edges a transition system, checked all at once."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any, Literal, NamedTuple, TypeAlias

from tsplan.errors import Finding, Nearest
from tsplan.limits import LARGEST, MOST_COST, MOST_STEPS, clipped, is_number
from tsplan.ts.closures import is_span
from tsplan.ts.edges import Edge, Pair, State

# the fewest corners of a shape
CORNERS = 3


@dataclass(frozen=True, slots=True)
class Problem:
    """One thing wrong with the state, edge or zone number `index` of what was given.

    `part` is the field that is wrong, or None for the whole. `first` is the number of the earlier
    one that a repetition repeats.
    """

    kind: Literal["system", "state", "edge", "zone"]
    index: int
    part: str | None
    message: str
    remedy: str
    first: int | None = None

    def finding(self) -> Finding:
        """The problem without a place, as for systems built in Python."""
        return Finding(self.message, self.remedy)


class Fault(NamedTuple):
    """What a value is that it should not be, and what to do about it."""

    what: str
    remedy: str


_NO_ZONES: Mapping[str, int] = MappingProxyType({})

_Flaw: TypeAlias = tuple[str | None, str, str]
"""The field that is wrong, what is wrong with it, and the remedy."""


def problems(
    states: Sequence[State], edges: Sequence[Edge], zones: Mapping[str, int] = _NO_ZONES
) -> Iterator[Problem]:
    """Everything that keeps these states and edges from being a transition system.

    `zones` are the capacities of its zones by their names.
    """
    if not states:
        yield Problem("system", 0, "states", "the map has no states", "add at least one state")
    seen: dict[str, int] = {}
    for index, state in enumerate(states):
        for flaw in _state(state):
            yield Problem("state", index, *flaw)
        if seen.setdefault(state.name, index) != index:
            message = f"the state '{state.name}' is defined twice"
            yield Problem("state", index, None, message, "keep one of them", seen[state.name])
    yield from _edges(edges, seen)
    yield from _zones(states, edges, zones)


def _zones(
    states: Sequence[State], edges: Sequence[Edge], zones: Mapping[str, int]
) -> Iterator[Problem]:
    """Capacities of zones that are none, and zones that are named and not there."""
    for index, capacity in enumerate(zones.values()):
        for flaw in _capacity(capacity):
            yield Problem("zone", index, *flaw)
    closest = Nearest(map(str, zones))
    members: list[tuple[Literal["state", "edge"], int, State | Edge]]
    members = [("state", index, state) for index, state in enumerate(states)]
    members += [("edge", index, edge) for index, edge in enumerate(edges)]
    for kind, index, member in members:
        if member.zone is None:
            continue
        if member.zone not in zones:
            remedy = closest(str(member.zone)) if zones else "add 'zones: {name: capacity}'"
            yield Problem(kind, index, "zone", f"the map has no zone '{member.zone}'", remedy)
        elif isinstance(member, Edge) and member.capacity is not None:
            message = "an edge in a zone has a capacity of its own"
            yield Problem(kind, index, "capacity", message, "keep the zone or the capacity")


def _edges(edges: Sequence[Edge], names: Collection[str]) -> Iterator[Problem]:
    known: dict[Pair, int] = {}
    closest = Nearest(map(str, names))
    repeated: set[Pair] = set()
    for index, edge in enumerate(edges):
        for part, name in (("source", edge.source), ("target", edge.target)):
            if name not in names and names:
                message = f"no state is called '{name}'"
                yield Problem("edge", index, part, message, closest(str(name)))
        for flaw in _edge(edge):
            yield Problem("edge", index, *flaw)
        if known.setdefault(edge.pair, index) != index:
            message = f"a second edge leads from '{edge.source}' to '{edge.target}'"
            remedy = "keep one, or put a state between"
            yield Problem("edge", index, None, message, remedy, known[edge.pair])
            repeated.add(edge.pair)
    for index, edge in enumerate(edges):
        back = (edge.target, edge.source)
        if edge.both_ways and (edge.is_wait or back not in repeated):
            other = edges[known[back]] if back in known else None
            for flaw in _both_ways(edge, other):
                yield Problem("edge", index, *flaw)


def _both_ways(edge: Edge, back: Edge | None) -> Iterator[_Flaw]:
    """An edge of both directions needs its reverse, equal to it in everything else."""
    if edge.is_wait:
        message = f"the edge from '{edge.source}' to itself cannot go both ways"
        yield "both_ways", message, "drop both_ways"
    elif back is None or back != edge.reverse():
        message = f"the edge from '{edge.source}' to '{edge.target}' lacks its equal reverse"
        yield "both_ways", message, "add edge.reverse(), or drop both_ways"


def _state(state: State) -> Iterator[_Flaw]:
    if not isinstance(state.name, str) or not state.name:
        message = f"{state.name!r} cannot be the name of a state"
        yield "name", message, "use text of at least one character"
    if state.at is not None and not is_point(state.at):
        yield "at", f"at: {_told(state.at)} is not a pair of finite numbers", "write it as [x, y]"
    if state.shape is not None and not _is_polygon(state.shape):
        message = f"shape: not {CORNERS} or more pairs of finite numbers"
        yield "shape", message, "write it as [[x, y], [x, y], [x, y]]"
    yield from _capacity(state.capacity)
    yield from _closed(state.closed)


def _edge(edge: Edge) -> Iterator[_Flaw]:
    by_class = edge.duration if isinstance(edge.duration, Mapping) else {None: edge.duration}
    if not by_class:
        message = "duration: no class is listed, so nobody can use this edge"
        yield "duration", message, "list a class, or drop the edge"
    for class_name, value in by_class.items():
        fault = steps_fault(value)
        if fault is not None:
            whose = "" if class_name is None else f" for '{class_name}'"
            yield "duration", f"duration: {_told(value)}{whose} is {fault.what}", fault.remedy
    cost: Any = edge.cost
    if cost is not None and (not is_number(cost) or cost < 0):
        message = f"cost: {_told(cost)} is not a finite number of at least 0"
        yield "cost", message, "write a number such as 2.5"
    elif cost is not None and cost >= MOST_COST:
        message = (
            f"cost: {float(cost):g} is not below {MOST_COST:g}, which solvers take for infinity"
        )
        yield "cost", message, "write a number such as 2.5"
    success: Any = edge.success
    if not is_number(success) or not 0 < success <= 1:
        message = f"success: {success} is no probability above 0"
        yield "success", message, "write how likely the move succeeds, such as 0.98"
    yield from _capacity(edge.capacity)
    yield from _closed(edge.closed)


def _closed(value: Any) -> Iterator[_Flaw]:
    """Spans of steps that are none."""
    for span in value if isinstance(value, tuple) else (value,):
        shown = list(span) if isinstance(span, tuple) else _told(span)
        if not is_span(span):
            message = f"closed: {shown} is not a first and a last step"
            yield "closed", message, "write whole numbers from 0 on, as in [[4, 9]]"
        elif span[1] > MOST_STEPS:
            message = f"closed: {shown} ends after {MOST_STEPS:,} steps"
            yield "closed", message, f"write at most {MOST_STEPS}"


def steps_fault(value: Any) -> Fault | None:
    """What keeps a value from being a duration; None if nothing does."""
    if type(value) is not int or value < 1:
        remedy = "durations are whole numbers of steps, at least 1"
        return Fault("not a whole number from 1 on", remedy)
    if value > MOST_STEPS:
        return Fault(f"more than {MOST_STEPS:,} steps", "write a shorter one")
    return None


def _told(value: Any) -> str:
    """A value in a message; a text as it stands in the file."""
    return value if isinstance(value, str) else clipped(value)


def _capacity(value: Any) -> Iterator[_Flaw]:
    if value is not None and (type(value) is not int or value < 0):
        message = f"capacity: {_told(value)} is not a whole number of at least 0"
        yield "capacity", message, "write how many agents fit, as in 2"
    elif value is not None and value > LARGEST:
        size = f"{value:.3e}" if is_number(value) else "a number of hundreds of digits"
        message = f"capacity: {size} is more than {LARGEST:,}"
        yield "capacity", message, "leave it out where all agents fit"


def is_point(value: Any) -> bool:
    """Whether a value is a pair of finite numbers."""
    return isinstance(value, tuple) and len(value) == 2 and all(map(is_number, value))  # noqa: PLR2004 - x and y


def _is_polygon(value: Any) -> bool:
    return isinstance(value, tuple) and len(value) >= CORNERS and all(map(is_point, value))
