"""Parts of a formula by where they occur: equal formulas are one object, but each place is its own.

An occurrence is the way to it from the root, child by child. Only operators that are monotone in
their children are entered, so replacing any occurrence by true makes the whole formula weaker.
"""

from __future__ import annotations

from collections.abc import Container, Iterable, Iterator, Mapping
from dataclasses import replace
from typing import NamedTuple, TypeAlias

from tsplan.logic import (
    TRUE,
    Always,
    And,
    Count,
    Eventually,
    Formula,
    Limit,
    Or,
    Release,
    Task,
    Until,
    Whole,
)

Way: TypeAlias = "tuple[int, ...]"

MOST_OCCURRENCES = 100
"""Parts into which one conjunct is taken apart at most."""

_DEEPEST = 100
_MONOTONE = (And, Or, Whole, Always, Eventually, Until, Release)


class Occurrence(NamedTuple):
    """A part of a formula: the sub-formula at a way, or one need of the task or limit there.

    The amounts of resources that a task needs are counted on after its needs of agents.
    """

    way: Way
    need: int | None = None


def monotone(node: Formula) -> bool:
    """Whether a formula becomes weaker when any of its children does."""
    return isinstance(node, _MONOTONE)


def node_at(root: Formula, way: Way) -> Formula:
    """The sub-formula at the end of a way."""
    for step in way:
        root = root.children[step]
    return root


def nodes_along(root: Formula, way: Way) -> Iterator[tuple[Way, Formula]]:
    """Every sub-formula on a way, the root first, each with its own way."""
    for length in range(len(way) + 1):
        yield way[:length], node_at(root, way[:length])


def counts_of(node: Formula) -> tuple[Count, ...]:
    """The counts that an atom means at a step, one for each need; nothing for other formulas."""
    if isinstance(node, Task):
        return tuple(Count("min", node.label, name, ">=", least) for name, least in node.needs)
    if isinstance(node, Limit):
        nobody: tuple[tuple[str | None, int], ...] = ((None, 0),)
        return tuple(
            Count("max", node.label, name, "<=", most) for name, most in node.needs or nobody
        )
    return (node,) if isinstance(node, Count) else ()


def amounts_of(node: Formula) -> tuple[tuple[str, float], ...]:
    """The amounts of resources that an atom needs, by their names."""
    return node.resources if isinstance(node, Task) else ()


def separable(node: Formula) -> int:
    """How many needs of agents and resources an atom has that are parts of their own; else 0."""
    parts = len(counts_of(node)) + len(amounts_of(node))
    return parts if parts > 1 else 0


def numbered_counts(node: Formula, way: Way) -> Iterator[tuple[Occurrence, Count]]:
    """The same, each with the occurrence that it is: that of a need where there are several."""
    apart = separable(node)
    for number, count in enumerate(counts_of(node)):
        yield Occurrence(way, number if apart else None), count


def numbered_amounts(node: Formula, way: Way) -> Iterator[tuple[Occurrence, str, float]]:
    """The amounts of resources that an atom needs, each with the occurrence that it is."""
    apart, before = separable(node), len(counts_of(node))
    for number, (resource, amount) in enumerate(amounts_of(node), start=before):
        yield Occurrence(way, number if apart else None), resource, amount


def conjuncts(root: Formula) -> tuple[Way, ...]:
    """The ways to what the root demands together: `and` below `and` is one level."""
    found: list[Way] = []
    open_: list[tuple[Way, Formula]] = [((), root)]
    while open_:
        way, node = open_.pop()
        if isinstance(node, And) and len(way) < _DEEPEST:
            open_ += ((((*way, n), child)) for n, child in reversed([*enumerate(node.children)]))
        else:
            found.append(way)
    return tuple(found)


def occurrences(root: Formula, way: Way) -> tuple[Occurrence, ...]:
    """What the sub-formula at `way` consists of, in the order of the text, so many at most."""
    parts = [Occurrence(way)]
    place = 0
    while place < len(parts):
        smaller = _smaller(root, parts[place])
        if smaller and len(parts) + len(smaller) - 1 <= MOST_OCCURRENCES:
            parts[place : place + 1] = smaller
        else:
            place += 1
    return tuple(parts)


def _smaller(root: Formula, part: Occurrence) -> list[Occurrence]:
    """What a part consists of; nothing if it cannot be taken apart."""
    if part.need is not None or len(part.way) >= _DEEPEST:
        return []
    node = node_at(root, part.way)
    if monotone(node):
        return [Occurrence((*part.way, number)) for number in range(len(node.children))]
    return [Occurrence(part.way, number) for number in range(separable(node))]


def without(root: Formula, dropped: Iterable[Occurrence]) -> Formula:
    """The formula that no longer demands some of its parts.

    A task with resources that is written twice is executed once where both may be, so it asks for
    less only where it does so wherever it is written: else it would be two tasks, and paid twice.
    """
    needs: dict[Way, set[int | None]] = {}
    for part in dropped:
        needs.setdefault(part.way, set()).add(part.need)
    paid = {node for way in needs if amounts_of(node := node_at(root, way))}
    places: dict[Formula, list[Way]] = {}
    for way in _ways_to(root, paid) if paid else ():
        if not any(None in needs.get(way[:length], ()) for length in range(len(way) + 1)):
            places.setdefault(node_at(root, way), []).append(way)
    for ways in places.values():
        common = set.intersection(*(needs.get(way, set()) for way in ways))
        needs |= dict.fromkeys(ways, common)
    return exchanged(
        root, {way: _rest(node_at(root, way), gone) for way, gone in needs.items() if gone}
    )


def _ways_to(root: Formula, wanted: Container[Formula]) -> Iterator[Way]:
    """The ways to everything that is one of some formulas."""
    open_: list[tuple[Way, Formula]] = [((), root)]
    while open_:
        way, node = open_.pop()
        if node in wanted:
            yield way
        open_ += (((*way, number), child) for number, child in enumerate(node.children))


def _rest(node: Formula, gone: set[int | None]) -> Formula:
    """What is left of a node without some of its needs (None: without all of it)."""
    if None in gone or not isinstance(node, Task | Limit):
        return TRUE
    kept = tuple(pair for number, pair in enumerate(node.needs) if number not in gone)
    if isinstance(node, Limit):
        return replace(node, needs=kept) if kept else TRUE
    counted = enumerate(node.resources, start=len(node.needs))
    amounts = tuple(pair for number, pair in counted if number not in gone)
    return replace(node, needs=kept, resources=amounts) if kept or amounts else TRUE


def exchanged(root: Formula, changes: Mapping[Way, Formula]) -> Formula:
    """The formula with other sub-formulas at some ways; a change above another one wins."""
    if () in changes:
        return changes[()]
    if not changes:
        return root
    below: dict[int, dict[Way, Formula]] = {}
    for way, new in changes.items():
        below.setdefault(way[0], {})[way[1:]] = new
    children = list(root.children)
    for number, inner in below.items():
        children[number] = exchanged(children[number], inner)
    return root.over(children)
