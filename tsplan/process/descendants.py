"""The processes that one thread has started, as far as the system tells.

They are needed to stop a solver that a modelling layer runs as a command and keeps to itself.
"""

from __future__ import annotations

import os
import signal
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

INTERRUPT, KILL = signal.SIGINT, getattr(signal, "SIGKILL", signal.SIGTERM)


@dataclass(eq=False)
class Descendants:
    """The processes started by a thread, given by its native number; nobody's as long as None."""

    thread: int | None = None

    def send(self, number: int) -> None:
        """Signal them all; nobody where the system does not tell of them."""
        listed = Path(f"/proc/self/task/{self.thread}/children")
        with suppress(OSError):
            for process in listed.read_text().split():
                with suppress(ProcessLookupError):
                    os.kill(int(process), number)
