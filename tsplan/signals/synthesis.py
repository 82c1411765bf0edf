"""A mission over signals as an optimisation problem that can be looked at, extended and solved."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from copy import copy
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from reprlib import repr as clipped
from typing import Any, ClassVar, Self

from tsplan.clock import Clock
from tsplan.encode.expressions import Constraint, Expression
from tsplan.encode.partial.partial_model import Wish, everything
from tsplan.encode.switches import ALL_SWITCHES
from tsplan.errors import Finding, MissionError
from tsplan.logic import Formula, conjunction, positive, simplify
from tsplan.logic.evaluation import holds
from tsplan.logic.weights import unweighted
from tsplan.logic.witness_steps import occurrences
from tsplan.milp.model import INFINITY, Model
from tsplan.milp.solver import solver as solver_named
from tsplan.parameters import known_name, step_within
from tsplan.plans.outcomes import MissionRef, Status
from tsplan.run.problem import Tuning
from tsplan.search.effort import Effort
from tsplan.search.lexicographic import Outcome, Tell
from tsplan.signals.aims import CHOSEN, Aim
from tsplan.signals.equalities import TOLERANCE, approximate, equations, narrowed_tree, range_of
from tsplan.signals.least_violation import LeastViolation, remaining
from tsplan.signals.motion_check import settled
from tsplan.signals.reach import Past, Reach, reach
from tsplan.signals.signal_mission import SignalMission
from tsplan.signals.signal_model import SignalModel, signal_model
from tsplan.signals.signal_objectives import (
    AimObjective,
    DepthObjective,
    OwnTerms,
    SignalObjective,
    SignalPoint,
    WishObjective,
    efforts_of,
)
from tsplan.signals.signal_setting import OwnRow, SignalSetting, Soft
from tsplan.signals.signal_stages import SignalStages, Start
from tsplan.signals.trajectory import Trajectory
from tsplan.stopping import StoppedBy

_SLACK = 1e-6  # by which an own constraint may be missed, relative to its bound: as rows are


@dataclass(frozen=True, slots=True)
class ValueTerm:
    """The value of a signal or control at a step."""

    name: str
    step: int

    whole: ClassVar[bool] = False

    def __str__(self) -> str:
        return f"value({self.name!r}, {self.step})"


class Synthesis:
    """A mission over signals with a user's own constraints and objective terms.

    What an own constraint or objective cannot mean is a MissionError in the line that says it.

    >>> import tsplan
    >>> from tsplan.signals import Region, System
    >>> goal = Region(x=(4, 6))
    >>> mission = tsplan.SignalMission.of(
    ...     formula=goal.inside().eventually(0, 5), system=System({"x": (0, 9)}),
    ...     objective={"robustness": 1},
    ... )
    >>> problem = tsplan.Synthesis(mission)
    >>> problem.add(sum(problem.value("x", step) for step in range(6)) <= 4.5)
    >>> tsplan.synthesise(problem).robustness
    0.5
    """

    def __init__(self, mission: SignalMission, tuning: Tuning | None = None) -> None:
        self.mission = mission
        self.tuning = tuning or Tuning()
        self._constraints: list[Constraint] = []
        self._objective = Expression()
        self.past: Past | None = None
        self.beyond = 0.0
        self._goals: dict[tuple[float, bool], Formula] = {}
        self._intervals: tuple[Past | None, float, Reach] | None = None

    def value(self, name: str, step: int) -> Expression:
        """The value of a signal or control at a step, for own constraints and objectives.

        Raises MissionError for names that the system does not have and for what is no step of it.
        """
        system = self.mission.system
        places = (system.signals, system.controls)
        name = known_name(name, places, "signal or control", MissionError)
        last = self.mission.horizon - (name in system.controls)
        term = ValueTerm(name, step_within(step, last, MissionError))
        return Expression(((term, Fraction(1)),))

    def add(self, constraint: Constraint, name: str = "constraint") -> None:
        """Demand a linear constraint over values of every trajectory; MissionError for others."""
        if not isinstance(constraint, Constraint):
            remedy = "compare values: problem.add(problem.value('x', 3) <= 5)"
            raise MissionError([Finding(f"{clipped(constraint)} is not a constraint", remedy)])
        self._known(constraint.terms)
        self._constraints.append(replace(constraint, name=name))

    def minimise(self, expression: Expression) -> None:
        """Add a linear term over values, minimised before the mission's own objectives."""
        if not isinstance(expression, Expression) or not expression.terms:
            remedy = "give a sum of values, such as 2 * problem.value('x', 3)"
            raise MissionError([Finding(f"{clipped(expression)} is not an objective", remedy)])
        self._known(expression.terms)
        self._objective += expression

    def maximise(self, expression: Expression) -> None:
        """Add a linear term over values, maximised; it is taken off what is minimised."""
        self.minimise(-expression)

    def _known(self, terms: Any) -> None:
        for term, _ in terms:
            if not isinstance(term, ValueTerm):
                remedy = "make it of problem.value(name, step)"
                raise MissionError([Finding(f"'{term}' is no value of a signal", remedy)])
            self.value(term.name, term.step)

    def after(self, past: Past, beyond: float = 0.0) -> Self:
        """The same problem after what was measured.

        Bounds of signals to come, limits and constraints that name one and what is left of the
        formula may be missed by `beyond`; how much of that is needed is minimised before all else.
        """
        made = copy(self)
        made.past, made.beyond = past, beyond
        return made

    @property
    def now(self) -> int | None:
        """The step of the last measurement; None where nothing was measured."""
        return None if self.past is None else self.past.step

    def _goal(self, margin: float, *, satisfied: bool) -> Formula:
        """The formula in its normal form, made once."""
        key = (margin, satisfied)
        if key not in self._goals:
            mission = self.mission
            near = approximate(mission.formula, mission.system, TOLERANCE / 2, margin)
            plain = unweighted(positive(near), mission.weighting, satisfied=satisfied)
            self._goals[key] = simplify(plain)
        return self._goals[key]

    @property
    def _reach(self) -> Reach:
        """What the system can reach, told once for what was measured."""
        known = self._intervals
        if known is None or known[0] is not self.past or known[1] != self.beyond:
            made = reach(self.mission.system, self.mission.horizon, self.past, self.beyond)
            self._intervals = known = (self.past, self.beyond, made)
        return known[2]

    @cached_property
    def _wishes(self) -> tuple[Wish, ...]:
        """What is to hold as far as possible."""
        mission = self.mission
        if mission.satisfaction is not None:
            return (Wish(narrowed_tree(mission.formula, mission.system), partial=True),)
        return tuple(
            Wish(narrowed_tree(wish.formula, mission.system), wish.partial)
            for wish in mission.prefer
        )

    def setting(self, margin: float = 0.0) -> SignalSetting:
        """What every model is made of; of a formula that is missed, with the factors of that.

        Predicates are to hold by a `margin`, a share of their range.
        """
        mission = self.mission
        goal = self._goal(margin, satisfied=not self.beyond)
        if self.beyond and self.past is not None:
            goal = remaining(goal, self.past.step)
        soft = None
        if mission.satisfaction is not None:
            soft = Soft(conjunction([]), self._wishes, depths=mission.satisfaction != "weighted")
        elif mission.prefer and not self.beyond:
            soft = Soft(goal, self._wishes)
        return SignalSetting(
            self._reach,
            goal if soft is None else everything(soft.demand, soft.wishes),
            efforts_of(mission.objective, mission.system),
            tuple(_row(constraint) for constraint in self._constraints),
            soft,
            ALL_SWITCHES - self.tuning.without,
            self.beyond,
        )

    def encode(self, level: tuple[float, float] | None = None) -> SignalModel:
        """The tight model of all trajectories with a robustness in `level`: 0 or more."""
        setting = self.setting()
        return signal_model(setting, level or (0.0, max(setting.ideal, 0.0)))

    @property
    def model(self) -> Model:
        """The arrays of the model."""
        return self.encode().model

    def native(self, solver: str = "highs") -> Any:
        """The model as the solver's own object, for example a `gurobipy.Model`."""
        return solver_named(solver).native(self.model)

    def broken(self, trajectory: Trajectory) -> tuple[str, ...]:
        """The own constraints that a trajectory does not keep, in words, but for those all past."""
        found = []
        for constraint in self._constraints:
            if _row(constraint).settled(self.mission.system, self.past):
                continue
            total = sum(
                float(factor) * float(trajectory[term.name][term.step])
                for term, factor in constraint.terms
            )
            low, high = _ends(constraint)
            if not low - _slack(low) <= total <= high + _slack(high):
                found.append(f"'{constraint.name}' asks for {constraint}, and it comes to {total}")
        return tuple(found)

    @property
    def objectives(self) -> tuple[SignalObjective, ...]:
        """What is to hold, then the own objective, then those of the mission.

        Of a formula that holds in part, the robustness of what holds is maximised in any case.
        """
        mission = self.mission
        terms = tuple((t.name, t.step, float(factor)) for t, factor in self._objective.terms)
        found: list[SignalObjective] = [LeastViolation()] if self.beyond else []
        if mission.satisfaction is not None or not self.beyond:
            found += _choosing(mission)
        found += [OwnTerms(terms, float(self._objective.constant))] if terms else []
        aims = [aim for aim in mission.objective if aim.name not in CHOSEN]
        named = any(name == "robustness" for aim in aims for name, _ in aim.weights)
        if mission.satisfaction is not None and not named:
            aims = [Aim((("robustness", 1.0),)), *aims]
        return (*found, *map(AimObjective, aims))

    def solve(
        self,
        effort: Effort,
        clock: Clock,
        tell: Tell[SignalPoint],
        margin: float = 0.0,
        start: Start | None = None,
    ) -> Outcome[SignalPoint]:
        """Run all objectives over trajectories whose predicates hold by a margin."""
        tight = self.tuning.encoding == "tight"
        least = 0.0 if self.mission.satisfaction is not None else -self.beyond
        return SignalStages(
            self, self.objectives, effort, clock, tell, least, margin, tight, start
        ).run()

    def read(
        self, point: SignalPoint, status: Status = Status.FEASIBLE, why: StoppedBy | None = None
    ) -> Trajectory:
        """What a point says of the signals and controls, unchecked."""
        mission = self.mission
        rows = dict(zip(mission.system.names, point.rows, strict=True))
        controls = {name: rows.pop(name)[:-1] for name in mission.system.controls}
        return Trajectory(
            status,
            MissionRef(mission.name, mission.digest),
            mission.horizon,
            why if status is not Status.FEASIBLE else why or StoppedBy.INTERRUPT,
            signals=rows,
            controls=controls,
        )

    @cached_property
    def slack(self) -> float:
        """By how much equations make robustness look greater than it is, as they are taken."""
        widths = (range_of(n.terms, self.mission.system) for n in equations(self.mission.formula))
        return TOLERANCE / 2 * max(widths, default=0.0)

    def holds(self, point: SignalPoint) -> bool:
        """Whether what must hold does, on what the controls of a point truly lead to."""
        mission = self.mission
        if mission.satisfaction is not None or self.beyond:
            return True
        led = settled(mission.system, self.read(point), self.now)
        return bool(holds(self._taken, led.trace())[0])

    @cached_property
    def _taken(self) -> Formula:
        """The formula with equations as they are taken."""
        return approximate(self.mission.formula, self.mission.system)


