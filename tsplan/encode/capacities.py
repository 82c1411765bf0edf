"""Capacities of states and edges as rows over the flows of all classes."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from tsplan.encode.agent_classes import MapArrays
from tsplan.encode.flow_network import Network
from tsplan.milp.model import Draft, Ints


def capacity_rows(network: Network, arrays: MapArrays, draft: Draft) -> None:
    """At each step at most so many agents at a state, and at most so many on an edge at once."""
    for state, capacity in arrays.capacity:
        _state_rows(network, state, capacity, draft)
    for group, capacity in enumerate(arrays.group_capacity):
        _edge_rows(network, group, capacity, draft)


def _state_rows(network: Network, state: int, capacity: int, draft: Draft) -> None:
    """`n(state, k) <= capacity` for every step; the start is the mission's to check."""
    steps = np.arange(1, network.horizon + 1)
    if not len(steps):
        return
    index, columns, _ = network.present_at(np.array([state]), None, steps)
    most = np.full(len(steps), float(capacity))
    draft.rows(index, columns, 1.0, lower=-np.inf, upper=most, kind="state capacity")


def _edge_rows(network: Network, group: int, capacity: int, draft: Draft) -> None:
    """Agents that entered in (k - duration, k] are on the edge at step k."""
    parts: list[list[Ints]] = [[] for _ in range(network.horizon)]
    for item in network.classes:
        for edge in np.flatnonzero(item.graph.group == group).tolist():
            first, last = int(item.first[edge]), int(item.last[edge])
            duration = int(item.graph.duration[edge])
            for step in range(network.horizon):
                entered = np.arange(max(first, step - duration + 1), min(last, step) + 1)
                parts[step].append(item.offset[edge] + entered - first)
    _sums([np.concatenate(part) for part in parts if part], capacity, "edge capacity", draft)


def _sums(parts: Sequence[Ints], most: int, kind: str, draft: Draft) -> None:
    """One row per part: the sum of its columns is at most `most`."""
    if not parts:
        return
    sizes = [len(part) for part in parts]
    members = np.concatenate(parts)
    index = np.repeat(np.arange(len(parts)), sizes)
    draft.rows(
        index, members, 1.0, lower=-np.inf, upper=np.full(len(parts), float(most)), kind=kind
    )
