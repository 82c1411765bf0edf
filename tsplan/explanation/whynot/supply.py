"""Capabilities that are too scarce for what must be staffed at one and the same step."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING, Any

from tsplan.explanation.part_words import agents
from tsplan.explanation.whynot.occurrences import Way
from tsplan.explanation.whynot.unconditional_demands import Demand, Span, demands_below
from tsplan.logic import Always, And, Eventually, Formula

if TYPE_CHECKING:
    from tsplan.explanation.explanation import Fact
    from tsplan.explanation.whynot.context import Context


def scarcity(context: Context) -> Iterator[Fact]:
    """A task that needs more robots than have the capability; then several at one step."""
    alone: set[str | None] = set()
    for need in context.needs:
        if need.total > context.mission.having(need.capability):
            alone.add(need.capability)
            text = f"{_wanted(need)}; the team has {context.having(need.capability)}"
            yield context.fact("scarcity", text, [need], *context.team(need.capability, "team"))
    for together in moments(context):
        context.pause()
        capability = together[0].capability
        total = _at_once(together)
        if capability not in alone and total > context.mission.having(capability):
            parts = " and ".join(_wanted(need) for need in together)
            text = (
                f"at one step, {parts}: {agents(total, capability)} in all; "
                f"the team has {context.having(capability)}"
            )
            yield context.fact("scarcity", text, together, *context.team(capability, "team"))


def _wanted(need: Demand) -> str:
    """What a need asks for, with the arithmetic over its states."""
    where = f"'{need.label}'"
    if need.reach == "each" and len(need.states) > 1:
        sum_ = f"{need.amount} at each of the {len(need.states)} states {where}"
        return f"{agents(need.total, need.capability)} are needed ({sum_})"
    verb = "is" if need.amount == 1 else "are"
    return f"{agents(need.amount, need.capability)} {verb} needed at {where}"


def moments(context: Context) -> Iterator[list[Demand]]:
    """Needs for one capability that begin at the same step, whenever that is."""
    for now in instants(context):
        for capability in dict.fromkeys(item.capability for item in now):
            together = [item for item in now if item.capability == capability]
            if len(together) > 1:
                yield together


def instants(context: Context) -> Iterator[list[Demand]]:
    """All needs that begin at the same step, whenever that is."""
    for way, node in _anchors(context.mission.formula):
        context.pause()
        yield [
            item
            for item in demands_below(context.mission, way, node, Span(0, 0))
            if not item.upper and item.amount > 0 and item.span.first == item.span.last == 0
        ]


def _anchors(root: Formula) -> Iterator[tuple[Way, Formula]]:
    """Sub-formulas that must hold at some step, and say something about that step."""
    open_: list[tuple[Way, Formula]] = [((), root)]
    yield (), root
    while open_:
        way, node = open_.pop()
        if isinstance(node, Always | Eventually):
            yield (*way, 0), node.children[0]
        if isinstance(node, And | Always | Eventually):
            open_ += [((*way, n), child) for n, child in enumerate(node.children)]


def apart(needs: Sequence[Demand], order: Callable[[Demand], Any]) -> list[tuple[Demand, str]]:
    """Needs for agents at places that no other one of them shares, with how the place is called.

    Of needs that share a place, the first in some order counts.
    """
    taken: set[str] = set()
    found = []
    for need in sorted(needs, key=order):
        each = need.states if need.reach == "each" else ()
        for state in each:
            if state not in taken:
                found.append((need, f"'{state}'"))
                taken.add(state)
        if not each and not taken & set(need.states):
            found.append((need, f"'{need.label}'"))
            taken |= set(need.states)
    return found


def _at_once(needs: Sequence[Demand]) -> int:
    """Different agents that the needs ask for together, at least: those of disjoint places."""
    disjoint = apart(needs, lambda need: (need.reach != "each", -need.amount))
    return max(sum(need.amount for need, _ in disjoint), *(need.total for need in needs))
