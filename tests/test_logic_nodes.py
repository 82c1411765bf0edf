"""Nodes: identity, builders, what they refuse, copies, and what they forget."""

import copy
import gc
import pickle
import weakref
from fractions import Fraction
from threading import Thread

import pytest

from tsplan import logic
from tsplan.logic import (
    FALSE,
    TRUE,
    Always,
    And,
    Constant,
    Count,
    Eventually,
    Formula,
    Implies,
    Limit,
    Linear,
    Not,
    Or,
    Percent,
    Release,
    Task,
    Until,
    parse,
)

A, B, C = (parse(name) for name in "abc")


def test_equal_formulas_are_one_object():
    assert parse("F[0,2] (a && sum(b,c) >= 2)") is parse("<>[0,2] (a /\\ 2 <= sum(b, c))")
    assert And((A, B)) is And((A, B))
    assert And((A, B)) is not And((B, A))
    assert Constant(value=True) is TRUE


def test_negated_implication_is_not_the_implication_of_a_negation():
    assert parse("!(a => b)") is Not(Implies(A, B))
    assert parse("!a => b") is Implies(Not(A), B)
    assert str(Not(Implies(A, B))) == "!(a => b)"
    assert str(Implies(Not(A), B)) == "!a => b"


def test_grouping_is_kept_as_written():
    assert parse("a && b && c") is And((A, B, C))
    assert parse("a && (b && c)") is And((A, And((B, C))))
    assert parse("(a && b) && c") is And((And((A, B)), C))
    assert parse("a || b && c") is Or((A, And((B, C))))


def test_builders_say_what_the_text_says():
    assert A & B | ~C is parse("(a && b) || !c")
    assert A >> B is parse("a => b")
    assert A.iff(B) is parse("a <=> b")
    assert A.eventually(0, 3) is parse("F[0,3] a")
    assert A.always(1, 2) is parse("G[1,2] a")
    assert A.until(B, 0, 4) is parse("a U[0,4] b")
    assert A.release(B, 2, 4) is parse("a R[2,4] b")
    assert logic.at_most("a", 2, "c") is parse("sum(a,c) <= 2")
    assert logic.each_at_least("a", 2) is parse("min(a) >= 2")
    assert logic.each_at_most("a", 0, "c") is parse("max(a,c) <= 0")
    assert logic.linear({"x": 1}, ">", 2) is parse("x > 2", "stl")
    assert logic.task(3, "a", {"c": 2}) is parse("T(3,a,{(c,2)})", "catl")
    assert logic.limit("a") is parse("L(a,{})", "catl")
    assert logic.conjunction([]) is TRUE
    assert logic.disjunction([]) is FALSE
    assert logic.conjunction([A]) is A
    assert logic.disjunction([A, B]) is Or((A, B))


@pytest.mark.parametrize(
    "make",
    [
        lambda: Eventually(2, 1, A),
        lambda: Always(-1, 1, A),
        lambda: Until(3, 2, A, B),
        lambda: And((A,)),
        lambda: Or(()),
        lambda: Count("mean", "a", None, ">=", 1),
        lambda: Count("sum", "a", None, "=>", 1),
        lambda: Percent(Fraction(101)),
        lambda: Percent(Fraction(-1)),
        lambda: Percent(Fraction(1, 3)),
        lambda: Linear((("x", float("inf")),), ">", 0.0),
        lambda: Linear((("x", 1.0),), ">", float("nan")),
        lambda: Task(-1, "a", (("c", 1),)),
        lambda: Task(1, "a", ()),
        lambda: Task(1, "a", (("c", -1),)),
        lambda: Task(1, "a", (("c", 1), ("c", 2))),
        lambda: Task(1, "a", (), (("r", -1.0),)),
        lambda: Limit("a", (("c", 1), ("c", 1))),
    ],
)
def test_impossible_values_are_refused(make):
    with pytest.raises(ValueError, match=r"\w"):
        make()


@pytest.mark.parametrize(
    "make",
    [
        lambda: Eventually(0.5, 1, A),
        lambda: Release(0, True, A, B),
        lambda: Not("a"),
        lambda: And((A, "b")),
        lambda: A & "b",
        lambda: A | None,
        lambda: Count("sum", "", None, ">=", 1),
        lambda: Count("sum", "a", None, ">=", 1.5),
        lambda: bool(A),
        lambda: A and B,
    ],
)
def test_values_of_the_wrong_kind_are_refused(make):
    with pytest.raises(TypeError):
        make()


