"""Demands on predicates as rows of the model.

Where a selection w is 1, `a.y - rho/s >= b`. Options that exclude each other share one row for
their direction a and step: with `base` below which `a.y - rho/s` cannot be, it is
`a.y - rho/s >= base + sum of (b_i - base) * w_i`, which is exact, since at most one w_i is 1, and
stronger than a row for each. What is asked for in any case is a row of its own and the base of the
others.

Source of the single rows: V. Raman et al., "Model predictive control with signal temporal logic
specifications", CDC 2014; the constants are the least that the reachable intervals allow.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator

import numpy as np

from tsplan.encode.encoder_rules import Witnesses
from tsplan.milp.model import Draft, Terms
from tsplan.signals.linear_system import Terms as Sum
from tsplan.signals.predicates import HalfSpace, LinearEncoder

Direction = tuple[Sum, float]  # the terms of a sum and the scale of its robustness


class PredicateRows:
    """Collects rows over the columns of an encoder; `rho` is the robustness's column.

    With a negative `rho` the robustness is the number `encoder.most`. Unless `merged`, options that
    exclude each other have rows of their own.
    """

    def __init__(self, encoder: LinearEncoder, rho: int, *, merged: bool = True) -> None:
        self._encoder = encoder
        self._rho = rho
        self._merged = merged
        self._terms: list[Terms] = []
        self._lower: list[float] = []

    def write(self, witnesses: Witnesses, draft: Draft) -> None:
        """Draft the rows of all demands."""
        for (terms, scale), steps in _by_direction(witnesses).items():
            low = self._encoder.sides(terms)[0]
            wanted = self._encoder.most / scale  # the most that rho/s can be
            for step, asked in steps.items():
                hard = asked.pop(-1, -np.inf)
                base = max(hard, float(low[step]) - wanted)
                if hard > low[step] - wanted:
                    self._row((terms, scale), step, hard, {})
                every = witnesses.choices.families(asked) if self._merged else [[c] for c in asked]
                for family in every:
                    beyond = {c: asked[c] - base for c in family if asked[c] > base}
                    if beyond:
                        self._row((terms, scale), step, base, beyond)
        draft.sums(*self._terms, lower=np.array(self._lower), kind="predicate")

    def _row(self, of: Direction, step: int, base: float, beyond: dict[int, float]) -> None:
        terms, scale = of
        row = len(self._lower)
        columns, factors = self._encoder.members(terms, step)
        self._terms.append((row, columns, factors))
        if self._rho >= 0:
            self._terms.append((row, [self._rho], -1.0 / scale))
        else:
            base += self._encoder.most / scale
        self._terms.append((row, list(beyond), -np.array(list(beyond.values()))))
        self._lower.append(base)


def _by_direction(witnesses: Witnesses) -> dict[Direction, dict[int, dict[int, float]]]:
    """For every direction and step the amount that each column asks for; -1 is in any case."""
    found: dict[Direction, dict[int, dict[int, float]]] = defaultdict(lambda: defaultdict(dict))
    for half, step, column in _single(witnesses):
        asked = found[half.terms, half.scale][step]
        asked[column] = max(asked.get(column, -np.inf), half.amount)
    return found


def _single(witnesses: Witnesses) -> Iterator[tuple[HalfSpace, int, int]]:
    for need in witnesses.stepwise:
        for column in need.selection or (-1,):
            yield need.bound, need.step, column
