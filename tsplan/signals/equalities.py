"""Equations between real signals, which hold where their sides are as good as equal.

Signals are simulated in floats, so that an equation that a solver has met to its last digit would
fail all the same. It holds here where its sides differ by no more than a share of their range, as
bounds and limits do.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from tsplan.logic import And, Formula, Linear, Or, Relation, Whole
from tsplan.logic.fraction import tree_of
from tsplan.logic.normal_form import positive_atoms
from tsplan.logic.traversal import substitute, walk
from tsplan.signals.linear_system import System, Terms

TOLERANCE = 1e-6
"""What may be amiss, as a share of the range of a value: ten times the 1e-7 by which solvers of
linear programs let rows fail, so that rows may be scaled a little."""

MARGIN = 1e-5
"""Of its range: by how much a predicate is to hold where by none it does not, be it that it is
strict or that a solver forgave too much. Ten times what solvers forgive."""


def range_of(terms: Terms, system: System) -> float:
    """The range of a sum by the bounds of its signals, of which those without count 1."""
    bounds = {**system.signals, **system.controls}
    total = 0.0
    for name, factor in terms:
        width = bounds[name][1] - bounds[name][0] if name in bounds else 1.0
        total += abs(factor) * (width if 0 < width < float("inf") else 1.0)
    return total


def approximate(
    formula: Formula,
    system: System,
    share: float = TOLERANCE,
    margin: float = 0.0,
    *,
    strictly: bool = False,
) -> Formula:
    """The formula in positive normal form, with equations by comparisons a share of a range apart.

    Sides that are no further apart count as equal, and not as different. All other comparisons are
    to hold by a `margin`, which is such a share as well; `strictly` those alone whose border does
    not belong to them. An equation counts as a whole still.

    >>> from tsplan.logic import parse
    >>> print(approximate(parse("F[0,2] x = 3", "stl"), System({"x": (0, 10)}), 0.01))
    F[0,2] all(x >= 2.9, x <= 3.1)
    """
    whole = positive_atoms(formula)
    found: dict[Formula, Formula] = {}
    for node in walk(whole):
        if isinstance(node, Linear):
            width = range_of(node.terms, system)
            if node.relation == "=":
                sides = _moved(node, ">=", -share * width), _moved(node, "<=", share * width)
                found[node] = Whole(And(sides))
            elif node.relation == "!=":
                far = (share + margin) * width
                found[node] = Or((_moved(node, "<", -far), _moved(node, ">", far)))
            elif margin and (node.relation in ("<", ">") or not strictly):
                found[node] = _narrower(node, margin * width)
    return substitute(whole, found) if found else whole


def equations(formula: Formula) -> Iterator[Linear]:
    """The comparisons of a formula that equate sums."""
    every = walk(positive_atoms(formula))
    return (node for node in every if isinstance(node, Linear) and node.relation == "=")


def tree(formula: Formula, system: System) -> Formula:
    """The tree whose fraction counts, with equations as they are taken."""
    return tree_of(approximate(formula, system))


def narrowed_tree(formula: Formula, system: System) -> Formula:
    """A tree of which what holds does so in `tree`, too, however a solver meets its rows.

    Rows know no border that does not belong to a comparison, so that keeps a margin from it.
    """
    return tree_of(approximate(formula, system, TOLERANCE / 2, MARGIN, strictly=True))


def loosened(tree: Formula, system: System, share: float = TOLERANCE) -> dict[Formula, Formula]:
    """The comparisons of a formula, each by one that may be missed by a share of its range.

    Equations are not among them.

    >>> from tsplan.logic import parse
    >>> made = loosened(parse("F[0,2] x >= 3", "stl"), System({"x": (0, 10)}), 0.01)
    >>> [f"{one} for {other}" for one, other in made.items()]
    ['x >= 2.9 for x >= 3']
    """
    return {
        _narrower(node, -share * range_of(node.terms, system)): node
        for node in walk(tree)
        if isinstance(node, Linear) and node.relation not in ("=", "!=")
    }


def _narrower(node: Linear, by: float) -> Linear:
    """An ordered comparison that asks for so much more."""
    return _moved(node, node.relation, by if node.relation in (">=", ">") else -by)


def _moved(node: Linear, relation: Relation, by: float) -> Linear:
    return replace(node, relation=relation, bound=node.bound + by)
