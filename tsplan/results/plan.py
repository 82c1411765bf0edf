"""The plan: where every agent is at every step, and what was proven about it.

A plan's outcome is two facts: what is known (`Status`) and what stopped the search
(`StoppedBy`). Pairs that contradict each other cannot be constructed.
"""

from __future__ import annotations

from bisect import bisect_right
from dataclasses import dataclass, field, fields, replace
from enum import StrEnum
from functools import cached_property
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, TypeAlias

from tsplan.errors import Finding, PlanError

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

    from tsplan.milp.model import Ints
    from tsplan.results.satisfaction import Fulfilment, Satisfaction

Stay: TypeAlias = tuple[int, int, str]
"""`(from, to, state)`: at that state at every step from..to, both included."""


class Status(StrEnum):
    """What is known when planning ends."""

    OPTIMAL = "optimal"
    FEASIBLE = "feasible"
    INFEASIBLE = "infeasible"
    NO_PLAN_FOUND = "no_plan_found"
    ERROR = "error"


class StoppedBy(StrEnum):
    """What ended a search before its question was settled."""

    TIME_LIMIT = "time_limit"
    GAP = "gap"
    INTERRUPT = "interrupt"
    MEMORY = "memory"


_LIMITS = frozenset({StoppedBy.TIME_LIMIT, StoppedBy.INTERRUPT, StoppedBy.MEMORY})
_POSSIBLE: Mapping[Status, frozenset[StoppedBy | None]] = {
    Status.OPTIMAL: frozenset({None}),
    Status.FEASIBLE: frozenset({*_LIMITS, StoppedBy.GAP}),
    Status.INFEASIBLE: frozenset({None}),
    Status.NO_PLAN_FOUND: _LIMITS,
    Status.ERROR: frozenset({None, *_LIMITS}),
}
_WITH_PATHS = frozenset({Status.OPTIMAL, Status.FEASIBLE})


@dataclass(frozen=True, slots=True)
class AgentPlan:
    """The path of one agent.

    Between two stays the agent is on the one edge from the first state to the second, and at no
    state. `heading` is the state it is travelling to when its last stay ends before the horizon.
    """

    id: str
    class_name: str
    capabilities: frozenset[str]
    stays: tuple[Stay, ...]
    heading: str | None = None

    def state_at(self, step: int) -> str | None:
        """The agent's state at `step`; None while it is travelling.

        >>> agent = AgentPlan("a-1", "a", frozenset(), ((0, 2, "p"), (4, 5, "q")))
        >>> [agent.state_at(step) for step in (2, 3, 4)]
        ['p', None, 'q']
        """
        place = bisect_right(self.stays, step, key=lambda stay: stay[0]) - 1
        if place < 0:
            return None
        _, last, state = self.stays[place]
        return state if step <= last else None


@dataclass(frozen=True, slots=True)
class ObjectiveValue:
    """Value of one objective in the plan, and the proven bound on what any plan can reach."""

    name: str
    value: float | None
    bound: float | None = None


@dataclass(frozen=True, slots=True)
class MissionRef:
    """Which mission a plan belongs to: its name and the SHA-256 of its text."""

    name: str
    sha256: str


@dataclass(frozen=True, slots=True)
class SolverUse:
    """The solver that found the plan, its version and the options it ran with."""

    name: str
    version: str = ""
    options: Mapping[str, Any] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class ModelSize:
    """Size of the model that was solved, and of the map it was built on."""

    columns: int = 0
    integers: int = 0
    rows: int = 0
    nonzeros: int = 0
    states: int = 0
    edges: int = 0


@dataclass(frozen=True, slots=True)
class Timings:
    """Seconds spent in each stage, to the microsecond."""

    load: float = 0.0
    parse: float = 0.0
    reduce: float = 0.0
    build: float = 0.0
    solve: float = 0.0
    extract: float = 0.0
    verify: float = 0.0
    total: float = 0.0

    def __post_init__(self) -> None:
        for item in fields(self):
            object.__setattr__(self, item.name, round(getattr(self, item.name), 6))


@dataclass(frozen=True, slots=True)
class Bundle:
    """Agents of one class that share one path; `agents` are their places in `Plan.agents`."""

    class_name: str
    capabilities: frozenset[str]
    stays: tuple[Stay, ...]
    heading: str | None
    agents: tuple[int, ...]


