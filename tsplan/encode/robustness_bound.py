"""What could hold at best: an optimistic robustness of every sub-formula at every step.

Each atom is judged on its own, as if all agents that can have arrived were where it wants them and
none where it does not. The result bounds the true availability from above, so a sub-formula whose
outlook is below the wanted level cannot hold and needs no columns; the root's outlook bounds the
mission's availability.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import singledispatch

import numpy as np

from tsplan.encode.count_atoms import Bound, Requirement
from tsplan.encode.flow_network import Network
from tsplan.logic import (
    Always,
    And,
    Constant,
    Count,
    Eventually,
    Formula,
    Or,
    Release,
    Until,
    walk,
)
from tsplan.logic.windows import switched, windowed
from tsplan.milp.model import Floats, Ints


class Outlook:
    """Optimistic robustness of the nodes of one formula on one flow network."""

    def __init__(
        self,
        root: Formula,
        network: Network,
        requirement: Callable[[Count], Requirement],
        *,
        trusting: bool = False,
    ) -> None:
        self._trusting = trusting
        self._network = network
        self._cache: dict[tuple[tuple[int, ...], str | None], Floats] = {}
        self._values: dict[Formula, Floats] = {}
        self._impossible: dict[Formula, Ints] = {}
        for node in walk(root):
            if isinstance(node, Count):
                self._values[node] = self._atom(requirement(node))
            else:
                self._values[node] = _combine(node, self._values, network.horizon + 1)

    def best(self, node: Formula, step: int) -> float:
        """Upper bound on the robustness of `node` at `step`, relative to the wanted level."""
        return float(self._values[node][step])

    def possible(self, node: Formula, step: int) -> bool:
        """False only if `node` can hold at `step` in no plan; if trusting, only if it is false."""
        best = self.best(node, step)
        return best > -np.inf if self._trusting else best >= 0

    def possible_throughout(self, node: Formula, first: int, last: int) -> bool:
        """Whether `possible` at all of the steps `first .. last`."""
        return self.first_impossible(node, first) > last

    def first_impossible(self, node: Formula, step: int) -> int:
        """The first step from `step` on at which `node` is not `possible`; past the end if none."""
        if node not in self._impossible:
            values = self._values[node]
            self._impossible[node] = np.flatnonzero(
                values == -np.inf if self._trusting else values < 0
            )
        steps = self._impossible[node]
        place = int(np.searchsorted(steps, step))
        return int(steps[place]) if place < len(steps) else self._network.horizon + 1

    def within_reach(self, bound: Bound, step: int) -> bool:
        """False only if one bound can hold at `step` in no plan."""
        return self._trusting or bool(self._bound(bound)[step] >= 0)

    def _bound(self, bound: Bound) -> Floats:
        if bound.upper:
            return np.full(self._network.horizon + 1, float(bound.amount))
        key = (bound.states, bound.capability)
        if key not in self._cache:
            states = np.array(bound.states, dtype=np.int64)
            self._cache[key] = self._network.most(states, bound.capability).astype(np.float64)
        return self._cache[key] - bound.amount

    def _atom(self, needed: Requirement) -> Floats:
        values = np.array([self._bound(bound) for bound in needed.bounds])
        result: Floats = values.min(axis=0) if needed.every else values.max(axis=0)
        return result


@singledispatch
def _combine(node: Formula, values: dict[Formula, Floats], steps: int) -> Floats:
    raise TypeError(f"no outlook is registered for {type(node).__name__}")


@_combine.register
def _(node: Constant, values: dict[Formula, Floats], steps: int) -> Floats:
    return np.full(steps, np.inf if node.value else -np.inf)


@_combine.register
def _(node: And, values: dict[Formula, Floats], steps: int) -> Floats:
    return np.array(np.min([values[child] for child in node.children], axis=0))


@_combine.register
def _(node: Or, values: dict[Formula, Floats], steps: int) -> Floats:
    return np.array(np.max([values[child] for child in node.children], axis=0))


@_combine.register
def _(node: Always, values: dict[Formula, Floats], steps: int) -> Floats:
    return np.array(windowed(_extended(values[node.child], node), node.low, node.high, np.minimum))


@_combine.register
def _(node: Eventually, values: dict[Formula, Floats], steps: int) -> Floats:
    return np.array(windowed(_extended(values[node.child], node), node.low, node.high, np.maximum))


@_combine.register
def _(node: Until, values: dict[Formula, Floats], steps: int) -> Floats:
    sides = _extended(values[node.left], node), _extended(values[node.right], node)
    return np.array(switched(sides, (node.low, node.high), np.maximum, np.minimum))


@_combine.register
def _(node: Release, values: dict[Formula, Floats], steps: int) -> Floats:
    sides = _extended(values[node.left], node), _extended(values[node.right], node)
    return np.array(switched(sides, (node.low, node.high), np.minimum, np.maximum))


def _extended(values: Floats, node: Always | Eventually | Until | Release) -> Floats:
    """The values at the steps that a window may reach; past the end nothing holds."""
    return np.concatenate([values, np.full(node.high, -np.inf)])
