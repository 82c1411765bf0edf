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
from tsplan.routing.crowd import Entries
from tsplan.routing.walks import Walk


@dataclass(frozen=True, eq=False)
class SingleAgent:
    """The map of one class, for ways of single agents up to a horizon.

    `prices` are those of its edges; no move ends after step `last`.
    """

    number: int
    graph: ClassGraph
    horizon: int
    prices: Floats
    last: int | None = None

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
    def _ending(self) -> list[list[tuple[int, int, int]]]:
        """The edges that end at each state, their durations and tails."""
        graph = self.graph
        found: list[list[tuple[int, int, int]]] = [[] for _ in graph.start]
        ends = zip(graph.duration.tolist(), graph.tail.tolist(), graph.head.tolist(), strict=True)
        for edge, (duration, tail, head) in enumerate(ends):
            found[head].append((edge, duration, tail))
        return found

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

    @cached_property
    def _priced(self) -> Floats:
        """What entering each edge costs, with a row for every step.

        Rows for steps before 0 and a last column for edges that are none are of no use to anybody.
        """
        table = np.full((self._longest + self.horizon, self._width), np.inf)
        table[self._longest :, :-1] = self.prices
        if self.last is not None:
            ends = np.arange(self.horizon)[:, None] + self.graph.arrives
            table[self._longest :, :-1][(ends > self.last) & (self.graph.travel > 0)] = np.inf
        return table

    def cheapest(
        self, start: int, duties: Mapping[int, Bools], at: Floats, entering: Entries
    ) -> tuple[Walk, float] | None:
        """The cheapest way from a state, with its cost; None where there is none.

        `at` is what being at each state costs at each step, an array (horizon + 1, states),
        `entering` what some edges cost at some steps beside their prices. At the steps of `duties`
        the agent is at one of the states that they mark, and at the horizon at some state.
        """
        step, edge, more = entering
        changed = (step + self._longest) * self._width + edge
        paid = self._priced.ravel()
        usual = paid[changed]
        paid[changed] += more
        busy = self._busy(duties)
        kept = self._priced[busy]
        for row in busy.tolist():  # nobody is at a state while on an edge
            step = row - self._longest
            ago = min(due - step for due in duties if due > step)
            self._priced[row, :-1][self.graph.duration > ago] = np.inf
        found = self._swept(start, duties, at, paid)
        self._priced[busy] = kept
        paid[changed] = usual
        return found

    def _busy(self, duties: Mapping[int, Bools]) -> Ints:
        """The rows of steps at which edges can be entered that are left only after a duty."""
        before = np.array([*duties], dtype=np.int64)[:, None] - np.arange(1, self._longest)
        return np.unique(before[before >= 0]) + self._longest

    def _swept(
        self, start: int, duties: Mapping[int, Bools], at: Floats, paid: Floats
    ) -> tuple[Walk, float] | None:
        """The cheapest way where entering edges costs what is to be paid."""
        before, steps, states = self._longest, self.horizon, len(self.graph.start)
        cost = np.full((before + steps + 1, states), np.inf)
        if 0 not in duties or duties[0][start]:
            cost[before, start] = 0.0
        reached = cost.ravel()
        of_cost, of_price = (positions.copy() for positions in self._begun)
        ways = np.empty(of_cost.shape)
        more = np.empty(of_cost.shape)
        for step in range(1, steps + 1):
            of_cost += states
            of_price += self._width
            reached.take(of_cost, out=ways, mode="clip")
            paid.take(of_price, out=more, mode="clip")
            np.add(ways, more, out=ways)
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
        states, width, before = len(self.graph.start), self._width, self._longest
        edges: list[int] = []
        entered: list[int] = []
        state, step = end, self.horizon
        while step > 0:
            least = np.inf
            for edge, duration, tail in self._ending[state]:
                row = step + before - duration
                cost = reached[row * states + tail] + paid[row * width + edge]
                if cost < least:
                    least, best = cost, (edge, duration, tail)
            edge, duration, state = best
            step -= duration
            edges.append(edge)
            entered.append(step)
        return Walk(self.number, start, np.array(edges[::-1]), np.array(entered[::-1]))
