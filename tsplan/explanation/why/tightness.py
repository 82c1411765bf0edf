"""What is tight about a mission that can be met: what holds availability down, and deadlines."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from math import isinf
from typing import TYPE_CHECKING

from tsplan.explanation.agent_numbers import agents
from tsplan.explanation.explanation import Element, Fact, Place
from tsplan.explanation.why.critical_atoms import Critical, critical_atoms
from tsplan.explanation.whynot.changes import least
from tsplan.explanation.whynot.conflicts import Finder
from tsplan.explanation.whynot.elements import formula_groups, leaf_of
from tsplan.explanation.whynot.formula_edits import edited
from tsplan.explanation.whynot.group_bounds import MARGIN, bound_of, swarm_bounds, with_bound
from tsplan.explanation.whynot.occurrences import Leaf, Way, exchanged, node_at, nodes_along
from tsplan.logic import (
    FALSE,
    Count,
    Eventually,
    Formula,
    Limit,
    Task,
    Until,
    fold,
    positive,
    translate,
)

if TYPE_CHECKING:
    from tsplan.explanation.whynot.facts import View
    from tsplan.explanation.whynot.oracle import Oracle
    from tsplan.mission import Mission
    from tsplan.plans.plan import Plan

_PATIENCE = 30.0  # seconds for one question


def tight_facts(view: View, oracle: Oracle) -> tuple[Fact, ...]:
    """What keeps availability from being higher: in any plan, and in the best one found.

    Swarms have no such objective, and so nothing is said of them here.
    """
    if view.mission.swarm is not None:
        return ()
    best = _most_robust(view.mission, oracle)
    if best is None or best.availability is None or isinf(best.availability):
        return ()
    level = int(best.availability)
    spare = agents(level, None)
    begin = view.wording.sources.place(Leaf(()))
    if best.status != "optimal":
        text = f"the most robust plan found has {spare} to spare; there may be better ones"
        return (Fact("tight", text, begin), *_bindings(view, best))
    text = f"the most robust plans have {spare} to spare (availability {level})"
    reason = _held_down(view, oracle, level)
    if reason:
        named = "; ".join(words for words, _ in reason)
        text += f"; with {level + 1} to spare these cannot hold together: {named}"
    return (Fact("tight", text, reason[0][1] if reason else begin), *_bindings(view, best))


def _most_robust(mission: Mission, oracle: Oracle) -> Plan | None:
    """A plan with the most agents to spare, as far as the time allows."""
    left = oracle.clock.left
    limit = _PATIENCE if left is None else min(_PATIENCE, max(left / 2, 1.0))
    asked = replace(mission, objective=("availability",), prefer=(), warnings=())
    found = oracle.planned(asked, limit)
    return found if found is not None and found.has_paths else None


def _bindings(view: View, best: Plan) -> Iterator[Fact]:
    """The atoms whose availability is that of the whole plan, with states and steps."""
    for item in critical_atoms(view.mission, best):
        part = view.wording.part_of(item.leaf)
        yield Fact("tight", f"{part.text}: {_counted(item)}", part.place, (part,))


def _counted(item: Critical) -> str:
    steps = ", ".join(
        f"{first}" if first == last else f"{first}..{last}" for first, last in item.steps
    )
    when = f"step {steps}" if steps.isdigit() else f"steps {steps}"
    if item.atom is None:
        return f"no more to spare at {when}"
    asked = "at most" if item.atom.relation == "<=" else "at least"
    return (
        f"{agents(item.count, item.atom.capability)} at {item.place} at {when}, "
        f"{asked} {item.atom.bound} asked for"
    )


def _held_down(view: View, oracle: Oracle, level: int) -> list[tuple[str, Place]]:
    """An irreducible set of requirements that cannot hold with one agent more to spare."""
    mission = view.mission
    harder = replace(mission, formula=tightened(mission, level + 1), objective=(), warnings=())
    harder = replace(harder, text=str(harder.formula))
    other = oracle.about(harder)
    other.patience = _PATIENCE
    finder = Finder(other)
    core = finder.within(finder.everything)
    if core is None:
        return []
    known = [item for group in formula_groups(mission) for item in group]
    elements = {item for item in core.elements if item.kind != "formula"}
    elements.update(
        item
        for item in known
        if any(_within(e, item) for e in core.elements if e.kind == "formula")
    )
    return [(part.text, part.place) for part in view.wording.parts(elements)]


def _within(element: Element, known: Element) -> bool:
    """Whether an element of the tightened formula came from one of the formula itself."""
    (way, pair), (origin, number) = leaf_of(element), leaf_of(known)
    return way[: len(origin)] == origin and (number is None or pair is None or pair == number)


def tightened(mission: Mission, level: int) -> Formula:
    """The formula that holds exactly where the mission's has availability of at least `level`."""
    formula = mission.formula
    ways = {leaf_of(item).way for group in formula_groups(mission) for item in group}
    return exchanged(
        formula, {way: _tighter(mission, node_at(formula, way), level) for way in ways}
    )


