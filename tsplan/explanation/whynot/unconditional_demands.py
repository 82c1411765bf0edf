"""What a formula asks for in any case, with the steps at which it does.

Only what every plan must do is listed: nothing below `or`, a negation or an implication. Each
demand holds from some step of a window on, for a number of steps. Under `G` over `F` the first
instance stands for all of them.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from math import ceil, floor
from typing import TYPE_CHECKING, Literal, NamedTuple, TypeAlias

from tsplan.exact import exact
from tsplan.explanation.whynot.occurrences import Occurrence, Way, numbered_amounts, numbered_counts
from tsplan.logic import (
    Always,
    And,
    Count,
    Eventually,
    Formula,
    Percent,
    Release,
    Task,
    Until,
    Whole,
)

if TYPE_CHECKING:
    from tsplan.mission import Mission

Reach: TypeAlias = Literal["each", "together", "one"]
_LOWER: dict[str, Reach] = {"min": "each", "sum": "together", "max": "one"}
_UPPER: dict[str, Reach] = {"max": "each", "sum": "together", "min": "one"}


class Span(NamedTuple):
    """A demand begins at some step `first .. last` and holds for `lasts` steps more."""

    first: int
    last: int
    lasts: int = 0

    @property
    def fixed(self) -> bool:
        """Whether the step at which it begins is known."""
        return self.first == self.last


@dataclass(frozen=True, slots=True)
class Demand:
    """At least (or, if `upper`, at most) `amount` agents with a capability at a label's states.

    `reach` says whether that is meant at each of the states, at all of them together, or at one of
    them.
    """

    occurrence: Occurrence
    states: tuple[str, ...]
    capability: str | None
    amount: int
    reach: Reach
    upper: bool
    span: Span
    label: str

    @property
    def total(self) -> int:
        """How many different agents a lower bound needs at once."""
        return self.amount * len(self.states) if self.reach == "each" else self.amount


@dataclass(frozen=True, slots=True)
class AmountDemand:
    """A task needs an `amount` of a resource at each of its states, whenever it is executed.

    It is executed at some step `span.first .. span.last`, and again at each of the `span.lasts`
    steps that follow.
    """

    occurrence: Occurrence
    task: Task
    resource: str
    amount: Fraction
    states: tuple[str, ...]
    span: Span

    @property
    def executions(self) -> int:
        """How often it is executed at each state."""
        return self.span.lasts + 1


def amount_demands(mission: Mission) -> tuple[AmountDemand, ...]:
    """The amounts of resources that the mission's formula asks for in any case."""
    consumed = {item.name for item in mission.resources if item.consumed}
    return tuple(
        AmountDemand(
            part, node, name, exact(amount), tuple(mission.system.labels[node.label]), when
        )
        for way, node, when, _ in required((), mission.formula, Span(0, 0))
        if isinstance(node, Task)
        for part, name, amount in numbered_amounts(node, way)
        if amount and not (node.begun and name in consumed)
    )


def demands(mission: Mission) -> tuple[Demand, ...]:
    """Everything that the mission's formula asks for in any case."""
    return tuple(demands_below(mission, (), mission.formula, Span(0, 0)))


def demands_below(mission: Mission, way: Way, node: Formula, span: Span) -> Iterator[Demand]:
    """What a sub-formula asks for that must hold from some step of `span` on."""
    for here, formula, when, _ in required(way, node, span):
        yield from _of_atom(mission, here, formula, when)


def required(way: Way, node: Formula, span: Span) -> Iterator[tuple[Way, Formula, Span, bool]]:
    """All that must hold where a sub-formula must, in the order of the text, and when.

    The last value says whether that is at other steps than what it stands in, as of the first.
    """
    open_ = [(way, node, span, True)]
    while open_:
        here, formula, when, moved = open_.pop()
        yield here, formula, when, moved
        inner = [
            ((*here, number), formula.children[number], later, later is not when)
            for number, later in _inside(formula, when)
        ]
        open_ += reversed(inner)


def _inside(node: Formula, span: Span) -> list[tuple[int, Span]]:
    """The children that must hold whenever the node does, and when."""
    first, last, lasts = span
    if isinstance(node, And | Whole):
        return [(number, span) for number in range(len(node.children))]
    if isinstance(node, Always):
        return [(0, Span(first + node.low, last + node.low, lasts + node.high - node.low))]
    if isinstance(node, Eventually):
        return [(0, _some_step(span, node.low, node.high))]
    if isinstance(node, Until):
        left = [(0, Span(first, last, lasts + node.low - 1))] if node.low > 0 else []
        return [*left, (1, _some_step(span, node.low, node.high))]
    if isinstance(node, Release) and node.low == 0:
        return [(1, span)]
    return []


def _some_step(span: Span, low: int, high: int) -> Span:
    if low == high:
        return Span(span.first + low, span.last + low, span.lasts)
    return Span(span.first + low, span.last + high)


def _of_atom(mission: Mission, way: Way, node: Formula, span: Span) -> Iterator[Demand]:
    """The demands of a task, a limit or a count itself."""
    if isinstance(node, Task):
        lasts = node.left - (mission.task_interval == "half-open")
        span = span._replace(lasts=span.lasts + lasts)
    for part, count in numbered_counts(node, way):
        states, who = mission.system.labels[count.label], count.capability
        for upper, amount in _bounds(count, mission.having(who)):
            reach = (_UPPER if upper else _LOWER)[count.function]
            yield Demand(part, states, who, amount, reach, upper, span, count.label)


def _bounds(count: Count, agents: int) -> Iterator[tuple[bool, int]]:
    """The bounds that a relation means, as (upper, amount); none for `!=`."""
    share = count.bound.of(agents) if isinstance(count.bound, Percent) else count.bound
    if count.relation in (">=", "="):
        yield False, ceil(share)
    if count.relation == ">":
        yield False, floor(share) + 1
    if count.relation in ("<=", "="):
        yield True, floor(share)
    if count.relation == "<":
        yield True, ceil(share) - 1
