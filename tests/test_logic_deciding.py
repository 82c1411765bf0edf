"""When a formula is decided, and what is asked of the counts for it."""

from __future__ import annotations

import numpy as np
from hypothesis import given

from tests.seeds import quick, seeds
from tsplan.logic import TRUE, And, Count, CountTrace, holds, horizon, parse, walk
from tsplan.logic.decision_time import decided_at, earliness
from tsplan.logic.obligations import START, obligations
from tsplan.testing.formula_strategies import count_trace, formulas, judged


def counts_owed(formula, values):
    owed = obligations(formula, START, values)
    return {key: one for key, one in owed.items() if isinstance(key[0], Count)}


def spliced(known, other, step):
    """A trace that is `known` up to a step and `other` afterwards."""
    counts = {
        name: np.concatenate([array[..., : step + 1], other.counts[name][..., step + 1 :]], axis=-1)
        for name, array in known.counts.items()
    }
    return CountTrace(counts, known.labels)


@quick
@given(judged("mtl"))
def test_the_sign_is_the_truth(case):
    _, formula, trace = case
    early = earliness(formula, trace)
    for part in walk(formula):
        truth = holds(part, trace)
        assert ((early[part] >= 0)[: truth.size] == truth).all()


@quick
@given(judged("mtl", extra=0), seeds)
def test_no_future_undoes_what_is_decided(case, seed):
    _, formula, trace = case
    (step,) = decided_at(earliness(formula, trace)[formula], trace.steps - 1)
    assert 0 <= step < trace.steps
    (truth,) = holds(formula, trace)
    for shift in range(5):
        future = count_trace(seed + shift, trace.steps)
        assert holds(formula, spliced(trace, future, int(step)))[0] == truth


@quick
@given(formulas("mtl"), seeds)
def test_what_is_asked_settles_the_formula_then(formula, seed):
    """All counts asked for are as they have to be, the last of them when the whole is decided."""
    trace = count_trace(seed, horizon(formula) + 1)
    early = earliness(formula, trace)
    if not holds(formula, trace)[0]:
        return
    asked = counts_owed(formula, early)
    last = 0
    for (count, wanted), ask in asked.items():
        for step in ask.steps.tolist():
            last = max(last, step)
            assert any(low <= step <= high for low, high in ask.windows)
            if wanted is not None:
                assert holds(count, trace)[step] == wanted
    (step,) = decided_at(early[formula], trace.steps - 1)
    assert last == step


def test_a_task_is_decided_when_it_has_lasted():
    formula = parse("F[0,3] G[0,1] (sum(a) >= 2)", language="mtl")
    trace = CountTrace({None: np.array([[0, 2, 1, 2, 2]])}, {"a": np.array([0])})
    early = earliness(formula, trace)
    assert decided_at(early[formula], 4).tolist() == [4]
    trace = CountTrace({None: np.array([[0, 2, 1, 2, 1]])}, {"a": np.array([0])})
    early = earliness(formula, trace)
    assert early[formula][0] < 0
    assert decided_at(early[formula], 4).tolist() == [4]


def test_every_part_of_a_failing_conjunction_is_asked_for():
    formula = parse("F[0,2] (sum(a) >= 1) && F[0,1] (sum(a) >= 5) && G[0,2] (sum(a) <= 3)")
    trace = CountTrace({None: np.array([[0, 1, 1]])}, {"a": np.array([0])})
    asked = counts_owed(formula, earliness(formula, trace))
    steps = {str(count): ask.steps.tolist() for (count, _), ask in asked.items()}
    assert steps == {"a": [1], "sum(a) >= 5": [0, 1], "sum(a) <= 3": [0, 1, 2]}
    assert isinstance(formula, And)


def test_constants_are_decided_from_the_start():
    trace = count_trace(0, 4)
    assert decided_at(earliness(TRUE, trace)[TRUE], 3).tolist() == [0, 0, 0, 0]
    assert not any(isinstance(node, Count) for node in walk(TRUE))
