"""The mission: what the planner is asked to do.

A mission is checked when it is made, however it is made: from a file (`load_mission`), from
Python values (`Mission.of`) or by its constructor.
"""

from __future__ import annotations

from collections.abc import Container, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from hashlib import sha256
from math import ceil
from numbers import Integral
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, TypeAlias, cast

from tsplan import display
from tsplan.errors import Finding, MissionError
from tsplan.milp.solver_choice import SolverChoice
from tsplan.mission.objectives import DEFAULT_OBJECTIVE
from tsplan.words import nfc

if TYPE_CHECKING:
    from pathlib import Path

    from tsplan.document import Document
    from tsplan.logic import Formula
    from tsplan.ts import TransitionSystem

Language: TypeAlias = Literal["catl", "mtl", "stl"]
TaskInterval: TypeAlias = Literal["closed", "half-open"]
Order: TypeAlias = Literal["weighted", "hierarchical", "depth"]

LANGUAGES: tuple[Language, ...] = ("catl", "mtl", "stl")
TASK_INTERVALS: tuple[TaskInterval, ...] = ("closed", "half-open")
ORDERS: tuple[Order, ...] = ("weighted", "hierarchical", "depth")


class Agent(NamedTuple):
    """One robot of the team, before it has a path."""

    id: str
    class_name: str
    capabilities: frozenset[str]
    start: str


@dataclass(frozen=True, slots=True)
class Group:
    """Robots of one class with the same capabilities: how many of them start at which state."""

    class_name: str
    capabilities: frozenset[str]
    starts: tuple[tuple[str, int], ...]

    def __post_init__(self) -> None:
        """Bring names into the form in which they are compared."""
        object.__setattr__(self, "class_name", nfc(self.class_name))
        object.__setattr__(self, "capabilities", frozenset(map(nfc, self.capabilities)))
        starts = tuple((nfc(state), _whole(count)) for state, count in self.starts)
        object.__setattr__(self, "starts", starts)

    @property
    def count(self) -> int:
        """How many robots the group has."""
        return sum(count for _, count in self.starts)

    @classmethod
    def of(
        cls,
        class_name: str,
        starts: Mapping[str, int] | Iterable[tuple[str, int]],
        capabilities: Iterable[str] = (),
    ) -> Group:
        """A group from any mapping or pairs of start states and counts.

        >>> Group.of("scout", {"q1": 3}, ["Vis"]).count
        3
        """
        pairs = starts.items() if isinstance(starts, Mapping) else starts
        return cls(class_name, frozenset(capabilities), tuple(pairs))


@dataclass(frozen=True, slots=True)
class SwarmBounds:
    """How a swarm may divide: at most `most` sub-swarms (None: any number) of `least` or more."""

    most: int | None = None
    least: int = 1


@dataclass(frozen=True)
class SwarmRules:
    """What makes classes of the team swarms, each of which moves as sub-swarms.

    `each` has the bounds of every swarm by its class name; other classes are ordinary robots.
    `together` bounds the sub-swarms of all swarms at one step, and `margin` is the head-room by
    which the counts of a plan are kept away from what the formula needs: a Fraction is one of the
    agents that are counted, a whole number is of agents. `Mission.goal` is tightened by it already.
    """

    each: Mapping[str, SwarmBounds] = field(hash=False)
    together: int | None = None
    margin: Fraction | int = Fraction(0)

    def __post_init__(self) -> None:
        """Bring names into the form in which they are compared."""
        object.__setattr__(self, "each", {nfc(name): item for name, item in self.each.items()})

    def spare(self, agents: int) -> int:
        """The head-room, in agents, of a demand on a swarm of so many `agents`.

        >>> SwarmRules({}, margin=Fraction(1, 20)).spare(130)
        7
        """
        return self.margin if isinstance(self.margin, int) else ceil(self.margin * agents)


@dataclass(frozen=True, slots=True)
class Preference:
    """A formula that is met if possible, and how much that is worth.

    Levels are settled one after the other, the highest first; within a level the summed weights
    of what is met are maximised. A `partial` preference counts by its fraction, any other one as
    a whole or not at all.
    """

    formula: Formula
    text: str
    weight: Fraction = Fraction(1)
    name: str = ""
    level: int = 0
    partial: bool = False


