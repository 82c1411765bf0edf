"""Proof trees as texts in the VIPR format.

A branching on a choice is one on the sum of its early columns: none of them, or one. As at most one
column of a choice is 1, which is derived first, the late ones are 0 in the second case.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from math import ceil

import numpy as np
from scipy import sparse

from tsplan.certificates.rows_of import KINDS, Limits, constraints_of
from tsplan.milp.exact_rows import ExactRows, Multipliers, defining_rows
from tsplan.milp.model import Floats, Tag
from tsplan.milp.proof_tree import Branch, Leaf, ProofTree


class UnprovenError(Exception):
    """A tree that does not prove what it is for, and why."""


def vipr_text(tree: ProofTree, comments: Sequence[str]) -> str:
    """The certificate of a tree, with comments at its head.

    Raises UnprovenError where the tree lacks something.
    """
    return _Writing(_with_used_cuts(tree)).text(comments)


def _with_used_cuts(tree: ProofTree) -> ProofTree:
    """The tree of a model that has only those cuts that something rests on."""
    model = tree.model
    rows = model.matrix.shape[0]
    given = [leaf.multipliers for leaf in tree.leaves if leaf.multipliers is not None]
    named = np.unique(np.concatenate([each.rows for each in given] or [np.arange(0)]))
    kept = np.union1d(np.arange(tree.added), named)
    place = np.full(rows, -1)
    place[kept] = np.arange(len(kept))
    kinds = {row: tag.kind for tag in model.tags for row in range(tag.start, tag.stop)}
    if unknown := {kinds[row] for row in kept[tree.added :].tolist()} - KINDS.keys():
        raise UnprovenError(f"it rests on {min(unknown)} cuts, which are not told from the mission")
    cuts = (Tag(kinds[int(kept[n])], n, n + 1) for n in range(tree.added, len(kept)))
    base = (tag for tag in model.tags if tag.start < tree.added)
    small = replace(
        model,
        matrix=sparse.csr_array(model.matrix[kept]),
        row_lower=model.row_lower[kept],
        row_upper=model.row_upper[kept],
        tags=(*base, *cuts),
    )
    leaves = tuple(
        leaf
        if leaf.multipliers is None
        else leaf._replace(multipliers=replace(leaf.multipliers, rows=place[leaf.multipliers.rows]))
        for leaf in tree.leaves
    )
    return replace(tree, model=small, leaves=leaves)


@dataclass
class _Bounds:
    """What holds at a node: constraints that bound single columns, and sums that are zero."""

    low: dict[int, tuple[int, int]] = field(default_factory=dict)
    high: dict[int, tuple[int, int]] = field(default_factory=dict)
    zero: list[tuple[int, tuple[int, ...]]] = field(default_factory=list)

    def copied(self) -> _Bounds:
        return _Bounds(dict(self.low), dict(self.high), list(self.zero))


class _Writing:
    """Writes the certificate of one tree."""

    def __init__(self, tree: ProofTree) -> None:
        self._tree = tree
        self._exact = ExactRows.of(tree.model)
        self._limits: Limits = constraints_of(tree.model, tree.added, refuted=tree.refuted)
        self._lines: list[str] = []
        self._implied: dict[int, int] = {}
        self._definitions = {column: (row, at) for column, row, at in defining_rows(tree.model)}
        self._choices: dict[tuple[int, ...], int] = {}

    def text(self, comments: Sequence[str]) -> str:
        tree, model = self._tree, self._tree.model
        columns = model.size.columns
        whole = np.flatnonzero(model.integer).tolist()
        priced = np.flatnonzero(model.objective).tolist()
        objective = [f"{j} {shown(Fraction(model.objective[j]))}" for j in priced]
        self._prove()
        least = "infeas" if tree.bound is None else f"range {shown(Fraction(tree.bound))} "
        value, point = self._solution()
        least += "" if tree.bound is None else value
        return "".join(
            f"{line}\n"
            for line in [
                *(f"% {comment}" for comment in comments),
                "VER 1.0",
                f"VAR {columns}",
                *(f"x{j}" for j in range(columns)),
                f"INT {len(whole)}",
                " ".join(map(str, whole)),
                "OBJ min",
                " ".join([str(len(priced)), *objective]),
                f"CON {len(self._limits.rows)} {self._limits.bounds}",
                *self._limits.lines(),
                f"RTP {least}",
                *point,
                f"DER {len(self._lines)}",
                *self._lines,
            ]
            if line
        )

    def _solution(self) -> tuple[str, list[str]]:
        """The value of the known point and the point, if it meets all rows exactly."""
        model, values = self._tree.model, self._tree.values
        if values is None or self._tree.bound is None:
            return "inf", ["SOL 0"]
        values = np.rint(values)
        if model.violation(values) > 0 or not self._exact.whole:
            return "inf", ["SOL 0"]
        some = np.flatnonzero(values).tolist()
        point = " ".join([str(len(some)), *(f"{j} {int(values[j])}" for j in some)])
        return str(int(model.objective @ values)), ["SOL 1", f"best {point}"]

    # --- derivations -----------------------------------------------------------------------------

    def _prove(self) -> None:
        tree = self._tree
        if tree.refuted:
            self._line("G 1 0", "lin", [(self._limits.refutation, 1)])
            return
        if not tree.leaves:
            raise UnprovenError("nothing was written down of what proves it")
        for choice, multipliers in sorted(tree.choices.items()):
            self._choices[choice] = self._at_most_one(choice, multipliers)
        self._node(tree.leaves, 0, _Bounds())

    def _node(self, leaves: Sequence[Leaf], depth: int, bounds: _Bounds) -> int:
        """Derive what is to be proven from the leaves below a node; where it stands."""
        first = leaves[0].trail
        if len(first) == depth:
            if len(leaves) > 1:
                raise UnprovenError("a node has an end and branchings")
            return self._leaf(leaves[0], bounds)
        branch = first[depth]
        ends, assumed = [], []
        for above in (False, True):
            side = branch._replace(above=above)
            mine = [leaf for leaf in leaves if leaf.trail[depth : depth + 1] == (side,)]
            if not mine:
                raise UnprovenError("one side of a branching is missing")
            assumed.append(self._assume(side))
            narrower = bounds.copied()
            self._narrow(narrower, side, assumed[-1])
            ends.append(self._node(mine, depth + 1, narrower))
        words = f"{ends[0]} {assumed[0]} {ends[1]} {assumed[1]}"
        return self._add(self._goal, f"uns {words}")

    @property
    def _goal(self) -> str:
        bound = self._tree.bound
        return "G 1 0" if bound is None else f"G {shown(Fraction(bound))} OBJ"

    def _assume(self, branch: Branch) -> int:
        terms = " ".join(f"{column} 1" for column in branch.columns)
        sense = f"G {branch.most + 1}" if branch.above else f"L {branch.most}"
        return self._add(f"{sense} {len(branch.columns)} {terms}", "asm")

    def _narrow(self, bounds: _Bounds, branch: Branch, assumed: int) -> None:
        """Take in what a branching says of columns."""
        if not branch.others:
            (column,) = branch.columns
            if branch.above:
                bounds.low[column] = branch.most + 1, assumed
            else:
                bounds.high[column] = branch.most, assumed
            return
        if not branch.above:
            bounds.zero.append((assumed, branch.columns))
            return
        if branch.choice not in self._choices:
            raise UnprovenError("it is not proven that a choice is one")
        terms = " ".join(f"{column} 1" for column in branch.others)
        pairs = [(self._choices[branch.choice], 1), (assumed, -1)]
        made = self._line(f"L 0 {len(branch.others)} {terms}", "lin", pairs)
        bounds.zero.append((made, branch.others))

    def _leaf(self, leaf: Leaf, bounds: _Bounds) -> int:
        if leaf.multipliers is None:
            raise UnprovenError("an end of the tree is open")
        value, pairs = self._summed(leaf.multipliers, bounds)
        if not leaf.multipliers.priced:
            if value <= 0:
                raise UnprovenError("an end of the tree is not refuted")
            return self._line("G 1 0", "lin", pairs)
        bound = self._tree.bound
        reached = ceil(value) if self._tree.whole else value
        if bound is None or reached < bound:
            raise UnprovenError("an end of the tree is worth less than the bound")
        return self._line(self._goal, "lin" if value >= bound else "rnd", pairs)

    def _at_most_one(self, choice: tuple[int, ...], multipliers: Multipliers) -> int:
        """At most one column of a choice is 1: minus their sum is bounded by the program."""
        model = self._tree.model
        costs = np.zeros(model.size.columns)
        costs[list(choice)] = -1.0
        value, pairs = self._summed(multipliers, _Bounds(), costs)
        if value <= -2:  # noqa: PLR2004  (two columns at once)
            raise UnprovenError("it is not proven that a choice is one")
        terms = " ".join(f"{column} 1" for column in choice)
        negated = [(index, -factor) for index, factor in pairs]
        return self._line(f"L 1 {len(choice)} {terms}", "lin" if value >= -1 else "rnd", negated)

    def _summed(
        self, given: Multipliers, bounds: _Bounds, costs: Floats | None = None
    ) -> tuple[Fraction, list[tuple[int, Fraction | int]]]:
        """What multipliers come to with the bounds of the columns, and all that is added up."""
        exact, model = self._exact, self._tree.model
        if costs is not None:
            exact = ExactRows(model.with_objective(costs), exact.most)
        reduced = exact.reduced(given)
        unit = 1 << (exact.digits + given.digits)
        left = {int(j): int(reduced[j]) for j in np.flatnonzero(reduced)}
        pairs: list[tuple[int, Fraction | int]] = []
        value = Fraction(0)
        for row, factor in given.fractions():
            index, side = self._limits.row(row, above=factor < 0)
            pairs.append((index, factor))
            value += factor * side
        for index, columns in bounds.zero:
            most = max([-left.get(column, 0) for column in columns], default=0)
            if most > 0:
                pairs.append((index, Fraction(-most, unit)))
                for column in columns:
                    left[column] = left.get(column, 0) + most
        for column, rest in sorted(left.items()):
            if rest:
                index, end = self._end(column, bounds, high=rest < 0)
                pairs.append((index, Fraction(rest, unit)))
                value += Fraction(rest, unit) * end
        return value, pairs

    def _end(self, column: int, bounds: _Bounds, *, high: bool) -> tuple[int, Fraction]:
        """The constraint that bounds a column, and its side."""
        known = (bounds.high if high else bounds.low).get(column)
        if known is not None:
            return known[1], Fraction(known[0])
        found = self._limits.bound(column, high=high)
        if found is not None:
            return found
        if not high or np.isinf(self._exact.most[column]):
            raise UnprovenError("a column has no bound")
        if column not in self._implied:
            self._implied[column] = self._imply(column)
        return self._implied[column], Fraction(self._exact.most[column])

    def _imply(self, column: int) -> int:
        """Derive the bound that an equation leaves a column."""
        row, at = self._definitions[column]
        matrix = self._tree.model.matrix
        own = int(matrix.data[at])
        pairs: list[tuple[int, Fraction | int]] = [(self._limits.row(row, above=False)[0], own)]
        for place in range(int(matrix.indptr[row]), int(matrix.indptr[row + 1])):
            if place != at:
                factor = -own * Fraction(float(matrix.data[place]))
                index, _ = self._end(int(matrix.indices[place]), _Bounds(), high=factor > 0)
                pairs.append((index, factor))
        most = shown(Fraction(self._exact.most[column]))
        return self._line(f"L {most} 1 {column} 1", "lin", pairs)

    # --- lines -----------------------------------------------------------------------------------

    def _line(self, row: str, kind: str, pairs: Iterable[tuple[int, Fraction | int]]) -> int:
        joined: dict[int, Fraction] = {}
        for index, factor in pairs:
            joined[index] = joined.get(index, Fraction(0)) + factor
        some = [f"{index} {shown(factor)}" for index, factor in joined.items() if factor]
        return self._add(row, " ".join([kind, str(len(some)), *some]))

    def _add(self, row: str, reason: str) -> int:
        index = len(self._limits.rows) + len(self._lines)
        self._lines.append(f"d{len(self._lines)} {row} {{ {reason} }} -1")
        return index


def shown(number: Fraction | int) -> str:
    """A number as a certificate has it."""
    return str(Fraction(number))
