"""A limit on work that is done in the process of the command line itself."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType

_AGAIN = 0.2  # seconds until it is said again, where something has swallowed it


_READING = 2.0  # seconds that reading may always take: without it there is no answer at all
_LEAST = 1.0  # seconds that are left for the rest however long reading took


class TimeUpError(BaseException):
    """The time that the work was given is over. Like Ctrl-C it is no error of the work."""


def rest(limit: float | None, spent: float) -> float | None:
    """What is left of a limit in seconds, though never so little that nothing could be done.

    >>> rest(60.0, 2.0), rest(3.0, 2.9), rest(0.5, 0.4), rest(None, 2.0)
    (58.0, 1.0, 0.5, None)
    """
    return None if limit is None else max(limit - spent, min(limit, _LEAST))


@contextmanager
def reading_limit(seconds: float | None) -> Iterator[None]:
    """Raise TimeUpError in the reading of a mission that takes longer; None is any time.

    The system's timer does it, so no other thread is begun; without such a timer, or outside the
    main thread, there is no limit.
    """
    able = hasattr(signal, "setitimer")
    main = threading.current_thread() is threading.main_thread()
    if seconds is None or not able or not main or signal.getitimer(signal.ITIMER_REAL)[0]:
        yield
        return

    working = True

    def ring(_number: int, _frame: FrameType | None) -> None:
        if working:
            raise TimeUpError("the time limit was reached while the mission was read")

    former = signal.signal(signal.SIGALRM, ring)
    signal.setitimer(signal.ITIMER_REAL, max(seconds, _READING), _AGAIN)
    try:
        yield
    finally:
        working = False
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, former)
