"""HiGHS, the default solver.

Every solve runs in a fresh thread. HiGHS keeps its workers per calling thread and refuses another
number of them there, so a fresh thread is also what lets `threads` differ from solve to solve.
"""

from __future__ import annotations

import time
from collections.abc import Sequence
from typing import Any

import numpy as np

from tsplan.errors import SolverError, nearest
from tsplan.milp.model import Floats, Model
from tsplan.milp.request import NativeRun, RawResult, Request
from tsplan.milp.solution import Options, Status
from tsplan.milp.solver import Availability, Solver
from tsplan.process.quiet_output import Hear, hushed
from tsplan.process.watchdog import Watchdog
from tsplan.stopping import StoppedBy

with hushed():
    import highspy
    from highspy import HighsModelStatus as Ended

_LEAST_GAP = 1e-6
_AGGREGATOR = 1 << 12  # among the bits of HiGHS' option presolve_rule_off
_UNCLEAR = (Ended.kUnboundedOrInfeasible, Ended.kUnbounded)
_ENDS: dict[Ended, tuple[Status, StoppedBy | None]] = {
    Ended.kOptimal: (Status.OPTIMAL, None),
    Ended.kModelEmpty: (Status.OPTIMAL, None),
    Ended.kInfeasible: (Status.INFEASIBLE, None),
    Ended.kObjectiveBound: (Status.INFEASIBLE, None),
    Ended.kSolutionLimit: (Status.UNKNOWN, None),
    Ended.kTimeLimit: (Status.UNKNOWN, StoppedBy.TIME_LIMIT),
    Ended.kInterrupt: (Status.UNKNOWN, StoppedBy.INTERRUPT),
    Ended.kMemoryLimit: (Status.UNKNOWN, StoppedBy.MEMORY),
    **dict.fromkeys(_UNCLEAR, (Status.UNKNOWN, None)),
}


def silent(log: Hear | None = None) -> highspy.Highs:
    """An empty HiGHS object that writes nothing; what it writes all the same goes to `log`."""
    with hushed(log):
        highs = highspy.Highs()
        checked(highs.setOptionValue("output_flag", False), "output_flag")
    return highs


def load(model: Model, *, relaxed: bool = False, log: Hear | None = None) -> highspy.Highs:
    """A silent HiGHS object that holds the model (its LP relaxation if `relaxed`)."""
    highs = silent(log)
    rows, columns = model.matrix.shape
    whole = np.zeros(columns, np.int32) if relaxed else model.integer.astype(np.int32)
    status = highs.passModel(
        columns,
        rows,
        model.matrix.nnz,
        int(highspy.MatrixFormat.kRowwise),
        int(highspy.ObjSense.kMinimize),
        float(model.offset),
        np.ascontiguousarray(model.objective, dtype=np.float64),
        np.ascontiguousarray(model.lower, dtype=np.float64),
        np.ascontiguousarray(model.upper, dtype=np.float64),
        np.ascontiguousarray(model.row_lower, dtype=np.float64),
        np.ascontiguousarray(model.row_upper, dtype=np.float64),
        model.matrix.indptr.astype(np.int32),
        model.matrix.indices.astype(np.int32),
        np.ascontiguousarray(model.matrix.data, dtype=np.float64),
        whole,
    )
    checked(status, "the model")
    return highs


def rules_off(model: Model) -> int:
    """What HiGHS is to leave out when it presolves a model, as its option `presolve_rule_off`.

    The aggregator of HiGHS 1.15 loses points of mixed models: some it calls infeasible, of others
    it calls a point optimal that is not (tests/models). Without it points of models that are not in
    whole numbers fit less well, by up to 1e-5, which is why those keep it.
    """
    numbers = model.matrix.data
    return _AGGREGATOR if np.array_equal(numbers, np.round(numbers)) else 0


def checked(status: highspy.HighsStatus, what: str) -> None:
    """Raise SolverError where HiGHS reports an error by return code only."""
    if status == highspy.HighsStatus.kError:
        raise SolverError(f"HiGHS refused {what}")


class Highs(Solver):
    """Solves models with HiGHS."""

    name = "highs"

    def availability(self) -> Availability:
        """HiGHS comes with tsplan."""
        return Availability(version=silent().version())

    def native(self, model: Model) -> highspy.Highs:
        """The model as a `highspy.Highs`."""
        return load(model)

    def named(self, model: Model, columns: Sequence[str], rows: Sequence[str]) -> highspy.Highs:
        """The model as a `highspy.Highs` with names."""
        native = self.native(model)
        for number, name in enumerate(columns):
            checked(native.passColName(number, name), f"the name {name}")
        for number, name in enumerate(rows):
            checked(native.passRowName(number, name), f"the name {name}")
        return native

    def point(self, native: highspy.Highs) -> Floats:
        """The point of a solved `highspy.Highs`."""
        info = native.getInfo()
        if info.primal_solution_status != int(highspy.SolutionStatus.kSolutionStatusFeasible):
            raise SolverError("HiGHS has no point of the model; run it first")
        return np.array(native.getSolution().col_value)

    def option_names(self) -> list[str]:
        """HiGHS' own names of its options."""
        return option_names()

    def answer(self, request: Request) -> RawResult:
        """What HiGHS makes of a request; see `tsplan.milp.solver.Solver`."""
        options = request.options
        # HiGHS counts points above its bound as found, so a first point needs a row
        strict = options.first and options.cutoff is not None
        highs = load(request.cut() if strict else request.model, log=options.log)
        _configure(highs, request)
        return NativeRun(request).result(lambda watchdog: _solved(highs, request, watchdog))


