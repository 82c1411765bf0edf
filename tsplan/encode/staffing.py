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

import numpy as np

from tsplan.encode.atoms import Site
from tsplan.encode.literals import ALWAYS, Choices
from tsplan.encode.network import Network
from tsplan.encode.together import Region, Together
from tsplan.encode.witness import Cover, Demand, Witnesses
from tsplan.milp.model import Block, Draft, Floats, Ints

_SEVERAL = 2


@dataclass(frozen=True, eq=False)
class Family:
    """Demands at one site by literals of which at most one is 1.

    `amount[t, j]` is what column `columns[j]` asks for at `steps[t]` (0: nothing), `base[t]` what
    is asked for in any case.
    """

    steps: Ints
    columns: Ints
    amount: Floats
    base: Floats

    @property
    def surplus(self) -> Floats:
        """What each column asks for beyond the base."""
        return np.maximum(self.amount - self.base[:, None], 0.0)


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

    def __init__(self, network: Network, draft: Draft, *, joint: bool = True) -> None:
        self._joint = joint
        self._network = network
        self._draft = draft
        self._needs = Block("staffing")
        self._visits = Block("visit")
        self.families: list[tuple[SiteColumns, Family]] = []

    def write(self, witnesses: Witnesses, *, cuts: bool, together: bool) -> None:
        """Rows for every demand; with `cuts` also visit cuts of windows and their parts.

        `together` adds what the demands of one witness at several places ask for as a whole.
        """
        lower: dict[tuple[Site, str | None], list[Demand]] = defaultdict(list)
        for demand in witnesses.demands:
            if not demand.bound.upper:
                lower[demand.bound.states, demand.bound.capability].append(demand)
        sites = {}
        for (states, capability), demands in lower.items():
            steps = [demand.step for demand in demands]
            site = self._site(np.array(states), capability, min(steps), max(steps), cuts=cuts)
            sites[states, capability] = site
            for family in self._families(demands, witnesses.choices):
                self.families.append((site, family))
                self._demand_rows(site, family)
                if cuts:
                    self._window_rows(site, family)
        if cuts:
            for key, demands in lower.items():
                self._cover_rows(sites[key], _asked(demands), witnesses.covers)
        if together:
            self._together(lower, witnesses, cuts=cuts)
        self._needs.write(self._draft)
        self._visits.write(self._draft)
        self._limits([d for d in witnesses.demands if d.bound.upper], witnesses.choices)

    def _together(
        self,
        lower: Mapping[tuple[Site, str | None], list[Demand]],
        witnesses: Witnesses,
        *,
        cuts: bool,
    ) -> None:
        """Rule out witnesses that need too many agents at once; visit cuts of whole regions."""
        able: dict[str | None, list[Demand]] = defaultdict(list)
        for (_, capability), demands in lower.items():
            able[capability] += demands
        for capability, demands in able.items():
            choices = witnesses.choices
            joint = Together(demands, choices)
            team = self._network.agents(capability)
            always, needed = joint.most()
            if max(always.values(), default=0) > team:
                choices.refute(ALWAYS, "together")
            for column, need in needed.items():
                if max(need.values(), default=0) > team:
                    choices.refute((column,), "together")
            for region in joint.regions() if cuts else ():
                self._region_rows(region, capability, witnesses)

    def _region_rows(self, region: Region, capability: str | None, witnesses: Witnesses) -> None:
        steps = {step for need in region.columns.values() for step in need}
        if len(steps) < _SEVERAL or self._network.horizon == 0:
            return
        site = self._site(np.array(region.states), capability, min(steps), max(steps), cuts=True)
        base = {step: float(n) for step, n in region.always.items() if step in steps}
        asked = {
            column: {step: float(n) for step, n in need.items()}
            for column, need in region.columns.items()
        }
        for columns in witnesses.choices.families(asked):
            family = _family(columns, asked, base)
            self.families.append((site, family))
            self._window_rows(site, family)
        self._cover_rows(site, asked, witnesses.covers)

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
        row, column = np.nonzero(family.surplus)
        index = np.concatenate([np.arange(len(here)), row])
        members = np.concatenate([here, family.columns[column]])
        values = np.concatenate([np.ones(len(here)), -family.surplus[row, column]])
        self._needs.add(index, members, values, family.base)

    def _window_rows(self, site: SiteColumns, family: Family) -> None:
        """Visit cuts of the family's whole window, of its beginnings and of its ends."""
        place = family.steps - site.first
        count = len(place) - 1
        if count < 1 or len(family.columns) < _SEVERAL:  # the demand itself says as much
            return
        begun = np.maximum.accumulate(family.amount)[1:]
        ending = np.maximum.accumulate(family.amount[::-1])[::-1][1:-1]
        low = np.concatenate([np.repeat(place[:1], count), place[1:-1]])
        high = np.concatenate([place[1:], np.repeat(place[-1:], count - 1)])
        need = np.concatenate([begun, ending])
        row, column = np.nonzero(need)
        every = np.arange(len(low))
        ends = [site.inside[low], site.arrived[high], site.arrived[low]]
        self._visits.add(
            np.concatenate([every, every, every, row]),
            np.concatenate([*ends, family.columns[column]]),
            np.concatenate([np.repeat([1.0, 1.0, -1.0], len(low)), -need[row, column]]),
            np.zeros(len(low)),
        )

    def _cover_rows(
        self, site: SiteColumns, asked: Mapping[int, Mapping[int, float]], covers: Sequence[Cover]
    ) -> None:
        """Visit cuts of shared windows: if every witness asks for agents here, some must come."""
        for cover in covers:
            if not all(column in asked for column in cover.columns):
                continue
            for edge in (min, max):  # the first, then the last step at which a witness needs agents
                times = [edge(asked[column]) for column in cover.columns]
                need = min(asked[c][k] for c, k in zip(cover.columns, times, strict=True))
                self._arrive(site, (min(times), max(times)), float(need), cover.literal)

    def _arrive(
        self, site: SiteColumns, window: tuple[int, int], need: float, literal: tuple[int, ...]
    ) -> None:
        low, high = (step - site.first for step in window)
        ends = [site.inside[low], site.arrived[high], site.arrived[low]]
        self._visits.add(
            np.zeros(3 + len(literal), dtype=np.int64),
            [*ends, *literal],
            np.array([1.0, 1.0, -1.0, *([-need] * len(literal))]),
            np.array([0.0 if literal else need]),
        )

    def _limits(self, demands: Sequence[Demand], choices: Choices) -> None:
        """`n(tau) <= N - sum of (N - m_s) * literal_s`, N the most agents that can be there."""
        grouped: dict[tuple[Site, str | None], list[Demand]] = defaultdict(list)
        for demand in demands:
            grouped[demand.bound.states, demand.bound.capability].append(demand)
        for (states, capability), members in grouped.items():
            site = np.array(states)
            most = self._network.most(site, capability)
            for family in self._families(members, choices, upper=most):
                index, here, constant = self._network.present_at(site, capability, family.steps)
                row, column = np.nonzero(family.surplus)
                self._draft.rows(
                    np.concatenate([index, row]),
                    np.concatenate([here, family.columns[column]]),
                    np.concatenate([np.ones(len(here)), family.surplus[row, column]]),
                    lower=-np.inf,
                    upper=most[family.steps] - family.base - constant,
                    kind="limit",
                )

    def _families(
        self, demands: Sequence[Demand], choices: Choices, upper: Ints | None = None
    ) -> list[Family]:
        """Demands at one site by exclusive literals; limits count what is taken from N."""
        base: dict[int, float] = defaultdict(float)
        asked: dict[int, dict[int, float]] = defaultdict(dict)
        for demand in demands:
            amount = float(demand.bound.amount)
            if upper is not None:
                amount = float(upper[demand.step]) - amount
            if amount <= 0:
                continue
            if not demand.literal:
                base[demand.step] = max(base[demand.step], amount)
            for column in demand.literal:
                mine = asked[column]
                mine[demand.step] = max(mine.get(demand.step, 0.0), amount)
        groups = choices.families(asked) if self._joint else [[column] for column in asked]
        return [_family(columns, asked, base) for columns in groups or ([[]] if base else [])]


def _asked(demands: Sequence[Demand]) -> dict[int, dict[int, float]]:
    """What each column asks for, by step."""
    asked: dict[int, dict[int, float]] = defaultdict(dict)
    for demand in demands:
        for column in demand.literal:
            mine = asked[column]
            mine[demand.step] = max(mine.get(demand.step, 0.0), float(demand.bound.amount))
    return asked


def _family(
    columns: Sequence[int], asked: dict[int, dict[int, float]], base: dict[int, float]
) -> Family:
    steps = sorted({step for column in columns for step in asked[column]} | set(base))
    position = {step: index for index, step in enumerate(steps)}
    amount = np.zeros((len(steps), len(columns)))
    for place, column in enumerate(columns):
        for step, value in asked[column].items():
            amount[position[step], place] = value
    return Family(
        steps=np.array(steps, dtype=np.int64),
        columns=np.array(columns, dtype=np.int64),
        amount=amount,
        base=np.array([base.get(step, 0.0) for step in steps]),
    )
