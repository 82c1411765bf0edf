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
        """The edges that end at each state, filled up with one that is none."""
        graph = self.graph
        order = np.argsort(graph.head, kind="stable")
        head = graph.head[order]
        begin = np.searchsorted(head, np.arange(len(graph.start) + 1))
        most = int(np.diff(begin).max(initial=1))
        edges = np.full((len(graph.start), most), len(graph.tail))
        edges[head, np.arange(len(head)) - begin[head]] = order
        return edges

    @cached_property
    def _ends(self) -> tuple[Ints, Ints]:
        """Tail and duration of each edge of `_incoming`."""
        tail = np.append(self.graph.tail, 0)[self._incoming]
        return tail, np.append(self.graph.duration, 1)[self._incoming]

    @cached_property
    def _longest(self) -> int:
        return int(self.graph.duration.max(initial=0))

    def cheapest(
        self, start: int, duties: Mapping[int, Bools], at: Floats, entering: Floats
    ) -> tuple[Walk, float] | None:
        """The cheapest way from a state, with its cost; None where there is none.

        `at` is what being at each state costs at each step, `entering` what edges cost entered at
        each step, arrays (horizon + 1, states) and (horizon, edges). At the steps of `duties` the
        agent is at one of the states that they mark, and at the horizon at some state.
        """
        tail, duration = self._ends
        steps = self.horizon
        cost = np.full((steps + 1, len(self.graph.start)), np.inf)
        cost[0, start] = 0.0 if 0 not in duties or duties[0][start] else np.inf
        price = np.concatenate([entering, np.full((steps, 1), np.inf)], axis=1)
        for due in duties:  # nobody is at a state while on an edge
            for before in range(1, min(self._longest, due + 1)):
                price[due - before, :-1][self.graph.duration > before] = np.inf
        for step in range(1, steps + 1):
            begun = step - duration
            since = np.maximum(begun, 0)
            ways = cost[since, tail] + price[since, self._incoming]
            ways[begun < 0] = np.inf
            cost[step] = ways.min(axis=1) + at[step]
            if step in duties:
                cost[step, ~duties[step]] = np.inf
        end = int(cost[steps].argmin())
        if not np.isfinite(cost[steps, end]):
            return None
        return self._traced(start, end, cost, price), float(cost[steps, end])

    def _traced(self, start: int, end: int, cost: Floats, price: Floats) -> Walk:
        """The way that has the least cost, read backwards."""
        tail, duration = self._ends
        edges: list[int] = []
        entered: list[int] = []
        state, step = end, self.horizon
        while step > 0:
            begun = step - duration[state]
            since = np.maximum(begun, 0)
            ways = cost[since, tail[state]] + price[since, self._incoming[state]]
            ways[begun < 0] = np.inf
            best = int(ways.argmin())
            edges.append(int(self._incoming[state, best]))
            step = int(begun[best])
            entered.append(step)
            state = int(tail[state, best])
        return Walk(self.number, start, np.array(edges[::-1]), np.array(entered[::-1]))
