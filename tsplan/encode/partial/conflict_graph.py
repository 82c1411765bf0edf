"""Demands that the same agents cannot meet, and rows that say so.

Where not everything can hold, the LP serves rival demands a little each: half of the agents here,
half of them there, each side half satisfied. Three families of rows forbid that.

* *Team rows*: at one step all places together need no more agents with a capability than there are.
* *Covers* of these: of places that need too many agents together, not all are served.
* *Cliques* of pairs: two demands exclude each other when m + m' agents are more than those that
  can serve one of them, counted twice where they can serve both, the later one after the way from
  the earlier (Hall's condition). Of demands that exclude each other pairwise at most one is met.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence
from itertools import combinations

import numpy as np
from scipy import sparse

from tsplan.encode.encoder_rules import Demand
from tsplan.encode.flow_network import Network
from tsplan.encode.joint_demands import apart
from tsplan.encode.rivals.travel_gaps import gaps_between
from tsplan.milp.model import Bools, Draft, Floats, Ints, joined_terms

_MOST_ITEMS = 1500  # demands that are compared pairwise
_MOST_PLACES = 12  # places of one step of which covers are looked for
_LARGEST_COVER = 4
_ENOUGH = 1e-3  # by which a row has to be violated


def team_rows(demands: Sequence[Demand], network: Network, draft: Draft) -> None:
    """Team rows and covers of the demands of each step and capability."""
    grouped: dict[tuple[str | None, int], list[Demand]] = defaultdict(list)
    for demand in demands:
        if demand.selection and not demand.bound.upper:
            grouped[demand.bound.capability, demand.step].append(demand)
    for (capability, _), mine in grouped.items():
        members = list(apart(mine).values())
        team = network.agents(capability)
        if sum(demand.bound.amount for demand in members) > team:
            _row(members, [demand.bound.amount for demand in members], team, draft)
            for cover, most in _covers(members, team):
                _row(cover, [1] * len(cover), most, draft)


def _covers(demands: Sequence[Demand], team: int) -> list[tuple[list[Demand], int]]:
    """Minimal sets that need more than the team, with what is as needy as any of them."""
    found = []
    for size in range(2, _LARGEST_COVER + 1):
        for cover in combinations(demands[:_MOST_PLACES], size):
            amounts = [demand.bound.amount for demand in cover]
            if sum(amounts) > team >= sum(amounts) - min(amounts):
                needy = [d for d in demands if d not in cover and d.bound.amount >= amounts[0]]
                found.append(([*cover, *needy], size - 1))
    return found


def _row(demands: Sequence[Demand], amounts: Sequence[int], most: int, draft: Draft) -> None:
    terms = ((0, d.selection, amount) for d, amount in zip(demands, amounts, strict=True))
    draft.sums(*terms, lower=-np.inf, upper=float(most), kind="team")


class ConflictGraph:
    """Which demands exclude each other pairwise; `rows[i]` is the selection of demand i."""

    def __init__(self, demands: Sequence[Demand], network: Network, columns: int) -> None:
        items = [d for d in demands if d.selection and not d.bound.upper and d.bound.amount > 0]
        items = items if len(items) <= _MOST_ITEMS else []
        number = {bound: place for place, bound in enumerate(dict.fromkeys(d.bound for d in items))}
        kind = np.array([number[demand.bound] for demand in items], dtype=np.int64)
        step = np.array([demand.step for demand in items], dtype=np.int64)
        needed = gaps_between(list(number), network)[np.ix_(kind, kind)]
        later = step[None, :] - step[:, None]
        self._exclusive: Bools = np.where(later >= 0, later < needed, -later < needed.T)
        entries = [(place, column) for place, d in enumerate(items) for column in d.selection]
        index, members = np.array(entries, dtype=np.int64).reshape(-1, 2).T
        shape = (len(items), columns)
        self.rows = sparse.csr_array((np.ones(len(entries)), (index, members)), shape=shape)

    def violated(self, values: Floats) -> sparse.csr_array | None:
        """Cliques `sum <= 1` that a point violates; None if there are none."""
        worth: Floats = np.asarray(self.rows @ values, dtype=np.float64)
        order = np.argsort(-worth, kind="stable")
        found: dict[tuple[int, ...], None] = {}
        for seed in order[worth[order] > _ENOUGH].tolist():
            clique = self._clique(seed, order)
            if worth[clique].sum() > 1 + _ENOUGH:
                found[tuple(sorted(clique))] = None
        if not found:
            return None
        index, members, ones = joined_terms([(row, c, 1.0) for row, c in enumerate(found)])
        shape = (len(found), len(worth))
        pick = sparse.csr_array((ones, (index, members)), shape=shape)
        return sparse.csr_array(pick @ self.rows)

    def _clique(self, seed: int, order: Ints) -> list[int]:
        """A maximal clique around a demand, those of the greatest value first."""
        clique = [seed]
        candidates = order[self._exclusive[seed][order]]
        while len(candidates):
            best = int(candidates[0])
            clique.append(best)
            candidates = candidates[self._exclusive[best][candidates]]
        return clique
