"""Modes of a map on which agents may be late: how long an agent has been where it counts.

A node is a state with what matters of the past of an agent there. Where a count is bounded from
below it is for how many steps the agent has been at the state: only those that have been there for
as many steps as they may be late are there for certain. Where a count is bounded from above an
agent counts while it is there and for as many steps after it left; if it is back before that, it
must not count twice, so a node also remembers from which such states the agent comes and how long
ago it left them, as long as it can still be back in time. Everything follows from the moves, so the
flow on the nodes counts exactly.

The idea of counting what holds however late agents are: Y. E. Sahin, P. Nilsson and N. Ozay,
"Multirobot Coordination With Counting Temporal Logics", IEEE T-RO 36(4), 2020, where it takes a
variable for each robot.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import NamedTuple, TypeAlias

import numpy as np

from tsplan.encode.class_columns import ClassColumns
from tsplan.encode.class_graph import ClassGraph, Modes
from tsplan.errors import Finding, MissionError
from tsplan.milp.model import Bools, Draft, Ints
from tsplan.ts.reachability import Lengths

MOST_NODES = 300_000
"""Nodes of one class from which on a delay is refused: there would be no room for a model."""

_Left: TypeAlias = "tuple[tuple[int, int], ...]"  # limited states, and how long ago they were left


class _Node(NamedTuple):
    """A state, for how many steps an agent has been there, and what it left before."""

    state: int
    since: int
    left: _Left = ()


def with_modes(graph: ClassGraph, wanted: Bools, limited: Bools, delay: int) -> ClassGraph:
    """The map of a class whose agents may be `delay` steps late, at least one.

    Agents are counted from below at the `wanted` states and from above at the `limited` ones. The
    first nodes are the states, with agents that have been there long enough to be there for
    certain. Raises MissionError where there would be too many nodes.
    """
    return _Expansion(graph, wanted, limited, delay).result()


def with_standing(graph: ClassGraph, wanted: Bools, delay: int) -> ClassGraph:
    """The map of a swarm whose agents may be late: its nodes are the states.

    From above everybody counts who left within the delay, as if nobody came back.
    """
    travel = graph.travel
    modes = Modes(
        delay=delay,
        place=np.arange(len(graph.start)),
        settled=wanted,
        lingers=np.full(len(travel), -1),
        travel=travel,
        arrives=travel,
        recent=np.zeros(len(graph.start), dtype=np.bool_),
        standing=True,
    )
    return replace(graph, modes=modes)


class _Expansion:
    def __init__(self, graph: ClassGraph, wanted: Bools, limited: Bools, delay: int) -> None:
        self._graph = graph
        self._delay = delay
        self._wanted = wanted.tolist()
        self._limited = limited.tolist()
        self._back = _ways_back(graph, np.flatnonzero(limited), delay)
        count = len(graph.start)
        self._nodes = [_Node(state, delay) for state in range(count)]
        self._number = {node: number for number, node in enumerate(self._nodes)}
        self._tail: list[int] = []
        self._head: list[int] = []
        self._edge: list[int] = []
        self._lingers: list[int] = []

    def result(self) -> ClassGraph:
        graph = self._graph
        leaving: list[list[tuple[int, int, int]]] = [[] for _ in graph.start]
        ends = graph.tail.tolist(), graph.head.tolist(), graph.duration.tolist()
        for edge, (tail, head, duration) in enumerate(zip(*ends, strict=True)):
            leaving[tail].append((edge, head, duration))
        for number, node in enumerate(self._nodes):  # grows meanwhile
            for edge, head, duration in leaving[node.state]:
                after, lingers = self._after(node, head, duration)
                self._tail.append(number)
                self._head.append(self._known(after))
                self._edge.append(edge)
                self._lingers.append(lingers)
        return self._expanded()

    def _known(self, node: _Node) -> int:
        if node not in self._number:
            if len(self._nodes) >= MOST_NODES:
                what = f"with a delay of {self._delay} steps there are too many ways to come back"
                remedy = "choose a smaller delay, or limit agents at fewer states"
                raise MissionError([Finding(what, remedy)])
            self._number[node] = len(self._nodes)
            self._nodes.append(node)
        return self._number[node]

    def _after(self, node: _Node, head: int, duration: int) -> tuple[_Node, int]:
        """The node that an edge leads to, and for how long the agent counts there already."""
        stays = head == node.state and duration == 1
        since = self._delay
        if self._wanted[head]:
            since = min(node.since + 1, self._delay) if stays else 0
        left = [(state, ago + duration) for state, ago in node.left]
        if self._limited[node.state] and not stays:
            left.append((node.state, duration))
        lingers = max((self._delay - ago for state, ago in left if state == head), default=-1)
        never = self._delay + 1
        kept = (
            (state, ago)
            for state, ago in left
            if state != head and ago + self._back[state].get(head, never) <= self._delay
        )
        return _Node(head, since, tuple(sorted(kept))), max(lingers, -1)

    def _expanded(self) -> ClassGraph:
        graph, edge = self._graph, np.array(self._edge, dtype=np.int64)
        extra = len(self._nodes) - len(graph.start)
        duration = graph.duration[edge]
        travel = graph.travel[edge]
        windows = graph.entries and (graph.entries[0][edge], graph.entries[1][edge])
        return replace(
            graph,
            start=np.concatenate([graph.start, np.zeros(extra, dtype=np.int64)]),
            tail=np.array(self._tail, dtype=np.int64),
            head=np.array(self._head, dtype=np.int64),
            duration=duration,
            cost=graph.cost[edge],
            risk=graph.risk[edge],
            group=graph.group[edge],
            entries=windows,
            modes=Modes(
                delay=self._delay,
                place=np.array([node.state for node in self._nodes], dtype=np.int64),
                settled=np.array([node.since == self._delay for node in self._nodes]),
                lingers=np.array(self._lingers, dtype=np.int64),
                travel=travel,
                arrives=travel,
                recent=np.array([bool(node.left) for node in self._nodes]),
            ),
        )


def _ways_back(graph: ClassGraph, limited: Ints, delay: int) -> Mapping[int, dict[int, int]]:
    """For each limited state, how long it takes to it from the states around it."""
    backwards = Lengths(len(graph.start), graph.head, graph.tail, graph.duration)
    found: dict[int, dict[int, int]] = {}
    for state in limited.tolist():
        distance = backwards.nearest([state], limit=float(delay))
        near = np.flatnonzero(distance <= delay)
        found[state] = dict(zip(near.tolist(), distance[near].astype(int).tolist(), strict=True))
    return found


def stood(columns: ClassColumns, horizon: int, draft: Draft) -> ClassColumns:
    """The columns with those of agents that stand long enough at each settled state.

    As many as wait there at each step of a window have been there throughout, if whoever came last
    leaves first.
    """
    graph, modes = columns.graph, columns.graph.modes
    if modes is None or not modes.standing:
        return columns
    found: dict[int, tuple[int, Ints]] = {}
    for state in np.flatnonzero(modes.settled).tolist():
        begun = int(graph.start[state])
        loops = np.flatnonzero((graph.tail == state) & graph.wait & (graph.duration == 1))
        first = 0 if begun else int(columns.arrival[state]) + modes.delay
        last = horizon if len(loops) else 0
        made = draft.columns(max(last - first + 1, 0), upper=float(graph.agents))
        found[state] = first, made
        steps = np.arange(first, last + 1)
        if begun:
            draft.sums((0, made[:1], 1.0), lower=-np.inf, upper=float(begun), kind="stand")
        for ago in range(1, modes.delay + 1):
            place = np.flatnonzero(steps >= ago)
            waits = columns.entered(loops, steps[place] - ago)
            every = np.arange(len(place))
            terms = (*waits, 1.0), (every, made[place], -1.0)
            draft.sums(*terms, count=len(place), kind="stand")
    return replace(columns, stood=found)
