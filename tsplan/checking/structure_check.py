"""What structures of modules do in a plan, and whether they can be: read against the mission alone.

Every module starts in one structure, and is in one at every step unless that is rebuilt. Structures
come to be at the start or when a reconfiguration is done, and end at the horizon or where one
begins; they move as agents do, by the durations of their configurations.
"""

from __future__ import annotations

from collections import Counter, defaultdict
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, NamedTuple

from tsplan.checking.class_traffic import ClassTraffic
from tsplan.checking.path_segments import Path, Segment, read_path, together
from tsplan.exact import exact
from tsplan.mission.team import UnderWay
from tsplan.plans.bundles import Bundle
from tsplan.plans.structures import ModulePath, Structure, module_paths, of_structures

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping, Sequence

    from tsplan.mission import Configuration, Group, Mission, Reconfiguration
    from tsplan.plans.plan import Plan
    from tsplan.plans.structures import Rebuilt


class Rebuild(NamedTuple):
    """A reconfiguration that a plan makes: of which rule, by how many structures, when."""

    rule: Reconfiguration
    parts: int
    begun: int
    done: int


@dataclass
class _Reading:
    """The structures of a plan while they are read."""

    mission: Mission
    plan: Plan
    problems: list[str] = field(default_factory=list)
    segments: dict[str, tuple[Segment, ...]] = field(default_factory=dict)
    ways: dict[tuple[object, ...], Path] = field(default_factory=dict)
    rebuilds: list[Rebuild] = field(default_factory=list)


def read_structures(
    mission: Mission, plan: Plan
) -> tuple[tuple[ClassTraffic, ...], tuple[Rebuild, ...], list[str]]:
    """What the structures of a plan do, what is rebuilt, and everything that cannot be."""
    if not any(group.configuration for group in mission.team):
        wrong = ["the plan has structures, and the mission has no modules"]
        return (), (), wrong if plan.structures or plan.rebuilt else []
    reading = _Reading(mission, plan)
    ids = Counter(each.id for each in plan.structures)
    reading.problems += [f"structure {name} is there twice" for name, n in ids.items() if n > 1]
    if not reading.problems:
        _read_bodies(reading)
    if not reading.problems:
        _read_births(reading)
    if not reading.problems:
        reading.problems += _astray(plan.bundles, module_paths(plan.structures), mission)
    if reading.problems:
        return (), (), reading.problems
    return tuple(_traffic(reading)), tuple(reading.rebuilds), []


def _read_bodies(reading: _Reading) -> None:
    """What each structure is made of, and its way over the map."""
    mission = reading.mission
    modules = [rank for rank in mission.ranks if mission.team[rank.group].configuration]
    groups = {name: mission.team[rank.group] for rank in modules for name in rank.names.names()}
    begins = {name: rank.start for rank in modules for name in rank.names.names()}
    for each in reading.plan.structures:
        problems = list(_unfit(each, mission, groups))
        if not problems and each.first == 0:
            problems += _misbegun(each, begins, groups)
        if not problems:
            problems += _read_way(each, reading)
        reading.problems += [f"structure {each.id} {problem}" for problem in problems]


def _unfit(each: Structure, mission: Mission, groups: Mapping[str, Group]) -> Iterator[str]:
    """Whether a structure can be of its configuration and its modules."""
    shape = mission.modular.of.get(each.configuration)
    if shape is None:
        yield f"is a '{each.configuration}', which the mission does not know"
        return
    if mission.roster.get(each.id) is not None:
        yield "is called as a module is"
    strangers = [m for m in each.modules if m not in groups]
    if strangers:
        yield f"is made of {strangers[0]}, which is no module of the mission"
        return
    if len(set(each.modules)) != shape.modules or len(each.modules) != shape.modules:
        yield f"is a {shape.name} of {len(set(each.modules))} modules instead of {shape.modules}"
    kinds = {(groups[m].class_name, groups[m].capabilities) for m in each.modules}
    able = groups[each.modules[0]].capabilities | shape.capabilities
    if len(kinds) > 1:
        yield "is made of modules of different classes or capabilities"
    elif each.class_name != groups[each.modules[0]].class_name:
        yield f"is of class {each.class_name}, and its modules are not"
    elif each.capabilities != able:
        yield "has other capabilities in the mission"


