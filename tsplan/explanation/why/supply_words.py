"""Executions in words: what they need lies there, and by whom it was brought."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from tsplan.name_runs import Names
from tsplan.plans.summary import names
from tsplan.words import number

if TYPE_CHECKING:
    from tsplan.explanation.why.stock_lines import Supply
    from tsplan.plans.ledger import Haul

MOST_SUPPLIES = 8
"""Amounts of one task that are told; more are only counted."""

_DELIVERIES = 4


def supply_lines(supplies: Sequence[Supply]) -> Iterator[str]:
    """A line for each amount that the executions of a task need."""
    yield from map(supply_words, supplies[:MOST_SUPPLIES])
    if supplies[MOST_SUPPLIES:]:
        yield f"... and {len(supplies) - MOST_SUPPLIES} further amounts"


def supply_words(supply: Supply) -> str:
    """What an execution needs of a resource and how it came there."""
    more = supply.there > supply.needed
    there = f" of {_amount(supply.there)}" if more else ""
    what = f"{_amount(supply.needed)} {supply.resource}{there} at {supply.state}"
    sources = [_brought(haul) for haul in supply.brought[:_DELIVERIES]]
    if rest := supply.brought[_DELIVERIES:]:
        times = sum(haul.agents.size for haul in rest)
        sources.append(f"{_amount(float(sum(haul.amount for haul in rest)))} in {times} more")
    if supply.first:
        sources.insert(0, f"{_amount(supply.first)} there from the start")
    gone = f"; {_amount(supply.gone)} used or carried away before" if supply.gone else ""
    return f"{what} at step {supply.step}: {', '.join(sources) or 'nothing was brought'}{gone}"


def _brought(haul: Haul) -> str:
    return (
        f"{names(Names((haul.agents,)))} brought {_amount(float(haul.amount))} at step {haul.come}"
    )


def _amount(value: float) -> str:
    return number(round(value, 6))
