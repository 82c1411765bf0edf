"""Which lexer, parser and reader make up a language; and reading a text with them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from importlib import import_module
from types import MappingProxyType
from typing import Any

from antlr4 import CommonTokenStream, PredictionMode
from antlr4.ListTokenSource import ListTokenSource

from tsplan.errors import Finding, FormulaError
from tsplan.limits import MOST_LETTERS
from tsplan.logic.parser.count_reader import CountReader
from tsplan.logic.parser.given import Given
from tsplan.logic.parser.signal_reader import SignalReader
from tsplan.logic.parser.source import Source
from tsplan.logic.parser.syntax_errors import Complaints
from tsplan.logic.parser.token_streams import Stream, Streams
from tsplan.logic.parser.tree_reader import Reader
from tsplan.logic.text_spans import Written

READERS: Mapping[str, type[Reader]] = MappingProxyType(
    {
        "mtl": CountReader,
        "catl": CountReader,
        "stl": SignalReader,
        "wmtl": CountReader,
        "wstl": SignalReader,
    }
)

WEIGHTED: Mapping[type[Reader], str] = MappingProxyType({CountReader: "wmtl", SignalReader: "wstl"})
"""The language with weights that has the atoms of others."""


@dataclass(frozen=True, eq=False)
class Grammar:
    """The generated classes of a language."""

    lexer: Any
    parser: Any


@cache
def grammar(language: str) -> Grammar:
    """Load what was generated for a language, once."""
    loaded = (
        getattr(import_module(f"tsplan.logic.generated.{language}{kind}"), f"{language}{kind}")
        for kind in ("Lexer", "Parser")
    )
    return Grammar(*loaded)


def read(text: str, language: str, given: Given) -> Written:
    """The formula of a text, and where in the text its sub-formulas stand.

    Raises FormulaError with everything that is wrong.
    """
    source = Source(text)
    if not text.strip():
        remedy = "write a formula; 'true' asks for nothing"
        raise FormulaError([source.finding(0, "the formula is empty", remedy)])
    if len(text) > MOST_LETTERS:
        what = f"a formula of {len(text):,} characters; at most {MOST_LETTERS:,} are read"
        raise FormulaError([source.finding(0, what, "say it with fewer, as by labels and windows")])
    generated = grammar(language)
    reader = READERS[language](source, given)
    streams = Streams(source, generated.lexer, generated.parser, WEIGHTED[type(reader)])
    findings: list[Finding] = []
    formula = None
    for stream in streams:
        complaints = Complaints(source, generated.parser, streams.strays)
        tree = _parsed(stream, generated.parser, complaints)
        if stream.balanced:
            findings += complaints.findings
        value = reader.read(tree)
        if stream.opener is not None:
            reader.groups[stream.opener.start] = value
        else:
            formula = reader.formula(reader.alone(value), tree)
    if streams.misread:  # what else is wrong comes of that
        findings, reader.findings = [], []
    findings += [*streams.findings, *reader.findings]
    if findings or formula is None:
        raise FormulaError(sorted(dict.fromkeys(findings), key=_order))
    return formula


def _parsed(stream: Stream, parser_class: Any, complaints: Complaints) -> Any:
    """The syntax tree of a stream; what is wrong goes to `complaints`."""
    parser = parser_class(CommonTokenStream(ListTokenSource(stream.tokens)))
    parser._interp.predictionMode = PredictionMode.SLL  # noqa: SLF001  (ANTLR's documented way)
    parser.removeErrorListeners()
    parser.addErrorListener(complaints)
    return parser.formula()


def _order(finding: Finding) -> tuple[int, int]:
    return finding.line or 0, finding.column or 0