@dataclass(frozen=True)
class Plan:
    """What planning a mission ended with.

    `agents` is empty unless `status` is optimal or feasible. `availability` is the counting
    robustness of the formula at step 0, None where it is infinite. `verified` says that the
    independent check accepted the paths. `notes` are sentences for the reader of the plan.
    `satisfaction` and `preferences` tell what holds where the mission does not demand it all.

    Raises PlanError for a status that contradicts `stopped_by` or the presence of agents.
    """

    status: Status
    mission: MissionRef
    horizon: int
    stopped_by: StoppedBy | None = None
    objective: tuple[ObjectiveValue, ...] = ()
    availability: float | None = None
    verified: bool = False
    agents: tuple[AgentPlan, ...] = ()
    solver: SolverUse = field(default_factory=lambda: SolverUse(""))
    size: ModelSize = field(default_factory=ModelSize)
    timings: Timings = field(default_factory=Timings)
    notes: tuple[str, ...] = ()
    satisfaction: Satisfaction | None = None
    preferences: tuple[Fulfilment, ...] = ()

    def __post_init__(self) -> None:
        object.__setattr__(self, "status", Status(self.status))
        if self.stopped_by is not None:
            object.__setattr__(self, "stopped_by", StoppedBy(self.stopped_by))
        findings = contradictions(self.status, self.stopped_by, agents=bool(self.agents))
        if self.verified and not self.has_paths:
            findings.append(Finding(f"a plan of status {self.status} cannot be verified"))
        if findings:
            raise PlanError(findings)

    @property
    def has_paths(self) -> bool:
        """Whether there is a path for every agent."""
        return self.status in _WITH_PATHS

    @cached_property
    def agent(self) -> Mapping[str, AgentPlan]:
        """The agents by their ids."""
        return MappingProxyType({agent.id: agent for agent in self.agents})

    @cached_property
    def bundles(self) -> tuple[Bundle, ...]:
        """The agents grouped by identical class and path, in order of first appearance."""
        return bundles(self.agents)

    @cached_property
    def states(self) -> tuple[str, ...]:
        """Every state at which some agent stays, sorted."""
        return tuple(sorted({stay[2] for bundle in self.bundles for stay in bundle.stays}))

    def state_at(self, step: int) -> dict[str, str | None]:
        """The state of every agent at `step` by its id; None for agents that are travelling."""
        return {agent.id: agent.state_at(step) for agent in self.agents}

    def counts(self, capability: str | None = None, *, states: Iterable[str] | None = None) -> Ints:
        """Agents with a capability (all agents for None) at each state and step.

        The array has one row for each of `states` (by default `Plan.states`) and one column for
        each step 0..horizon. States outside the plan have rows of zeros.
        """
        from tsplan.results.occupancy import state_counts  # noqa: PLC0415  (numpy takes 0.1 s)

        rows = self.states if states is None else tuple(states)
        return state_counts(self.bundles, rows, self.horizon, capability)

    def to_json(self) -> str:
        """The plan as a `tsplan-plan/1` document, one agent a line."""
        from tsplan.results.planfile import plan_to_json  # noqa: PLC0415  (imports this module)

        return plan_to_json(self)

    @classmethod
    def from_json(cls, text: str, source: str = "plan") -> Plan:
        """Read a `tsplan-plan/1` document; raises PlanError with everything wrong with it."""
        from tsplan.results.planfile import plan_from_json  # noqa: PLC0415  (imports this module)

        return plan_from_json(text, source)


def contradictions(status: Status, stopped_by: StoppedBy | None, *, agents: bool) -> list[Finding]:
    """What is impossible about a status together with its reason and the presence of agents."""
    findings = []
    possible = _POSSIBLE[status]
    if stopped_by not in possible:
        words = ", ".join(sorted(str(item) if item else "null" for item in possible))
        given = stopped_by or "null"
        findings.append(
            Finding(f"status {status} contradicts stopped_by {given}", f"possible: {words}")
        )
    if agents != (status in _WITH_PATHS):
        shape = "needs the agents' paths" if status in _WITH_PATHS else "cannot hold agents' paths"
        findings.append(Finding(f"a plan of status {status} {shape}"))
    return findings


def bundles(agents: Iterable[AgentPlan]) -> tuple[Bundle, ...]:
    """Group agents by class, capabilities and path, in order of first appearance.

    Large teams share path objects, so paths are first told apart by identity, which is cheap,
    and only the distinct objects are compared by value.
    """
    shared: dict[tuple[str, frozenset[str], int, str | None], list[int]] = {}
    samples: list[AgentPlan] = []
    for place, agent in enumerate(agents):
        key = (agent.class_name, agent.capabilities, id(agent.stays), agent.heading)
        members = shared.get(key)
        if members is None:
            shared[key] = [place]
            samples.append(agent)
        else:
            members.append(place)
    equal: dict[Bundle, list[int]] = {}
    for agent, members in zip(samples, shared.values(), strict=True):
        path = Bundle(agent.class_name, agent.capabilities, agent.stays, agent.heading, ())
        equal.setdefault(path, []).extend(members)
    return tuple(replace(path, agents=tuple(sorted(members))) for path, members in equal.items())
