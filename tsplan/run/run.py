"""One run, whatever is planned: time, events, Ctrl-C, and what is kept where it ends early."""

from __future__ import annotations

import time
from abc import ABC, abstractmethod
from collections.abc import Callable
from typing import Generic, TypeVar

from tsplan.clock import Clock, Halted
from tsplan.milp.proof_tree import StageProof
from tsplan.milp.proven_lp import Tally
from tsplan.milp.solver import solver as solver_named
from tsplan.milp.solver_choice import DEFAULT_CHOICE, SolverChoice
from tsplan.plans.outcomes import SolverUse, Timings
from tsplan.process.grace_period import NATIVE, GracePeriod
from tsplan.process.interrupt import on_interrupt
from tsplan.process.quiet_output import Hear, audible, hushed_alone
from tsplan.run.events import Bound, Event, Incumbent, Stage
from tsplan.search.effort import Effort
from tsplan.search.lexicographic import Outcome
from tsplan.stopping import StoppedBy, true_reason
from tsplan.words import known

Listener = Callable[[Event], "bool | None"]

PointT = TypeVar("PointT")
ResultT = TypeVar("ResultT")


class Run(ABC, Generic[PointT, ResultT]):
    """Searches for the best point of a problem and makes a result of it, in a time.

    Ctrl-C and the listener ask every stage to end with what is known. Where memory runs out, the
    best point known is made use of, with that as the reason. Native code that does not end within
    `grace` of that is left behind. `log` gets what the solver says of each program, line by line.
    `alone` a solver's word counts for nothing; what proves an answer is put into `proofs`.
    """

    grace: GracePeriod = NATIVE
    alone = False
    proofs: list[StageProof] | None = None

    def __init__(
        self, choice: SolverChoice, listener: Listener | None, log: Hear | None = None
    ) -> None:
        self.choice = choice.over(DEFAULT_CHOICE)
        self._listener = listener
        self._log = None if log is None else audible(log)
        self._stopped: float | None = None  # seconds after which it was asked to stop
        self._newest: PointT | None = None
        self.clock = Clock(self.choice.time_limit, lambda: self._stopped is not None)
        self.tally = Tally()
        self.seconds = {"reduce": 0.0, "build": 0.0, "solve": 0.0, "extract": 0.0, "verify": 0.0}

    @abstractmethod
    def prepared(self) -> None:
        """What is done before the first model is made."""

    @abstractmethod
    def solved(self, effort: Effort) -> Outcome[PointT]:
        """Run all objectives, telling of it by `tell`."""

    @abstractmethod
    def provisional(self, found: PointT) -> ResultT:
        """The verified result of something found on the way."""

    @abstractmethod
    def finished(self, outcome: Outcome[PointT], used: SolverUse) -> ResultT:
        """The verified result of what was found."""

    def result(self) -> ResultT:
        """Run all stages and certify what they found."""
        with on_interrupt(self._stop), hushed_alone():
            solver = solver_named(self.choice.name or "")
            version = solver.availability().version or ""
            used = SolverUse(solver.name, version, self.choice.numbers)
            effort = Effort(
                solver,
                self.choice,
                grace=self.grace,
                log=self._log,
                certified=self.alone,
                proofs=self.proofs,
                tally=self.tally,
            )
            return self.finished(self._searched(effort), used)

    def reason(self, outcome: Outcome[PointT]) -> StoppedBy | None:
        """What truly ended the search."""
        return true_reason(outcome.stopped_by, self._stopped, self.clock.limit)

    @property
    def timings(self) -> Timings:
        """The seconds of each stage so far."""
        return Timings(**self.seconds, total=self.clock.elapsed)

    def _searched(self, effort: Effort) -> Outcome[PointT]:
        """What the search finds; where it was halted, the last that was heard of."""
        began = time.perf_counter()
        try:
            self.prepared()
            self.seconds["reduce"] = time.perf_counter() - began
            began = time.perf_counter()
            return self.solved(effort)
        except Halted as halted:
            words = (halted.words,) if halted.words else ()
            return Outcome(self._newest, stopped_by=halted.reason, notes=words)
        except MemoryError:
            # what was being built is gone with the error, so there is room again
            return Outcome(self._newest, stopped_by=StoppedBy.MEMORY)
        finally:
            built = self.seconds["build"] = self.clock.spent.get("build", 0.0)
            self.seconds["solve"] = time.perf_counter() - began - built

    def _stop(self) -> None:
        if self._stopped is None:
            self._stopped = self.clock.elapsed

    def tell(
        self, stage: str, found: PointT | None, value: float | None, bound: float | None
    ) -> None:
        """The gate through which all news pass: what is infinite is not known out there."""
        if found is not None:
            self._newest = found
        if self._listener is None:
            return
        elapsed = self.clock.elapsed
        value, bound = known(value), known(bound)
        event: Event
        if found is not None:
            event = Incumbent(stage, value, bound, elapsed, lambda: self.provisional(found))
        elif value is None and bound is None:
            event = Stage(stage, elapsed)
        else:
            event = Bound(stage, value, bound, elapsed)
        if audible(self._listener)(event):
            self._stop()
