"""Any solver that PuLP finds, by its PuLP name after a colon: `pulp:PULP_CBC_CMD`.

Written for PuLP 3.3.2 and for PuLP 4, whose problems make their variables and whose `solve` returns
an object. PuLP calls a time-limited incumbent "Optimal" in `status`; `sol_status` tells the truth.
"""

from __future__ import annotations

import time
from importlib.metadata import version
from importlib.util import find_spec
from typing import Any

import numpy as np

from tsplan.errors import SolverError, nearest
from tsplan.milp.model import Model
from tsplan.milp.solution import Options, Solution, Status, StoppedBy, Watcher, settled
from tsplan.milp.solver import Availability

_PREFERRED = ("PULP_CBC_CMD", "COIN_CMD", "HiGHS", "GLPK_CMD", "SCIP_CMD", "SCIP_PY")
_OPTIMAL, _FEASIBLE, _INFEASIBLE, _UNBOUNDED = 1, 2, -1, -2


class Pulp:
    """Solves models through PuLP with the named backend, or with the first good one it finds."""

    features = frozenset({"log", "threads", "gap"})

    def __init__(self, backend: str = "") -> None:
        self._backend = backend
        self.name = f"pulp:{backend}" if backend else "pulp"

    def availability(self) -> Availability:
        """Installed if PuLP is there; usable if PuLP finds the backend."""
        if find_spec("pulp") is None:
            remedy = "pip install 'tsplan[pulp]'"
            return Availability(False, False, None, "PuLP is not installed", remedy)
        found = _found()
        number = version("pulp")
        if self._backend and self._backend not in found:
            why = f"PuLP finds no {self._backend} here"
            return Availability(True, False, number, why, nearest(self._backend, found))
        if not found:
            why, remedy = "PuLP finds no solver here", "install one, such as CBC, or use highs"
            return Availability(True, False, number, why, remedy)
        return Availability(True, True, number)

    def native(self, model: Model) -> Any:
        """The model as a `pulp.LpProblem`."""
        return _load(model)[0]

    def solve(
        self, model: Model, options: Options | None = None, watch: Watcher | None = None
    ) -> Solution:
        """Minimise the model. PuLP hands no progress over, so `watch` is not called."""
        import pulp  # noqa: PLC0415 - never imported unasked

        options = options or Options()
        known = settled(model)
        if known is not None:
            return known
        began = time.perf_counter()
        problem, variables = _load(model)
        try:
            backend = pulp.getSolver(self._name(), **_arguments(options))
            answer = problem.solve(backend)
        except pulp.PulpSolverError as error:
            raise SolverError(f"PuLP's {self._name()} failed: {error}") from error
        seconds = time.perf_counter() - began
        ended = int(getattr(answer, "sol_status", getattr(problem, "sol_status", 0)))
        if _INFEASIBLE in (ended, int(getattr(problem, "status", 0))):
            return Solution(Status.INFEASIBLE, seconds=seconds)
        if ended == _UNBOUNDED:
            raise SolverError("the model is unbounded: its objective can fall without end")
        if ended not in (_OPTIMAL, _FEASIBLE):
            return Solution(Status.UNKNOWN, StoppedBy.TIME_LIMIT, seconds=seconds)
        values = np.array([variable.value() or 0.0 for variable in variables])
        values = np.where(model.integer, np.round(values), values)
        objective = float(model.objective @ values) + model.offset
        if ended == _FEASIBLE:
            why = StoppedBy.TIME_LIMIT
            return Solution(Status.FEASIBLE, why, values, objective, None, seconds)
        if options.gap > 0:
            # the backend stopped within the gap and says no more than that
            bound = objective - options.gap * abs(objective)
            return Solution(Status.FEASIBLE, StoppedBy.GAP, values, objective, bound, seconds)
        return Solution(Status.OPTIMAL, None, values, objective, objective, seconds)

    def _name(self) -> str:
        found = _found()
        return self._backend or next((name for name in _PREFERRED if name in found), found[0])


def _found() -> list[str]:
    """The solvers PuLP can use here, without those that need a licence server to answer."""
    import pulp  # noqa: PLC0415 - never imported unasked

    return list(pulp.listSolvers(onlyAvailable=True))


def _arguments(options: Options) -> dict[str, object]:
    asked: dict[str, object] = {"msg": options.log is not None, **options.extra}
    if options.time_limit is not None:
        asked["timeLimit"] = max(options.time_limit, 0.01)
    if options.threads is not None:
        asked["threads"] = options.threads
    if options.gap:
        asked["gapRel"] = options.gap
    return asked


def _load(model: Model) -> tuple[Any, list[Any]]:
    import pulp  # noqa: PLC0415 - never imported unasked

    problem = pulp.LpProblem("tsplan", pulp.LpMinimize)
    variables = [
        problem.add_variable(
            f"x{column}",
            lowBound=float(low) if np.isfinite(low) else None,
            upBound=float(high) if np.isfinite(high) else None,
            cat=pulp.LpInteger if whole else pulp.LpContinuous,
        )
        for column, (low, high, whole) in enumerate(
            zip(model.lower, model.upper, model.integer, strict=True)
        )
    ]
    terms = [(variables[c], float(model.objective[c])) for c in np.flatnonzero(model.objective)]
    problem += pulp.LpAffineExpression(terms) + model.offset
    matrix = model.matrix
    for row, (low, high) in enumerate(zip(model.row_lower, model.row_upper, strict=True)):
        part = slice(matrix.indptr[row], matrix.indptr[row + 1])
        pairs = zip(matrix.indices[part].tolist(), matrix.data[part].tolist(), strict=True)
        left = pulp.LpAffineExpression([(variables[c], value) for c, value in pairs])
        if low == high:
            problem += left == float(low)
            continue
        if np.isfinite(low):
            problem += left >= float(low)
        if np.isfinite(high):
            problem += left <= float(high)
    return problem, variables
