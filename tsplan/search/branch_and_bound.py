"""Branch and bound on the witnesses, with warm-started LPs.

A choice whose LP value is spread over several witnesses is split where half of its weight lies:
the witness comes early, or it comes late. Both halves cut the LP's solution off, unlike "this
witness or not", which leaves the rest of the choice as vague as before (branching on special
ordered sets: Beale and Tomlin, 1970). The choice split first is the one spread widest. Nodes are
taken best first, and below each the likelier half is followed as far as it leads: that finds
points, and its LPs differ little from one to the next.
"""

from __future__ import annotations

import heapq
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import count
from typing import NamedTuple, TypeAlias

import numpy as np

from tsplan.clock import Clock
from tsplan.milp.lp import LPResult, WarmLP
from tsplan.milp.model import Floats, Ints
from tsplan.milp.target import Target
from tsplan.search.dive import TOLERANCE, fractional

Fixed: TypeAlias = dict[int, float]


@dataclass(frozen=True, eq=False)
class Explored:
    """What the search knows at its end: the best point it found, and a bound on all points.

    The point may have parts of agents, and the bound is what linear programs say of it.
    """

    values: Floats | None
    bound: float
    done: bool


class _Node(NamedTuple):
    bound: float
    order: int
    fixed: Fixed


class BranchAndBound:
    """Branch and bound over the indicators of one model, for the least value of its target.

    `choices` are the groups of indicators that can be split; `root` is the LP's solution as it is.
    """

    def __init__(
        self,
        lp: WarmLP,
        indicators: Ints,
        choices: Sequence[Ints],
        target: Target,
        root: LPResult,
    ) -> None:
        self._lp = lp
        self._indicators = indicators
        self._choices = choices
        self._target = target
        self._fixed: Fixed = {}
        self._values: Floats | None = None
        self._value = np.inf
        self._leaf = np.inf  # the least program of a node whose witnesses were whole
        self._order = count(1)
        self._heap = [_Node(root.objective, 0, {})]
        self._deep: list[_Node] = []

    def run(
        self,
        clock: Clock,
        known: float = np.inf,
        *,
        first: bool = False,
        most: float = np.inf,
    ) -> Explored:
        """Search until the clock is over, from where the last run ended; restores the LP's bounds.

        Points that do not beat a `known` value are not looked for; `first` ends with any point. At
        `most` so many linear programs are solved.
        """
        self._value = min(self._value, known)
        heap, deep = self._heap, self._deep
        solved = 0
        while (heap or deep) and not (first and self._values is not None):
            if clock.over or solved >= most:
                break
            node = deep.pop() if deep else heapq.heappop(heap)
            if not self._promising(node.bound):
                continue
            result = self._solve(node.fixed, clock)
            solved += 1
            if result.status == "limit":
                heapq.heappush(heap, node)
                break
            children = [
                _Node(result.objective, next(self._order), fixed)
                for fixed in self._split(node, result)
            ]
            if children:
                deep.append(children.pop(0))
            for child in children:
                heapq.heappush(heap, child)
        self._move_to({})
        left = [node.bound for node in (*heap, *deep) if self._promising(node.bound)]
        bound = min([self._cutoff, self._leaf, *left])
        return Explored(self._values, bound, done=not left)

    @property
    def _cutoff(self) -> float:
        return np.inf if np.isinf(self._value) else self._target.cutoff(self._value)

    def _promising(self, bound: float) -> bool:
        """Whether a node with this bound can hold a point that is better by a whole step."""
        return bound <= self._cutoff

    def _split(self, node: _Node, result: LPResult) -> list[Fixed]:
        """The children of a node, the likelier one first; none if it is settled."""
        if result.status != "optimal" or not self._promising(result.objective):
            return []
        values = result.values
        assert values is not None
        open_ = fractional(values, self._indicators)
        if not len(open_):
            self._leaf = min(self._leaf, result.objective)
            # parts of agents may be better than whole ones: only the next whole value is at stake
            value = self._target.proven(result.objective)
            if self._values is None or value < self._value:
                self._values, self._value = values, min(value, self._value)
            return []
        group = self._widest(values)
        if group is None:
            column = int(open_[np.argmax(values[open_])])
            return [{**node.fixed, column: choice} for choice in (1.0, 0.0)]
        early, late = _halves(group, values)
        halves = [(late, early), (early, late)]
        if values[early].sum() < values[late].sum():
            halves.reverse()
        # the half that stays open is listed second: the other one is ruled out
        return [{**node.fixed, **dict.fromkeys(out.tolist(), 0.0)} for out, _ in halves]

    def _widest(self, values: Floats) -> Ints | None:
        """The group whose weight is spread widest over its steps."""
        widest, best = None, 0.0
        for group in self._choices:
            weight = values[group]
            total = weight.sum()
            if total <= TOLERANCE or weight.max() >= total - TOLERANCE:
                continue
            place = np.arange(len(group))
            spread = float(weight @ (place - weight @ place / total) ** 2)
            if spread > best:
                widest, best = group, spread
        return widest

    def _solve(self, fixed: Fixed, clock: Clock) -> LPResult:
        self._move_to(fixed)
        limit = None if np.isinf(self._value) else self._cutoff
        return self._lp.solve(time_limit=clock.left, cutoff=limit)

    def _move_to(self, fixed: Fixed) -> None:
        """Change only the bounds in which this node differs from the last one."""
        changes = {
            column: (fixed.get(column, 0.0), fixed.get(column, 1.0))
            for column in self._fixed.keys() | fixed.keys()
            if self._fixed.get(column) != fixed.get(column)
        }
        if changes:
            columns = np.array(list(changes), dtype=np.int64)
            bounds = np.array(list(changes.values()))
            self._lp.bounds(columns, bounds[:, 0], bounds[:, 1])
        self._fixed = fixed


def _halves(group: Ints, values: Floats) -> tuple[Ints, Ints]:
    """A group's early and late columns, each with some of its weight."""
    weight = np.cumsum(values[group])
    used = np.flatnonzero(values[group] > TOLERANCE)
    middle = int(np.searchsorted(weight, weight[-1] / 2))
    last_early = int(np.clip(middle, used[0], used[-1] - 1))
    return group[: last_early + 1], group[last_early + 1 :]
