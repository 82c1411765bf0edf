"""Building formulas from syntax trees: what all languages share.

A reader has one method per grammar rule, `read_<rule>`, that returns the value of a part: a
formula, or something of the language's own (a number, a count, a linear expression). None stands
for a part that is wrong; its findings are collected and the rest is read on.
"""

from __future__ import annotations

import re
from abc import ABC, abstractmethod
from collections import defaultdict
from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Any, TypeAlias

from antlr4.tree.Tree import ErrorNode

from tsplan.errors import Finding
from tsplan.logic.nodes import (
    FALSE,
    TRUE,
    Always,
    And,
    Eventually,
    Formula,
    Iff,
    Implies,
    Not,
    Or,
    Release,
    Until,
)
from tsplan.logic.parser.numerals import exact, whole
from tsplan.logic.parser.source import Place, Source

Interval: TypeAlias = "tuple[int, int]"

PREFIXES: Mapping[str, Callable[[Interval, Formula], Formula]] = MappingProxyType(
    {
        "NOT": lambda _interval, child: Not(child),
        "NEXT": lambda _interval, child: Eventually(1, 1, child),
        "EVENTUALLY": lambda interval, child: Eventually(*interval, child),
        "DIAMOND": lambda interval, child: Eventually(*interval, child),
        "ALWAYS": lambda interval, child: Always(*interval, child),
        "BOX": lambda interval, child: Always(*interval, child),
    }
)
"""Operators before their operand, by the name of their token."""

CONNECTIVES: Mapping[str, Callable[[Interval, Formula, Formula], Formula]] = MappingProxyType(
    {
        "IMPLIES": lambda _interval, left, right: Implies(left, right),
        "IFF": lambda _interval, left, right: Iff(left, right),
        "UNTIL": lambda interval, left, right: Until(*interval, left, right),
        "RELEASE": lambda interval, left, right: Release(*interval, left, right),
    }
)
"""Operators between two operands that never share a level with others."""

TIMELESS: Interval = (0, 0)  # stands where an operator has no interval


class Reader(ABC):
    """Reads the syntax trees of one text, stream after stream.

    `groups` holds the values of parts that were cut out, by the offset of their parenthesis.
    """

    def __init__(self, source: Source) -> None:
        self.source = source
        self.findings: list[Finding] = []
        self.groups: dict[int, Any] = {}
        self._places: dict[Formula, dict[Place, None]] = defaultdict(dict)

    quantities: tuple[type, ...]
    """Classes of values that are numbers rather than formulas."""

    @abstractmethod
    def formula(self, value: Any, part: Any) -> Formula | None:
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

    def places(self) -> dict[Formula, tuple[Place, ...]]:
        """Where each formula stands in the text, in the order of the text."""
        return {formula: tuple(sorted(places)) for formula, places in self._places.items()}

    def complain(self, part: Any, message: str, remedy: str = "") -> None:
        """Note that a part of the tree, or a token, is wrong."""
        start = getattr(part, "start", part)
        offset = start if isinstance(start, int) else start.start
        self.findings.append(self.source.finding(offset, message, remedy))

    def placed(self, formula: Formula, first: Any, last: Any) -> Formula:
        """Remember that a formula reaches from one part of the tree to another."""
        self._places[formula][self.source.place(first.start.start, last.stop.stop)] = None
        return formula

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
            joined = CONNECTIVES[kinds[0]](intervals[0], sure[0], sure[1])
            return self.placed(joined, parts[0], parts[1])
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
            formula = PREFIXES[_kind(prefix)](interval, formula)
            self.placed(formula, prefix, part)
        return formula

    def read_prefix(self, part: Any) -> Interval | None:
        """Read the interval of an operator; `TIMELESS` for one that has none."""
        return self.read(part.interval()) if part.interval() else TIMELESS

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
        return low, high

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

    def read_constant(self, part: Any) -> Formula:
        """Read true or false."""
        return TRUE if part.TRUE() else FALSE

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

    def _alternatives(self, parts: list[Any], operands: list[Formula], kinds: list[str]) -> Formula:
        """Join operands with && and ||, of which && binds tighter."""
        groups = [[(operands[0], parts[0])]]
        for kind, operand, part in zip(kinds, operands[1:], parts[1:], strict=True):
            if kind == "AND":
                groups[-1].append((operand, part))
            else:
                groups.append([(operand, part)])
        choices = []
        for group in groups:
            members = tuple(operand for operand, _ in group)
            one = members[0]
            if len(members) > 1:
                one = self.placed(And(members), group[0][1], group[-1][1])
            choices.append(one)
        if len(choices) == 1:
            return choices[0]
        return self.placed(Or(tuple(choices)), parts[0], parts[-1])


def _kind(part: Any) -> str:
    """Name of the token that an operator begins with."""
    name: str = part.parser.symbolicNames[part.start.type]
    return name


def _reader_of(part: Any) -> str:
    """The name of the method that reads parts of this rule."""
    return f"read_{part.parser.ruleNames[part.getRuleIndex()]}"
