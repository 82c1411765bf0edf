"""A plan and its map, brought together and checked, as every format needs them."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, NamedTuple

from tsplan.checking.assignment import assign
from tsplan.checking.fitting import refuse_pathless
from tsplan.checking.path_segments import read_path
from tsplan.errors import Finding, InputError, PlanError, nearest
from tsplan.exact import exact
from tsplan.plans.agent_plans import AgentPlan, Bundle, Stay
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
    modules = frozenset(name for each in plan.structures for name in each.modules)
    ways: dict[_Way, Journey] = {}
    findings: list[Finding] = []
    for agent in _agents(plan, chosen):
        if (way := _way(agent)) not in ways:
            problems, ways[way] = _read(plan, system, way, module=agent.id in modules)
            findings += (Finding(f"agent {agent.id} {words}", _OTHER) for words in problems)
    if findings:
        raise PlanError(findings)
    return Handover(plan, system, chosen, ways)


def _agents(plan: Plan, chosen: Collection[str]) -> Iterator[AgentPlan]:
    return (agent for agent in plan.agents if not chosen or agent.id in chosen)


def _way(agent: AgentPlan) -> _Way:
    return _Way(agent.class_name, agent.capabilities, agent.stays, agent.heading)


def _without_paths(plan: Plan) -> list[str]:
    """The swarms of which the plan has no agents."""
    if not plan.moves:
        return []
    told = {agent.class_name for agent in plan.agents}
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


def _read(
    plan: Plan, system: TransitionSystem, way: _Way, *, module: bool
) -> tuple[tuple[str, ...], Journey]:
    """What the map does not allow about a way, and its journey.

    A module moves at the pace of the structures that it is part of, which the map does not know.
    """
    journey = Journey(way.class_name, way.stays, way.heading)
    if module:
        unknown = sorted(journey.states - system.states.keys())
        return tuple(f"is at '{state}', which the map does not have" for state in unknown), journey
    path = read_path(system, Bundle(*way, agents=(0,)), plan.horizon)
    if path.segments and path.segments[-1].left > plan.horizon:
        last = path.segments[-1]
        journey = Journey(way.class_name, way.stays, last.edge.target, last.left)
    return path.problems, journey