def _solved(highs: highspy.Highs, request: Request, watchdog: Watchdog) -> RawResult:
    """What HiGHS says at its end; infeasible and unbounded are told apart."""
    _subscribe(highs, watchdog, request.options)
    raw = _run(highs, request)
    if highs.getModelStatus() in _UNCLEAR:  # presolve cannot tell them apart
        set_option(highs, "presolve", "off")
        raw = _run(highs, request)
    if highs.getModelStatus() in _UNCLEAR:  # nor can branching
        size = request.model.size.columns
        every = np.arange(size, dtype=np.int32)
        checked(highs.changeColsCost(size, every, np.zeros(size)), "a zero objective")
        set_option(highs, "objective_bound", highspy.kHighsInf)
        raw = _run(highs, request)
        if raw.values is not None:
            raise SolverError("the model is unbounded: its objective can fall without end")
    highs.clearCallbacks()
    return raw


def _run(highs: highspy.Highs, request: Request) -> RawResult:
    """Run HiGHS once, in the time that is left."""
    if request.deadline is not None:
        # HiGHS counts the seconds of all its runs together
        left = max(request.deadline - time.perf_counter(), 0.0)
        set_option(highs, "time_limit", highs.getRunTime() + left)
    try:
        status = highs.run()
    except RuntimeError as error:
        raise SolverError(f"HiGHS failed: {error}") from error
    ended = highs.getModelStatus()
    if status == highspy.HighsStatus.kError:
        raise SolverError(f"HiGHS ended with an error: {highs.modelStatusToString(ended)}")
    if ended not in _ENDS:
        words = highs.modelStatusToString(ended)
        raise SolverError(f"HiGHS could not solve the model: {words}")
    claim, why = _ENDS[ended]
    info = highs.getInfo()
    known = info.primal_solution_status == int(highspy.SolutionStatus.kSolutionStatusFeasible)
    known = known and ended not in _UNCLEAR
    values = np.array(highs.getSolution().col_value) if known else None
    bound = finite(info.mip_dual_bound) if request.model.integer.any() else None
    return RawResult(claim, values, bound, why, max(int(info.mip_node_count), 0))


def set_option(highs: highspy.Highs, name: str, value: object) -> None:
    """Set one option; SolverError names the nearest option where HiGHS knows none of the name."""
    if highs.getOptionType(name)[0] == highspy.HighsStatus.kError:
        raise SolverError(f"HiGHS has no option '{name}'; {nearest(name, option_names())}")
    try:
        checked(highs.setOptionValue(name, value), f"option {name} = {value}")
    except TypeError:
        raise SolverError(f"HiGHS refused option {name} = {value!r}") from None


def option_names() -> list[str]:
    """HiGHS' own names of its options."""
    return [word for word in dir(highspy.HighsOptions()) if not word.startswith("_")]


def finite(value: float) -> float | None:
    """The number, or None for what HiGHS takes as infinite."""
    return float(value) if abs(value) < highspy.kHighsInf else None


def _configure(highs: highspy.Highs, request: Request) -> None:
    options = request.options
    asked = {
        "mip_rel_gap": float(options.gap),
        "mip_abs_gap": max(float(options.absolute_gap), _LEAST_GAP),
        "random_seed": options.seed,
        "mip_max_improving_sols": 1 if options.first else None,
        "objective_bound": options.cutoff,
        "threads": options.threads,
        "log_to_console": False,
        "output_flag": options.log is not None,
        "presolve": None if options.presolve else "off",
        "presolve_rule_off": rules_off(request.model),
        **options.extra,
    }
    for name, value in asked.items():
        if value is not None:
            set_option(highs, name, value)
    if options.start is not None:
        point = highspy.HighsSolution()
        point.col_value = np.asarray(options.start, dtype=np.float64).tolist()
        checked(highs.setSolution(point), "the start")


def _subscribe(highs: highspy.Highs, watchdog: Watchdog, options: Options) -> None:
    """Let the watchdog hear of the run, and stop it."""

    def interrupt(event: Any) -> None:
        if watchdog.stopping:
            event.interrupt()

    def told(event: Any, values: Floats | None = None) -> None:
        data = event.data_out
        watchdog.tell((finite(data.mip_primal_bound), finite(data.mip_dual_bound), values))

    highs.cbMipImprovingSolution += lambda event: told(event, np.array(event.data_out.mip_solution))
    highs.cbMipLogging += told
    for callback in (highs.cbMipInterrupt, highs.cbSimplexInterrupt, highs.cbIpmInterrupt):
        callback.subscribe(interrupt)
    if options.log is not None:
        highs.cbLogging += lambda event: watchdog.tell(event.message)
