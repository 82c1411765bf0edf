"""Keeping counts at a distance from what a formula asks for."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from tsplan.logic.atoms import Count, Known, Percent
from tsplan.logic.nodes import Formula
from tsplan.logic.traversal import fold


def shifted(formula: Formula, by: int) -> Formula:
    """A formula in positive normal form whose every atom asks for so many agents more.

    What is known has so much less to spare.

    >>> from tsplan.logic import parse
    >>> print(shifted(parse("sum(A) >= 4 && sum(B) <= 1"), -2))
    sum(A) >= 2 && sum(B) <= 3
    """
    return _bounded(formula, lambda node, bound: bound + (by if node.relation == ">=" else -by), by)


def tighten(
    formula: Formula,
    total_of: Callable[[str | None], int],
    spare_of: Callable[[int], int],
    level: int = 0,
) -> Formula:
    """A formula in positive normal form whose every demand has head-room.

    An atom about `total_of(capability)` agents asks for `spare_of(total)` more than before, or
    allows so many less, but never for more than all of them nor for fewer than none: where all
    agents are, or none is, no count can stray. Atoms that hold for any count stay as they are, and
    so does what is known: it strays no more.

    >>> from tsplan.logic import parse
    >>> print(tighten(parse("sum(A) >= 3 && sum(B) <= 1"), lambda capability: 10, lambda all: 2))
    sum(A) >= 5 && sum(B) <= 0
    """

    def wanted(node: Count, bound: int) -> int:
        total = total_of(node.capability)
        spare = spare_of(total) if 0 < bound < total else 0
        if node.relation == ">=":
            return max(min(bound + spare, total) if spare else bound, bound + level)
        return min(max(bound - spare, 0) if spare else bound, bound - level)

    return _bounded(formula, wanted, level)


def _bounded(formula: Formula, bound_of: Callable[[Count, int], int], less: int) -> Formula:
    """A formula with other bounds of its atoms, which are numbers; known margins are less."""

    def moved(node: Formula, below: tuple[Formula, ...]) -> Formula:
        if isinstance(node, Known):
            return Known(node.margin - less)
        if not isinstance(node, Count):
            return node.over(below)
        if isinstance(node.bound, Percent):
            raise TypeError(f"'{node}' is a percentage; resolve_percent() makes it a number")
        return replace(node, bound=bound_of(node, node.bound))

    return fold(formula, moved)
