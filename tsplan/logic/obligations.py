"""What has to hold when, so that a formula holds as it does, for all of its parts at once.

Which steps settle a part is told by `tsplan.logic.causes`, read on any values: on robustness, by
how many agents something holds; on earliness (`tsplan.logic.decision_time`), from which step on
nothing can undo it. What has to hold is asked of all parts of a conjunction even where it fails,
not only of the one that made it fail; where nobody says which it is to be, that part settles it.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple, TypeAlias

import numpy as np

from tsplan.logic.causes import NO_STEPS, Steps, Values, cause_of
from tsplan.logic.nodes import And, Formula, Iff, Implies, Not, Or
from tsplan.logic.time_horizon import Span, lookahead
from tsplan.logic.traversal import walk

Obligations: TypeAlias = "Mapping[tuple[Formula, bool | None], Obligation]"
"""Obligations by the formula and whether it has to hold."""


class Obligation(NamedTuple):
    """A formula has to hold, or to fail, at some steps.

    `holds` is None where it is whichever it is, as below `<=>`. `windows` are the spans of steps
    among which the steps could be chosen.
    """

    holds: bool | None
    steps: Steps
    windows: frozenset[Span] = frozenset({(0, 0)})


START = Obligation(True, np.zeros(1, dtype=np.int64))
"""A whole formula has to hold at step 0."""

JUDGED = Obligation(None, np.zeros(1, dtype=np.int64))
"""A whole formula is judged at step 0, whether it holds or fails."""


def obligations(
    formula: Formula, whole: Obligation, values: Mapping[Formula, Values]
) -> Obligations:
    """What is asked of every sub-formula, in the order of the text; that of equal ones together.

    The formula is without tasks and limits; `values` has those of each part at every step.
    """
    order = tuple(walk(formula))
    owed: dict[tuple[Formula, bool | None], Obligation] = {(formula, whole.holds): whole}
    for node in reversed(order):
        for one in [owed[key] for holds in (True, False, None) if (key := (node, holds)) in owed]:
            for child, more in zip(node.children, below(node, one, values), strict=True):
                key = child, more.holds
                owed[key] = _together(owed[key], more) if key in owed else more
    rank = {node: number for number, node in enumerate(order)}
    return dict(sorted(owed.items(), key=lambda item: rank[item[0][0]]))


def below(
    node: Formula, owed: Obligation, values: Mapping[Formula, Values]
) -> tuple[Obligation, ...]:
    """What an obligation of a node asks of each of its children."""
    if owed.holds is not None and isinstance(node, And if owed.holds else Or):
        wanted = tuple(owed.steps for _ in node.children)
    else:
        wanted = cause_of(node, owed.steps, values).below
    windows: list[set[Span]] = [set() for _ in node.children]
    for span in owed.windows:
        for found, (low, high) in zip(windows, lookahead(node), strict=True):
            if low <= high:
                found.add((span[0] + low, span[1] + high))
    return tuple(
        Obligation(holds, steps, frozenset(found))
        for holds, steps, found in zip(_signs(node, owed.holds), wanted, windows, strict=True)
    )


def _signs(node: Formula, holds: bool | None) -> tuple[bool | None, ...]:
    """Whether each child has to hold where a node has to."""
    turned = None if holds is None else not holds
    if isinstance(node, Not):
        return (turned,)
    if isinstance(node, Implies):
        return turned, holds
    if isinstance(node, Iff):
        return None, None
    return tuple(holds for _ in node.children)


def _together(one: Obligation, other: Obligation) -> Obligation:
    steps = np.union1d(one.steps, other.steps)
    return Obligation(one.holds, steps if steps.size else NO_STEPS, one.windows | other.windows)
