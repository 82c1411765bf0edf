"""What a solver is asked, what it says, and the solution: what the model itself bears out."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from tsplan.errors import SolverError
from tsplan.milp.model import Floats, Model
from tsplan.milp.solution import Options, Progress, Solution, Status, Watcher
from tsplan.process.watchdog import Watchdog
from tsplan.stopping import StoppedBy

TOLERANCE = 1e-5  # by which a point may violate the model
_CLOSED, _DIGITS = 1e-6, 1e-9  # a gap that is none, absolute and relative to the objective
_GAIN = 1e-6  # by which a point has to beat the cutoff, relative to it if that is more
_CERTAIN = 1e-6  # a start this close to the model refutes "infeasible"


@dataclass(frozen=True, eq=False)
class RawResult:
    """What a solver says at its end; `bound` None if it names none.

    `status` is its claim: OPTIMAL (nothing is better than its point, within the gaps asked for),
    INFEASIBLE, or UNKNOWN where it stopped before it knew, with a point or without.
    """

    status: Status
    values: Floats | None = None
    bound: float | None = None
    stopped_by: StoppedBy | None = None
    nodes: int = 0


@dataclass(frozen=True, eq=False)
class Request:
    """The model and options that a solver is given; `watch` hears of its progress."""

    model: Model
    options: Options = field(default_factory=Options)
    watch: Watcher | None = None
    began: float = field(default_factory=time.perf_counter)

    @property
    def elapsed(self) -> float:
        """Seconds since the request was made."""
        return time.perf_counter() - self.began

    @property
    def deadline(self) -> float | None:
        """When the time is up, as `time.perf_counter` counts; None for never."""
        limit = self.options.time_limit
        return None if limit is None else self.began + max(limit, 0.0)

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

    def rounded(self, values: Floats, tolerance: float = TOLERANCE) -> Floats | None:
        """The point with whole numbers in the integer columns; None if that does not fit the model.

        Where all numbers of a row are whole, the tolerance forgives it nothing.
        """
        values = np.asarray(values, dtype=np.float64)
        if values.shape != self.model.objective.shape or not np.isfinite(values).all():
            return None
        point = np.where(self.model.integer, np.round(values), values)
        return point if self.model.violation(point) <= tolerance else None

    def is_off(self, values: Floats) -> bool:
        """Whether a point fits the model as it is, and no more with its whole numbers rounded."""
        known = values.shape == self.model.objective.shape and bool(np.isfinite(values).all())
        fits = known and self.model.violation(values) <= TOLERANCE
        return fits and self.rounded(values) is None

    def solution(self, raw: RawResult, seconds: float) -> Solution:
        """The solution in common terms.

        Raises SolverError for a point that violates the model by more than 1e-5, and for a model
        called infeasible of which the start is a point.
        """
        start = self._start()
        found = self._checked(raw.values)
        # a best point that does not beat the cutoff means that none does
        beaten = raw.status is Status.OPTIMAL and found is None
        if raw.status is Status.INFEASIBLE or beaten:
            if start is not None:
                raise SolverError("the solver calls a model infeasible of which a point is known")
            return Solution(Status.INFEASIBLE, seconds=seconds, nodes=raw.nodes)
        raw = replace(raw, bound=self.true_bound(raw.bound))
        points = [point for point in (found, start) if point is not None]
        if points:
            return self._with_point(raw, min(points, key=self.objective), seconds)
        if raw.stopped_by is None:
            raise SolverError("the solver ended without a point and without a reason")
        return Solution(Status.UNKNOWN, raw.stopped_by, None, None, raw.bound, seconds, raw.nodes)

    def _start(self) -> Floats | None:
        start = self.options.start
        point = None if start is None else self.rounded(start, _CERTAIN)
        return point if point is not None and self.wanted(self.objective(point)) else None

    def _checked(self, values: Floats | None) -> Floats | None:
        """A solver's point, if it beats the cutoff."""
        if values is None:
            return None
        point = self.rounded(values)
        if point is None:
            raise SolverError("the solver returned a point that violates the model")
        return point if self.wanted(self.objective(point)) else None

    def _with_point(self, raw: RawResult, values: Floats, seconds: float) -> Solution:
        objective = self.objective(values)
        bound = self._believed(raw, objective)
        status, why = Status.FEASIBLE, raw.stopped_by
        distance = np.inf if bound is None else objective - bound
        if distance <= max(self.options.absolute_gap, _rounding(objective)):
            status, why = Status.OPTIMAL, None
        elif raw.status is Status.OPTIMAL:
            silent = raw.bound is None and self.options.gap > 0
            wanted = silent or distance <= self.options.gap * abs(objective)
            why = StoppedBy.GAP if wanted else StoppedBy.PRECISION
        silent = raw.bound is None and bool(self.model.integer.any())
        return Solution(status, why, values, objective, bound, seconds, raw.nodes, silent)

    def _believed(self, raw: RawResult, objective: float) -> float | None:
        """A solver's own bound, unless the point contradicts it.

        A solver that names none is held to the value of its point as it gave it.
        """
        bound = raw.bound
        if bound is None and raw.status is Status.OPTIMAL and self.options.gap <= 0:
            bound = objective if raw.values is None else self.objective(raw.values)
            bound = objective if abs(objective - bound) <= _rounding(objective) else bound
        if bound is None or bound > objective + _rounding(objective):
            return None
        return min(bound, objective)


def _rounding(objective: float) -> float:
    """Distances from an objective up to this are rounding."""
    return max(_CLOSED, _DIGITS * abs(objective))


@dataclass(eq=False)
class NativeRun:
    """One run of native code under a watchdog, whose news are heard in the calling thread.

    News are lines of the solver's log, or `(objective, bound, values)` with None for what is not
    known. The best point and bound are kept for a run that has to be left behind.
    """

    request: Request
    _best: Floats | None = field(default=None, init=False)
    _bound: float | None = field(default=None, init=False)

    def result(self, work: Callable[[Watchdog], RawResult], **watching: Any) -> RawResult:
        """What `work` returns, or what is known of work that came to no end of its own."""
        options, request = self.request.options, self.request
        asked = options.stop or (lambda: False)
        watchdog = Watchdog(
            **{
                "deadline": request.deadline,
                "asked": asked,
                "hear": self._hear,
                "grace": options.grace,
                **watching,
            }
        )
        try:
            ended = watchdog.run(lambda: work(watchdog))
        except MemoryError:
            return RawResult(Status.UNKNOWN, self._best, self._bound, StoppedBy.MEMORY)
        if ended is None:
            return RawResult(Status.UNKNOWN, self._best, self._bound, watchdog.stopped_by)
        raw = ended.result
        # a solver calls the watchdog's time limit an interrupt
        return replace(raw, stopped_by=watchdog.stopped_by or raw.stopped_by)

    def _hear(self, news: Any) -> bool:
        request, log = self.request, self.request.options.log
        if isinstance(news, str):
            if log is not None:
                for line in news.splitlines():
                    log(line)
            return False
        objective, bound, values = news
        point = None if values is None else request.rounded(values)
        if point is not None and request.wanted(request.objective(point)):
            self._best = point
        else:
            point = None
        self._bound = request.true_bound(bound)
        known = objective if objective is not None and request.wanted(objective) else None
        progress = Progress(known, self._bound, request.elapsed, point)
        return request.watch is not None and request.watch(progress)
