"""Gurobi, for those who have it: the optional extra `gurobi`.

The package from the registry carries a licence for small models only, so being installed and being
usable are two things; a model that is too large is refused in words.
"""

from __future__ import annotations

import signal
import time
from dataclasses import dataclass, field
from importlib.util import find_spec
from typing import Any

import numpy as np

from tsplan.errors import SolverError, SolverUnavailableError, nearest
from tsplan.milp.model import Model
from tsplan.milp.quiet_output import hushed
from tsplan.milp.solution import Options, Progress, Solution, Watcher, settled
from tsplan.milp.solver import Availability
from tsplan.milp.verdict import Ending, Question, Verdict
from tsplan.milp.watchdog import Attendant
from tsplan.stopping import StoppedBy

_SMALL = 2000  # columns and rows that the licence in the package allows
_TOO_LARGE = 10010  # Gurobi's error number for a model over its licence's size
_LEAST_GAP = 1e-6
_INSTALL = "pip install 'tsplan[gurobi]'"
_REMEDY = "get a full licence from Gurobi (free for academics), or use --solver highs"


class Gurobi:
    """Solves models with gurobipy."""

    name = "gurobi"
    features = frozenset(
        {
            *("start", "progress", "incumbents", "first", "log"),
            *("seed", "threads", "gap", "cutoff", "presolve"),
        }
    )

    def availability(self) -> Availability:
        """Installed if gurobipy is there; usable if an environment starts."""
        if find_spec("gurobipy") is None:
            return Availability(
                installed=False, usable=False, why="gurobipy is not installed", remedy=_INSTALL
            )
        try:
            with hushed():
                import gurobipy  # noqa: PLC0415 - never imported unasked
        except ImportError as error:
            why = f"gurobipy cannot be imported ({error})"
            return Availability(installed=True, usable=False, why=why, remedy=_INSTALL)
        version = ".".join(str(part) for part in gurobipy.gurobi.version())
        try:
            with _environment():
                return Availability(installed=True, usable=True, version=version)
        except gurobipy.GurobiError as error:
            why = f"its licence fails ({error})"
            return Availability(
                installed=True, usable=False, version=version, why=why, remedy=_REMEDY
            )

    def native(self, model: Model) -> Any:
        """The model as a `gurobipy.Model`."""
        _imported()
        return _load(model, _environment())

    def solve(
        self, model: Model, options: Options | None = None, watch: Watcher | None = None
    ) -> Solution:
        """Minimise the model; see `tsplan.milp.solver.Solver`."""
        gurobipy = _imported()
        began = time.perf_counter()
        options = options or Options()
        known = settled(model)
        if known is not None:
            return known
        question = Question(model, options)
        try:
            said = _Solve(question, watch, began).ending()
        except (gurobipy.GurobiError, TypeError) as error:
            raise _refusal(error, model, options) from error
        return question.answer(said, time.perf_counter() - began)


@dataclass(eq=False)
class _Solve:
    """One solve; everything native happens in one thread, which also disposes of it."""

    question: Question
    watch: Watcher | None
    began: float
    _said: Ending = field(default=Ending(Verdict.ENDED), init=False)
    _best: Any = field(default=None, init=False)
    _bound: float | None = field(default=None, init=False)

    def ending(self) -> Ending:
        options = self.question.options
        limit = options.time_limit
        deadline = None if limit is None else self.began + max(limit, 0.0)
        attendant = Attendant(deadline, self._hear, options.stop or (lambda: False))
        try:
            ended = attendant.run(lambda: self._work(attendant))
        except MemoryError:
            return Ending(Verdict.ENDED, self._best, self._bound, StoppedBy.MEMORY)
        if not ended:
            return Ending(Verdict.ENDED, self._best, self._bound, attendant.stopped_by)
        if self._said.stopped_by is StoppedBy.INTERRUPT and not attendant.stopping:
            _pass_interrupt_on()
        return self._said

    def _work(self, attendant: Attendant) -> None:
        grb = _imported().GRB
        with _environment() as environment, _load(self.question.model, environment) as native:
            _configure(native, self.question.options)
            watched = _Callback(attendant, grb, quiet=self.watch is None)
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
            self._said = _read(native, grb, attendant.stopped_by)

    def _hear(self, news: Any) -> bool:
        """Pass progress and log lines on, in the calling thread."""
        if isinstance(news, str):
            if self.question.options.log is not None:
                self.question.options.log(news)
            return False
        objective, bound, values = news
        point = None if values is None else self.question.whole(values)
        if point is not None:
            self._best = point
        self._bound = self.question.true_bound(bound)
        elapsed = time.perf_counter() - self.began
        progress = Progress(objective, self._bound, elapsed, point)
        return self.watch is not None and self.watch(progress)


@dataclass(eq=False)
class _Callback:
    """Tells the attendant what Gurobi tells, and Gurobi to stop when the attendant says so."""

    attendant: Attendant
    grb: Any
    quiet: bool

    def __call__(self, model: Any, where: int) -> None:
        callback = self.grb.Callback
        if self.attendant.stopping:
            model.terminate()
        if where == callback.MESSAGE:
            self.attendant.tell(model.cbGet(callback.MSG_STRING).rstrip("\n"))
        elif where == callback.MIPSOL:
            values = np.array(model.cbGetSolution(model.getVars()))
            self._told(
                model.cbGet(callback.MIPSOL_OBJ), model.cbGet(callback.MIPSOL_OBJBND), values
            )
        elif where == callback.MIP and not self.quiet:
            self._told(model.cbGet(callback.MIP_OBJBST), model.cbGet(callback.MIP_OBJBND), None)

    def _told(self, objective: float, bound: float, values: Any) -> None:
        self.attendant.tell((self._finite(objective), self._finite(bound), values))

    def _finite(self, value: float) -> float | None:
        return value if abs(value) < self.grb.INFINITY else None


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
    same = model.row_lower == model.row_upper
    for rows, sense, side in (
        (same, "=", model.row_lower),
        (~same & np.isfinite(model.row_lower), ">", model.row_lower),
        (~same & np.isfinite(model.row_upper), "<", model.row_upper),
    ):
        if rows.any() and model.size.columns:
            native.addMConstr(model.matrix[np.flatnonzero(rows)], x, sense, side[rows])
    native.update()
    return native


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


def _read(native: Any, grb: Any, stopped_by: StoppedBy | None) -> Ending:
    """What Gurobi says at its end."""
    verdicts = {
        grb.OPTIMAL: Verdict.SOLVED,
        grb.INFEASIBLE: Verdict.REFUTED,
        grb.CUTOFF: Verdict.REFUTED,
        grb.SOLUTION_LIMIT: Verdict.ENDED,
    }
    reasons = {
        grb.TIME_LIMIT: StoppedBy.TIME_LIMIT,
        grb.INTERRUPTED: StoppedBy.INTERRUPT,
        grb.MEM_LIMIT: StoppedBy.MEMORY,
    }
    ended = native.Status
    if ended not in verdicts and ended not in reasons:
        raise SolverError(f"Gurobi could not solve the model (status {ended})")
    values = np.array(native.getAttr("X", native.getVars())) if native.SolCount else None
    bound = float(native.ObjBound) if native.IsMIP else None
    return Ending(
        verdicts.get(ended, Verdict.ENDED),
        values,
        None if bound is None or abs(bound) >= grb.INFINITY else bound,
        stopped_by or reasons.get(ended),
        int(native.NodeCount),
    )
