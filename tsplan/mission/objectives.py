"""The objectives that a mission may name: one register, to which others can be added.

An objective has an entry here, a measure that says what it is worth in a plan
(`tsplan.checking.measures`), and a way to be planned for (`tsplan.encode`).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from types import MappingProxyType
from typing import Literal, TypeAlias

Sense: TypeAlias = Literal["maximise", "minimise"]


@dataclass(frozen=True, slots=True)
class Objective:
    """What is known of an objective by its name alone.

    One `of_groups` counts the sub-swarms of swarms, and only a mission with swarms may name it;
    any other is about all agents. One that is `first` says what holds, and no other objective
    comes before it. The value of one that is `whole` is a whole number wherever it is finite;
    that of any other is an exact decimal number or fraction. One `of_amounts` is about
    resources, and only a mission with some may name it, and one `of_modules` about modular
    robots. One that is `expected` has an expected value where moves are uncertain. `words` say
    what it is.
    """

    name: str
    sense: Sense
    words: str = ""
    of_groups: bool = False
    first: bool = False
    whole: bool = True
    of_amounts: bool = False
    of_modules: bool = False
    expected: bool = False

    def is_better(self, value: Fraction | float, other: Fraction | float) -> bool:
        """Whether one value is better than another.

        >>> OBJECTIVES["travel"].is_better(3, 4), OBJECTIVES["availability"].is_better(3, 4)
        (True, False)
        """
        return value > other if self.sense == "maximise" else value < other


_REGISTER: dict[str, Objective] = {}

OBJECTIVES: Mapping[str, Objective] = MappingProxyType(_REGISTER)
"""Every registered objective by its name, in the order in which they are listed."""


def register(objective: Objective) -> None:
    """Let missions name an objective. Raises ValueError for a name that is taken."""
    if objective.name in _REGISTER:
        raise ValueError(f"there is an objective '{objective.name}' already")
    _REGISTER[objective.name] = objective


def objectives_for(*, swarms: bool, expected: bool = False) -> tuple[str, ...]:
    """The names that a mission may use: with `swarms` all, else those that are not of groups.

    Where numbers are `expected` ones, only those that have an expected value.
    """
    return tuple(
        item.name
        for item in OBJECTIVES.values()
        if (swarms or not item.of_groups) and (item.expected or not expected)
    )


for _objective in (
    Objective("satisfaction", "maximise", "how much of the formula holds", first=True, whole=False),
    Objective(
        "preferences", "maximise", "summed weights of what is preferred", first=True, whole=False
    ),
    Objective(
        "availability",
        "maximise",
        "agents that may fail with the formula still holding",
        expected=True,
    ),
    Objective("delay", "maximise", "steps that every agent may be late, the formula still holding"),
    Objective("travel", "minimise", "steps that all agents together spend on moves", expected=True),
    Objective(
        "cost", "minimise", "summed costs of all edges that are entered", whole=False, expected=True
    ),
    Objective("risk", "minimise", "-log of the chance that no move fails", whole=False),
    Objective(
        "haulage",
        "minimise",
        "amounts times the steps they are moved",
        whole=False,
        of_amounts=True,
    ),
    Objective(
        "reserve",
        "maximise",
        "least amount left beside what an execution needs",
        whole=False,
        of_amounts=True,
    ),
    Objective(
        "energy",
        "minimise",
        "summed costs of all edges that are entered and of all reconfigurations",
        whole=False,
        of_modules=True,
    ),
    Objective(
        "performance",
        "maximise",
        "how well structures do what the formula asks for",
        whole=False,
        of_modules=True,
    ),
    Objective("makespan", "minimise", "step at which the last move arrives"),
    Objective("agents", "minimise", "agents that ever move"),
    Objective("stability", "minimise", "agents that do not go on as they were planned to"),
    Objective("deviation", "minimise", "steps at which agents are not where some were to be"),
    Objective("splits", "minimise", "how often sub-swarms split", of_groups=True),
    Objective("moves", "minimise", "edges that sub-swarms enter", of_groups=True),
    Objective("balance", "maximise", "agents in the smallest sub-swarm", of_groups=True),
):
    register(_objective)


def default_objective(*, swarms: bool) -> tuple[str, ...]:
    """What a mission asks for where it names no objective: one with swarms, or without."""
    return ("splits", "travel") if swarms else ("travel",)
