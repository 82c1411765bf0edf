"""Where everybody has been until a step, and where everybody is then."""

from __future__ import annotations

from collections import Counter
from collections.abc import Container, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, NamedTuple, TypeAlias

from tsplan.errors import Finding, PlanError
from tsplan.history.past_moves import moves_before
from tsplan.mission.team import UnderWay
from tsplan.name_runs import Run, RunMap
from tsplan.plans.agent_plans import Stay, joined
from tsplan.plans.bundles import Agents, Bundle
from tsplan.plans.cargo_rows import CargoRows
from tsplan.plans.worlds import Newcomers, OnEdge, World

if TYPE_CHECKING:
    from tsplan.history.changed_map import Maps
    from tsplan.mission import Mission
    from tsplan.plans.moves import Move
    from tsplan.plans.plan import Plan
    from tsplan.plans.subswarms import SubSwarm
    from tsplan.plans.supplies import ExecutedTask

Whereabouts: TypeAlias = str | OnEdge
"""The state that somebody is at, or between which states and until when somebody is under way."""


class Joining(NamedTuple):
    """Agents that join at a step, with their names."""

    names: Run
    group: Newcomers
    step: int


class Past(NamedTuple):
    """The paths of robots until a step, and the moves of swarms before it, by their names.

    So are what robots carried and the tasks that were begun before it.
    """

    agents: Agents
    moves: Mapping[str, tuple[Move, ...]]
    groups: tuple[SubSwarm, ...] = ()
    cargo: CargoRows = CargoRows()
    executions: tuple[ExecutedTask, ...] = ()

    @classmethod
    def of(cls, mission: Mission, plan: Plan, step: int) -> Past:
        """What happened by a plan as it stands."""
        paths = robots_of(mission, plan).stretches
        return cls.along(((names, until(path, step)) for names, path in paths), plan, step)

    @classmethod
    def along(cls, paths: Iterable[tuple[Run, Bundle]], plan: Plan, step: int) -> Past:
        """What happened by a plan but for the paths of its robots."""
        rows = (row for row in CargoRows.of(plan.cargo).order if row.step < step)
        begun = (
            replace(each, given_up=None) if (each.given_up or 0) >= step else each
            for each in plan.executions
            if each.step < step
        )
        own = moves_before(plan, step), plan.groups, CargoRows.joined(rows), tuple(begun)
        return cls(Agents.along(paths), *own)


def robots_of(mission: Mission, plan: Plan) -> Agents:
    """The agents of a plan that are of no swarm."""
    return Agents.of(plan.agents).only(lambda b: mission.group_bounds(b.class_name) is None)


class Now(NamedTuple):
    """Agents in a row that are at one place at a step, with what they have done until then.

    `load` is what each of them carries that is under way.
    """

    names: Run
    path: Bundle
    place: Whereabouts
    load: tuple[tuple[str, float], ...] = ()


def clipped(stays: Iterable[Stay], last: int) -> tuple[Stay, ...]:
    """Stays as far as they begin by a step, ending there at the latest.

    >>> clipped([(0, 2, "p"), (4, 9, "q"), (11, 12, "p")], 6)
    ((0, 2, 'p'), (4, 6, 'q'))
    """
    return tuple((first, min(end, last), state) for first, end, state in stays if first <= last)


def until(path: Bundle, step: int) -> Bundle:
    """A path until a step, heading for where it goes on if it is on an edge then.

    >>> made = until(Bundle("a", frozenset(), ((0, 2, "p"), (4, 9, "q")), None), 3)
    >>> made.stays, made.heading
    (((0, 2, 'p'),), 'q')
    """
    stays = clipped(path.stays, step)
    later = path.stays[len(stays) :]
    away = not stays or stays[-1][1] < step
    heading = (later[0][2] if later else path.heading) if away else None
    return replace(path, stays=stays, heading=heading)


def really(mission: Mission, plan: Plan, world: World, maps: Maps) -> Past:
    """What happened by a plan until the step of a world, as it was by what that says.

    Those that join there are among them.

    Raises PlanError for what it says of agents and cannot be.
    """
    worlds, before = (*plan.replanned, world), lost_in(plan.replanned)
    named = _named(worlds)
    findings = list(_unknown(plan, world, before))
    paths: list[tuple[Run, Bundle]] = []
    for names, path in robots_of(mission, plan).stretches:
        for part, name in named.parts(names):
            if name is None:
                paths.append((part, until(path, world.step)))
                continue
            try:
                told = path if name in before else _As(world, maps).told(name, path)
            except PlanError as error:
                findings += error.findings
                continue
            paths.append((part, told))
    if findings:
        raise PlanError(findings)
    for names, group, _ in newcomers(mission, worlds)[-len(world.added) :] if world.added else ():
        maps.known_state(group.at, f"agent {names.name()}")
        stays = ((world.step, world.step, group.at),)
        paths.append((names, Bundle(group.class_name, _able(mission, group), stays, None)))
    seen = (each for each in paths if each[1].stays or each[1].heading)
    return Past.along(seen, plan, world.step)


def _unknown(plan: Plan, world: World, before: Container[str]) -> Iterator[Finding]:
    """Agents of which a world tells, and that the plan does not have, or not any more."""
    for name in _told_of(world):
        if name not in plan.agent:
            remedy = "name agents as the plan does, such as scout-1"
            yield Finding(f"the plan has no agent '{name}'", remedy)
        elif name in before:
            yield Finding(f"agent {name} has been lost before")


