"""The paths of agents, and of agents that share one."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from typing import Annotated, TypeAlias

from pydantic import AfterValidator, Field, field_validator

from tsplan.parameters import step_within
from tsplan.plans.records import OPTIONAL, Record, Whole, Word, as_json, json_lines, shared

Stay: TypeAlias = tuple[Whole, Whole, Word]
"""`(from, to, state)`: at that state at every step from..to, both included."""


@dataclass(frozen=True, slots=True)
class AgentPlan(Record):
    """The path of one agent.

    Between two stays the agent is on the one edge from the first state to the second, and at no
    state. `heading` is the state it is travelling to when its last stay ends before the horizon.
    """

    id: Word
    class_name: Word
    capabilities: Annotated[frozenset[Word], AfterValidator(shared)]
    stays: Annotated[tuple[Stay, ...], Field(min_length=1), AfterValidator(shared)]
    heading: Word | None = field(default=None, metadata=OPTIONAL)

    @field_validator("stays")
    @classmethod
    def _forwards(cls, stays: tuple[Stay, ...]) -> tuple[Stay, ...]:
        before = -1
        for first, last, _ in stays:
            if not before < first <= last:
                raise ValueError(f"the stay from {first} to {last} is out of order")
            before = last
        return stays

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


@dataclass(frozen=True, slots=True)
class Bundle:
    """Agents of one class that share one path; `agents` are their places in `Plan.agents`."""

    class_name: str
    capabilities: frozenset[str]
    stays: tuple[Stay, ...]
    heading: str | None
    agents: tuple[int, ...]


def bundles(agents: Sequence[AgentPlan]) -> tuple[Bundle, ...]:
    """Group agents by class, capabilities and path, in order of first appearance.

    Large teams share path objects, so paths are first told apart by identity, which is cheap,
    and only the distinct objects are compared by value.
    """
    shared: dict[tuple[str, frozenset[str], int, str | None], list[int]] = {}
    for place, agent in enumerate(agents):
        key = (agent.class_name, agent.capabilities, id(agent.stays), agent.heading)
        shared.setdefault(key, []).append(place)
    equal: dict[Bundle, list[int]] = {}
    for (class_name, able, _, heading), members in shared.items():
        path = Bundle(class_name, able, agents[members[0]].stays, heading, ())
        equal.setdefault(path, []).extend(members)
    return tuple(replace(path, agents=tuple(sorted(members))) for path, members in equal.items())


def agents_json(agents: Sequence[AgentPlan], grouped: Sequence[Bundle]) -> str:
    """A list of agents in JSON; what agents on one path have in common is made only once."""
    lines = [""] * len(agents)
    for bundle in grouped:
        common = as_json(replace(agents[bundle.agents[0]], id=""))
        tail = common.removeprefix('{"id": ""')
        for place in bundle.agents:
            lines[place] = f'{{"id": {as_json(agents[place].id)}{tail}'
    return json_lines(lines)


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
