"""Run a job in a child process, so that a crash of native solver code becomes a message.

The job gets its argument and a function that sends events back; events and the result must be
picklable. The child has a process group of its own, so Ctrl-C reaches the parent alone, which
passes it on: from a signal handler, as an exception could tear a message apart. The child and
whatever it started end with the parent, however that ends. What the child's native code writes to
its output is seen by nobody; its last words are part of the message on a crash.
"""

from __future__ import annotations

import multiprocessing
import os
import pickle
import signal
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager, suppress
from dataclasses import dataclass
from multiprocessing.connection import Connection
from pathlib import Path
from tempfile import TemporaryDirectory
from types import FrameType
from typing import Any, TypeVar

from tsplan.errors import SolverError, TsplanError
from tsplan.milp.grace_period import Leash
from tsplan.milp.quiet_output import hush_for_good
from tsplan.words import visible

A = TypeVar("A")
R = TypeVar("R")
Send = Callable[[Any], object]

STOPPING = tuple(
    number
    for name in ("SIGINT", "SIGTERM", "SIGHUP")
    if (number := getattr(signal, name, None)) is not None
)
"""Signals by which a process is asked to stop."""

_WORDS = 200  # letters of a child's last words
_TAIL = 4000  # bytes in which they are looked for


class CrashError(SolverError):
    """The process that ran the solver died without an answer."""


class OutOfMemoryError(CrashError):
    """It died for lack of memory: the same model would do so again."""


class LateError(CrashError):
    """It had to be ended, as it neither answered nor stopped in time."""


@dataclass(frozen=True)
class _Ends:
    """The child's ends of its pipes; `others` are the parent's, to be closed where inherited."""

    answers: Connection
    lifeline: Connection
    others: tuple[Connection, ...]
    words: str  # the file that gets what native code writes


def run_guarded(
    job: Callable[[A, Send], R],
    argument: A,
    on_event: Callable[[Any], object] | None = None,
    leash: Leash | None = None,
) -> R:
    """`job(argument, send)` in a child process; `on_event` is called with what it sends.

    The first Ctrl-C raises KeyboardInterrupt in the job, the second one ends it and raises
    KeyboardInterrupt here; where the program has a SIGINT handler of its own, passing it on is left
    to that, by way of the `leash`. A worker process of multiprocessing that may have no children
    does the job itself.

    Raises CrashError when the child dies of a signal or without an answer, OutOfMemoryError for
    lack of memory, LateError when it had to be ended by its leash, and whatever the job raised
    otherwise.

    Example, with `def double(number, send): send("half way"); return 2 * number` in a module:
    `run_guarded(double, 21, print)` prints `half way` and returns 42.
    """
    leash = leash or Leash()
    if not may_have_children():
        leash.hold_here()
        try:
            return job(argument, on_event or _unheard)
        finally:
            leash.let_go()
    with _place_for_words() as words, _passing_on(leash):
        kind, value, code = _answered(job, argument, on_event, leash, words)
        if kind == "lost":
            value = _loss(leash, code, _last(words))
    if kind == "result":
        result: R = value
        return result
    raise value


def may_have_children() -> bool:
    """Whether this process may start others; workers of `multiprocessing` that are daemons not."""
    return not multiprocessing.current_process().daemon


def _unheard(_: object) -> None:
    return


@contextmanager
def _place_for_words() -> Iterator[Path]:
    """Where the child's native code writes to; without room for a file, to nowhere."""
    with ExitStack() as stack:
        try:
            folder = stack.enter_context(TemporaryDirectory(prefix="tsplan-"))
        except OSError:
            yield Path(os.devnull)
            return
        yield Path(folder, "words")


def _answered(
    job: Callable[[A, Send], R],
    argument: A,
    on_event: Callable[[Any], object] | None,
    leash: Leash,
    words: Path,
) -> tuple[str, Any, int | None]:
    """The kind of the child's answer, the answer, and its exit code."""
    # fork is quick and safe while no other thread runs; elsewhere start afresh
    alone = sys.platform == "linux" and threading.active_count() == 1
    context: Any = multiprocessing.get_context("fork" if alone else "spawn")
    ours, theirs = context.Pipe(duplex=False)
    end, line = context.Pipe(duplex=False)
    ends = _Ends(theirs, end, (ours, line) if alone else (), str(words))
    child = context.Process(target=_child, args=(job, argument, ends), daemon=True)
    with _held_back():
        child.start()
    theirs.close()
    end.close()
    leash.hold(child)
    try:
        kind, value = _listen(ours, on_event)
    finally:
        ours.close()
        _ended(child, leash.patience.settling)
        line.close()
        leash.let_go()
    return kind, value, child.exitcode


