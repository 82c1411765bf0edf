"""Building formulas from syntax trees: what all languages share.

A reader has one method per grammar rule, `read_<rule>`, that returns the value of a part: a
formula, or something of the language's own (a number, a count, a linear expression). None stands
for a part that is wrong; its findings are collected and the rest is read on.
"""

from __future__ import annotations

import re
from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from itertools import pairwise
from types import MappingProxyType
from typing import Any, NamedTuple

from antlr4.tree.Tree import ErrorNode

from tsplan.errors import Finding
from tsplan.logic import nodes
from tsplan.logic.nodes import FALSE, TRUE, Formula
from tsplan.logic.parser.numerals import exact, whole
from tsplan.logic.parser.source import Source
from tsplan.logic.text_spans import Span, Way, Written

PREFIXES: Mapping[str, type[Formula]] = MappingProxyType(
    {
        "NOT": nodes.Not,
        "NEXT": nodes.Eventually,
        "EVENTUALLY": nodes.Eventually,
        "DIAMOND": nodes.Eventually,
        "ALWAYS": nodes.Always,
        "BOX": nodes.Always,
    }
)
"""Operators before their operand, by the name of their token."""

CONNECTIVES: Mapping[str, type[Formula]] = MappingProxyType(
    {"IMPLIES": nodes.Implies, "IFF": nodes.Iff, "UNTIL": nodes.Until, "RELEASE": nodes.Release}
)
"""Operators between two operands that never share a level with others."""


class Interval(NamedTuple):
    """The steps of an operator, and what is written of them; neither for one without time."""

    steps: tuple[int, ...] = ()
    parts: Mapping[Way, Span] = MappingProxyType({})


IMPLIED: Mapping[str, Interval] = MappingProxyType({"NEXT": Interval((1, 1))})
"""What operators mean that have no interval in the text, if that is any."""


