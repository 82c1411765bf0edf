"""A second reader of VIPR certificates, written from the format's description alone.

It shares nothing with the package's own: it goes line by line, keeps every constraint as a vector
of fractions, and turns all of them to "at least". Source: K. K. H. Cheung, A. Gleixner,
D. E. Steffy, "Verifying integer programming results", IPCO 2017.
"""

from __future__ import annotations

from fractions import Fraction
from math import ceil
from re import fullmatch


def accepts(text: str) -> bool:
    """Whether every line of a certificate follows, and the last one says what is claimed."""
    try:
        return _Certificate(text).holds()
    except (ValueError, IndexError, KeyError, StopIteration, ZeroDivisionError):
        return False


class _Certificate:
    def __init__(self, text: str) -> None:
        lines = [line for line in text.splitlines() if line and line[0] != "%"]
        self.lines = iter(lines)
        if next(self.lines) != "VER 1.0":
            raise ValueError
        self.size = int(self.head("VAR")[0])
        for _ in range(self.size):
            next(self.lines)
        count = int(self.head("INT")[0])
        self.whole = set(map(int, next(self.lines).split())) if count else set()
        if len(self.whole) != count or self.head("OBJ") != ["min"]:
            raise ValueError
        self.objective = self.vector(next(self.lines).split())
        # a constraint is (vector, sense, side); sense 1 for at least, -1 for at most, 0 for equal
        self.known = [self.constraint(next(self.lines))[0] for _ in range(int(self.head("CON")[0]))]
        self.needs: list[set[int]] = [set() for _ in self.known]
        self.claim = self.head("RTP")

    def head(self, word: str) -> list[str]:
        found = next(self.lines).split()
        if found[0] != word:
            raise ValueError
        return found[1:]

    def vector(self, words: list[str]) -> dict[int, Fraction]:
        if len(words) != 1 + 2 * int(words[0]):
            raise ValueError
        pairs = [(int(j), Fraction(a)) for j, a in zip(words[1::2], words[2::2], strict=True)]
        if len(dict(pairs)) < len(pairs) or any(not 0 <= j < self.size for j, _ in pairs):
            raise ValueError
        return {j: a for j, a in pairs if a}

    def constraint(self, line: str) -> tuple[tuple[dict[int, Fraction], int, Fraction], str]:
        match = fullmatch(r"\S+ ([EGL]) (\S+) (OBJ|[^{]*?)\s*(?:\{(.*)\} \S+)?", line)
        if match is None:
            raise ValueError
        sense, side, terms, reason = match.groups()
        vector = self.objective if terms == "OBJ" else self.vector(terms.split())
        return (vector, {"E": 0, "G": 1, "L": -1}[sense], Fraction(side)), (reason or "").strip()

    def holds(self) -> bool:
        solutions = [next(self.lines).split() for _ in range(int(self.head("SOL")[0]))]
        points = [self.vector(words[1:]) for words in solutions]
        if not all(self.fits(point) for point in points):
            return False
        for _ in range(int(self.head("DER")[0])):
            constraint, reason = self.constraint(next(self.lines))
            needs = self.follows(constraint, reason)
            if needs is None:
                return False
            self.known.append(constraint)
            self.needs.append(needs)
        return next(self.lines, None) is None and self.concludes(points)

    def fits(self, point: dict[int, Fraction]) -> bool:
        whole = all(value.denominator == 1 for j, value in point.items() if j in self.whole)
        return whole and all(
            (total := sum((a * point.get(j, Fraction(0)) for j, a in vector.items()), Fraction(0)))
            == side
            or (sense and sense * (total - side) > 0)
            for vector, sense, side in self.known
        )

    def concludes(self, points: list[dict[int, Fraction]]) -> bool:
        if not self.known or self.needs[-1]:
            return False
        vector, sense, side = self.known[-1]
        if self.claim == ["infeas"]:
            return not vector and ((sense >= 0 and side > 0) or (sense <= 0 and side < 0))
        kind, least, most = self.claim
        values = [
            sum((a * p.get(j, Fraction(0)) for j, a in self.objective.items()), Fraction(0))
            for p in points
        ]
        reached = most == "inf" or min(values) <= Fraction(most)
        return (
            kind == "range"
            and reached
            and self.implies(self.known[-1], (self.objective, 1, Fraction(least)))
        )

    def implies(self, one: tuple, other: tuple) -> bool:
        """Whether the other follows: from a falsehood, or by the same terms and a stronger side."""
        vector, sense, side = one
        if not vector and ((sense >= 0 and side > 0) or (sense <= 0 and side < 0)):
            return True
        if vector != other[0] or (sense and sense != other[1]):
            return False
        gap = side - other[2]
        return gap == 0 or bool(other[1] and other[1] * gap > 0)

    def follows(self, constraint: tuple, reason: str) -> set[int] | None:
        """The assumptions a constraint rests on, None if it does not follow."""
        kind, *words = reason.split()
        if kind == "asm":
            return {len(self.known)}
        if kind == "uns":
            return self.on_both_sides(constraint, *map(int, words))
        if kind not in ("lin", "rnd"):
            return None
        pairs = [(int(i), Fraction(m)) for i, m in zip(words[1::2], words[2::2], strict=True)]
        if int(words[0]) != len(pairs) or any(not 0 <= i < len(self.known) for i, _ in pairs):
            return None
        made = self.added_up(pairs, rounded=kind == "rnd")
        if made is None or not self.implies(made, constraint):
            return None
        return {need for i, _ in pairs for need in self.needs[i]}

    def on_both_sides(self, constraint: tuple, i: int, a: int, j: int, b: int) -> set[int] | None:
        """What holds on both sides of a branching holds without it."""
        both = self.implies(self.known[i], constraint) and self.implies(self.known[j], constraint)
        low, high = sorted((self.known[a], self.known[b]), key=lambda each: each[1])
        split = (low[1], high[1]) == (-1, 1) and low[0] == high[0] and high[2] - low[2] == 1
        whole = low[2].denominator == 1 and all(
            column in self.whole and value.denominator == 1 for column, value in low[0].items()
        )
        if min(i, a, j, b) < 0 or not (both and split and whole):
            return None
        return (self.needs[i] - {a}) | (self.needs[j] - {b})

    def added_up(self, pairs: list[tuple[int, Fraction]], *, rounded: bool) -> tuple | None:
        """Constraints times their factors, added up; None where their senses disagree."""
        total: dict[int, Fraction] = {}
        side, senses = Fraction(0), set()
        for i, factor in pairs:
            vector, sense, right = self.known[i]
            senses.add(sense * ((factor > 0) - (factor < 0)))
            side += factor * right
            for column, a in vector.items():
                total[column] = total.get(column, Fraction(0)) + factor * a
        senses.discard(0)
        if len(senses) > 1:
            return None
        sense = senses.pop() if senses else 0
        made = {column: a for column, a in total.items() if a}
        if rounded:
            if not sense or any(j not in self.whole or a.denominator > 1 for j, a in made.items()):
                return None
            side = Fraction(sense * ceil(sense * side))
        return made, sense, side
