"""The LP-guided dive: whole witnesses from a fractional solution, by fixing one at a time.

Solve the LP, fix a fractional indicator to 1, solve again from the last basis, and so on; where the
LP becomes infeasible or too dear, the last decision is turned to 0 (depth first).

Where the LP is tight, a handful of LPs is enough with the indicator of the largest value. Where it
is not, as under an always, decisions in the order of time do better: what a wrong one makes
impossible shows soon after it, while it is still among the last.

Where one LP takes seconds, a *plunge* settles a part of the choices with every one of them: those
with the largest values first, since later ones see what these came to.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np

from tsplan.clock import Clock
from tsplan.milp.lp import LPResult, WarmLP
from tsplan.milp.model import Floats, Ints

TOLERANCE = 1e-6

_PART = 0.3  # of the open choices that a plunge settles at once
_CLEAR = 0.5  # a value from which on it says what is chosen

Picker: TypeAlias = Callable[[Floats, Ints], int]
"""Chooses the column to fix, from an LP's values and the columns that are fractional."""


@dataclass(frozen=True, eq=False)
class Dived:
    """A point with whole indicators, or None; `refuted` if the dive proved there is none."""

    values: Floats | None
    refuted: bool = False


def fractional(values: Floats, columns: Ints) -> Ints:
    """Those of `columns` that are not whole numbers in `values`."""
    part = values[columns]
    return columns[np.abs(part - np.round(part)) > TOLERANCE]


def largest(values: Floats, open_: Ints) -> int:
    """The fractional column of the largest value."""
    return int(open_[np.argmax(values[open_])])


@dataclass(frozen=True, eq=False)
class Earliest:
    """Of the choice whose fractional columns begin first, the one of the largest value."""

    indicators: Ints
    steps: Ints
    groups: Sequence[Ints]

    def __call__(self, values: Floats, open_: Ints) -> int:
        """The column to fix next."""
        steps = self.steps[np.searchsorted(self.indicators, open_)]
        first = open_[np.argmin(steps)]
        group = next((group for group in self.groups if first in group), open_)
        return largest(values, np.intersect1d(group, open_))


def dive(
    lp: WarmLP,
    indicators: Ints,
    result: LPResult,
    clock: Clock,
    *,
    cutoff: float | None = None,
    pick: Picker = largest,
    turns: int | None = None,
) -> Dived:
    """Fix indicators until all are whole; the LP's bounds are restored before returning.

    `result` is the LP's solution now; points that do not beat `cutoff` are not looked for. `pick`
    chooses among the fractional columns. A dive that goes wrong more than `turns` times is better
    left to a full search.
    """
    decisions: list[tuple[int, float]] = []
    certain = True
    try:
        while not clock.over:
            if result.status == "optimal" and (cutoff is None or result.objective < cutoff):
                assert result.values is not None
                open_ = fractional(result.values, indicators)
                if not len(open_):
                    return Dived(result.values)
                column = pick(result.values, open_)
                lp.bounds([column], 1.0, 1.0)
                decisions.append((column, 1.0))
            elif result.status == "limit":
                break
            else:
                certain = certain and result.status != "unproven"
                if not _turn(lp, decisions):
                    return Dived(None, refuted=certain)
                turns = None if turns is None else turns - 1
                if turns is not None and turns < 0:
                    break
            result = lp.solve(time_limit=clock.left, cutoff=cutoff)
    finally:
        if decisions:
            lp.bounds([column for column, _ in decisions], 0.0, 1.0)
    return Dived(None)


def plunge(
    lp: WarmLP,
    choices: Sequence[Ints],
    result: LPResult,
    clock: Clock,
    *,
    cutoff: float | None = None,
) -> LPResult | None:
    """The LP's end where all choices are settled, a part of them at a time; None for a dead end.

    `result` is the LP's solution now, and its bounds are restored before returning. Each choice is
    settled for its largest value or, where that says little, for where half of its weight lies.
    """
    settled: list[int] = []
    try:
        while result.status == "optimal" and not clock.over:
            assert result.values is not None
            weights = [result.values[group] for group in choices]
            most = np.array([weight.max(initial=0.0) for weight in weights])
            most[settled] = -1.0
            open_ = np.flatnonzero((most > TOLERANCE) & (most < 1 - TOLERANCE))
            if not len(open_):
                return result
            order = open_[np.argsort(-most[open_], kind="stable")]
            chosen = order[: max(int(_PART * len(order)), 1)]
            for number in [*chosen.tolist(), *np.flatnonzero(most >= 1 - TOLERANCE).tolist()]:
                only = np.zeros(len(choices[number]))
                only[_middle(weights[number])] = 1.0
                lp.bounds(choices[number], only, only)
                settled.append(number)
            result = lp.solve(time_limit=clock.left, cutoff=cutoff)
        return None
    finally:
        for number in settled:
            lp.bounds(choices[number], 0.0, 1.0)


def _middle(weight: Floats) -> int:
    """The place of the largest weight, or of the middle of all where none is large."""
    largest = int(np.argmax(weight))
    if weight[largest] >= _CLEAR * weight.sum():
        return largest
    return int(np.searchsorted(np.cumsum(weight), weight.sum() / 2))


def _turn(lp: WarmLP, decisions: list[tuple[int, float]]) -> bool:
    """Undo decisions up to the last 1 and make it 0; False if there is none left."""
    while decisions:
        column, value = decisions.pop()
        lp.bounds([column], 0.0, 1.0 - value)
        if value:
            decisions.append((column, 0.0))
            return True
    return False