def _tighter(mission: Mission, node: Formula, level: int) -> Formula:
    """One leaf with `level` to spare; what tasks and limits cannot say is said by counts."""
    if isinstance(node, Task):
        return replace(node, needs=tuple((name, m + level) for name, m in node.needs))
    if isinstance(node, Limit):
        needs = node.needs or ((None, 0),)
        if any(most < level for _, most in needs):
            return FALSE
        return replace(node, needs=tuple((name, m - level) for name, m in node.needs))

    def atom(part: Formula, below: tuple[Formula, ...]) -> Formula:
        if not isinstance(part, Count):
            return part.over(below)
        assert isinstance(part.bound, int)
        return replace(part, bound=part.bound + (level if part.relation == ">=" else -level))

    return fold(positive(translate(node, interval=mission.task_interval)), atom)


def slacks(view: View, oracle: Oracle) -> Iterator[Fact]:
    """How much sooner each deadline, and how much tighter each bound of a swarm, could be."""
    oracle.patience = _PATIENCE
    for way in _deadlines(view.mission):
        yield _slack(view, oracle, way)
    for element in swarm_bounds(view.mission):
        if element != MARGIN:
            yield _bound_slack(view, oracle, element)


def _bound_slack(view: View, oracle: Oracle, element: Element) -> Fact:
    """How much tighter a bound of a swarm could be with a plan still there."""
    mission = view.mission
    assert mission.swarm is not None
    now = bound_of(mission.swarm, element)
    assert isinstance(now, int)
    larger = element.key[1] == "least"
    most = mission.size - now if larger else now - 1

    def impossible(steps: int) -> bool | None:
        value = now + steps if larger else now - steps
        answer = oracle.met(replace(mission, swarm=with_bound(mission.swarm, element, value)))
        return None if answer is None else not answer

    found = least(impossible, most) if most > 0 else None
    part = view.wording.fact(element)
    if found is None:
        far = most if most == 0 or impossible(most) is False else None
    else:
        far = found.amount - 1 if found.proven or found.amount > 1 else None
    if far is None:
        text = "how much tighter it could be is open: no time"
    elif far == 0:
        text = "it cannot be tighter"
    else:
        sure = "" if found is None or found.proven else " at least"
        text = f"it could be{sure} {now + far if larger else now - far}"
    return Fact("slack", f"{part.text}: {text}", part.place, (part,))


def _deadlines(mission: Mission) -> list[Way]:
    """The windows that a formula could close sooner, in the order of the text."""
    found: dict[Way, None] = {}
    for group in formula_groups(mission):
        for element in group:
            for way, node in nodes_along(mission.formula, leaf_of(element).way):
                if isinstance(node, Eventually | Until) and node.high > node.low:
                    found[way] = None
    return list(found)


def _slack(view: View, oracle: Oracle, way: Way) -> Fact:
    mission = view.mission
    node = node_at(mission.formula, way)
    assert isinstance(node, Eventually | Until)

    def impossible(steps: int) -> bool | None:
        sooner = edited(mission, Leaf(way), replace(node, high=node.high - steps))
        answer = oracle.met(sooner)
        return None if answer is None else not answer

    most = node.high - node.low
    found = least(impossible, most)
    whole = view.wording.text(Leaf(view.wording.conjunct(way)))
    place = view.wording.sources.place(Leaf(way))
    if found is None:
        known = impossible(most) is False
        text = f"could be {most} steps sooner, at {node.low}" if known else "is open: no time"
    elif found.amount == 1:
        text = "cannot be a step sooner" if found.proven else "is open: no time"
    else:
        steps = found.amount - 1
        sure = "" if found.proven else " at least"
        text = (
            f"could be{sure} {steps} step{'s' if steps > 1 else ''} sooner, at {node.high - steps}"
        )
    return Fact("slack", f"the deadline {node.high} {text}, in {whole}", place)
