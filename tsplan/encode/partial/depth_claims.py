"""Claims that parts of a formula hold, for the orders that count what holds by its depth.

A claim is an indicator of a pair (a place in the tree, a step): where it is 1 the sub-formula holds
at that step. Along the way from a claim to the root no other claim is made. Of all claims that a
plan allows, those at the topmost pairs that hold are lexicographically the best: claiming such a
pair in place of everything below it gains one at its own depth and loses only deeper ones. So one
direction suffices, and the best counts of claims are the best counts of pairs that hold while no
ancestor of theirs does. Below `or` and `F` nothing is claimed, since where such a child holds its
parent does.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from tsplan.encode.selection import SelectionColumns
from tsplan.encode.witness import Request
from tsplan.logic import Eventually, Formula, Or, positive
from tsplan.logic.witness_steps import Occurrence, reach
from tsplan.milp.model import INFINITY, Draft, Ints, Terms


@dataclass(frozen=True, eq=False)
class Claims:
    """The columns of the claims at each depth, and the duties they stand for."""

    by_depth: tuple[Ints, ...]
    requests: tuple[Request, ...]


def claim(
    everywhere: Sequence[Occurrence],
    deepest: int,
    choices: SelectionColumns,
    draft: Draft,
    possible: Callable[[Formula, int], bool],
) -> Claims:
    """Columns and rows for claims at the occurrences of a tree down to the depth `deepest`.

    `possible(node, step)` is False only where a node of the positive normal form holds in no plan.
    """
    by_depth: list[list[int]] = [[] for _ in range(deepest + 1)]
    requests: list[Request] = []
    covers: list[dict[int, tuple[int, ...]]] = []
    for occurrence in everywhere:
        if occurrence.depth > deepest:
            break
        above = _above(occurrence, everywhere, covers)
        node = positive(occurrence.node)
        made: dict[int, tuple[int, ...]] = {}
        for step in occurrence.steps:
            made[step] = above[step]
            if _claimable(occurrence, everywhere) and possible(node, step):
                column = int(choices.free([step])[0])
                by_depth[occurrence.depth].append(column)
                requests.append((node, step, (column,)))
                cover = _cover(column, above[step], draft, leaf=occurrence.depth == deepest)
                made[step] = (cover,)
        covers.append(made)
    columns = tuple(np.array(made, dtype=np.int64) for made in by_depth)
    return Claims(columns, tuple(requests))


def _claimable(occurrence: Occurrence, everywhere: Sequence[Occurrence]) -> bool:
    return occurrence.parent < 0 or not isinstance(
        everywhere[occurrence.parent].node, Or | Eventually
    )


def _above(
    occurrence: Occurrence,
    everywhere: Sequence[Occurrence],
    covers: Sequence[dict[int, tuple[int, ...]]],
) -> dict[int, tuple[int, ...]]:
    """For every step of a occurrence, columns of which one is 1 where some ancestor is claimed."""
    found: dict[int, dict[int, None]] = {step: {} for step in occurrence.steps}
    if occurrence.parent >= 0:
        parent = everywhere[occurrence.parent]
        for step in parent.steps:
            for later in reach(parent.node, occurrence.child, step):
                found[later].update(dict.fromkeys(covers[occurrence.parent][step]))
    return {step: tuple(columns) for step, columns in found.items()}


def _cover(column: int, above: Sequence[int], draft: Draft, *, leaf: bool) -> int:
    """A column that is 1 where a pair or an ancestor of it is claimed; never both are."""
    if not above:
        return column
    every = range(len(above))
    either: tuple[Terms, ...] = (every, above, 1.0), (every, column, 1.0)
    cover, total = column, 1.0
    if not leaf:
        cover, total = int(draft.columns(1, upper=1.0)[0]), 0.0
        either = (*either, (every, cover, -1.0))
    draft.sums(*either, lower=-INFINITY, upper=total, count=len(above), kind="claim")
    return cover
