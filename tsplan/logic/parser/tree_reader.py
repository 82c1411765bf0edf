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

from tsplan.logic import nodes
from tsplan.logic.derived import DERIVED, stands_for
from tsplan.logic.nodes import FALSE, TRUE, Formula
from tsplan.logic.parser.numerals import exact, whole
from tsplan.logic.parser.reading import reach
from tsplan.logic.parser.weight_reader import Interval, WeightReader
from tsplan.logic.text_spans import Span, Written
from tsplan.logic.traversal import fold

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

JOINS: Mapping[str, type[Formula]] = MappingProxyType({"AND": nodes.And, "OR": nodes.Or})
"""Operators before a list of parts."""


class Listed(NamedTuple):
    """Several values in parentheses, with their parts of the tree."""

    values: Sequence[Any]
    parts: Sequence[Any]


IMPLIED: Mapping[str, Interval] = MappingProxyType({"NEXT": Interval((1, 1))})
"""What operators mean that have no interval in the text, if that is any."""


class Reader(WeightReader, ABC):
    """Reads the rules of the shared grammar."""

    quantities: tuple[type, ...]
    """Classes of values that are numbers rather than formulas."""

    @abstractmethod
    def formula(self, value: Any, part: Any) -> Written | None:
        """The value as a formula; if it is none, a finding says so."""

    def read_formula(self, part: Any) -> Any:
        """Read a whole stream; the value is not yet asked to be a formula."""
        return Listed([self.read(level) for level in part.level()], part.level())

    def alone(self, value: Any) -> Any:
        """A value that is one; if there are several in a list, a finding says so."""
        if not isinstance(value, Listed):
            return value
        if len(value.values) == 1:
            return value.values[0]
        if None in value.values:  # what is wrong there may have had the comma
            return None
        remedy = "join it with an operator such as && or ||, or remove it"
        comma = value.parts[0].stop.stop + 1
        comma += self.source.text[comma:].index(",")
        self.complain(comma, "',' is left over after the formula", remedy)
        return None

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
        return self._alternatives(parts, sure, joins, intervals)

    def read_unary(self, part: Any) -> Any:
        """Apply prefixes to a comparison, the innermost first."""
        inner = part.comparison() or part.joined()
        value = self.read(inner)
        prefixes = part.prefix()
        if not prefixes:
            return value
        intervals = [self.read(prefix) for prefix in prefixes]
        formula = self.formula(value, inner)
        if formula is None or None in intervals:
            return None
        for prefix, interval in zip(reversed(prefixes), reversed(intervals), strict=True):
            word, span = prefix.start.text, reach(prefix, part)
            if word in DERIVED:
                formula = self._derived(prefix, [formula], span, interval.steps)
            else:
                formula = _applied(PREFIXES[_kind(prefix)], interval, [formula], span)
            if formula is None:
                return None
        return formula

    def read_prefix(self, part: Any) -> Interval | None:
        """Read the interval of an operator and its weight, if it has them."""
        interval = IMPLIED.get(_kind(part), Interval())
        if part.interval():
            interval = self.read(part.interval())
        weight = _weight(part)
        if weight is None:
            return interval
        mark = self.read(weight)
        if interval is None or mark is None:
            return None
        if not interval.steps:
            return interval._replace(mark=mark)
        low, high = interval.steps
        return self.weighed(interval, mark, range(low, high + 1), "step")

    read_connective = read_prefix

    def read_joined(self, part: Any) -> Written | None:
        """Read a list of parts that the operator before them joins."""
        weight, word = _weight(part), part.start.text
        mark = None if weight is None else self.read(weight)
        listed = self.read(part.parts())
        if listed is None or (weight is not None and mark is None):
            return None
        operands = [self.formula(*each) for each in zip(*listed, strict=True)]
        sure = [operand for operand in operands if operand is not None]
        if len(sure) < len(operands):
            return None
        if len(sure) == 1 and word != "all":
            self.complain(part, f"'{word}' joins one formula alone", f"write two: {word} (a, b)")
            return None
        if word in DERIVED:
            return self._derived(part, sure, reach(part))
        return self._joined(JOINS[_kind(part)], sure, reach(part), [(part, Interval(mark=mark))])

    def read_parts(self, part: Any) -> Listed | None:
        """Read a list in parentheses, of one or more; what a GROUP token stands for."""
        if not part.GROUP():
            return Listed([self.read(level) for level in part.level()], part.level())
        value: Listed | None = self.groups[part.start.start]
        return value

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
        """Read the smallest part, which is in parentheses or what it is by itself."""
        return self.alone(self.read(part.children[0]))

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

    def _alternatives(
        self, parts: list[Any], operands: list[Written], joins: list[Any], marks: list[Interval]
    ) -> Written | None:
        """Join operands with && and ||, of which && binds tighter."""
        between = list(zip(joins, marks, strict=True))
        ends = [n for n, join in enumerate(joins, start=1) if _kind(join) != "AND"]
        choices = [
            self._joined(
                nodes.And,
                operands[first:end],
                reach(parts[first], parts[end - 1]),
                between[first : end - 1],
            )
            for first, end in pairwise([0, *ends, len(parts)])
        ]
        return self._joined(nodes.Or, choices, reach(*parts), [between[end - 1] for end in ends])

    def _joined(
        self,
        kind: type[Formula],
        operands: Sequence[Written | None],
        span: Span,
        joins: Sequence[tuple[Any, Interval]],
    ) -> Written | None:
        """Operands under one connective with one weight at most; a single one is itself."""
        if None in operands or len(operands) == 1:
            return operands[0]
        sure = [operand for operand in operands if operand is not None]
        (first, interval), *others = joins
        for join, other in others:
            if _key(other) != _key(interval):
                signs = f"'{self.quote(first, first)}' and '{self.quote(join, join)}'"
                remedy = "put in parentheses what each of them joins"
                self.complain(join, f"{signs} join parts of one level", remedy)
                return None
        if interval.mark is not None:
            made = self.weighed(Interval(), interval.mark, range(len(operands)), "part")
            return None if made is None else _applied(kind, made, sure, span)
        return _applied(kind, interval, sure, span)

    def _derived(
        self, part: Any, operands: Sequence[Written], span: Span, steps: Sequence[int] = ()
    ) -> Written | None:
        """What a derived operator stands for; its operands stay where they are written."""
        try:
            formula = stands_for(part.start.text, [each.formula for each in operands], steps)
        except ValueError as error:
            remedy = "write it for fewer parts or steps, or say in another way what is meant"
            self.complain(part, str(error), remedy)
            return None
        known = {each.formula: each for each in operands}

        def written(node: Formula, below: tuple[Written, ...]) -> Written:
            return known.get(node) or Written(node, span, below)

        whole = fold(formula, written)
        return Written(formula, span, whole.children)


def _applied(
    kind: type[Formula], interval: Interval, operands: Sequence[Written], span: Span
) -> Written:
    """An operator with its interval over its operands."""
    formula = kind.assembled(interval.steps, (operand.formula for operand in operands))
    return Written(formula, span, tuple(operands), interval.parts)


def _weight(part: Any) -> Any:
    """The weight after an operator; None where it has none, as in languages without weights."""
    return part.weight() if hasattr(part, "weight") else None


def _key(interval: Interval) -> object:
    return None if interval.mark is None else interval.mark.key


def _kind(part: Any) -> str:
    """Name of the token that an operator begins with."""
    name: str = part.parser.symbolicNames[part.start.type]
    return name
