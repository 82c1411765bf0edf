"""Formulas whose robustness is known already, whatever is still to come."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from math import inf, isinf
from types import MappingProxyType
from typing import NamedTuple

from tsplan.logic.atoms import Known, Linear, Relation
from tsplan.logic.nodes import FALSE, TRUE, Constant, Formula


class Settled(NamedTuple):
    """A robustness that is known, and whether the formula holds.

    They are compared by the robustness first: of all parts of an `and` the least decides, of those
    of an `or` the greatest. On the border, robustness 0 of signals, the truth decides.
    """

    margin: float
    holds: bool


_ALWAYS, _NEVER = Settled(inf, True), Settled(-inf, False)

_BORDERS: Mapping[Relation, Callable[[float], Settled]] = MappingProxyType(
    {
        ">=": lambda bound: Settled(0.0 - bound, bound <= 0),
        ">": lambda bound: Settled(0.0 - bound, bound < 0),
        "<=": lambda bound: Settled(bound, bound >= 0),
        "<": lambda bound: Settled(bound, bound > 0),
        "=": lambda bound: Settled(-abs(bound), bound == 0),
        "!=": lambda bound: Settled(abs(bound), bound != 0),
    }
)
"""What a sum of no signals, which is 0, has to spare to a bound."""


def settled(formula: Formula) -> Settled | None:
    """The robustness of a formula that has the same on every trace, as far as it tells by itself.

    >>> from tsplan.logic import parse
    >>> settled(Known(2)), settled(parse("0 > 1.5", language="stl")), settled(parse("a"))
    (Settled(margin=2, holds=True), Settled(margin=-1.5, holds=False), None)
    """
    match formula:
        case Constant():
            return _ALWAYS if formula.value else _NEVER
        case Known():
            return Settled(formula.margin, formula.margin >= 0)
        case Linear() if not formula.terms:
            return _BORDERS[formula.relation](formula.bound)
    return None


def known_count(margin: float) -> Formula:
    """The formula of counts with this robustness; ValueError for one that is not whole."""
    if isinf(margin):
        return _endless(margin)
    if margin != int(margin):
        raise ValueError(f"{margin} agents are to spare: expected numbers leave no known margin")
    return Known(int(margin))


def known_signal(margin: float, holds: bool) -> Formula:
    """The formula of signals with this robustness and truth.

    >>> print(known_signal(1.5, True), known_signal(0.0, False), sep=", ")
    0 >= -1.5, 0 > 0
    """
    if isinf(margin):
        return _endless(margin)
    return Linear((), ">=" if holds or margin < 0 else ">", -margin)


def _endless(margin: float) -> Formula:
    return TRUE if margin > 0 else FALSE
