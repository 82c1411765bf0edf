"""Capacities of states, edges and zones as rows over the flows of all classes."""

from __future__ import annotations

import numpy as np

from tsplan.encode.agent_classes import MapArrays
from tsplan.encode.flow_network import Network
from tsplan.milp.model import INFINITY, Draft, Ints


def capacity_rows(network: Network, arrays: MapArrays, draft: Draft) -> None:
    """At each step at most so many agents at a state, on an edge at once, and in a zone."""
    steps = np.arange(1, network.horizon + 1)  # the start is the mission's to check
    if not len(steps):
        return
    for state, capacity in arrays.capacity:
        index, columns, _ = network.present_at(np.array([state]), None, steps, settled=False)
        most = np.full(len(steps), capacity)
        draft.sums((index, columns, 1.0), lower=-INFINITY, upper=most, kind="state capacity")
    for group, capacity in enumerate(arrays.group_capacity):
        if group in arrays.zone_states:
            _zone_rows(network, (group, capacity, arrays.zone_states[group]), draft)
            continue
        parts = _on_edges(network, group)
        most = np.full(len(parts), capacity)
        terms = ((row, part, 1.0) for row, part in enumerate(parts))
        draft.sums(*terms, lower=-INFINITY, upper=most, kind="edge capacity")


def _zone_rows(network: Network, zone: tuple[int, int, Ints], draft: Draft) -> None:
    """At each step at most so many agents at the states of a zone and on its edges together.

    Whoever leaves a state of the zone is counted there, and on the edge from the next step on.
    """
    group, capacity, states = zone
    steps = np.arange(network.horizon + 1)
    index, columns, _ = network.present_at(states, None, steps, settled=False)
    parts = _on_edges(network, group, states)
    terms = ((row, part, 1.0) for row, part in enumerate(parts))
    most = np.full(len(steps), capacity)
    at_states = (index, columns, 1.0)
    draft.sums(at_states, *terms, lower=-INFINITY, upper=most, kind="zone capacity")


def _on_edges(network: Network, group: int, states: Ints | None = None) -> list[Ints]:
    """Agents that entered in (k - duration, k] are on the edge at step k: their columns.

    With the `states` of a zone, those that entered at k itself are left out where the edge leaves
    one of them; and the last step counts, which only tells as much as the one before for edges.
    """
    parts: list[list[Ints]] = [[] for _ in range(network.horizon + (states is not None))]
    for item in network.classes:
        place = None if item.graph.modes is None else item.graph.modes.place
        for edge in np.flatnonzero(item.graph.group == group).tolist():
            first, last = int(item.first[edge]), int(item.last[edge])
            duration, tail = int(item.graph.duration[edge]), int(item.graph.tail[edge])
            state = tail if place is None else int(place[tail])
            late = states is not None and state in states
            for step, part in enumerate(parts):
                entered = np.arange(max(first, step - duration + 1), min(last, step - late) + 1)
                part.append(item.offset[edge] + entered - first)
    return [np.concatenate(part) for part in parts if part]
