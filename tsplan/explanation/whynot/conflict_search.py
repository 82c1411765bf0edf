"""From what is known of a mission to its first conflict, by as few and as easy questions as may be.

That a mission cannot be met is much harder to prove than that it can. So first the facts are
confirmed, then the mission itself is asked about for a moment. If that leaves it open, a few parts
of it and all of it take turns, each time for longer: a small mission is mostly proven impossible
sooner than a large one. Where these are hard, too, the least shortage of agents is looked for,
which says whom there are too few of, and whatever asks for them is tried alone.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from tsplan.explanation.whynot.changes import Step, fewest

if TYPE_CHECKING:
    from tsplan.clock import Clock
    from tsplan.explanation.explanation import Cut, Fact
    from tsplan.explanation.whynot.conflicts import Core, Finder, Set
    from tsplan.explanation.whynot.mission_numbers import Edit
    from tsplan.explanation.whynot.oracle import Oracle

PATIENCE = 10.0
"""Seconds for one question about a part or a change."""

_SHARE = 0.5  # of what is left of the time goes to conflicts at most, and
_FOR_WHOLE = 0.8  # to whether there is a plan at all
_SOON = 0.2  # seconds for the mission at first
_TIMES = 2  # so many times as long a guess gets; all guesses of a turn get so many times of that
_LONGER = 4  # times as long each of them gets the next time
_GUESSED = 2.0  # seconds for the least shortage; where guesses get less, it is not worth its while
_EASY = 0.1  # seconds of a proof beside which guesses do not pay
_HOPELESS: frozenset[Cut] = frozenset({"memory", "precision"})
"""Why a question may be left open that more time does not answer."""


@dataclass(eq=False)
class ConflictSearch:
    """Finds out whether a mission can be met, and a first conflict if it cannot.

    `shortage` is how many agents more would do, as far as that was looked for.
    """

    finder: Finder
    clock: Clock
    shortage: Sequence[Step] = ()
    _core: Core | None = field(default=None, init=False)
    _proof: float = field(default=0.0, init=False)  # seconds of the last question about it all
    _sought: bool = field(default=False, init=False)
    _asked: Counter[Set] = field(default_factory=Counter, init=False)  # how often about each guess
    _open: set[Set] = field(default_factory=set, init=False)  # guesses without an answer so far

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
        """Whether there is a plan; None where the time is too short to find out.

        The mission and a few parts of it are asked about in turn, longer every time: whichever is
        refuted soonest decides.
        """
        oracle = self._oracle
        oracle.clock, oracle.patience = self.clock, None
        with oracle.hasty(_SOON):
            answer = self._whole()
        if self.clock.left is not None:
            oracle.clock = self.clock.within(_FOR_WHOLE * self.clock.left)
        seconds = _TIMES * self._spent
        while answer is None and not (oracle.refuses() or oracle.unanswered & _HOPELESS):
            if self._guess(seconds):
                return False
            oracle.patience = seconds / (_TIMES if self._open else 1)
            with oracle.unnoticed():
                answer = self._whole()
            seconds *= _LONGER
        return answer

    def _whole(self) -> bool | None:
        """Whether all of the mission can be met."""
        before = self._spent
        answer = self._oracle.without(())
        self._proof = self._spent - before
        return answer

    @property
    def _spent(self) -> float:
        """Seconds of questions so far."""
        return self._oracle.seconds

    def found(self) -> Core | None:
        """A conflict of a mission that cannot be met."""
        if self._core is None and not self.shortage and self._proof > _EASY:
            self._guess(_LONGER * self._proof)
        self._limit_questions(self._spent)
        return self._core or self.finder.within(self.finder.everything)

    def _guess(self, seconds: float) -> bool:
        """Whether a conflict is found among a few parts that are tried alone, each so long.

        Of a hard mission the least shortage is looked for, and what asks for those of whom there
        are too few is tried alone, too.
        """
        oracle = self._oracle
        if self._tried(oracle.subject.guesses(()), seconds):
            return True
        if seconds < _GUESSED:
            return False
        if not self._sought:
            self._sought = True
            every = oracle.subject.candidates(self.finder.everything)
            oracle.patience = _GUESSED
            self.shortage = fewest(oracle, [edit for edit in every if _at_home(oracle, edit)]) or ()
        return bool(self.shortage) and self._tried(oracle.subject.guesses(self.shortage), seconds)

    def _tried(self, guesses: Iterable[Set], seconds: float) -> bool:
        """Whether some of the guesses is impossible by itself, so that a conflict is in it.

        Each gets so many seconds, and all together the time of a few; those come first that were
        asked about least. None is looked at that asks for more than one which was left open.
        """
        oracle, until = self._oracle, self._spent + _TIMES * seconds
        for guess in sorted(guesses, key=self._asked.__getitem__):
            if self._spent >= until:
                break
            if any(known < guess for known in self._open):
                continue
            oracle.patience = seconds
            with oracle.unnoticed():
                answer = oracle.without(self.finder.everything - guess)
            self._asked[guess] += 1
            self._open.discard(guess)
            if answer is None:
                self._open.add(guess)
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
