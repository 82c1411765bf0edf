"""Exact linear expressions, and sums of sums that are resolved when all their parts are known."""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction

import numpy as np

from tsplan.milp.model import Draft

_ONE = Fraction(1)


@dataclass(frozen=True, slots=True)
class Sum:
    """`constant` and columns times exact coefficients."""

    columns: Mapping[int, Fraction] = field(default_factory=dict)
    constant: Fraction = Fraction(0)

    @classmethod
    def of(cls, columns: Iterable[int]) -> Sum:
        """The plain sum of some columns.

        >>> Sum.of([3, 5]).columns[5]
        Fraction(1, 1)
        """
        return cls(dict.fromkeys(columns, _ONE))

    @classmethod
    def total(cls, parts: Iterable[tuple[Sum, Fraction]]) -> Sum:
        """Sums times factors, added up."""
        columns: dict[int, Fraction] = {}
        constant = Fraction(0)
        for part, factor in parts:
            constant += factor * part.constant
            for column, value in part.columns.items():
                columns[column] = columns.get(column, Fraction(0)) + factor * value
        return cls(columns, constant)


class Ledger:
    """What each key is worth, as a sum of columns and of other keys, and rows that bound columns.

    Keys are entered before the keys they are made of.
    """

    def __init__(self) -> None:
        self._parts: dict[Hashable, tuple[Sum, Sequence[tuple[Hashable, Fraction]]]] = {}
        self._ties: list[tuple[Sequence[int], Sum, Sequence[Hashable]]] = []

    def enter(
        self, key: Hashable, own: Sum, others: Iterable[tuple[Hashable, Fraction]] = ()
    ) -> None:
        """A key is worth `own` and the other keys times their factors."""
        self._parts[key] = (own, tuple(others))

    def tie(self, columns: Sequence[int], own: Sum, keys: Sequence[Hashable] = ()) -> None:
        """The columns together are at most `own` and what the keys are worth."""
        self._ties.append((columns, own, keys))

    def resolve(self) -> dict[Hashable, Sum]:
        """What every key is worth in columns."""
        worth: dict[Hashable, Sum] = {}
        for key, (own, others) in reversed(self._parts.items()):
            parts = [(worth[other], factor) for other, factor in others]
            worth[key] = Sum.total([(own, _ONE), *parts]) if parts else own
        return worth

    def write(self, draft: Draft, worth: Mapping[Hashable, Sum]) -> None:
        """One row for every tie."""
        index: list[int] = []
        members: list[int] = []
        values: list[float] = []
        lower: list[float] = []
        for row, (columns, own, keys) in enumerate(self._ties):
            total = Sum.total([(own, _ONE), *((worth[key], _ONE) for key in keys)])
            index += [row] * (len(total.columns) + len(columns))
            members += [*total.columns, *columns]
            values += [float(value) for value in total.columns.values()]
            values += [-1.0] * len(columns)
            lower.append(-float(total.constant))
        if lower:
            draft.rows(index, members, values, lower=np.array(lower), upper=np.inf, kind="fraction")
