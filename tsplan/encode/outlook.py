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

from tsplan.encode.atoms import Bound, Requirement
from tsplan.encode.network import Network
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
from tsplan.milp.model import Floats


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
    return np.array(_windows(values[node.child], node.low, node.high, -np.inf).min(axis=-1))


@_combine.register
def _(node: Eventually, values: dict[Formula, Floats], steps: int) -> Floats:
    return np.array(_windows(values[node.child], node.low, node.high, -np.inf).max(axis=-1))


@_combine.register
def _(node: Until, values: dict[Formula, Floats], steps: int) -> Floats:
    left = _windows(values[node.left], 0, node.high, -np.inf)
    right = _windows(values[node.right], 0, node.high, -np.inf)
    before = np.concatenate(
        [np.full((steps, 1), np.inf), np.minimum.accumulate(left, axis=1)[:, :-1]], axis=1
    )
    return np.array(np.minimum(before, right)[:, node.low :].max(axis=1))


@_combine.register
def _(node: Release, values: dict[Formula, Floats], steps: int) -> Floats:
    left = _windows(values[node.left], 0, node.high, -np.inf)
    right = _windows(values[node.right], 0, node.high, -np.inf)
    before = np.concatenate(
        [np.full((steps, 1), -np.inf), np.maximum.accumulate(left, axis=1)[:, :-1]], axis=1
    )
    return np.array(np.maximum(before, right)[:, node.low :].min(axis=1))


def _windows(values: Floats, low: int, high: int, beyond: float) -> Floats:
    """Row k holds the values at steps k+low .. k+high; steps past the end have `beyond`."""
    padded = np.concatenate([values, np.full(high, beyond)])
    view = np.lib.stride_tricks.sliding_window_view(padded, high - low + 1)
    return np.array(view[low : low + len(values)])
