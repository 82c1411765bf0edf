"""Run a job in a child process, so that a crash of native solver code becomes a message.

The job gets its argument and a function that sends events back; events and the result must be
picklable. The child has a process group of its own, so Ctrl-C reaches the parent alone, which
passes it on: from a signal handler, as an exception could tear a message apart. The child and
whatever it started end with the parent, however that ends.
"""

from __future__ import annotations

import multiprocessing
import os
import pickle
import signal
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from multiprocessing.connection import Connection
from types import FrameType
from typing import Any, TypeVar

from tsplan.errors import SolverError, TsplanError

A = TypeVar("A")
R = TypeVar("R")
Send = Callable[[Any], None]

_SETTLING = 1.0  # seconds that a child gets to end after its answer


class CrashError(SolverError):
    """The process that ran the solver died without an answer."""


@dataclass(frozen=True)
class _Ends:
    """The child's ends of its pipes; `others` are the parent's, to be closed where inherited."""

    answers: Connection
    lifeline: Connection
    others: tuple[Connection, ...]


def run_guarded(
    job: Callable[[A, Send], R], argument: A, on_event: Callable[[Any], object] | None = None
) -> R:
    """`job(argument, send)` in a child process; `on_event` is called with what it sends.

    The first Ctrl-C raises KeyboardInterrupt in the job, the second one ends it and raises
    KeyboardInterrupt here; where the program has a SIGINT handler of its own, passing it on is left
    to that.

    Raises CrashError when the child dies of a signal, for lack of memory or without an answer, and
    whatever the job raised otherwise.

    Example, with `def double(number, send): send("half way"); return 2 * number` in a module:
    `run_guarded(double, 21, print)` prints `half way` and returns 42.
    """
    # fork is quick and safe while no other thread runs; elsewhere start afresh
    alone = sys.platform == "linux" and threading.active_count() == 1
    context: Any = multiprocessing.get_context("fork" if alone else "spawn")
    ours, theirs = context.Pipe(duplex=False)
    end, line = context.Pipe(duplex=False)
    ends = _Ends(theirs, end, (ours, line) if alone else ())
    child = context.Process(target=_child, args=(job, argument, ends), daemon=True)
    child.start()
    theirs.close()
    end.close()
    with _passing_on(child) as asked:
        try:
            kind, value = _listen(ours, on_event)
        finally:
            ours.close()
            _ended(child)
            line.close()
    if kind == "result":
        result: R = value
        return result
    if kind == "error":
        raise value
    if asked() > 1:
        raise KeyboardInterrupt
    raise CrashError(_cause(child.exitcode))


@contextmanager
def _passing_on(child: Any) -> Iterator[Callable[[], int]]:
    """Pass Ctrl-C on to the child; yields how often it was asked to stop."""
    count = 0
    standard = signal.getsignal(signal.SIGINT) is signal.default_int_handler
    if not standard or threading.current_thread() is not threading.main_thread():
        yield lambda: 0
        return

    def handle(_number: int, _frame: FrameType | None) -> None:
        nonlocal count
        count += 1
        if count > 1:
            child.kill()
        elif child.pid is not None:
            with suppress(ProcessLookupError):
                os.kill(child.pid, signal.SIGINT)

    former = signal.signal(signal.SIGINT, handle)
    try:
        yield lambda: count
    finally:
        signal.signal(signal.SIGINT, former)


def _listen(connection: Connection, on_event: Callable[[Any], object] | None) -> tuple[str, Any]:
    """Events until the answer comes; ("lost", None) when the child ends without one."""
    while True:
        try:
            kind, value = connection.recv()
        except (EOFError, ConnectionResetError):
            return "lost", None
        if kind != "event":
            return kind, value
        if on_event is not None:
            on_event(value)


def _ended(child: Any) -> None:
    """See the child and what it has started to their end."""
    child.join(_SETTLING)
    if child.is_alive():
        child.kill()
        child.join()
    if hasattr(os, "killpg") and child.pid is not None:
        with suppress(ProcessLookupError, PermissionError):
            os.killpg(child.pid, signal.SIGKILL)


def _child(job: Callable[[A, Send], R], argument: A, ends: _Ends) -> None:
    if hasattr(os, "setpgrp"):
        os.setpgrp()
    # a forked child has its parent's handlers, which are not meant for it
    signal.signal(signal.SIGINT, signal.default_int_handler)
    for name in ("SIGTERM", "SIGHUP"):
        if hasattr(signal, name):
            signal.signal(getattr(signal, name), signal.SIG_DFL)
    for other in ends.others:
        other.close()
    threading.Thread(target=_watch_parent, args=(ends.lifeline,), daemon=True).start()
    connection = ends.answers
    try:
        answer: tuple[str, Any] = (
            "result",
            job(argument, lambda event: connection.send(("event", event))),
        )
    except MemoryError:
        answer = ("error", CrashError("the solver's process ran out of memory"))
    except (Exception, KeyboardInterrupt) as error:  # noqa: BLE001 - handed to the parent as it is
        answer = ("error", _sendable(error))
    # the answer is ready: a second Ctrl-C must not lose it
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        connection.send(answer)
    except (pickle.PicklingError, TypeError, AttributeError) as error:
        connection.send(("error", TsplanError(f"the answer cannot be sent: {error}")))
    connection.close()


def _watch_parent(lifeline: Connection) -> None:
    """End this process and what it has started when the parent's end of the line goes."""
    with suppress(OSError, EOFError):
        lifeline.recv()
    if hasattr(os, "killpg"):
        os.killpg(os.getpgrp(), signal.SIGKILL)
    os._exit(1)


def _sendable(error: BaseException) -> BaseException:
    """The error itself where it survives pickling, else one that says the same."""
    try:
        pickle.loads(pickle.dumps(error))  # noqa: S301 - our own bytes
    except Exception:  # noqa: BLE001 - any failure means it cannot be sent
        return TsplanError(f"{type(error).__name__}: {error}")
    return error


def _cause(exitcode: int | None) -> str:
    if exitcode is not None and exitcode < 0:
        name = signal.Signals(-exitcode).name
        more = "; the system may have run out of memory" if name == "SIGKILL" else ""
        return f"the solver's process crashed ({name}){more}"
    return f"the solver's process ended without an answer (exit code {exitcode})"
