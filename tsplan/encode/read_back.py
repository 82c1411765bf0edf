"""From a point of a model back to moves on the full map, class by class."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Sequence
from typing import TypeAlias

import numpy as np

from tsplan.encode.agent_classes import AgentClass
from tsplan.encode.class_graph import ClassGraph
from tsplan.encode.encoded import Point, Setting
from tsplan.encode.executions import PART as EXECUTIONS
from tsplan.encode.executions import Executions, executed_at
from tsplan.encode.map_reduction import Reduced, whole
from tsplan.encode.stocks import PART as STOCKS
from tsplan.encode.stocks import Stocks
from tsplan.logic import Execution, Formula
from tsplan.logic import labels as labels_of
from tsplan.logic.evaluation import CountTrace, robustness
from tsplan.milp.model import Bools, Floats, Ints
from tsplan.plans.loading import LEAST, Carried
from tsplan.plans.moves import Move
from tsplan.plans.structure_paths import PoolMoves, Times

Moves: TypeAlias = tuple[Ints, Ints, Ints]
"""Edges of a class's full map, the steps, and how many agents enter."""

ClassMoves: TypeAlias = Sequence[tuple[AgentClass, Moves]]


def moves_of(point: Point) -> list[tuple[AgentClass, Moves]]:
    """For every class the edges of its full graph that agents enter, when, and how many do."""
    found = []
    setting = point.encoded.setting
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


def node_names(setting: Setting, item: AgentClass) -> tuple[str, ...]:
    """The names of the nodes of a class's map: those of the states first, then their own."""
    states = setting.arrays.names
    own = range(len(states), len(item.graph.start))
    return (*states, *(f"node {number}\0" for number in own))


def listed(setting: Setting, item: AgentClass, moves: Moves) -> tuple[Move, ...]:
    """The moves of one class with the names of their nodes, in the order of time."""
    names = node_names(setting, item)
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


def present_of(setting: Setting, point: Point) -> list[Floats]:
    """Agents of every class at every state and step."""
    watched = np.arange(len(setting.arrays.names))
    return [_there(item.graph, moves, watched, setting.horizon) for item, moves in moves_of(point)]


def counts_of(setting: Setting, formula: Formula, point: Point) -> CountTrace:
    """The counts that the moves imply at the labels of a formula."""
    system = setting.mission.system
    named = sorted(labels_of(formula))
    site = {label: setting.arrays.states_with(system, label) for label in named}
    watched = np.unique(np.concatenate([*site.values(), np.empty(0, dtype=np.int64)]))
    shape = (len(watched), setting.horizon + 1)
    counts: dict[str | None, Floats] = {None: np.zeros(shape)}
    possible: dict[str | None, Floats] = {None: np.zeros(shape)}
    executions: dict[str, Bools] = {}
    for task, state, when in executions_of(point):
        if state not in watched:
            continue  # of a task that this formula does not name
        done = executions.setdefault(task.task, np.zeros(shape, dtype=np.bool_))
        done[np.searchsorted(watched, state), when] = True
    delay = point.encoded.setting.delay
    for item, moves in moves_of(point):
        where = item.graph, moves, watched, setting.horizon
        present = _there(*where)
        if item.graph.modes is not None and item.graph.modes.standing:
            present[:, 1:] = _stood(*where)
        late = np.zeros(shape)
        if delay:
            late = _there(*where, settled=False)
            for part in _lingering(item.graph, moves):
                _add(late, watched, part)
        for capability in (None, *item.graph.capabilities):
            for table, here in ((counts, present), (possible, late)):
                table[capability] = table.get(capability, np.zeros(shape)) + here
    labels = {label: np.searchsorted(watched, states) for label, states in site.items()}
    return CountTrace(counts, labels, executions, possible if delay else {})


def _there(
    graph: ClassGraph, moves: Moves, watched: Ints, horizon: int, *, settled: bool = True
) -> Floats:
    """Agents at the watched states and steps; if `settled` those that count for sure."""
    table = np.zeros((len(watched), horizon + 1))
    table[:, 0] = graph.start[watched]
    _add(table, watched, _arrivals(graph, moves, settled=settled))
    return table


def _add(table: Floats, watched: Ints, events: Moves) -> None:
    """Add agents at states and steps to a table of the watched states."""
    state, step, count = events
    inside = (step < table.shape[1]) & np.isin(state, watched)
    np.add.at(table, (np.searchsorted(watched, state[inside]), step[inside]), count[inside])


