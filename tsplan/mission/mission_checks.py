"""What has to fit together in a mission: team and map, formula and map, objective, horizon.

Every check gives faults that name their place as a path in a mission file or as a node of the
formula; who reads a file turns them into findings with lines and columns.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from tsplan.errors import nearest
from tsplan.logic import Formula
from tsplan.mission.booking_checks import Booked, booking_faults
from tsplan.mission.configuration_checks import (
    Building,
    carriers,
    module_faults,
    unperformed,
)
from tsplan.mission.costs import cost_faults
from tsplan.mission.expectation_checks import chance_faults, expectation_faults
from tsplan.mission.findings import Entry, Fault, Place, moved, preferred
from tsplan.mission.formula_checks import formula_faults, horizon_faults
from tsplan.mission.magnitudes import number_faults
from tsplan.mission.mission_parts import MissionParts, Preference
from tsplan.mission.objectives import OBJECTIVES, objectives_for
from tsplan.mission.resource_checks import Carrying, resource_faults, spending_faults
from tsplan.mission.team import SwarmRules, with_brought
from tsplan.mission.team_checks import entries_of, map_faults, team_faults


def mission_faults(mission: MissionParts) -> list[Fault]:
    """Everything that does not fit together in a mission."""
    numbers = number_faults(mission)
    if numbers:
        return numbers  # with numbers that are none, nothing else can be judged
    return [
        *objective_faults(mission.objective, mission.swarm),
        *preference_faults(mission.objective, mission.prefer, mission.swarm),
        *expectation_faults(
            mission.expected,
            mission.swarm,
            mission.objective,
            mission.prefer,
            resources=bool(mission.resources),
            modular=bool(mission.modular),
        ),
        *chance_faults(mission.system, mission.expected),
        *team_faults(_entries(mission), mission.system, mission.swarm, mission.modular),
        *module_faults(
            Building(
                mission.modular,
                _entries(mission),
                mission.system,
                mission.objective,
                mission.swarm is not None,
            )
        ),
        *map_faults(mission.system, mission.team),
        *cost_faults(
            mission.system, mission.team, mission.horizon, mission.objective, mission.modular
        ),
        *resource_faults(_carrying(mission), mission.objective, mission.swarm),
        *delay_faults(
            mission.delay,
            mission.objective,
            resources=bool(mission.resources),
            expected=mission.expected is not None,
            modular=bool(mission.modular),
        ),
        *late_faults(mission.delay, mission.horizon),
        *unperformed(mission.formula, mission.modular),
        *booking_faults(_booked(mission), mission.objective, [mission.formula]),
        *_formula_faults(mission, mission.formula, whole="satisfaction" not in mission.objective),
        *(
            fault
            for number, soft in enumerate(mission.prefer)
            for fault in moved(_formula_faults(mission, soft.formula), preferred(number))
        ),
    ]


def _formula_faults(
    mission: MissionParts, formula: Formula, *, whole: bool = False
) -> Iterator[Fault]:
    """What does not fit in a formula of a mission."""
    team = mission.modular.possible(mission.team)
    yield from formula_faults(formula, mission.system, team, mission.swarm)
    yield from horizon_faults(formula, mission.task_interval, mission.horizon)
    yield from spending_faults(formula, _carrying(mission), whole=whole)


def _carrying(mission: MissionParts) -> Carrying:
    entries = carriers(_entries(mission), mission.modular)
    resources = with_brought(mission.resources, mission.team, mission.modular.sizes)
    return Carrying(resources, entries, mission.system, mission.books)


def _booked(mission: MissionParts) -> Booked:
    return Booked(
        mission.booking,
        swarms=mission.swarm is not None,
        delay=mission.delay,
        expected=mission.expected is not None,
    )


def _entries(mission: MissionParts) -> list[Entry]:
    return entries_of(mission.team, mission.swarm)


def preference_faults(
    objective: Sequence[str], prefer: Sequence[Preference], swarm: SwarmRules | None
) -> Iterator[Fault]:
    """Objectives about what holds that are out of place, and preferences of one name."""
    for place, name in enumerate(objective):
        path: Place = ("objective", place)
        if place and name in OBJECTIVES and OBJECTIVES[name].first:
            what = f"'{name}' comes after other objectives"
            yield Fault(path, what, "name it first: it is settled first")
        if name == "preferences" and not prefer:
            what = "'preferences' are an objective and none are there"
            yield Fault(path, what, "add 'prefer: [...]' to the spec")
        if name == "satisfaction" and swarm is not None and swarm.margin:
            what = "a margin is head-room of what must hold, and nothing must hold wholly"
            yield Fault(path, what, "remove 'margin', or write it into the counts")
        if name == "satisfaction" and prefer:
            what = "what must hold cannot hold in part"
            remedy = "remove 'satisfaction', and prefer with 'partial: true' what may"
            yield Fault(path, what, remedy)
    names = [soft.name for soft in prefer]
    for number, name in enumerate(names):
        if name in names[:number]:
            what = f"two preferences are called '{name}'"
            yield Fault(preferred(number, "name"), what, "rename one")


def delay_faults(
    delay: int, objective: Sequence[str], *, resources: bool, expected: bool, modular: bool
) -> Iterator[Fault]:
    """What cannot be asked for together with agents that may be late."""
    aims = [("objective", place) for place, name in enumerate(objective) if name == "delay"]
    path: Place = ("delay",) if delay else next(iter(aims), ())
    if path and resources:
        what = "cargo moves with the robots that are on time, and these may be late"
        yield Fault(path, what, "remove the resources, or plan without delay")
    if path and modular:
        what = "structures are rebuilt by those that are on time, and these may be late"
        yield Fault(path, what, "remove the configurations, or plan without delay")
    if delay and expected:
        what = "of uncertain moves expected numbers are planned, and these say nothing of delays"
        yield Fault(path, what, "remove 'delay'")
    for place in aims:
        if {"satisfaction", "preferences"}.intersection(objective):
            what = "how late agents may be is told of what must hold alone"
            yield Fault(place, what, "write 'delay: 2' for the steps that all is to stand")


def late_faults(delay: int, horizon: int) -> Iterator[Fault]:
    """A delay beyond the end of a mission."""
    if delay > horizon:
        what = f"agents may be {delay} steps late, and the mission ends at step {horizon}"
        yield Fault(("delay",), what, f"write at most {horizon}")


def objective_faults(objective: Sequence[str], swarm: SwarmRules | None) -> Iterator[Fault]:
    """Unknown and repeated objectives, and those of swarms where there is none."""
    known = objectives_for(swarms=swarm is not None)
    for place, name in enumerate(objective):
        path = ("objective", place)
        if name in OBJECTIVES and name not in known:
            what = f"objective '{name}' is for swarms, and this mission is for a team"
            yield Fault(path, what, f"use {', '.join(known)}")
        elif name not in known:
            yield Fault(path, f"unknown objective '{name}'", nearest(name, known))
        elif name in objective[:place]:
            yield Fault(path, f"objective '{name}' is named twice", "remove one")
