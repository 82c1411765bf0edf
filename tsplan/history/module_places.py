"""Where structures and their modules are at a step: at which state, on which edge.

Who is being rebuilt is on the way from a state to itself, as what it will be.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from tsplan.history.past_amounts import Load
from tsplan.history.past_paths import Now, way_from_start
from tsplan.history.past_structures import path_of, structure_pace
from tsplan.history.told_paths import Whereabouts, place_of
from tsplan.name_runs import Run
from tsplan.plans.bundles import Bundle
from tsplan.plans.worlds import OnEdge

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from tsplan.history.changed_map import Maps
    from tsplan.history.past_paths import Past
    from tsplan.mission import Mission
    from tsplan.name_runs import RunMap
    from tsplan.plans.structures import Structure
    from tsplan.plans.worlds import World


class Body(NamedTuple):
    """Modules that are one structure of a `configuration` at a step, or are being made into it.

    `id` is that of the structure, `load` what it carries if it is under way.
    """

    id: str
    configuration: str
    modules: tuple[str, ...]
    place: Whereabouts
    load: Load = ()


def bodies_now(
    mission: Mission, past: Past, worlds: Sequence[World], maps: Maps, loads: RunMap[Load]
) -> Iterator[Body]:
    """Where the structures are at the step of the last of some worlds.

    What is being made and not done by the end of the plan has no id there, which is empty then.
    """
    step = worlds[-1].step
    for each in past.built.structures:
        own = each.id, each.configuration, each.modules
        if each.first > step:
            yield Body(*own, OnEdge(each.stays[0][2], each.stays[0][2], each.first))
        elif each.last >= step:
            names = each.id, *each.modules
            place = place_of(path_of(each), names, worlds, _begun(mission, each, maps))
            load = (loads.get(each.id) or ()) if isinstance(place, OnEdge) else ()
            yield Body(*own, place, load)
    bodies = {each.id: each for each in past.built.structures}
    for rebuilt in past.built.rebuilt:
        rule = mission.modular.reconfigurations[rebuilt.rule]
        done = rebuilt.step + rule.duration
        if done > step and not rebuilt.made:  # beyond the end of the plan
            modules = tuple(module for name in rebuilt.parts for module in bodies[name].modules)
            for name, count in rule.made:
                for _ in range(count):
                    size = mission.modular.of[name].modules
                    mine, modules = modules[:size], modules[size:]
                    yield Body("", name, mine, OnEdge(rebuilt.state, rebuilt.state, done))


def modules_now(
    mission: Mission, past: Past, worlds: Sequence[World], maps: Maps, loads: RunMap[Load]
) -> Iterator[Now]:
    """Where modules are at the step of the last of some worlds, those of a structure in a row."""
    for body in bodies_now(mission, past, worlds, maps, loads):
        for module in body.modules:
            rank = mission.roster.get(module)
            assert rank is not None
            path = Bundle(rank.class_name, rank.capabilities, (), None)
            yield Now(Run.of(module), path, body.place, body.load, body.configuration)


def _begun(mission: Mission, each: Structure, maps: Maps) -> OnEdge | None:
    """How a structure is under way that heads for somewhere, by the map."""
    if each.heading is None:
        return None
    if each.stays:
        _, depart, state = each.stays[-1]
        pace = structure_pace(mission, each)
        return maps.ride(f"structure {each.id}", pace, (state, each.heading), depart)
    return way_from_start(mission, each.modules[0])
