"""Texts that are wrong: what is said, where, and what to do about it."""

import contextlib

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from tests.seeds import quick
from tsplan.errors import FormulaError
from tsplan.logic import LANGUAGES, parse


def findings(text, language="mtl"):
    with pytest.raises(FormulaError) as caught:
        parse(text, language)
    return caught.value.findings


def columns(text, language="mtl"):
    return [finding.column for finding in findings(text, language)]


@pytest.mark.parametrize(
    ("language", "text", "column", "message", "remedy"),
    [
        ("mtl", "", 1, "empty", "write a formula"),
        ("mtl", "  \n ", 1, "empty", "write a formula"),
        ("mtl", "a zzz", 3, "'zzz' is left over", "&& or ||"),
        ("mtl", "(a || b c)", 9, "'c' is left over", "&& or ||"),
        ("mtl", "a@b", 2, "'@' has no meaning", "quotes"),
        ("mtl", "a.b", 2, "'.' has no meaning", "quotes"),
        ("mtl", '"a', 1, "quote is never closed", "another quote"),
        ("mtl", '"" && a', 1, "name in quotes is empty", "at least one"),
        ("mtl", "F a", 3, "'F' needs an interval", "F[a,b]"),
        ("mtl", "F (a)", 3, "'F' needs an interval", "F[a,b]"),
        ("mtl", "G a U[0,2] b", 3, "'G' needs an interval", "G[a,b]"),
        ("mtl", "a U b", 5, "'U' needs an interval", "U[a,b]"),
        ("mtl", "<> a", 4, "'<>' needs an interval", "<>[a,b]"),
        ("mtl", "GF[0,2] x", 3, "'[' cannot follow the name 'GF'", "own interval"),
        ("mtl", "aU[0,2]b", 3, "'[' cannot follow the name 'aU'", "apart from names"),
        ("mtl", "next a", 1, "'next' is no operator", "write X"),
        ("mtl", "a until b", 3, "'until' is no operator", "U[a,b]"),
        ("mtl", "F[0.5,2] a", 3, "0.5 is not a whole number of steps", "whole number"),
        ("mtl", "F[0,1E] a", 6, "'E' is unexpected", "[a,b]"),
        ("mtl", "F[3,1] a", 2, "[3,1] ends before it begins", "[1,3]"),
        ("mtl", "F[1e1,2] a", 2, "[10,2] ends before it begins", "[2,10]"),
        ("mtl", "F[-1,2] a", 3, "-1 lies before now", "0 or later"),
        ("mtl", "F[0,1e99] a", 5, "1e99 is not a whole number of steps", "15 digits"),
        ("mtl", "F[0,1e999999999] a", 5, "is not a whole number of steps", "15 digits"),
        ("mtl", "F[0] a", 4, "']' is unexpected", "[a,b]"),
        ("mtl", "F[0,2]", 7, "the end stands where a formula should begin", "missing"),
        ("mtl", "a && ", 6, "the end stands where a formula should begin", "missing"),
        ("mtl", "&& a", 1, "'&&' stands where a formula should begin", "missing"),
        ("mtl", "()", 2, "nothing between the parentheses", "remove"),
        ("mtl", "(a && b", 1, "'(' is never closed", "add ')'"),
        ("mtl", "((a && b", 1, "'(' is never closed, and 1 more", "add ')'"),
        ("mtl", "a) && b", 2, "')' is never opened", "add '('"),
        ("mtl", "a => 2", 3, "'=>' means 'implies'", "a >= 2"),
        ("mtl", "2", 1, "'2' is a number, not a formula", "compare"),
        ("mtl", "sum(a)", 1, "'sum(a)' is a number of agents", "sum(a) >= 1"),
        ("mtl", "sum(a) >= 2.5", 11, "2.5 is not a number of agents", "whole"),
        ("mtl", "sum(a) >= 120%", 11, "not between 0% and 100%", "30%"),
        ("mtl", "sum(a) >= sum(b)", 8, "only counts and numbers", "sum(A) >= 2"),
        ("mtl", "1 <= sum(a) <= 3", 13, "one number at a time", "&&"),
        ("mtl", "(a && b) > 2", 10, "only counts and numbers", "sum(A) >= 2"),
        ("mtl", "sum() > 2", 5, "')' is unexpected", "name"),
        ("mtl", "sum(a,b,c) > 2", 8, "',' is unexpected", "sum(label"),
        ("mtl", "T(1,a,{(c,1)})", 2, "'(' cannot follow the name 'T'", "CaTL"),
        ("stl", "x=>3", 2, "'=>' means 'implies'", "x >= 3"),
        ("stl", "0 < x < 2", 7, "two values are compared", "0 < x && x < 2"),
        ("stl", "x[0] > 2", 2, "'[' cannot follow the name 'x'", "interval"),
        ("stl", "x", 1, "'x' is a number", "x >= 0"),
        ("stl", "2x > 1", 2, "'x' cannot follow the number 2", "2*x"),
        ("stl", "x*y > 2", 3, "two signals are multiplied", "linear"),
        ("stl", "x/0 > 2", 3, "division by 0", "other than 0"),
        ("stl", "2/x > 2", 3, "division by a signal", "other than 0"),
        ("stl", "(x > 2) + 1 > 3", 1, "is a formula, not a number", "both sides"),
        ("stl", "true > 2", 1, "'true' is a formula", "both sides"),
        ("stl", "x > 1e309", 1, "beyond all numbers", "1e308"),
        ("stl", "x > 1e999999999", 5, "beyond all numbers", "1e308"),
        *(
            (language, "F[0,2]^w a", 7, "'^' begins a weight", f"the language {weighted}")
            for language, weighted in (("mtl", "wmtl"), ("catl", "wmtl"), ("stl", "wstl"))
        ),
        ("stl", "x > 1 || (a &&^[1, 2] b) ||", 15, "'^' begins a weight", "wstl"),
        ("mtl", "a && (b, c)", 8, "',' is left over", "&& or ||"),
        ("mtl", "(" * 12 + "a, b" + ")" * 12, 14, "',' is left over", "&& or ||"),
        ("stl", "in()", 4, "')' is unexpected", "name of letters"),
        ("stl", "in(a, b, c)", 8, "',' is unexpected", "in(robot, region)"),
        ("stl", "in(x > 1)", 6, "'>' is unexpected", "in(robot, region)"),
        ("stl", "inside(a)", 7, "'(' cannot follow the name 'inside'", "in(...)"),
        ("stl", "x > 1 => out(a)", 14, "there is no region 'a'", "give regions"),
        ("wstl", "G^w x > 1", 2, "'G' needs an interval", "G[a,b]"),
        ("wstl", "x > 1 =>^w y > 1", 9, "cannot stand after '=>'", "F[0,5]^w a"),
        ("wstl", "X^2 x > 1", 2, "cannot stand after 'X'", "F[0,5]^w a"),
        ("wstl", "^[1,2] (x > 1)", 1, "a weight stands alone", "F[0,5]^w a"),
        ("wmtl", "a &&^w b", 5, "no weights 'w' are given", "^[1, 2]"),
        ("wmtl", "a &&^ (b)", 7, "'(' is unexpected", "^[0.2, 0.8]"),
        ("wmtl", "a &&^[ ] b", 8, "']' is unexpected", "^[0.2, 0.8]"),
        ("wmtl", "&&^2 a", 6, "'a' is unexpected", "&&^w (a, b)"),
        ("wmtl", "&&^2 (a)", 1, "joins one formula alone", "&& (a, b)"),
        ("wmtl", "||^2 ()", 7, "nothing between the parentheses", "remove"),
        ("wmtl", "||^2 (a, )", 10, "')' stands where a formula should begin", "missing"),
        ("wmtl", "||^2 (a b)", 9, "'b' is left over", "&& or ||"),
        ("wmtl", "a &&^[1] b", 5, "1 weights are given for parts 0 to 1", "from 0 to 1"),
        ("wmtl", "F[1,3]^[1,2] b", 7, "2 weights are given for steps 1 to 3", "from 1 to 3"),
        ("wmtl", "F[1,3]^0 b", 7, "the weight of step 1 is 0.0", "above 0"),
        ("wmtl", "||^[1, -2] (a, b)", 3, "the weight of part 1 is -2.0", "above 0"),
        ("wmtl", "a U[0,1]^1e999 b", 9, "the weight of step 0 is inf", "above 0"),
        ("wmtl", "G[0,1e15]^2 a", 5, "not a whole number of steps", "15 digits"),
        ("wmtl", "G[0,999999999999999]^2 a", 21, "more than 1,000,000 steps", "one number"),
        ("wmtl", "a &&^1 b && c", 10, "'&&^1' and '&&' join parts of one level", "parentheses"),
        ("wmtl", "a ||^1 b && c ||^2 d", 15, "'||^1' and '||^2'", "parentheses"),
        ("catl", "T(1, test, {(a,-1)})", 16, "-1 is not a number of agents", "from 0"),
        ("catl", "T(-1, test, {(a,1)})", 3, "-1 is not a duration", "from 0"),
        ("catl", "T(1.5, test, {(a,1)})", 3, "1.5 is not a duration", "whole"),
        ("catl", "T(1, test, {})", 12, "asks for nothing", "(capability, number)"),
        ("catl", "T(1, test, {(a,1),(a,2)})", 19, "'a' is named twice", "once"),
        ("catl", "T(1, a, {(c,1)}, {(r,-2)})", 22, "-2 is not an amount", "from 0"),
        ("catl", "F[0, 20] T(1, green {(IR, 2)})", 21, "'{' is unexpected", "T(duration"),
        ("catl", "L(a, (c,1))", 6, "'(' is unexpected", "{(capability"),
        ("catl", "F[0,5] T(1,a,{(b,1)}) F[0,5] T(1,c,{(b,1)})", 23, "'F' is left over", "&&"),
    ],
)
def test_one_finding_with_place_and_remedy(language, text, column, message, remedy):
    found = findings(text, language)
    assert len(found) == 1
    assert found[0].column == column
    assert message in found[0].message
    assert remedy in found[0].remedy


