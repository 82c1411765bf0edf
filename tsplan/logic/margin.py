"""Keeping counts at a distance from what a formula asks for."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from tsplan.logic.atoms import Count, Percent
from tsplan.logic.nodes import Formula
from tsplan.logic.traversal import fold


def tighten(
    formula: Formula,
    total_of: Callable[[str | None], int],
    spare_of: Callable[[int], int],
    level: int = 0,
) -> Formula:
    """A formula in positive normal form whose every demand has head-room.

    An atom about `total_of(capability)` agents asks for `spare_of(total)` more than before, or
    allows so many less, but never for more than all of them nor for fewer than none: where all
    agents are, or none is, no count can stray. Atoms that hold for any count stay as they are.

    >>> from tsplan.logic import parse
    >>> print(tighten(parse("sum(A) >= 3 && sum(B) <= 1"), lambda capability: 10, lambda all: 2))
    sum(A) >= 5 && sum(B) <= 0
    """

    def moved(node: Formula, below: tuple[Formula, ...]) -> Formula:
        if not isinstance(node, Count):
            return node.over(below)
        if isinstance(node.bound, Percent):
            raise TypeError(f"'{node}' is a percentage; resolve_percent() makes it a number")
        total = total_of(node.capability)
        spare = spare_of(total) if 0 < node.bound < total else 0
        if node.relation == ">=":
            wanted = min(node.bound + spare, total) if spare else node.bound
            return replace(node, bound=max(wanted, node.bound + level))
        wanted = max(node.bound - spare, 0) if spare else node.bound
        return replace(node, bound=min(wanted, node.bound - level))

    return fold(formula, moved)
