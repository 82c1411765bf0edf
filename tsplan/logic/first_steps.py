"""What a formula asks for within its first steps, whatever may come later."""

from __future__ import annotations

from functools import singledispatch

from tsplan.logic import nodes
from tsplan.logic.atoms import Count, Execution, Known, Linear
from tsplan.logic.nodes import TRUE, Formula, conjunction, disjunction
from tsplan.logic.normal_form import positive
from tsplan.logic.simplification import simplify
from tsplan.logic.time_horizon import horizon


def within(formula: Formula, last: int) -> Formula:
    """A weaker formula that looks no further than step `last`.

    Every trace whose continuation can satisfy the formula satisfies it: what may come to hold after
    that step counts as holding, and what has to hold after it is not asked for yet. A formula that
    ends by then is itself.

    >>> from tsplan.logic import parse
    >>> print(within(parse("F[0,30] a && G[2,40] !b && F[0,9] G[0,2] c && G[0,50] F[0,5] d"), 10))
    G[2,10] (sum(b) <= 0) && (F[0,8] G[0,2] c || F[9,9] G[0,1] c) && G[0,5] F[0,5] d
    """
    return simplify(_weaker(positive(formula), last))


@singledispatch
def _weaker(node: Formula, last: int) -> Formula:
    """The same of a node in positive normal form, with so many steps to go."""
    raise TypeError(f"no outlook is registered for {type(node).__name__}")


@_weaker.register
def _(node: nodes.Constant | Known | Count | Linear | Execution, last: int) -> Formula:
    return node if horizon(node) <= last else TRUE


@_weaker.register
def _(node: nodes.And, last: int) -> Formula:
    return conjunction(_weaker(child, last) for child in node.children)


@_weaker.register
def _(node: nodes.Or, last: int) -> Formula:
    return disjunction(_weaker(child, last) for child in node.children)


@_weaker.register
def _(node: nodes.Whole, last: int) -> Formula:
    return nodes.Whole(_weaker(node.child, last))


@_weaker.register
def _(node: nodes.Eventually, last: int) -> Formula:
    if node.high > last:  # it may come later
        return TRUE
    return disjunction(_steps(node, last))


@_weaker.register
def _(node: nodes.Always, last: int) -> Formula:
    return conjunction(_steps(node, last))


def _steps(node: nodes.Window, last: int) -> list[Formula]:
    """The windows in which the child is asked for in full, and single steps with less of it."""
    whole = last - horizon(node.child)  # up to there it ends in time
    parts: list[Formula] = []
    if node.low <= whole:
        parts.append(type(node)(node.low, min(node.high, whole), node.child))
    later = range(max(node.low, whole + 1), min(node.high, last) + 1)
    return parts + [type(node)(step, step, _weaker(node.child, last - step)) for step in later]


@_weaker.register
def _(node: nodes.Until, last: int) -> Formula:
    if horizon(node) <= last:
        return node
    whole = last - max(horizon(node.left), horizon(node.right))  # a change-over there ends in time
    # if it changes over later than that, the left side holds at least until then
    kept = min(max(whole, node.low - 1), last - horizon(node.left))
    later = nodes.Always(0, kept, node.left) if kept >= 0 else TRUE
    if whole < node.low:
        return later
    sooner = nodes.Until(node.low, min(node.high, whole), node.left, node.right)
    return disjunction([sooner, later])


@_weaker.register
def _(node: nodes.Release, last: int) -> Formula:
    if horizon(node) <= last:
        return node
    whole = last - max(horizon(node.left), horizon(node.right))
    if whole < node.low:
        return TRUE
    return nodes.Release(node.low, min(node.high, whole), node.left, node.right)