def _misbegun(
    each: Structure, begins: Mapping[str, str | UnderWay], groups: Mapping[str, Group]
) -> Iterator[str]:
    """Whether a structure is there at the start, where its modules begin.

    When those arrive that are under way is asked of the modules, whose paths are the structure's.
    """
    where = _beginning(each)
    for module in each.modules:
        start = begins[module]
        same = start == where
        if isinstance(start, UnderWay):
            same = (start.origin, start.target) == where
        if groups[module].configuration != each.configuration:
            yield f"is there at the start, where {module} is in a {groups[module].configuration}"
        elif not same:
            told = start.label if isinstance(start, UnderWay) else start
            begun = where if isinstance(where, str) else " to ".join(where)
            yield f"starts at {begun}, and {module} at {told}"


def _beginning(each: Structure) -> str | tuple[str, str]:
    """Where a structure is first, or between which states."""
    first = each.stays[0][2] if each.stays else str(each.heading)
    return first if each.coming is None else (each.coming, first)


def _read_way(each: Structure, reading: _Reading) -> list[str]:
    """The way of a structure over the map; what is wrong with it."""
    horizon = reading.plan.horizon
    if not each.first <= each.last <= horizon:
        return [f"is there from step {each.first} to {each.last} of {horizon}"]
    if each.coming is not None and each.first:
        return [f"comes from {each.coming} at the start, and is not there before {each.first}"]
    ended = each.stays[-1][1] if each.stays else -1
    if ended != each.last and (each.last < horizon or each.heading is None):
        return [f"is last seen at step {ended}, and it is there until {each.last}"]
    key = (
        each.class_name,
        each.capabilities,
        each.configuration,
        each.stays,
        each.first,
        each.last,
        each.coming,
    )
    path = reading.ways.get((*key, each.heading))
    if path is None:
        path = reading.ways[*key, each.heading] = structure_path(reading.mission, each)
    reading.segments[each.id] = path.segments
    return list(path.problems)


def structure_path(mission: Mission, each: Structure) -> Path:
    """The way of a structure while it lives, by the durations of its configuration."""
    shape = mission.modular.of[each.configuration]
    own = each.class_name, each.capabilities, each.stays, each.heading, (each.id,)
    bundle = Bundle(*own, coming=each.coming)
    return read_path(
        mission.system,
        bundle,
        each.last,
        each.first,
        lambda edge: shape.steps(edge, each.class_name),
    )


def _read_births(reading: _Reading) -> None:
    """Where structures come from and what becomes of them."""
    plan, problems = reading.plan, reading.problems
    bodies = {each.id: each for each in plan.structures}
    used = Counter(name for each in plan.rebuilt for name in each.parts)
    made = Counter(name for each in plan.rebuilt for name in each.made)
    for each in plan.rebuilt:
        problems += (
            f"what is rebuilt at {each.state} at step {each.step} {problem}"
            for problem in _misbuilt(each, bodies, reading)
        )
    for name, body in bodies.items():
        if made[name] != (body.first > 0):
            problems.append(f"structure {name} is made {made[name]} times from others")
        open_ended = body.last == plan.horizon
        if used[name] > 1 or not (used[name] or open_ended):
            problems.append(f"structure {name} is rebuilt {used[name]} times after {body.last}")
        if used[name] and body.heading is not None:
            problems.append(f"structure {name} is rebuilt, and heads for {body.heading}")
    modular = _modular(reading.mission)
    begun = Counter(m for body in bodies.values() if not body.first for m in body.modules)
    for agent in reading.mission.members(modular):
        if begun[agent.id] != 1:
            problems.append(f"module {agent.id} is in {begun[agent.id]} structures at the start")


