"""A user's own linear constraints and objective terms over counts of agents."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from tsplan.encode.classes import MapArrays
from tsplan.encode.network import Network
from tsplan.errors import Finding, MissionError, nearest
from tsplan.milp.model import Draft, Floats, Ints
from tsplan.ts import TransitionSystem


@dataclass(frozen=True, slots=True)
class CountTerm:
    """Agents with a capability (None: all) at the states of a label, or at one state, at a step."""

    place: str
    capability: str | None
    step: int

    def states(self, system: TransitionSystem, arrays: MapArrays) -> Ints:
        """Numbers of the states meant: a state of this name, else all states with the label."""
        if self.place in arrays.number:
            return np.array([arrays.number[self.place]], dtype=np.int64)
        if self.place in system.labels:
            return arrays.states_with(system, self.place)
        remedy = nearest(self.place, [*arrays.names, *system.labels])
        raise MissionError([Finding(f"'{self.place}' is neither a state nor a label", remedy)])


@dataclass(frozen=True, slots=True)
class Expression:
    """A linear expression over counts: `+`, `-`, `*` with numbers; `<=`, `>=`, `==` constrain it.

    >>> count = Expression(((CountTerm("dock", None, 3), 1.0),))
    >>> (2 * count - 1 >= 3).lower
    4.0
    """

    terms: tuple[tuple[CountTerm, float], ...] = ()
    constant: float = 0.0

    def __add__(self, other: Expression | float) -> Expression:
        if isinstance(other, Expression):
            summed = dict(self.terms)
            for term, factor in other.terms:
                summed[term] = summed.get(term, 0.0) + factor
            return Expression(tuple(summed.items()), self.constant + other.constant)
        return Expression(self.terms, self.constant + other)

    __radd__ = __add__

    def __mul__(self, factor: float) -> Expression:
        scaled = tuple((term, value * factor) for term, value in self.terms)
        return Expression(scaled, self.constant * factor)

    __rmul__ = __mul__

    def __neg__(self) -> Expression:
        return self * -1.0

    def __sub__(self, other: Expression | float) -> Expression:
        return self + -other

    def __rsub__(self, other: float) -> Expression:
        return -self + other

    def __ge__(self, other: Expression | float) -> Constraint:
        return Constraint.between(self - other, 0.0, float("inf"))

    def __le__(self, other: Expression | float) -> Constraint:
        return Constraint.between(self - other, -float("inf"), 0.0)

    def equals(self, other: Expression | float) -> Constraint:
        """The constraint that both sides are the same."""
        return Constraint.between(self - other, 0.0, 0.0)


@dataclass(frozen=True, slots=True)
class Constraint:
    """`lower <= sum of the terms <= upper`."""

    terms: tuple[tuple[CountTerm, float], ...]
    lower: float
    upper: float
    name: str = "constraint"

    @staticmethod
    def between(expression: Expression, lower: float, upper: float) -> Constraint:
        """`lower <= expression <= upper`, the expression's constant moved to the bounds."""
        shift = expression.constant
        return Constraint(expression.terms, lower - shift, upper - shift)


def terms_of(constraints: Iterable[Constraint]) -> set[CountTerm]:
    """All counts that some constraint speaks about."""
    return {term for constraint in constraints for term, _ in constraint.terms}


def constraint_rows(
    constraints: Sequence[Constraint],
    system: TransitionSystem,
    arrays: MapArrays,
    network: Network,
    draft: Draft,
) -> None:
    """One row per constraint."""
    for constraint in constraints:
        columns, values, constant = resolve(constraint.terms, system, arrays, network)
        draft.rows(
            np.zeros(len(columns)),
            columns,
            values,
            lower=constraint.lower - constant,
            upper=constraint.upper - constant,
            kind=constraint.name,
        )


def resolve(
    terms: Iterable[tuple[CountTerm, float]],
    system: TransitionSystem,
    arrays: MapArrays,
    network: Network,
) -> tuple[Ints, Floats, float]:
    """Flow columns, coefficients and constant of a linear expression over counts."""
    columns, values, constant = [np.empty(0, dtype=np.int64)], [np.empty(0)], 0.0
    for term, factor in terms:
        if not 0 <= term.step <= network.horizon:
            message = f"step {term.step} lies outside 0..{network.horizon}"
            raise MissionError([Finding(message, "give the mission a longer horizon")])
        found, fixed = network.present(term.states(system, arrays), term.capability, term.step)
        columns.append(found)
        values.append(np.full(len(found), factor))
        constant += factor * fixed
    return np.concatenate(columns), np.concatenate(values), constant
