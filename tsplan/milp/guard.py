"""Run a job in a child process, so that a crash of native solver code becomes a message.

The job gets its argument and a function that sends events back; events and the result must be
picklable. The child has a process group of its own, so Ctrl-C reaches the parent alone; a caller
that wants to pass it on does so from a signal handler, which tears no message apart.
"""

from __future__ import annotations

import multiprocessing
import os
import pickle
import signal
import sys
import threading
from collections.abc import Callable
from multiprocessing.connection import Connection
from typing import Any, TypeVar

from tsplan.errors import SolverError, TsplanError

A = TypeVar("A")
R = TypeVar("R")
Send = Callable[[Any], None]


class CrashError(SolverError):
    """The process that ran the solver died without an answer."""


def run_guarded(
    job: Callable[[A, Send], R], argument: A, on_event: Callable[[Any], object] | None = None
) -> R:
    """`job(argument, send)` in a child process; `on_event` is called with what it sends.

    Raises CrashError when the child dies of a signal or without an answer, and whatever the job
    raised otherwise.
    """
    # fork is quick and safe while no other thread runs; elsewhere start afresh
    alone = sys.platform == "linux" and threading.active_count() == 1
    context: Any = multiprocessing.get_context("fork" if alone else "spawn")
    ours, theirs = context.Pipe(duplex=False)
    child = context.Process(target=_child, args=(job, argument, theirs), daemon=True)
    child.start()
    theirs.close()
    try:
        kind, value = _listen(ours, on_event)
    finally:
        ours.close()
        child.join(1.0)
        if child.is_alive():
            child.kill()
            child.join()
    if kind == "result":
        result: R = value
        return result
    if kind == "error":
        raise value
    raise CrashError(_cause(child.exitcode))


def _listen(connection: Connection, on_event: Callable[[Any], object] | None) -> tuple[str, Any]:
    """Events until the answer comes; ("lost", None) when the child ends without one."""
    while True:
        try:
            kind, value = connection.recv()
        except EOFError:
            return "lost", None
        if kind != "event":
            return kind, value
        if on_event is not None:
            on_event(value)


def _child(job: Callable[[A, Send], R], argument: A, connection: Connection) -> None:
    if hasattr(os, "setpgrp"):
        os.setpgrp()
    signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        answer: tuple[str, Any] = (
            "result",
            job(argument, lambda event: connection.send(("event", event))),
        )
    except (Exception, KeyboardInterrupt) as error:  # noqa: BLE001 - handed to the parent as it is
        answer = ("error", _sendable(error))
    # the answer is ready: a second Ctrl-C must not lose it
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    connection.send(answer)
    connection.close()


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
