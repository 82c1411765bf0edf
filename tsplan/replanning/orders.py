"""What a plan has robots and structures begin at a step."""

from __future__ import annotations

from bisect import bisect_left
from operator import itemgetter
from typing import TYPE_CHECKING

from tsplan.history.changed_map import Maps
from tsplan.history.past_paths import pace_of, robots_of
from tsplan.history.past_structures import path_of, structure_pace
from tsplan.replanning.robot_fleet import Assembly, MoveOrder, Order, RebuildOrder

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from tsplan.history.changed_map import Pace
    from tsplan.mission import Mission
    from tsplan.plans.bundles import Bundle
    from tsplan.plans.plan import Plan
    from tsplan.plans.structures import Structure


def orders_at(step: int, mission: Mission, plan: Plan) -> Iterator[Order]:
    """Who is to set out at a step of a plan, and for where, and what is to be rebuilt."""
    maps = Maps(mission.system, plan.replanned)
    for bundle in robots_of(mission, plan).bundles:
        yield from _moves(step, bundle, bundle.agents, pace_of(bundle), maps)
    for each in plan.structures:
        pace = structure_pace(mission, each)
        yield from _moves(step, path_of(each), (each.id,), pace, maps)
    bodies = {each.id: each for each in plan.structures}
    for rebuilt in plan.rebuilt:
        if rebuilt.step == step:
            made = tuple(assembly(bodies[name]) for name in rebuilt.made)
            done = step + mission.modular.reconfigurations[rebuilt.rule].duration
            yield RebuildOrder(rebuilt.state, rebuilt.parts, made, done)


def assembly(each: Structure) -> Assembly:
    """What a structure is made of."""
    return Assembly(each.id, each.configuration, each.modules)


def _moves(
    step: int, path: Bundle, names: Sequence[str], pace: Pace, maps: Maps
) -> Iterator[MoveOrder]:
    """The orders to those on a path, if it leaves a state at the step."""
    place = bisect_left(path.stays, step, key=itemgetter(1))
    here, *later = path.stays[place : place + 2] or (None,)
    target = later[0][2] if later else path.heading
    if here is not None and here[1] == step and target is not None:
        way = maps.ride(f"agent {names[0]}", pace, (here[2], target), step)
        yield from (MoveOrder(name, here[2], target, way.arrives) for name in names)
