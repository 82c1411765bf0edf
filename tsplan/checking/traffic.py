"""What a plan does on the map: who is where when, and who enters which edge when.

Everything that the check judges follows from this. It is read from nothing but the map, the team
and the agents' paths or the moves of swarms, and shares no code with what makes plans.
"""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import chain
from typing import TYPE_CHECKING, TypeAlias

from tsplan.checking.class_traffic import ClassTraffic
from tsplan.checking.lateness import Late, late, late_swarm
from tsplan.checking.ledger_reading import read_ledger
from tsplan.checking.path_segments import Segment, read_path, together, unwelcome, usable_edge
from tsplan.checking.satisfaction_check import preferences_of, satisfaction_of
from tsplan.checking.structure_check import Rebuild, read_structures
from tsplan.checking.team_check import told
from tsplan.logic import Formula, capabilities
from tsplan.logic.evaluation import robustness
from tsplan.logic.traces import CountTrace
from tsplan.plans.count_traces import count_trace
from tsplan.plans.moves import Move
from tsplan.plans.presence import Presence, of_bundles, state_counts
from tsplan.plans.subswarms import SubSwarm, subswarms
from tsplan.plans.supplies import ExecutedTask, execution_tables
from tsplan.ts import Edge

if TYPE_CHECKING:
    from tsplan.milp.model import Floats, Ints
    from tsplan.mission import Group, Mission
    from tsplan.plans.bundles import Bundle
    from tsplan.plans.ledger import Ledger
    from tsplan.plans.plan import Plan
    from tsplan.plans.satisfaction import PreferenceSatisfaction, Satisfaction
    from tsplan.ts import TransitionSystem


@dataclass(frozen=True)
class Traffic:
    """What all agents of a mission do in a plan up to its horizon, and what follows from it.

    `promised` is how late a plan says that every agent may be, None where it says nothing;
    `rebuilds` are the reconfigurations of modular robots.
    """

    mission: Mission
    horizon: int
    classes: tuple[ClassTraffic, ...]
    ledger: Ledger
    promised: int | None = None
    rebuilds: tuple[Rebuild, ...] = ()

    @property
    def segments(self) -> Iterator[Segment]:
        """The times of all agents on edges."""
        return (segment for item in self.classes for segment in item.segments)

    @property
    def away(self) -> Iterator[Segment]:
        """The times of all agents on edges that are no waits."""
        return (segment for segment in self.segments if not segment.edge.is_wait)

    @cached_property
    def begun(self) -> tuple[Segment, ...]:
        """The times on edges of agents that start under way, from step 0 on.

        Where the map has lost the edge, it is one that nothing is known of. Who is being rebuilt is
        on none.
        """
        edges, modular = self.mission.system.edges, self.mission.modular
        return tuple(
            Segment(
                edges.get((start.origin, start.target), Edge(start.origin, start.target)),
                0,
                start.arrives,
                count,
            )
            for group in map(modular.structures, self.mission.team)
            for start, count in group.coming
            if start.origin != start.target or group.configuration is None
        )

    @property
    def swarms(self) -> Iterator[ClassTraffic]:
        """What the swarms among the classes do."""
        return (c for c in self.classes if self.mission.group_bounds(c.class_name) is not None)

    @cached_property
    def moves(self) -> Mapping[str, tuple[Move, ...]]:
        """The moves of every swarm."""
        return {swarm.class_name: swarm.moves for swarm in self.swarms}

    @cached_property
    def groups(self) -> tuple[SubSwarm, ...]:
        """The sub-swarms that the moves of every swarm make."""
        mine = {group.class_name: group for group in self.mission.team}
        return tuple(
            group
            for swarm in self.swarms
            for group in subswarms(
                swarm.class_name,
                dict(mine[swarm.class_name].all_starts),
                swarm.moves,
                {segment.edge.pair: segment.left - segment.entered for segment in swarm.segments},
                self.horizon,
            )
        )

    @property
    def present(self) -> Iterator[Presence]:
        """Who is at which state when."""
        return (presence for item in self.classes for presence in item.present)

    def counts(self, states: Sequence[str], capability: str | None = None) -> Ints | Floats:
        """Agents with a capability (all for None) at each of `states` and step."""
        return state_counts(self.present, states, self.horizon, capability)

    @cached_property
    def delay(self) -> int:
        """How many steps late every agent may be, by which all is told.

        As many as the plan says; otherwise as the mission asks for, or at most, if that is what it
        wants.
        """
        if self.promised is not None:
            return self.promised
        delay, mission = self.mission.delay, self.mission
        if "delay" not in mission.objective:
            return delay
        later = range(self.horizon, delay, -1)
        return next((n for n in later if self._slack(mission.counted, n) >= 0), delay)

    @cached_property
    def trace(self) -> CountTrace:
        """Who is at which label when, of every capability that the mission's formulas name."""
        return self._trace(self.delay)

    def _trace(self, delay: int) -> CountTrace:
        """The counts where every agent is up to `delay` steps late."""
        mission = self.mission
        formulas = (mission.formula, *(preference.formula for preference in mission.prefer))
        named = sorted({name for formula in formulas for name in capabilities(formula)})
        states = tuple(mission.system.states)
        if delay:
            return self.late_trace(named, delay)
        counts = {name: self.counts(states, name) for name in (None, *named)}
        uses = (use for use in self.ledger.uses if use.done)
        done = (ExecutedTask(use.task.task, use.state, use.first) for use in uses)
        executed = execution_tables(done, states, self.horizon)
        return count_trace(mission.system, counts, executed)

    def late_trace(self, named: Iterable[str], delay: int) -> CountTrace:
        """Agents with each capability where each is up to `delay` steps late."""
        states = tuple(self.mission.system.states)
        places = [self.late(item, delay) for item in self.classes]
        sure, possible = (
            {
                name: state_counts(chain(*where), states, self.horizon, name)
                for name in (None, *named)
            }
            for where in zip(*places, strict=True)
        )
        return count_trace(self.mission.system, sure, most=possible)

    def late(self, item: ClassTraffic, delay: int) -> Late:
        """Where the agents of a class are for certain and may be; of swarms by their moves."""
        if self.mission.group_bounds(item.class_name) is None:
            return late(item.bundles, delay)
        return late_swarm(item.present, item.segments, delay, self.horizon)

    @cached_property
    def availability(self) -> float:
        """Counting robustness at step 0 of the mission's formula as written."""
        return self.robustness(self.mission.counted)

    def robustness(self, formula: Formula) -> float:
        """Counting robustness at step 0 of a formula."""
        return float(robustness(formula, self.trace)[0])

    def _slack(self, formula: Formula, delay: int) -> float:
        return float(robustness(formula, self._trace(delay))[0])

    @cached_property
    def satisfaction(self) -> Satisfaction | None:
        """How much of the formula holds, where the mission lets it hold in part."""
        return satisfaction_of(self.mission, self.trace) if self.mission.partial else None

    @cached_property
    def preferences(self) -> tuple[PreferenceSatisfaction, ...]:
        """What became of every preferred formula, in the mission's order."""
        return preferences_of(self.mission, self.trace) if self.mission.prefer else ()


