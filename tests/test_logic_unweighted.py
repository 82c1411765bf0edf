"""Formulas without weights that mean what formulas with weights mean."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings

from tests.seeds import quick
from tests.test_logic_robustness import close, weighted
from tsplan.logic import (
    FALSE,
    TRUE,
    And,
    Or,
    Until,
    linear,
    parse,
    positive,
    robustness,
    task,
    walk,
)
from tsplan.logic.weights import unweighted

X, Y = linear({"x": 1}, ">=", 2), linear({"x": -1, "y": 2}, "<", 6)


def free(formula):
    """Whether no node has weights."""
    return all(getattr(node, "weights", None) is None for node in walk(formula))


@quick
@given(weighted())
def test_the_product_is_the_same_on_every_trace(case):
    formula, trace = case
    plain = unweighted(formula)
    assert free(plain)
    assert positive(plain) is plain
    assert close(robustness(plain, trace), robustness(formula, trace, "product"))


@quick
@given(weighted())
def test_normalised_weights_are_the_same_on_their_side(case):
    formula, trace = case
    values = robustness(formula, trace, "normalised")
    for satisfied, side in ((True, values >= 0), (False, values <= 0)):
        plain = unweighted(formula, "normalised", satisfied=satisfied)
        found = robustness(plain, trace)
        assert free(plain)
        assert close(found[side], values[side])
        apart = np.abs(values) > 1e-9  # from the border, where scaling rounds
        assert np.array_equal(np.sign(found)[apart], np.sign(values)[apart])


@pytest.mark.long
@settings(max_examples=3000, deadline=None)
@given(weighted())
def test_many_formulas(case):
    test_the_product_is_the_same_on_every_trace.hypothesis.inner_test(case)
    test_normalised_weights_are_the_same_on_their_side.hypothesis.inner_test(case)


@pytest.mark.parametrize(
    ("formula", "text"),
    [
        (And((X, Y), (3, 0.5)), "3*x >= 6 && 0.5*x - y > -3"),
        (Or((X, X & TRUE), (2, 4)), "2*x >= 4 || 4*x >= 8 && true"),
        (X.always(1, 4, (1, 1, 2, 2)), "G[1,2] (x >= 2) && G[3,4] (2*x >= 4)"),
        (X.eventually(0, 2, (1, 2, 1)), "F[0,0] (x >= 2) || F[1,1] (2*x >= 4) || F[2,2] (x >= 2)"),
        (X.eventually(0, 2, 2), "F[0,2] (2*x >= 4)"),
        (X.until(X, 0, 1, (3, 2)), "((x >= 2) U[0,0] (3*x >= 6)) || ((x >= 2) U[1,1] (2*x >= 4))"),
        (X.release(X, 1, 2, 2).always(0, 1, 2), "G[0,1] ((2*x >= 4) R[1,2] (4*x >= 8))"),
        (~And((X, FALSE), 3), "3*x < 6 || true"),
    ],
)
def test_by_hand(formula, text):
    assert str(unweighted(formula)) == text
    assert unweighted(formula) is parse(text, "stl")


def test_normalised_by_hand():
    both, single = And((X, X), (1, 3)), X.eventually(2, 2, 5)
    assert unweighted(both, "normalised") is parse("0.75*x >= 1.5 && 0.25*x >= 0.5", "stl")
    assert unweighted(both, "normalised", satisfied=False) is parse(
        "0.25*x >= 0.5 && 0.75*x >= 1.5", "stl"
    )
    for satisfied in (True, False):
        assert unweighted(single, "normalised", satisfied=satisfied) is parse(
            "F[2,2] (0.5*x >= 1)", "stl"
        )


def test_what_has_no_weights_is_its_normal_form():
    formula = parse("!(x >= 2 U[0,3] !(y < 1)) && G[1,2] x != 3", "stl")
    assert unweighted(formula) is positive(formula)
    assert unweighted(parse("a && F[0,2] !b")) is positive(parse("a && F[0,2] !b"))


def test_formulas_of_any_depth_and_shared_parts_stay_small():
    deep = X
    for depth in range(3000):
        deep = And((deep, Y), 1) if depth % 2 else deep.eventually(0, 1, (1, 1))
    assert len(list(walk(unweighted(deep)))) == len(list(walk(deep)))
    shared = X
    for _ in range(40):  # 2^40 ways from the root to the predicate, 41 products on them
        shared = Or((shared, shared), (1, 2))
    plain = unweighted(shared)
    assert sum(not node.children for node in walk(plain)) == 41
    assert robustness(plain, {"x": np.array([3.0])}) == [2.0**40]


def test_until_scales_its_right_side_alone():
    same = Until(0, 3, X, X, (2, 2, 2, 2))
    assert unweighted(same) is parse("(x >= 2) U[0,3] (2*x >= 4)", "stl")


def test_what_cannot_be_scaled():
    with pytest.raises(ValueError, match="counts agents"):
        unweighted(And((parse("a"), parse("b")), (1, 2)))
    with pytest.raises(ValueError, match="translate"):
        unweighted(And((task(1, "a", {"c": 1}), parse("b")), (1, 2)))
    lost = X
    for _ in range(40):
        lost = And((lost, Y), (1e-9, 1))
    with pytest.raises(ValueError, match=r"the way to 'x .*' multiply to .*scale the weights"):
        unweighted(lost)
