"""What the independent check says of the plan of a swarm mission."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import TYPE_CHECKING

from tsplan.checking.claimed_values import shown
from tsplan.checking.count_traces import count_trace
from tsplan.checking.swarm_check import (
    Spot,
    Traffic,
    broken_bounds,
    counts_of,
    crowded,
    differences,
    moves_of_paths,
    read_moves,
    robustness_of,
    spots,
    swarm_values,
)
from tsplan.plans.moves import Move
from tsplan.plans.subswarms import SubSwarm, subswarms

if TYPE_CHECKING:
    from tsplan.checking.plan_check import Journeys
    from tsplan.logic.traces import CountTrace
    from tsplan.mission import Mission
    from tsplan.plans.plan import Plan


@dataclass(frozen=True)
class Verdict:
    """What is wrong with a plan; unless its moves are impossible, all values and the counts."""

    problems: tuple[str, ...]
    values: Mapping[str, float] | None = None
    trace: CountTrace | None = None


def judged_swarms(mission: Mission, plan: Plan, journeys: Journeys) -> Verdict:
    """Judge the plan of a swarm mission by its agents' paths where it has them, else by its moves.

    `journeys` are the paths of the agents, already read against the map.
    """
    moves = moves_of_paths(journeys) if journeys else plan.moves
    traffic, problems = read_moves(mission, moves)
    if journeys and plan.moves:
        problems += differences(moves, plan.moves)
    if problems:
        return Verdict(tuple(problems))
    assert mission.swarm is not None
    table = spots(traffic, mission.horizon)
    problems += broken_bounds(mission.swarm, table)
    problems += crowded(mission.system, traffic, mission.horizon)
    availability, with_margin = robustness_of(mission, traffic)
    if mission.partial:
        pass  # it may fail; by how much is another matter
    elif availability < 0:
        problems.append(f"the formula does not hold (its availability is {shown(availability)})")
    elif with_margin < 0:
        short = f"{shown(-with_margin)} short of the mission's margin"
        problems.append(f"the formula holds, but some demand falls {short}")
    problems += _misnamed(plan.groups, table)
    if not problems and plan.groups:
        problems += _unrelated(plan.groups, groups_of_traffic(traffic, mission.horizon))
    values = swarm_values(traffic, table) | {"availability": availability}
    counts = counts_of(mission, traffic, tuple(mission.system.states))
    return Verdict(tuple(problems), values, count_trace(mission.system, counts))


def strange_swarms(mission: Mission, plan: Plan, journeys: Journeys) -> list[str]:
    """Moves that are impossible on the map, and sub-swarms that the moves do not make.

    `journeys` are the paths of the agents; their moves count where the plan names none.
    """
    moves = plan.moves or moves_of_paths(journeys)
    traffic, problems = read_moves(mission, moves)
    if not problems and journeys and plan.moves:
        problems += differences(moves_of_paths(journeys), plan.moves)
    if not problems:
        problems += _misnamed(plan.groups, spots(traffic, mission.horizon))
    return problems


def swarm_completed(mission: Mission, plan: Plan, journeys: Journeys) -> Plan:
    """A plan that the check can read, with its moves and sub-swarms where it names none."""
    moves = plan.moves or moves_of_paths(journeys)
    traffic, problems = read_moves(mission, moves)
    if problems:
        return plan
    groups = plan.groups or groups_of_traffic(traffic, mission.horizon)
    return replace(plan, moves=moves, groups=groups)


def swarm_facts(
    mission: Mission, plan: Plan, values: Mapping[str, Fraction | float]
) -> tuple[str, ...]:
    """In words, what was found to hold of an accepted plan's moves."""
    assert mission.swarm is not None
    facts = [
        f"{group.class_name} keeps its {group.count:,} agents from its start on"
        for group in mission.team
    ]
    facts.append(f"every move follows the map's edges at their durations up to step {plan.horizon}")
    if plan.agents and plan.moves:
        facts.append(f"the paths of {len(plan.agents):,} agents say the same as the moves")
    facts.append(
        "the bounds on sub-swarms are kept at every step; the smallest one has "
        f"{int(values['balance']):,} agents"
    )
    if mission.swarm.margin:
        facts.append("every demand of the formula has the mission's head-room")
    return tuple(facts)


def groups_of_traffic(traffic: Sequence[Traffic], horizon: int) -> tuple[SubSwarm, ...]:
    """The sub-swarms of moves that fit the map."""
    return tuple(
        group
        for item in traffic
        for group in subswarms(
            item.group.class_name,
            {state: count for (state, step), count in item.present.items() if step == 0},
            [Move(t.step, t.edge.source, t.edge.target, t.count) for t in item.trips],
            {(t.edge.source, t.edge.target): t.left - t.step for t in item.trips},
            horizon,
        )
    )


def _misnamed(groups: Sequence[SubSwarm], table: Sequence[Sequence[Spot]]) -> Iterator[str]:
    """Steps at which the plan's sub-swarms are not those that the check counts."""
    at: list[set[Spot]] = [set() for _ in table]
    for group in groups:
        for step in range(group.first, min(group.last + 1, len(table))):
            at[step].add(_spot(group))
    for step, (row, named) in enumerate(zip(table, at, strict=True) if groups else ()):
        for spot in sorted(named - set(row)):
            yield (
                f"the plan names a sub-swarm of {spot.size} agents of {spot.swarm} {spot.place} at "
                f"step {step}, which its moves do not make"
            )
        for spot in sorted(set(row) - named):
            yield (
                f"the plan names no sub-swarm of {spot.size} agents of {spot.swarm} {spot.place} "
                f"at step {step}, which its moves make"
            )


def _spot(group: SubSwarm) -> Spot:
    since = "" if group.edge is None else f" since step {group.first - 1}"
    return Spot(group.swarm, f"{group.place}{since}", group.size)


def _unrelated(named: Sequence[SubSwarm], made: Sequence[SubSwarm]) -> Iterator[str]:
    """Sub-swarms whose steps or relatives are not what the moves make of them."""
    key = {group.id: _key(group) for group in named}
    own = {group.id: _key(group) for group in made}
    true = {_key(group): _relatives(group, own) for group in made}
    for group in named:
        if true.get(_key(group)) != _relatives(group, key):
            yield (
                f"sub-swarm {group.id} {group.place} from step {group.first} to {group.last} has "
                "other steps, parents or children by the moves"
            )


def _key(group: SubSwarm) -> tuple[str, str, int, int]:
    return group.swarm, group.place, group.first, group.last


def _relatives(group: SubSwarm, key: Mapping[str, object]) -> tuple[frozenset[object], ...]:
    return (
        frozenset(key.get(other) for other in group.parents),
        frozenset(key.get(other) for other in group.children),
    )
