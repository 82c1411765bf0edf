"""Where a swarm is: which states are occupied at which step, which edges are entered when.

A column is 1 where at least one agent is, so nothing here depends on how many agents there are.
Groups are not conserved as agents are: who leaves a state by several edges splits, who comes to it
by several merges. What is kept is that an occupied state is left by some edge, and that a state is
occupied exactly when somebody comes. As an LP this is nearly a flow whose splits are paid for, so
its bound on the number of splits is good.

The model of swarms is the project's own; the idea that a whole swarm is told only which part of it
goes where comes from "Temporal Logic Swarm Control with Splitting and Merging" (ICRA 2023).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from tsplan.encode.class_columns import ClassColumns
from tsplan.encode.class_graph import ClassGraph
from tsplan.encode.flow_network import laid_out
from tsplan.encode.running_sums import unfolded
from tsplan.milp.model import Draft, Floats, Ints


@dataclass(frozen=True, eq=False)
class Occupancy:
    """Columns of one swarm: its edges entered, and its states, from their earliest step on."""

    entered: ClassColumns
    states: Ints  # column of each state at its earliest step; consecutive steps follow
    horizon: int

    def reached(self) -> tuple[Ints, Ints, Ints]:
        """State, step and column of everything that can be occupied, as equal-length arrays."""
        arrival = self.entered.arrival
        state, step = unfolded(arrival, np.maximum(self.horizon + 1 - arrival, 0))
        return state, step, self.at(state, step)

    def at(self, state: Ints, step: Ints) -> Ints:
        """Columns of states that can be reached by the given steps."""
        return np.asarray(self.states[state] + step - self.entered.arrival[state])

    def position(self, state: Ints, step: Ints) -> Ints:
        """Places of states and steps in what `reached` lists."""
        return self.at(state, step) - int(self.states[0])

    def inside(self) -> tuple[Ints, Ints]:
        """Steps and columns of groups strictly between the ends of an edge, up to the horizon."""
        edge, step, column = self.entered.unrolled()
        spans = np.minimum(self.entered.graph.duration[edge] - 1, self.horizon - step)
        group, inside = unfolded(step + 1, np.maximum(spans, 0))
        return inside, column[group]


def occupancy(graph: ClassGraph, horizon: int, draft: Draft) -> Occupancy:
    """Columns of one swarm, and the rows that tie them to each other."""
    entered = laid_out(graph, horizon, draft, upper=1.0)
    spans = np.maximum(horizon + 1 - entered.arrival, 0)
    # whole by themselves where edges are; said all the same, so that sums of them may be rounded
    columns = draft.columns(int(spans.sum()), upper=1.0, integer=True)
    base = int(columns[0]) if len(columns) else 0
    made = Occupancy(entered, base + np.cumsum(spans) - spans, horizon)
    _begin(made, draft)
    _tie(made, draft)
    return made


def _begin(made: Occupancy, draft: Draft) -> None:
    """The starts are occupied at step 0."""
    starts = np.flatnonzero(made.entered.graph.start)
    at = made.at(starts, np.zeros(len(starts), dtype=np.int64))
    draft.sums((np.arange(len(at)), at, 1.0), lower=1.0, upper=1.0, count=len(at), kind="start")


def _tie(made: Occupancy, draft: Draft) -> None:
    """An occupied state is left and entered by some edge, and what an edge joins is occupied."""
    graph = made.entered.graph
    edge, step, column = made.entered.unrolled()
    end = step + graph.duration[edge]
    ends = end <= made.horizon
    tails = made.at(graph.tail[edge], step)
    heads = made.at(graph.head[edge][ends], end[ends])
    _at_most(column, tails, draft)
    _at_most(column[ends], heads, draft)
    _, when, own = made.reached()
    for members, joined, some in (
        (column, tails, own[when < made.horizon]),
        (column[ends], heads, own[when > 0]),
    ):
        place = np.full(int(own.max(initial=-1)) + 1, -1)
        place[some] = np.arange(len(some))
        every = np.arange(len(some))
        entered = place[joined], members, 1.0
        draft.sums((every, some, -1.0), entered, count=len(some), kind="occupied")


def _at_most(columns: Ints, others: Ints, draft: Draft) -> None:
    every = np.arange(len(columns))
    draft.sums((every, others, 1.0), (every, columns, -1.0), count=len(every), kind="occupied")


def bound_groups(swarms: Sequence[Occupancy], most: int, draft: Draft) -> None:
    """At every step at most `most` sub-swarms: occupied states, and groups inside edges."""
    groups = [found for swarm in swarms for found in (swarm.reached()[1:], swarm.inside())]
    draft.sums(
        *((step, column, 1.0) for step, column in groups),
        lower=-np.inf,
        upper=float(most),
        count=swarms[0].horizon + 1,
        kind="sub-swarms",
    )


def split_terms(swarms: Sequence[Occupancy]) -> tuple[Ints, Floats]:
    """Columns and coefficients of the number of splits.

    Edges entered beyond one for every occupied state before the horizon.
    """
    columns, values = [], []
    for swarm in swarms:
        entered = swarm.entered.unrolled()[2]
        _, step, own = swarm.reached()
        left = own[step < swarm.horizon]
        columns += [entered, left]
        values += [np.ones(len(entered)), -np.ones(len(left))]
    return np.concatenate(columns), np.concatenate(values)
