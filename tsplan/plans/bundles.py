"""Agents that share one path, together."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from tsplan.plans.plan import AgentPlan, Bundle


def bundles(agents: Iterable[AgentPlan]) -> tuple[Bundle, ...]:
    """Group agents by class, capabilities and path, in order of first appearance.

    Large teams share path objects, so paths are first told apart by identity, which is cheap,
    and only the distinct objects are compared by value.
    """
    shared: dict[tuple[str, frozenset[str], int, str | None], list[int]] = {}
    samples: list[AgentPlan] = []
    last: AgentPlan | None = None
    members: list[int] | None = None
    for place, agent in enumerate(agents):
        if (
            members is not None
            and last is not None
            and agent.stays is last.stays
            and agent.capabilities is last.capabilities
            and agent.heading is last.heading
            and agent.class_name is last.class_name
        ):
            members.append(place)  # neighbours share a path most often
            continue
        last = agent
        key = (agent.class_name, agent.capabilities, id(agent.stays), agent.heading)
        members = shared.get(key)
        if members is None:
            shared[key] = members = [place]
            samples.append(agent)
        else:
            members.append(place)
    equal: dict[Bundle, list[int]] = {}
    for agent, members in zip(samples, shared.values(), strict=True):
        path = Bundle(agent.class_name, agent.capabilities, agent.stays, agent.heading, ())
        equal.setdefault(path, []).extend(members)
    return tuple(replace(path, agents=tuple(sorted(members))) for path, members in equal.items())
