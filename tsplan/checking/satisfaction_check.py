"""How much of a mission a plan satisfies, computed from the agents' counts alone."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

from tsplan.logic import Count, Formula, Limit, Percent, Task, fold, walk
from tsplan.logic.evaluation import robustness
from tsplan.logic.fraction import preference, shares
from tsplan.logic.text import text_of
from tsplan.logic.witness_steps import levels, parts
from tsplan.plans.outcomes import Status
from tsplan.plans.plan import Plan
from tsplan.plans.satisfaction import Depth, Node, PreferenceSatisfaction, Satisfaction
from tsplan.words import known

if TYPE_CHECKING:
    from tsplan.logic.traces import CountTrace, Trace
    from tsplan.mission import Mission

MOST_LETTERS = 1000
"""Letters of a part of a formula in a plan; longer ones are cut off."""


def satisfaction_of(mission: Mission, trace: CountTrace) -> Satisfaction:
    """How much of the formula holds of a mission that lets it hold in part."""
    tree = mission.tree(mission.formula)
    by_depth = mission.satisfaction != "weighted"
    counts = levels(tree, trace).counts if by_depth else ()
    return Satisfaction(
        order=mission.satisfaction,
        fraction=shares(tree, trace)[tree][0].fraction,
        availability=known(least_spare([(tree, True)], trace)),
        depths=tuple(Depth(depth, count) for depth, count in enumerate(counts)),
        nodes=_nodes(mission, mission.formula, trace),
        preference=preference(tree, trace),
    )


def slack_of(mission: Mission, trace: CountTrace, availability: float) -> float:
    """Agents to spare at all that holds: what must, and what may and does; infinite for nothing.

    Of a formula that may hold in part it is what counts in its order: the atoms that its fraction
    is made of, or all parts that hold while none around them does. `availability` is that of the
    formula as a whole.
    """
    if not mission.partial:
        wishes = [(mission.tree(item.formula), item.partial) for item in mission.prefer]
        return least_spare(wishes, trace, availability)
    tree = mission.tree(mission.formula)
    by_depth = mission.satisfaction != "weighted"
    return levels(tree, trace).spare if by_depth else least_spare([(tree, True)], trace)


def least_spare(
    trees: Iterable[tuple[Formula, bool]], trace: Trace, least: float = math.inf
) -> float:
    """The least robustness of what holds of trees, each of which counts in part or as a whole."""
    for tree, partial in trees:
        if partial:
            least = min(least, shares(tree, trace, weighted=True)[tree][0].spare)
        else:
            slack = float(robustness(tree, trace)[..., 0])
            least = min(least, slack) if slack >= 0 else least
    return least


def preferences_of(mission: Mission, trace: CountTrace) -> tuple[PreferenceSatisfaction, ...]:
    """What became of every preferred formula, in the mission's order."""
    found = []
    for wish in mission.prefer:
        nodes = _nodes(mission, wish.formula, trace)
        by = preference(mission.tree(wish.formula), trace)
        own = wish.name, wish.weight, wish.level, wish.partial
        found.append(PreferenceSatisfaction(*own, nodes[0].fraction, nodes, by))
    return tuple(found)


def _nodes(mission: Mission, formula: Formula, trace: CountTrace) -> tuple[Node, ...]:
    """The parts of a formula with their texts; tasks, limits and shares as they are written."""
    tree = mission.tree(formula)
    written: dict[Formula, Formula] = {
        mission.tree(node): node
        for node in walk(formula)
        if isinstance(node, Task | Limit)
        or (isinstance(node, Count) and isinstance(node.bound, Percent))
    }
    shown: dict[Formula, Formula] = {}

    def show(node: Formula, below: tuple[Formula, ...]) -> Formula:
        shown[node] = written[node] if node in written else node.over(below)
        return shown[node]

    fold(tree, show)
    return tuple(
        Node(
            text_of(shown[part.node], MOST_LETTERS),
            part.depth,
            (part.first, part.last),
            part.fraction,
            part.counted,
        )
        for part in parts(tree, trace)
    )


def completed(given: Satisfaction | None, actual: Satisfaction | None) -> Satisfaction | None:
    """What was computed, with the bounds that are claimed of the depths."""
    if given is None or actual is None:
        return actual
    bounds = {item.depth: item.bound for item in given.depths}
    depths = tuple(replace(item, bound=bounds.get(item.depth)) for item in actual.depths)
    return replace(actual, depths=depths)


def false_claims(
    plan: Plan, satisfaction: Satisfaction | None, preferences: tuple[PreferenceSatisfaction, ...]
) -> Iterator[str]:
    """What a plan says about what it satisfies and is not so."""
    claimed = plan.satisfaction
    if (claimed is None) != (satisfaction is None):
        lacks = "says nothing" if claimed is None else "speaks"
        yield f"the plan {lacks} about satisfaction, unlike its mission"
    elif claimed is not None and satisfaction is not None:
        yield from _false_satisfaction(claimed, satisfaction, plan.status)
    if [item.name for item in plan.preferences] != [item.name for item in preferences]:
        yield "the plan's preferences are not the mission's"
        return
    for given, actual in zip(plan.preferences, preferences, strict=True):
        if given != actual:
            what = f"account of preference '{given.name}' is not so"
            by = "" if actual.preference is None else f" and its preference {actual.preference}"
            yield f"the plan's {what}: its fraction is {actual.fraction}{by}"


def _false_satisfaction(
    claimed: Satisfaction, actual: Satisfaction, status: Status
) -> Iterator[str]:
    if claimed.order != actual.order:
        yield f"the plan claims the order {claimed.order}, not {actual.order}"
        return
    if claimed.fraction != actual.fraction:
        yield f"the plan claims satisfaction {claimed.fraction} and has {actual.fraction}"
    if claimed.preference != actual.preference:
        said, true = (item.preference or "none" for item in (claimed, actual))
        yield f"the plan claims the preference {said} and has {true}"
    if claimed.availability != actual.availability:
        yield (
            f"the plan claims availability {claimed.availability} of what it satisfies and has "
            f"{actual.availability}"
        )
    if claimed.nodes != actual.nodes:
        yield "the plan's account of what holds of each part is not so"
    counts = [item.value for item in actual.depths]
    if [item.value for item in claimed.depths] != counts:
        yield f"by depth {', '.join(map(str, counts)) or 'nothing'} parts hold"
        return
    yield from _false_bounds(claimed.depths, status)


def _false_bounds(depths: tuple[Depth, ...], status: Status) -> Iterator[str]:
    for item in depths:
        if item.bound is None:
            break
        parts = f"{item.value} parts of depth {item.depth} are"
        if item.value > item.bound:
            yield f"{parts} more than their bound {item.bound}"
        elif item.value < item.bound:
            if status is Status.OPTIMAL:
                yield f"{parts} called optimal with the bound {item.bound}"
            break  # what is said of deeper parts does not hold any more
