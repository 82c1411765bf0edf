"""What texts mean: synonyms, names, numbers, binding, places."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.seeds import languages, quick
from tsplan import logic
from tsplan.errors import FormulaError
from tsplan.logic import TRUE, Count, Eventually, Limit, Task, parse, parse_with_places
from tsplan.logic.parser import token_streams as streams
from tsplan.testing.formula_strategies import ANYTHING, formulas

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

WEIGHTS = {"w": [0.2, 0.8], "n": 2, "steps": {1: 3, 2: 4}, "later": lambda step: step + 1}
WEIGHED = [
    ("a &&^w b", "&&^[0.2, 0.8] (a, b)"),
    ("a ||^ w b &&^n c", "||^w (a, &&^2.0 (b, c))"),
    ("a &&^n b &&^n c", "&&^2 (a, b, c)"),
    ("a &&^2 b &&^2.0 c", "&&^[2, 2, 2] (a, b, c)"),
    ("&& (a, b || c)", "a && (b || c)"),
    ("a && || (b, c)", "a && (b || c)"),
    ("a &&^w ||^n (b, (c))", "&&^w (a, ||^n (b, c))"),
    ("!&&^w (a > 2, F[1,2]^steps b)", "!(a > 2 &&^w F[1,2]^[3, 4] b)"),
    ("<>[1,2]^steps [][0,3]^later b", "F[1,2]^[3,4] G[0,3]^[1,2,3,4] b"),
    ("a U[1,2]^steps b", "a U[1,2]^[3.0, 4] (b)"),
    ("(a R[0,1]^w b) => c", "(a R[0,1]^[.2, 8e-1] b) => c"),
    ('a &&^"w" b', "a &&^w b"),
    ("F[0,1]^w w", "F[0,1]^[0.2, 0.8] (w)"),
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


@pytest.mark.parametrize(("text", "same"), WEIGHED)
def test_weights_are_written_in_many_ways(text, same):
    read, other = (parse_with_places(one, "wmtl", weights=WEIGHTS)[0] for one in (text, same))
    assert read is other
    assert parse(str(read), "wmtl") is read


def test_weighted_languages_read_what_the_others_do():
    for text, same in SYNONYMS + BINDING + NUMBERS:
        assert parse(text, "wmtl") is parse(same)
    assert parse("2*x -1 <= y && X x > 2", "wstl") is parse("2*x -1 <= y && X x > 2", "stl")


def test_weights_belong_to_the_operator_that_they_follow():
    weights = {"p": (1, 2), "F": 3}
    text = "&&^p (x > 1, F[0,1]^F F[0,2]^[4, 5, 6] y > 1)"
    formula = parse(text, "wstl", weights=weights)
    inner = logic.linear({"y": 1}, ">", 1).eventually(0, 2, (4, 5, 6))
    assert formula is logic.And((logic.linear({"x": 1}, ">", 1), inner.eventually(0, 1, 3)), (1, 2))


def test_a_function_is_called_once_for_each_index():
    asked = []
    parse("F[2,4]^w (a ||^w b)", "wmtl", weights={"w": lambda index: asked.append(index) or 1})
    assert sorted(asked) == [0, 1, 2, 3, 4]


def test_weights_that_nothing_uses_are_told():
    with pytest.raises(FormulaError, match="no operator has the weights 'v'") as caught:
        parse("a &&^w b", "wmtl", weights={"w": 1, "v": 2, "u": 3})
    assert len(caught.value.findings) == 2
    with pytest.raises(FormulaError, match="no operator has the weights 'v'"):
        parse("a && b", weights={"v": 2})
    assert parse_with_places("a &&^w b", "wmtl", weights={"w": 1, "v": 2})[1].weight_names == {"w"}


@pytest.mark.parametrize(
    ("weights", "message"),
    [
        ({"w": [1]}, "1:7: 'w' does not fit: 1 weights are given for steps 1 to 2, 2 needed"),
        ({"w": {1: 1}}, "1:7: 'w' does not fit: no weight is given for step 2"),
        ({"w": "ab"}, "1:7: 'w' does not fit: the weight of step 1 is no number: 'ab'"),
        ({"w": lambda step: 1 - step}, "1:7: 'w' does not fit: the weight of step 1 is 0"),
        ({"weights": 1}, "1:7: no weights 'w' are given; known: weights"),
        ({"ww": 1}, "1:7: no weights 'w' are given; did you mean 'ww'"),
    ],
)
def test_given_weights_that_do_not_fit(weights, message):
    with pytest.raises(FormulaError) as caught:
        parse("F[1,2]^w a", "wmtl", weights=weights)
    assert str(caught.value).startswith(message)


@pytest.mark.parametrize(
    "name",
    [*"FGURXTL", "F1", "Gx", "_x", "sum", "min", "max", "one", "all", "in", "out", "TRUE", "Not"],
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
    _, places = parse_with_places(text)
    assert places[0] == places[0, "label"] == (0, 1)
    assert places[1] == (7, 32)
    assert places[1, 0, 0] == (15, 16)
    assert places[1, 0, 1] == (20, 31)
    assert places[()] == (0, 32)
    assert places.get((2,)) is places.get((0, "bound")) is places.get((1, 0, 0, 0)) is None
    with pytest.raises(KeyError):
        places[1, "label"]


@pytest.mark.parametrize(
    ("text", "way", "words"),
    [
        ("a U[ 1, 20] b", ("interval",), "[ 1, 20]"),
        ("a U[ 1, 20] b", ("low",), "1"),
        ("F[0,3]X G[1,12] a", ("high",), "3"),
        ("F[0,3]X G[1,12] a", (0, 0, "high"), "12"),
        ("F[0,3]X G[1,12] a", (0, 0, 0, "label"), "a"),
        ('3 <= sum( "a b" , c )', ("bound",), "3"),
        ('3 <= sum( "a b" , c )', ("label",), '"a b"'),
        ('3 <= sum( "a b" , c )', ("capability",), "c"),
        ("min(a) > 5 %", ("bound",), "5 %"),
        ("T( 2 ,a, {(c, 10),( d,4 )}, {(w, .5)})", ("duration",), "2"),
        ("T( 2 ,a, {(c, 10),( d,4 )}, {(w, .5)})", ("label",), "a"),
        ("T( 2 ,a, {(c, 10),( d,4 )}, {(w, .5)})", ("needs", 1), "( d,4 )"),
        ("T( 2 ,a, {(c, 10),( d,4 )}, {(w, .5)})", ("needs", 0, 1), "10"),
        ("T( 2 ,a, {(c, 10),( d,4 )}, {(w, .5)})", ("resources", 0, 0), "w"),
        ("b || L(a, {(c, 0)})", (1, "needs", 0, 0), "c"),
        ("b || L(a, {(c, 0)})", (1, "label"), "a"),
        ("(!((b))) => (true && b)", (0,), "!((b))"),
        ("(!((b))) => (true && b)", (0, 0), "b"),
        ("(!((b))) => (true && b)", (1, 0), "true"),
        ("a && b || c && d && e || f", (1,), "c && d && e"),
        ("a && b || c && d && e || f", (1, 2), "e"),
    ],
)
def test_where_a_part_is_written(text, way, words):
    begin, end = parse_with_places(text, "catl")[1][way]
    assert text[begin:end] == words


@pytest.mark.parametrize(
    ("text", "way", "words"),
    [
        ('b > 1 || 3*(b - 2*"c d") <= x - b', (0, "signal", "b"), "b"),
        ('b > 1 || 3*(b - 2*"c d") <= x - b', (1, "signal", "c d"), '"c d"'),
        ('b > 1 || 3*(b - 2*"c d") <= x - b', (1, "signal", "x"), "x"),
        ("F[0,1] gap <= 1", (0, "signal", "gap"), "gap"),
    ],
)
def test_where_signals_are_written(text, way, words):
    gap = {"gap": ({"a": 1, "b": -1}, 2.0)}
    written = parse_with_places(text, "stl", definitions=gap)[1]
    begin, end = written[way]
    assert text[begin:end] == words
    assert begin == text.index(words, written[way[:1]].begin)


@pytest.mark.parametrize(
    ("text", "way", "words"),
    [
        ("b || &&^ w (F[0,1]^w a, c)", (1,), "&&^ w (F[0,1]^w a, c)"),
        ("b || &&^ w (F[0,1]^w a, c)", (1, "weight"), "^ w"),
        ("b || &&^ w (F[0,1]^w a, c)", (1, 0), "F[0,1]^w a"),
        ("b || &&^ w (F[0,1]^w a, c)", (1, 0, "weight", "w"), "^w"),
        ("b || &&^ w (F[0,1]^w a, c)", (1, 1), "c"),
        ("a U[0,1]^[1, 2] b ", ("weight",), "^[1, 2]"),
        ("a &&^2 b &&^2 c", ("weight",), "^2"),
    ],
)
def test_where_weights_are_written(text, way, words):
    begin, end = parse_with_places(text, "wmtl", weights={"w": 3})[1][way]
    assert text[begin:end] == words


def test_places_below_parentheses_that_were_cut_out():
    depth = 3 * streams.DEPTH
    _, places = parse_with_places("(" * depth + "a" + ")" * depth + " && b")
    assert places[0] == (depth, depth + 1)
    assert places[1] == (2 * depth + 5, 2 * depth + 6)
    assert places[()] == (0, 2 * depth + 6)


@quick
@given(st.data())
def test_every_part_of_a_printed_formula_has_a_place(data):
    language = data.draw(languages)
    formula = data.draw(formulas(language, words=ANYTHING, leaves=5))
    text = str(formula)
    parsed, places = parse_with_places(text, language)
    assert parsed is formula
    open_ = [(formula, places)]
    while open_:
        node, here = open_.pop()
        assert here.formula is node
        written = parse(text[here.span.begin : here.span.end], language)
        # what `all(...)` is of has no text but that of the whole
        assert written is node or (isinstance(written, logic.Whole) and written.child is node)
        open_ += zip(node.children, here.children, strict=True)
    assert {here.formula for here in places.occurrences()} == set(logic.walk(formula))


@quick
@given(st.data(), st.integers(1, 4))
def test_where_a_text_is_cut_makes_no_difference(data, depth):
    language = data.draw(languages)
    formula = data.draw(formulas(language, words=ANYTHING))
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(streams, "DEPTH", depth)
        assert parse(str(formula), language) is formula