@pytest.mark.parametrize(
    ("text", "column", "readings"),
    [
        ("a => b && c", 8, ("(a => b) && c", "a => (b && c)")),
        ("a && b => c", 8, ("(a && b) => c", "a && (b => c)")),
        ("a => b => c", 8, ("(a => b) => c", "a => (b => c)")),
        ("a <=> b || c", 9, ("(a <=> b) || c", "a <=> (b || c)")),
        ("a && b U[0,3] c", 8, ("(a && b) U[0,3] c", "a && (b U[0,3] c)")),
        ("a U[0,1] b U[0,2] c", 12, ("(a U[0,1] b) U[0,2] c", "a U[0,1] (b U[0,2] c)")),
        ("a R[0,1] b -> c", 12, ("(a R[0,1] b) -> c", "a R[0,1] (b -> c)")),
        ("a || b || c || d => e", 18, ("(c || d) => e", "c || (d => e)")),
    ],
)
def test_mixed_operators_are_refused_with_both_readings(text, column, readings):
    (found,) = findings(text)
    assert found.column == column
    assert "parentheses" in found.message
    for reading in readings:
        assert reading in found.remedy
        if reading.startswith("(a") and len(text) < 20:
            parse(reading)


def test_findings_in_different_parts_come_together_in_order():
    text = "F[3,1] a &&\n  (b c) && sum(a) >= 2.5 &&\n F[0.5,2] d && e @ && (f g)"
    found = [(item.line, item.column) for item in findings(text)]
    assert found == [(1, 2), (2, 6), (2, 22), (3, 4), (3, 18), (3, 26)]


