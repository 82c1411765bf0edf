"""Native work in a thread of its own, watched by the thread that asked for it.

Native code cannot be left from outside: it can only be asked to stop. The watchdog asks it when the
time is up, when the listener or `asked` wants it, and on Ctrl-C, and it hears the news of the work
in the calling thread, where an exception means what it says. Native code that does not stop soon
after it was asked is left behind, so that a time limit holds whatever the solver does.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, field
from queue import Empty, SimpleQueue
from threading import Thread
from typing import Any, Generic, TypeVar

from tsplan.process.grace_period import NATIVE, GracePeriod
from tsplan.stopping import StoppedBy

R = TypeVar("R")


@dataclass(frozen=True, slots=True)
class Ended(Generic[R]):
    """The end of some work, with its result."""

    result: R


@dataclass(frozen=True, slots=True)
class _Failed:
    error: BaseException


@dataclass(eq=False)
class Watchdog:
    """Watches one piece of native work.

    `hear` is called with what the work tells, `asked` when there is no news; both may return True
    to stop. `stop` is called once, when the work is to stop; it must not block. `deadline` is a
    time of `time.perf_counter`.
    """

    deadline: float | None = None
    hear: Callable[[Any], bool] = lambda _: False
    asked: Callable[[], bool] = lambda: False
    stop: Callable[[], object] = lambda: None
    grace: GracePeriod = NATIVE
    stopped_by: StoppedBy | None = field(default=None, init=False)
    _stopped: float = field(default=0.0, init=False)
    _news: SimpleQueue[object] = field(default_factory=SimpleQueue, init=False)

    @property
    def stopping(self) -> bool:
        """Whether the work is to stop; asked from its thread."""
        return self.stopped_by is not None

    def tell(self, news: object) -> None:
        """Pass news to the calling thread; called from the work's thread."""
        self._news.put(news)

    def run(self, work: Callable[[], R]) -> Ended[R] | None:
        """Run `work` in a thread of its own; None if it had to be left behind.

        Raises what `work` raises. A second Ctrl-C raises KeyboardInterrupt.
        """

        def worked() -> None:
            try:
                self._news.put(Ended(work()))
            except BaseException as error:  # noqa: BLE001 - raised again in the calling thread
                self._news.put(_Failed(error))

        # not a daemon: the interpreter must not end under native code that still runs
        thread = Thread(target=worked, name="solver")
        try:
            thread.start()
            ended = self._watched()
        except BaseException:
            self._stop(StoppedBy.INTERRUPT)
            raise
        if isinstance(ended, _Failed):
            raise ended.error
        return ended

    def _watched(self) -> Ended[Any] | _Failed | None:
        while not self._left_behind:
            try:
                news = self._next()
                if isinstance(news, Ended | _Failed):
                    return news
                if self.deadline is not None and time.perf_counter() >= self.deadline:
                    self._stop(StoppedBy.TIME_LIMIT)
                elif self.asked() if news is None else self.hear(news):
                    self._stop(StoppedBy.INTERRUPT)
            except KeyboardInterrupt:
                if self.stopped_by is StoppedBy.INTERRUPT:
                    raise
                self._stop(StoppedBy.INTERRUPT)
        return None

    def _next(self) -> object | None:
        # a wait on the queue, unlike the join of a thread, survives Ctrl-C
        wait = self.grace.poll
        if self.deadline is not None and not self.stopping:
            wait = min(wait, max(self.deadline - time.perf_counter(), 0.0))
        try:
            return self._news.get(timeout=wait)
        except Empty:
            return None

    def _stop(self, why: StoppedBy) -> None:
        if self.stopped_by is None:
            self.stopped_by, self._stopped = why, time.perf_counter()
            self.stop()

    @property
    def _left_behind(self) -> bool:
        why = self.stopped_by
        return why is not None and time.perf_counter() - self._stopped > self.grace.after(why)
