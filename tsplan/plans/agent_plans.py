"""The path of one agent: where it stays from when until when, and where it is heading."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import Annotated, Self, TypeAlias

from pydantic import AfterValidator, ValidationInfo, model_validator

from tsplan.parameters import step_within
from tsplan.plans.records import OPTIONAL, Record, Whole, Word, shared

Stay: TypeAlias = tuple[Whole, Whole, Word]
"""`(from, to, state)`: at that state at every step from..to, both included."""


def _forwards(stays: tuple[Stay, ...], info: ValidationInfo) -> tuple[Stay, ...]:
    before = -1
    for first, last, _ in stays:
        if not before < first <= last:
            raise ValueError(f"the stay from {first} to {last} is out of order")
        before = last
    return shared(stays, info)


Stays: TypeAlias = Annotated[tuple[Stay, ...], AfterValidator(_forwards)]
"""The stays of an agent in order; equal ones of one file are one object."""


def stays_somewhere(stays: Sequence[Stay], coming: str | None, heading: str | None) -> None:
    """Refuse a path without a stay, unless it is one of an agent that is on one edge throughout."""
    if not stays and (coming is None or heading is None):
        raise ValueError("there are no stays: the agent is nowhere")


Able: TypeAlias = Annotated[frozenset[Word], AfterValidator(shared)]
"""What an agent can do."""


@dataclass(frozen=True, slots=True)
class AgentPlan(Record):
    """The path of one agent.

    Between two stays the agent is on the one edge from the first state to the second, and at no
    state. `heading` is the state it is travelling to when its last stay ends before the horizon,
    and `coming` the state it left before step 0 when its first stay begins later.
    """

    id: Word
    class_name: Word
    capabilities: Able
    stays: Stays
    heading: Word | None = field(default=None, metadata=OPTIONAL)
    coming: Word | None = field(default=None, metadata=OPTIONAL)

    @model_validator(mode="after")
    def _somewhere(self) -> Self:
        """Asked of what a file says alone."""
        stays_somewhere(self.stays, self.coming, self.heading)
        return self

    def state_at(self, step: int) -> str | None:
        """The agent's state at `step`; None while it is travelling.

        Raises InputError for what is no step. The horizon is known to the plan alone: after it
        the answer here is None.

        >>> agent = AgentPlan("a-1", "a", frozenset(), ((0, 2, "p"), (4, 5, "q")))
        >>> [agent.state_at(step) for step in (2, 3, 4)]
        ['p', None, 'q']
        """
        return state_in(self.stays, step_within(step, None))


def state_in(stays: Sequence[Stay], step: int) -> str | None:
    """The state of the stay that a step is in, if it is in one.

    >>> [state_in([(0, 2, "p"), (4, 5, "q")], step) for step in (2, 3, 4)]
    ['p', None, 'q']
    """
    place = bisect_right(stays, step, key=lambda stay: stay[0]) - 1
    if place < 0:
        return None
    _, last, state = stays[place]
    return state if step <= last else None


def joined(stays: Iterable[Stay]) -> Iterator[Stay]:
    """Stays in order, those at one state that follow each other as one."""
    open_: Stay | None = None
    for first, last, state in stays:
        if open_ is not None and open_[2] == state and open_[1] + 1 == first:
            open_ = open_[0], last, state
            continue
        if open_ is not None:
            yield open_
        open_ = first, last, state
    if open_ is not None:
        yield open_
