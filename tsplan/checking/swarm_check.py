"""The independent check of swarms: their moves read against the map, and what follows from them.

It counts agents, sub-swarms, splits and objectives itself, from nothing but the moves, the map and
the mission, and shares no code with what makes plans.
"""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from tsplan.checking.count_traces import counts_robustness
from tsplan.plans.moves import Move

if TYPE_CHECKING:
    from tsplan.checking.plan_check import Journeys
    from tsplan.milp.model import Ints
    from tsplan.mission import Group, Mission, SwarmRules
    from tsplan.ts import Edge, TransitionSystem


class Trip(NamedTuple):
    """`count` agents enter `edge` at `step` and arrive at step `left`, maybe after the horizon."""

    edge: Edge
    step: int
    left: int
    count: int  # type: ignore[assignment]  # hides tuple.count, which no trip is asked


class Spot(NamedTuple):
    """A sub-swarm at one step, as the check counts them: whose, where, and how many agents."""

    swarm: str
    place: str
    size: int


@dataclass(frozen=True)
class Traffic:
    """One swarm's moves read against the map: the trips, and who is where up to the horizon."""

    group: Group
    trips: tuple[Trip, ...]
    present: Mapping[tuple[str, int], int]


def moves_of_paths(journeys: Journeys) -> dict[str, tuple[Move, ...]]:
    """The moves that the agents' paths make together, by class."""
    entered: dict[str, Counter[tuple[int, str, str]]] = defaultdict(Counter)
    for bundle, legs in journeys:
        agents = len(bundle.agents)
        counted = entered[bundle.class_name]  # there even if nobody ever moves
        for leg in legs:
            for step in range(leg.entered, leg.left, (leg.left - leg.entered) // leg.times):
                counted[step, leg.edge.source, leg.edge.target] += agents
    return {
        swarm: tuple(sorted(Move(*edge, count) for edge, count in counted.items()))
        for swarm, counted in entered.items()
    }


def differences(
    paths: Mapping[str, Sequence[Move]], moves: Mapping[str, Sequence[Move]]
) -> list[str]:
    """Where the agents' paths and the moves of a plan do not say the same."""
    found = []
    for swarm in sorted({*paths, *moves}):
        walked = {move[:3]: move.count for move in paths.get(swarm, ())}
        named = {move[:3]: move.count for move in moves.get(swarm, ())}
        for entry in sorted({*walked, *named}):
            step, source, target = entry
            if walked.get(entry, 0) != named.get(entry, 0):
                how = f"wait at {source}" if source == target else f"go from {source} to {target}"
                found.append(
                    f"at step {step}, {named.get(entry, 0)} agents of {swarm} {how} by the moves "
                    f"and {walked.get(entry, 0)} by the agents' paths"
                )
    return found


def read_moves(
    mission: Mission, moves: Mapping[str, Sequence[Move]]
) -> tuple[tuple[Traffic, ...], list[str]]:
    """Every swarm's moves on the map, and everything that is impossible about them."""
    known = {group.class_name for group in mission.team}
    problems = [
        f"the plan moves '{name}', which the mission does not have"
        for name in moves
        if name not in known
    ]
    traffic = []
    for group in mission.team:
        if group.class_name not in moves:
            problems.append(f"the plan has no moves of {group.class_name}")
            continue
        made, wrong = _read(mission.system, group, moves[group.class_name], mission.horizon)
        traffic.append(made)
        problems += [f"{group.class_name} {words}" for words in wrong]
    return tuple(traffic), problems


def _read(
    system: TransitionSystem, group: Group, moves: Sequence[Move], horizon: int
) -> tuple[Traffic, list[str]]:
    problems: list[str] = []
    trips = [trip for move in moves if (trip := _trip(system, group, move, problems)) is not None]
    repeated = [entry for entry, times in Counter(move[:3] for move in moves).items() if times > 1]
    for step, source, target in repeated:
        problems.append(f"names the move from {source} to {target} at step {step} twice")
    present: Counter[tuple[str, int]] = Counter()
    for state, count in group.starts:
        present[state, 0] += count
    gone: Counter[tuple[str, int]] = Counter()
    for trip in trips:
        gone[trip.edge.source, trip.step] += trip.count
        present[trip.edge.target, trip.left] += trip.count
    if not problems:
        problems += _unconserved(present, gone, horizon)
    inside = {node: count for node, count in present.items() if node[1] <= horizon}
    late = [trip for trip in trips if not 0 <= trip.step < horizon]
    problems += [f"moves at step {trip.step}, and the plan ends at {horizon}" for trip in late]
    return Traffic(group, tuple(trips), inside), problems


def _trip(system: TransitionSystem, group: Group, move: Move, problems: list[str]) -> Trip | None:
    """A move on the map; what is wrong with it goes to `problems`."""
    step, source, target, count = move
    how = f"waits at {source}" if source == target else f"goes from {source} to {target}"
    edge = system.edges.get((source, target))
    if count < 1:
        problems.append(f"{how} at step {step} with {count} agents")
    if edge is None:
        problems.append(f"{how} at step {step}, and the map has no such edge")
        return None
    needs = edge.needs | system.states[target].needs
    if not needs <= group.capabilities:
        missing = ", ".join(sorted(needs - group.capabilities))
        problems.append(f"{how} at step {step}, which needs {missing}")
    duration = edge.duration_for(group.class_name)
    if duration is None:
        problems.append(f"{how} at step {step} by an edge that it lacks")
        return None
    return Trip(edge, step, step + duration, count)


def _unconserved(
    present: Mapping[tuple[str, int], int], gone: Mapping[tuple[str, int], int], horizon: int
) -> Iterator[str]:
    """Agents that are lost or come from nowhere."""
    for state, step in sorted({*present, *gone}, key=lambda node: (node[1], node[0])):
        here, left = present.get((state, step), 0), gone.get((state, step), 0)
        if step >= horizon or here == left:
            continue
        words = f"{here - left} lost" if here > left else f"{left - here} come from nowhere"
        yield f"has {here} agents at {state} at step {step} and {left} leave or wait: {words}"


def counts_of(
    mission: Mission, traffic: Iterable[Traffic], states: Sequence[str]
) -> dict[str | None, Ints]:
    """Agents at each of `states` and step, of all swarms (None) and by capability."""
    row = {state: number for number, state in enumerate(states)}
    shape = (len(states), mission.horizon + 1)
    counts: dict[str | None, Ints] = {None: np.zeros(shape, dtype=np.int64)}
    for item in traffic:
        for name in (None, *item.group.capabilities):
            array = counts.setdefault(name, np.zeros(shape, dtype=np.int64))
            for (state, step), count in item.present.items():
                if state in row:
                    array[row[state], step] += count
    return counts


def spots(traffic: Iterable[Traffic], horizon: int) -> list[list[Spot]]:
    """The sub-swarms at every step 0..horizon.

    At a state all agents of a swarm are one; on an edge those that entered it at the same step
    are one, at every step strictly between that and their arrival.
    """
    table: list[list[Spot]] = [[] for _ in range(horizon + 1)]
    for item in traffic:
        name = item.group.class_name
        for (state, step), count in item.present.items():
            table[step].append(Spot(name, f"at {state}", count))
        for edge, step, left, count in item.trips:
            way = f"on the way from {edge.source} to {edge.target} since step {step}"
            for inside in range(step + 1, min(left, horizon + 1)):
                table[inside].append(Spot(name, way, count))
    return [sorted(row) for row in table]


def broken_bounds(rules: SwarmRules, table: Sequence[Sequence[Spot]]) -> Iterator[str]:
    """Steps at which there are too many sub-swarms, or too small ones."""
    for step, row in enumerate(table):
        for swarm, bounds in rules.each.items():
            mine = [spot for spot in row if spot.swarm == swarm]
            if bounds.most is not None and len(mine) > bounds.most:
                listed = ", ".join(f"{spot.size} {spot.place}" for spot in mine)
                yield (
                    f"{swarm} is in {len(mine)} sub-swarms at step {step}, and max_subswarms is "
                    f"{bounds.most}: {listed}"
                )
            for spot in mine:
                if spot.size < bounds.least:
                    yield (
                        f"the sub-swarm of {swarm} {spot.place} has {spot.size} agents at step "
                        f"{step}, and min_subswarm is {bounds.least}"
                    )
        if rules.together is not None and len(row) > rules.together:
            yield (
                f"the swarms together are in {len(row)} sub-swarms at step {step}, and "
                f"max_subswarms is {rules.together}"
            )


def crowded(system: TransitionSystem, traffic: Sequence[Traffic], horizon: int) -> Iterator[str]:
    """Steps at which more agents are somewhere than fit."""
    at: Counter[tuple[str, int]] = Counter()
    for item in traffic:
        at.update(item.present)
    for (state, step), count in sorted(at.items(), key=lambda entry: (entry[0][1], entry[0][0])):
        capacity = system.states[state].capacity
        if capacity is not None and count > capacity:
            yield f"{count} agents are at {state} at step {step}, which holds {capacity}"
    for capacity, pairs in system.capacity_groups:
        row = np.zeros(horizon + 2, dtype=np.int64)
        for edge, step, left, count in (trip for item in traffic for trip in item.trips):
            if (edge.source, edge.target) in pairs:
                row[step : min(left, horizon + 1)] += count
        where = f"on the edge from {pairs[0][0]} to {pairs[0][1]}"
        for step in np.flatnonzero(row > capacity).tolist():
            yield f"{row[step]} agents are {where} at step {step}, which holds {capacity}"


def swarm_values(traffic: Sequence[Traffic], table: Sequence[Sequence[Spot]]) -> dict[str, float]:
    """Every objective of swarms except availability.

    `splits`: agents at a state that leave by j edges, waits too, split j-1 times. `travel`: steps
    that all agents spend on moves. `moves`: how often a sub-swarm enters an edge that is no wait.
    `balance`: the size of the smallest sub-swarm. `makespan`: when the last move arrives.
    """
    exits = Counter(
        (item.group.class_name, trip.edge.source, trip.step)
        for item in traffic
        for trip in item.trips
    )
    away = [trip for item in traffic for trip in item.trips if not trip.edge.is_wait]
    return {
        "splits": float(sum(times - 1 for times in exits.values())),
        "travel": float(sum(trip.count * (trip.left - trip.step) for trip in away)),
        "moves": float(len(away)),
        "balance": float(min(spot.size for row in table for spot in row)),
        "makespan": float(max((trip.left for trip in away), default=0)),
    }


def robustness_of(mission: Mission, traffic: Sequence[Traffic]) -> tuple[float, float]:
    """Availability of the formula as written, and of the formula with the mission's margin."""
    counts = counts_of(mission, traffic, tuple(mission.system.states))
    return (
        counts_robustness(mission.system, mission.counted, counts),
        counts_robustness(mission.system, mission.goal, counts),
    )
