"""The plan: where every agent is at every step, and what was proven about it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Self

from pydantic import Field, field_validator, model_validator

from tsplan import display
from tsplan.errors import Finding, InputError, PlanError, nearest
from tsplan.limits import MOST_STEPS, clipped
from tsplan.parameters import known_name, name_list, step_within
from tsplan.plans.agent_entries import READ_AGENTS, agents_json
from tsplan.plans.agent_plans import AgentPlan, state_in
from tsplan.plans.bundles import Agents, AgentsById, Bundle
from tsplan.plans.cargo_rows import READ_CARGO, CargoRows, cargo_json
from tsplan.plans.known_mission import OfMission
from tsplan.plans.moves import Moves, shares
from tsplan.plans.outcomes import (
    FOUND,
    MissionRef,
    ModelSize,
    ObjectiveValue,
    Programs,
    SolverUse,
    Status,
    Timings,
    contradictions,
)
from tsplan.plans.plan_frame import agent_columns, frame
from tsplan.plans.plan_text import PLANS, read_result
from tsplan.plans.policies import Policy, expected_counts
from tsplan.plans.presence import Presence, of_bundles, of_groups, state_counts
from tsplan.plans.records import (
    OPTIONAL,
    Finite,
    Rational,
    Record,
    Whole,
    Word,
    as_json,
    json_document,
    json_lines,
    rational_json,
)
from tsplan.plans.satisfaction import PreferenceSatisfaction, Satisfaction
from tsplan.plans.structures import Rebuilt, Structure, of_structures
from tsplan.plans.subswarms import SubSwarm
from tsplan.plans.supplies import Cargo, ExecutedTask, StockHistory
from tsplan.plans.worlds import World
from tsplan.stopping import StoppedBy
from tsplan.words import known

if TYPE_CHECKING:
    from collections.abc import Iterable

    from tsplan.milp.model import Floats, Ints
    from tsplan.mission import Mission
    from tsplan.plans.moves import Node


@dataclass(frozen=True)
class Plan(Record, OfMission["Mission"], display.Displayed):
    """What planning a mission ended with.

    `agents` is empty unless `status` is optimal or feasible; it and `cargo` make each item when it
    is looked at, and may be given as any sequence. `availability` is the counting robustness of the
    formula at step 0, None where it is infinite. `verified` says that the independent check
    accepted the paths; `proof` says who vouches for it that there is no plan, and what that `rests`
    on, as objectives do. The formula holds, and all that is told of it is told, with every agent up
    to `delay` steps late. `notes` are sentences for the reader of the plan. `satisfaction` and
    `preferences` tell what holds where the mission does not demand it all.

    The plan of a mission with swarms has the `moves` of every swarm, by its name, and `groups`, the
    sub-swarms that they make; the `agents` of swarms are there if they were asked for, or are few.

    Of modular robots the `agents` are the modules, and `structures` what they are part of; it is
    these that count and do. `rebuilt` says which structures become which.

    The plan of a mission with resources has the `executions` of tasks, the `cargo` of every agent
    and the `stocks` that follow from both; where agents are booked it has executions, too.
    Where moves are uncertain there are `policies`, and no agents: numbers are expected ones.
    `variables` has the values of the own variables of a `Problem`, as exact fractions.

    A plan that was `replanned` says what the world was found to be each time. Until the last of
    these steps its paths are what really happened, and its objectives are those of what came after.

    `str` is the summary that the command line prints. A plan that was made here knows its mission,
    which those read from files have to be given: `load_plan(path).with_mission(mission)`.

    Raises PlanError for a status that contradicts `stopped_by` or the presence of paths.
    """

    status: Status
    mission: MissionRef
    horizon: Annotated[int, Field(strict=True, ge=0, le=MOST_STEPS)]
    stopped_by: StoppedBy | None = None
    objective: tuple[ObjectiveValue, ...] = ()
    availability: Finite | None = None
    delay: Whole | None = field(default=None, metadata=OPTIONAL)
    satisfaction: Satisfaction | None = field(default=None, metadata=OPTIONAL)
    preferences: tuple[PreferenceSatisfaction, ...] = field(default=(), metadata=OPTIONAL)
    verified: Annotated[bool, Field(strict=True)] = False
    proof: Word | None = field(default=None, metadata=OPTIONAL)
    rests: tuple[Word, ...] = field(default=(), metadata=OPTIONAL)
    moves: Mapping[Word, Moves] = field(default_factory=dict, hash=False, metadata=OPTIONAL)
    groups: tuple[SubSwarm, ...] = field(default=(), metadata=OPTIONAL)
    agents: Annotated[Sequence[AgentPlan], READ_AGENTS] = field(default=(), metadata=OPTIONAL)
    structures: tuple[Structure, ...] = field(default=(), metadata=OPTIONAL)
    rebuilt: tuple[Rebuilt, ...] = field(default=(), metadata=OPTIONAL)
    executions: tuple[ExecutedTask, ...] = field(default=(), metadata=OPTIONAL)
    cargo: Annotated[Sequence[Cargo], READ_CARGO] = field(default=(), metadata=OPTIONAL)
    stocks: tuple[StockHistory, ...] = field(default=(), metadata=OPTIONAL)
    policies: tuple[Policy, ...] = field(default=(), metadata=OPTIONAL)
    replanned: tuple[World, ...] = field(default=(), metadata=OPTIONAL)
    variables: Mapping[Word, Rational] = field(default_factory=dict, hash=False, metadata=OPTIONAL)
    solver: SolverUse = field(default_factory=SolverUse)
    size: ModelSize = field(default_factory=ModelSize)
    programs: Programs | None = field(default=None, metadata=OPTIONAL)
    timings: Timings = field(default_factory=Timings)
    notes: tuple[str, ...] = field(default=(), metadata=OPTIONAL)

    def __post_init__(self) -> None:
        object.__setattr__(self, "agents", Agents.of(self.agents))
        object.__setattr__(self, "cargo", CargoRows.of(self.cargo))
        there = bool(self.agents or self.moves or self.policies)
        if findings := contradictions(self, "plan", "the agents' paths", there=there):
            raise PlanError(findings)

    @field_validator("groups")
    @classmethod
    def _related(cls, groups: tuple[SubSwarm, ...]) -> tuple[SubSwarm, ...]:
        known = {group.id for group in groups}
        if len(known) < len(groups):
            raise ValueError("two sub-swarms have the same id")
        for group in groups:
            for other in (*group.parents, *group.children):
                if other not in known:
                    raise ValueError(f"sub-swarm {group.id} names {other}, which is not there")
        return groups

    @model_validator(mode="after")
    def _within(self) -> Self:
        """Nothing happens after the horizon; asked of what a file says alone."""
        late = [move.step for moves in self.moves.values() for move in moves]
        late += [choice.step for policy in self.policies for choice in policy.choices]
        if late and max(late) >= self.horizon:
            raise ValueError(f"a move at step {max(late)} of a plan that ends at {self.horizon}")
        if any(group.last > self.horizon for group in self.groups):
            raise ValueError(f"a sub-swarm exists after step {self.horizon}, where the plan ends")
        return self

    @property
    def has_paths(self) -> bool:
        """Whether there is a path for every agent, or the moves of every swarm."""
        return self.status in FOUND

    @cached_property
    def agent(self) -> Mapping[str, AgentPlan]:
        """The agents by their ids."""
        return AgentsById(self._agents)

    @property
    def _agents(self) -> Agents:
        return Agents.of(self.agents)  # as which they are kept

    @property
    def bundles(self) -> tuple[Bundle, ...]:
        """The agents grouped by identical class and path, in order of first appearance."""
        return self._agents.bundles

    @property
    def robots(self) -> tuple[Bundle, ...]:
        """The bundles of agents that no sub-swarm and no structure tells of."""
        told = {group.swarm for group in self.groups} | {
            each.class_name for each in self.structures
        }
        return tuple(bundle for bundle in self.bundles if bundle.class_name not in told)

    def structure_of(self, module: str, step: int) -> Structure | None:
        """The structure that a module is part of at a step; None while it is rebuilt.

        Raises InputError for what is no step of the plan.
        """
        step = step_within(step, self.horizon)
        mine = (each for each in self.structures if module in each.modules)
        return next((each for each in mine if each.first <= step <= each.last), None)

    @cached_property
    def states(self) -> tuple[str, ...]:
        """Every state at which some agent stays, sorted."""
        stays = {stay[2] for bundle in self.bundles for stay in bundle.stays}
        stays.update(state for policy in self.policies for state in policy.expected)
        return tuple(sorted(stays.union(presence.state for presence in self.presences)))

    @cached_property
    def presences(self) -> tuple[Presence, ...]:
        """Who is where: swarms by their sub-swarms where the plan has them, others by paths.

        Raises PlanError for a plan that has the moves of a swarm alone.
        """
        unknown = set(self.moves).difference(group.swarm for group in self.groups)
        if unknown.difference(bundle.class_name for bundle in self.robots):
            what = "the plan names the moves of swarms, but not the sub-swarms they make"
            raise PlanError([Finding(what, "fill them in with certify(mission, plan)")])
        structures = of_structures(self.structures)
        return (*of_bundles(self.robots), *structures, *of_groups(self.groups))

    def state_at(self, step: int) -> dict[str, str | None]:
        """The state of every agent at `step` by its id; None for agents that are travelling.

        Of swarms whose agents have no paths, the state of every sub-swarm that exists at `step`,
        by its id. Raises InputError for what is no step of the plan.
        """
        step = step_within(step, self.horizon)
        told = {bundle.class_name for bundle in self.bundles}
        at = {id(bundle): state_in(bundle.stays, step) for bundle in self.bundles}
        return {
            name: at[id(path)] for names, path in self._agents.stretches for name in names.names()
        } | {group.id: group.state for group in self.groups_at(step) if group.swarm not in told}

    def groups_at(self, step: int) -> tuple[SubSwarm, ...]:
        """The sub-swarms that exist at a step; InputError for what is no step of the plan."""
        step = step_within(step, self.horizon)
        return tuple(group for group in self.groups if group.first <= step <= group.last)

    @cached_property
    def shares(self) -> Mapping[str, Mapping[Node, tuple[tuple[str, Fraction], ...]]]:
        """For every swarm, which part of it leaves a state at a step by which edge.

        `shares[swarm][state, step]` has pairs of a target and a fraction; the fractions sum to 1.
        """
        return {swarm: shares(moves) for swarm, moves in self.moves.items()}

    def counts(
        self, capability: str | None = None, *, states: Iterable[str] | None = None
    ) -> Ints | Floats:
        """Agents with a capability (all agents for None) at each state and step.

        Of policies they are expected numbers.

        The array has one row for each of `states` (by default `Plan.states`) and one column for
        each step 0..horizon. States outside the plan have rows of zeros: a plan does not know its
        map. In the plan of several swarms a capability is the name of one.

        Raises InputError for a capability that nobody in the plan has, and for `states` that are
        no names.

        >>> agent = AgentPlan("a-1", "a", frozenset({"see"}), ((0, 1, "p"), (3, 3, "q")))
        >>> made = Plan(Status.FEASIBLE, MissionRef("", ""), 3, StoppedBy.GAP, agents=(agent,))
        >>> made.counts("see", states=["q"]).tolist()
        [[0, 0, 0, 1]]
        """
        if capability is not None and self.has_paths:  # without paths nobody is known
            able = {name for presence in self.presences for name in presence.capabilities}
            able.update(name for policy in self.policies for name in policy.capabilities)
            swarms = {group.swarm for group in self.groups} | set(self.moves)
            known_name(capability, [able | swarms], "swarm" if able <= swarms else "capability")
        rows = self.states if states is None else name_list(states, "state")
        return self.tallied(rows, capability)

    def tallied(self, states: Sequence[str], capability: str | None) -> Ints | Floats:
        """The same at `states`, whether anybody in the plan has the capability or not."""
        if self.policies:
            return expected_counts(self.policies, states, self.horizon, capability)
        return state_counts(self.presences, states, self.horizon, capability)

    def value(self, name: str, mission: Mission | None = None) -> float | None:
        """The value of an objective in the plan, as `travel`; None where it is infinite.

        Objectives that the mission does not name are measured on the paths, for which the mission
        has to be known or given. Raises InputError for what is no objective of the mission, and
        PlanError for a plan without paths.
        """
        if not self.has_paths:
            raise PlanError([Finding(f"a plan of status {self.status} has no values")])
        told = {"availability": self.availability}
        told |= {item.name: item.value for item in self.objective}
        mission = self.known_mission(mission)
        missing = isinstance(name, str) and name not in told
        if missing and mission is not None:
            told |= display.objective_values(mission, self)
        if missing and mission is None:
            remedy = f"{nearest(name, told)}; others need the mission: plan.value(name, mission)"
            raise InputError([Finding(f"the plan has no value {clipped(name)}", remedy)])
        return known(told[known_name(name, [told], "value of the plan")])

    def to_frame(self) -> Any:
        """A DataFrame of pandas with a row for each agent and step: agent, class, step and state.

        The state is None while the agent is travelling. Raises FrameUnavailableError without
        pandas, and PlanError for a plan without paths of agents (of swarms, see `tsplan.assign`).
        """
        return frame(agent_columns(self._agents, self.horizon))

    def explain(self, mission: Mission | None = None) -> display.WitnessNode:
        """Why the plan satisfies the formula of its mission, as a tree that prints itself.

        Every node says where it holds, by how many agents, and what it rests on there: which step,
        which agents. It comes from the evaluator and the counts alone. Raises InputError where the
        mission is not known and not given, PlanError for a plan without paths or of another one.
        """
        return display.explain(self, self.needed_mission(mission, "explain"))

    def plot(
        self, mission: Mission | None = None, *, view: str = "", ax: Any = None, **look: Any
    ) -> display.Picture:
        """A picture of the plan: its matplotlib figure and axes.

        `view` is one of `paths` (the default with a mission; of policies `policy`), `timeline` (the
        default, and all that there is, without one), `requirements`, `stocks` (of a mission with
        resources), `flow` and `map`; or `page`, which has several below each other. Without `ax`
        there is a figure of its own that pyplot does not know; a page always has one.

        The `look` may have a `step` to look at, which may lie between two steps; `agents`, ids or
        names of classes, whose paths and rows are drawn; a plan of what really happened as
        `executed`, beside which this one is pale; `dark=True`; and a `size` in inches. Raises
        PlotUnavailableError without matplotlib, InputError for an unknown view and one that the
        mission has nothing for, and PlanError for a plan without paths or of another mission.
        """
        return display.draw_plan(self, self.known_mission(mission), view, ax, **look)

    def requirements(self, mission: Mission | None = None) -> tuple[display.Requirement, ...]:
        """What the formula's atoms ask of the counts and what the plan gives, over all steps.

        Raises as `explain`.
        """
        return display.requirements(self, self.needed_mission(mission, "requirements"))

    def view(
        self, mission: Mission | None = None, path: str | Path | None = None, **look: Any
    ) -> Path:
        """Show the plan in the browser: one page that plays it, whose path is returned.

        With a `path` the page is written there and no browser is opened. The `look` may have a
        `step` at which it opens, and a plan of what really happened as `executed`, which is shown
        beside this one. Raises as `explain`, and InputError for a step that is not there.
        """
        place = None if path is None else Path(path)
        return display.show_page(self.needed_mission(mission, "view"), self, place, **look)

    def animate(
        self, path: str | Path | None = None, mission: Mission | None = None, **pace: Any
    ) -> display.Movie:
        """The plan as a moving picture, which a notebook plays.

        With a `path` it is written there, as .gif, .mp4 or .html; `save` of what is returned does
        that, too, where the keywords of the `pace` are explained. Raises as `explain`.
        """
        return display.movie(self.needed_mission(mission, "animate"), self, path, **pace)

    def simulate(
        self, mission: Mission | None = None, *, runs: int = 1000, seed: int = 0
    ) -> display.Simulation:
        """How often the plan's mission holds if every agent follows the shares at random.

        See `tsplan.simulate`; raises PlanError for a plan without moves of swarms, and InputError
        where the mission is not known and not given.
        """
        known_one = self.needed_mission(mission, "simulate")
        return display.simulate(known_one, self, runs=runs, seed=seed)

    def __str__(self) -> str:
        """What `tsplan plan` prints."""
        return display.plan_words(self)

    def _repr_html_(self) -> str:
        """The plan as notebooks show it: what is known, and who is where when."""
        return display.plan_html(self)

    def _caption(self) -> str:
        return f"<Plan of {self.mission.name!r}: {self.status}, {len(self.agents)} agents>"

    def to_json(self, *, each: bool = False) -> str:
        """The plan as a `tsplan-plan/1` document: one key, agent, move and sub-swarm a line.

        More than 1,000 agents are written as bundles of agents on one path, and what they carry
        likewise, unless `each` of them is to have an entry of its own.
        """
        first = {"format": PLANS.mark, "status": self.status, "stopped_by": self.stopped_by}
        moves = (
            f"{as_json(swarm)}: {json_lines(map(as_json, moves))}"
            for swarm, moves in self.moves.items()
        )
        large = {
            "moves": lambda: json_lines(moves, "{}"),
            "groups": lambda: json_lines(map(as_json, self.groups)),
            "structures": lambda: json_lines(map(as_json, self.structures)),
            "rebuilt": lambda: json_lines(map(as_json, self.rebuilt)),
            "executions": lambda: json_lines(map(as_json, self.executions)),
            "cargo": lambda: cargo_json(CargoRows.of(self.cargo), each=each),
            "stocks": lambda: json_lines(map(as_json, self.stocks)),
            "agents": lambda: agents_json(self._agents, each=each),
            "variables": lambda: as_json({k: rational_json(v) for k, v in self.variables.items()}),
            "policies": lambda: json_lines(policy.text() for policy in self.policies),
        }
        return json_document({**first, **self.data()}, large)

    @classmethod
    def from_json(cls, text: str, source: str = "plan") -> Self:
        """Read a `tsplan-plan/1` document; raises PlanError with everything wrong with it."""
        return read_result(cls, PLANS, text, source)
