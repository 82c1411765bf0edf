"""Swarms in a model: columns of their groups, and the rows that tie agents to them.

`occupied_rows` only knows where groups are: a relaxation, in which who asks for more than one agent
asks for one, and sizes are not looked at. `size_rows` tie the flows of a swarm's agents to its
groups; with the rows of the formula over these flows they are the whole problem.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from tsplan.encode.agent_classes import AgentClass
from tsplan.encode.atom_encoders import Bound
from tsplan.encode.capability_mask import is_counted
from tsplan.encode.class_columns import ClassColumns
from tsplan.encode.demand_rows import DemandRows
from tsplan.encode.flow_network import Network
from tsplan.encode.groups.group_demands import (
    group_network,
    most_groups,
    only_of,
    presence_rows,
    split_rows,
)
from tsplan.encode.groups.occupancy import Occupancy, bound_groups, occupancy, split_terms
from tsplan.encode.selection import Selection
from tsplan.encode.witness import Demand, Witnesses
from tsplan.milp.model import Draft, Floats, Ints
from tsplan.mission import SwarmBounds


@dataclass(frozen=True, eq=False)
class Swarm:
    """A class that moves in groups: where these are and, in a whole model, its agents' flows.

    `number` is the position of the class among all.
    """

    number: int
    bounds: SwarmBounds
    places: Occupancy
    agents: ClassColumns | None = None

    @property
    def flows(self) -> ClassColumns:
        """The flows of the agents, which a whole model has."""
        assert self.agents is not None
        return self.agents

    @property
    def size(self) -> int:
        """How many agents the swarm has."""
        return self.places.entered.graph.agents

    def counts(self, bound: Bound) -> bool:
        """Whether a bound is about the agents of this swarm."""
        return is_counted(bound.capability, self.places.entered.graph.capabilities)


def swarms_of(
    classes: Sequence[AgentClass], together: int | None, horizon: int, draft: Draft
) -> tuple[Swarm, ...]:
    """Columns of the groups of every swarm, at most as many at a step as their bounds say."""
    swarms = tuple(
        Swarm(number, item.bounds, occupancy(item.graph, horizon, draft))
        for number, item in enumerate(classes)
        if item.bounds is not None
    )
    for swarm in swarms:
        if swarm.bounds.most is not None:
            bound_groups([swarm.places], swarm.bounds.most, draft)
    if swarms and together is not None:
        bound_groups([swarm.places for swarm in swarms], together, draft)
    return swarms


# --- where groups are ----------------------------------------------------------------------------


def occupied_rows(
    swarms: Sequence[Swarm],
    robots: Network,
    together: int | None,
    witnesses: Witnesses,
    draft: Draft,
) -> DemandRows:
    """Where the formula wants agents there is a group or robot; where it wants none, no group."""
    entered = [swarm.places.entered for swarm in swarms]
    most = [most_groups(swarm.size, swarm.bounds, together) for swarm in swarms]
    rows = presence_rows(group_network(entered, most, robots), witnesses, draft)
    for demand in witnesses.stepwise:
        if demand.bound.upper and demand.bound.amount == 0:
            _forbid(draft, _at_site(swarms, demand), demand.selection)
        elif not demand.bound.upper and demand.bound.amount > 1:
            _forbid(draft, _left_over(swarms, robots, demand), demand.selection)
    begin = sum(int((columns.graph.start > 0).sum()) for columns in entered)
    splits = split_terms([swarm.places for swarm in swarms])
    split_rows(splits, begin, only_of(witnesses, robots), draft)
    return rows


def served_rows(
    swarms: Sequence[Swarm], robots: Network, witnesses: Witnesses, draft: Draft
) -> None:
    """A demand that only swarms can meet has one of its states occupied where it is met.

    The entered edges say so of whole points, but where a group splits they count it twice in the
    LP; of demands that need not be met all, it would meet more than there can be groups.
    """
    for demand in only_of(witnesses, robots).stepwise:
        if demand.bound.upper or demand.bound.amount <= 0 or not demand.selection:
            continue
        there = _at_site(swarms, demand)
        draft.sums((0, there, 1.0), (0, demand.selection, -1.0), kind="served")


def _at_site(swarms: Sequence[Swarm], demand: Demand) -> Ints:
    """Columns of groups at the states of a demand, at its step."""
    states = np.array(demand.bound.states, dtype=np.int64)
    found = [
        swarm.places.at(there, np.full(len(there), demand.step))
        for swarm in swarms
        if swarm.counts(demand.bound)
        for there in [states[swarm.places.entered.arrival[states] <= demand.step]]
    ]
    return np.concatenate([*found, np.empty(0, dtype=np.int64)])


def _left_over(swarms: Sequence[Swarm], robots: Network, demand: Demand) -> Ints:
    """Columns of groups elsewhere of which too few agents for a sub-swarm would be left over."""
    able = [swarm for swarm in swarms if swarm.counts(demand.bound)]
    total = sum(swarm.size for swarm in able) + robots.agents(demand.bound.capability)
    inside = np.array(demand.bound.states)
    found = []
    for swarm in able:
        if total - demand.bound.amount >= swarm.bounds.least:
            continue
        state, step, own = swarm.places.reached()
        elsewhere = (step == demand.step) & ~np.isin(state, inside)
        when, between = swarm.places.inside()
        found += [own[elsewhere], between[when == demand.step]]
    return np.concatenate([*found, np.empty(0, dtype=np.int64)])


def _forbid(draft: Draft, columns: Ints, selection: Selection) -> None:
    """The columns are 0 where the selection is 1."""
    every = np.arange(len(columns))
    draft.sums(
        (every, columns, 1.0),
        *((every, column, 1.0) for column in selection),
        lower=-np.inf,
        upper=1.0 if selection else 0.0,
        count=len(every),
        kind="empty",
    )


# --- how many agents groups have -----------------------------------------------------------------


def counted(swarms: Sequence[Swarm], robots: Network, witnesses: Witnesses) -> Witnesses:
    """The demands on agents: whoever of a swarm is at a state is a sub-swarm there."""
    needs = []
    for need in witnesses.demands:
        bound = need.bound
        if not bound.upper and bound.amount <= 0:
            continue
        able = [swarm.bounds.least for swarm in swarms if swarm.counts(bound)]
        if not bound.upper and able and not robots.having(bound.capability):
            bound = replace(bound, amount=max(bound.amount, min(able)))
        needs.append(replace(need, bound=bound))
    return Witnesses(witnesses.choices, needs)


def size_rows(swarms: Sequence[Swarm], draft: Draft) -> None:
    """Agents are where their groups are, and every group has at least as many as it must."""
    for swarm in swarms:
        edge, _, flow = swarm.flows.unrolled()
        _, _, group = swarm.places.entered.unrolled()
        long = swarm.flows.graph.duration[edge] > 1
        least = float(swarm.bounds.least)
        _between(draft, flow, group, np.where(long, least, 1.0), float(swarm.size))
        if least > 1:
            _least_at_states(draft, swarm)


def _between(draft: Draft, flow: Ints, group: Ints, least: Floats, most: float) -> None:
    """`least * group <= flow <= most * group`."""
    every = np.arange(len(flow))
    draft.sums((every, flow, 1.0), (every, group, -least), count=len(every), kind="size")
    draft.sums((every, flow, -1.0), (every, group, most), count=len(every), kind="size")


def agents_at_states(swarm: Swarm) -> tuple[Ints, Ints]:
    """Entries of the counts at all that `places.reached` lists: their positions there, and columns.

    Agents at a state leave it by some edge, or have arrived at the horizon.
    """
    places = swarm.places
    edge, step, flow = swarm.flows.unrolled()
    graph = swarm.flows.graph
    end = step + graph.duration[edge]
    last = end == places.horizon
    tails = places.position(graph.tail[edge], step)
    heads = places.position(graph.head[edge][last], end[last])
    return np.concatenate([tails, heads]), np.concatenate([flow, flow[last]])


def _least_at_states(draft: Draft, swarm: Swarm) -> None:
    """An occupied state holds at least the smallest sub-swarm."""
    least, start = swarm.bounds.least, swarm.places.entered.graph.start
    if swarm.places.horizon == 0:  # the starts are all there is
        if (start[start > 0] < least).any():
            draft.sums(lower=1.0, upper=1.0, kind="size")
        return
    own = swarm.places.reached()[2]
    groups = np.arange(len(own)), own, -float(least)
    draft.sums((*agents_at_states(swarm), 1.0), groups, count=len(own), kind="size")
