"""What proves a bound or a refutation: a tree of branchings, and multipliers at its ends."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import NamedTuple, TypeAlias

from tsplan.milp.exact_rows import Multipliers
from tsplan.milp.model import Model


class Branch(NamedTuple):
    """One side of a branching: the sum of whole `columns` is at most `most`, or, `above`, more.

    Where it is more and `others` are named, these are 0: with `columns` they are a choice, of which
    at most one is 1.
    """

    columns: tuple[int, ...]
    most: int
    above: bool
    others: tuple[int, ...] = ()

    @property
    def sibling(self) -> Branch:
        """The other side."""
        return self._replace(above=not self.above)


Trail: TypeAlias = tuple[Branch, ...]


class Leaf(NamedTuple):
    """An end of a tree: the branchings from the root on, and what is known there.

    None for the multipliers is the end of an open node of which nothing is.
    """

    trail: Trail
    multipliers: Multipliers | None


@dataclass(frozen=True, eq=False)
class ProofTree:
    """That no point of a model is worth less than `bound`, or, with None, that there is none.

    The leaves together are all of the tree. `whole` says that all points are worth whole numbers.
    """

    model: Model
    bound: float | None
    whole: bool
    leaves: tuple[Leaf, ...]


def choices_in(leaves: Iterable[Leaf]) -> set[tuple[int, ...]]:
    """The choices that were split, as sorted columns."""
    branches = (branch for leaf in leaves for branch in leaf.trail)
    return {tuple(sorted((*each.columns, *each.others))) for each in branches if each.others}
