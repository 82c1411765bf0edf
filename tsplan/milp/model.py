"""A mixed-integer linear program as plain arrays: columns, rows, and a tag for every row.

The model is always a minimisation of `objective @ x + offset` subject to
`row_lower <= matrix @ x <= row_upper` and `lower <= x <= upper`. Arrays, unlike the objects of
modelling layers, go into any solver at once and can be sent to another process.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Sequence
from dataclasses import dataclass, replace
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt
from scipy import sparse

Floats: TypeAlias = npt.NDArray[np.float64]
Ints: TypeAlias = npt.NDArray[np.int64]
Bools: TypeAlias = npt.NDArray[np.bool_]

Terms: TypeAlias = tuple[npt.ArrayLike, npt.ArrayLike, npt.ArrayLike]
"""Entries of rows: the rows' numbers, columns and factors; one number stands for many."""

INFINITY = float("inf")

_Block: TypeAlias = tuple[npt.NDArray[Any], ...]


@dataclass(frozen=True, slots=True)
class Tag:
    """What the rows `start .. stop-1` stand for: a kind, and the formula node and step, if any."""

    kind: str
    start: int
    stop: int
    node: Hashable | None = None
    step: int | None = None


@dataclass(frozen=True, slots=True)
class Size:
    """How large a model is."""

    columns: int
    integers: int
    rows: int
    nonzeros: int


@dataclass(frozen=True, eq=False)
class Model:
    """A minimisation problem over arrays; see the module's text for its meaning."""

    objective: Floats
    lower: Floats
    upper: Floats
    integer: Bools
    matrix: sparse.csr_array
    row_lower: Floats
    row_upper: Floats
    tags: tuple[Tag, ...] = ()
    offset: float = 0.0

    def __post_init__(self) -> None:
        rows, columns = self.matrix.shape
        if not len(self.objective) == len(self.lower) == len(self.upper) == columns:
            raise ValueError("objective, bounds and matrix disagree about the number of columns")
        if len(self.integer) != columns or len(self.row_lower) != rows:
            raise ValueError("integrality or row bounds do not fit the matrix")

    @property
    def size(self) -> Size:
        """Numbers of columns, integer columns, rows and nonzeros."""
        rows, columns = self.matrix.shape
        return Size(columns, int(self.integer.sum()), rows, int(self.matrix.nnz))

    def with_objective(self, objective: Floats, offset: float = 0.0) -> Model:
        """The same constraints, minimising something else."""
        return replace(self, objective=objective, offset=offset)

    def with_bounds(self, lower: Floats, upper: Floats) -> Model:
        """The same model between other column bounds."""
        return replace(self, lower=lower, upper=upper)

    def with_fixed(self, columns: Ints, values: npt.ArrayLike) -> Model:
        """The same model with some columns at given values, rounded to whole numbers."""
        lower, upper = self.lower.copy(), self.upper.copy()
        lower[columns] = upper[columns] = np.round(np.asarray(values))
        return self.with_bounds(lower, upper)

    def with_integrality(self, integer: Bools) -> Model:
        """The same model with other columns integer."""
        return replace(self, integer=integer)

    def with_row(self, coefficients: Floats, lower: float, upper: float, kind: str) -> Model:
        """The model and one more row, given densely: `lower <= coefficients @ x <= upper`."""
        return self.with_rows(sparse.csr_array(coefficients.reshape(1, -1)), lower, upper, kind)

    def with_rows(
        self, rows: sparse.csr_array, lower: npt.ArrayLike, upper: npt.ArrayLike, kind: str
    ) -> Model:
        """The model and more rows `lower <= rows @ x <= upper`; bounds are scalars or arrays."""
        count, more = self.matrix.shape[0], rows.shape[0]
        low, high = _spread((lower, upper), more)
        return replace(
            self,
            matrix=sparse.csr_array(sparse.vstack([self.matrix, rows], format="csr")),
            row_lower=np.append(self.row_lower, low),
            row_upper=np.append(self.row_upper, high),
            tags=(*self.tags, Tag(kind, count, count + more)),
        )

    def violation(self, values: Floats) -> float:
        """Largest violation of any bound, row or integrality by the point `values`."""
        activity = self.matrix @ values
        gaps = [
            np.maximum(self.lower - values, values - self.upper),
            np.maximum(self.row_lower - activity, activity - self.row_upper),
            np.abs(values - np.round(values)) * self.integer,
        ]
        return max((float(gap.max()) for gap in gaps if gap.size), default=0.0)


