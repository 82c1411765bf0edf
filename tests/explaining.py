"""What every explanation must keep, checked by the reference encoding, or by all joint plans."""

from __future__ import annotations

from dataclasses import replace

import tsplan
from tests.joint_plans import best, small_enough
from tsplan import Mission
from tsplan.errors import MissionError
from tsplan.explanation import Change, Conflict, Explanation, SoftConstraint, explain
from tsplan.explanation.whynot.changes import applied
from tsplan.explanation.whynot.relaxing import relaxed
from tsplan.explanation.whynot.soft_constraints import formula_groups, named_facts
from tsplan.run.problem import Problem, Tuning

REFERENCE = Tuning.named("reference", ())


def everything(mission: Mission) -> frozenset[SoftConstraint]:
    """All that can be taken out of a mission."""
    groups = formula_groups(mission)
    return frozenset(item for group in groups for item in group) | frozenset(named_facts(mission))


def possible(question: Mission | Problem) -> bool:
    """Whether there is a plan, by the reference encoding; of few agents, by all joint plans."""
    if isinstance(question, Mission) and question.swarm is not None and small_enough(question):
        return best(question) is not None
    plan = tsplan.plan(
        question,
        **({"encoding": "reference"} if isinstance(question, Mission) else {}),
        time_limit=120,
    )
    assert plan.status in ("optimal", "feasible", "infeasible"), plan.status
    return plan.has_paths


def holds_without(mission: Mission, kept: frozenset[SoftConstraint]) -> bool:
    """Whether some elements of a mission, alone, can hold together."""
    return possible(relaxed(mission, everything(mission) - kept, REFERENCE))


def elements(conflict: Conflict) -> frozenset[SoftConstraint]:
    """All elements of a conflict's parts."""
    return frozenset().union(*(part.constraints for part in conflict.parts))


def check_conflict(mission: Mission, conflict: Conflict) -> None:
    """The set itself is impossible, and whatever misses one element of it is not."""
    assert conflict.minimal
    core = elements(conflict)
    assert not holds_without(mission, core)
    for element in core:
        assert holds_without(mission, core - {element}), element


def check_change(mission: Mission, change: Change) -> None:
    """There is a plan after the change, and none after one step less of it."""
    assert change.proven
    assert change.amount == sum(edit.unit * amount for edit, amount in change.steps)
    assert possible(plain(change.mission)), change.text
    for place, (edit, amount) in enumerate(change.steps):
        less = [*change.steps]
        less[place] = (edit, amount - 1)
        try:
            smaller = applied(mission, [step for step in less if step[1]])
        except MissionError:
            continue  # does not even fit together
        assert not possible(plain(smaller)), change.text


def plain(mission: Mission) -> Mission:
    """The mission without anything to optimise."""
    return replace(mission, objective=(), prefer=())


def check_explanation(mission: Mission, *, conflicts: int = 1) -> Explanation:
    """Everything that an explanation says is so; `mission` may have a plan or not."""
    made = explain(mission, conflicts=conflicts)
    if possible(plain(mission)):
        assert made.status == "feasible"
        assert not made.conflicts
        assert not made.changes
        return made
    assert made.status == "explained"
    assert 1 <= len(made.conflicts) <= conflicts
    cores = [elements(conflict) for conflict in made.conflicts]
    assert len(set(cores)) == len(cores)
    for conflict in made.conflicts:
        check_conflict(mission, conflict)
    for fact in made.facts:
        own = frozenset().union(*(part.constraints for part in fact.parts))
        assert own
        assert not holds_without(mission, own), fact.text
    for change in made.changes:
        check_change(mission, change)
    return made
