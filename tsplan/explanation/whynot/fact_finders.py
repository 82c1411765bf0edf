"""What forbids every plan and can be seen without a solver.

Each finder looks at what the formula asks for in any case (`demands`) and at when robots can be
where on their own (`Context.arrivals`). What it reports is a proof: any team that did better would
break the arithmetic it quotes.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from math import ceil, inf
from typing import TYPE_CHECKING

from tsplan.explanation.explanation import Fact
from tsplan.explanation.part_words import agents, closed_words, ends_words
from tsplan.explanation.whynot.context import Context, able, latest_of
from tsplan.explanation.whynot.shortages import shortage, undelivered
from tsplan.explanation.whynot.soft_constraints import WAITING
from tsplan.explanation.whynot.supply import divided, scarcity, unbuilt
from tsplan.explanation.whynot.time_conflicts import contradictions, crowding, timing
from tsplan.ts.reachability import usable
from tsplan.ts.waits import longest_ways, without_wait
from tsplan.words import many

if TYPE_CHECKING:
    from tsplan.explanation.whynot.context import Arrival
    from tsplan.explanation.whynot.unconditional_demands import Demand
    from tsplan.mission import Group

MOST_FACTS = 20
"""Facts that are listed; the rest would only repeat them."""


def facts_of(context: Context) -> Iterator[Fact]:
    """All facts that forbid every plan, as they are found, those of the simplest kinds first."""
    finders: tuple[Callable[[Context], Iterator[Fact]], ...] = (
        stuck,
        scarcity,
        unbuilt,
        shortage,
        divided,
        unreachable,
        undelivered,
        restless,
        crowding,
        contradictions,
        timing,
    )
    known: set[tuple[str, str]] = set()
    for finder in finders:
        context.pause()
        for fact in finder(context):
            if (fact.kind, fact.text) not in known:
                known.add((fact.kind, fact.text))
                yield fact
            if len(known) >= MOST_FACTS:
                return


def unreachable(context: Context) -> Iterator[Fact]:
    """Places that too few robots with the capability can reach before it is too late."""
    for need in context.needs:
        context.pause()
        if context.mission.having(need.capability) < need.amount:
            continue  # too few wherever they are: that is scarcity
        late = [
            (state, arrivals)
            for state, arrivals in context.places(need)
            if latest_of(arrivals, need.amount) > need.span.last
        ]
        if late and (need.reach != "one" or len(late) == len(need.states)):
            state, arrivals = late[0]
            text = _too_late(context, need, state, arrivals)
            able = context.team(need.capability, "start", "team")
            yield context.fact("reach", text, [need], *able)


def _too_late(context: Context, need: Demand, state: str, arrivals: list[Arrival]) -> str:
    where = f"'{state}' ({need.label})" if need.reach != "together" else f"any {need.label} state"
    last = need.span.last
    inside = sum(item.robots for item in arrivals if item.step <= last)
    who = f"with {need.capability} " if need.capability else ""
    wanted = agents(need.amount, need.capability)
    known = f"only {inside} of the agents {who}" if inside else f"nobody {who}"
    text = f"{known.rstrip()} can be at {where} by step {last}, when {wanted} must be there"
    missing = next(item for item in arrivals if item.step > last)
    group = context.mission.team[missing.entry]
    if group.configuration is not None:
        return f"{text}: {_built(group, missing.step)}"
    shut = _shut(context, state if need.reach != "together" else None)
    if missing.step == inf:
        none = f"there is no way for class {group.class_name} from '{missing.start}'"
        return f"{text}: {none}{shut}"
    target = state
    if need.reach == "together":
        distance = {s: context.distances(group, missing.start)[s] for s in need.states}
        target = min(need.states, key=lambda name: distance[name])
    way = context.way(group, missing.start, target)
    which = "next" if inside else "first"
    return (
        f"{text}: the {which} is one of class {group.class_name} from '{missing.start}', at step "
        f"{int(missing.step)} by {_shown(way)}{shut}"
    )


def _shut(context: Context, target: str | None) -> str:
    """What of a place, or of the edges to it, is closed for a time, in words."""
    system = context.mission.system
    if not system.timed:
        return ""
    found = [
        f"{ends_words((state.name,))} is closed {closed_words(state.closed)}"
        for state in system.states.values()
        if state.closed and target in (None, state.name)
    ]
    found += [
        f"{ends_words(edge.pair)} is closed {closed_words(edge.closed)}"
        for edge in system.edges.values()
        if edge.closed and target in (None, edge.target)
    ]
    if not found:
        return " (some places on the way are closed for a time)"
    return f" ({'; '.join(found[:3])}{'; ...' * (len(found) > 3)})"  # noqa: PLR2004 - a sentence


def _built(group: Group, step: float) -> str:
    """From when on a structure can be somewhere."""
    if step == inf:
        return f"no such structure of class {group.class_name} can ever be there"
    return f"the first such structure of class {group.class_name} can be there at step {int(step)}"


def _shown(way: list[str]) -> str:
    """A way in words, its middle left out where it is long."""
    most = 6
    if len(way) <= most:
        return " > ".join(way)
    return " > ".join([*way[:3], f"... {len(way) - 5} more ...", *way[-2:]])


def stuck(context: Context) -> Iterator[Fact]:
    """Robots that cannot be anywhere at the end, whatever they do: all of their ways end before."""
    mission = context.mission
    missing = without_wait(mission.system)
    for number, group in enumerate(mission.team):
        context.pause()
        if group.configuration is not None:
            continue  # modules can be rebuilt, and are nowhere then
        moves = [*usable(mission.system, group.class_name, group.capabilities)]
        if len({edge.source for edge, _ in moves}) == len(mission.system.states):
            continue  # there is a way on from everywhere
        ways = longest_ways(moves)
        for start, first, count in group.begins:
            length, end = ways.get(start, (0, start))
            if count and first + length < mission.horizon:
                there = f"its longest way ends at '{end}'"
                there = "it cannot go on from there" if start == end else there
                wait = f", and nobody can wait at '{end}'" if end in missing else ""
                comes = f"comes to '{start}' at step {first}" if first else f"starts at '{start}'"
                text = (
                    f"{many(1, 'agent')} of class {group.class_name} that {comes} "
                    f"can be nowhere after step {first + int(length)}: {there}{wait}; "
                    f"the mission lasts {mission.horizon} steps"
                )
                waits = [WAITING] if missing else []
                yield context.fact("waiting", text, [], *waits, *context.entry(number))
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
        if context.builders(need.capability):
            continue  # structures go and come in other shapes
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
        for _, group in able(context.mission, need.capability)
    )


def _back(context: Context, group: Group, state: str) -> float:
    """Fewest steps of a way from a state back to it, for robots like those of a group."""
    moves = usable(context.mission.system, group.class_name, group.capabilities)
    ways = (
        duration + context.distances(group, edge.target)[state]
        for edge, duration in moves
        if edge.source == state and not edge.is_wait
    )
    return min(ways, default=inf)
