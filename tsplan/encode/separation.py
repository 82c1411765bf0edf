"""Visit cuts that a fractional solution violates, found for all windows of a family at once.

For a family whose columns each ask over consecutive steps, the cut of window [lo, hi] reads
`n(lo) + C(hi) - C(lo) >= S(hi) - E(lo)`: C cumulative arrivals, S(hi) what the columns that begin
by hi ask for, E(lo) what those that end before lo asked for. So all windows are one outer
difference.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy import sparse

from tsplan.encode.staffing import Family, SiteColumns
from tsplan.milp.model import Floats, Ints

_ENOUGH = 1e-4  # violations below this are left to the solver's tolerance


def violated(
    families: Sequence[tuple[SiteColumns, Family]], values: Floats, columns: int
) -> sparse.csr_array | None:
    """Rows `>= 0` over `columns` columns that `values` violates; None if there are none."""
    rows: list[Ints] = []
    members: list[Ints] = []
    coefficients: list[Floats] = []
    count = 0
    for site, family in families:
        for low, high in _worst_windows(site, family, values):
            need = family.amount[low : high + 1].max(axis=0)
            asked = np.flatnonzero(need)
            begin, end = family.steps[low] - site.first, family.steps[high] - site.first
            three = [site.inside[begin], site.arrived[end], site.arrived[begin]]
            members.append(np.concatenate([three, family.columns[asked]]))
            coefficients.append(np.concatenate([[1.0, 1.0, -1.0], -need[asked]]))
            rows.append(np.full(3 + len(asked), count))
            count += 1
    if not count:
        return None
    entries = (np.concatenate(coefficients), (np.concatenate(rows), np.concatenate(members)))
    return sparse.csr_array(sparse.coo_array(entries, shape=(count, columns)))


def _worst_windows(site: SiteColumns, family: Family, values: Floats) -> list[tuple[int, int]]:
    """For each beginning the window that is violated most, as positions in the family's steps."""
    if len(family.columns) < 2 or not len(site.arrived):  # noqa: PLR2004 - a window needs two
        return []
    asked = family.amount > 0
    first = asked.argmax(axis=0)
    last = len(family.steps) - 1 - asked[::-1].argmax(axis=0)
    if not (asked.sum(axis=0) == last - first + 1).all():
        return []
    weight = family.amount.max(axis=0) * values[family.columns]
    steps = np.arange(len(family.steps))
    begun = np.where(first[None, :] <= steps[:, None], weight, 0.0).sum(axis=1)
    ended = np.where(last[None, :] < steps[:, None], weight, 0.0).sum(axis=1)
    place = family.steps - site.first
    come = values[site.arrived[place]]
    here = values[site.inside[place]]
    lack = (begun - come)[None, :] - (ended + here - come)[:, None]
    lack[np.tril_indices(len(steps))] = -np.inf
    worst = lack.argmax(axis=1)
    return [
        (low, int(high))
        for low, high in enumerate(worst)
        if high > low and lack[low, high] > _ENOUGH
    ]
