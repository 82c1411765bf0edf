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
from dataclasses import replace
from itertools import combinations
from typing import TypeAlias

import numpy as np
from scipy import sparse

from tsplan.encode.count_atoms import Site
from tsplan.encode.encoded import Encoded
from tsplan.encode.flow_network import Network
from tsplan.encode.witness import Demand
from tsplan.milp.lp import WarmLP
from tsplan.milp.model import Bools, Draft, Floats, Ints, Model, Tag
from tsplan.search.clock import Clock

Kind: TypeAlias = tuple[Site, str | None, int]

_MOST_ITEMS = 1500  # demands that are compared pairwise
_MOST_PLACES = 12  # places of one step of which covers are looked for
_LARGEST_COVER = 4
_ROUNDS = 12
_ENOUGH = 1e-3  # by which a row has to be violated
_GAIN = 1e-4  # relative rise of the bound that another round has to bring


def team_rows(demands: Sequence[Demand], network: Network, draft: Draft) -> None:
    """Team rows and covers of the demands of each step and capability."""
    grouped: dict[tuple[str | None, int], dict[Site, Demand]] = defaultdict(dict)
    for demand in demands:
        if demand.literal and not demand.bound.upper:
            places = grouped[demand.bound.capability, demand.step]
            former = places.get(demand.bound.states)
            if former is None or former.bound.amount < demand.bound.amount:
                places[demand.bound.states] = demand
    for (capability, _), places in grouped.items():
        members = _apart(list(places.values()))
        team = network.agents(capability)
        if sum(demand.bound.amount for demand in members) > team:
            _row(members, [demand.bound.amount for demand in members], team, draft)
            for cover, most in _covers(members, team):
                _row(cover, [1] * len(cover), most, draft)


def _apart(demands: Sequence[Demand]) -> list[Demand]:
    """Demands at places without common states, the neediest first."""
    found: list[Demand] = []
    for demand in sorted(demands, key=lambda d: -d.bound.amount):
        if all(set(demand.bound.states).isdisjoint(other.bound.states) for other in found):
            found.append(demand)
    return found


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
    columns = [column for demand in demands for column in demand.literal]
    values = [
        float(amount)
        for demand, amount in zip(demands, amounts, strict=True)
        for _ in demand.literal
    ]
    draft.rows(
        np.zeros(len(columns)), columns, values, lower=-np.inf, upper=float(most), kind="team"
    )


class Rivals:
    """Which demands exclude each other pairwise; `rows[i]` is the literal of demand i."""

    def __init__(self, demands: Sequence[Demand], network: Network, columns: int) -> None:
        items = [d for d in demands if d.literal and not d.bound.upper and d.bound.amount > 0]
        items = items if len(items) <= _MOST_ITEMS else []
        kinds = [(d.bound.states, d.bound.capability, d.bound.amount) for d in items]
        number = {kind: place for place, kind in enumerate(dict.fromkeys(kinds))}
        self._kind = np.array([number[kind] for kind in kinds], dtype=np.int64)
        self._step = np.array([demand.step for demand in items], dtype=np.int64)
        self._exclusive = self._matrix(_waits(list(number), network))
        entries = [(place, column) for place, d in enumerate(items) for column in d.literal]
        index, members = np.array(entries, dtype=np.int64).reshape(-1, 2).T
        shape = (len(items), columns)
        self.rows = sparse.csr_array((np.ones(len(entries)), (index, members)), shape=shape)

    def _matrix(self, waits: Ints) -> Bools:
        if not len(self._kind):
            return np.zeros((0, 0), dtype=np.bool_)
        later = self._step[None, :] - self._step[:, None]
        needed = waits[np.ix_(self._kind, self._kind)]
        return np.where(later >= 0, later < needed, -later < needed.T)

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
        index = np.concatenate([np.full(len(clique), row) for row, clique in enumerate(found)])
        members = np.concatenate([np.array(clique) for clique in found])
        shape = (len(found), len(worth))
        pick = sparse.csr_array((np.ones(len(index)), (index, members)), shape=shape)
        return sparse.csr_array(pick @ self.rows)

    def _clique(self, seed: int, order: Ints) -> list[int]:
        """A maximal clique around a demand, those of the greatest value first."""
        clique = [seed]
        open_ = self._exclusive[seed].copy()
        candidates = order[open_[order]]
        while len(candidates):
            best = int(candidates[0])
            clique.append(best)
            candidates = candidates[self._exclusive[best][candidates]]
        return clique


def _waits(kinds: Sequence[Kind], network: Network) -> Ints:
    """For two kinds of demands: how many steps must lie between the first and the second."""
    never = network.horizon + 1
    waits = np.zeros((len(kinds), len(kinds)), dtype=np.int64)
    places = sorted({state for states, _, _ in kinds for state in states})
    place = {state: number for number, state in enumerate(places)}
    ways = [
        (item.graph, item.graph.lengths.distances(places)[:, places]) for item in network.classes
    ]
    for first, (here, able, amount) in enumerate(kinds):
        for second, (there, skilled, number) in enumerate(kinds):
            if not set(here).isdisjoint(there):
                continue
            lacking = amount + number
            both: list[tuple[float, int]] = []
            for graph, distance in ways:
                has = [name is None or name in graph.capabilities for name in (able, skilled)]
                lacking -= graph.agents if any(has) else 0
                if all(has):
                    rows, columns = [place[s] for s in here], [place[s] for s in there]
                    both.append((float(distance[np.ix_(rows, columns)].min()), graph.agents))
            for away, agents in sorted(both):
                if lacking <= 0:
                    break
                lacking -= agents
                waits[first, second] = int(min(away, never))
            if lacking > 0:
                waits[first, second] = never
    return waits


def without_rivalry(encoded: Encoded, objective: Floats, rivals: Rivals, clock: Clock) -> Encoded:
    """The model with the cliques that its LP violates, round after round while that pays."""
    if encoded.refuted or not rivals.rows.shape[0]:
        return encoded
    model = encoded.model
    lp = WarmLP(model.with_objective(objective), clock.stop)
    former = -np.inf
    for _ in range(_ROUNDS):
        result = lp.solve(time_limit=clock.left)
        if result.status != "optimal" or result.values is None or clock.over:
            break
        if result.objective < former + _GAIN * max(abs(former), 1.0):
            break
        cliques = rivals.violated(result.values)
        if cliques is None:
            break
        former = result.objective
        count = cliques.shape[0]
        lp.add_rows(cliques, np.full(count, -np.inf), np.ones(count))
        model = _with(model, cliques)
    return replace(encoded, model=model)


def _with(model: Model, rows: sparse.csr_array) -> Model:
    count, more = model.matrix.shape[0], rows.shape[0]
    return replace(
        model,
        matrix=sparse.csr_array(sparse.vstack([model.matrix, rows], format="csr")),
        row_lower=np.append(model.row_lower, np.full(more, -np.inf)),
        row_upper=np.append(model.row_upper, np.ones(more)),
        tags=(*model.tags, Tag("rivals", count, count + more)),
    )
