"""What a plan says of tasks that are executed, what every robot carries, and what lies where."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Annotated, TypeAlias

import numpy as np
from pydantic import Field

from tsplan.plans.records import OPTIONAL, Record, Whole, Word
from tsplan.words import number

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping, Sequence

    from tsplan.milp.model import Bools

Amount: TypeAlias = Annotated[float, Field(ge=0, allow_inf_nan=False)]
Loads: TypeAlias = "dict[str, float]"
"""Amounts of resources by their names."""


@dataclass(frozen=True, slots=True)
class ExecutedTask(Record):
    """A task, by its text, is executed at a state at a step.

    One that was `given_up` at a later step, when the mission was planned again, is not done. What
    it used up is gone.
    """

    task: Word
    state: Word
    step: Whole
    given_up: Whole | None = field(default=None, metadata=OPTIONAL)


def execution_tables(
    executions: Iterable[ExecutedTask], states: Sequence[str], horizon: int
) -> dict[str, Bools]:
    """Where and when each task, by its text, is executed and done: arrays (states, steps).

    >>> execution_tables([ExecutedTask("T(0,a,{},{(brick,1)})", "q", 1)], ["p", "q"], 1)
    {'T(0,a,{},{(brick,1)})': array([[False, False],
           [False,  True]])}
    """
    found: dict[str, Bools] = {}
    for each in executions:
        if each.given_up is None:
            none = np.zeros((len(states), horizon + 1), dtype=np.bool_)
            found.setdefault(each.task, none)[states.index(each.state), each.step] = True
    return found


@dataclass(frozen=True, slots=True)
class Cargo(Record):
    """What an agent carries of a resource along the edge that it enters at a step."""

    agent: Word
    step: Whole
    resource: Word
    amount: Annotated[float, Field(gt=0, allow_inf_nan=False)]


def together(loads: Iterable[Loads]) -> Loads:
    """The amounts of several loads added up.

    >>> together([{"brick": 2.0}, {"water": 0.5, "brick": 1.0}])
    {'brick': 3.0, 'water': 0.5}
    """
    total: Loads = {}
    for load in loads:
        for resource, amount in load.items():
            total[resource] = total.get(resource, 0.0) + amount
    return total


def load_words(load: Mapping[str, float], between: str = ", ") -> str:
    """Amounts in words.

    >>> load_words({"brick": 2.0, "water": 0.25})
    '2 brick, 0.25 water'
    """
    return between.join(f"{number(round(amount, 6))} {name}" for name, amount in load.items())


@dataclass(frozen=True, slots=True)
class StockHistory(Record):
    """How much of a resource lies at a state: `(step, amount)` wherever that changes, from 0 on.

    What has come by a step is there at it, and so is what is used up or carried away then.
    """

    resource: Word
    state: Word
    amounts: tuple[tuple[Whole, Amount], ...]

    def at(self, step: int) -> float:
        """The amount at a step.

        >>> StockHistory("brick", "wall", ((0, 0.0), (4, 2.0))).at(5)
        2.0
        """
        return next((amount for since, amount in reversed(self.amounts) if since <= step), 0.0)
