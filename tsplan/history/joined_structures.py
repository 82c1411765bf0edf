"""The structures before a step and those of a plan of the rest as one plan has them, and back."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING

from tsplan.history.past_structures import Built
from tsplan.history.told_paths import ahead, followed_by
from tsplan.name_runs import Run
from tsplan.plans.structure_paths import module_plan
from tsplan.plans.structures import Rebuilt, Structure, module_paths

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from tsplan.history.rest_mission import Rest
    from tsplan.mission import Agent
    from tsplan.plans.agent_plans import AgentPlan
    from tsplan.plans.bundles import Bundle
    from tsplan.plans.plan import Plan


def modules_by_rest(rest: Rest) -> dict[str, str]:
    """The modules of a plan by their names in the mission of its rest."""
    modular = rest.mission.team
    return {
        new: old
        for rank, runs in zip(rest.mission.ranks, rest.names, strict=True)
        if modular[rank.group].configuration
        for new, old in zip(
            rank.names.names(), (name for run in runs for name in run.names()), strict=True
        )
    }


def joined_structures(
    rest: Rest, plan: Plan, planned: Plan | None = None
) -> tuple[Built, Mapping[str, str]]:
    """All structures and what is rebuilt, and the ids of those of the plan of the rest.

    Structures that were `planned` alike before are called as they were then.
    """
    step, old = rest.step, modules_by_rest(rest)
    before = {each.id: each for each in rest.past.built.structures}
    open_ = {frozenset(each.modules): each for each in before.values() if each.last >= step}
    names = _Names(step, () if planned is None else planned.structures, before)
    ids: dict[str, str] = {}
    later: dict[str, Structure] = {}
    new: list[Structure] = []
    for each in plan.structures:
        modules = tuple(old[module] for module in each.modules)
        known = open_.get(frozenset(modules)) if not each.first else None
        ids[each.id] = name = known.id if known else names.of(each, modules)
        if known or each.stays:  # else it comes to be after the end
            later[name] = _later(each, known, name, modules, step)
            if known is None and not each.first:
                new.append(later[name])
    rebuilt = tuple(
        replace(
            each,
            step=each.step + step,
            parts=tuple(ids[name] for name in each.parts),
            made=tuple(ids[name] for name in each.made),
        )
        for each in plan.rebuilt
    )
    past = _completed(rest.past.built, before, new)
    return Built(tuple((before | later).values()), (*past, *rebuilt)), ids


class _Names:
    """Ids of structures that come to be from a step on."""

    def __init__(
        self, step: int, planned: Iterable[Structure], before: Mapping[str, Structure]
    ) -> None:
        self._step = step
        self._taken = set(before)
        self._planned: dict[tuple[str, frozenset[str]], list[str]] = defaultdict(list)
        for each in planned:
            if each.id not in before:
                self._planned[each.configuration, frozenset(each.modules)].append(each.id)

    def of(self, each: Structure, modules: Iterable[str]) -> str:
        """The id of a structure of modules: as planned, or else a new one."""
        alike = self._planned[each.configuration, frozenset(modules)]
        name = alike.pop(0) if alike else f"{each.id}@{self._step}"
        while name in self._taken:
            name = f"{name}@{self._step}"
        self._taken.add(name)
        return name


def _completed(
    built: Built, before: Mapping[str, Structure], new: Sequence[Structure]
) -> Iterator[Rebuilt]:
    """What was rebuilt before, with what comes out of it, now that the plan ends later."""
    for each in built.rebuilt:
        modules = {module for part in each.parts for module in before[part].modules}
        out = (body.id for body in new if modules.issuperset(body.modules))
        yield each if each.made else replace(each, made=tuple(out))


def _later(
    each: Structure, known: Structure | None, name: str, modules: tuple[str, ...], step: int
) -> Structure:
    """A structure of the plan of the rest, that goes on from a known one if there is one."""
    stays = followed_by((), each.stays, step)
    if known is None or known.first > step:  # it is new, or was being made
        return replace(
            each,
            id=name,
            modules=modules,
            first=stays[0][0],
            last=each.last + step,
            stays=stays,
            coming=None,
        )
    return replace(
        known,
        stays=followed_by(known.stays, each.stays, step),
        heading=each.heading,
        last=each.last + step,
    )


def structures_from(plan: Plan, rest: Rest) -> tuple[tuple[Structure, ...], tuple[Rebuilt, ...]]:
    """What structures do from the step of a rest on, which is step 0 then, by names there."""
    step = rest.step
    new = {old: name for name, old in modules_by_rest(rest).items()}
    making = {name for each in plan.rebuilt if each.step < step for name in each.made}
    there = {each.id for each in rest.past.built.structures if each.last >= step}
    waiting = [each for each in plan.rebuilt if each.step < step and there & {*each.parts}]
    found = list(_waiting(plan, waiting, step, new))
    told = {name for each in waiting for name in (*each.parts, *each.made)}
    for each in plan.structures:
        if each.id in told or each.last < step or not all(module in new for module in each.modules):
            continue
        modules = tuple(new[module] for module in each.modules)
        stays = ahead(each.stays, step)
        coming, first = None, max(each.first - step, 0)
        if each.id in making and each.first > step:
            coming, first = stays[0][2], 0
        elif each.first <= step and (not stays or stays[0][0]):
            coming = _left(each, step)
        made = replace(each, modules=modules, stays=stays, coming=coming)
        found.append(replace(made, first=first, last=each.last - step))
    found += _beyond(rest, new, {module for each in found for module in each.modules})
    rebuilt = [*waiting, *(each for each in plan.rebuilt if each.step >= step)]
    return tuple(found), tuple(replace(each, step=max(each.step - step, 0)) for each in rebuilt)


def _waiting(
    plan: Plan, rebuilt: Iterable[Rebuilt], step: int, new: Mapping[str, str]
) -> Iterator[Structure]:
    """What should be being rebuilt at a step and is not, and what is to come of it."""
    bodies = {each.id: each for each in plan.structures}
    for item in rebuilt:
        for each in (bodies[name] for name in (*item.parts, *item.made)):
            if not all(module in new for module in each.modules):
                continue
            later = each.first - item.step if each.id in item.made else 0
            stays = tuple(
                (max(first - step, later), max(last - step, later), state)
                for first, last, state in (each.stays if later else each.stays[-1:])
            )
            modules = tuple(new[module] for module in each.modules)
            last = max(each.last - step, later)
            yield replace(each, modules=modules, stays=stays, coming=None, first=later, last=last)


def _left(each: Structure, step: int) -> str | None:
    """Where a structure was before it was under way at a step."""
    before = [state for _, last, state in each.stays if last < step]
    return before[-1] if before else each.coming


def _beyond(rest: Rest, new: Mapping[str, str], told: set[str]) -> Iterator[Structure]:
    """Structures that are being made, and were not to be done before the plan ended; they stay."""
    mission = rest.mission
    for group in mission.team:
        for way, _ in group.coming if group.configuration else ():
            shape = mission.modular.of[str(group.configuration)]
            mine = [
                name
                for rank in mission.ranks
                if rank.start == way and mission.team[rank.group] is group
                for name in rank.names.names()
            ]
            for begin in range(0, len(mine), shape.modules):
                modules = tuple(mine[begin : begin + shape.modules])
                if told.isdisjoint(modules):
                    able = group.capabilities | shape.capabilities
                    stays = ((way.arrives, mission.horizon, way.target),)
                    late = way.arrives > mission.horizon
                    yield Structure(
                        f"{shape.name}@{modules[0]}",
                        group.class_name,
                        shape.name,
                        able,
                        modules,
                        0,
                        mission.horizon,
                        () if late else stays,
                        way.target if late else None,
                        way.origin,
                    )


def modules_along(
    modules: Iterable[Agent | AgentPlan], structures: Sequence[Structure]
) -> Iterator[tuple[Run, Bundle]]:
    """The paths of those modules that are part of some structures."""
    paths = module_paths(structures)
    for each in modules:
        if each.id in paths:
            yield Run.of(each.id), module_plan(each, paths[each.id])
