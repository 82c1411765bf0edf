"""Agents that share one path, together."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from tsplan.plans.plan import AgentPlan, Bundle


def bundles(agents: Sequence[AgentPlan]) -> tuple[Bundle, ...]:
    """Group agents by class, capabilities and path, in order of first appearance.

    Large teams share path objects, so paths are first told apart by identity, which is cheap,
    and only the distinct objects are compared by value.
    """
    shared: dict[tuple[str, frozenset[str], int, str | None], list[int]] = {}
    for place, agent in enumerate(agents):
        key = (agent.class_name, agent.capabilities, id(agent.stays), agent.heading)
        shared.setdefault(key, []).append(place)
    equal: dict[Bundle, list[int]] = {}
    for (class_name, able, _, heading), members in shared.items():
        path = Bundle(class_name, able, agents[members[0]].stays, heading, ())
        equal.setdefault(path, []).extend(members)
    return tuple(replace(path, agents=tuple(sorted(members))) for path, members in equal.items())
