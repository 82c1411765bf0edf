"""From moves to one path per agent.

An integral flow in the map unrolled over time is a sum of paths (Ford and Fulkerson, "Flows in
Networks", 1962, chapter I.2). Whole bundles of agents that share a path are taken off the flow
at once: each one empties an edge at a step or a start, so the work depends on the number of
moves and not on the number of agents.
"""

from __future__ import annotations

from collections import defaultdict, deque
from collections.abc import Iterable, Iterator, Sequence
from random import Random
from typing import TYPE_CHECKING, NamedTuple, TypeAlias

import numpy as np

from tsplan.errors import TsplanError
from tsplan.mission.team import UnderWay
from tsplan.plans.agent_plans import Stay
from tsplan.plans.bundles import Bundle, Stretch
from tsplan.plans.moves import Durations, Move, Node, present

if TYPE_CHECKING:
    from tsplan.mission import Mission, Rank
    from tsplan.name_runs import Run

Walked: TypeAlias = tuple[tuple[Stretch, ...], ...]
"""Of every rank its robots in their order, with their paths."""


def paths_of(
    mission: Mission,
    ranks: Sequence[Rank],
    moves: Sequence[Move],
    seed: int | None = None,
    *,
    late: bool = False,
) -> Walked:
    """One path per robot of one class, which together make its `moves` on the mission's map.

    Where agents may be `late`, whoever came last to a state leaves it first.
    """
    used = {(move.source, move.target) for move in moves}
    durations = {
        pair: edge.duration_for(ranks[0].class_name) or 0
        for pair, edge in mission.system.edges.items()
        if pair in used
    }
    starts = (rank.start for rank in ranks)
    durations |= {(s.place, s.target): s.arrives for s in starts if isinstance(s, UnderWay)}
    make = last_first if late else decompose
    return make(ranks, moves, durations, mission.horizon, seed)


class _Path(NamedTuple):
    stays: tuple[Stay, ...]
    heading: str | None
    agents: int


def decompose(
    ranks: Sequence[Rank],
    moves: Sequence[Move],
    durations: Durations,
    horizon: int,
    seed: int | None = None,
) -> Walked:
    """One path per robot whose paths together enter every edge exactly as the moves say.

    Robots are interchangeable. Those that can wait at their start for the whole time do so;
    otherwise one that can wait does, before any that can move moves, and edges are taken in the
    order of `durations`. The result is the same for equal moves and seeds; another seed gives the
    paths to other robots of the same start and mixes which arrivals take which departure. Raises
    TsplanError for moves that lose or create agents.
    """
    lines = _lines(ranks)
    sizes = {state: sum(names.size for _, names in line) for state, line in lines.items()}
    flow = _Unrolled(moves, durations, horizon, seed)
    flow.refuse_unless_conserved(sizes)
    staying = {state: flow.patient(state, size) for state, size in sizes.items()}
    random = None if seed is None else Random(seed)  # noqa: S311  (reproducible, no secret)
    given: list[list[Stretch]] = [[] for _ in ranks]
    for state, line in lines.items():
        paths = [staying[state], *flow.paths(state, sizes[state] - staying[state].agents)]
        if random is not None:
            random.shuffle(paths)
            line = _turned(line, random.randrange(sizes[state]))  # noqa: PLW2901
        for number, names, path in _dealt(line, paths):
            given[number].append(_stretch(ranks[number], names, *path[:2]))
    return _in_order(given)


_Line: TypeAlias = "list[tuple[int, Run]]"
"""Robots that start at one state: the number of their rank, and their names."""


def _lines(ranks: Iterable[Rank]) -> dict[str, _Line]:
    lines: dict[str, _Line] = defaultdict(list)
    for number, rank in enumerate(ranks):
        lines[rank.place].append((number, rank.names))
    return lines


def _turned(line: _Line, first: int) -> _Line:
    """The line from a place on, and then what comes before it."""
    before: _Line = []
    after: _Line = []
    for number, names in line:
        cut = min(max(first, 0), names.size)
        first -= names.size
        before += [(number, names.part(0, cut))] if cut else []
        after += [(number, names.part(cut, names.size))] if cut < names.size else []
    return after + before


