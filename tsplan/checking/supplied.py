"""Whether every task that a plan executes has the robots and the amounts that it needs."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterator

    from tsplan.checking.traffic import Traffic


def unsupplied(traffic: Traffic) -> Iterator[str]:
    """Executions without the robots or the amounts that they need."""
    ledger = traffic.ledger
    for use in ledger.uses:
        for capability, number in use.task.needs:
            there = traffic.counts([use.state], capability)[0, use.first : use.last + 1]
            if there.min() < number:
                yield (
                    f"{use.task.task} is executed at {use.state} at step {use.first} with "
                    f"{there.min()} agents for {capability}"
                )
    yield from ledger.shortages()
