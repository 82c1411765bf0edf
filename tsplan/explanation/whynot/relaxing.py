"""Missions with some of their elements taken out, as problems for the ordinary planner.

A formula part is replaced by true, a capacity removed; there is as much of a resource, or a robot
carries as much, as can be of use. Where the size or the start of a part of
the team is taken out, its robots come from a depot: a new state, from which an edge of one step
leads to every state where they may start, one step before the mission begins; sooner where
structures take longer for such an edge. Robots whose number is open may stay in their depot; there
are as many as any plan could use.
"""

from __future__ import annotations

from collections.abc import Container, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from math import ceil
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

from tsplan.explanation.explanation import PartKind, SoftConstraint
from tsplan.explanation.whynot.amount_numbers import useful_amount, useful_hold, with_carries
from tsplan.explanation.whynot.mission_numbers import remapped, with_bound
from tsplan.explanation.whynot.occurrences import counts_of, without
from tsplan.explanation.whynot.posed_mission import (
    begun_later,
    own_of,
    problem_of,
    useful_robots,
    with_own,
)
from tsplan.explanation.whynot.soft_constraints import (
    BOOKING,
    WAITING,
    occurrence_of,
    robot_entries,
)
from tsplan.limits import MOST_ROBOTS
from tsplan.logic import Always, Count, Execution, walk
from tsplan.mission.resources import Resource, most_carried
from tsplan.mission.team import UnderWay, with_brought
from tsplan.run.problem import Problem, Tuning
from tsplan.ts import Edge, State, TransitionSystem
from tsplan.ts.waits import with_waits, without_wait

if TYPE_CHECKING:
    from tsplan.mission import Group, Mission, Resource
    from tsplan.mission.configurations import ModuleRules

Dropped = frozenset[SoftConstraint]

_UNBOUNDED = {"most": None, "least": 1, "margin": Fraction(0)}
"""Bounds of swarms that bound nothing."""


_AIMLESS: Mapping[str, Any] = MappingProxyType({"objective": (), "prefer": (), "warnings": ()})
"""The parts of a mission of which any plan will do."""


def any_plan(mission: Mission) -> Mission:
    """The mission that asks for no more than that its formula holds, as a whole."""
    return replace(mission, **_AIMLESS)


def relaxed(
    mission: Mission, dropped: Iterable[SoftConstraint], tuning: Tuning | None = None
) -> Mission | Problem:
    """The problem without some constraints of the mission; of swarms alone, the mission itself."""
    tuning = tuning or Tuning()
    gone = frozenset(dropped)
    parts = [occurrence_of(item) for item in gone if item.kind == "formula"]
    formula = without(mission.formula, parts)
    rules = mission.swarm
    mission = _without_own(_supplied(mission, gone), gone)
    if rules is not None:
        for item in gone:
            if item.kind == "swarm":
                rules = with_bound(rules, _UNBOUNDED[item.key[1]], *item.key)
    left = replace(
        mission,
        **_AIMLESS,
        formula=formula,
        text=str(formula),
        system=_roomier(mission.system, gone),
        swarm=rules,
        booking="shared" if BOOKING in gone else mission.booking,
    )
    if any(item.kind in ("team", "start") for item in gone):
        return _from_depots(left, gone, tuning)
    return problem_of(left, tuning) if robot_entries(mission) else left


def _supplied(mission: Mission, gone: Dropped) -> Mission:
    """The mission with as much as can be of use of some resources, or carried by some entries."""
    names = {item.key[0] for item in gone if item.kind == "stock"}
    if names:
        found = tuple(_plenty(mission, r) if r.name in names else r for r in mission.resources)
        mission = replace(mission, resources=found, warnings=())
    carrying = [item.key[0] for item in gone if item.kind == "carries"]
    return (
        with_carries(mission, dict.fromkeys(carrying, float(useful_hold(mission))))
        if carrying
        else mission
    )


def _without_own(mission: Mission, gone: Dropped) -> Mission:
    """The mission without some of its own constraints."""
    if not own_of(mission):
        return mission
    left = (
        item.unbounded() if SoftConstraint("own", (number,)) in gone else item
        for number, item in enumerate(own_of(mission))
    )
    return with_own(mission, left)


def _plenty(mission: Mission, resource: Resource) -> Resource:
    """A resource of which enough lies wherever a task needs it."""
    labels = [
        node.label
        for node in walk(mission.goal)
        if isinstance(node, Execution) and dict(node.resources).get(resource.name)
    ]
    enough = float(useful_amount(mission, resource))
    states = {state: enough for label in labels for state in mission.system.labels[label]}
    return replace(resource, at=tuple({**dict(resource.at), **states}.items()))


def _roomier(system: TransitionSystem, gone: Dropped) -> TransitionSystem:
    """The map without some capacities, and with all waits; the same where nothing is taken out."""
    if WAITING in gone:
        system = with_waits(system, without_wait(system))
    keys = [item.key for item in gone if item.kind == "capacity"]
    names = [key[0] if len(key) == 1 else key for key in keys]
    if keys:
        system = remapped(system, names, lambda item: replace(item, capacity=None))
    open_ = {item.key[0] for item in gone if item.kind == "zone"}
    return without_zones(system, open_) if open_ else system


