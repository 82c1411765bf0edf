"""What one witness asks of the agents at several places at once.

A witness often needs agents at several places at the same step: the states of a label, the tasks
of a conjunction, both sides of an until. Place by place the LP may serve them one after the other
with the same agents, a little for every witness. Taken together they give two more rows:

* a witness that needs more agents with a capability at one step than there are is impossible;
* the arrival cut of the union of the places: so many agents must come to the region as a whole, and
  going from one of its places to another is not coming.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from tsplan.encode.atom_encoders import Site
from tsplan.encode.encoder_rules import Demand
from tsplan.encode.selection import ALWAYS, Selection, SelectionColumns
from tsplan.encode.step_runs import Run, pieces


class Needs(NamedTuple):
    """Agents needed at the steps `first .. last` at several places without common states."""

    first: int
    last: int
    places: Mapping[Site, int]


@dataclass(frozen=True, slots=True)
class Region:
    """A union of places that some witness needs at one step, and what each column needs there.

    `always` is what is needed whatever the witnesses are.
    """

    states: Site
    columns: Mapping[int, Sequence[Run]]
    always: Sequence[Run]


class JointDemands:
    """The needs of one capability by the columns that imply them."""

    def __init__(self, needs: Iterable[Demand], choices: SelectionColumns) -> None:
        self._choices = choices
        self._own: dict[int, list[Demand]] = defaultdict(list)
        self._always: list[Demand] = []
        for need in needs:
            if need.bound.amount > 0:
                if not need.selection:
                    self._always.append(need)
                for column in need.selection:
                    self._own[column].append(need)
        self._ends = np.array([(need.first, need.last) for need in self._always]).reshape(-1, 2)
        self._base = _needs(self._always)
        self._of = {column: self._implied(column) for column in sorted(self._own)}

    def _implied(self, column: int) -> list[Needs]:
        """Everything that is needed where `column` is 1, its ancestors' needs included."""
        own = list(self._own[column])
        for ancestor in self._choices.ancestors(column):
            own += self._own.get(ancestor, ())
        first, last = min(need.first for need in own), max(need.last for need in own)
        near = np.flatnonzero((self._ends[:, 0] <= last) & (self._ends[:, 1] >= first)).tolist()
        return _needs([*own, *(self._always[place] for place in near)])

    def most(self) -> tuple[int, dict[int, int]]:
        """Agents needed at most at one step: in any case, and where a column is 1."""
        return _most(self._base), {column: _most(needs) for column, needs in self._of.items()}

    def too_much(self, team: int) -> list[Selection]:
        """What needs more than `team` agents at one step."""
        always, needs = self.most()
        found: list[Selection] = [ALWAYS] if always > team else []
        return [*found, *((column,) for column, need in needs.items() if need > team)]

    def rule_out(self, team: int) -> None:
        """Refute what needs more than `team` agents at one step."""
        for selection in self.too_much(team):
            self._choices.refute(selection, "together")

    def regions(self) -> list[Region]:
        """A region for every set of places that some column needs most agents at, all at once."""
        unions = {_widest(needs) for needs in self._of.values()} - {frozenset()}
        found = []
        for places in sorted(unions, key=sorted):
            states = tuple(sorted({state for place in places for state in place}))
            columns = {
                column: runs
                for column, needs in self._of.items()
                for runs in [_totals(needs, places)]
                if runs
            }
            found.append(Region(states, self._leaves(columns), _totals(self._base, places)))
        return found

    def everywhere(self, states: Site) -> Region:
        """All that is needed at once, as a region of all states: nobody comes there but the new."""
        columns = {column: _totals(needs) for column, needs in self._of.items()}
        return Region(states, self._leaves(columns), _totals(self._base))

    def _leaves(self, columns: Mapping[int, Sequence[Run]]) -> dict[int, Sequence[Run]]:
        """What is needed by columns that are no ancestors of others."""
        inner = {a for column in columns for a in self._choices.ancestors(column)}
        return {column: need for column, need in columns.items() if column not in inner and need}


def apart(demands: Iterable[Demand]) -> dict[Site, Demand]:
    """Demands at places without common states; of places that overlap the neediest stays."""
    found: dict[Site, Demand] = {}
    for demand in sorted(demands, key=lambda d: (-d.bound.amount, d.bound.states)):
        if all(set(demand.bound.states).isdisjoint(place) for place in found):
            found[demand.bound.states] = demand
    return found


def _needs(demands: Sequence[Demand]) -> list[Needs]:
    """Needs at places apart, at the steps of demands under a selection if there are any."""
    conditional = any(need.selection for need in demands)
    return [
        Needs(first, last, {place: need.bound.amount for place, need in apart(active).items()})
        for first, last, active in pieces(demands)
        if not conditional or any(need.selection for need in active)
    ]


def _most(needs: Sequence[Needs]) -> int:
    return max((sum(need.places.values()) for need in needs), default=0)


def _totals(needs: Sequence[Needs], among: frozenset[Site] | None = None) -> list[Run]:
    """What is needed at some places together, or at all, as runs in order."""
    counted = [
        (n, (m for place, m in n.places.items() if among is None or place in among)) for n in needs
    ]
    totals = [Run(n.first, n.last, float(sum(amounts))) for n, amounts in counted]
    return [run for run in totals if run.amount]


def _widest(needs: Sequence[Needs]) -> frozenset[Site]:
    """The places needed at the step that needs most agents; none if that is a single place."""
    if not needs:
        return frozenset()
    widest = max(needs, key=lambda need: (sum(need.places.values()), len(need.places)))
    return frozenset(widest.places) if len(widest.places) > 1 else frozenset()
