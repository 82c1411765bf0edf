"""Demands as rows: how many agents must be, or must come, where and when.

For every set of states and capability there is one count column per step (`present`) and one
cumulative column of arrivals by moves (`arrived`). Demands of selections that exclude each other
share one row, `n(tau) >= sum of m_s * s`, which is far stronger than a row for each. No big-M is
needed, since counts are not negative.

*Arrival cuts*: whoever is present at some step of [lo, hi] was there at lo or arrived in (lo, hi],
so `n(lo) + arrivals(lo, hi] >= sum of m_s * s` over the selections s with a demand in the window.
In a fractional solution one waiting agent can no longer be counted again at every step.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import NamedTuple, TypeAlias

import numpy as np

from tsplan.encode.atom_encoders import Site
from tsplan.encode.demand_runs import Family, family
from tsplan.encode.encoder_rules import Cover, Demand, Witnesses
from tsplan.encode.flow_network import Network
from tsplan.encode.hulls import hull_of
from tsplan.encode.joint_demands import JointDemands, Region
from tsplan.encode.running_sums import RunningSums
from tsplan.encode.selection import Selection, SelectionColumns, less
from tsplan.encode.step_runs import Run, most_at_once
from tsplan.encode.switches import Switch
from tsplan.encode.visitor_cuts import Visits
from tsplan.milp.model import Block, Draft, Floats, Ints, Terms

LONG = 1000
"""Steps of a family from which on its arrival cuts are left to separation, but for the window's.

