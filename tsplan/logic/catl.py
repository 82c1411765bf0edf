"""CaTL said with counts and temporal operators; percentages said as numbers of agents."""

from __future__ import annotations

from collections.abc import Callable, Collection
from dataclasses import replace
from fractions import Fraction
from functools import singledispatch
from math import ceil, floor
from typing import Literal, TypeAlias

from tsplan.errors import Finding, FormulaError
from tsplan.logic.atoms import Count, Execution, Known, Limit, Linear, Percent, Relation, Task
from tsplan.logic.nodes import (
    FALSE,
    TRUE,
    Always,
    Constant,
    Formula,
    Not,
    Pair,
    Several,
    Switch,
    Whole,
    Window,
    conjunction,
)
from tsplan.logic.traversal import fold, walk

TaskInterval: TypeAlias = Literal["closed", "half-open"]

INTERVALS: tuple[TaskInterval, ...] = ("closed", "half-open")


def translate(
    formula: Formula,
    interval: TaskInterval = "closed",
    *,
    executed: bool = False,
    consumed: Collection[str] = (),
) -> Formula:
    """The formula without tasks and limits.

    `T(d,A,{(c,m),...})` becomes `G[0,d]` of the conjunction of `min(A,c) >= m`; `half-open` ends
    one step sooner. `L(A,{(c,m),...})` becomes the conjunction of `max(A,c) <= m`. A task with
    resources also becomes the `Execution` of it; where tasks are `executed`, every task does. One
    that has begun needs none of the resources that are `consumed`, by name, any more.

    Raises FormulaError for tasks that last no step where the interval is half-open.

    >>> from tsplan.logic import parse
    >>> print(translate(parse("F[0,9] T(2, green, {(IR,2),(Vis,1)})", language="catl")))
    F[0,9] G[0,2] (min(green,IR) >= 2 && min(green,Vis) >= 1)
    """
    if interval not in INTERVALS:
        raise ValueError(f"'{interval}' is none of {', '.join(INTERVALS)}")
    findings = [
        finding
        for node in walk(formula)
        if isinstance(node, Task)
        for finding in _untranslatable(node, interval)
    ]
    if findings:
        raise FormulaError(findings)

    def plain(node: Formula, below: tuple[Formula, ...]) -> Formula:
        if isinstance(node, Task) and (executed or node.resources):
            return _execution(node, interval, consumed, booked=executed)
        return counted(node, below, interval)

    made: Formula = fold(formula, plain)
    return made


def _untranslatable(node: Task, interval: TaskInterval) -> list[Finding]:
    findings = []
    if _last(node, interval) < 0:
        remedy = "give it at least 1 step, or use the closed task interval"
        findings.append(Finding(f"'{node}' lasts no step in a half-open interval", remedy))
    return findings


@singledispatch
def counted(
    node: Formula,
    _below: tuple[Formula, ...],
    _interval: TaskInterval,
) -> Formula:
    """A node over translated children. Every class of nodes registers its own."""
    raise TypeError(f"no translation is registered for {type(node).__name__}")


@counted.register
def _(
    node: Constant | Count | Linear | Known | Execution,
    _below: tuple[Formula, ...],
    _interval: TaskInterval,
) -> Formula:
    return node


@counted.register
def _(
    node: Not | Whole | Several | Pair | Window | Switch,
    below: tuple[Formula, ...],
    _interval: TaskInterval,
) -> Formula:
    return node.over(below)


@counted.register
def _(node: Task, _below: tuple[Formula, ...], interval: TaskInterval) -> Formula:
    return _staffed(node, interval)


def _last(node: Task, interval: TaskInterval) -> int:
    """How many steps from now on a task ends."""
    return node.left - (interval != "closed")


def _staffed(node: Task, interval: TaskInterval) -> Formula:
    """A task has its agents as long as it lasts."""
    staffed = (Count("min", node.label, name, ">=", number) for name, number in node.needs)
    return Always(0, _last(node, interval), conjunction(staffed))


def _execution(
    node: Task, interval: TaskInterval, consumed: Collection[str], *, booked: bool
) -> Formula:
    """A task has its agents and is executed, if that takes agents or resources of its own."""
    gone = consumed if node.begun else ()
    used = tuple((name, amount) for name, amount in node.resources if name not in gone)
    if not (used or booked):
        return _staffed(node, interval)
    whole = str(replace(node, begun=0))
    last = _last(node, interval)
    done = Execution(whole, node.label, node.needs, used, last, node.begun)
    return conjunction((_staffed(node, interval), done))


@counted.register
def _(node: Limit, _below: tuple[Formula, ...], _interval: TaskInterval) -> Formula:
    if not node.needs:
        return Count("max", node.label, None, "<=", 0)
    return conjunction(Count("max", node.label, name, "<=", number) for name, number in node.needs)


def resolve_percent(formula: Formula, total_of: Callable[[str | None], int]) -> Formula:
    """The formula with percentages replaced by numbers of agents, exactly.

    `total_of(capability)` tells how many agents have a capability (None: all agents).

    >>> from tsplan.logic import parse
    >>> print(resolve_percent(parse("sum(A) >= 30% && max(A) < 30%"), lambda capability: 12))
    sum(A) >= 4 && max(A) < 4
    """

    def resolved(node: Formula, below: tuple[Formula, ...]) -> Formula:
        if isinstance(node, Count) and isinstance(node.bound, Percent):
            return _whole(node, node.bound.of(total_of(node.capability)))
        return node.over(below)

    return fold(formula, resolved)


def _whole(node: Count, share: Fraction) -> Formula:
    """A whole number is compared with a share that may be none: round to the side that matters."""
    if node.relation in ("=", "!=") and share.denominator != 1:
        return FALSE if node.relation == "=" else TRUE
    upward: tuple[Relation, ...] = (">=", "<")
    return replace(node, bound=ceil(share) if node.relation in upward else floor(share))
