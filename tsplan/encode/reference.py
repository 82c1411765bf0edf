"""The reference encoding: plain, slow, and meant to be obviously right.

The full map, integer flows, one binary for every (sub-formula, step), tied to it in both
directions. `rho` is the availability asked for: the binary of an atom `f >= m` is 1 exactly when
`f - m >= rho`, that of `f <= m` when `m - f >= rho`. Of real numbers it may be both where they are
equal. Every M is the least that the bounds of the
row allow. The tight encoding is judged against this one.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import singledispatchmethod
from typing import Any

import numpy as np

from tsplan.encode.atom_encoders import AtomEncoder, Atoms
from tsplan.logic import Always, And, Constant, Eventually, Formula, Or, Release, Until, walk
from tsplan.milp.model import Draft


class ReferenceEncoder:
    """One 0/1 column for every (node, step) of a formula in positive normal form."""

    def __init__(self, draft: Draft, atoms: Atoms, rho: tuple[int, float, float]) -> None:
        self._draft = draft
        self._atoms = atoms
        self._rho, self._rho_low, self._rho_high = rho
        self._columns: dict[tuple[Formula, int], int] = {}
        self._bounds: dict[tuple[Any, int], int] = {}

    def encode(self, root: Formula) -> None:
        """Require the root at step 0."""
        latest = _latest(root)
        for node in walk(root):
            for step in range(latest[node] + 1):
                make = self._atom if node in self._atoms else self._column
                self._columns[node, step] = make(node, step)
        column = self._columns[root, 0]
        self._draft.rows([0], [column], 1.0, lower=1.0, upper=1.0, kind="root", node=root, step=0)

    def _atom(self, node: Formula, step: int) -> int:
        encoder, needed = self._atoms.of(node)
        parts = [self._bound(encoder, bound, step) for bound in needed.bounds]
        return self._all(parts, node, step) if needed.every else self._any(parts, node, step)

    @singledispatchmethod
    def _column(self, node: Formula, step: int) -> int:
        raise TypeError(f"no reference encoding is registered for {type(node).__name__}")

    @_column.register
    def _(self, node: Constant, step: int) -> int:
        fixed = float(node.value)
        return int(self._draft.columns(1, lower=fixed, upper=fixed, integer=True)[0])

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
        cases = self._cases(node, step)
        return self._any([self._all(case, node, step) for case in cases], node, step)

    @_column.register
    def _(self, node: Release, step: int) -> int:
        cases = self._cases(node, step)
        return self._all([self._any(case, node, step) for case in cases], node, step)

    def _cases(self, node: Until | Release, step: int) -> list[list[int]]:
        """For each step of the window the right side there and the left side at those before."""
        left = [self._columns[node.left, time] for time in range(step, step + node.high)]
        window = range(node.low, node.high + 1)
        return [[*left[:late], self._columns[node.right, step + late]] for late in window]

    def _bound(self, encoder: AtomEncoder, bound: Any, step: int) -> int:
        """1 exactly when the bound holds with `rho` to spare, by two rows with derived M."""
        if (bound, step) in self._bounds:
            return self._bounds[bound, step]
        column = int(self._draft.columns(1, upper=1.0, integer=True)[0])
        self._bounds[bound, step] = column
        members, factor, constant, low, high = encoder.slack(bound, step)
        # the column is 1 exactly when slack - rho >= 0, that is: when it is not -grain or less
        grain = encoder.grain
        spare = (0, members, factor), (0, self._rho, -1.0)
        down, up = min(low - self._rho_high, 0.0), max(high - self._rho_low + grain, 0.0)
        self._draft.sums(*spare, (0, column, down), lower=down - constant, kind="atom")
        self._draft.sums(
            *spare, (0, column, -up), lower=-np.inf, upper=-grain - constant, kind="atom"
        )
        return column

    def _all(self, parts: Sequence[int], node: Formula, step: int) -> int:
        """1 exactly when all parts are 1: `z <= each`, `z >= sum - (count - 1)`."""
        return self._tied(parts, (-np.inf, 0.0), (1.0 - len(parts), np.inf), (node, step))

    def _any(self, parts: Sequence[int], node: Formula, step: int) -> int:
        """1 exactly when some part is 1: `z >= each`, `z <= sum`."""
        return self._tied(parts, (0.0, np.inf), (-np.inf, 0.0), (node, step))

    def _tied(
        self,
        parts: Sequence[int],
        single: tuple[float, float],
        total: tuple[float, float],
        place: tuple[Formula, int],
    ) -> int:
        """A column z: `single[0] <= z - part <= single[1]`, `total[0] <= z - sum <= total[1]`."""
        column, count = int(self._draft.columns(1, upper=1.0, integer=True)[0]), len(parts)
        # one row for each part, and the last one for their sum
        index = np.concatenate([np.tile(np.arange(count), 2), np.full(count + 1, count)])
        members = [*[column] * count, *parts, column, *parts]
        values = np.repeat([1.0, -1.0, 1.0, -1.0], [count, count, 1, count])
        lower, upper = ([one] * count + [all_] for one, all_ in zip(single, total, strict=True))
        node, step = place
        self._draft.rows(
            index, members, values, lower=lower, upper=upper, kind="logic", node=node, step=step
        )
        return column


def _latest(root: Formula) -> dict[Formula, int]:
    """Last step at which each sub-formula is needed for the root at step 0; -1: never."""
    order = list(walk(root))
    latest = dict.fromkeys(order, -1)
    latest[root] = 0
    for node in reversed(order):
        for child, shift in _reach(node) if latest[node] >= 0 else ():
            latest[child] = max(latest[child], latest[node] + shift)
    return latest


def _reach(node: Formula) -> list[tuple[Formula, int]]:
    """The children of a node, with how many steps after the node's own they are last needed."""
    if isinstance(node, Until | Release):
        before = [(node.left, node.high - 1)] if node.high > 0 else []
        return [*before, (node.right, node.high)]
    return [(child, getattr(node, "high", 0)) for child in node.children]
