"""How a parent process holds the child that works for it: asks it to stop, and ends it in time.

A child that listens ends by itself. One that does not, because native code does not come back or
because the system has stopped it, is ended from outside when its time and some grace are up.
"""

from __future__ import annotations

import os
import signal
import threading
import time
from contextlib import suppress
from dataclasses import dataclass, field
from multiprocessing.process import BaseProcess


@dataclass(frozen=True, slots=True)
class Patience:
    """Seconds that a child gets.

    `limit` is for its work (None: any time), `grace` from then on, or from when it was asked to
    stop, until it is ended; `finishing` takes the place of `grace` once the child has said that it
    only makes its answer ready; `settling` is to end after its answer. `poll` is between looks.
    """

    limit: float | None = None
    grace: float = 5.0
    finishing: float = 25.0
    settling: float = 1.0
    poll: float = 0.05


USUAL = Patience()
"""What a child gets where nothing else is said."""


@dataclass(eq=False)
class Leash:
    """One child process, held by whoever started it; usable in signal handlers.

    `asked` counts the requests to stop, `late` says that the child was ended for being late.
    """

    patience: Patience = USUAL
    asked: int = field(default=0, init=False)
    late: bool = field(default=False, init=False)
    finishing: bool = field(default=False, init=False)
    _child: BaseProcess | None = field(default=None, init=False)
    _here: bool = field(default=False, init=False)
    _began: float = field(default=0.0, init=False)
    _since: float | None = field(default=None, init=False)
    _done: threading.Event = field(default_factory=threading.Event, init=False)
    _watch: threading.Thread | None = field(default=None, init=False)

    def ask(self) -> None:
        """Ask the child to stop, as Ctrl-C does; the second time, end it."""
        self.asked += 1
        if self._since is None:
            self._since = time.monotonic()
        if self.asked > 1:
            self.end()
        else:
            self._interrupt()

    def end(self) -> None:
        """End the child at once."""
        if self._child is not None:
            self._child.kill()

    def _interrupt(self) -> None:
        if self._here:
            signal.raise_signal(signal.SIGINT)
        elif self._child is not None and self._child.pid is not None:
            with suppress(ProcessLookupError):
                os.kill(self._child.pid, signal.SIGINT)

    def hold(self, child: BaseProcess) -> None:
        """Begin to watch a child that has just started."""
        self._child, self._began, self._here = child, time.monotonic(), False
        if self.asked:
            self._interrupt()
        self._watch = threading.Thread(target=self._look, name="leash", daemon=True)
        self._watch.start()

    def hold_here(self) -> None:
        """The work is done in this process: it can be asked, and cannot be ended."""
        self._here = True

    def let_go(self) -> None:
        """End the watch."""
        self._done.set()
        if self._watch is not None:
            self._watch.join()
        self._child, self._here = None, False

    def _look(self) -> None:
        while not self._done.wait(self.patience.poll):
            if self._overdue(time.monotonic()):
                self.late = True
                self.end()
                return

    def _overdue(self, now: float) -> bool:
        limit = self.patience.limit
        ends = [] if limit is None else [self._began + limit]
        if self._since is not None:
            ends.append(self._since)
        more = self.patience.finishing if self.finishing else self.patience.grace
        return bool(ends) and now > min(ends) + more
