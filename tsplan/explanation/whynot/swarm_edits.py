"""The bounds of swarms: stepwise looser, and what breaks them without a solver."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import TYPE_CHECKING

from tsplan.explanation.agent_numbers import agents
from tsplan.explanation.explanation import Element, Fact
from tsplan.explanation.whynot.group_bounds import (
    MARGIN,
    TOGETHER,
    bound_of,
    least_of,
    most_of,
    room_of,
    sub_swarms,
    with_bound,
)
from tsplan.explanation.whynot.supply import instants, moments

if TYPE_CHECKING:
    from tsplan.explanation.explanation import ChangeKind
    from tsplan.explanation.whynot.facts import View
    from tsplan.explanation.whynot.unconditional_demands import Demand
    from tsplan.mission import Mission

# --- changes -----------------------------------------------------------------------------------


@dataclass(frozen=True)
class LooserBound:
    """More sub-swarms, smaller ones, or less head-room (in agents, or hundredths of the swarm)."""

    element: Element
    most: int
    kind: ChangeKind

    @classmethod
    def of(cls, mission: Mission, element: Element) -> LooserBound | None:
        """The bound of a mission; None where it cannot be loosened."""
        rules = mission.swarm
        assert rules is not None
        name, what = element.key
        if element == MARGIN:
            whole = isinstance(rules.margin, int)
            most = rules.margin if whole else -(-100 * rules.margin // 1)
            return cls(element, int(most), "lower_need")
        if what == "least":
            return cls(element, rules.each[name].least - 1, "loosen_limit")
        now = rules.together if element == TOGETHER else rules.each[name].most
        most = mission.size - (now or 0)
        return cls(element, most, "more_subswarms") if most > 0 else None

    def applied(self, mission: Mission, amount: int) -> Mission:
        """The mission with the looser bound."""
        rules = mission.swarm
        assert rules is not None
        now = bound_of(rules, self.element)
        if self.element == MARGIN:
            less = amount if isinstance(rules.margin, int) else Fraction(amount, 100)
            changed = replace(rules, margin=max(rules.margin - less, 0 * less))
        else:
            assert isinstance(now, int)
            looser = now - amount if self.element.key[1] == "least" else now + amount
            changed = with_bound(rules, self.element, looser)
        return replace(mission, swarm=changed, warnings=())

    def words(self, mission: Mission, amount: int) -> str:
        """The bound, from what to what."""
        before, after = mission.swarm, self.applied(mission, amount).swarm
        assert before is not None
        assert after is not None
        name, what = self.element.key
        if self.element == MARGIN:
            return f"lower the margin from {room_of(before.margin)} to {room_of(after.margin)}"
        if self.element == TOGETHER:
            text = f"from {before.together} to {after.together}"
            return f"raise max_subswarms of all swarms together {text}"
        one, other = before.each[name], after.each[name]
        whose = f" of swarm '{name}'" if len(before.each) > 1 else ""
        if what == "most":
            return f"raise max_subswarms{whose} from {one.most} to {other.most}"
        return f"lower min_subswarm{whose} from {one.least} to {other.least}"


# --- facts -------------------------------------------------------------------------------------


def divided(view: View) -> Iterator[Fact]:
    """More places at one step than sub-swarms, or than there are agents for sub-swarms."""
    mission = view.mission
    if mission.swarm is None:
        return
    yield from _begun(view)
    yield from _all_swarms(view)
    for together in moments(view):
        name = _swarm_of(mission, together)
        if name is None:
            continue
        yield from _too_many(view, name, _apart(together))


def _begun(view: View) -> Iterator[Fact]:
    """Bounds that the start already breaks."""
    rules = view.mission.swarm
    assert rules is not None
    for group in view.mission.team:
        name = group.class_name
        bounds = rules.each[name]
        whose = f"the swarm '{name}'" if len(rules.each) > 1 else "the swarm"
        places = len(group.starts)
        if bounds.most is not None and places > bounds.most:
            text = f"{whose} starts at {places} states, in as many sub-swarms"
            yield _of_start(view, text, most_of(name))
        for state, count in group.starts:
            if 0 < count < bounds.least:
                text = f"only {agents(count, None)} of {whose} start at '{state}'"
                yield _of_start(view, text, least_of(name))
    begin = sum(len(group.starts) for group in view.mission.team)
    if rules.together is not None and begin > rules.together:
        text = f"the swarms start at {begin} states, in as many sub-swarms"
        yield _of_start(view, text, TOGETHER)


def _of_start(view: View, text: str, element: Element) -> Fact:
    """A fact about the start and one bound."""
    parts = view.wording.parts({element})
    return Fact("swarm", f"{text}, and {parts[0].text}", parts[0].place, parts)


def _all_swarms(view: View) -> Iterator[Fact]:
    """More sub-swarms of all swarms at one step than may be."""
    rules = view.mission.swarm
    if rules is None or rules.together is None:
        return
    for now in instants(view):
        needs: list[Demand] = []
        words, number = [], 0
        for name in rules.each:
            apart = _apart([item for item in now if _swarm_of(view.mission, [item]) == name])
            needs += [need for need, _ in apart]
            number += max(len(apart), 1)  # every swarm is somewhere
            places = ", ".join(place for _, place in apart) or "anywhere"
            words.append(f"{name} at {max(len(apart), 1)} ({places})")
        if needs and number > rules.together:
            text = (
                f"at one step there must be {sub_swarms(number)}: {', '.join(words)}; all swarms "
                f"together may be divided into {sub_swarms(rules.together)} at most"
            )
            yield view.fact("swarm", text, needs, TOGETHER)


def _swarm_of(mission: Mission, needs: Sequence[Demand]) -> str | None:
    """The one swarm that must meet the needs, which are all for one capability."""
    who = needs[0].capability
    able = [group.class_name for group in mission.team if who is None or who in group.capabilities]
    return able[0] if len(able) == 1 else None


def _apart(needs: Sequence[Demand]) -> list[tuple[Demand, str]]:
    """Needs for agents at places that no other one of them shares, with how it is called."""
    taken: set[str] = set()
    found = []
    for need in sorted(needs, key=lambda item: len(item.states)):
        each = need.states if need.reach == "each" else ()
        for state in each:
            if state not in taken:
                found.append((need, f"'{state}'"))
                taken.add(state)
        if not each and not taken & set(need.states):
            found.append((need, f"'{need.label}'"))
            taken |= set(need.states)
    return found


def _too_many(view: View, name: str, apart: list[tuple[Demand, str]]) -> Iterator[Fact]:
    """What forbids agents at so many places at once."""
    rules = view.mission.swarm
    assert rules is not None
    bounds = rules.each[name]
    needs = [need for need, _ in apart]
    where = f"at one step agents must be at {len(apart)} places ({', '.join(p for _, p in apart)})"
    whose = f"the swarm '{name}'" if len(rules.each) > 1 else "the swarm"
    if bounds.most is not None and bounds.most < len(apart):
        text = f"{where}; {whose} may be divided into {sub_swarms(bounds.most)} at most"
        yield view.fact("swarm", text, needs, most_of(name))
    size = view.mission.having(needs[0].capability)
    sizes = [max(need.amount, bounds.least) for need in needs]
    if sum(sizes) > size >= sum(need.amount for need in needs):
        text = (
            f"{where}, in sub-swarms of {bounds.least} or more: {sum(sizes):,} in all; "
            f"{whose} has {size:,}"
        )
        yield view.fact("swarm", text, needs, least_of(name))
