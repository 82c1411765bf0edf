"""Positive normal form: negation only inside the atoms, no implication, no equivalence."""

from __future__ import annotations

from dataclasses import replace
from functools import singledispatch
from typing import NamedTuple

from tsplan.logic import nodes
from tsplan.logic.atoms import (
    OPPOSITE,
    Count,
    Execution,
    Known,
    Limit,
    Linear,
    Percent,
    Relation,
    Task,
)
from tsplan.logic.nodes import DUAL, FALSE, TRUE, Formula
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
    percentages keep >=, <=, > and <. `all` is left out: it holds where its child does. Truth and
    robustness stay what they were.

    Raises ValueError where tasks or limits have not been translated.

    >>> from tsplan.logic import parse
    >>> print(positive(parse("!(F[0,2] a => sum(b) = 2)")))
    F[0,2] a && (sum(b) >= 3 || sum(b) <= 1)
    """
    both: Polarity = fold(formula, normal)
    return both.holds


def positive_atoms(formula: Formula) -> Formula:
    """The same, with every atom one atom still, `=` and `!=` among them, and Whole kept.

    >>> from tsplan.logic import parse
    >>> print(positive_atoms(parse("!(F[0,2] a => sum(b) = 2)")))
    F[0,2] a && sum(b) != 2
    """
    both: Polarity = fold(formula, _whole_atoms)
    return both.holds


def _whole_atoms(node: Formula, below: tuple[Polarity, ...]) -> Polarity:
    if isinstance(node, Count | Linear):
        return Polarity(node, replace(node, relation=OPPOSITE[node.relation]))
    if isinstance(node, nodes.Whole):
        return Polarity(*map(nodes.Whole, below[0]))
    return normal(node, below)


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
def _(node: nodes.Constant, _below: tuple[Polarity, ...]) -> Polarity:
    return Polarity(TRUE, FALSE) if node.value else Polarity(FALSE, TRUE)


@normal.register
def _(_node: nodes.Not, below: tuple[Polarity, ...]) -> Polarity:
    return below[0].swapped()


@normal.register
def _(_node: nodes.Whole, below: tuple[Polarity, ...]) -> Polarity:
    return below[0]


@normal.register
def _(
    node: nodes.And | nodes.Or | nodes.Eventually | nodes.Always | nodes.Until | nodes.Release,
    below: tuple[Polarity, ...],
) -> Polarity:
    dual = DUAL[type(node)].assembled(node.parameters, _failing(below))
    return Polarity(node.over(_holding(below)), dual)


@normal.register
def _(_node: nodes.Implies, below: tuple[Polarity, ...]) -> Polarity:
    left, right = below
    return Polarity(nodes.Or((left.fails, right.holds)), nodes.And((left.holds, right.fails)))


@normal.register
def _(_node: nodes.Iff, below: tuple[Polarity, ...]) -> Polarity:
    both, neither = nodes.And(_holding(below)), nodes.And(_failing(below))
    return Polarity(
        nodes.Or((both, neither)), nodes.And((nodes.Or(_failing(below)), nodes.Or(_holding(below))))
    )


@normal.register
def _(node: Count | Linear, _below: tuple[Polarity, ...]) -> Polarity:
    opposite = replace(node, relation=OPPOSITE[node.relation])
    return Polarity(_ordered(node), _ordered(opposite))


@normal.register
def _(node: Known, _below: tuple[Polarity, ...]) -> Polarity:
    return Polarity(node, Known(-node.margin - 1))


@normal.register
def _(node: Execution, _below: tuple[Polarity, ...]) -> Polarity:
    return Polarity(node, nodes.Not(node))  # missions have none under negations


@normal.register
def _(node: Task | Limit, _below: tuple[Polarity, ...]) -> Polarity:
    raise ValueError(f"'{node}' has no normal form of its own; translate the formula first")


def _holding(below: tuple[Polarity, ...]) -> tuple[Formula, ...]:
    return tuple(child.holds for child in below)


def _failing(below: tuple[Polarity, ...]) -> tuple[Formula, ...]:
    return tuple(child.fails for child in below)


def _ordered(node: Count | Linear) -> Formula:
    """No = and no !=, said with two ordered relations; of whole numbers no > and no < either."""
    match node.relation:
        case "=":
            return nodes.And((replace(node, relation=">="), replace(node, relation="<=")))
        case "!=":
            return nodes.Or((_strict(node, ">"), _strict(node, "<")))
        case ">" | "<":
            return _strict(node, node.relation)
    return node


def _strict(node: Count | Linear, relation: Relation) -> Formula:
    """`> m` of whole numbers is `>= m+1` and `< m` is `<= m-1`."""
    if isinstance(node, Linear) or isinstance(node.bound, Percent):
        return replace(node, relation=relation)
    if relation == ">":
        return replace(node, relation=">=", bound=node.bound + 1)
    return replace(node, relation="<=", bound=node.bound - 1)
