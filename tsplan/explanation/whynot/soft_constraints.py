"""What a mission consists of, as constraints that can be taken out one by one."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tsplan.explanation.explanation import SoftConstraint
from tsplan.explanation.whynot.mission_numbers import MARGIN, TOGETHER
from tsplan.explanation.whynot.occurrences import Occurrence, conjuncts, occurrences
from tsplan.explanation.whynot.posed_mission import own_of, useful_robots
from tsplan.ts.waits import without_wait

if TYPE_CHECKING:
    from tsplan.document import Path
    from tsplan.mission import Mission
    from tsplan.signals.result_check import AnyMission

WAITING = SoftConstraint("waiting", ())
"""That nobody can wait at the states without an edge to themselves."""


BOOKING = SoftConstraint("booking", ())
"""That agents are booked for tasks."""


def of_occurrence(occurrence: Occurrence) -> SoftConstraint:
    """The constraint of a part of the formula."""
    return SoftConstraint("formula", tuple(occurrence))


def occurrence_of(constraint: SoftConstraint) -> Occurrence:
    """The part of the formula that a constraint stands for."""
    return Occurrence(*constraint.key)


def formula_groups(mission: AnyMission) -> tuple[tuple[SoftConstraint, ...], ...]:
    """The parts of the formula, those of one conjunct together, in the order of the text."""
    formula = mission.formula
    return tuple(
        tuple(of_occurrence(part) for part in occurrences(formula, way))
        for way in conjuncts(formula)
    )


def named_facts(mission: Mission) -> tuple[SoftConstraint, ...]:
    """Everything that bounds the plans beside the formula, what matters most to people first.

    How many robots an entry of the team has, where they start and how much they carry can be taken
    out, and how much there is of a resource; of a swarm how it may divide and its head-room. Its
    size and its start stay, and so does the map, but for its capacities (those of edges by the
    direction that comes first) and for states without a wait. Agents that are booked for tasks can
    be shared. Where own constraints weigh agents against each other, any number of robots may be of
    use, and their numbers stay as they are.
    """
    system = mission.system
    entries = robot_entries(mission)
    sized = () if useful_robots(mission) is None else entries
    return (
        *(SoftConstraint("own", (n,)) for n, item in enumerate(own_of(mission)) if item.bounds),
        *(SoftConstraint("team", (number,)) for number in sized),
        *(SoftConstraint("start", (number,)) for number in entries),
        *(
            SoftConstraint("carries", (number,))
            for number in entries
            if mission.team[number].carries
        ),
        *(SoftConstraint("stock", (item.name,)) for item in mission.resources),
        *((BOOKING,) if mission.books else ()),
        *((WAITING,) if without_wait(system) else ()),
        *group_bounds(mission),
        *(
            SoftConstraint("capacity", (state.name,))
            for state in system.states.values()
            if state.capacity is not None
        ),
        *(SoftConstraint("capacity", pairs[0]) for _, pairs in system.capacity_groups),
        *(SoftConstraint("zone", (name,)) for name in system.zones),
    )


def robot_entries(mission: Mission) -> tuple[int, ...]:
    """The numbers of the team's entries that are no swarms."""
    bounds = [mission.group_bounds(group.class_name) for group in mission.team]
    return tuple(number for number, own in enumerate(bounds) if own is None)


def group_bounds(mission: Mission) -> tuple[SoftConstraint, ...]:
    """What bounds the swarms of a mission; nothing where there are none."""
    rules = mission.swarm
    if rules is None:
        return ()
    keys = []
    for name, bounds in rules.each.items():
        keys += [(name, "most")] if bounds.most is not None else []
        keys += [(name, "least")] if bounds.least > 1 else []
    keys += [TOGETHER] if rules.together is not None else []
    keys += [MARGIN] if rules.margin else []
    return tuple(SoftConstraint("swarm", key) for key in keys)


def file_path(mission: Mission, constraint: SoftConstraint) -> Path:
    """Where a mission file says what is no part of the formula."""
    kind, key = constraint
    if kind == "waiting":
        return ("map", "waiting")
    if kind == "booking":
        return ("booking",)
    if kind in ("capacity", "zone"):
        return _room_path(constraint)
    if kind == "stock":
        return ("resources", [item.name for item in mission.resources].index(key[0]))
    if kind == "swarm":
        word = {"most": "max_subswarms", "least": "min_subswarm", "margin": "margin"}[key[1]]
        names = [group.class_name for group in mission.team]
        return (*_entry_path(mission, names.index(key[0])), word) if key[0] else (word,)
    words = {"team": "count", "start": "at", "carries": "carries"}
    return (*_entry_path(mission, key[0]), words[kind])


def _room_path(constraint: SoftConstraint) -> Path:
    """Where a mission file says how many agents a state, an edge or a zone holds."""
    kind, key = constraint
    if kind == "zone":
        return ("map", "zones", key[0])
    return ("map", "states", key[0], "capacity") if len(key) == 1 else ("map", "edges")


def _entry_path(mission: Mission, number: int) -> Path:
    """Where a mission file says what an entry of the team is, or a swarm."""
    robots = robot_entries(mission)
    if number in robots:
        return ("team", robots.index(number))
    swarms = [n for n in range(len(mission.team)) if n not in robots]
    data = mission.origin.data if mission.origin is not None else {}
    return ("swarms", swarms.index(number)) if "swarms" in data else ("swarm",)
