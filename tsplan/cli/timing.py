"""A limit on work that is done in the process of the command line itself."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType

_AGAIN = 0.2  # seconds until it is said again, where something has swallowed it


class TimeUpError(BaseException):
    """The time that the work was given is over. Like Ctrl-C it is no error of the work."""


@contextmanager
def time_limit(seconds: float | None) -> Iterator[None]:
    """Raise TimeUpError in the work once it has taken so long; None is any time.

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
            raise TimeUpError

    former = signal.signal(signal.SIGALRM, ring)
    signal.setitimer(signal.ITIMER_REAL, seconds, _AGAIN)
    try:
        yield
    finally:
        working = False
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, former)
