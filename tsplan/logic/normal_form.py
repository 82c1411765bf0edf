"""Positive normal form: negation only inside the atoms, no implication, no equivalence."""

from __future__ import annotations

from dataclasses import replace
from functools import singledispatch
from typing import NamedTuple

from tsplan.logic.atoms import OPPOSITE, Count, Limit, Linear, Percent, Relation, Task
from tsplan.logic.nodes import (
    FALSE,
    TRUE,
    Always,
    And,
    Constant,
    Eventually,
    Formula,
    Iff,
    Implies,
    Not,
    Or,
    Release,
    Until,
)
from tsplan.logic.traversal import fold


class Polarity(NamedTuple):
    """A formula and its negation, both in positive normal form."""

    holds: Formula
    fails: Formula

    def swapped(self) -> Polarity:
        """The same for the negated formula."""
        return Polarity(self.fails, self.holds)


def positive(formula: Formula) -> Formula:
    """The equal formula of And, Or, Always, Eventually, Until, Release, constants and atoms only.

    Counts keep the relations >= and <= alone, since they are whole numbers; linear predicates and
    percentages keep >=, <=, > and <. Truth and robustness stay what they were.

    Raises ValueError where tasks or limits have not been translated.

    >>> from tsplan.logic import parse
    >>> print(positive(parse("!(F[0,2] a => sum(b) = 2)")))
    F[0,2] a && (sum(b) >= 3 || sum(b) <= 1)
    """
    both: Polarity = fold(formula, normal)
    return both.holds


def negation(formula: Formula) -> Formula:
    """The negated formula, in positive normal form.

    >>> from tsplan.logic import parse
    >>> print(negation(parse("a U[0,3] sum(b) >= 2")))
    (sum(a) <= 0) R[0,3] (sum(b) <= 1)
    """
    both: Polarity = fold(formula, normal)
    return both.fails


@singledispatch
def normal(node: Formula, _below: tuple[Polarity, ...]) -> Polarity:
    """A node's normal forms from those of its children. Every class of nodes registers its own."""
    raise TypeError(f"no normal form is registered for {type(node).__name__}")


@normal.register
def _(node: Constant, _below: tuple[Polarity, ...]) -> Polarity:
    return Polarity(TRUE, FALSE) if node.value else Polarity(FALSE, TRUE)


@normal.register
def _(_node: Not, below: tuple[Polarity, ...]) -> Polarity:
    return below[0].swapped()


@normal.register
def _(_node: And, below: tuple[Polarity, ...]) -> Polarity:
    return Polarity(And(_holding(below)), Or(_failing(below)))


@normal.register
def _(_node: Or, below: tuple[Polarity, ...]) -> Polarity:
    return Polarity(Or(_holding(below)), And(_failing(below)))


@normal.register
def _(_node: Implies, below: tuple[Polarity, ...]) -> Polarity:
    left, right = below
    return Polarity(Or((left.fails, right.holds)), And((left.holds, right.fails)))


@normal.register
def _(_node: Iff, below: tuple[Polarity, ...]) -> Polarity:
    both, neither = And(_holding(below)), And(_failing(below))
    return Polarity(Or((both, neither)), And((Or(_failing(below)), Or(_holding(below)))))


@normal.register
def _(node: Eventually, below: tuple[Polarity, ...]) -> Polarity:
    child = below[0]
    some = Eventually(node.low, node.high, child.holds)
    return Polarity(some, Always(node.low, node.high, child.fails))


@normal.register
def _(node: Always, below: tuple[Polarity, ...]) -> Polarity:
    child = below[0]
    every = Always(node.low, node.high, child.holds)
    return Polarity(every, Eventually(node.low, node.high, child.fails))


@normal.register
def _(node: Until, below: tuple[Polarity, ...]) -> Polarity:
    holding, failing = _holding(below), _failing(below)
    until = Until(node.low, node.high, *holding)
    return Polarity(until, Release(node.low, node.high, *failing))


@normal.register
def _(node: Release, below: tuple[Polarity, ...]) -> Polarity:
    holding, failing = _holding(below), _failing(below)
    release = Release(node.low, node.high, *holding)
    return Polarity(release, Until(node.low, node.high, *failing))


@normal.register
def _(node: Count, _below: tuple[Polarity, ...]) -> Polarity:
    opposite = replace(node, relation=OPPOSITE[node.relation])
    return Polarity(_count(node), _count(opposite))


@normal.register
def _(node: Linear, _below: tuple[Polarity, ...]) -> Polarity:
    opposite = replace(node, relation=OPPOSITE[node.relation])
    return Polarity(_ordered(node), _ordered(opposite))


@normal.register(Task)
@normal.register(Limit)
def _(node: Formula, _below: tuple[Polarity, ...]) -> Polarity:
    raise ValueError(f"'{node}' has no normal form of its own; translate the formula first")


def _holding(below: tuple[Polarity, ...]) -> tuple[Formula, ...]:
    return tuple(child.holds for child in below)


def _failing(below: tuple[Polarity, ...]) -> tuple[Formula, ...]:
    return tuple(child.fails for child in below)


def _count(node: Count) -> Formula:
    """Only >= and <= where the bound is a number: `> m` is `>= m+1`."""
    bound = node.bound
    if isinstance(bound, Percent):
        return _ordered(node)
    above: tuple[Relation, int] = (">=", bound + 1)
    below: tuple[Relation, int] = ("<=", bound - 1)
    match node.relation:
        case ">":
            return _bounded(node, above)
        case "<":
            return _bounded(node, below)
        case "!=":
            return Or((_bounded(node, above), _bounded(node, below)))
    return _ordered(node)


def _bounded(node: Count, comparison: tuple[Relation, int]) -> Count:
    relation, bound = comparison
    return replace(node, relation=relation, bound=bound)


def _ordered(node: Count | Linear) -> Formula:
    """No = and no !=: both are said with two ordered relations."""
    match node.relation:
        case "=":
            return And((replace(node, relation=">="), replace(node, relation="<=")))
        case "!=":
            return Or((replace(node, relation=">"), replace(node, relation="<")))
    return node
