"""Planning in a child process: a crash of native code becomes a message and a second try.

Ctrl-C (or a request to terminate) asks the search to stop and keep its best plan; a second one
ends it at once.
"""

from __future__ import annotations

import multiprocessing
import os
import signal
import sys
import threading
import time
from contextlib import contextmanager
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from tsplan.errors import Finding, InputError
from tsplan.events import Bound, Event, Incumbent
from tsplan.milp.guard import CrashError, run_guarded

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from types import FrameType

    from tsplan.cli.progress import Progress
    from tsplan.mission import Mission
    from tsplan.results.plan import Plan

_EVERY = 0.1  # seconds between bounds that are passed on
_ONE_REQUEST = 0.5  # seconds within which signals are one request
_WATCH = 1.0  # seconds between looks at whether the parent still lives
_LEAST = 1.0  # seconds that a second try gets at least
_SIGNALS = tuple(
    number
    for name in ("SIGINT", "SIGTERM", "SIGHUP")
    if (number := getattr(signal, name, None)) is not None
)


@dataclass(frozen=True, slots=True)
class Order:
    """What the command line asks of the planner; None leaves it to the mission."""

    solver: str | None = None
    time_limit: float | None = None
    gap: float | None = None
    threads: int | None = None
    seed: int | None = None
    encoding: str = "tight"
    without: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class _Refusal:
    """Findings on their way from the child, to be raised again here."""

    findings: tuple[Finding, ...]


def planned(mission: Mission, order: Order, progress: Progress) -> Plan:
    """Plan in a child process; raises what the planner raises, and CrashError after two crashes."""
    began = time.perf_counter()
    try:
        return _tried(mission, order, progress)
    except CrashError as crash:
        progress.pause()
        progress.note(f"{crash}; trying once more with one thread and another seed")
        again = _otherwise(mission, order, time.perf_counter() - began)
        plan = _tried(mission, again, progress)
        note = f"first try: {crash}; this is the second, with one thread and seed {again.seed}"
        return replace(plan, notes=(*plan.notes, note))


def _tried(mission: Mission, order: Order, progress: Progress) -> Plan:
    with _passing_on(quiet=progress.quiet) as stopping:
        try:
            answer = run_guarded(_job, (mission, order), progress.tell)
        except CrashError:
            if stopping.asked > 1:
                raise KeyboardInterrupt from None
            raise
    if isinstance(answer, _Refusal):
        raise InputError(answer.findings)
    return answer


def _otherwise(mission: Mission, order: Order, spent: float) -> Order:
    """The same order with what may keep a solver from crashing again, in the time that is left."""
    seed = order.seed if order.seed is not None else mission.solver.seed or 0
    limit = order.time_limit if order.time_limit is not None else mission.solver.time_limit
    left = None if limit is None else max(limit - spent, _LEAST)
    return replace(order, threads=1, seed=seed + 1, time_limit=left)


def _job(given: tuple[Mission, Order], send: Callable[[Event], None]) -> Plan | _Refusal:
    """The child's part."""
    from tsplan.planner import plan  # noqa: PLC0415  (loads the solver, in the child alone)

    mission, order = given
    threading.Thread(target=_end_with, args=(os.getppid(),), daemon=True).start()
    try:
        return plan(
            mission,
            solver=order.solver,
            time_limit=order.time_limit,
            gap=order.gap,
            threads=order.threads,
            seed=order.seed,
            encoding=order.encoding,
            without=order.without,
            on_event=_Forward(send),
        )
    except InputError as error:
        return _Refusal(error.findings)


def _end_with(parent: int) -> None:
    """End this process when its parent is gone: nobody waits for the answer any more."""
    while os.getppid() == parent:
        time.sleep(_WATCH)
    os._exit(1)


class _Forward:
    """Sends events on: without the means to make plans, and bounds not too often."""

    def __init__(self, send: Callable[[Event], None]) -> None:
        self._send = send
        self._last = -_EVERY

    def __call__(self, event: Event) -> None:
        now = time.monotonic()
        if isinstance(event, Bound) and now - self._last < _EVERY:
            return
        self._last = now
        self._send(replace(event, plan=None) if isinstance(event, Incumbent) else event)


@dataclass(slots=True)
class _Stopping:
    """What this process was asked by signals while the child works: once to stop, twice at once."""

    quiet: bool
    asked: int = 0
    last: float = 0.0

    def handle(self, _number: int, _frame: FrameType | None) -> None:
        """Pass a signal on. It does not raise, so no message from the child is torn apart."""
        children = multiprocessing.active_children()
        if not children:
            raise KeyboardInterrupt
        # some senders signal a process and its group: what comes at the same time is one request
        now = time.monotonic()
        if self.asked and now - self.last < _ONE_REQUEST:
            return
        self.asked, self.last = self.asked + 1, now
        for child in children:
            if self.asked > 1:
                child.kill()
            elif child.pid is not None:
                os.kill(child.pid, signal.SIGINT)
        if self.asked == 1 and not self.quiet:
            # a plain write is safe wherever the signal came
            os.write(sys.__stderr__.fileno() if sys.__stderr__ else 2, _STOPPING)


@contextmanager
def _passing_on(*, quiet: bool) -> Iterator[_Stopping]:
    """Signals that ask this process to stop ask the child first, and end it the second time."""
    stopping = _Stopping(quiet)
    if threading.current_thread() is not threading.main_thread():
        yield stopping
        return
    former = {number: signal.signal(number, stopping.handle) for number in _SIGNALS}
    try:
        yield stopping
    finally:
        for number, handler in former.items():
            signal.signal(number, handler)


_STOPPING = b"\nstopping with the best plan found; once more to stop at once\n"