def _arrivals(graph: ClassGraph, moves: Moves, *, settled: bool) -> Moves:
    """State, step and number of agents of every arrival; if `settled` where they count for sure."""
    edge, step, count = moves
    head, ends = graph.head[edge], step + graph.duration[edge]
    if graph.modes is None:
        return head, ends, count
    here = graph.modes.settled[head] if settled else np.ones(len(head), dtype=np.bool_)
    return graph.modes.place[head[here]], ends[here], count[here]


def _stood(graph: ClassGraph, moves: Moves, watched: Ints, horizon: int) -> Floats:
    """How many agents have waited long enough at the watched states, from step 1 on."""
    edge, step, count = moves
    modes = graph.modes
    assert modes is not None
    waits = graph.wait[edge] & (graph.duration[edge] == 1)
    waiting = np.zeros((len(watched), horizon))
    _add(waiting, watched, (graph.tail[edge[waits]], step[waits], count[waits]))
    found = np.array(waiting)
    for ago in range(1, min(modes.delay, horizon)):
        found[:, ago:] = np.minimum(found[:, ago:], waiting[:, : horizon - ago])
    return found


def _lingering(graph: ClassGraph, moves: Moves) -> Iterator[Moves]:
    """Agents that may be at a state still, by their number, less those that are back there."""
    edge, step, count = moves
    modes = graph.modes
    assert modes is not None
    tail, head = modes.place[graph.tail[edge]], modes.place[graph.head[edge]]
    left = np.flatnonzero((tail != head) | (graph.duration[edge] > 1))
    ends = step + graph.duration[edge]
    for ago in range(modes.delay + 1):
        if ago:
            yield tail[left], step[left] + ago, count[left]
        back = np.flatnonzero(modes.lingers[edge] >= ago)
        yield head[back], ends[back] + ago, -count[back]


def rides_of(item: AgentClass, moves: Moves) -> Moves:
    """The moves of a class from state to state: without those of structures that are rebuilt."""
    if item.graph.layer is None:
        return moves
    ride = moves[0] < item.graph.layer.rides
    return moves[0][ride], moves[1][ride], moves[2][ride]


def modules_at(setting: Setting, point: Point) -> list[PoolMoves]:
    """What the modules of every pool do at a point."""
    mission, moved = setting.mission, moves_of(point)
    times: dict[tuple[int, ...], list[Times]] = defaultdict(list)
    for change in setting.changes:
        number, half, count = change.parts[0]
        item, (edges, steps, agents) = moved[number]
        state = setting.arrays.names[change.state]
        times[item.groups] += (
            Times(int(steps[place]), state, change.rule, int(agents[place]) // count)
            for place in np.flatnonzero(edges == item.graph.half(half)).tolist()
        )
    return [
        PoolMoves(
            pool,
            {
                item.shape: listed(setting, item, rides_of(item, moves))
                for item, moves in moved
                if item.shape is not None and item.groups == pool.groups
            },
            times[pool.groups],
        )
        for pool in mission.modular.pools(mission.team)
    ]


def executions_of(point: Point) -> list[tuple[Execution, int, int]]:
    """The task, state and step of every execution at a point."""
    made: Executions = point.encoded.own_columns.get(EXECUTIONS, {})
    return executed_at(made, point.values)


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
    for item, (edge, step, _count) in moves_of(point):
        move = item.graph.travel[edge] > 0
        ends = (step + item.graph.duration[edge])[move]
        last = max(last, int(ends.max(initial=0)))
    return last


def begun_until(setting: Setting) -> int:
    """Last step at which an agent arrives that starts under way, but by a wait; 0 without any."""
    return setting.mission.begun_until


def moving(setting: Setting, point: Point) -> int:
    """Agents that ever move: all but those that can wait at their start to the end."""
    staying = 0
    for item, (edge, step, count) in moves_of(point):
        graph = item.graph
        for state in np.flatnonzero(graph.start).tolist():
            stays = graph.waits(state, setting.horizon)
            if stays is None:
                continue
            pairs = zip(*(part.tolist() for part in stays), strict=True)
            taken = dict.fromkeys(pairs, 0)
            for entry in zip(edge.tolist(), step.tolist(), count.tolist(), strict=True):
                if entry[:2] in taken:
                    taken[entry[:2]] += entry[2]
            staying += graph.modules * min([int(graph.start[state]), *taken.values()])
    return setting.mission.size - int(staying)
