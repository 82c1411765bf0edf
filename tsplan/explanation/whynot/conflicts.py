"""Irreducible conflicts among the constraints of a mission, and several different ones.

One conflict is found by deletion (J. Chinneck and E. Dravnieks, "Locating minimal infeasible
constraint sets in linear programs", ORSA Journal on Computing 1991): from the end on, whatever the
rest is impossible without is dropped. As long as that succeeds more and more is dropped at a time,
so that much which is of no matter takes few questions; and what has to stay takes one plan each,
where halving all of it first would take two. It is the conflict that U. Junker's QuickXplain (AAAI
2004) finds. Further ones are found by the hitting-set tree (R. Reiter, "A theory of diagnosis from
first principles", Artificial Intelligence 1987): leave one element of every conflict known out; if
what is left is still impossible, it holds a new one.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from tsplan.explanation.explanation import SoftConstraint
    from tsplan.explanation.whynot.oracle import Oracle

Set = frozenset["SoftConstraint"]

_AT_ONCE = 8  # of so many parts one is dropped at first


class Core(NamedTuple):
    """Soft constraints that cannot hold together; `minimal` if no proof of that is missing."""

    constraints: Set
    minimal: bool


@dataclass(eq=False)
class Finder:
    """Finds conflicts of one mission.

    `groups` are the parts of each conjunct, `facts` all other constraints, those first that are
    rather to be named.
    """

    oracle: Oracle

    def __post_init__(self) -> None:
        subject = self.oracle.subject
        self.groups = [frozenset(group) for group in subject.groups]
        self.facts = [frozenset({fact}) for fact in subject.bounds]
        self.everything: Set = frozenset().union(*self.groups, *self.facts)
        self._sure = True

    def within(self, constraints: Set) -> Core | None:
        """An irreducible conflict among some constraints; None where none is proven to be there.

        It is found over whole conjuncts first, then over their parts and the facts.
        """
        if not self._impossible(constraints):
            return None
        self._sure = True
        facts = [fact for fact in self.facts if fact <= constraints]
        conjuncts = [group & constraints for group in self.groups if group & constraints]
        every: Set = frozenset().union(*facts)
        kept = self._least(every, conjuncts)
        fine = [frozenset({part}) for group in kept for part in sorted(group, key=repr)]
        parts = frozenset().union(*self._least(every, fine))
        bounds = frozenset().union(*self._least(parts, facts))
        # without a part all facts together can be met, and so can the fewer that are left
        return Core(parts | bounds, self._sure)

    def others(self, core: Core, most: int) -> Iterator[Core]:
        """Up to `most` conflicts that differ from `core` and from each other."""
        cores, found = [core], 0
        tried: set[Set] = set()
        open_: list[Set] = [frozenset()]
        while open_ and found < most and not self.oracle.refuses():
            hit = open_.pop(0)
            for known in cores:
                if not known.constraints & hit:
                    branches = [hit | {item} for item in sorted(known.constraints, key=repr)]
                    open_ += [branch for branch in branches if branch not in tried]
                    tried.update(branches)
                    break
            else:
                rest = self.everything - hit
                new = self.within(rest)
                if new is not None:
                    found += 1
                    cores.append(new)
                    yield new
                    open_.insert(0, hit)

    def _least(self, background: Set, parts: Sequence[Set]) -> list[Set]:
        """As few parts as are impossible together with the background; early ones preferred."""
        open_, kept = list(parts), list[Set]()
        size = first = max(len(parts) // _AT_ONCE, 1)
        again = False
        while open_:
            if self.oracle.refuses():  # nothing more is known of any of them
                self._sure = False
                break
            size = min(size, len(open_))
            if self._impossible(background.union(*open_[:-size], *kept)):
                del open_[-size:]
                size, again = size * (1 + again), True
            elif size > 1:
                size, again = size // 2, False
            else:
                kept.append(open_.pop())
                size, again = first, False
        return [*open_, *reversed(kept)]

    def _impossible(self, constraints: Set) -> bool:
        """Whether it is proven that constraints cannot hold together."""
        answer = self.oracle.without(self.everything - constraints)
        if answer is None:
            self._sure = False
        return answer is False
