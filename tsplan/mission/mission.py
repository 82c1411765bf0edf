"""The mission: what the planner is asked to do.

A mission is checked when it is made, however it is made: from a file (`load_mission`), from
Python values (`Mission.of`) or by its constructor.
"""

from __future__ import annotations

from collections.abc import Container, Iterable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from hashlib import sha256
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

from tsplan import display, logic
from tsplan.errors import MissionError
from tsplan.logic import Formula
from tsplan.logic.fraction import tree_of
from tsplan.logic.weight_values import Weight
from tsplan.milp.solver_choice import SolverChoice
from tsplan.mission.configurations import Configuration, Reconfiguration
from tsplan.mission.costs import cost_unit
from tsplan.mission.mission_checks import mission_faults
from tsplan.mission.mission_parts import MissionParts, Preference
from tsplan.mission.mission_writer import mission_to_yaml, save_mission
from tsplan.mission.name_resolution import (
    with_named_classes,
    with_named_configurations,
    with_named_states,
)
from tsplan.mission.resources import Resource
from tsplan.mission.team import Agent, Rank, with_brought
from tsplan.mission.team_values import TeamValues, team_members
from tsplan.mission.values import parts_from_values
from tsplan.mission.vocabulary import (
    Booking,
    Dynamics,
    Language,
    PolicyKind,
    TaskInterval,
    default_language,
)
from tsplan.name_runs import Run, RunMap
from tsplan.ts import TransitionSystem
from tsplan.words import nfc

if TYPE_CHECKING:
    import networkx as nx


