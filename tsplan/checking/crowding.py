"""Whether anywhere on the map there are more agents than fit."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from tsplan.plans.presence import interval_counts

if TYPE_CHECKING:
    from tsplan.checking.traffic import Traffic


def crowded(traffic: Traffic) -> Iterator[str]:
    """Steps at which more agents are at a state or on an edge than it holds."""
    system = traffic.mission.system
    limits = {name: state.capacity for name, state in system.states.items()}
    limited = [name for name, capacity in limits.items() if capacity is not None]
    row = {pair: n for n, (_, pairs) in enumerate(system.capacity_groups) for pair in pairs}
    on_edges = interval_counts(
        (
            (row[segment.edge.pair], segment.entered, segment.left - 1, segment.agents)
            for segment in traffic.segments
            if segment.edge.pair in row
        ),
        len(system.capacity_groups),
        traffic.horizon,
    )
    places = [(limits[name] or 0, f"at {name}") for name in limited]
    for capacity, pairs in system.capacity_groups:
        back = " and back" if len(pairs) > 1 else ""
        places.append((capacity, f"on the edge from {pairs[0][0]} to {pairs[0][1]}{back}"))
    counts = np.concatenate([traffic.counts(limited), on_edges])
    for (capacity, where), agents in zip(places, counts, strict=True):
        for step in np.flatnonzero(agents > capacity).tolist():
            yield f"{agents[step]} agents are {where} at step {step}, which holds {capacity}"
