"""One planning run: time, events, Ctrl-C, paths, the independent check, bookkeeping."""

from __future__ import annotations

import gc
import time
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import replace

from tsplan.checking.plan_check import certify
from tsplan.clock import Clock, Halted
from tsplan.encode.encoded import Point
from tsplan.errors import SolverError
from tsplan.exact import digits
from tsplan.milp.solver import solver as solver_named
from tsplan.milp.solver_choice import DEFAULT_CHOICE, SolverChoice
from tsplan.mission import Mission
from tsplan.plans.plan import (
    MissionRef,
    ModelSize,
    ObjectiveValue,
    Plan,
    SolverUse,
    Status,
    Timings,
)
from tsplan.plans.satisfaction import Depth, Satisfaction
from tsplan.process.interrupt import on_interrupt
from tsplan.process.quiet_output import audible, hushed_alone
from tsplan.run.events import FINISHING, Bound, Event, Incumbent, Stage
from tsplan.run.own_terms import worth
from tsplan.run.paths import ways_of
from tsplan.run.problem import Problem
from tsplan.search.effort import Effort
from tsplan.search.lexicographic import Outcome
from tsplan.stopping import StoppedBy, true_reason
from tsplan.words import known

Listener = Callable[[Event], "bool | None"]


class MissionRun:
    """One planning run for a problem."""

    def __init__(self, problem: Problem, choice: SolverChoice, listener: Listener | None) -> None:
        self._problem = problem
        self._mission = problem.mission
        self._choice = choice.over(self._mission.solver).over(DEFAULT_CHOICE)
        self._listener = listener
        self._stopped: float | None = None  # seconds after which it was asked to stop
        self._newest: Point | None = None
        self._clock = Clock(self._choice.time_limit, lambda: self._stopped is not None)
        self._seconds = {"reduce": 0.0, "build": 0.0, "solve": 0.0, "extract": 0.0, "verify": 0.0}

    def plan(self) -> Plan:
        """Run all stages and certify what they found.

        Ctrl-C and the listener ask every stage to end with what is known. Where memory runs out,
        the best plan known is certified, with that as the reason.
        """
        with on_interrupt(self._stop), hushed_alone():
            return self._planned()

    def _planned(self) -> Plan:
        solver = solver_named(self._choice.name or "")
        version = solver.availability().version or ""
        used = SolverUse(solver.name, version, self._choice.numbers)
        result = self._searched(Effort(solver, self._choice))
        with _uncollected():
            return self._finished(result, used)

    def _searched(self, effort: Effort) -> Outcome:
        """What the search finds; where it was halted, the last that was heard of."""
        began = time.perf_counter()
        try:
            self._problem.prepared(self._clock)
            self._seconds["reduce"] = time.perf_counter() - began
            began = time.perf_counter()
            return self._problem.solve(effort, self._clock, self._tell)
        except Halted as halted:
            words = (halted.words,) if halted.words else ()
            return Outcome(self._newest, stopped_by=halted.reason, notes=words)
        except MemoryError:
            # what was being built is gone with the error, so there is room again
            return Outcome(self._newest, stopped_by=StoppedBy.MEMORY)
        finally:
            built = self._seconds["build"] = self._clock.spent.get("build", 0.0)
            self._seconds["solve"] = time.perf_counter() - began - built

    def _stop(self) -> None:
        if self._stopped is None:
            self._stopped = self._clock.elapsed

    def _tell(
        self, stage: str, found: Point | None, value: float | None, bound: float | None
    ) -> None:
        """The gate through which all news pass: what is infinite is not known out there."""
        if found is not None:
            self._newest = found
        if self._listener is None:
            return
        elapsed = self._clock.elapsed
        value, bound = known(value), known(bound)
        event: Event
        if found is not None:
            event = Incumbent(stage, value, bound, elapsed, lambda: self._provisional(found))
        elif value is None and bound is None:
            event = Stage(stage, elapsed)
        else:
            event = Bound(stage, value, bound, elapsed)
        if audible(self._listener)(event):
            self._stop()

    def _provisional(self, found: Point) -> Plan:
        """The verified plan of something found on the way."""
        mission = self._mission
        made = Plan(
            status=Status.FEASIBLE,
            stopped_by=StoppedBy.INTERRUPT,
            mission=MissionRef(mission.name, mission.digest),
            horizon=mission.horizon,
            objective=self._open(),
            **ways_of(self._problem.setting, found, self._choice.seed),
        )
        return certify(mission, made)

    def _open(self) -> tuple[ObjectiveValue, ...]:
        """The objectives of the mission, nothing known of them: the check fills their values in."""
        mission = self._mission
        return tuple(ObjectiveValue(name, None, None) for name in mission.objective)

    def _finished(self, outcome: Outcome, used: SolverUse) -> Plan:
        mission, point = self._mission, outcome.point
        if point is not None:
            self._tell(FINISHING, None, None, None)
        began = time.perf_counter()
        seed = self._choice.seed
        ways = {} if point is None else ways_of(self._problem.setting, point, seed)
        self._seconds["extract"] = time.perf_counter() - began
        # values are those that the check measures on the paths
        reached = [replace(item, value=None, bound=known(item.bound)) for item in outcome.reached]
        if point is not None and not reached:
            reached = list(self._open())
        size = ModelSize(
            *outcome.size, states=len(mission.system.states), edges=len(mission.system.edges)
        )
        made = Plan(
            status=outcome.status,
            stopped_by=true_reason(outcome.stopped_by, self._stopped, self._clock.limit),
            mission=MissionRef(mission.name, mission.digest),
            horizon=mission.horizon,
            objective=tuple(item for item in reached if item.name != "own"),
            satisfaction=None if point is None else claimed_depths(mission, outcome.levels),
            notes=outcome.notes,
            solver=used,
            size=size,
            **ways,
        )
        own = next((item for item in reached if item.name == "own"), None)
        return self._certified(made, own)

    def _certified(self, made: Plan, own: ObjectiveValue | None) -> Plan:
        """The plan after the independent check, with the seconds of each stage."""
        began = time.perf_counter()
        checked = made
        if made.has_paths:
            checked = self._with_own(certify(self._mission, made), own)
        self._seconds["verify"] = time.perf_counter() - began
        return replace(checked, timings=Timings(**self._seconds, total=self._clock.elapsed))

    def _with_own(self, plan: Plan, reached: ObjectiveValue | None) -> Plan:
        """The plan after the check of the user's own constraints, and what the own sum comes to."""
        if broken := self._problem.broken(plan):
            raise SolverError(f"the plan breaks an own constraint: {'; '.join(broken)}")
        own = self._problem.own
        if not own.expression.terms:
            return plan
        value = own.expression.constant
        value += worth(own.expression.terms, plan, self._mission.system)
        bound = None if reached is None else reached.bound
        what = "own objective, maximised:" if own.maximised else "own objective"
        note = f"{what} {digits(value)} (bound {'open' if bound is None else digits(bound)})"
        return replace(plan, notes=(note, *plan.notes))


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
