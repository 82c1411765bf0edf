"""What has to hold when, so that a formula is fulfilled as early as the plan fulfils it.

This is `tsplan.logic.causes` read on how early things are certain instead of by how many agents
they hold, so that a part ticks off at the step from which nothing can undo it. Where a
conjunction fails, all of its parts are still asked for, not only the one that made it fail.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from tsplan.logic.atoms import Count
from tsplan.logic.causes import NO_STEPS, Span, Steps, cause_of, spans
from tsplan.logic.nodes import And, Formula, Iff, Implies, Not, Or
from tsplan.logic.traces import Floats
from tsplan.logic.traversal import walk


class Ask(NamedTuple):
    """A formula is asked to hold, or to fail, at some steps.

    `holds` is None below `<=>`, where it is neither. `windows` are the spans of steps among which
    the steps could be chosen.
    """

    holds: bool | None
    steps: Steps
    windows: frozenset[Span]


START = Ask(True, np.zeros(1, dtype=np.int64), frozenset({(0, 0)}))
"""What is asked of a mission's formula: to hold at step 0."""

Early = Mapping[Formula, Floats]


def below(node: Formula, ask: Ask, early: Early) -> tuple[Ask, ...]:
    """What a node asks of each of its children."""
    if (isinstance(node, And) and ask.holds is True) or (
        isinstance(node, Or) and ask.holds is False
    ):
        wanted = tuple(ask.steps for _ in node.children)
    else:
        wanted = cause_of(node, ask.steps, early).below
    windows: list[set[Span]] = [set() for _ in node.children]
    for span in ask.windows:
        for found, one in zip(windows, spans(node, span), strict=True):
            if one[0] <= one[1]:
                found.add(one)
    return tuple(
        Ask(holds, steps, frozenset(found))
        for holds, steps, found in zip(_signs(node, ask.holds), wanted, windows, strict=True)
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


def atoms(formula: Formula, ask: Ask, early: Early) -> dict[tuple[Count, bool | None], Ask]:
    """What is asked of every count below, in the order of the text; equal ones once."""
    asked: dict[tuple[Formula, bool | None], Ask] = {(formula, ask.holds): ask}
    found: dict[tuple[Count, bool | None], Ask] = {}
    order = tuple(walk(formula))
    for node in reversed(order):
        for holds in (True, False, None):
            one = asked.get((node, holds))
            if one is None:
                continue
            if isinstance(node, Count):
                found[node, holds] = one
            for child, more in zip(node.children, below(node, one, early), strict=True):
                key = child, more.holds
                asked[key] = _together(asked.get(key), more)
    rank = {node: number for number, node in enumerate(order)}
    return dict(sorted(found.items(), key=lambda item: rank[item[0][0]]))


def _together(one: Ask | None, other: Ask) -> Ask:
    if one is None:
        return other
    steps = np.union1d(one.steps, other.steps)
    return Ask(one.holds, steps if steps.size else NO_STEPS, one.windows | other.windows)
