"""HiGHS, the default solver.

The solve runs in a thread of its own while the calling thread waits, so that a wall-clock watchdog,
Ctrl-C and a watcher's wish to stop all work in the same way: ask HiGHS to stop, keep the incumbent.
"""

from __future__ import annotations

import time
from dataclasses import dataclass, field
from threading import Event, Thread
from typing import Any

import highspy
import numpy as np
from highspy import HighsModelStatus as Ended

from tsplan.errors import SolverError
from tsplan.milp.model import Floats, Model
from tsplan.milp.solution import (
    Options,
    Progress,
    Solution,
    Status,
    StoppedBy,
    Watcher,
    settled,
)
from tsplan.milp.solver import Availability

_INTEGER = int(highspy.HighsVarType.kInteger)
_TOLERANCE = 1e-5
_POLL = 0.05  # seconds between looks at the clock
_STOPPED = {
    Ended.kTimeLimit: StoppedBy.TIME_LIMIT,
    Ended.kInterrupt: StoppedBy.INTERRUPT,
    Ended.kMemoryLimit: StoppedBy.MEMORY,
}


def load(model: Model, *, relaxed: bool = False) -> highspy.Highs:
    """A silent HiGHS object that holds the model (its LP relaxation if `relaxed`)."""
    highs = highspy.Highs()
    checked(highs.setOptionValue("output_flag", False), "output_flag")
    problem = highspy.HighsLp()
    rows, columns = model.matrix.shape
    problem.num_col_, problem.num_row_ = columns, rows
    problem.col_cost_, problem.offset_ = model.objective, model.offset
    problem.col_lower_, problem.col_upper_ = model.lower, model.upper
    problem.row_lower_, problem.row_upper_ = model.row_lower, model.row_upper
    problem.a_matrix_.format_ = highspy.MatrixFormat.kRowwise
    problem.a_matrix_.num_col_, problem.a_matrix_.num_row_ = columns, rows
    problem.a_matrix_.start_ = model.matrix.indptr.astype(np.int32)
    problem.a_matrix_.index_ = model.matrix.indices.astype(np.int32)
    problem.a_matrix_.value_ = model.matrix.data
    checked(highs.passModel(problem), "the model")
    whole = np.flatnonzero(model.integer).astype(np.int32)
    if len(whole) and not relaxed:
        kinds = np.full(len(whole), _INTEGER, dtype=np.uint8)
        checked(highs.changeColsIntegrality(len(whole), whole, kinds), "integrality")
    return highs


def checked(status: highspy.HighsStatus, what: str) -> None:
    """Raise SolverError where HiGHS reports an error by return code only."""
    if status == highspy.HighsStatus.kError:
        raise SolverError(f"HiGHS refused {what}")


@dataclass(eq=False)
class _Watched:
    """Passes a running solve's progress on, and remembers that it should stop."""

    watch: Watcher | None
    began: float
    stop: bool = field(default=False)

    def event(self, event: Any) -> None:
        data = event.data_out
        values = None
        if event.callback_type == highspy.cb.HighsCallbackType.kCallbackMipImprovingSolution:
            values = np.array(data.mip_solution)
        progress = Progress(
            objective=_finite(data.mip_primal_bound),
            bound=_finite(data.mip_dual_bound),
            elapsed=time.perf_counter() - self.began,
            values=values,
        )
        if self.watch is not None and self.watch(progress):
            self.stop = True

    def interrupt(self, event: Any) -> None:
        if self.stop:
            event.interrupt()


class Highs:
    """Solves models with HiGHS."""

    name = "highs"
    features = frozenset(
        {"start", "progress", "incumbents", "first", "log", "seed", "threads", "gap"}
    )

    def availability(self) -> Availability:
        """HiGHS comes with tsplan."""
        return Availability(installed=True, usable=True, version=highspy.Highs().version())

    def native(self, model: Model) -> highspy.Highs:
        """The model as a `highspy.Highs`."""
        return load(model)

    def solve(
        self, model: Model, options: Options | None = None, watch: Watcher | None = None
    ) -> Solution:
        """Minimise the model; see `tsplan.milp.solver.Solver`."""
        options = options or Options()
        began = time.perf_counter()
        known = settled(model)
        if known is not None:
            return known
        highs = load(model)
        _configure(highs, options)
        if options.start is not None:
            point = highspy.HighsSolution()
            point.col_value = options.start.tolist()
            highs.setSolution(point)
        watched = _Watched(watch, began)
        _subscribe(highs, watched, options)
        limit = options.time_limit
        _run(highs, watched, None if limit is None else began + limit)
        if highs.getModelStatus() == Ended.kUnboundedOrInfeasible:
            checked(highs.setOptionValue("presolve", "off"), "presolve")
            _run(highs, watched, None if limit is None else began + limit)
        return _read(highs, model, options, time.perf_counter() - began)


