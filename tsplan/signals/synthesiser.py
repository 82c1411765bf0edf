"""Synthesis: the trajectory of a system that satisfies a formula, checked before it is shown."""

from __future__ import annotations

import time
from collections import defaultdict
from collections.abc import Mapping
from dataclasses import replace
from functools import partial
from os import PathLike
from typing import Any

from tsplan.errors import Finding, InputError, SolverError
from tsplan.logic import Formula
from tsplan.milp.solver_choice import SolverChoice
from tsplan.plans.outcomes import MissionRef, ModelSize, ObjectiveValue, SolverUse, Status
from tsplan.plans.satisfaction import Depth
from tsplan.process.quiet_output import Hear
from tsplan.run.events import FINISHING
from tsplan.run.problem import Tuning
from tsplan.run.run import Listener, Run
from tsplan.search.effort import Effort
from tsplan.search.lexicographic import Outcome
from tsplan.signals.equalities import MARGIN
from tsplan.signals.linear_system import System
from tsplan.signals.signal_mission import SignalMission
from tsplan.signals.signal_objectives import SignalPoint
from tsplan.signals.signal_parts import Weighting
from tsplan.signals.synthesis import Synthesis
from tsplan.signals.trajectory import Trajectory
from tsplan.signals.trajectory_check import certify
from tsplan.stopping import StoppedBy
from tsplan.words import known


class SynthesisRun(Run[SignalPoint, Trajectory]):
    """One run of synthesis."""

    def __init__(
        self,
        problem: Synthesis,
        choice: SolverChoice,
        listener: Listener | None,
        log: Hear | None = None,
    ) -> None:
        self.problem = problem
        self.mission = problem.mission
        super().__init__(choice.over(self.mission.solver), listener, log)

    def prepared(self) -> None:
        """Nothing is done before the first model is made."""

    def solved(self, effort: Effort) -> Outcome[SignalPoint]:
        """Run all objectives; once more with a margin where the formula holds by none."""
        outcome = self.sought(effort)
        if outcome.point is None or self.problem.holds(outcome.point):
            return outcome
        second = self.sought(effort, MARGIN)
        if second.point is not None:
            # the bounds of what need not hold by a margin are those of all trajectories
            pairs = zip(second.reached, outcome.reached, strict=True)
            reached = tuple(replace(item, bound=other.bound) for item, other in pairs)
            return replace(second, reached=reached)
        words = "trajectories are known that miss the formula by less than solvers can tell"
        why = second.stopped_by or StoppedBy.PRECISION
        return Outcome(stopped_by=why, size=second.size, notes=(words,))

    def sought(self, effort: Effort, margin: float = 0.0) -> Outcome[SignalPoint]:
        """Run all objectives over trajectories whose predicates hold by a margin."""
        return self.problem.solve(effort, self.clock, self.tell, margin)

    def certified(self, made: Trajectory) -> Trajectory:
        """The trajectory after the independent check; SolverError where that refuses it."""
        checked = certify(self.mission, made)
        if broken := self.problem.broken(checked) if checked.has_signals else ():
            raise SolverError(f"the trajectory breaks an own constraint: {'; '.join(broken)}")
        return checked

    def provisional(self, found: SignalPoint) -> Trajectory:
        """The verified trajectory of something found on the way."""
        return certify(self.mission, self.problem.read(found))

    def finished(self, outcome: Outcome[SignalPoint], used: SolverUse) -> Trajectory:
        """The trajectory of what was found, after the independent check."""
        point = outcome.point
        if point is not None:
            self.tell(FINISHING, None, None, None)
        why, status = self.reason(outcome), outcome.status
        read = self._nothing if point is None else partial(self.problem.read, point)
        made = replace(
            read(status, why),
            objective=tuple(
                item.vouched(used, known(item.bound)) for item in self._claimed(outcome)
            ),
            depths=self._depths(outcome),
            notes=outcome.notes,
            solver=used,
            size=ModelSize(*outcome.size),
        )
        began = time.perf_counter()
        checked = self.certified(made)
        self.seconds["verify"] = time.perf_counter() - began
        return replace(checked, timings=self.timings).with_mission(self.mission)

    def _nothing(self, status: Status, why: StoppedBy | None) -> Trajectory:
        mission = self.mission
        return Trajectory(status, MissionRef(mission.name, mission.digest), mission.horizon, why)

    def _claimed(self, outcome: Outcome[SignalPoint]) -> tuple[ObjectiveValue, ...]:
        """What the search claims of the mission's own objectives; levels of one add up."""
        reached: dict[str, list[ObjectiveValue]] = defaultdict(list)
        for item in outcome.reached:
            reached[item.name].append(item)
        claims = []
        for aim in self.mission.objective:
            items = reached[aim.name]
            if aim.name == "preferences":
                known_all = all(item.bound is not None for item in items)
                bound = sum(item.bound or 0.0 for item in items) if known_all else None
                claims.append(ObjectiveValue(aim.name, None, bound))
            elif self.mission.satisfaction in (None, "weighted") or aim.name != "satisfaction":
                claims += [replace(items.pop(0), value=None)] if items else []
        return tuple(claims)

    def _depths(self, outcome: Outcome[SignalPoint]) -> tuple[Depth, ...]:
        """What is proven of each depth, where what holds is counted by its depth."""
        if self.mission.satisfaction in (None, "weighted"):
            return ()
        levels = [item for item in outcome.reached if item.name == "satisfaction"]
        return tuple(
            Depth(depth, round(item.value or 0), None if item.bound is None else round(item.bound))
            for depth, item in enumerate(levels)
        )


