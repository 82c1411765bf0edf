"""Exactly one, and all as a whole: what they stand for, and where their parts are written."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.seeds import quick, seeds
from tsplan import logic
from tsplan.errors import FormulaError
from tsplan.logic import (
    And,
    conjunction,
    derived,
    disjunction,
    holds,
    parse,
    parse_with_places,
    positive,
    robustness,
)
from tsplan.logic.evaluation import KINDS
from tsplan.testing.formula_strategies import formulas, trace_for

COUNTED = {
    "one": lambda number, _: number == 1,
    "all": lambda number, most: number == most,
}

words = st.sampled_from(["one", "all"])
several = st.lists(formulas("stl", leaves=2), min_size=2, max_size=6)


def judged(*made, seed):
    """Whether formulas hold at the first steps of a trace that is long enough, and how well."""
    trace = trace_for("stl", conjunction(made), seed)
    steps = trace.steps - logic.horizon(conjunction(made))
    return tuple([judge(one, trace)[:steps] for one in made] for judge in (holds, robustness))


@quick
@given(words, several, seeds)
def test_over_parts_they_count_what_holds(word, parts, seed):
    made = derived.stands_for(word, parts)
    truth, _ = judged(made, *parts, seed=seed)
    number = np.sum(truth[1:], axis=0)
    assert np.array_equal(truth[0], COUNTED[word](number, len(parts)))


@quick
@given(several, seeds)
def test_one_is_as_robust_as_its_best_choice(parts, seed):
    choices = [
        conjunction(part if n == chosen else ~part for n, part in enumerate(parts))
        for chosen in range(len(parts))
    ]
    _, values = judged(derived.one_of(parts), disjunction(choices), seed=seed)
    assert np.array_equal(*values)


@quick
@given(formulas("stl", leaves=2), st.integers(0, 2), st.integers(0, 4), seeds)
def test_one_step_is_as_robust_as_its_best_choice(child, low, length, seed):
    window = range(low, low + length + 1)
    choices = [
        conjunction((child if n == chosen else ~child).eventually(n, n) for n in window)
        for chosen in window
    ]
    made = derived.one_step(low, low + length, child)
    _, values = judged(made, disjunction(choices), seed=seed)
    assert np.array_equal(*values)


@quick
@given(several, st.integers(0, 2), st.integers(0, 3), st.sampled_from(KINDS), seeds)
def test_all_is_as_robust_as_and_in_every_kind(parts, low, length, kind, seed):
    pairs = [
        (derived.all_of(parts), And(tuple(parts))),
        (derived.all_steps(low, low + length, parts[0]), parts[0].always(low, low + length)),
    ]
    for whole, plain in pairs:
        trace = trace_for("stl", plain, seed)
        bounds = dict.fromkeys("xyz", (-5, 5))
        for sign in (lambda node: node, lambda node: ~node):
            one, other = (robustness(sign(made), trace, kind, bounds) for made in (whole, plain))
            assert np.array_equal(one, other)
        assert positive(whole) is positive(plain)
        assert logic.negation(whole) is logic.negation(plain)


def test_what_is_simplified_counts_as_it_did():
    for text, simple in [
        ("all(all(a, b)) && (c && true)", "all(a, b) && c"),
        ("all(a) && all(true)", "a"),
        ("b && all(b && true, a && b)", "b && all(b, a)"),
        ("G[0,1] all[0,1] a", "G[0,1] all[0,1] a"),
    ]:
        assert str(logic.simplify(parse(text))) == simple


@quick
@given(words, formulas("stl", leaves=2), st.integers(0, 2), st.integers(0, 5), seeds)
def test_over_steps_they_are_those_of_the_steps(word, child, low, length, seed):
    steps = [child.eventually(step, step) for step in range(low, low + length + 1)]
    over = derived.stands_for(word, [child], (low, low + length))
    if not length:
        steps = [*steps, logic.FALSE] if word == "one" else [*steps, *steps]
    truth, values = judged(over, derived.stands_for(word, steps), seed=seed)
    assert np.array_equal(*truth)
    assert np.array_equal(*values)


def test_they_stay_small():
    def size(made):
        return logic.fold(made, lambda _, below: 1 + sum(below))

    names = [parse(f"a{n}") for n in range(64)]
    assert size(derived.one_of(names)) < 64 * 6 * 4
    assert size(derived.all_of(names)) == 2 + 64
    assert size(derived.one_step(0, 63, names[0])) <= 64 * 9
    assert size(derived.all_steps(0, 63, names[0])) == 3


@pytest.mark.parametrize("language", logic.LANGUAGES)
def test_every_language_has_them(language):
    a, b, c = ("x > 1", "y > 1", "z > 1") if language.endswith("stl") else "abc"
    parts = [parse(text, language) for text in (a, b, c)]
    assert parse(f"one({a}, {b}, {c})", language) is derived.one_of(parts)
    assert parse(f"all ({a}, {b},({c}))", language) is derived.all_of(parts)
    assert parse(f"!one[2,4] {a} && {b}", language) is ~derived.one_step(2, 4, parts[0]) & parts[1]
    nested = f"all[0,1] one({a}, all[1,1] {b})"
    inner = derived.one_of([parts[0], derived.all_steps(1, 1, parts[1])])
    assert parse(nested, language) is derived.all_steps(0, 1, inner)
    assert parse("(" * 30 + f"one({a}, {b})" + ")" * 30, language) is derived.one_of(parts[:2])


def test_weights_stand_below_them():
    made = parse("one(&&^w (a, b), F[0,1]^2 c)", "wmtl", weights={"w": [1, 3]})
    assert made is derived.one_of([parse("&&^[1,3] (a, b)", "wmtl"), parse("F[0,1]^2 c", "wmtl")])


@pytest.mark.parametrize(
    ("text", "column", "message"),
    [
        ("one(a)", 1, "'one' joins one formula alone"),
        ("b && one((a))", 6, "'one' joins one formula alone"),
        ("one()", 5, "nothing between the parentheses"),
        ("all a", 5, "'a' is left over"),
        ("one(a b)", 7, "'b' is left over"),
        ("one(a, 2)", 8, "'2' is a number"),
        ("one[3,1] a", 4, "ends before it begins"),
        ("one[0,1] (a, b)", 12, "',' is left over"),
        ("b || one[0,999999] a", 6, "at most 100,000 steps"),
        ("one[0,1] " * 20 + "a", 37, "more than 100,000 parts"),
    ],
)
def test_what_they_cannot_join_is_told(text, column, message):
    with pytest.raises(FormulaError) as caught:
        parse(text)
    (found,) = caught.value.findings
    assert message in found.message
    assert found.remedy
    assert message.startswith("more") or found.column == column


@pytest.mark.parametrize(
    ("text", "printed"),
    [
        ("all(a, b || c) && d", None),
        ("all[1,2] a U[0,3] all(b)", None),
        ("all(a && b)", "all(a, b)"),
        ("all(G[0,1] a)", "all[0,1] a"),
        ("all(&&^[1, 2] (a, b))", None),
        ("all(G[0,1]^[1, 2] a)", None),
        ("!all(a => b, c)", "!all(a => b, c)"),
        ("all(all[0,1] a)", None),
    ],
)
def test_all_is_printed_as_it_is_written(text, printed):
    formula = parse(text, "wmtl")
    assert str(formula) == (printed or text)
    assert parse(str(formula), "wmtl") is formula


def test_parts_keep_their_places():
    text = "b || one(F[0,3] a, !c)"
    formula, written = parse_with_places(text)
    part = parse("F[0,3] a")
    places = {text[slice(*here.span)] for here in written.occurrences() if here.formula is part}
    assert places == {"F[0,3] a"}
    assert text[slice(*written[1])] == "one(F[0,3] a, !c)"
    assert {here.formula for here in written.occurrences()} == set(logic.walk(formula))
    open_ = [(formula, written)]
    while open_:
        node, here = open_.pop()
        assert here.formula is node
        open_ += zip(node.children, here.children, strict=True)