def _loss(leash: Leash, code: int | None, words: str) -> BaseException:
    """What it means that the child ended without an answer."""
    if leash.late:
        return LateError("the search did not stop in time and was ended")
    if leash.asked > 1:
        return KeyboardInterrupt()
    said = f"; its last words: {words}" if words else ""
    if code is not None and code == -getattr(signal, "SIGKILL", 0):
        return OutOfMemoryError(
            "the solver's process crashed (SIGKILL); the system may have run out of memory"
        )
    if "bad_alloc" in words:
        return OutOfMemoryError(f"the solver's process ran out of memory{said}")
    return CrashError(f"{_cause(code)}{said}")


@contextmanager
def _held_back() -> Iterator[None]:
    """Signals wait meanwhile: a child that has just begun could not hear them."""
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    former = signal.pthread_sigmask(signal.SIG_BLOCK, STOPPING)
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, former)


@contextmanager
def _passing_on(leash: Leash) -> Iterator[None]:
    """Pass Ctrl-C on to the child, where the program does not do so itself."""
    standard = signal.getsignal(signal.SIGINT) is signal.default_int_handler
    if not standard or threading.current_thread() is not threading.main_thread():
        yield
        return

    def handle(_number: int, _frame: FrameType | None) -> None:
        leash.ask()

    former = signal.signal(signal.SIGINT, handle)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, former)


def _listen(connection: Connection, on_event: Callable[[Any], object] | None) -> tuple[str, Any]:
    """Events until the answer comes; ("lost", None) when the child ends without one."""
    while True:
        try:
            kind, value = connection.recv()
        except (EOFError, OSError):
            return "lost", None
        if kind != "event":
            return kind, value
        if on_event is not None:
            on_event(value)


def _ended(child: Any, settling: float) -> None:
    """See the child and what it has started to their end."""
    child.join(settling)
    if child.is_alive():
        child.kill()
        child.join()
    if hasattr(os, "killpg") and child.pid is not None:
        with suppress(ProcessLookupError, PermissionError):
            os.killpg(child.pid, signal.SIGKILL)


def _child(job: Callable[[A, Send], R], argument: A, ends: _Ends) -> None:
    if hasattr(os, "setpgrp"):
        os.setpgrp()
    with suppress(OSError):  # without room for a file there is nowhere to lead it
        hush_for_good(ends.words)
    _own_signals()
    for other in ends.others:
        other.close()
    threading.Thread(target=_watch_parent, args=(ends.lifeline,), daemon=True).start()
    connection = ends.answers
    answer: tuple[str, Any] | None = None
    try:
        _listen_to_signals()
        answer = ("result", job(argument, lambda event: connection.send(("event", event))))
        # the answer is ready: Ctrl-C must not lose it
        signal.signal(signal.SIGINT, signal.SIG_IGN)
    except (Exception, KeyboardInterrupt) as error:  # noqa: BLE001 - handed to the parent as it is
        signal.signal(signal.SIGINT, signal.SIG_IGN)
        answer = answer or ("error", _sendable(error))
    try:
        connection.send(answer)
    except (pickle.PicklingError, TypeError, AttributeError) as error:
        connection.send(("error", TsplanError(f"the answer cannot be sent: {error}")))
    connection.close()


def _own_signals() -> None:
    """A forked child has its parent's handlers, which are not meant for it.

    What was ignored stays so, as under `nohup`; but the parent's wish to stop has to be heard.
    """
    signal.signal(signal.SIGINT, signal.default_int_handler)
    for number in STOPPING:
        if number != signal.SIGINT and signal.getsignal(number) != signal.SIG_IGN:
            signal.signal(number, signal.SIG_DFL)


def _listen_to_signals() -> None:
    """From here on those that came while the child began are heard, and those to come."""
    if hasattr(signal, "pthread_sigmask"):
        signal.pthread_sigmask(signal.SIG_UNBLOCK, STOPPING)


def _watch_parent(lifeline: Connection) -> None:
    """End this process and what it has started when the parent's end of the line goes."""
    with suppress(OSError, EOFError):
        lifeline.recv()
    if hasattr(os, "killpg"):
        os.killpg(os.getpgrp(), signal.SIGKILL)
    os._exit(1)


def _sendable(error: BaseException) -> BaseException:
    """The error itself where it survives pickling, else one that says the same."""
    if isinstance(error, MemoryError):
        return OutOfMemoryError("the solver's process ran out of memory")
    try:
        pickle.loads(pickle.dumps(error))  # noqa: S301 - our own bytes
    except Exception:  # noqa: BLE001 - any failure means it cannot be sent
        return TsplanError(f"{type(error).__name__}: {error}")
    return error


def _cause(exitcode: int | None) -> str:
    if exitcode is not None and exitcode < 0:
        return f"the solver's process crashed ({signal.Signals(-exitcode).name})"
    return f"the solver's process ended without an answer (exit code {exitcode})"


def _last(words: Path) -> str:
    """The last line that a child wrote, in what can be seen."""
    try:
        with words.open("rb") as file:
            file.seek(max(words.stat().st_size - _TAIL, 0))
            lines = file.read().decode(errors="replace").split("\n")
    except OSError:
        return ""
    spoken = [line.strip() for line in lines if line.strip()]
    return visible(spoken[-1][-_WORDS:]) if spoken else ""
