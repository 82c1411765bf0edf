"""One search of a controller: the rest of a mission, from what was measured on."""

from __future__ import annotations

from dataclasses import replace

from tsplan.milp.solver_choice import SolverChoice
from tsplan.process.grace_period import GracePeriod
from tsplan.search.effort import Effort
from tsplan.search.lexicographic import Outcome
from tsplan.signals.signal_objectives import SignalPoint
from tsplan.signals.signal_stages import Start
from tsplan.signals.synthesis import Synthesis
from tsplan.signals.synthesiser import SynthesisRun
from tsplan.signals.trajectory import Trajectory
from tsplan.signals.trajectory_check import appraised


class ControllerRun(SynthesisRun):
    """Searches for the best way on after a past, from a start; native code has `grace` to stop.

    The trajectory is measured on the past and what the dynamics make of its controls from there on;
    `problems` are what is wrong with that.
    """

    problems: tuple[str, ...] = ()

    def __init__(
        self, problem: Synthesis, choice: SolverChoice, start: Start | None, grace: GracePeriod
    ) -> None:
        super().__init__(problem, choice, None)
        self._start, self.grace = start, grace

    def sought(self, effort: Effort, margin: float = 0.0) -> Outcome[SignalPoint]:
        """Run all objectives from the start."""
        return self.problem.solve(effort, self.clock, self.tell, margin, self._start)

    def certified(self, made: Trajectory) -> Trajectory:
        """The trajectory measured, and no more refused than the world is."""
        if not made.has_signals:
            return made
        if self.problem.beyond:  # what is proven is proven of the violation alone
            made = replace(made, objective=(), depths=())
        own, problems = appraised(self.mission, made, self.problem.now)
        self.problems = problems + self.problem.broken(own)
        return own
