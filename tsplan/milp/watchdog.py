"""A native solve in a thread of its own, attended by the thread that asked for it.

Native code cannot be left from outside: it can only be asked to stop. The attendant asks it when
the time is up, when the listener or `asked` wants it, and on Ctrl-C, and it hears the news of the
solve in the calling thread, where an exception means what it says. Native code that does not stop
soon after it was asked is left behind, so that a time limit holds whatever the solver does.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, field
from queue import Empty, SimpleQueue
from threading import Thread
from typing import Any

from tsplan.stopping import StoppedBy

_POLL = 0.05  # seconds between looks at the clock


@dataclass(frozen=True, slots=True)
class Patience:
    """Seconds that native code gets to stop, by what stopped it."""

    time_limit: float = 0.2
    interrupt: float = 1.0


@dataclass(frozen=True)
class _Ended:
    error: BaseException | None


def _never() -> bool:
    return False


def _nothing() -> None:
    return


@dataclass(eq=False)
class Attendant:
    """Runs one native solve.

    `hear` is called with what the solve tells, `asked` when there is no news; both may return True
    to stop. `stop` is called once, when the solve is to stop; it must not block. `deadline` is a
    time of `time.perf_counter`.
    """

    deadline: float | None = None
    hear: Callable[[Any], bool] = field(default=lambda _: False)
    asked: Callable[[], bool] = _never
    stop: Callable[[], None] = _nothing
    patience: Patience = Patience()
    stopped_by: StoppedBy | None = field(default=None, init=False)
    _stopped: float = field(default=0.0, init=False)
    _news: SimpleQueue[object] = field(default_factory=SimpleQueue, init=False)

    @property
    def stopping(self) -> bool:
        """Whether the solve is to stop; asked from the solve's thread."""
        return self.stopped_by is not None

    def tell(self, news: object) -> None:
        """Pass news to the attending thread; called from the solve's thread."""
        self._news.put(news)

    def run(self, work: Callable[[], None]) -> bool:
        """Run `work` in a thread of its own; False if it had to be left behind.

        Raises what `work` raises. A second Ctrl-C raises KeyboardInterrupt.
        """
        # not a daemon: the interpreter must not end under native code that still runs
        Thread(target=self._work, args=(work,), name="solver").start()
        try:
            ended = self._attend()
        except BaseException:
            self._stop(StoppedBy.INTERRUPT)
            raise
        if ended is None:
            return False
        if ended.error is not None:
            raise ended.error
        return True

    def _work(self, work: Callable[[], None]) -> None:
        error: BaseException | None = None
        try:
            work()
        except BaseException as raised:  # noqa: BLE001 - raised again in the attending thread
            error = raised
        self._news.put(_Ended(error))

    def _attend(self) -> _Ended | None:
        while not self._left_behind:
            try:
                news = self._next()
                if isinstance(news, _Ended):
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
        try:
            return self._news.get(timeout=_POLL)
        except Empty:
            return None

    def _stop(self, why: StoppedBy) -> None:
        if self.stopped_by is None:
            self.stopped_by, self._stopped = why, time.perf_counter()
            self.stop()

    @property
    def _left_behind(self) -> bool:
        if self.stopped_by is None:
            return False
        spent = time.perf_counter() - self._stopped
        late = self.stopped_by is StoppedBy.TIME_LIMIT
        return spent > (self.patience.time_limit if late else self.patience.interrupt)
