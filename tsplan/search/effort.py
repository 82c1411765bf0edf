"""How hard to search, and with what."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

from tsplan.clock import Clock
from tsplan.encode.switches import Switch
from tsplan.milp.model import Floats
from tsplan.milp.proof_tree import StageProof
from tsplan.milp.proven_lp import Tally
from tsplan.milp.solution import Options
from tsplan.milp.solver import Solver
from tsplan.milp.solver_choice import DEFAULT_CHOICE, SolverChoice
from tsplan.milp.target import Target
from tsplan.process.grace_period import NATIVE, GracePeriod
from tsplan.process.quiet_output import Hear


@dataclass(frozen=True)
class Effort:
    """How to solve: the solver, what was chosen of it, and which switches to use.

    `grace` is how long native code may take to stop once its time is up; `log` gets the lines that
    the solver says. With `certified` nothing counts as proven that only a solver says, and with
    `proofs` what proves it is put there. `tally` counts linear programs that were verified.
    """

    solver: Solver
    choice: SolverChoice = DEFAULT_CHOICE
    switches: frozenset[Switch] = frozenset(Switch)
    grace: GracePeriod = NATIVE
    log: Hear | None = None
    certified: bool = False
    proofs: list[StageProof] | None = None
    tally: Tally = field(default_factory=Tally)

    @property
    def record(self) -> bool:
        """Whether what proves an answer is kept."""
        return self.proofs is not None

    def options(self, clock: Clock, target: Target, start: Floats | None = None) -> Options:
        """What to ask a solver for: the least value of a target, in the time that is left."""
        return replace(
            self.limited(clock),
            gap=self.choice.gap or 0.0,
            absolute_gap=target.absolute_gap,
            start=start if "start" in self.solver.features else None,
        )

    def limited(self, clock: Clock) -> Options:
        """What to ask a solver for at any time: to obey the clock, and what was chosen."""
        choice = self.choice
        return Options(
            clock.left,
            threads=choice.threads,
            seed=choice.seed,
            log=self.log,
            stop=clock.stop,
            grace=self.grace,
        )
