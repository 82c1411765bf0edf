"""What a plan says of resources: executions of tasks, what every robot carries, what lies where."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, TypeAlias

import numpy as np
from pydantic import Field

from tsplan.plans.records import Record, Whole, Word

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from tsplan.milp.model import Bools

Amount: TypeAlias = Annotated[float, Field(ge=0, allow_inf_nan=False)]


@dataclass(frozen=True, slots=True)
class ExecutedTask(Record):
    """A task with resources, by its text, is executed at a state at a step."""

    task: Word
    state: Word
    step: Whole


def execution_tables(
    executions: Iterable[tuple[str, str, int]], states: Sequence[str], horizon: int
) -> dict[str, Bools]:
    """Where and when each task, by its text, is executed: arrays (states, steps).

    >>> execution_tables([("T(0,a,{},{(brick,1)})", "q", 1)], ["p", "q"], 1)
    {'T(0,a,{},{(brick,1)})': array([[False, False],
           [False,  True]])}
    """
    found: dict[str, Bools] = {}
    for task, state, step in executions:
        none = np.zeros((len(states), horizon + 1), dtype=np.bool_)
        found.setdefault(task, none)[states.index(state), step] = True
    return found


@dataclass(frozen=True, slots=True)
class Cargo(Record):
    """What an agent carries of a resource along the edge that it enters at a step."""

    agent: Word
    step: Whole
    resource: Word
    amount: Annotated[float, Field(gt=0, allow_inf_nan=False)]


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
