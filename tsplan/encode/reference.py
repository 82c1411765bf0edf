"""The reference encoding: plain, slow, and meant to be obviously right.

The full map, integer flows, one binary for every (sub-formula, step), tied to it in both
directions. `rho` is the availability asked for: the binary of an atom `f >= m` is 1 exactly when
`f - m >= rho`, that of `f <= m` when `m - f >= rho`. Every M is the least that the bounds of the
row allow. The tight encoding is judged against this one.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import singledispatchmethod

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
from tsplan.milp.model import Draft


class ReferenceEncoder:
    """One 0/1 column for every (node, step) of a formula in positive normal form."""

    def __init__(
        self,
        draft: Draft,
        network: Network,
        requirement: Callable[[Count], Requirement],
        rho: tuple[int, int, int],
    ) -> None:
        self._draft = draft
        self._network = network
        self._requirement = requirement
        self._rho, self._rho_low, self._rho_high = rho
        self._columns: dict[tuple[Formula, int], int] = {}
        self._bounds: dict[tuple[Bound, int], int] = {}

    def encode(self, root: Formula) -> None:
        """Require the root at step 0."""
        latest = _latest(root)
        for node in walk(root):
            for step in range(latest[node] + 1):
                self._columns[node, step] = self._column(node, step)
        self._draft.rows(
            [0], [self._columns[root, 0]], 1.0, lower=1.0, upper=1.0, kind="root", node=root, step=0
        )

    @singledispatchmethod
    def _column(self, node: Formula, step: int) -> int:
        raise TypeError(f"no reference encoding is registered for {type(node).__name__}")

    @_column.register
    def _(self, node: Constant, step: int) -> int:
        fixed = float(node.value)
        return int(self._draft.columns(1, lower=fixed, upper=fixed, integer=True)[0])

    @_column.register
    def _(self, node: Count, step: int) -> int:
        needed = self._requirement(node)
        parts = [self._bound(bound, step) for bound in needed.bounds]
        return self._all(parts, node, step) if needed.every else self._any(parts, node, step)

    @_column.register
    def _(self, node: And, step: int) -> int:
        return self._all([self._columns[child, step] for child in node.children], node, step)

    @_column.register
    def _(self, node: Or, step: int) -> int:
        return self._any([self._columns[child, step] for child in node.children], node, step)

    @_column.register
    def _(self, node: Always, step: int) -> int:
        span = range(step + node.low, step + node.high + 1)
        return self._all([self._columns[node.child, time] for time in span], node, step)

    @_column.register
    def _(self, node: Eventually, step: int) -> int:
        span = range(step + node.low, step + node.high + 1)
        return self._any([self._columns[node.child, time] for time in span], node, step)

    @_column.register
    def _(self, node: Until, step: int) -> int:
        cases = []
        for time in range(step + node.low, step + node.high + 1):
            left = [self._columns[node.left, before] for before in range(step, time)]
            cases.append(self._all([*left, self._columns[node.right, time]], node, step))
        return self._any(cases, node, step)

    @_column.register
    def _(self, node: Release, step: int) -> int:
        cases = []
        for time in range(step + node.low, step + node.high + 1):
            left = [self._columns[node.left, before] for before in range(step, time)]
            cases.append(self._any([*left, self._columns[node.right, time]], node, step))
        return self._all(cases, node, step)

    def _bound(self, bound: Bound, step: int) -> int:
        """1 exactly when the bound holds with `rho` to spare, by two rows with derived M."""
        if (bound, step) in self._bounds:
            return self._bounds[bound, step]
        column = int(self._draft.columns(1, upper=1.0, integer=True)[0])
        self._bounds[bound, step] = column
        states = np.array(bound.states, dtype=np.int64)
        present, constant = self._network.present(states, bound.capability, step)
        sign = -1.0 if bound.upper else 1.0
        most = sum(item.graph.agents for item in self._network.having(bound.capability))
        # slack = sign * (n - amount) - rho; the column is 1 exactly when slack >= 0
        shift = sign * (constant - bound.amount)
        ends = (shift, shift + sign * most)
        low, high = min(ends) - self._rho_high, max(ends) - self._rho_low
        members = [*present.tolist(), self._rho, column]
        values = np.append(np.full(len(present), sign), [-1.0, 0.0])
        down, up = min(low, 0.0), max(high + 1.0, 0.0)
        at_least, at_most = values.copy(), values.copy()
        at_least[-1], at_most[-1] = down, -up
        self._draft.rows(
            np.zeros(len(members)), members, at_least, lower=down - shift, upper=np.inf, kind="atom"
        )
        self._draft.rows(
            np.zeros(len(members)), members, at_most, lower=-np.inf, upper=-1.0 - shift, kind="atom"
        )
        return column

    def _all(self, parts: Sequence[int], node: Formula, step: int) -> int:
        """1 exactly when all parts are 1: `z <= each`, `z >= sum - (count - 1)`."""
        column = int(self._draft.columns(1, upper=1.0, integer=True)[0])
        self._tie((column, parts), (-np.inf, 0.0), (1.0 - len(parts), np.inf), (node, step))
        return column

    def _any(self, parts: Sequence[int], node: Formula, step: int) -> int:
        """1 exactly when some part is 1: `z >= each`, `z <= sum`."""
        column = int(self._draft.columns(1, upper=1.0, integer=True)[0])
        self._tie((column, parts), (0.0, np.inf), (-np.inf, 0.0), (node, step))
        return column

    def _tie(
        self,
        members: tuple[int, Sequence[int]],
        single: tuple[float, float],
        total: tuple[float, float],
        place: tuple[Formula, int],
    ) -> None:
        """Rows `single[0] <= z - part <= single[1]` and `total[0] <= z - sum <= total[1]`."""
        (column, parts), (node, step) = members, place
        count = len(parts)
        index = np.arange(count)
        self._draft.rows(
            np.concatenate([index, index]),
            np.concatenate([np.full(count, column), np.array(parts, dtype=np.int64)]),
            np.repeat([1.0, -1.0], count),
            lower=np.full(count, single[0]),
            upper=single[1],
            kind="logic",
            node=node,
            step=step,
        )
        values = [1.0, *([-1.0] * count)]
        self._draft.rows(
            np.zeros(count + 1),
            [column, *parts],
            values,
            lower=total[0],
            upper=total[1],
            kind="logic",
            node=node,
            step=step,
        )


def _latest(root: Formula) -> dict[Formula, int]:
    """Last step at which each sub-formula is needed for the root at step 0; -1: never."""
    order = list(walk(root))
    latest = dict.fromkeys(order, -1)
    latest[root] = 0
    for node in reversed(order):
        if latest[node] < 0:
            continue
        for child, shift in _reach(node):
            latest[child] = max(latest[child], latest[node] + shift)
    return latest


def _reach(node: Formula) -> list[tuple[Formula, int]]:
    """The children of a node, with how many steps after the node's own they are last needed."""
    if isinstance(node, Until | Release):
        before = [(node.left, node.high - 1)] if node.high > 0 else []
        return [*before, (node.right, node.high)]
    return [(child, getattr(node, "high", 0)) for child in node.children]
