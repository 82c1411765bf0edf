"""Whether anywhere on the map there are more agents than fit."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from tsplan.plans.presence import interval_counts

if TYPE_CHECKING:
    from tsplan.checking.path_segments import Segment
    from tsplan.checking.traffic import Traffic
    from tsplan.milp.model import Floats, Ints


def crowded(traffic: Traffic) -> Iterator[str]:
    """Steps at which more agents are at a state, on an edge or in a zone than it holds."""
    system = traffic.mission.system
    limits = {name: state.capacity for name, state in system.states.items()}
    limited = [name for name, capacity in limits.items() if capacity is not None]
    row = {pair: n for n, (_, pairs) in enumerate(system.capacity_groups) for pair in pairs}
    on_edges = interval_counts(
        (
            (row[segment.edge.pair], segment.entered, segment.left - 1, segment.agents)
            for segment in (*traffic.segments, *traffic.begun)
            if segment.edge.pair in row
        ),
        len(system.capacity_groups),
        traffic.horizon,
    )
    places = [(limits[name] or 0, f"at {name}") for name in limited]
    for capacity, pairs in system.capacity_groups:
        back = " and back" if len(pairs) > 1 else ""
        places.append((capacity, f"on the edge from {pairs[0][0]} to {pairs[0][1]}{back}"))
    places += [(system.zones[name], f"in the zone {name}") for name in system.zones]
    counts = np.concatenate([traffic.counts(limited), on_edges, _in_zones(traffic)])
    for (capacity, where), agents in zip(places, counts, strict=True):
        for step in np.flatnonzero(agents > capacity).tolist():
            yield f"{agents[step]} agents are {where} at step {step}, which holds {capacity}"


def _in_zones(traffic: Traffic) -> Floats | Ints:
    """Agents in every zone at each step: at its states, or between the ends of its edges.

    Whoever leaves a state of the zone is counted there, and on the edge from the next step on.
    """
    system, parts = traffic.mission.system, traffic.mission.system.zone_parts
    row = {name: number for number, name in enumerate(parts)}
    entered = [(segment, system.states[segment.edge.source].zone) for segment in traffic.segments]
    between = interval_counts(
        (
            (row[zone], first, last, segment.agents)
            for segment, left in (*entered, *((segment, None) for segment in traffic.begun))
            if (zone := segment.edge.zone) is not None
            for first, last in _on_the_way(segment, left == zone)
        ),
        len(row),
        traffic.horizon,
    )
    at_states = [traffic.counts(part.states).sum(axis=0) for part in parts.values()]
    return between + at_states if at_states else between


def _on_the_way(segment: Segment, counted: bool) -> Iterator[tuple[int, int]]:
    """First and last steps on an edge; those at which it is entered do not count if `counted`.

    A wait that is repeated is entered anew each time.
    """
    if not counted:
        yield segment.entered, segment.left - 1
        return
    each = (segment.left - segment.entered) // segment.times
    for step in range(segment.entered, segment.left, each) if each > 1 else ():
        yield step + 1, step + each - 1
