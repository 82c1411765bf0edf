"""Demands as rows: how many agents must be, or must come, where and when.

For every set of states and capability there is one count column per step (`present`) and one
cumulative column of arrivals by moves (`arrived`). Demands of literals that exclude each other
share one row, `n(tau) >= sum of m_s * literal_s`, which is far stronger than a row for each. No
big-M is needed, since counts are not negative.

*Visit cuts*: whoever is present at some step of [lo, hi] was there at lo or arrived in (lo, hi], so
`n(lo) + arrivals(lo, hi] >= sum of m_s * literal_s` over the literals with a demand in the window.
In a fractional solution one waiting agent can no longer be counted again at every step.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import TypeAlias

import numpy as np
from scipy import sparse

from tsplan.encode.count_atoms import Site
from tsplan.encode.demand_runs import Family, Run, apart, family
from tsplan.encode.flow_network import Network
from tsplan.encode.joint_demands import Region, Together
from tsplan.encode.running_sums import RunningSums
from tsplan.encode.selection import Choices, Literal
from tsplan.encode.witness import Cover, Lasting, Visit, Witnesses
from tsplan.milp.model import Block, Draft, Floats, Ints

LONG = 1000
"""Steps of a family from which on its visit cuts are left to separation, the whole window's apart.

A chain for all of them would double the LP, whose iterations cost as much as it has rows.
"""

_SEVERAL = 2
_ANYWAY = -1  # in the place of a column: what is asked for whatever the witnesses are

Place: TypeAlias = tuple[Site, str | None]
_Edge: TypeAlias = tuple[Ints, Floats]


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


class Staffing:
    """Writes the rows of all demands, and keeps what is needed to separate more visit cuts."""

    def __init__(
        self, network: Network, draft: Draft, *, joint: bool = True, lazy: bool = False
    ) -> None:
        self._joint = joint
        self._lazy = lazy
        self._network = network
        self._draft = draft
        self._needs = Block("staffing")
        self._visits = Block("visit")
        self.families: list[tuple[SiteColumns, Family]] = []

    def write(self, witnesses: Witnesses, *, cuts: bool, together: bool) -> None:
        """Rows for every demand; with `cuts` also visit cuts of windows and their parts.

        `together` adds what the demands of one witness at several places ask for as a whole.
        """
        lower: dict[Place, list[Lasting]] = defaultdict(list)
        upper: dict[Place, list[Lasting]] = defaultdict(list)
        for need in witnesses.lasting:
            found = upper if need.bound.upper else lower
            found[need.bound.states, need.bound.capability].append(need)
        for (states, capability), needs in lower.items():
            span = min(need.first for need in needs), max(need.last for need in needs)
            site = self._site(np.array(states), capability, *span, cuts=cuts)
            asked = _runs_of(needs)
            for made in self._families(asked, witnesses.choices):
                self.families.append((site, made))
                self._demand_rows(site, made)
                if cuts:
                    self._window_rows(site, made)
            if cuts:
                self._cover_rows(site, asked, witnesses.covers)
        if together:
            self._together(lower, witnesses, cuts=cuts)
        self._visited(witnesses.visits)
        self._needs.write(self._draft)
        self._visits.write(self._draft)
        self._limits(upper, witnesses.choices)

    def _visited(self, visits: Sequence[Visit]) -> None:
        """One agent is there at the beginning of a window, or comes in it."""
        grouped: dict[Place, list[Visit]] = defaultdict(list)
        for visit in visits:
            grouped[visit.bound.states, visit.bound.capability].append(visit)
        for (states, capability), mine in grouped.items():
            site = np.array(states)
            first = np.array([visit.first for visit in mine])
            last = np.array([visit.last for visit in mine])
            begin = int(first.min())
            steps = np.arange(begin, int(last.max()) + 1)
            position, column = self._network.coming(site, capability, steps)
            come = RunningSums(position + begin, column, np.ones(len(column)))
            row, members, values = come.over(self._draft, first + 1, last)
            moments, which = np.unique(first, return_inverse=True)
            here, there, constant = self._network.present_at(site, capability, moments)
            at = sparse.csr_array(
                (np.ones(len(here)), (here, np.arange(len(here)))), (len(moments), len(here))
            )[which].tocoo()
            above = [column for visit in mine for column in visit.literal]
            under = np.repeat(np.arange(len(mine)), [len(visit.literal) for visit in mine])
            self._needs.add(
                np.concatenate([row, at.row, under]),
                np.concatenate([members, there[at.col], np.array(above, dtype=np.int64)]),
                np.concatenate([values, np.ones(len(at.row)), -np.ones(len(above))]),
                np.array([0.0 if visit.literal else 1.0 for visit in mine]) - constant,
            )

    def _together(
        self, lower: Mapping[Place, list[Lasting]], witnesses: Witnesses, *, cuts: bool
    ) -> None:
        """Rule out witnesses that need too many agents at once; visit cuts of whole regions."""
        able: dict[str | None, list[Lasting]] = defaultdict(list)
        for (_, capability), needs in lower.items():
            able[capability] += needs
        for capability, needs in able.items():
            joint = Together(needs, witnesses.choices)
            joint.rule_out(self._network.agents(capability))
            for region in joint.regions() if cuts else ():
                self._region_rows(region, capability, witnesses)

    def _region_rows(self, region: Region, capability: str | None, witnesses: Witnesses) -> None:
        runs = [run for found in region.columns.values() for run in found]
        first = min((run.first for run in runs), default=0)
        last = max((run.last for run in runs), default=0)
        if first == last or self._network.horizon == 0:
            return
        site = self._site(np.array(region.states), capability, first, last, cuts=True)
        for columns in witnesses.choices.families(region.columns):
            made = family(columns, region.columns, region.always, everywhere=False)
            self.families.append((site, made))
            self._window_rows(site, made)
        self._cover_rows(site, region.columns, witnesses.covers)

    def _site(
        self, states: Ints, capability: str | None, first: int, last: int, *, cuts: bool
    ) -> SiteColumns:
        """Count columns for steps first..last and, with `cuts`, cumulative arrivals."""
        steps = np.arange(first, last + 1)
        present = self._draft.columns(len(steps))
        index, columns, constant = self._network.present_at(states, capability, steps)
        self._define(present, (index, columns), float(constant))
        if not cuts:
            return SiteColumns(first, present, present, present[:0])
        inside = present
        index, columns = self._network.between(states, capability, steps)
        if len(index):
            inside = self._draft.columns(len(steps))
            every = np.arange(len(steps))
            index = np.concatenate([index, every])
            self._define(inside, (index, np.concatenate([columns, present])), 0.0)
        arrived = self._draft.columns(len(steps))
        index, columns = self._network.entering(states, capability, steps)
        later = index > 0  # arrivals are counted from the first step on
        every = np.arange(1, len(steps))
        index = np.concatenate([index[later], every])
        self._define(arrived, (index, np.concatenate([columns[later], arrived[:-1]])), 0.0)
        return SiteColumns(first, present, inside, arrived)

    def _define(self, columns: Ints, parts: tuple[Ints, Ints], constant: float) -> None:
        """`columns[i]` = the columns that `parts` puts at position i, summed, + `constant`."""
        index, members = parts
        own = np.arange(len(columns))
        self._draft.rows(
            np.concatenate([own, index]),
            np.concatenate([columns, members]),
            np.concatenate([np.ones(len(columns)), np.full(len(members), -1.0)]),
            lower=np.full(len(columns), constant),
            upper=constant,
            kind="count",
        )

    def _demand_rows(self, site: SiteColumns, family: Family) -> None:
        """`n(tau) >= base + sum of surplus * literal` for every step of the family."""
        here = site.present[family.steps - site.first]
        row, columns, surplus = family.surplus(self._draft)
        index = np.concatenate([np.arange(len(here)), row])
        members = np.concatenate([here, columns])
        values = np.concatenate([np.ones(len(here)), -surplus])
        self._needs.add(index, members, values, family.base)

    def _window_rows(self, site: SiteColumns, family: Family) -> None:
        """Visit cuts of the family's whole window, of its beginnings and of its ends."""
        place = family.steps - site.first
        count = len(place) - 1
        if count < 1 or len(family.columns) < _SEVERAL:  # the demand itself says as much
            return
        ends, begins = np.arange(1, count + 1), np.arange(1, count)
        if self._lazy and len(place) > LONG:
            ends, begins = ends[-1:], begins[:0]
        low = np.concatenate([np.zeros_like(ends), begins])
        high = np.concatenate([ends, np.full_like(begins, count)])
        draft, late = self._draft, len(ends)
        row, columns, need = family.begun.over(draft, low[:late], high[:late])
        later, others, rest = family.ending.over(draft, low[late:], high[late:])
        low, high = place[low], place[high]
        every = np.arange(len(low))
        three = [site.inside[low], site.arrived[high], site.arrived[low]]
        self._visits.add(
            np.concatenate([every, every, every, row, later + late]),
            np.concatenate([*three, columns, others]),
            np.concatenate([np.repeat([1.0, 1.0, -1.0], len(low)), -need, -rest]),
            np.zeros(len(low)),
        )

    def _cover_rows(
        self, site: SiteColumns, asked: Mapping[int, Sequence[Run]], covers: Sequence[Cover]
    ) -> None:
        """Visit cuts of shared windows: if every witness asks for agents here, some must come."""
        edges: dict[int, tuple[_Edge, _Edge]] = {}
        for cover in covers:
            shared = cover.columns.tolist()
            if id(cover.columns) not in edges:
                runs = [asked.get(column) for column in shared]
                edges[id(cover.columns)] = (
                    _edge([(r[0].first, r[0].amount) if r else None for r in runs]),
                    _edge([(r[-1].last, r[-1].amount) if r else None for r in runs]),
                )
            members = slice(cover.begin, cover.end)
            # the first, then the last step at which a witness needs agents
            for steps, amounts in edges[id(cover.columns)]:
                if cover.begin < cover.end and amounts[members].all():
                    window = int(steps[members].min()), int(steps[members].max())
                    self._arrive(site, window, float(amounts[members].min()), cover.literal)

    def _arrive(
        self, site: SiteColumns, window: tuple[int, int], need: float, literal: Literal
    ) -> None:
        low, high = (step - site.first for step in window)
        ends = [site.inside[low], site.arrived[high], site.arrived[low]]
        self._visits.add(
            np.zeros(3 + len(literal), dtype=np.int64),
            [*ends, *literal],
            np.array([1.0, 1.0, -1.0, *([-need] * len(literal))]),
            np.array([0.0 if literal else need]),
        )

    def _limits(self, upper: Mapping[Place, Sequence[Lasting]], choices: Choices) -> None:
        """`n(tau) <= N - sum of (N - m_s) * literal_s`, N the most agents that can be there."""
        for (states, capability), needs in upper.items():
            site = np.array(states)
            most = self._network.most(site, capability)
            for made in self._families(_runs_of(needs, most), choices):
                index, here, constant = self._network.present_at(site, capability, made.steps)
                row, column, surplus = made.surplus(self._draft)
                self._draft.rows(
                    np.concatenate([index, row]),
                    np.concatenate([here, column]),
                    np.concatenate([np.ones(len(here)), surplus]),
                    lower=-np.inf,
                    upper=most[made.steps] - made.base - constant,
                    kind="limit",
                )

    def _families(self, asked: Mapping[int, Sequence[Run]], choices: Choices) -> list[Family]:
        """Demands at one site by exclusive literals; what holds in any case goes with the first."""
        columns = [column for column in asked if column != _ANYWAY]
        base = asked.get(_ANYWAY, ())
        groups = choices.families(columns) if self._joint else [[column] for column in columns]
        if base and not groups:
            groups = [[]]
        return [
            family(members, asked, base, everywhere=number == 0)
            for number, members in enumerate(groups)
        ]


def _edge(found: Sequence[tuple[int, float] | None]) -> _Edge:
    """Steps and amounts as arrays; 0 agents where there is nothing."""
    pairs = [pair or (0, 0.0) for pair in found]
    steps, amounts = zip(*pairs, strict=True) if pairs else ((), ())
    return np.array(steps, dtype=np.int64), np.array(amounts, dtype=np.float64)


def _runs_of(needs: Sequence[Lasting], most: Ints | None = None) -> dict[int, list[Run]]:
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
        for column in need.literal or (_ANYWAY,):
            asked[column] += [run for run in runs if run.amount > 0]
    return {column: apart(runs) for column, runs in asked.items() if runs}
