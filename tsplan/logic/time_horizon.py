"""How many steps ahead a formula looks, and where it looks at its parts."""

from __future__ import annotations

from functools import singledispatch
from typing import TypeAlias

from tsplan.logic.atoms import Count, Execution, Known, Limit, Linear, Task
from tsplan.logic.nodes import Constant, Formula, Not, Pair, Several, Switch, Whole, Window
from tsplan.logic.traversal import fold

Span: TypeAlias = tuple[int, int]
"""A first and a last step; no step at all where the last comes before the first."""


def horizon(formula: Formula) -> int:
    """The last step that matters for a formula judged at step 0.

    Tasks count with their closed interval; translate first for the half-open one. The left side
    of until and release is only looked at before the right side, hence one step less.

    >>> from tsplan.logic import parse
    >>> horizon(parse("F[0,5] G[0,2] a")), horizon(parse("(F[0,3] a) U[0,4] b"))
    (7, 6)
    """
    return fold(formula, _horizon)


def _horizon(node: Formula, below: tuple[int, ...]) -> int:
    own = node.left if isinstance(node, Task) else 0
    own = node.last if isinstance(node, Execution) else own
    spans = zip(lookahead(node), below, strict=True)
    return max((last + steps for (_, last), steps in spans if last >= 0), default=own)


@singledispatch
def lookahead(node: Formula) -> tuple[Span, ...]:
    """Between which steps from now each child of a node matters.

    Every class of nodes registers its own.
    """
    raise TypeError(f"no lookahead is registered for {type(node).__name__}")


@lookahead.register
def _(
    node: Constant | Count | Linear | Known | Execution | Task | Limit,
) -> tuple[Span, ...]:
    return ()


@lookahead.register
def _(node: Not | Whole | Several | Pair) -> tuple[Span, ...]:
    return ((0, 0),) * len(node.children)


@lookahead.register
def _(node: Window) -> tuple[Span, ...]:
    return ((node.low, node.high),)


@lookahead.register
def _(node: Switch) -> tuple[Span, ...]:
    return (0, node.high - 1), (node.low, node.high)
