"""Whether anybody is at a state or on an edge while it is closed."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from tsplan.ts.closures import Span, closed_at

if TYPE_CHECKING:
    from tsplan.checking.traffic import Traffic


def shut_in(traffic: Traffic) -> Iterator[str]:
    """Agents that are where it is closed; those that start on an edge are let through.

    Where a move ends after the horizon its edge must be open until then, and the state at its end
    open when it arrives.
    """
    system = traffic.mission.system
    if not system.timed:
        return
    for item in traffic.classes:
        for there in item.present:
            span = closed_at(system.states[there.state].closed, there.first, there.last)
            if span is not None:
                yield _words(item.class_name, f"at {there.state}", span)
        for ride in item.segments:
            edge = ride.edge
            span = closed_at(edge.closed, ride.entered, ride.left - 1)
            if span is not None:
                yield _words(
                    item.class_name, f"on the edge from {edge.source} to {edge.target}", span
                )
            if ride.left > traffic.horizon:
                span = closed_at(system.states[edge.target].closed, ride.left, ride.left)
                if span is not None:
                    yield _words(item.class_name, f"due at {edge.target} at step {ride.left}", span)


def _words(class_name: str, where: str, span: Span) -> str:
    first, last = span
    steps = f"at step {first}" if first == last else f"from step {first} to {last}"
    return f"an agent of class {class_name} is {where}, which is closed {steps}"
