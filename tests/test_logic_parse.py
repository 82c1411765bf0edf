"""What texts mean: synonyms, names, numbers, binding, places."""

import pytest
from formulas import formulas, languages, quick
from hypothesis import given
from hypothesis import strategies as st

from tsplan import logic
from tsplan.logic import TRUE, Count, Eventually, Limit, Task, parse, parse_with_places
from tsplan.logic.parser import token_streams as streams

SYNONYMS = [
    ("a & b", "a && b"),
    (r"a /\ b", "a && b"),
    ("a | b", "a || b"),
    (r"a \/ b", "a || b"),
    ("~a", "!a"),
    ("not a", "!a"),
    ("a -> b", "a => b"),
    ("a <-> b", "a <=> b"),
    ("<>[0,2] a", "F[0,2] a"),
    ("[][0,2] a", "G[0,2] a"),
    ("X a", "F[1,1] a"),
    ("X X a", "F[1,1] F[1,1] a"),
    ("X(a && b)", "F[1,1] (a && b)"),
    ("True && False", "true && false"),
    ("sum(a) == 2", "sum(a) = 2"),
    ("2 <= sum(a)", "sum(a) >= 2"),
    ("3 > min(a,c)", "min(a,c) < 3"),
    ("a > 2", "sum(a) > 2"),
    ("a >= 1", "a"),
    ("(a) < 2", "sum(a) < 2"),
    ("((a))", "a"),
    ('"a"', "a"),
]

BINDING = [
    ("F[0,2] a > 2", "F[0,2] (sum(a) > 2)"),
    ("F[0,5] a && b", "(F[0,5] a) && b"),
    ("!a U[0,3] b", "(!a) U[0,3] b"),
    ("a || b && c", "a || (b && c)"),
    ("a && b || c && d", "(a && b) || (c && d)"),
    ("!a > 2", "!(a > 2)"),
    ("G[0,9]F[0,3] x", "G[0,9] (F[0,3] x)"),
    ("! ~ not a", "!(!(!a))"),
    ("a U[0,2]b", "a U[0,2] b"),
    ("a\n&&\r\n\tb", "a && b"),
]

NUMBERS = [
    ("F[5.,6] a", "F[5,6] a"),
    ("F[5.0,6] a", "F[5,6] a"),
    ("F[1e1,12] a", "F[10,12] a"),
    ("F[0,1.5e1] a", "F[0,15] a"),
    ("F[ 0 , 2 ] a", "F[0,2] a"),
    ("sum(a) >= 10", "sum(a) >= 1e1"),
    ("sum(a) >= 12.50%", "sum(a) >= 12.5%"),
    ("sum(a) <= .5 %", "sum(a) <= 0.5%"),
]


@pytest.mark.parametrize(("text", "same"), SYNONYMS + BINDING + NUMBERS)
def test_texts_that_mean_the_same(text, same):
    assert parse(text) is parse(same)


@pytest.mark.parametrize(
    "name",
    ["F", "G", "U", "R", "X", "T", "L", "F1", "Gx", "_x", "sum", "min", "max", "TRUE", "Not"],
)
def test_reserved_words_are_names_where_they_are_no_operators(name):
    label = Count("sum", name, None, ">=", 1)
    assert parse(name) is label
    assert parse(f"{name} && F[0,2] {name}") is label & Eventually(0, 2, label)
    assert parse(f"{name} U[0,2] {name}") is label.until(label, 0, 2)
    assert parse(f"sum({name},{name}) >= 2", "catl") is Count("sum", name, name, ">=", 2)
    assert parse(f"T(1,{name},{{({name},1)}})", "catl") is Task(1, name, ((name, 1),))
    if name != "X":  # 'X (x > 2)' is the operator
        assert parse(f"{name} - x > 2", "stl") is logic.linear({name: 1, "x": -1}, ">", 2)


def test_next_is_only_an_operator_before_an_operand():
    assert parse("X - y > 2", "stl") is logic.linear({"X": 1, "y": -1}, ">", 2)
    assert parse("X (x > 2)", "stl") is parse("F[1,1] (x > 2)", "stl")
    assert parse("X U[0,2] b") is logic.at_least("X").until(parse("b"), 0, 2)
    assert parse("X U && b") is parse("(F[1,1] U) && b")
    assert parse("X X") is parse("F[1,1] (X)")


@pytest.mark.parametrize(
    "name", ["north field", "a.b", "ä", "true", "not", 'say "hi"', "back\\", "2"]
)
def test_any_text_is_a_name_in_quotes(name):
    formula = Count("min", name, name, ">=", 2)
    assert parse(str(formula)) is formula
    assert logic.labels(formula) == (name,)


def test_constants():
    assert parse("true") is parse("True") is TRUE
    assert parse("false", "catl") is parse("False", "stl") is logic.FALSE


