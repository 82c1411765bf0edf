"""The amounts of a mission that can be changed: what lies where, and what robots carry."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import TYPE_CHECKING

from tsplan.exact import common_unit, exact
from tsplan.logic import Execution, walk

if TYPE_CHECKING:
    from collections.abc import Iterator

    from tsplan.mission import Mission, Resource
    from tsplan.mission.resources import Carries


def resource_of(mission: Mission, name: str) -> Resource:
    """A resource by its name."""
    return next(item for item in mission.resources if item.name == name)


def stock(mission: Mission, name: str, state: str) -> float:
    """What lies of a resource at a state at first."""
    return dict(resource_of(mission, name).at).get(state, 0.0)


def put_stock(mission: Mission, value: float, name: str, state: str) -> Mission:
    """The mission with another amount of a resource at a state."""
    changed = tuple(
        replace(item, at=tuple({**dict(item.at), state: value}.items()))
        if item.name == name
        else item
        for item in mission.resources
    )
    return replace(mission, resources=changed, warnings=())


def carried(mission: Mission, entry: int, name: str) -> float:
    """What each robot of an entry of the team carries of a resource, or of all together."""
    carries = mission.team[entry].carries
    return dict(carries).get(name, 0.0) if isinstance(carries, tuple) else carries


def put_carried(mission: Mission, value: float, entry: int, name: str) -> Mission:
    """The mission in which the robots of an entry carry another amount."""
    before = mission.team[entry].carries
    after: Carries = value
    if isinstance(before, tuple):
        after = tuple({**dict(before), name: value}.items())
    return with_carries(mission, {entry: after})


def with_carries(mission: Mission, changed: dict[int, Carries]) -> Mission:
    """The mission in which the robots of some entries carry something else."""
    team = tuple(
        replace(group, carries=changed[number]) if number in changed else group
        for number, group in enumerate(mission.team)
    )
    return replace(mission, team=team, warnings=())


def unit_of(mission: Mission, resource: Resource) -> Fraction:
    """The steps in which amounts of a resource move: a piece, or what all are multiples of."""
    if resource.indivisible:
        return Fraction(1)
    given = [exact(amount) for _, amount in resource.at]
    given += (exact(amount) for amount in _needed(mission, resource))
    for group in mission.modular.possible(mission.team):
        load = group.carries
        given.append(exact(dict(load).get(resource.name, 0.0) if isinstance(load, tuple) else load))
    return common_unit(given)


def _needed(mission: Mission, resource: Resource) -> Iterator[float]:
    """The amounts of a resource that tasks need."""
    for node in walk(mission.goal):
        if isinstance(node, Execution):
            yield dict(node.resources).get(resource.name, 0.0)


def useful_amount(mission: Mission, resource: Resource) -> Fraction:
    """As much of a resource as any plan could use at one state: for executions at every step."""
    return sum(map(exact, _needed(mission, resource)), Fraction(0)) * (mission.horizon + 1)


def useful_hold(mission: Mission) -> Fraction:
    """As much as a robot could carry: all there is of all resources."""
    return sum((item.total for item in mission.resources), Fraction(0))
