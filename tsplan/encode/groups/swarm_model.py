"""The two models of a swarm mission: who is where, and how many.

`occupied` only knows which states and edges hold agents. It is a relaxation: atoms that ask for
more than one agent ask it for one, and sizes are not looked at. `counted` is the whole problem; it
adds a flow of agents per swarm, so its first columns are those of `occupied`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from tsplan.encode.agent_classes import MapArrays, map_arrays
from tsplan.encode.assemble import Encoded
from tsplan.encode.capacities import capacity_rows
from tsplan.encode.count_atoms import Bound
from tsplan.encode.demand_rows import SiteColumns, Staffing
from tsplan.encode.demand_runs import Family
from tsplan.encode.flow_network import ClassColumns, Network, unroll
from tsplan.encode.groups.group_demands import (
    Wanting,
    group_network,
    most_groups,
    presence_rows,
    split_rows,
    swarm_graphs,
    witnesses_of,
)
from tsplan.encode.groups.occupancy import Occupancy, bound_groups, occupancy, split_terms
from tsplan.encode.memory import Watch
from tsplan.encode.selection import Literal
from tsplan.encode.witness import Demand, Witnesses
from tsplan.milp.model import Draft, Floats, Ints
from tsplan.mission import Mission
from tsplan.mission.mission import SwarmBounds
from tsplan.search.clock import Clock


class EdgeFlows(NamedTuple):
    """Agents that enter edges: the edges' ends, the steps, and how many agents."""

    tail: Ints
    head: Ints
    step: Ints
    agents: Ints


@dataclass(frozen=True, eq=False)
class SwarmModel:
    """Both models, and what their columns mean; `agents` are the flows of `counted`."""

    swarms: tuple[Occupancy, ...]
    agents: Network
    occupied: Encoded
    counted: Encoded
    names: tuple[str, ...]


def moves_of(agents: Network, point: Floats) -> list[EdgeFlows]:
    """Where the agents of each swarm go in a point of a counted model, waits included."""
    found = []
    for item in agents.classes:
        edge, step, column = item.unrolled()
        count = np.round(point[column]).astype(np.int64)
        some = np.flatnonzero(count)
        tail, head = item.graph.tail[edge[some]], item.graph.head[edge[some]]
        found.append(EdgeFlows(tail, head, step[some], count[some]))
    return found


@dataclass(frozen=True, eq=False)
class _Plot:
    """What is being drafted."""

    mission: Mission
    arrays: MapArrays
    bounds: tuple[SwarmBounds, ...]
    draft: Draft


def swarm_model(
    mission: Mission, wanting: Wanting | None = None, clock: Clock | None = None
) -> SwarmModel:
    """Encode a mission of swarms, or what is wanted in place of its goal.

    Raises Halted when the clock is over, or the model would not fit in memory.
    """
    graphs = swarm_graphs(mission)
    rules = mission.swarm
    assert rules is not None
    plot = _Plot(
        mission,
        map_arrays(mission.system),
        tuple(rules.each[group.class_name] for group in mission.team),
        Draft(Watch(clock or Clock())),
    )
    swarms = tuple(occupancy(graph, mission.horizon, plot.draft) for graph in graphs)
    _bound(plot, swarms, rules.together)
    laid = [swarm.entered for swarm in swarms]
    witnesses = witnesses_of(mission, laid, plot.draft, wanting)
    groups = group_network(laid, most_groups(mission), mission.horizon)
    staffing = _occupied_rows(plot, groups, swarms, witnesses)
    if wanting is not None:
        _served_rows(plot, swarms, witnesses)
    entered = np.concatenate([swarm.entered.unrolled()[2] for swarm in swarms])
    occupied = _encoded(plot, groups, swarms, witnesses, staffing.families, entered)
    before = plot.draft.column_count
    agents = unroll(graphs, mission.horizon, plot.draft)
    flows = np.arange(before, plot.draft.column_count)
    counting = _counted_rows(plot, agents, swarms, witnesses)
    families = [*staffing.families, *counting.families]
    counted = _encoded(plot, groups, swarms, witnesses, families, flows)
    return SwarmModel(swarms, agents, occupied, counted, plot.arrays.names)


