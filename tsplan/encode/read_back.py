"""From a point of a model back to moves on the full map, class by class."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TypeAlias

import numpy as np

from tsplan.encode.agent_classes import AgentClass
from tsplan.encode.encoded import Point, Setting
from tsplan.encode.map_reduction import Reduced, whole
from tsplan.encode.stocks import PART as STOCKS
from tsplan.encode.stocks import Stocks
from tsplan.logic import Execution, Formula
from tsplan.logic import labels as labels_of
from tsplan.logic.evaluation import CountTrace, robustness
from tsplan.milp.model import Bools, Floats, Ints
from tsplan.plans.loading import LEAST, Carried
from tsplan.plans.moves import Move

Moves: TypeAlias = tuple[Ints, Ints, Ints]
"""Edges of a class's full map, the steps, and how many agents enter."""

ClassMoves: TypeAlias = Sequence[tuple[AgentClass, Moves]]


def moves_of(setting: Setting, point: Point) -> list[tuple[AgentClass, Moves]]:
    """For every class the edges of its full graph that agents enter, when, and how many do."""
    found = []
    for number, (item, columns) in enumerate(
        zip(setting.classes, point.encoded.network.classes, strict=True)
    ):
        edge, step, column = columns.unrolled()
        count = np.round(point.values[column]).astype(np.int64)
        used = np.flatnonzero(count)
        shortcuts = setting.reduced[number] if point.tight else whole(item.graph)
        found.append(
            (item, _expand(item, shortcuts, (edge[used], step[used], count[used]), setting.horizon))
        )
    return found


def listed(setting: Setting, item: AgentClass, moves: Moves) -> tuple[Move, ...]:
    """The moves of one class with the names of their states, in the order of time."""
    names = setting.arrays.names
    edge, step, count = moves
    ends = item.graph.tail[edge].tolist(), item.graph.head[edge].tolist()
    found = zip(step.tolist(), *ends, count.tolist(), strict=True)
    return tuple(
        sorted(Move(when, names[tail], names[head], agents) for when, tail, head, agents in found)
    )


def _expand(item: AgentClass, reduced: Reduced, moves: Moves, horizon: int) -> Moves:
    """Shortcuts replaced by the edges of their paths, entered one after the other."""
    edges, steps, counts = [], [], []
    for edge, step, count in zip(*(part.tolist() for part in moves), strict=True):
        path = reduced.paths[edge]
        duration = item.graph.duration[path]
        entered = step + np.cumsum(duration) - duration
        within = entered < horizon
        edges.append(path[within])
        steps.append(entered[within])
        counts.append(np.full(int(within.sum()), count))
    empty = [np.empty(0, dtype=np.int64)]
    return (
        np.concatenate(edges + empty),
        np.concatenate(steps + empty),
        np.concatenate(counts + empty),
    )


def availability(setting: Setting, point: Point) -> float:
    """Robustness of the goal at step 0 under the counts that the moves imply."""
    trace = counts_of(setting, setting.judged, point)
    return float(robustness(setting.judged, trace)[..., 0])


def counts_of(setting: Setting, formula: Formula, point: Point) -> CountTrace:
    """The counts that the moves imply at the labels of a formula."""
    system = setting.mission.system
    named = sorted(labels_of(formula))
    site = {label: setting.arrays.states_with(system, label) for label in named}
    watched = np.unique(np.concatenate([*site.values(), np.empty(0, dtype=np.int64)]))
    shape = (len(watched), setting.horizon + 1)
    everybody = np.zeros(shape)
    counts: dict[str | None, Floats] = {None: everybody}
    executions: dict[str, Bools] = {}
    for task, state, when in executions_of(point):
        here = executions.setdefault(task.task, np.zeros(shape, dtype=np.bool_))
        here[np.searchsorted(watched, state), when] = True
    for item, (edge, step, count) in moves_of(setting, point):
        present = np.zeros(shape)
        present[:, 0] = item.graph.start[watched]
        ends = step + item.graph.duration[edge]
        heads = item.graph.head[edge]
        inside = (ends <= setting.horizon) & np.isin(heads, watched)
        np.add.at(present, (np.searchsorted(watched, heads[inside]), ends[inside]), count[inside])
        everybody += present
        for capability in item.graph.capabilities:
            counts.setdefault(capability, np.zeros(shape))
            counts[capability] += present
    labels = {label: np.searchsorted(watched, states) for label, states in site.items()}
    return CountTrace(counts, labels, executions)


def executions_of(point: Point) -> list[tuple[Execution, int, int]]:
    """The task, state and step of every execution at a point."""
    made: Stocks | None = point.encoded.own_columns.get(STOCKS)
    return [] if made is None else made.executed(point.values)


def carried_at(setting: Setting, point: Point) -> Iterator[Carried]:
    """What is carried along every edge at a point."""
    made: Stocks | None = point.encoded.own_columns.get(STOCKS)
    names = setting.arrays.names
    for load in () if made is None else made.loads:
        lanes = load.lanes
        amounts = point.values[load.columns]
        for place in np.flatnonzero(amounts > LEAST).tolist():
            ends = names[lanes.tail[place]], names[lanes.head[place]]
            times = int(lanes.step[place]), int(lanes.duration[place])
            yield Carried(*ends, *times, lanes.held, load.resource, float(amounts[place]))


def last_arrival(setting: Setting, point: Point) -> int:
    """Last step at which an agent arrives by a move that is not a wait; 0 without any."""
    last = 0
    for item, (edge, step, _count) in moves_of(setting, point):
        move = ~item.graph.wait[edge]
        ends = (step + item.graph.duration[edge])[move]
        last = max(last, int(ends.max(initial=0)))
    return last


def moving(setting: Setting, point: Point) -> int:
    """Agents that ever move: all but those that can wait at their start to the end."""
    staying = 0
    for item, (edge, step, count) in moves_of(setting, point):
        graph = item.graph
        for state in np.flatnonzero(graph.start).tolist():
            loop = np.flatnonzero((graph.tail == state) & (graph.head == state))
            here = graph.start[state]
            if setting.horizon and not len(loop):
                continue
            waits = range(0, setting.horizon, int(graph.duration[loop[0]]) if len(loop) else 1)
            entered = np.zeros(setting.horizon, dtype=np.int64)
            mine = np.isin(edge, loop)
            np.add.at(entered, step[mine], count[mine])
            staying += min([here, *entered[list(waits)].tolist()])
    return setting.mission.size - int(staying)