@dataclass(frozen=True)
class Mission:
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
    sub-swarms.
    `digest` is the SHA-256 of the mission's text; reading its formula took `parse_seconds`. A
    mission that was read from a file keeps its document as `origin`, for places in it.

    Raises MissionError with everything that does not fit together.
    """

    name: str
    system: TransitionSystem
    team: tuple[Group, ...]
    language: Language
    text: str
    formula: Formula
    horizon: int
    objective: tuple[str, ...] = DEFAULT_OBJECTIVE
    task_interval: TaskInterval = "closed"
    solver: SolverChoice = field(default_factory=SolverChoice)
    swarm: SwarmRules | None = None
    satisfaction: Order = "weighted"
    prefer: tuple[Preference, ...] = ()
    digest: str = ""
    warnings: tuple[Finding, ...] = ()
    parse_seconds: float = field(default=0.0, compare=False, repr=False)
    origin: Document | None = field(default=None, compare=False, repr=False)

    def __post_init__(self) -> None:
        from tsplan.mission.mission_checks import problems_of  # noqa: PLC0415  (imports this module)
        from tsplan.mission.named_parts import (  # noqa: PLC0415  (imports this module)
            with_named_classes,
            with_named_states,
        )

        team = with_named_classes(self.team, self.system, self._formulas)
        object.__setattr__(self, "team", team)
        object.__setattr__(self, "system", with_named_states(self.system, self._formulas))
        if self.prefer and "preferences" not in self.objective:
            object.__setattr__(self, "objective", ("preferences", *self.objective))
        errors = [problem for problem in problems_of(self) if problem.serious]
        if errors:
            raise MissionError(problem.finding() for problem in errors)

    @property
    def _formulas(self) -> tuple[Formula, ...]:
        """The formula and those that are preferred."""
        return self.formula, *(wish.formula for wish in self.prefer)

    @cached_property
    def counted(self) -> Formula:
        """The formula as written, over numbers of agents: tasks translated, percentages resolved.

        A percentage is one of all agents that its atom counts.
        """
        from tsplan import logic  # noqa: PLC0415  (the parser is slow to import)

        plain = logic.translate(self.formula, interval=self.task_interval)
        return plain if self.swarm is None else logic.resolve_percent(plain, self.having)

    def tree(self, formula: Formula) -> Formula:
        """The tree of a formula of the mission whose fraction counts, percentages resolved."""
        from tsplan import logic  # noqa: PLC0415  (the parser is slow to import)
        from tsplan.logic.fraction import tree_of  # noqa: PLC0415

        plain = formula if self.swarm is None else logic.resolve_percent(formula, self.having)
        return tree_of(plain, self.task_interval)

    @cached_property
    def goal(self) -> Formula:
        """The formula that is encoded: over counts, in positive normal form, with its margin."""
        from tsplan import logic  # noqa: PLC0415  (the parser is slow to import)

        formula = logic.positive(self.counted)
        if self.swarm is not None and self.swarm.margin:
            formula = logic.tighten(formula, self.having, self.swarm.spare)
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
        made: dict[str, int] = {}
        agents: list[Agent] = []
        for group in (group for group in self.team if group.class_name in classes):
            number = made.get(group.class_name, 0)
            for state, count in group.starts:
                agents += (
                    Agent(f"{group.class_name}-{n}", group.class_name, group.capabilities, state)
                    for n in range(number + 1, number + count + 1)
                )
                number += count
            made[group.class_name] = number
        return tuple(agents)

    @property
    def size(self) -> int:
        """How many robots the team has."""
        return sum(group.count for group in self.team)

    @cached_property
    def capabilities(self) -> frozenset[str]:
        """Every capability that some robot has."""
        return frozenset().union(*(group.capabilities for group in self.team))

    def having(self, capability: str | None) -> int:
        """How many robots have a capability; all of them for None."""
        return sum(
            group.count
            for group in self.team
            if capability is None or capability in group.capabilities
        )

    def group_bounds(self, class_name: str) -> SwarmBounds | None:
        """How a class may divide into sub-swarms; None for ordinary robots."""
        return None if self.swarm is None else self.swarm.each.get(class_name)

    def plot(self, ax: Any = None) -> display.Picture:
        """The map with the team's starts: the matplotlib figure and its axes.

        Raises PlotUnavailableError without matplotlib.
        """
        return display.draw_mission(self, ax)

    @classmethod
    def of(
        cls,
        *,
        map: TransitionSystem | str | Path,  # noqa: A002  (the word of the mission file)
        team: Iterable[Group | Mapping[str, Any]] | None = None,
        swarm: Mapping[str, Any] | None = None,
        swarms: Iterable[Mapping[str, Any]] | None = None,
        max_subswarms: int | None = None,
        margin: str | int | None = None,
        formula: str | bool | Formula | Sequence[str | bool] | None = None,
        must: str | bool | Formula | Sequence[str | bool] | None = None,
        prefer: Iterable[Preference | Mapping[str, Any]] = (),
        language: Language | None = None,
        objective: Sequence[str | Mapping[str, str]] | None = None,
        task_interval: TaskInterval = "closed",
        horizon: int | None = None,
        solver: SolverChoice | Mapping[str, Any] | None = None,
        name: str = "",
    ) -> Mission:
        """A mission from Python values, with the same checks as a file.

        `map` is a transition system or the path of a map file. Each member of `team` is a Group
        or a mapping with the keys of a mission file; instead of a team or beside it there may be
        one `swarm` or several `swarms`, mappings with those keys, and for them `max_subswarms`
        and `margin`.
        `formula` is a text, several texts (their conjunction) or a parsed formula; `must` is
        another word for it beside what to `prefer`. Without a `language`, that of teams is "catl"
        and that of swarms "mtl". Raises MissionError with all findings.
        """
        from tsplan.mission.values import mission_from_values  # noqa: PLC0415  (imports this)

        given = {"formula": formula, "must": must}
        spec: dict[str, Any] = {key: value for key, value in given.items() if value is not None}
        wishes = list(prefer)
        values = {
            "name": name,
            "map": map,
            "team": None if team is None else list(team),
            "swarm": swarm,
            "swarms": None if swarms is None else list(swarms),
            "max_subswarms": max_subswarms,
            "margin": margin,
            "spec": {
                "language": language or default_language(team=bool(team)),
                **spec,
                **({"prefer": wishes} if wishes else {}),
            },
            "objective": None if objective is None else list(objective),
            "task_interval": task_interval,
            "horizon": horizon,
            "solver": solver,
        }
        return mission_from_values(cast("Mapping[str, Any]", values))


def _whole(value: Any) -> Any:
    """A whole number of any kind as Python's own; what is none is left to the checks."""
    return int(value) if isinstance(value, Integral) and not isinstance(value, bool) else value


def default_language(*, team: bool) -> Language:
    """The language of a formula where none is named: of a team, or else of swarms."""
    return "catl" if team else "mtl"


def digest_of(text: str) -> str:
    """The SHA-256 of a mission's text, in hexadecimal."""
    return sha256(text.encode()).hexdigest()
