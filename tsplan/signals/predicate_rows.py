"""Demands on predicates as rows of the model.

Where a selection w is 1, `a.y - rho/s >= b`. Options that exclude each other share one row for
their direction a and step (`tsplan.encode.shared_rows`).

Source of the single rows: V. Raman et al., "Model predictive control with signal temporal logic
specifications", CDC 2014; the constants are the least that the reachable intervals allow.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np

from tsplan.encode.encoder_rules import Witnesses
from tsplan.encode.shared_rows import amounts, shared_rows
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
        families = witnesses.choices.families if self._merged else _alone
        for (terms, scale), steps in amounts(witnesses, _directed).items():
            low = self._encoder.sides(terms)[0]
            wanted = self._encoder.most / scale  # the most that rho/s can be
            for step, asked in steps.items():
                for base, beyond in shared_rows(asked, float(low[step]) - wanted, families):
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


def _directed(half: HalfSpace) -> tuple[Direction, float]:
    return (half.terms, half.scale), half.amount


def _alone(columns: Sequence[int]) -> Iterable[Iterable[int]]:
    return ([column] for column in columns)
