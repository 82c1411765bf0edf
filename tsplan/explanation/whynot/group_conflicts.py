"""What breaks the bounds of swarms and is seen without a solver."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from tsplan.explanation.explanation import Fact, SoftConstraint
from tsplan.explanation.part_words import agents, counted, swarm_words
from tsplan.explanation.whynot.context import able
from tsplan.explanation.whynot.mission_numbers import TOGETHER
from tsplan.explanation.whynot.supply import apart, instants, moments

if TYPE_CHECKING:
    from tsplan.explanation.whynot.context import Context
    from tsplan.explanation.whynot.unconditional_demands import Demand
    from tsplan.mission import Mission


def divided(context: Context) -> Iterator[Fact]:
    """More places at one step than sub-swarms, or than there are agents for sub-swarms."""
    if context.mission.swarm is None:
        return
    yield from _begun(context)
    yield from _all_swarms(context)
    for together in moments(context):
        name = _swarm_of(context.mission, together)
        if name is not None:
            yield from _too_many(context, name, _places(together))


def _begun(context: Context) -> Iterator[Fact]:
    """Bounds that the start already breaks."""
    rules = context.mission.swarm
    assert rules is not None
    broken: list[tuple[str, tuple[str, str]]] = []
    begin = 0
    for group in context.mission.team:
        name, places = group.class_name, len(group.starts)
        bounds = rules.each.get(name)
        if bounds is None:
            continue  # robots
        begin += places
        whose = swarm_words(context.mission, name)
        if bounds.most is not None and places > bounds.most:
            text = f"{whose} starts at {places} states, in as many sub-swarms"
            broken.append((text, (name, "most")))
        broken += (
            (f"only {agents(count, None)} of {whose} start at '{state}'", (name, "least"))
            for state, count in group.starts
            if 0 < count < bounds.least
        )
    if rules.together is not None and begin > rules.together:
        broken.append((f"the swarms start at {begin} states, in as many sub-swarms", TOGETHER))
    for text, key in broken:
        parts = context.wording.parts({SoftConstraint("swarm", key)})
        yield Fact("swarm", f"{text}, and {parts[0].text}", parts[0].place, parts)


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
            sites = _places(own)
            needs += [need for need, _ in sites]
            number += max(len(sites), 1)  # every swarm is somewhere
            places = ", ".join(place for _, place in sites) or "anywhere"
            words.append(f"{name} at {max(len(sites), 1)} ({places})")
        if needs and number > rules.together:
            text = (
                f"at one step there must be {counted(number, 'sub-swarm')}: {', '.join(words)}; "
                f"all swarms together may be divided into "
                f"{counted(rules.together, 'sub-swarm')} at most"
            )
            yield context.fact("swarm", text, needs, SoftConstraint("swarm", TOGETHER))


def _swarm_of(mission: Mission, needs: Sequence[Demand]) -> str | None:
    """The one swarm that must meet the needs, which are all for one capability."""
    assert mission.swarm is not None
    names = [group.class_name for _, group in able(mission, needs[0].capability)]
    return names[0] if len(names) == 1 and names[0] in mission.swarm.each else None


def _places(needs: Sequence[Demand]) -> list[tuple[Demand, str]]:
    """Places at which agents must be at once, with the needs; those of few states first."""
    return apart(needs, lambda need: len(need.states))


def _too_many(context: Context, name: str, sites: list[tuple[Demand, str]]) -> Iterator[Fact]:
    """What forbids agents at so many places at once."""
    rules = context.mission.swarm
    assert rules is not None
    bounds = rules.each[name]
    needs = [need for need, _ in sites]
    where = f"at one step agents must be at {len(sites)} places ({', '.join(p for _, p in sites)})"
    whose = swarm_words(context.mission, name)
    if bounds.most is not None and bounds.most < len(sites):
        most = counted(bounds.most, "sub-swarm")
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
