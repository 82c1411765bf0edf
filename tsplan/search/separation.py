"""Cuts that the linear program of a model violates, added round by round while that pays.

Arrival cuts (`encode.arrival_cuts`) and cuts of visitors (`encode.visitor_cuts`).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from scipy import sparse

from tsplan.clock import Clock
from tsplan.encode.arrival_cuts import violated
from tsplan.encode.encoded import Encoded
from tsplan.encode.switches import Switch
from tsplan.encode.visitor_cuts import VisitorCuts
from tsplan.milp.lp import LPResult, WarmLP
from tsplan.milp.model import INFINITY, Floats, Model
from tsplan.search.dive import fractional

_ROUNDS = 100
_GAIN = 1e-4  # relative rise of the bound that counts as one
_SHARE = 0.4  # of the time that is left: plans are looked for afterwards
_IDLE = 15  # rounds without one: cuts of visitors often need several for a rise


@dataclass(eq=False)
class Separation:
    """Adds cuts to the linear program of an encoded problem, and to its `model`.

    `hear` is told every bound on the way. It is `open` as long as more cuts may help.
    """

    encoded: Encoded
    model: Model
    switches: frozenset[Switch]
    clock: Clock
    hear: Callable[[float], None]
    open: bool = field(default=True, init=False)

    def tightened(self, lp: WarmLP, root: LPResult, seconds: float = np.inf) -> LPResult:
        """The program's solution with cuts; the last one that was found where time is up.

        A part of the time that is left is spent at most, and no more than so many seconds.
        """
        idle = 0
        left = self.clock.left
        most = seconds if left is None else min(_SHARE * left, seconds)
        clock = self.clock.within(most)
        visitors = self._visitors
        for _ in range(_ROUNDS):
            if clock.over:
                return root
            if not self._add(lp, root, visitors):
                break
            after = lp.solve(time_limit=self.clock.left)
            if after.status == "limit":
                break
            if after.status != "optimal":
                return after
            gain = after.objective - root.objective
            root = after
            self.hear(root.objective)
            idle = 0 if gain >= _GAIN * max(abs(root.objective), 1.0) else idle + 1
            if idle >= (_IDLE if visitors.demands else 1):
                break
        self.open = False
        return root

    @cached_property
    def _visitors(self) -> VisitorCuts:
        """Made once: what it unrolls serves all rounds, also those after a break."""
        return VisitorCuts(self.encoded.network, self.encoded.visits)

    def _add(self, lp: WarmLP, root: LPResult, visitors: VisitorCuts) -> bool:
        """Add what a solution violates; whether there is anything."""
        values, columns = root.values, self.model.size.columns
        assert values is not None
        found: list[tuple[sparse.csr_array, Floats, str]] = []
        if not visitors.windows and not len(fractional(values, self.encoded.indicators)):
            return False  # where witnesses are whole so many agents are there at one step
        if Switch.LAZY in self.switches:
            rows = violated(self.encoded.families, values, columns)
            found += [] if rows is None else [(rows, np.zeros(rows.shape[0]), "arrival")]
        if Switch.VISITORS in self.switches:
            cuts = visitors.violated(values, columns)
            found += [] if cuts is None else [(*cuts, "visitors")]
        for rows, lower, kind in found:
            lp.add_rows(rows, lower, np.full(len(lower), np.inf))
            self.model = self.model.with_rows(rows, lower, INFINITY, kind)
        return bool(found)
