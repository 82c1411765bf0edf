"""Syntax trees as values: which method reads a part, where it stands, what is wrong with it."""

from __future__ import annotations

from typing import Any

from antlr4.tree.Tree import ErrorNode

from tsplan.errors import Finding
from tsplan.logic.parser.given import Given
from tsplan.logic.parser.source import Source
from tsplan.logic.text_spans import Span


class Reading:
    """Reads the syntax trees of one text, stream after stream.

    `groups` holds the values of parts that were cut out, by the offset of their parenthesis.
    """

    def __init__(self, source: Source, given: Given) -> None:
        self.source = source
        self.given = given
        self.findings: list[Finding] = []
        self.groups: dict[int, Any] = {}

    def read(self, part: Any) -> Any:
        """The value of a part of the syntax tree; None if something in it is wrong."""
        children = part.children or ()
        if part.exception is not None or any(isinstance(child, ErrorNode) for child in children):
            # words such as operators are read by the rule above them and have no reader
            for child in children:
                if hasattr(child, "getRuleIndex") and hasattr(self, _reader_of(child)):
                    self.read(child)
            return None
        return getattr(self, _reader_of(part))(part)

    def complain(self, part: Any, message: str, remedy: str = "") -> None:
        """Note that a part of the tree, or a token, is wrong."""
        start = getattr(part, "start", part)
        offset = start if isinstance(start, int) else start.start
        self.findings.append(self.source.finding(offset, message, remedy))

    def quote(self, first: Any, last: Any) -> str:
        """The text from one part of the tree to another; an ellipsis for one that is missing."""
        if last.stop is None:
            return "..."
        return self.source.quote(first.start.start, last.stop.stop)


def reach(*parts: Any) -> Span:
    """Where a part of the tree stands, or all from the first to the last."""
    return Span(parts[0].start.start, parts[-1].stop.stop + 1)


def _reader_of(part: Any) -> str:
    """The name of the method that reads parts of this rule."""
    return f"read_{part.parser.ruleNames[part.getRuleIndex()]}"
