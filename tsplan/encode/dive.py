"""The LP-guided dive: whole witnesses from a fractional solution, by fixing one at a time.

Solve the LP, fix the indicator with the largest fractional value to 1, solve again from the last
basis, and so on; where the LP becomes infeasible or too dear, the last decision is turned to 0
(depth first). Where the LP is tight, a handful of LPs is enough.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tsplan.encode.clock import Clock
from tsplan.milp.model import Floats, Ints
from tsplan.milp.warm import LPResult, WarmLP

TOLERANCE = 1e-6


@dataclass(frozen=True, eq=False)
class Dived:
    """A point with whole indicators, or None; `refuted` if the dive proved there is none."""

    values: Floats | None
    refuted: bool = False


def fractional(values: Floats, columns: Ints) -> Ints:
    """Those of `columns` that are not whole numbers in `values`."""
    part = values[columns]
    return columns[np.abs(part - np.round(part)) > TOLERANCE]


def dive(
    lp: WarmLP, indicators: Ints, result: LPResult, clock: Clock, cutoff: float | None
) -> Dived:
    """Fix indicators until all are whole; the LP's bounds are restored before returning.

    `result` is the LP's solution now; points that do not beat `cutoff` are not looked for.
    """
    decisions: list[tuple[int, float]] = []
    turns = 0
    try:
        while not clock.over:
            if result.status == "optimal" and (cutoff is None or result.objective < cutoff):
                assert result.values is not None
                open_ = fractional(result.values, indicators)
                if not len(open_):
                    return Dived(result.values)
                column = int(open_[np.argmax(result.values[open_])])
                _fix(lp, column, 1.0)
                decisions.append((column, 1.0))
            elif result.status == "limit":
                break
            else:
                turns += 1
                if not _turn(lp, decisions):
                    return Dived(None, refuted=True)
                if turns > _most_turns(len(indicators)):
                    break
            result = lp.solve(time_limit=clock.left, cutoff=cutoff)
    finally:
        for column, _ in decisions:
            lp.bounds(np.array([column]), np.array([0.0]), np.array([1.0]))
    return Dived(None)


def _fix(lp: WarmLP, column: int, value: float) -> None:
    lp.bounds(np.array([column]), np.array([value]), np.array([value]))


def _turn(lp: WarmLP, decisions: list[tuple[int, float]]) -> bool:
    """Undo decisions up to the last 1 and make it 0; False if there is none left."""
    while decisions:
        column, value = decisions.pop()
        lp.bounds(np.array([column]), np.array([0.0]), np.array([1.0]))
        if value > 0.5:  # noqa: PLR2004 - decisions are 0 or 1
            _fix(lp, column, 0.0)
            decisions.append((column, 0.0))
            return True
    return False


def _most_turns(indicators: int) -> int:
    """A dive that goes wrong this often is better left to the full search."""
    return 20 + indicators // 10
