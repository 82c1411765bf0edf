"""Gurobi, for those who have it: the optional extra `gurobi`.

The package from the registry carries a licence for small models only, so being installed and being
usable are two things; a model that is too large is refused in words.
"""

from __future__ import annotations

import signal
from collections.abc import Callable, Sequence
from importlib.util import find_spec
from typing import Any

import numpy as np

from tsplan.errors import SolverError, SolverUnavailableError, nearest
from tsplan.milp.model import Bools, Floats, Model
from tsplan.milp.request import NativeRun, RawResult, Request
from tsplan.milp.solution import Options, Status
from tsplan.milp.solver import Availability, Solver
from tsplan.process.quiet_output import hushed
from tsplan.process.watchdog import Watchdog
from tsplan.stopping import StoppedBy

_SMALL = 2000  # columns and rows that the licence in the package allows
_TOO_LARGE = 10010  # Gurobi's error number for a model over its licence's size
_LEAST_GAP = 1e-6
_INSTALL = "pip install 'tsplan[gurobi]'"
_REMEDY = "get a full licence from Gurobi (free for academics), or use --solver highs"


class Gurobi(Solver):
    """Solves models with gurobipy."""

    name = "gurobi"

    def availability(self) -> Availability:
        """Installed if gurobipy is there; usable if an environment starts."""
        if find_spec("gurobipy") is None:
            return Availability(False, None, "gurobipy is not installed", _INSTALL)
        try:
            with hushed():
                import gurobipy  # noqa: PLC0415 - never imported unasked
        except ImportError as error:
            return Availability(True, None, f"gurobipy cannot be imported ({error})", _INSTALL)
        version = ".".join(str(part) for part in gurobipy.gurobi.version())
        try:
            with _environment():
                return Availability(True, version)
        except gurobipy.GurobiError as error:
            return Availability(True, version, f"its licence fails ({error})", _REMEDY)

    def native(self, model: Model) -> Any:
        """The model as a `gurobipy.Model`."""
        return _load(model, _environment())

    def named(self, model: Model, columns: Sequence[str], rows: Sequence[str]) -> Any:
        """The model as a `gurobipy.Model` with names; both sides of a row have its name."""
        native = self.native(model)
        native.setAttr("VarName", native.getVars(), list(columns))
        numbers = np.concatenate([np.flatnonzero(chosen) for chosen, _, _ in _sides(model)])
        ordered = [rows[number] for number in numbers.tolist()]
        native.setAttr("ConstrName", native.getConstrs(), ordered[: native.NumConstrs])
        native.update()
        return native

    def point(self, native: Any) -> Floats:
        """The best point of a solved `gurobipy.Model`."""
        if not native.SolCount:
            raise SolverError("Gurobi has no point of the model; optimise it first")
        return np.array(native.getAttr("X", native.getVars()))

    def answer(self, request: Request) -> RawResult:
        """What Gurobi makes of a request; see `tsplan.milp.solver.Solver`."""
        gurobipy = _imported()
        try:
            return NativeRun(request).result(lambda watchdog: _solved(request, watchdog))
        except (gurobipy.GurobiError, TypeError) as error:
            raise _refusal(error, request.model, request.options) from error


def _solved(request: Request, watchdog: Watchdog) -> RawResult:
    """What Gurobi says at its end; all is done in the calling thread, which also disposes of it."""
    grb = _imported().GRB
    with _environment() as environment, _load(request.model, environment) as native:
        _configure(native, request.options)
        watched = _callback(watchdog, grb, quiet=request.watch is None)
        native.optimize(watched)
        if native.Status == grb.INF_OR_UNBD:
            native.Params.DualReductions = 0
            native.optimize(watched)
        if native.Status in (grb.UNBOUNDED, grb.INF_OR_UNBD):
            # a ray says nothing about points: ask for one
            native.setAttr("Obj", native.getVars(), [0.0] * native.NumVars)
            native.Params.Cutoff = grb.INFINITY
            native.optimize(watched)
            if native.SolCount:
                raise SolverError("the model is unbounded: its objective can fall without end")
        raw = _read(native, grb)
    if raw.stopped_by is StoppedBy.INTERRUPT and not watchdog.stopping:
        _pass_interrupt_on()
    return raw


def _callback(watchdog: Watchdog, grb: Any, *, quiet: bool) -> Callable[[Any, int], None]:
    """Tells the watchdog what Gurobi tells, and Gurobi to stop when the watchdog says so."""
    where = grb.Callback

    def tell(model: Any, objective: int, bound: int, values: Any) -> None:
        ends = (_finite(model.cbGet(what), grb) for what in (objective, bound))
        watchdog.tell((*ends, values))

    def hear(model: Any, now: int) -> None:
        if watchdog.stopping:
            model.terminate()
        if now == where.MESSAGE:
            watchdog.tell(model.cbGet(where.MSG_STRING))
        elif now == where.MIPSOL:
            values = np.array(model.cbGetSolution(model.getVars()))
            tell(model, where.MIPSOL_OBJ, where.MIPSOL_OBJBND, values)
        elif now == where.MIP and not quiet:
            tell(model, where.MIP_OBJBST, where.MIP_OBJBND, None)

    return hear


