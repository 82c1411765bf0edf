"""Formulas made smaller without changing what they mean, nor by how much they hold."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from functools import singledispatch
from typing import TypeAlias

from tsplan.logic import nodes
from tsplan.logic.atoms import OPPOSITE, Count, Execution, Known, Limit, Linear, Task
from tsplan.logic.nodes import FALSE, TRUE, Formula
from tsplan.logic.settled import settled
from tsplan.logic.traversal import fold

Below: TypeAlias = "tuple[Formula, ...]"


def simplify(formula: Formula) -> Formula:
    """An equal formula without needless constants, repetitions, negations and windows.

    Nested `and` and nested `or` become flat. Robustness stays the same at every step; the horizon
    may shrink where a constant swallows a window. What has weights stays as it is over simplified
    parts: what they weigh would be another thing.

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


@simpler.register
def _(
    node: nodes.Constant | Count | Linear | Known | Execution | Task | Limit, _below: Below
) -> Formula:
    return node


@simpler.register
def _(_node: nodes.Not, below: Below) -> Formula:
    return _negated(below[0])


@simpler.register
def _(node: nodes.Whole, below: Below) -> Formula:
    """What never holds in part needs not be said to count as a whole."""
    (child,) = below
    return (
        child
        if isinstance(child, nodes.Constant | Count | Linear | Known | nodes.Whole)
        else node.over(below)
    )


@simpler.register
def _(node: nodes.And | nodes.Or, below: Below) -> Formula:
    return node.over(below) if node.weights else joined(type(node), below)


@simpler.register
def _(node: nodes.Implies, below: Below) -> Formula:
    left, right = below
    if settled(left) or settled(right):
        return joined(nodes.Or, (_negated(left), right))
    return node.over(below)


@simpler.register
def _(node: nodes.Iff, below: Below) -> Formula:
    left, right = below
    if isinstance(left, nodes.Constant):
        return right if left is TRUE else _negated(right)
    if isinstance(right, nodes.Constant):
        return left if right is TRUE else _negated(left)
    if settled(left) and settled(right):
        neither = joined(nodes.And, map(_negated, below))
        return joined(nodes.Or, (joined(nodes.And, below), neither))
    return node.over(below)


@simpler.register
def _(node: nodes.Eventually | nodes.Always, below: Below) -> Formula:
    if node.weights:
        return node.over(below)
    return _window(type(node), node.low, node.high, below[0])


@simpler.register
def _(node: nodes.Until | nodes.Release, below: Below) -> Formula:
    """Rules of until; release has the same with constants and windows exchanged."""
    if node.weights:
        return node.over(below)
    left, right = below
    low, high = node.low, node.high
    until = isinstance(node, nodes.Until)
    true, false = (TRUE, FALSE) if until else (FALSE, TRUE)
    some, every = (nodes.Eventually, nodes.Always) if until else (nodes.Always, nodes.Eventually)
    if right is false or high == 0:
        return right
    if left is true:
        return _window(some, low, high, right)
    if left is false:
        return false if low else right
    if settled(right):
        before = _window(every, 0, low - 1, left) if low else true
        return joined(nodes.And if until else nodes.Or, (right, before))
    return node.over(below)


def joined(kind: type[nodes.And | nodes.Or], parts: Iterable[Formula]) -> Formula:
    """Simplified parts under `and` without TRUE, or FALSE if one is; under `or` the other way.

    Of those whose margins are known, only the one that decides the others.
    """
    idle, decisive = (TRUE, FALSE) if kind is nodes.And else (FALSE, TRUE)
    each = tuple(_flat(kind, parts))
    known = {part: margin for part in each if (margin := settled(part))}
    if known:
        decided = (min if kind is nodes.And else max)(known, key=known.__getitem__)
        each = tuple(part for part in each if part is decided or part not in known)
    kept = tuple(part for part in each if part is not idle)
    if decisive in kept or len(kept) < 2:  # noqa: PLR2004  (a single part is itself)
        return decisive if decisive in kept else (*kept, idle)[0]
    return kind(kept)


def _negated(formula: Formula) -> Formula:
    if isinstance(formula, nodes.Constant):
        return FALSE if formula is TRUE else TRUE
    if isinstance(formula, Known):
        return Known(-formula.margin - 1)
    if isinstance(formula, Linear) and not formula.terms:
        return replace(formula, relation=OPPOSITE[formula.relation])
    return formula.child if isinstance(formula, nodes.Not) else nodes.Not(formula)


def _flat(kind: type[nodes.And | nodes.Or], parts: Iterable[Formula]) -> Iterator[Formula]:
    """Each part once, in order; parts of the same kind are replaced by their own parts."""
    inner = (
        part.children if isinstance(part, kind) and not part.weights else (part,) for part in parts
    )
    yield from dict.fromkeys(part for group in inner for part in group)


def _window(
    kind: type[nodes.Eventually | nodes.Always], low: int, high: int, child: Formula
) -> Formula:
    """A window over what is known is that; a window over a like window is one window."""
    if settled(child) or high == 0:
        return child
    if isinstance(child, kind) and not child.weights:
        return kind(low + child.low, high + child.high, child.child)
    return kind(low, high, child)
