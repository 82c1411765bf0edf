"""Progress on stderr while a plan is sought: one live line, or plain lines without a terminal."""

from __future__ import annotations

from contextlib import suppress
from typing import TYPE_CHECKING, Self

from tsplan.cli.output import ERR, remark
from tsplan.run.progress_line import ProgressLine

if TYPE_CHECKING:
    from rich.live import Live
    from rich.text import Text

    from tsplan.run.events import Event

_REFRESH = 8  # live lines a second


class Progress:
    """Shows stage, best objective, bound, gap and elapsed time; a context manager.

    Whatever goes wrong with showing costs words, never the work that is told of.
    """

    def __init__(self, *, quiet: bool = False) -> None:
        self.quiet = quiet
        self._known = ProgressLine()
        self._live: Live | None = None

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.pause()

    def pause(self) -> None:
        """Take the live line away until the next event."""
        live, self._live = self._live, None
        if live is not None:
            with suppress(Exception):
                live.stop()

    def _begin(self) -> None:
        """Show the live line. Not before the first event: processes are begun without threads."""
        from rich.console import Console  # noqa: PLC0415  (slow to import)
        from rich.live import Live  # noqa: PLC0415

        self._live = Live(
            console=Console(file=ERR),  # type: ignore[arg-type]
            get_renderable=self._rendered,
            refresh_per_second=_REFRESH,
            transient=True,
            redirect_stdout=False,
            redirect_stderr=False,
        )
        self._live.start()

    def tell(self, event: Event) -> None:
        """Take in what the planner tells."""
        with suppress(Exception):
            self._tell(event)

    def _tell(self, event: Event) -> None:
        self._known.take(event)
        if self.quiet or self._live is not None:
            return
        if ERR.isatty():
            self._begin()
        elif self._known.due():
            remark(self.line())

    def note(self, text: str) -> None:
        """Write a line of its own, however quiet: it says what became of the work."""
        self.pause()
        remark(text)

    def line(self) -> str:
        """Stage, objective, bound, gap and elapsed time as far as they are known."""
        return str(self._known)

    def _rendered(self) -> Text:
        from rich.text import Text  # noqa: PLC0415  (slow to import)

        return Text(self.line(), no_wrap=True, overflow="ellipsis")
