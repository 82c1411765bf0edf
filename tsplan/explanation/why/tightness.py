"""What is tight about a mission that can be met: what holds availability down, and deadlines."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from math import isinf
from typing import TYPE_CHECKING, NamedTuple

from tsplan.explanation.explanation import Fact, Place, SoftConstraint
from tsplan.explanation.part_words import agents
from tsplan.explanation.why.critical_atoms import CriticalAtom, critical_atoms
from tsplan.explanation.whynot.changes import least
from tsplan.explanation.whynot.conflicts import Finder
from tsplan.explanation.whynot.context import Context
from tsplan.explanation.whynot.edits import swarm_size
from tsplan.explanation.whynot.mission_numbers import MARGIN, Number
from tsplan.explanation.whynot.occurrences import Occurrence, Way, exchanged, node_at, nodes_along
from tsplan.explanation.whynot.soft_constraints import (
    formula_groups,
    group_bounds,
    occurrence_of,
    robot_entries,
)
from tsplan.logic import (
    FALSE,
    Count,
    Eventually,
    Execution,
    Formula,
    Limit,
    Task,
    Until,
    conjunction,
    fold,
    positive,
    resolve_percent,
    translate,
)
from tsplan.words import many, run_words

if TYPE_CHECKING:
    from tsplan.explanation.whynot.oracle import Oracle
    from tsplan.mission import Mission
    from tsplan.plans.plan import Plan
    from tsplan.signals.result_check import AnyMission

PATIENCE = 30.0
"""Seconds for one question."""


def tight_facts(oracle: Oracle) -> tuple[Fact, ...]:
    """What keeps availability from being higher: in any plan, and in the best one found.

    Swarms are planned for few splits and moves; where there are no robots nothing is said of it.
    """
    context = Context(oracle.subject.mission, oracle.pause)
    if not robot_entries(context.mission):
        return ()
    left = oracle.clock.left
    limit = PATIENCE if left is None else min(PATIENCE, max(left / 2, 1.0))
    wanted = replace(context.mission, objective=("availability",), prefer=(), warnings=())
    best = oracle.planned(wanted, limit)
    if best is None or not best.has_paths:
        return ()
    if best.availability is None or isinf(best.availability):
        return ()  # it asks for nothing
    level = int(best.availability)
    spare = agents(level, None)
    begin = context.wording.sources.place(Occurrence(()))
    if best.status != "optimal":
        text = f"the most robust plan found has {spare} to spare; there may be better ones"
        return (Fact("tight", text, begin), *_bindings(context, best))
    text = f"the most robust plans have {spare} to spare (availability {level})"
    reason = held_down(oracle, tightened(context.mission, level + 1))
    if reason:
        named = "; ".join(words for words, _ in reason)
        text += f"; with {level + 1} to spare these cannot hold together: {named}"
    return (Fact("tight", text, reason[0][1] if reason else begin), *_bindings(context, best))


def _bindings(context: Context, best: Plan) -> Iterator[Fact]:
    """The atoms whose availability is that of the whole plan, with states and steps."""
    for critical in critical_atoms(context.mission, best):
        part = context.wording.part_of(critical.occurrence)
        yield Fact("tight", f"{part.text}: {_at_hand(critical)}", part.place, (part,))


def _at_hand(critical: CriticalAtom) -> str:
    steps = run_words(critical.steps)
    when = f"step {steps}" if steps.isdigit() else f"steps {steps}"
    if critical.atom is None:
        return f"no more to spare at {when}"
    least_or_most = "at most" if critical.atom.relation == "<=" else "at least"
    return (
        f"{agents(critical.count, critical.atom.capability)} at {critical.place} at {when}, "
        f"{least_or_most} {critical.atom.bound} asked for"
    )


def held_down(oracle: Oracle, harder: Formula) -> list[tuple[str, Place]]:
    """An irreducible set of requirements that cannot hold where the formula is made harder."""
    mission = oracle.subject.mission
    changed = replace(mission, formula=harder, text=str(harder), objective=(), warnings=())
    other = oracle.about(changed)
    other.patience = PATIENCE
    finder = Finder(other)
    core = finder.within(finder.everything)
    if core is None:
        return []
    parts = [item for item in core.constraints if item.kind == "formula"]
    constraints = core.constraints.difference(parts) | {
        known
        for group in formula_groups(mission)
        for known in group
        if any(_within(part, known) for part in parts)
    }
    return [(part.text, part.place) for part in oracle.subject.wording.parts(constraints)]


def _within(constraint: SoftConstraint, known: SoftConstraint) -> bool:
    """Whether a part of the tightened formula came from one of the formula itself."""
    (way, need), (origin, number) = occurrence_of(constraint), occurrence_of(known)
    return way[: len(origin)] == origin and (number is None or need is None or need == number)


def part_ways(mission: AnyMission) -> frozenset[Way]:
    """The ways to the parts that a formula is taken apart into."""
    groups = formula_groups(mission)
    return frozenset(occurrence_of(item).way for group in groups for item in group)


def tightened(mission: Mission, level: int) -> Formula:
    """The formula that holds exactly where the mission's has availability of at least `level`."""
    formula = mission.formula
    ways = part_ways(mission)
    return exchanged(
        formula, {way: _tighter(mission, node_at(formula, way), level) for way in ways}
    )


