"""What the best way to meet a formula is worth, where its tasks are worth something.

Every step at which the formula asks for a task counts once, and of several ways to meet it the best
one counts: of `and` the sum of its parts, of `G` the sum over its window; of `or` and `F` the
greatest; of `p U[a,b] q` the greatest, over the steps at which the change-over may be, of q there
and p at each step before. What does not hold is worth minus infinity.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import reduce

import numpy as np
import numpy.typing as npt

from tsplan.logic import nodes
from tsplan.logic.catl import TaskInterval, translate
from tsplan.logic.fraction import without_release
from tsplan.logic.nodes import Formula
from tsplan.logic.normal_form import positive
from tsplan.logic.traversal import fold

Floats = npt.NDArray[np.float64]


def tree_of_tasks(formula: Formula, interval: TaskInterval = "closed") -> Formula:
    """The formula in positive normal form, without release, every task with its `Execution`.

    >>> from tsplan.logic import parse
    >>> print(tree_of_tasks(parse("F[0,2] T(1, a, {(u,1)})", language="catl")))
    F[0,2] (G[0,1] (min(a,u) >= 1) && executed T(1,a,{(u,1)}))
    """
    made: Formula = fold(positive(translate(formula, interval, executed=True)), without_release)
    return made


def worth(tree: Formula, leaf: Callable[[Formula], Floats]) -> Floats:
    """What a tree is worth at every step at which it can be judged, given its atoms'.

    Values are exact where those of the atoms are whole numbers.

    >>> from tsplan.logic import parse
    >>> values = {"a": np.array([1.0, -np.inf, 5.0]), "b": np.array([2.0, 3.0, 0.0])}
    >>> tree = parse("F[0,2] a && G[0,1] b")
    >>> worth(tree, lambda atom: values[atom.label]).tolist()
    [10.0]
    """

    def value(node: Formula, below: tuple[Floats, ...]) -> Floats:
        return _joined(node, below) if below else leaf(node)

    made: Floats = fold(tree, value)
    return made


def _joined(node: Formula, below: tuple[Floats, ...]) -> Floats:
    match node:
        case nodes.And() | nodes.Or():
            length = min(map(len, below))
            parts = (part[:length] for part in below)
            return reduce(np.add if isinstance(node, nodes.And) else np.maximum, parts)
        case nodes.Always() | nodes.Eventually():
            (part,) = below
            steps = max(len(part) - node.high, 0)
            spans = (part[low : low + steps] for low in range(node.low, node.high + 1))
            return reduce(np.add if isinstance(node, nodes.Always) else np.maximum, spans)
        case nodes.Not():  # of what is never asked for by itself
            return np.full_like(below[0], -np.inf)
        case nodes.Until():
            return _changed_over(node, *below)
    raise TypeError(f"'{node}' is worth nothing by itself; take tree_of_tasks() first")


def _changed_over(node: nodes.Until, left: Floats, right: Floats) -> Floats:
    """The best change-over from the left side to the right one."""
    steps = max(len(right) - node.high, 0)
    if node.high:  # or else the left side does not matter
        steps = min(steps, max(len(left) + 1 - node.high, 0))
    before = np.zeros(steps)
    best = np.full(steps, -np.inf)
    for late in range(node.high + 1):
        if late >= node.low:
            best = np.maximum(best, before + right[late : late + steps])
        if late < node.high:
            before = before + left[late : late + steps]
    return best
