"""Questions to the planner: can this mission be met? Every answer is a proof, or none.

An answer also settles what is weaker than a mission with a plan, and what is stronger than one
without, so many questions need no solve.
"""

from __future__ import annotations

import time
from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from tsplan.explanation.data import Element
from tsplan.explanation.relaxing import any_plan, relaxed
from tsplan.planner import plan
from tsplan.results import Status, StoppedBy

if TYPE_CHECKING:
    from tsplan.encode.clock import Clock
    from tsplan.encode.problem import Problem
    from tsplan.mission import Mission

Answer = bool | None
"""True: there is a verified plan. False: it is proven that there is none. None: not known."""

_LEAST = 0.05  # seconds that a question gets at least


@dataclass(eq=False)
class Oracle:
    """Asks the planner about a mission and its relatives until the clock is over."""

    mission: Mission
    clock: Clock
    solver: str | None = None
    patience: float | None = None  # seconds for one question
    solves: int = field(default=0, init=False)
    seconds: float = field(default=0.0, init=False)
    interrupted: bool = field(default=False, init=False)
    _met: list[frozenset[Element]] = field(default_factory=list, init=False)
    _unmet: list[frozenset[Element]] = field(default_factory=list, init=False)

    @property
    def over(self) -> bool:
        """Whether no more questions are answered."""
        return self.interrupted or self.clock.over

    def stop(self) -> None:
        """Answer no more questions."""
        self.interrupted = True

    def without(self, dropped: Iterable[Element]) -> Answer:
        """Whether the mission without some of its elements can be met."""
        gone = frozenset(dropped)
        if any(known <= gone for known in self._met):
            return True
        if any(gone <= known for known in self._unmet):
            return False
        answer = self.asked(relaxed(self.mission, gone))
        if answer is not None:
            (self._met if answer else self._unmet).append(gone)
        return answer

    def learn_impossible(self, dropped: Iterable[Element]) -> None:
        """Take over a proof that the mission without some elements cannot be met."""
        self._unmet.append(frozenset(dropped))

    def met(self, mission: Mission) -> Answer:
        """Whether another mission can be met."""
        return self.asked(any_plan(mission))

    def asked(self, problem: Mission | Problem) -> Answer:
        """One question to the planner."""
        if self.over:
            return None
        began = time.perf_counter()
        limits = [item for item in (self.clock.left, self.patience) if item is not None]
        limit = max(min(limits), _LEAST) if limits else None
        found = plan(problem, time_limit=limit, solver=self.solver)
        self.solves += 1
        self.seconds += time.perf_counter() - began
        if found.stopped_by is StoppedBy.INTERRUPT:
            self.stop()
        if found.has_paths:
            return True
        return False if found.status is Status.INFEASIBLE else None
