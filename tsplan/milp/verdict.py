"""From what a solver says to a `Solution`: what the model itself contradicts is not believed."""

from __future__ import annotations

from dataclasses import dataclass, replace
from enum import Enum, auto

import numpy as np

from tsplan.errors import SolverError
from tsplan.milp.model import Floats, Model
from tsplan.milp.solution import Options, Solution, Status
from tsplan.stopping import StoppedBy

TOLERANCE = 1e-5  # by which a point may violate the model
_CLOSED, _DIGITS = 1e-6, 1e-9  # a gap that is none, absolute and relative to the objective
_GAIN = 1e-6  # by which a point has to beat the cutoff, relative to it if that is more
_CERTAIN = 1e-6  # a start this close to the model refutes "infeasible"


class Verdict(Enum):
    """What a solver claims at its end."""

    SOLVED = auto()  # nothing is better than its point, within the gaps asked for
    REFUTED = auto()  # there is no point
    ENDED = auto()  # it stopped before it knew


@dataclass(frozen=True, eq=False)
class Ending:
    """What a solver says at its end; `bound` None if it names none."""

    verdict: Verdict
    values: Floats | None = None
    bound: float | None = None
    stopped_by: StoppedBy | None = None
    nodes: int = 0


@dataclass(frozen=True, eq=False)
class Question:
    """The model and options that a solver was given."""

    model: Model
    options: Options

    def objective(self, values: Floats) -> float:
        """The value of a point."""
        return float(self.model.objective @ values) + self.model.offset

    def wanted(self, objective: float) -> bool:
        """Whether a point of this value beats the cutoff."""
        cutoff = self.options.cutoff
        return cutoff is None or objective < cutoff - _GAIN * max(1.0, abs(cutoff))

    def cut(self) -> Model:
        """The model with a row that forbids points at or above the cutoff."""
        cutoff = self.options.cutoff
        if cutoff is None:
            return self.model
        # solvers forgive a row as much as a gain has to be, so the row asks for twice that
        most = cutoff - 2 * _GAIN * max(1.0, abs(cutoff)) - self.model.offset
        return self.model.with_row(self.model.objective, -np.inf, most, "cutoff")

    def true_bound(self, bound: float | None) -> float | None:
        """A solver's bound as one on the model; what is above the cutoff was not looked at."""
        if bound is None or not np.isfinite(bound):
            return None
        cutoff = self.options.cutoff
        return float(bound) if cutoff is None else min(float(bound), cutoff)

    def whole(self, values: Floats, tolerance: float = TOLERANCE) -> Floats | None:
        """The point with whole numbers in the integer columns; None if that does not fit the model.

        Where all numbers of a row are whole, the tolerance forgives it nothing.
        """
        values = np.asarray(values, dtype=np.float64)
        if values.shape != self.model.objective.shape or not np.isfinite(values).all():
            return None
        rounded = np.where(self.model.integer, np.round(values), values)
        return rounded if self.model.violation(rounded) <= tolerance else None

    def answer(self, said: Ending, seconds: float) -> Solution:
        """The solution in common terms.

        Raises SolverError for a point that violates the model by more than 1e-5, and for a model
        called infeasible of which the start is a point.
        """
        start = self._start()
        found = self._checked(said.values)
        # a best point that does not beat the cutoff means that none does
        refuted = said.verdict is Verdict.REFUTED or (
            said.verdict is Verdict.SOLVED and found is None
        )
        if refuted and start is not None:
            raise SolverError("the solver calls a model infeasible of which a point is known")
        if refuted:
            return Solution(Status.INFEASIBLE, seconds=seconds, nodes=said.nodes)
        said = replace(said, bound=self.true_bound(said.bound))
        best = self._better(found, start)
        if best is not None:
            return self._with_point(said, best, seconds)
        if said.stopped_by is None:
            raise SolverError("the solver ended without a point and without a reason")
        return Solution(
            Status.UNKNOWN, said.stopped_by, None, None, said.bound, seconds, said.nodes
        )

    def _start(self) -> Floats | None:
        start = self.options.start
        point = None if start is None else self.whole(start, _CERTAIN)
        return point if point is not None and self.wanted(self.objective(point)) else None

    def _checked(self, values: Floats | None) -> Floats | None:
        """A solver's point, if it beats the cutoff."""
        if values is None:
            return None
        point = self.whole(values)
        if point is None:
            raise SolverError("the solver returned a point that violates the model")
        return point if self.wanted(self.objective(point)) else None

    def _better(self, first: Floats | None, second: Floats | None) -> Floats | None:
        if first is None or second is None:
            return second if first is None else first
        return second if self.objective(second) < self.objective(first) else first

    def _with_point(self, said: Ending, values: Floats, seconds: float) -> Solution:
        objective = self.objective(values)
        bound = self._believed(said, objective)
        status, why = Status.FEASIBLE, said.stopped_by
        distance = np.inf if bound is None else objective - bound
        if distance <= max(self.options.absolute_gap, self._nothing(objective)):
            status, why = Status.OPTIMAL, None
        elif said.verdict is Verdict.SOLVED:
            silent = said.bound is None and self.options.gap > 0
            wanted = silent or distance <= self.options.gap * abs(objective)
            why = StoppedBy.GAP if wanted else StoppedBy.PRECISION
        silent = said.bound is None and bool(self.model.integer.any())
        return Solution(status, why, values, objective, bound, seconds, said.nodes, silent)

    def _believed(self, said: Ending, objective: float) -> float | None:
        """A solver's own bound, unless the point contradicts it.

        A solver that names none is held to the value of its point as it gave it.
        """
        bound = said.bound
        if bound is None and said.verdict is Verdict.SOLVED and self.options.gap <= 0:
            bound = objective if said.values is None else self.objective(said.values)
            bound = objective if abs(objective - bound) <= self._nothing(objective) else bound
        if bound is None or bound > objective + self._nothing(objective):
            return None
        return min(bound, objective)

    def _nothing(self, objective: float) -> float:
        """Distances from an objective up to this are rounding."""
        return max(_CLOSED, _DIGITS * abs(objective))
