"""Weights on nodes: what they may be, what identity and operations make of them."""

import copy
import pickle
from fractions import Fraction

import numpy as np
import pytest

from tsplan import logic
from tsplan.logic import (
    TRUE,
    Always,
    And,
    Eventually,
    Or,
    Release,
    Until,
    linear,
    negation,
    parse,
    positive,
    simplify,
    translate,
)
from tsplan.logic.fraction import tree_of
from tsplan.logic.text import operator_text

A, B, C = (parse(name) for name in "abc")
BOTH = And((A, B), (0.2, 0.8))
SOON = Eventually(1, 3, A, (3, 2, 1))
CHANGE = Until(0, 1, A, B, (1, 4))


def test_what_has_no_weights_is_what_it_was():
    assert And((A, B), None) is And((A, B)) is A & B
    assert Eventually(1, 3, A, None) is A.eventually(1, 3)
    assert (A & B).parameters == ()
    assert A.until(B, 0, 2).parameters == (0, 2)
    assert (A & B).weights is None


def test_weights_belong_to_the_identity_and_are_floats():
    assert And((A, B), [Fraction(1, 5), np.float32(0.5)]) is And((A, B), (0.2, 0.5))
    assert Eventually(1, 3, A, np.array([3, 2, 1])) is SOON
    assert SOON.weights == (3.0, 2.0, 1.0)
    assert all(type(weight) is float for weight in SOON.weights)
    assert BOTH is not And((B, A), (0.2, 0.8))
    assert And((A, B), (1, 1)) is not And((A, B))
    for node in (BOTH, SOON, ~CHANGE, A.release(BOTH, 2, 2, 7)):
        assert copy.deepcopy(node) is node
        assert pickle.loads(pickle.dumps(node)) is node
        assert node.assembled(node.parameters, node.children) is node


def test_a_number_a_mapping_and_a_function_give_a_weight_for_each_index():
    assert A.always(2, 4, 0.5) is Always(2, 4, A, (0.5, 0.5, 0.5))
    assert A.until(B, 1, 2, {1: 3, 2: 4, 9: 1}) is Until(1, 2, A, B, (3, 4))
    assert A.release(B, 1, 2, lambda step: step * 10) is Release(1, 2, A, B, (10, 20))
    assert Or((A, B), lambda part: part + 1) is Or((A, B), (1, 2))


@pytest.mark.parametrize(
    ("weights", "message"),
    [
        ((1.0,), "1 weights are given for steps 1 to 3, 3 needed"),
        ((1, 2, 3, 4), "4 weights are given"),
        ((1, 0, 1), "the weight of step 2 is 0, which is no finite number above 0"),
        ((1, 1, -0.5), "step 3 is -0.5"),
        (float("inf"), "step 1 is inf"),
        ((1, float("nan"), 1), "step 2 is nan"),
        (10**400, "no finite number"),
        ({1: 1, 3: 1}, "no weight is given for step 2"),
        ({}, "no weight is given for step 1 and 2 more"),
    ],
)
def test_weights_that_are_none_are_refused(weights, message):
    with pytest.raises(ValueError, match=message):
        A.eventually(1, 3, weights)


@pytest.mark.parametrize("weights", ["abc", True, ("1", 1, 1), object()])
def test_weights_of_another_kind_are_refused(weights):
    with pytest.raises(TypeError, match="the weight of step 1 is no number"):
        A.eventually(1, 3, weights)


def test_printing_shows_them():
    assert str(BOTH) == "&&^[0.2, 0.8] (a, b)"
    assert str(~And((A | B, SOON, A), 2)) == "!&&^2 (a || b, F[1,3]^[3, 2, 1] a, a)"
    assert str(CHANGE & BOTH) == "(a U[0,1]^[1, 4] b) && &&^[0.2, 0.8] (a, b)"
    assert operator_text(BOTH) == "&&^[0.2, 0.8]"
    assert operator_text(CHANGE) == "U[0,1]^[1, 4]"


def test_negation_keeps_them_at_the_dual_operator():
    fails = (negation(A), negation(B))
    assert negation(BOTH) is Or(fails, (0.2, 0.8))
    assert negation(SOON) is Always(1, 3, fails[0], (3, 2, 1))
    assert negation(CHANGE) is Release(0, 1, *fails, (1, 4))
    assert negation(negation(BOTH)) is BOTH is positive(~~BOTH)
    assert tree_of(~~BOTH) is BOTH


def test_a_release_hands_them_to_what_holds_throughout():
    tree = tree_of(A.release(B, 1, 2, (5, 6)))
    assert tree.children[0] is B.always(1, 2, (5, 6))
    assert all(part.weights is None for part in tree.children[1:])


@pytest.mark.parametrize(
    "formula",
    [
        BOTH,
        And((A, A, TRUE), (1, 2, 3)),
        A & BOTH,
        Or((BOTH, A), (1, 2)),
        Or((Or((A, B)), Or((A, B), 3)), 1),
        A.eventually(0, 0, 2),
        TRUE.always(0, 1, 2),
        SOON.eventually(0, 2),
        A.eventually(0, 2).eventually(1, 3, 2),
        TRUE.until(B, 0, 1, 2),
        A.release(B, 0, 0, 2),
    ],
)
def test_simplifying_leaves_what_is_weighed(formula):
    assert simplify(formula) is formula


def test_simplifying_goes_on_below_and_beside_them():
    assert simplify(And((A & TRUE, ~~B), (1, 2))) is And((A, B), (1, 2))
    assert simplify(A & (B & (BOTH & TRUE))) is And((A, B, BOTH))
    assert simplify((A & TRUE).until(B, 0, 1, 3)) is A.until(B, 0, 1, 3)


def test_other_operations_keep_them():
    staffed = logic.task(1, "a", {"c": 1})
    assert translate(And((staffed, B), (1, 2))) is And((translate(staffed), B), (1, 2))
    assert logic.substitute(CHANGE, {A: C}) is C.until(B, 0, 1, (1, 4))
    assert logic.tighten(BOTH, lambda _: 9, lambda _: 1).weights == (0.2, 0.8)
    assert logic.horizon(SOON & CHANGE) == 3
    assert logic.labels(BOTH) == ("a", "b")


def test_truth_does_not_depend_on_them():
    x = linear({"x": 1}, ">=", 1)
    trace = logic.SignalTrace({"x": [0.0, 2.0, 1.0, 3.0]})
    for made in (x.eventually(0, 1, (1, 9)), x.always(1, 2, 4), x.until(x, 0, 2, 2)):
        bare = type(made).assembled(made.parameters[:2], made.children)
        assert logic.holds(made, trace).tolist() == logic.holds(bare, trace).tolist()