def test_tasks_and_limits():
    assert parse("T(4, test, {(a, 10)})", "catl") is Task(4, "test", (("a", 10),))
    spent = Task(2, "A", (("c", 1),), (("r", 2.5),))
    assert parse("T(2, A, {(c,1)}, {(r, 2.5)})", "catl") is spent
    assert str(spent) == "T(2,A,{(c,1)},{(r,2.5)})"
    assert parse("T(1, A, {}, {(r, .5)})", "catl") is Task(1, "A", (), (("r", 0.5),))
    assert parse("L(A, {(c,0)})", "catl") is Limit("A", (("c", 0),))
    assert parse("L(A,{}) U[0,2] !T(1,A,{(c,1)})", "catl") is logic.limit("A").until(
        ~logic.task(1, "A", {"c": 1}), 0, 2
    )


def test_tasks_may_be_grouped_in_any_way():
    one, two, three = (f"T(1,{name},{{(b,1)}})" for name in "acd")
    nested = parse(f"{one} && ({two} && {three})", "catl")
    assert nested is parse(one, "catl") & parse(f"{two} && {three}", "catl")
    assert len(parse(f"{one} && {two} && {three}", "catl").children) == 3


@pytest.mark.parametrize(
    ("text", "terms", "relation", "bound"),
    [
        ("x > 2", {"x": 1}, ">", 2),
        ("2 < x", {"x": 1}, ">", 2),
        ("x + y > 2", {"x": 1, "y": 1}, ">", 2),
        ("2*x > 3", {"x": 2}, ">", 3),
        ("x*2 > 3", {"x": 2}, ">", 3),
        ("x -2 > 0", {"x": 1}, ">", 2),
        ("-x > 2", {"x": 1}, "<", -2),
        ("- - x > 2", {"x": 1}, ">", 2),
        ("x > -(2)", {"x": 1}, ">", -2),
        ("x == 2", {"x": 1}, "=", 2),
        ("x != 2", {"x": 1}, "!=", 2),
        ("x > 1E3", {"x": 1}, ">", 1000),
        ("x > .7", {"x": 1}, ">", 0.7),
        ("2*(x + 3*y)/4 - 1 <= y", {"x": 0.5, "y": 0.5}, "<=", 1),
        ("((((x)))) >= ((2))", {"x": 1}, ">=", 2),
        ("(1 + 1)*x >= 2", {"x": 2}, ">=", 2),
        ("x - x >= 2", {}, ">=", 2),
        ("3 > 2", {}, ">", -1),
        ("2*x - y + 1 >= 3", {"x": 2, "y": -1}, ">=", 2),
    ],
)
def test_linear_predicates(text, terms, relation, bound):
    assert parse(text, "stl") is logic.linear(terms, relation, bound)


def test_predicates_join_like_other_formulas():
    assert parse("x > 2 & y>1", "stl") is parse("x > 2", "stl") & parse("y > 1", "stl")
    assert parse("F[0,2] x > 1 => y > 1", "stl") is parse("(F[0,2] (x > 1)) => (y > 1)", "stl")


def test_places_of_parts():
    text = "a &&\n  F[0,2] (a || sum(b) >= 2)"
    formula, places = parse_with_places(text)
    assert places[parse("a")] == ((1, 1, 1, 2), (2, 11, 2, 12))
    assert places[parse("sum(b) >= 2")] == ((2, 16, 2, 27),)
    assert places[parse("F[0,2] (a || sum(b) >= 2)")] == ((2, 3, 2, 28),)
    assert places[formula] == ((1, 1, 2, 28),)


def test_places_below_parentheses_that_were_cut_out():
    depth = 3 * streams.DEPTH
    _, places = parse_with_places("(" * depth + "a" + ")" * depth + " && b")
    assert places[parse("b")] == ((1, 2 * depth + 6, 1, 2 * depth + 7),)
    assert places[parse("(a) && b")] == ((1, 1, 1, 2 * depth + 7),)


@quick
@given(st.data())
def test_every_part_of_a_printed_formula_has_a_place(data):
    language = data.draw(languages)
    formula = data.draw(formulas(language, plain=False, leaves=5))
    text = str(formula)
    parsed, places = parse_with_places(text, language)
    assert parsed is formula
    assert set(places) | {logic.TRUE, logic.FALSE} >= set(logic.walk(formula))
    if "\n" not in text:
        for part, spots in places.items():
            for _, start, _, stop in spots:
                assert parse(text[start - 1 : stop - 1], language) is part


@quick
@given(st.data(), st.integers(1, 4))
def test_where_a_text_is_cut_makes_no_difference(data, depth):
    language = data.draw(languages)
    formula = data.draw(formulas(language, plain=False))
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(streams, "DEPTH", depth)
        assert parse(str(formula), language) is formula
