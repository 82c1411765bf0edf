"""Objectives that are linear in the flows: one coefficient per column.

`travel`, `cost` and `agents` are minimised as they stand; `makespan` and `availability` are
searched level by level (see `search.lexicographic`), since each of their levels is a model of its
own.
"""

from __future__ import annotations

import numpy as np

from tsplan.encode.flow_network import ClassColumns, Network
from tsplan.milp.model import Draft, Floats, Ints


def travel(network: Network, columns: int) -> Floats:
    """Agent-steps spent in moves that are not waits."""
    return _priced(network, columns, [c.graph.duration * ~c.graph.wait for c in network.classes])


def cost(network: Network, columns: int) -> Floats:
    """Summed edge costs of all moves; waits are free unless their edge says otherwise."""
    return _priced(network, columns, [c.graph.cost for c in network.classes])


def _priced(network: Network, columns: int, prices: list[Floats] | list[Ints]) -> Floats:
    objective = np.zeros(columns)
    for item, price in zip(network.classes, prices, strict=True):
        edge, _, column = item.unrolled()
        objective[column] = price[edge]
    return objective


def late_moves(network: Network, makespan: int) -> Ints:
    """Flow columns of moves that are not waits and end after step `makespan`."""
    late = []
    for item in network.classes:
        edge, step, column = item.unrolled()
        ends = step + item.graph.duration[edge]
        late.append(column[~item.graph.wait[edge] & (ends > makespan)])
    return np.concatenate([*late, np.empty(0, dtype=np.int64)])


def stayers(network: Network, draft: Draft) -> Ints:
    """Columns that count the agents of each class and start that wait there to the end.

    An agent stays by taking its start's self-loop again and again, so as many can stay as every
    one of those waits is taken by. Minimising the agents that move is maximising these columns.
    """
    made = []
    for item in network.classes:
        for state in np.flatnonzero(item.graph.start).tolist():
            waits = _waits_for_ever(item, state, network.horizon)
            if waits is None:
                continue
            staying = draft.columns(1, upper=float(item.graph.start[state]), integer=True)
            count = len(waits)
            draft.rows(
                np.tile(np.arange(count), 2),
                np.concatenate([waits, np.repeat(staying, count)]),
                np.repeat([1.0, -1.0], count),
                lower=np.zeros(count),
                upper=np.inf,
                kind="stay",
            )
            made.append(staying)
    return np.concatenate([*made, np.empty(0, dtype=np.int64)])


def _waits_for_ever(item: ClassColumns, state: int, horizon: int) -> Ints | None:
    """Columns of the waits that fill all steps at a state, or None where it has no self-loop."""
    loops = np.flatnonzero((item.graph.tail == state) & (item.graph.head == state))
    if horizon > 0 and not len(loops):
        return None
    if horizon == 0:
        return np.empty(0, dtype=np.int64)
    loop = int(loops[0])
    steps = np.arange(0, horizon, int(item.graph.duration[loop]))
    return np.asarray(item.offset[loop] + steps - item.first[loop], dtype=np.int64)
