"""A sweep in words and one table, for people, and as JSON for programs."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from tsplan.exact_json import canonical
from tsplan.plans.records import as_json, json_document, json_lines
from tsplan.plans.summary import seen
from tsplan.sweeps.sweep_rows import SweepResults, SweepRow
from tsplan.words import many, number

if TYPE_CHECKING:
    from rich.console import RenderableType

MOST_ROWS = 60
"""Rows that are listed; the file of the table has all of them."""

_FORMAT = "tsplan-sweep-results/1"
_LONGEST = 40  # letters of a value


def axis_words(row: SweepRow) -> str:
    """The values of a run, in one line."""
    return ", ".join(f"{column} {shown_value(value)}" for column, value in row.axes.items())


def outcome_words(row: SweepRow) -> str:
    """What became of a run, in one line."""
    if row.failed:
        return f"failed: {row['error']}"
    values = [f"{name} {number(row[f'value.{name}'])}" for name in objectives(row)]
    ended = f" ({row['stopped_by']})" if row.get("stopped_by") else ""
    return ", ".join([f"{row['status']}{ended}", *values, f"{row['seconds.wall']:.2f} s"])


def objectives(row: Mapping[str, Any]) -> list[str]:
    """The objectives of which a row has a value."""
    names = (column.partition(".") for column in row if column.startswith("value."))
    return [name for _, _, name in names if row[f"value.{name}"] is not None]


def shown_value(value: Any) -> str:
    """A value of an axis, short."""
    text = value if isinstance(value, str) else canonical(value)
    return text if len(text) <= _LONGEST else f"{text[: _LONGEST - 3]}..."


def counts_line(results: SweepResults, total: int) -> str:
    """How many runs ended in which way."""
    ends = Counter("failed" if row.failed else str(row["status"]) for row in results)
    told = ", ".join(f"{count} {name}" for name, count in ends.items())
    left = total - len(results)
    return (
        f"{many(total, 'run')}: {', '.join(filter(None, [told, f'{left} open' if left else '']))}"
    )


def sweep_parts(results: SweepResults, total: int) -> Iterator[RenderableType]:
    """The lines and the table of a summary."""
    if results:
        yield _table(results)
        hidden = len(results) - MOST_ROWS
        if hidden > 0:
            yield f"... and {many(hidden, 'more row')}"
        yield ""
    yield counts_line(results, total)


def _table(results: SweepResults) -> RenderableType:
    from rich.table import Table  # noqa: PLC0415  (slow to import)
    from rich.text import Text  # noqa: PLC0415

    varied = varied_axes(results)
    names = list(dict.fromkeys(name for row in results for name in objectives(row)))
    table = Table(box=None, pad_edge=False, show_edge=False, padding=(0, 1))
    for column in (*varied, "status"):
        table.add_column(next(seen([column])), overflow="fold")
    for name in (*names, "seconds"):
        table.add_column(name, overflow="fold", justify="right")
    for row in results[:MOST_ROWS]:
        cells = [shown_value(row.axes[axis]) if axis in row.axes else "" for axis in varied]
        values = [_number(row.get(f"value.{name}")) for name in names]
        cells += [_status(row), *values, f"{row.get('seconds.wall') or 0:.2f}"]
        table.add_row(*map(Text, seen(cells)))
    return table


def _status(row: SweepRow) -> str:
    if row.failed:
        return str(row["error_kind"])
    stopped = row.get("stopped_by")
    return f"{row['status']} ({stopped})" if stopped else str(row["status"])


def _number(value: float | None) -> str:
    return "" if value is None else number(value)


def varied_axes(results: Sequence[SweepRow]) -> list[str]:
    """The axes of which the rows have several values, or all axes if there is none."""
    every = list(dict.fromkeys(column for row in results for column in row.axes))
    several = [
        column
        for column in every
        if len({canonical([row.axes.get(column)]) for row in results}) > 1
    ]
    return several or every


def sweep_json(results: SweepResults, total: int, files: Mapping[str, str]) -> str:
    """A sweep as JSON: how many runs ended how, the types of the columns, and every row."""
    ends = Counter("failed" if row.failed else str(row["status"]) for row in results)
    entries: dict[str, Any] = {
        "format": _FORMAT,
        "runs": total,
        "recorded": len(results),
        "outcomes": dict(ends),
        **files,
        "dtypes": results.dtypes,
        "rows": None,
    }
    rows = [as_json({column: row.get(column) for column in results.columns}) for row in results]
    return json_document(entries, {"rows": lambda: json_lines(rows)})