def without_zones(system: TransitionSystem, names: Container[str]) -> TransitionSystem:
    """The map without some of its zones."""

    def freed(item: Any) -> Any:
        return replace(item, zone=None) if item.zone in names else item

    zones = {name: room for name, room in system.zones.items() if name not in names}
    states, edges = map(freed, system.states.values()), map(freed, system.edges.values())
    return replace(system, zones=zones).rebuilt(states, edges)


def bounded_above(mission: Mission) -> bool:
    """Whether more robots somewhere can do harm: by a limit, a capacity, or an own constraint."""
    system = mission.system
    return (
        any(isinstance(node, Count) and node.relation == "<=" for node in walk(mission.goal))
        or any(state.capacity is not None for state in system.states.values())
        or bool(system.capacity_groups or system.zones or own_of(mission))
    )


def waits_everywhere(mission: Mission) -> bool:
    """Whether whoever is at a state can stay there and be counted at every step."""
    system = mission.system
    return not system.timed and all(
        (edge := system.edges.get((name, name))) is not None
        and edge.duration == 1
        and edge.needs <= system.states[name].needs
        for name in system.states
    )


def can_idle(mission: Mission) -> bool:
    """Whether robots that are not needed are in nobody's way, wherever they start."""
    simple = not (mission.swarm or mission.resources or mission.modular)
    return simple and waits_everywhere(mission) and not bounded_above(mission)


def needless(mission: Mission, gone: Dropped) -> Dropped:
    """Whose numbers and starts say nothing without some constraints: no part left counts them.

    Only where `can_idle`: whoever is not counted can stay where it starts, so that there is a plan
    with more of them, or with others, just if there is one with these.
    """
    bounds = frozenset(item for item in gone if item.kind in ("team", "start"))
    if not bounds:
        return frozenset()
    parts = [occurrence_of(item) for item in gone if item.kind == "formula"]
    left = without(mission.formula, parts)
    asked = {count.capability for node in walk(left) for count in counts_of(node)}
    if None in asked:
        return frozenset()
    return frozenset(
        item for item in bounds if asked.isdisjoint(mission.team[item.key[0]].capabilities)
    )


def modules_of(mission: Mission, group: Group) -> int:
    """Of how many modules the structures of an entry of the team are made at first; 1 of robots."""
    shape = mission.modular.of.get(group.configuration or "")
    return 1 if shape is None else shape.modules


