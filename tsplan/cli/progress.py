"""Progress on stderr while a plan is sought: one live line, or plain lines without a terminal."""

from __future__ import annotations

import time
from contextlib import suppress
from typing import TYPE_CHECKING, Self

from tsplan.cli.output import ERR, remark
from tsplan.run.events import Bound, Event, Incumbent, Stage
from tsplan.words import number, visible

if TYPE_CHECKING:
    from rich.live import Live
    from rich.text import Text

_EVERY = 5.0  # seconds between plain lines that tell nothing but a new bound
_REFRESH = 8  # live lines a second


class Progress:
    """Shows stage, best objective, bound, gap and elapsed time; a context manager.

    Whatever goes wrong with showing costs words, never the work that is told of.
    """

    def __init__(self, *, quiet: bool = False) -> None:
        self.quiet = quiet
        self._began = time.monotonic()
        self._said = -_EVERY
        self._stage = "start"
        self._news: Incumbent | Bound | None = None
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
        important = not isinstance(event, Bound)
        if isinstance(event, Stage):
            if event.name != self._stage:
                self._news = None
            self._stage = event.name
        else:
            if event.stage != self._stage:
                important = True
            self._stage, self._news = event.stage, event
        if self.quiet or self._live is not None:
            return
        if ERR.isatty():
            self._begin()
            return
        now = time.monotonic()
        if important or now - self._said >= _EVERY:
            self._said = now
            remark(self.line())

    def note(self, text: str) -> None:
        """Write a line of its own, however quiet: it says what became of the work."""
        self.pause()
        remark(text)

    def line(self) -> str:
        """Stage, objective, bound, gap and elapsed time as far as they are known."""
        parts = [visible(self._stage)]
        news = self._news
        if news is not None and news.objective is not None:
            parts.append(f"best {number(news.objective)}")
        if news is not None and news.bound is not None:
            parts.append(f"bound {number(news.bound)}")
        if news is not None and news.gap is not None:
            parts.append(f"gap {news.gap:.1%}")
        return "  ".join([*parts, f"{time.monotonic() - self._began:.1f} s"])

    def _rendered(self) -> Text:
        from rich.text import Text  # noqa: PLC0415  (slow to import)

        return Text(self.line(), no_wrap=True, overflow="ellipsis")
