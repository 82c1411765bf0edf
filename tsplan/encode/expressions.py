"""Linear expressions in exact numbers, and a user's own constraints over counts of agents.

Counts, flows and whole variables are whole numbers, so a constraint over them is brought to whole
coefficients and whole bounds: it means exactly what was written, whether with fractions, decimals
or `<`. What cannot be meant as it is written (`1 <= count <= 3`, `count * count`, a number that is
none) is an error where it is written.
"""

from __future__ import annotations

from collections.abc import Hashable, Iterable
from dataclasses import dataclass, field, replace
from decimal import Decimal
from fractions import Fraction
from math import ceil, floor, log10
from typing import Any, ClassVar, NoReturn, TypeAlias

from tsplan.errors import Finding, MissionError
from tsplan.exact import common_unit
from tsplan.parameters import finite

_LONGEST = 40  # digits that are shown
_ZERO, _ONE = Fraction(0), Fraction(1)

UNNAMED = "constraint"
"""What own constraints are called that were given no name."""

Number: TypeAlias = "float | Fraction | Decimal"


Terms: TypeAlias = tuple[tuple[Any, Fraction], ...]
"""What is summed (`Quantity`), or columns of a model by number, each times a factor."""


def _refused(what: str, remedy: str) -> NoReturn:
    raise MissionError([Finding(what, remedy)])


def _not_linear(_one: object, _other: object = None, _more: object = None) -> NoReturn:
    what = "an own constraint or objective is a sum of counts and such, each times a number"
    _refused(what, "use only +, -, * and / with numbers")


@dataclass(frozen=True, slots=True, eq=False)
class Expression:
    """A linear expression over counts, or over columns of a model, in exact numbers.

    `+`, `-`, and `*` and `/` with numbers make expressions; `<=`, `>=`, `==`, `<`, `>` and
    `between` make constraints of those over counts. Numbers count as they are written: 0.1 is a
    tenth.

    Raises MissionError for what is not linear, and for numbers that are not finite.

    >>> from tsplan.encode.quantities import CountTerm
    >>> dock, ship = (Expression(((CountTerm(name, None, 3), Fraction(1)),)) for name in "ds")
    >>> print(2 * dock - ship / 2 > 0.5)
    4*count('d', step=3) - count('s', step=3) >= 2
    >>> print(dock.between(1, 3))
    1 <= count('d', step=3) <= 3
    """

    terms: Terms = ()
    constant: Fraction = _ZERO

    # numbers of numpy leave arithmetic with expressions to the expressions
    __array_ufunc__: ClassVar[None] = None
    __hash__: ClassVar[None]  # type: ignore[assignment]  # == makes constraints

    @staticmethod
    def total(parts: Iterable[tuple[Expression, Fraction]]) -> Expression:
        """Expressions times factors, added up.

        >>> part = Expression.sum_of([3, 5])
        >>> dict(Expression.total([(part, Fraction(2)), (part, Fraction(1))]).terms)[5]
        Fraction(3, 1)
        """
        summed: dict[Any, Fraction] = {}
        constant = _ZERO
        for part, factor in parts:
            constant += factor * part.constant
            for key, value in part.terms:
                summed[key] = summed.get(key, _ZERO) + factor * value
        kept = tuple((key, value) for key, value in summed.items() if value)
        return Expression(kept, constant)

    @staticmethod
    def sum_of(keys: Iterable[Hashable]) -> Expression:
        """The plain sum of some counts or columns."""
        return Expression(tuple((key, _ONE) for key in keys))

    @staticmethod
    def of(value: object) -> Expression:
        """An expression as it is, a number as a constant; MissionError for anything else."""
        if isinstance(value, Constraint):
            remedy = "compare only once, or use expression.between(low, high)"
            _refused(f"'{value}' is a constraint, not an expression or number", remedy)
        return (
            value if isinstance(value, Expression) else Expression((), finite(value, MissionError))
        )

    def __add__(self, other: Expression | Number) -> Expression:
        return Expression.total([(self, _ONE), (Expression.of(other), _ONE)])

    __radd__ = __add__

    def __mul__(self, other: Expression | Number) -> Expression:
        scale = Expression.of(other)
        if scale.terms:
            if self.terms:
                _not_linear(self)
            return scale * self.constant
        return Expression.total([(self, scale.constant)])

    __rmul__ = __mul__

    def __truediv__(self, other: Number) -> Expression:
        divisor = Expression.of(other)
        if divisor.terms:
            _not_linear(self)
        if not divisor.constant:
            _refused("an expression is divided by 0", "divide by another number")
        return self * (1 / divisor.constant)

    def __neg__(self) -> Expression:
        return self * -1

    def __pos__(self) -> Expression:
        return self

    def __sub__(self, other: Expression | Number) -> Expression:
        return self + -Expression.of(other)

    def __rsub__(self, other: Number) -> Expression:
        return -self + other

    __rtruediv__ = __floordiv__ = __rfloordiv__ = __mod__ = __rmod__ = _not_linear
    __pow__ = __rpow__ = __abs__ = __round__ = __int__ = __float__ = _not_linear

    def __ge__(self, other: Expression | Number) -> Constraint:
        return Constraint.of(self - other, 0, None)

    def __le__(self, other: Expression | Number) -> Constraint:
        return Constraint.of(self - other, None, 0)

    def __gt__(self, other: Expression | Number) -> Constraint:
        return Constraint.of(self - other, 0, None, strict=True)

    def __lt__(self, other: Expression | Number) -> Constraint:
        return Constraint.of(self - other, None, 0, strict=True)

    def __eq__(self, other: Expression | Number) -> Constraint:  # type: ignore[override]  # as numpy
        return Constraint.of(self - other, 0, 0)

    def __ne__(self, other: object) -> NoReturn:  # as above
        _refused("'!=' is no linear constraint", "use '<=', '>=', '==' or between(low, high)")

    def between(self, low: Number, high: Number) -> Constraint:
        """The constraint `low <= expression <= high`; MissionError where low is above high."""
        least, most = finite(low, MissionError), finite(high, MissionError)
        if least > most:
            what = f"nothing is between {_text(least)} and {_text(most)}"
            _refused(what, "give the lower bound first")
        return Constraint.of(self, least, most)

    def _no_truth(self) -> NoReturn:
        _refused(
            f"whether '{self}' is 0 depends on the plan",
            "compare it with <=, >= or ==, and give the constraint to problem.add",
        )

    __bool__ = _no_truth

    def __str__(self) -> str:
        return _sum(self.terms, self.constant)


