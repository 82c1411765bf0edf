"""How far the planner is, in one line, and where Python code shows it."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from contextlib import suppress
from typing import TYPE_CHECKING, Any, Self, TextIO

from tsplan.run.events import Bound, Event, Incumbent, Stage
from tsplan.words import number, visible

if TYPE_CHECKING:
    from tsplan.run.run import Listener

_EVERY = 5.0  # seconds between plain lines that tell nothing but a new bound
_REFRESH = 0.1  # seconds between two looks of a line that is written over


class ProgressLine:
    """What the planner has told, as one line: stage, objective, bound, gap and elapsed time."""

    def __init__(self) -> None:
        self._began = time.monotonic()
        self._said = -_EVERY
        self._stage = "start"
        self._news: Incumbent | Bound | None = None
        self._important = False

    def take(self, event: Event) -> None:
        """Take in what the planner tells."""
        important = not isinstance(event, Bound)
        if isinstance(event, Stage):
            if event.name != self._stage:
                self._news = None
            self._stage = event.name
        else:
            if event.stage != self._stage:
                important = True
            self._stage, self._news = event.stage, event
        self._important = important

    def due(self) -> bool:
        """Whether it is time for a line of its own, where none can be written over."""
        now = time.monotonic()
        if not (self._important or now - self._said >= _EVERY):
            return False
        self._said = now
        return True

    def __str__(self) -> str:
        parts = [visible(self._stage)]
        news = self._news
        if news is not None and news.objective is not None:
            parts.append(f"best {number(news.objective)}")
        if news is not None and news.bound is not None:
            parts.append(f"bound {number(news.bound)}")
        if news is not None and news.gap is not None:
            parts.append(f"gap {news.gap:.1%}")
        return "  ".join([*parts, f"{time.monotonic() - self._began:.1f} s"])


class ProgressDisplay:
    """Shows how far the planner is below a notebook's cell, or on stderr; a context manager.

    It is a listener to the planner's events, which passes them on to another one. Whatever goes
    wrong with showing costs words, never the work that is told of.
    """

    def __init__(self, listener: Listener | None = None) -> None:
        self._listener = listener
        self._line = ProgressLine()
        self._show: Callable[[str], object] = _shower(sys.stderr, self._line)
        self._shown = float("-inf")

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        with suppress(Exception):
            self._show("")

    def __call__(self, event: Event) -> bool | None:
        """Take in what the planner tells; whether the other listener wants it to stop."""
        with suppress(Exception):
            self._line.take(event)
            now = time.monotonic()
            if not isinstance(event, Bound) or now - self._shown >= _REFRESH:
                self._shown = now
                self._show(str(self._line))
        return None if self._listener is None else self._listener(event)


def _shower(stream: TextIO, line: ProgressLine) -> Callable[[str], object]:
    """What shows a text in place of the one before; without such a place, when it is due."""
    shell = _notebook()
    if shell is not None:
        return _cell(shell)
    if stream.isatty():
        return lambda text: (stream.write(f"\r\x1b[K{text}"), stream.flush())
    return lambda text: print(text, file=stream, flush=True) if text and line.due() else None


def _notebook() -> Any:
    """The part of IPython that shows things, where this is the kernel of a notebook."""
    python = sys.modules.get("IPython")  # a kernel has loaded it
    shell = None if python is None else python.get_ipython()
    return sys.modules.get("IPython.display") if hasattr(shell, "kernel") else None


def _cell(shell: Any) -> Callable[[str], object]:
    """What writes a text over below the cell."""
    handle = shell.display({"text/plain": ""}, raw=True, display_id=True)
    return lambda text: handle.update({"text/plain": text}, raw=True)
