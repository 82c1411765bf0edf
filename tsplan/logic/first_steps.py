"""What a formula asks for within its first steps, whatever may come later."""

from __future__ import annotations

from tsplan.logic import nodes
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


def _weaker(node: Formula, last: int) -> Formula:
    """The same of a node in positive normal form, with so many steps to go."""
    if horizon(node) <= last:
        return node
    made: Formula = TRUE  # it may come to hold later
    match node:
        case nodes.And():
            made = conjunction(_weaker(child, last) for child in node.children)
        case nodes.Or():
            made = disjunction(_weaker(child, last) for child in node.children)
        case nodes.Whole():
            made = nodes.Whole(_weaker(node.child, last))
        case nodes.Always():
            made = conjunction(_steps(node, last))
        case nodes.Eventually() if node.high <= last:
            made = disjunction(_steps(node, last))
        case nodes.Until() | nodes.Release():
            made = _changing(node, last)
    return made


def _steps(node: nodes.Window, last: int) -> list[Formula]:
    """The windows in which the child is asked for in full, and single steps with less of it."""
    whole = last - horizon(node.child)  # up to there it ends in time
    parts: list[Formula] = []
    if node.low <= whole:
        parts.append(type(node)(node.low, min(node.high, whole), node.child))
    later = range(max(node.low, whole + 1), min(node.high, last) + 1)
    return parts + [type(node)(step, step, _weaker(node.child, last - step)) for step in later]


def _changing(node: nodes.Switch, last: int) -> Formula:
    """Of what changes over: the change-overs that end in time, or that there may be a later one."""
    whole = last - max(horizon(node.left), horizon(node.right))
    sooner = None
    if whole >= node.low:
        sooner = type(node)(node.low, min(node.high, whole), node.left, node.right)
    if isinstance(node, nodes.Release):
        return TRUE if sooner is None else sooner
    # if it changes over later than that, the left side holds at least until then
    kept = min(max(whole, node.low - 1), last - horizon(node.left))
    later = nodes.Always(0, kept, node.left) if kept >= 0 else TRUE
    return later if sooner is None else disjunction([sooner, later])
