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

from tsplan.encode.atom_encoders import Bound
from tsplan.encode.encoder_rules import Demand, Witnesses
from tsplan.encode.flow_network import Network
from tsplan.encode.rivals.travel_gaps import gaps_between
from tsplan.encode.selection import Relayed
from tsplan.milp.model import Draft, Ints


class Leg(NamedTuple):
    """`way` steps that somebody has to travel from the demand `first` to that of a relay."""

    relayed: Relayed
    first: Bound
    way: int


def placed(network: Network) -> bool:
    """Whether a state where somebody is needed is one node of every class's map."""
    modes = [item.graph.modes for item in network.classes]
    return not any(each is not None and each.recent.any() for each in modes)


def direct(network: Network) -> bool:
    """Whether that is so, and who serves in one class serves in none besides.

    Modules serve in several classes.
    """
    return placed(network) and all(item.graph.layer is None for item in network.classes)


def legs_of(witnesses: Witnesses, network: Network) -> list[Leg]:
    """The ways that lie between the witnesses of relays, as far as they are sure."""
    needs: dict[int, list[Demand]] = defaultdict(list)
    for need in witnesses.demands:
        if len(need.selection) == 1 and not need.bound.upper:
            needs[need.selection[0]].append(need)
    pairs = [
        (relayed, before, after)
        for relayed in witnesses.choices.relays
        if (before := _alike(needs, relayed.waiting.columns))
        and (after := _alike(needs, relayed.columns))
    ]
    bounds = list(dict.fromkeys(need.bound for _, *both in pairs for need, *_ in both))
    number = {bound: place for place, bound in enumerate(bounds)}
    ways = gaps_between(bounds, network)
    found = []
    for relayed, before, after in pairs:
        low, times = relayed.waiting.low, relayed.waiting.times
        shifts = np.array([need.first for need in after]) - times
        way = int(ways[number[before[0].bound], number[after[0].bound]])
        # the second witness must not be needed before the first
        if way and (low + shifts.min() >= [need.first for need in before]).all():
            begins = np.array([need.last for need in before]) + way - shifts.max()
            _space_out(witnesses, relayed, np.maximum(low, begins))
            found.append(Leg(relayed, before[0].bound, way))
    return found


def _alike(needs: Mapping[int, Sequence[Demand]], columns: Ints) -> list[Demand]:
    """What each column of a choice needs, if each needs one thing only and all the same."""
    every = [needs.get(column, ()) for column in columns.tolist()]
    alike = all(len(mine) == 1 for mine in every) and len({n.bound for (n,) in every}) == 1
    return [need for (need,) in every] if alike else []


def _space_out(witnesses: Witnesses, relayed: Relayed, sooner: Ints) -> None:
    """Tighten the windows of a relay by the way between the places of its witnesses."""
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
    travel = []
    for item in network.classes:
        edge, _, column = item.unrolled()
        travel.append((0, column, item.graph.travel[edge]))
    for last in legs:
        if id(last) in followed:
            continue
        chain = [last]
        while (before := _before(chain[-1], after)) is not None:
            chain.append(before)
        begun = chain[-1].relayed.waiting.columns
        asked = [(0, begun, -_approach(chain[-1].first, network))]
        asked += [(0, leg.relayed.columns, -leg.way) for leg in chain]
        draft.sums(*travel, *asked, kind="route")


def _before(leg: Leg, after: Mapping[int, Leg]) -> Leg | None:
    """The leg whose witnesses are those that a leg's relay waits for."""
    return after.get(int(leg.relayed.waiting.columns[0]))


def _approach(first: Bound, network: Network) -> int:
    """Steps that somebody has to travel from the start to meet a demand."""
    able = [item.graph for item in network.having(first.capability)]
    states = np.array(first.states)
    if sum(int(graph.landed[states].sum()) for graph in able) >= first.amount:
        return 0
    ways = [network.horizon + 1.0]
    for graph in able:
        away = np.setdiff1d(np.flatnonzero(graph.landed), states)
        if len(away):
            ways.append(graph.lengths.nearest(away)[states].min())
    return int(min(ways))
