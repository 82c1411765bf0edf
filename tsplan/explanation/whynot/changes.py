"""The smallest changes after which a mission can be met, each proven by solves.

A change goes along one dimension. Its least amount is found by doubling and bisection: at the end
there is a plan of the mission changed by the amount, and a proof that one less does not do. Where
no single change helps, the least total over a few dimensions is found level by level: at every
total, vectors are ruled out a prefix at a time by giving all of the rest to every later dimension.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, NamedTuple

from tsplan.errors import MissionError
from tsplan.explanation.explanation import Change, ChangeKind, Element
from tsplan.explanation.whynot.facts import View, facts_of
from tsplan.explanation.whynot.oracle import EnoughError
from tsplan.explanation.whynot.relaxing import relaxed

if TYPE_CHECKING:
    from tsplan.explanation.whynot.candidates import Candidate
    from tsplan.explanation.whynot.formula_edits import Dimension
    from tsplan.explanation.whynot.oracle import Oracle
    from tsplan.mission import Mission

ORDER: tuple[ChangeKind, ...] = (
    "extend_deadline",
    "loosen_limit",
    "more_subswarms",
    "shorten_task",
    "waiting",
    "edge",
    "add_agents",
    "lower_need",
)
"""Changes of equal amounts are ranked in this order."""


_SECONDS = 5.0  # of solves in the search for a smaller total


class Least(NamedTuple):
    """The least amount found; `proven` if one less is known not to do."""

    amount: int
    proven: bool


def least(possible: Callable[[int], bool | None], most: int) -> Least | None:
    """The least amount in 1..most that is possible; None if there is none or it is not found.

    >>> least(lambda amount: amount >= 5, 100)
    Least(amount=5, proven=True)
    """
    low, high, proven = 0, 1, True
    while True:
        answer = possible(min(high, most))
        if answer:
            break
        proven = proven and answer is False
        if high >= most:
            return None
        low, high = high, 2 * high
    high = min(high, most)
    # impossible at `low`, possible at `high`
    while high - low > 1:
        middle = (low + high) // 2
        answer = possible(middle)
        if answer:
            high = middle
        else:
            low, proven = middle, answer is False
    return Least(high, proven)


@dataclass(eq=False)
class Repairs:
    """Looks for changes of the mission that an oracle knows.

    `cores` are conflicts of the mission and `everything` all its elements. A change that leaves a
    fact, or a conflict that is impossible by itself, is ruled out by that alone: it is quicker than
    with the whole mission.
    """

    oracle: Oracle
    everything: frozenset[Element]
    cores: Sequence[frozenset[Element]]
    _answers: dict[tuple[tuple[Dimension, int], ...], bool | None] = field(
        default_factory=dict, init=False
    )

    def single(self, candidate: Candidate) -> Change | None:
        """The least change along one dimension; None if it does not help or the time is up."""
        dimension = candidate.dimension
        if self._hopeless(candidate):
            return None
        found = least(lambda amount: self.possible([(dimension, amount)]), dimension.most)
        if found is None:
            return None
        return self._change([(dimension, found.amount)], proven=found.proven)

    def _hopeless(self, candidate: Candidate) -> bool:
        """Whether even the largest change would leave a fact, or the rest is impossible anyway."""
        dimension = candidate.dimension
        self.oracle.pause()
        try:
            changed = applied(self.oracle.mission, [(dimension, dimension.most)])
        except MissionError:
            changed = None  # a smaller change may fit
        if changed is not None and self._factual(changed):
            return True
        return bool(candidate.within) and self.oracle.without(candidate.within) is False

    def at_most(self, dimensions: Sequence[Dimension]) -> bool:
        """Whether the mission can be met when all of several dimensions are changed the most."""
        return bool(self.possible([(item, item.most) for item in dimensions]))

    def several(self, dimensions: Sequence[Dimension], below: int, most: int) -> Change | None:
        """The least total over several dimensions, if it is less than `below`.

        At most so many questions are asked, for some seconds; None where no total is found then.
        """
        self._last = self.oracle.solves + most
        self._until = self.oracle.seconds + _SECONDS
        for total in range(2, below):
            found = self._spread(dimensions, total, [])
            if self._exhausted:
                return None
            if found is not None:
                return self.made(found)
        return None

    _last: int = field(default=0, init=False)
    _until: float = field(default=0.0, init=False)

    @property
    def _exhausted(self) -> bool:
        spent = self.oracle.solves >= self._last or self.oracle.seconds >= self._until
        return spent or self.oracle.refuses()

    def made(self, steps: Sequence[tuple[Dimension, int]]) -> Change:
        """The change by some steps; it is proven if no step can be shorter beside the others."""
        sure = self.possible(steps) is True
        for place, (dimension, amount) in enumerate(steps):
            less = [*steps[:place], (dimension, amount - 1), *steps[place + 1 :]]
            sure = sure and (amount == 0 or self.possible(less) is False)
        return self._change(steps, proven=sure)

    def _spread(
        self, dimensions: Sequence[Dimension], total: int, chosen: list[tuple[Dimension, int]]
    ) -> list[tuple[Dimension, int]] | None:
        """Amounts that sum to `total` and do; None if there are none."""
        if self._exhausted:
            return None
        first, rest = dimensions[len(chosen)], dimensions[len(chosen) + 1 :]
        if not rest:
            whole = [*chosen, (first, total)]
            return whole if total <= first.most and self.possible(whole) else None
        generous = [*chosen, *((item, min(total, item.most)) for item in (first, *rest))]
        if not self.possible(generous):
            return None
        for amount in range(min(total, first.most), -1, -1):
            found = self._spread(dimensions, total - amount, [*chosen, (first, amount)])
            if found is not None:
                return found
        return None

    def possible(self, amounts: Sequence[tuple[Dimension, int]]) -> bool | None:
        """Whether the mission can be met after several changes; None where it is not found out."""
        key = tuple(item for item in amounts if item[1])
        if key not in self._answers:
            try:
                self._answers[key] = self._asked(key)
            except EnoughError:
                return None
        return self._answers[key]

    def _asked(self, amounts: Sequence[tuple[Dimension, int]]) -> bool | None:
        if not amounts:
            return False  # it is known that the mission as it is cannot be met
        self.oracle.pause()
        try:
            changed = applied(self.oracle.mission, amounts)
        except MissionError:
            return False  # for example more robots at a state than it holds
        if self._factual(changed):
            return False
        for core in self.cores:
            others = [item for item in self.everything - core if item.kind == "formula"]
            if self.oracle.asked(relaxed(changed, others)) is False:
                return False
        return self.oracle.met(changed)

    def _factual(self, changed: Mission) -> bool:
        """Whether a fact forbids every plan of a changed mission."""
        return next(facts_of(View.of(changed, self.oracle.pause)), None) is not None

    def _change(self, amounts: Sequence[tuple[Dimension, int]], *, proven: bool) -> Change:
        mission = self.oracle.mission
        used = tuple(item for item in amounts if item[1])
        largest = max(used, key=lambda item: item[1])[0]
        text = "; and ".join(dimension.words(mission, amount) for dimension, amount in used)
        changed = applied(mission, used)
        total = sum(amount for _, amount in used)
        return Change(largest.kind, text, total, proven, changed, used)


def applied(mission: Mission, amounts: Sequence[tuple[Dimension, int]]) -> Mission:
    """The mission after several changes."""
    for dimension, amount in amounts:
        mission = dimension.applied(mission, amount)
    return replace(mission, digest="")


def ranked(changes: Sequence[Change]) -> tuple[Change, ...]:
    """The changes, smallest amounts first, each text once."""
    distinct = {change.text: change for change in changes}
    return tuple(
        sorted(distinct.values(), key=lambda item: (item.amount, ORDER.index(item.kind), item.text))
    )