def _configure(highs: highspy.Highs, options: Options) -> None:
    asked: dict[str, object] = {
        "mip_rel_gap": options.gap,
        "mip_abs_gap": max(options.absolute_gap, 1e-6),
    }
    if options.time_limit is not None:
        asked["time_limit"] = max(float(options.time_limit), 0.0)
    if options.seed is not None:
        asked["random_seed"] = options.seed
    if options.first:
        asked["mip_max_improving_sols"] = 1
    if options.cutoff is not None:
        asked["objective_bound"] = options.cutoff
    if options.threads is not None:
        # a process keeps its first number of threads until the scheduler is made anew
        highspy.Highs.resetGlobalScheduler(True)
        asked["threads"] = options.threads
    for name, value in {**asked, **options.extra}.items():
        checked(highs.setOptionValue(name, value), f"option {name} = {value}")


def _subscribe(highs: highspy.Highs, watched: _Watched, options: Options) -> None:
    if watched.watch is not None:
        highs.cbMipImprovingSolution += watched.event
        highs.cbMipLogging += watched.event
    highs.cbMipInterrupt += watched.interrupt
    highs.cbSimplexInterrupt += watched.interrupt
    highs.cbIpmInterrupt += watched.interrupt
    log = options.log
    if log is not None:
        checked(highs.setOptionValue("output_flag", True), "output_flag")
        checked(highs.setOptionValue("log_to_console", False), "log_to_console")
        highs.cbLogging += lambda event: log(event.message.rstrip("\n"))


def _run(highs: highspy.Highs, watched: _Watched, deadline: float | None) -> None:
    """Run in a thread; ask it to stop when the time is up or on Ctrl-C."""
    outcome: list[highspy.HighsStatus] = []
    # an event and not `join`: a join that Ctrl-C breaks off takes the thread for ended
    done = Event()

    def work() -> None:
        try:
            outcome.append(highs.run())
        finally:
            done.set()

    Thread(target=work, daemon=True).start()
    while not done.is_set():
        try:
            done.wait(_POLL)
            if deadline is not None and time.perf_counter() > deadline:
                watched.stop = True
        except KeyboardInterrupt:
            watched.stop = True
            if watched.watch is not None:
                watched.watch(Progress(None, None, time.perf_counter() - watched.began))
    if not outcome or outcome[0] == highspy.HighsStatus.kError:
        raise SolverError("HiGHS ended with an error")


def _read(highs: highspy.Highs, model: Model, options: Options, seconds: float) -> Solution:
    ended = highs.getModelStatus()
    info = highs.getInfo()
    nodes = max(int(info.mip_node_count), 0)
    if ended == Ended.kInfeasible:
        return Solution(Status.INFEASIBLE, seconds=seconds, nodes=nodes)
    if ended in (Ended.kUnbounded, Ended.kUnboundedOrInfeasible):
        raise SolverError("the model is unbounded: its objective can fall without end")
    whole = bool(model.integer.any())
    bound = _finite(info.mip_dual_bound) if whole else None
    if info.primal_solution_status != int(highspy.SolutionStatus.kSolutionStatusFeasible):
        stopped = _stopped(ended, options, seconds)
        return Solution(Status.UNKNOWN, stopped, None, None, bound, seconds, nodes)
    values = _whole(np.array(highs.getSolution().col_value), model)
    objective = float(model.objective @ values) + model.offset
    if ended == Ended.kOptimal:
        shown = objective if bound is None else min(bound, objective)
        closed = options.gap <= 0 or objective - shown <= max(options.absolute_gap, 1e-6)
        status, why = (Status.OPTIMAL, None) if closed else (Status.FEASIBLE, StoppedBy.GAP)
        return Solution(status, why, values, objective, shown, seconds, nodes)
    why = None if ended == Ended.kSolutionLimit else _stopped(ended, options, seconds)
    return Solution(Status.FEASIBLE, why, values, objective, bound, seconds, nodes)


def _stopped(ended: Ended, options: Options, seconds: float) -> StoppedBy:
    """What stopped the solve; the watchdog's interrupt is the time limit's."""
    late = options.time_limit is not None and seconds >= options.time_limit - _POLL
    if late:
        return StoppedBy.TIME_LIMIT
    return _STOPPED.get(ended, StoppedBy.INTERRUPT)


def _whole(values: Floats, model: Model) -> Floats:
    """Integer columns rounded where that keeps the point feasible; SolverError if none is."""
    rounded = np.where(model.integer, np.round(values), values)
    if model.violation(rounded) <= _TOLERANCE:
        return rounded
    if model.violation(values) <= _TOLERANCE:
        return values
    raise SolverError("HiGHS returned a point that violates the model")


def _finite(value: float) -> float | None:
    return float(value) if abs(value) < highspy.kHighsInf else None
