"""Moves of sub-swarms: how many agents enter which edge at which step.

The moves of a swarm name every edge entered at every step before the horizon, waits included, so
together with the start and the map's durations they determine where how many agents are.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction
from typing import Annotated, Any, NamedTuple, TypeAlias

from pydantic import AfterValidator, GetCoreSchemaHandler, GetPydanticSchema
from pydantic_core.core_schema import CoreSchema, no_info_after_validator_function

from tsplan.mission.team import UnderWay
from tsplan.plans.records import Positive, Whole, Word

Node: TypeAlias = tuple[str, int]
"""A state at a step."""

Durations: TypeAlias = Mapping[tuple[str, str], int]
"""Steps that each edge, by its two ends, takes a swarm."""


Starts: TypeAlias = "Mapping[str, int] | Mapping[str | UnderWay, int]"
"""How many agents start at states, or under way."""


class Move(NamedTuple):
    """`count` agents of one swarm enter the edge from `source` to `target` at `step`."""

    step: int
    source: str
    target: str
    count: int  # type: ignore[assignment]  # hides tuple.count, which no move is asked

    @property
    def is_wait(self) -> bool:
        """Whether the edge leads back to its own state."""
        return self.source == self.target


def _read(_: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
    """How a move is read: from a list of its fields, with findings at their places there."""
    listed = handler.generate_schema(tuple[Whole, Word, Word, Positive])
    return no_info_after_validator_function(Move._make, listed)


def _distinct(moves: tuple[Move, ...]) -> tuple[Move, ...]:
    for move, times in Counter(move[:3] for move in moves).items():
        if times > 1:
            step, source, target = move
            raise ValueError(f"the move from {source} to {target} at step {step} is there twice")
    return tuple(sorted(moves))


Moves: TypeAlias = Annotated[
    tuple[Annotated[Move, GetPydanticSchema(_read)], ...], AfterValidator(_distinct)
]
"""The moves of one swarm; those of a file are sorted when they are read."""


def leaving(moves: Iterable[Move]) -> dict[Node, tuple[Move, ...]]:
    """The moves by the state and step they leave from."""
    return _by_node(((move.source, move.step), move) for move in moves)


def arriving(moves: Iterable[Move], durations: Durations) -> dict[Node, tuple[Move, ...]]:
    """The moves by the state and step they arrive at, those after the horizon too."""
    return _by_node(
        ((move.target, move.step + durations[move.source, move.target]), move) for move in moves
    )


def _by_node(pairs: Iterator[tuple[Node, Move]]) -> dict[Node, tuple[Move, ...]]:
    nodes: dict[Node, list[Move]] = {}
    for node, move in pairs:
        nodes.setdefault(node, []).append(move)
    return {node: tuple(moves) for node, moves in nodes.items()}


def present(
    starts: Starts, moves: Iterable[Move], durations: Durations, horizon: int
) -> dict[Node, int]:
    """How many agents are at each state and step up to the horizon, where there are any."""
    counts: Counter[Node] = Counter()
    for start, count in starts.items():
        state, step = _first(start)
        if step <= horizon:
            counts[state, step] += count
    for (state, step), came in arriving(moves, durations).items():
        if step <= horizon:
            counts[state, step] += sum(move.count for move in came)
    return dict(counts)


def _first(start: str | UnderWay) -> Node:
    """Where and when agents of a start are first."""
    return (start.target, start.arrives) if isinstance(start, UnderWay) else (start, 0)


def shares(moves: Iterable[Move]) -> dict[Node, tuple[tuple[str, Fraction], ...]]:
    """By which edges, named by their target, which part of the agents leaves a state at a step.

    >>> split = shares([Move(3, "dock", "aisle", 40), Move(3, "dock", "dock", 80)])
    >>> [(target, str(part)) for target, part in split["dock", 3]]
    [('aisle', '1/3'), ('dock', '2/3')]
    """
    parts = {}
    for node, gone in leaving(moves).items():
        total = sum(move.count for move in gone)
        parts[node] = tuple((move.target, Fraction(move.count, total)) for move in gone)
    return parts


def splits(moves: Iterable[Move]) -> int:
    """How often sub-swarms split: agents that leave by j edges at once, waits too, split j-1 times.

    >>> splits([Move(0, "p", "p", 2), Move(0, "p", "q", 1), Move(1, "p", "p", 2)])
    1
    """
    return sum(len(gone) - 1 for gone in leaving(moves).values())
