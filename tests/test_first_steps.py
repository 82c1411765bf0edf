"""What formulas ask for within their first steps."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from tests.seeds import quick
from tsplan.logic import horizon, labels, parse
from tsplan.logic.evaluation import CountTrace, holds
from tsplan.logic.first_steps import within
from tsplan.testing import formulas


@quick
@given(formulas("mtl"), st.integers(0, 6), st.integers(0, 2**32 - 1))
def test_it_is_weaker_and_looks_no_further(formula, last: int, seed: int) -> None:
    weaker = within(formula, last)
    assert horizon(weaker) <= last
    draw = np.random.default_rng(seed)
    steps = horizon(formula) + last + 1
    labels = {label: np.array([n]) for n, label in enumerate(("A", "B", "C", "D"))}
    counts = {n: draw.integers(0, 3, (8, 4, steps)) for n in (None, "c1", "c2", "c3")}
    named = {label: labels.get(label, np.array([0])) for label in _labels(formula)}
    trace = CountTrace(counts, named)
    strong, weak = holds(formula, trace)[..., 0], holds(weaker, trace)[..., 0]
    assert not (strong & ~weak).any()


def _labels(formula) -> set[str]:
    return set(labels(formula)) | {"A"}


def test_what_ends_in_time_is_asked_for_in_full() -> None:
    for text in ("F[0,3] a", "G[1,4] (a || F[0,1] b)", "a U[1,4] b", "a R[0,5] b"):
        formula = parse(text)
        assert within(formula, 5) == within(formula, 50)
        assert within(formula, 5) is not parse("true")


@quick
@given(st.data())
def test_changes_over_are_weakened(data) -> None:
    numbers = [data.draw(st.integers(0, most)) for most in (3, 4, 2, 2, 8)]
    low, more, left, right, last = numbers
    letter = data.draw(st.sampled_from("UR"))
    text = f"(F[0,{left}] p) {letter}[{low},{low + more}] (G[0,{right}] q)"
    formula = parse(text)
    weaker = within(formula, last)
    assert horizon(weaker) <= last
    draw = np.random.default_rng(data.draw(st.integers(0, 2**32 - 1)))
    share = draw.random((60, 1, 1))
    counts = (draw.random((60, 2, horizon(formula) + last + 1)) < share).astype(np.int64)
    trace = CountTrace({None: counts}, {"p": np.array([0]), "q": np.array([1])})
    assert not (holds(formula, trace)[..., 0] & ~holds(weaker, trace)[..., 0]).any()