def _finite(value: float, grb: Any) -> float | None:
    return value if abs(value) < grb.INFINITY else None


def _pass_interrupt_on() -> None:
    """Gurobi catches Ctrl-C itself; a handler of the program's own has to hear of it too."""
    handler = signal.getsignal(signal.SIGINT)
    if callable(handler) and handler is not signal.default_int_handler:
        signal.raise_signal(signal.SIGINT)


def _imported() -> Any:
    """The module gurobipy. Raises SolverUnavailableError where it is missing."""
    try:
        with hushed():
            import gurobipy  # noqa: PLC0415 - never imported unasked
    except ImportError as error:
        raise SolverUnavailableError(f"gurobipy is not installed; {_INSTALL}") from error
    return gurobipy


def _refusal(error: Any, model: Model, options: Options) -> SolverError:
    """What a GurobiError means for the user."""
    if getattr(error, "errno", 0) == _TOO_LARGE:
        size = f"{model.size.columns} columns and {model.size.rows} rows"
        return SolverUnavailableError(
            f"Gurobi's licence here is too small for {size} "
            f"(it allows about {_SMALL} of each); {_REMEDY}"
        )
    known = [word for word in dir(_imported().GRB.Param) if not word.startswith("_")]
    for name in options.extra:
        if name not in known:
            return SolverError(f"Gurobi has no parameter '{name}'; {nearest(name, known)}")
    return SolverError(f"Gurobi failed: {error}")


def _environment() -> Any:
    gurobipy = _imported()
    with hushed():  # an environment tells of its licence when it starts
        environment = gurobipy.Env(empty=True)
        environment.setParam("OutputFlag", 0)
        environment.start()
    return environment


def _load(model: Model, environment: Any) -> Any:
    gurobipy = _imported()
    native = gurobipy.Model(env=environment)
    kinds = np.where(model.integer, gurobipy.GRB.INTEGER, gurobipy.GRB.CONTINUOUS)
    x = native.addMVar(
        model.size.columns, lb=model.lower, ub=model.upper, obj=model.objective, vtype=kinds
    )
    native.ModelSense = gurobipy.GRB.MINIMIZE
    native.ObjCon = model.offset
    for rows, sense, side in _sides(model):
        if rows.any() and model.size.columns:
            native.addMConstr(model.matrix[np.flatnonzero(rows)], x, sense, side[rows])
    native.update()
    return native


def _sides(model: Model) -> tuple[tuple[Bools, str, Floats], ...]:
    """Which rows become constraints of which sense, in their order; of some, either side does."""
    same = model.row_lower == model.row_upper
    return (
        (same, "=", model.row_lower),
        (~same & np.isfinite(model.row_lower), ">", model.row_lower),
        (~same & np.isfinite(model.row_upper), "<", model.row_upper),
    )


def _configure(native: Any, options: Options) -> None:
    asked = {
        "MIPGap": options.gap,
        "MIPGapAbs": max(options.absolute_gap, _LEAST_GAP),
        "TimeLimit": None if options.time_limit is None else max(options.time_limit, 0.0),
        "Threads": options.threads,
        "Seed": options.seed,
        "SolutionLimit": 1 if options.first else None,
        "Cutoff": options.cutoff,
        "Presolve": None if options.presolve else 0,
        "LogToConsole": 0,
        "OutputFlag": 0 if options.log is None else 1,
        **options.extra,
    }
    for name, value in asked.items():
        if value is not None:
            native.setParam(name, value)
    if options.start is not None:
        native.setAttr("Start", native.getVars(), np.asarray(options.start).tolist())


def _read(native: Any, grb: Any) -> RawResult:
    """What Gurobi says at its end."""
    ends: dict[int, tuple[Status, StoppedBy | None]] = {
        grb.OPTIMAL: (Status.OPTIMAL, None),
        grb.INFEASIBLE: (Status.INFEASIBLE, None),
        grb.CUTOFF: (Status.INFEASIBLE, None),
        grb.SOLUTION_LIMIT: (Status.UNKNOWN, None),
        grb.TIME_LIMIT: (Status.UNKNOWN, StoppedBy.TIME_LIMIT),
        grb.INTERRUPTED: (Status.UNKNOWN, StoppedBy.INTERRUPT),
        grb.MEM_LIMIT: (Status.UNKNOWN, StoppedBy.MEMORY),
    }
    ended = native.Status
    if ended not in ends:
        raise SolverError(f"Gurobi could not solve the model (status {ended})")
    claim, why = ends[ended]
    values = np.array(native.getAttr("X", native.getVars())) if native.SolCount else None
    bound = _finite(float(native.ObjBound), grb) if native.IsMIP else None
    return RawResult(claim, values, bound, why, int(native.NodeCount))
