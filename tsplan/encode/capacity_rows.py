"""Capacities of states and edges as rows over the flows of all classes."""

from __future__ import annotations

import numpy as np

from tsplan.encode.agent_classes import MapArrays
from tsplan.encode.flow_network import Network
from tsplan.milp.model import INFINITY, Draft, Ints


def capacity_rows(network: Network, arrays: MapArrays, draft: Draft) -> None:
    """At each step at most so many agents at a state, and at most so many on an edge at once."""
    steps = np.arange(1, network.horizon + 1)  # the start is the mission's to check
    if not len(steps):
        return
    for state, capacity in arrays.capacity:
        index, columns, _ = network.present_at(np.array([state]), None, steps, settled=False)
        most = np.full(len(steps), capacity)
        draft.sums((index, columns, 1.0), lower=-INFINITY, upper=most, kind="state capacity")
    for group, capacity in enumerate(arrays.group_capacity):
        parts = _on_edges(network, group)
        most = np.full(len(parts), capacity)
        terms = ((row, part, 1.0) for row, part in enumerate(parts))
        draft.sums(*terms, lower=-INFINITY, upper=most, kind="edge capacity")


def _on_edges(network: Network, group: int) -> list[Ints]:
    """Agents that entered in (k - duration, k] are on the edge at step k: their columns."""
    parts: list[list[Ints]] = [[] for _ in range(network.horizon)]
    for item in network.classes:
        for edge in np.flatnonzero(item.graph.group == group).tolist():
            first, last = int(item.first[edge]), int(item.last[edge])
            duration = int(item.graph.duration[edge])
            for step, part in enumerate(parts):
                entered = np.arange(max(first, step - duration + 1), min(last, step) + 1)
                part.append(item.offset[edge] + entered - first)
    return [np.concatenate(part) for part in parts if part]
