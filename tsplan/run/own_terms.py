"""Own constraints and objectives as they are posed and measured: by names, on a mission or plan."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from fractions import Fraction
from inspect import currentframe
from pathlib import Path
from typing import TYPE_CHECKING, TypeAlias

from tsplan.checking.edge_entries import entering, entries_of
from tsplan.encode.expressions import Constraint
from tsplan.encode.quantities import CountTerm, FlowTerm, OwnVariable, Quantity
from tsplan.errors import Finding, MissionError, nearest
from tsplan.limits import clipped
from tsplan.parameters import finite, known_name, step_within
from tsplan.plans.presence import state_counts
from tsplan.ts import Edge
from tsplan.words import nfc

if TYPE_CHECKING:
    from tsplan.mission import Mission
    from tsplan.plans.plan import Plan

MOST_TOTAL = 10**15
"""What the terms of a constraint may sum to at most: solvers compute with 53 bits, and take larger
coefficients for mistakes."""

MOST_VALUE = 10**6
"""What own variables are bounded by, on both sides: in larger ones solvers do not tell whole
numbers from others."""

Terms: TypeAlias = "Iterable[tuple[Quantity, Fraction | int]]"
Variables: TypeAlias = Mapping[str, OwnVariable]


def checked_count(term: CountTerm, mission: Mission) -> CountTerm:
    """A count that the mission knows; MissionError that names what it does not know."""
    system = mission.system
    places = (system.states, system.labels)
    place = known_name(term.place, places, "state or label", MissionError)
    step = step_within(term.step, mission.horizon, MissionError)
    return CountTerm(place, _capability(term.capability, mission), step)


def checked_flow(term: FlowTerm, mission: Mission) -> FlowTerm:
    """A flow that the mission knows; MissionError that names what it does not know.

    The edge is a pair of names, or an `Edge`; at the last step nobody enters one any more.
    """
    given = term.edge.pair if isinstance(term.edge, Edge) else term.edge
    if not isinstance(given, tuple | list) or len(given) != 2:  # noqa: PLR2004  (two ends)
        what = f"{clipped(term.edge)} is no edge"
        raise MissionError([Finding(what, "name its two ends: problem.flow(('a', 'b'), step=3)")])
    system = mission.system
    source, target = (known_name(end, (system.states,), "state", MissionError) for end in given)
    if (source, target) not in system.edges:
        ends = [f"('{edge.source}', '{edge.target}')" for edge in system.leaving(source)]
        remedy = f"from '{source}' lead {', '.join(ends)}" if ends else "nothing leads from there"
        what = f"there is no edge from '{source}' to '{target}'"
        raise MissionError([Finding(what, remedy)])
    last = mission.horizon - 1
    if last < 0:
        what = "nobody enters an edge in a mission that ends at step 0"
        raise MissionError([Finding(what, "set a longer horizon")])
    step = step_within(term.step, last, MissionError)
    return FlowTerm((source, target), _capability(term.capability, mission), step)


def made_variable(name: object, low: object, high: object, *, integer: bool) -> OwnVariable:
    """An own variable; MissionError for a name or bounds that cannot be those of one."""
    if not isinstance(name, str) or not name.strip():
        raise MissionError([Finding(f"{clipped(name)} is not a name", "give a text")])
    bounds = finite(low, MissionError), finite(high, MissionError)
    if integer:
        least, most = -((-bounds[0]) // 1), bounds[1] // 1
        bounds = Fraction(least), Fraction(most)
    if bounds[0] > bounds[1]:
        kind = "whole number" if integer else "number"
        what = f"no {kind} is between {clipped(low)} and {clipped(high)}"
        raise MissionError([Finding(what, "give the lower bound first")])
    if max(map(abs, bounds)) > MOST_VALUE:
        what = f"the bounds of '{name}' are larger than {MOST_VALUE:,}"
        raise MissionError([Finding(what, "count in larger units")])
    return OwnVariable(nfc(name), *bounds, integer)


def calling_place() -> str:
    """The file and line of the statement that called the method which asks for it."""
    frame = currentframe()
    asking = frame and frame.f_back
    calling = asking and asking.f_back
    if calling is None:
        return ""
    return f"{Path(calling.f_code.co_filename).name}:{calling.f_lineno}"


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
    terms: Terms, mission: Mission, variables: Variables, constant: Fraction | int = 0
) -> None:
    """Refuse terms that the problem does not know, and sums too large for a solver."""
    total = abs(Fraction(constant))
    for term, factor in terms:
        if isinstance(term, CountTerm):
            checked_count(term, mission)
        elif isinstance(term, FlowTerm):
            checked_flow(term, mission)
        elif variables.get(term.name) != term:
            what = f"'{term.name}' is a variable of another problem"
            remedy = (
                f"{nearest(term.name, variables)}; make it by problem.variable(name, low, high)"
            )
            raise MissionError([Finding(what, remedy)])
        low, high = _range(term, mission.size)
        total += max(abs(Fraction(low)), abs(Fraction(high))) * abs(Fraction(factor))
    if total > MOST_TOTAL:
        what = f"in whole numbers the terms sum to more than {MOST_TOTAL:.0e}"
        raise MissionError([Finding(what, "drop digits of the numbers in them")])


def _range(term: Quantity, agents: int) -> tuple[Fraction | int, Fraction | int]:
    """The least and the most that a quantity can be."""
    return (term.low, term.high) if isinstance(term, OwnVariable) else (0, agents)


def reach(constraint: Constraint, agents: int) -> tuple[Fraction | int, Fraction | int]:
    """The least and the most that the terms of a constraint of so many agents can sum to."""
    ends: list[Fraction | int] = [0, 0]
    for term, factor in constraint.terms:
        for place, value in enumerate(sorted(factor * end for end in _range(term, agents))):
            ends[place] += value
    return ends[0], ends[1]


def within_reach(constraint: Constraint, agents: int) -> Constraint:
    """The same constraint of so many agents, without bounds that always hold.

    One that never holds has no terms, so that no bound is larger than what the terms can sum to.
    """
    least, most = reach(constraint, agents)
    lower = least if constraint.lower is None else max(constraint.lower, least)
    upper = most if constraint.upper is None else min(constraint.upper, most)
    if lower > upper:
        return Constraint((), 1, None, constraint.name)
    return replace(
        constraint, lower=lower if lower > least else None, upper=upper if upper < most else None
    )


def worth(terms: Terms, plan: Plan, mission: Mission) -> Fraction:
    """What terms sum to in a plan: by the paths of its agents, and its values of own variables.

    Of a variable that the plan has no value for it is that of the least one.
    """
    given = list(terms)
    counts = [(term, factor) for term, factor in given if isinstance(term, CountTerm)]
    flows = [(term, factor) for term, factor in given if isinstance(term, FlowTerm)]
    found = _counted(counts, plan, mission) if counts else Fraction(0)
    if flows:
        entries = list(entries_of(mission, plan))
        entered = {able: entering(entries, able) for able in {term.capability for term, _ in flows}}
        for flow, factor in flows:
            found += factor * entered[flow.capability][flow.edge, flow.step]
    for term, factor in given:
        if isinstance(term, OwnVariable):
            found += factor * plan.variables.get(term.name, term.low)
    return found


def _counted(
    given: Iterable[tuple[CountTerm, Fraction | int]], plan: Plan, mission: Mission
) -> Fraction:
    """What counts times factors sum to."""
    terms, system = list(given), mission.system
    places = {
        term.place: (term.place,) if term.place in system.states else system.labels[term.place]
        for term, _ in terms
    }
    states = tuple({state for those in places.values() for state in those})
    row = {state: number for number, state in enumerate(states)}
    counts = {
        able: state_counts(plan.presences, states, plan.horizon, able)
        for able in {term.capability for term, _ in terms}
    }
    found = Fraction(0)
    for term, factor in terms:
        rows = [row[state] for state in places[term.place]]
        found += factor * int(counts[term.capability][rows, term.step].sum())
    return found
