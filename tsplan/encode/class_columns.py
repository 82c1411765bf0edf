"""Where the flow columns of one class of agents lie: by edge and step, and by states at steps."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from tsplan.encode.class_graph import ClassGraph
from tsplan.encode.running_sums import unfolded
from tsplan.milp.model import Bools, Floats, Ints, Terms


@dataclass(frozen=True, eq=False)
class ClassColumns:
    """Where the columns of one class lie: edge e entered at step k is `offset[e] + k - first[e]`.

    `first[e] .. last[e]` are the steps at which edge e may be entered (empty if last < first);
    `arrival` is the earliest step at each state.
    """

    graph: ClassGraph
    arrival: Ints
    first: Ints
    last: Ints
    offset: Ints
    by_tail: tuple[Ints, Ints]
    by_head: tuple[Ints, Ints]
    stood: Mapping[int, tuple[int, Ints]] | None = None

    def standing(self, states: Ints, steps: Ints) -> tuple[Ints, Ints]:
        """Columns of those who have waited long enough at `states`: positions in `steps`, columns.

        `stood` has them for each state, from a first step on.
        """
        found = []
        for first, columns in ((self.stood or {})[state] for state in states.tolist()):
            inside = np.flatnonzero((steps >= first) & (steps < first + len(columns)))
            found.append((inside, columns[steps[inside] - first]))
        return positions_joined(found)

    def leaving(self, states: Ints, steps: Ints) -> tuple[Ints, Ints]:
        """Edges that leave `states`: positions in `steps`, and the column entered then."""
        edges = _members(self.by_tail, states)
        return self._at(edges, np.broadcast_to(steps, (len(edges), len(steps))))

    def entered(self, edges: Ints, steps: Ints) -> tuple[Ints, Ints]:
        """Some edges: positions in `steps`, and the column entered then."""
        return self._at(edges, np.broadcast_to(steps, (len(edges), len(steps))))

    def entries(self, edges: Ints, steps: Ints) -> Ints:
        """The columns of edges entered at these steps, one for each edge, where they may be."""
        return self._at(edges, steps[:, None])[1]

    def arriving(self, states: Ints, steps: Ints) -> tuple[Ints, Ints]:
        """Edges that end in `states`: positions in `steps`, and the column that ends then."""
        edges = _members(self.by_head, states)
        return self._at(edges, steps - self.graph.duration[edges][:, None])

    def entering(self, states: Ints, steps: Ints) -> tuple[Ints, Ints]:
        """Edges that end in `states` and begin elsewhere, as `arriving`."""
        edges = _members(self.by_head, states)
        edges = edges[~np.isin(self.graph.tail[edges], states)]
        return self._at(edges, steps - self.graph.duration[edges][:, None])

    def riding(self, states: Ints, steps: Ints) -> tuple[Ints, Ints]:
        """Edges that end in `states` and begin at other states, as `arriving`."""
        edges = _members(self.by_head, states)
        edges = edges[(edges < len(self.graph.rides)) & ~np.isin(self.graph.tail[edges], states)]
        return self._at(edges, steps - self.graph.duration[edges][:, None])

    def coming(self, states: Ints, steps: Ints) -> tuple[Ints, Ints]:
        """Edges that end in `states` and are no waits of one step, as `arriving`."""
        edges = _members(self.by_head, states)
        edges = edges[~self.graph.wait[edges] | (self.graph.duration[edges] > 1)]
        return self._at(edges, steps - self.graph.duration[edges][:, None])

    def between(self, states: Ints, steps: Ints) -> tuple[Ints, Ints]:
        """Edges from `states` to `states`: the columns that have begun and not ended then."""
        edges = _members(self.by_head, states)
        edges = edges[np.isin(self.graph.tail[edges], states)]
        inside, since = unfolded(np.ones_like(edges), self.graph.duration[edges] - 1)
        return self._at(edges[inside], steps - since[:, None])

    def _at(self, edges: Ints, entered: Ints) -> tuple[Ints, Ints]:
        first, last = self.first[edges][:, None], self.last[edges][:, None]
        edge, position = np.nonzero((first <= entered) & (entered <= last))
        column = self.offset[edges[edge]] + entered[edge, position] - first[edge, 0]
        return position, column

    def unrolled(self) -> tuple[Ints, Ints, Ints]:
        """Edge, step and column of every flow column of the class, as three equal-length arrays."""
        edge, step = unfolded(self.first, np.maximum(self.last - self.first + 1, 0))
        return edge, step, self.offset[edge] + step - self.first[edge]

    def late(self, makespan: int) -> Ints:
        """Columns of the moves that end after step `makespan`."""
        edge, step, column = self.unrolled()
        arrives = self.graph.arrives[edge]
        return column[(arrives > 0) & (step + arrives > makespan)]

    def lingering(self, states: Ints, steps: Ints) -> list[Terms]:
        """Who counts at `states` without being there: positions in `steps`, columns, signs.

        Those who left not long ago, less those who have come back since.
        """
        modes, graph = self.graph.modes, self.graph
        if modes is None:
            return []
        head = np.isin(modes.place[graph.head], states)
        same = modes.place[graph.tail] == modes.place[graph.head]
        left = np.isin(modes.place[graph.tail], states) & ~(same & (graph.duration == 1))
        found: list[Terms] = []
        for ago in range(modes.delay + 1):
            back = np.flatnonzero(head & (modes.lingers >= ago))
            begun = steps - ago - graph.duration[back][:, None]
            found.append((*self._at(back, begun), -1.0))
            gone = np.flatnonzero(left if ago else left[:0])
            begun = np.broadcast_to(steps - ago, (len(gone), len(steps)))
            found.append((*self._at(gone, begun), 1.0))
        return found

    def price(self, vector: Floats, prices: Floats | Ints | Bools) -> None:
        """Set the coefficients of all columns in a vector, given one for each edge."""
        edge, _, column = self.unrolled()
        vector[column] = prices[edge]


def grouped(keys: Ints, count: int) -> tuple[Ints, Ints]:
    """Positions sorted by key, and where each key's run begins (CSR of positions by key)."""
    order = np.argsort(keys, kind="stable")
    return order, np.searchsorted(keys[order], np.arange(count + 1))


def positions_joined(pairs: Sequence[tuple[Ints, Ints]]) -> tuple[Ints, Ints]:
    """Positions and columns of several parts, one after the other."""
    empty = np.empty(0, dtype=np.int64)
    return (
        np.concatenate([*(position for position, _ in pairs), empty]),
        np.concatenate([*(column for _, column in pairs), empty]),
    )


def _members(grouped: tuple[Ints, Ints], keys: Ints) -> Ints:
    order, begin = grouped
    parts = [order[begin[key] : begin[key + 1]] for key in keys]
    return np.concatenate([*parts, np.empty(0, dtype=np.int64)])
