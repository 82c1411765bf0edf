"""From counted flows to one path per agent.

An integral flow in the map unrolled over time is a sum of paths (Ford and Fulkerson, "Flows in
Networks", 1962, chapter I.2). Whole bundles of agents that share a path are taken off the flow
at once: each one empties an edge at a step or a start, so the work depends on the number of
nonzero entries and not on the number of agents.
"""

from __future__ import annotations

from collections import defaultdict
from dataclasses import dataclass
from itertools import islice
from random import Random
from typing import TYPE_CHECKING, NamedTuple, TypeAlias

import numpy as np

from tsplan.errors import TsplanError
from tsplan.plans.plan import AgentPlan, Stay

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from tsplan.milp.model import Ints
    from tsplan.mission import Agent, Mission
    from tsplan.plans.moves import Move
    from tsplan.ts import TransitionSystem


class FlowEdge(NamedTuple):
    """An edge of the map and the steps it takes the class to travel it."""

    source: str
    target: str
    duration: int


@dataclass(frozen=True, eq=False)
class ClassFlow:
    """The flow of one class of interchangeable agents.

    `members` have an id, a class, capabilities and a start. `edge`, `step` and `count` are arrays
    of equal length: `count[i]` agents enter `edges[edge[i]]` at step `step[i]`. Only entries that
    are not zero need to be there.
    """

    members: Sequence[tuple[str, str, frozenset[str], str]]
    edges: Sequence[tuple[str, str, int]]
    edge: Ints
    step: Ints
    count: Ints


_Entry: TypeAlias = tuple[tuple[str, int], int]  # (state, step) and the edge entered there


class _Path(NamedTuple):
    stays: tuple[Stay, ...]
    heading: str | None
    agents: int


def decompose(flow: ClassFlow, horizon: int, seed: int | None = None) -> tuple[AgentPlan, ...]:
    """One path per member of `flow` whose paths together enter every edge exactly as counted.

    Agents that can wait at their start for the whole time do so; otherwise an agent that can
    wait does, before any that can move moves. The result is in the order of the members and the
    same for equal flows and seeds; another seed gives the paths to other members of the same
    start and mixes which arrivals take which departure. Raises TsplanError for a flow that
    loses or creates agents.
    """
    waiting: dict[str, list[int]] = defaultdict(list)
    for place, (_, _, _, start) in enumerate(flow.members):
        waiting[start].append(place)
    if seed is not None:
        random = Random(seed)  # noqa: S311  (reproducible choice, not a secret)
        for places in waiting.values():
            random.shuffle(places)
    network = _Unrolled(flow, horizon, seed)
    network.refuse_unless_conserved({state: len(places) for state, places in waiting.items()})
    shares = {state: [network.patient(state, len(places))] for state, places in waiting.items()}
    for state, places in waiting.items():
        rest = len(places) - shares[state][0].agents
        shares[state] += network.paths(state, rest)
    given: list[tuple[tuple[Stay, ...], str | None]] = [((), None)] * len(flow.members)
    for state, places in waiting.items():
        line = iter(places)
        for stays, heading, agents in shares[state]:
            way = stays, heading
            for place in islice(line, agents):
                given[place] = way
    return tuple(
        AgentPlan(name, class_name, capabilities, stays, heading)
        for (name, class_name, capabilities, _), (stays, heading) in zip(
            flow.members, given, strict=True
        )
    )


def agents_of(
    mission: Mission, moves: Mapping[str, Sequence[Move]], seed: int | None = None
) -> tuple[AgentPlan, ...]:
    """One path per agent of the classes in `moves`, which must fit the mission, in its order."""
    members: dict[str, list[Agent]] = {}
    for agent in mission.members(moves):
        members.setdefault(agent.class_name, []).append(agent)
    return tuple(
        path
        for name, agents in members.items()
        for path in decompose(_flow(mission.system, agents, moves[name]), mission.horizon, seed)
    )


def _flow(system: TransitionSystem, members: Sequence[Agent], moves: Sequence[Move]) -> ClassFlow:
    """The moves of one swarm as a flow that can be decomposed into paths."""
    pairs = sorted({(move.source, move.target) for move in moves})
    number = {pair: place for place, pair in enumerate(pairs)}
    entries = [(number[move.source, move.target], move.step, move.count) for move in moves]
    columns = np.array(entries, dtype=np.int64).reshape(-1, 3).T
    swarm = members[0].class_name
    return ClassFlow(
        members=members,
        edges=[(*pair, system.edges[pair].duration_for(swarm) or 0) for pair in pairs],
        edge=columns[0],
        step=columns[1],
        count=columns[2],
    )


