"""Own constraints and objectives as they are posed and measured: by names, on a mission or plan."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from fractions import Fraction
from typing import TYPE_CHECKING

from tsplan.encode.expressions import Constraint, CountTerm
from tsplan.errors import Finding, MissionError
from tsplan.parameters import known_name, step_within
from tsplan.plans.presence import state_counts
from tsplan.ts import TransitionSystem

if TYPE_CHECKING:
    from tsplan.mission import Mission
    from tsplan.plans.plan import Plan

MOST_TOTAL = 10**15
"""What the terms of a constraint may sum to at most: solvers compute with 53 bits, and take larger
coefficients for mistakes."""


def checked_term(term: CountTerm, mission: Mission) -> CountTerm:
    """A count that the mission knows; MissionError that names what it does not know."""
    system = mission.system
    places = (system.states, system.labels)
    place = known_name(term.place, places, "state or label", MissionError)
    return CountTerm(
        place,
        _capability(term.capability, mission),
        step_within(term.step, mission.horizon, MissionError),
    )


def _capability(name: str | None, mission: Mission) -> str | None:
    if name is None:
        return None
    able = {item for group in mission.team for item in group.capabilities}
    if name not in able and any(name == group.class_name for group in mission.team):
        own = {c for g in mission.team if g.class_name == name for c in g.capabilities}
        remedy = f"agents are counted by capability; those of the class: {', '.join(sorted(own))}"
        raise MissionError([Finding(f"'{name}' is a class, not a capability", remedy)])
    return known_name(name, [able], "capability", MissionError)


def checked_terms(
    terms: Iterable[tuple[CountTerm, Fraction | int]],
    mission: Mission,
    constant: Fraction | int = 0,
) -> None:
    """Refuse terms that the mission does not know, and sums too large for a solver."""
    total = abs(Fraction(constant))
    for term, factor in terms:
        checked_term(term, mission)
        total += mission.size * abs(Fraction(factor))
    if total > MOST_TOTAL:
        what = f"in whole numbers the terms sum to more than {MOST_TOTAL:.0e}"
        raise MissionError([Finding(what, "drop digits of the numbers in them")])


def within_reach(constraint: Constraint, agents: int) -> Constraint:
    """The same constraint of so many agents, without bounds that always hold.

    One that never holds has no terms, so that no bound is larger than what the terms can sum to.
    """
    most = agents * sum(factor for _, factor in constraint.terms if factor > 0)
    least = agents * sum(factor for _, factor in constraint.terms if factor < 0)
    lower = least if constraint.lower is None else max(constraint.lower, least)
    upper = most if constraint.upper is None else min(constraint.upper, most)
    if lower > upper:
        return Constraint((), 1, None, constraint.name)
    return replace(
        constraint, lower=lower if lower > least else None, upper=upper if upper < most else None
    )


def worth(
    terms: Iterable[tuple[CountTerm, Fraction | int]], plan: Plan, system: TransitionSystem
) -> Fraction:
    """What terms sum to in a plan, by the paths of its agents."""
    given = list(terms)
    places = {
        term.place: (term.place,) if term.place in system.states else system.labels[term.place]
        for term, _ in given
    }
    states = tuple({state for those in places.values() for state in those})
    row = {state: number for number, state in enumerate(states)}
    counts = {
        able: state_counts(plan.presences, states, plan.horizon, able)
        for able in {term.capability for term, _ in given}
    }
    found = Fraction(0)
    for term, factor in given:
        rows = [row[state] for state in places[term.place]]
        found += factor * int(counts[term.capability][rows, term.step].sum())
    return found
