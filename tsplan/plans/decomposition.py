"""From moves to one path per agent.

An integral flow in the map unrolled over time is a sum of paths (Ford and Fulkerson, "Flows in
Networks", 1962, chapter I.2). Whole bundles of agents that share a path are taken off the flow
at once: each one empties an edge at a step or a start, so the work depends on the number of
moves and not on the number of agents.
"""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Sequence
from itertools import islice
from random import Random
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from tsplan.errors import TsplanError
from tsplan.plans.agent_plans import AgentPlan, Stay
from tsplan.plans.moves import Durations, Move, Node, present

if TYPE_CHECKING:
    from tsplan.mission import Agent, Mission


def paths_of(
    mission: Mission,
    members: Sequence[Agent],
    moves: Sequence[Move],
    seed: int | None = None,
    *,
    late: bool = False,
) -> tuple[AgentPlan, ...]:
    """One path per member of one class, which together make its `moves` on the mission's map.

    Where agents may be `late`, whoever came last to a state leaves it first.
    """
    used = {(move.source, move.target) for move in moves}
    durations = {
        pair: edge.duration_for(members[0].class_name) or 0
        for pair, edge in mission.system.edges.items()
        if pair in used
    }
    make = last_first if late else decompose
    return make(members, moves, durations, mission.horizon, seed)


class _Path(NamedTuple):
    stays: tuple[Stay, ...]
    heading: str | None
    agents: int


def decompose(
    members: Sequence[tuple[str, str, frozenset[str], str]],
    moves: Sequence[Move],
    durations: Durations,
    horizon: int,
    seed: int | None = None,
) -> tuple[AgentPlan, ...]:
    """One path per member whose paths together enter every edge exactly as the moves say.

    Members are interchangeable and have an id, a class, capabilities and a start. Agents that can
    wait at their start for the whole time do so; otherwise an agent that can wait does, before any
    that can move moves, and edges are taken in the order of `durations`. The result is in the order
    of the members and the same for equal moves and seeds; another seed gives the paths to other
    members of the same start and mixes which arrivals take which departure. Raises TsplanError for
    moves that lose or create agents.
    """
    waiting: dict[str, list[int]] = defaultdict(list)
    for place, (_, _, _, start) in enumerate(members):
        waiting[start].append(place)
    if seed is not None:
        random = Random(seed)  # noqa: S311  (reproducible choice, not a secret)
        for places in waiting.values():
            random.shuffle(places)
    flow = _Unrolled(moves, durations, horizon, seed)
    flow.refuse_unless_conserved({state: len(places) for state, places in waiting.items()})
    bundles = {state: [flow.patient(state, len(places))] for state, places in waiting.items()}
    paths: list[AgentPlan | None] = [None] * len(members)
    for state, places in waiting.items():
        rest = len(places) - bundles[state][0].agents
        line = iter(places)
        for stays, heading, agents in bundles[state] + flow.paths(state, rest):
            for place in islice(line, agents):
                paths[place] = AgentPlan(*members[place][:3], stays, heading)
    return tuple(agent for agent in paths if agent is not None)


def last_first(
    members: Sequence[tuple[str, str, frozenset[str], str]],
    moves: Sequence[Move],
    durations: Durations,
    horizon: int,
    seed: int | None = None,
) -> tuple[AgentPlan, ...]:
    """As `decompose`, with paths by which whoever came last to a state leaves it first.

    Then at every state and step as many agents as can be have been there for any number of steps.
    """
    order = list(range(len(members)))
    if seed is not None:
        Random(seed).shuffle(order)  # noqa: S311  (reproducible choice, not a secret)
    _Unrolled(moves, durations, horizon, None).refuse_unless_conserved(
        Counter(start for *_, start in members)
    )
    stacks = _Stacks(moves, durations, horizon)
    for number in order:
        stacks.coming[0][members[number][3]].append(number)
    stays, heading = stacks.paths()
    return tuple(
        AgentPlan(*member[:3], tuple(stays[number]), heading.get(number))
        for number, member in enumerate(members)
    )


