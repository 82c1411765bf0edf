"""The processes that one thread has started, as far as the system tells.

They are needed to stop a solver that a modelling layer runs as a command and keeps to itself.
"""

from __future__ import annotations

import os
import signal
import threading
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path


@dataclass(eq=False)
class Offspring:
    """The processes started by the thread that calls `mine`; none where they cannot be known."""

    _thread: int | None = field(default=None, init=False)

    def mine(self) -> None:
        """From now on, this thread's processes are meant."""
        self._thread = threading.get_native_id()

    def interrupt(self) -> None:
        """Ask them to stop, as Ctrl-C does; most solvers keep their best point."""
        self._signal(signal.SIGINT)

    def kill(self) -> None:
        """End them at once."""
        self._signal(getattr(signal, "SIGKILL", signal.SIGTERM))

    def _signal(self, number: int) -> None:
        for process in self._processes():
            with suppress(ProcessLookupError):
                os.kill(process, number)

    def _processes(self) -> list[int]:
        if self._thread is None:
            return []
        listed = Path(f"/proc/self/task/{self._thread}/children")
        with suppress(OSError):
            return [int(word) for word in listed.read_text().split()]
        return []
