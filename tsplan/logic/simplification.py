"""Formulas made smaller without changing what they mean, nor by how much they hold."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import singledispatch
from typing import TypeAlias

from tsplan.logic.atoms import Count, Limit, Linear, Task
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
    conjunction,
    disjunction,
)
from tsplan.logic.traversal import fold

Below: TypeAlias = "tuple[Formula, ...]"


def simplify(formula: Formula) -> Formula:
    """An equal formula without needless constants, repetitions, negations and windows.

    Nested `and` and nested `or` become flat. Robustness stays the same at every step; the horizon
    may shrink where a constant swallows a window.

    >>> from tsplan.logic import parse
    >>> print(simplify(parse("F[1,2] F[0,3] a && (b && true) && !!b")))
    F[1,5] a && b
    """
    simple: Formula = fold(formula, simpler)
    return simple


@singledispatch
def simpler(node: Formula, _below: Below) -> Formula:
    """A node over simplified children, simplified. Every class of nodes registers its own."""
    raise TypeError(f"no simplification is registered for {type(node).__name__}")


@simpler.register(Constant)
@simpler.register(Count)
@simpler.register(Linear)
@simpler.register(Task)
@simpler.register(Limit)
def _(node: Formula, _below: Below) -> Formula:
    return node


@simpler.register
def _(_node: Not, below: Below) -> Formula:
    return _negated(below[0])


@simpler.register
def _(_node: And, below: Below) -> Formula:
    return _all(below)


@simpler.register
def _(_node: Or, below: Below) -> Formula:
    return _any(below)


@simpler.register
def _(node: Implies, below: Below) -> Formula:
    left, right = below
    if isinstance(left, Constant) or isinstance(right, Constant):
        return _any((_negated(left), right))
    return node.over(below)


@simpler.register
def _(node: Iff, below: Below) -> Formula:
    left, right = below
    if isinstance(left, Constant):
        return right if left is TRUE else _negated(right)
    if isinstance(right, Constant):
        return left if right is TRUE else _negated(left)
    return node.over(below)


@simpler.register(Eventually)
@simpler.register(Always)
def _(node: Eventually | Always, below: Below) -> Formula:
    return _window(type(node), node.low, node.high, below[0])


@simpler.register
def _(node: Until, below: Below) -> Formula:
    left, right = below
    low, high = node.low, node.high
    if right is FALSE or high == 0:
        return right
    if left is TRUE:
        return _window(Eventually, low, high, right)
    if left is FALSE:
        return FALSE if low else right
    if right is TRUE:
        return _window(Always, 0, low - 1, left) if low else TRUE
    return node.over(below)


@simpler.register
def _(node: Release, below: Below) -> Formula:
    left, right = below
    low, high = node.low, node.high
    if right is TRUE or high == 0:
        return right
    if left is FALSE:
        return _window(Always, low, high, right)
    if left is TRUE:
        return TRUE if low else right
    if right is FALSE:
        return _window(Eventually, 0, low - 1, left) if low else FALSE
    return node.over(below)


def _negated(formula: Formula) -> Formula:
    if isinstance(formula, Constant):
        return FALSE if formula is TRUE else TRUE
    return formula.child if isinstance(formula, Not) else Not(formula)


def _all(parts: Iterable[Formula]) -> Formula:
    kept = tuple(part for part in _flat(And, parts) if part is not TRUE)
    return FALSE if FALSE in kept else conjunction(kept)


def _any(parts: Iterable[Formula]) -> Formula:
    kept = tuple(part for part in _flat(Or, parts) if part is not FALSE)
    return TRUE if TRUE in kept else disjunction(kept)


def _flat(kind: type[And | Or], parts: Iterable[Formula]) -> Iterator[Formula]:
    """Each part once, in order; parts of the same kind are replaced by their own parts."""
    inner = (part.children if isinstance(part, kind) else (part,) for part in parts)
    yield from dict.fromkeys(part for group in inner for part in group)


def _window(kind: type[Eventually | Always], low: int, high: int, child: Formula) -> Formula:
    """A window over a constant is the constant; a window over a like window is one window."""
    if isinstance(child, Constant) or high == 0:
        return child
    if isinstance(child, kind):
        return kind(low + child.low, high + child.high, child.child)
    return kind(low, high, child)
