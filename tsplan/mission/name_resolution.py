"""Names of states and classes in formulas, which stand for what is called so.

A name that is no label is a state's, and one that is no capability is a class's. This is settled
once, when a mission is made: the state gets its own name as a label, in the mission's map alone,
and the class its own name as a capability, in its team. Whatever reads the mission afterwards
(encoding, check, reasons, pictures) finds a label or a capability like any other.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import TYPE_CHECKING

from tsplan.logic.symbols import capabilities, labels
from tsplan.mission.configurations import ModuleRules
from tsplan.mission.team import ONE_SWARM, Group, SwarmRules

if TYPE_CHECKING:
    from tsplan.logic import Formula
    from tsplan.ts import TransitionSystem


def with_named_states(system: TransitionSystem, formulas: Iterable[Formula]) -> TransitionSystem:
    """The map in which every state that a formula names has its name as a label.

    A name that some state has as a label means that label. The same map where nothing changes.

    >>> from tsplan.logic import parse
    >>> from tsplan.ts import Edge, State, TransitionSystem
    >>> yard = TransitionSystem.build([State("dock"), State("gate")], [Edge("dock", "gate")])
    >>> with_named_states(yard, [parse("F[0,2] gate")]).labels
    mappingproxy({'gate': ('gate',)})
    """
    named = {
        name
        for formula in formulas
        for name in labels(formula)
        if name not in system.labels and name in system.states
    }
    if not named:
        return system
    states = {
        name: replace(state, labels=state.labels | {name}) if name in named else state
        for name, state in system.states.items()
    }
    return replace(system, states=states)


def with_named_classes(
    team: Iterable[Group],
    swarm: SwarmRules | None,
    system: TransitionSystem | None,
    formulas: Iterable[Formula],
) -> tuple[Group, ...]:
    """The team in which every class that a formula or the map names has its name as a capability.

    A name that some robot has as a capability means that capability. Swarms have their names
    always, but for a single one that has no name of its own.

    >>> from tsplan.logic import parse
    >>> from tsplan.mission import Group
    >>> with_named_classes([Group.of("scout", {"q1": 3})], None, None, [parse("sum(A, scout) > 1")])
    (Group(class_name='scout', capabilities=frozenset({'scout'}), starts=(('q1', 3),)),)
    """
    team = tuple(team)
    named = _named(system, formulas)
    if swarm is not None and set(swarm.each) != {ONE_SWARM}:
        named.update(swarm.each)
    named.difference_update(*(group.capabilities for group in team))
    return tuple(
        replace(group, capabilities=group.capabilities | {group.class_name})
        if group.class_name in named
        else group
        for group in team
    )


def with_named_configurations(
    rules: ModuleRules,
    team: Iterable[Group],
    system: TransitionSystem | None,
    formulas: Iterable[Formula],
) -> ModuleRules:
    """The rules in which every configuration that a formula or the map names can do its name.

    A name that some robot or structure has as a capability means that capability.
    """
    named = _named(system, formulas)
    named.difference_update(*(group.capabilities for group in team))
    named.difference_update(*(shape.capabilities for shape in rules.configurations))
    if named.isdisjoint(rules.of):
        return rules
    shapes = (
        replace(shape, capabilities=shape.capabilities | ({shape.name} & named))
        for shape in rules.configurations
    )
    return replace(rules, configurations=tuple(shapes))


def _named(system: TransitionSystem | None, formulas: Iterable[Formula]) -> set[str]:
    """The capabilities that formulas and the map name."""
    named = {name for formula in formulas for name in capabilities(formula)}
    if system is not None:
        named.update(*(state.needs for state in system.states.values()))
        named.update(*(edge.needs for edge in system.edges.values()))
    return named
