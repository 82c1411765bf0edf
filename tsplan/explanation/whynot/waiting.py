"""Where nobody can wait: robots that must be somewhere at every step, and cannot be."""

from __future__ import annotations

from collections.abc import Iterator
from math import ceil, inf
from typing import TYPE_CHECKING

from tsplan.explanation.part_words import agents, counted
from tsplan.explanation.whynot.soft_constraints import WAITING, waiting_constraints
from tsplan.ts.reachability import usable
from tsplan.ts.waits import longest_ways, without_wait

if TYPE_CHECKING:
    from tsplan.explanation.explanation import Fact
    from tsplan.explanation.whynot.context import Context
    from tsplan.explanation.whynot.unconditional_demands import Demand
    from tsplan.mission import Group


def stuck(context: Context) -> Iterator[Fact]:
    """Robots that cannot be anywhere at the end, whatever they do: all of their ways end before."""
    mission = context.mission
    missing = without_wait(mission.system)
    for number, group in enumerate(mission.team):
        context.pause()
        moves = [*usable(mission.system, group.class_name, group.capabilities)]
        if len({edge.source for edge, _ in moves}) == len(mission.system.states):
            continue  # there is a way on from everywhere
        ways = longest_ways(moves)
        for start, count in group.starts:
            length, end = ways.get(start, (0, start))
            if count and length < mission.horizon:
                there = f"its longest way ends at '{end}'"
                there = "it cannot go on from there" if start == end else there
                wait = f", and nobody can wait at '{end}'" if end in missing else ""
                text = (
                    f"{counted(1, 'agent')} of class {group.class_name} that starts at '{start}' "
                    f"can be nowhere after step {int(length)}: {there}{wait}; the mission lasts "
                    f"{mission.horizon} steps"
                )
                own = context.entry(number)
                yield context.fact("waiting", text, [], *waiting_constraints(mission), *own)
                break


def restless(context: Context) -> Iterator[Fact]:
    """Needs for several steps at a state where nobody can wait, and too few robots to take turns.

    Whoever leaves such a state is there again when the quickest way back is over, so that everybody
    can only be there at some of the steps.
    """
    nowhere = frozenset(without_wait(context.mission.system))
    for need in context.needs:
        context.pause()
        fixed = need.reach == "each" or len(need.states) == 1
        if not (nowhere and fixed and need.span.lasts):
            continue
        if context.mission.having(need.capability) < need.amount:
            continue  # too few even for one step: that is scarcity
        asked = need.amount * (need.span.lasts + 1)
        for state in need.states:
            most = _presences(context, need, state) if state in nowhere else asked
            if most < asked:
                text = (
                    f"{agents(need.amount, need.capability)} must be at '{state}' ({need.label}) "
                    f"for {need.span.lasts + 1} steps on end, and nobody can wait there: together "
                    f"the agents can be there {most} times at most, {asked} are needed"
                )
                able = context.team(need.capability, "team")
                yield context.fact("waiting", text, [need], WAITING, *able)
                break


def _presences(context: Context, need: Demand, state: str) -> int:
    """At how many of the steps of a need the robots can be at its state, each counted, at most."""
    steps = need.span.lasts + 1
    return sum(
        group.count * max(1, ceil(steps / _back(context, group, state)))
        for group in context.mission.team
        if need.capability is None or need.capability in group.capabilities
    )


def _back(context: Context, group: Group, state: str) -> float:
    """Fewest steps of a way from a state back to it, for robots like those of a group."""
    moves = usable(context.mission.system, group.class_name, group.capabilities)
    return min(
        (
            duration + context.arrivals.between(group, edge.target, state)
            for edge, duration in moves
            if edge.source == state and not edge.is_wait
        ),
        default=inf,
    )
