"""Plans that change little: robots go on as they were to, and places have as many as planned.

A robot goes on as planned by taking every edge of its path, so as many of those of one path can as
the flows over its edges allow beside the others that do: what is left of the flows is a flow of the
others.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from fractions import Fraction

import numpy as np

from tsplan.encode.agent_classes import AgentClass
from tsplan.encode.encoded import Encoded, Setting
from tsplan.encode.executions import Executions
from tsplan.encode.flow_network import Network
from tsplan.encode.objective_kinds import TargetObjective
from tsplan.encode.planned_ways import Following
from tsplan.milp.model import INFINITY, Draft, Ints, Terms
from tsplan.milp.target import Target
from tsplan.mission import Rank, UnderWay
from tsplan.mission.intended_paths import Intended
from tsplan.plans.bundles import Bundle


@dataclass(frozen=True, eq=False)
class Keeping:
    """How many robots go on as intended, by a column, and the flow columns that they are among."""

    intended: Intended
    column: int
    entered: Ints


class Stability(TargetObjective):
    """How many robots do not go on as they were to."""

    name = "stability"

    def reducible(self, setting: Setting) -> bool:
        """A path is not any quick way between its ends."""
        return not setting.mission.intended

    def columns(
        self, setting: Setting, network: Network, executed: Executions, draft: Draft
    ) -> tuple[Keeping, ...]:
        """A column for every path, and rows by which the flows are enough for all that keep one."""
        made = []
        for number, item in enumerate(setting.classes):
            mine = intended_of(setting, item)
            kept = list(self._kept(setting, number, network, mine, draft))
            made += kept
            used = np.unique(np.concatenate([*(each.entered for each in kept), _NONE]))
            terms: list[Terms] = [(np.arange(len(used)), used, 1.0)]
            for each in kept:
                rows = np.searchsorted(used, each.entered)
                terms.append((rows, np.full(len(rows), each.column), -1.0))
            if len(used):
                draft.sums(*terms, count=len(used), kind="as intended")
        return tuple(made)

    def _kept(
        self,
        setting: Setting,
        number: int,
        network: Network,
        mine: Iterable[Intended],
        draft: Draft,
    ) -> Iterator[Keeping]:
        """The columns of the paths of a class that can be kept."""
        columns = network.classes[number]
        follow = Following(setting.classes[number].graph, setting.horizon, setting.arrays.number)
        for each in mine:
            rank = rank_of(setting, each)
            entries = follow.whole(setting.arrays.number[rank.place], path_of(rank, each))
            if entries is None:
                continue
            edges, steps = np.array(entries, dtype=np.int64).reshape(-1, 2).T
            there = (columns.first[edges] <= steps) & (steps <= columns.last[edges])
            if not there.all():
                continue
            (column,) = draft.columns(1, upper=float(each.names.size), integer=True)
            yield Keeping(each, int(column), columns.offset[edges] + steps - columns.first[edges])

    def target(self, setting: Setting, encoded: Encoded) -> Target:
        """All of them but those that do."""
        vector = np.zeros(encoded.model.size.columns)
        vector[[each.column for each in encoded.own_columns[self.name]]] = -1.0
        total = sum(each.names.size for each in setting.mission.intended)
        return Target(vector, constant=Fraction(total))


class Deviation(TargetObjective):
    """Steps at which fewer robots are at a state than were to be there, added up."""

    name = "deviation"

    def reducible(self, setting: Setting) -> bool:
        """States matter at which robots were to be."""
        return not setting.mission.intended

    def columns(
        self, setting: Setting, network: Network, executed: Executions, draft: Draft
    ) -> Ints:
        """Columns of how many are missing, at every state and step where somebody was to be."""
        missing = []
        asked = intended_counts(setting.mission.intended, setting.horizon)
        states = sorted({state for state, _ in asked})
        for state in states:
            steps = np.array(sorted(step for name, step in asked if name == state))
            most = np.array([asked[state, step] for step in steps.tolist()], dtype=np.float64)
            place = np.array([setting.arrays.number[state]])
            rows, columns, constant = network.present_at(place, None, steps, settled=False)
            own = draft.columns(len(steps), upper=most)
            terms = (rows, columns, 1.0), (np.arange(len(steps)), own, 1.0)
            least, none = most - constant, np.full(len(most), INFINITY)
            draft.sums(*terms, lower=least, upper=none, kind="as planned")
            missing.append(own)
        return np.concatenate([*missing, _NONE])

    def target(self, setting: Setting, encoded: Encoded) -> Target:
        """The sum of these columns."""
        vector = np.zeros(encoded.model.size.columns)
        vector[encoded.own_columns[self.name]] = 1.0
        return Target(vector)


_NONE = np.empty(0, dtype=np.int64)


def intended_counts(intended: Iterable[Intended], horizon: int) -> Counter[tuple[str, int]]:
    """How many were to be at each state and step."""
    found: Counter[tuple[str, int]] = Counter()
    for names, stays, _ in intended:
        for first, last, state in stays:
            for step in range(first, min(last, horizon) + 1):
                found[state, step] += names.size
    return found


def intended_of(setting: Setting, item: AgentClass) -> list[Intended]:
    """The paths that robots of a class were to take."""
    every = setting.mission.intended
    return [each for each in every if rank_of(setting, each).group in item.groups]


def rank_of(setting: Setting, each: Intended) -> Rank:
    """The rank that robots are of."""
    rank = setting.mission.roster.get(each.names.name())
    assert rank is not None
    return rank


def path_of(rank: Rank, each: Intended) -> Bundle:
    """The path that robots of a rank were to take."""
    coming = rank.start.origin if isinstance(rank.start, UnderWay) else None
    return Bundle(rank.class_name, rank.capabilities, each.stays, each.heading, coming=coming)
