"""Reading formulas from text."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal, TypeAlias

from tsplan.errors import Finding, FormulaError, nearest
from tsplan.logic.boxes import Box
from tsplan.logic.nodes import Formula
from tsplan.logic.parser.given import Definition, Given
from tsplan.logic.text_spans import Written
from tsplan.logic.weight_values import Weight
from tsplan.words import nfc

Language: TypeAlias = Literal["mtl", "stl", "catl", "wmtl", "wstl"]

LANGUAGES: tuple[Language, ...] = ("mtl", "stl", "catl", "wmtl", "wstl")


def parse(
    text: str,
    language: Language = "mtl",
    *,
    weights: Mapping[str, Weight] | None = None,
    regions: Mapping[str, Box] | None = None,
    definitions: Mapping[str, Definition] | None = None,
) -> Formula:
    """The formula that a text means.

    `mtl` counts agents at labels, `catl` has tasks and limits besides, `stl` compares signals.
    `wmtl` and `wstl` have weights after operators besides, whose names `weights` explains: each is
    a number, or numbers for parts 0, 1, ... or for the steps of a window, in order, by index or as
    a function of it (see `tsplan.logic.weight_values`).

    Over signals, `in(goal)`, `out(goal)` and `clear(goal)` speak of `regions`, each the ends of a
    box by its axes; `in(a, goal)` has the axes `a_x`, `a_y` of one robot of several. `definitions`
    are names of linear expressions: the factors of signals, and a constant.

    Raises FormulaError with everything that is wrong, each with line, column and remedy; weights
    that the text does not name are wrong too.

    >>> parse("F[0,5] depot && [][0,9] !fire")
    <And: F[0,5] depot && G[0,9] !fire>
    >>> parse("x >= 3 &&^w F[0,1]^0.5 y <= 1", "wstl", weights={"w": [0.2, 0.8]})
    <And: &&^[0.2, 0.8] (x >= 3, F[0,1]^0.5 (y <= 1))>
    >>> parse("in(goal)", "stl", regions={"goal": {"x": (7, 8)}})
    <And: x >= 7 && x <= 8>
    >>> parse("2*gap > 2", "stl", definitions={"gap": ({"x": 1, "y": -1}, 0.5)})
    <Linear: 2*x - 2*y > 1>
    """
    formula, written = parse_with_places(
        text, language, weights=weights, regions=regions, definitions=definitions
    )
    unused = sorted({nfc(name) for name in weights or ()} - written.weight_names)
    if unused:
        remedy = "write ^ and its name after an operator, or leave it out"
        raise FormulaError([Finding(f"no operator has the weights '{n}'", remedy) for n in unused])
    return formula


def parse_with_places(
    text: str,
    language: Language = "mtl",
    *,
    weights: Mapping[str, Weight] | None = None,
    regions: Mapping[str, Box] | None = None,
    definitions: Mapping[str, Definition] | None = None,
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

    given = Given(weights or {}, regions or {}, definitions or {})
    written = read(text.removeprefix("\ufeff"), language, given)
    return written.formula, written
