"""All changes of a mission that help, those that are found soonest first.

More agents, lower needs and higher limits leave a mission as large as it is; later deadlines make
it larger, and it is hard to prove that one step less is not enough. So the former are tried first,
and where none of them helps by itself the fewest of them that help together.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from tsplan.explanation.change_kinds import ORDER, ChangeKind
from tsplan.explanation.whynot.changes import fewest
from tsplan.explanation.whynot.joint_repair import JointRepair

if TYPE_CHECKING:
    from tsplan.clock import Clock
    from tsplan.explanation.explanation import Change, SoftConstraint
    from tsplan.explanation.whynot.changes import Repairs, Step
    from tsplan.explanation.whynot.mission_numbers import Edit
    from tsplan.explanation.whynot.oracle import Oracle

_ENOUGH = 3  # changes, if more would take longer than
_LONG = 20.0  # seconds and no time limit was set
_TOGETHER = 2.0  # seconds for the fewest that help together
_TOGETHER_FIRST = ("edge", "rebuild", "site")  # of these there are many, and few help
_SLOW: frozenset[ChangeKind] = frozenset({"extend_deadline", "shorten_task", "edge", "reconfigure"})


@dataclass(eq=False)
class ChangeSearch:
    """Looks for changes against a conflict; `hear` is told each one.

    `shortage` is what more agents would do, if that is known. `untried` has what is left open.
    """

    repairs: Repairs
    clock: Clock
    conflict: frozenset[SoftConstraint]
    shortage: Sequence[Step]
    hear: Callable[[Change], object]
    found: int = field(default=0, init=False)
    untried: list[Edit] = field(default_factory=list, init=False)
    _began: float = field(default_factory=time.perf_counter, init=False)
    _helped: dict[int, int] = field(default_factory=dict, init=False)

    @property
    def _oracle(self) -> Oracle:
        return self.repairs.oracle

    def run(self) -> None:
        """Look for all of them, as long as there is time."""
        rank = self._oracle.subject.rank
        every = self._oracle.subject.candidates(self.conflict)
        every.sort(key=lambda e: (e.kind in _SLOW, ORDER.index(e.kind), rank(e.number)))
        self.untried = list(every)
        self._singles([edit for edit in every if edit.kind not in _SLOW])
        together = 0 if self.found else self._together()
        self._singles([edit for edit in every if edit.kind in _SLOW])
        if self.found == together:  # none by itself
            self._tell(JointRepair(self._oracle, self.repairs).change(self.conflict))

    def _tell(self, change: Change | None) -> None:
        if change is not None:
            self.found += 1
            self.hear(change)

    def _singles(self, every: Sequence[Edit]) -> None:
        """Changes of one number."""
        oracle = self._oracle
        at_once: dict[str, list[Step]] = {kind: [] for kind in _TOGETHER_FIRST}
        for edit in every:
            if edit.number.kind in at_once:
                at_once[edit.number.kind].append((edit, edit.most))
        for edit in every:
            long = time.perf_counter() - self._began > _LONG
            if self.found >= _ENOUGH and long and self.clock.limit is None:
                oracle.unanswered.add("patience")
                return
            kind, key = edit.number
            place = oracle.subject.rank(edit.number)
            oracle.pause()
            self.untried.remove(edit)
            if kind == "agents" and place > self._helped.get(key[0], place):
                continue
            if kind in at_once and not self.repairs.possible(at_once[kind]):
                continue  # not even all of them as far as can be would do
            open_ = len(oracle.unanswered)
            change = self.repairs.single(edit)
            if change is None and len(oracle.unanswered) > open_:
                self.untried.append(edit)
            self._tell(change)
            if change is not None and kind == "agents":
                self._helped.setdefault(key[0], place)

    def _together(self) -> int:
        """The fewest agents more, and the fewest fewer asked for, that help together."""
        oracle = self._oracle
        patience, oracle.patience = oracle.patience, _TOGETHER
        every = oracle.subject.candidates(self.repairs.everything)
        needs = [edit for edit in every if edit.kind == "lower_need" and edit.whole]
        agents = self.shortage or fewest(oracle, [edit for edit in every if self._at_home(edit)])
        found = [agents, fewest(oracle, needs)]
        oracle.patience = patience
        for steps in found:
            small = self.repairs.lowered(steps) if steps else None
            self._tell(self.repairs.made(small) if small else None)
        return self.found

    def _at_home(self, edit: Edit) -> bool:
        return edit.kind == "add_agents" and self._oracle.subject.rank(edit.number) == 0
