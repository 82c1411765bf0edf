"""PuLP's own terms: problems out of models, and raw results out of answers.

Works with PuLP 3.3.2 and PuLP 4. PuLP 3 calls a time-limited incumbent "Optimal" in `status` and an
unsolved model "infeasible" in `sol_status`, so each is asked only what it tells truly; PuLP 4
returns an object that says why the solver stopped and whether it has a point.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from tsplan.errors import SolverError
from tsplan.milp.model import Floats, Model
from tsplan.milp.request import RawResult
from tsplan.milp.solution import Status
from tsplan.process.quiet_output import hushed
from tsplan.stopping import StoppedBy

_NOT_SOLVED, _SOLVED, _INFEASIBLE, _UNBOUNDED, _UNDEFINED = 0, 1, -1, -2, -3  # PuLP 3 and 4
_TIME, _MEMORY, _GAP, _NUMERICAL = -4, -5, -7, -12  # PuLP 4


class UnclearError(SolverError):
    """The solver says neither that the model is infeasible nor that it is unbounded, but either."""


def pulp_module() -> Any:
    """The module pulp, loaded without a word of its own or of the solvers it loads."""
    with hushed():
        import pulp  # noqa: PLC0415 - never imported unasked
    return pulp


def load(model: Model) -> tuple[Any, list[Any]]:
    """The model as a `pulp.LpProblem`, and its variables in the order of the columns."""
    pulp = pulp_module()
    expression = getattr(pulp.LpAffineExpression, "from_list", pulp.LpAffineExpression)
    problem = pulp.LpProblem("tsplan", pulp.LpMinimize)
    kinds = (pulp.LpContinuous, pulp.LpInteger)
    columns = zip(_sides(model.lower), _sides(model.upper), model.integer.tolist(), strict=True)
    variables = [
        problem.add_variable(f"x{number}", lowBound=low, upBound=high, cat=kinds[whole])
        for number, (low, high, whole) in enumerate(columns)
    ]
    costs = model.objective.tolist()
    problem += expression([(x, cost) for x, cost in zip(variables, costs, strict=True) if cost]) + (
        float(model.offset)
    )
    starts, places = model.matrix.indptr.tolist(), model.matrix.indices.tolist()
    entries = model.matrix.data.tolist()
    for row, (low, high) in enumerate(
        zip(_sides(model.row_lower), _sides(model.row_upper), strict=True)
    ):
        begin, end = starts[row], starts[row + 1]
        if begin == end:
            continue  # already known to hold
        pairs = zip(places[begin:end], entries[begin:end], strict=True)
        left = expression([(variables[place], entry) for place, entry in pairs])
        if low is not None and low == high:
            problem += left == low
            continue
        if low is not None:
            problem += left >= low
        if high is not None:
            problem += left <= high
    return problem, variables


def _sides(bounds: Floats) -> list[float | None]:
    """Bounds with None for no bound, as PuLP has it."""
    return [bound if np.isfinite(bound) else None for bound in bounds.tolist()]


_CLAIMS = {
    _INFEASIBLE: RawResult(Status.INFEASIBLE),
    _UNBOUNDED: RawResult(Status.INFEASIBLE),  # the model says which of the two
    _SOLVED: RawResult(Status.OPTIMAL),
    _GAP: RawResult(Status.OPTIMAL),
    _TIME: RawResult(Status.UNKNOWN, stopped_by=StoppedBy.TIME_LIMIT),
    _MEMORY: RawResult(Status.UNKNOWN, stopped_by=StoppedBy.MEMORY),
}


def raw_result(problem: Any, answer: Any) -> RawResult:
    """What PuLP says, without a point: `problem.solve` gave `answer`. Raises SolverError."""
    unknown = RawResult(Status.UNKNOWN)
    if hasattr(answer, "has_solution"):  # PuLP 4
        status = int(answer.status)
        if status in (_UNDEFINED, _NUMERICAL, _NOT_SOLVED):
            # PuLP 4 has the first for "infeasible or unbounded" too
            kind = UnclearError if status == _UNDEFINED else SolverError
            raise kind(f"PuLP's solver ended without an answer ({answer.status_str})")
        # its `best_bound` is read off logs, and was seen above the best point of a stopped CBC
        return _CLAIMS.get(status, unknown)
    status, found = int(problem.status), int(problem.sol_status)
    if status == _INFEASIBLE or _UNBOUNDED in (status, found):
        return _CLAIMS[_INFEASIBLE]
    if status == _UNDEFINED:
        raise SolverError("PuLP's solver ended without an answer")
    return _CLAIMS[_SOLVED] if status == found == _SOLVED else unknown
