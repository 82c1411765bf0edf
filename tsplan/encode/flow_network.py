"""The flow network: agents of one class move through the map unrolled over time.

`x[g, e, k]` is the number of agents of class g that enter edge e at step k. Agents of a class are
interchangeable, so the number of columns does not depend on how many there are. Where outcomes are
uncertain an edge is an action, whose agents end at several states in their parts; then the columns
are expected numbers, and at the last step there is one for every state. A column exists
only where some agent can be: from the earliest arrival at the edge's tail on. All arrays here are
built without a Python loop over columns.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from tsplan.encode.capability_mask import counted_nodes
from tsplan.encode.class_columns import ClassColumns, grouped, positions_joined
from tsplan.encode.class_graph import ClassGraph
from tsplan.milp.model import Bools, Draft, Floats, Ints, joined_terms


@dataclass(frozen=True, eq=False)
class Network:
    """The flow columns of all classes up to `horizon`."""

    classes: tuple[ClassColumns, ...]
    horizon: int

    @property
    def expected(self) -> bool:
        """Whether the columns are expected numbers."""
        return any(item.graph.outcomes is not None for item in self.classes)

    def counted(self, capability: str | None) -> Bools:
        """At which nodes agents of each class have a capability, as an array (classes, nodes)."""
        nodes = max((len(item.graph.start) for item in self.classes), default=0)
        return counted_nodes(capability, [c.graph.capabilities for c in self.classes], nodes)

    def having(self, capability: str | None) -> list[ClassColumns]:
        """The classes that have a capability; all of them for None."""
        able = np.flatnonzero(self.counted(capability).any(axis=1))
        return [self.classes[place] for place in able.tolist()]

    @property
    def states(self) -> tuple[int, ...]:
        """All states that the maps of classes have in common."""
        return tuple(range(min((c.graph.states for c in self.classes), default=0)))

    def reborn(self, capability: str | None) -> bool:
        """Whether some that have a capability may be rebuilt, or be new."""
        return any(item.graph.layer is not None for item in self.having(capability))

    def begun(self, capability: str | None) -> bool:
        """Whether whole agents with a capability all begin somewhere and stay what they are."""
        return self.horizon > 0 and not self.expected and not self.reborn(capability)

    def agents(self, capability: str | None) -> int:
        """How many agents have a capability, or of structures can have it at once."""
        return sum(most for most, _ in self._able(self.having(capability)))

    def _able(self, classes: Iterable[ClassColumns]) -> list[tuple[int, list[ClassColumns]]]:
        """How many agents some classes can have at once, layers of the same modules together."""
        pools: dict[int, list[ClassColumns]] = {}
        alone = []
        for item in classes:
            if item.graph.layer is None:
                alone.append((item.graph.agents, [item]))
            else:
                pools.setdefault(item.graph.layer.pool, []).append(item)
        shared = [(max(c.graph.agents for c in items), items) for items in pools.values()]
        return alone + shared

    def present(
        self, states: Ints, capability: str | None, step: int, *, settled: bool = True
    ) -> tuple[Ints, int]:
        """Columns whose sum, with the returned constant, is n(states, capability, step)."""
        steps = np.array([step])
        _, columns, constant = self.present_at(states, capability, steps, settled=settled)
        return columns, constant

    def present_at(
        self, states: Ints, capability: str | None, steps: Ints, *, settled: bool = True
    ) -> tuple[Ints, Ints, int]:
        """Positions in `steps` and columns: summed, with a constant, they are the count there.

        Agents at a state leave it by some edge (a wait is one), or have arrived at the horizon.
        Where agents may be late, those alone are counted that are there for certain (`settled`), or
        those that the plan has there.
        """
        if self.expected:
            return *positions_joined([c.leaving(states, steps) for c in self.having(capability)]), 0
        able = [(c, c.graph.nodes(states, settled=settled)) for c in self.having(capability)]
        if self.horizon == 0:
            return *positions_joined([]), sum(int(c.graph.start[nodes].sum()) for c, nodes in able)
        stood = [c.standing(nodes, steps) for c, nodes in able if settled and c.stood is not None]
        able = [(c, nodes) for c, nodes in able if not settled or c.stood is None]
        begun = [*stood, *(c.leaving(nodes, steps) for c, nodes in able)]
        ended = []
        if steps[-1] == self.horizon:
            # nobody leaves at the horizon: count who has arrived
            last = len(steps) - 1
            for item, nodes in able:
                position, column = item.arriving(nodes, steps[-1:])
                ended.append((position + last, column))
        return *positions_joined([*begun, *ended]), 0

    def possible_at(
        self, states: Ints, capability: str | None, steps: Ints
    ) -> tuple[Ints, Ints, Floats, int]:
        """As `present_at`, with factors: who is there, and who may be there though late.

        Whoever may be at several of the states counts at each of them.
        """
        here, columns, constant = self.present_at(states, capability, steps, settled=False)
        late = [terms for c in self.having(capability) for terms in c.lingering(states, steps)]
        return *joined_terms([(here, columns, 1.0), *late]), constant

    def entering(self, states: Ints, capability: str | None, steps: Ints) -> tuple[Ints, Ints]:
        """Positions in `steps` and columns of the arrivals at `states` from elsewhere."""
        return self._each(ClassColumns.entering, states, capability, steps)

    def coming(self, states: Ints, capability: str | None, steps: Ints) -> tuple[Ints, Ints]:
        """Positions in `steps` and columns of those who come to a state otherwise than by waiting.

        Whoever is at one of the states at some step of a window was there at its beginning or is
        among those who come in it.
        """
        return self._each(ClassColumns.coming, states, capability, steps)

    def between(self, states: Ints, capability: str | None, steps: Ints) -> tuple[Ints, Ints]:
        """Positions in `steps` and columns of the agents on their way inside `states`."""
        return self._each(ClassColumns.between, states, capability, steps)

    def _each(
        self,
        columns: Callable[[ClassColumns, Ints, Ints], tuple[Ints, Ints]],
        states: Ints,
        capability: str | None,
        steps: Ints,
    ) -> tuple[Ints, Ints]:
        """The columns of all classes with a capability, at the nodes that count from below."""
        able = self.having(capability)
        return positions_joined([columns(item, item.graph.nodes(states), steps) for item in able])

    def most(
        self, states: Ints, capability: str | None, *, upper: bool = False, later: int = 0
    ) -> Ints:
        """How many agents with a capability can count at `states` at most, for every step.

        With `upper` as bounds from above count them; `later` is by how many steps they may be later
        than they may be anyway.
        """
        most = np.zeros(self.horizon + 1, dtype=np.int64)
        for _, items in self._able(self.having(capability)):
            there = np.zeros(self.horizon + 1, dtype=np.int64)
            for item in items:
                modes = item.graph.modes
                arrival = item.arrival[item.graph.nodes(states, settled=not upper)]
                standing = modes.delay if modes is not None and modes.standing and not upper else 0
                arrival = np.where(arrival > 0, arrival + later + standing, 0)
                times = min(len(states), modes.delay + 1) if modes is not None and upper else 1
                first = int(arrival.min(initial=self.horizon + 1))
                there[first:] = np.maximum(there[first:], times * item.graph.agents)
            most += there
        return most

    def best(self, states: Ints, capability: str | None, *, later: int = 0) -> Floats:
        """The same, of expected numbers where outcomes are uncertain."""
        if not self.expected:
            return self.most(states, capability, later=later).astype(np.float64)
        able = self.having(capability)
        parts = [most_expected(item.graph, states, self.horizon) for item in able]
        return np.asarray(sum(parts, np.zeros(self.horizon + 1)))


def unroll(
    graphs: Sequence[ClassGraph],
    horizon: int,
    draft: Draft,
    *,
    finish: Sequence[Bools] | None = None,
) -> Network:
    """Add the flow columns and conservation rows of every class to `draft`.

    `finish` marks, per class, the edges that may only be entered when they end by the horizon;
    without it every edge may be entered at any step and an agent may still travel at the end.
    """
    late = [None] * len(graphs) if finish is None else finish
    classes = (flow(*each, horizon, draft) for each in zip(graphs, late, strict=True))
    return Network(tuple(classes), horizon)


def flow(graph: ClassGraph, finish: Bools | None, horizon: int, draft: Draft) -> ClassColumns:
    """The flow columns and conservation rows of one class."""
    columns = laid_out(graph, horizon, draft, upper=float(graph.agents), finish=finish)
    _conserve(columns, horizon, draft)
    return columns


def laid_out(
    graph: ClassGraph, horizon: int, draft: Draft, *, upper: float, finish: Bools | None = None
) -> ClassColumns:
    """Columns up to `upper` for every edge and step at which it may be entered.

    They are whole numbers unless outcomes are uncertain.
    """
    arrival = graph.earliest(horizon)
    last = np.full(len(graph.tail), horizon - 1)
    if finish is not None:
        last = np.where(finish, horizon - graph.duration, last)
    last[graph.begun] = min(0, horizon - 1)
    first = arrival[graph.tail] if graph.layer is None else graph.layer.begins
    if graph.entries is not None:
        first, last = np.maximum(first, graph.entries[0]), np.minimum(last, graph.entries[1])
        # where agents cannot wait, they may be gone from a state by then
        first = np.maximum(first, arrival[graph.head] - graph.duration)
    if graph.outcomes is not None:
        ending = graph.outcomes.ending
        first = np.where(ending, np.maximum(first, horizon), first)
        last = np.where(ending, horizon, last)
    spans = np.maximum(last - first + 1, 0)
    whole = graph.outcomes is None
    columns = draft.columns(int(spans.sum()), upper=upper, integer=whole)
    base = int(columns[0]) if len(columns) else 0
    return ClassColumns(
        graph=graph,
        arrival=arrival,
        first=first,
        last=last,
        offset=base + np.cumsum(spans) - spans,
        by_tail=grouped(graph.tail, len(graph.start)),
        by_head=grouped(graph.head, len(graph.start)),
    )


class Balance(NamedTuple):
    """At every state and step before the horizon: what leaves, less what has come.

    Where outcomes are uncertain, at the horizon too: there, agents leave by edges that end it.
    There are `total` rows; `row_of` plus a step is that of a state. `rows`, `columns` and `values`
    are their entries.
    """

    total: int
    row_of: Ints
    rows: Ints
    columns: Ints
    values: Floats


def balance(columns: ClassColumns, horizon: int) -> Balance:
    """The balance of one class."""
    graph = columns.graph
    stop = horizon if graph.outcomes is None else horizon + 1
    spans = np.maximum(stop - columns.arrival, 0)
    row_of = np.cumsum(spans) - spans - columns.arrival
    edge, step, column = columns.unrolled()
    somewhere = columns.arrival[graph.tail[edge]] <= step  # of structures some come from nowhere
    leaving = (row_of[graph.tail[edge]] + step)[somewhere]
    entry, head, part = _ends(graph, edge)
    end = (step + graph.duration[edge])[entry]
    inside = (end < stop) & (columns.arrival[head] <= end)
    coming = (row_of[head] + end)[inside]
    return Balance(
        int(spans.sum()),
        row_of,
        np.concatenate([leaving, coming]),
        np.concatenate([column[somewhere], column[entry][inside]]),
        np.concatenate([np.ones(len(leaving)), -part[inside]]),
    )


def _ends(graph: ClassGraph, edge: Ints) -> tuple[Ints, Ints, Floats]:
    """Where those who enter edges end: positions in `edge`, states, and which part of them does."""
    if graph.outcomes is None:
        return np.arange(len(edge)), graph.head[edge], np.ones(len(edge))
    order, begin = grouped(graph.outcomes.edge, len(graph.tail))
    counts = (begin[1:] - begin[:-1])[edge]
    entry = np.repeat(np.arange(len(edge)), counts)
    within = np.arange(len(entry)) - np.repeat(np.cumsum(counts) - counts, counts)
    outcome = order[begin[edge][entry] + within]
    return entry, graph.outcomes.head[outcome], graph.outcomes.chance[outcome]


def _conserve(columns: ClassColumns, horizon: int, draft: Draft) -> None:
    """At every (state, step) before the horizon, agents that leave are those that came."""
    kept = balance(columns, horizon)
    supply = np.zeros(kept.total)
    begun = np.flatnonzero(columns.graph.start)
    if horizon > 0 or columns.graph.outcomes is not None:
        supply[kept.row_of[begun]] = columns.graph.start[begun]
    draft.rows(kept.rows, kept.columns, kept.values, lower=supply, upper=supply, kind="flow")


_ROUNDING = 1e-9  # by which a sum of products of probabilities may be too small


def most_expected(graph: ClassGraph, states: Ints, horizon: int) -> Floats:
    """The most agents that can be expected at `states`, for every step, by backward induction.

    Source: R. Bellman, "A Markovian decision process", Journal of Mathematics and Mechanics 6,
    1957; the value of a state is how likely an agent is at `states` in so many steps.
    """
    outcomes = graph.outcomes
    assert outcomes is not None
    count, actions = len(graph.start), np.flatnonzero(~outcomes.ending)
    likely = np.zeros((horizon + 1, count))
    likely[0, states] = 1.0
    duration = graph.duration[outcomes.edge]
    for left in range(1, horizon + 1):
        in_time = duration <= left
        later = likely[np.maximum(left - duration, 0), outcomes.head] * in_time
        value = np.bincount(outcomes.edge, later * outcomes.chance, len(graph.tail))
        np.maximum.at(likely[left], graph.tail[actions], value[actions])
    return np.asarray((likely @ graph.start) * (1 + _ROUNDING))