def _served_rows(plot: _Plot, swarms: Sequence[Occupancy], witnesses: Witnesses) -> None:
    """A demand that is met has one of its states occupied.

    The entered edges say so of whole points, but where a group splits they count it twice in the
    LP; of demands that need not be met all, it would meet more than there can be groups.
    """
    for demand in witnesses.demands:
        if demand.bound.upper or demand.bound.amount <= 0 or not demand.literal:
            continue
        states = np.array(demand.bound.states, dtype=np.int64)
        there = [
            swarm.at(here, np.full(len(here), demand.step))
            for swarm in swarms
            if _counts(demand.bound, swarm)
            for here in [states[swarm.entered.arrival[states] <= demand.step]]
        ]
        columns = np.concatenate([*there, np.array(demand.literal, dtype=np.int64)])
        values = np.where(np.arange(len(columns)) < len(columns) - len(demand.literal), 1.0, -1.0)
        plot.draft.rows(
            np.zeros(len(columns)), columns, values, lower=np.zeros(1), upper=np.inf, kind="served"
        )


def _bound(plot: _Plot, swarms: Sequence[Occupancy], together: int | None) -> None:
    for swarm, bounds in zip(swarms, plot.bounds, strict=True):
        if bounds.most is not None:
            bound_groups([swarm], bounds.most, plot.draft)
    if together is not None:
        bound_groups(swarms, together, plot.draft)


def _occupied_rows(
    plot: _Plot, groups: Network, swarms: Sequence[Occupancy], witnesses: Witnesses
) -> Staffing:
    """Where the formula wants agents there is some group, where it wants none there is none."""
    staffing = presence_rows(groups, witnesses, plot.draft)
    for demand in witnesses.demands:
        if demand.bound.upper and demand.bound.amount <= 0:
            _empty(plot, swarms, demand)
        elif not demand.bound.upper and demand.bound.amount > 1:
            _nobody_else(plot, swarms, demand)
    begin = sum(int((swarm.entered.graph.start > 0).sum()) for swarm in swarms)
    split_rows(split_terms(swarms), begin, witnesses, plot.draft)
    return staffing


def _nobody_else(plot: _Plot, swarms: Sequence[Occupancy], demand: Demand) -> None:
    """Too few agents for a sub-swarm are left over: no group is anywhere else."""
    able = [swarm for swarm in swarms if _counts(demand.bound, swarm)]
    each = dict(zip(map(id, swarms), plot.bounds, strict=True))
    total = sum(swarm.entered.graph.agents for swarm in able)
    inside = np.array(demand.bound.states)
    found = []
    for swarm in able:
        if total - demand.bound.amount >= each[id(swarm)].least:
            continue
        state, step, own = swarm.reached()
        elsewhere = (step == demand.step) & ~np.isin(state, inside)
        when, between = swarm.inside()
        found += [own[elsewhere], between[when == demand.step]]
    _forbid(plot.draft, np.concatenate([*found, np.empty(0, dtype=np.int64)]), demand.literal)


def _empty(plot: _Plot, swarms: Sequence[Occupancy], demand: Demand) -> None:
    """No group at the demand's states where its literal is 1."""
    if demand.bound.amount < 0:
        return
    found = [
        swarm.at(states, np.full(len(states), demand.step))
        for swarm in swarms
        if _counts(demand.bound, swarm)
        for states in [np.array(demand.bound.states)]
        for states in [states[swarm.entered.arrival[states] <= demand.step]]
    ]
    columns = np.concatenate([*found, np.empty(0, dtype=np.int64)])
    _forbid(plot.draft, columns, demand.literal)


def _forbid(draft: Draft, columns: Ints, literal: Literal) -> None:
    """The columns are 0 where the literal is 1."""
    count, members = len(columns), np.array(literal, dtype=np.int64)
    draft.rows(
        np.concatenate([np.arange(count), np.repeat(np.arange(count), len(members))]),
        np.concatenate([columns, np.tile(members, count)]),
        1.0,
        lower=-np.inf,
        upper=np.full(count, 1.0 if literal else 0.0),
        kind="empty",
    )


def _counts(bound: Bound, swarm: Occupancy) -> bool:
    able = swarm.entered.graph.capabilities
    return bound.capability is None or bound.capability in able


