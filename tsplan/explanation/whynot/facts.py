"""What forbids every plan and can be seen without a solver.

Each finder looks at what the formula asks for in any case (`demands`) and at when robots can be
where on their own (`Arrivals`). What it reports is a proof: any team that did better would break
the arithmetic it quotes.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from math import inf
from typing import TYPE_CHECKING

from tsplan.explanation.explanation import Fact
from tsplan.explanation.part_words import agents
from tsplan.explanation.whynot.arrivals import latest_of
from tsplan.explanation.whynot.context import Context
from tsplan.explanation.whynot.group_conflicts import divided
from tsplan.explanation.whynot.supply import scarcity
from tsplan.explanation.whynot.time_conflicts import contradictions, crowding, timing
from tsplan.explanation.whynot.waiting import restless, stuck

if TYPE_CHECKING:
    from tsplan.explanation.whynot.arrivals import Arrival
    from tsplan.explanation.whynot.unconditional_demands import Demand

MOST_FACTS = 20
"""Facts that are listed; the rest would only repeat them."""

Finder = Callable[[Context], Iterator[Fact]]


def find_facts(context: Context) -> tuple[Fact, ...]:
    """All facts that forbid every plan, those of the simplest kinds first."""
    return tuple(facts_of(context))


def facts_of(context: Context) -> Iterator[Fact]:
    """The same one by one, as they are found."""
    finders: tuple[Finder, ...] = (
        stuck,
        scarcity,
        divided,
        unreachable,
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
            for state, arrivals in _places(context, need)
            if latest_of(arrivals, need.amount) > need.span.last
        ]
        if late and (need.reach != "one" or len(late) == len(need.states)):
            state, arrivals = late[0]
            text = _too_late(context, need, state, arrivals)
            able = context.team(need.capability, "start", "team")
            yield context.fact("reach", text, [need], *able)


def _places(context: Context, need: Demand) -> list[tuple[str, list[Arrival]]]:
    if need.reach == "together":
        nearest = context.arrivals.within(need.states, need.capability)
        return [(need.states[0], nearest)]
    return [(state, context.arrivals.within((state,), need.capability)) for state in need.states]


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
    if missing.step == inf:
        return f"{text}: there is no way for class {group.class_name} from '{missing.start}'"
    target = state
    if need.reach == "together":
        distance = {s: context.arrivals.between(group, missing.start, s) for s in need.states}
        target = min(need.states, key=lambda name: distance[name])
    way = context.arrivals.way(group, missing.start, target)
    which = "next" if inside else "first"
    return (
        f"{text}: the {which} is one of class {group.class_name} from '{missing.start}', at step "
        f"{int(missing.step)} by {_shown(way)}"
    )


def _shown(way: list[str]) -> str:
    """A way in words, its middle left out where it is long."""
    most = 6
    if len(way) <= most:
        return " > ".join(way)
    return " > ".join([*way[:3], f"... {len(way) - 5} more ...", *way[-2:]])