A chain for all of them would double the LP, whose iterations cost as much as it has rows.
"""

_SEVERAL = 2
_ANYWAY = -1  # in the place of a column: what is asked for whatever the witnesses are
_ALL = frozenset(Switch)

Place: TypeAlias = tuple[Site, str | None]


@dataclass(frozen=True, eq=False)
class SiteColumns:
    """Count and cumulative arrival columns of a site; step k is at position k - first.

    `inside` counts the agents that are there or on their way from one of its states to another,
    `arrived` those that have come from elsewhere.
    """

    first: int
    present: Ints
    inside: Ints
    arrived: Ints

    def come(self, low: Ints, high: Ints) -> list[Terms]:
        """Terms of who was at the site at steps `low` or arrived until `high`; one row for each."""
        low, high, every = low - self.first, high - self.first, np.arange(len(low))
        return [
            (every, self.inside[low], 1.0),
            (every, self.arrived[high], 1.0),
            (every, self.arrived[low], -1.0),
        ]


class Built(NamedTuple):
    """What is asked of structures at some states."""

    states: Site
    capability: str | None
    asked: Family


class _Joint(NamedTuple):
    """What is asked of a capability at several places together, and what asks for too much."""

    capability: str | None
    demands: JointDemands
    too_much: Sequence[Selection]


class DemandRows:
    """Writes the rows of all demands, and keeps what is needed to separate more arrival cuts."""

    def __init__(self, network: Network, draft: Draft, options: frozenset[Switch] = _ALL) -> None:
        self._options = options
        self._cuts = Switch.VISITS in options
        self._network = network
        self._draft = draft
        self._needs = Block("demand")
        self._arrivals = Block("arrival")
        self.families: list[tuple[SiteColumns, Family]] = []
        self.visits: list[Visits] = []
        self.built: list[Built] = []

    def write(self, witnesses: Witnesses) -> None:
        """Rows for every demand, arrival cuts, and what is asked for at several places together.

        None are written where too much is asked for at once whatever is chosen.
        """
        lower = _by_place(need for need in witnesses.demands if not need.bound.upper)
        joint: list[_Joint] = []
        if Switch.TOGETHER in self._options:
            every = (need for needs in lower.values() for need in needs)
            joint = self._joint(every, witnesses.choices)
            excess = [some for item in joint for some in item.too_much]
            witnesses.choices.settle(excess)
            if witnesses.choices.refuted:
                return
        wanted = frozenset(state for states, _ in lower for state in states)
        for (states, capability), needs in lower.items():
            span = min(need.first for need in needs), max(need.last for need in needs)
            site = self._site(np.array(states), capability, *span)
            asked = _runs_of(needs)
            families = self._families(asked, witnesses)
            for made in families:
                self._asked(site, made, states, capability)
                self._demand_rows(site, made)
            self._cover_rows(site, asked, witnesses.covers, (states, capability))
            hull = self._hull(states, wanted)
            if len(hull) > len(states):
                around = self._site(np.array(hull), capability, *span)
                for made in families:
                    self.families.append((around, made))
                    self._window_rows(around, made)
                self._cover_rows(around, asked, witnesses.covers, (hull, capability))
        for item in joint:
            self._together(item, witnesses)
        for place, visits in _by_place(witnesses.visits).items():
            self._visited(*place, visits)
        self._needs.write(self._draft)
        self._arrivals.write(self._draft)
        limits = _by_place(need for need in witnesses.demands if need.bound.upper)
        for (states, capability), needs in limits.items():
            self._limits(np.array(states), capability, needs, witnesses)

    def _hull(self, states: Site, wanted: frozenset[int]) -> Site:
        """The surroundings of a place on whose arrival cuts of its own there is no relying."""
        if self._cuts and Switch.HULLS in self._options:
            return hull_of(states, wanted, self._network)
        return states

    def _visited(self, states: Site, capability: str | None, visits: Sequence[Demand]) -> None:
        """One agent is there at the beginning of a window, or comes in it."""
        site = np.array(states)
        first, last = np.array([(visit.first, visit.last) for visit in visits]).T
        begin = int(first.min())
        steps = np.arange(begin, int(last.max()) + 1)
        position, column = self._network.coming(site, capability, steps)
        come = RunningSums(position + begin, column).over(self._draft, first + 1, last)
        moments, moment = np.unique(first, return_inverse=True)
        here, there, constant = self._network.present_at(site, capability, moments)
        visit, at = np.nonzero(moment[:, None] == here)
        selections = [visit.selection for visit in visits]
        lower = np.array([0.0 if selection else 1.0 for selection in selections]) - constant
        self._needs.add(come, (visit, there[at], 1.0), less(selections), lower=lower)
        for one in visits:
            self._once((states, capability), (one.first, one.last), 1.0, one.selection)

    def _joint(self, lower: Iterable[Demand], choices: SelectionColumns) -> list[_Joint]:
        """What is asked for at several places together, capability by capability."""
        able: dict[str | None, list[Demand]] = defaultdict(list)
        for need in lower:
            able[need.bound.capability].append(need)
        return [
            _Joint(name, made, made.too_much(self._network.agents(name)))
            for name, needs in able.items()
            for made in [JointDemands(needs, choices)]
        ]

    def _together(self, joint: _Joint, witnesses: Witnesses) -> None:
        """Rule out witnesses that need too many agents at once; arrival cuts of whole regions."""
        capability, demands, too_much = joint
        for selection in too_much:
            witnesses.choices.refute(selection, "together")
        regions = demands.regions() if self._cuts else []
        if self._cuts and self._network.reborn(capability):
            regions.append(demands.everywhere(self._network.states))
        for region in regions:
            self._region_rows(region, capability, witnesses)

    def _region_rows(self, region: Region, capability: str | None, witnesses: Witnesses) -> None:
        runs = [run for found in region.columns.values() for run in found]
        first = min((run.first for run in runs), default=0)
        last = max((run.last for run in runs), default=0)
        if first == last or self._network.horizon == 0:
            return
        site = self._site(np.array(region.states), capability, first, last)
        for columns in witnesses.choices.families(region.columns):
            made = family(columns, region.columns, region.always, everywhere=False)
            self._asked(site, made, region.states, capability)
        self._cover_rows(site, region.columns, witnesses.covers, (region.states, capability))

    def _asked(self, site: SiteColumns, made: Family, states: Site, capability: str | None) -> None:
        """Arrival cuts of a family; of structures, what has to be built is noted."""
        self.families.append((site, made))
        self._window_rows(site, made)
        if len(made.columns) >= _SEVERAL:
            self._visits_of(made, (states, capability))
        if self._network.reborn(capability):
            self.built.append(Built(states, capability, made))

    def _visits_of(self, made: Family, place: Place) -> None:
        """What a family asks of different agents: the most that each column asks for at once."""
        column, first, last, amount = made.pieces
        order = np.lexsort((first, -amount, column))
        most = order[np.append(True, np.diff(column[order]) > 0)]
        steps, every = made.steps[first[most]], np.arange(len(most))
        terms = every, column[most], amount[most]
        stay = int((last - first)[most].min()) + 1
        self._visit(Visits(*place, steps, steps, terms, np.zeros(len(most)), stay))

    def _once(
        self, place: Place, window: tuple[int, int], amount: float, selection: Selection
    ) -> None:
        """So many agents are at a place together at some step of a window."""
        first, last = np.array(window).reshape(2, 1)
        members = np.array(selection, dtype=np.int64)
        terms = np.zeros_like(members), members, np.full(len(members), amount)
        constant = np.array([0.0 if selection else amount])
        self._visit(Visits(*place, first, last, terms, constant))

    def _visit(self, visits: Visits) -> None:
        """Note demands of different agents where all of them have ways from their starts."""
        if Switch.VISITORS in self._options and self._network.begun(visits.capability):
            self.visits.append(visits)

    def _site(self, states: Ints, capability: str | None, first: int, last: int) -> SiteColumns:
        """Count columns for steps first..last and, for the cuts, cumulative arrivals."""
        steps = np.arange(first, last + 1)
        index, columns, constant = self._network.present_at(states, capability, steps)
        present = self._counted(len(steps), (index, columns, 1.0), constant=constant)
        if not self._cuts:
            return SiteColumns(first, present, present, present[:0])
        inside = present
        index, columns = self._network.between(states, capability, steps)
        if len(index):
            every = np.arange(len(steps))
            inside = self._counted(len(steps), (index, columns, 1.0), (every, present, 1.0))
        index, columns = self._network.entering(states, capability, steps)
        later = index > 0  # arrivals are counted from the first step on
        arrived = self._draft.columns(len(steps))
        new, former = (index[later], columns[later], 1.0), (steps[1:] - first, arrived[:-1], 1.0)
        self._draft.define(arrived, new, former, kind="count")
        return SiteColumns(first, present, inside, arrived)

    def _counted(self, count: int, *terms: Terms, constant: float = 0.0) -> Ints:
        """So many new columns that are sums of terms."""
        columns = self._draft.columns(count)
        self._draft.define(columns, *terms, constant=constant, kind="count")
        return columns

    def _demand_rows(self, site: SiteColumns, family: Family) -> None:
        """`n(tau) >= base + sum of surplus * selection` for every step of the family."""
        here = site.present[family.steps - site.first]
        row, columns, surplus = family.surplus(self._draft)
        every = np.arange(len(here))
        self._needs.add((every, here, 1.0), (row, columns, -surplus), lower=family.base)

    def _window_rows(self, site: SiteColumns, family: Family) -> None:
        """Arrival cuts of the family's whole window, of its beginnings and of its ends."""
        count = len(family.steps) - 1
        # the demand itself says as much of a single step or column
        if not self._cuts or count < 1 or len(family.columns) < _SEVERAL:
            return
        ends, begins = np.arange(1, count + 1), np.arange(1, count)
        if Switch.LAZY in self._options and count >= LONG:
            ends, begins = ends[-1:], begins[:0]
        low = np.concatenate([np.zeros_like(ends), begins])
        high = np.concatenate([ends, np.full_like(begins, count)])
        late = len(ends)
        row, columns, need = family.begun.over(self._draft, low[:late], high[:late])
        later, others, rest = family.ending.over(self._draft, low[late:], high[late:])
        come = site.come(family.steps[low], family.steps[high])
        asked = (row, columns, -need), (later + late, others, -rest)
        self._arrivals.add(*come, *asked, lower=np.zeros(len(low)))

    def _cover_rows(
        self,
        site: SiteColumns,
        asked: Mapping[int, Sequence[Run]],
        covers: Sequence[Cover],
        place: Place,
    ) -> None:
        """Arrival cuts of shared windows: if every witness asks for agents here, some must come."""
        edges: dict[int, list[tuple[Ints, Floats]]] = {}
        for cover in covers if self._cuts else ():
            if id(cover.columns) not in edges:
                runs = [asked.get(column) or [_NOTHING] for column in cover.columns.tolist()]
                edges[id(cover.columns)] = [
                    (np.array([run[0].first for run in runs]), _amounts(runs, 0)),
                    (np.array([run[-1].last for run in runs]), _amounts(runs, -1)),
                ]
            members = slice(cover.begin, cover.end)
            # the first, then the last step at which a witness needs agents
            for number, (steps, amounts) in enumerate(edges[id(cover.columns)]):
                if cover.begin < cover.end and amounts[members].all():
                    window = steps[members].min(keepdims=True), steps[members].max(keepdims=True)
                    need = float(amounts[members].min())
                    self._arrive(site, window, need, cover.selection)
                    if not number:
                        ends = int(window[0][0]), int(window[1][0])
                        self._once(place, ends, need, cover.selection)

    def _arrive(
        self, site: SiteColumns, window: tuple[Ints, Ints], need: float, selection: Selection
    ) -> None:
        terms = (*site.come(*window), (0, selection, -need))
        self._arrivals.add(*terms, lower=0.0 if selection else need)

    def _limits(
        self, site: Ints, capability: str | None, needs: Sequence[Demand], witnesses: Witnesses
    ) -> None:
        """`n(tau) <= N - sum of (N - m_s) * s`, N the most agents that can be there."""
        most = self._network.most(site, capability, upper=True)
        for made in self._families(_runs_of(needs, most), witnesses):
            index, here, factors, constant = self._network.possible_at(site, capability, made.steps)
            upper = most[made.steps] - made.base - constant
            terms = (index, here, factors), made.surplus(self._draft)
            self._draft.sums(*terms, lower=-np.inf, upper=upper, kind="limit")

    def _families(self, asked: Mapping[int, Sequence[Run]], witnesses: Witnesses) -> list[Family]:
        """Demands at a site by exclusive selections; what holds in any case goes with the first."""
        columns = [column for column in asked if column != _ANYWAY]
        base = asked.get(_ANYWAY, ())
        joint = Switch.FAMILIES in self._options
        groups = witnesses.choices.families(columns) if joint else [[column] for column in columns]
        return [
            family(members, asked, base, everywhere=number == 0)
            for number, members in enumerate(groups or ([[]] if base else []))
        ]


