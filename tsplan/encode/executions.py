"""When tasks are executed: 0/1 columns, and how formulas ask for them.

There is a column for every task, state of its label and step. What it takes from the stocks there
is said in `tsplan.encode.stocks`, and which agents it needs for itself in `tsplan.encode.bookings`.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import ClassVar, NamedTuple, TypeAlias

import numpy as np

from tsplan.encode.agent_classes import MapArrays
from tsplan.encode.atom_encoders import Executed, Requirement, Slack
from tsplan.encode.class_columns import ClassColumns
from tsplan.encode.flow_network import Network
from tsplan.logic import Count, Execution, Formula, Known, walk
from tsplan.milp.model import Draft, Floats, Ints
from tsplan.mission import Resource
from tsplan.mission.resources import compartment
from tsplan.ts import TransitionSystem


class Timed(NamedTuple):
    """The columns of one task at one state, for the steps from `first` on."""

    first: int
    columns: Ints

    @property
    def last(self) -> int:
        """The last step that has a column."""
        return self.first + len(self.columns) - 1


Executions: TypeAlias = Mapping[Executed, Timed]

PART = "executions"
"""The name of this part among those of a model."""

_HELD = 1e-6  # less than a whole execution by this is one: the tolerance of the solvers


def executed_at(executions: Executions, values: Floats) -> list[tuple[Execution, int, int]]:
    """The task, state and step of every execution at a point."""
    return [
        (bound.task, bound.state, timed.first + int(place))
        for bound, timed in executions.items()
        for place in np.flatnonzero(values[timed.columns] > 1 - _HELD)
    ]


@dataclass(frozen=True, eq=False)
class ExecutionEncoder:
    """Reads tasks that are executed; availability has no part in it."""

    network: Network
    system: TransitionSystem
    arrays: MapArrays
    resources: tuple[Resource, ...]
    columns: Executions = field(default_factory=dict)
    most: float = 0.0  # more than any availability that is a number
    _best: dict[Executed, Floats] = field(default_factory=dict)
    grain: ClassVar[float] = 1.0

    def requirement(self, atom: Execution) -> Requirement:
        """It is executed at every state with the label."""
        states = self.arrays.states_with(self.system, atom.label).tolist()
        return Requirement(tuple(Executed(atom, state) for state in states), every=True)

    def best(self, bound: Executed) -> Floats:
        """Infinite from the step on at which everything needed may lie there."""
        if bound not in self._best:
            needed = dict(bound.task.resources)
            begin = max(
                (
                    int(earliest(item, self.network, self.arrays, needed[item.name])[bound.state])
                    for item in self.resources
                    if needed.get(item.name)
                ),
                default=0,
            )
            steps = np.arange(self.network.horizon + 1)
            able = (begin <= steps) & (steps <= self.network.horizon - bound.task.last)
            self._best[bound] = np.where(able, np.inf, -np.inf)
        return self._best[bound]

    def worst(self, bound: Executed) -> None:
        """Nothing is executed unless it is asked for."""

    def slack(self, bound: Executed, step: int) -> Slack:
        """More than any availability where it is executed, less than all where it is not."""
        most = self.most
        timed = self.columns.get(bound)
        if timed is None or not timed.first <= step <= timed.last:
            return Slack(np.empty(0, dtype=np.int64), 1.0, -most, -most, -most)
        column = timed.columns[step - timed.first : step - timed.first + 1]
        return Slack(column, 2 * most, -most, -most, most)


def beyond(goal: Formula, agents: int) -> int:
    """More than any availability of a formula that is a number."""
    bounds = (node.bound for node in walk(goal) if isinstance(node, Count))
    known = (abs(node.margin) for node in walk(goal) if isinstance(node, Known))
    numbers = (*(bound for bound in bounds if isinstance(bound, int)), *known)
    return agents + 1 + max(numbers, default=0)


def execution_columns(spans: Mapping[Executed, tuple[int, int]], draft: Draft) -> Executions:
    """A column for every step of a span, 1 where the task is executed then."""
    return {
        bound: Timed(first, draft.columns(last - first + 1, upper=1.0, integer=True))
        for bound, (first, last) in spans.items()
    }


def carriers(resource: Resource, network: Network) -> Iterator[ClassColumns]:
    """The classes that can carry some of a resource."""
    for item in network.classes:
        own = compartment(item.graph.carries, resource)
        if own or (own is None and item.graph.carries):
            yield item


def earliest(resource: Resource, network: Network, arrays: MapArrays, amount: float = 0.0) -> Ints:
    """The first step at which some of a resource may lie at each state, horizon + 1 if never.

    With an `amount`, some that was brought where less than that lies from the start.
    """
    lying = {arrays.number[state]: there for state, there in resource.at if there}
    sources = [(n, 0) for n in lying]
    sources += [(arrays.number[state], step) for state, step, _ in resource.brought]
    able = tuple(carriers(resource, network))
    never = network.horizon + 1

    def brought(sources: Iterable[tuple[int, int]]) -> Ints:
        found = np.full(len(arrays.names), never)
        for state, step in sources:
            found[state] = min(found[state], step)
        settled = False
        while not settled:
            before = found.copy()
            for item in able:
                graph, ride = item.graph, item.graph.rides
                tail, head = graph.tail[ride], graph.head[ride]
                leaving = np.maximum(found[tail], item.arrival[tail])
                np.minimum.at(found, head, leaving + graph.duration[ride])
            settled = bool((found == before).all())
        return np.asarray(np.minimum(found, never))

    found = brought(sources)
    for state, there in lying.items() if amount else ():
        if there < amount:
            found[state] = brought(other for other in sources if other != (state, 0))[state]
    return found


def latest(
    wanted: Mapping[int, int], resource: Resource, network: Network, arrays: MapArrays
) -> Ints:
    """The last step at which a resource may be of use at each state, -1 if never.

    It is of use at the `wanted` states up to a step each, and where it can be carried there from.
    """
    found = np.full(len(arrays.names), -1)
    found[list(wanted)] = list(wanted.values())
    able = tuple(carriers(resource, network))
    settled = False
    while not settled:
        before = found.copy()
        for item in able:
            graph, ride = item.graph, item.graph.rides
            ends = found[graph.head[ride]] - graph.duration[ride]
            np.maximum.at(found, graph.tail[ride], ends)
        settled = bool((found == before).all())
    return found
