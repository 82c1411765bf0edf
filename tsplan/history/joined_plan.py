"""What has happened and the plan of the rest as one plan, and the rest of such a plan."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Generator, Iterable, Iterator
from dataclasses import replace
from typing import TYPE_CHECKING, NamedTuple, TypeAlias

from tsplan.history.joined_amounts import (
    cargo_from,
    executions_from,
    joined_amounts,
    stocks_from,
)
from tsplan.history.joined_structures import (
    joined_structures,
    modules_along,
    structures_from,
)
from tsplan.history.past_moves import groups_from, joined_groups, joined_moves
from tsplan.history.past_paths import Past
from tsplan.history.rest_mission import STABLE, Rest, rest_of
from tsplan.history.told_paths import ahead, followed_by
from tsplan.mission.intended_paths import Intended
from tsplan.mission.team import UnderWay
from tsplan.name_runs import Run, RunMap, counterpart
from tsplan.plans.agent_plans import Stay
from tsplan.plans.bundles import Agents, Bundle
from tsplan.plans.outcomes import ObjectiveValue, Status
from tsplan.plans.worlds import Ahead, World
from tsplan.stopping import StoppedBy

if TYPE_CHECKING:
    from tsplan.mission import Mission, Rank
    from tsplan.plans.plan import Plan


def rest_of_plan(mission: Mission, plan: Plan) -> tuple[Rest, Plan]:
    """What was left of the mission of a plan when it was replanned last, and the plan for that.

    Raises PlanError and MissionError as `rest_of` does.
    """
    step = plan.replanned[-1].step
    rest = rest_of(mission, plan.replanned, Past.of(mission, plan, step))
    objective = tuple(_told(item, -step) for item in plan.objective)
    cut = replace(
        planned_ahead(rest, plan),
        objective=objective,
        horizon=plan.horizon - step,
        stocks=stocks_from(plan.stocks, step),
        moves={
            swarm: tuple(m._replace(step=m.step - step) for m in moves if m.step >= step)
            for swarm, moves in plan.moves.items()
        },
        groups=groups_from(plan.groups, step),
    )
    return with_intended(rest, planned_ahead(rest, _as_before(plan))), cut


def _as_before(plan: Plan) -> Plan:
    """A plan in which those that changed their ways last have their former ones."""
    former = plan.replanned[-1].former
    named = RunMap((Run.of(name), ahead) for name, ahead in former.items())
    stretches = (
        (part, path if a is None else replace(path, stays=a.stays, heading=a.heading))
        for names, path in Agents.of(plan.agents).stretches
        for part, a in named.parts(names)
    )
    return replace(plan, agents=Agents.along(stretches))


def _told(item: ObjectiveValue, later: int) -> ObjectiveValue:
    """The value of an objective, which is a step if it is that of the last arrival."""
    if item.name != "makespan":
        return item
    value, bound = (told + later if told else told for told in (item.value, item.bound))
    return replace(item, value=value, bound=bound)


def renamed(rest: Rest) -> Iterator[tuple[Run, Run, str | None]]:
    """Robots in a row as the plan and as the rest of the mission name them.

    Those that are under way then come with the state that they left.
    """
    for rank, runs in zip(rest.mission.ranks, rest.names, strict=True):
        origin = rank.start.origin if isinstance(rank.start, UnderWay) else None
        begin = 0
        for run in runs:
            yield run, rank.names.part(begin, begin + run.size), origin
            begin += run.size


def planned_ahead(rest: Rest, plan: Plan) -> Plan:
    """What a plan has for the robots of a rest, under their names there, from its step on."""
    structures, rebuilt = structures_from(plan, rest)
    modular = {each.class_name for each in structures}  # whose ways are those of structures
    own = RunMap(Agents.of(plan.agents).stretches)
    stretches = []
    for old, new, origin in renamed(rest):
        for part, path in _each(old, new, own):
            stays, heading = _ahead(path, rest.step)
            if (stays or heading) and path.class_name not in modular:
                stretches.append((part, replace(path, stays=stays, heading=heading, coming=origin)))
    names = RunMap((old, (old, new)) for old, new, _ in renamed(rest))
    if structures:
        stretches += modules_along(rest.mission.agents, structures)
    for each in structures:
        names.give(Run.of(each.id), (Run.of(each.id), Run.of(each.id)))
    return replace(
        plan,
        agents=Agents.along(stretches),
        structures=structures,
        rebuilt=rebuilt,
        cargo=cargo_from(plan.cargo, rest.step, names),
        executions=executions_from(plan.executions, rest),
        horizon=rest.mission.horizon,
        replanned=(),
    )


def with_intended(rest: Rest, before: Plan) -> Rest:
    """A rest whose robots were to take the paths that a plan of theirs has, where these begin.

    Nothing changes where no objective is about that.
    """
    if not set(STABLE).intersection(rest.mission.objective):
        return rest
    own, last = RunMap(Agents.of(before.agents).stretches), rest.mission.horizon
    intended = [
        Intended(part, _prolonged(path.stays, last, path.heading), path.heading)
        for rank in rest.mission.ranks
        for part, path in own.parts(rank.names)
        if path is not None and _begins(rank, path)
    ]
    return replace(rest, mission=replace(rest.mission, intended=tuple(intended)))


def _prolonged(stays: tuple[Stay, ...], last: int, heading: str | None) -> tuple[Stay, ...]:
    """Stays of somebody who waits to a step at the end, unless it is under way."""
    if heading is not None or not stays:
        return stays
    return (*stays[:-1], (stays[-1][0], last, stays[-1][2]))


def _begins(rank: Rank, path: Bundle) -> bool:
    """Whether a path begins where robots are, and when they arrive there."""
    first = path.stays[0] if path.stays else (None, None, path.heading)
    if isinstance(rank.start, UnderWay):
        return first[2] == rank.start.target and first[0] in (rank.start.arrives, None)
    return first[0] == 0 and first[2] == rank.start


def _each(old: Run, new: Run, paths: RunMap[Bundle]) -> Iterator[tuple[Run, Bundle]]:
    begin = 0
    for part, path in paths.parts(old):
        if path is not None:
            yield new.part(begin, begin + part.size), path
        begin += part.size


def joined_plan(rest: Rest, plan: Plan, planned: Plan | None = None) -> Plan:
    """The plan of a rest with what has happened before it.

    Of robots that are at one place with the same abilities, as many as can go on as they were
    `planned`.
    """
    taken = _shared_out(rest, plan, planned) if plan.has_paths else []
    built, ids = joined_structures(rest, plan, planned)
    own = RunMap((each.old, each.path) for each in taken)
    step = rest.step
    paths: list[tuple[Run, Bundle]] = []
    for names, past in rest.past.agents.stretches:
        for part, path in own.parts(names):
            paths.append((part, past if path is None else _one(past, path, step)))
    paths += modules_along(rest.past.modules, built.structures)
    mapped = [*(each[:2] for each in taken), *((Run.of(ids[new]), Run.of(new)) for new in ids)]
    return replace(
        plan,
        horizon=rest.horizon,
        objective=tuple(_told(item, step) for item in plan.objective),
        agents=Agents.along(paths) if plan.has_paths else (),
        structures=built.structures if plan.has_paths else (),
        rebuilt=built.rebuilt if plan.has_paths else (),
        **(joined_amounts(rest, plan, mapped) if plan.has_paths else {}),
        moves=joined_moves(rest.past.moves, plan.moves, step),
        groups=joined_groups(rest.past.groups, plan.groups, step) if plan.has_paths else (),
        replanned=(*rest.worlds[:-1], replace(rest.worlds[-1], former=_former(rest, own))),
    )


def ended_plan(plan: Plan, past: Past, world: World) -> Plan:
    """A plan of which nobody is left in a world: what has happened before."""
    modules = modules_along(past.modules, past.built.structures)
    return replace(
        unjudged(plan),
        agents=Agents.along([*past.agents.stretches, *modules]),
        cargo=past.cargo,
        executions=past.executions,
        structures=past.built.structures,
        rebuilt=past.built.rebuilt,
        moves=past.moves,
        groups=past.groups,
        replanned=(*plan.replanned, world),
    )


def unjudged(plan: Plan) -> Plan:
    """A plan whose paths are others than those that were judged."""
    return replace(
        plan,
        status=Status.FEASIBLE,
        stopped_by=StoppedBy.INTERRUPT,
        objective=tuple(ObjectiveValue(item.name, None) for item in plan.objective),
        availability=None,
        stocks=(),
        satisfaction=None,
        preferences=(),
        notes=(),
        verified=False,
    )


def _former(rest: Rest, later: RunMap[Bundle]) -> dict[str, Ahead]:
    """What those were to do that do something else now, where it matters to an objective."""
    intended = RunMap((each.names, each[1:]) for each in rest.mission.intended)
    found = {}
    for old, new, _ in renamed(rest) if len(intended) else ():
        for name, named in zip(old.names(), new.names(), strict=True):
            wanted, path = intended.get(named), later.get(name)
            if wanted is not None and (path is None or wanted != (path.stays, path.heading)):
                stays, heading = wanted
                found[name] = Ahead(followed_by((), stays, rest.step), heading)
    return found


def _one(past: Bundle, later: Bundle, step: int) -> Bundle:
    return replace(past, stays=followed_by(past.stays, later.stays, step), heading=later.heading)


class _Taken(NamedTuple):
    """Robots in a row, as the plan before and as the plan of the rest name them, and their path."""

    old: Run
    new: Run
    path: Bundle


def _shared_out(rest: Rest, plan: Plan, planned: Plan | None) -> list[_Taken]:
    """Who takes which path of the plan of the rest."""
    own = RunMap(Agents.of(plan.agents).stretches)
    if rest.mission.intended:  # who keeps which path is settled
        return [
            _Taken(counterpart(part, new, old), part, path)
            for old, new, _ in renamed(rest)
            for part, path in own.parts(new)
            if path is not None
        ]
    before = RunMap[Bundle](() if planned is None else Agents.of(planned.agents).stretches)
    found: list[_Taken] = []
    for rank, runs in zip(rest.mission.ranks, rest.names, strict=True):
        if rest.mission.team[rank.group].configuration:  # whose ways are those of structures
            continue
        paths = [(part, path) for part, path in own.parts(rank.names) if path is not None]
        asked = [
            (part, None if path is None else _ahead(path, rest.step))
            for run in runs
            for part, path in before.parts(run)
        ]
        found += _matched(paths, asked)
    return found


def _ahead(path: Bundle, step: int) -> _Ahead:
    """What of a path lies ahead of a step, which is its step 0."""
    return ahead(path.stays, step), path.heading


_Ahead: TypeAlias = "tuple[tuple[Stay, ...], str | None]"


def _matched(
    paths: Iterable[tuple[Run, Bundle]], asked: Iterable[tuple[Run, _Ahead | None]]
) -> Iterator[_Taken]:
    """Robots with their paths: whoever can gets the one that was asked for, the others any."""
    free: dict[_Ahead | None, list[tuple[Run, Bundle]]] = defaultdict(list)
    for names, path in paths:
        free[path.stays, path.heading].append((names, path))
    others: list[Run] = []
    for run, wish in asked:
        left = yield from _given_out(run, free.get(wish, []))
        if left is not None:
            others.append(left)
    rest = [each for mine in free.values() for each in mine]
    for run in others:
        yield from _given_out(run, rest)


def _given_out(run: Run, free: list[tuple[Run, Bundle]]) -> Generator[_Taken, None, Run | None]:
    """Robots with paths that are free, as far as there are any; returns those without one."""
    begin = 0
    while begin < run.size:
        if not free:
            return run.part(begin, run.size)
        names, path = free.pop()
        size = min(names.size, run.size - begin)
        yield _Taken(run.part(begin, begin + size), names.part(0, size), path)
        begin += size
        if names.size > size:
            free.append((names.part(size, names.size), path))
    return None
