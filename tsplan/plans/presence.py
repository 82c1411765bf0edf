"""Who is at which state when: by agents' stays and by sub-swarms."""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Sequence

    from tsplan.milp.model import Ints
    from tsplan.plans.bundles import Bundle
    from tsplan.plans.subswarms import SubSwarm


class Presence(NamedTuple):
    """Agents with the same capabilities at a state at every step `first`..`last`."""

    state: str
    first: int
    last: int
    agents: int
    capabilities: frozenset[str]


def of_bundles(bundles: Iterable[Bundle]) -> Iterator[Presence]:
    """Where the agents of some bundles stay, those at one state at the same time as one."""
    counts: Counter[tuple[str, int, int, frozenset[str]]] = Counter()
    for bundle in bundles:
        agents, able = len(bundle.agents), bundle.capabilities
        for first, last, state in bundle.stays:
            counts[state, first, last, able] += agents
    for (state, first, last, able), agents in counts.items():
        yield Presence(state, first, last, agents, able)


def of_groups(groups: Iterable[SubSwarm]) -> Iterator[Presence]:
    """Where sub-swarms are that are at a state; the capability is the name of their swarm."""
    for group in groups:
        if group.state is not None:
            able = frozenset({group.swarm})
            yield Presence(group.state, group.first, group.last, group.size, able)


def state_counts(
    present: Iterable[Presence], states: Sequence[str], horizon: int, capability: str | None = None
) -> Ints:
    """Agents with a capability (all for None) at each of `states` and step; (states, horizon+1)."""
    row = {state: number for number, state in enumerate(states)}
    intervals = (
        (row[state], first, last, agents)
        for state, first, last, agents, able in present
        if state in row and (capability is None or capability in able)
    )
    return interval_counts(intervals, len(row), horizon)


def interval_counts(
    intervals: Iterable[tuple[int, int, int, int]], rows: int, horizon: int
) -> Ints:
    """Sums, by row and step 0..horizon, of `(row, from, to, agents)` intervals, ends included.

    >>> interval_counts([(0, 0, 1, 2), (0, 1, 9, 1)], 1, 3).tolist()
    [[2, 3, 1, 1]]
    """
    change = np.zeros((rows, horizon + 2), dtype=np.int64)
    for row, first, last, agents in intervals:
        change[row, min(first, horizon + 1)] += agents
        change[row, min(last, horizon) + 1] -= agents
    return np.cumsum(change, axis=1)[:, : horizon + 1]
