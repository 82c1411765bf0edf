"""Branch and bound on the witnesses, with warm-started LPs.

A choice whose LP value is spread over several witnesses is split where half of its weight lies:
the witness comes early, or it comes late. Both halves cut the LP's solution off, unlike "this
witness or not", which leaves the rest of the choice as vague as before (branching on special
ordered sets: Beale and Tomlin, 1970). The choice split first is the one spread widest. Nodes are
taken best first, and below each the likelier half is followed as far as it leads: that finds
points, and its LPs differ little from one to the next.

Asked to, it goes on below whole witnesses and splits what is left of whole columns, until nothing
is left for a general solver to decide.
"""

from __future__ import annotations

import heapq
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import count
from typing import NamedTuple, TypeAlias

import numpy as np

from tsplan.clock import Clock
from tsplan.milp.exact_rows import Multipliers
from tsplan.milp.lp import LPResult, WarmLP
from tsplan.milp.model import Floats, Ints
from tsplan.milp.proof_tree import Branch, Leaf, Trail
from tsplan.milp.target import Target
from tsplan.search.dive import TOLERANCE, fractional

_HALF = 0.5

Fixed: TypeAlias = dict[int, tuple[float, float]]
Child: TypeAlias = tuple[Fixed, Branch]


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
    trail: Trail
    proof: Multipliers | None


class BranchAndBound:
    """Branch and bound over the indicators of one model, for the least value of its target.

    `choices` are the groups of indicators that can be split; `root` is the LP's solution as it is.
    `record` keeps what proves it all.
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
        self._heap = [_Node(root.objective, 0, {}, (), root.proof)]
        self._deep: list[_Node] = []
        self._closed: list[Leaf] = []
        self._further = indicators[:0]
        self._hear: Callable[[Floats], float] = lambda _: np.inf
        self.record = False

    def deepen(self, further: Ints, hear: Callable[[Floats], float]) -> None:
        """Split further columns where the witnesses are whole.

        `hear` is told of such points, and says what the best known one is worth.
        """
        self._further, self._hear = further, hear

    @property
    def leaves(self) -> tuple[Leaf, ...]:
        """All ends of the tree so far, open ones too; only if they are recorded."""
        return (*self._closed, *(Leaf(n.trail, n.proof) for n in (*self._heap, *self._deep)))

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
                self._close(node.trail, node.proof)
                continue
            result = self._solve(node.fixed, clock)
            solved += 1
            if result.status == "limit":
                heapq.heappush(heap, node)
                break
            known = result.status == "optimal"
            bound, proof = (result.objective, result.proof) if known else (node.bound, node.proof)
            children = [
                _Node(bound, next(self._order), fixed, (*node.trail, branch), proof)
                for fixed, branch in self._split(node, result)
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

    def _close(self, trail: Trail, proof: Multipliers | None) -> None:
        if self.record:
            self._closed.append(Leaf(trail, proof))

    def _split(self, node: _Node, result: LPResult) -> list[Child]:
        """The children of a node, the likelier one first; none if it is settled."""
        if result.status == "unproven":
            return self._blindly(node)
        if result.status != "optimal" or not self._promising(result.objective):
            self._close(node.trail, result.proof)
            return []
        values = result.values
        assert values is not None
        open_ = fractional(values, self._indicators)
        if not len(open_):
            return self._below_whole(node, result, values)
        group = self._widest(values)
        if group is None:
            column = int(open_[np.argmax(values[open_])])
            return self._by_column(node, column, 0)
        early, late = _halves(group, values)
        return self._by_halves(node, early, late, swapped=values[early].sum() < values[late].sum())

    def _below_whole(self, node: _Node, result: LPResult, values: Floats) -> list[Child]:
        """A node whose witnesses are whole: its children, if it is to be split further."""
        open_ = fractional(values, self._further)
        if len(open_):
            if not np.isin(self._further, [each.columns[0] for each in node.trail]).any():
                self._move_to({})
                self._value = min(self._value, self._hear(values))
            if not self._promising(result.objective):
                self._close(node.trail, result.proof)
                return []
            column = int(open_[np.argmin(np.abs(values[open_] % 1.0 - _HALF))])
            return self._by_column(node, column, int(np.floor(values[column])))
        self._close(node.trail, result.proof)
        self._leaf = min(self._leaf, result.objective)
        # parts of agents may be better than whole ones: only the next whole value is at stake
        value = self._target.proven(result.objective)
        if self._values is None or value < self._value:
            self._values, self._value = values, min(value, self._value)
        return []

    def _blindly(self, node: _Node) -> list[Child]:
        """Children of a node of which its program says nothing: what is open is halved."""
        for group in self._choices:
            left = np.array([column for column in group.tolist() if column not in node.fixed])
            if len(left) > 1:
                return self._by_halves(node, *np.split(left, [len(left) // 2]), swapped=False)
        for column in self._indicators.tolist():
            if column not in node.fixed:
                return self._by_column(node, column, 0)
        self._leaf = min(self._leaf, node.bound)
        self._close(node.trail, node.proof)
        return []

    def _by_column(self, node: _Node, column: int, most: int) -> list[Child]:
        """One column at most so much, or more; of witnesses one that is chosen comes first."""
        low, high = node.fixed.get(column, self._lp.span(column))
        below, above = Branch((column,), most, above=False), Branch((column,), most, above=True)
        return [
            ({**node.fixed, column: (most + 1.0, high)}, above),
            ({**node.fixed, column: (low, float(most))}, below),
        ]

    def _by_halves(self, node: _Node, early: Ints, late: Ints, *, swapped: bool) -> list[Child]:
        """A choice that comes early or late, the half of more weight first."""
        low, rest = tuple(early.tolist()), tuple(late.tolist())
        made = []
        for out, above in ((rest, True), (low, False)):
            fixed = {**node.fixed, **dict.fromkeys(out, (0.0, 0.0))}
            made.append((fixed, Branch(low, 0, above, rest)))
        return made[::-1] if swapped else made

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
            column: fixed.get(column, self._lp.span(column))
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
