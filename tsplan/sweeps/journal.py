"""The journal of a sweep: a line of JSON for each run that is done, safe as soon as it is written.

It stands beside the table, which is made from it. A line that was not finished, because the machine
or the process ended, is as if it was never begun.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterable
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from tsplan.errors import Finding, InputError
from tsplan.sweeps.sweep_rows import SweepRow
from tsplan.sweeps.sweep_runs import SweepRun


@dataclass(frozen=True)
class Journal:
    """The file of a journal; there may be none yet."""

    path: Path

    @classmethod
    def beside(cls, table: Path) -> Journal:
        """The journal of a table."""
        return cls(table.with_name(f"{table.name}.journal"))

    def rows(self, runs: Iterable[SweepRun]) -> dict[str, SweepRow]:
        """The rows of runs that are recorded as they would be done now, by the runs' ids."""
        wanted = {run.id: run for run in runs}
        rows = {}
        for values in self._entries():
            run = wanted.get(str(values.get("id")))
            if run is not None and run.content == values.get("content"):
                rows[run.id] = SweepRow(run.axes, values)
        return rows

    def begin(self, *, fresh: bool = False) -> None:
        """Make ready for further lines, after the last whole one; `fresh` forgets all of them.

        Raises InputError where the file cannot be written.
        """
        try:
            with self.path.open("wb" if fresh else "ab+") as stream:
                stream.seek(0)
                content = stream.read() if not fresh else b""
                stream.truncate(content.rfind(b"\n") + 1)
                os.fsync(stream.fileno())
        except OSError as error:
            raise self._unwritable(error) from None
        with suppress(OSError):  # that the file is there; not every system opens folders
            folder = os.open(self.path.parent, os.O_RDONLY)
            try:
                os.fsync(folder)
            finally:
                os.close(folder)

    def append(self, row: SweepRow) -> None:
        """Write the row of a run that is done; it is on the disk when this returns.

        Raises InputError where the file cannot be written.
        """
        entry = {"axes": dict(row.axes), "row": dict(row.cells)}
        line = json.dumps(entry, allow_nan=False, default=str) + "\n"
        try:
            with self.path.open("ab") as stream:
                stream.write(line.encode())
                stream.flush()
                os.fsync(stream.fileno())
        except OSError as error:
            raise self._unwritable(error) from None

    def _entries(self) -> Iterable[dict[str, Any]]:
        """What the whole lines say, in their order."""
        try:
            content = self.path.read_bytes()
        except FileNotFoundError:
            return
        except OSError as error:
            raise self._unwritable(error) from None
        for line in content.split(b"\n")[:-1]:
            try:
                entry = json.loads(line)
            except (ValueError, RecursionError):  # no line of ours
                continue
            if isinstance(entry, dict) and isinstance(entry.get("row"), dict):
                yield entry["row"]

    def _unwritable(self, error: OSError) -> InputError:
        what = f"cannot keep the journal: {error.strerror or 'it cannot be used'}"
        return InputError([Finding(what, "choose another file by -o", str(self.path))])
