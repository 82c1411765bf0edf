"""Who moves when: agents, paths and groups of swarms as tracks, for every picture and the page.

A track is one or more agents of one class that move together: all agents that share a path, a
group of a swarm for as long as it neither splits nor merges, or a structure of modules for as long
as it lasts. The class of a structure is its configuration.
"""

from __future__ import annotations

from bisect import bisect_right
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise
from typing import NamedTuple, TypeAlias

from tsplan.checking.path_segments import Path, read_path
from tsplan.checking.structure_check import structure_path
from tsplan.errors import Finding, PlanError
from tsplan.mission import Mission
from tsplan.mission.team import UnderWay
from tsplan.name_runs import Names
from tsplan.plans.bundles import Bundle
from tsplan.plans.cargo_rows import AgentLoads, carried_by
from tsplan.plans.moves import Starts
from tsplan.plans.plan import Plan
from tsplan.plans.structures import Structure
from tsplan.plans.summary import names
from tsplan.plans.supplies import Loads
from tsplan.ts import TransitionSystem

MoveTuple: TypeAlias = tuple[int, str, str, int]
"""`(step, source, target, count)`: so many agents enter this edge at this step, waits included."""

_OTHER = "name the mission that was planned"


class Stop(NamedTuple):
    """At a state at every step `first..last`, on the slots from `slot` on.

    A stop beyond the horizon is where the agents are travelling to when the plan ends.
    """

    first: int
    last: int
    state: str
    slot: int = 0


class Whereabouts(NamedTuple):
    """At `source` (`share` is 0), or `share` of the way from `source` to `target`."""

    source: Stop
    target: Stop
    share: float


class Life(NamedTuple):
    """The steps at which a module is part of a structure, whose id and configuration these are."""

    first: int
    last: int
    id: str
    configuration: str


@dataclass(frozen=True, slots=True)
class Track:
    """`count` agents of one class together, from their first step on, and no more from `end` on.

    `ids` are the agents' names; none where agents have none. A structure has `modules`, and a
    module that is shown by itself the `lives` of the structures that it is part of.
    """

    class_name: str
    count: int
    name: str
    ids: Sequence[str]
    stops: tuple[Stop, ...]
    end: int
    modules: tuple[str, ...] = ()
    lives: tuple[Life, ...] = ()
    begun: str | None = None  # of agents that are on an edge from before step 0, its beginning

    @property
    def width(self) -> int:
        """How many move together: agents, or the modules of a structure."""
        return len(self.modules) or self.count

    @property
    def short(self) -> str:
        """The name with one run of agents at most, the others counted."""
        if self.modules:
            return f"{self.ids[0]} ({len(self.modules)})"
        return names(self.ids, most=1) if self.ids else self.name

    @property
    def moves(self) -> bool:
        """Whether they are ever at another state, or head for one."""
        return self.begun is not None or len({stop.state for stop in self.stops}) > 1

    def load(self, step: int, loads: AgentLoads) -> Loads:
        """What all of them carry together along the edge that they enter at a step."""
        return carried_by(Names.of(self.ids), step, loads) if step in loads else {}

    def present(self, time: float) -> bool:
        """Whether they are there: agents always are, parts of a swarm while they last."""
        begin = 0 if self.begun is not None else self.stops[0].first
        return begin <= time < self.end

    def at(self, time: float, dwell: float = 0.0) -> Whereabouts:
        """Where they are at a time between 0 and the horizon, not only at whole steps.

        They leave so much after a step, and arrive so much before one, as `dwell` says.
        """
        before = bisect_right(self.stops, time + dwell, key=lambda stop: stop.first) - 1
        place = max(0, before)
        here = self.stops[place]
        if self.begun is not None and time < here.first:  # nobody knows when it was entered
            return Whereabouts(Stop(-1, -1, self.begun), here, (time + 1) / (here.first + 1))
        if time <= here.last + dwell or place + 1 == len(self.stops):
            return Whereabouts(here, here, 0.0)
        there = self.stops[place + 1]
        begin, end = here.last + dwell, there.first - dwell
        return Whereabouts(here, there, (time - begin) / (end - begin))

    def only(self, wanted: frozenset[str]) -> Track | None:
        """The track of some of its agents, named by their ids or by their class; None without."""
        if self.class_name in wanted or wanted & {*self.modules}:
            return self
        ids = tuple(name for name in self.ids if name in wanted)
        if not ids or len(ids) == len(self.ids):
            return self if ids else None
        return replace(self, count=len(ids), name=names(ids), ids=ids)

    def stays(self, horizon: int) -> tuple[Stop, ...]:
        """The stops up to the horizon, as far as the track lasts."""
        last = min(self.end - 1, horizon)
        return tuple(
            stop._replace(last=min(stop.last, last)) for stop in self.stops if stop.first <= last
        )

    def journeys(self, horizon: int) -> Iterator[tuple[int, int]]:
        """The steps at which they leave a state and come to another, even if these are neighbours.

        One that is not over at the horizon ends after it.
        """
        last = min(self.end - 1, horizon)
        rebuilt = self.lives and self.begun == self.stops[0].state
        if self.begun is not None and self.stops[0].first > 0 and not rebuilt:
            yield 0, min(self.stops[0].first, horizon + 1)
        for here, there in pairwise(self.stops):
            gap = here.last + 1, there.first - 1
            whole = gap[0] > gap[1] or not self.lives or self._whole(gap)
            if here.last <= last and here.state != there.state and whole:
                yield here.last, min(there.first, horizon + 1)

    def _whole(self, gap: tuple[int, int]) -> bool:
        """Whether modules are part of one structure all through a gap between two stops."""
        return any(life.first <= gap[0] <= life.last for life in self.lives)


