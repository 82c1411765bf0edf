"""Reading the formula, the weights and the trace that a command is given."""

from __future__ import annotations

from dataclasses import replace
from math import isfinite
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from pydantic import RootModel

from tsplan import logic
from tsplan.document.document import LARGEST_FILE, read_document
from tsplan.document.files import read_text
from tsplan.document.validation import validated
from tsplan.errors import Finding, FormulaError, InputError
from tsplan.logic.traces import SignalTrace
from tsplan.mission.entry_fields import Name
from tsplan.mission.mission_schema import WeightEntry
from tsplan.words import nfc

if TYPE_CHECKING:
    import argparse
    from collections.abc import Iterator, Mapping, Sequence

    from tsplan.logic.weight_values import Weight

_SHAPE = "write the signals' names in the first line and a row of numbers for each step"


class _Weights(RootModel[dict[Name, WeightEntry]]):
    """Weights by their names."""


def formula_of(options: argparse.Namespace) -> logic.Formula:
    """The formula of a command, which is given as text or as the name of a file of it."""
    weights = {} if options.weights is None else weights_of(options.weights)
    if not _is_file(options.formula):
        return logic.parse(options.formula, options.language, weights=weights)
    text = read_text(options.formula, most=LARGEST_FILE)
    try:
        return logic.parse(text, options.language, weights=weights)
    except FormulaError as error:
        found = (replace(finding, source=options.formula) for finding in error.findings)
        raise FormulaError(found) from None


def _is_file(given: str) -> bool:
    try:
        return Path(given).is_file()
    except (OSError, ValueError):  # too long for a name, or with letters that none has
        return False


def weights_of(path: Path) -> Mapping[str, Weight]:
    """The weights of a file: a YAML mapping of their names, as missions have it."""
    read, findings = validated(read_document(path), _Weights)
    if read is None:
        raise InputError(findings)
    return read.root


def trace_of(path: Path) -> SignalTrace:
    """The signals of a table: a line of names, then a row of numbers for each step, by commas."""
    lines = read_text(path, most=LARGEST_FILE).split("\n")
    rows = [(number, _cells(line)) for number, line in enumerate(lines, start=1) if line.strip()]
    if len(rows) < 2:  # noqa: PLR2004  (names and one step)
        raise InputError([Finding("this is no table with a step in it", _SHAPE, str(path))])
    names = [_name(cell) for cell in rows[0][1]]
    findings = [*_faults_of_names(rows[0], names), *_faults_of_rows(rows[1:], names)]
    if findings:
        raise InputError(replace(finding, source=str(path)) for finding in findings)
    values = np.array([[float(cell) for cell in cells] for _, cells in rows[1:]])
    return SignalTrace(dict(zip(names, values.T, strict=True)))


def _cells(line: str) -> Sequence[str]:
    """The parts of a line between commas outside of quotes, as they are written."""
    if '"' not in line:
        return line.split(",")
    cells, quoted, start = [], False, 0
    for place, letter in enumerate(line):
        quoted ^= letter == '"'
        if letter == "," and not quoted:
            cells.append(line[start:place])
            start = place + 1
    return [*cells, line[start:]]


def _name(cell: str) -> str:
    name = nfc(cell.strip())
    quoted = len(name) > 1 and name[0] == name[-1] == '"'
    return name[1:-1].replace('""', '"') if quoted else name


Row = tuple[int, "Sequence[str]"]


def _at(row: Row, place: int, message: str, remedy: str) -> Finding:
    """A finding at one of the cells of a row."""
    line, cells = row
    before = sum(len(cell) + 1 for cell in cells[:place])
    blank = len(cells[place]) - len(cells[place].lstrip())
    return Finding(message, remedy, None, line, before + blank + 1)


def _faults_of_names(row: Row, names: Sequence[str]) -> Iterator[Finding]:
    if all(_number(name) is not None for name in names):
        yield _at(row, 0, "the first line has numbers and no names of signals", _SHAPE)
        return
    for place, name in enumerate(names):
        if not name:
            yield _at(row, place, "a column has no name", _SHAPE)
        elif name in names[:place]:
            yield _at(row, place, f"the signal '{name}' has two columns", "leave one of them out")


def _faults_of_rows(rows: Sequence[Row], names: Sequence[str]) -> Iterator[Finding]:
    for row in rows:
        for place, cell in enumerate(row[1]):
            if _number(cell) is None:
                what = (
                    f"'{cell.strip()}' is no finite number"
                    if cell.strip()
                    else "a value is missing"
                )
                yield _at(row, place, what, "write a number, as in 1.5")
        if len(row[1]) != len(names):
            last = len(row[1]) - 1
            what = f"this row has {len(row[1])} values for {len(names)} signals"
            yield _at(row, last, what, "separate one value for each signal by commas")


def _number(cell: str) -> float | None:
    """The number of a cell; Python's underscores between digits are none of a table's."""
    try:
        value = float(cell)
    except ValueError:
        return None
    return value if isfinite(value) and "_" not in cell else None
