"""The bounds of swarms as elements of a mission: what they are, and the rules without some."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import TYPE_CHECKING

from tsplan.explanation.agent_numbers import agents
from tsplan.explanation.explanation import Element, Part, Place
from tsplan.logic.text import number_text
from tsplan.mission import SwarmBounds, SwarmRules

if TYPE_CHECKING:
    from tsplan.mission import Mission

TOGETHER = Element("swarm", ("", "most"))
"""The bound on the sub-swarms of all swarms together."""

MARGIN = Element("swarm", ("", "margin"))
"""The head-room that every demand is kept away from."""


def most_of(name: str) -> Element:
    """The bound on the number of sub-swarms of one swarm."""
    return Element("swarm", (name, "most"))


def least_of(name: str) -> Element:
    """The bound on the size of the sub-swarms of one swarm."""
    return Element("swarm", (name, "least"))


def swarm_bounds(mission: Mission) -> tuple[Element, ...]:
    """What bounds the swarms of a mission; nothing for a team."""
    rules = mission.swarm
    if rules is None:
        return ()
    found = []
    for name, bounds in rules.each.items():
        if bounds.most is not None:
            found.append(most_of(name))
        if bounds.least > 1:
            found.append(least_of(name))
    if rules.together is not None:
        found.append(TOGETHER)
    if rules.margin:
        found.append(MARGIN)
    return tuple(found)


def unbounded(rules: SwarmRules, gone: frozenset[Element]) -> SwarmRules:
    """The rules without some of their bounds."""
    each = {
        name: SwarmBounds(
            None if most_of(name) in gone else bounds.most,
            1 if least_of(name) in gone else bounds.least,
        )
        for name, bounds in rules.each.items()
    }
    return SwarmRules(
        each,
        None if TOGETHER in gone else rules.together,
        Fraction(0) if MARGIN in gone else rules.margin,
    )


def bound_of(rules: SwarmRules, element: Element) -> Fraction | int | None:
    """What the rules say of a bound."""
    name, what = element.key
    if element == MARGIN:
        return rules.margin
    if element == TOGETHER:
        return rules.together
    return rules.each[name].most if what == "most" else rules.each[name].least


def with_bound(rules: SwarmRules | None, element: Element, value: int) -> SwarmRules:
    """The rules with another number of sub-swarms, or another least size."""
    assert rules is not None
    name, what = element.key
    if element == TOGETHER:
        return replace(rules, together=value)
    bounds = rules.each[name]
    bounds = replace(bounds, most=value) if what == "most" else replace(bounds, least=value)
    return replace(rules, each={**rules.each, name: bounds})


def swarm_part(mission: Mission, element: Element, place: Place) -> Part:
    """A bound in words."""
    rules = mission.swarm
    assert rules is not None
    name, what = element.key
    whose = f"the swarm '{name}'" if len(rules.each) > 1 else "the swarm"
    if element == MARGIN:
        text = f"every demand is met with {room_of(rules.margin)} to spare (margin)"
    elif element == TOGETHER:
        text = f"all swarms together have at most {sub_swarms(rules.together or 0)} at a step"
    elif what == "most":
        text = f"{whose} has at most {sub_swarms(rules.each[name].most or 0)} at a step"
    else:
        text = f"every sub-swarm of {whose} has at least {agents(rules.each[name].least, None)}"
    return Part("swarm", text, place, frozenset({element}))


def path_of(mission: Mission, element: Element) -> tuple[str | int, ...]:
    """Where a mission file says a bound."""
    assert mission.swarm is not None
    name, what = element.key
    if element == MARGIN:
        return ("margin",)
    key = "max_subswarms" if what == "most" else "min_subswarm"
    if element == TOGETHER:
        return (key,)
    names = list(mission.swarm.each)
    data = mission.origin.data if mission.origin is not None else {}
    return ("swarms", names.index(name), key) if "swarms" in data else ("swarm", key)


def sub_swarms(number: int) -> str:
    """A number of sub-swarms in words."""
    return f"{number} sub-swarm{'' if number == 1 else 's'}"


def room_of(margin: Fraction | int) -> str:
    """A head-room in words."""
    return (
        agents(margin, None) if isinstance(margin, int) else f"{number_text(float(100 * margin))}%"
    )
