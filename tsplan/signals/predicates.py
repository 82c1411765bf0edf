"""Linear predicates as half-spaces, and by how much they can hold.

A predicate `a.y >= b` of which a robustness r is wanted asks for `a.y >= b + r`. Its terms are
brought to one length (the first factor is 1 or -1), so that predicates about one direction meet,
whatever they are scaled by; the scale divides the robustness instead.
"""

from __future__ import annotations

from collections import defaultdict
from dataclasses import dataclass
from functools import cached_property
from typing import ClassVar

import numpy as np

from tsplan.encode.atom_encoders import Atoms, Requirement, Slack
from tsplan.logic import And, Formula, Linear
from tsplan.milp.model import Floats, Ints
from tsplan.signals.linear_system import Terms
from tsplan.signals.reach import Reach

_ROUNDING = 1e-12
"""What floats round of a sum, relative to its size: some thousand times their own precision."""


@dataclass(frozen=True, slots=True)
class HalfSpace:
    """`terms . y >= amount`, whose robustness is `scale * (terms . y - amount)`.

    The border of a strict one does not belong to it, which rows cannot tell.
    """

    terms: Terms
    scale: float
    amount: float
    strict: bool = False

    @classmethod
    def of(cls, atom: Linear) -> HalfSpace:
        """The half-space of an ordered predicate."""
        sign = 1.0 if atom.relation in (">=", ">") else -1.0
        scale = abs(atom.terms[0][1]) if atom.terms else 1.0
        terms = tuple((name, sign * factor / scale) for name, factor in atom.terms)
        return cls(terms, scale, sign * atom.bound / scale, atom.relation in ("<", ">"))

    @property
    def opposite(self) -> Terms:
        """The terms of half-spaces that look the other way."""
        return tuple((name, -factor) for name, factor in self.terms)


@dataclass(frozen=True, eq=False)
class LinearEncoder:
    """Reads predicates over signals of which a robustness from `least` to `most` is wanted."""

    reach: Reach
    columns: Ints  # of every signal and control (names, T+1)
    least: float
    most: float
    forgiving: bool = True  # what floats have rounded rules nothing out
    grain: ClassVar[float] = 0.0

    @cached_property
    def _sides(self) -> dict[Terms, tuple[Floats, Floats]]:
        return {}

    @cached_property
    def _place(self) -> dict[str, int]:
        return {name: row for row, name in enumerate(self.reach.system.names)}

    def sides(self, terms: Terms) -> tuple[Floats, Floats]:
        """The least and greatest value of a sum at each step."""
        if terms not in self._sides:
            self._sides[terms] = self.reach.sides(terms)
        return self._sides[terms]

    def requirement(self, atom: Linear) -> Requirement:
        """The half-space an atom means."""
        if atom.relation in ("=", "!="):
            raise ValueError(f"'{atom}' is not in positive normal form")
        return Requirement((HalfSpace.of(atom),), every=True)

    def best(self, bound: HalfSpace) -> Floats:
        """By how much it holds at best, beyond the least that is wanted."""
        high = self.sides(bound.terms)[1]
        values = bound.scale * (high - bound.amount)
        rounded = _ROUNDING * bound.scale * (np.abs(high) + abs(bound.amount))
        if bound.strict and self.least >= 0:
            values = np.where(values > rounded, values, -np.inf)  # the border is not its own
        return np.asarray(values + self.forgiving * rounded - self.least)

    def worst(self, bound: HalfSpace) -> Floats:
        """By how much it holds in any case, beyond the most that is wanted."""
        return bound.scale * (self.sides(bound.terms)[0] - bound.amount) - self.most

    def members(self, terms: Terms, step: int) -> tuple[Ints, Floats]:
        """The columns of a sum at a step, and their factors."""
        rows = [self._place[name] for name, _ in terms]
        return self.columns[rows, step], np.array([factor for _, factor in terms])

    def slack(self, bound: HalfSpace, step: int) -> Slack:
        """The robustness at a step."""
        columns, factors = self.members(bound.terms, step)
        low, high = (float(side[step]) for side in self.sides(bound.terms))
        scale, constant = bound.scale, -bound.scale * bound.amount
        return Slack(
            columns, scale * factors, constant, scale * low + constant, scale * high + constant
        )


def jointly(node: Formula, atoms: Atoms) -> float:
    """The most robustness that a conjunction has because of predicates that look at each other.

    Like that of a predicate it is counted beyond the least that is wanted.

    A box of width w is nowhere left by more than w/2. Infinite where no predicates face each other.

    >>> from tsplan.logic import parse
    >>> from tsplan.signals.linear_system import System
    >>> encoder = LinearEncoder(Reach(System({}), np.empty((0, 1)), np.empty((0, 1))), None, 0, 9)
    >>> atoms = Atoms({Linear: encoder}, 0)
    >>> jointly(parse("x >= 3 && (y > 1 && x <= 4)", language="stl"), atoms)
    0.5
    """
    facing: dict[Terms, list[HalfSpace]] = defaultdict(list)
    wanted = 0.0
    waiting = list(node.children)
    while waiting:
        part = waiting.pop()
        if isinstance(part, And):
            waiting += part.children
        elif part in atoms:
            encoder, needed = atoms.of(part)
            wanted = getattr(encoder, "least", 0.0)
            for bound in needed.bounds:
                facing[bound.terms].append(bound)
    least = np.inf
    for bounds in facing.values():
        for one in bounds:
            for other in facing.get(one.opposite, ()):
                room = -(one.amount + other.amount)
                least = min(least, room / (1 / one.scale + 1 / other.scale))
    return float(least) - wanted
