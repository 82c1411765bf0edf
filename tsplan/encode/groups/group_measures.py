"""What a point of the counted model of swarms is worth, and which moves it stands for."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TypeAlias

import numpy as np

from tsplan.encode.flow_network import Network
from tsplan.encode.groups.group_objectives import VECTORS
from tsplan.encode.groups.group_sizes import sizes
from tsplan.encode.groups.swarm_model import SwarmModel, moves_of
from tsplan.milp.model import INFINITY, Floats
from tsplan.mission import Mission
from tsplan.plans.moves import Move

SwarmFlows: TypeAlias = Mapping[str, tuple[Move, ...]]
"""The moves of each swarm by its class name."""

_HALF = 0.5


def worth(model: SwarmModel, name: str, point: Floats) -> float:
    """An objective's value in its own unit."""
    value = minimised(model, name, point)
    return 0.0 - value if name == "balance" else value


def minimised(model: SwarmModel, name: str, point: Floats) -> float:
    """An objective's value, as it is minimised."""
    if name == "makespan":
        return float(last_move(model, point))
    if name == "balance":
        found = sizes(model)
        size = found.base.copy()
        np.add.at(size, found.index, np.round(point[found.flow]))
        held = np.round(point[found.group]) > 0
        return -float(size[held].min(initial=INFINITY))
    return float(np.round(VECTORS[name](model, len(point)) @ point))


def last_move(model: SwarmModel, point: Floats) -> int:
    """The step at which the last move that is not a wait arrives."""
    last = 0
    for swarm in model.swarms:
        edge, step, column = swarm.entered.unrolled()
        graph = swarm.entered.graph
        made = (point[column] > _HALF) & ~graph.wait[edge]
        last = max(last, int((step + graph.duration[edge])[made].max(initial=0)))
    return last


def flows_of(mission: Mission, agents: Network, point: Floats) -> SwarmFlows:
    """The moves of every swarm in a point of a counted model with the flows `agents`."""
    names = tuple(mission.system.states)
    found = {}
    for group, moves in zip(mission.team, moves_of(agents, point), strict=True):
        listed = (
            Move(when, names[source], names[target], number)
            for source, target, when, number in zip(
                *(column.tolist() for column in moves), strict=True
            )
        )
        found[group.class_name] = tuple(sorted(listed))
    return found