def _able(mission: Mission, group: Newcomers) -> frozenset[str]:
    """What newcomers can do: what is said, or what the others of their class can."""
    alike = (each for each in mission.team if each.class_name == group.class_name)
    return group.capabilities or next((each.capabilities for each in alike), frozenset())


def whereabouts(
    mission: Mission, agents: Agents, worlds: Sequence[World], maps: Maps
) -> Iterator[Now]:
    """Where the agents that are not lost are at the step of the last of some worlds.

    `agents` have their paths until then. Whoever is on an edge arrives when its duration is over,
    and later by what the worlds say. Raises PlanError where that cannot be told.
    """
    lost, named = lost_in(worlds), _named(worlds)
    for names, path in agents.stretches:
        for part, name in named.parts(names):
            if name is None or name not in lost:
                first = name or part.name()
                way = _begun(mission, first, path, maps)
                yield Now(part, path, _place(path, first, worlds, way))


def newcomers(mission: Mission, worlds: Iterable[World]) -> list[Joining]:
    """Everybody who joins in some worlds; names go on from those of the class that are there."""
    last: Counter[str] = Counter()
    for member in mission.team:
        last[member.class_name] += member.count
    made = []
    for world in worlds:
        for group in world.added:
            first = last[group.class_name] + 1
            last[group.class_name] += group.count
            names = Run(f"{group.class_name}-", first, last[group.class_name])
            made.append(Joining(names, group, world.step))
    return made


def lost_in(worlds: Iterable[World]) -> frozenset[str]:
    """Everybody who is lost in some worlds."""
    return frozenset(name for world in worlds for name in world.lost)


def _told_of(world: World) -> tuple[str, ...]:
    return (*world.lost, *world.moved, *world.late)


def _named(worlds: Iterable[World]) -> RunMap[str]:
    """Everybody of whom some worlds tell."""
    return RunMap((Run.of(name), name) for world in worlds for name in _told_of(world))


def _begun(mission: Mission, name: str, path: Bundle, maps: Maps) -> OnEdge | None:
    """How an agent is under way that heads for somewhere at the end of its path, by the map."""
    if path.heading is None:
        return None
    if path.stays:
        _, depart, state = path.stays[-1]
        return maps.ride(path, name, (state, path.heading), depart)
    rank = mission.roster.get(name)
    assert rank is not None
    assert isinstance(rank.start, UnderWay)
    return OnEdge(rank.start.origin, rank.start.target, rank.start.arrives)


def _place(path: Bundle, name: str, worlds: Sequence[World], way: OnEdge | None) -> Whereabouts:
    """Where an agent is at the end of its path, given how it is under way by the map."""
    depart, state = (path.stays[-1][1:]) if path.stays else (-1, None)
    if state is not None and depart >= worlds[-1].step:
        return state
    for world in worlds:
        if world.step <= depart:
            continue
        moved, late = world.moved.get(name), world.late.get(name)
        if isinstance(moved, OnEdge):
            way = moved
        if late is not None and way is not None:
            way = replace(way, arrives=way.arrives + late)
    if way is None:
        what = f"agent {name} is nowhere after step {depart}, and it is not said where it goes"
        raise PlanError([Finding(what, f"say where it is at step {worlds[-1].step}")])
    if way.arrives <= worlds[-1].step:
        what = f"agent {name} is to be on its way to {way.target} at step {worlds[-1].step}"
        raise PlanError([Finding(f"{what}, and arrives there at step {way.arrives}")])
    return way


@dataclass(frozen=True)
class _As:
    """Paths as a world says that they were until its step."""

    world: World
    maps: Maps

    def told(self, name: str, path: Bundle) -> Bundle:
        """The path of an agent."""
        world = self.world
        self._refuse_twice(name)
        if name in world.lost:
            return replace(path, stays=clipped(path.stays, world.step - 1), heading=None)
        if name in world.moved:
            return self._moved(name, path)
        return self._late(name, path) if name in world.late else until(path, world.step)

    def _refuse_twice(self, name: str) -> None:
        said = [word for word in ("lost", "moved", "late") if name in getattr(self.world, word)]
        if len(said) > 1:
            raise PlanError(
                [Finding(f"agent {name} is said to be {' and '.join(said)}", "say one")]
            )

    def _moved(self, name: str, path: Bundle) -> Bundle:
        step, place = self.world.step, self.world.moved[name]
        before = clipped(path.stays, step - 1)
        if isinstance(place, OnEdge):
            ends = [place.source, place.target]
            if place.arrives <= step:
                what = f"agent {name} arrives at step {place.arrives}, and it is step {step}"
                raise PlanError([Finding(what, f"write a later step, or that it is at {ends[1]}")])
        else:
            ends = [place]
        for state in ends:
            self.maps.known_state(state, f"agent {name}")
        if isinstance(place, OnEdge):
            return replace(path, stays=before, heading=place.target)
        return replace(path, stays=tuple(joined([*before, (step, step, place)])), heading=None)

    def _late(self, name: str, path: Bundle) -> Bundle:
        step, late = self.world.step, self.world.late[name]
        made = until(path, step)
        if made.heading is not None:  # it is on the edge still
            return made
        *before, (first, last, state) = made.stays
        if not (before or path.coming):
            what = f"agent {name} has not moved by step {step}, so it is not late"
            raise PlanError([Finding(what, "say where it is with 'moved'")])
        if first + late <= step:
            return replace(made, stays=(*before, (first + late, last, state)))
        return replace(made, stays=tuple(before), heading=state)