_Walk: TypeAlias = "tuple[Bundle, tuple[Segment, ...]]"
"""A path of a bundle of agents, read against the map."""


def read_traffic(mission: Mission, plan: Plan) -> tuple[Traffic | None, list[str]]:
    """What a plan does, and everything that the map does not allow; None where that is anything.

    A swarm whose agents have paths is read by these; where it has moves, too, they must agree.
    """
    walks, problems = _walks(mission, plan)
    if problems:
        return None, problems
    swarms = _swarms(mission)
    problems = [
        f"the plan moves '{name}', and the mission has {'no such swarm' if swarms else 'a team'}"
        for name in plan.moves
        if name not in swarms
    ]
    shaped, rebuilds, wrong = read_structures(mission, plan)
    problems += wrong
    classes = list(shaped)
    robots = (group.class_name for group in mission.team if not group.configuration)
    for name in dict.fromkeys(robots):
        moves = plan.moves.get(name, ())
        if name not in swarms:
            classes.append(_walked(name, walks[name]))
            continue
        if name in walks:
            moves = _moves_of(walks[name])
            problems += _differences(name, moves, plan.moves.get(name, moves))
        elif name not in plan.moves:
            problems.append(f"the plan has no moves of {name}")
            continue
        moved, wrong = _read_moves(mission.system, swarms[name], moves, plan.horizon)
        problems += [f"{name} {words}" for words in wrong]
        if name in walks:
            own = tuple(bundle for bundle, _ in walks[name])
            moved = replace(moved, moving=_moving(walks[name]), bundles=own)
        classes.append(moved)
    ledger, wrong = read_ledger(mission, plan)
    problems += wrong
    if problems:
        return None, problems
    made = Traffic(mission, plan.horizon, tuple(classes), ledger, plan.delay, rebuilds)
    return made, []


def _walks(mission: Mission, plan: Plan) -> tuple[dict[str, list[_Walk]], list[str]]:
    """The paths of the robots by class, and what the map does not allow about them.

    Those of modules are told by the structures that they are part of.
    """
    walks: dict[str, list[_Walk]] = defaultdict(list)
    problems = []
    modular = {group.class_name for group in mission.team if group.configuration}
    for bundle in (b for b in plan.bundles if b.class_name not in modular):
        path = read_path(mission.system, bundle, plan.horizon)
        walks[bundle.class_name].append((bundle, path.segments))
        problems += [
            f"{told(bundle.agents, 'on the same path')} {problem}" for problem in path.problems
        ]
    return walks, problems


