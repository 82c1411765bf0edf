"""A checker of certificates in the VIPR format: every step in exact arithmetic, nothing believed.

It knows the format alone: no model, no search and no solver. A certificate lists the rows of a
program, then constraints that follow from those before them: as a sum of some with multipliers
(`lin`), by rounding such a sum (`rnd`), as an assumption (`asm`), or because they hold on both
sides of a branching (`uns`). The last one is what is to be proven, and rests on no assumption.

Source of the format: K. K. H. Cheung, A. Gleixner, D. E. Steffy, "Verifying integer programming
results", Integer Programming and Combinatorial Optimization (IPCO), 2017; version 1.0.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import NamedTuple, TypeAlias

Number: TypeAlias = int | Fraction
Terms: TypeAlias = Mapping[int, Number]
Pairs: TypeAlias = Sequence[tuple[int, Number]]

_SIGN = {"G": 1, "E": 0, "L": -1}
_NOBODY: frozenset[int] = frozenset()


class CertificateError(Exception):
    """A certificate that proves nothing, and why."""


class Row(NamedTuple):
    """A constraint: its terms, G (at least), L (at most) or E (equal), and its side."""

    name: str
    sense: str
    side: Number
    terms: Terms

    @property
    def false(self) -> bool:
        """Whether no numbers meet it: nothing on the left, and a side that is not met by zero."""
        if any(self.terms.values()):
            return False
        return (self.sense != "L" and self.side > 0) or (self.sense != "G" and self.side < 0)

    def dominates(self, other: Row) -> bool:
        """Whether whatever meets it meets the other."""
        if self.false:
            return True
        if _plain(self.terms) != _plain(other.terms):
            return False
        if other.sense == "E":
            return self.sense == "E" and self.side == other.side
        if self.sense not in ("E", other.sense):
            return False
        return self.side >= other.side if other.sense == "G" else self.side <= other.side


@dataclass(frozen=True, eq=False)
class Proven:
    """A program as a certificate has it, and what that proves: a `bound`, or (None) no point.

    `value` is what the best point it names is worth. `bound` is minus infinity for no claim.
    """

    comments: Sequence[str]
    variables: int
    whole: frozenset[int]
    objective: Terms
    rows: Sequence[Row]
    bound: Number | float | None
    value: Number | None
    steps: int


def checked(text: str) -> Proven:
    """What a certificate proves. Raises CertificateError where any step of it is not so."""
    return _Reading(text).proven()


@dataclass(eq=False)
class _Reading:
    """Reads a certificate from its beginning to its end, and checks what it reads."""

    text: str
    _at: int = field(default=0, init=False)
    _words: list[str] = field(default_factory=list, init=False)
    _rows: list[Row] = field(default_factory=list, init=False)
    _resting: list[frozenset[int]] = field(default_factory=list, init=False)
    _variables: int = field(default=0, init=False)
    _whole: frozenset[int] = field(default=_NOBODY, init=False)
    _objective: Terms = field(default_factory=dict, init=False)

    def proven(self) -> Proven:
        lines = self.text.split("\n")
        begin = next((n for n, line in enumerate(lines) if not line.startswith("%")), len(lines))
        self._words = " ".join(lines[begin:]).split()
        self._expect("VER", "1.0", "VAR")
        self._variables = self._count()
        for _ in range(self._variables):
            self._word()  # its name
        self._expect("INT")
        self._whole = frozenset(self._variable() for _ in range(self._count()))
        self._expect("OBJ", "min")
        self._objective = self._terms(self._count())
        self._expect("CON")
        count = self._count()
        self._count()  # how many of them are bounds
        self._rows = [self._row() for _ in range(count)]
        self._resting = [_NOBODY] * count
        least, most = self._claim()
        value = self._solutions(most)
        self._expect("DER")
        for _ in range(steps := self._count()):
            self._derived()
        if self._at != len(self._words):
            raise CertificateError(f"'{self._word()}' is beyond the end of the certificate")
        self._conclude(least)
        said = [line[1:].strip() for line in lines[:begin]], self._variables, self._whole
        return Proven(*said, self._objective, self._rows[:count], least, value, steps)

    def _claim(self) -> tuple[Number | float | None, Number | float]:
        """What is to be proven: the least and the most that the best point is worth."""
        self._expect("RTP")
        if (kind := self._word()) == "infeas":
            return None, math.inf
        if kind != "range":
            raise CertificateError(f"'{kind}' is nothing that can be proven")
        low, high = self._word(), self._word()
        least = -math.inf if low == "-inf" else _number(low)
        return least, math.inf if high == "inf" else _number(high)

    def _solutions(self, most: Number | float) -> Number | None:
        """The value of the best point that is named, every one of which has to meet all rows."""
        self._expect("SOL")
        best: Number | None = None
        for _ in range(self._count()):
            name = self._word()
            point = self._terms(self._count())
            for column, number in point.items():
                if column in self._whole and Fraction(number).denominator != 1:
                    raise CertificateError(f"solution {name}: a number that is not whole")
            for row in self._rows:
                total = sum(factor * point.get(column, 0) for column, factor in row.terms.items())
                if not _meets(total, row):
                    raise CertificateError(f"solution {name} does not meet {row.name}")
            value = sum(f * point.get(column, 0) for column, f in self._objective.items())
            best = value if best is None else min(best, value)
        if most < math.inf and (best is None or best > most):
            raise CertificateError("no solution is as good as is claimed")
        return best

    def _derived(self) -> None:
        row = self._row()
        self._expect("{")
        kind = self._word()
        if kind == "asm":
            resting = frozenset({len(self._rows)})
        elif kind in ("lin", "rnd"):
            resting = self._summed(row, rounded=kind == "rnd")
        elif kind == "uns":
            resting = self._either(row)
        else:
            raise CertificateError(f"{row.name}: there is no reason '{kind}'")
        self._expect("}")
        self._word()  # where it is last used: of no importance here
        self._rows.append(row)
        self._resting.append(resting)

    def _summed(self, row: Row, *, rounded: bool) -> frozenset[int]:
        pairs = [(self._earlier(), _number(self._word())) for _ in range(self._count())]
        if len({index for index, _ in pairs}) < len(pairs):
            raise CertificateError(f"{row.name}: a constraint is named twice")
        made = self._sum(row.name, pairs)
        if rounded:
            made = self._rounded(made)
        if not made.dominates(row):
            raise CertificateError(f"{row.name} does not follow from what it is made of")
        return frozenset().union(*(self._resting[index] for index, _ in pairs))

    def _sum(self, name: str, pairs: Pairs) -> Row:
        """Constraints times their multipliers, added up."""
        scale = math.lcm(*(Fraction(factor).denominator for _, factor in pairs))
        total: dict[int, Number] = {}
        side: Number = 0
        signs = set()
        for index, given in pairs:
            row, factor = self._rows[index], int(given * scale)
            if factor:
                signs.add(_SIGN[row.sense] * (1 if factor > 0 else -1))
                side += factor * row.side
                for column, number in row.terms.items():
                    total[column] = total.get(column, 0) + factor * number
        if {1, -1} <= signs:
            raise CertificateError(f"{name} adds up what is at least and what is at most something")
        sense = "G" if 1 in signs else "L" if -1 in signs else "E"
        if scale != 1:
            total = {column: Fraction(number, scale) for column, number in total.items() if number}
            side = Fraction(side, scale)
        return Row(name, sense, side, total)

    def _rounded(self, row: Row) -> Row:
        """A constraint of whole numbers with its side rounded."""
        for column, number in row.terms.items():
            if number and (column not in self._whole or Fraction(number).denominator != 1):
                raise CertificateError(f"{row.name} rounds what need not be whole")
        if row.sense == "E":
            raise CertificateError(f"{row.name} rounds an equation")
        side = math.ceil(row.side) if row.sense == "G" else math.floor(row.side)
        return row._replace(side=side)

    def _either(self, row: Row) -> frozenset[int]:
        """What holds on both sides of a branching, whatever is assumed there."""
        first, one, second, other = (self._earlier() for _ in range(4))
        sides = {self._rows[one].sense: one, self._rows[other].sense: other}
        if set(sides) != {"L", "G"}:
            raise CertificateError(f"{row.name}: the branching has no two sides")
        low, high = self._rows[sides["L"]], self._rows[sides["G"]]
        numbers = [*low.terms.values(), low.side]
        whole = all(Fraction(number).denominator == 1 for number in numbers)
        if not whole or not self._whole.issuperset(_plain(low.terms)):
            raise CertificateError(f"{row.name}: the branching is on what need not be whole")
        if _plain(low.terms) != _plain(high.terms) or high.side != low.side + 1:
            raise CertificateError(f"{row.name}: the branching leaves something out")
        if not (self._rows[first].dominates(row) and self._rows[second].dominates(row)):
            raise CertificateError(f"{row.name} does not follow on both sides of the branching")
        return (self._resting[first] - {one}) | (self._resting[second] - {other})

    def _conclude(self, least: Number | float | None) -> None:
        """The last constraint says what was to be proven, and rests on no assumption."""
        if least == -math.inf:
            return
        if self._resting[-1:] != [_NOBODY]:
            raise CertificateError("the last constraint rests on an assumption")
        last = self._rows[-1]
        if least is None:
            if not last.false:
                raise CertificateError("the last constraint is no contradiction")
        elif isinstance(least, float) or not last.dominates(Row("", "G", least, self._objective)):
            raise CertificateError("the last constraint is not the bound that is claimed")

    def _word(self) -> str:
        if self._at >= len(self._words):
            raise CertificateError("the certificate ends too early")
        self._at += 1
        return self._words[self._at - 1]

    def _expect(self, *words: str) -> None:
        for word in words:
            if (found := self._word()) != word:
                raise CertificateError(f"'{word}' is expected where '{found}' stands")

    def _count(self) -> int:
        word = self._word()
        if not word.isascii() or not word.isdigit():
            raise CertificateError(f"'{word}' is no number of things")
        return int(word)

    def _variable(self) -> int:
        return self._below(self._variables, "variable")

    def _earlier(self) -> int:
        return self._below(len(self._rows), "constraint")

    def _below(self, count: int, what: str) -> int:
        if (index := self._count()) >= count:
            raise CertificateError(f"there is no {what} {index} here")
        return index

    def _terms(self, count: int) -> Terms:
        found = {self._variable(): _number(self._word()) for _ in range(count)}
        if len(found) < count:
            raise CertificateError("a variable is named twice")
        return found

    def _row(self) -> Row:
        name, sense, side = self._word(), self._word(), _number(self._word())
        if sense not in _SIGN:
            raise CertificateError(f"{name}: '{sense}' is none of E, L and G")
        if self._words[self._at : self._at + 1] != ["OBJ"]:
            return Row(name, sense, side, self._terms(self._count()))
        self._at += 1
        return Row(name, sense, side, self._objective)


def _number(word: str) -> Number:
    try:
        return int(word) if word.lstrip("-").isdigit() else Fraction(word)
    except (ValueError, ZeroDivisionError):
        raise CertificateError(f"'{word}' is no number") from None


def _meets(total: Number, row: Row) -> bool:
    return (total >= row.side or row.sense == "L") and (total <= row.side or row.sense == "G")


def _plain(terms: Terms) -> dict[int, Number]:
    """The terms without those that are nothing."""
    return {column: number for column, number in terms.items() if number}
