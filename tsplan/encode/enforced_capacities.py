"""Which of a map's capacities a model has to keep; without the others it is a relaxation."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from tsplan.encode.agent_classes import AgentClass, MapArrays
from tsplan.milp.model import Ints


@dataclass(frozen=True)
class Enforced:
    """The numbers of the states and of the groups of edges whose capacities are kept.

    >>> Enforced() < Enforced(frozenset({3})).also(groups=[1])
    True
    """

    states: frozenset[int] = frozenset()
    groups: frozenset[int] = frozenset()

    def also(self, states: Iterable[int] = (), groups: Iterable[int] = ()) -> Enforced:
        """With more states and groups."""
        return Enforced(self.states.union(states), self.groups.union(groups))

    def __lt__(self, other: Enforced) -> bool:
        """Whether another keeps all of these and more."""
        return self != other and self.states <= other.states and self.groups <= other.groups

    def on(
        self, classes: Sequence[AgentClass], arrays: MapArrays
    ) -> tuple[tuple[AgentClass, ...], MapArrays]:
        """The classes and the map without the other capacities."""
        kept = sorted(self.groups)
        number = np.full(len(arrays.group_capacity) + 1, -1)  # the last is that of edges without
        number[kept] = np.arange(len(kept))
        narrowed = tuple(_with_groups(item, number[item.graph.group]) for item in classes)
        return narrowed, replace(
            arrays,
            group=number[arrays.group],
            capacity=tuple(pair for pair in arrays.capacity if pair[0] in self.states),
            group_capacity=tuple(arrays.group_capacity[group] for group in kept),
        )


def _with_groups(item: AgentClass, group: Ints) -> AgentClass:
    return replace(item, graph=replace(item.graph, group=group))
