"""Control by planning: at every step the rest of a mission is planned anew from what was measured.

The horizon shrinks: what was measured and applied is fixed, and the formula is judged on all of it,
the past and what is planned. The last plan is at hand from the first moment of a step on, led on
from what was measured; the search begins there, or at what that plan chose, and betters it as long
as the deadline lets it.

Source: V. Raman et al., "Model predictive control with signal temporal logic specifications", CDC
2014, of which the horizon does not shrink.
"""

from __future__ import annotations

import time
from collections.abc import Collection, Mapping
from dataclasses import dataclass, field, replace
from types import MappingProxyType

import numpy as np

from tsplan.errors import Finding, InputError, MissionError, PlanError, TsplanError
from tsplan.milp.model import Floats
from tsplan.milp.solver import solver as solver_named
from tsplan.milp.solver_choice import DEFAULT_CHOICE, SolverChoice
from tsplan.plans.outcomes import MissionRef, ObjectiveValue, Status
from tsplan.process.grace_period import NATIVE, GracePeriod
from tsplan.signals.controller_run import ControllerRun
from tsplan.signals.least_violation import violation
from tsplan.signals.measurements import column, complaints, seconds
from tsplan.signals.motion_check import refuse_misfit
from tsplan.signals.reach import Past
from tsplan.signals.signal_mission import SignalMission
from tsplan.signals.signal_stages import Start
from tsplan.signals.synthesis import Synthesis
from tsplan.signals.trajectory import Trajectory
from tsplan.signals.trajectory_check import appraised, check
from tsplan.stopping import StoppedBy

_RESERVE = 0.2  # of a deadline that is kept for what no clock can stop, until it is known better
_LATER = 1.25  # of the longest that was ever needed for it
_GRACE = 0.5  # of the reserve that native code gets to stop, and is left behind
_POLLS = 4  # looks at the clock meanwhile
_FIRST = 0.6  # of the time that a plan is looked for while none is known; the rest is for the least
_MORE = 1e-6  # by which a violation that is known may be missed, so that its trajectory is allowed


@dataclass(frozen=True)
class Step:
    """What a controller says at one step.

    `control` is what to apply until the next step, by name; the step itself gives it too:
    `step["u"]`. `robustness` is that of the formula, with its weights, on what was measured and
    what is planned, as the evaluator tells it; `holds` says that the formula holds on that and that
    all bounds, limits and own constraints are kept from now on. If it does, `status` is optimal or
    feasible; if not, it is infeasible where that is proven and no_plan_found where it is not, and
    the control is that of the least `violation` found. `stopped_by` is what ended the search. A
    control is `fresh` if the search has found or confirmed it; else it is that of the last plan.
    """

    number: int
    control: Mapping[str, float] = field(hash=False)
    status: Status
    stopped_by: StoppedBy | None
    fresh: bool
    holds: bool
    robustness: float | None
    violation: float
    seconds: float
    notes: tuple[str, ...] = ()

    def __getitem__(self, name: str) -> float:
        """The control of a name; KeyError for others."""
        return self.control[name]


@dataclass(frozen=True, eq=False)
class _Way:
    """A past and a way on, measured; what is wrong with it, in words."""

    trajectory: Trajectory
    problems: tuple[str, ...]


@dataclass(frozen=True)
class _Times:
    """The time of a step: when it began, its deadline, and how late searches have been so far.

    A search has a share of it, less a reserve for what no clock can stop.
    """

    began: float
    deadline: float | None
    late: float
    share: float = 1.0

    @property
    def reserve(self) -> float:
        """Seconds that are kept."""
        return max(_RESERVE * (self.deadline or 0.0), _LATER * self.late)

    @property
    def grace(self) -> GracePeriod:
        """How long native code may take to stop."""
        if self.deadline is None:
            return NATIVE
        within = min(_GRACE * self.reserve, NATIVE.time_limit)
        return GracePeriod(within, within, poll=min(NATIVE.poll, within / _POLLS))

    @property
    def limit(self) -> float | None:
        """Seconds that a search may take from now on."""
        if self.deadline is None:
            return None
        return self.share * (self.began + self.deadline - time.perf_counter() - self.reserve)


