"""Long and deep formulas: nothing recurses on nesting, nothing takes more than its length."""

import pickle
import sys
from itertools import product

import numpy as np
import pytest

from tests.seeds import sampled
from tsplan import logic
from tsplan.errors import FormulaError
from tsplan.logic import CountTrace, parse

DEPTH = 1200  # more than the stack of Python has room for

DEEP = {
    "parentheses": ("mtl", "(" * DEPTH + "a" + ")" * DEPTH),
    "numbers in parentheses": ("stl", "(" * DEPTH + "x" + ")" * DEPTH + " > 2"),
    "predicates in parentheses": ("stl", "(" * DEPTH + "x > 2" + ")" * DEPTH),
    "negations": ("mtl", "!" * DEPTH + "a"),
    "negations in parentheses": ("mtl", "!(" * DEPTH + "a" + ")" * DEPTH),
    "windows": ("mtl", "F[0,1] " * DEPTH + "a"),
    "alternating windows": ("mtl", "F[0,1] G[0,1] (" * (DEPTH // 2) + "a" + ")" * (DEPTH // 2)),
    "steps": ("mtl", "X " * DEPTH + "a"),
    "until to the right": ("mtl", "(a U[0,1] " * DEPTH + "b" + ")" * DEPTH),
    "until to the left": ("mtl", "(" * DEPTH + "a" + " U[0,1] b)" * DEPTH),
    "conjunctions": ("mtl", "(a && " * DEPTH + "b" + ")" * DEPTH),
    "equivalences": ("mtl", "(a <=> " * DEPTH + "b" + ")" * DEPTH),
    "weighted parts": ("wmtl", "&&^2 (a, " * DEPTH + "b" + ")" * DEPTH),
    "weighted parts to the left": ("wmtl", "||^[1, 3] (" * DEPTH + "b" + ", a)" * DEPTH),
    "weighted windows": ("wstl", "G[0,1]^[1, 3] " * DEPTH + "x > 1"),
    "signs": ("stl", "-" * DEPTH + "x > 2"),
}


QUICK = (
    "parentheses",
    "numbers in parentheses",
    "negations in parentheses",
    "windows",
    "steps",
    "conjunctions",
    "signs",
)


@pytest.mark.parametrize("name", sampled(DEEP, QUICK))
def test_deep_formulas_are_read_printed_and_transformed(name):
    language, text = DEEP[name]
    limit = sys.getrecursionlimit()
    formula = parse(text, language)
    assert parse(str(formula), language) is formula
    assert pickle.loads(pickle.dumps(formula)) is formula
    assert logic.horizon(formula) >= 0
    assert logic.simplify(logic.negation(formula)) is not formula
    assert logic.substitute(formula, {}) is formula
    assert sys.getrecursionlimit() == limit


WRONG = (
    "(" * DEPTH + "a",
    "a" + ")" * DEPTH,
    "sum(" * DEPTH + "a",
    "F[" * DEPTH,
    "{(" * DEPTH,
    ",(" * DEPTH,
    "T(1,a,{(" * DEPTH,
    "@" * DEPTH,
    "a, (" * DEPTH,
    "(a b) && " * 200 + "c",
    "(a => b && c) && " * 200 + "c",
)
EVERY = [*product(range(len(WRONG)), logic.LANGUAGES)]


# by default every other text, each in the next language
@pytest.mark.parametrize("one", sampled(EVERY, EVERY[:: 2 * len(logic.LANGUAGES) + 1]))
def test_wrong_texts_that_are_long_are_refused(one):
    number, language = one
    with pytest.raises(FormulaError):
        parse(WRONG[number], language)


def test_five_hundred_conjuncts_are_parsed():
    tasks = [
        f"F[0,{20 + place % 7}] T(1, green{place}, {{(IR,2),(Vis,2)}})" for place in range(500)
    ]
    parse("true", "catl")
    formula = parse(" && ".join(tasks), "catl")
    assert len(formula.children) == 500


def test_deep_formulas_are_evaluated():
    formula = parse("(a U[0,1] " * DEPTH + "b" + ")" * DEPTH)
    counts = np.ones((1, DEPTH + 3))
    trace = CountTrace({None: counts}, {"a": np.array([0]), "b": np.array([0])})
    assert logic.robustness(formula, trace).tolist() == [0.0, 0.0, 0.0]
    assert logic.holds(~formula, trace).tolist() == [False] * 3


def test_deeper_than_any_stack():
    formula, other = parse("a"), parse("b")
    for _ in range(20_000):
        formula = ~(formula & other)
    assert hash(formula) == hash(formula)
    assert len(str(formula)) > 100_000
    assert len(repr(formula)) < 300
    del formula


def test_shared_parts_are_evaluated_once():
    formula = parse("a")
    for _ in range(100):
        formula = (formula & parse("b")) | (formula & ~parse("b"))
    trace = CountTrace({None: np.array([[2, 0]])}, {"a": np.array([0]), "b": np.array([0])})
    assert logic.holds(formula, trace).tolist() == [True, False]
