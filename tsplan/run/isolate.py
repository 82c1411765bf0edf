"""Planning in a child process: a crash of native code becomes a message and a second try.

Ctrl-C (or a request to terminate) asks the search to stop and keep its best plan; a second one
ends it at once. The best plan found so far is handed over now and then, so that a child that
crashes, or that has to be ended, does not take it along.
"""

from __future__ import annotations

import os
import signal
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

from tsplan.errors import Finding, InputError, SolverError
from tsplan.milp.child_process import (
    STOPPING,
    CrashError,
    LateError,
    OutOfMemoryError,
    run_guarded,
)
from tsplan.milp.grace_period import USUAL, Leash, Patience
from tsplan.plans.plan import MissionRef, Plan, Status
from tsplan.run.events import FINISHING, Bound, Event, Incumbent, Stage
from tsplan.stopping import StoppedBy

if TYPE_CHECKING:
    from types import FrameType

    from tsplan.cli.progress import Progress
    from tsplan.mission import Mission

_EVERY = 0.1  # seconds between bounds that are passed on
_ONE_REQUEST = 0.5  # seconds within which signals are one request
_LEAST = 1.0  # seconds that a second try gets at least
_MANY = 1_000_000  # robots times steps whose paths take seconds to make and check
_SHARE = 0.05  # of the time may go into plans that are handed over on the way


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


@dataclass(frozen=True, slots=True)
class _HandedOver:
    """The best plan so far, on its way from the child."""

    plan: Plan


@dataclass(eq=False)
class Planning:
    """Plans one mission in child processes; `requests` has what signals asked for meanwhile."""

    mission: Mission
    progress: Progress
    requests: Requests
    patience: Patience = USUAL
    _best: Plan | None = field(default=None, init=False)

    def plan(self, order: Order) -> Plan:
        """The plan, or the best one known of where the search had to be given up.

        Raises what the planner raises, and CrashError after two crashes without a plan.
        """
        began = time.perf_counter()
        try:
            return self._tried(order)
        except (OutOfMemoryError, LateError, KeyboardInterrupt) as error:
            return self._given_up(error)
        except CrashError as crash:
            self.progress.note(f"{crash}; trying once more with one thread and another seed")
            again = self._otherwise(order, time.perf_counter() - began)
            return self._second(again, crash)

    def _second(self, order: Order, crash: CrashError) -> Plan:
        note = f"first try: {crash}; this is the second, with one thread and seed {order.seed}"
        try:
            plan = self._tried(order)
        except (OutOfMemoryError, LateError, KeyboardInterrupt) as error:
            plan = self._given_up(error)
        except CrashError as error:
            if self._best is None:
                raise
            plan = self._given_up(error)
        return replace(plan, notes=(*plan.notes, note))

    def _tried(self, order: Order) -> Plan:
        limit = self._limit(order)
        leash = Leash(replace(self.patience, limit=limit))

        def hear(news: Event | _HandedOver) -> None:
            if isinstance(news, _HandedOver):
                self._best = news.plan
                return
            if isinstance(news, Stage) and news.name == FINISHING:
                leash.finishing = True
            self.progress.tell(news)

        with self.requests.passed_to(leash):
            answer = run_guarded(_job, (self.mission, order), hear, leash)
        if isinstance(answer, _Refusal):
            raise InputError(answer.findings)
        return answer

    def _limit(self, order: Order) -> float | None:
        return self.mission.solver.time_limit if order.time_limit is None else order.time_limit

    def _otherwise(self, order: Order, spent: float) -> Order:
        """The same order with what may keep a solver from crashing again, in the time left."""
        seed = order.seed if order.seed is not None else self.mission.solver.seed or 0
        limit = self._limit(order)
        left = None if limit is None else max(limit - spent, _LEAST)
        return replace(order, threads=1, seed=seed + 1, time_limit=left)

    def _given_up(self, error: BaseException) -> Plan:
        """The best plan that was handed over, or that there is none, with the true reason."""
        if isinstance(error, OutOfMemoryError):
            why = StoppedBy.MEMORY
        elif isinstance(error, LateError) and not self.requests.asked:
            why = StoppedBy.TIME_LIMIT
        else:
            why = StoppedBy.INTERRUPT
        words = "interrupted" if isinstance(error, KeyboardInterrupt) else str(error)
        best = self._best
        what = "there is no plan" if best is None else "this is the best plan it had handed over"
        self.progress.note(f"{words}; {what}")
        if best is None:
            mission = self.mission
            ref = MissionRef(mission.name, mission.digest)
            best = Plan(Status.NO_PLAN_FOUND, ref, mission.horizon, stopped_by=why)
        return replace(best, stopped_by=why, notes=(*best.notes, words))


