"""Whole agents from fractional flows, once the witnesses are fixed.

Each class is then a network flow of its own, and what is left fractional is how several classes
share a task: half an agent of each. Raising one such share to the next whole number settles the
others along the same paths, so a few warm LPs are enough where an integer program of all flows
may take minutes. Where robots carry things what is left fractional is the room that loads take, in
many moves at once; several of them are raised together then. It is a heuristic: the point it finds
need not be the best one, and it may find none.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from tsplan.clock import Clock
from tsplan.encode.encoded import Encoded
from tsplan.milp.confirmation import tried
from tsplan.milp.lp import WarmLP
from tsplan.milp.model import Floats, Ints, Model
from tsplan.milp.target import Target
from tsplan.search.dive import fractional
from tsplan.search.effort import Effort

_LEAST_TRIES = 20
_SECONDS = 5.0  # for one attempt
_SHARE = 0.25  # of the moves of carriers that are fractions are raised at once: there are many


@dataclass(frozen=True, eq=False)
class Rounding:
    """Makes points of whole agents from points with parts of them, for one search."""

    encoded: Encoded
    target: Target
    effort: Effort
    clock: Clock

    def near(self, lp: WarmLP, model: Model, values: Floats) -> Floats | None:
        """A point with the same witnesses and whole agents, or None.

        `lp` is the relaxation of the model; its bounds are restored before returning.
        """
        encoded, indicators = self.encoded, self.encoded.indicators
        if not len(fractional(values, encoded.repaired)):
            return values
        fixed = np.round(values[indicators])
        lp.bounds(indicators, fixed, fixed)
        carrying = encoded.carrying
        share = _SHARE if carrying else 0.0
        raising = _Raising(lp, model, self.clock.within(_SECONDS), share)
        try:
            # who goes where settles what is carried
            found = raising.whole(encoded.moves) if carrying else values
            return None if found is None else raising.whole(encoded.repaired)
        finally:
            raised = np.array(list(raising.bounds), dtype=np.int64)
            columns = np.concatenate([indicators, raised])
            lp.bounds(columns, model.lower[columns], model.upper[columns])

    def best(self, model: Model, values: Floats, start: Floats | None) -> Floats | None:
        """The best point with the witnesses of `values`, if the solver finds it soon."""
        indicators = self.encoded.indicators
        return self._tried(model.with_fixed(indicators, values[indicators]), start)

    def carrying(self, model: Model, flows: Floats, start: Floats | None) -> Floats | None:
        """The best point with the given flows, if there is one."""
        return self._tried(model.with_fixed(self.encoded.flows, flows), start)

    def _tried(self, model: Model, start: Floats | None) -> Floats | None:
        options = self.effort.options(self.clock.within(_SECONDS), self.target, start)
        return tried(self.effort.solver, model, options)


class _Raising:
    """Raises fractions of one program to whole numbers; `bounds` are what columns are held between.

    A `share` of those that are left is raised at once, at least one of them.
    """

    def __init__(self, lp: WarmLP, model: Model, clock: Clock, share: float) -> None:
        self.bounds: dict[int, tuple[float, float]] = {}
        self._lp = lp
        self._model = model
        self._clock = clock
        self._share = share

    def whole(self, columns: Ints) -> Floats | None:
        """Raise those nearest below a whole number; lower one where that is impossible."""
        values, most = np.empty(0), len(columns)
        before: dict[int, tuple[float, float]] = {}  # the bounds of those raised last
        for _ in range(max(_LEAST_TRIES, len(columns) // 1000)):
            result = self._lp.solve(time_limit=self._clock.left)
            if result.status == "optimal":
                assert result.values is not None
                values = result.values
                open_ = fractional(values, columns)
                if not len(open_):
                    return values
                most = max(min(int(self._share * len(open_)), most), 1)
                order = np.argsort(-(values[open_] % 1.0), kind="stable")
                before = self._raise(open_[order[:most]].tolist(), values)
            elif result.status == "infeasible" and len(before) > 1:
                self._hold(before)
                most = len(before) // 2  # what lacks least is told first
                before = self._raise(list(before)[:most], values)
            elif result.status == "infeasible" and before:
                ((column, (low, _)),) = before.items()
                self._hold({column: (low, float(np.floor(values[column])))})
                before = {}
            else:
                break
        return None

    def _raise(self, columns: list[int], values: Floats) -> dict[int, tuple[float, float]]:
        """Raise columns; the bounds they had."""
        low, high = self._model.lower, self._model.upper
        before = {
            column: self.bounds.get(column, (low[column], high[column])) for column in columns
        }
        self._hold({c: (float(np.ceil(values[c])), most) for c, (_, most) in before.items()})
        return before

    def _hold(self, bounds: Mapping[int, tuple[float, float]]) -> None:
        self.bounds.update(bounds)
        pairs = np.array(list(bounds.values()))
        self._lp.bounds(list(bounds), pairs[:, 0], pairs[:, 1])
