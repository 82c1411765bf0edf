"""Where signals can be at each step: intervals that are carried forward from the start.

The intervals of all signals together are a box, so what they say of a sum of signals is interval
arithmetic. Bounds on columns follow from them, constants of rows, and which parts of a formula can
hold at all.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tsplan.milp.model import Floats
from tsplan.signals.linear_system import System, Terms


@dataclass(frozen=True, eq=False)
class Reach:
    """The least and greatest value of every signal and control at the steps 0..T.

    Arrays (names, T+1), in the order of `System.names`; controls are held after the last step.
    """

    system: System
    low: Floats
    high: Floats

    @property
    def horizon(self) -> int:
        """The last step."""
        return int(self.low.shape[1]) - 1

    @property
    def empty(self) -> bool:
        """Whether some signal has no value left at some step."""
        return bool((self.low > self.high).any())

    def sides(self, terms: Terms) -> tuple[Floats, Floats]:
        """The least and greatest value of a sum at each step: two arrays (T+1,)."""
        place = {name: row for row, name in enumerate(self.system.names)}
        rows = np.array([place[name] for name, _ in terms], dtype=np.int64)
        factors = np.array([factor for _, factor in terms]).reshape(-1, 1)
        ends = factors * self.low[rows], factors * self.high[rows]
        return np.minimum(*ends).sum(axis=0), np.maximum(*ends).sum(axis=0)


def reach(system: System, horizon: int) -> Reach:
    """The intervals of a system over the steps 0..horizon.

    >>> from tsplan.signals.linear_system import Dynamics
    >>> whole = Dynamics(((1,),), ((1,),), (0,))
    >>> reach(System({"p": (0, 9)}, {"u": (-1, 1)}, whole, {"p": (2, 2)}), 3).high[0].tolist()
    [2.0, 3.0, 4.0, 5.0]
    """
    bounds = np.array([*system.signals.values(), *system.controls.values()], dtype=np.float64)
    low, high = (np.repeat(side.reshape(-1, 1), horizon + 1, axis=1) for side in bounds.T)
    count = len(system.signals)
    start = np.array([system.begins(name) for name in system.signals], dtype=np.float64)
    low[:count, 0], high[:count, 0] = start.T
    if system.dynamics is not None:
        a, b, d = system.dynamics.arrays
        whole = np.hstack([a, b])
        for step in range(horizon):
            below, above = _through(whole, low[:, step], high[:, step])
            low[:count, step + 1] = np.maximum(low[:count, step + 1], below + d)
            high[:count, step + 1] = np.minimum(high[:count, step + 1], above + d)
    return Reach(system, low, high)


def _through(matrix: Floats, low: Floats, high: Floats) -> tuple[Floats, Floats]:
    """The sides of the box around the image of a box; infinite sides times 0 are 0."""
    with np.errstate(invalid="ignore"):
        ends = np.array([matrix * low, matrix * high])
    ends[:, matrix == 0] = 0.0
    return ends.min(axis=0).sum(axis=1), ends.max(axis=0).sum(axis=1)
