"""The sub-swarms of a plan: when they exist, where and how large, and what becomes of them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Self

from pydantic import model_validator

from tsplan.plans.moves import Durations, Move, Node, arriving, leaving, present
from tsplan.plans.records import OPTIONAL, Positive, Record, Whole, Word


@dataclass(frozen=True, slots=True)
class SubSwarm(Record):
    """Agents of one swarm that are at one place at every step `first`..`last`, both included.

    The place is a `state`, or an `edge` (its two ends) that all of them entered at step
    `first - 1`. `parents` and `children` are the ids of the sub-swarms they come from and become.
    """

    id: Word
    swarm: Word
    first: Whole
    last: Whole
    size: Positive
    state: Word | None = field(default=None, metadata=OPTIONAL)
    edge: tuple[Word, Word] | None = field(default=None, metadata=OPTIONAL)
    parents: tuple[Word, ...] = ()
    children: tuple[Word, ...] = ()

    @model_validator(mode="after")
    def _somewhere(self) -> Self:
        """One place, and steps that are in order; asked of what a file says alone."""
        if (self.state is None) == (self.edge is None):
            raise ValueError("a sub-swarm is at a state or on an edge, one of both")
        if self.last < self.first:
            raise ValueError(f"the steps {self.first} to {self.last} are out of order")
        return self

    @property
    def place(self) -> str:
        """Where the sub-swarm is, in words."""
        if self.edge is not None:
            return f"on the way from {self.edge[0]} to {self.edge[1]}"
        return f"at {self.state}"


@dataclass(slots=True, eq=False)
class _Draft:
    """A sub-swarm while its steps and relatives are collected."""

    first: int
    last: int
    size: int
    state: str | None = None
    edge: tuple[str, str] | None = None
    name: str = ""
    parents: list[_Draft] = field(default_factory=list)
    children: list[_Draft] = field(default_factory=list)

    @property
    def order(self) -> tuple[int, bool, str, str]:
        """Sub-swarms are numbered as they come to be, first those at states."""
        source, target = self.edge or ("", "")
        return self.first, self.edge is not None, self.state or source, target

    def done(self, swarm: str) -> SubSwarm:
        """The finished sub-swarm, when all drafts have their names."""
        parents = tuple(other.name for other in self.parents)
        children = tuple(other.name for other in self.children)
        place = self.state, self.edge
        return SubSwarm(
            self.name, swarm, self.first, self.last, self.size, *place, parents, children
        )


def subswarms(
    swarm: str,
    starts: Mapping[str, int],
    moves: Iterable[Move],
    durations: Durations,
    horizon: int,
) -> tuple[SubSwarm, ...]:
    """Every sub-swarm of one swarm up to the horizon, numbered in the order they come to be.

    A sub-swarm lasts at its state while all of it waits there and nobody joins; on edges of
    duration 1 it is at no step, so none is made there. `moves` must fit the start and the map.
    """
    listed = sorted(moves)
    staying = _staying(starts, listed, durations, horizon)
    travelling = {
        move: _Draft(
            move.step + 1,
            min(move.step + durations[move.source, move.target] - 1, horizon),
            move.count,
            edge=(move.source, move.target),
        )
        for move in listed
        if durations[move.source, move.target] > 1
    }
    drafts = sorted({*staying.values(), *travelling.values()}, key=lambda draft: draft.order)
    for number, draft in enumerate(drafts, 1):
        draft.name = f"{swarm}:{number}"
    for move in listed:
        arrival = (move.target, move.step + durations[move.source, move.target])
        way = (staying[move.source, move.step], travelling.get(move), staying.get(arrival))
        _link([draft for draft in way if draft is not None])
    return tuple(draft.done(swarm) for draft in drafts)


def _staying(
    starts: Mapping[str, int], moves: Sequence[Move], durations: Durations, horizon: int
) -> dict[Node, _Draft]:
    """The sub-swarm at each state and step where there are agents."""
    came, gone = arriving(moves, durations), leaving(moves)
    counts = present(starts, moves, durations, horizon)
    found: dict[Node, _Draft] = {}
    for state, step in sorted(counts, key=lambda node: (node[1], node[0])):
        node, before = (state, step), (state, step - 1)
        alone = came.get(node, ())
        # the one move that left here a step ago is the one that arrives: all wait, nobody joins
        if len(alone) == 1 and gone.get(before) == alone:
            found[node] = found[before]
            found[node].last = step
        else:
            found[node] = _Draft(step, step, counts[node], state=state)
    return found


def _link(way: Sequence[_Draft]) -> None:
    """Make each sub-swarm on the way of a move the parent of the next."""
    for parent, child in pairwise(way):
        if parent is not child and child not in parent.children:
            parent.children.append(child)
            child.parents.append(parent)