class _Stacks:
    """Who is at each state in the order of arrival; `coming` has who will come there at a step."""

    def __init__(self, moves: Sequence[Move], durations: Durations, horizon: int) -> None:
        self._durations = durations
        self._horizon = horizon
        self._going: dict[int, list[Move]] = defaultdict(list)
        for move in moves:
            if durations[move.source, move.target] > 1 or not move.is_wait:
                self._going[move.step].append(move)
        self.coming: dict[int, dict[str, list[int]]] = defaultdict(lambda: defaultdict(list))
        self._there: dict[str, list[tuple[int, int]]] = defaultdict(list)  # who, and since when

    def paths(self) -> tuple[dict[int, list[Stay]], dict[int, str]]:
        """The stays of everybody, and where those are going that are still on their way."""
        stays: dict[int, list[Stay]] = defaultdict(list)
        heading: dict[int, str] = {}
        for step in range(self._horizon + 1):
            for state, numbers in self.coming[step].items():
                self._there[state] += [(number, step) for number in numbers]
            for move in self._going[step]:
                arrival = step + self._durations[move.source, move.target]
                for _ in range(move.count):
                    number, since = self._there[move.source].pop()
                    stays[number].append((since, step, move.source))
                    self.coming[arrival][move.target].append(number)
                    if arrival > self._horizon:
                        heading[number] = move.target
        for state, people in self._there.items():
            for number, since in people:
                stays[number].append((since, self._horizon, state))
        return stays, heading


class _Unrolled:
    """What is left of a flow: for every state and step, how many agents still leave whereto."""

    def __init__(
        self, moves: Sequence[Move], durations: Durations, horizon: int, seed: int | None
    ) -> None:
        self.moves = moves
        self.durations = durations
        self.horizon = horizon
        self.left: dict[Node, dict[str, int]] = defaultdict(dict)
        rank = {pair: number for number, pair in enumerate(durations)}
        entries = sorted(moves, key=lambda move: (rank[move.source, move.target], move.step))
        if seed is not None:
            order = np.random.default_rng(seed).permutation(len(entries))
            entries = [entries[place] for place in order]
        for move in entries:
            step, source, target, count = move
            if not 0 <= step < horizon or count < 0:
                raise TsplanError(f"the move {tuple(move)} is impossible (report this)")
            if count:
                leaving = self.left[source, step]
                leaving[target] = leaving.get(target, 0) + count
        for (state, _), leaving in self.left.items():  # waits first
            for target in [target for target in leaving if target != state]:
                leaving[target] = leaving.pop(target)

    def refuse_unless_conserved(self, starts: dict[str, int]) -> None:
        """Raise unless at every state and step as many agents leave as have come."""
        here = present(starts, self.moves, self.durations, self.horizon)
        for node in sorted({*here, *self.left}, key=lambda node: (node[1], node[0])):
            state, step = node
            gone = sum(self.left[node].values()) if node in self.left else 0
            if step < self.horizon and gone != here.get(node, 0):
                raise TsplanError(
                    f"the flow is not conserved: {here.get(node, 0)} agents are at {state} at "
                    f"step {step} and {gone} leave (report this)"
                )

    def patient(self, start: str, agents: int) -> _Path:
        """Take off as many of `agents` as can wait at `start` to the end, perhaps none.

        To be called for every start before `paths`: agents that come by later must not use up
        the waiting of agents that could stay at home.
        """
        taken, step = [], 0
        while step < self.horizon:
            if start not in self.left.get((start, step), {}):
                return _Path(((0, 0, start),), None, 0)
            taken.append((start, step, start))
            step += self.durations[start, start]
        return self._take(start, taken, agents)

    def paths(self, start: str, agents: int) -> list[_Path]:
        """Take off paths from `start` until all of its `agents` have one."""
        bundles = []
        while agents > 0:
            taken, state, step = [], start, 0
            while step < self.horizon:
                target = next(iter(self.left[state, step]))
                taken.append((state, step, target))
                state, step = target, step + self.durations[state, target]
            bundles.append(self._take(start, taken, agents))
            agents -= bundles[-1].agents
        return bundles

    def _take(self, start: str, taken: list[tuple[str, int, str]], agents: int) -> _Path:
        """Take some path off the flow, for as many agents as it is left for."""
        share = min([agents, *(self.left[state, step][target] for state, step, target in taken)])
        for state, step, target in taken if share else ():
            leaving = self.left[state, step]
            leaving[target] -= share
            if not leaving[target]:
                del leaving[target]
        return _Path(*self._stays(start, taken), share)

    def _stays(
        self, start: str, taken: list[tuple[str, int, str]]
    ) -> tuple[tuple[Stay, ...], str | None]:
        stays: list[Stay] = []
        since, last, state, heading = 0, 0, start, None
        for source, step, target in taken:
            arrival = step + self.durations[source, target]
            if arrival > self.horizon:
                heading = target
            elif source == target and arrival == step + 1:
                last = arrival
            else:
                stays.append((since, last, state))
                since, last, state = arrival, arrival, target
        return (*stays, (since, last, state)), heading
