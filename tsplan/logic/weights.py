"""What weights do to robustness: the factors of parts, and formulas that mean the same without.

A weighted part counts `factor * robustness`. There are two weightings:

* `product`: the factor is the weight. Under `and` and `G` a part that holds matters less to the
  minimum the greater its weight is, and one that fails matters more.
* `normalised`: with v the weight's share of all weights of the node, a part of `and`, `G` and
  `R` that holds has the factor 1 - v, one that fails v; of `or`, `F` and `U` the other way round.
  A part that is alone has the factor 1/2, since 1 - v would be 0.

Weights of until and release belong to the steps of the change-over and count for the right side.

Sources: product: G. A. Cardona, D. Kamale and C.-I. Vasile, "Mixed Integer Linear Programming
Approach for Control Synthesis with Weighted Signal Temporal Logic", HSCC 2023; normalised: N.
Mehdipour, C.-I. Vasile and C. Belta, "Specifying User Preferences Using Weighted Signal Temporal
Logic", L-CSS 2021.
"""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from itertools import groupby
from operator import itemgetter
from sys import float_info
from typing import Any, Literal, NamedTuple, TypeAlias

from tsplan.logic.atoms import Linear
from tsplan.logic.nodes import (
    Always,
    And,
    Constant,
    Formula,
    Release,
    Switch,
    Window,
    conjunction,
    disjunction,
)
from tsplan.logic.normal_form import positive
from tsplan.logic.traversal import walk

Weighting: TypeAlias = Literal["product", "normalised"]

_ALL = (And, Always, Release)  # what is as good as its worst part
_LEAST, _MOST = float_info.min, float_info.max  # floats that keep all their digits lie between


class Factors(NamedTuple):
    """What the robustness of a part is multiplied by."""

    satisfied: float  # where it is 0 or more
    violated: float


def factors(
    kind: type[Formula], weights: Iterable[float], weighting: Weighting
) -> tuple[Factors, ...]:
    """The factors of the parts of a node of this kind that has these weights.

    >>> factors(And, (1.0, 3.0), "normalised")
    (Factors(satisfied=0.75, violated=0.25), Factors(satisfied=0.25, violated=0.75))
    """
    each = tuple(weights)
    if weighting == "product":
        return tuple(Factors(weight, weight) for weight in each)
    if len(each) == 1:
        return (Factors(0.5, 0.5),)
    total = sum(map(Fraction, each), Fraction(0))
    shares = [Fraction(weight) / total for weight in each]
    # subtracted as fractions: the lesser one is above 0 however unlike the weights are
    pairs = ((float(1 - share), float(share)) for share in shares)
    return tuple(Factors(*(pair if kind in _ALL else reversed(pair))) for pair in pairs)


class _Piece(NamedTuple):
    """A node without weights that says a part of what one with weights does."""

    parameters: tuple[Any, ...]
    scales: tuple[float, ...]  # of its children


def unweighted(
    formula: Formula, weighting: Weighting = "product", *, satisfied: bool = True
) -> Formula:
    """The formula without weights, in positive normal form, over predicates that are scaled.

    On the way from the root to a predicate the factors multiply to W, and `e >= c` becomes
    `W*e >= W*c`. A weighted window becomes one for each run of its steps with equal factors, all or
    some of which count as the operator says; until and release do likewise by their change-over.

    With `product` its traditional robustness is the weighted one of the formula, up to rounding.
    With `normalised` that is so where the formula holds (robustness 0 or more), since the factors
    are those of parts that hold; with `satisfied` False where it fails (0 or less). On the other
    side only the signs agree.

    Raises ValueError for weights over counts of agents, for tasks and limits, and for weights that
    multiply to what floats do not hold.

    >>> from tsplan.logic import linear
    >>> x, y = linear({"x": 1}, ">=", 2), linear({"y": 1}, "<=", 6)
    >>> print(unweighted(And((x, y.always(0, 3, [0.5, 0.5, 1, 1])), (3, 2))))
    3*x >= 6 && (G[0,1] (y <= 6) && G[2,3] (2*y <= 12))
    """
    plain = positive(formula)
    pieces = {node: _pieces(node, weighting, satisfied) for node in walk(plain)}
    made: dict[tuple[Formula, float], Formula] = {}
    waiting = [(plain, 1.0)]
    while waiting:
        node, factor = waiting[-1]
        below = [
            [(child, factor * scale) for child, scale in zip(node.children, scales, strict=True)]
            for _, scales in pieces[node]
        ]
        missing = [key for keys in below for key in keys if key not in made]
        waiting += missing
        if not missing:
            parts = [[made[key] for key in keys] for keys in below]
            made[waiting.pop()] = _assembled(node, factor, pieces[node], parts)
    return made[plain, 1.0]


def _pieces(node: Formula, weighting: Weighting, satisfied: bool) -> tuple[_Piece, ...]:
    weights = getattr(node, "weights", None)
    if weights is None:
        return (_Piece(node.parameters, (1.0,) * len(node.children)),)
    pairs = factors(type(node), weights, weighting)
    scales = tuple(pair.satisfied if satisfied else pair.violated for pair in pairs)
    if not isinstance(node, Window | Switch):
        return (_Piece((), scales),)
    runs = [list(run) for _, run in groupby(enumerate(scales, node.low), key=itemgetter(1))]
    left = (1.0,) * (len(node.children) - 1)
    return tuple(_Piece((run[0][0], run[-1][0]), (*left, run[0][1])) for run in runs)


def _assembled(
    node: Formula, factor: float, pieces: Iterable[_Piece], parts: Iterable[list[Formula]]
) -> Formula:
    if not node.children:
        return _scaled(node, factor)
    each = (
        type(node).assembled(piece.parameters, own)
        for piece, own in zip(pieces, parts, strict=True)
    )
    return conjunction(each) if isinstance(node, _ALL) else disjunction(each)


def _scaled(atom: Formula, factor: float) -> Formula:
    if factor == 1 or isinstance(atom, Constant):
        return atom
    if not isinstance(atom, Linear):
        raise ValueError(f"weights scale predicates over signals, but '{atom}' counts agents")  # noqa: TRY004  (a formula is the value)
    terms = tuple((name, own * factor) for name, own in atom.terms)
    numbers = [(own, own * factor) for own in (atom.bound, *(own for _, own in atom.terms))]
    if not all(_LEAST <= abs(scaled) <= _MOST for own, scaled in numbers if own):
        raise ValueError(
            f"the weights on the way to '{atom}' multiply to {factor:g}, which is too "
            "small or too large for its numbers; scale the weights"
        )
    return Linear(terms, atom.relation, atom.bound * factor)