def _modular(mission: Mission) -> set[str]:
    """The classes whose robots are modules."""
    return {group.class_name for group in mission.team if group.configuration}


def _misbuilt(each: Rebuilt, bodies: Mapping[str, Structure], reading: _Reading) -> Iterator[str]:
    """Whether structures may be rebuilt as they are."""
    rules, horizon = reading.mission.modular.reconfigurations, reading.plan.horizon
    if each.rule >= len(rules):
        yield f"follows reconfiguration {each.rule}, and the mission has {len(rules)}"
        return
    unknown = [name for name in (*each.parts, *each.made) if name not in bodies]
    if unknown:
        yield f"is of structure {unknown[0]}, which is not there"
        return
    rule = rules[each.rule]
    system, done = reading.mission.system, each.step + rule.duration
    labels = () if each.state not in system.states else system.states[each.state].labels
    if rule.at and not {each.state, *labels} & set(rule.at):
        yield "is rebuilt where the mission does not allow that"
    if each.step >= horizon:
        yield f"begins at the end of the plan, {horizon}"
    parts, made = ([bodies[name] for name in names] for names in (each.parts, each.made))
    if _shapes(parts) != Counter(dict(rule.parts)):
        yield "goes in as other structures than the mission says"
    if _shapes(made) != (Counter(dict(rule.made)) if done <= horizon else Counter()):
        yield "comes out as other structures than the mission says"
    if not all(_ends(part, each.step, each.state) for part in parts):
        yield "has parts that are not there then"
    if not all(new.first == done and _begins(new, done, each.state) for new in made):
        yield f"is not there at step {done}, when that is done"
    if made and Counter(m for part in parts for m in part.modules) != Counter(
        m for new in made for m in new.modules
    ):
        yield "has other modules afterwards"
    reading.rebuilds.append(Rebuild(rule, len(parts), each.step, done))


def _ends(part: Structure, step: int, state: str) -> bool:
    """Whether a structure is last seen at a state at a step, and ends then."""
    return part.last == step and bool(part.stays) and part.stays[-1][1:] == (step, state)


def _begins(new: Structure, step: int, state: str) -> bool:
    """Whether a structure is first seen at a state at a step."""
    return bool(new.stays) and (new.stays[0][0], new.stays[0][2]) == (step, state)


def _shapes(structures: Sequence[Structure]) -> Counter[str]:
    return Counter(each.configuration for each in structures)


def _astray(
    bundles: Sequence[Bundle], paths: Mapping[str, ModulePath], mission: Mission
) -> Iterator[str]:
    """Modules whose own paths are not those of the structures that they are part of."""
    modular = _modular(mission)
    for bundle in (each for each in bundles if each.class_name in modular):
        for name in bundle.agents:
            path = paths.get(name)
            own = bundle.stays, bundle.heading, bundle.coming
            if path is None or (path.stays, path.heading, path.coming) != own:
                yield f"agent {name} is elsewhere than the structures that it is part of"


def _traffic(reading: _Reading) -> Iterator[ClassTraffic]:
    """What the structures of each configuration and class do."""
    bodies: dict[tuple[str, str], list[Structure]] = defaultdict(list)
    for each in reading.plan.structures:
        bodies[each.class_name, each.configuration].append(each)
    rebuilt = {name for each in reading.plan.rebuilt for name in (*each.parts, *each.made)}
    moved = {
        module
        for each in reading.plan.structures
        for module in each.modules
        if each.id in rebuilt
        or each.coming is not None
        or any(not s.edge.is_wait for s in reading.segments[each.id])
    }
    for (class_name, name), mine in bodies.items():
        shape: Configuration = reading.mission.modular.of[name]
        starting = {module for each in mine if not each.first for module in each.modules}
        yield ClassTraffic(
            class_name,
            together(segment for each in mine for segment in reading.segments[each.id]),
            tuple(of_structures(mine)),
            len(moved & starting),
            factor=exact(shape.cost),
            shape=name,
        )
