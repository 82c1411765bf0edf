"""From moves of structures and reconfigurations to the life of every structure.

Structures of one configuration at one state are interchangeable, so any of them may take any of the
moves that leave there: those that have never moved wait before others do, and all else is given out
in the order in which structures came.
"""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from operator import attrgetter
from typing import TYPE_CHECKING, NamedTuple

from tsplan.errors import TsplanError
from tsplan.mission.team import UnderWay
from tsplan.plans.agent_plans import Stay
from tsplan.plans.bundles import Bundle
from tsplan.plans.structures import ModulePath, Rebuilt, Structure

if TYPE_CHECKING:
    from tsplan.mission import Agent, Mission
    from tsplan.mission.configurations import Pool
    from tsplan.plans.agent_plans import AgentPlan
    from tsplan.plans.moves import Move


class Times(NamedTuple):
    """A reconfiguration, by its place in the mission's list, begins some times at a state."""

    step: int
    state: str
    rule: int
    times: int


@dataclass
class _Body:
    """A structure while its life is told."""

    configuration: str
    modules: tuple[str, ...]
    first: int
    state: str
    id: str = ""
    since: int = 0
    moved: bool = False
    stays: list[Stay] = field(default_factory=list)
    last: int = 0
    heading: str | None = None
    coming: str | None = None

    def leave(self, step: int) -> None:
        """End the stay that is going on."""
        self.stays.append((self.since, step, self.state))
        self.last = step


class PoolMoves(NamedTuple):
    """What the modules of a pool do: moves of each configuration, and what is rebuilt."""

    pool: Pool
    moves: Mapping[str, Sequence[Move]]
    times: Sequence[Times]


def structures_of(
    mission: Mission, moved: Iterable[PoolMoves]
) -> tuple[tuple[Structure, ...], tuple[Rebuilt, ...]]:
    """The structures of all pools of modules, and what is rebuilt in the order of time.

    Raises TsplanError for moves that lose or create structures.
    """
    number: Counter[str] = Counter()
    structures: list[Structure] = []
    rebuilt: list[Rebuilt] = []
    for each in moved:
        lives = _Lives(mission, each, number)
        structures += lives.told()
        rebuilt += lives.rebuilt
    return tuple(structures), tuple(sorted(rebuilt, key=lambda each: each.step))


def module_plan(member: Agent | AgentPlan, path: ModulePath) -> Bundle:
    """The path of a module as a plan has it."""
    own = member.class_name, member.capabilities, path.stays, path.heading
    return Bundle(*own, coming=path.coming)


_HAS_MOVED = attrgetter("moved")