@dataclass(frozen=True, slots=True)
class Constraint:
    """`lower <= sum of the terms <= upper`; None bounds nothing.

    Of terms that are whole, all numbers are brought to whole ones; others stay as they are given.
    `place` is the file and line that demanded it.

    A constraint is neither true nor false before there is a plan: `bool`, and so `and`, `or`,
    `not` and `1 <= count <= 3`, raise MissionError.
    """

    terms: tuple[tuple[Any, Any], ...]
    lower: Any
    upper: Any
    name: str = UNNAMED
    place: str = ""

    @property
    def bounds(self) -> bool:
        """Whether it bounds anything."""
        return self.lower is not None or self.upper is not None

    @property
    def sum(self) -> str:
        """What it is about, in words."""
        return _sum(self.terms, _ZERO)

    def unbounded(self) -> Constraint:
        """The same that bounds nothing."""
        return replace(self, lower=None, upper=None)

    @staticmethod
    def of(
        expression: Expression,
        lower: Number | None,
        upper: Number | None,
        *,
        strict: bool = False,
    ) -> Constraint:
        """`lower <= expression <= upper` (strictly: `<`) with the least whole coefficients."""
        if any(not getattr(term, "whole", False) for term, _ in expression.terms):
            return Constraint._of_reals(expression, lower, upper, strict=strict)
        scale = 1 / common_unit(factor for _, factor in expression.terms)

        def bound(value: Number | None) -> Fraction | None:
            return None if value is None else (Fraction(value) - expression.constant) * scale

        low, high = bound(lower), bound(upper)
        least = None if low is None else floor(low) + 1 if strict else ceil(low)
        most = None if high is None else ceil(high) - 1 if strict else floor(high)
        return Constraint(
            tuple((t, int(factor * scale)) for t, factor in expression.terms), least, most
        )

    @staticmethod
    def _of_reals(
        expression: Expression, lower: Number | None, upper: Number | None, *, strict: bool
    ) -> Constraint:
        if strict:
            _refused("'<' and '>' of real values cannot be told from '<=' and '>='", "use these")
        constant = expression.constant
        least, most = (None if b is None else Fraction(b) - constant for b in (lower, upper))
        return Constraint(expression.terms, least, most)

    def holds(self, total: Fraction | int) -> bool:
        """Whether the terms may sum to this."""
        low = self.lower is None or self.lower <= total
        return low and (self.upper is None or total <= self.upper)

    def _no_truth(self, _other: object = None) -> NoReturn:
        _refused(
            f"the constraint '{self}' is neither true nor false before there is a plan",
            "write a range as expression.between(low, high), and add each constraint by itself: "
            "'and', 'or' and 'not' cannot be used",
        )

    __bool__ = __and__ = __rand__ = __or__ = __ror__ = __xor__ = __rxor__ = __invert__ = _no_truth

    def __str__(self) -> str:
        total = self.sum
        if self.lower is not None and self.lower == self.upper:
            return f"{total} == {self.lower}"
        if self.lower is not None and self.upper is not None:
            return f"{self.lower} <= {total} <= {self.upper}"
        return f"{total} <= {self.upper}" if self.lower is None else f"{total} >= {self.lower}"


def _sum(terms: Any, constant: Fraction) -> str:
    """Terms and a constant as a sum; of many terms the first ones."""
    most = 8
    text = ""
    for term, factor in [*terms[:most], *([(None, constant)] if constant else [])]:
        size = abs(factor)
        word = _text(size) if term is None else str(term) if size == 1 else f"{_text(size)}*{term}"
        sign = ("- " if factor < 0 else "+ ") if text else ("-" if factor < 0 else "")
        text += f" {sign}{word}" if text else f"{sign}{word}"
    return (text or "0") + (" + ..." if len(terms) > most else "")


def _text(value: Fraction | int) -> str:
    """A number with its digits, as a fraction where it is no short decimal."""
    number = Fraction(value)
    if number.denominator == 1:
        digits = int(number.numerator.bit_length() * log10(2)) + 1
        return str(number) if digits <= _LONGEST else f"a number of about {digits} digits"
    decimal = str(float(number))
    return decimal if Fraction(decimal) == number else str(number)


@dataclass(frozen=True, slots=True)
class Own:
    """A user's own objective, in its own sense; without terms there is none."""

    expression: Expression = field(default_factory=Expression)
    maximised: bool = False


NO_OWN = Own()
"""No objective of the user's own."""