def _choosing(mission: SignalMission) -> Iterator[SignalObjective]:
    """What is to hold, level by level or depth by depth."""
    if mission.satisfaction == "weighted":
        yield WishObjective("satisfaction", ((0, Fraction(1)),))
    elif mission.satisfaction is not None:
        tree = narrowed_tree(mission.formula, mission.system)
        yield from map(DepthObjective, sorted({place.depth for place in occurrences(tree)}))
    levels: dict[int, list[tuple[int, Fraction]]] = defaultdict(list)
    for number, wish in enumerate(mission.prefer):
        levels[wish.level].append((number, Fraction(str(wish.weight))))
    for level in sorted(levels, reverse=True):
        yield WishObjective("preferences", tuple(levels[level]))


def _row(constraint: Constraint) -> OwnRow:
    terms = tuple((term.name, term.step, float(factor)) for term, factor in constraint.terms)
    return OwnRow(terms, *_ends(constraint))


def _ends(constraint: Constraint) -> tuple[float, float]:
    low = -INFINITY if constraint.lower is None else float(constraint.lower)
    return low, INFINITY if constraint.upper is None else float(constraint.upper)


def _slack(bound: float) -> float:
    return _SLACK * max(1.0, abs(bound)) if abs(bound) < INFINITY else 0.0
