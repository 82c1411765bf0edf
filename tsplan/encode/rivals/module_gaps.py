"""How many steps lie between two tasks that the same modules have to serve.

A task that asks for structures takes so many modules, at least those of the smallest structures
that can do it. Two tasks at different places that take more modules together than there are share
some of them. Whoever is shared is in a structure that can do the first when that ends, and in one
that can do the second when that begins; in between it goes from place to place in some structure or
other, each as fast as it is, and is rebuilt where that is possible. That others must be there for a
reconfiguration too is not asked, so it takes so many steps at least.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from tsplan.encode.flow_network import Network
from tsplan.encode.rivals.travel_gaps import Stay, disjoint
from tsplan.encode.structure_flows import Change
from tsplan.milp.model import Floats, Ints
from tsplan.ts.reachability import Lengths


class _Taken(NamedTuple):
    """How many modules of a pool a stay takes at least, and in which classes they can be."""

    stay: int
    pool: int
    modules: int
    classes: tuple[int, ...]


class ModuleGaps:
    """How many steps must lie between two stays of structures, whose changes are known."""

    def __init__(self, network: Network, changes: Sequence[Change]) -> None:
        self._network = network
        self._never = network.horizon + 1
        layers = [item.graph.layer for item in network.classes]
        self._pool = [None if layer is None else layer.pool for layer in layers]
        self._states = max((c.graph.states for c in network.classes), default=0)
        self._ways = _ways(network, changes, self._states)

    def between(self, stays: Sequence[Stay]) -> Ints:
        """Steps between the end of a stay (row) and the beginning of a later one (column).

        0 where there are modules enough for both, where others than modules of one kind may serve,
        or both need somebody at a common state.
        """
        found = np.zeros((len(stays), len(stays)), dtype=np.int64)
        taken = [item for place, stay in enumerate(stays) for item in self._taken(place, stay)]
        if not taken:
            return found
        of, pool, modules = (
            np.array([getattr(item, name) for item in taken], dtype=np.int64)
            for name in ("stay", "pool", "modules")
        )
        count = np.array([self._count(each) for each in pool.tolist()], dtype=np.int64)
        lacking = (modules[:, None] + modules[None, :] > count) & (pool[:, None] == pool)
        lacking &= disjoint([stay.states for stay in stays])[np.ix_(of, of)]
        one, other = np.nonzero(lacking)
        if len(one):
            far = self._far(taken, [stays[item.stay] for item in taken])[one, other]
            ways = np.minimum(far, self._never).astype(np.int64)
            np.maximum.at(found, (of[one], of[other]), ways)
        return found

    def _taken(self, place: int, stay: Stay) -> Iterator[_Taken]:
        """What a stay takes for each capability that only modules of one pool can have."""
        for capability, amount in stay.amounts if stay.states else ():
            able = np.flatnonzero(self._network.counted(capability).any(axis=1)).tolist()
            pools = {self._pool[number] for number in able}
            come = tuple(number for number in able if number in stay.classes)
            (pool, *others) = pools or {None}
            if come and pool is not None and not others:
                least = min(self._network.classes[number].graph.modules for number in come)
                yield _Taken(place, pool, amount * least, come)

    def _count(self, pool: int) -> int:
        """How many modules there are of a pool."""
        every = zip(self._network.classes, self._pool, strict=True)
        mine = [item.graph for item, own in every if own == pool]
        return sum(graph.modules * int(graph.start.sum()) for graph in mine)

    def _far(self, taken: Sequence[_Taken], stays: Sequence[Stay]) -> Floats:
        """How far it is for a module from each of some stays to each other."""
        nodes = [self._nodes(stay, item) for stay, item in zip(stays, taken, strict=True)]
        kinds = {each: place for place, each in enumerate(dict.fromkeys(nodes))}
        far = np.array(
            [
                [away[list(target)].min(initial=np.inf) for target in kinds]
                for away in map(self._ways.nearest, kinds)
            ]
        )
        kind = [kinds[each] for each in nodes]
        return far[np.ix_(kind, kind)]

    def _nodes(self, stay: Stay, item: _Taken) -> tuple[int, ...]:
        """Where modules are that serve a stay: a state in a class."""
        return tuple(
            number * self._states + state for number in item.classes for state in stay.states
        )


def _ways(network: Network, changes: Sequence[Change], states: int) -> Lengths:
    """The ways of a module from state to state in each class, and from class to class."""
    ways = []
    for number, item in enumerate(network.classes):
        if item.graph.layer is not None:
            graph = item.graph.among(item.graph.rides)
            ends = (number * states + graph.tail, number * states + graph.head)
            ways.append(np.stack([*ends, graph.duration]))
    rebuilt = [
        (one * states + change.state, other * states + change.state, change.end - change.begin)
        for change in changes
        for one, _, _ in change.parts
        for other, _, _ in change.made
    ]
    ways.append(np.array(rebuilt, dtype=np.int64).reshape(-1, 3).T)
    tail, head, steps = np.concatenate(ways, axis=1)
    return Lengths(len(network.classes) * states, tail, head, steps)
