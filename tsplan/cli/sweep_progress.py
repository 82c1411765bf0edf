"""Progress of a sweep on stderr: a bar on a terminal, a line for each run elsewhere."""

from __future__ import annotations

from contextlib import suppress
from typing import TYPE_CHECKING, Any, Self

from tsplan.cli.output import ERR, remark
from tsplan.sweeps.sweep_summary import axis_words, outcome_words

if TYPE_CHECKING:
    from tsplan.sweeps.sweep_rows import SweepRow


class SweepProgress:
    """Tells of the runs of a sweep as they end; a context manager.

    Whatever goes wrong with showing costs words, never the work that is told of. No thread redraws
    the bar: processes are begun quickly only without one.
    """

    def __init__(self, total: int, done: int, *, quiet: bool = False) -> None:
        self.quiet = quiet
        self._total, self._done, self._failed = total, done, 0
        self._bar: Any = None

    def __enter__(self) -> Self:
        if not self.quiet and ERR.isatty():
            with suppress(Exception):
                self._begin()
        return self

    def __exit__(self, *_: object) -> None:
        bar, self._bar = self._bar, None
        if bar is not None:
            with suppress(Exception):
                bar.stop()

    def _begin(self) -> None:
        from rich import progress  # noqa: PLC0415  (slow to import)
        from rich.console import Console  # noqa: PLC0415

        self._bar = progress.Progress(
            progress.BarColumn(),
            progress.MofNCompleteColumn(),
            progress.TimeElapsedColumn(),
            progress.TextColumn("{task.description}", markup=False),
            console=Console(file=ERR),  # type: ignore[arg-type]
            auto_refresh=False,
            transient=True,
            redirect_stdout=False,
            redirect_stderr=False,
        )
        self._bar.add_task("", total=self._total, completed=self._done)
        self._bar.start()
        self._bar.refresh()

    def tell(self, row: SweepRow) -> None:
        """Take in the row of a run that is done."""
        self._done += 1
        self._failed += row.failed
        if self.quiet:
            return
        with suppress(Exception):
            line = f"{axis_words(row)}: {outcome_words(row)}"
            if self._bar is None:
                remark(f"[{self._done}/{self._total}] {' '.join(line.split())}")
                return
            failed = f"{self._failed} failed; " if self._failed else ""
            self._bar.update(0, completed=self._done, description=f"{failed}{line}")
            self._bar.refresh()