def _dealt(line: _Line, paths: Iterable[_Path]) -> Iterator[tuple[int, Run, _Path]]:
    """Who of a line takes which path: as many as each is for, one after the other."""
    waiting = deque(line)
    for path in paths:
        left = path.agents
        while left:
            number, names = waiting.popleft()
            if names.size > left:
                waiting.appendleft((number, names.part(left, names.size)))
                names = names.part(0, left)
            left -= names.size
            yield number, names, path


def _stretch(rank: Rank, names: Run, stays: tuple[Stay, ...], heading: str | None) -> Stretch:
    start, coming = rank.start, None
    if isinstance(start, UnderWay):  # there they are nowhere
        stays, coming = stays[1:], start.origin
        heading = heading if stays else start.target
    return Stretch(names, Bundle(rank.class_name, rank.capabilities, stays, heading, coming=coming))


def _in_order(given: Iterable[list[Stretch]]) -> Walked:
    return tuple(tuple(sorted(mine, key=lambda each: each.names)) for mine in given)


def last_first(
    ranks: Sequence[Rank],
    moves: Sequence[Move],
    durations: Durations,
    horizon: int,
    seed: int | None = None,
) -> Walked:
    """As `decompose`, with paths by which whoever came last to a state leaves it first.

    Then at every state and step as many agents as can be have been there for any number of steps.
    """
    lines = _lines(ranks)
    sizes = {state: sum(names.size for _, names in line) for state, line in lines.items()}
    _Unrolled(moves, durations, horizon, None).refuse_unless_conserved(sizes)
    random = None if seed is None else Random(seed)  # noqa: S311  (reproducible, no secret)
    stacks = _Stacks(moves, durations, horizon)
    for state, line in lines.items():
        turned = line if random is None else _turned(line, random.randrange(sizes[state]))
        stacks.coming[0][state] += [_Party(*each) for each in turned]
    given: list[list[Stretch]] = [[] for _ in ranks]
    for party in stacks.parties():
        mine = given[party.rank]
        mine.append(_stretch(ranks[party.rank], party.names, party.stays, party.heading))
    return _in_order(given)


class _Party(NamedTuple):
    """Robots of one rank that have gone the same way so far; at a state, `since` when."""

    rank: int
    names: Run
    stays: tuple[Stay, ...] = ()
    since: int = 0
    heading: str | None = None

    def part(self, begin: int, end: int) -> _Party:
        """Some of them."""
        return self._replace(names=self.names.part(begin, end))

    def left(self, step: int, state: str) -> _Party:
        """They once their stay at a state is over."""
        return self._replace(stays=(*self.stays, (self.since, step, state)))


class _Stacks:
    """Who is at each state in the order of arrival; `coming` has who will come there at a step."""

    def __init__(self, moves: Sequence[Move], durations: Durations, horizon: int) -> None:
        self._durations = durations
        self._horizon = horizon
        self._going: dict[int, list[Move]] = defaultdict(list)
        for move in moves:
            if durations[move.source, move.target] > 1 or not move.is_wait:
                self._going[move.step].append(move)
        self.coming: dict[int, dict[str, list[_Party]]] = defaultdict(lambda: defaultdict(list))
        self._there: dict[str, list[_Party]] = defaultdict(list)

    def parties(self) -> Iterator[_Party]:
        """Everybody with all stays, and where those are going that are still on their way."""
        for step in range(self._horizon + 1):
            for state, parties in self.coming.pop(step, {}).items():
                self._there[state] += [party._replace(since=step) for party in parties]
            for move in self._going[step]:
                arrival = step + self._durations[move.source, move.target]
                for party in self._taken(move):
                    gone = party.left(step, move.source)
                    if arrival > self._horizon:
                        yield gone._replace(heading=move.target)
                    else:
                        self.coming[arrival][move.target].append(gone)
        for state, parties in self._there.items():
            yield from (party.left(self._horizon, state) for party in parties)

    def _taken(self, move: Move) -> Iterator[_Party]:
        """As many as move, from the top of the stack of their state."""
        there, left = self._there[move.source], move.count
        while left:
            party = there.pop()
            stay = party.names.size - left
            if stay > 0:
                there.append(party.part(0, stay))
                party = party.part(stay, party.names.size)
            left -= party.names.size
            yield party


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
