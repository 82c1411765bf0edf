"""What a formula asks of groups: where some must be, whatever their sizes.

Shared by the models of groups (`model`) and of tokens (`tokens`), whose columns both say which
edges are entered when.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from tsplan.encode.agent_classes import agent_classes, map_arrays
from tsplan.encode.assemble import Asking
from tsplan.encode.count_atoms import Requirement, requirement
from tsplan.encode.demand_rows import Staffing
from tsplan.encode.flow_network import ClassColumns, ClassGraph, Network
from tsplan.encode.joint_demands import Together
from tsplan.encode.robustness_bound import Outlook
from tsplan.encode.witness import Lasting, WitnessEncoder, Witnesses
from tsplan.logic import Count, Formula
from tsplan.milp.model import Draft, Floats, Ints
from tsplan.mission import Mission


@dataclass(frozen=True, eq=False)
class Wanting:
    """What is asked for in place of the mission's goal, all of it parts of `goal`."""

    goal: Formula
    ask: Asking


def swarm_graphs(mission: Mission) -> list[ClassGraph]:
    """The graph of each swarm, with the capability that atoms name it by."""
    return [
        agent_classes(mission.system, [group], group.capabilities)[0].graph
        for group in mission.team
    ]


def most_groups(mission: Mission) -> list[int]:
    """The most sub-swarms that each swarm can have at a step."""
    rules = mission.swarm
    assert rules is not None
    most = []
    for group in mission.team:
        bounds = rules.each[group.class_name]
        limits = [group.count // bounds.least, bounds.most, rules.together]
        most.append(min(limit for limit in limits if limit is not None))
    return most


def witnesses_of(
    mission: Mission, entered: Sequence[ClassColumns], draft: Draft, wanting: Wanting | None = None
) -> Witnesses:
    """The demands of a mission's formula, or of what is wanted instead, under literals."""
    network = Network(tuple(entered), mission.horizon, len(mission.system.states))
    arrays = map_arrays(mission.system)

    def read(atom: Count) -> Requirement:
        return requirement(atom, mission.system, arrays)

    goal = mission.goal if wanting is None else wanting.goal
    encoder = WitnessEncoder(draft, Outlook(goal, network, read), read)
    return encoder.encode(goal) if wanting is None else wanting.ask(encoder, draft, network)


def wanted(witnesses: Witnesses) -> list[Lasting]:
    """Where the formula wants agents, it wants some group."""
    return [
        replace(need, bound=replace(need.bound, amount=1))
        for need in witnesses.lasting
        if not need.bound.upper and need.bound.amount > 0
    ]


def group_network(entered: Sequence[ClassColumns], most: Sequence[int], horizon: int) -> Network:
    """The groups as if they were agents, at most so many of each swarm at a step.

    Only what is true of groups may be built on it: that a state with a group is left by one, and
    that a group which is somewhere was there or has come. One group may become several.
    """
    classes = []
    for columns, limit in zip(entered, most, strict=True):
        graph = columns.graph
        start = np.minimum(graph.start, 1)
        start[np.flatnonzero(start)[:1]] += max(limit - int(start.sum()), 0)
        classes.append(replace(columns, graph=replace(graph, start=start)))
    return Network(tuple(classes), horizon, len(entered[0].graph.start))


def presence_rows(groups: Network, witnesses: Witnesses, draft: Draft) -> Staffing:
    """Where the formula wants agents there is some group, and there are enough groups for it."""
    some = wanted(witnesses)
    staffing = Staffing(groups, draft)
    # one group may become several in a region, so its visits as a whole say nothing
    staffing.write(Witnesses(witnesses.choices, some, witnesses.covers), cuts=True, together=False)
    for capability in {need.bound.capability for need in some}:
        mine = [need for need in some if need.bound.capability == capability]
        Together(mine, witnesses.choices).rule_out(groups.agents(capability))
    return staffing


def split_rows(
    splits: tuple[Ints, Floats], starts: int, witnesses: Witnesses, draft: Draft
) -> None:
    """A witness that wants agents at several places at once costs the splits to be there.

    Whoever is at so many places at one step has come from the starts by splitting. `splits` are the
    columns and coefficients of their number, `starts` is how many groups there are at step 0.
    """
    always, needs = Together(wanted(witnesses), witnesses.choices).most()
    costs = {column: need - starts for column, need in needs.items() if need > starts}
    unconditional: list[list[int]] = [[]] if always > starts else []
    for family in unconditional + witnesses.choices.families(costs):
        columns = np.array(family, dtype=np.int64)
        price = np.array([costs[column] for column in family], dtype=np.float64)
        draft.rows(
            np.zeros(len(splits[0]) + len(columns)),
            np.concatenate([splits[0], columns]),
            np.concatenate([splits[1], -price]),
            lower=np.array([0.0 if family else float(always - starts)]),
            upper=np.inf,
            kind="splits",
        )
