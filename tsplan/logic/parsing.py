"""Reading formulas from text."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal, TypeAlias

from tsplan.errors import Finding, FormulaError, nearest
from tsplan.logic.nodes import Formula
from tsplan.logic.parser.given import Given
from tsplan.logic.text_spans import Written
from tsplan.logic.weight_values import Weight

Language: TypeAlias = Literal["mtl", "stl", "catl", "wmtl", "wstl"]

LANGUAGES: tuple[Language, ...] = ("mtl", "stl", "catl", "wmtl", "wstl")


def parse(
    text: str, language: Language = "mtl", *, weights: Mapping[str, Weight] | None = None
) -> Formula:
    """The formula that a text means.

    `mtl` counts agents at labels, `catl` has tasks and limits besides, `stl` compares signals;
    `wmtl` and `wstl` have weights after operators besides, whose names `weights` explains: each is
    a number, or numbers for parts 0, 1, ... or for the steps of a window, in order, by index or as
    a function of it (see `tsplan.logic.weight_values`).

    Raises FormulaError with everything that is wrong, each with line, column and remedy; weights
    that the text does not name are wrong too.

    >>> parse("F[0,5] depot && [][0,9] !fire")
    <And: F[0,5] depot && G[0,9] !fire>
    >>> parse("x >= 3 &&^w F[0,1]^0.5 y <= 1", "wstl", weights={"w": [0.2, 0.8]})
    <And: &&^[0.2, 0.8] (x >= 3, F[0,1]^0.5 (y <= 1))>
    """
    formula, written = parse_with_places(text, language, weights=weights)
    unused = sorted(set(weights or ()) - written.weight_names)
    if unused:
        remedy = "write ^ and its name after an operator, or leave it out"
        raise FormulaError([Finding(f"no operator has the weights '{n}'", remedy) for n in unused])
    return formula


def parse_with_places(
    text: str, language: Language = "mtl", *, weights: Mapping[str, Weight] | None = None
) -> tuple[Formula, Written]:
    """The formula that a text means, and where each of its occurrences stands.

    As `parse`, but several texts may share the weights, so each may leave some of them unused.

    >>> formula, written = parse_with_places("a && F[0,2] b")
    >>> written[1, 0]
    Span(begin=12, end=13)
    """
    if language not in LANGUAGES:
        message = f"'{language}' is no language of formulas"
        raise FormulaError([Finding(message, nearest(language, LANGUAGES))])
    from tsplan.logic.parser.languages import read  # noqa: PLC0415  (ANTLR is slow to import)

    written = read(text.removeprefix("\ufeff"), language, Given(weights or {}))
    return written.formula, written
