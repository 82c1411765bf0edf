"""The routes of one class, unrolled: where an agent is, since when, and what it has run already.

A state of a route is a place, for how many steps the agent has stood there (as far as that
matters), and which errands of those remembered at the place it has run. Errands are forgotten at
places that do not remember them: then they may be run again, which only makes routes cheaper
(ng-routes: Baldacci, Mingozzi and Roberti, 2011).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from tsplan.encode.class_columns import ClassColumns, grouped
from tsplan.milp.model import Bools, Ints
from tsplan.search.routes.errands import Errand


class Moves(NamedTuple):
    """Moves that end at one step: from `source` to `target`, which is sorted, by `column`.

    Both are places with memories; sources count all steps, one after the other. The moves to one
    target begin at `first`.
    """

    source: Ints
    target: Ints
    first: Ints
    column: Ints


@dataclass(frozen=True, eq=False)
class RouteGraph:
    """The states of routes of one class, and the moves between them.

    `own` are the errands at each of the `places`, `bits` those that are remembered there, the own
    ones first. States of a place are in the order of the steps stood, then of the memories. With
    memories alone there are fewer: those are told by `memory`.
    """

    item: ClassColumns
    horizon: int
    places: Ints
    own: Sequence[Sequence[int]]
    bits: Sequence[Sequence[int]]
    longest: Ints  # steps stood at each place that are told apart

    @classmethod
    def of(
        cls,
        item: ClassColumns,
        horizon: int,
        errands: Mapping[int, Errand],
        remembered: Mapping[int, Sequence[int]],
    ) -> RouteGraph:
        """The routes past some errands; `remembered` are more of them by the nodes of the map."""
        graph = item.graph
        places = np.unique(np.concatenate([graph.tail, graph.head, np.flatnonzero(graph.start)]))
        here: dict[int, list[int]] = {place: [] for place in places.tolist()}
        for number, errand in errands.items():
            for state in errand.states.tolist():
                if state in here:
                    here[state].append(number)
        bits = [list(dict.fromkeys([*own, *remembered.get(p, ())])) for p, own in here.items()]
        stays = [max((errands[k].stay for k in own), default=0) for own in here.values()]
        return cls(item, horizon, places, list(here.values()), bits, np.array(stays))

    # --- states ----------------------------------------------------------------------------------

    @cached_property
    def masks(self) -> Ints:
        """How many memories there are at each place."""
        return 1 << np.array([len(bits) for bits in self.bits], dtype=np.int64)

    @cached_property
    def base(self) -> Ints:
        """Where the states of each place begin, and how many there are."""
        return np.concatenate([[0], np.cumsum((self.longest + 1) * self.masks)])

    @cached_property
    def memory(self) -> Ints:
        """Where the memories of each place begin, and how many there are."""
        return np.concatenate([[0], np.cumsum(self.masks)])

    @cached_property
    def place(self) -> Ints:
        """The place of each state."""
        return np.repeat(np.arange(len(self.places)), np.diff(self.base))

    @cached_property
    def stood(self) -> Ints:
        """For how many steps an agent has stood at its place before, at most `longest`."""
        return (np.arange(self.base[-1]) - self.base[self.place]) // self.masks[self.place]

    @cached_property
    def mask(self) -> Ints:
        """What an agent remembers in each state."""
        return (np.arange(self.base[-1]) - self.base[self.place]) % self.masks[self.place]

    @cached_property
    def folds(self) -> tuple[Ints, Ints]:
        """The states in the order of their memories, and where each memory's begin."""
        return grouped(self.memory[self.place] + self.mask, int(self.memory[-1]))

    @cached_property
    def come(self) -> Ints:
        """For each memory the state in which nobody has stood before."""
        where = np.repeat(np.arange(len(self.places)), self.masks)
        return self.base[where] + np.arange(self.memory[-1]) - self.memory[where]

    @cached_property
    def starts(self) -> list[tuple[int, int]]:
        """The states in which agents begin, and how many do."""
        begun = np.flatnonzero(self.item.graph.start)
        places = np.searchsorted(self.places, begun)
        return list(
            zip(self.base[places].tolist(), self.item.graph.start[begun].tolist(), strict=True)
        )

    # --- waits -----------------------------------------------------------------------------------

    @cached_property
    def wait(self) -> Ints:
        """The edge by which agents stand at each place for a step, or -1."""
        graph = self.item.graph
        found = np.full(len(self.places), -1)
        waits = np.flatnonzero(graph.wait & (graph.duration == 1))
        found[np.searchsorted(self.places, graph.tail[waits])] = waits
        return found

    @cached_property
    def standing(self) -> tuple[Ints, Ints]:
        """States in which agents can stand, and what they become; the latter are sorted out.

        The longest time goes on, so two states may become one: those come last.
        """
        able = np.flatnonzero(self.wait[self.place] >= 0)
        longer = self.stood[able] < self.longest[self.place[able]]
        after = able + np.where(longer, self.masks[self.place[able]], 0)
        order = np.argsort(~longer, kind="stable")
        return able[order], after[order]

    def waits_at(self, step: int) -> Bools:
        """At which places agents can stand from a step to the next."""
        if not len(self.item.first):
            return np.zeros(len(self.wait), dtype=np.bool_)
        first, last = self.item.first[self.wait], self.item.last[self.wait]
        return (self.wait >= 0) & (first <= step) & (step <= last)

    def wait_column(self, place: Ints | int, step: int) -> Ints:
        """The columns of waits."""
        edge = self.wait[place]
        return np.asarray(self.item.offset[edge] + step - self.item.first[edge])

    @cached_property
    def stood_from(self) -> list[list[int]]:
        """For each state those in which agents can stand for a step and come to be in it."""
        found: list[list[int]] = [[] for _ in range(int(self.base[-1]))]
        for before, after in zip(*(part.tolist() for part in self.standing), strict=True):
            found[after].append(before)
        return found

    @cached_property
    def _stood(self) -> list[tuple[int, int, int]]:
        """The first and last step and the column of step 0 of waits at each place; none of -1."""
        item, found = self.item, []
        for edge in self.wait.tolist():
            span = (
                (item.first[edge], item.last[edge], item.offset[edge]) if edge >= 0 else (0, -1, 0)
            )
            first, last, offset = map(int, span)
            found.append((first, last, offset - first))
        return found

    def stood_column(self, place: int, step: int) -> int:
        """The column of standing at a place from a step to the next, or -1."""
        first, last, column = self._stood[place]
        return column + step if first <= step <= last else -1

    # --- moves -----------------------------------------------------------------------------------

    @cached_property
    def moves(self) -> list[Moves]:
        """The moves that end at each step, 0 included."""
        edge, source, target = self._ways
        item, most = self.item, int(self.memory[-1])
        steps = item.graph.duration[edge]
        found = []
        for step in range(self.horizon + 1):
            begun = step - steps
            some = np.flatnonzero((begun >= item.first[edge]) & (begun <= item.last[edge]))
            begun, ends = begun[some], target[some]
            column = item.offset[edge[some]] + begun - item.first[edge[some]]
            first = np.flatnonzero(np.diff(ends, prepend=-1))
            found.append(Moves(begun * most + source[some], ends, first, column))
        return found

    @cached_property
    def _ways(self) -> tuple[Ints, Ints, Ints]:
        """Edges between memories: all that is remembered at both ends goes on."""
        graph = self.item.graph
        edges = np.setdiff1d(np.arange(len(graph.tail)), self.wait)
        tails, heads = (np.searchsorted(self.places, ends[edges]) for ends in self._ends)
        ways = {}
        for pair in sorted(set(zip(tails.tolist(), heads.tolist(), strict=True))):
            ways[pair] = self.memory[pair[0]] + np.arange(self.masks[pair[0]]), self._kept(*pair)
        pairs = [ways[pair] for pair in zip(tails.tolist(), heads.tolist(), strict=True)]
        none = np.empty(0, dtype=np.int64)
        source = np.concatenate([none, *(source for source, _ in pairs)])
        target = np.concatenate([none, *(target for _, target in pairs)])
        edge = np.repeat(edges, [len(source) for source, _ in pairs])
        order = np.argsort(target, kind="stable")
        return edge[order], source[order], target[order]

    @property
    def _ends(self) -> tuple[Ints, Ints]:
        return self.item.graph.tail, self.item.graph.head

    def _kept(self, tail: int, head: int) -> Ints:
        """The memories at one place that those at another become."""
        before, after = self.bits[tail], {k: bit for bit, k in enumerate(self.bits[head])}
        masks = np.arange(self.masks[tail])
        kept = np.zeros_like(masks)
        for bit, number in enumerate(before):
            if number in after:
                kept |= (masks >> bit & 1) << after[number]
        return np.asarray(self.memory[head] + kept)

    @cached_property
    def cut(self) -> tuple[Ints, Ints, Ints]:
        """Where and when edges begin that end after the horizon: places, steps and columns."""
        edge, step, column = self.item.unrolled()
        late = step + self.item.graph.duration[edge] > self.horizon
        places = np.searchsorted(self.places, self.item.graph.tail[edge[late]])
        return places, step[late], column[late]

    # --- routes ----------------------------------------------------------------------------------

    @cached_property
    def _entered(self) -> tuple[Ints, Ints, Ints]:
        """Columns in their order, with the edges and steps they stand for."""
        edge, step, column = self.item.unrolled()
        order = np.argsort(column)
        return column[order], edge[order], step[order]

    def waiting(self, start: int) -> Ints | None:
        """The columns of those who stay where they begin; None where nobody can."""
        place = int(self.place[self.starts[start][0]])
        steps = np.arange(self.horizon)
        edge = int(self.wait[place])
        if edge < 0 or self.item.first[edge] > 0 or self.item.last[edge] < self.horizon - 1:
            return None
        return np.asarray(self.item.offset[edge] + steps - self.item.first[edge])

    def stays(self, start: int, columns: Ints) -> list[tuple[int, int, int]]:
        """Where a route from a start with a number stands from which step to which, in order.

        Places are nodes of the map.
        """
        graph = self.item.graph
        every, edges, steps = self._entered
        where = np.searchsorted(every, columns)
        node, since = int(self.places[self.place[self.starts[start][0]]]), 0
        found = []
        for edge, step in zip(edges[where].tolist(), steps[where].tolist(), strict=True):
            if graph.tail[edge] == graph.head[edge] and graph.duration[edge] == 1:
                continue
            found.append((node, since, step))
            node, since = int(graph.head[edge]), step + int(graph.duration[edge])
        return [*found, (node, since, self.horizon)]
