"""A table (CSV) of where every agent is at every step."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable, Iterator
from functools import lru_cache

from tsplan.writers.handover import Handover
from tsplan.writers.journeys import Journey

_KEPT = 1024  # journeys whose rows are kept for the agents that follow


def write(handover: Handover) -> Iterator[str]:
    """A line of names, then for each agent a row for every step 0..horizon.

    The columns are `agent`, `step`, `state` (empty while the agent is travelling), `x` and `y` (on
    an edge on the straight line between its ends; empty where the map says nothing), `seconds`
    where the map knows how long a step takes, and `origin`, the original id of the state, where it
    has them.
    """
    origins = any(handover.system.states[state].origin is not None for state in handover.states)
    columns = ["agent", "step", "state", "x", "y"]
    columns += ["seconds"] * handover.timed + ["origin"] * origins
    rows = lru_cache(_KEPT)(lambda journey: _rows(handover, journey, origins=origins))
    yield _text([columns])
    for agent, journey in handover.journeys():
        yield _text([agent, *row] for row in rows(journey))


def _rows(handover: Handover, journey: Journey, *, origins: bool) -> tuple[list[object], ...]:
    """What the rows of an agent say after its name; None is written as nothing."""
    rows: list[list[object]] = []
    for step in range(handover.plan.horizon + 1):
        state = journey.state_at(step)
        row: list[object] = [step, state]
        row += journey.position_at(step, handover.place) or (None, None)
        if handover.timed:
            row.append(handover.seconds(step))
        if origins:
            row.append(None if state is None else handover.system.states[state].origin)
        rows.append(row)
    return tuple(rows)


def _text(rows: Iterable[Iterable[object]]) -> str:
    stream = io.StringIO()
    csv.writer(stream, lineterminator="\n").writerows(rows)
    return stream.getvalue()
