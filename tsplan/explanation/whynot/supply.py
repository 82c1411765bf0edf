"""What must be staffed at one and the same step: too few agents for it, or too few sub-swarms."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING, Any

from tsplan.explanation.explanation import Fact, SoftConstraint
from tsplan.explanation.part_words import agents, swarm_words
from tsplan.explanation.whynot.context import able
from tsplan.explanation.whynot.mission_numbers import TOGETHER
from tsplan.explanation.whynot.unconditional_demands import Demand, Span, demands_below, required
from tsplan.mission.team import UnderWay
from tsplan.words import many

if TYPE_CHECKING:
    from tsplan.explanation.whynot.context import Context
    from tsplan.explanation.whynot.module_builders import Builder
    from tsplan.mission import Mission


def scarcity(context: Context) -> Iterator[Fact]:
    """A task that needs more robots than have the capability; then several at one step."""
    alone: set[str | None] = set()
    for need in context.needs:
        if need.total > context.mission.having(need.capability):
            alone.add(need.capability)
            text = f"{_wanted(need)}; the team has {context.having(need.capability)}"
            yield context.fact("scarcity", text, [need], *context.team(need.capability, "team"))
    for together in moments(context):
        context.pause()
        capability = together[0].capability
        total = _at_once(together)
        if capability not in alone and total > context.mission.having(capability):
            parts = " and ".join(_wanted(need) for need in together)
            text = (
                f"at one step, {parts}: {agents(total, capability)} in all; "
                f"the team has {context.having(capability)}"
            )
            yield context.fact("scarcity", text, together, *context.team(capability, "team"))


def unbuilt(context: Context) -> Iterator[Fact]:
    """Structures at one step that together have more modules than there are."""
    for now in instants(context):
        needs: dict[int, list[tuple[Demand, Builder]]] = {}
        for need, _ in _apart(now, lambda need: (need.reach != "each", -need.amount)):
            built = context.builders(need.capability)
            robots = (g.configuration is None for _, g in able(context.mission, need.capability))
            if len(built) == 1 and not any(robots):
                needs.setdefault(built[0].pool.groups[0], []).append((need, built[0]))
        for own in needs.values():
            together = list(dict.fromkeys(need for need, _ in own))
            asked = sum(need.amount * builder.least for need, builder in own)
            pool, single = own[0][1].pool, len({need.capability for need in together}) == 1
            if asked > pool.count and not single:  # of one capability, that is scarcity
                parts = " and ".join(_wanted(need) for need in together)
                text = (
                    f"at one step, {parts}: structures of {asked} modules or more in all; the team "
                    f"has {pool.count} {own[0][1].group.class_name}"
                )
                entries = [item for n in pool.groups for item in context.entry(n, "team")]
                yield context.fact("scarcity", text, together, *entries)


def _wanted(need: Demand) -> str:
    """What a need asks for, with the arithmetic over its states."""
    where = f"'{need.label}'"
    if need.reach == "each" and len(need.states) > 1:
        sum_ = f"{need.amount} at each of the {len(need.states)} states {where}"
        return f"{agents(need.total, need.capability)} are needed ({sum_})"
    verb = "is" if need.amount == 1 else "are"
    return f"{agents(need.amount, need.capability)} {verb} needed at {where}"


def moments(context: Context) -> Iterator[list[Demand]]:
    """Needs for one capability that begin at the same step, whenever that is."""
    for now in instants(context):
        for capability in dict.fromkeys(item.capability for item in now):
            together = [item for item in now if item.capability == capability]
            if len(together) > 1:
                yield together


def instants(context: Context) -> Iterator[list[Demand]]:
    """All needs that begin at the same step, whenever that is."""
    for way, node, _, moved in required((), context.mission.formula, Span(0, 0)):
        if not moved:  # said with what it stands in
            continue
        context.pause()
        yield [
            item
            for item in demands_below(context.mission, way, node, Span(0, 0))
            if not item.upper and item.amount > 0 and item.span.first == item.span.last == 0
        ]


def _apart(needs: Sequence[Demand], order: Callable[[Demand], Any]) -> list[tuple[Demand, str]]:
    """Needs for agents at places that no other one of them shares, with how the place is called.

    Of needs that share a place, the first in some order counts.
    """
    taken: set[str] = set()
    found = []
    for need in sorted(needs, key=order):
        each = need.states if need.reach == "each" else ()
        for state in each:
            if state not in taken:
                found.append((need, f"'{state}'"))
                taken.add(state)
        if not each and not taken & set(need.states):
            found.append((need, f"'{need.label}'"))
            taken |= set(need.states)
    return found


def _at_once(needs: Sequence[Demand]) -> int:
    """Different agents that the needs ask for together, at least: those of disjoint places."""
    disjoint = _apart(needs, lambda need: (need.reach != "each", -need.amount))
    return max(sum(need.amount for need, _ in disjoint), *(need.total for need in needs))


# --- bounds of swarms --------------------------------------------------------------------------


def divided(context: Context) -> Iterator[Fact]:
    """More places at one step than sub-swarms, or than there are agents for sub-swarms."""
    if context.mission.swarm is None:
        return
    yield from _begun(context)
    yield from _all_swarms(context)
    for together in moments(context):
        name = _swarm_of(context.mission, together)
        if name is not None:
            yield from _too_many(context, name, _apart(together, _few_states))


def _begun(context: Context) -> Iterator[Fact]:
    """Bounds that the start already breaks."""
    rules = context.mission.swarm
    assert rules is not None
    broken: list[tuple[str, tuple[str, str]]] = []
    begin = 0
    for group in context.mission.team:
        name, places = group.class_name, len(group.all_starts)
        bounds = rules.each.get(name)
        if bounds is None:
            continue  # robots
        begin += places
        whose = swarm_words(context.mission, name)
        if bounds.most is not None and places > bounds.most:
            kind = "places" if group.coming else "states"
            text = f"{whose} starts at {places} {kind}, in as many sub-swarms"
            broken.append((text, (name, "most")))
        broken += (
            (f"only {agents(count, None)} of {whose} start {_where(start)}", (name, "least"))
            for start, count in group.all_starts
            if 0 < count < bounds.least
        )
    if rules.together is not None and begin > rules.together:
        kind = "places" if any(group.coming for group in context.mission.team) else "states"
        broken.append((f"the swarms start at {begin} {kind}, in as many sub-swarms", TOGETHER))
    for text, key in broken:
        parts = context.wording.parts({SoftConstraint("swarm", key)})
        yield Fact("swarm", f"{text}, and {parts[0].text}", parts[0].place, parts)


def _where(start: str | UnderWay) -> str:
    return start.words if isinstance(start, UnderWay) else f"at '{start}'"


def _all_swarms(context: Context) -> Iterator[Fact]:
    """More sub-swarms of all swarms at one step than may be."""
    rules = context.mission.swarm
    if rules is None or rules.together is None:
        return
    for now in instants(context):
        needs: list[Demand] = []
        words, number = [], 0
        for name in rules.each:
            own = [item for item in now if _swarm_of(context.mission, [item]) == name]
            sites = _apart(own, _few_states)
            needs += [need for need, _ in sites]
            number += max(len(sites), 1)  # every swarm is somewhere
            places = ", ".join(place for _, place in sites) or "anywhere"
            words.append(f"{name} at {max(len(sites), 1)} ({places})")
        if needs and number > rules.together:
            text = (
                f"at one step there must be {many(number, 'sub-swarm')}: {', '.join(words)}; "
                f"all swarms together may be divided into "
                f"{many(rules.together, 'sub-swarm')} at most"
            )
            yield context.fact("swarm", text, needs, SoftConstraint("swarm", TOGETHER))


def _swarm_of(mission: Mission, needs: Sequence[Demand]) -> str | None:
    """The one swarm that must meet the needs, which are all for one capability."""
    assert mission.swarm is not None
    names = [group.class_name for _, group in able(mission, needs[0].capability)]
    return names[0] if len(names) == 1 and names[0] in mission.swarm.each else None


def _too_many(context: Context, name: str, sites: list[tuple[Demand, str]]) -> Iterator[Fact]:
    """What forbids agents at so many places at once."""
    rules = context.mission.swarm
    assert rules is not None
    bounds = rules.each[name]
    needs = [need for need, _ in sites]
    where = f"at one step agents must be at {len(sites)} places ({', '.join(p for _, p in sites)})"
    whose = swarm_words(context.mission, name)
    if bounds.most is not None and bounds.most < len(sites):
        most = many(bounds.most, "sub-swarm")
        text = f"{where}; {whose} may be divided into {most} at most"
        yield context.fact("swarm", text, needs, SoftConstraint("swarm", (name, "most")))
    size = context.mission.having(needs[0].capability)
    sizes = [max(need.amount, bounds.least) for need in needs]
    if sum(sizes) > size >= sum(need.amount for need in needs):
        text = (
            f"{where}, in sub-swarms of {bounds.least} or more: {sum(sizes):,} in all; "
            f"{whose} has {size:,}"
        )
        yield context.fact("swarm", text, needs, SoftConstraint("swarm", (name, "least")))


def _few_states(need: Demand) -> int:
    return len(need.states)
