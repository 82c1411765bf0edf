"""Reading formulas from text."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal, TypeAlias

from tsplan.errors import Finding, FormulaError, nearest
from tsplan.logic.nodes import Formula

Language: TypeAlias = Literal["mtl", "stl", "catl"]
Place: TypeAlias = "tuple[int, int, int, int]"

LANGUAGES: tuple[Language, ...] = ("mtl", "stl", "catl")


def parse(text: str, language: Language = "mtl") -> Formula:
    """The formula that a text means.

    `mtl` counts agents at labels, `catl` has tasks and limits besides, `stl` compares signals.
    Raises FormulaError with everything that is wrong, each with line, column and remedy.

    >>> parse("F[0,5] depot && [][0,9] !fire")
    <And: F[0,5] depot && G[0,9] !fire>
    """
    return parse_with_places(text, language)[0]


def parse_with_places(
    text: str, language: Language = "mtl"
) -> tuple[Formula, Mapping[Formula, tuple[Place, ...]]]:
    """The formula that a text means, and where its sub-formulas stand.

    A place is (line, column, end line, end column), all from 1; the end is just after the last
    character. A sub-formula that is written several times has as many places.

    >>> formula, places = parse_with_places("a && F[0,2] b")
    >>> places[parse("b")]
    ((1, 13, 1, 14),)
    """
    if language not in LANGUAGES:
        message = f"'{language}' is no language of formulas"
        raise FormulaError([Finding(message, nearest(language, LANGUAGES))])
    from tsplan.logic.parser.languages import read  # noqa: PLC0415  (ANTLR is slow to import)

    return read(text.removeprefix("\ufeff"), language)