class Controller:
    """Steers a system by a mission, step by step.

    `problem` is a mission over signals or a `Synthesis` of one. A trajectory may be given as the
    first `plan`; without one the first step plans from nothing, so give it time.

    Raises MissionError for systems that nothing steers, PlanError for the plan of another mission,
    SolverUnavailableError for a solver that cannot be used.

    >>> import tsplan
    >>> from tsplan.signals import Region, System, double_integrator
    >>> system = double_integrator(("x",), position=(0, 9), speed=2, push=1)
    >>> mission = tsplan.SignalMission.of(
    ...     formula=Region(x=(4, 6)).inside().eventually(0, 6), system=system,
    ...     start={"x": 1, "vx": 0}, objective={"robustness": 1},
    ... )
    >>> controller, measured = tsplan.Controller(mission), {"x": 1.0, "vx": 0.0}
    >>> while not controller.done:
    ...     step = controller.step(measured, deadline=1)
    ...     if step.control:
    ...         measured = system.led(measured, step.control)
    >>> step.holds, step.robustness
    (True, 1.0)
    """

    def __init__(
        self,
        problem: SignalMission | Synthesis,
        *,
        plan: Trajectory | None = None,
        solver: str | None = None,
        gap: float | None = None,
        threads: int | None = None,
        seed: int | None = None,
    ) -> None:
        self._problem = problem if isinstance(problem, Synthesis) else Synthesis(problem)
        mission = self._mission = self._problem.mission
        self._system = mission.system
        if self._system.dynamics is None or not self._system.controls:
            remedy = "give the system dynamics with controls"
            raise MissionError([Finding("nothing steers the signals", remedy)])
        if not mission.horizon:
            raise MissionError([Finding("there is no step to steer", "set a horizon")])
        self._choice = SolverChoice(solver, None, gap, threads, seed).checked()
        solver_named(self._choice.over(mission.solver).over(DEFAULT_CHOICE).name or "")
        self._past: Past | None = None
        self._way: _Way | None = None
        self._planned: Trajectory | None = None
        self._controls = self._idle()
        self._late = 0.0
        self._notes: tuple[str, ...] = ()
        if plan is not None:
            self._follow(plan)

    @property
    def done(self) -> bool:
        """Whether the last step of the mission was measured."""
        return self._past is not None and self._past.step == self._mission.horizon

    @property
    def trajectory(self) -> Trajectory:
        """What was measured so far, and what is planned from there on.

        Everything in it is measured. It is verified if `check` accepts it as it would any other,
        so not where a disturbance has led the system elsewhere than its controls.

        Raises InputError before the first step.
        """
        if self._way is None:
            remedy = "call step(measured) first"
            raise InputError([Finding("nothing was measured so far", remedy)])
        own = self._way.trajectory
        return replace(own, verified=check(self._mission, own).ok)

    def step(
        self,
        measured: Mapping[str, float],
        deadline: float | None = None,
        *,
        applied: Mapping[str, float] | None = None,
    ) -> Step:
        """The control for this step, given the signals that were measured at it.

        The first call is of step 0, each further one of the next, the last of the horizon: it has
        no control, and tells how the mission ended. `deadline` is in seconds; 0 is to lead on the
        last plan at once. Without one the search has the time limit of the mission, or ends when it
        is done. `applied` is what the controls truly were since the last step, if that is not what
        the controller said.

        Whatever the system does, the step returns a control: see `Step`. Raises InputError for what
        is no measurement of all signals, and for steps after the horizon; nothing has happened
        then.
        """
        began = time.perf_counter()
        within = None if deadline is None else seconds(deadline)
        self._past = self._measured(measured, applied)
        self._notes = ()
        self._way = known = self._led(self._past)
        if self.done:
            holds = not known.problems
            status = Status.OPTIMAL if holds else Status.INFEASIBLE
            return self._told(status, None, known, began, fresh=True)
        return self._planning(known, began, within)

    # --- searching -----------------------------------------------------------------------------

    def _planning(self, known: _Way, began: float, deadline: float | None) -> Step:
        """Look for a better way on than that of the last plan, and how to miss the least."""
        assert self._past is not None
        rows = _rows(known.trajectory, self._system.names)
        times = _Times(began, deadline, self._late)
        start: Start | None = Start(rows, holds=True)
        if known.problems:
            start, times = self._choices(), replace(times, share=_FIRST)
        found = self._searched(self._problem.after(self._past), start, times)
        status = Status.NO_PLAN_FOUND
        why: StoppedBy | None = StoppedBy.TIME_LIMIT
        if found is not None and not found.trajectory.has_signals:
            status, why = found.trajectory.status, found.trajectory.stopped_by
            found = None
        if (found is None or found.problems) and known.problems:
            times = _Times(began, deadline, self._late)
            found = self._least(rows, times) or found
        if found is None or (found.problems and not known.problems):
            way, fresh = known, False
        else:
            way, fresh = found, True
        if not way.problems:
            status, why = way.trajectory.status, way.trajectory.stopped_by
        self._way = way
        self._planned, self._controls = way.trajectory, self._steered(way.trajectory)
        return self._told(status, why, way, began, fresh=fresh)

    def _choices(self) -> Start | None:
        """What the last plan chose, on what was measured and what it expected from now on."""
        if self._planned is None or self._past is None:
            return None
        rows = _rows(self._planned, self._system.names)
        count, now = len(self._system.signals), self._past.step
        rows[:count, : now + 1] = self._past.signals
        rows[count:, :now] = self._past.controls
        return Start(rows, holds=False)

    def _least(self, rows: Floats, times: _Times) -> _Way | None:
        """The way of the least violation found, from one that is known by its values."""
        assert self._past is not None
        amount = self._violation(rows)
        if not 0 < amount < np.inf:
            return None
        problem = self._problem.after(self._past, amount * (1 + _MORE) + _MORE)
        found = self._searched(problem, Start(rows, holds=True), times)
        return found if found is not None and found.trajectory.has_signals else None

    def _violation(self, rows: Floats) -> float:
        """By how much a way misses what is still to come."""
        assert self._past is not None
        return violation(self._problem.after(self._past, 1.0).setting(), rows)

    def _searched(self, problem: Synthesis, start: Start | None, times: _Times) -> _Way | None:
        """What a search finds in its time; None where it fails or has none."""
        began, limit = time.perf_counter(), times.limit
        if limit is not None and limit <= 0:
            return None
        try:
            choice = replace(self._choice, time_limit=limit)
            run = ControllerRun(problem, choice, start, times.grace)
            return _Way(run.result(), run.problems)
        except (TsplanError, MemoryError) as error:
            self._notes += (f"the search failed: {error}",)
            return None
        finally:
            if limit is not None:
                self._late = max(self._late, time.perf_counter() - began - limit)

    # --- what is known -------------------------------------------------------------------------

    def _measured(self, measured: Mapping[str, float], applied: Mapping[str, float] | None) -> Past:
        """What was measured so far, with one more step."""
        now = -1 if self._past is None else self._past.step
        if now == self._mission.horizon:
            remedy = "make a new controller for another run"
            raise InputError([Finding(f"the mission ended at step {now}", remedy)])
        findings = complaints(measured, self._system.signals, "signal")
        if applied is not None:
            findings += complaints(applied, self._system.controls, "control")
            if self._past is None:
                findings.append(Finding("nothing was applied before the first step"))
        if findings:
            raise InputError(findings)
        state = column(measured, self._system.signals)
        if self._past is None:
            return Past(state, np.empty((len(self._system.controls), 0)))
        control = self._controls[:, now : now + 1]
        if applied is not None:
            control = column(applied, self._system.controls)
        return Past(
            np.hstack([self._past.signals, state]), np.hstack([self._past.controls, control])
        )

    def _led(self, past: Past) -> _Way:
        """Where the controls of the last plan lead from what was measured."""
        controls = np.hstack([past.controls, self._controls[:, past.step :]])
        later = self._mission.horizon - past.step
        signals = np.hstack([past.signals, np.repeat(past.signals[:, -1:], later, axis=1)])
        names, mission = self._system.names, self._mission
        given = Trajectory(
            Status.FEASIBLE,
            MissionRef(mission.name, mission.digest),
            mission.horizon,
            StoppedBy.TIME_LIMIT,
            tuple(ObjectiveValue(aim.name, None) for aim in mission.objective),
            signals=dict(zip(names, signals, strict=False)),
            controls=dict(zip(names[len(signals) :], controls, strict=True)),
        )
        try:
            own, problems = appraised(mission, given, past.step)
        except PlanError as error:  # an unstable system that is led beyond all numbers
            return _Way(given, (str(error),))
        return _Way(own, problems + self._problem.after(past).broken(own))

    def _told(
        self, status: Status, why: StoppedBy | None, way: _Way, began: float, *, fresh: bool
    ) -> Step:
        """What is said of a step."""
        assert self._past is not None
        now, amount = self._past.step, 0.0
        if way.problems:
            amount = max(0.0, self._violation(_rows(way.trajectory, self._system.names)))
        control = {} if self.done else {n: row[now] for n, row in way.trajectory.controls.items()}
        notes = (*self._notes, *way.problems)
        return Step(
            now,
            MappingProxyType(control),
            status,
            why,
            fresh,
            not way.problems,
            way.trajectory.robustness,
            amount,
            time.perf_counter() - began,
            notes,
        )

    def _follow(self, plan: Trajectory) -> None:
        """Take a trajectory as the last plan."""
        refuse_misfit(plan, self._mission)
        self._planned, self._controls = plan, self._steered(plan)

    def _steered(self, trajectory: Trajectory) -> Floats:
        """The controls (m, T) of a trajectory."""
        return np.array([trajectory[name] for name in self._system.controls])

    def _idle(self) -> Floats:
        """The least controls that the bounds allow, for as long as there is no plan."""
        low, high = np.array([*self._system.controls.values()], dtype=np.float64).T
        still = np.clip(np.zeros(len(low)), low, high)
        return np.repeat(still.reshape(-1, 1), self._mission.horizon, axis=1)


def _rows(trajectory: Trajectory, names: Collection[str]) -> Floats:
    """Every signal and control (names, T+1), controls held after the last step."""
    trace = trajectory.trace()
    return np.array([trace.signal(name) for name in names])
