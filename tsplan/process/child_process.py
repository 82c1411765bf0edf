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
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager, suppress
from dataclasses import dataclass, field
from multiprocessing.connection import Connection
from multiprocessing.process import BaseProcess
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, TypeVar

from tsplan.errors import SolverError, TsplanError
from tsplan.process.grace_period import CHILD, GracePeriod
from tsplan.process.interrupt import hear_again, held_back, own_handlers, passed_on
from tsplan.process.quiet_output import hush_for_good
from tsplan.stopping import StoppedBy
from tsplan.words import visible

A = TypeVar("A")
R = TypeVar("R")
Send = Callable[[Any], object]

_WORDS = 200  # letters of a child's last words
_TAIL = 4000  # bytes in which they are looked for


class CrashError(SolverError):
    """The process that ran the solver died without an answer."""


class OutOfMemoryError(CrashError):
    """It died for lack of memory: the same model would do so again."""


class LateError(CrashError):
    """It had to be ended, as it neither answered nor stopped in time."""


ENDED = (OutOfMemoryError, LateError, KeyboardInterrupt)
"""What is raised for a child that ended, or was ended, as any other one would be."""


def reason_of(error: BaseException, *, asked: bool) -> StoppedBy:
    """What a child without an answer was stopped by, if it was `asked` to stop or was not."""
    if isinstance(error, OutOfMemoryError):
        return StoppedBy.MEMORY
    late = isinstance(error, LateError) and not asked
    return StoppedBy.TIME_LIMIT if late else StoppedBy.INTERRUPT


@dataclass(eq=False)
class Leash:
    """One child process, held by whoever started it; usable in signal handlers.

    `limit` is seconds for its work (None: any time). A child that listens ends by itself when it is
    asked to. One that does not, because native code does not come back or because the system has
    stopped it, is ended from outside when its time and some grace are up. `finishing` may be set
    once the child only makes its answer ready. `asked` counts the requests to stop, `late` says
    that the child was ended for being late.
    """

    limit: float | None = None
    grace: GracePeriod = field(default_factory=lambda: CHILD)
    finishing: bool = False
    asked: int = field(default=0, init=False)
    late: bool = field(default=False, init=False)
    _child: BaseProcess | None = field(default=None, init=False)
    _here: bool = field(default=False, init=False)
    _due: list[tuple[float, float]] = field(default_factory=list, init=False)

    def ask(self) -> None:
        """Ask the child to stop, as Ctrl-C does; the second time, end it."""
        self.asked += 1
        if self.asked > 1:
            self.end()
            return
        self._due.append((time.monotonic(), self.grace.after(StoppedBy.INTERRUPT)))
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

    @contextmanager
    def held(self, child: BaseProcess) -> Iterator[None]:
        """Watch a child that has just started."""
        self._child, done = child, threading.Event()
        if self.limit is not None:
            begun = time.monotonic() + self.limit
            self._due.append((begun, self.grace.after(StoppedBy.TIME_LIMIT)))
        if self.asked:
            self._interrupt()
        watch = threading.Thread(target=self._watch, args=(done,), name="leash", daemon=True)
        watch.start()
        try:
            yield
        finally:
            done.set()
            watch.join()
            self._child = None

    @contextmanager
    def held_here(self) -> Iterator[None]:
        """The work is done in this process meanwhile: it can be asked, and cannot be ended."""
        self._here = True
        try:
            yield
        finally:
            self._here = False

    def _watch(self, done: threading.Event) -> None:
        while not done.wait(self.grace.poll):
            more = self.grace.finishing if self.finishing else None
            now = time.monotonic()
            if any(now > due + (more or grace) for due, grace in self._due):
                self.late = True
                self.end()
                return


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
    leash, hear = leash or Leash(), on_event or (lambda _: None)
    if not may_have_children():
        with leash.held_here():
            return job(argument, hear)
    with _place_for_words() as words, passed_on(leash.ask):
        kind, value, code = _answered(job, argument, hear, leash, words)
        if kind == "lost":
            value = _loss(leash, code, _last(words))
    if kind == "result":
        result: R = value
        return result
    raise value


def may_have_children() -> bool:
    """Whether this process may start others; workers of `multiprocessing` that are daemons not."""
    return not multiprocessing.current_process().daemon


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
    hear: Callable[[Any], object],
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
    with held_back():
        child.start()
    theirs.close()
    end.close()
    with leash.held(child), line:
        try:
            kind, value = _listen(ours, hear)
        finally:
            ours.close()
            _settle(child, leash.grace.settling)
    return kind, value, child.exitcode


def _listen(connection: Connection, hear: Callable[[Any], object]) -> tuple[str, Any]:
    """Events until the answer comes; ("lost", None) when the child ends without one."""
    while True:
        try:
            kind, value = connection.recv()
        except (EOFError, OSError):
            return "lost", None
        if kind != "event":
            return kind, value
        hear(value)


def _settle(child: Any, seconds: float) -> None:
    """See the child and what it has started to their end."""
    child.join(seconds)
    if child.is_alive():
        child.kill()
        child.join()
    if hasattr(os, "killpg") and child.pid is not None:
        with suppress(ProcessLookupError, PermissionError):
            os.killpg(child.pid, signal.SIGKILL)


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
    if code is not None and code < 0:
        return CrashError(f"the solver's process crashed ({signal.Signals(-code).name}){said}")
    return CrashError(f"the solver's process ended without an answer (exit code {code}){said}")


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


def _child(job: Callable[[A, Send], R], argument: A, ends: _Ends) -> None:
    if hasattr(os, "setpgrp"):
        os.setpgrp()
    with suppress(OSError):  # without room for a file there is nowhere to lead it
        hush_for_good(ends.words)
    own_handlers()
    for other in ends.others:
        other.close()
    threading.Thread(target=_watch_parent, args=(ends.lifeline,), daemon=True).start()
    connection = ends.answers
    answer: tuple[str, Any] | None = None
    try:
        hear_again()
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
