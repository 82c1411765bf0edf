"""Several changes at once, where no single one helps.

Conflicts are resolved one after the other, each by one or two ways to change the mission, until
there is a plan. What is not needed of these ways is left out again, then each goes back as far as
it can. Last, for as long as `QUESTIONS` and a few seconds allow, smaller totals are tried.

Most ways make a mission the easier the further they go, so they go as far as they can at first; but
deadlines of short missions go only as far as the missions are long, as long as that will do.
More agents may be in the way of limits: no more are added than resolve a conflict, and where they
lead nowhere the ways without them are tried.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import inf
from typing import TYPE_CHECKING, Any

from tsplan.explanation.change_kinds import ORDER
from tsplan.explanation.whynot.changes import Repairs, Step, least
from tsplan.explanation.whynot.conflicts import Finder
from tsplan.explanation.whynot.mission_numbers import MOST_STEPS

if TYPE_CHECKING:
    from tsplan.explanation.change_kinds import ChangeKind
    from tsplan.explanation.explanation import Change, SoftConstraint
    from tsplan.explanation.whynot.mission_numbers import Edit
    from tsplan.explanation.whynot.oracle import Oracle
    from tsplan.explanation.whynot.subject import Subject

MOST_WAYS = 12
"""Ways to change a mission that are gathered at most."""

QUESTIONS = 40
"""Missions that are planned at most in the search for a smaller total."""

_PER_CONFLICT = 2
_NEAR = 8  # steps by which deadlines of short missions are moved at first
_MOST_ADDED = 64
_SEARCHED = 6  # ways over which the least total is looked for


@dataclass(frozen=True)
class JointRepair:
    """Looks for changes of more than one kind together."""

    oracle: Oracle
    repairs: Repairs

    @property
    def subject(self) -> Subject[Any]:
        """The mission that is changed."""
        return self.oracle.subject

    def change(self, conflict: frozenset[SoftConstraint]) -> Change | None:
        """A change that resolves a conflict and all others; None if none is found in time."""
        ways = self._ways(conflict)
        small = self.repairs.lowered(self._needed(ways)) if ways else None
        if small is None:
            return None
        found = [edit for edit, _ in small]
        found += [edit for edit, _ in ways if edit not in found]
        if self.subject.restrained:
            found = [item for item in found if item.kind != "add_agents"]
        total = sum(amount for _, amount in small)
        best = self.repairs.several(found[:_SEARCHED], total, QUESTIONS)
        return best or self.repairs.made(small)

    def _ways(self, conflict: frozenset[SoftConstraint]) -> list[Step]:
        """Ways that together lead to a plan: first with near deadlines, which are proven sooner."""
        near = max(_NEAR, self.subject.mission.horizon)
        for farthest in (near, inf) if near < MOST_STEPS else (near,):
            for kinds in self.subject.orders:
                ways = self._gathered(conflict, kinds, farthest)
                if ways or self.oracle.refuses():
                    return ways
        return []

    def _gathered(
        self, core: frozenset[SoftConstraint], kinds: Sequence[ChangeKind], farthest: float
    ) -> list[Step]:
        """Ways of some kinds that together lead to a plan; nothing if none are found.

        Deadlines are moved by so many steps at most.
        """
        chosen: list[Step] = []
        while len(chosen) < MOST_WAYS and not self.oracle.refuses():
            new = self._resolving(core, chosen, kinds, farthest)
            chosen += new
            changed = self.repairs.changed(chosen)
            if not new or changed is None:
                return []
            finder = Finder(self.oracle.about(changed))
            found = finder.within(finder.everything)
            if found is None:
                return chosen
            core = found.constraints
        return []

    def _resolving(
        self,
        core: frozenset[SoftConstraint],
        chosen: Sequence[Step],
        kinds: Sequence[ChangeKind],
        farthest: float,
    ) -> list[Step]:
        """One or two further ways, of different kinds, each of which resolves a conflict."""
        every = self.subject.candidates(core)
        every.sort(key=lambda edit: (self.subject.rank(edit.number), ORDER.index(edit.kind)))
        taken = {edit for edit, _ in chosen}
        found: list[Step] = []
        for edit in (edit for edit in every if edit.kind in kinds):
            if edit in taken or edit.kind in {other.kind for other, _ in found}:
                continue
            amount = self._enough(edit, core, chosen, farthest)
            if amount:
                found.append((edit, amount))
                if len(found) == _PER_CONFLICT:
                    break
        return found

    def _enough(
        self,
        edit: Edit,
        core: frozenset[SoftConstraint],
        chosen: Sequence[Step],
        farthest: float,
    ) -> int:
        """How far an edit may go at first to resolve a conflict; 0 where it does not."""
        if edit.kind == "add_agents":
            most = min(edit.most, _MOST_ADDED)
            few = least(lambda amount: self._resolves(core, [*chosen, (edit, amount)]), most)
            return 0 if few is None else few.amount
        amount = edit.most
        if edit.kind == "extend_deadline":
            amount = int(min(amount, farthest))
        while amount and self.repairs.changed([*chosen, (edit, amount)]) is None:
            amount //= 2  # less may fit together
        return amount if amount and self._resolves(core, [*chosen, (edit, amount)]) else 0

    def _resolves(self, core: frozenset[SoftConstraint], steps: Sequence[Step]) -> bool:
        """Whether a conflict can be met after some changes."""
        changed = self.repairs.changed(steps)
        if changed is None:
            return False
        subject = self.subject.about(changed)
        others = Finder(self.oracle.about(changed)).everything - core
        return self.oracle.asked(subject.without(others)) is True

    def _needed(self, ways: Sequence[Step]) -> list[Step]:
        """The ways without those that are not needed beside the others, the last ones first."""
        kept = list(ways)
        for step in reversed(ways):
            fewer = [item for item in kept if item is not step]
            if self.repairs.possible(fewer):
                kept = fewer
        return kept if len(kept) == len(ways) else self._needed(kept)
