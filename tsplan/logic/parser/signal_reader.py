"""Reading linear predicates over signals (STL)."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import Any, cast

from tsplan.errors import nearest
from tsplan.logic.atoms import Linear, Relation
from tsplan.logic.boxes import PLACES, checked
from tsplan.logic.parser.count_reader import relation_of
from tsplan.logic.parser.numerals import exact, written
from tsplan.logic.parser.reading import reach
from tsplan.logic.parser.tree_reader import Reader
from tsplan.logic.text_spans import Span, Way, Written
from tsplan.words import nfc

_NOTHING = Fraction(0)
_HUGE = 10**800  # twice the digits of the largest and finest numbers that are read


@dataclass(frozen=True, slots=True)
class Expression:
    """A linear expression, exact: the factor of every signal, and a constant.

    `places` has where each name in it is written first.
    """

    factors: Mapping[str, Fraction] = field(default_factory=dict)
    constant: Fraction = Fraction(0)
    places: Mapping[str, Span] = field(default_factory=dict)

    @classmethod
    def total(cls, signed: Iterable[tuple[int, Expression]]) -> Expression:
        """The sum of expressions, each with its sign, in time linear in their terms."""
        factors: dict[str, Fraction] = {}
        places: dict[str, Span] = {}
        constant = Fraction(0)
        for sign, expression in signed:
            for name, value in expression.factors.items():
                factors[name] = factors.get(name, _NOTHING) + sign * value
            constant += sign * expression.constant
            for name, place in expression.places.items():
                places.setdefault(name, place)
        return cls(factors, constant, places)

    def times(self, factor: Fraction) -> Expression:
        """Multiply by a number."""
        factors = {name: value * factor for name, value in self.factors.items()}
        return Expression(factors, self.constant * factor, self.places)

    def compared(self, relation: Relation, bound: Fraction = _NOTHING) -> Linear:
        """The predicate that compares it with a number.

        Raises OverflowError or ValueError for numbers that are no floats.
        """
        terms = tuple((name, float(value)) for name, value in self.factors.items())
        return Linear(terms, relation, float(bound - self.constant))

    @property
    def is_readable(self) -> bool:
        """Whether all its numbers are ones that could be written out: a product grows fast."""
        numbers = (*self.factors.values(), self.constant)
        return all(max(abs(number.numerator), number.denominator) < _HUGE for number in numbers)

    @property
    def is_number(self) -> bool:
        """Whether no signal is left in it."""
        return not any(self.factors.values())


class SignalReader(Reader):
    """Reads STL."""

    quantities = (Expression,)

    def formula(self, value: Any, part: Any) -> Written | None:
        """A formula as it is; an expression must be compared first."""
        if isinstance(value, Expression):
            text = self.quote(part, part)
            remedy = f"compare it, such as {text} >= 0"
            self.complain(part, f"'{text}' is a number, not a formula", remedy)
            return None
        return cast("Written | None", value)

    def read_comparison(self, part: Any) -> Any:
        """Read two expressions compared, brought to one side, or a lone operand."""
        sums, relations = part.total(), part.relation()
        values = [self.read(side) for side in sums]
        if not relations:
            return values[0]
        if len(relations) > 1:
            self._chained(part)
            return None
        sides = [self._expression(value, at) for value, at in zip(values, sums, strict=True)]
        if sides[0] is None or sides[1] is None:
            return None
        difference = Expression.total([(1, sides[0]), (-1, sides[1])])
        try:
            formula = difference.compared(relation_of(relations[0]))
        except (OverflowError, ValueError):
            self._too_large(part)
            return None
        places: dict[Way, Span] = {("signal", n): at for n, at in difference.places.items()}
        return Written(formula, reach(part), parts=places)

    def read_total(self, part: Any) -> Any:
        """Read terms added and subtracted."""
        terms = part.term()
        values = [self.read(term) for term in terms]
        if len(values) == 1:
            return values[0]
        sides = self._expressions(values, terms)
        if sides is None:
            return None
        signs = [1, *(-1 if mark.getText() == "-" else 1 for mark in part.children[1::2])]
        return Expression.total(zip(signs, sides, strict=True))

    def read_term(self, part: Any) -> Any:
        """Read factors multiplied and divided, at most one of them with signals."""
        factors = part.factor()
        values = [self.read(factor) for factor in factors]
        if len(values) == 1:
            return values[0]
        sides = self._expressions(values, factors)
        if sides is None:
            return None
        product = sides[0]
        marks = part.children[1::2]
        for mark, side, factor in zip(marks, sides[1:], factors[1:], strict=True):
            made = self._multiplied(product, side, mark.getText(), factor)
            if made is None:
                return None
            product = made
            if not product.is_readable:
                self._too_large(part)
                return None
        return product

    def read_factor(self, part: Any) -> Any:
        """Read an operand with its signs."""
        value = self.read(part.operand())
        signs = [child.getText() for child in part.children[:-1]]
        if not signs:
            return value
        expression = self._expression(value, part.operand())
        negative = signs.count("-") % 2
        return expression.times(Fraction(-1)) if expression and negative else expression

    def read_operand(self, part: Any) -> Any:
        """Read a number, a signal, a constant or a part in parentheses."""
        if part.NUMBER():
            value = exact(part.getText())
            if value is None:
                self._too_large(part)
                return None
            return Expression(constant=value)
        if part.name():
            name = self.read(part.name())
            return None if name is None else self._defined(name, part)
        return super().read_operand(part)

    def read_region(self, part: Any) -> Written | None:
        """Read what is said of a region: its signals may be those of one robot of several."""
        names, known = [self.read(name) for name in part.name()], self.given.regions
        if None in names:
            return None
        *robot, region = map(nfc, names)
        if region not in known:
            remedy = nearest(region, known) if known else "give regions, or write what is meant"
            self.complain(part.name()[-1], f"there is no region '{region}'", remedy)
            return None
        try:
            axes = {"_".join((*robot, axis)): ends for axis, ends in known[region].items()}
            formula = PLACES[part.start.text](checked(axes), self._compared)
        except (OverflowError, TypeError, ValueError) as error:
            remedy = "give a finite least and greatest value of 1 to 3 signals"
            self.complain(part, f"'{region}' is no region: {error}", remedy)
            return None
        ways: list[Way] = [("robot",), ("region",)]
        return Written(
            formula,
            reach(part),
            parts=dict(zip(ways[-len(names) :], map(reach, part.name()), strict=True)),
        )

    def _compared(self, axis: str, relation: Relation, end: float) -> Linear:
        return self._named(axis).compared(relation, written(end))

    def _named(self, name: str) -> Expression:
        """The signal of a name, or the expression that it stands for."""
        terms, constant = self.given.definitions.get(nfc(name), ({name: 1}, 0))
        pairs = terms.items() if isinstance(terms, Mapping) else terms
        parts = (Expression({signal: written(factor)}) for signal, factor in pairs)
        number = Expression(constant=written(constant))
        return Expression.total((1, part) for part in (number, *parts))

    def _defined(self, name: str, part: Any) -> Expression | None:
        try:
            return replace(self._named(name), places={nfc(name): reach(part)})
        except (OverflowError, TypeError, ValueError):
            remedy = "define it by finite factors of signals and a finite constant"
            self.complain(part, f"'{name}' stands for no linear expression", remedy)
            return None

    def _expressions(self, values: list[Any], parts: list[Any]) -> list[Expression] | None:
        """The values of several parts as expressions; None if one is none."""
        sides = [self._expression(value, at) for value, at in zip(values, parts, strict=True)]
        sure = [side for side in sides if side is not None]
        return sure if len(sure) == len(sides) else None

    def _multiplied(
        self, total: Expression, side: Expression, sign: str, part: Any
    ) -> Expression | None:
        if sign == "/":
            if not side.is_number or not side.constant:
                what = "0" if side.is_number else "a signal"
                self.complain(part, f"division by {what}", "divide by a number other than 0")
                return None
            return total.times(1 / side.constant)
        if side.is_number:
            return total.times(side.constant)
        if total.is_number:
            return side.times(total.constant)
        remedy = "predicates are linear: multiply signals by numbers only"
        self.complain(part, "two signals are multiplied", remedy)
        return None

    def _expression(self, value: Any, part: Any) -> Expression | None:
        if isinstance(value, Written):
            text = self.quote(part, part)
            remedy = "write numbers and signals on both sides of a comparison"
            self.complain(part, f"'{text}' is a formula, not a number", remedy)
            return None
        return cast("Expression | None", value)

    def _chained(self, part: Any) -> None:
        sides = [self.quote(side, side) for side in part.total()]
        marks = [self.quote(mark, mark) for mark in part.relation()]
        pairs = zip(sides, marks, sides[1:], strict=False)
        remedy = "write " + " && ".join(" ".join(pair) for pair in pairs)
        self.complain(part.relation(1), "two values are compared at a time", remedy)

    def _too_large(self, part: Any) -> None:
        remedy = "write numbers below 1e308 with fewer than 400 decimals"
        self.complain(part, f"'{self.quote(part, part)}' is beyond all numbers", remedy)
