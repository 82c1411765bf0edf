"""One planning run of a mission: the search, paths, the independent check, bookkeeping."""

from __future__ import annotations

import gc
import time
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from typing import Any

from tsplan.checking.plan_check import certify
from tsplan.encode.encoded import Point
from tsplan.exact import digits
from tsplan.milp.proven_lp import Tally
from tsplan.milp.solver_choice import SolverChoice
from tsplan.mission import Mission
from tsplan.plans.outcomes import (
    CERTIFIED,
    MissionRef,
    ModelSize,
    ObjectiveValue,
    Programs,
    SolverUse,
)
from tsplan.plans.plan import Plan
from tsplan.plans.satisfaction import Depth, Satisfaction
from tsplan.process.quiet_output import Hear
from tsplan.run.events import FINISHING
from tsplan.run.own_terms import worth
from tsplan.run.paths import ways_of
from tsplan.run.point_reading import open_objective, plan_at
from tsplan.run.problem import Problem
from tsplan.run.run import Listener, Run
from tsplan.search.effort import Effort
from tsplan.search.lexicographic import Outcome
from tsplan.words import known


class MissionRun(Run[Point, Plan]):
    """One planning run for a problem."""

    def __init__(
        self,
        problem: Problem,
        choice: SolverChoice,
        listener: Listener | None,
        log: Hear | None = None,
        *,
        certified: bool = False,
    ) -> None:
        self.alone = certified
        self._problem = problem
        self._mission = problem.mission
        super().__init__(choice.over(self._mission.solver), listener, log)

    def prepared(self) -> None:
        """Bring the team into classes, on reduced maps."""
        self._problem.prepared(self.clock)

    def solved(self, effort: Effort) -> Outcome[Point]:
        """Run all objectives of the problem."""
        return self._problem.solve(effort, self.clock, self.tell)

    def provisional(self, found: Point) -> Plan:
        """The verified plan of something found on the way."""
        plan = plan_at(self._problem.setting, found, self.choice.seed)
        return self._problem.completed(plan, found)

    def finished(self, outcome: Outcome[Point], used: SolverUse) -> Plan:
        """The plan of what was found, after the independent check."""
        with _uncollected():
            return self._finished(outcome, used)

    def _finished(self, outcome: Outcome[Point], used: SolverUse) -> Plan:
        mission, point = self._mission, outcome.point
        if point is not None:
            self.tell(FINISHING, None, None, None)
        began = time.perf_counter()
        seed = self.choice.seed
        ways = {} if point is None else ways_of(self._problem.setting, point, seed)
        self.seconds["extract"] = time.perf_counter() - began
        # values are those that the check measures on the paths
        reached = [item.vouched(used, known(item.bound)) for item in outcome.reached]
        if point is not None and not reached:
            reached = list(open_objective(mission))
        size = ModelSize(
            *outcome.size, states=len(mission.system.states), edges=len(mission.system.edges)
        )
        made = Plan(
            status=outcome.status,
            stopped_by=self.reason(outcome),
            mission=MissionRef(mission.name, mission.digest),
            horizon=mission.horizon,
            objective=tuple(item for item in reached if item.name != "own"),
            satisfaction=None if point is None else claimed_depths(mission, outcome.levels),
            notes=outcome.notes,
            solver=used,
            size=size,
            programs=programs(self.tally),
            **_refutation(outcome, used),
            **ways,
        )
        own = next((item for item in reached if item.name == "own"), None)
        began = time.perf_counter()
        checked = made
        if point is not None:
            checked = self._with_own(certify(mission, made), point, own)
        self.seconds["verify"] = time.perf_counter() - began
        return replace(checked, timings=self.timings)

    def _with_own(self, plan: Plan, point: Point, reached: ObjectiveValue | None) -> Plan:
        """The plan after the check of the user's own constraints, and what the own sum comes to."""
        plan, own = self._problem.completed(plan, point), self._problem.own
        if not own.expression.terms:
            return plan
        value = own.expression.constant
        value += worth(own.expression.terms, plan, self._mission)
        bound = None if reached is None else reached.bound
        what = "own objective, maximised:" if own.maximised else "own objective"
        note = f"{what} {digits(value)} (bound {'open' if bound is None else digits(bound)})"
        return replace(plan, notes=(note, *plan.notes))


def _refutation(outcome: Outcome[Point], used: SolverUse) -> dict[str, Any]:
    """Who says that there is no plan, and what that rests on."""
    if not outcome.infeasible:
        return {}
    proof = CERTIFIED if outcome.certified else None
    rests = tuple(sorted(outcome.rests)) if outcome.certified else ()
    return {"proof": proof or used.word, "rests": rests}


def programs(tally: Tally) -> Programs | None:
    """What a plan says of the linear programs that were verified; None without any."""
    made = Programs(tally.verified, tally.again, tally.unproven)
    return None if made == Programs() else made


def claimed_depths(mission: Mission, levels: Iterable[ObjectiveValue]) -> Satisfaction | None:
    """What is proven about the depths of a formula; the check fills in what holds."""
    if not mission.partial:
        return None
    depths = (
        Depth(int(level.name), 0, None if level.bound is None else round(level.bound))
        for level in levels
    )
    return Satisfaction(mission.satisfaction, depths=tuple(depths))


@contextmanager
def _uncollected() -> Iterator[None]:
    """Without the garbage collector: of millions of paths that stay it would search all, often."""
    enabled = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if enabled:
            gc.enable()
