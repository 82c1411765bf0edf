"""Signals: Ctrl-C and its kin ask for an end, the system's timer limits what is done right here.

Every handler of a signal is set here. What is ignored, as under `nohup` or in a background job of a
shell, stays so; outside the main thread no handler can be set, and nothing is changed.
"""

from __future__ import annotations

import os
import signal
import sys
import threading
import time
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator
    from contextlib import AbstractContextManager
    from types import FrameType

STOPPING = tuple(
    number
    for name in ("SIGINT", "SIGTERM", "SIGHUP")
    if (number := getattr(signal, name, None)) is not None
)
"""Signals by which a process is asked to stop."""

_STOPPING = b"\nstopping with %s; once more to stop at once\n"
_AGAIN = 0.2  # seconds until time is said to be up again, where something has swallowed it


class TimeUpError(BaseException):
    """The time that the work was given is over. Like Ctrl-C it is no error of the work."""


@contextmanager
def handled(numbers: Iterable[int], handler: Callable[[int, Any], object]) -> Iterator[None]:
    """Meanwhile these signals go to `handler`, except those that are ignored."""
    former: dict[int, Any] = {}
    if threading.current_thread() is threading.main_thread():
        ignored = (None, signal.SIG_IGN)
        former = {n: before for n in numbers if (before := signal.getsignal(n)) not in ignored}
    for number in former:
        signal.signal(number, handler)
    try:
        yield
    finally:
        for number, before in former.items():
            if signal.getsignal(number) is handler:  # else it has given way to the one before
                signal.signal(number, before)


@dataclass(eq=False, slots=True)
class _Asked:
    """What the first Ctrl-C does: ask a run to stop, and every run that this one is a part of."""

    stop: Callable[[], None]
    former: Any

    def __call__(self, number: int, frame: FrameType | None) -> None:
        """Hear Ctrl-C; the next one is for whoever heard it before."""
        self.stop()
        signal.signal(signal.SIGINT, self.former)
        if isinstance(self.former, _Asked):
            self.former(number, frame)


def on_interrupt(stop: Callable[[], None]) -> AbstractContextManager[None]:
    """Ctrl-C asks the search to stop and keep its best plan; a second one interrupts for good."""
    return handled((signal.SIGINT,), _Asked(stop, signal.getsignal(signal.SIGINT)))


def passed_on(ask: Callable[[], None]) -> AbstractContextManager[None]:
    """Ctrl-C asks a child to stop, where the program has no handler of its own to do so."""
    standard = signal.getsignal(signal.SIGINT) is signal.default_int_handler
    return handled((signal.SIGINT,) if standard else (), lambda *_: ask())


@dataclass(eq=False)
class Requests:
    """What this process was asked by signals: once to stop, twice to stop at once.

    While a child works the requests go to it; what is done here meanwhile, as writing the plan, is
    not torn apart by the first. What comes within `together` seconds is one request: some senders
    signal a process and its group. `quiet` says nothing of it.
    """

    quiet: bool = False
    what: bytes = b"the best plan found"
    together: float = 0.5
    asked: int = 0
    _last: float = 0.0
    _pass: Callable[[], None] | None = None

    def handle(self, _number: int, _frame: FrameType | None) -> None:
        """Take a request in; the second one is an interrupt where no child has to hear of it."""
        now = time.monotonic()
        if self.asked and now - self._last < self.together:
            return
        self.asked, self._last = self.asked + 1, now
        if self._pass is not None:
            self._pass()
        elif self.asked > 1:
            raise KeyboardInterrupt
        if self.asked == 1 and not self.quiet:
            # a plain write is safe wherever the signal came, and stderr may be gone
            with suppress(OSError, ValueError):
                os.write(sys.__stderr__.fileno() if sys.__stderr__ else 2, _STOPPING % self.what)

    @contextmanager
    def passed_to(self, ask: Callable[[], None]) -> Iterator[None]:
        """Meanwhile requests are for a child, which is asked by `ask`."""
        if self.asked:
            raise KeyboardInterrupt
        self._pass = ask
        try:
            yield
        finally:
            self._pass = None

    def heard(self) -> AbstractContextManager[None]:
        """Hear the signals by which a process is asked to stop."""
        return handled(STOPPING, self.handle)


@contextmanager
def held_back() -> Iterator[None]:
    """Signals wait meanwhile: a child that has just begun could not hear them."""
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    former = signal.pthread_sigmask(signal.SIG_BLOCK, STOPPING)
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, former)


def hear_again() -> None:
    """In a child: signals that came while it began are heard from here on, and those to come."""
    if hasattr(signal, "pthread_sigmask"):
        signal.pthread_sigmask(signal.SIG_UNBLOCK, STOPPING)


def own_handlers() -> None:
    """In a child: its parent's handlers are not meant for it, but its parent has to be heard."""
    signal.signal(signal.SIGINT, signal.default_int_handler)
    for number in STOPPING:
        if number != signal.SIGINT and signal.getsignal(number) != signal.SIG_IGN:
            signal.signal(number, signal.SIG_DFL)


@contextmanager
def alarm(seconds: float | None, words: str) -> Iterator[None]:
    """Raise TimeUpError with these words in work that takes longer; None is any time.

    The system's timer does it, so no other thread is begun; without such a timer, or where another
    alarm is set, there is no limit.
    """
    main = threading.current_thread() is threading.main_thread()
    able = hasattr(signal, "setitimer") and main
    if seconds is None or not able or signal.getitimer(signal.ITIMER_REAL)[0]:
        yield
        return
    working = True

    def ring(_number: int, _frame: FrameType | None) -> None:
        if working:
            raise TimeUpError(words)

    with handled((signal.SIGALRM,), ring):
        signal.setitimer(signal.ITIMER_REAL, seconds, _AGAIN)
        try:
            yield
        finally:
            working = False
            signal.setitimer(signal.ITIMER_REAL, 0)
