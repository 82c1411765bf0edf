"""A mission as an optimisation problem that can be looked at, extended and solved."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from typing import Any, Literal, TypeAlias

from tsplan.encode.build import Encoded, Setting, prepare, reference, tight
from tsplan.encode.clock import Clock
from tsplan.encode.constraints import Constraint, CountTerm, Expression
from tsplan.encode.effort import Effort
from tsplan.encode.ideas import ALL_IDEAS, Idea
from tsplan.encode.partial.planning import is_soft, plan_soft, prepare_soft
from tsplan.encode.readout import Measure
from tsplan.encode.stages import Outcome, Point, Stages
from tsplan.errors import Finding, MissionError, nearest
from tsplan.milp.model import Model
from tsplan.milp.solver import solver as solver_named
from tsplan.mission import Mission

Encoding: TypeAlias = Literal["tight", "reference"]


@dataclass(frozen=True)
class Tuning:
    """How a problem is to be encoded: by which encoding, and without which of its ideas."""

    encoding: Encoding = "tight"
    without: frozenset[Idea] = frozenset()

    @classmethod
    def named(cls, encoding: str, without: Iterable[str] = ()) -> Tuning:
        """Tuning from plain words; MissionError names those that do not exist."""
        known = [idea.value for idea in Idea]
        findings = [
            Finding(f"there is no idea '{name}' to switch off", nearest(name, known))
            for name in without
            if name not in known
        ]
        if encoding not in ("tight", "reference"):
            remedy = nearest(encoding, ["tight", "reference"])
            findings.append(Finding(f"there is no encoding '{encoding}'", remedy))
        if findings:
            raise MissionError(findings)
        return cls(
            "tight" if encoding == "tight" else "reference",
            frozenset(Idea(name) for name in without),
        )


class Problem:
    """The mission of a team with a user's own constraints and objective terms.

    Raises MissionError for the mission of a swarm.

    >>> problem = Problem(mission)                                      # doctest: +SKIP
    >>> problem.add(problem.count("dock", step=5) >= 2)                 # doctest: +SKIP
    >>> plan = tsplan.plan(problem, time_limit=10)                      # doctest: +SKIP
    """

    def __init__(self, mission: Mission, tuning: Tuning = Tuning()) -> None:
        if mission.swarm is not None:
            what = "a swarm mission is not the problem of a team"
            raise MissionError([Finding(what, "plan the mission itself")])
        self.mission = mission
        self.tuning = tuning
        self._constraints: list[Constraint] = []
        self._objective = Expression()
        self._setting: Setting | None = None

    def count(self, place: str, capability: str | None = None, *, step: int) -> Expression:
        """Agents with a capability (None: all) at a state, or at a label's states, at a step."""
        return Expression(((CountTerm(place, capability, step), 1.0),))

    def add(self, constraint: Constraint, name: str = "constraint") -> None:
        """Demand a linear constraint over counts of every plan."""
        self._constraints.append(replace(constraint, name=name))
        self._setting = None

    def minimise(self, expression: Expression) -> None:
        """Add a linear term over counts, minimised before the mission's own objectives."""
        self._objective = self._objective + expression
        self._setting = None

    @property
    def setting(self) -> Setting:
        """The team in classes, on reduced maps; made when first needed."""
        return self.prepared(Clock())

    def prepared(self, clock: Clock) -> Setting:
        """The same, made within the time of a clock; raises Halted when that is over."""
        if self._setting is None:
            terms = self._objective.terms
            watched = Constraint(terms, -float("inf"), float("inf"), "objective")
            constraints = [*self._constraints, *([watched] if terms else [])]
            make = prepare_soft if is_soft(self.mission) else prepare
            ideas = ALL_IDEAS - self.tuning.without
            self._setting = make(self.mission, constraints, ideas, clock=clock)
        return self._setting

    def encode(self, level: int = 0) -> Encoded:
        """The model of all plans with availability at least `level`, without an objective."""
        if self.tuning.encoding == "tight":
            return tight(self.setting, level)
        return reference(self.setting, (level, level))

    @property
    def model(self) -> Model:
        """The arrays of the model."""
        return self.encode().model

    def native(self, solver: str = "highs") -> Any:
        """The model as the solver's own object, for example a `gurobipy.Model`."""
        return solver_named(solver).native(self.model)

    def solve(
        self,
        effort: Effort,
        clock: Clock,
        tell: Callable[[str, Point | None, float | None, float | None], None],
    ) -> Outcome:
        """Run all objectives; `tell` hears of stages, points and bounds."""
        objective = self.mission.objective
        if self._objective.terms:
            objective = ("own", *objective)
        setting = replace(self.prepared(clock), clock=clock)
        stages = Stages(
            setting=setting,
            effort=replace(effort, ideas=setting.ideas),
            clock=clock,
            measure=Measure(setting),
            tell=tell,
            objective=objective,
            own=self._objective.terms,
            tight=self.tuning.encoding == "tight",
        )
        return plan_soft(stages) if is_soft(self.mission) else stages.run()
