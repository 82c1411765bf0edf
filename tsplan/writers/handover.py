"""A plan and its map, brought together and checked, as every format needs them."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from operator import attrgetter
from typing import TYPE_CHECKING, NamedTuple

from tsplan.checking.assignment import assign
from tsplan.checking.fitting import refuse_pathless
from tsplan.checking.path_segments import Path, read_path
from tsplan.errors import Finding, InputError, PlanError, nearest
from tsplan.exact import exact
from tsplan.plans.agent_plans import AgentPlan, Stay
from tsplan.plans.plan import Plan
from tsplan.ts.state_places import Point, own_place
from tsplan.writers.journeys import Journey

if TYPE_CHECKING:
    from tsplan.mission import Mission
    from tsplan.ts import TransitionSystem

_SEARCHED = 1000  # agents up to which a close name is looked for
_OTHER = "name the map that the mission was planned on"


class _Way(NamedTuple):
    """What agents have in common that share a journey."""

    class_name: str
    capabilities: frozenset[str]
    stays: tuple[Stay, ...]
    heading: str | None
    coming: str | None = None


_parts = attrgetter(*_Way._fields)


@dataclass(frozen=True)
class Handover:
    """A plan that is handed to another program, with the map that it was made on.

    `chosen` are the ids of the agents that are handed over, none meaning all. Made by `handover`,
    which sees to it that every agent has a path and that the map allows it.
    """

    plan: Plan
    system: TransitionSystem
    chosen: frozenset[str]
    ways: Mapping[_Way, Journey]

    def journeys(self) -> Iterator[tuple[str, Journey]]:
        """The ids of the agents with their journeys, in the order of the plan.

        Agents of one class that go the same way have one object for it.
        """
        for agent in _agents(self.plan, self.chosen):
            yield agent.id, self.ways[_way(agent)]

    @cached_property
    def states(self) -> tuple[str, ...]:
        """The states that some agent comes to or is heading for, in the order of the map."""
        used = frozenset[str]().union(*(journey.states for journey in self.ways.values()))
        return tuple(state for state in self.system.states if state in used)

    def place(self, state: str) -> Point | None:
        """The coordinates of a state, if it has any."""
        return self._places[state]

    @cached_property
    def _places(self) -> Mapping[str, Point | None]:
        return {state: own_place(self.system.states[state]) for state in self.states}

    @property
    def timed(self) -> bool:
        """Whether it is known how long a step takes."""
        return self.system.step_seconds is not None

    def seconds(self, step: int | None) -> float | None:
        """The time of a step in seconds from the start on; None where that is not known.

        It has the digits that the map gives the length of a step with, and no others.
        """
        if step is None or self.system.step_seconds is None:
            return None
        return float(step * exact(self.system.step_seconds))


def with_paths(plan: Plan, mission: Mission) -> Plan:
    """The plan with a path for every agent of its swarms, as `tsplan.assign` makes them."""
    return assign(mission, plan) if _without_paths(plan) else plan


def handover(plan: Plan, system: TransitionSystem, agents: Collection[str] = ()) -> Handover:
    """A plan, or the named agents of it, and the map that it was made on.

    Raises
    ------
    PlanError
        The plan has no paths, or some that the map does not allow.
    InputError
        There is no agent of a name.

    """
    refuse_pathless(plan)
    if plan.policies:
        what = "the plan is a policy: where agents go is left to chance, so there are no paths"
        raise PlanError([Finding(what, "see 'tsplan simulate' for what agents then do")])
    if names := _without_paths(plan):
        what = f"the plan has the moves of {', '.join(names)}, and no paths of single agents"
        raise PlanError([Finding(what, "name its mission, by which they are found")])
    chosen = frozenset(agents)
    _refuse_unknown(plan, chosen)
    return Handover(plan, system, chosen, _ways(plan, system, chosen))


def _ways(plan: Plan, system: TransitionSystem, chosen: Collection[str]) -> dict[_Way, Journey]:
    """The journey of every way that somebody goes; PlanError for what the map does not allow."""
    modules = frozenset(name for each in plan.structures for name in each.modules)
    first: dict[_Way, str] = {}
    for agent in _agents(plan, chosen):
        first.setdefault(_way(agent), agent.id)
    ways: dict[_Way, Journey] = {}
    findings: list[Finding] = []
    for bundle in plan.bundles:
        if (name := first.get(way := _way(bundle))) is None:
            continue
        if name in modules or plan.replanned:  # what has happened is a fact
            ways[way] = Journey(way.class_name, way.stays, way.heading)
            problems = _strange(ways[way], system)
        else:
            path = read_path(system, bundle, plan.horizon)
            ways[way], problems = _journey(way, path, plan.horizon), path.problems
        findings += (Finding(f"agent {name} {words}", _OTHER) for words in problems)
    if findings:
        raise PlanError(findings)
    return ways


def _agents(plan: Plan, chosen: Collection[str]) -> Iterator[AgentPlan]:
    return (agent for agent in plan.agents if not chosen or agent.id in chosen)


def _way(of: object) -> _Way:
    """The way of an agent, or of agents that share a path."""
    return _Way._make(_parts(of))


def _without_paths(plan: Plan) -> list[str]:
    """The swarms of which the plan has no agents."""
    if not plan.moves:
        return []
    told = {bundle.class_name for bundle in plan.bundles}
    return [name for name in plan.moves if name not in told]


def _refuse_unknown(plan: Plan, chosen: frozenset[str]) -> None:
    if not chosen:
        return
    unknown = sorted(chosen - {agent.id for agent in plan.agents if agent.id in chosen})
    if unknown:
        few = len(plan.agents) <= _SEARCHED
        names = [agent.id for agent in (plan.agents if few else plan.agents[:1])]
        raise InputError(
            Finding(f"the plan has no agent '{name}'", nearest(name, names)) for name in unknown
        )


def _journey(way: _Way, path: Path, horizon: int) -> Journey:
    """The journey of agents whose path is read on the map, which knows where and when it ends."""
    if path.segments and path.segments[-1].left > horizon:
        last = path.segments[-1]
        return Journey(way.class_name, way.stays, last.edge.target, last.left, way.coming)
    return Journey(way.class_name, way.stays, None if way.stays else way.heading, None, way.coming)


def _strange(journey: Journey, system: TransitionSystem) -> tuple[str, ...]:
    """The states of a module's journey that the map does not have.

    More is not asked: it moves at the pace of its structures, which the map does not know.
    """
    unknown = sorted(journey.states - system.states.keys())
    return tuple(f"is at '{state}', which the map does not have" for state in unknown)
