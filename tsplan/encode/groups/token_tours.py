"""The cheapest ways of one token by the stops that it makes.

A token begins at one state and goes over a map between the states that matter. For every step,
node and set of *calls* there is the least price of being there then with these calls made (Held and
Karp, "A dynamic programming approach to sequencing problems", 1962, with windows of time). So one
table has the price of every set of calls.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from tsplan.encode.groups.token_stops import Steps
from tsplan.milp.model import Bools, Floats, Ints


class Call(NamedTuple):
    """To be at one of some nodes at all steps of one of the `runs`.

    Where runs are longer than a step there is one node, or none would be known to be left.
    """

    nodes: tuple[int, ...]
    runs: tuple[Steps, ...]


@dataclass(frozen=True, eq=False)
class Journey:
    """Where a token begins, and its map: what edges cost, and where it must not be when.

    `barred[step, node]` says that.
    """

    start: int
    tail: Ints
    head: Ints
    duration: Ints
    price: Floats
    barred: Bools

    @property
    def horizon(self) -> int:
        """The last step."""
        return len(self.barred) - 1

    @property
    def nodes(self) -> int:
        """How many nodes the map has."""
        return int(self.barred.shape[1])


class _Stay(NamedTuple):
    """From one step to another at a node: its price, and the calls that this makes."""

    node: int
    first: int
    last: int
    price: float
    calls: tuple[int, ...]


class Way(NamedTuple):
    """The edges that a token enters and when, and its node at every step, or -1."""

    edge: Ints
    step: Ints
    at: Ints


class Tours:
    """The table of one journey and some calls; `costs` has the price of every set of them.

    A set is a number whose bit i stands for call i.
    """

    def __init__(self, journey: Journey, calls: Sequence[Call]) -> None:
        self._journey = journey
        self._calls = calls
        self._waits = _waits(journey)
        self._stays = list(self._staying())
        shape = journey.horizon + 1, journey.nodes, 1 << len(calls)
        self._table = np.full(shape, np.inf)
        self._end = np.full(shape[2], np.inf)  # still on the way at the horizon
        self._fill()
        self.costs: Floats = np.minimum(self._table[-1].min(axis=0), self._end)

    def _fill(self) -> None:
        journey, table = self._journey, self._table
        table[0, journey.start, 0] = 0.0
        groups = list(_by_duration(journey))
        for step in range(journey.horizon + 1):
            self._call(step)
            for duration, edges, heads, first in groups if step < journey.horizon else ():
                gone = table[step][journey.tail[edges]] + journey.price[edges][:, None]
                end = step + duration
                if end > journey.horizon:
                    self._end = np.minimum(self._end, gone.min(axis=0))
                else:
                    come = np.minimum.reduceat(gone, first, axis=0)
                    table[end, heads] = np.minimum(table[end, heads], come)

    def _call(self, step: int) -> None:
        """Make calls at a step, and stay for those that take longer."""
        layer = self._table[step]
        layer[self._journey.barred[step]] = np.inf
        for number, call in enumerate(self._calls):
            if (step, step) in call.runs:
                for node in call.nodes:
                    _make(layer[node], number)
        for stay in self._stays:
            if stay.first == step:
                made = layer[stay.node] + stay.price
                for number in stay.calls:
                    _make(made, number)
                there = self._table[stay.last, stay.node]
                np.minimum(there, made, out=there)

    def _staying(self) -> Iterator[_Stay]:
        """The stays that calls of more than a step take, and those that overlapping ones take."""
        journey = self._journey
        nodes = {node for call in self._calls for a, b in call.runs for node in call.nodes if a < b}
        for node in sorted(nodes):
            here = [n for n, call in enumerate(self._calls) if node in call.nodes]
            long = {run for n in here for run in self._calls[n].runs if run[0] < run[1]}
            most = sum(
                max((b - a for a, b in self._calls[n].runs if a < b), default=0) for n in here
            )
            price = self._waits.get(node)
            if price is None:
                continue
            for first in sorted({a for a, _ in long}):
                for last in sorted({b for _, b in long if first < b <= first + most}):
                    if last > journey.horizon or journey.barred[first : last + 1, node].any():
                        continue
                    made = [
                        n
                        for n in here
                        if any(first <= a and b <= last for a, b in self._calls[n].runs)
                    ]
                    yield _Stay(node, first, last, (last - first) * price[1], tuple(made))

    def way(self, wanted: int) -> Way:
        """A cheapest way that makes some calls."""
        journey, table = self._journey, self._table
        node, step = -1, journey.horizon
        taken: list[tuple[int, int]] = []
        at = np.full(journey.horizon + 1, -1)
        if self._end[wanted] < table[-1, :, wanted].min():
            node, step, edge = self._last(wanted)
            taken.append((edge, step))
        else:
            node = int(table[-1, :, wanted].argmin())
        calls = wanted
        while True:
            at[step] = node
            value = table[step, node, calls]
            if step == 0 and node == journey.start and not calls:
                break
            fewer = self._fewer(step, node, calls, value)
            if fewer is not None:
                calls = fewer
                continue
            stay = self._stayed(step, node, calls, value)
            if stay is not None:
                edge = self._waits[node][0]
                taken += [(edge, when) for when in range(stay[0].first, step)]
                at[stay[0].first : step] = node
                step, calls = stay[0].first, stay[1]
                continue
            edge = self._came(step, node, calls, value)
            step -= int(journey.duration[edge])
            node = int(journey.tail[edge])
            taken.append((edge, step))
        edges, steps = np.array(taken, dtype=np.int64).reshape(-1, 2).T
        return Way(edges, steps, at)

    def _last(self, calls: int) -> tuple[int, int, int]:
        """Where, when and by which edge a token sets out that does not arrive any more."""
        journey = self._journey
        for edge, duration in enumerate(journey.duration.tolist()):
            for step in range(max(journey.horizon - duration + 1, 0), journey.horizon):
                node = int(journey.tail[edge])
                if self._table[step, node, calls] + journey.price[edge] == self._end[calls]:
                    return node, step, edge
        raise AssertionError("a price comes from somewhere")

    def _fewer(self, step: int, node: int, calls: int, value: float) -> int | None:
        for number, call in enumerate(self._calls):
            if calls >> number & 1 and node in call.nodes and (step, step) in call.runs:
                fewer = calls & ~(1 << number)
                if self._table[step, node, fewer] == value:
                    return fewer
        return None

    def _stayed(self, step: int, node: int, calls: int, value: float) -> tuple[_Stay, int] | None:
        for stay in self._stays:
            if stay.node == node and stay.last == step:
                made = sum(1 << number for number in stay.calls)
                before = calls & ~made
                if before != calls and self._table[stay.first, node, before] + stay.price == value:
                    return stay, before
        return None

    def _came(self, step: int, node: int, calls: int, value: float) -> int:
        journey = self._journey
        for edge in np.flatnonzero(journey.head == node).tolist():
            before = step - int(journey.duration[edge])
            if (
                before >= 0
                and self._table[before, journey.tail[edge], calls] + journey.price[edge] == value
            ):
                return edge
        raise AssertionError("a price comes from somewhere")


def _make(prices: Floats, number: int) -> None:
    """Whoever has not made a call makes it for nothing, in the prices of all sets."""
    pairs = prices.reshape(-1, 2, 1 << number)
    np.minimum(pairs[:, 1], pairs[:, 0], out=pairs[:, 1])


def _waits(journey: Journey) -> dict[int, tuple[int, float]]:
    """The unit wait of every node that has one, and its price."""
    waits = np.flatnonzero((journey.tail == journey.head) & (journey.duration == 1)).tolist()
    return {int(journey.tail[edge]): (edge, float(journey.price[edge])) for edge in waits}


def _by_duration(journey: Journey) -> Iterator[tuple[int, Ints, Ints, Ints]]:
    """Edges of equal duration in the order of their heads, these, and where each one's begin."""
    for duration in np.unique(journey.duration).tolist():
        edges = np.flatnonzero(journey.duration == duration)
        edges = edges[np.argsort(journey.head[edges], kind="stable")]
        heads, first = np.unique(journey.head[edges], return_index=True)
        yield duration, edges, heads, first
