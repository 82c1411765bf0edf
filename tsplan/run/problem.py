"""A mission as an optimisation problem that can be looked at, extended and solved."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, Literal, TypeAlias

import numpy as np

from tsplan.checking.fitting import refuse_pathless
from tsplan.clock import Clock
from tsplan.encode.assemble import reference, tight
from tsplan.encode.encoded import Encoded, Point, Setting
from tsplan.encode.expressions import Constraint, Expression, Own
from tsplan.encode.model_objectives import OwnSum, objectives_of
from tsplan.encode.native_names import column_names, row_names
from tsplan.encode.own_constraints import terms_of
from tsplan.encode.planned_ways import Planned, planned_ways
from tsplan.encode.preparation import prepare
from tsplan.encode.quantities import CountTerm, FlowTerm, OwnVariable
from tsplan.encode.switches import ALL_SWITCHES, Switch
from tsplan.errors import Finding, InputError, MissionError, SolverError, nearest
from tsplan.limits import LARGEST, Range, clipped
from tsplan.milp.model import Model
from tsplan.milp.request import TOLERANCE
from tsplan.milp.solver import solver as solver_named
from tsplan.mission import Mission
from tsplan.routing.walks import point_of, walks_along
from tsplan.run.own_terms import (
    calling_place,
    checked_count,
    checked_flow,
    checked_terms,
    made_variable,
    within_reach,
    worth,
)
from tsplan.run.own_values import with_values
from tsplan.run.partial_strategy import is_soft, plan_soft, prepare_soft
from tsplan.run.point_reading import plan_at
from tsplan.search.capacity_relaxation import CapacityRelaxation, relaxable
from tsplan.search.effort import Effort
from tsplan.search.lexicographic import Outcome, Tell
from tsplan.search.stages import Stages

if TYPE_CHECKING:
    from tsplan.encode.expressions import Number
    from tsplan.plans.plan import Plan
    from tsplan.ts import Edge

Encoding: TypeAlias = Literal["tight", "reference"]


@dataclass(frozen=True)
class Tuning:
    """How a problem is to be encoded: by which encoding, and without which of its methods."""

    encoding: Encoding = "tight"
    without: frozenset[Switch] = frozenset()

    @classmethod
    def named(cls, encoding: str, without: Iterable[str] = ()) -> Tuning:
        """Tuning from plain words; MissionError names those that do not exist."""
        known = [switch.value for switch in Switch]
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
            frozenset(Switch(name) for name in without),
        )


class Problem:
    """A mission with a user's own constraints and objective terms.

    What an own constraint or objective cannot mean
    is a MissionError in the line that says it: unknown names, steps outside the mission, numbers
    that are not finite, and whatever is no sum of counts times numbers.

    >>> import tsplan
    >>> from tsplan.ts.builders import grid
    >>> corridor = grid(1, 3, labels={(0, 2): "dock"}, name="corridor")
    >>> team = [tsplan.Group.of("cart", {"r0c0": 4})]
    >>> mission = tsplan.Mission.of(
    ...     map=corridor, team=team, formula="F[0,5] dock", language="mtl", objective=["travel"]
    ... )
    >>> problem = tsplan.Problem(mission)
    >>> problem.add(problem.count("dock", step=5).between(2, 3))
    >>> problem.add(problem.count("r0c1", step=5) == 1, "one waits outside")
    >>> plan = tsplan.plan(problem, time_limit=10)
    >>> plan.counts(states=["r0c1", "r0c2"])[:, 5].tolist()
    [1, 2]
    >>> problem.maximise(problem.count("dock", step=5))
    >>> tsplan.plan(problem, time_limit=10).notes
    ('own objective, maximised: 3 (bound 3)',)

    What agents do on the way is a `flow`, and what else is to be decided a `variable`: here lifts
    that are opened, each for two carts.

    >>> lifts = problem.variable("lifts", 0, 5)
    >>> entered = sum(problem.flow(("r0c1", "r0c2"), step=step) for step in range(5))
    >>> problem.add(entered <= 2 * lifts, "room in the lifts")
    >>> problem.minimise(10 * lifts)
    >>> plan = tsplan.plan(problem, time_limit=10)
    >>> int(plan.variables["lifts"]), int(plan.counts(states=["r0c2"])[0, 5])
    (1, 2)
    """

    def __init__(self, mission: Mission, tuning: Tuning = Tuning()) -> None:
        self.mission = mission
        self.tuning = tuning
        self._constraints: list[Constraint] = []
        self._variables: dict[str, OwnVariable] = {}
        self._objective = Expression()
        self._maximised = False
        self._start: Plan | None = None
        self._setting: Setting | None = None

    def tuned(self, tuning: Tuning) -> Problem:
        """The same problem, encoded in another way."""
        other = self.with_constraints(self.mission, self._constraints)
        other.tuning = tuning
        return other

    def start_from(self, plan: Plan) -> None:
        """Begin the search with the paths of a plan, of this mission or of one like it.

        Where they are a plan of this problem one is known at once; else they are of no use, and of
        no harm. Agents are told by their ids. Raises PlanError for a plan without paths.
        """
        refuse_pathless(plan)
        self._start = plan

    @classmethod
    def of(
        cls, mission: Mission, constraints: Iterable[Constraint], tuning: Tuning = Tuning()
    ) -> Problem:
        """A problem with constraints of another one, and the own variables in them."""
        made = cls(mission, tuning)
        made._constraints = [*constraints]
        used = terms_of(made._constraints)
        made._variables = {item.name: item for item in used if isinstance(item, OwnVariable)}
        for item in made._constraints:
            checked_terms(item.terms, mission, made._variables)
        return made

    def with_constraints(self, mission: Mission, constraints: Iterable[Constraint]) -> Problem:
        """The same objective and variables with other constraints, on another mission."""
        other = Problem(mission, self.tuning)
        changed = {
            "mission": mission,
            "_constraints": [*constraints],
            "_setting": None,
            "_variables": dict(self._variables),
        }
        other.__dict__.update(self.__dict__ | changed)
        return other

    @property
    def constraints(self) -> tuple[Constraint, ...]:
        """The own constraints as they were added."""
        return tuple(self._constraints)

    def count(self, place: str, capability: str | None = None, *, step: int) -> Expression:
        """Agents with a capability (None: all) at a state, or at a label's states, at a step.

        Where a state and a label have the same name, the state is meant. Raises MissionError for
        names that the mission does not know, and for what is no step of it.
        """
        return Expression.sum_of([checked_count(CountTerm(place, capability, step), self.mission)])

    def flow(
        self, edge: tuple[str, str] | Edge, capability: str | None = None, *, step: int
    ) -> Expression:
        """Agents with a capability (None: all) that enter an edge, named by its ends, at a step.

        An edge from a state to itself is a wait. Swarms, structures and capabilities are counted as
        by `count`. Raises MissionError for an edge that the map does not have, for other names that
        the mission does not know, and for a step at which nobody enters an edge any more: the last.

        >>> import tsplan
        >>> problem = tsplan.Problem(tsplan.load_mission("mission.yaml"))
        >>> print(problem.flow(("yard", "dock"), step=0) <= 1)
        flow(('yard', 'dock'), step=0) <= 1
        """
        asked: Any = edge
        return Expression.sum_of([checked_flow(FlowTerm(asked, capability, step), self.mission)])

    def variable(self, name: str, low: Number, high: Number, *, integer: bool = True) -> Expression:
        """A number of one's own between two others, which plans choose: a whole one, or a real one.

        It stands beside counts and flows in constraints and objectives. A plan has its value in
        `plan.variables`; real ones are fractions that keep the constraints exactly. The same name
        with the same bounds is the same variable. Raises MissionError for no name or bounds, for
        bounds beyond a million, and for a name that is another variable's.

        >>> import tsplan
        >>> problem = tsplan.Problem(tsplan.load_mission("mission.yaml"))
        >>> share = problem.variable("share", 0, 1, integer=False)
        >>> problem.add(3 * share == problem.count("dock", step=6))
        >>> problem.maximise(share)
        >>> tsplan.plan(problem, time_limit=10).variables["share"]
        Fraction(1, 1)
        """
        made = made_variable(name, low, high, integer=integer)
        known = self._variables.setdefault(made.name, made)
        if known != made:
            what = f"there is another variable '{name}', between {known.low} and {known.high}"
            raise MissionError([Finding(what, "choose another name")])
        return Expression.sum_of([made])

    def add(self, constraint: Constraint, name: str = "") -> None:
        """Demand a linear constraint over counts, flows and own variables of every plan.

        Constraints are comparisons of expressions: `<=`, `>=`, `==`, `<`, `>`, and
        `expression.between(low, high)`. They mean exactly what they say: `count > 1.5` is
        `count >= 2`. What is said of one names it by its `name`, or by the file and line that added
        it. Raises MissionError for anything else.
        """
        if not isinstance(constraint, Constraint):
            remedy = "compare counts: problem.add(problem.count(place, step=5) >= 2)"
            raise MissionError([Finding(f"{clipped(constraint)} is not a constraint", remedy)])
        self._refuse_expected()
        checked_terms(constraint.terms, self.mission, self._variables)
        named = replace(constraint, name=name or constraint.name, place=calling_place())
        self._constraints.append(named)
        self._setting = None

    def minimise(self, expression: Expression) -> None:
        """Add a linear term over such quantities, minimised before the mission's own objectives.

        Only `satisfaction` (with the availability of what holds) and `preferences`, which say what
        is to hold, come before it. Several terms are added up. Raises MissionError for what is no
        expression over them.

        >>> import tsplan
        >>> problem = tsplan.Problem(tsplan.load_mission("mission.yaml"))
        >>> problem.minimise(problem.count("dock", step=0) + problem.count("dock", step=1))
        """
        self._extend(expression, maximised=False)

    def maximise(self, expression: Expression) -> None:
        """Add a linear term over such quantities, maximised; otherwise as `minimise`.

        Together with terms to minimise, it is taken off these, and the difference is minimised.

        >>> import tsplan
        >>> problem = tsplan.Problem(tsplan.load_mission("mission.yaml"))
        >>> problem.maximise(problem.count("dock", step=5))
        >>> tsplan.plan(problem, time_limit=10).notes[0].startswith("own objective, maximised:")
        True
        """
        self._extend(expression, maximised=True)

    def _extend(self, expression: Expression, *, maximised: bool) -> None:
        if not isinstance(expression, Expression) or not expression.terms:
            remedy = "give a sum of counts, such as 2 * problem.count(place, step=5)"
            raise MissionError([Finding(f"{clipped(expression)} is not an objective", remedy)])
        self._refuse_expected()
        checked_terms(expression.terms, self.mission, self._variables, expression.constant)
        first = not self._objective.terms
        self._maximised = maximised and (first or self._maximised)
        self._objective += -expression if maximised else expression
        self._setting = None

    def _refuse_expected(self) -> None:
        if self.mission.expected is not None:
            what = "own constraints and objectives are about counts, and those here are expected"
            raise MissionError([Finding(what, "say it in the formula")])

    @property
    def own(self) -> Own:
        """The objective that `minimise` and `maximise` have made, in its own sense."""
        maximised = self._maximised
        return Own(-self._objective if maximised else self._objective, maximised)

    @property
    def extended(self) -> bool:
        """Whether there are own constraints or objectives."""
        return bool(self._constraints or self._objective.terms)

    def broken(self, plan: Plan) -> tuple[str, ...]:
        """The own constraints that a plan does not keep, in words, by exact arithmetic.

        Counts and flows are told by the agents' paths, own variables by the plan; what these may
        not be is told, too.
        """
        sums = [(item, worth(item.terms, plan, self.mission)) for item in self._constraints]
        used = terms_of([*self._constraints, self._watched])
        wrong = {
            item.name: words
            for item in used
            if isinstance(item, OwnVariable)
            and (words := item.complaint(plan.variables.get(item.name)))
        }
        return (
            *(f"the own variable '{name}' {words}" for name, words in sorted(wrong.items())),
            *(
                f"'{item.name}' asks for {item}, and it comes to {total}"
                for item, total in sums
                if not item.holds(total)
            ),
        )

    def completed(self, plan: Plan, point: Point) -> Plan:
        """The plan of a point with the values of own variables, after the check of what is own.

        Raises SolverError where it breaks an own constraint.
        """
        if self._variables:
            plan = with_values(plan, point, self.mission, self._constraints, self._objective)
        if broken := self.broken(plan):
            raise SolverError(f"the plan breaks an own constraint: {'; '.join(broken)}")
        return plan

    @property
    def _watched(self) -> Constraint:
        """What the own objective is about, as a constraint that bounds nothing."""
        terms = self._objective.terms
        return Constraint(tuple((term, 1) for term, _ in terms), None, None, "objective")

    @property
    def setting(self) -> Setting:
        """The team in classes, on reduced maps; made when first needed."""
        return self.prepared(Clock())

    def prepared(self, clock: Clock) -> Setting:
        """The same, made within the time of a clock; raises Halted when that is over."""
        if self._setting is None:
            size = self.mission.size
            constraints = [within_reach(item, size) for item in self._constraints]
            constraints += [self._watched] if self._objective.terms else []
            make = prepare_soft if is_soft(self.mission) else prepare
            switches = ALL_SWITCHES - self.tuning.without
            self._setting = make(self.mission, constraints, switches, clock=clock)
        return self._setting

    def encode(self, level: int = 0) -> Encoded:
        """The model of all plans with availability at least `level`, without an objective.

        Raises InputError for a level that is no number of agents.
        """
        if words := Range(-LARGEST, LARGEST, whole=True).complaint(level):
            raise InputError([Finding(f"level: {words}", "give a number of agents")])
        if self.tuning.encoding == "tight":
            return tight(self.setting, level)
        return reference(self.setting, (level, level))

    @property
    def model(self) -> Model:
        """The arrays of the model."""
        return self.encode().model

    def native(self, solver: str = "highs") -> Any:
        """The model as the solver's own object, for example a `gurobipy.Model`.

        HiGHS and Gurobi have names for its columns, as `n[barn,3,cart]` for the carts that wait at
        the barn from step 3 on and `x[barn,field,3,cart]` for those that leave it for the field,
        and for its rows; those of PuLP are numbered.
        """
        encoded = self.encode()
        names = column_names(encoded), row_names(encoded.model)
        return solver_named(solver).named(encoded.model, *names)

    def plan_from(self, native: Any, solver: str = "highs") -> Plan:
        """The plan of the solver's own object after somebody has solved it, judged by the check.

        `native` came from `native(solver)`, or is the values of its columns in their order. What
        it was solved for is not known, so that the plan is feasible, and its objectives are those
        of the mission, as the check measures them. Raises SolverError where there is no point, or
        one that is no plan of this problem, and InputError for another number of columns.

        >>> import tsplan
        >>> problem = tsplan.Problem(tsplan.load_mission("mission.yaml"))
        >>> highs = problem.native("highs")
        >>> _ = highs.run()
        >>> problem.plan_from(highs).verified
        True
        """
        given = isinstance(native, Sequence | np.ndarray)
        values = np.asarray(native if given else solver_named(solver).point(native), np.float64)
        encoded = self.encode()
        columns = encoded.model.size.columns
        if values.shape != (columns,):
            what = f"the point has {values.size:,} values, and the model {columns:,} columns"
            raise InputError([Finding(what, "solve what problem.native() gives, as it is now")])
        if not encoded.model.violation(values) <= TOLERANCE:
            raise SolverError("the point is none of this problem: it breaks rows of its model")
        point = Point(encoded, values, self.tuning.encoding == "tight")
        plan = self.completed(plan_at(self.setting, point, self.mission.solver.seed), point)
        return plan.with_mission(self.mission)

    def solve(self, effort: Effort, clock: Clock, tell: Tell[Point]) -> Outcome[Point]:
        """Run all objectives; `tell` hears of stages, points and bounds."""
        setting = replace(self.prepared(clock), clock=clock)
        own = (OwnSum(self.own),) if self._objective.terms else ()
        objectives = (*own, *objectives_of(self.mission))
        tight, soft = self.tuning.encoding == "tight", is_soft(self.mission)
        effort = replace(effort, switches=setting.switches)
        ways = [] if self._start is None else planned_ways(setting, self._start)
        relaxed = relaxable(setting) and not effort.record  # certificates are of whole models
        if tight and not soft and not own and relaxed:
            known = self._known_point(setting, ways) if ways else None
            return CapacityRelaxation(setting, objectives, effort, clock, tell, known).run()
        stages = Stages(setting, objectives, effort, clock, tell, tight=tight, planned=ways)
        return plan_soft(stages) if soft else stages.run()

    def _known_point(self, setting: Setting, ways: Sequence[Planned]) -> Point | None:
        """The point in which all go these ways, if that is a plan."""
        point = point_of(setting, walks_along(ways), 0)
        try:
            plan_at(setting, point, None)
        except SolverError:  # the check refuses it
            return None
        return point
