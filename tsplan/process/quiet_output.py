"""Keeping native libraries from writing into the program's output.

Libraries such as solvers write to file descriptors 1 and 2, past whatever Python has set up: a
banner when they are loaded, the text of a licence. Here these descriptors lead elsewhere while
native code is loaded or begun, and back as soon as the last one is done. They belong to the whole
process, so what else it writes just then is lost too: the hush is kept short, and is kept up during
long work only where no other thread could want to speak.
"""

from __future__ import annotations

import os
import sys
import tempfile
import threading
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager, nullcontext, suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import IO, TypeVar

A = TypeVar("A")
R = TypeVar("R")
Hear = Callable[[str], None]

_OUTPUTS = (1, 2)


@dataclass(eq=False)
class _Outputs:
    """The two descriptors: where they lead, and how many want them hushed or heard."""

    lock: threading.RLock = field(default_factory=threading.RLock)
    hushed: int = 0
    aloud: int = 0
    sink: IO[bytes] | None = None
    former: dict[int, int] = field(default_factory=dict)

    @contextmanager
    def wanted(self, hushed: int = 0, aloud: int = 0) -> Iterator[None]:
        """Meanwhile one more wants the descriptors hushed, or heard."""
        try:
            self._change(hushed, aloud)
            yield
        finally:
            self._change(-hushed, -aloud)

    def _change(self, hushed: int, aloud: int) -> None:
        """Count, and lead the descriptors where they now belong."""
        with self.lock:
            self.hushed = max(self.hushed + hushed, 0)
            self.aloud = max(self.aloud + aloud, 0)
            silent = self.hushed > 0 and self.aloud == 0
            if silent and not self.former:
                self._away()
            elif not silent and self.former:
                self._back()

    def _away(self) -> None:
        flush()
        if self.sink is None:
            self.sink = _sink()
        for output in _OUTPUTS:
            with suppress(OSError):  # one that is closed needs no hush
                self.former[output] = os.dup(output)
                os.dup2(self.sink.fileno(), output)

    def _back(self) -> None:
        flush()
        while self.former:
            output, kept = self.former.popitem()
            os.dup2(kept, output)
            os.close(kept)

    def take(self) -> str:
        """What was written, once nobody wants the hush any more."""
        with self.lock:
            if self.hushed or self.sink is None:
                return ""
            sink, self.sink = self.sink, None
            with sink:
                sink.seek(0)
                return sink.read(_MOST).decode(errors="replace")


def _sink() -> IO[bytes]:
    """A file without a name; without room for one, what is written is gone."""
    try:
        return tempfile.TemporaryFile()
    except OSError:
        return Path(os.devnull).open("w+b")


_MOST = 100_000  # bytes of a library's words that are passed on
_outputs = _Outputs()  # descriptors are the process's, so what is known of them is too


@contextmanager
def hushed(hear: Hear | None = None) -> Iterator[None]:
    r"""Nothing that is written to file descriptors 1 and 2 meanwhile is seen.

    What was written goes to `hear`, line by line, where this is the only hush of the process at its
    end. May be used in several threads at once and within itself.

    >>> with hushed(print):
    ...     _ = os.write(1, b"a banner\n")
    a banner
    """
    try:
        with _outputs.wanted(hushed=1):
            yield
    finally:
        text = _outputs.take()
    if hear is not None:
        for line in text.splitlines():
            hear(line)


def aloud() -> AbstractContextManager[None]:
    """Within a hush: what is written meanwhile is seen, as when the user's own code is called."""
    return _outputs.wanted(aloud=1)


def audible(call: Callable[[A], R]) -> Callable[[A], R]:
    """The user's own code, called from within a hush: what it prints is seen."""

    def heard(argument: A) -> R:
        with aloud():
            return call(argument)

    return heard


def hushed_alone(hear: Hear | None = None) -> AbstractContextManager[None]:
    """A hush for long work; none where another thread runs, whose words would be lost."""
    return hushed(hear) if threading.active_count() == 1 else nullcontext()


def hush_for_good(place: str) -> None:
    """Lead both descriptors into a file until this process ends."""
    flush()
    sink = os.open(place, os.O_WRONLY | os.O_CREAT | os.O_APPEND, 0o600)
    for output in _OUTPUTS:
        os.dup2(sink, output)
    os.close(sink)


def flush() -> None:
    """Write out what Python and the C library still hold back, so that it goes where it belongs."""
    for stream in (sys.stdout, sys.stderr):
        with suppress(AttributeError, OSError, ValueError):
            stream.flush()
    import ctypes  # noqa: PLC0415 - only where native code is loaded anyway

    with suppress(AttributeError, OSError, TypeError):
        name = "ucrtbase" if sys.platform == "win32" else None
        ctypes.CDLL(name).fflush(None)
