"""What a formula asks of groups: where some must be, whatever their sizes.

Shared by the models of groups (`group_rows`) and of tokens (`token_flow`), whose columns both say
which edges are entered when. Robots that move one by one are counted beside the groups.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from tsplan.encode.class_columns import ClassColumns
from tsplan.encode.demand_rows import DemandRows
from tsplan.encode.flow_network import Network
from tsplan.encode.joint_demands import JointDemands
from tsplan.encode.switches import ALL_SWITCHES, Switch
from tsplan.encode.witness import Demand, Witnesses
from tsplan.milp.model import Draft, Floats, Ints
from tsplan.mission import SwarmBounds


def most_groups(agents: int, bounds: SwarmBounds, together: int | None) -> int:
    """The most sub-swarms that a swarm of so many agents can have at a step."""
    limits = [agents // bounds.least, bounds.most, together]
    return min(limit for limit in limits if limit is not None)


def some_wanted(witnesses: Witnesses) -> list[Demand]:
    """Where the formula wants agents, it wants some group or robot."""
    return [
        replace(need, bound=replace(need.bound, amount=1))
        for need in witnesses.demands
        if not need.bound.upper and need.bound.amount > 0
    ]


def group_network(entered: Sequence[ClassColumns], most: Sequence[int], robots: Network) -> Network:
    """The groups as if they were agents, at most so many of each swarm at a step, and the robots.

    Only what is true of groups may be built on it: that a state with a group is left by one, and
    that a group which is somewhere was there or has come. One group may become several.
    """
    classes = []
    for columns, limit in zip(entered, most, strict=True):
        graph = columns.graph
        start = np.minimum(graph.start, 1)
        start[np.flatnonzero(start)[:1]] += max(limit - int(start.sum()), 0)
        classes.append(replace(columns, graph=replace(graph, start=start)))
    return Network((*classes, *robots.classes), robots.horizon)


def presence_rows(network: Network, witnesses: Witnesses, draft: Draft) -> DemandRows:
    """Where the formula wants agents there is some group, and there are enough groups for it."""
    some = some_wanted(witnesses)
    # one group may become several in a region, so its visits as a whole say nothing
    rows = DemandRows(network, draft, ALL_SWITCHES - {Switch.TOGETHER, Switch.LAZY})
    rows.write(Witnesses(witnesses.choices, some, witnesses.covers))
    for capability in {need.bound.capability for need in some}:
        mine = [need for need in some if need.bound.capability == capability]
        JointDemands(mine, witnesses.choices).rule_out(network.agents(capability))
    return rows


def only_of(witnesses: Witnesses, robots: Network) -> Witnesses:
    """The demands that no single robot can serve."""
    only = [need for need in witnesses.demands if not robots.having(need.bound.capability)]
    return Witnesses(witnesses.choices, only, witnesses.covers)


def split_rows(
    splits: tuple[Ints, Floats], starts: int, witnesses: Witnesses, draft: Draft
) -> None:
    """A witness that wants groups at several places at once costs the splits to be there.

    Whoever is at so many places at one step has come from the starts by splitting. `splits` are the
    columns and coefficients of their number, `starts` is how many groups there are at step 0.
    """
    always, needs = JointDemands(some_wanted(witnesses), witnesses.choices).most()
    costs = {column: need - starts for column, need in needs.items() if need > starts}
    unconditional: list[list[int]] = [[]] if always > starts else []
    for family in unconditional + witnesses.choices.families(costs):
        columns = np.array(family, dtype=np.int64)
        price = np.array([costs[column] for column in family], dtype=np.float64)
        least = 0.0 if family else float(always - starts)
        draft.sums((0, *splits), (0, columns, -price), lower=least, kind="splits")
