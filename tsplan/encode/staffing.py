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
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from tsplan.encode.atoms import Site
from tsplan.encode.literals import Choices
from tsplan.encode.network import Network
from tsplan.encode.witness import Cover, Demand, Witnesses
from tsplan.milp.model import Draft, Floats, Ints


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
    """Count and cumulative arrival columns of a site; step k is at position k - first."""

    first: int
    present: Ints
    arrived: Ints


class Staffing:
    """Writes the rows of all demands, and keeps what is needed to separate more visit cuts."""

    def __init__(self, network: Network, draft: Draft, *, joint: bool = True) -> None:
        self._joint = joint
        self._network = network
        self._draft = draft
        self.families: list[tuple[SiteColumns, Family]] = []

    def write(self, witnesses: Witnesses, *, cuts: bool) -> None:
        """Rows for every demand; with `cuts` also visit cuts of windows and their parts."""
        lower: dict[tuple[Site, str | None], list[Demand]] = defaultdict(list)
        for demand in witnesses.demands:
            if demand.bound.upper:
                continue
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
                    self._window_rows(site, family, _windows(family))
        if cuts:
            for key, demands in lower.items():
                self._cover_rows(sites[key], demands, witnesses.covers)
        self._limits([d for d in witnesses.demands if d.bound.upper], witnesses.choices)

    def _site(
        self, states: Ints, capability: str | None, first: int, last: int, *, cuts: bool
    ) -> SiteColumns:
        """Count columns for steps first..last and, with `cuts`, cumulative arrivals."""
        steps = range(first, last + 1)
        present = self._draft.columns(len(steps))
        here = [self._network.present(states, capability, step) for step in steps]
        self._define(present, [c for c, _ in here], np.array([k for _, k in here], dtype=float))
        arrived = np.empty(0, dtype=np.int64)
        if cuts:
            arrived = self._draft.columns(len(steps))
            able = self._network.having(capability)
            came = [
                np.concatenate([item.moved_in(states, step) for item in able] or [present[:0]])
                for step in steps
            ]
            came[0] = present[:0]
            followed = [np.append(c, arrived[i - 1 : i]) for i, c in enumerate(came)]
            followed[0] = present[:0]
            self._define(arrived, followed, np.zeros(len(steps)))
        return SiteColumns(first, present, arrived)

    def _define(self, columns: Ints, parts: Sequence[Ints], constant: Floats) -> None:
        """`columns[i]` = sum of the columns `parts[i]` + `constant[i]`."""
        sizes = [len(part) for part in parts]
        index = np.concatenate([np.arange(len(columns)), np.repeat(np.arange(len(columns)), sizes)])
        members = np.concatenate([columns, *parts])
        values = np.concatenate([np.ones(len(columns)), np.full(sum(sizes), -1.0)])
        self._draft.rows(index, members, values, lower=constant, upper=constant, kind="count")

    def _demand_rows(self, site: SiteColumns, family: Family) -> None:
        """`n(tau) >= base + sum of surplus * literal` for every step of the family."""
        here = site.present[family.steps - site.first]
        row, column = np.nonzero(family.surplus)
        index = np.concatenate([np.arange(len(here)), row])
        members = np.concatenate([here, family.columns[column]])
        values = np.concatenate([np.ones(len(here)), -family.surplus[row, column]])
        self._draft.rows(index, members, values, lower=family.base, upper=np.inf, kind="staffing")

    def _window_rows(
        self, site: SiteColumns, family: Family, windows: Sequence[tuple[int, int]]
    ) -> None:
        """Visit cuts of the family over windows given as positions in its steps."""
        for low, high in windows:
            self.visit(site, family, low, high)

    def visit(self, site: SiteColumns, family: Family, low: int, high: int) -> None:
        """One visit cut: positions low..high of the family's steps."""
        need = family.amount[low : high + 1].max(axis=0)
        asked = np.flatnonzero(need)
        begin = family.steps[low] - site.first
        end = family.steps[high] - site.first
        members = [site.present[begin], site.arrived[end], site.arrived[begin]]
        values = [1.0, 1.0, -1.0]
        self._draft.rows(
            np.zeros(3 + len(asked), dtype=np.int64),
            np.concatenate([members, family.columns[asked]]),
            np.concatenate([values, -need[asked]]),
            lower=0.0,
            upper=np.inf,
            kind="visit",
        )

    def _cover_rows(
        self, site: SiteColumns, demands: Sequence[Demand], covers: Sequence[Cover]
    ) -> None:
        """Visit cuts of shared windows: if every witness asks for agents here, some must come."""
        asked: dict[int, dict[int, int]] = defaultdict(dict)
        for demand in demands:
            for column in demand.literal:
                mine = asked[column]
                mine[demand.step] = max(mine.get(demand.step, 0), demand.bound.amount)
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
        self._draft.rows(
            np.zeros(3 + len(literal), dtype=np.int64),
            [site.present[low], site.arrived[high], site.arrived[low], *literal],
            [1.0, 1.0, -1.0, *([-need] * len(literal))],
            lower=0.0 if literal else need,
            upper=np.inf,
            kind="visit",
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
                parts = [self._network.present(site, capability, int(k)) for k in family.steps]
                sizes = [len(columns) for columns, _ in parts]
                row, column = np.nonzero(family.surplus)
                self._draft.rows(
                    np.concatenate([np.repeat(np.arange(len(parts)), sizes), row]),
                    np.concatenate([*(c for c, _ in parts), family.columns[column]]),
                    np.concatenate([np.ones(sum(sizes)), family.surplus[row, column]]),
                    lower=-np.inf,
                    upper=most[family.steps] - family.base - [k for _, k in parts],
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


def _windows(family: Family) -> list[tuple[int, int]]:
    """Positions of the whole window, its beginnings and its ends."""
    if not len(family.columns):
        return []
    last = len(family.steps) - 1
    return [(0, high) for high in range(1, last + 1)] + [(low, last) for low in range(1, last)]
