"""How far it is between the places that an agenda names, and from where agents begin."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from tsplan.encode.encoded import Setting
from tsplan.milp.model import Floats, Ints
from tsplan.routing.appointments import Agenda
from tsplan.ts.reachability import Lengths


@dataclass(frozen=True, eq=False)
class Distances:
    """Places, numbered by their states, and what it takes to go from one to another.

    `kind` is the class of every agent and `begin` the place where it is at first. `steps` and
    `prices` are tables of classes, places and places: the quickest way and, apart from that, the
    cheapest.
    """

    place: dict[int, int]
    kind: Ints
    begin: Ints
    steps: Floats
    prices: Floats

    @classmethod
    def of(cls, setting: Setting, agenda: Agenda, prices: Sequence[Floats]) -> Distances:
        """Those of all agents of a setting, class by class; every edge has its price."""
        wanted = {state for need in agenda.needs for state in need.states}
        starts = [np.repeat(np.arange(len(c.graph.start)), c.graph.start) for c in setting.classes]
        begin = np.concatenate(starts)
        states = [*sorted(wanted), *sorted(set(begin.tolist()) - wanted)]
        place = {state: number for number, state in enumerate(states)}
        steps, cheap = [], []
        for item, price in zip(setting.classes, prices, strict=True):
            graph = item.graph
            steps.append(graph.lengths.distances(states)[:, states])
            if np.array_equal(price, graph.travel):
                cheap.append(steps[-1])
                continue
            lengths = Lengths(len(graph.start), graph.tail, graph.head, price)
            cheap.append(lengths.distances(states)[:, states])
        kind = np.repeat(np.arange(len(starts)), [len(part) for part in starts])
        at = np.array([place[state] for state in begin.tolist()], dtype=np.int64)
        return cls(place, kind, at, np.array(steps), np.array(cheap))

    def places(self, states: Sequence[int]) -> Ints:
        """The numbers of some states."""
        return np.array([self.place[state] for state in states], dtype=np.int64)
