"""What the command line writes to stdout and stderr, whatever these are.

A stream may be closed, full, of an encoding without the letters of a name, or read by somebody who
has seen enough. On stderr that costs words and nothing else. On stdout a full disk is an error of
its own, and a reader who leaves is none.
"""

from __future__ import annotations

import os
import re
import sys
from contextlib import suppress
from typing import TYPE_CHECKING, Literal

from tsplan.errors import InputError
from tsplan.words import visible

if TYPE_CHECKING:
    from collections.abc import Callable

    from rich.console import Console

Name = Literal["stdout", "stderr"]

_LINES = "\n\t"
_OUTSIDE_ASCII = re.compile(r"[^\x00-\x7e]")


class OutputError(Exception):
    """Stdout cannot be written to; what was found out is not shown."""


class Stream:
    """Stdout or stderr, as far as something to print to needs it; looked up anew each time."""

    def __init__(self, name: Name) -> None:
        self._name = name

    @property
    def encoding(self) -> str:
        """The encoding of the stream."""
        return getattr(getattr(sys, self._name), "encoding", None) or "utf-8"

    def isatty(self) -> bool:
        """Whether a person watches."""
        try:
            return bool(getattr(sys, self._name).isatty())
        except (AttributeError, OSError, ValueError):
            return False

    def fileno(self) -> int:
        """The descriptor behind the stream; OSError where there is none."""
        stream = getattr(sys, self._name)
        if stream is None:
            raise OSError(f"{self._name} is closed")
        return int(stream.fileno())

    def write(self, text: str) -> int:
        """Write a text, with letters that the encoding does not have as escapes."""
        stream = getattr(sys, self._name)
        if stream is not None:
            name = self.encoding
            shown = text.encode(name, "backslashreplace").decode(name)
            self._attempt(lambda: stream.write(shown))
        return len(text)

    def flush(self) -> None:
        """Write out what is held back. Raises OutputError for a stdout that takes nothing."""
        stream = getattr(sys, self._name)
        if stream is not None:
            self._attempt(stream.flush)

    def _attempt(self, action: Callable[[], object]) -> None:
        try:
            action()
        except BrokenPipeError:
            self._give_up()
        except (OSError, ValueError) as error:
            self._give_up()
            if self._name == "stdout":
                reason = getattr(error, "strerror", None) or str(error)
                raise OutputError(f"cannot write to the standard output: {reason}") from None

    def _give_up(self) -> None:
        """Let what is still held back, and all that follows, go nowhere."""
        with suppress(OSError, ValueError):
            nowhere = os.open(os.devnull, os.O_WRONLY)
            os.dup2(nowhere, self.fileno())
            os.close(nowhere)


OUT = Stream("stdout")
ERR = Stream("stderr")


def say(text: str) -> None:
    """Write a line of what was asked for to stdout; what could not be seen is escaped."""
    OUT.write(visible(text, _LINES) + "\n")


def remark(text: str) -> None:
    """Write a line about the work to stderr."""
    ERR.write(visible(text, _LINES) + "\n")
    ERR.flush()


def say_json(text: str) -> None:
    """Write a JSON document to stdout; letters that the encoding does not have stay JSON."""
    try:
        text.encode(OUT.encoding)
        shown = text if visible(text, _LINES) == text else _in_ascii(text)
    except UnicodeEncodeError:
        shown = _in_ascii(text)
    OUT.write(shown)


def _in_ascii(text: str) -> str:
    return _OUTSIDE_ASCII.sub(lambda match: _json_escape(match.group()), text)


def _json_escape(letter: str) -> str:
    units = letter.encode("utf-16-be", "surrogatepass")
    return "".join(f"\\u{units[n]:02x}{units[n + 1]:02x}" for n in range(0, len(units), 2))


def attempted(write: Callable[[], object]) -> InputError | None:
    """Write a file before anything is printed; what keeps it from being written comes last."""
    try:
        write()
    except InputError as error:
        return error
    return None


def console(width: int) -> Console:
    """Where tables for people go: stdout, `width` columns wide where it is no terminal."""
    from rich.console import Console  # noqa: PLC0415  (slow to import)

    plain = {"emoji": False, "markup": False, "highlight": False}
    own = Console(file=OUT, **plain)  # type: ignore[arg-type]
    return own if own.is_terminal else Console(file=OUT, width=width, **plain)  # type: ignore[arg-type]


def fill_closed() -> None:
    """Give closed standard descriptors a place: the next file that is opened must not get one."""
    for descriptor in range(3):
        try:
            os.fstat(descriptor)
        except OSError:
            with suppress(OSError):
                os.open(os.devnull, os.O_RDWR)
