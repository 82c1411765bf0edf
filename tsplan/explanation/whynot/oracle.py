"""Questions to the planner: can this mission be met? Every answer is a proof, or none.

An answer also settles what is weaker than a mission with a plan, and what is stronger than one
without, so many questions need no solve.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

from tsplan.explanation.explanation import Cut, SoftConstraint
from tsplan.plans.outcomes import Status
from tsplan.signals.trajectory import Trajectory
from tsplan.stopping import StoppedBy

if TYPE_CHECKING:
    from tsplan.clock import Clock
    from tsplan.explanation.whynot.subject import Question, Subject
    from tsplan.plans.plan import Plan
    from tsplan.run.events import Event
    from tsplan.signals.result_check import AnyMission

Answer = bool | None
"""True: there is a verified plan. False: it is proven that there is none. None: not known."""

_CUTS: dict[StoppedBy, Cut] = {
    StoppedBy.MEMORY: "memory",
    StoppedBy.PRECISION: "precision",
}
_LEAST = 0.05  # seconds that a question gets at least
_SOON, _TIMES = (
    0.5,
    4,
)  # seconds that a hasty one gets, or so many times as long as the slowest plan took


@dataclass(eq=False, slots=True)
class _Enough:
    """Remembers whether a planner was stopped by what it told."""

    judge: Callable[[Event], bool]
    reached: bool = False

    def __call__(self, event: Event) -> bool:
        self.reached = self.reached or self.judge(event)
        return self.reached


class EnoughError(Exception):
    """The time is up, or the run was asked to stop, in the midst of work without questions."""


@dataclass(eq=False)
class Oracle:
    """Asks the planner about a mission and its relatives until the clock is over.

    `stop` tells the run that a question was interrupted, `asking` that one is asked. `unanswered`
    has why questions got no answer; oracles about changed missions share it.
    """

    subject: Subject[Any]
    clock: Clock
    solver: str | None = None
    patience: float | None = None  # seconds for one question
    stop: Callable[[], None] = lambda: None
    unanswered: set[Cut] = field(default_factory=set)
    asking: Callable[[], object] = lambda: None
    solves: int = field(default=0, init=False)
    seconds: float = field(default=0.0, init=False)
    slowest: float = field(default=0.0, init=False)  # seconds of a question that had a plan
    _met: list[frozenset[SoftConstraint]] = field(default_factory=list, init=False)
    _unmet: list[frozenset[SoftConstraint]] = field(default_factory=list, init=False)

    def refuses(self) -> bool:
        """Whether no more questions are answered; why is noted in `unanswered`."""
        stopped = self.clock.stopped_by
        if stopped is not None:
            self.unanswered.add("interrupt" if stopped.value == "interrupt" else "time_limit")
        return stopped is not None

    def pause(self) -> None:
        """Raise EnoughError where no more questions are answered: called between parts of work."""
        if self.refuses():
            raise EnoughError

    def about(self, mission: AnyMission) -> Oracle:
        """An oracle about another mission of the same kind, with the same time."""
        subject = self.subject.about(mission)
        return replace(self, subject=subject)

    def without(self, dropped: Iterable[SoftConstraint]) -> Answer:
        """Whether the mission without some of its constraints can be met."""
        gone = frozenset(dropped)
        gone -= self.subject.needless(gone)
        if any(known <= gone for known in self._met):
            return True
        if any(gone <= known for known in self._unmet):
            return False
        if self.refuses():
            return None
        question = self.subject.without(gone)
        found = self._timed(question)
        answer = _answer(found)
        if answer:
            self._met.append(self.subject.broken_by(gone, question, found))
        elif answer is False:
            self._unmet.append(gone)
        return answer

    def learn_impossible(self, dropped: Iterable[SoftConstraint]) -> None:
        """Take over a proof that the mission without some constraints cannot be met."""
        self._unmet.append(frozenset(dropped))

    def met(self, mission: AnyMission) -> Answer:
        """Whether another mission can be met."""
        return self.asked(self.subject.about(mission).plain())

    def asked(self, question: Question) -> Answer:
        """One question to the planner."""
        return _answer(self._timed(question))

    def _timed(self, question: Question) -> Any:
        """What the planner finds; how long it takes at most to find a plan is kept."""
        began = time.perf_counter()
        found = self.planned(question, self.patience)
        if _answer(found):
            self.slowest = max(self.slowest, time.perf_counter() - began)
        return found

    @contextmanager
    def hasty(self, soon: float = _SOON) -> Iterator[None]:
        """Questions are given up soon, and that is no news."""
        patience = self.patience
        soon = max(soon, _TIMES * self.slowest)
        self.patience = soon if patience is None else min(patience, soon)
        try:
            with self.unnoticed():
                yield
        finally:
            self.patience = patience

    @contextmanager
    def unnoticed(self) -> Iterator[None]:
        """That questions take too long is no news: they are asked again, or need no answer."""
        open_ = set(self.unanswered)
        try:
            yield
        finally:
            self.unanswered.difference_update({"patience"} - open_)

    def planned(
        self,
        question: Question,
        patience: float | None,
        enough: Callable[[Event], bool] | None = None,
    ) -> Any:
        """What the planner finds in some seconds at most; None where there is no time left.

        It ends as soon as something it tells is `enough`.
        """
        if self.refuses():
            return None
        self.asking()
        began = time.perf_counter()
        limits = [item for item in (self.clock.left, patience) if item is not None]
        limit = max(min(limits), _LEAST) if limits else None
        told = None if enough is None else _Enough(enough)
        found = self.subject.planned(question, limit, self.solver, told)
        self.solves += 1
        self.seconds += time.perf_counter() - began
        if told is not None and told.reached:
            return found
        if found.stopped_by is StoppedBy.INTERRUPT:
            self.stop()
        if found.stopped_by is not None and not self.refuses():
            self.unanswered.add(_CUTS.get(found.stopped_by, "patience"))
        return found


def _answer(found: Plan | Trajectory | None) -> Answer:
    """What a plan, a proof that there is none, or neither of them answers."""
    if found is None:
        return None
    there = found.has_signals if isinstance(found, Trajectory) else found.has_paths
    return True if there else False if found.status is Status.INFEASIBLE else None
