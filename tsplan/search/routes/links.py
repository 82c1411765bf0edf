"""What agents do between two errands: links, each the way from one of them to the next.

If every errand has a step at which its stay begins, a link can be made by those who are there in
time: a link asks for so many steps between the beginnings of two stays. Two stays at one place may
overlap: who is there for both makes no way in between.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from scipy import sparse
from scipy.sparse.csgraph import dijkstra

from tsplan.encode.class_columns import ClassColumns
from tsplan.encode.flow_network import Network
from tsplan.milp.model import Bools, Floats, Ints
from tsplan.search.routes.errands import Errand

_EXACT = 2.0**52  # sums up to this are whole, with room for two of them
_NEAREST = 20  # links from each errand, and to each errand, that are looked at
_FAR = 2**40


@dataclass(frozen=True, eq=False)
class Ways:
    """The ways of one class from some nodes to all others, by the first criterion and the second.

    By row and node: `steps` and `price` of the way, and the edge by which it comes; -1 for none.
    """

    sources: Ints
    steps: Ints
    price: Ints
    edge: Ints

    def path(self, tail: Ints, source: int, node: int) -> list[int]:
        """The edges of the way between two nodes, in order; `tail` are those of all edges."""
        row = int(np.searchsorted(self.sources, source))
        found: list[int] = []
        while node != source:
            found.append(int(self.edge[row, node]))
            node = int(tail[found[-1]])
        return found[::-1]


@dataclass(frozen=True, eq=False)
class Links:
    """Ways from starts and errands to errands, as arrays over all links.

    `group` is the class, `source` an errand or a start after all errands, `target` an errand. The
    stay of the target begins at least `gap` steps after that of the source, or after step 0.
    `ways[g][way]` has the ways of each class. `starts` are classes, nodes and numbers of agents.
    """

    group: Ints
    source: Ints
    target: Ints
    gap: Ints
    price: Ints
    way: Ints
    ways: Sequence[Sequence[Ways]]
    starts: Sequence[tuple[int, int, int]]

    def able(self, begins: Ints) -> Bools:
        """Which links can be made where stays begin at these steps."""
        at = np.append(begins, np.zeros(len(self.starts), dtype=np.int64))
        return np.asarray(at[self.source] + self.gap <= begins[self.target])


def links_of(network: Network, errands: Sequence[Errand], vector: Floats) -> Links | None:
    """The links of a network whose columns cost `vector`; None where ways have no single price.

    That is where an errand is at several states, where a price depends on the step, and where
    standing costs anything.
    """
    prices = [_prices(item, vector) for item in network.classes]
    if any(price is None for price in prices) or any(len(each.states) > 1 for each in errands):
        return None
    starts: list[tuple[int, int, int]] = []
    ways, blocks = [], []
    for number, (item, price) in enumerate(zip(network.classes, prices, strict=True)):
        assert price is not None
        begun = np.flatnonzero(item.graph.start)
        own = np.array([k for k, each in enumerate(errands) if number in each.classes], np.int64)
        place = np.array([errands[k].states[0] for k in own.tolist()], np.int64)
        made = _ways(item, price, np.unique(np.append(begun, place)), network.horizon)
        if made is None:
            return None
        ways.append(made)
        named = len(errands) + len(starts) + np.arange(len(begun))
        starts += [(number, node, int(item.graph.start[node])) for node in begun.tolist()]
        ends = np.append(begun, place), np.append(named, own)
        blocks += list(_between(errands, number, made, ends, (place, own)))
    columns = zip(*blocks, strict=True)
    group, source, target, gap, price, way = (np.concatenate(column) for column in columns)
    return Links(group, source, target, gap, price, way, ways, starts)


def _prices(item: ClassColumns, vector: Floats) -> Ints | None:
    """What each edge costs whenever it is entered; None where that is not one whole number."""
    edge, _, column = item.unrolled()
    price = np.zeros(len(item.graph.tail))
    price[edge] = vector[column]
    standing = item.graph.wait & (item.graph.duration == 1)
    if (price[edge] != vector[column]).any() or price[standing].any():
        return None
    return np.rint(price).astype(np.int64)


def _ways(item: ClassColumns, price: Ints, sources: Ints, horizon: int) -> list[Ways] | None:
    """The quickest ways, and the cheapest ones where these are others."""
    steps = item.graph.duration
    quick = _least(item, (steps, price), sources, horizon)
    cheap = _least(item, (price, steps), sources, horizon)
    if quick is None or cheap is None:
        return None
    return [Ways(sources, *quick), Ways(sources, cheap[1], cheap[0], cheap[2])]


def _least(
    item: ClassColumns, criteria: tuple[Ints, Ints], sources: Ints, horizon: int
) -> tuple[Ints, Ints, Ints] | None:
    """Both criteria of the ways that are least by the first and then the second, and last edges."""
    graph, (first, second) = item.graph, criteria
    width = (int(second.max(initial=0)) + 1) * len(graph.start)
    if float(width) * (int(first.max(initial=0)) + 1) * max(horizon, len(graph.start)) > _EXACT:
        return None
    moving = np.flatnonzero(graph.tail != graph.head)
    weight = (first * width + second)[moving]
    order = np.lexsort((weight, graph.head[moving], graph.tail[moving]))
    pairs = np.stack([graph.tail[moving], graph.head[moving]])[:, order]
    best = order[np.append(True, (np.diff(pairs) != 0).any(axis=0))[: len(order)]]
    count = len(graph.start)
    edges = moving[best]
    ends = graph.tail[edges], graph.head[edges]
    net = sparse.csr_array((weight[best].astype(np.float64), ends), shape=(count, count))
    keys = ends[0] * count + ends[1]
    far, before = dijkstra(net, indices=sources, return_predecessors=True)
    reached = np.isfinite(far) & (before >= 0)
    whole = np.where(np.isfinite(far), far, 0.0).astype(np.int64)
    edge = np.full(before.shape, -1)
    nodes = np.nonzero(reached)[1]
    edge[reached] = edges[np.searchsorted(keys, before[reached] * count + nodes)]
    one, other = whole // width, whole % width
    one[~np.isfinite(far)] = _FAR
    return one, other, edge


def _between(
    errands: Sequence[Errand],
    group: int,
    ways: Sequence[Ways],
    sources: tuple[Ints, Ints],
    targets: tuple[Ints, Ints],
) -> Iterator[tuple[Ints, ...]]:
    """The links of one class: quickest ways, and cheaper ones."""
    nodes, source = (part[:, None] for part in sources)
    places, target = targets
    count = len(errands)
    stay = np.array([*(each.stay for each in errands)], np.int64)
    first, last = (np.array([each.ends[end] for each in errands], np.int64) for end in (0, 1))
    number = np.minimum(source, count - 1)
    begun = source >= count
    row = np.searchsorted(ways[0].sources, nodes)
    for way, made in enumerate(ways):
        steps, price = made.steps[row, places], made.price[row, places]
        gap = np.where(begun, 0, stay[number] - 1) + steps
        # of two equal stays at one place and step one comes first, so there is no circle
        tied = (stay[number] == stay[target]) & (source > target)
        over = np.maximum(stay[number] - stay[target], tied)
        gap = np.where(~begun & (nodes == places), over, gap)
        soonest = np.where(begun, 0, first[number]) + gap
        open_ = (source != target) & (soonest <= last[target])
        if way:
            open_ &= price < ways[0].price[row, places]
        near = _near(price, open_, 1) | _near(price, open_, 0) | begun
        at, to = np.nonzero(open_ & near)
        where = np.full(len(at), group), source[at, 0], target[to]
        yield (*where, gap[at, to], price[at, to], np.full(len(at), way))


def _near(price: Ints, open_: Bools, axis: int) -> Bools:
    """Those that are among the cheapest of their row or column."""
    value = np.where(open_, price, _FAR)
    if value.shape[axis] <= _NEAREST:
        return open_
    most = np.sort(value, axis=axis).take([_NEAREST - 1], axis=axis)
    return np.asarray(value <= most)
