"""The rows of a model as the constraints of a certificate: bounds first, then rows, then cuts."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import isfinite
from types import MappingProxyType

from tsplan.certificates.checker import Row
from tsplan.milp.model import Model

REFUTATION = "refuted"
"""The name of the constraint that says that demands, judged one by one, cannot be met."""


KINDS: Mapping[str, str] = MappingProxyType({"arrival": "arrival cuts", "visitors": "visitor cuts"})
"""The kinds of cuts that can be told from a mission, and what they are called."""


@dataclass(frozen=True, eq=False)
class Limits:
    """The constraints of a model, and where each of its bounds and rows stands among them.

    The first `bounds` of them bound single columns; the false one is the `refutation`.
    """

    rows: Sequence[Row]
    bounds: int
    refutation: int
    _low: dict[int, int]
    _high: dict[int, int]
    _below: dict[int, int]
    _above: dict[int, int]

    def lines(self) -> list[str]:
        """The constraints as texts."""
        made = []
        for name, sense, side, terms in self.rows:
            words = [f"{column} {number}" for column, number in terms.items()]
            made.append(" ".join([name, sense, str(side), str(len(terms)), *words]))
        return made

    def bound(self, column: int, *, high: bool) -> tuple[int, Fraction] | None:
        """The constraint that bounds a column, and its side; None where there is none."""
        index = (self._high if high else self._low).get(column)
        return None if index is None else (index, Fraction(self.rows[index].side))

    def row(self, row: int, *, above: bool) -> tuple[int, Fraction]:
        """The constraint of one side of a row, and that side."""
        index = (self._above if above else self._below)[row]
        return index, Fraction(self.rows[index].side)


def constraints_of(model: Model, added: int, *, refuted: bool = False) -> Limits:
    """The constraints of a model, of whose rows those from `added` on are cuts.

    Cuts have the names of their kinds. With `refuted` one more is false.
    """
    rows: list[Row] = []
    low: dict[int, int] = {}
    high: dict[int, int] = {}
    for place, sense, ends in ((low, "G", model.lower), (high, "L", model.upper)):
        for column, end in enumerate(ends.tolist()):
            if isfinite(end):
                place[column] = len(rows)
                rows.append(Row(f"{sense.lower()}{column}", sense, exactly(end), {column: 1}))
    bounds = len(rows)
    below, above = _sides(model, added, rows)
    refutation = len(rows)
    if refuted:
        rows.append(Row(REFUTATION, "G", 1, {}))
    return Limits(rows, bounds, refutation, low, high, below, above)


def _sides(model: Model, added: int, rows: list[Row]) -> tuple[dict[int, int], dict[int, int]]:
    """Add the rows of a model; where the lower and the upper side of each stands."""
    below: dict[int, int] = {}
    above: dict[int, int] = {}
    kinds = {row: tag.kind for tag in model.tags for row in range(tag.start, tag.stop)}
    matrix = model.matrix
    data = [exactly(number) for number in matrix.data.tolist()]
    indices, begin = matrix.indices.tolist(), matrix.indptr.tolist()
    for row, (least, most) in enumerate(
        zip(model.row_lower.tolist(), model.row_upper.tolist(), strict=True)
    ):
        part = slice(begin[row], begin[row + 1])
        terms = dict(zip(indices[part], data[part], strict=True))
        name = f"{kinds[row]}{row}" if row >= added else f"r{row}"
        if least == most:
            below[row] = above[row] = len(rows)
            rows.append(Row(name, "E", exactly(least), terms))
            continue
        for side, place, sense in ((least, below, "G"), (most, above, "L")):
            if isfinite(side):
                place[row] = len(rows)
                rows.append(Row(f"{name}{sense.lower()}", sense, exactly(side), terms))
    return below, above


def exactly(number: float) -> int | Fraction:
    """A double as what it is."""
    return int(number) if number.is_integer() else Fraction(number)
