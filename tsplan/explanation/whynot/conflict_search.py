"""From what is known of a mission to its first conflict, by as few and as easy questions as may be.

That a mission cannot be met is much harder to prove than that it can. So first the facts are
confirmed, then the mission itself is asked about for a moment. If that leaves it open, the least
shortage of agents is looked for, which says whom there are too few of, and whatever asks for them
is tried alone: a small mission is proven impossible sooner than a large one.
"""

from __future__ import annotations

import time
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from tsplan.explanation.whynot.changes import Step, fewest

if TYPE_CHECKING:
    from tsplan.clock import Clock
    from tsplan.explanation.explanation import Fact
    from tsplan.explanation.whynot.conflicts import Core, Finder
    from tsplan.explanation.whynot.mission_numbers import Edit
    from tsplan.explanation.whynot.oracle import Oracle

PATIENCE = 10.0
"""Seconds for one question about a part or a change."""

_SHARE = 0.5  # of what is left of the time goes to conflicts at most, and
_FOR_WHOLE = 0.8  # to whether there is a plan at all
_GUESSED = 2.0  # seconds for the least shortage, and for each guess that it leads to
_EASY = 0.1  # seconds of a proof beside which guesses do not pay


@dataclass(eq=False)
class ConflictSearch:
    """Finds out whether a mission can be met, and a first conflict if it cannot.

    `shortage` is how many agents more would do, as far as that was looked for.
    """

    finder: Finder
    clock: Clock
    shortage: Sequence[Step] = ()
    _core: Core | None = field(default=None, init=False)
    _spent: float = field(default=0.0, init=False)

    @property
    def _oracle(self) -> Oracle:
        return self.finder.oracle

    def among(self, facts: Iterable[Fact]) -> Core | None:
        """A conflict among what the first fact that solves do not contradict follows from.

        Where they are too slow to confirm it, its own proof stands.
        """
        self._limit_questions(0.0)
        finder, oracle = self.finder, self._oracle
        for fact in facts:
            constraints = frozenset().union(*(part.constraints for part in fact.parts))
            core = finder.within(constraints)
            rest = finder.everything - constraints
            if core is None and oracle.without(rest) is None:
                oracle.learn_impossible(rest)
                core = finder.within(constraints)
            if core is not None:
                return core
        return None

    def possible(self) -> bool | None:
        """Whether there is a plan; None where the time is too short to find out."""
        oracle = self._oracle
        oracle.clock, oracle.patience = self.clock, None
        began = time.perf_counter()
        with oracle.hasty():
            answer = oracle.without(())
        self._spent = time.perf_counter() - began
        if answer is None and self._guess():
            return False
        if answer is None:
            if self.clock.left is not None:
                oracle.clock = self.clock.within(_FOR_WHOLE * self.clock.left)
            oracle.patience = None
            answer = oracle.without(())
        self._spent = time.perf_counter() - began
        return answer

    def found(self) -> Core | None:
        """A conflict of a mission that cannot be met."""
        if self._core is None and not self.shortage and self._spent > _EASY:
            self._guess()
        self._limit_questions(self._spent)
        return self._core or self.finder.within(self.finder.everything)

    def _guess(self) -> bool:
        """Whether a conflict is found among what asks for those of whom there are too few."""
        oracle = self._oracle
        every = oracle.subject.candidates(self.finder.everything)
        oracle.patience = _GUESSED
        self.shortage = fewest(oracle, [edit for edit in every if _at_home(oracle, edit)]) or ()
        for guess in oracle.subject.guesses(self.shortage):
            oracle.patience = _GUESSED
            with oracle.unnoticed():
                answer = oracle.without(self.finder.everything - guess)
            if answer is False:
                self._limit_questions(self._spent)
                self._core = self.finder.within(guess)
                return True
        return False

    def _limit_questions(self, least: float) -> None:
        """Leave a share of the time to the changes."""
        oracle = self._oracle
        oracle.patience = max(PATIENCE, least)
        oracle.clock = self.clock
        if self.clock.left is not None:
            oracle.clock = self.clock.within(_SHARE * self.clock.left)


def _at_home(oracle: Oracle, edit: Edit) -> bool:
    """Whether an edit has more agents where others like them start."""
    return edit.kind == "add_agents" and oracle.subject.rank(edit.number) == 0
