"""How long it takes from one witness to the next, where the same agents are needed for both.

A relay says that the second witness comes in a window after the first. If the first needs agents at
one place and the second at another, and together they need more than there are, somebody must go
from the one to the other: the second cannot come sooner than that takes. In whole points the flows
say so already; in the LP, where a little of every witness is served, they do not.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from tsplan.encode.count_atoms import Bound
from tsplan.encode.encoder_rules import Lasting, Witnesses
from tsplan.encode.flow_network import ClassGraph, Network
from tsplan.encode.selection import Relay, Relayed
from tsplan.milp.model import Draft, Ints


class Leg(NamedTuple):
    """`way` steps that somebody has to travel from the demand `first` to that of a relay."""

    relayed: Relayed
    first: Bound
    way: int


def legs_of(witnesses: Witnesses, network: Network) -> list[Leg]:
    """The ways that lie between the witnesses of relays, as far as they are sure."""
    needs: dict[int, list[Lasting]] = defaultdict(list)
    for need in witnesses.lasting:
        if len(need.literal) == 1 and not need.bound.upper:
            needs[need.literal[0]].append(need)
    found = []
    for relayed in witnesses.choices.relays:
        before = [needs.get(column, []) for column in relayed.waiting.columns.tolist()]
        after = [needs.get(column, []) for column in relayed.columns.tolist()]
        for first in _common(before):
            for second in _common(after):
                way = _way(first, second, network)
                if way and not _crossed(before, after, relayed.waiting):
                    _space_out(witnesses, relayed, _begins(before, after, relayed.waiting, way))
                    found.append(Leg(relayed, first, way))
    return found


def _space_out(witnesses: Witnesses, relayed: Relayed, begins: Ints) -> None:
    """Tighten the windows of a relay by the way between the places of its witnesses."""
    sooner = np.maximum(relayed.waiting.low, begins)
    if (sooner > relayed.waiting.low).any():
        # beginnings must not go back: a later parent's may be taken for an earlier one's
        witnesses.choices.not_before(relayed, np.minimum.accumulate(sooner[::-1])[::-1])


def route_rows(legs: Sequence[Leg], network: Network, draft: Draft) -> None:
    """What is travelled is at least the legs of a chain of relays together, from the start on.

    The legs of a chain lie one after the other, so their ways add up; in the LP, where a little of
    every witness is served from everywhere, they would not.
    """
    after = {int(leg.relayed.columns[0]): leg for leg in legs}
    followed = {id(before) for leg in legs if (before := _before(leg, after)) is not None}
    parts = [(item.unrolled(), item.graph) for item in network.classes]
    flows = np.concatenate([column for (_, _, column), _ in parts])
    spent = np.concatenate([(g.duration * ~g.wait)[edge] for (edge, _, _), g in parts])
    for last in legs:
        if id(last) in followed:
            continue
        chain = [last]
        while (before := _before(chain[-1], after)) is not None:
            chain.append(before)
        begun = chain[-1].relayed.waiting.columns
        asked = [(begun, _approach(chain[-1].first, network))]
        asked += [(leg.relayed.columns, leg.way) for leg in chain]
        columns = np.concatenate([flows, *(columns for columns, _ in asked)])
        values = [spent, *(np.full(len(columns), -float(way)) for columns, way in asked)]
        row = np.zeros(len(columns))
        draft.rows(row, columns, np.concatenate(values), lower=0.0, upper=np.inf, kind="route")


def _before(leg: Leg, after: Mapping[int, Leg]) -> Leg | None:
    """The leg whose witnesses are those that a leg's relay waits for."""
    return after.get(int(leg.relayed.waiting.columns[0]))


def _approach(first: Bound, network: Network) -> int:
    """Steps that somebody has to travel from the start to meet a demand."""
    able = network.having(first.capability)
    states = np.array(first.states)
    if sum(int(item.graph.start[states].sum()) for item in able) >= first.amount:
        return 0
    starts = [(item.graph, np.flatnonzero(item.graph.start)) for item in able]
    ways = []
    for graph, begun in starts:
        away = begun[~np.isin(begun, states)]
        if len(away):
            ways.append(_distance(graph, away.tolist(), first.states))
    return int(min([*ways, network.horizon + 1]))


def _common(needs: Sequence[Sequence[Lasting]]) -> list[Bound]:
    """What every column of a choice needs, if each needs one thing only."""
    bounds = {need.bound for mine in needs for need in mine}
    return list(bounds) if len(bounds) == 1 and all(len(mine) == 1 for mine in needs) else []


def _begins(
    before: Sequence[Sequence[Lasting]], after: Sequence[Sequence[Lasting]], relay: Relay, way: int
) -> Ints:
    """The first time at which the second witness may come, for each of the first ones."""
    shifts = _shifts(after, relay)
    return np.array([need.last + way - max(shifts) for (need,) in before], dtype=np.int64)


def _crossed(
    before: Sequence[Sequence[Lasting]], after: Sequence[Sequence[Lasting]], relay: Relay
) -> bool:
    """Whether the second witness may be needed before the first."""
    soonest = min(_shifts(after, relay))
    return any(relay.low[place] + soonest < need.first for place, (need,) in enumerate(before))


def _shifts(after: Sequence[Sequence[Lasting]], relay: Relay) -> list[int]:
    """Steps from each time of a relay to when its witness is needed."""
    return [need.first - time for (need,), time in zip(after, relay.times.tolist(), strict=True)]


def _way(first: Bound, second: Bound, network: Network) -> int:
    """Steps between two demands that not enough agents are there to meet apart; else 0."""
    if not set(first.states).isdisjoint(second.states):
        return 0
    able = [*network.having(first.capability), *network.having(second.capability)]
    team = {id(item): item.graph.agents for item in able}
    if first.amount + second.amount <= sum(team.values()):
        return 0
    both = [
        item
        for item in network.having(first.capability)
        if any(item is other for other in network.having(second.capability))
    ]
    ways = [_distance(item.graph, first.states, second.states) for item in both]
    return int(min([*ways, network.horizon + 1]))


def _distance(graph: ClassGraph, here: Sequence[int], there: Sequence[int]) -> float:
    """Fewest steps from one of some states to one of others."""
    return float(graph.lengths.nearest(here)[np.array(there)].min())
