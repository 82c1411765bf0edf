"""Who moves when: the plan as lanes that a picture can follow smoothly.

A mover is one or more agents that share a path. At a state its agents take slots, small numbers
that no other agent there has at the same time, so that a picture can give each one a place of its
own and keep it there for the whole stay.
"""

from __future__ import annotations

from bisect import bisect_right
from collections import defaultdict
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, NamedTuple

from tsplan.checking.path_segments import read_path
from tsplan.errors import Finding, PlanError
from tsplan.plans.summary import names
from tsplan.viewer.lanes import lanes

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from tsplan.mission import Mission
    from tsplan.plans.moves import Move
    from tsplan.plans.plan import Plan
    from tsplan.ts import TransitionSystem

MOST_SLOTS = 127
"""Agents at one state that get a place of their own; more are shown as a number anyway."""


class Stop(NamedTuple):
    """At a state at every step `first..last`, on the slots from `slot` on.

    A stop beyond the horizon is where the mover is travelling to when the plan ends.
    """

    first: int
    last: int
    state: str
    slot: int


class Whereabouts(NamedTuple):
    """At `source` (`share` is 0), or `share` of the way from `source` to `target`."""

    source: Stop
    target: Stop
    share: float


@dataclass(frozen=True, slots=True)
class Mover:
    """`count` agents of one class on one path, from its first step on, and gone from `end` on.

    `ids` are the agents' names; none where agents have none.
    """

    class_name: str
    count: int
    name: str
    ids: tuple[str, ...]
    stops: tuple[Stop, ...]
    end: int

    def present(self, time: float) -> bool:
        """Whether the mover is there: agents always are, parts of a swarm while they last."""
        return self.stops[0].first <= time < self.end

    def at(self, time: float) -> Whereabouts:
        """Where the mover is at a time between 0 and the horizon, not only at whole steps."""
        place = max(0, bisect_right(self.stops, time, key=lambda stop: stop.first) - 1)
        here = self.stops[place]
        if time <= here.last or place + 1 == len(self.stops):
            return Whereabouts(here, here, 0.0)
        there = self.stops[place + 1]
        return Whereabouts(here, there, (time - here.last) / (there.first - here.last))


def movers(mission: Mission, plan: Plan) -> tuple[Mover, ...]:
    """The movers of a plan: one for each of its distinct paths, in the order of the agents.

    The movers of swarms are groups that last until they split or merge, in the order they begin.
    Raises PlanError with everything that the map does not allow about the paths.
    """
    made = _of_swarms(mission, plan) if plan.moves else _of_agents(mission.system, plan)
    slots = with_slots([mover.stops for mover in made], [mover.count for mover in made])
    return tuple(replace(mover, stops=stops) for mover, stops in zip(made, slots, strict=True))


def _of_agents(system: TransitionSystem, plan: Plan) -> list[Mover]:
    """One mover for each bundle of agents, all of them at slot 0."""
    made: list[Mover] = []
    findings: list[Finding] = []
    for bundle in plan.bundles:
        ids = tuple(plan.agents[place].id for place in bundle.agents)
        path = read_path(system, bundle, plan.horizon)
        findings += [
            Finding(f"agent {ids[0]} {problem}", "name the mission that was planned")
            for problem in path.problems
        ]
        stops = [Stop(*stay, slot=0) for stay in bundle.stays]
        if path.segments and path.segments[-1].left > plan.horizon:
            leg = path.segments[-1]
            stops.append(Stop(leg.left, leg.left, leg.edge.target, 0))
        made.append(
            Mover(bundle.class_name, len(ids), names(ids), ids, tuple(stops), end=plan.horizon + 1)
        )
    if findings:
        raise PlanError(findings)
    return made


def _of_swarms(mission: Mission, plan: Plan) -> list[Mover]:
    """The groups of every swarm, all of them at slot 0."""
    made: list[Mover] = []
    for swarm in mission.team:
        name, moves = swarm.class_name, plan.moves.get(swarm.class_name, ())
        durations = {
            (move.source, move.target): _duration(mission.system, name, move) for move in moves
        }
        groups = lanes(dict(swarm.starts), moves, durations, plan.horizon)
        for lane in sorted(groups, key=lambda lane: lane.stays[0][0]):
            stops = tuple(Stop(*stay, slot=0) for stay in lane.stays)
            made.append(Mover(name, lane.count, f"{name} ({lane.count:,})", (), stops, lane.end))
    return made


def _duration(system: TransitionSystem, swarm: str, move: Move) -> int:
    edge = system.edges.get((move.source, move.target))
    duration = None if edge is None else edge.duration_for(swarm)
    if duration is None:
        what = f"{swarm} goes from {move.source} to {move.target}, and the map has no such edge"
        raise PlanError([Finding(what, "name the mission that was planned")])
    return duration


def with_slots(paths: Iterable[Sequence[Stop]], counts: Sequence[int]) -> list[tuple[Stop, ...]]:
    """The paths with slots: at each state the first free ones, in the order of arrival."""
    placed = [list(path) for path in paths]
    visits: defaultdict[str, list[tuple[int, int, int]]] = defaultdict(list)
    for number, path in enumerate(placed):
        for place, stop in enumerate(path):
            visits[stop.state].append((stop.first, number, place))
    for arrivals in visits.values():
        taken: list[tuple[int, int, int]] = []  # slots from .. to (excluded), until this step
        for first, number, place in sorted(arrivals):
            taken = [entry for entry in taken if entry[2] >= first]
            stop = placed[number][place]
            slot = _free(taken, counts[number])
            if slot + counts[number] <= MOST_SLOTS:
                taken.append((slot, slot + counts[number], stop.last))
                taken.sort()
            placed[number][place] = stop._replace(slot=slot)
    return [tuple(path) for path in placed]


def _free(taken: Sequence[tuple[int, int, int]], wanted: int) -> int:
    """The first of `wanted` free slots in a row."""
    slot = 0
    for begin, end, _ in taken:
        if slot + wanted <= begin:
            return slot
        slot = max(slot, end)
    return slot
