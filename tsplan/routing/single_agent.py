"""The cheapest way of one agent over the map unrolled in time, around what is in its way.

A dynamic program over the steps: the cheapest way to each state at a step comes by one of the edges
that end there then. Source: D. Silver, "Cooperative pathfinding", AIIDE 2005, with all states
looked at in one sweep per step instead of a search guided by distances.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from tsplan.encode.class_graph import ClassGraph
from tsplan.milp.model import Bools, Floats, Ints
from tsplan.routing.walks import Walk


@dataclass(frozen=True, eq=False)
class SingleAgent:
    """The map of one class, for ways of single agents up to a horizon."""

    number: int
    graph: ClassGraph
    horizon: int

    @cached_property
    def _incoming(self) -> Ints:
        """The edges that end at each state, one a row, filled up with one that is none."""
        graph = self.graph
        order = np.argsort(graph.head, kind="stable")
        head = graph.head[order]
        begin = np.searchsorted(head, np.arange(len(graph.start) + 1))
        most = int(np.diff(begin).max(initial=1))
        edges = np.full((most, len(graph.start)), len(graph.tail))
        edges[np.arange(len(head)) - begin[head], head] = order
        return edges

    @cached_property
    def _longest(self) -> int:
        return int(self.graph.duration.max(initial=1))

    @cached_property
    def _begun(self) -> tuple[Ints, Ints]:
        """Where it says, for each incoming edge that ends at step 0, what its beginning cost.

        Positions in the tables of costs and of prices, which have a row for every step, and rows
        for steps before 0 in which nothing is possible; those of a later step lie rows further on.
        """
        tail = np.append(self.graph.tail, 0)[self._incoming]
        row = self._longest - np.append(self.graph.duration, 1)[self._incoming]
        return row * len(self.graph.start) + tail, row * self._width + self._incoming

    @property
    def _width(self) -> int:
        return len(self.graph.tail) + 1

    def cheapest(
        self, start: int, duties: Mapping[int, Bools], at: Floats, entering: Floats
    ) -> tuple[Walk, float] | None:
        """The cheapest way from a state, with its cost; None where there is none.

        `at` is what being at each state costs at each step, `entering` what edges cost entered at
        each step, arrays (horizon + 1, states) and (horizon, edges). At the steps of `duties` the
        agent is at one of the states that they mark, and at the horizon at some state.
        """
        before, steps, states = self._longest, self.horizon, len(self.graph.start)
        price = np.full((before + steps, self._width), np.inf)
        price[before:, :-1] = entering
        for due in duties:  # nobody is at a state while on an edge
            for ago in range(1, min(before, due + 1)):
                price[before + due - ago, :-1][self.graph.duration > ago] = np.inf
        cost = np.full((before + steps + 1, states), np.inf)
        if 0 not in duties or duties[0][start]:
            cost[before, start] = 0.0
        reached, paid = cost.ravel(), price.ravel()
        of_cost, of_price = (positions.copy() for positions in self._begun)
        for step in range(1, steps + 1):
            of_cost += states
            of_price += self._width
            ways = reached.take(of_cost)
            ways += paid.take(of_price)
            here = cost[before + step]
            ways.min(axis=0, out=here)
            here += at[step]
            if step in duties:
                here[~duties[step]] = np.inf
        end = int(cost[-1].argmin())
        if not np.isfinite(cost[-1, end]):
            return None
        return self._traced(start, end, reached, paid), float(cost[-1, end])

    def _traced(self, start: int, end: int, reached: Floats, paid: Floats) -> Walk:
        """The way that has the least cost, read backwards."""
        of_cost, of_price = self._begun
        states, width = len(self.graph.start), self._width
        edges: list[int] = []
        entered: list[int] = []
        state, step = end, self.horizon
        while step > 0:
            ways = reached[of_cost[:, state] + step * states]
            ways = ways + paid[of_price[:, state] + step * width]
            edge = int(self._incoming[int(ways.argmin()), state])
            step -= int(self.graph.duration[edge])
            edges.append(edge)
            entered.append(step)
            state = int(self.graph.tail[edge])
        return Walk(self.number, start, np.array(edges[::-1]), np.array(entered[::-1]))
