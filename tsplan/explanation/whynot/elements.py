"""What a mission consists of, as elements that can be taken out one by one."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tsplan.explanation.explanation import Element
from tsplan.explanation.whynot.group_bounds import swarm_bounds
from tsplan.explanation.whynot.occurrences import Leaf, conjuncts, leaves
from tsplan.explanation.whynot.waiting import waiting_elements

if TYPE_CHECKING:
    from tsplan.mission import Mission

Group = frozenset[Element]


def of_leaf(leaf: Leaf) -> Element:
    """The element of a part of the formula."""
    return Element("formula", tuple(leaf))


def leaf_of(element: Element) -> Leaf:
    """The part of the formula that an element stands for."""
    return Leaf(*element.key)


def formula_groups(mission: Mission) -> tuple[tuple[Element, ...], ...]:
    """The leaves of the formula, those of one conjunct together, in the order of the text."""
    formula = mission.formula
    return tuple(
        tuple(of_leaf(leaf) for leaf in leaves(formula, way)) for way in conjuncts(formula)
    )


def named_facts(mission: Mission) -> tuple[Element, ...]:
    """Everything that bounds the plans beside the formula, what matters most to people first.

    How many robots an entry of the team has and where they start can be taken out of a team, and
    from a swarm how it may divide and its head-room; its size and its start stay, and so does the
    map, but for its capacities and for states without a wait.
    """
    entries = range(len(mission.team)) if mission.swarm is None else ()
    return (
        *(Element("team", (number,)) for number in entries),
        *(Element("start", (number,)) for number in entries),
        *waiting_elements(mission),
        *swarm_bounds(mission),
        *capacities(mission),
    )


def capacities(mission: Mission) -> tuple[Element, ...]:
    """The capacities of states, and of edges by the direction that comes first."""
    system = mission.system
    return (
        *(
            Element("capacity", (state.name,))
            for state in system.states.values()
            if state.capacity is not None
        ),
        *(Element("capacity", pairs[0]) for _, pairs in system.capacity_groups),
    )
