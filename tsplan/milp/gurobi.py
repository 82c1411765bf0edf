"""Gurobi, for those who have it: the optional extra `gurobi`.

The package from the registry carries a licence for small models only, so being installed and being
usable are two things; a model that is too large is refused before it is built.
"""

from __future__ import annotations

import time
from importlib.util import find_spec
from typing import Any

import numpy as np

from tsplan.errors import SolverError, SolverUnavailableError
from tsplan.milp.model import Model
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

_SMALL = 2000  # columns and rows that the licence in the package allows
_TOO_LARGE = 10010  # Gurobi's error number for a model over its licence's size
_REMEDY = "get a full licence from Gurobi (free for academics), or use --solver highs"


class Gurobi:
    """Solves models with gurobipy."""

    name = "gurobi"
    features = frozenset(
        {"start", "progress", "incumbents", "first", "log", "seed", "threads", "gap"}
    )

    def availability(self) -> Availability:
        """Installed if gurobipy is there; usable if an environment starts."""
        if find_spec("gurobipy") is None:
            remedy = "pip install 'tsplan[gurobi]'"
            return Availability(False, False, None, "gurobipy is not installed", remedy)
        import gurobipy  # noqa: PLC0415 - never imported unasked

        version = ".".join(str(part) for part in gurobipy.gurobi.version())
        try:
            with _environment():
                return Availability(True, True, version)
        except gurobipy.GurobiError as error:
            return Availability(True, False, version, f"its licence fails ({error})", _REMEDY)

    def native(self, model: Model) -> Any:
        """The model as a `gurobipy.Model`."""
        return _load(model, _environment())

    def solve(
        self, model: Model, options: Options | None = None, watch: Watcher | None = None
    ) -> Solution:
        """Minimise the model; see `tsplan.milp.solver.Solver`."""
        import gurobipy  # noqa: PLC0415 - never imported unasked

        options = options or Options()
        known = settled(model)
        if known is not None:
            return known
        began = time.perf_counter()
        try:
            with _environment() as environment, _load(model, environment) as native:
                _configure(native, options)
                native.optimize(_Callback(watch, options))
                return _read(native, model, options, time.perf_counter() - began)
        except gurobipy.GurobiError as error:
            if error.errno == _TOO_LARGE:
                size = f"{model.size.columns} columns and {model.size.rows} rows"
                raise SolverUnavailableError(
                    f"Gurobi's licence here is too small for {size} "
                    f"(it allows {_SMALL} of each); {_REMEDY}"
                ) from error
            raise SolverError(f"Gurobi failed: {error}") from error


def _environment() -> Any:
    import gurobipy  # noqa: PLC0415 - never imported unasked

    environment = gurobipy.Env(empty=True)
    environment.setParam("OutputFlag", 0)
    environment.start()
    return environment


def _load(model: Model, environment: Any) -> Any:
    import gurobipy  # noqa: PLC0415 - never imported unasked

    native = gurobipy.Model(env=environment)
    kinds = np.where(model.integer, gurobipy.GRB.INTEGER, gurobipy.GRB.CONTINUOUS)
    x = native.addMVar(
        model.size.columns, lb=model.lower, ub=model.upper, obj=model.objective, vtype=kinds
    )
    native.ModelSense = gurobipy.GRB.MINIMIZE
    native.ObjCon = model.offset
    same = model.row_lower == model.row_upper
    for rows, sense, side in (
        (same, "=", model.row_lower),
        (~same & np.isfinite(model.row_lower), ">", model.row_lower),
        (~same & np.isfinite(model.row_upper), "<", model.row_upper),
    ):
        if rows.any() and model.size.columns:
            part: Any = model.matrix[np.flatnonzero(rows)]  # gurobipy's stubs know no sparse arrays
            native.addMConstr(part, x, sense, side[rows])
    native.update()
    return native


def _configure(native: Any, options: Options) -> None:
    native.Params.MIPGap = options.gap
    native.Params.MIPGapAbs = max(options.absolute_gap, 1e-6)
    asked = {
        "TimeLimit": options.time_limit,
        "Threads": options.threads,
        "Seed": options.seed,
        "SolutionLimit": 1 if options.first else None,
        "Cutoff": options.cutoff,
        **options.extra,
    }
    for name, value in asked.items():
        if value is not None:
            native.setParam(name, value)
    if options.start is not None:
        native.setAttr("Start", native.getVars(), options.start.tolist())
    if options.log is not None:
        native.Params.OutputFlag = 1
        native.Params.LogToConsole = 0
    # tell infeasible and unbounded models apart
    native.Params.DualReductions = 0


class _Callback:
    """Passes progress and log lines on; asks Gurobi to stop when the watcher does."""

    def __init__(self, watch: Watcher | None, options: Options) -> None:
        self._watch = watch
        self._log = options.log

    def __call__(self, model: Any, where: int) -> None:
        from gurobipy import GRB  # noqa: PLC0415 - never imported unasked

        if where == GRB.Callback.MESSAGE and self._log is not None:
            self._log(model.cbGet(GRB.Callback.MSG_STRING).rstrip("\n"))
        if self._watch is None:
            return
        if where == GRB.Callback.MIPSOL:
            values = np.array(model.cbGetSolution(model.getVars()))
            best, bound = GRB.Callback.MIPSOL_OBJ, GRB.Callback.MIPSOL_OBJBND
        elif where == GRB.Callback.MIP:
            values = None
            best, bound = GRB.Callback.MIP_OBJBST, GRB.Callback.MIP_OBJBND
        else:
            return
        ends = [model.cbGet(best), model.cbGet(bound)]
        shown = [end if abs(end) < GRB.INFINITY else None for end in ends]
        elapsed = model.cbGet(GRB.Callback.RUNTIME)
        if self._watch(Progress(shown[0], shown[1], elapsed, values)):
            model.terminate()


def _read(native: Any, model: Model, options: Options, seconds: float) -> Solution:
    from gurobipy import GRB  # noqa: PLC0415 - never imported unasked

    ended, nodes = native.Status, int(native.NodeCount)
    if ended in (GRB.INFEASIBLE, GRB.CUTOFF):
        return Solution(Status.INFEASIBLE, seconds=seconds, nodes=nodes)
    if ended in (GRB.UNBOUNDED, GRB.INF_OR_UNBD):
        raise SolverError("the model is unbounded: its objective can fall without end")
    stopped = {GRB.TIME_LIMIT: StoppedBy.TIME_LIMIT, GRB.MEM_LIMIT: StoppedBy.MEMORY}.get(
        ended, StoppedBy.INTERRUPT
    )
    bound = float(native.ObjBound) if abs(native.ObjBound) < GRB.INFINITY else None
    if not native.SolCount:
        return Solution(Status.UNKNOWN, stopped, None, None, bound, seconds, nodes)
    values = np.array([variable.X for variable in native.getVars()])
    values = np.where(model.integer, np.round(values), values)
    objective = float(model.objective @ values) + model.offset
    if ended == GRB.OPTIMAL:
        shown = objective if bound is None else min(bound, objective)
        closed = options.gap <= 0 or objective - shown <= max(options.absolute_gap, 1e-6)
        status, why = (Status.OPTIMAL, None) if closed else (Status.FEASIBLE, StoppedBy.GAP)
        return Solution(status, why, values, objective, shown, seconds, nodes)
    why = None if ended == GRB.SOLUTION_LIMIT else stopped
    return Solution(Status.FEASIBLE, why, values, objective, bound, seconds, nodes)
