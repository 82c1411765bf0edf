"""Which formulas never hold by more than others, so that a conjunction needs only the lesser ones.

What is said here follows from the shapes of formulas alone and holds for robustness, not merely for
truth: `G[0,5] p` is at most `G[0,3] p`, `p && q` at most `p`, `F[1,2] p` at most `F[0,4] (p || q)`.
Where shapes do not tell, nothing is said.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

from tsplan.logic import nodes
from tsplan.logic.atoms import Count
from tsplan.logic.nodes import FALSE, TRUE, Formula
from tsplan.logic.settled import settled

_DEPTH = 12  # levels of formulas that are compared; what is deeper is taken for different


class Dominance:
    """Compares formulas; what has been compared once is remembered."""

    def __init__(self) -> None:
        self._found: dict[tuple[Formula, Formula], bool] = {}

    def at_most(self, lesser: Formula, other: Formula, depth: int = _DEPTH) -> bool:
        """Whether the robustness of `lesser` is at most that of `other` on every trace, for sure.

        >>> from tsplan.logic import parse
        >>> Dominance().at_most(parse("G[0,5] (a && b)"), parse("F[2,3] a || c"))
        True
        """
        if lesser is other or lesser is FALSE or other is TRUE:
            return True
        if not depth:
            return False
        key = lesser, other
        if key not in self._found:
            self._found[key] = self._compared(lesser, other, depth - 1)
        return self._found[key]

    def least(self, parts: Iterable[Formula]) -> tuple[Formula, ...]:
        """The parts that decide a conjunction: those that no other one is at most."""
        return self._deciding(parts, lambda one, other: self.at_most(other, one))

    def greatest(self, parts: Iterable[Formula]) -> tuple[Formula, ...]:
        """The parts that decide a disjunction."""
        return self._deciding(parts, self.at_most)

    def _deciding(
        self, parts: Iterable[Formula], needless: Callable[[Formula, Formula], bool]
    ) -> tuple[Formula, ...]:
        """The parts of which none makes another one needless; of equal ones the first."""
        kept: list[Formula] = []
        for part in dict.fromkeys(parts):
            if any(needless(part, other) for other in kept):
                continue
            kept = [other for other in kept if not needless(other, part)]
            kept.append(part)
        return tuple(kept)

    def _compared(self, lesser: Formula, other: Formula, depth: int) -> bool:
        known, beside = settled(lesser), settled(other)
        if known is not None and beside is not None:
            return known <= beside
        if isinstance(lesser, nodes.Or):
            return _plain(lesser) and all(self.at_most(c, other, depth) for c in lesser.children)
        if isinstance(other, nodes.And):
            return _plain(other) and all(self.at_most(lesser, c, depth) for c in other.children)
        if any(self.at_most(part, other, depth) for part in _at_least(lesser)):
            return True
        if any(self.at_most(lesser, part, depth) for part in _at_most(other)):
            return True
        return self._alike(lesser, other, depth)

    def _alike(self, lesser: Formula, other: Formula, depth: int) -> bool:
        """Formulas of the same operator, or of windows that meet."""
        match lesser, other:
            case nodes.Not(child=one), nodes.Not(child=two):
                return self.at_most(two, one, depth)
            case Count() as one, Count() as two:
                return _asks_no_less(one, two)
            case nodes.Always() as one, nodes.Eventually() as two:
                alike = max(one.low, two.low) <= min(one.high, two.high)
            case ((nodes.Always() | nodes.Release() as one), two) if type(one) is type(two):
                alike = _within(two, one)
            case ((nodes.Eventually() | nodes.Until() as one), two) if type(one) is type(two):
                alike = _within(one, two)
            case _:
                return False
        pairs = zip(lesser.children, other.children, strict=True)
        plain = _plain(lesser) and _plain(other)
        return alike and plain and all(self.at_most(*pair, depth) for pair in pairs)


def _at_least(formula: Formula) -> tuple[Formula, ...]:
    """Parts of a formula that are all at least as robust as it is."""
    match formula:
        case nodes.Whole():
            return formula.children
        case nodes.And() if _plain(formula):
            return formula.children
        case nodes.Always() | nodes.Release() if not formula.low and _plain(formula):
            return formula.children[-1:]
    return ()


def _at_most(formula: Formula) -> tuple[Formula, ...]:
    """Parts of a formula that are all at most as robust as it is."""
    match formula:
        case nodes.Whole():
            return formula.children
        case nodes.Or() if _plain(formula):
            return formula.children
        case nodes.Eventually() | nodes.Until() if not formula.low and _plain(formula):
            return formula.children[-1:]
    return ()


def _within(inner: Any, outer: Any) -> bool:
    """Whether the window of one node lies in that of another."""
    return bool(outer.low <= inner.low and inner.high <= outer.high)


def _plain(node: Formula) -> bool:
    """Whether a node has no weights, which make kinds of robustness unlike."""
    return getattr(node, "weights", None) is None


def _asks_no_less(lesser: Count, other: Count) -> bool:
    """Whether one count is compared with a bound that asks for as much as another's or more."""
    same = (lesser.function, lesser.label, lesser.capability, lesser.relation) == (
        other.function,
        other.label,
        other.capability,
        other.relation,
    )
    if not same or not (isinstance(lesser.bound, int) and isinstance(other.bound, int)):
        return False
    if lesser.relation in (">=", ">"):
        return lesser.bound >= other.bound
    return lesser.relation in ("<=", "<") and lesser.bound <= other.bound