def _counted_rows(
    plot: _Plot, agents: Network, swarms: Sequence[Occupancy], witnesses: Witnesses
) -> Staffing:
    """Agents are where their groups are, and as many as the formula and the bounds want."""
    capacity_rows(agents, plot.arrays, plot.draft)
    smallest = min(bounds.least for bounds in plot.bounds)
    counted = [
        need
        if need.bound.upper
        # whoever is at a state is a sub-swarm there
        else replace(need, bound=replace(need.bound, amount=max(need.bound.amount, smallest)))
        for need in witnesses.lasting
        if need.bound.upper or need.bound.amount > 0
    ]
    staffing = Staffing(agents, plot.draft)
    staffing.write(Witnesses(witnesses.choices, counted), cuts=True, together=True)
    for item, swarm, bounds in zip(agents.classes, swarms, plot.bounds, strict=True):
        edge, _, flow = item.unrolled()
        _, _, group = swarm.entered.unrolled()
        long = item.graph.duration[edge] > 1
        size = float(item.graph.agents)
        _between(plot.draft, flow, group, np.where(long, float(bounds.least), 1.0), size)
        if bounds.least > 1:
            _least_at_states(plot, item, swarm, bounds)
    return staffing


def _between(draft: Draft, flow: Ints, group: Ints, least: Floats, most: float) -> None:
    """`least * group <= flow <= most * group`."""
    count = len(flow)
    for sign, factor in ((1.0, least), (-1.0, np.full(count, most))):
        draft.rows(
            np.tile(np.arange(count), 2),
            np.concatenate([flow, group]),
            np.concatenate([np.full(count, sign), -sign * factor]),
            lower=np.zeros(count),
            upper=np.inf,
            kind="size",
        )


def agents_at_states(item: ClassColumns, swarm: Occupancy) -> tuple[Ints, Ints]:
    """Entries of the counts at all that `swarm.reached` lists: their places there, and columns.

    Agents at a state leave it by some edge, or have arrived at the horizon.
    """
    edge, step, flow = item.unrolled()
    end = step + item.graph.duration[edge]
    last = end == swarm.horizon
    tails = swarm.position(item.graph.tail[edge], step)
    heads = swarm.position(item.graph.head[edge][last], end[last])
    return np.concatenate([tails, heads]), np.concatenate([flow, flow[last]])


def _least_at_states(
    plot: _Plot, item: ClassColumns, swarm: Occupancy, bounds: SwarmBounds
) -> None:
    """An occupied state holds at least the smallest sub-swarm."""
    if swarm.horizon == 0:
        _small_starts(plot, swarm, bounds)
        return
    own = swarm.reached()[2]
    index, columns = agents_at_states(item, swarm)
    count = len(own)
    plot.draft.rows(
        np.concatenate([index, np.arange(count)]),
        np.concatenate([columns, own]),
        np.concatenate([np.ones(len(columns)), np.full(count, -float(bounds.least))]),
        lower=np.zeros(count),
        upper=np.inf,
        kind="size",
    )


def _small_starts(plot: _Plot, swarm: Occupancy, bounds: SwarmBounds) -> None:
    """Without any step the starts are all there is."""
    start = swarm.entered.graph.start
    if (start[start > 0] < bounds.least).any():
        plot.draft.rows([], [], [], lower=np.ones(1), upper=1.0, kind="size")


def _encoded(  # noqa: PLR0917 - everything the search asks for
    plot: _Plot,
    groups: Network,
    swarms: Sequence[Occupancy],
    witnesses: Witnesses,
    families: Sequence[tuple[SiteColumns, Family]],
    flows: Ints,
) -> Encoded:
    choices = witnesses.choices
    unrolled = [swarm.entered.unrolled() for swarm in swarms]
    columns, steps = [np.array(choices.columns, dtype=np.int64)], [np.array(choices.steps)]
    if not np.isin(unrolled[0][2], flows).any():  # where the groups go is decided too
        columns += [column for _, _, column in unrolled]
        steps += [step for _, step, _ in unrolled]
    order = np.argsort(np.concatenate(columns))
    return Encoded(
        model=plot.draft.build(),
        network=groups,
        indicators=np.concatenate(columns)[order],
        flows=flows,
        stayers=np.empty(0, dtype=np.int64),
        refuted=choices.refuted,
        steps=np.concatenate(steps).astype(np.int64)[order],
        groups=tuple(choices.groups),
        families=tuple(families),
    )