def useful_number(mission: Mission, entry: int) -> int:
    """As many robots of one entry of the team as any plan could use.

    Of modules, as many as the largest structures take that are met while one is made of others,
    each configuration once.

    Whoever serves no atom can be left out. At one step those of one state (or of the states of a
    label, for a sum) serve the largest need for each capability, and where agents are booked the
    needs of all that may be executed then; where nothing is bounded from above and waiting is free
    they can stay there for good, otherwise others may come at every step.
    """
    needs: dict[tuple[str, str | None, str], int] = {}
    for node in walk(mission.goal):
        if isinstance(node, Count) and node.relation == ">=" and isinstance(node.bound, int):
            site = (node.label, node.capability, node.function)
            needs[site] = max(needs.get(site, 0), node.bound)
    labels = mission.system.labels
    total = sum(
        amount * (1 if function == "sum" else len(labels[label]))
        for (label, _, function), amount in needs.items()
    )
    for node in walk(mission.goal) if mission.books else ():
        if isinstance(node, Execution):
            asked = sum(number for _, number in node.needs)
            total += asked * (node.last + 1) * len(labels[node.label])
    for_good = waits_everywhere(mission) and not bounded_above(mission)
    steps = 1 if for_good else mission.horizon + 1
    useful = total * steps + _useful_carriers(mission) + (useful_robots(mission) or 0)
    group, rules = mission.team[entry], mission.modular
    if group.configuration is not None:
        sizes = [rules.modules(rule.parts) for rule in rules.reconfigurations]
        largest = max((*sizes, *(shape.modules for shape in rules.configurations)))
        useful *= largest * len(rules.configurations)
    modules = modules_of(mission, group)
    most = min(useful, MOST_ROBOTS // (2 * len(mission.team)))
    return max(1, most // modules) * modules


def _useful_carriers(mission: Mission) -> int:
    """As many robots as could be of use for carrying: one for each load on each edge of its way.

    A load is a piece, or what goes from one place or execution to another execution, on one way
    and in as many parts as it takes.
    """
    needing = [node for node in walk(mission.goal) if isinstance(node, Execution)]
    loads = 0
    for resource in mission.resources:
        sites = [
            len(mission.system.labels[node.label])
            for node in needing
            if dict(node.resources).get(resource.name)
        ]
        able = mission.modular.possible(mission.team)
        rooms = [room for g in able if (room := most_carried(g.carries, resource))]
        if not sites or not rooms:
            continue
        if resource.indivisible:
            loads += int(resource.total)
            continue
        executions = sum(sites) * (mission.horizon + 1)
        loads += (len(resource.at) + executions) * executions + ceil(resource.total / min(rooms))
    return loads * (mission.horizon + 1)


def _from_depots(mission: Mission, gone: Dropped, tuning: Tuning) -> Problem:
    """The mission one step later, begun from depots; of swarms come as many as there are."""
    # leaving a depot late may be as good as waiting where a robot starts; but bounded swarms are
    # sub-swarms in their depots, too
    harmless = mission.swarm is None and waits_everywhere(mission) and not bounded_above(mission)
    # resources lie where nobody is counted, and structures are built there
    near = harmless and not mission.resources and not mission.modular
    steps = [_way_in(mission, group) for group in mission.team]
    before = max(steps)
    system = mission.system.later(before)
    states, edges, team = [*system.states.values()], [*system.edges.values()], []
    open_: list[tuple[str, int]] = []
    all_: list[tuple[str, int]] = []
    for number, group in enumerate(mission.team):
        sized = SoftConstraint("team", (number,)) not in gone
        starts, begun = [], _still_begun(group, gone, number)
        for place, (count, targets, steps_in) in enumerate(
            _starts(mission, gone, number, near=near)
        ):
            name = f"depot {number}.{place}"
            while name in system.states:
                name += "'"
            states.append(State(name))
            edges += [Edge(name, name), *(Edge(name, target, steps_in) for target in targets)]
            starts.append((name, count if sized else useful_number(mission, number)))
            (all_ if sized else open_).append((name, before - steps[number] + 1))
        coming = [(replace(way, arrives=way.arrives + before), count) for way, count in begun]
        team.append(replace(group, starts=tuple(starts), coming=tuple(coming)))
    formula = Always(before, before, mission.formula)
    later = replace(
        mission,
        system=system.rebuilt(states, edges),
        team=tuple(team),
        formula=formula,
        text=str(formula),
        horizon=mission.horizon + before,
        modular=_built_there(mission),
        resources=_with_lost(mission, team),
    )
    problem = problem_of(begun_later(later, before), tuning)
    if not harmless:  # robots leave before the mission begins or, where they may, never
        for name, gone_by in all_:
            problem.add(problem.count(name, step=gone_by) <= 0, "everybody starts")
        for name, gone_by in open_:
            left = problem.count(name, step=gone_by) - problem.count(name, step=later.horizon)
            problem.add(left <= 0, "nobody starts late")
    return problem


def _way_in(mission: Mission, group: Group) -> int:
    """Steps of an edge from a depot, which structures may take longer to go along."""
    shape = mission.modular.of.get(group.configuration or "")
    return 1 if shape is None else shape.steps(Edge("depot", "start"), group.class_name) or 1


def _built_there(mission: Mission) -> ModuleRules:
    """What modules can become, but in no depot."""
    rules, every = mission.modular, tuple(mission.system.states)
    made = (rule if rule.at else replace(rule, at=every) for rule in rules.reconfigurations)
    return replace(rules, reconfigurations=tuple(made))


def _still_begun(group: Group, gone: Dropped, number: int) -> Sequence[tuple[UnderWay, int]]:
    """The starts under way that stay as they are: where neither number nor start is taken out."""
    kinds: tuple[PartKind, ...] = ("team", "start")
    kept = all(SoftConstraint(kind, (number,)) not in gone for kind in kinds)
    return group.coming if kept else ()


def _with_lost(mission: Mission, team: Sequence[Group]) -> tuple[Resource, ...]:
    """The resources; what is brought by nobody any more lies there from the beginning."""
    kept = with_brought(mission.resources, team, mission.modular.sizes)
    found = []
    for item, other in zip(mission.resources, kept, strict=True):
        lost = item.brought if not other.brought else ()
        found.append(replace(item, at=(*item.at, *((state, n) for state, _, n in lost))))
    return tuple(found)


def _starts(
    mission: Mission, gone: Dropped, number: int, *, near: bool
) -> Iterator[tuple[int, list[str], int]]:
    """How many robots of one entry of the team start where: any of some states.

    The last is how many steps it takes to come there from outside: more where robots are under way
    that their number is not kept of.

    If the start is taken out, that is everywhere, or where they count if that is `near` enough.
    """
    group = mission.team[number]
    if SoftConstraint("start", (number,)) not in gone:
        yield from ((count, [state], 1) for state, count in group.starts)
        if not _still_begun(group, gone, number):
            yield from ((count, [way.target], 1 + way.arrives) for way, count in group.coming)
        return
    states = mission.system.states.values()
    able = mission.modular.structures(group).capabilities
    allowed = [state for state in states if state.needs <= able]
    if near and not group.carries:  # who carries may be of use anywhere
        named = {node.label for node in walk(mission.goal) if isinstance(node, Count)}
        own = {state for state, *_ in group.begins}
        allowed = [state for state in allowed if state.labels & named or state.name in own]
    yield group.count, [state.name for state in allowed], 1
