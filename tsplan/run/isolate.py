"""Planning in a child process: a crash of native code becomes a message and a second try.

Ctrl-C (or a request to terminate) asks the search to stop and keep its best plan; a second one
ends it at once. The best plan found so far is handed over now and then, so that a child that
crashes, or that has to be ended, does not take it along.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, field, replace
from importlib import import_module
from typing import TYPE_CHECKING, Any, Protocol

from tsplan.errors import SolverError
from tsplan.plans.outcomes import MissionRef, Status
from tsplan.plans.plan import Plan
from tsplan.process.child_process import ENDED, CrashError, Leash, reason_of, run_guarded
from tsplan.run.events import FINISHING, Bound, Event, Incumbent, Stage

if TYPE_CHECKING:
    from pathlib import Path

    from tsplan.milp.solver_choice import SolverChoice
    from tsplan.process.interrupt import Requests

_EVERY = 0.1  # seconds between bounds that are passed on
_LEAST = 1.0  # seconds that a second try gets at least
_MANY = 1_000_000  # pieces times steps that take seconds to make and check
_SHARE = 0.05  # of the time may go into plans that are handed over on the way


class Audience(Protocol):
    """Who hears of the work while it is done."""

    def tell(self, event: Event) -> None:
        """Take in what the planner tells."""

    def note(self, text: str) -> None:
        """Take in what became of the work."""


@dataclass(frozen=True, slots=True)
class Order:
    """What is asked of a planner: the function `planner` of a module, which makes a `kind`.

    With `anytime` it goes on until nothing is left to prove or time is up, else it ends with the
    first plan. With `log` the audience is told what the solver says, too. The search for the plan
    of a team begins with the paths of a plan to `start` with. A `certified` answer, and a
    `certificate` of it, are those of `tsplan.plan`.
    """

    mission: Any
    choice: SolverChoice
    encoding: str = "tight"
    without: tuple[str, ...] = ()
    planner: tuple[str, str] = ("tsplan.run.planner", "plan")
    kind: type[Any] = Plan
    anytime: bool = True
    log: bool = False
    start: Plan | None = None
    certified: bool = False
    certificate: Path | None = None

    @property
    def further(self) -> dict[str, Any]:
        """What not every planner can be asked for."""
        names = ("start", "certified", "certificate")
        return {name: value for name in names if (value := getattr(self, name))}


@dataclass(frozen=True, slots=True)
class _Said:
    """What the solver says."""

    text: str


@dataclass(frozen=True, slots=True)
class _HandedOver:
    """The best plan so far, on its way from the child."""

    plan: Any


@dataclass(eq=False)
class Planning:
    """Plans in child processes; `requests` has what signals asked for meanwhile."""

    audience: Audience
    requests: Requests
    _best: Any = field(default=None, init=False)

    def plan(self, order: Order) -> Any:
        """The plan, or the best one known of where the search had to be given up.

        Raises what the planner raises, and CrashError after two crashes without a plan.
        """
        began = time.perf_counter()
        try:
            return self._tried(order)
        except ENDED as error:
            return self._given_up(order, error)
        except CrashError as crash:
            self.audience.note(f"{crash}; trying once more with one thread and another seed")
            return self._second(_otherwise(order, time.perf_counter() - began), crash)

    def _second(self, order: Order, crash: CrashError) -> Any:
        seed = order.choice.seed
        note = f"first try: {crash}; this is the second, with one thread and seed {seed}"
        try:
            plan = self._tried(order)
        except (*ENDED, CrashError) as error:
            if self._best is None and not isinstance(error, ENDED):
                raise
            plan = self._given_up(order, error)
        return replace(plan, notes=(*plan.notes, note))

    def _tried(self, order: Order) -> Any:
        leash = Leash(order.choice.time_limit)

        def hear(news: Event | _HandedOver | _Said) -> None:
            if isinstance(news, _HandedOver):
                self._best = news.plan
                return
            if isinstance(news, _Said):
                self.audience.note(news.text)
                return
            if isinstance(news, Stage) and news.name == FINISHING:
                leash.finishing = True
            self.audience.tell(news)

        with self.requests.passed_to(leash.ask):
            return run_guarded(_job, order, hear, leash)

    def _given_up(self, order: Order, error: BaseException) -> Any:
        """The best plan that was handed over, or that there is none, with the true reason."""
        why = reason_of(error, asked=self.requests.asked > 0)
        words = "interrupted" if isinstance(error, KeyboardInterrupt) else str(error)
        best = self._best
        what = "there is no plan" if best is None else "this is the best plan it had handed over"
        self.audience.note(f"{words}; {what}")
        if best is None:
            mission = order.mission
            ref = MissionRef(mission.name, mission.digest)
            best = order.kind(Status.NO_PLAN_FOUND, ref, mission.horizon, stopped_by=why)
        return replace(best, stopped_by=why, notes=(*best.notes, words))


def _otherwise(order: Order, spent: float) -> Order:
    """The same order with what may keep a solver from crashing again, in the time left."""
    choice = order.choice
    limit = choice.time_limit
    left = None if limit is None else max(limit - spent, _LEAST)
    return replace(
        order, choice=replace(choice, threads=1, seed=(choice.seed or 0) + 1, time_limit=left)
    )


def _job(order: Order, send: Callable[[object], object]) -> Any:
    """The child's part."""
    module, name = order.planner  # it loads the solver, in the child alone
    mission, choice = order.mission, order.choice
    many = mission.pieces * mission.horizon > _MANY
    return getattr(import_module(module), name)(
        mission,
        solver=choice.name,
        time_limit=choice.time_limit,
        gap=choice.gap,
        threads=choice.threads,
        seed=choice.seed,
        encoding=order.encoding,
        without=order.without,
        on_event=Forward(send, 0.0 if many else _SHARE, anytime=order.anytime),
        on_log=(lambda text: send(_Said(text))) if order.log else None,
        **order.further,
    )


class Forward:
    """Sends events on: bounds not too often, and plans as far as making them takes little time.

    The first plan is handed over at once, as a search may be silent for long after its last news;
    later ones while all of them take at most a `share` of the time. With a share of 0 none is.
    Without `anytime` the first plan asks the search to stop.
    """

    def __init__(
        self, send: Callable[[object], object], share: float = _SHARE, *, anytime: bool = True
    ) -> None:
        self._send = send
        self._anytime = anytime
        self._share = share
        self._began = time.monotonic()
        self._last = -_EVERY
        self._spent = 0.0
        self._made: Callable[[], Any] | None = None

    def __call__(self, event: Event) -> bool:
        """Take an event in and send on what is worth it; whether to stop."""
        self._take(event)
        return isinstance(event, Incumbent) and not self._anytime

    def _take(self, event: Event) -> None:
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
