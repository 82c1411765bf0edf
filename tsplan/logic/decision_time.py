"""When the truth of a formula is certain, as a trace unfolds.

At step s the counts or signals of steps 0..s are known and the future is open. A formula is decided
at the first step at which every future agrees about it: a task that has been staffed long enough,
or a window that has been missed, will not change any more.

With `last` the last step of the trace, a formula that is certain to hold from step s on has the
earliness last - s, one that is certain to fail s - last - 1: the sign tells the truth, the size how
early it was known. Then a conjunction has the least earliness of its parts (it holds with the
latest of them and fails with the first), a disjunction the greatest, and the negation of e is
-e - 1. These are the rules of availability, so the evaluator is used as it is, and whatever reads
margins can read earliness.

Certainty is found part by part: of `p || !p` it waits until p is decided.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial

import numpy as np

from tsplan.logic.evaluation import TRUTH, Compare, Reading, values_of
from tsplan.logic.nodes import Formula
from tsplan.logic.traces import Floats, Trace, Values


def earliness(formula: Formula, trace: Trace) -> Mapping[Formula, Floats]:
    """For every part of a formula, at each step, how early its truth is certain.

    The formula is free of tasks, limits and percentages (see `translate`, `resolve_percent`).
    `decided_at` makes steps of what is returned.

    >>> from tsplan.logic import CountTrace, parse
    >>> trace = CountTrace({None: np.array([[0, 1, 1, 0]])}, {"a": np.array([0])})
    >>> formula = parse("F[0,2] G[0,1] a", language="mtl")
    >>> early = earliness(formula, trace)[formula]
    >>> early, decided_at(early, 3)
    (array([1.]), array([2.]))
    """
    certain = np.arange(trace.steps - 1.0, -1.0, -1.0, dtype=np.float64)
    known = np.full(trace.steps, trace.steps - 1.0)
    reading = Reading(
        trace,
        true=known,
        false=_negated(known),
        compare={sign: partial(_read, test, certain) for sign, test in TRUTH.items()},
        negate=_negated,
        measures=False,
    )
    return values_of(formula, reading)


def decided_at(early: Floats, last: int) -> Floats:
    """The step from which each truth is certain, on a trace that ends at step `last`."""
    return last - np.where(early >= 0, early, _negated(early))


def _negated(early: Values) -> Values:
    return -early - 1.0


def _read(test: Compare, certain: Floats, counts: Values, bound: float) -> Values:
    """The earliness of an atom: what a step's counts say is certain at that step."""
    return np.where(test(counts, bound), certain, _negated(certain))