def synthesise_mission(
    mission: SignalMission | Synthesis,
    *,
    time_limit: float | None = None,
    solver: str | None = None,
    gap: float | None = None,
    threads: int | None = None,
    seed: int | None = None,
    encoding: str = "tight",
    without: tuple[str, ...] = (),
    on_event: Listener | None = None,
    on_log: Hear | None = None,
    certified: bool = False,
    certificate: str | PathLike[str] | None = None,
) -> Trajectory:
    """The verified trajectory of a mission over signals, or that there is none.

    The options are those of `tsplan.plan`, which raises the same, and InputError where a
    `certified` answer is asked for.
    """
    if certified or certificate is not None:
        what = "there are no certified answers over signals"
        raise InputError([Finding(what, "plan without certified and certificate")])
    choice = SolverChoice(solver, time_limit, gap, threads, seed).checked()
    tuning = Tuning.named(encoding, without)
    problem = mission if isinstance(mission, Synthesis) else Synthesis(mission, tuning)
    return SynthesisRun(problem, choice, on_event, on_log).result()


def synthesise(
    formula: Formula | str | SignalMission | Synthesis,
    system: System | None = None,
    *,
    start: Mapping[str, float | tuple[float, float]] | None = None,
    horizon: int | None = None,
    objective: Any = None,
    weighting: Weighting = "product",
    **options: Any,
) -> Trajectory:
    """The best trajectory of a system that satisfies a formula, verified; or that there is none.

    A mission or a `Synthesis` stands for a formula and all that goes with it. Otherwise `start`
    says where signals begin, `horizon` is the last step (by default the formula's own) and
    `objective` is what a mission file has: `{"robustness": 1, "control_effort": 0.1}` for a
    weighted sum, `["robustness", "control_effort"]` for one after the other, `[]` for any
    trajectory; by default robustness is maximised. `options` are those of `tsplan.plan`:
    `time_limit` in seconds, `solver`, `gap`, `threads`, `seed`, `encoding`, `on_event`, `on_log`.

    Raises MissionError with everything that does not fit together, and what `tsplan.plan` raises.

    >>> from tsplan.signals import Region, double_integrator
    >>> system = double_integrator(("x", "y"), position=(0, 10), speed=1, push=0.5)
    >>> goal, wall = Region(x=(7, 8), y=(8, 9)), Region(x=(3, 5), y=(4, 6))
    >>> reach = goal.inside().eventually(0, 12) & wall.outside().always(0, 12)
    >>> found = synthesise(reach, system, start={"x": 1, "y": 2})
    >>> found.status.value, round(found.robustness, 6), found["x"].shape
    ('optimal', 0.5, (13,))
    """
    if isinstance(formula, SignalMission | Synthesis):
        return synthesise_mission(formula, **options)
    mission = SignalMission.of(
        system=system,
        start=start,
        formula=formula,
        horizon=horizon,
        objective=objective,
        weighting=weighting,
    )
    return synthesise_mission(mission, **options)
