"""Which needs of a mission are the tightest, by arithmetic: what is likely to be in the way."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from math import inf
from typing import TYPE_CHECKING

from tsplan.explanation.explanation import Likely, SoftConstraint
from tsplan.explanation.part_words import agents
from tsplan.explanation.whynot.occurrences import counts_of, node_at
from tsplan.explanation.whynot.soft_constraints import occurrence_of

if TYPE_CHECKING:
    from tsplan.explanation.whynot.context import Context
    from tsplan.explanation.whynot.unconditional_demands import Demand
    from tsplan.mission import Mission

MOST_SUSPECTS = 5
"""Needs that are named where nothing is proven."""


def tightest(context: Context) -> Iterator[Likely]:
    """The needs for which the largest part of who there is, or of the time, is needed."""
    for need in sorted(context.needs, key=lambda need: -_tightness(context, need))[:MOST_SUSPECTS]:
        able, ready = context.mission.having(need.capability), context.ready(need)
        when = "never" if ready == inf else f"at step {int(ready)}"
        where = f"{'each ' if need.reach == 'each' and len(need.states) > 1 else ''}'{need.label}'"
        text = (
            f"{agents(need.amount, need.capability)} at {where} by step {need.span.last}: the team "
            f"has {able}, and by travel times alone they can be there {when} at the earliest"
        )
        yield Likely("conflict", text, context.wording.sources.place(need.occurrence))


def _tightness(context: Context, need: Demand) -> float:
    """What is needed of the agents there are, and of the steps there are: the larger part."""
    able = context.mission.having(need.capability)
    numbers = need.total / able if able else inf
    return max(numbers, (context.ready(need) + 1) / (need.span.last + 1))


def about(
    mission: Mission,
    groups: Collection[Sequence[SoftConstraint]],
    capabilities: Collection[str],
) -> frozenset[SoftConstraint]:
    """The parts of the formula that may ask for some capabilities, and all that limits."""
    return frozenset(
        part for group in groups for part in group if _asks(mission, part, capabilities)
    )


def _asks(mission: Mission, part: SoftConstraint, capabilities: Collection[str]) -> bool:
    way, number = occurrence_of(part)
    counts = counts_of(node_at(mission.formula, way))
    asked = counts if number is None else counts[number : number + 1]
    return not asked or any(
        count.relation != ">=" or count.capability in (None, *capabilities) for count in asked
    )