@dataclass(frozen=True)
class Mission(MissionParts):
    """A map, a team, a formula and what to optimise.

    `text` is the formula as it was written and `formula` what it parses to; `goal` is what is
    encoded. `horizon` is the last step, at least the formula's own. `objective` is
    lexicographic, the first name matters most; without any, every plan is as good as another.
    With the objective `satisfaction` the formula need not hold: as much of it as possible does, in
    the order `satisfaction`. `prefer` holds formulas that are met as far as possible beside it;
    then `preferences` comes first among the objectives.
    A state that a formula names where no state has such a label gets its name as a label of the
    mission's own map, so that everything made from the mission counts there alike.
    A name of a class that is nobody's capability is one of its own robots, if a formula or the
    map asks for it. The `swarm` rules say which classes are swarms, whose agents move as
    sub-swarms. `resources` are what tasks may need beside robots, and `modular` says what the
    modules of modular robots can become. The formula holds even where every agent is up to `delay`
    steps late at any time. `intended` are the paths that robots were to take before the mission was
    planned again, which the objectives `stability` and `deviation` ask for. `booking` says whether
    an agent counts for all tasks at its state, for those of one label, or for one alone. On a map
    of actions with uncertain outcomes numbers are `expected` ones.
    `digest` is the SHA-256 of the mission's text; reading its formula took `parse_seconds`. A
    mission that was read from a file keeps its document as `origin`, for places in it.

    Raises MissionError with everything that does not fit together.
    """

    def __post_init__(self) -> None:
        """Bring everything into one form, and refuse what does not fit together."""
        formulas = (self.formula, *(soft.formula for soft in self.prefer))
        team = with_named_classes(self.team, self.swarm, self.system, formulas)
        robots = [group for group in team if self.group_bounds(group.class_name) is None]
        swarms = [group for group in team if self.group_bounds(group.class_name) is not None]
        object.__setattr__(self, "name", nfc(self.name))
        object.__setattr__(self, "text", nfc(self.text or str(self.formula)))
        object.__setattr__(self, "team", (*robots, *swarms))
        resources = with_brought(self.resources, self.team, self.modular.sizes)
        object.__setattr__(self, "resources", resources)
        object.__setattr__(self, "system", with_named_states(self.system, formulas))
        modular = with_named_configurations(self.modular, team, self.system, formulas)
        object.__setattr__(self, "modular", modular)
        if self.prefer and "preferences" not in self.objective:
            object.__setattr__(self, "objective", ("preferences", *self.objective))
        errors = [fault.finding() for fault in mission_faults(self) if fault.serious]
        if errors:
            raise MissionError(errors)

    @cached_property
    def counted(self) -> Formula:
        """The formula as written, over numbers of agents: tasks translated, percentages resolved.

        A percentage is one of all agents that its atom counts.
        """
        return self.counting(self.formula)

    def counting(self, formula: Formula) -> Formula:
        """A formula of the mission over numbers of agents, as `counted` is its own."""
        return self._resolved(self.translated(formula))

    def translated(self, formula: Formula) -> Formula:
        """A formula of the mission without tasks, which are executed where agents are booked."""
        consumed = {item.name for item in self.resources if item.consumed}
        interval = self.task_interval
        return logic.translate(formula, interval, executed=self.books, consumed=consumed)

    def _resolved(self, formula: Formula) -> Formula:
        """A formula without percentages, which only missions with swarms have."""
        return formula if self.swarm is None else logic.resolve_percent(formula, self.having)

    def tree(self, formula: Formula) -> Formula:
        """The tree of a formula of the mission whose fraction counts, percentages resolved."""
        return tree_of(self._resolved(formula), self.task_interval)

    @cached_property
    def goal(self) -> Formula:
        """The formula that is encoded: over counts, in positive normal form, with its margin."""
        formula = logic.positive(self.counted)
        if self.headroom is not None:
            formula = logic.tighten(formula, self.having, self.headroom.spare)
        return logic.simplify(formula)

    @property
    def partial(self) -> bool:
        """Whether the formula may hold in part only."""
        return "satisfaction" in self.objective

    @cached_property
    def agents(self) -> tuple[Agent, ...]:
        """Every robot, numbered within its class in the order of the team: `scout-1`, ..."""
        return self.members({group.class_name for group in self.team})

    def members(self, classes: Container[str]) -> tuple[Agent, ...]:
        """The robots of some classes, as `agents` has them."""
        ranks = (rank for rank in self.ranks if rank.class_name in classes)
        return tuple(agent for rank in ranks for agent in rank.agents)

    @property
    def begun_until(self) -> int:
        """Last step at which robots arrive that start under way, or are rebuilt; else 0.

        Waits that have begun do not count.
        """
        return max(
            (
                way.arrives
                for group in self.team
                for way, _ in group.coming
                if way.origin != way.target or group.configuration
            ),
            default=0,
        )

    @cached_property
    def ranks(self) -> tuple[Rank, ...]:
        """The robots in the order of `agents`, those of a group that start at one state as one."""
        made: dict[str, int] = {}
        ranks: list[Rank] = []
        for place, group in enumerate(self.team):
            for start, count in group.all_starts:
                before = made.get(group.class_name, 0)
                made[group.class_name] = before + count
                names = Run(f"{group.class_name}-", before + 1, before + count)
                if count:
                    ranks.append(Rank(names, group.class_name, group.capabilities, start, place))
        return tuple(ranks)

    @property
    def size(self) -> int:
        """How many robots the team has."""
        return sum(group.count for group in self.team)

    @property
    def pieces(self) -> int:
        """What a plan is made of one by one: modules; other robots are planned many at a time."""
        return sum(group.count for group in self.team if group.configuration is not None)

    @cached_property
    def roster(self) -> RunMap[Rank]:
        """The rank of every robot by its id."""
        return RunMap((rank.names, rank) for rank in self.ranks)

    @cached_property
    def cost_unit(self) -> Fraction:
        """The largest number of which all that a plan may pay for is a whole multiple."""
        return cost_unit(self.system, self.team, self.modular)

    @cached_property
    def capabilities(self) -> frozenset[str]:
        """Every capability that some robot has."""
        able = self.modular.possible(self.team)
        return frozenset().union(*(group.capabilities for group in able))

    def having(
        self, capability: str | None, *, lost: Mapping[int, int] = MappingProxyType({})
    ) -> int:
        """How many robots have a capability; all of them for None.

        Modules have what they can do as structures: as many of these count as there can be at once.
        `lost` says how many are, by the place of their group in the team.
        """
        able = (
            group.count - lost.get(number, 0)
            for number, group in enumerate(self.team)
            if group.configuration is None
            and (capability is None or capability in group.capabilities)
        )
        return sum(able) + self.modular.most(self.team, capability, lost=lost)

    def plot(self, ax: Any = None) -> display.Picture:
        """The map with the team's starts: the matplotlib figure and its axes.

        Raises PlotUnavailableError without matplotlib.
        """
        return display.draw_mission(self, ax)

    @classmethod
    def of(
        cls,
        *,
        map: TransitionSystem | nx.Graph[Any] | Mapping[str, Any] | str | Path,  # noqa: A002  (the word of files)
        team: TeamValues | None = None,
        resources: Iterable[Resource | Mapping[str, Any]] = (),
        configurations: Mapping[str, Configuration | Mapping[str, Any]] | None = None,
        reconfigure: Iterable[Reconfiguration | Mapping[str, Any]] = (),
        performance: Mapping[str, Mapping[str, float]] | None = None,
        swarm: Mapping[str, Any] | None = None,
        swarms: Iterable[Mapping[str, Any]] | None = None,
        max_subswarms: int | None = None,
        margin: str | int | None = None,
        delay: int | None = None,
        booking: Booking | None = None,
        formula: str | bool | Formula | Sequence[str | bool] | None = None,
        must: str | bool | Formula | Sequence[str | bool] | None = None,
        prefer: Iterable[Preference | Mapping[str, Any]] = (),
        language: Language | None = None,
        weights: Mapping[str, Weight] | None = None,
        objective: Sequence[str | Mapping[str, str]] | None = None,
        task_interval: TaskInterval = "closed",
        horizon: int | None = None,
        dynamics: Dynamics | None = None,
        policy: PolicyKind | None = None,
        solver: SolverChoice | Mapping[str, Any] | None = None,
        name: str = "",
    ) -> Mission:
        """A mission from Python values, with the same checks as a file.

        `map` is a transition system, a networkx graph (see `tsplan.ts.builders.map_of_graph`), the
        path of a map file, or a mapping as a mission file has it, such as `{"file": "nav.geojson",
        "speed": 0.5}`. Each member of `team` is a Group, the arguments of `Group.of` in a tuple, or
        a mapping with the keys of a mission file; a mapping has them by their classes, of which
        each may be the starts alone. Instead of a team or beside it there may be
        one `swarm` or several `swarms`, mappings with those keys, and for them `max_subswarms`
        and `margin`. Each of the `resources` is a Resource or a mapping, and so are the
        `configurations` of modular robots by their names, the ways to `reconfigure` them, and their
        `performance` by labels. `dynamics` and `policy` are for maps of uncertain actions.
        `formula` is a text, several texts (their conjunction) or a parsed formula; `must` is
        another word for it beside what to `prefer`. Without a `language`, that of teams is "catl"
        and that of swarms "mtl". In "wmtl" formulas name `weights`, which may be functions (see
        `tsplan.logic.parse`). Raises MissionError with all findings.
        """
        members = None if team is None else team_members(team)
        spec = {
            "language": language or default_language(team=bool(members)),
            "formula": formula,
            "must": must,
            "prefer": list(prefer) or None,
            "weights": weights,
        }
        values = {
            "name": name,
            "map": map,
            "resources": list(resources) or None,
            "configurations": configurations,
            "reconfigure": list(reconfigure) or None,
            "performance": performance,
            "team": members,
            "swarm": swarm,
            "swarms": None if swarms is None else list(swarms),
            "max_subswarms": max_subswarms,
            "margin": margin,
            "delay": delay,
            "booking": booking,
            "spec": {key: value for key, value in spec.items() if value is not None},
            "objective": None if objective is None else list(objective),
            "task_interval": task_interval,
            "horizon": horizon,
            "dynamics": dynamics,
            "policy": policy,
            "solver": solver,
        }
        return cls(**vars(parts_from_values(values)))

    def to_yaml(self) -> str:
        """The mission as a mission file with its map inside, which is read as the same mission.

        Raises MissionError for a number that no file can say exactly.
        """
        return mission_to_yaml(self)

    def save(self, path: str | Path, *, map_file: str | None = None) -> None:
        """Write a mission file, at once or not at all; its map inside, or to a file beside it.

        Raises MissionError for a number that no file can say exactly, or where the place cannot be
        written (of the map, MapError).
        """
        save_mission(self, Path(path), map_file)


def digest_of(text: str) -> str:
    """The SHA-256 of a mission's text, in hexadecimal."""
    return sha256(text.encode()).hexdigest()