def tracks(
    plan: Plan, mission: Mission | None = None, *, moving: bool = False, modules: bool = False
) -> tuple[Track, ...]:
    """The tracks of a plan, class by class: of each path of agents, of each group of a swarm.

    Of modules the structures have tracks, or else with `modules` these themselves.
    A swarm whose agents have paths is shown by them. For what is `moving` it is its groups that
    move, and arrivals beyond the horizon are those of the map; then PlanError tells everything that
    the map does not allow about the paths. Without the mission there are no groups.
    """
    findings: list[Finding] = []
    known = mission is not None and moving and not plan.replanned  # what has happened is a fact
    exact = mission.system if mission is not None and known else None
    shown = plan.bundles if modules else plan.robots
    every = [_of_agents(plan, bundle, exact, findings) for bundle in shown]
    if plan.structures and modules:
        every = _with_lives(every, plan)
    elif plan.structures:
        rules = mission if moving else None
        every += (_of_structure(plan, each, rules, findings) for each in plan.structures)
    walked = by_class(every)
    if findings:
        raise PlanError(findings)
    if mission is None:
        return tuple(track for group in walked.values() for track in group)
    found: list[Track] = []
    starting = {group.class_name: dict(group.all_starts) for group in mission.team}
    if plan.structures:  # whose classes are configurations, after those of robots
        starting |= {name: {} for name in mission.modular.of}
    for name, starts in starting.items():
        if name in plan.moves and (moving or name not in walked):
            found += _of_swarm(plan, mission.system, name, starts)
        else:
            found += walked.get(name, [])
    return tuple(found)


def _of_agents(
    plan: Plan, bundle: Bundle, exact: TransitionSystem | None, findings: list[Finding]
) -> Track:
    """The track of a path; what an `exact` map does not allow about it goes to `findings`."""
    ids = bundle.agents
    path = None if exact is None else read_path(exact, bundle, plan.horizon)
    if path is not None:
        findings += [Finding(f"agent {ids[0]} {words}", _OTHER) for words in path.problems]
    stops, end = _stops(bundle, path, plan.horizon), plan.horizon + 1
    if plan.replanned and bundle.heading is None and bundle.stays:  # who is lost is gone
        end = bundle.stays[-1][1] + 1
    made = Track(bundle.class_name, len(ids), names(ids), ids, stops, end)
    return made if bundle.coming is None else replace(made, begun=bundle.coming)


def _stops(who: Bundle | Structure, path: Path | None, horizon: int) -> tuple[Stop, ...]:
    """Where somebody stays, and where a move ends that the horizon cuts short.

    Without a `path` on an exact map nobody knows when that is: soon.
    """
    stops = [Stop(*stay) for stay in who.stays]
    if not stops:
        return (Stop(horizon + 1, horizon + 1, who.heading or ""),)
    if path is None and who.heading is not None:
        stops.append(Stop(horizon + 1, horizon + 1, who.heading))
    elif path is not None and path.segments and path.segments[-1].left > horizon:
        last = path.segments[-1]
        stops.append(Stop(last.left, last.left, last.edge.target))
    return tuple(stops)


def _with_lives(found: Iterable[Track], plan: Plan) -> list[Track]:
    """The tracks of modules, each one by itself with the structures that it is part of."""
    lives: dict[str, list[Life]] = {}
    for each in sorted(plan.structures, key=lambda each: each.first):
        for module in each.modules:
            life = Life(each.first, each.last, each.id, each.configuration)
            lives.setdefault(module, []).append(life)
    return [
        replace(track, lives=tuple(lives.get(track.name, ())))
        for group in found
        for track in (single([group]) if {*group.ids} & lives.keys() else [group])
    ]


