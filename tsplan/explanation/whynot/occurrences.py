"""Sub-formulas by where they occur: equal formulas are one object, but each place is its own.

An occurrence is the way to it from the root, child by child. Only operators that are monotone in
their children are entered, so replacing any occurrence by true makes the whole formula weaker.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from typing import NamedTuple, TypeAlias

from tsplan.logic import (
    TRUE,
    Always,
    And,
    Eventually,
    Formula,
    Limit,
    Or,
    Release,
    Task,
    Until,
)

Way: TypeAlias = "tuple[int, ...]"

MOST_LEAVES = 100
"""Leaves into which one conjunct is taken apart at most."""

_DEEPEST = 100
_MONOTONE = (And, Or, Always, Eventually, Until, Release)


class Leaf(NamedTuple):
    """A part that is not taken apart further: a sub-formula, or one need of a task or limit."""

    way: Way
    pair: int | None = None


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


def leaves(root: Formula, way: Way) -> tuple[Leaf, ...]:
    """The parts of the sub-formula at `way`, in the order of the text, `MOST_LEAVES` at most."""
    parts = [Leaf(way)]
    place = 0
    while place < len(parts):
        smaller = _smaller(root, parts[place])
        if smaller and len(parts) + len(smaller) - 1 <= MOST_LEAVES:
            parts[place : place + 1] = smaller
        else:
            place += 1
    return tuple(parts)


def _smaller(root: Formula, leaf: Leaf) -> list[Leaf]:
    """What a leaf consists of; nothing if it cannot be taken apart."""
    if leaf.pair is not None or len(leaf.way) >= _DEEPEST:
        return []
    node = node_at(root, leaf.way)
    if monotone(node):
        return [Leaf((*leaf.way, number)) for number in range(len(node.children))]
    if isinstance(node, Task | Limit) and len(node.needs) > 1:
        return [Leaf(leaf.way, number) for number in range(len(node.needs))]
    return []


def without(root: Formula, dropped: Iterable[Leaf]) -> Formula:
    """The formula that no longer demands some leaves."""
    pairs: dict[Way, set[int | None]] = {}
    for leaf in dropped:
        pairs.setdefault(leaf.way, set()).add(leaf.pair)
    return exchanged(root, {way: _rest(node_at(root, way), gone) for way, gone in pairs.items()})


def _rest(node: Formula, gone: set[int | None]) -> Formula:
    """What is left of a node without some of its needs (None: without all of it)."""
    if None in gone or not isinstance(node, Task | Limit):
        return TRUE
    kept = tuple(pair for number, pair in enumerate(node.needs) if number not in gone)
    return replace(node, needs=kept) if kept else TRUE


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
