"""Reading formulas from text."""

from __future__ import annotations

from typing import Literal, TypeAlias

from tsplan.errors import Finding, FormulaError, nearest
from tsplan.logic.nodes import Formula
from tsplan.logic.text_spans import Written

Language: TypeAlias = Literal["mtl", "stl", "catl"]

LANGUAGES: tuple[Language, ...] = ("mtl", "stl", "catl")


def parse(text: str, language: Language = "mtl") -> Formula:
    """The formula that a text means.

    `mtl` counts agents at labels, `catl` has tasks and limits besides, `stl` compares signals.
    Raises FormulaError with everything that is wrong, each with line, column and remedy.

    >>> parse("F[0,5] depot && [][0,9] !fire")
    <And: F[0,5] depot && G[0,9] !fire>
    """
    return parse_with_places(text, language)[0]


def parse_with_places(text: str, language: Language = "mtl") -> tuple[Formula, Written]:
    """The formula that a text means, and where each of its occurrences stands.

    >>> formula, written = parse_with_places("a && F[0,2] b")
    >>> written[1, 0]
    Span(begin=12, end=13)
    """
    if language not in LANGUAGES:
        message = f"'{language}' is no language of formulas"
        raise FormulaError([Finding(message, nearest(language, LANGUAGES))])
    from tsplan.logic.parser.languages import read  # noqa: PLC0415  (ANTLR is slow to import)

    written = read(text.removeprefix("\ufeff"), language)
    return written.formula, written