_NOTHING = Run(0, 0, 0.0)


def _amounts(runs: Sequence[Sequence[Run]], place: int) -> Floats:
    return np.array([run[place].amount for run in runs])


def _by_place(needs: Iterable[Demand]) -> dict[Place, list[Demand]]:
    found: dict[Place, list[Demand]] = defaultdict(list)
    for need in needs:
        found[need.bound.states, need.bound.capability].append(need)
    return found


def _runs_of(needs: Sequence[Demand], most: Ints | None = None) -> dict[int, list[Run]]:
    """What each column asks for, `_ANYWAY` for what is asked under none.

    With `most`, limits: what they take away from the most agents there can be at each step.
    """
    asked: dict[int, list[Run]] = defaultdict(list)
    for need in needs:
        amount = float(need.bound.amount)
        if most is None:
            runs = [Run(need.first, need.last, amount)]
        else:
            part = most[need.first : need.last + 1]
            edges = [0, *(np.flatnonzero(np.diff(part)) + 1).tolist(), len(part)]
            runs = [
                Run(need.first + begin, need.first + end - 1, float(part[begin]) - amount)
                for begin, end in pairwise(edges)
            ]
        for column in need.selection or (_ANYWAY,):
            asked[column] += [run for run in runs if run.amount > 0]
    return {column: most_at_once(runs) for column, runs in asked.items() if runs}