def _job(given: tuple[Mission, Order], send: Callable[[object], object]) -> Plan | _Refusal:
    """The child's part."""
    from tsplan.run.planner import plan  # noqa: PLC0415  (loads the solver, in the child alone)

    mission, order = given
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
            on_event=Forward(send, 0.0 if mission.size * mission.horizon > _MANY else _SHARE),
        )
    except InputError as error:
        return _Refusal(error.findings)


class Forward:
    """Sends events on: bounds not too often, and plans as far as making them takes little time.

    The first plan is handed over at once, as a search may be silent for long after its last news;
    later ones while all of them take at most a `share` of the time. With a share of 0 none is.
    """

    def __init__(self, send: Callable[[object], object], share: float = _SHARE) -> None:
        self._send = send
        self._share = share
        self._began = time.monotonic()
        self._last = -_EVERY
        self._spent = 0.0
        self._made: Callable[[], Plan] | None = None

    def __call__(self, event: Event) -> None:
        """Take an event in and send on what is worth it."""
        now = time.monotonic()
        if isinstance(event, Incumbent):
            self._made = event.plan
        self._hand_over(now - self._began)
        if isinstance(event, Bound) and now - self._last < _EVERY:
            return
        self._last = now
        self._send(replace(event, plan=None) if isinstance(event, Incumbent) else event)

    def _hand_over(self, elapsed: float) -> None:
        if self._made is None or not self._share or self._spent > self._share * elapsed:
            return
        make, self._made = self._made, None
        began = time.monotonic()
        with suppress(SolverError):  # a plan that does not stand is found out at the end
            self._send(_HandedOver(make()))
        self._spent += time.monotonic() - began


@dataclass(eq=False)
class Requests:
    """What this process was asked by signals: once to stop, twice to stop at once.

    While a child works the requests go to it; what is done here meanwhile, as writing the plan, is
    not torn apart by the first.
    """

    quiet: bool = False
    what: bytes = b"the best plan found"
    asked: int = 0
    _last: float = 0.0
    _leash: Leash | None = None

    def handle(self, _number: int, _frame: FrameType | None) -> None:
        """Take a request in; the second one is an interrupt where no child has to hear of it."""
        # some senders signal a process and its group: what comes at the same time is one request
        now = time.monotonic()
        if self.asked and now - self._last < _ONE_REQUEST:
            return
        self.asked, self._last = self.asked + 1, now
        if self._leash is not None:
            self._leash.ask()
        elif self.asked > 1:
            raise KeyboardInterrupt
        if self.asked == 1 and not self.quiet:
            # a plain write is safe wherever the signal came, and stderr may be gone
            with suppress(OSError, ValueError):
                os.write(sys.__stderr__.fileno() if sys.__stderr__ else 2, _STOPPING % self.what)

    @contextmanager
    def passed_to(self, leash: Leash) -> Iterator[None]:
        """While a child is held by a leash, requests are for it."""
        if self.asked:
            raise KeyboardInterrupt
        self._leash = leash
        try:
            yield
        finally:
            self._leash = None

    @contextmanager
    def heard(self) -> Iterator[None]:
        """Hear the signals by which a process is asked to stop, except those that are ignored."""
        if threading.current_thread() is not threading.main_thread():
            yield
            return
        ignored = (None, signal.SIG_IGN)
        former = {n: h for n in STOPPING if (h := signal.getsignal(n)) not in ignored}
        for number in former:
            signal.signal(number, self.handle)
        try:
            yield
        finally:
            for number, handler in former.items():
                signal.signal(number, handler)


_STOPPING = b"\nstopping with %s; once more to stop at once\n"
