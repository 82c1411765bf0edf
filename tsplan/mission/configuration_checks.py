"""Whether configurations of modular robots fit together with map, team and objectives."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TypeAlias

from tsplan import logic
from tsplan.errors import Nearest
from tsplan.limits import LARGEST, MOST_COST, MOST_STEPS, Range
from tsplan.logic import Formula
from tsplan.mission.configurations import (
    Configuration,
    ModuleRules,
    Parts,
    Reconfiguration,
)
from tsplan.mission.findings import Entry, Fault, Place
from tsplan.mission.objectives import OBJECTIVES
from tsplan.mission.team import Group
from tsplan.ts import TransitionSystem

Carrier: TypeAlias = "tuple[Place, Group | Configuration]"
"""Something that can carry, and where that is said in the mission."""

_COUNT = Range(1, LARGEST, whole=True)
_STEPS = Range(1, MOST_STEPS, whole=True)
_COST = Range(0, MOST_COST, below=True)
_AMOUNT = Range(0, LARGEST)
_FACTOR = Range(0, MOST_STEPS, above=True)


@dataclass(frozen=True)
class Building:
    """What modules can become, the team and the map, as far as they are known."""

    rules: ModuleRules
    entries: Sequence[Entry]
    system: TransitionSystem | None
    objective: Sequence[str]
    swarms: bool


def carriers(entries: Sequence[Entry], rules: ModuleRules) -> list[Carrier]:
    """Who can carry something: robots, and structures by their configurations."""
    return [
        *((place, group) for place, group in entries if group.configuration is None),
        *((("configurations", each.name), each) for each in rules.configurations),
    ]


def module_number_faults(rules: ModuleRules) -> Iterator[tuple[Place, str | None]]:
    """Numbers of configurations that are none, or too small or too large."""
    for shape in rules.configurations:
        place: Place = ("configurations", shape.name)
        yield (*place, "modules"), _COUNT.complaint(shape.modules)
        yield (*place, "cost"), _AMOUNT.complaint(shape.cost)
        yield (*place, "duration"), _FACTOR.complaint(shape.duration)
    for number, rule in enumerate(rules.reconfigurations):
        place = ("reconfigure", number)
        for key, parts in (("from", rule.parts), ("to", rule.made)):
            yield from (((*place, key, name), _COUNT.complaint(count)) for name, count in parts)
        yield (*place, "duration"), _STEPS.complaint(rule.duration)
        yield (*place, "cost"), _COST.complaint(rule.cost)
    for label, worth in rules.performance:
        yield from (
            (("performance", label, name), _AMOUNT.complaint(amount)) for name, amount in worth
        )


def module_faults(building: Building) -> Iterator[Fault]:
    """Everything about configurations but what formulas have to do with it."""
    rules, names = building.rules, [shape.name for shape in building.rules.configurations]
    closest = Nearest(names)
    for number, name in enumerate(building.objective):
        if name in OBJECTIVES and OBJECTIVES[name].of_modules and not rules.configurations:
            what = f"'{name}' is about modular robots, and the mission has no configurations"
            yield Fault(("objective", number), what, "add 'configurations: {...}' or remove it")
    if rules.configurations and building.swarms:
        what = "structures are planned for teams, and this mission has swarms"
        yield Fault(("configurations",), what, "describe the agents as a team")
    if rules.configurations and building.system is not None and building.system.timed:
        what = "places of the map are closed for a time, which is not planned for structures"
        yield Fault(("configurations",), what, "leave out 'closed', or the configurations")
    for number, name in enumerate(names):
        if name in names[:number]:
            what = f"two configurations are called '{name}'"
            yield Fault(("configurations", name), what, "rename one")
    for place, group in building.entries:
        yield from _misplaced(group, place, building, closest)
    for number, rule in enumerate(rules.reconfigurations):
        yield from _broken_rule(rule, ("reconfigure", number), building, closest)
    yield from _performed(building, closest)
    if rules.configurations and not any(g.configuration in rules.of for _, g in building.entries):
        what = "no class of the team is made of modules, so there are no structures"
        yield Fault(("configurations",), what, "say 'configuration: ...' of a class", serious=False)


def _misplaced(group: Group, place: Place, building: Building, closest: Nearest) -> Iterator[Fault]:
    """What is wrong with the structures in which modules start."""
    rules, name = building.rules, group.configuration
    if group.class_name in rules.of:
        what = f"a class is called '{group.class_name}', as a configuration is"
        yield Fault((*place, "class"), what, "give one of them another name")
    if name is None:
        modular = {other.class_name for _, other in building.entries if other.configuration}
        if group.class_name in modular:
            what = f"class '{group.class_name}' is of modules elsewhere, and here of robots"
            yield Fault((*place, "class"), what, "add 'configuration: ...' or call it another name")
        return
    if group.carries != ():
        what = f"modules of class '{group.class_name}' are given what they carry"
        remedy = "structures carry: write 'carries' into the configurations"
        yield Fault((*place, "carries"), what, remedy)
    shape = rules.of.get(name)
    if shape is None:
        remedy = closest(name) if rules.of else "add 'configurations: {...}' to the mission"
        yield Fault((*place, "configuration"), f"there is no configuration '{name}'", remedy)
        return
    for state, count in group.starts:
        if count % shape.modules:
            what = f"{count} modules start at '{state}', and a '{name}' is made of {shape.modules}"
            yield Fault((*place, "at", state), what, f"start a multiple of {shape.modules} there")
    for way, count in group.coming:
        if count % shape.modules:
            what = f"{count} modules start {way.words}, and a '{name}' is made of {shape.modules}"
            yield Fault((*place, "at", way.label), what, f"start a multiple of {shape.modules}")


def _broken_rule(
    rule: Reconfiguration, place: Place, building: Building, closest: Nearest
) -> Iterator[Fault]:
    """Unknown names, and modules that do not add up."""
    rules, system = building.rules, building.system
    known = True
    for key, parts in (("from", rule.parts), ("to", rule.made)):
        for name, _ in parts:
            if name not in rules.of:
                known = False
                where = (*place, key, name)
                yield Fault(where, f"there is no configuration '{name}'", closest(name))
    if known:
        yield from _unbalanced(rule, place, rules)
    if system is not None:
        names = Nearest({*system.states, *system.labels})
        for number, name in enumerate(rule.at):
            if name not in system.states and name not in system.labels:
                what = f"the map has no state and no label '{name}'"
                yield Fault((*place, "at", number), what, names(name))


def _unbalanced(rule: Reconfiguration, place: Place, rules: ModuleRules) -> Iterator[Fault]:
    """Modules that come from nowhere or get lost, and reconfigurations of nothing."""
    given, made = rules.modules(rule.parts), rules.modules(rule.made)
    if given != made:
        what = (
            f"{_shown(rule.parts, rules)} have {given} modules and {_shown(rule.made, rules)} "
            f"{made}"
        )
        remedy = "write how many of each, as in 'from: {line: 1, single: 1}', so that both agree"
        yield Fault(place, what, remedy)
    elif dict(rule.parts) == dict(rule.made):
        yield Fault(place, "the reconfiguration changes nothing", "remove it")


def _shown(parts: Parts, rules: ModuleRules) -> str:
    return " and ".join(f"{count} '{name}' of {rules.of[name].modules}" for name, count in parts)


def _performed(building: Building, closest: Nearest) -> Iterator[Fault]:
    """Labels and configurations of performances."""
    rules, system = building.rules, building.system
    for label, worth in rules.performance:
        place: Place = ("performance", label)
        if system is not None and label not in system.labels and label not in system.states:
            names = Nearest({*system.states, *system.labels})
            yield Fault(place, f"no state of the map has the label '{label}'", names(label))
        for name, _ in worth:
            if name not in rules.of:
                yield Fault((*place, name), f"there is no configuration '{name}'", closest(name))
    if "performance" in building.objective:
        where = ("objective", tuple(building.objective).index("performance"))
        if not rules.performance:
            what = "nothing says how well configurations do anything"
            yield Fault(where, what, "add 'performance: {label: {configuration: 1}}'")
        if "satisfaction" in building.objective:
            what = "'performance' is of a formula that holds as a whole, and this may hold in part"
            yield Fault(where, what, "remove 'satisfaction', or 'performance'")


def unperformed(formula: Formula, rules: ModuleRules) -> Iterator[Fault]:
    """Labels at which a mission's formula asks for no task that could be done well (warnings)."""
    asked = {node.label for node in logic.walk(formula) if isinstance(node, logic.Task)}
    for label, _ in rules.performance:
        if label not in asked:
            what = f"the formula asks for no task at '{label}'"
            remedy = "its performance never counts; correct the label or remove it"
            yield Fault(("performance", label), what, remedy, serious=False)