def test_both_bounds_are_reported():
    assert columns("F[0.5,1.5] a") == [3, 7]


def test_findings_below_deep_parentheses_are_reported():
    depth = 40
    assert columns("(" * depth + "F[2,1] a b" + ")" * depth + " && F[3,0] c") == [42, 50, 96]


def test_unbalanced_parentheses_do_not_hide_the_rest():
    assert columns("(F[3,1] a && b") == [1, 3]
    assert columns("F[3,1] a) && b") == [2, 9]


def test_an_unknown_language_is_refused():
    with pytest.raises(FormulaError, match="did you mean 'catl'"):
        parse("a", "cat")


ALPHABET = [
    "a",
    "F",
    "X",
    "U",
    "[0,2]",
    "[",
    "]",
    "(",
    ")",
    "&&",
    "||",
    "=>",
    "!",
    ">=",
    "2",
    ",",
    "T",
]
ALPHABET += [
    "^",
    "^w",
    "^2",
    "one",
    "all(",
    "in(",
    "sum",
    "{",
    "}",
    "%",
    "@",
    '"',
    ".5",
    "-",
    "*",
    " ",
    "L(a,{(c,1)})",
    "true",
    "x",
    "\n",
]


@settings(max_examples=200, deadline=None)
@example(["&&", "=>"], "mtl")
@given(st.lists(st.sampled_from(ALPHABET), max_size=15), st.sampled_from(LANGUAGES))
def test_any_text_is_a_formula_or_has_findings(parts, language):
    text = "".join(parts)
    try:
        formula = parse(text, language)
    except FormulaError as error:
        found = error.findings
    else:
        assert parse(str(formula), language) is formula
        return
    lines = text.split("\n")
    assert found
    for finding in found:
        assert finding.message
        assert finding.remedy
        assert 1 <= finding.line <= len(lines)
        assert 1 <= finding.column <= len(lines[finding.line - 1]) + 1


@quick
@given(st.text(max_size=20), st.sampled_from(LANGUAGES))
def test_any_characters_at_all(text, language):
    with contextlib.suppress(FormulaError):
        parse(text, language)


def test_an_operator_in_the_midst_of_a_broken_task_is_a_finding_and_no_crash() -> None:
    with pytest.raises(FormulaError):
        parse("F[0,4] T(1, green, {(      && G[0,9] sum(home) >= 1", "catl")