def _swarms(mission: Mission) -> dict[str, Group]:
    """The swarms among the classes of a mission."""
    return {
        group.class_name: group
        for group in mission.team
        if mission.group_bounds(group.class_name) is not None
    }


def _walked(class_name: str, walks: Sequence[_Walk]) -> ClassTraffic:
    """What the agents of a class do by their paths."""
    segments = together(segment for _, path in walks for segment in path)
    own = tuple(bundle for bundle, _ in walks)
    present = tuple(of_bundles(own))
    return ClassTraffic(class_name, segments, present, _moving(walks), bundles=own)


def _moving(walks: Iterable[_Walk]) -> int:
    """How many agents ever make a move that is no wait."""
    return sum(
        len(bundle.agents)
        for bundle, segments in walks
        if bundle.coming is not None or any(not segment.edge.is_wait for segment in segments)
    )


def _moves_of(walks: Iterable[_Walk]) -> tuple[Move, ...]:
    """The moves that the paths of one class make together."""
    entered: Counter[tuple[int, str, str]] = Counter()
    for segment in (segment for _, segments in walks for segment in segments):
        each = (segment.left - segment.entered) // segment.times
        for step in range(segment.entered, segment.left, each):
            entered[step, *segment.edge.pair] += segment.agents
    return tuple(sorted(Move(*edge, count) for edge, count in entered.items()))


def _differences(swarm: str, paths: Sequence[Move], moves: Sequence[Move]) -> Iterator[str]:
    """Where the agents' paths and the moves of a swarm do not say the same."""
    walked = {move[:3]: move.count for move in paths}
    named = {move[:3]: move.count for move in moves}
    for entry in sorted({*walked, *named}):
        step, source, target = entry
        if walked.get(entry, 0) != named.get(entry, 0):
            how = f"wait at {source}" if source == target else f"go from {source} to {target}"
            yield (
                f"at step {step}, {named.get(entry, 0)} agents of {swarm} {how} by the moves "
                f"and {walked.get(entry, 0)} by the agents' paths"
            )


def _read_moves(
    system: TransitionSystem, group: Group, moves: Sequence[Move], horizon: int
) -> tuple[ClassTraffic, list[str]]:
    """What a swarm does by its moves, and everything that is impossible about them."""
    problems: list[str] = []
    segments = [item for move in moves if (item := _segment(system, group, move, problems))]
    for (step, source, target), times in Counter(move[:3] for move in moves).items():
        if times > 1:
            problems.append(f"names the move from {source} to {target} at step {step} twice")
    present: Counter[tuple[str, int]] = Counter()
    for state, count in group.starts:
        present[state, 0] += count
    for start, count in group.coming:
        present[start.target, start.arrives] += count
    gone: Counter[tuple[str, int]] = Counter()
    for item in segments:
        gone[item.edge.source, item.entered] += item.agents
        present[item.edge.target, item.left] += item.agents
    if not problems:
        problems += _unconserved(present, gone, horizon)
    late = [move.step for move in moves if not 0 <= move.step < horizon]
    problems += [f"moves at step {step}, and the plan ends at {horizon}" for step in late]
    stays = tuple(
        Presence(state, step, step, count, group.capabilities)
        for (state, step), count in present.items()
        if step <= horizon
    )
    moving = group.count - _waiting(group, segments, horizon)  # also who is under way
    return ClassTraffic(group.class_name, tuple(segments), stays, moving, tuple(moves)), problems


def _segment(
    system: TransitionSystem, group: Group, move: Move, problems: list[str]
) -> Segment | None:
    """A move on the map; what is wrong with it goes to `problems`."""
    step, source, target, count = move
    if count < 1:
        how = f"waits at {source}" if source == target else f"goes from {source} to {target}"
        problems.append(f"{how} at step {step} with {count} agents")
    edge = usable_edge(system, group, (source, target), step, problems)
    duration = None if edge is None else edge.duration_for(group.class_name)
    if edge is None or duration is None:
        return None
    problems += unwelcome(system, group, target, step + duration)
    return Segment(edge, step, step + duration, count)


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


def _waiting(group: Group, segments: Iterable[Segment], horizon: int) -> int:
    """How many agents can have waited at their start all the time: as many as waited at least."""
    waits: dict[str, dict[int, Segment]] = {state: {} for state, _ in group.starts}
    for item in segments:
        if item.edge.is_wait and item.edge.source in waits:
            waits[item.edge.source][item.entered] = item
    total = 0
    for state, count in group.starts:
        staying, step = count, 0
        while staying and step < horizon:
            wait = waits[state].get(step)
            staying, step = (min(staying, wait.agents), wait.left) if wait else (0, horizon)
        total += staying
    return total
