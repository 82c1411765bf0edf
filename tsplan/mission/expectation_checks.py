"""What has to fit together where moves are uncertain and expected numbers are planned."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from tsplan.mission.findings import Fault, Place, preferred
from tsplan.mission.mission_parts import Preference
from tsplan.mission.objectives import OBJECTIVES, objectives_for
from tsplan.mission.team import Expectation, SwarmRules
from tsplan.ts import TransitionSystem


def expectation_faults(
    expected: Expectation | None,
    swarm: SwarmRules | None,
    objective: Sequence[str],
    prefer: Sequence[Preference],
    *,
    resources: bool,
    modular: bool,
) -> Iterator[Fault]:
    """What nothing is known of in expectation: swarms, some objectives, what holds in part."""
    if expected is None:
        return
    if swarm is not None:
        what = "swarms move for sure, and the mission asks for expected numbers"
        yield Fault(("dynamics",), what, "describe a team, or drop 'dynamics'")
    if resources:
        what = "amounts move with robots for sure, and the mission asks for expected numbers"
        yield Fault(("resources",), what, "leave them out, or drop 'dynamics'")
    if modular:
        what = "structures are rebuilt for sure, and the mission asks for expected numbers"
        yield Fault(("configurations",), what, "leave them out, or drop 'dynamics'")
    told = objectives_for(swarms=False, expected=True)
    for number, name in enumerate(objective):
        if name in OBJECTIVES and name not in told and (name != "preferences" or not prefer):
            path: Place = ("objective", number)
            what = f"objective '{name}' has no expected value"
            yield Fault(path, what, f"use {', '.join(told)}")
    for number, _ in enumerate(prefer[:1]):
        what = "preferences are met or not, and expected numbers tell of neither"
        yield Fault(preferred(number), what, "demand it, or leave it out")


def chance_faults(system: TransitionSystem, expected: Expectation | None) -> Iterator[Fault]:
    """Maps of uncertain moves for certain ones, and the other way round."""
    if expected is None:
        if system.actions:
            what = "the outcomes of the map's actions are uncertain"
            yield Fault(("map",), what, "add 'dynamics: expected' to plan expected numbers")
        return
    if not system.actions:
        what = "the map has no actions, so all its moves are certain"
        yield Fault(("dynamics",), what, "drop 'dynamics', or give the map 'actions'")
    limited = [state.name for state in system.states.values() if state.capacity is not None]
    for names, noun in ((limited, ""), (system.zones, "the zone ")):
        for name in names:
            what = f"{noun}'{name}' has a capacity, which uncertain moves cannot keep for sure"
            remedy = "remove it, or bound the expected number in the formula, as in max(label) <= 2"
            yield Fault(("map",), what, remedy)
