"""What weights do to robustness: the factors of parts.

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
from sys import float_info
from typing import Literal, NamedTuple, TypeAlias

from tsplan.logic.nodes import (
    Always,
    And,
    Formula,
    Release,
)

Weighting: TypeAlias = Literal["product", "normalised"]

_ALL = (And, Always, Release)  # what is as good as its worst part


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
