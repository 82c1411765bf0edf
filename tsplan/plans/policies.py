"""Policies: which action agents take by chance, and where how many of them are expected.

Where moves are uncertain a plan is no list of paths: an agent at a state at a step takes each
action with the probability that the policy of its class says, independently of all others.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Annotated, Any, NamedTuple, TypeAlias

import numpy as np
from pydantic import AfterValidator, Field, GetCoreSchemaHandler, GetPydanticSchema
from pydantic_core.core_schema import CoreSchema, no_info_after_validator_function

from tsplan.plans.records import Finite, Record, Whole, Word, as_json, json_lines

if TYPE_CHECKING:
    from tsplan.milp.model import Floats

Node: TypeAlias = tuple[str, int]
"""A state at a step."""

Chance: TypeAlias = Annotated[float, Field(gt=0, le=1, allow_inf_nan=False)]


class Choice(NamedTuple):
    """An agent at `state` at `step` takes an action with some probability."""

    step: int
    state: str
    action: str
    probability: float


def _read(_: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
    """How a choice is read: from a list of its fields, with findings at their places there."""
    listed = handler.generate_schema(tuple[Whole, Word, Word, Chance])
    return no_info_after_validator_function(Choice._make, listed)


def _distinct(choices: tuple[Choice, ...]) -> tuple[Choice, ...]:
    for (step, state, action), times in Counter(choice[:3] for choice in choices).items():
        if times > 1:
            raise ValueError(f"the action {action} of {state} at step {step} is there twice")
    return tuple(sorted(choices))


Choices: TypeAlias = Annotated[
    tuple[Annotated[Choice, GetPydanticSchema(_read)], ...], AfterValidator(_distinct)
]
"""The choices of one policy; those of a file are sorted when they are read."""


@dataclass(frozen=True)
class Policy(Record):
    """What agents of one class with the same capabilities do, and where they are expected.

    `choices` has the actions that are taken at every state and step before the horizon where an
    agent can be, with probabilities that add up to 1. `expected` has the expected number of agents
    at each state for the steps 0..horizon; states where nobody can be are left out.

    >>> slide = Policy("cart", frozenset(), (Choice(0, "ice", "go", 1.0),), {"ice": (2.0, 0.5)})
    >>> slide.taken["ice", 0], slide.agents
    ((('go', 1.0),), 2.0)
    """

    class_name: Word
    capabilities: frozenset[Word]
    choices: Choices
    expected: Mapping[Word, tuple[Finite, ...]] = field(default_factory=dict, hash=False)

    @property
    def taken(self) -> dict[Node, tuple[tuple[str, float], ...]]:
        """The actions at every state and step, each with its probability."""
        nodes: dict[Node, list[tuple[str, float]]] = {}
        for step, state, action, probability in self.choices:
            nodes.setdefault((state, step), []).append((action, probability))
        return {node: tuple(actions) for node, actions in nodes.items()}

    @property
    def agents(self) -> float:
        """How many agents follow the policy."""
        return sum(numbers[0] for numbers in self.expected.values())

    def text(self) -> str:
        """The policy in JSON, one choice and one state a line."""
        choices = json_lines(map(as_json, self.choices))
        expected = json_lines(
            (f"{as_json(state)}: {as_json(numbers)}" for state, numbers in self.expected.items()),
            "{}",
        )
        head = {"class": self.class_name, "capabilities": sorted(self.capabilities)}
        return f'{as_json(head)[:-1]}, "choices": {choices}, "expected": {expected}}}'


def expected_counts(
    policies: Iterable[Policy], states: Sequence[str], horizon: int, capability: str | None = None
) -> Floats:
    """Expected numbers with a capability (all for None) at `states`; (states, horizon+1)."""
    row = {state: number for number, state in enumerate(states)}
    counts = np.zeros((len(row), horizon + 1))
    for policy in policies:
        if capability is None or capability in policy.capabilities:
            for state, numbers in policy.expected.items():
                if state in row:
                    counts[row[state]] += numbers
    return counts
