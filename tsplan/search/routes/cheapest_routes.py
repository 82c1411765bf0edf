"""The cheapest routes of one class at given prices: a dynamic program over steps and states.

All numbers are whole, so what it says is exact: no route costs less, once what it is credited with
is taken off, than the program tells.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np
from scipy import sparse

from tsplan.milp.model import Floats, Ints
from tsplan.search.routes.rewards import Part, Prices, Rewards
from tsplan.search.routes.route_graph import RouteGraph

_FAR = 2**60  # of states nobody can be in

FIRST, LAST, EACH = range(3)
"""The ways in which an agent is credited, in the order of their prices."""


@dataclass(frozen=True, eq=False)
class Route:
    """What one agent of a class does: the columns it moves along from the start with a number.

    `stays` tell where it stands from which step to which, in order: nodes of the map.
    `credits` are parts of the needs of errands, by way and number; no more than 1 each, if the
    route is one that runs no errand twice.
    """

    group: int
    start: int
    columns: Ints
    stays: Sequence[tuple[int, int, int]]
    cost: int
    credits: Mapping[tuple[int, int], float]

    @property
    def repeats(self) -> list[int]:
        """The errands it is credited with more than once."""
        return sorted({number for (_, number), part in self.credits.items() if part > 1 + _LITTLE})


_LITTLE = 1e-9  # parts are sums of a few fractions


class CheapestRoutes:
    """Finds the cheapest routes of class `group`, whose columns cost whole numbers: `vector`.

    Costs and prices are counted in parts of one, `scale` of them.
    """

    def __init__(
        self, group: int, graph: RouteGraph, rewards: Rewards, vector: Floats, scale: int
    ) -> None:
        self.group = group
        self.graph = graph
        self.rewards = rewards
        self._vector = vector
        self._scale = scale

    def cost(self, columns: Ints) -> Ints:
        """What columns cost, in parts of one."""
        return np.rint(self._vector[columns]).astype(np.int64) * self._scale

    @cached_property
    def waits(self) -> list[tuple[Ints, Ints, Ints | None]]:
        """Who can stand from each step to the next, what that leads to, and its cost if any."""
        graph, (before, after) = self.graph, self.graph.standing
        known: dict[bytes, tuple[Ints, Ints]] = {}  # at most steps they are the same
        found = []
        for step in range(graph.horizon):
            waits = graph.waits_at(step)
            if waits.tobytes() not in known:
                some = waits[graph.place[before]]
                known[waits.tobytes()] = before[some], after[some]
            origin, become = known[waits.tobytes()]
            paid = np.zeros(len(graph.places), dtype=np.int64)
            paid[waits] = self.cost(graph.wait_column(np.flatnonzero(waits), step))
            found.append((origin, become, paid[graph.place[origin]] if paid.any() else None))
        return found

    def paid(self, column: int) -> int:
        """What one column costs, in parts of one."""
        return round(float(self._vector[column])) * self._scale

    def whole_cost(self, columns: Ints) -> int:
        """What a route along some columns costs."""
        return round(float(self._vector[columns].sum()))

    @cached_property
    def costs(self) -> list[Ints]:
        """What the moves cost that end at each step."""
        return [self.cost(move.column) for move in self.graph.moves]

    def solve(self, prices: Prices, fees: Ints) -> Solved:
        """All values at some prices; `fees` are paid at each of the starts."""
        graph, rewards = self.graph, self.rewards
        shape = graph.horizon + 1, int(graph.base[-1])
        gain = (rewards.whole @ (prices.first + prices.last + prices.each)).reshape(shape)
        parts = [self._worth(part, prices) for part in rewards.parts]
        solved = Solved(self, prices, fees, gain, parts)
        solved.fill()
        return solved

    def _worth(self, part: Part, prices: Prices) -> list[Ints]:
        """What it is worth at each step to be in each of the states in which errands are in part.

        Nobody is there at both ends of a stay who is not there for all of it.
        """
        step = (prices.each // self.rewards.stays)[part.errand]
        ends = part.first * prices.first[part.errand], part.last * prices.last[part.errand]
        return np.split(np.maximum(*ends) + part.inside * step, part.begin[1:])


class Solved:
    """The values of all states at some prices: before and after what is credited there."""

    def __init__(
        self,
        routes: CheapestRoutes,
        prices: Prices,
        fees: Ints,
        gain: Ints,
        parts: Sequence[list[Ints]],
    ) -> None:
        self._routes, self._graph, self._rewards = routes, routes.graph, routes.rewards
        self._prices, self._fees, self._gain, self._parts = prices, fees, gain, parts
        count, steps = int(self._graph.memory[-1]), self._graph.horizon + 1
        self._come = np.full(gain.shape, _FAR)
        self._whole = np.full(gain.shape, _FAR)
        self._done = np.full(gain.shape, _FAR)
        self._left = np.full((steps, count), _FAR)

    # --- forward ---------------------------------------------------------------------------------

    def fill(self) -> None:
        """Go through the steps: who comes, what is credited, who leaves."""
        order, begin = self._graph.folds
        for state, fee in zip(self._graph.starts, self._fees.tolist(), strict=True):
            self._come[0, state[0]] = fee
        for step in range(self._graph.horizon + 1):
            self._arrive(step)
            self._credit(step)
            self._left[step] = np.minimum.reduceat(self._done[step][order], begin[:-1])

    def _arrive(self, step: int) -> None:
        graph, values = self._graph, self._come[step]
        move = graph.moves[step]
        if len(move.source):
            cost = self._left.ravel()[move.source] + self._routes.costs[step]
            values[graph.come[move.target[move.first]]] = np.minimum.reduceat(cost, move.first)
        if step:
            before, after, paid = self._routes.waits[step - 1]
            stood = self._done[step - 1, before]
            np.minimum.at(values, after, stood if paid is None else stood + paid)

    def _credit(self, step: int) -> None:
        values = self._come[step] - self._gain[step]
        states, become = self._rewards.after[step]
        whole = self._whole[step]
        whole[:] = values
        whole[states] = _FAR
        np.minimum.at(whole, become, values[states])
        done = self._done[step]
        done[:] = whole
        for bit, (part, worth) in enumerate(zip(self._rewards.parts, self._parts, strict=True)):
            some = part.states[step]
            after = some + (1 << bit)
            done[after] = np.minimum(done[after], done[some] - worth[step])

    # --- what comes of it ------------------------------------------------------------------------

    @property
    def least(self) -> int:
        """The least cost of any route, to its end or beyond the horizon."""
        graph = self._graph
        found = int(self._left[-1].min())
        places, steps, columns = graph.cut
        if len(places):
            best = np.minimum.reduceat(self._left, graph.memory[:-1], axis=1)
            cost = best[steps, places] + self._routes.cost(columns)
            found = min(found, int(cost.min()))
        return found

    def below(self, most: int) -> Iterator[Route]:
        """The cheapest routes to each place in the end, as far as they cost less."""
        memory = self._graph.memory.tolist()
        for low, high in pairwise(memory):
            end = low + int(np.argmin(self._left[-1, low:high]))
            if self._left[-1, end] < most:
                yield self._route(end)

    # --- backward --------------------------------------------------------------------------------

    def _route(self, end: int) -> Route:
        """The route that ends in a memory at the horizon."""
        graph = self._graph
        given: dict[tuple[int, int], float] = defaultdict(float)
        columns: list[int] = []
        step, state = graph.horizon, self._leaving(graph.horizon, end)
        while True:
            state = self._credited(step, state, given)
            if not step:
                break
            step, state, column = self._before(step, state)
            columns.append(column)
        start = next(
            number
            for number, (begin, _) in enumerate(graph.starts)
            if begin == state and self._fees[number] == self._come[0, state]
        )
        way = np.array(columns[::-1], dtype=np.int64)
        cost = self._routes.whole_cost(way)
        stays = graph.stays(start, way)
        return Route(self._routes.group, start, way, stays, cost, dict(given))

    def _leaving(self, step: int, memory: int) -> int:
        """A state of the least value with a memory."""
        order, begin = self._graph.folds
        states = order[begin[memory] : begin[memory + 1]]
        return int(states[np.argmin(self._done[step, states])])

    def _credited(self, step: int, state: int, given: dict[tuple[int, int], float]) -> int:
        """The state before everything that was credited at a step, which is added to `given`."""
        if self._come[step, state] == self._done[step, state]:
            return state
        width = int(self._graph.base[-1])
        for part, origin in self._in_parts(step, state):
            state = origin
            place = part.place(step, state)
            number = int(part.errand[place])
            first, last = int(part.first[place]), int(part.last[place])
            dear = first * self._prices.first[number] >= last * self._prices.last[number]
            given[FIRST if dear else LAST, number] += float(first if dear else last)
            given[EACH, number] += float(part.inside[place]) / self._rewards.errands[number].stay
        states, become = self._rewards.after[step]
        some = states[become == state]
        if state not in states:
            some = np.append(some, state)
        value = self._come[step, some] - self._gain[step, some]
        origin = int(some[np.argmin(value)])
        for number, _ in _row(self._rewards.whole, step * width + origin):
            for way in (FIRST, LAST, EACH):
                given[way, number] += 1.0
        return origin

    def _in_parts(self, step: int, state: int) -> list[tuple[Part, int]]:
        """What was run in part at a step, the last one first, with the states before each."""
        if self._whole[step, state] == self._done[step, state]:
            return []
        parts = list(zip(self._rewards.parts, self._parts, strict=True))
        values = [self._whole[step]]  # with what is told from more and more of the bits
        for bit, (part, worth) in enumerate(parts):
            some, now = part.states[step], values[-1].copy()
            after = some + (1 << bit)
            now[after] = np.minimum(now[after], values[-1][some] - worth[step])
            values.append(now)
        found = []
        for bit, (part, _) in reversed(list(enumerate(parts))):
            if values[bit + 1][state] != values[bit][state]:
                state -= 1 << bit
                found.append((part, state))
        return found

    def _before(self, step: int, state: int) -> tuple[int, int, int]:
        """The step and state from which somebody came, and the column."""
        graph, value = self._graph, self._come[step, state]
        place = int(graph.place[state])
        column = graph.stood_column(place, step - 1)
        if column >= 0:
            paid = self._routes.paid(column)
            for origin in graph.stood_from[state]:
                if self._done[step - 1, origin] + paid == value:
                    return step - 1, origin, column
        move = graph.moves[step]
        memory = int(graph.memory[place] + graph.mask[state])
        low, high = np.searchsorted(move.target, [memory, memory + 1])
        cost = self._left.ravel()[move.source[low:high]] + self._routes.costs[step][low:high]
        chosen = low + int(np.argmin(cost))
        begun, origin = divmod(int(move.source[chosen]), int(graph.memory[-1]))
        return begun, self._leaving(begun, origin), int(move.column[chosen])


def _row(matrix: sparse.csr_array, row: int) -> Iterator[tuple[int, int]]:
    """The entries of one row of a matrix."""
    begin, end = matrix.indptr[row : row + 2].tolist()
    yield from zip(matrix.indices[begin:end].tolist(), matrix.data[begin:end].tolist(), strict=True)
