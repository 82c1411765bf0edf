"""The results of a sweep: one row for each run, the columns of a table, and their types."""

from __future__ import annotations

import csv
import io
import json
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType
from typing import Any

from tsplan.document.files import write_whole
from tsplan.limits import is_number

DTYPES: Mapping[str, str] = MappingProxyType(
    {
        "id": "string",
        "status": "string",
        "stopped_by": "string",
        "error_kind": "string",
        "error": "string",
        "verified": "boolean",
        "availability": "Float64",
        "robustness": "Float64",
        "steps": "Int64",
        "agents": "Int64",
        **{f"size.{name}": "Int64" for name in ("columns", "integers", "rows", "nonzeros")},
        **{f"size.{name}": "Int64" for name in ("states", "edges")},
        **{
            f"seconds.{name}": "Float64"
            for name in (
                *("load", "parse", "reduce", "build", "solve", "extract", "verify"),
                *("total", "wall"),
            )
        },
        "used.solver": "string",
        "used.options": "string",
        "version.solver": "string",
        "version.tsplan": "string",
        "version.python": "string",
        "platform": "string",
        "content": "string",
    }
)
"""The columns that every table has, and their types by the names that pandas has for them."""

_AFTER = "verified"  # the column after which the objectives stand
_LARGEST_WHOLE = 2**63  # of a whole number in 64 bits


@dataclass(frozen=True)
class SweepRow(Mapping[str, Any]):
    """What became of one run, by the names of the columns; what is not known is None.

    `axes` are the values that were varied, `cells` the results.
    """

    axes: Mapping[str, Any]
    cells: Mapping[str, Any]

    def __getitem__(self, column: str) -> Any:
        return self.axes[column] if column in self.axes else self.cells[column]

    def __iter__(self) -> Iterator[str]:
        return iter({**self.axes, **self.cells})

    def __len__(self) -> int:
        return len({**self.axes, **self.cells})

    def __hash__(self) -> int:
        return hash((self.cells.get("id"), self.cells.get("content")))

    @property
    def id(self) -> str:
        """By what the run is known."""
        return str(self.cells["id"])

    @property
    def failed(self) -> bool:
        """Whether there is no answer: an error in the mission, of a solver, of a worker."""
        return self.cells.get("error_kind") is not None


class SweepResults(tuple[SweepRow, ...]):
    """The rows of a sweep in the order of its runs.

    >>> row = SweepRow({"seed": 1}, {"id": "a", "status": "optimal", "value.travel": 2.0})
    >>> results = SweepResults([row])
    >>> results[0]["value.travel"], results.dtypes["seed"], results.columns[:2]
    (2.0, 'Int64', ('id', 'seed'))
    """

    __slots__ = ()

    @property
    def axes(self) -> tuple[str, ...]:
        """The columns of what was varied."""
        return tuple(dict.fromkeys(column for row in self for column in row.axes))

    @property
    def columns(self) -> tuple[str, ...]:
        """All columns: the id, what was varied, and the results."""
        own = dict.fromkeys(column for row in self for column in row.cells)
        objectives = [column for column in own if column not in DTYPES]
        fixed = list(DTYPES)
        place = fixed.index(_AFTER) + 1
        return (fixed[0], *self.axes, *fixed[1:place], *objectives, *fixed[place:])

    @property
    def dtypes(self) -> dict[str, str]:
        """The type of each column, as pandas calls it; all of them may be empty in a row.

        Of what was varied: Int64, Float64 or boolean where all values are of that kind, and
        otherwise string, in which lists and mappings are JSON.
        """
        axes = {column: _dtype([row.axes.get(column) for row in self]) for column in self.axes}
        return {
            column: axes.get(column) or DTYPES.get(column, "Float64") for column in self.columns
        }

    def to_csv(self, path: str | Path | None = None) -> str:
        """The table as CSV, written whole to a file if one is named.

        Raises InputError where that cannot be written.
        """
        stream = io.StringIO()
        writer = csv.writer(stream, lineterminator="\n")
        columns, dtypes = self.columns, self.dtypes
        writer.writerow(columns)
        for row in self:
            writer.writerow([_cell(row.get(column), dtypes[column]) for column in columns])
        if path is not None:
            write_whole(Path(path), stream.getvalue().encode("utf-8", "backslashreplace"))
        return stream.getvalue()


def _dtype(values: Iterable[Any]) -> str:
    there = [value for value in values if value is not None]
    if there and all(isinstance(value, bool) for value in there):
        return "boolean"
    if not there or not all(map(is_number, there)):
        return "string"
    whole = all(isinstance(value, int) and abs(value) < _LARGEST_WHOLE for value in there)
    return "Int64" if whole else "Float64"


def _cell(value: Any, dtype: str) -> str:
    """A value as CSV has it: nothing for None, and what is no text as JSON writes it."""
    if value is None:
        return ""
    if isinstance(value, str):
        return value
    if dtype == "Float64":
        return repr(float(value))
    return json.dumps(value, ensure_ascii=False)
