"""Arrival cuts that a fractional solution violates, found for all windows of a family at once.

For a family whose columns each ask over consecutive steps, the cut of window [lo, hi] reads
`n(lo) + C(hi) - C(lo) >= S(hi) - E(lo)`: C cumulative arrivals, S(hi) what the columns that begin
by hi ask for, E(lo) what those that end before lo asked for. So all windows are one outer
difference.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy import sparse

from tsplan.encode.demand_rows import LONG, SiteColumns
from tsplan.encode.demand_runs import Family
from tsplan.encode.running_sums import Sums
from tsplan.milp.model import Floats, Ints, joined_terms

_MOST = 30  # cuts of a long family at once: each has an entry for every witness in its window
_ENOUGH = 1e-4  # violations below this are left to the solver's tolerance


def violated(
    families: Sequence[tuple[SiteColumns, Family]], values: Floats, columns: int
) -> sparse.csr_array | None:
    """Rows `>= 0` over `columns` columns that `values` violates; None if there are none."""
    found: list[Sums] = []
    count = 0
    for site, family in families:
        low, high = _worst_windows(site, family, values)
        if len(low):
            row, members, factors = cut_terms(site, family, low, high)
            found.append((row + count, members, factors))
            count += len(low)
    if not count:
        return None
    rows, members, factors = joined_terms(found)
    shape = (count, columns)
    return sparse.csr_array(sparse.coo_array((factors, (rows, members)), shape=shape))


def cut_terms(site: SiteColumns, family: Family, low: Ints, high: Ints) -> Sums:
    """The cuts of windows given by positions in the family's steps."""
    come = site.come(family.steps[low], family.steps[high])
    if family.begun.chained or family.ending.chained:
        first = np.zeros_like(low)
        row, members, begun = family.begun.known(first, high)
        return joined_terms([*come, (row, members, -begun), family.ending.known(first, low - 1)])
    within = [family.asked_within(*pair) for pair in zip(low, high, strict=True)]
    asked = [(row, members, -amount) for row, (members, amount) in enumerate(within)]
    return joined_terms([*come, *asked])


def _worst_windows(site: SiteColumns, family: Family, values: Floats) -> tuple[Ints, Ints]:
    """For each beginning the window that is violated most, as positions in the family's steps."""
    none = np.empty(0, dtype=np.int64)
    steps = len(family.steps)
    if len(family.columns) < 2 or not len(site.arrived) or not family.consecutive:  # noqa: PLR2004
        return none, none
    column, first, last, amount = family.pieces
    weight = amount * values[column]
    begun = np.cumsum(np.bincount(first, weight, steps))
    ended = np.cumsum(np.bincount(last + 1, weight, steps + 1))[:steps]
    place = family.steps - site.first
    come = values[site.arrived[place]]
    here = values[site.inside[place]]
    gain, need = begun - come, ended + here - come
    # the best end after each beginning: the first of the greatest gains from there on
    greatest = np.maximum.accumulate(gain[::-1])[::-1]
    best = np.minimum.accumulate(
        np.where(gain[:-1] >= greatest[:-1], np.arange(steps - 1), steps - 1)[::-1]
    )[::-1]
    high = np.append(best[1:], steps - 1) if steps > 1 else none
    low = np.arange(len(high))
    lack = gain[high] - need[low]
    some = np.flatnonzero(lack > _ENOUGH)
    if steps > LONG:
        some = np.sort(some[np.argsort(-lack[some], kind="stable")[:_MOST]])
    return low[some], high[some]
