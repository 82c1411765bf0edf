"""Demands in each other's way: limits and capacities against needs, and too little time."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations
from math import inf
from typing import TYPE_CHECKING

from tsplan.explanation.explanation import SoftConstraint
from tsplan.explanation.part_words import agents
from tsplan.explanation.whynot.context import able

if TYPE_CHECKING:
    from tsplan.explanation.explanation import Fact
    from tsplan.explanation.whynot.context import Context
    from tsplan.explanation.whynot.unconditional_demands import Demand

MOST_DEMANDS = 200
"""Demands that are compared with each other."""


def crowding(context: Context) -> Iterator[Fact]:
    """Needs beyond the capacity of the state where they must be met."""
    states = context.mission.system.states
    for need in context.needs:
        context.pause()
        room = {name: most for name in need.states if (most := states[name].capacity) is not None}
        if need.reach == "each":
            full = [name for name, most in room.items() if most < need.amount][:1]
        else:
            most = sum(room.values()) if need.reach == "together" else max(room.values(), default=0)
            full = list(room) if len(room) == len(need.states) and most < need.amount else []
        if full:
            holds = ", ".join(f"'{name}' holds {room[name]}" for name in full)
            text = f"{agents(need.amount, need.capability)} must be at '{need.label}', and {holds}"
            names = (SoftConstraint("capacity", (name,)) for name in full)
            yield context.fact("capacity", text, [need], *names)


def contradictions(context: Context) -> Iterator[Fact]:
    """Needs that a limit forbids at every step at which they may begin."""
    for need, limits in _opposed(context):
        context.pause()
        if _free_steps(need, limits, need.span.first) is None:
            text = f"{_asked(need)}, and {_allowed(limits[0])}"
            yield context.fact("contradiction", text, [need, *limits])
            continue
        ready = context.ready(need)
        if ready <= need.span.last and _free_steps(need, limits, int(ready)) is None:
            late = f"nobody can see to it before step {int(ready)}"
            text = f"{_asked(need)}, {late}, and {_allowed(limits[0])}"
            robots = context.team(need.capability, "start", "team")
            yield context.fact("room", text, [need, *limits], *robots)


def _opposed(context: Context) -> Iterator[tuple[Demand, list[Demand]]]:
    """Needs with the limits that forbid them and whose steps are known."""
    limits = [limit for limit in context.limits if limit.span.fixed]
    for need in context.needs[:MOST_DEMANDS]:
        context.pause()
        against = [limit for limit in limits if _forbids(limit, need)]
        if against:
            yield need, against


def _forbids(limit: Demand, need: Demand) -> bool:
    """Whether both cannot hold at one step, whoever is where."""
    if limit.capability not in (None, need.capability):
        return False
    inside = set(need.states) & set(limit.states)
    all_inside = len(inside) == len(need.states)
    if limit.reach == "one":  # some state has few: not if all of them must have many
        return need.reach == "each" and inside == set(limit.states) and need.amount > limit.amount
    if need.reach == "each":
        each = need.amount if limit.reach == "each" else need.amount * len(inside)
        return bool(inside) and each > limit.amount
    if limit.reach == "together" or need.reach == "one":
        return all_inside and need.amount > limit.amount
    return all_inside and need.amount > limit.amount * len(inside)


def _free_steps(need: Demand, limits: list[Demand], first: int) -> int | None:
    """The first step from which the need can be met between its limits; None if there is none."""
    blocked = sorted((limit.span.first, limit.span.first + limit.span.lasts) for limit in limits)
    begin = max(first, need.span.first)
    for low, high in blocked:
        if begin + need.span.lasts >= low and begin <= high:
            begin = high + 1
    return begin if begin <= need.span.last else None


def timing(context: Context) -> Iterator[Fact]:
    """Two tasks that need the same robots, with too little time to see to both."""
    needs = [need for need in context.needs[:MOST_DEMANDS] if need.span.last < inf]
    for one, two in combinations(needs, 2):
        context.pause()
        if one.capability != two.capability or set(one.states) & set(two.states):
            continue
        if one.total + two.total <= context.mission.having(one.capability):
            continue
        if max(one.total, two.total) > context.mission.having(one.capability):
            continue  # one alone is too much: that is scarcity
        late = _too_late(context, one, two)
        if late is not None:
            robots = context.team(one.capability, "start", "team")
            yield context.fact("timing", late, [one, two], *robots)


def _too_late(context: Context, one: Demand, two: Demand) -> str | None:
    """Why nobody can see to both needs, in either order; None if somebody may."""
    words = []
    for early, later in ((one, two), (two, one)):
        ready = max(context.ready(early), early.span.first)
        if ready > early.span.last:
            return None  # that alone is impossible: it is out of reach
        travel = _between(context, early, later)
        free = ready + early.span.lasts
        if free + travel <= later.span.last:
            return None
        way = f"the way takes {int(travel)} steps" if travel < inf else "there is no way"
        words.append(
            f"after '{early.label}' (done at step {int(free)} at the earliest) {way} to "
            f"'{later.label}', which must begin by step {later.span.last}"
        )
    both = one.total + two.total
    return (
        f"{_asked(one)}, and {_asked(two)}: {both} in all, the team has "
        f"{context.having(one.capability)}, so somebody must see to both; {'; '.join(words)}"
    )


def _between(context: Context, one: Demand, two: Demand) -> float:
    """Fewest steps from a state of one need to a state of the other, for anybody able."""
    ways = (
        context.distances(group, source)[target]
        for _, group in able(context.mission, one.capability)
        if group.configuration is None
        for source in one.states
        for target in two.states
    )
    built = (item.fewest(one.states, two.states) for item in context.builders(one.capability))
    return min((*ways, *built), default=inf)


def _asked(need: Demand) -> str:
    """A need with its steps."""
    first, last, lasts = need.span
    when = f"at step {first}" if need.span.fixed else f"at one of the steps {first}..{last}"
    how_long = f" and stay for {lasts} more" if lasts else ""
    if need.reach == "each" and len(need.states) > 1:
        where = f"each of the {len(need.states)} states '{need.label}'"
    else:
        where = f"'{need.label}'"
    return f"{agents(need.amount, need.capability)} must be at {where} {when}{how_long}"


def _allowed(limit: Demand) -> str:
    """What a limit allows, and when."""
    first, _, lasts = limit.span
    who = f" with {limit.capability}" if limit.capability else ""
    most = f"at most {agents(limit.amount, limit.capability)}" if limit.amount else f"nobody{who}"
    when = f"during the steps {first}..{first + lasts}" if lasts else f"at step {first}"
    return f"{most} may be there {when}"
