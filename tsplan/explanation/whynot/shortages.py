"""Tasks whose resources cannot be where they are needed: too little of them, or too late."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import replace
from fractions import Fraction
from math import floor
from typing import TYPE_CHECKING, Any, NamedTuple

from tsplan.explanation.part_words import amount_words, stock_words
from tsplan.explanation.whynot.amount_numbers import resource_of, unit_of
from tsplan.explanation.whynot.haulage_bounds import HaulageBounds, Most
from tsplan.explanation.whynot.mission_numbers import remapped
from tsplan.explanation.whynot.occurrences import Occurrence, separable
from tsplan.explanation.whynot.relaxing import any_plan
from tsplan.explanation.whynot.soft_constraints import named_facts, of_occurrence
from tsplan.logic import Always, Task
from tsplan.logic.text import number_text
from tsplan.plans.outcomes import Status
from tsplan.words import many

if TYPE_CHECKING:
    from collections.abc import Callable

    from tsplan.explanation.explanation import Fact, SoftConstraint
    from tsplan.explanation.whynot.context import Context
    from tsplan.explanation.whynot.unconditional_demands import AmountDemand
    from tsplan.mission import Mission, Resource

_ROUNDING = 1e-6  # of a unit, by which solvers may fall short of one

MOST_QUESTIONS = 3
"""Amounts at states by steps that a solver is asked for."""


def shortage(context: Context) -> Iterator[Fact]:
    """More of a resource used up by all tasks, or in use at once by one, than there is."""
    for resource in context.mission.resources:
        wanted = [need for need in context.amounts if need.resource == resource.name]
        if not resource.consumed:
            for need in wanted:
                if need.amount * len(need.states) > resource.total:
                    text = f"{_in_use(need)}; {stock_words(resource)}"
                    yield context.fact("scarcity", text, [need], *context.carrying(resource)[:1])
            continue
        # a task that is asked for twice may be executed once for both
        most: dict[Task, AmountDemand] = {}
        for need in wanted:
            known = most.get(need.task)
            if known is None or known.executions < need.executions:
                most[need.task] = need
        if sum(map(_used_up, most.values())) > resource.total:
            total = amount_words(sum(map(_used_up, most.values()), Fraction(0)), resource.name)
            each = " and ".join(map(_spent, most.values()))
            text = f"{total} in all are used up ({each}); {stock_words(resource)}"
            parts = [*context.carrying(resource)[:1], *_told_apart(most.values())]
            yield context.fact("scarcity", text, most.values(), *parts)


def _told_apart(needs: Collection[AmountDemand]) -> Iterator[SoftConstraint]:
    """All parts of several tasks, each executed by itself: less of them might be one task."""
    for need in needs if len(needs) > 1 else ():
        for number in range(separable(need.task)):
            yield of_occurrence(Occurrence(need.occurrence.way, number))


def _used_up(need: AmountDemand) -> Fraction:
    return need.amount * len(need.states) * need.executions


def _spent(need: AmountDemand) -> str:
    """What is used up by one task, with the arithmetic."""
    amount = number_text(float(need.amount))
    times = f" at {many(need.executions, 'step')}" if need.executions > 1 else ""
    if len(need.states) > 1:
        return f"{amount} at each of the {len(need.states)} states '{need.task.label}'{times}"
    return f"{amount} at '{need.states[0]}'{times}"


def _in_use(need: AmountDemand) -> str:
    what = f"{amount_words(need.amount * len(need.states), need.resource)} in use at one step"
    return f"{what} ({_spent(replace(need, span=need.span._replace(lasts=0)))})"


def undelivered(context: Context) -> Iterator[Fact]:
    """Amounts that cannot be at a state in time, by how often robots can come there with a load."""
    bounds: dict[str, HaulageBounds] = {}
    for need in context.amounts:
        resource = resource_of(context.mission, need.resource)
        able = bounds.setdefault(need.resource, HaulageBounds(context, resource))
        for state in need.states:
            context.pause()
            for wanted, step in _by_steps(need, resource):
                most = able.most(state, step)
                if most.amount < wanted <= resource.total:
                    text = f"{_asked(need, wanted, state, step)}; {_at_most(resource, most)}"
                    yield context.fact("delivery", text, [need], *context.carrying(resource))
                    break


def _by_steps(need: AmountDemand, resource: Resource) -> Iterator[tuple[Fraction, int]]:
    """How much must have been at each state by when: for the first execution, then for all."""
    yield need.amount, need.span.last
    if need.span.lasts and resource.consumed:
        yield need.amount * need.executions, need.span.last + need.span.lasts


def _asked(need: AmountDemand, wanted: Fraction, state: str, step: int) -> str:
    """What must be where by when."""
    what = amount_words(wanted, need.resource)
    where = f"'{state}'" if need.task.label == state else f"'{state}' ({need.task.label})"
    often = f" for {need.executions} executions" if wanted > need.amount else ""
    return f"{what} must be at {where} by step {step}{often}"


def _at_most(resource: Resource, most: Most) -> str:
    """How much can be there, and why no more."""
    here = f"{number_text(float(most.lying))} there from the start" if most.lying else ""
    if not most.brought:  # of robots: what structures bring has no bound of its own
        none = "nobody can come there with any by then"
        return f"{number_text(float(most.amount))} can be: {', '.join(filter(None, (here, none)))}"
    carried = [
        f"{many(item.robots, 'agent')} of class {item.class_name} with {_loads(item.loads)} of "
        f"{number_text(float(item.room))}"
        for item in most.brought
    ]
    why = ", ".join(filter(None, (here, *carried)))
    return f"at most {number_text(float(most.amount))} can be: {why}"


def _loads(number: int) -> str:
    return "one load" if number == 1 else f"{number} loads"


# --- by a solver ---------------------------------------------------------------------------------


def undeliverable(context: Context, ask: Callable[[Mission], Any]) -> Iterator[Fact]:
    """Amounts that cannot be at a state in time, whatever else is left undone: by solves.

    First come those of which the least can be there by the bound, measured by what is needed. No
    more are asked for once one takes too long.
    """
    questions = sorted(_open(context), key=lambda question: question.ease)
    for _, need, state, wanted, step in questions[:MOST_QUESTIONS]:
        resource = resource_of(context.mission, need.resource)
        unit = unit_of(context.mission, resource)
        found = ask(gathering(context.mission, resource.name, (state, step), unit))
        most = None if found is None else _most_found(found, unit)
        if most is None:
            return
        if most[0] < wanted:
            can = f"{'' if most[1] else 'at most '}{number_text(float(most[0]))} can be"
            text = f"{_asked(need, wanted, state, step)}, and {can}"
            yield context.fact("delivery", text, [need], *named_facts(context.mission))


class _Question(NamedTuple):
    """Whether so much can be at a state by a step; `ease` is how often by the bound."""

    ease: Fraction
    need: AmountDemand
    state: str
    wanted: Fraction
    step: int


def _open(context: Context) -> Iterator[_Question]:
    """Amounts of which the bound does not tell that they cannot be there, nor what lies there."""
    for need in context.amounts:
        resource = resource_of(context.mission, need.resource)
        bounds = HaulageBounds(context, resource)
        for state in need.states:
            for wanted, step in _by_steps(need, resource):
                most = bounds.most(state, step)
                if most.lying < wanted <= most.amount:
                    yield _Question(most.amount / wanted, need, state, wanted, step)


def gathering(mission: Mission, resource: str, place: tuple[str, int], unit: Fraction) -> Mission:
    """The mission to have as much of a resource as can be at a state at a step, and nothing else.

    Its `reserve` is how much more than one unit that is; it has no plan where not even that can be.
    """
    state, step = place
    label = "gathered"
    while label in mission.system.labels or label in mission.system.states:
        label += "'"
    system = remapped(
        mission.system, [state], lambda item: replace(item, labels=item.labels | {label})
    )
    formula = Always(step, step, Task(0, label, (), ((resource, float(unit)),)))
    return replace(
        any_plan(mission),
        system=system,
        formula=formula,
        text=str(formula),
        horizon=step,
        objective=("reserve",),
        delay=0,
    )


def _most_found(plan: Any, unit: Fraction) -> tuple[Fraction, bool] | None:
    """The most that can be gathered by what a planner found, and whether that much can be."""
    if plan.status is Status.INFEASIBLE:
        return Fraction(0), True
    if not plan.has_paths:
        return None
    (reserve,) = plan.objective
    if reserve.bound is None:
        return None
    # one resource flows between whole robots, so all that can be there is a multiple of the unit
    return (floor(reserve.bound / float(unit) + _ROUNDING) + 1) * unit, bool(reserve.proven)
