"""How many steps ahead a formula looks."""

from __future__ import annotations

from functools import singledispatch

from tsplan.logic.atoms import Count, Limit, Linear, Task
from tsplan.logic.nodes import Constant, Formula, Not, Pair, Several, Switch, Window
from tsplan.logic.traversal import fold


def horizon(formula: Formula) -> int:
    """The last step that matters for a formula judged at step 0.

    Tasks count with their closed interval; translate first for the half-open one. The left side
    of until and release is only looked at before the right side, hence one step less.

    >>> from tsplan.logic import parse
    >>> horizon(parse("F[0,5] G[0,2] a")), horizon(parse("(F[0,3] a) U[0,4] b"))
    (7, 6)
    """
    steps: int = fold(formula, reach)
    return steps


@singledispatch
def reach(node: Formula, _below: tuple[int, ...]) -> int:
    """The horizon of a node from those of its children. Every class of nodes registers its own."""
    raise TypeError(f"no horizon is registered for {type(node).__name__}")


@reach.register(Constant)
@reach.register(Count)
@reach.register(Linear)
@reach.register(Limit)
def _(_node: Formula, _below: tuple[int, ...]) -> int:
    return 0


@reach.register
def _(node: Task, _below: tuple[int, ...]) -> int:
    return node.duration


@reach.register(Not)
@reach.register(Several)
@reach.register(Pair)
def _(_node: Formula, below: tuple[int, ...]) -> int:
    return max(below)


@reach.register
def _(node: Window, below: tuple[int, ...]) -> int:
    return node.high + below[0]


@reach.register
def _(node: Switch, below: tuple[int, ...]) -> int:
    left, right = below
    return max(node.high + right, node.high - 1 + left) if node.high else right
