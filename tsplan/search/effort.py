"""How hard to search, and with what."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from tsplan.encode.options import Idea
from tsplan.milp.model import Floats
from tsplan.milp.solution import Options
from tsplan.milp.solver import Solver
from tsplan.search.clock import Clock
from tsplan.search.target import Target


@dataclass(frozen=True)
class Effort:
    """How to solve: the solver and its settings, and which ideas to use."""

    solver: Solver
    gap: float = 0.0
    threads: int | None = None
    seed: int | None = None
    log: Callable[[str], None] | None = None
    ideas: frozenset[Idea] = frozenset(Idea)

    def options(self, clock: Clock, target: Target, start: Floats | None = None) -> Options:
        """What to ask a solver for: the least value of a target, in the time that is left."""
        return Options(
            time_limit=clock.left,
            gap=self.gap,
            absolute_gap=target.absolute_gap,
            threads=self.threads,
            seed=self.seed,
            start=start if "start" in self.solver.features else None,
            log=self.log,
            stop=clock.stop,
        )
