"""The values of own variables in a plan: read off a point, and exact where they are no integers.

Whole ones are what the point has. Others are found by a linear program over the rational numbers,
once everybody's path is settled: so they keep the own constraints exactly, whatever a solver makes
of floats.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import TYPE_CHECKING

from tsplan.encode.own_constraints import PART, terms_of
from tsplan.encode.quantities import OwnVariable
from tsplan.errors import SolverError
from tsplan.run.own_terms import worth
from tsplan.run.rational_program import Row, least

if TYPE_CHECKING:
    from tsplan.encode.encoded import Point
    from tsplan.encode.expressions import Constraint, Expression
    from tsplan.mission import Mission
    from tsplan.plans.plan import Plan


def with_values(
    plan: Plan,
    point: Point,
    mission: Mission,
    constraints: Sequence[Constraint],
    minimised: Expression,
) -> Plan:
    """The plan of a point with the values of all variables that it has columns for.

    Of those that are not whole, the values are least for what is minimised. Raises SolverError
    where none keep the constraints.
    """
    columns: Mapping[OwnVariable, int] = point.encoded.own_columns.get(PART, {})
    if not columns:
        return plan
    whole = {
        item.name: item.low + round(float(point.values[column]))
        for item, column in columns.items()
        if item.whole
    }
    plan = replace(plan, variables=whole)
    reals = [item for item in columns if not item.whole]
    if not reals:
        return plan
    about = [item for item in constraints if terms_of([item]).intersection(reals)]
    rows = [_row(item, reals, plan, mission) for item in about]
    factors = dict(minimised.terms)
    costs = [Fraction(factors.get(item, 0)) for item in reals]
    found = least(costs, rows, [item.high - item.low for item in reals])
    if found is None:
        names = ", ".join(item.name for item in about)
        raise SolverError(f"no values of own variables keep {names} exactly: it fails by little")
    exact = {item.name: item.low + value for item, value in zip(reals, found, strict=True)}
    return replace(plan, variables={**whole, **exact})


def _row(constraint: Constraint, reals: Sequence[OwnVariable], plan: Plan, mission: Mission) -> Row:
    """What a constraint leaves to the variables, each told from its least value on."""
    settled = worth(constraint.terms, plan, mission)  # with all of these at their least
    sides = (
        None if bound is None else Fraction(bound) - settled
        for bound in (constraint.lower, constraint.upper)
    )
    factors = dict(constraint.terms)
    return Row([Fraction(factors.get(item, 0)) for item in reals], *sides)