class _Unrolled:
    """What is left of a flow: for every state and step, the edges that agents still enter."""

    def __init__(self, flow: ClassFlow, horizon: int, seed: int | None) -> None:
        self.edges = [FlowEdge(*edge) for edge in flow.edges]
        self.horizon = horizon
        self.left: dict[tuple[str, int], dict[int, int]] = {}
        order = np.lexsort((flow.step, flow.edge))
        if seed is not None:
            order = order[np.random.default_rng(seed).permutation(len(order))]
        entries = (flow.edge[order], flow.step[order], flow.count[order])
        for edge, step, count in zip(*(column.tolist() for column in entries), strict=True):
            self._add(edge, step, count)
        for leaving in self.left.values():
            self._waits_first(leaving)

    def _add(self, edge: int, step: int, count: int) -> None:
        if not 0 <= step < self.horizon or count < 0 or count != int(count):
            where = f"edge {tuple(self.edges[edge])} at step {step}"
            raise TsplanError(f"a flow of {count} into {where} is impossible (report this)")
        if count:
            leaving = self.left.setdefault((self.edges[edge].source, step), {})
            leaving[edge] = leaving.get(edge, 0) + int(count)

    def _waits_first(self, leaving: dict[int, int]) -> None:
        for edge in [e for e in leaving if self.edges[e].source != self.edges[e].target]:
            leaving[edge] = leaving.pop(edge)

    def refuse_unless_conserved(self, starts: dict[str, int]) -> None:
        """Raise unless at every state and step as many agents leave as have come."""
        present = {(state, 0): count for state, count in starts.items()}
        for (_, step), leaving in self.left.items():
            for edge, count in leaving.items():
                _, target, duration = self.edges[edge]
                arrival = (target, step + duration)
                present[arrival] = present.get(arrival, 0) + count
        for node in sorted({*present, *self.left}, key=lambda node: (node[1], node[0])):
            state, step = node
            if step >= self.horizon:
                break
            gone = sum(self.left.get(node, {}).values())
            if gone != present.get(node, 0):
                raise TsplanError(
                    f"the flow is not conserved: {present.get(node, 0)} agents are at {state} at "
                    f"step {step} and {gone} leave (report this)"
                )

    def patient(self, start: str, agents: int) -> _Path:
        """Take off as many of `agents` as can wait at `start` to the end, perhaps none.

        To be called for every start before `paths`: agents that come by later must not use up
        the waiting of agents that could stay at home.
        """
        taken, step = [], 0
        while step < self.horizon:
            node = (start, step)
            edge = next(iter(self.left.get(node, ())), None)
            if edge is None or self.edges[edge].target != start:
                return _Path(((0, 0, start),), None, 0)
            taken.append((node, edge))
            step += self.edges[edge].duration
        return self._take(start, taken, agents)

    def paths(self, start: str, agents: int) -> list[_Path]:
        """Take off paths from `start` until all of its `agents` have one."""
        found = []
        while agents > 0:
            found.append(self._take(start, self._following(start), agents))
            agents -= found[-1].agents
        return found

    def _take(self, start: str, taken: list[_Entry], agents: int) -> _Path:
        share = min([agents, *(self.left[node][edge] for node, edge in taken)])
        for node, edge in taken if share else ():
            self.left[node][edge] -= share
            if not self.left[node][edge]:
                del self.left[node][edge]
        return _Path(*self._stays(start, taken), share)

    def _following(self, start: str) -> list[_Entry]:
        """Some path from `start` at step 0 along edges that still have flow."""
        taken, node = [], (start, 0)
        while node[1] < self.horizon:
            edge = next(iter(self.left[node]))
            taken.append((node, edge))
            node = (self.edges[edge].target, node[1] + self.edges[edge].duration)
        return taken

    def _stays(self, start: str, taken: list[_Entry]) -> tuple[tuple[Stay, ...], str | None]:
        stays: list[Stay] = []
        since, last, state, heading = 0, 0, start, None
        for (_, step), edge in taken:
            source, target, duration = self.edges[edge]
            arrival = step + duration
            if arrival > self.horizon:
                heading = target
            elif source == target and duration == 1:
                last = arrival
            else:
                stays.append((since, last, state))
                since, last, state = arrival, arrival, target
        return (*stays, (since, last, state)), heading
