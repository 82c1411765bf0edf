"""What a search knows: the best point, a bound on all points, and whether that answers it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import TypeAlias

import numpy as np

from tsplan.clock import Clock
from tsplan.errors import SolverError
from tsplan.exact import digits, relative_gap
from tsplan.milp.model import Floats, Model
from tsplan.milp.target import Target
from tsplan.search.lexicographic import Found
from tsplan.stopping import StoppedBy

_FORGIVEN = 1e-6  # by which a point may violate a row of numbers that are not whole

Reporter: TypeAlias = Callable[[Floats | None, float | None, float | None], None]
"""Hears of a point, the value of the best one, and a bound, as values of the target."""


@dataclass(eq=False)
class Standing:
    """The best point of one search, `bound` as far as it is proven, and `refuted` if there is none.

    `exact` is the part of the bound that rests on no solver's word; so does a refutation if it is
    `sure`.
    `gap` is the relative one that is enough; with `first` any point is. All news are reported.
    """

    target: Target
    report: Reporter
    gap: float | None = None
    refuted: bool = False
    first: bool = field(default=False, init=False)
    values: Floats | None = field(default=None, init=False)
    value: float = field(default=np.inf, init=False)
    bound: float = field(default=-np.inf, init=False)
    exact: float = field(default=-np.inf, init=False)
    sure: bool = field(default=True, init=False)

    @property
    def done(self) -> bool:
        """Whether the question is answered."""
        return self.refuted or self._closed or (self.first and self.values is not None)

    @property
    def cutoff(self) -> float | None:
        """Only points below this are of interest to linear programs."""
        return None if self.values is None else self.target.cutoff(self.value)

    def accept(self, values: Floats, model: Model) -> None:
        """Keep a point of whole agents if it is one of the model, and better than the one known."""
        values = np.where(model.integer, np.round(values), values)
        value = self.target.value(values)
        if not self.target.better(value, self.value):
            return
        if model.violation(values) > _FORGIVEN:
            return
        if self.target.refutes(value, self.bound):
            raise SolverError(
                f"a plan of value {digits(value)} is better than the bound {digits(self.bound)} "
                "that was proven: the solver's arithmetic fails on this mission"
            )
        self.values, self.value = values, value
        self.report(values, value, self.bound if np.isfinite(self.bound) else None)

    def raise_bound(self, bound: float, *, exact: bool = True) -> None:
        """Take in what a linear program or a solver says, as far as it can be believed.

        A bound that the known point refutes says nothing. One that is not `exact` is a solver's.
        """
        proven = self.target.proven(bound)
        if self.target.refutes(self.value, proven):
            return
        self.exact = max(self.exact, proven) if exact else self.exact
        if proven > self.bound:
            self._tell(min(proven, self.value))

    def know(self, bound: float, *, exact: bool = False) -> None:
        """Take over a bound that has been proven elsewhere, as a value of the target."""
        self.exact = max(self.exact, bound) if exact else self.exact
        if bound > self.bound:
            self._tell(bound)

    def refute(self, *, sure: bool = True) -> None:
        """There is no point; a solver that says so alone is not `sure`."""
        self.refuted, self.sure = True, sure

    def none_below(self, cutoff: float | None) -> None:
        """There is no point below the cutoff, or none at all without one."""
        if cutoff is None:
            self.refuted = True
        else:
            self.raise_bound(cutoff)

    def found(self, clock: Clock) -> Found:
        """What has come of it; the clock tells what ended a search that answers nothing."""
        why = None if self.first and self.values is not None else StoppedBy.PRECISION
        why = clock.stopped_by if clock.over else why
        if self.values is None:
            bound = np.inf if self.refuted else self.bound
            why = None if self.refuted else why
            sure = self.sure if self.refuted else self.exact >= self.bound
            return Found(None, None, bound, self.refuted, why, certified=sure)
        proven = self.target.closed(self.value, self.bound)
        bound = self.value if proven else self.bound
        stopped = StoppedBy.GAP if self._near else why
        certified = self.exact >= self.bound or self.target.closed(self.value, self.exact)
        why = None if proven else stopped
        return Found(self.values, self.value, bound, proven, why, certified=certified)

    def _tell(self, bound: float) -> None:
        self.bound = bound
        self.report(None, None if self.values is None else self.value, bound)

    @property
    def _closed(self) -> bool:
        """Whether nothing better by the wanted gap can exist."""
        if self.values is None:
            return False
        return self.target.closed(self.value, self.bound) or self._near

    @property
    def _near(self) -> bool:
        """Whether the gap that was asked for is reached."""
        if not self.gap or not np.isfinite(self.bound) or self.values is None:
            return False
        gap = relative_gap(self.target.own(self.value), self.target.own(self.bound))
        return gap is not None and gap <= self.gap
