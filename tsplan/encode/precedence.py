"""How long it takes from one witness to the next, where the same agents are needed for both.

A relay says that the second witness comes in a window after the first. If the first needs agents at
one place and the second at another, and together they need more than there are, somebody must go
from the one to the other: the second cannot come sooner than that takes. In whole points the flows
say so already; in the LP, where a little of every witness is served, they do not.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence

import numpy as np
from scipy import sparse
from scipy.sparse import csgraph

from tsplan.encode.asking import Lasting, Witnesses
from tsplan.encode.atoms import Bound
from tsplan.encode.literals import Relay
from tsplan.encode.network import ClassGraph, Network
from tsplan.milp.model import Ints


def space_out(witnesses: Witnesses, network: Network) -> None:
    """Tighten the windows of relays by the way between the places of their witnesses."""
    needs: dict[int, list[Lasting]] = defaultdict(list)
    for need in witnesses.lasting:
        if len(need.literal) == 1 and not need.bound.upper:
            needs[need.literal[0]].append(need)
    for relayed in witnesses.choices.relays:
        before = [needs.get(column, []) for column in relayed.waiting.columns.tolist()]
        after = [needs.get(column, []) for column in relayed.columns.tolist()]
        sooner = relayed.waiting.low
        for first in _common(before):
            for second in _common(after):
                way = _way(first, second, network)
                if way:
                    begins = _begins(before, after, relayed.waiting, way)
                    sooner = np.maximum(sooner, begins)
        if (sooner > relayed.waiting.low).any():
            # beginnings must not go back: a later parent's may be taken for an earlier one's
            witnesses.choices.not_before(relayed, np.minimum.accumulate(sooner[::-1])[::-1])


def _common(needs: Sequence[Sequence[Lasting]]) -> list[Bound]:
    """What every column of a choice needs, if each needs one thing only."""
    bounds = {need.bound for mine in needs for need in mine}
    return list(bounds) if len(bounds) == 1 and all(len(mine) == 1 for mine in needs) else []


def _begins(
    before: Sequence[Sequence[Lasting]], after: Sequence[Sequence[Lasting]], relay: Relay, way: int
) -> Ints:
    """The first time at which the second witness may come, for each of the first ones."""
    shifts = [need.first - time for (need,), time in zip(after, relay.times.tolist(), strict=True)]
    low = relay.low
    if any(low[place] + min(shifts) < need.first for place, (need,) in enumerate(before)):
        return low  # the second may be needed before the first
    return np.array([need.last + way - max(shifts) for (need,) in before], dtype=np.int64)


def _way(first: Bound, second: Bound, network: Network) -> int:
    """Steps between two demands that not enough agents are there to meet apart; else 0."""
    if not set(first.states).isdisjoint(second.states):
        return 0
    able = [*network.having(first.capability), *network.having(second.capability)]
    team = {id(item): item.graph.agents for item in able}
    if first.amount + second.amount <= sum(team.values()):
        return 0
    both = [
        item
        for item in network.having(first.capability)
        if any(item is other for other in network.having(second.capability))
    ]
    ways = [_distance(item.graph, first.states, second.states) for item in both]
    return int(min([*ways, network.horizon + 1]))


def _distance(graph: ClassGraph, here: Sequence[int], there: Sequence[int]) -> float:
    """Fewest steps from one of some states to one of others."""
    count = len(graph.start)
    # entries at the same place would be added up: keep the quickest of parallel edges
    order = np.lexsort((graph.duration, graph.head, graph.tail))
    key = graph.tail[order] * count + graph.head[order]
    _, fresh = np.unique(key, return_index=True)
    edge = order[fresh]
    entries = graph.duration[edge].astype(np.float64), (graph.tail[edge], graph.head[edge])
    matrix = sparse.csr_array(entries, shape=(count, count))
    found = csgraph.dijkstra(matrix, indices=np.array(here), min_only=True)
    return float(found[np.array(there)].min())
