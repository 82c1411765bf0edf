"""What a route is credited with: the part of an errand's need that one agent can be.

Who is at an errand's states for the whole stay counts once. Who is there for a part of it may be
relieved by others, and counts in three ways, each of which is true of every plan: as one who was
there at the first step, as one at the last step, and as the part of all steps that it was there.
Every way has a price of its own, so who is there for a part is paid for what that part is.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from typing import NamedTuple

import numpy as np
from scipy import sparse

from tsplan.milp.model import Bools, Ints
from tsplan.search.routes.errands import Errand
from tsplan.search.routes.route_graph import RouteGraph


class Prices(NamedTuple):
    """Prices of errands: of agents at a first step, at a last one, and of each step of one."""

    first: Ints
    last: Ints
    each: Ints


class Part(NamedTuple):
    """Errands that are run in part: one bit of the memories.

    By step the states in which they can be. Of all these, one step after the other from `begin` on:
    the errand, whether that is at a first step and at a last one, and the number of steps.
    """

    states: list[Ints]
    begin: Ints
    errand: Ints
    first: Ints
    last: Ints
    inside: Ints

    def place(self, step: int, state: int) -> int:
        """Where a state of a step is among all."""
        return int(self.begin[step] + np.searchsorted(self.states[step], state))


class Rewards:
    """What is credited in the states of one class at each step.

    `errands` are those of the class, of so many in all. Without `parts` only those count who are
    there for the whole stay: then the bound is none, but routes are those of plans in which nobody
    is relieved.
    """

    def __init__(
        self, graph: RouteGraph, errands: Mapping[int, Errand], count: int, *, parts: bool
    ) -> None:
        self._graph = graph
        self.errands = errands
        self._parts = parts
        self._width = int(graph.base[-1])
        self._rows = (graph.horizon + 1) * self._width
        self._count = count
        self.stays = np.ones(count, dtype=np.int64)
        for number, errand in errands.items():
            self.stays[number] = errand.stay

    @cached_property
    def whole(self) -> sparse.csr_array:
        """By step and state, the errands that are run to their end then."""
        rows, columns = self._whole
        return self._matrix(rows, columns, np.ones_like(rows))

    @cached_property
    def _whole(self) -> tuple[Ints, Ints]:
        rows, columns = [_NONE], [_NONE]
        for number, bit, states in self._own():
            errand = self.errands[number]
            steps = self._steps(errand)
            inside = self._inside(errand, steps, states)
            step, state = np.nonzero(self._free(states, bit) & (inside >= errand.stay))
            rows.append(steps[step, 0] * self._width + states[state])
            columns.append(np.full(len(step), number))
        return np.concatenate(rows), np.concatenate(columns)

    @cached_property
    def after(self) -> list[tuple[Ints, Ints]]:
        """By step the states in which errands are run to their end, and what they become."""
        graph = self._graph
        rows, columns = self._whole
        becomes: dict[int, int] = {}
        place = graph.place[rows % self._width]
        for row, number, where in zip(rows.tolist(), columns.tolist(), place.tolist(), strict=True):
            bit = 1 << graph.own[where].index(number)
            becomes[row] = becomes.get(row, row % self._width) + bit
        before = np.array(sorted(becomes), dtype=np.int64)
        states = np.array([becomes[row] for row in before.tolist()], dtype=np.int64)
        begin = np.searchsorted(before, np.arange(graph.horizon + 2) * self._width)
        return [
            (before[low:high] % self._width, states[low:high])
            for low, high in zip(begin[:-1].tolist(), begin[1:].tolist(), strict=True)
        ]

    @cached_property
    def parts(self) -> list[Part]:
        """What can be credited to those who leave too soon, one bit after the other."""
        bits = max((len(own) for own in self._graph.own), default=0)
        return [self._part(bit) for bit in range(bits if self._parts else 0)]

    def _part(self, wanted: int) -> Part:
        rows, columns, firsts, lasts, inside_of = ([_NONE] for _ in range(5))
        for number, bit, states in self._own():
            errand = self.errands[number]
            if bit != wanted or errand.stay == 1:
                continue
            steps = self._steps(errand)
            inside = self._inside(errand, steps, states)
            step, state = np.nonzero(self._free(states, bit) & (inside < errand.stay))
            now, here = steps[step, 0], states[state]
            rows.append(now * self._width + here)
            columns.append(np.full(len(step), number))
            firsts.append((now - self._graph.stood[here] <= errand.ends[1]).astype(np.int64))
            lasts.append((now >= errand.first + errand.stay - 1).astype(np.int64))
            inside_of.append(inside[step, state])
        row, column = np.concatenate(rows), np.concatenate(columns)
        order = np.argsort(row)
        begin = np.searchsorted(row[order], np.arange(self._graph.horizon + 2) * self._width)
        by_step = [part % self._width for part in np.split(row[order], begin[1:-1])]
        counts = (np.concatenate(values)[order] for values in (firsts, lasts, inside_of))
        return Part(by_step, begin[:-1], column[order], *counts)

    def _own(self) -> list[tuple[int, int, Ints]]:
        """Every errand at a place: its number, its bit there, and the states of the place."""
        base = self._graph.base.tolist()
        return [
            (number, bit, np.arange(base[place], base[place + 1]))
            for place, own in enumerate(self._graph.own)
            for bit, number in enumerate(own)
        ]

    def _steps(self, errand: Errand) -> Ints:
        return np.arange(errand.first, errand.last + 1)[:, None]

    def _inside(self, errand: Errand, steps: Ints, states: Ints) -> Ints:
        """For how many steps of the window an agent has been there, this one included."""
        return np.minimum(self._graph.stood[states], steps - errand.first) + 1

    def _free(self, states: Ints, bit: int) -> Bools:
        return np.asarray((self._graph.mask[states] >> bit & 1) == 0)

    def _matrix(self, rows: Ints, columns: Ints, values: Ints) -> sparse.csr_array:
        shape = (self._rows, self._count)
        return sparse.csr_array((values.astype(np.int64), (rows, columns)), shape=shape)


_NONE = np.empty(0, dtype=np.int64)