def _tighter(mission: Mission, node: Formula, level: int) -> Formula:
    """One part with `level` to spare; what tasks and limits cannot say is said by counts."""
    if isinstance(node, Task) and not mission.books:
        return replace(node, needs=tuple((name, m + level) for name, m in node.needs))
    if isinstance(node, Limit):
        needs = node.needs or ((None, 0),)
        if any(most < level for _, most in needs):
            return FALSE
        return replace(node, needs=tuple((name, m - level) for name, m in node.needs))

    def atom(part: Formula, below: tuple[Formula, ...]) -> Formula:
        if isinstance(part, Execution):  # plans name what is executed by its task
            duration = part.last + part.begun + (mission.task_interval == "half-open")
            needs = tuple((name, number + level) for name, number in part.needs)
            return Task(duration, part.label, needs, part.resources, part.begun)
        if not isinstance(part, Count):
            return part.over(below)
        assert isinstance(part.bound, int)
        return replace(part, bound=part.bound + (level if part.relation == ">=" else -level))

    plain = translate(node, interval=mission.task_interval)
    counted: Formula = fold(positive(resolve_percent(plain, mission.having)), atom)
    # agents are booked for what a task needs, whoever else is there
    return conjunction((node, counted)) if isinstance(node, Task) else counted


# --- how much tighter numbers could be -----------------------------------------------------------


class _Slack(NamedTuple):
    """How many steps a number could be moved with a plan still there; at least, if not `sure`."""

    steps: int
    sure: bool

    @property
    def least(self) -> str:
        """What is said before a number of steps that may be larger."""
        return "" if self.sure else " at least"


def slacks(oracle: Oracle) -> Iterator[Fact]:
    """How much sooner each deadline, and how much tighter each bound of a swarm, could be."""
    yield from deadline_slacks(oracle)
    for bound in group_bounds(oracle.subject.mission):
        if bound.key != MARGIN:
            yield _bound_slack(oracle, bound)


def deadline_slacks(oracle: Oracle) -> Iterator[Fact]:
    """How much sooner each deadline of a formula could be."""
    oracle.patience = PATIENCE
    for way in _deadlines(oracle.subject.mission):
        yield _deadline_slack(oracle, way)


def _slack(oracle: Oracle, number: Number, sense: int, most: int) -> _Slack | None:
    """By how much a number could be tighter, `most` at most; None where it is not found out."""
    mission = oracle.subject.mission
    now = number.get(mission)

    def impossible(steps: int) -> bool | None:
        answer = oracle.met(number.put(mission, now + sense * steps))
        return None if answer is None else not answer

    found = least(impossible, most) if most > 0 else None
    if found is None:
        return _Slack(most, sure=True) if most == 0 or impossible(most) is False else None
    if found.amount == 1 and not found.proven:
        return None
    return _Slack(found.amount - 1, found.proven)


def _deadline_slack(oracle: Oracle, way: Way) -> Fact:
    """How much sooner a deadline could be."""
    wording = oracle.subject.wording
    node = node_at(oracle.subject.mission.formula, way)
    assert isinstance(node, Eventually | Until)
    slack = _slack(oracle, Number("formula", (way, "high")), -1, node.high - node.low)
    if slack is None:
        text = "is open: no time"
    elif not slack.steps:
        text = "cannot be a step sooner"
    else:
        far = many(slack.steps, "step")
        text = f"could be{slack.least} {far} sooner, at {node.high - slack.steps}"
    whole = wording.whole(way)
    place = wording.sources.place(Occurrence(way))
    return Fact("slack", f"the deadline {node.high} {text}, in {whole}", place)


def _bound_slack(oracle: Oracle, bound: SoftConstraint) -> Fact:
    """How much tighter a bound of a swarm could be."""
    name, which = bound.key
    number = Number("swarm", bound.key)
    mission = oracle.subject.mission
    now = number.get(mission)
    larger = which == "least"
    sense = 1 if larger else -1
    most = swarm_size(mission, name) - now if larger else now - 1
    slack = _slack(oracle, number, sense, most)
    if slack is None:
        text = "how much tighter it could be is open: no time"
    elif not slack.steps:
        text = "it cannot be tighter"
    else:
        text = f"it could be{slack.least} {now + sense * slack.steps}"
    part = oracle.subject.wording.fact(bound)
    return Fact("slack", f"{part.text}: {text}", part.place, (part,))


def _deadlines(mission: Mission) -> list[Way]:
    """The windows that a formula could close sooner, in the order of the text."""
    found: dict[Way, None] = {}
    for group in formula_groups(mission):
        for constraint in group:
            for way, node in nodes_along(mission.formula, occurrence_of(constraint).way):
                if isinstance(node, Eventually | Until) and node.high > node.low:
                    found[way] = None
    return list(found)
