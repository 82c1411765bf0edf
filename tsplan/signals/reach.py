"""Where signals can be at each step: intervals that are carried forward from the start.

What was measured already is known to the point, and the way on begins there. The intervals of all
signals together are a box, so what they say of a sum of signals is interval
arithmetic. Bounds on columns follow from them, constants of rows, and which parts of a formula can
hold at all.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tsplan.milp.model import Floats
from tsplan.signals.equalities import TOLERANCE
from tsplan.signals.linear_system import System, Terms

_ROUNDED = TOLERANCE / 2
"""Of a range: by how much values may be led over a bound, half of what checks forgive."""


@dataclass(frozen=True, eq=False)
class Past:
    """What was measured: signals (n, k+1) at the steps 0..k, controls (m, k) applied before k."""

    signals: Floats
    controls: Floats

    @property
    def step(self) -> int:
        """The step of the last measurement."""
        return int(self.signals.shape[1]) - 1


@dataclass(frozen=True, eq=False)
class Reach:
    """The least and greatest value of every signal and control at the steps 0..T.

    Arrays (names, T+1), in the order of `System.names`; controls are held after the last step.
    `past` has what of it was measured.
    """

    system: System
    low: Floats
    high: Floats
    past: Past | None = None

    @property
    def now(self) -> int:
        """The first step from which on the system is still to be led."""
        return 0 if self.past is None else self.past.step

    @property
    def ahead(self) -> int:
        """The first step at which the signals are not known."""
        return 0 if self.past is None else self.past.step + 1

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


def reach(system: System, horizon: int, past: Past | None = None, beyond: float = 0.0) -> Reach:
    """The intervals of a system over the steps 0..horizon, from what was measured of them on.

    Signals may be `beyond` their bounds by so much. What was led to a bound is measured there but
    for what solvers and floats round, so after a past they may be led over one by as much.

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
    if past is not None:
        low[:count] -= beyond
        high[:count] += beyond
        for side in (low, high):
            side[:count, : past.step + 1] = past.signals
            side[count:, : past.step] = past.controls
    if system.dynamics is not None:
        a, b, d = system.dynamics.arrays
        whole = np.hstack([a, b])
        for step in range(0 if past is None else past.step, horizon):
            below, above = _through(whole, low[:, step], high[:, step])
            least, most = low[:count, step + 1], high[:count, step + 1]
            width = most - least
            np.maximum(least, below + d, out=least)
            np.minimum(most, above + d, out=most)
            if past is not None:
                _forced(least, most, width)
    return Reach(system, low, high, past)


def _forced(low: Floats, high: Floats, width: Floats) -> None:
    """Let values be where they are led, where that is off a bound by what solvers forgive."""
    close = (low > high) & (low - high <= _ROUNDED * np.where(np.isfinite(width), width, 1.0))
    low[close], high[close] = high[close], low[close]


def _through(matrix: Floats, low: Floats, high: Floats) -> tuple[Floats, Floats]:
    """The sides of the box around the image of a box; infinite sides times 0 are 0."""
    with np.errstate(invalid="ignore"):
        ends = np.array([matrix * low, matrix * high])
    ends[:, matrix == 0] = 0.0
    return ends.min(axis=0).sum(axis=1), ends.max(axis=0).sum(axis=1)
