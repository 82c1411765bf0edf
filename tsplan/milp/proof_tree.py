"""What proves a bound or a refutation: a tree of branchings, and multipliers at its ends."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import NamedTuple, TypeAlias

from tsplan.milp.exact_rows import Multipliers
from tsplan.milp.model import Floats, Model


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
    def choice(self) -> tuple[int, ...]:
        """All columns of a choice that is split, in order; none where a column is."""
        return tuple(sorted((*self.columns, *self.others))) if self.others else ()


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

    The leaves together are all of the tree. `whole` says that all points are worth whole numbers,
    `choices` why of the columns of each choice at most one is 1. Rows of the model from `added` on
    are cuts. `values` are a point of it. A tree without leaves is of what was `refuted` before.
    """

    model: Model
    bound: float | None
    whole: bool
    leaves: tuple[Leaf, ...]
    choices: Mapping[tuple[int, ...], Multipliers]
    added: int
    values: Floats | None = None
    refuted: bool = False


def choices_in(leaves: Iterable[Leaf]) -> set[tuple[int, ...]]:
    """The choices that were split."""
    return {branch.choice for leaf in leaves for branch in leaf.trail if branch.others}


@dataclass(frozen=True, eq=False)
class StageProof:
    """What one search proved: that among plans that keep something an `objective` is no less.

    `stage` is the objective the search was for, or another word while any plan is looked for;
    `kept` are objectives with the values that plans must not lose, as they are minimised. With
    `places` the model knows of swarms only where their groups are.
    """

    stage: str
    objective: str
    kept: tuple[tuple[str, float], ...]
    places: bool
    tree: ProofTree
