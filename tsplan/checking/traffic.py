"""Who is where when, counted from the agents' stays, or from the sub-swarms."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from tsplan.asked import known_name, name_list

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from tsplan.milp.model import Ints
    from tsplan.plans.plan import Bundle, Plan
    from tsplan.plans.subswarms import SubSwarm


def asked_counts(plan: Plan, states: Iterable[str] | None, capability: str | None) -> Ints:
    """The same as `counted`; InputError for what the plan does not know, as a slip of the caller.

    A plan without paths knows nobody, and counts nobody.
    """
    if capability is not None and plan.has_paths:
        known = {group.swarm for group in plan.groups} | set(plan.moves)
        if not plan.by_groups:
            known = {name for bundle in plan.bundles for name in bundle.capabilities}
        known_name(capability, [known], "swarm" if plan.by_groups else "capability")
    return counted(plan, None if states is None else name_list(states, "state"), capability)


def counted(plan: Plan, states: Sequence[str] | None, capability: str | None) -> Ints:
    """Who is at each of `states` (None: the plan's own) and step, of agents or of sub-swarms.

    Nobody is where nobody has the capability.
    """
    rows = plan.states if states is None else states
    if plan.by_groups:
        return group_counts(plan.groups, rows, plan.horizon, capability)
    return state_counts(plan.bundles, rows, plan.horizon, capability)


def state_counts(
    bundles: Iterable[Bundle], states: Sequence[str], horizon: int, capability: str | None = None
) -> Ints:
    """Agents with a capability (all for None) at each of `states` and step; (states, horizon+1)."""
    row = {state: number for number, state in enumerate(states)}
    change = np.zeros((len(row), horizon + 2), dtype=np.int64)
    for bundle in bundles:
        if capability is not None and capability not in bundle.capabilities:
            continue
        agents = len(bundle.agents)
        for first, last, state in bundle.stays:
            place = row.get(state)
            if place is not None:
                change[place, min(first, horizon + 1)] += agents
                change[place, min(last, horizon) + 1] -= agents
    return np.cumsum(change, axis=1)[:, : horizon + 1]


def group_counts(
    groups: Iterable[SubSwarm], states: Sequence[str], horizon: int, swarm: str | None = None
) -> Ints:
    """Agents of a swarm (all for None) at each of `states` and step; (states, horizon+1)."""
    row = {state: number for number, state in enumerate(states)}
    change = np.zeros((len(row), horizon + 2), dtype=np.int64)
    for group in groups:
        if group.state in row and swarm in (None, group.swarm):
            change[row[group.state], group.first] += group.size
            change[row[group.state], group.last + 1] -= group.size
    return np.cumsum(change, axis=1)[:, : horizon + 1]


def interval_counts(intervals: Iterable[tuple[int, int, int]], horizon: int) -> Ints:
    """Sum over `(from, to, agents)` intervals of the agents present at each step 0..horizon.

    >>> interval_counts([(0, 1, 2), (1, 9, 1)], 3).tolist()
    [2, 3, 1, 1]
    """
    change = np.zeros(horizon + 2, dtype=np.int64)
    for first, last, agents in intervals:
        change[min(first, horizon + 1)] += agents
        change[min(last, horizon) + 1] -= agents
    return np.cumsum(change)[: horizon + 1]
