"""Which of a map's capacities a model has to keep; without the others it is a relaxation."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from tsplan.encode.agent_classes import AgentClass, MapArrays
from tsplan.milp.model import Ints


@dataclass(frozen=True)
class Enforced:
    """The numbers of the states and of the groups of edges and zones whose capacities are kept.

    Only plans matter whose agents make detours of at most `slack` steps in all, compared with a
    plan that keeps no capacities.

    >>> Enforced() < Enforced(frozenset({3})).also(groups=[1])
    True
    """

    states: frozenset[int] = frozenset()
    groups: frozenset[int] = frozenset()
    slack: float = np.inf

    @property
    def any(self) -> bool:
        """Whether it keeps some."""
        return bool(self.states or self.groups)

    def also(self, states: Iterable[int] = (), groups: Iterable[int] = ()) -> Enforced:
        """With more states and groups."""
        more = self.states.union(states), self.groups.union(groups)
        return Enforced(*more, self.slack)

    def __lt__(self, other: Enforced) -> bool:
        """Whether another keeps all of these and more."""
        mine, others = (self.states, self.groups), (other.states, other.groups)
        pairs = zip(mine, others, strict=True)
        return mine != others and all(one <= more for one, more in pairs)

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
            zone_states={
                int(number[group]): states
                for group, states in arrays.zone_states.items()
                if group in self.groups
            },
        )


def _with_groups(item: AgentClass, group: Ints) -> AgentClass:
    return replace(item, graph=replace(item.graph, group=group))
