"""Sums of signals as text: outputs `s1 - s2`, limits `|u1| + 2*|u2| <= 1`.

The reader of STL reads them, so a number, a name or a product is the same everywhere. Findings have
the lines and columns of the text.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import replace
from fractions import Fraction
from itertools import product

from tsplan.errors import Finding, FormulaError
from tsplan.exact import exact
from tsplan.logic import Linear, parse
from tsplan.logic.text import number_text, sum_text
from tsplan.signals.linear_system import Limit, Terms

Sum = tuple[Terms, float]
"""The factor of every signal, and a constant."""

_NAME = r'"(?:[^"\\]|\\.)*"'
_BARS = re.compile(rf'{_NAME}|\|((?:{_NAME}|[^|"])*)\|')
_RELATION = re.compile(rf"{_NAME}|([<>=!&|])")
_BEFORE = "0 <= "  # what makes a predicate of a sum
_FIRST_PRIVATE = 0xF0000  # characters that nobody's names have stand for what is between bars
_MOST_SIDES = 10  # sums in bars with a constant, each of which doubles the limits


def expression(text: str) -> Sum:
    """The sum that a text means, its terms by name.

    Raises FormulaError with everything that is wrong.

    >>> expression("2*(x - y) + 1")
    ((('x', 2.0), ('y', -2.0)), 1.0)
    """
    for match in _RELATION.finditer(text):
        if match[1]:
            remedy = "write a sum, such as 2*x - y + 1"
            raise FormulaError([_finding(text, match.start(), f"'{match[1]}' in a sum", remedy)])
    try:
        made = parse(f"{_BEFORE}{text}", "stl")
    except FormulaError as error:
        raise FormulaError(map(_shifted, error.findings)) from None
    assert isinstance(made, Linear)
    sign = 1.0 if made.relation == ">=" else -1.0
    return tuple((name, sign * factor) for name, factor in made.terms), 0.0 - sign * made.bound


def _shifted(item: Finding) -> Finding:
    """A finding without what was put before its text."""
    if item.line != 1 or item.column is None:
        return item
    return replace(item, column=max(item.column - len(_BEFORE), 1))


def expression_text(terms: Terms, constant: float) -> str:
    """A text that is read as the sum.

    >>> expression_text((("x", 2.0), ("y", -1.0)), 0.5), expression_text((), -3.0)
    ('2*x - y + 0.5', '-3')
    """
    number = number_text(abs(constant))
    if not terms:
        return f"-{number}" if constant < 0 else number
    more = f" {'-' if constant < 0 else '+'} {number}" if constant else ""
    return sum_text(terms) + more


def limits(text: str) -> tuple[Limit, ...]:
    """The limits that a text means: one, two for an equation, more where bars have a constant.

    Raises FormulaError with everything that is wrong: no comparison of two sums, one that leaves
    out its end, absolute values on the large side, where the limit would not be convex.

    >>> [str(limit) for limit in limits("2 >= |u1| + |u2 - u1|")]
    ['|u1| + |u1 - u2| <= 2']
    >>> [str(limit) for limit in limits("|x - 3| <= 1")]
    ['x <= 4', '-x <= -2']
    """
    inside: list[tuple[str, int]] = []

    def hidden(match: re.Match[str]) -> str:
        if match[1] is None:
            return match[0]
        inside.append((match[1], match.start(1)))
        return f'"{chr(_FIRST_PRIVATE + len(inside) - 1) * len(match[1])}"'

    outer = _BARS.sub(hidden, text)
    for match in _RELATION.finditer(outer):
        if match[1] == "|":
            what, remedy = "this bar is never closed", "write absolute values as |x - y|"
            raise FormulaError([_finding(text, match.start(), what, remedy)])
    sums = [_between(text, part, start) for part, start in inside]
    names = {chr(_FIRST_PRIVATE + n) * len(part): n for n, (part, _) in enumerate(inside)}
    try:
        made = parse(outer, "stl")
    except FormulaError as error:
        raise FormulaError(_spoken(error.findings, inside)) from None
    if not isinstance(made, Linear):
        what, remedy = "this is no limit", "compare two sums, such as |u1| + |u2| <= 1"
        raise FormulaError([_finding(text, 0, what, remedy)])
    return _oriented(text, made, {name: sums[n] for name, n in names.items()})


def _between(text: str, part: str, start: int) -> Sum:
    """The sum between two bars, its findings at their places in the whole text."""
    if not part.strip():
        what, remedy = "there is nothing between the bars", "write absolute values as |x - y|"
        raise FormulaError([_finding(text, start - 1, what, remedy)])
    return expression(re.sub(r"[^\n]", " ", text[:start]) + part)


def _spoken(findings: Iterable[Finding], inside: list[tuple[str, int]]) -> Iterable[Finding]:
    """Findings in which what stands between bars is told again."""
    for item in findings:
        message, remedy = item.message, item.remedy
        for number, (part, _) in enumerate(inside):
            name = f'"{chr(_FIRST_PRIVATE + number) * len(part)}"'
            message, remedy = (words.replace(name, f"|{part}|") for words in (message, remedy))
        yield replace(item, message=message, remedy=remedy)


def _oriented(text: str, made: Linear, bars: Mapping[str, Sum]) -> tuple[Limit, ...]:
    """The limits of a comparison, in which names stand for absolute values."""
    if made.relation not in ("<=", ">=", "="):
        what, remedy = "a limit includes its end", "write <= or >="
        raise FormulaError([_finding(text, 0, what, remedy)])
    found: list[Limit] = []
    for sign in {"<=": (1.0,), ">=": (-1.0,), "=": (1.0, -1.0)}[made.relation]:
        plain = tuple((name, sign * factor) for name, factor in made.terms if name not in bars)
        sized = [(sign * factor, *bars[name]) for name, factor in made.terms if name in bars]
        if any(factor < 0 for factor, _, _ in sized):
            what = "an absolute value stands on the large side, and what it allows is not convex"
            remedy = "keep |...| on the small side of <=, or ask for it in the formula"
            raise FormulaError([_finding(text, text.index("|"), what, remedy)])
        if sum(constant != 0 for _, _, constant in sized) > _MOST_SIDES:
            what = f"more than {_MOST_SIDES} absolute values have constants"
            raise FormulaError([_finding(text, 0, what, "write several limits")])
        found += _sides(plain, sized, sign * made.bound)
    return tuple(found)


def _sides(plain: Terms, sized: list[tuple[float, Terms, float]], bound: float) -> Iterable[Limit]:
    """A limit whose absolute values have no constants: of those that have, both sides."""
    shifted = [entry for entry in sized if entry[2]]
    absolute = tuple((factor, terms) for factor, terms, constant in sized if not constant)
    for signs in product((1.0, -1.0), repeat=len(shifted)):
        added = [
            (sign * factor, (terms, constant))
            for sign, (factor, terms, constant) in zip(signs, shifted, strict=True)
        ]
        terms, constant = total([(1.0, (plain, -bound)), *added])
        yield Limit(terms, absolute, 0.0 - constant)


def total(sums: Iterable[tuple[float, Sum]]) -> Sum:
    """Sums added up, each with a factor: exact decimals, terms by name and none that is 0.

    >>> total([(0.1, expression("x + 3")), (0.2, expression("x"))])
    ((('x', 0.3),), 0.3)
    """
    factors: dict[str, Fraction] = {}
    constant = Fraction(0)
    for given, (terms, more) in sums:
        by = exact(given)
        for name, factor in terms:
            factors[name] = factors.get(name, Fraction(0)) + by * exact(factor)
        constant += by * exact(more)
    return tuple((name, float(factors[name])) for name in sorted(factors) if factors[name]), float(
        constant
    )


def _finding(text: str, offset: int, message: str, remedy: str) -> Finding:
    before = text[:offset]
    return Finding(message, remedy, line=before.count("\n") + 1, column=offset - before.rfind("\n"))