class Draft:
    """Collects columns and rows in blocks of arrays, then becomes a `Model`.

    `watch` hears, before a block is made, how many columns and entries there will be then; what it
    raises ends the drafting.

    >>> draft = Draft()
    >>> x = draft.columns(2, upper=3.0, integer=True)
    >>> draft.rows([0, 0], x, [1.0, 1.0], lower=[2.0], upper=[4.0], kind="demo")
    >>> draft.build().size
    Size(columns=2, integers=2, rows=1, nonzeros=2)
    """

    def __init__(self, watch: Callable[[int, int], None] | None = None) -> None:
        self.column_count = 0
        self.row_count = 0
        self.entry_count = 0
        self._watch = watch
        self._columns: list[_Block] = []
        self._entries: list[_Block] = []
        self._sides: list[_Block] = []
        self._tags: list[Tag] = []

    def columns(
        self,
        count: int,
        lower: npt.ArrayLike = 0.0,
        upper: npt.ArrayLike = INFINITY,
        *,
        integer: bool = False,
    ) -> Ints:
        """Add `count` columns; return their indices. Bounds are scalars or arrays."""
        start = self.column_count
        self._grow(count, 0)
        self._columns.append((*_spread((lower, upper), count), np.full(count, integer)))
        return np.arange(start, start + count, dtype=np.int64)

    def rows(
        self,
        index: npt.ArrayLike,
        column: npt.ArrayLike,
        value: npt.ArrayLike,
        *,
        lower: npt.ArrayLike,
        upper: npt.ArrayLike,
        kind: str,
        node: Hashable | None = None,
        step: int | None = None,
    ) -> None:
        """Add a block of rows given as triplets; `index` counts from 0 within the block.

        `lower` and `upper` are one number for all rows or one for each; two numbers make one row.
        Entries at the same place are added up.
        """
        self._grow(0, len(np.atleast_1d(column)))
        low, high = np.asarray(lower, dtype=np.float64), np.asarray(upper, dtype=np.float64)
        count = np.broadcast(low, high).size
        rows = np.asarray(index, dtype=np.int64) + self.row_count
        columns = np.asarray(column, dtype=np.int64)
        values = np.broadcast_to(np.asarray(value, dtype=np.float64), rows.shape)
        self._entries.append((rows, columns, values))
        self._sides.append(_spread((low, high), count))
        self._tags.append(Tag(kind, self.row_count, self.row_count + count, node, step))
        self.row_count += count

    def sums(
        self,
        *terms: Terms,
        kind: str,
        lower: npt.ArrayLike = 0.0,
        upper: npt.ArrayLike = INFINITY,
        count: int = 1,
    ) -> None:
        """Add rows `lower <= sum of the terms <= upper`.

        There are as many as there are bounds, or `count` where both bounds are single numbers.

        >>> draft = Draft()
        >>> x, y = draft.columns(3), draft.columns(1)
        >>> draft.sums((range(3), x, 1.0), (range(3), y[0], -1.0), count=3, kind="x >= y")
        >>> draft.build().matrix.toarray()[2].tolist()
        [0.0, 0.0, 1.0, -1.0]
        """
        low = np.full(count, lower) if np.ndim(lower) == np.ndim(upper) == 0 else lower
        self.rows(*joined_terms(terms), lower=low, upper=upper, kind=kind)

    def define(
        self, columns: Ints, *terms: Terms, kind: str, constant: npt.ArrayLike = 0.0
    ) -> None:
        """Add rows that make `columns[i]` the sum of the terms of row i, and the constant."""
        index, members, factors = joined_terms(terms)
        self.sums(
            (np.arange(len(columns)), columns, 1.0),
            (index, members, -factors),
            lower=constant,
            upper=constant,
            count=len(columns),
            kind=kind,
        )

    def _grow(self, columns: int, entries: int) -> None:
        self.column_count += columns
        self.entry_count += entries
        if self._watch is not None:
            self._watch(self.column_count, self.entry_count)

    def build(self) -> Model:
        """The collected columns and rows as a model with a zero objective."""
        self._grow(0, 0)
        rows, columns, values = _stacked(self._entries, np.int64, np.int64, np.float64)
        lower, upper, integer = _stacked(self._columns, np.float64, np.float64, np.bool_)
        row_lower, row_upper = _stacked(self._sides, np.float64, np.float64)
        shape = (self.row_count, self.column_count)
        matrix = sparse.csr_array(sparse.coo_array((values, (rows, columns)), shape=shape))
        tags = tuple(self._tags)
        zero = np.zeros(self.column_count)
        return Model(zero, lower, upper, integer, matrix, row_lower, row_upper, tags)


class Block:
    """Rows of one kind, `>= lower`, collected piece by piece and drafted all at once."""

    def __init__(self, kind: str) -> None:
        self._kind = kind
        self._count = 0
        self._pieces: list[Terms] = []
        self._lower: list[Floats] = []

    def add(self, *terms: Terms, lower: npt.ArrayLike) -> None:
        """More rows, one for each number of `lower`; the terms' rows count from 0 here."""
        index, columns, factors = joined_terms(terms)
        self._pieces.append((index + self._count, columns, factors))
        self._lower.append(np.atleast_1d(np.asarray(lower, dtype=np.float64)))
        self._count += len(self._lower[-1])

    def write(self, draft: Draft) -> None:
        """Draft the rows collected so far."""
        if self._pieces:
            draft.sums(*self._pieces, lower=np.concatenate(self._lower), kind=self._kind)


def joined_terms(terms: Sequence[Terms]) -> tuple[Ints, Ints, Floats]:
    """All entries of some terms: rows' numbers, columns and factors, each as one array."""
    sizes = [np.size(term[1] if np.ndim(term[1]) else term[0]) for term in terms]
    index, columns = np.empty((2, sum(sizes)), dtype=np.int64)
    factors, end = np.empty(sum(sizes)), 0
    for size, term in zip(sizes, terms, strict=True):
        begin, end = end, end + size
        index[begin:end], columns[begin:end], factors[begin:end] = term
    return index, columns, factors


def _spread(numbers: Sequence[npt.ArrayLike], count: int) -> _Block:
    """Each number, or array of numbers, as an array of this length."""
    return tuple(np.broadcast_to(np.asarray(n, dtype=np.float64), (count,)) for n in numbers)


def _stacked(blocks: Sequence[_Block], *kinds: type) -> _Block:
    """Blocks of arrays one after the other: an array of each kind, empty without any block."""
    columns = [[*(block[place] for block in blocks)] for place in range(len(kinds))]
    return tuple(
        np.concatenate([*parts, np.empty(0, dtype=kind)]).astype(kind, copy=False)
        for parts, kind in zip(columns, kinds, strict=True)
    )
