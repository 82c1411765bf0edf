"""How much of a formula holds: by hand, by its definition, and by its laws."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tsplan import logic
from tsplan.logic import CountTrace, SignalTrace, parse
from tsplan.logic.evaluation import holds, robustness
from tsplan.logic.fraction import Share, denominator, fraction, shares, tree_of
from tsplan.logic.witness_steps import demanded, levels, parts, satisfied
from tsplan.testing.formula_strategies import judged

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


def definition(node: logic.Formula, step: int, trace: CountTrace) -> Fraction:
    """The fraction as it is defined, step by step and without any sharing."""
    if not node.children:
        return Fraction(int(holds(node, trace)[step]))
    below = [lambda k, c=child: definition(c, k, trace) for child in node.children]
    if isinstance(node, logic.And):
        return sum((part(step) for part in below), Fraction(0)) / len(below)
    if isinstance(node, logic.Or):
        return max(part(step) for part in below)
    window = range(step + node.low, step + node.high + 1)
    if isinstance(node, logic.Always):
        return sum((below[0](k) for k in window), Fraction(0)) / len(window)
    if isinstance(node, logic.Eventually):
        return max(below[0](k) for k in window)
    assert isinstance(node, logic.Until)
    left, right = below
    return max(
        (right(s) + sum((left(k) for k in range(step, s)), Fraction(0))) / (s - step + 1)
        for s in window
    )


@given(judged("mtl"))
def test_fractions_are_as_defined(case):
    _, formula, trace = case
    tree = tree_of(formula)
    assert shares(tree, trace)[tree][0].fraction == definition(tree, 0, trace)


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
