"""When the truth of a formula is certain, as a trace unfolds.

At step s the counts of steps 0..s are known and the future is open. A formula is decided at the
first step at which every future agrees about it: a task that has been staffed long enough, or a
window that has been missed, will not change any more.

Let t be the step from which a formula has been fulfilled whatever comes (infinity if never), and f
the step from which it has failed. Of a conjunction t is the latest of its parts' and f the
earliest; of a disjunction the other way round; negation exchanges the two. On the pair (-t, f)
these are minimum, maximum and a swap, which is how the evaluator reads robustness. So the
evaluator is used as it is, with pairs in the place of margins.

Certainty is found part by part: of `p || !p` it waits until p is decided.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from types import MappingProxyType
from typing import NamedTuple

import numpy as np

from tsplan.logic.atoms import Relation
from tsplan.logic.evaluate import Compare, CountTrace, Reading, value
from tsplan.logic.nodes import Formula
from tsplan.logic.traces import Floats, Values
from tsplan.logic.walking import walk


class Decided(NamedTuple):
    """When it is certain that a formula holds and that it fails, judged at each step.

    Both are arrays over the steps at which the formula is judged, in steps of the trace; one of
    the two is infinite at each of them.
    """

    fulfilled: Floats
    failed: Floats


def decided(formula: Formula, trace: CountTrace) -> dict[Formula, Decided]:
    """For every part of a formula of counts, when its truth is certain.

    The formula is free of tasks, limits and percentages (see `translate`, `resolve_percent`). A
    part reaches as far as the trace lets it be judged.

    >>> from tsplan.logic import parse
    >>> trace = CountTrace({None: np.array([[0, 1, 1, 0]])}, {"a": np.array([0])})
    >>> formula = parse("F[0,2] G[0,1] a", language="mtl")
    >>> decided(formula, trace)[formula].fulfilled
    array([2.])
    """
    certain = np.arange(trace.steps, dtype=np.float64)
    never = np.full(trace.steps, np.inf)
    reading = Reading(
        trace,
        true=np.stack([np.zeros(trace.steps), never]),
        false=np.stack([-never, np.zeros(trace.steps)]),
        compare={sign: partial(_read, test, certain) for sign, test in _TESTS.items()},
        negate=lambda pair: -pair[::-1],
    )
    values: dict[Formula, Values] = {}
    for node in walk(formula):
        below = tuple(values[child] for child in node.children)
        values[node] = value(node, below, reading)
    return {node: Decided(-pair[0], pair[1]) for node, pair in values.items()}


def _read(test: Compare, certain: Floats, counts: Values, bound: float) -> Values:
    """The pair of an atom: what a step's counts say is certain at that step."""
    held = test(counts, bound)
    return np.stack([np.where(held, -certain, -np.inf), np.where(held, np.inf, certain)])


_TESTS: Mapping[Relation, Compare] = MappingProxyType(
    {
        ">=": np.greater_equal,
        "<=": np.less_equal,
        ">": np.greater,
        "<": np.less,
        "=": np.equal,
        "!=": np.not_equal,
    }
)
