"""Rows of missions over expected numbers: demands on real counts, and policies without chance.

Where a selection w is 1, `f - rho >= b` for a count or its negative f. Options that exclude each
other share one row for their site and step (`tsplan.encode.shared_rows`).

Source: occupation measures of constrained Markov decision processes: E. Altman, "Constrained
Markov Decision Processes", 1999, chapter 2, with a finite horizon.
"""

from __future__ import annotations

from typing import TypeAlias

import numpy as np

from tsplan.encode.atom_encoders import Bound, Site
from tsplan.encode.class_columns import ClassColumns
from tsplan.encode.encoder_rules import Witnesses
from tsplan.encode.flow_network import Network
from tsplan.encode.shared_rows import ANYWAY, amounts, shared_rows
from tsplan.milp.model import INFINITY, Draft, Ints
from tsplan.mission import Expectation

Place: TypeAlias = tuple[Site, str | None, bool]
"""States, a capability, and whether agents are bounded from above there."""


def expected_rows(
    witnesses: Witnesses, network: Network, draft: Draft, rho: tuple[int, float] | None = None
) -> None:
    """Rows for all demands, with `rho` (its column, and the most that it can be) to spare."""
    best: dict[int, float] = {}
    for (states, capability, upper), steps in amounts(witnesses, _placed).items():
        site, sign = np.array(states, dtype=np.int64), -1.0 if upper else 1.0
        most, none = network.best(site, capability), np.zeros(network.horizon + 1)
        least, most = (-most, none) if upper else (none, most)
        for step, asked in steps.items():
            columns, constant = network.present(site, capability, step)
            terms = [(0, columns, sign)]
            low = float(least[step])
            if rho is not None:
                terms.append((0, np.array([rho[0]]), -1.0))
                low -= rho[1]
            for column, amount in asked.items():
                if column != ANYWAY:
                    best[column] = min(best.get(column, np.inf), float(most[step]) - amount)
            for base, beyond in shared_rows(asked, low, witnesses.choices.families):
                chosen = (0, list(beyond), -np.array(list(beyond.values())))
                draft.sums(*terms, chosen, lower=base - sign * constant, kind="demand")
    if rho is not None:
        _outlook(best, witnesses, draft, rho)


def _outlook(
    best: dict[int, float], witnesses: Witnesses, draft: Draft, rho: tuple[int, float]
) -> None:
    """Where a column is 1, `rho` is no more than what it asks for can be exceeded by at best."""
    column, most = rho
    for family in witnesses.choices.families(best):
        less = {c: most - best[c] for c in family if best[c] < most}
        if less:
            terms = (0, [column], 1.0), (0, list(less), np.array(list(less.values())))
            draft.sums(*terms, lower=-INFINITY, upper=most, kind="outlook")


def _placed(bound: Bound) -> tuple[Place, float]:
    """Where a bound on a count asks, and for how much of the count or its negative."""
    place = (bound.states, bound.capability, bound.upper)
    return place, float(-bound.amount if bound.upper else bound.amount)


def policy_rows(expected: Expectation | None, network: Network, draft: Draft) -> Ints:
    """For policies without chance: one action for every state and step; the columns that say so."""
    if expected is None or not expected.deterministic:
        return np.empty(0, dtype=np.int64)
    parts = [_decided(item, draft) for item in network.classes]
    return np.concatenate([*parts, np.empty(0, dtype=np.int64)])


def _decided(item: ClassColumns, draft: Draft) -> Ints:
    """A 0/1 column for every action and step where there are several, of which one is 1."""
    edge, step, column = item.unrolled()
    _, node, times = np.unique(
        item.graph.tail[edge] * (int(step.max(initial=0)) + 1) + step,
        return_inverse=True,
        return_counts=True,
    )
    several = np.flatnonzero(times[node] > 1)
    chosen = draft.columns(len(several), upper=1.0, integer=True)
    every = np.arange(len(several))
    agents = float(item.graph.agents)
    draft.sums(
        (every, column[several], 1.0),
        (every, chosen, -agents),
        lower=-INFINITY,
        upper=np.zeros(len(several)),
        kind="policy",
    )
    places = np.searchsorted(np.flatnonzero(times > 1), node[several])
    count = int((times > 1).sum())
    one = np.ones(count)
    if count:
        draft.sums((places, chosen, 1.0), lower=one, upper=one, kind="policy")
    return chosen
