"""Objectives of swarms that are linear in the columns; all are minimised."""

from __future__ import annotations

import numpy as np

from tsplan.encode.groups.occupancy import Occupancy, split_terms
from tsplan.encode.groups.swarm_model import SwarmModel
from tsplan.milp.model import Floats, Ints
from tsplan.search.target import Target

OF_GROUPS = frozenset({"splits", "moves", "makespan"})
"""Objectives that do not depend on how many agents the groups have."""


def splits(model: SwarmModel, columns: int) -> Floats:
    """The number of splits."""
    vector = np.zeros(columns)
    terms, values = split_terms(model.swarms)
    vector[terms] = values
    return vector


def moves(model: SwarmModel, columns: int) -> Floats:
    """Edges entered by a group, waits aside."""
    vector = np.zeros(columns)
    for swarm in model.swarms:
        edge, _, column = swarm.entered.unrolled()
        vector[column] = ~swarm.entered.graph.wait[edge]
    return vector


def travel(model: SwarmModel, columns: int) -> Floats:
    """Agent-steps spent in moves that are not waits."""
    vector = np.zeros(columns)
    for item in model.agents.classes:
        edge, _, column = item.unrolled()
        vector[column] = (item.graph.duration * ~item.graph.wait)[edge]
    return vector


def late(swarm: Occupancy, makespan: int) -> Ints:
    """Columns of the swarm's moves that end after step `makespan`."""
    edge, step, column = swarm.entered.unrolled()
    graph = swarm.entered.graph
    return column[~graph.wait[edge] & (step + graph.duration[edge] > makespan)]


def target(model: SwarmModel, name: str, columns: int) -> Target:
    """One of these objectives over so many columns."""
    return Target(VECTORS[name](model, columns))


VECTORS = {"splits": splits, "moves": moves, "travel": travel}