class _Lives:
    """The lives of the structures of one pool, step by step."""

    def __init__(self, mission: Mission, moved: PoolMoves, number: Counter[str]) -> None:
        self._mission = mission
        self._pool = moved.pool
        self._horizon = mission.horizon
        self._group = mission.team[moved.pool.groups[0]]
        self._steps = {
            (shape.name, pair): shape.steps(edge, self._group.class_name) or 0
            for shape in moved.pool.shapes
            for pair, edge in mission.system.edges.items()
        }
        self._going: dict[int, list[tuple[str, Move]]] = defaultdict(list)
        groups = [mission.team[number] for number in moved.pool.groups]
        begun = {way.place for group in groups for way, _ in group.coming}
        for name, mine in moved.moves.items():
            for move in mine:
                if move.source not in begun:  # those are told of as they begin
                    self._going[move.step].append((name, move))
        self._changing: dict[int, list[Times]] = defaultdict(list)
        for each in moved.times:
            self._changing[each.step].append(each)
        self._coming: dict[int, list[_Body]] = defaultdict(list)
        self._there: dict[tuple[str, str], list[_Body]] = defaultdict(list)
        self._number = number
        self._bodies: list[_Body] = []
        self.rebuilt: list[Rebuilt] = []

    def told(self) -> list[Structure]:
        """The structures, in the order in which they come to be."""
        self._begin()
        for step in range(self._horizon + 1):
            for body in self._coming.pop(step, ()):
                body.since = step
                self._there[body.configuration, body.state].append(body)
            if step < self._horizon:
                self._leave(step)
        for bodies in self._there.values():
            for body in bodies:
                body.leave(self._horizon)
        return [self._structure(body) for body in self._bodies]

    def _begin(self) -> None:
        """Modules in the structures in which they start, in the order of the team."""
        for number in self._pool.groups:
            group = self._mission.team[number]
            ranks = (rank for rank in self._mission.ranks if rank.group == number)
            members = [agent for rank in ranks for agent in rank.agents]
            shape = self._mission.modular.of[str(group.configuration)]
            for begin in range(0, len(members), shape.modules):
                mine = members[begin : begin + shape.modules]
                self._starting(shape.name, tuple(each.id for each in mine), mine[0].start)

    def _starting(self, name: str, modules: tuple[str, ...], start: str | UnderWay) -> None:
        """A structure that is there from the beginning, at a state or under way."""
        if not isinstance(start, UnderWay):
            self._add(_Body(name, modules, 0, start), 0)
            return
        body = _Body(name, modules, 0, start.target, moved=True, coming=start.origin)
        body.last = self._horizon
        body.heading = start.target if start.arrives > self._horizon else None
        self._add(body, start.arrives)

    def _born(self, configuration: str, modules: tuple[str, ...], step: int, state: str) -> str:
        """A new structure that is there from a step on; its id, none if that is too late."""
        if step > self._horizon:
            return ""
        return self._add(_Body(configuration, modules, step, state, moved=True), step)

    def _add(self, body: _Body, step: int) -> str:
        """Keep a structure, which comes to its first state at a step; its id."""
        self._number[body.configuration] += 1
        body.id = f"{body.configuration}-{self._number[body.configuration]}"
        self._coming[step].append(body)
        self._bodies.append(body)
        return body.id

    def _leave(self, step: int) -> None:
        """Give out what leaves at a step: short waits first, then moves, then reconfigurations."""
        for bodies in self._there.values():
            bodies.sort(key=_HAS_MOVED)
        kept: dict[tuple[str, str], list[_Body]] = defaultdict(list)

        def length(entry: tuple[str, Move]) -> tuple[bool, int]:
            name, move = entry
            return not move.is_wait, self._steps[name, (move.source, move.target)]

        for name, move in sorted(self._going[step], key=length):
            steps = self._steps[name, (move.source, move.target)]
            taken = self._taken(name, move.source, move.count)
            if move.is_wait and steps == 1:
                kept[name, move.source] += taken
                continue
            for body in taken:
                body.leave(step)
                body.moved |= not move.is_wait
                body.state = move.target
                self._coming[step + steps].append(body)
                if step + steps > self._horizon:
                    body.heading = move.target
        for each in self._changing[step]:
            for _ in range(each.times):
                self._rebuild(each)
        lost = next((node for node, bodies in self._there.items() if bodies), None)
        if lost is not None:
            raise TsplanError(f"structures at {lost[1]} at step {step} are lost (report this)")
        self._there = kept

    def _taken(self, name: str, state: str, count: int) -> list[_Body]:
        """So many of the structures at a state, which leave."""
        there = self._there[name, state]
        if len(there) < count:
            raise TsplanError(f"structures at {state} come from nowhere (report this)")
        taken, self._there[name, state] = there[:count], there[count:]
        return taken

    def _rebuild(self, times: Times) -> None:
        """Structures at a state become others."""
        rule = self._mission.modular.reconfigurations[times.rule]
        parts = [
            body for name, count in rule.parts for body in self._taken(name, times.state, count)
        ]
        for body in parts:
            body.leave(times.step)
        modules = [module for body in parts for module in body.modules]
        made = []
        for name, count in rule.made:
            size = self._mission.modular.of[name].modules
            for _ in range(count):
                mine, modules = modules[:size], modules[size:]
                end = times.step + rule.duration
                made.append(self._born(name, tuple(mine), end, times.state))
        ids = tuple(each for each in made if each)
        before = tuple(body.id for body in parts)
        self.rebuilt.append(Rebuilt(times.step, times.state, times.rule, before, ids))

    def _structure(self, body: _Body) -> Structure:
        shape = self._mission.modular.of[body.configuration]
        return Structure(
            body.id,
            self._group.class_name,
            body.configuration,
            self._group.capabilities | shape.capabilities,
            body.modules,
            body.first,
            self._horizon if body.heading is not None else body.last,
            tuple(body.stays),
            body.heading,
            body.coming,
        )
