"""Who is at which state when, by a plan: by its agents' stays and by its sub-swarms."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from tsplan.errors import Finding, PlanError
from tsplan.parameters import known_name, name_list

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Sequence

    from tsplan.milp.model import Ints
    from tsplan.plans.plan import Bundle, Plan
    from tsplan.plans.subswarms import SubSwarm


class Presence(NamedTuple):
    """Agents with the same capabilities at a state at every step `first`..`last`."""

    state: str
    first: int
    last: int
    agents: int
    capabilities: frozenset[str]


def presences(plan: Plan) -> Iterator[Presence]:
    """Where everybody is: swarms by their sub-swarms where the plan has them, others by paths.

    Raises PlanError for a plan that has the moves of a swarm alone.
    """
    unknown = set(plan.moves).difference(group.swarm for group in plan.groups)
    if unknown.difference(bundle.class_name for bundle in plan.robots):
        what = "the plan names the moves of swarms, but not the sub-swarms they make"
        raise PlanError([Finding(what, "fill them in with certify(mission, plan)")])
    yield from of_bundles(plan.robots)
    yield from of_groups(plan.groups)


def of_bundles(bundles: Iterable[Bundle]) -> Iterator[Presence]:
    """Where the agents of some bundles stay."""
    for bundle in bundles:
        for first, last, state in bundle.stays:
            yield Presence(state, first, last, len(bundle.agents), bundle.capabilities)


def of_groups(groups: Iterable[SubSwarm]) -> Iterator[Presence]:
    """Where sub-swarms are that are at a state; the capability is the name of their swarm."""
    for group in groups:
        if group.state is not None:
            able = frozenset({group.swarm})
            yield Presence(group.state, group.first, group.last, group.size, able)


def asked_counts(plan: Plan, states: Iterable[str] | None, capability: str | None) -> Ints:
    """The same as `counted`; InputError for what the plan does not know, as a slip of the caller.

    A plan without paths knows nobody, and counts nobody.
    """
    if capability is not None and plan.has_paths:
        able = {name for presence in presences(plan) for name in presence.capabilities}
        swarms = {group.swarm for group in plan.groups} | set(plan.moves)
        known_name(capability, [able | swarms], "swarm" if able <= swarms else "capability")
    return counted(plan, None if states is None else name_list(states, "state"), capability)


def counted(plan: Plan, states: Sequence[str] | None, capability: str | None) -> Ints:
    """Who is at each of `states` (None: the plan's own) and step.

    Nobody is where nobody has the capability.
    """
    rows = plan.states if states is None else states
    return state_counts(presences(plan), rows, plan.horizon, capability)


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
