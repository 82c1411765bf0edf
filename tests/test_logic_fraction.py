"""How much of a formula holds: by hand, by its definition, and by its laws."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.seeds import quick
from tsplan import logic
from tsplan.logic import CountTrace, SignalTrace, parse, walk
from tsplan.logic.evaluation import holds, robustness
from tsplan.logic.fraction import (
    Share,
    denominator,
    fraction,
    portions,
    preference,
    shares,
    tree_of,
)
from tsplan.logic.witness_steps import demanded, is_settled, levels, parts, satisfied
from tsplan.testing.formula_strategies import judged, trace_for

X = SignalTrace({"x": np.array([1.0, 4, 2, 0, 5]), "y": np.array([0.0, 0, 3, 3, 0])})


def of(text: str, trace: SignalTrace = X) -> Fraction:
    return fraction(parse(text, "stl"), trace)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("x >= 1", "1"),
        ("x >= 2", "0"),
        ("x >= 1 && y >= 1", "1/2"),
        ("x >= 1 && y >= 1 && y >= 2", "1/3"),
        ("x >= 1 && (y >= 1 && y >= 2)", "1/2"),
        ("x >= 1 && x >= 1 && y >= 1", "2/3"),
        ("G[0,4] x >= 2", "3/5"),
        ("G[0,1] (x >= 2 && y >= 1)", "1/4"),
        ("F[0,3] (x >= 4 && y >= 3)", "1/2"),
        ("F[0,4] (x >= 4 && y >= 3 && x >= 0)", "2/3"),
        ("x >= 2 || y >= 1", "0"),
        ("(x >= 2 && x >= 0) || G[0,3] y >= 3", "1/2"),
        # the best switch is at step 3: right there, left at 1 and 2
        ("(x >= 2) U[0,3] (y >= 3)", "3/4"),
        ("(x >= 1) U[0,3] (y >= 3)", "1"),
        ("(x >= 9) U[0,3] (y >= 3)", "1/3"),
        ("(x >= 9) U[2,3] (y >= 9)", "0"),
        ("!(x >= 2 && y >= 1)", "1"),
        ("!(x >= 1 || y >= 0)", "0"),
        ("!(x >= 1 || y >= 1)", "1/2"),
        ("x >= 2 => y >= 1", "1"),
        ("x >= 1 <=> y >= 1", "1/2"),
        ("true && false", "1/2"),
        ("(x >= 4) R[0,4] (x >= 1)", "1"),
        # q throughout has 4/5, q until both has (1 + 1 + 1/2) / 3 with the switch at 2
        ("(x >= 9) R[0,4] (x >= 1)", "5/6"),
        ("all(x >= 1, y >= 1)", "0"),
        ("all(x >= 1, y >= 0) && x >= 2", "1/2"),
        ("all[0,4] x >= 2 && G[0,4] x >= 2", "3/10"),
        ("F[0,3] all(x >= 4, y >= 3) || F[0,3] (x >= 4 && y >= 3)", "1/2"),
        ("G[0,3] all[0,1] x >= 1", "1/2"),
        ("!(G[0,4] x < 2 && F[0,4] x < 0)", "1"),
        ("!(F[0,4] x < 2 && F[0,4] x < 1)", "4/5"),
        ("!all(F[0,4] x < 2, F[0,4] x < 1)", "0"),
        # before the window the left side alone is enough
        ("(x >= 4) R[2,4] (x >= 9)", "1"),
    ],
)
def test_by_hand(text, expected):
    assert of(text) == Fraction(expected)


def test_tasks_are_their_trees():
    counts = CountTrace(
        {None: np.array([[1, 2, 2, 0]]), "c": np.array([[0, 1, 1, 0]])}, {"a": np.array([0])}
    )
    task = parse("T(2, a, {(c,1),(d,1)})", "catl")
    assert fraction(task, counts) == Fraction(1, 3)
    assert fraction(task, counts, "half-open") == Fraction(1, 4)
    assert fraction(parse("F[0,1] T(1, a, {(c,1)})", "catl"), counts) == 1
    assert fraction(parse("sum(a) = 2", "mtl"), counts) == 0
    assert fraction(parse("!(sum(a) = 2)", "mtl"), counts) == 1
    assert fraction(parse("sum(a) != 1", "mtl"), counts) == 0


def test_what_cannot_be_judged():
    with pytest.raises(ValueError, match="too short"):
        of("G[0,9] x >= 1")
    batch = SignalTrace({"x": np.zeros((2, 3))})
    with pytest.raises(ValueError, match="batch"):
        fraction(parse("x >= 1", "stl"), batch)
    with pytest.raises(ValueError, match="tree_of"):
        shares(parse("!(a && b)"), CountTrace({None: np.ones((1, 1))}, {"a": [0], "b": [0]}))


def test_the_spare_is_that_of_what_holds():
    tree = tree_of(parse("G[0,1] x >= 1 && y >= 1", "stl"))
    assert shares(tree, X)[tree][0] == Share(Fraction(1, 2), 0.0)
    assert shares(tree, X)[tree][1] == Share(Fraction(1, 2), 1.0)


def test_the_parts_and_when():
    tree = tree_of(parse("F[0,3] G[0,1] y >= 3 && (x >= 4 || x >= 1) && y >= 1", "stl"))
    found = [
        (str(part.node), part.depth, part.first, part.last, part.fraction, part.counted)
        for part in parts(tree, X)
    ]
    assert found[1:] == [
        ("F[0,3] G[0,1] (y >= 3)", 1, 2, 3, 1, True),
        ("G[0,1] (y >= 3)", 2, 2, 3, 1, True),
        ("y >= 3", 3, 2, 3, 1, True),
        ("x >= 4 || x >= 1", 1, 0, 0, 1, True),
        ("x >= 4", 2, 0, 0, 0, False),
        ("x >= 1", 2, 0, 0, 1, True),
        ("y >= 1", 1, 0, 0, 0, True),
    ]
    assert found[0][4] == Fraction(2, 3)
    assert [(str(node), step) for node, step in satisfied(tree, X)] == [
        ("x >= 4 || x >= 1", 0),
        ("F[0,3] G[0,1] (y >= 3)", 0),
    ]


def test_what_counts_as_a_whole_is_one_part():
    tree = tree_of(parse("G[0,1] all[0,1] F[0,1] x >= 4 && all(x >= 1, y >= 1) && y >= 0", "stl"))
    found = [
        (str(part.node), part.depth, part.first, part.last, part.fraction)
        for part in parts(tree, X)
    ]
    assert found[1:] == [
        ("G[0,1] all[0,1] F[0,1] (x >= 4)", 1, 0, 3, Fraction(1, 2)),
        ("all[0,1] F[0,1] (x >= 4)", 2, 0, 3, Fraction(1, 2)),
        ("all(x >= 1, y >= 1)", 1, 0, 0, 0),
        ("y >= 0", 1, 0, 0, 1),
    ]
    assert levels(tree, X).counts == (0, 1, 1)
    assert [str(node) for node, _ in satisfied(tree, X)][-1] == "all[0,1] F[0,1] (x >= 4)"
    weighted = parse("all(x >= 1 &&^[1, 2] y >= 1, F[0,1]^3 x >= 1) &&^2 y >= 1", "wstl")
    assert str(tree_of(weighted)) == "&&^2 (all(x >= 1 && y >= 1, F[0,1] (x >= 1)), y >= 1)"


def test_depths_count_what_no_ancestor_covers():
    tree = tree_of(parse("G[0,2] (x >= 1 && y >= 3) && F[0,3] x >= 9 && x >= 1", "stl"))
    # depth 1: x >= 1 alone; depth 2: the and at step 2; depth 3: x >= 1 at steps 0 and 1
    found = levels(tree, X)
    assert found.counts == (0, 1, 1, 2)
    whole = tree_of(parse("G[0,2] x >= 1 && y >= 0", "stl"))
    assert levels(whole, X).counts == (1, 0, 0)


def test_the_same_formula_counts_at_each_of_its_places():
    tree = tree_of(parse("x >= 1 && x >= 1 && x >= 9", "stl"))
    assert levels(tree, X).counts == (0, 2)
    both = tree_of(parse("((x >= 1) U[1,2] (x >= 1)) && x >= 9", "stl"))
    assert levels(both, X).counts == (0, 1, 0)


@quick
@given(judged("mtl"))
def test_a_formula_holds_exactly_where_its_fraction_is_one(case):
    _, formula, trace = case
    tree = tree_of(formula)
    for step, share in enumerate(shares(tree, trace)[tree]):
        assert 0 <= share.fraction <= 1
        assert (share.fraction == 1) == bool(holds(formula, trace)[step])
        assert share.fraction * denominator(tree) % 1 == 0
        if share.fraction == 1:
            assert share.spare == robustness(formula, trace)[step]


@quick
@given(judged("mtl"))
def test_what_is_satisfied_keeps_its_fraction_when_it_is_demanded(case):
    _, formula, trace = case
    tree = tree_of(formula)
    for found in (satisfied(tree, trace), levels(tree, trace).pairs):
        assert holds(demanded(found), trace)[0]
    assert parts(tree, trace)[0].fraction == shares(tree, trace)[tree][0].fraction
    counts = levels(tree, trace).counts
    assert counts[0] == bool(holds(formula, trace)[0])
    assert not (counts[0] and any(counts[1:]))


def definition(node: logic.Formula, step: int, trace: CountTrace, weighted: bool) -> Fraction:
    """The fraction as it is defined, step by step and without any sharing."""
    if not node.children or isinstance(node, logic.Whole):
        return Fraction(int(holds(node, trace)[step]))
    below = [lambda k, c=child: definition(c, k, trace, weighted) for child in node.children]
    if isinstance(node, logic.And | logic.Or):
        values = [part(step) for part in below]
    else:
        window = range(step + node.low, step + node.high + 1)
        values = [below[-1](k) for k in window]
    if isinstance(node, logic.Until):
        for place, s in enumerate(window):
            before = sum((below[0](k) for k in range(step, s)), Fraction(0))
            values[place] = (values[place] + before) / (s - step + 1)
    given = node.weights if weighted and node.weights else [1] * len(values)
    weights = [Fraction(str(weight)) for weight in given]
    pairs = [weight * value for weight, value in zip(weights, values, strict=True)]
    if isinstance(node, logic.And | logic.Always):
        return sum(pairs, Fraction(0)) / sum(weights)
    return max(pairs) / max(weights)


@quick
@given(judged("wmtl"))
def test_fractions_are_as_defined(case):
    _, formula, trace = case
    tree = tree_of(formula)
    for weighted in (False, True):
        found = shares(tree, trace, weighted=weighted)[tree][0].fraction
        assert found == definition(tree, 0, trace, weighted)
        assert found == fraction(formula, trace, weighted=weighted)
    assert found * denominator(tree) % 1 == 0
    assert preference(tree, trace) in (None, found)


@quick
@given(judged("wmtl"))
def test_preference_and_fraction_agree_at_their_ends(case):
    _, formula, trace = case
    tree = tree_of(formula)
    plain, preferred = (
        shares(tree, trace, weighted=weighted)[tree][0].fraction for weighted in (False, True)
    )
    assert 0 <= preferred <= 1
    assert (preferred == 0) == (plain == 0)
    if preferred == 1:
        assert plain == 1
    if is_settled(tree):
        assert (preferred == 1) == (plain == 1) == bool(holds(formula, trace)[0])
    if not any(isinstance(node, logic.And | logic.Always | logic.Until) for node in walk(tree)):
        assert preferred <= plain


@quick
@given(judged("mtl"), st.sampled_from([0.3, 2.0]))
def test_equal_weights_prefer_nothing(case, weight):
    _, formula, trace = case
    tree = logic.fold(tree_of(formula), lambda node, below: evenly(node, below, weight))
    assert fraction(tree, trace, weighted=True) == fraction(formula, trace)
    assert is_settled(tree)


def evenly(node, below, weight):
    made = node.over(below)
    return replace(made, weights=weight) if hasattr(made, "weights") else made


@quick
@given(judged("wmtl"))
def test_what_is_satisfied_keeps_its_preference_when_it_is_demanded(case):
    """Also on other traces: only then is it worth as much in every plan."""
    _, formula, trace = case
    tree = tree_of(formula)
    wanted = demanded(satisfied(tree, trace))
    assert holds(wanted, trace)[0]
    least = fraction(formula, trace, weighted=True)
    for seed in range(3):
        other = trace_for("mtl", formula, seed)
        if holds(wanted, other)[0]:
            assert fraction(formula, other, weighted=True) >= least


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("||^[0.4, 0.6] (x >= 1, x >= 2)", "2/3"),  # whose fraction is 1
        ("||^[0.4, 0.6] (x >= 2, x >= 1)", "1"),
        ("&&^[0.1, 0.2, 0.3] (x >= 1, x >= 2, x >= 1)", "2/3"),
        ("G[0,1]^[1, 3] (x >= 2)", "3/4"),
        ("F[0,4]^[1, 2, 3, 4, 5] (y >= 3)", "4/5"),
        ("F[0,4]^[5, 4, 3, 2, 1] (y >= 3 && x >= 2)", "3/5"),  # both hold at step 2 alone
        # change over at 2: 2/3 of 1/4, at 3: 3/4 of 1, since y >= 3 at both
        ("(x >= 2) U[2,3]^[1, 4] (y >= 3)", "3/4"),
        ("(x >= 2) U[2,3]^[4, 1] (y >= 3)", "2/3"),
        ("!&&^[1, 4] (x >= 2, x >= 1)", "1/4"),
    ],
)
def test_preferences_by_hand(text, expected):
    assert fraction(parse(text, "wstl"), X, weighted=True) == Fraction(expected)


def test_portions_are_those_of_the_written_numbers():
    assert portions(parse("a ||^[0.1, 0.3] b", "wmtl")) == (Fraction(1, 3), 1)
    assert portions(parse("a &&^[0.1, 0.2] b", "wmtl")) == (Fraction(1, 3), Fraction(2, 3))
    assert portions(parse("a U[1,2]^0.7 b", "wmtl")) == (1, 1)
    assert portions(parse("G[1,4]^[1, 1, 1, 7] b", "wmtl"), weighted=False) == (Fraction(1, 4),) * 4
    assert preference(parse("a"), CountTrace({None: np.ones((1, 1))}, {"a": [0]})) is None


@quick
@given(judged("mtl"), st.data())
def test_more_atoms_never_give_less(case, data):
    """Making an atom true where it was false raises the fraction or keeps it."""
    _, formula, trace = case
    tree = tree_of(formula)
    atoms = [node for node in logic.walk(tree) if isinstance(node, logic.Count)]
    if not atoms:
        return
    exchanged = {data.draw(st.sampled_from(atoms)): logic.TRUE}
    easier = logic.substitute(tree, exchanged)
    assert shares(easier, trace)[easier][0].fraction >= shares(tree, trace)[tree][0].fraction
