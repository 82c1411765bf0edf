"""In words, what was found to hold of an accepted plan."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from types import MappingProxyType
from typing import TYPE_CHECKING

from tsplan.checking.claimed_values import shown
from tsplan.plans.structure_table import structures_checked
from tsplan.plans.summary import infinite_word
from tsplan.words import many

if TYPE_CHECKING:
    from tsplan.checking.measures import Number
    from tsplan.checking.traffic import Traffic
    from tsplan.plans.plan import Plan


_BOOKED: Mapping[str, str] = MappingProxyType(
    {
        "exclusive": "{} at every step have agents that serve no other task then",
        "per-label": "{} at every step have agents that serve no other label of the state then",
    }
)
"""What is told of executions whose agents are booked."""


def facts_of(plan: Plan, traffic: Traffic, values: Mapping[str, Number]) -> tuple[str, ...]:
    """What holds of the team, of the map's rules, of the formula, and what the plan is worth."""
    endless = infinite_word(plan)
    return (
        *_team(plan, traffic),
        *_rules(plan, traffic),
        *_formula(traffic),
        *(f"{name} is {shown(values[name], endless)}" for name in traffic.mission.objective),
    )


def _team(plan: Plan, traffic: Traffic) -> Iterator[str]:
    """Who is there: robots with paths, and swarms."""
    if plan.policies:
        agents = traffic.mission.size
        yield f"the team is the mission's: {agents:,} agents, each by the policy of its class"
        where = f"at all states it may lead to before step {plan.horizon}"
        yield f"every policy takes actions of the map {where}"
        return
    swarms = traffic.moves
    robots = sum(len(each.agents) for each in plan.bundles if each.class_name not in swarms)
    if robots:
        yield f"the team is the mission's: {robots} agents, each with one path from its start"
    for group in traffic.mission.team:
        if group.class_name in swarms:
            yield f"{group.class_name} keeps its {group.count:,} agents from its start on"
    yield from structures_checked(plan)
    what = " and ".join(["every path"] * bool(robots) + ["every move"] * bool(swarms))
    verb = "follow" if robots and swarms else "follows"
    pace = (
        "the durations of their classes and configurations"
        if plan.structures
        else "their durations"
    )
    yield f"{what} {verb} the map's edges at {pace} up to step {plan.horizon}"
    if plan.moves and len(plan.agents) > robots:
        yield f"the paths of {len(plan.agents) - robots:,} agents say the same as the moves"


def _rules(plan: Plan, traffic: Traffic) -> Iterator[str]:
    """What is kept: capacities, bounds and the margin."""
    system, swarm = traffic.mission.system, traffic.mission.swarm
    limited = any(state.capacity is not None for state in system.states.values())
    if limited or system.capacity_groups or system.zones:
        yield "every capacity is kept"
    if traffic.mission.resources:
        count = len(traffic.ledger.uses)
        yield f"{count} task{'s have' if count != 1 else ' has'} what they need when executed"
        yield "no robot carries more than it can, and no state is left with less than nothing"
    if traffic.mission.books:
        yield _BOOKED[traffic.mission.booking].format(many(len(traffic.ledger.uses), "execution"))
    if swarm is None:
        return
    least = min(group.size for group in traffic.groups)
    yield f"the bounds on sub-swarms are kept at every step; the smallest one has {least:,} agents"
    if swarm.margin:
        yield "every demand of the formula has the mission's head-room"


def _formula(traffic: Traffic) -> Iterator[str]:
    """What holds of the formula and of the preferences."""
    satisfaction = traffic.satisfaction
    if satisfaction is not None and satisfaction.fraction != 1:
        by = "" if satisfaction.preference is None else f", preference {satisfaction.preference}"
        yield f"the formula holds in part, with satisfaction {satisfaction.fraction}{by}"
    else:
        over = "" if traffic.mission.expected is None else " of expected numbers"
        yield f"the formula{over} holds, with availability {shown(traffic.availability)}"
    for item in traffic.preferences:
        fraction = f"not met (its fraction is {item.fraction})"
        yield f"preference '{item.name}' is {'met' if item.met else fraction}"
