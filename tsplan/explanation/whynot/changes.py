"""The smallest changes after which a mission can be met, each proven by solves.

A change moves one number of the mission. Its least amount is found by doubling and bisection: at
the end there is a plan of the mission changed by the amount, and a proof that one less does not do.
Plans are found much sooner than it is proven that there is none, so that at first whatever takes
long counts as impossible; only what is next to the amount found in this way is asked patiently.
Where no single change helps, the least total over a few numbers is found level by level: at every
total, vectors are ruled out a prefix at a time by giving all of the rest to every later one.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any, NamedTuple, TypeAlias

from tsplan.errors import MissionError
from tsplan.explanation.explanation import Change, SoftConstraint
from tsplan.explanation.whynot.mission_numbers import Edit
from tsplan.explanation.whynot.oracle import EnoughError

if TYPE_CHECKING:
    from tsplan.explanation.whynot.oracle import Oracle
    from tsplan.explanation.whynot.subject import Question
    from tsplan.signals.result_check import AnyMission

Step: TypeAlias = tuple[Edit, int]
"""An edit, and how far it goes."""

Possible: TypeAlias = Callable[[int], bool | None]
"""Whether an amount will do; None where that is not found out."""

_SECONDS = 5.0  # of solves in the search for a smaller total


_GAPS = tuple(4**power for power in range(7))
"""Steps below an amount that are tried: near a border solvers may have no answer."""

_WIDER = 8  # times as far above a guess is tried next
_PARTS = 8  # of what lies between a guess and the least amount above it: so finely that is told


class Least(NamedTuple):
    """The least amount found; `proven` if one less is known not to do."""

    amount: int
    proven: bool


def least(
    possible: Possible, most: int, guess: int | None = None, hasty: Possible | None = None
) -> Least | None:
    """The least amount in 1..most that is possible; None if there is none or it is not found.

    A guess is looked at first: if an amount near it is possible and a smaller one near it is not,
    that will do. What `hasty` calls possible is so; it may miss that others are.

    >>> least(lambda amount: amount >= 5, 100)
    Least(amount=5, proven=True)
    """
    near = None if guess is None else _near(possible, min(guess, most), most)
    if near is not None:
        return near
    look = hasty or possible
    low, high = 0, 1
    while not look(min(high, most)):
        if high >= most:
            if hasty is None or not possible(most):
                return None
            break
        low, high = high, 2 * high
    high = min(high, most)
    # possible at `high`, and not seen to be at `low`
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (low, middle) if look(middle) else (middle, high)
    while high > 1:
        answer = possible(high - 1)
        if not answer:
            return Least(high, answer is False)
        high -= 1
    return Least(high, proven=True)


def _near(possible: Possible, guess: int, most: int) -> Least | None:
    """The least amount from a guess on; None where that is no good."""
    low, high, gap = guess - 1, guess, 1
    while not possible(high):
        if high >= most:
            return None
        low, high, gap = high, min(guess + gap, most), _WIDER * gap
    fine = max((high - guess) // _PARTS, 1)
    while high - low > fine:
        middle = (low + high) // 2
        low, high = (low, middle) if possible(middle) else (middle, high)
    for gap in _GAPS:
        answer = possible(high - gap) if gap < high else False
        if answer is not None:
            return None if answer else Least(high, proven=True)
    return Least(high, proven=False)


@dataclass(eq=False)
class Repairs:
    """Looks for changes of the mission that an oracle knows.

    `cores` are conflicts of the mission and `everything` all its constraints. A change that leaves
    a fact, or a conflict that is impossible by itself, is ruled out by that alone: it is quicker
    than with the whole mission.
    """

    oracle: Oracle
    everything: frozenset[SoftConstraint]
    cores: Sequence[frozenset[SoftConstraint]]
    _answers: dict[tuple[Step, ...], bool | None] = field(default_factory=dict, init=False)
    _last: int = field(default=0, init=False)
    _until: float = field(default=0.0, init=False)

    def single(self, edit: Edit) -> Change | None:
        """The least change by one edit; None if it does not help or the time is up."""
        # even the largest change may leave a fact, or the rest be impossible anyway
        changed = self.changed([(edit, edit.most)])  # a smaller change may fit if this does not
        if changed is not None and self._factual(changed):
            return None
        weakened = self.oracle.subject.touched(edit.number)
        if weakened and self.oracle.without(weakened) is False:
            return None
        open_ = set(self.oracle.unanswered)
        guess = self.oracle.subject.guessed(edit, self.ask)
        found = least(
            lambda amount: self.possible([(edit, amount)]),
            edit.most,
            guess,
            lambda amount: self.hastily([(edit, amount)]),
        )
        made = None if found is None else self.made([(edit, found.amount)])
        if made is not None and made.proven:  # what has no answer on the border changes nothing
            self.oracle.unanswered.intersection_update(open_)
        return made

    def changed(self, steps: Sequence[Step]) -> AnyMission | None:
        """The mission after several changes; None where they do not fit together."""
        self.oracle.pause()
        try:
            return applied(self.oracle.subject.mission, steps)
        except (MissionError, ValueError):
            return None  # more robots at a state than it holds, a window that ends before it begins

    def several(self, edits: Sequence[Edit], below: int, most: int) -> Change | None:
        """The least total over several edits, if it is less than `below`.

        At most so many questions are asked, for some seconds; None where no total is found then.
        """
        if not all(edit.whole for edit in edits):
            return None  # of real numbers there is no next level
        self._last = self.oracle.solves + most
        self._until = self.oracle.seconds + _SECONDS
        for total in range(2, below):
            found = self._spread(edits, total, [])
            if self._exhausted:
                return None
            if found is not None:
                return self.made(found)
        return None

    def lowered(self, ways: Sequence[Step]) -> list[Step] | None:
        """Each way as short as it can be beside the others; None if there is no plan after all."""
        steps = list(ways)
        if not self.possible(steps):
            return None
        for place, (edit, amount) in enumerate(steps):
            before, after = steps[:place], steps[place + 1 :]
            beside = self.changed([*before, *after])
            guess = None
            if beside is not None:
                guess = self.oracle.subject.about(beside).guessed(edit, self.ask)
            found = least(
                lambda less, edit=edit, before=before, after=after: (  # type: ignore[misc]  # bound now
                    self.possible([*before, (edit, less), *after]) is True
                ),
                amount,
                guess,
            )
            if found is not None:
                steps[place] = (edit, found.amount)
        return steps

    @property
    def _exhausted(self) -> bool:
        spent = self.oracle.solves >= self._last or self.oracle.seconds >= self._until
        return spent or self.oracle.refuses()

    def made(self, steps: Sequence[Step]) -> Change:
        """The change by some steps; it is proven if no step can be shorter beside the others."""
        used = tuple(step for step in steps if step[1])
        sure = self.possible(used) is True
        gaps = [self._refuted(used, place) for place in range(len(used))] if sure else []
        shares = [amount / edit.most for edit, amount in used]
        total = sum(edit.unit * amount for edit, amount in used)
        return Change(
            kind=used[shares.index(max(shares))][0].kind,
            text="; and ".join(edit.words(amount) for edit, amount in used),
            amount=total if isinstance(total, int) else float(total),
            proven=sure and None not in gaps,
            mission=applied(self.oracle.subject.mission, used),
            steps=used,
            within=max((gap for gap in gaps if gap), default=1),
        )

    def _refuted(self, steps: Sequence[Step], place: int) -> float | None:
        """By how much less of one step it is proven that the mission cannot be met; None if not."""
        edit, amount = steps[place]
        for gap in (1,) if edit.whole else _GAPS:
            less = [*steps[:place], (edit, max(amount - gap, 0)), *steps[place + 1 :]]
            if self.possible(less) is False:
                return gap if edit.whole else float(gap * edit.unit)
        return None

    def ask(self, question: Question) -> Any:
        """What the planner finds, as patient as for other questions."""
        return self.oracle.planned(question, self.oracle.patience)

    def _spread(self, edits: Sequence[Edit], total: int, chosen: list[Step]) -> list[Step] | None:
        """Amounts that sum to `total` and do; None if there are none."""
        if self._exhausted:
            return None
        first, rest = edits[len(chosen)], edits[len(chosen) + 1 :]
        if not rest:
            whole = [*chosen, (first, total)]
            return whole if total <= first.most and self.possible(whole) else None
        generous = [*chosen, *((edit, min(total, edit.most)) for edit in (first, *rest))]
        if not self.possible(generous):
            return None
        for amount in range(min(total, first.most), -1, -1):
            found = self._spread(edits, total - amount, [*chosen, (first, amount)])
            if found is not None:
                return found
        return None

    def possible(self, steps: Sequence[Step]) -> bool | None:
        """Whether the mission can be met after several changes; None where it is not found out."""
        key = tuple(step for step in steps if step[1])
        if key not in self._answers:
            answer = self._answer(key)
            if answer is None and self.oracle.refuses():
                return None
            self._answers[key] = answer
        return self._answers[key]

    def hastily(self, steps: Sequence[Step]) -> bool | None:
        """The same, given up as soon as it takes several times as long as plans took so far."""
        key = tuple(step for step in steps if step[1])
        if key not in self._answers:
            with self.oracle.hasty():
                answer = self._answer(key)
            if answer is None:
                return None
            self._answers[key] = answer
        return self._answers[key]

    def _answer(self, key: tuple[Step, ...]) -> bool | None:
        try:
            return self._asked(key)
        except EnoughError:
            return None

    def _asked(self, steps: Sequence[Step]) -> bool | None:
        if not steps:
            return False  # it is known that the mission as it is cannot be met
        changed = self.changed(steps)
        if changed is None or self._factual(changed):
            return False
        for core in self.cores:
            others = [item for item in self.everything - core if item.kind == "formula"]
            if self.oracle.asked(self.oracle.subject.about(changed).without(others)) is False:
                return False
        return self.oracle.met(changed)

    def _factual(self, changed: AnyMission) -> bool:
        """Whether a fact forbids every plan of a changed mission."""
        return next(self.oracle.subject.about(changed).facts(), None) is not None


def fewest(oracle: Oracle, edits: Sequence[Edit]) -> list[Step] | None:
    """By how little some edits do together, as far as that is found in the oracle's patience.

    A plan for it was found; that less does not do is not known. None where no plan was found.
    """
    problem = oracle.subject.shortage(edits)
    if problem is None:
        return None
    with oracle.unnoticed():
        plan = oracle.planned(problem.problem, oracle.patience, problem.enough)
    return problem.steps(plan) if plan is not None and plan.has_paths else None


def applied(mission: AnyMission, steps: Sequence[Step]) -> AnyMission:
    """The mission after several changes."""
    for edit, amount in steps:
        mission = edit.applied(mission, amount)
    return replace(mission, digest="")