class Reader(ABC):
    """Reads the syntax trees of one text, stream after stream.

    `groups` holds the values of parts that were cut out, by the offset of their parenthesis.
    """

    def __init__(self, source: Source) -> None:
        self.source = source
        self.findings: list[Finding] = []
        self.groups: dict[int, Any] = {}

    quantities: tuple[type, ...]
    """Classes of values that are numbers rather than formulas."""

    @abstractmethod
    def formula(self, value: Any, part: Any) -> Written | None:
        """The value as a formula; if it is none, a finding says so."""

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

    # --- rules of the shared grammar ---

    def read_formula(self, part: Any) -> Any:
        """Read a whole stream; the value is not yet asked to be a formula."""
        return self.read(part.level())

    def read_level(self, part: Any) -> Any:
        """Read operands of one level and join them."""
        parts, joins = part.unary(), part.connective()
        values = [self.read(operand) for operand in parts]
        if not joins:
            return values[0]
        intervals = [self.read(join) for join in joins]
        kinds = [_kind(join) for join in joins]
        if self._compares(parts, values, joins):
            return None
        operands = [self.formula(value, at) for value, at in zip(values, parts, strict=True)]
        if self._mixed(parts, joins) or None in operands or None in intervals:
            return None
        sure = [operand for operand in operands if operand is not None]
        if kinds[0] in CONNECTIVES:
            return _applied(CONNECTIVES[kinds[0]], intervals[0], sure, reach(*parts))
        return self._alternatives(parts, sure, kinds)

    def read_unary(self, part: Any) -> Any:
        """Apply prefixes to a comparison, the innermost first."""
        value = self.read(part.comparison())
        prefixes = part.prefix()
        if not prefixes:
            return value
        intervals = [self.read(prefix) for prefix in prefixes]
        formula = self.formula(value, part.comparison())
        if formula is None or None in intervals:
            return None
        for prefix, interval in zip(reversed(prefixes), reversed(intervals), strict=True):
            operator = PREFIXES[_kind(prefix)]
            formula = _applied(operator, interval, [formula], reach(prefix, part))
        return formula

    def read_prefix(self, part: Any) -> Interval | None:
        """Read the interval of an operator, if it has one."""
        written: Interval | None = self.read(part.interval()) if part.interval() else None
        return written if part.interval() else IMPLIED.get(_kind(part), Interval())

    read_connective = read_prefix

    def read_interval(self, part: Any) -> Interval | None:
        """Read two whole numbers of steps, in order."""
        low, high = (self.read(bound) for bound in part.bound())
        if low is None or high is None:
            return None
        if low > high:
            remedy = f"write the smaller bound first: [{high},{low}]"
            self.complain(part, f"the interval [{low},{high}] ends before it begins", remedy)
            return None
        parts = zip(("interval", "low", "high"), (part, *part.bound()), strict=True)
        return Interval((low, high), {(name,): reach(at) for name, at in parts})

    def read_bound(self, part: Any) -> int | None:
        """Read a whole number of steps from now on."""
        text = self.quote(part, part).replace(" ", "")
        steps = whole(exact(text))
        if steps is None:
            remedy = "time goes in whole steps; write a whole number of at most 15 digits"
            self.complain(part, f"the bound {text} is not a whole number of steps", remedy)
        elif steps < 0:
            remedy = "intervals begin at 0 or later"
            self.complain(part, f"the bound {text} lies before now", remedy)
            return None
        return steps

    def read_constant(self, part: Any) -> Written:
        """Read true or false."""
        return Written(TRUE if part.TRUE() else FALSE, reach(part))

    def read_name(self, part: Any) -> str | None:
        """Read a label, capability or signal, with or without quotes."""
        text: str = part.getText()
        if not part.STRING():
            return text
        name = re.sub(r"\\(.)", r"\1", text[1:-1])
        if not name:
            self.complain(part, "a name in quotes is empty", "write at least one character")
        return name or None

    def read_operand(self, part: Any) -> Any:
        """Read the smallest part: what a GROUP token stands for, or the only sub-part."""
        if part.GROUP():
            return self.groups[part.start.start]
        return self.read(next(child for child in part.children if hasattr(child, "getRuleIndex")))

    # --- joining the operands of a level ---

    def _compares(self, parts: list[Any], values: list[Any], joins: list[Any]) -> bool:
        """Whether '=>' was written where '>=' is meant; then a finding says so."""
        for place, join in enumerate(joins):
            if _kind(join) == "IMPLIES" and isinstance(values[place + 1], self.quantities):
                left, right = (self.quote(part, part) for part in parts[place : place + 2])
                message = f"'{join.getText()}' means 'implies', and '{right}' is no formula"
                self.complain(join, message, f"to compare, write {left} >= {right}")
                return True
        return False

    def _mixed(self, parts: list[Any], joins: list[Any]) -> bool:
        """Whether operators share a level that tools group differently; then a finding says so."""
        for place in range(len(joins) - 1):
            if CONNECTIVES.keys() & {_kind(join) for join in joins[place : place + 2]}:
                texts = [self.quote(part, part) for part in parts[place : place + 3]]
                first, second = (self.quote(join, join) for join in joins[place : place + 2])
                left = f"({texts[0]} {first} {texts[1]}) {second} {texts[2]}"
                right = f"{texts[0]} {first} ({texts[1]} {second} {texts[2]})"
                message = f"'{first}' and '{second}' need parentheses: tools read them differently"
                self.complain(joins[place + 1], message, f"write {left} or {right}")
                return True
        return False

    def _alternatives(self, parts: list[Any], operands: list[Written], kinds: list[str]) -> Written:
        """Join operands with && and ||, of which && binds tighter."""
        ends = [0, *(n for n, kind in enumerate(kinds, start=1) if kind != "AND"), len(parts)]
        choices = [
            _joined(nodes.And, operands[first:end], parts[first:end])
            for first, end in pairwise(ends)
        ]
        return _joined(nodes.Or, choices, parts)


def reach(first: Any, last: Any = None) -> Span:
    """Where a part of the tree stands, or all from one to another."""
    return Span(first.start.start, (last or first).stop.stop + 1)


def _applied(
    kind: type[Formula], interval: Interval, operands: Sequence[Written], span: Span
) -> Written:
    """An operator with its interval over its operands."""
    formula = kind.assembled(interval.steps, (operand.formula for operand in operands))
    return Written(formula, span, tuple(operands), interval.parts)


def _joined(kind: type[Formula], operands: Sequence[Written], parts: Sequence[Any]) -> Written:
    """Operands under one connective; a single one is itself."""
    if len(operands) == 1:
        return operands[0]
    return _applied(kind, Interval(), operands, reach(parts[0], parts[-1]))


def _kind(part: Any) -> str:
    """Name of the token that an operator begins with."""
    name: str = part.parser.symbolicNames[part.start.type]
    return name


def _reader_of(part: Any) -> str:
    """The name of the method that reads parts of this rule."""
    return f"read_{part.parser.ruleNames[part.getRuleIndex()]}"
