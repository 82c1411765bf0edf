"""What one witness asks of the agents at several places at once.

A witness often needs agents at several places at the same step: the states of a label, the tasks
of a conjunction, both sides of an until. Place by place the LP may serve them one after the other
with the same agents, a little for every witness. Taken together they give two more rows:

* a witness that needs more agents with a capability at one step than there are is impossible;
* the visit cut of the union of the places: so many agents must come to the region as a whole, and
  going from one of its places to another is not coming.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import TypeAlias

from tsplan.encode.atoms import Site
from tsplan.encode.literals import ALWAYS, Choices
from tsplan.encode.witness import Demand

Needs: TypeAlias = dict[int, dict[Site, int]]
"""By step: agents needed at each of several places that share no state."""


@dataclass(frozen=True, slots=True)
class Region:
    """A union of places that some witness needs at one step, and what each column needs there.

    `always` is what is needed whatever the witnesses are.
    """

    states: Site
    columns: Mapping[int, Mapping[int, int]]  # column -> step -> agents
    always: Mapping[int, int]


class Together:
    """The needs of one capability by the columns that imply them."""

    def __init__(self, demands: Iterable[Demand], choices: Choices) -> None:
        self._choices = choices
        self._own: dict[int, list[Demand]] = defaultdict(list)
        self._always: list[Demand] = []
        for demand in demands:
            if not demand.literal:
                self._always.append(demand)
            for column in demand.literal:
                self._own[column].append(demand)
        self._base = _needs(self._always)
        self._of = {column: self._implied(column) for column in sorted(self._own)}

    def _implied(self, column: int) -> Needs:
        """Everything that is needed where `column` is 1, its ancestors' needs included."""
        own = list(self._own[column])
        for ancestor in self._choices.ancestors(column):
            own += self._own.get(ancestor, ())
        steps = {demand.step for demand in own}
        return _needs([*own, *(demand for demand in self._always if demand.step in steps)])

    def most(self) -> tuple[int, dict[int, int]]:
        """Agents needed at most at one step: in any case, and where a column is 1."""
        always = max(_totals(self._base).values(), default=0)
        return always, {
            column: max(_totals(needs).values(), default=0) for column, needs in self._of.items()
        }

    def rule_out(self, team: int) -> None:
        """Refute what needs more than `team` agents at one step."""
        always, needs = self.most()
        if always > team:
            self._choices.refute(ALWAYS, "together")
        for column, need in needs.items():
            if need > team:
                self._choices.refute((column,), "together")

    def regions(self) -> list[Region]:
        """A region for every set of places that some column needs most agents at, all at once."""
        unions = {_widest(needs) for needs in self._of.values()} - {frozenset()}
        found = []
        for places in sorted(unions, key=sorted):
            states = tuple(sorted({state for place in places for state in place}))
            columns = {
                column: _totals(needs, places)
                for column, needs in self._of.items()
                if any(place in places for mine in needs.values() for place in mine)
            }
            inner = {a for column in columns for a in self._choices.ancestors(column)}
            leaves = {column: need for column, need in columns.items() if column not in inner}
            found.append(Region(states, leaves, _totals(self._base, places)))
        return found


def _needs(demands: Sequence[Demand]) -> Needs:
    """Needs by step at places without common states; of places that overlap the neediest stays."""
    needs: Needs = defaultdict(dict)
    for demand in sorted(demands, key=lambda d: (-d.bound.amount, d.bound.states)):
        places = needs[demand.step]
        mine = set(demand.bound.states)
        if demand.bound.amount > 0 and all(mine.isdisjoint(place) for place in places):
            places[demand.bound.states] = demand.bound.amount
    return {step: places for step, places in needs.items() if places}


def _totals(needs: Needs, among: frozenset[Site] | None = None) -> dict[int, int]:
    totals = {}
    for step, places in needs.items():
        total = sum(n for place, n in places.items() if among is None or place in among)
        if total:
            totals[step] = total
    return totals


def _widest(needs: Needs) -> frozenset[Site]:
    """The places needed at the step that needs most agents; none if that is a single place."""
    if not needs:
        return frozenset()
    places = max(needs.values(), key=lambda places: (sum(places.values()), len(places)))
    return frozenset(places) if len(places) > 1 else frozenset()
