"""How far the two sides of a predicate over signals can be apart, by the signals' bounds."""

from __future__ import annotations

from collections.abc import Mapping
from math import isfinite
from types import MappingProxyType
from typing import TypeAlias

from tsplan.errors import Finding, FormulaError
from tsplan.logic.atoms import Linear
from tsplan.logic.nodes import Formula
from tsplan.logic.symbols import variables
from tsplan.logic.traversal import walk
from tsplan.words import nfc

Bounds: TypeAlias = Mapping[str, tuple[float, float]]
"""The least and the greatest value of signals, by their names."""


def predicate_ranges(formula: Formula, bounds: Bounds) -> Mapping[Linear, float]:
    """The greatest less the least value of what each predicate of a formula compares.

    This is interval arithmetic: each signal takes any value within its bounds. Raises FormulaError
    with every signal of the formula that has no bounds, or not two finite ones in their order.

    >>> from tsplan.logic import linear
    >>> atom = linear({"x": 1, "y": -2}, ">=", 3)
    >>> predicate_ranges(atom, {"x": (0, 10), "y": (-1, 1)})[atom]
    14.0
    """
    known = {nfc(name): ends for name, ends in bounds.items()}
    findings = [
        Finding(words, f"give its least and its greatest value, as in bounds {name}=0:10")
        for name in variables(formula)
        if (words := _complaint(name, known)) is not None
    ]
    if findings:
        raise FormulaError(findings)
    widths = {name: float(high) - float(low) for name, (low, high) in known.items()}
    return MappingProxyType(
        {
            node: sum((abs(factor) * widths[name] for name, factor in node.terms), 0.0)
            for node in walk(formula)
            if isinstance(node, Linear)
        }
    )


def _complaint(name: str, known: Bounds) -> str | None:
    if name not in known:
        return f"the signal '{name}' has no bounds, which its share of its range needs"
    low, high = known[name]
    if not (isfinite(low) and isfinite(high)):
        return f"the bounds {low:g} to {high:g} of the signal '{name}' are not finite"
    return None if low <= high else f"the bounds of the signal '{name}' end before they begin"