def _of_structure(
    plan: Plan, each: Structure, mission: Mission | None, findings: list[Finding]
) -> Track:
    """The track of a structure; what the map of a mission does not allow goes to `findings`."""
    path = None
    if mission is not None and each.configuration in mission.modular.of:
        path = structure_path(mission, each)
        findings += [Finding(f"structure {each.id} {words}", _OTHER) for words in path.problems]
    stops, name = _stops(each, path, plan.horizon), f"{each.id} ({names(each.modules)})"
    return Track(each.configuration, 1, name, (each.id,), stops, each.last + 1, each.modules)


def _of_swarm(plan: Plan, system: TransitionSystem, name: str, starts: Starts) -> Iterator[Track]:
    """The tracks of the groups of a swarm, in the order they begin."""
    moves = plan.moves[name]
    durations = {}
    for move in moves:
        edge = system.edges.get((move.source, move.target))
        duration = None if edge is None else edge.duration_for(name)
        if duration is None:
            what = f"{name} goes from {move.source} to {move.target}, and the map has no such edge"
            raise PlanError([Finding(what, _OTHER)])
        durations[move.source, move.target] = duration
    groups = lanes(starts, moves, durations, plan.horizon)
    ordered = sorted(groups, key=lambda lane: lane.stays[0].first)
    for number, lane in enumerate(ordered, 1):
        called = f"{name} {number}" if len(ordered) > 1 else name  # equal groups are told apart
        words, stops = f"{called} ({lane.count:,})", tuple(lane.stays)
        yield Track(name, lane.count, words, (), stops, lane.end, begun=lane.begun)


def agents_of(found: Iterable[Track]) -> int:
    """How many agents there are in all, however often their groups split and merge."""
    return sum(
        track.count
        for track in found
        if (track.ids and not track.modules) or track.begun or track.stops[0].first == 0
    )


def by_class(found: Iterable[Track]) -> dict[str, list[Track]]:
    """The tracks of each class, in their order."""
    classes: dict[str, list[Track]] = {}
    for track in found:
        classes.setdefault(track.class_name, []).append(track)
    return classes


def single(found: Iterable[Track]) -> Iterator[Track]:
    """Each agent that has a name as a track of its own; groups stay as they are."""
    for track in found:
        if not track.ids:
            yield track
        for name in track.ids:
            yield replace(track, count=1, name=name, ids=(name,))


@dataclass(eq=False)
class Lane:
    """`count` agents that stay together: their stays, and the step from which they are no more.

    A lane that ends where others begin ends at the step at which they begin.
    """

    count: int
    end: int
    stays: list[Stop] = field(default_factory=list)
    begun: str | None = None

    def arrive(self, step: int, state: str) -> None:
        """Go on at a state from a step on; at the same state as before, stay on there."""
        if self.stays and self.stays[-1][1:3] == (step - 1, state):
            self.stays[-1] = self.stays[-1]._replace(last=step)
        else:
            self.stays.append(Stop(step, step, state))


def lanes(
    starts: Starts,
    moves: Iterable[MoveTuple],
    durations: Mapping[tuple[str, str], int],
    horizon: int,
) -> tuple[Lane, ...]:
    """The lanes of one swarm, in the order they begin.

    `moves` name every edge entered at every step, waits included, as those of a swarm's plan do;
    `durations` has their edges. Where exactly one group comes to a state and goes on together, it
    keeps its lane; otherwise all that come end there and each that goes begins.

    >>> made = lanes({"p": 5}, [(0, "p", "p", 2), (0, "p", "q", 3), (1, "p", "q", 2)],
    ...              {("p", "p"): 1, ("p", "q"): 1}, 1)
    >>> [(lane.count, [stop[:3] for stop in lane.stays]) for lane in made]
    [(2, [(0, 1, 'p'), (2, 2, 'q')]), (3, [(0, 0, 'p'), (1, 1, 'q')])]
    """
    leaving: defaultdict[tuple[int, str], list[MoveTuple]] = defaultdict(list)
    for move in moves:
        leaving[move[0], move[1]].append(move)
    made: list[Lane] = []
    here: defaultdict[tuple[int, str], list[Lane]] = defaultdict(list)
    for start, count in starts.items():
        begun = start.origin if isinstance(start, UnderWay) else None
        state, step = (start.target, start.arrives) if isinstance(start, UnderWay) else (start, 0)
        lane = Lane(count, horizon + 1, [Stop(step, step, state)], begun)
        made.append(lane)
        here[step, state].append(lane)
    for (step, state), gone in sorted(leaving.items()):
        came = here[step, state]
        if len(came) == 1 and len(gone) == 1:
            going = came
        else:
            going = [Lane(move[3], horizon + 1, [Stop(step, step, state)]) for move in sorted(gone)]
            made += going
            for lane in came:
                lane.end = step
        for lane, (_, _, target, _) in zip(going, sorted(gone), strict=True):
            arrival = step + durations[state, target]
            lane.arrive(arrival, target)
            here[arrival, target].append(lane)
    return tuple(lane for lane in made if lane.begun or lane.end > lane.stays[0].first)
