"""Own constraints and objectives in a model: which counts they name, and their rows."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from tsplan.encode.agent_classes import MapArrays
from tsplan.encode.expressions import Constraint, CountTerm
from tsplan.encode.flow_network import Network
from tsplan.errors import Finding, MissionError
from tsplan.milp.model import INFINITY, Draft, Ints
from tsplan.parameters import known_name, step_within
from tsplan.plans.presence import counted
from tsplan.ts import TransitionSystem

if TYPE_CHECKING:
    from tsplan.mission import Mission
    from tsplan.plans.plan import Plan

MOST_TOTAL = 10**15
"""What the terms of a constraint may sum to at most: solvers compute with 53 bits, and take larger
coefficients for mistakes."""


_BASE = 10**4
"""The largest factor in a row: a solver that lets rows be broken by 1e-6 of their largest factor
still tells whole numbers apart by a wide margin."""


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


def checked_terms(terms: Iterable[tuple[CountTerm, Fraction | int]], mission: Mission) -> None:
    """Refuse terms that the mission does not know, and sums too large for a solver."""
    total = Fraction(0)
    for term, factor in terms:
        checked_term(term, mission)
        total += mission.size * abs(Fraction(factor))
    if total > MOST_TOTAL:
        what = f"in whole numbers the terms sum to more than {MOST_TOTAL:.0e}"
        raise MissionError([Finding(what, "drop digits of the coefficients")])


def terms_of(constraints: Iterable[Constraint]) -> set[CountTerm]:
    """All counts that some constraint speaks about."""
    return {term for constraint in constraints for term, _ in constraint.terms}


def states_of(term: CountTerm, system: TransitionSystem, arrays: MapArrays) -> Ints:
    """Numbers of the states meant: a state of this name, else all states with the label."""
    if term.place in arrays.number:
        return np.array([arrays.number[term.place]], dtype=np.int64)
    return arrays.states_with(system, term.place)


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


class _Part(NamedTuple):
    """A summand of a row: a sum of whole columns between 0 and `most`, times a factor."""

    columns: Ints
    factor: int
    most: int


def constraint_rows(
    constraints: Sequence[Constraint],
    system: TransitionSystem,
    arrays: MapArrays,
    network: Network,
    draft: Draft,
) -> None:
    """Rows for every constraint that bounds anything: one, or a few where numbers are large."""
    for constraint in constraints:
        if constraint.lower is None and constraint.upper is None:
            continue
        parts, constant = [], 0
        for term, factor in constraint.terms:
            columns, fixed = resolve(term, system, arrays, network)
            parts.append(_Part(columns, factor, network.agents(term.capability)))
            constant += factor * fixed
        lower, upper = constraint.lower, constraint.upper
        if all(abs(part.factor) <= _BASE for part in parts):
            low = -INFINITY if lower is None else lower - constant
            high = INFINITY if upper is None else upper - constant
            _row(parts, (low, high), draft, constraint.name)
            continue
        if upper is not None:
            _at_most(parts, upper - constant, draft, constraint.name)
        if lower is not None:
            turned = [part._replace(factor=-part.factor) for part in parts]
            _at_most(turned, constant - lower, draft, constraint.name)


def _row(parts: Sequence[_Part], bounds: tuple[float, float], draft: Draft, kind: str) -> None:
    empty = np.empty(0, dtype=np.int64)
    columns = np.concatenate([empty, *(part.columns for part in parts)])
    values = [np.full(len(part.columns), float(part.factor)) for part in parts]
    draft.rows(
        np.zeros(len(columns)),
        columns,
        np.concatenate([np.empty(0), *values]),
        lower=bounds[0],
        upper=bounds[1],
        kind=kind,
    )


def _at_most(parts: Sequence[_Part], bound: int, draft: Draft, kind: str) -> None:
    """`sum of the parts <= bound`, with no factor above the base.

    With every factor and the bound split as B q + r, the sum keeps the bound exactly if there is a
    whole carry c with `sum of r x <= r of the bound + B c` and `sum of q x + c <= q of the bound`:
    B times the second and the first add up to it, and the largest c of the second fits the first.
    """
    if all(abs(part.factor) <= _BASE for part in parts):
        _row(parts, (-INFINITY, bound), draft, kind)
        return
    high, low = divmod(bound, _BASE)
    rests = [part._replace(factor=part.factor % _BASE) for part in parts]
    # carried must be what the rests come to at most
    most = max(0, -((low - sum(part.factor * part.most for part in rests)) // _BASE))
    carry = draft.columns(1, upper=float(most), integer=True)
    _row([*rests, _Part(carry, -_BASE, most)], (-INFINITY, low), draft, kind)
    quotients = [part._replace(factor=part.factor // _BASE) for part in parts]
    _at_most([*quotients, _Part(carry, 1, most)], high, draft, kind)


def resolve(
    term: CountTerm, system: TransitionSystem, arrays: MapArrays, network: Network
) -> tuple[Ints, int]:
    """Flow columns whose sum, with the returned constant, is a count."""
    return network.present(states_of(term, system, arrays), term.capability, term.step)


def worth(
    terms: Iterable[tuple[CountTerm, Fraction | int]], plan: Plan, system: TransitionSystem
) -> Fraction:
    """What terms sum to in a plan, by the paths of its agents."""
    given = list(terms)
    found = Fraction(0)
    for capability in {term.capability for term, _ in given}:
        some = [(term, factor) for term, factor in given if term.capability == capability]
        places = {
            term.place: (term.place,) if term.place in system.states else system.labels[term.place]
            for term, _ in some
        }
        states = tuple({state for those in places.values() for state in those})
        row = {state: number for number, state in enumerate(states)}
        counts = counted(plan, states, capability)
        for term, factor in some:
            rows = [row[state] for state in places[term.place]]
            found += factor * int(counts[rows, term.step].sum())
    return found