def test_nodes_are_frozen():
    with pytest.raises(AttributeError):
        A.bound = 2


def test_copies_and_pickles_are_the_same_object():
    formula = parse("F[0,3] T(2,a,{(c,1)},{(r,2.5)}) && L(b,{}) || sum(a) >= 12.5%", "catl")
    assert copy.copy(formula) is formula
    assert copy.deepcopy([formula])[0] is formula
    assert pickle.loads(pickle.dumps(formula)) is formula


def test_formulas_that_nobody_holds_are_forgotten():
    formula = parse("forgotten && nowhere")
    trace = weakref.ref(formula)
    del formula
    gc.collect()
    assert trace() is None


def test_threads_get_the_same_object():
    made = []

    def build():
        made.extend(parse(f"sum(t) >= {number}").eventually(0, 3) for number in range(50))

    threads = [Thread(target=build) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(set(made)) == 50


def test_percentages_print_as_they_are():
    shares = [Percent(Fraction(text)) for text in ("0", "30", "12.5", "0.05", "100")]
    assert [str(share) for share in shares] == ["0%", "30%", "12.5%", "0.05%", "100%"]


def test_predicates_have_one_form():
    assert parse("2 < x", "stl") is parse("x > 2", "stl")
    assert parse("-x > 2", "stl") is parse("x < -2", "stl")
    assert parse("x + y >= 2", "stl") is parse("1 + y - 3 + x >= 0", "stl")
    assert parse("2*x - (x - y)/2 >= y", "stl") is parse("1.5*x - 0.5*y >= 0", "stl")
    assert parse("0.1*x + 0.2*x > 1", "stl") is parse("0.3*x > 1", "stl")
    assert parse("x > -(2)", "stl") is parse("x > - 2", "stl")


def test_what_a_formula_speaks_about():
    formula = parse("F[0,2] T(1,b,{(Vis,1),(IR,2)}) && sum(a,Vis) >= 1 && L(b,{})", "catl")
    assert logic.labels(formula) == ("b", "a")
    assert logic.capabilities(formula) == ("Vis", "IR")
    assert logic.variables(parse("y - x > 2 || x > 1", "stl")) == ("x", "y")


def test_substitution_reaches_every_place_at_once():
    formula = parse("a U[0,2] (a && b)")
    assert logic.substitute(formula, {A: B, B: A}) is parse("b U[0,2] (b && a)")


def test_long_formulas_are_shown_in_part():
    assert len(repr(And((A,) * 1000))) < 250
    assert repr(A.eventually(0, 2)) == "<Eventually: F[0,2] a>"


def test_shared_parts_cost_once():
    formula: Formula = A
    for _ in range(200):
        formula = formula.iff(formula & B)
    assert len(list(logic.walk(formula))) == 402
    assert logic.horizon(logic.positive(formula.eventually(0, 1))) == 1
    assert len(repr(formula)) < 250


@pytest.mark.parametrize(
    ("text", "simple"),
    [
        ("a && true && (b && a)", "a && b"),
        ("a || false", "a"),
        ("a && false", "false"),
        ("a || true || b", "true"),
        ("!!a", "a"),
        ("!true", "false"),
        ("F[1,2] F[3,4] a", "F[4,6] a"),
        ("G[0,2] G[0,3] a", "G[0,5] a"),
        ("F[0,0] a", "a"),
        ("G[3,7] true", "true"),
        ("true => a", "a"),
        ("a => false", "!a"),
        ("a <=> true", "a"),
        ("false <=> a", "!a"),
        ("true U[1,3] b", "F[1,3] b"),
        ("false U[1,3] b", "false"),
        ("false U[0,3] b", "b"),
        ("a U[2,3] true", "G[0,1] a"),
        ("a U[0,3] true", "true"),
        ("a U[0,0] b", "b"),
        ("a U[0,4] false", "false"),
        ("false R[1,3] b", "G[1,3] b"),
        ("true R[1,3] b", "true"),
        ("true R[0,3] b", "b"),
        ("a R[2,3] false", "F[0,1] a"),
        ("a R[0,3] false", "false"),
        ("a R[0,3] true", "true"),
        ("F[0,2] G[0,2] a", "F[0,2] G[0,2] a"),
    ],
)
def test_simplification(text, simple):
    assert logic.simplify(parse(text)) is parse(simple)


@pytest.mark.parametrize(
    ("text", "steps"),
    [
        ("a", 0),
        ("F[0,5] G[1,2] a", 7),
        ("a U[0,4] b", 4),
        ("(F[0,3] a) U[0,4] b", 6),
        ("(F[0,3] a) U[0,0] b", 0),
        ("a R[2,4] (F[0,1] b)", 5),
        ("X X a", 2),
        ("F[0,9] T(3,a,{(c,1)})", 12),
        ("L(a,{}) && true", 0),
    ],
)
def test_horizon(text, steps):
    assert logic.horizon(parse(text, "catl")) == steps


@pytest.mark.parametrize(
    ("text", "normal", "denied"),
    [
        ("sum(a) > 2", "sum(a) >= 3", "sum(a) <= 2"),
        ("sum(a) < 2", "sum(a) <= 1", "sum(a) >= 2"),
        ("min(a,c) = 2", "min(a,c) >= 2 && min(a,c) <= 2", "min(a,c) >= 3 || min(a,c) <= 1"),
        ("max(a) != 2", "max(a) >= 3 || max(a) <= 1", "max(a) >= 2 && max(a) <= 2"),
        ("a && !b", "a && sum(b) <= 0", "sum(a) <= 0 || b"),
        ("a || b", "a || b", "sum(a) <= 0 && sum(b) <= 0"),
        ("a U[1,2] b", "a U[1,2] b", "(sum(a) <= 0) R[1,2] (sum(b) <= 0)"),
        ("!(a R[1,2] b)", "(sum(a) <= 0) U[1,2] (sum(b) <= 0)", "a R[1,2] b"),
        ("F[0,1] a", "F[0,1] a", "G[0,1] (sum(a) <= 0)"),
        ("sum(a) = 30%", "sum(a) >= 30% && sum(a) <= 30%", "sum(a) > 30% || sum(a) < 30%"),
        ("!true", "false", "true"),
    ],
)
def test_normal_form_and_negation(text, normal, denied):
    assert logic.positive(parse(text)) is parse(normal)
    assert logic.negation(parse(text)) is parse(denied)


def test_signals_keep_strictness_in_the_normal_form():
    formula = parse("!(!(x > 2) && y > 1)", "stl")
    assert logic.positive(formula) is parse("x > 2 || y <= 1", "stl")


def test_the_normal_form_asks_for_a_translation():
    with pytest.raises(ValueError, match="translate"):
        logic.positive(parse("T(1,a,{(c,1)})", "catl"))


@pytest.mark.parametrize(
    ("text", "interval", "plain"),
    [
        ("T(2,a,{(c,1)})", "closed", "G[0,2] (min(a,c) >= 1)"),
        ("T(2,a,{(c,1)})", "half-open", "G[0,1] (min(a,c) >= 1)"),
        ("T(0,a,{(c,1),(d,2)})", "closed", "G[0,0] (min(a,c) >= 1 && min(a,d) >= 2)"),
        ("L(a,{})", "closed", "max(a) <= 0"),
        ("L(a,{(c,1),(d,0)})", "closed", "max(a,c) <= 1 && max(a,d) <= 0"),
        (
            "!T(1,a,{(c,1)}) U[0,2] L(b,{})",
            "closed",
            "!G[0,1] (min(a,c) >= 1) U[0,2] (max(b) <= 0)",
        ),
    ],
)
def test_translation(text, interval, plain):
    assert logic.translate(parse(text, "catl"), interval=interval) is parse(plain)


def test_what_cannot_be_translated_is_named():
    formula = parse("T(0,a,{(c,1)}) && T(1,b,{},{(water,2.5)})", "catl")
    with pytest.raises(logic.parsing.FormulaError) as caught:
        logic.translate(formula, interval="half-open")
    (finding,) = caught.value.findings
    assert "lasts no step" in finding.message
    with pytest.raises(ValueError, match="open"):
        logic.translate(formula, interval="open")
