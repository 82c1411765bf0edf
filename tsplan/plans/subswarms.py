"""The sub-swarms of a plan: when they exist, where and how large, and what becomes of them."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Self, TypeAlias

from pydantic import model_validator

from tsplan.mission.team import UnderWay
from tsplan.plans.moves import Durations, Move, Node, Starts, arriving, leaving, present
from tsplan.plans.records import OPTIONAL, Positive, Record, Whole, Word


@dataclass(frozen=True, slots=True)
class SubSwarm(Record):
    """Agents of one swarm that are at one place at every step `first`..`last`, both included.

    The place is a `state`, or an `edge` (its two ends) that all of them entered at step
    `first - 1`, or before step 0. `parents` and `children` are the ids of the sub-swarms they come
    from and become.
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


_Key: TypeAlias = tuple[int, bool, str, str, int]
"""Since when a sub-swarm is where: they are numbered as they come to be, first those at states.

Those that are under way from the beginning have their step of arrival last.
"""


def subswarms(
    swarm: str,
    starts: Starts,
    moves: Iterable[Move],
    durations: Durations,
    horizon: int,
) -> tuple[SubSwarm, ...]:
    """Every sub-swarm of one swarm up to the horizon, numbered in the order they come to be.

    A sub-swarm lasts at its state while all of it waits there and nobody joins; on edges of
    duration 1 it is at no step, so none is made there. `moves` must fit the start and the map.
    """
    listed = sorted(moves)
    staying, last = _staying(starts, listed, durations, horizon)
    size = {
        staying[node]: count for node, count in present(starts, listed, durations, horizon).items()
    }
    parents: dict[_Key, list[_Key]] = defaultdict(list)
    children: dict[_Key, list[_Key]] = defaultdict(list)
    ways: list[tuple[_Key | None, ...]] = []
    for start, count in starts.items():
        if isinstance(start, UnderWay):
            under_way = (0, True, start.origin, start.target, start.arrives)
            size[under_way], last[under_way] = count, min(start.arrives - 1, horizon)
            ways.append((under_way, staying.get((start.target, start.arrives))))
    for move in listed:
        arrival = move.step + durations[move.source, move.target]
        on_edge = (move.step + 1, True, move.source, move.target, 0)
        if arrival > move.step + 1:
            size[on_edge], last[on_edge] = move.count, min(arrival - 1, horizon)
        ways.append((staying[move.source, move.step], on_edge, staying.get((move.target, arrival))))
    for way in ways:
        for parent, child in pairwise(key for key in way if key in size):
            if parent != child and child not in children[parent]:
                children[parent].append(child)
                parents[child].append(parent)
    name = {key: f"{swarm}:{number}" for number, key in enumerate(sorted(size), 1)}
    return tuple(
        SubSwarm(
            name[key],
            swarm,
            key[0],
            last[key],
            size[key],
            None if key[1] else key[2],
            key[2:4] if key[1] else None,
            tuple(name[other] for other in parents[key]),
            tuple(name[other] for other in children[key]),
        )
        for key in name
    )


def _staying(
    starts: Starts, moves: Sequence[Move], durations: Durations, horizon: int
) -> tuple[dict[Node, _Key], dict[_Key, int]]:
    """The sub-swarm at each state and step where there are agents, and the last step of each."""
    came, gone = arriving(moves, durations), leaving(moves)
    joined = {(s.target, s.arrives) for s in starts if isinstance(s, UnderWay)}
    staying: dict[Node, _Key] = {}
    last: dict[_Key, int] = {}
    counts = present(starts, moves, durations, horizon)
    for state, step in sorted(counts, key=lambda node: (node[1], node[0])):
        alone = came.get((state, step), ())
        # the one move that left here a step ago is the one that arrives: all wait, nobody joins
        waits = len(alone) == 1 and gone.get((state, step - 1)) == alone
        waits = waits and (state, step) not in joined
        key = staying[state, step - 1] if waits else (step, False, state, "", 0)
        staying[state, step], last[key] = key, step
    return staying, last
