"""Where everybody has been until a step, and where everybody is then."""

from __future__ import annotations

from collections import Counter
from collections.abc import Container, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, NamedTuple

from tsplan.errors import Finding, PlanError
from tsplan.history.past_moves import moves_before
from tsplan.history.past_structures import Built
from tsplan.history.told_paths import Whereabouts, place_of, told_of, told_path, until
from tsplan.mission.team import UnderWay
from tsplan.name_runs import Run, RunMap
from tsplan.plans.bundles import Agents, Bundle
from tsplan.plans.cargo_rows import CargoRows
from tsplan.plans.worlds import Newcomers, OnEdge, World

if TYPE_CHECKING:
    from tsplan.history.changed_map import Maps, Pace
    from tsplan.mission import Mission
    from tsplan.plans.moves import Move
    from tsplan.plans.plan import Plan
    from tsplan.plans.subswarms import SubSwarm
    from tsplan.plans.supplies import ExecutedTask


class Joining(NamedTuple):
    """Agents that join at a step, with their names."""

    names: Run
    group: Newcomers
    step: int


class Past(NamedTuple):
    """The paths of robots until a step, and the moves of swarms before it, by their names.

    So are what robots carried and the tasks that were begun before it, and of modular robots what
    was `built`; `modules` are who these are.
    """

    agents: Agents
    moves: Mapping[str, tuple[Move, ...]]
    groups: tuple[SubSwarm, ...] = ()
    cargo: CargoRows = CargoRows()
    executions: tuple[ExecutedTask, ...] = ()
    built: Built = Built()
    modules: Agents = Agents(())

    @classmethod
    def of(cls, mission: Mission, plan: Plan, step: int) -> Past:
        """What happened by a plan as it stands."""
        paths = robots_of(mission, plan).stretches
        told = ((names, until(path, step)) for names, path in paths)
        return cls.along(told, plan, Built.of(plan, step), step)

    @classmethod
    def along(
        cls, paths: Iterable[tuple[Run, Bundle]], plan: Plan, built: Built, step: int
    ) -> Past:
        """What happened by a plan but for the paths of its robots and structures."""
        rows = (row for row in CargoRows.of(plan.cargo).order if row.step < step)
        begun = (
            replace(each, given_up=None) if (each.given_up or 0) >= step else each
            for each in plan.executions
            if each.step < step
        )
        own = moves_before(plan, step), plan.groups, CargoRows.joined(rows), tuple(begun)
        modular = {each.class_name for each in plan.structures}
        modules = Agents.of(plan.agents).only(lambda bundle: bundle.class_name in modular)
        return cls(Agents.along(paths), *own, built, modules)


def robots_of(mission: Mission, plan: Plan) -> Agents:
    """The agents of a plan that are of no swarm and no modules."""
    others = {each.class_name for each in plan.structures}
    others |= {group.class_name for group in mission.team if group.configuration}
    return Agents.of(plan.agents).only(
        lambda b: b.class_name not in others and mission.group_bounds(b.class_name) is None
    )


class Now(NamedTuple):
    """Agents in a row that are at one place at a step, with what they have done until then.

    `load` is what each of them carries that is under way, and `configuration` that of the structure
    that modules are part of, which carries it.
    """

    names: Run
    path: Bundle
    place: Whereabouts
    load: tuple[tuple[str, float], ...] = ()
    configuration: str | None = None


def really(mission: Mission, plan: Plan, world: World, maps: Maps) -> Past:
    """What happened by a plan until the step of a world, as it was by what that says.

    Those that join there are among them.

    Raises PlanError for what it says of agents and cannot be.
    """
    worlds, before = (*plan.replanned, world), lost_in(plan.replanned)
    named = _named(worlds)
    findings = list(_unknown(plan, world, before))
    built = Built.of(plan, world.step)
    try:
        built = built.really(world, maps)
    except PlanError as error:
        findings += error.findings
    paths: list[tuple[Run, Bundle]] = []
    for names, path in robots_of(mission, plan).stretches:
        for part, name in named.parts(names):
            if name is None:
                paths.append((part, until(path, world.step)))
                continue
            try:
                told = path if name in before else told_path(world, maps, name, path)
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
    return Past.along(seen, plan, built, world.step)


def _unknown(plan: Plan, world: World, before: Container[str]) -> Iterator[Finding]:
    """Agents of which a world tells, and that the plan does not have, or not any more or yet."""
    known = {each.id for each in Built.of(plan, world.step).structures}
    coming = {each.id for each in plan.structures} - known
    for name in told_of(world):
        if name not in plan.agent and all(name != each.id for each in plan.structures):
            remedy = "name agents as the plan does, such as scout-1"
            yield Finding(f"the plan has no agent '{name}'", remedy)
        elif name in before:
            yield Finding(f"agent {name} has been lost before")
        elif name in coming:
            what = f"structure {name} is not there, nor being made, at step {world.step}"
            yield Finding(what, "tell of what its modules are now")


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
            if name is not None and name in lost:
                continue
            # without stays it is their starts that tell when they arrive
            for some in [part] if path.stays else (p for p, _ in mission.roster.parts(part)):
                first = name or some.name()
                way = _begun(mission, first, path, maps)
                yield Now(some, path, place_of(path, (first,), worlds, way))


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


def _named(worlds: Iterable[World]) -> RunMap[str]:
    """Everybody of whom some worlds tell."""
    return RunMap((Run.of(name), name) for world in worlds for name in told_of(world))


def _begun(mission: Mission, name: str, path: Bundle, maps: Maps) -> OnEdge | None:
    """How an agent is under way that heads for somewhere at the end of its path, by the map."""
    if path.heading is None:
        return None
    if path.stays:
        _, depart, state = path.stays[-1]
        return maps.ride(f"agent {name}", pace_of(path), (state, path.heading), depart)
    return way_from_start(mission, name)


def pace_of(path: Bundle) -> Pace:
    """How long edges take agents on a path."""
    return lambda edge: edge.duration_for(path.class_name)


def way_from_start(mission: Mission, name: str) -> OnEdge:
    """How a robot is under way that starts so and has not arrived."""
    rank = mission.roster.get(name)
    assert rank is not None
    assert isinstance(rank.start, UnderWay)
    return OnEdge(rank.start.origin, rank.start.target, rank.start.arrives)
