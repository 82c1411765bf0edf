"""Answers that are not taken at a solver's word.

A solver that calls a point optimal with a bound that lies below it or with none, calls a model
infeasible, or returns a point that violates the model is asked again with other settings, each of
them at most once. What two runs say alike counts; what stays unclear is a point and a bound, and no
proof.

Two runs that presolve alike are one witness: a rule of presolve that is wrong about a model is so
with every seed. So "infeasible" counts only if a run without presolve says it too, where the solver
can do without. As infeasible models are mostly so at their root, that costs little: 450 of them
(planning, swarms, signals, explanations) took 5.0 seconds without presolve, 2.8 with it.
"""

from __future__ import annotations

import math
import time
from collections.abc import Iterator
from dataclasses import dataclass, replace

from tsplan.errors import SolverError
from tsplan.milp.model import Floats, Model
from tsplan.milp.solution import Options, Solution, Status, Watcher
from tsplan.milp.solver import Solver
from tsplan.stopping import StoppedBy

_SEEDS = 2**31
_SAME = 1e-6  # relative distance of values that count as the same


@dataclass(eq=False)
class _Runs:
    """What the runs so far say together."""

    optional: bool  # whether the solver can do without presolve
    point: Solution | None = None
    best: float = math.inf  # the value of the point
    bound: float = -math.inf
    refutations: int = 0
    plain: bool = False  # whether a refutation came without presolve
    words: int = 0  # optima of the best point's value that no bound bears out
    trouble: SolverError | None = None

    @property
    def refuted(self) -> bool:
        """Whether it is proven that there is no point."""
        return self.refutations > 1 and (self.plain or not self.optional)

    def take(self, solution: Solution, *, plain: bool) -> Solution | None:
        """Take in one run, `plain` without presolve; the answer, once it is clear."""
        if solution.status is Status.INFEASIBLE:
            if self.point is not None:
                raise SolverError("one run calls a model infeasible of which another has a point")
            self.refutations += 1
            self.plain = self.plain or plain
            return solution if self.refuted else None
        if solution.bound is not None and not solution.silent:
            self.bound = max(self.bound, solution.bound)
        value = math.inf if solution.objective is None else solution.objective
        same = 0.0 if self.point is None else _SAME * max(1.0, abs(self.best))
        if value < self.best - same:
            self.point, self.best, self.words = solution, value, 0
        if solution.silent and solution.status is Status.OPTIMAL:
            self.words += value <= self.best + same
            optimal = self.point is not None and self.point.status is Status.OPTIMAL
            return self.point if optimal and self.words > 1 else None
        return None if solution.stopped_by is StoppedBy.PRECISION else self.together(solution)

    def together(self, last: Solution | None = None) -> Solution:
        """The best point and bound; how it ended is what the `last` run says, if it is clear."""
        if last is not None and last is self.point:
            return last
        why = None if last is None else last.stopped_by
        why = why or StoppedBy.PRECISION
        # a point refutes a bound above it, whichever run has named that
        bound = self.bound if -math.inf < self.bound <= self.best else None
        if self.point is None:
            return Solution(Status.UNKNOWN, why, bound=bound)
        return replace(self.point, status=Status.FEASIBLE, stopped_by=why, bound=bound)


def confirmed(
    solver: Solver, model: Model, options: Options, watch: Watcher | None = None
) -> Solution:
    """Solve a model; see the module's text for what is asked a second time.

    FEASIBLE or UNKNOWN with `StoppedBy.PRECISION` is the end of a search that could not be made
    clear. Raises SolverError where every run fails, and where two runs contradict each other.
    """
    runs, count = _Runs("presolve" in solver.features), 0
    for setting in _settings(solver, options, runs):
        count += 1
        try:
            solution = solver.solve(model, setting, watch)
        except SolverError as error:
            runs.trouble = error
            continue
        answer = runs.take(solution, plain=not setting.presolve)
        if answer is not None:
            return answer
    if count == 1 and runs.refutations:
        return Solution(Status.INFEASIBLE)  # there is no other setting to ask with
    if count == 1 and runs.words and runs.point is not None:
        return runs.point
    if runs.point is None and not runs.refutations and runs.trouble is not None:
        raise runs.trouble
    return runs.together()


def _settings(solver: Solver, options: Options, runs: _Runs) -> Iterator[Options]:
    """The options as given; then with another seed, and without presolve, both without a start.

    After a refutation the run without presolve comes first, as no proof does without it.
    """
    began = time.perf_counter()
    yield options
    fresh = replace(options, start=None)
    others = []
    if "seed" in solver.features or options.start is not None:
        others.append(replace(fresh, seed=((options.seed or 0) + 1) % _SEEDS))
    if runs.optional:
        others.append(replace(fresh, presolve=False))
    if runs.refutations:
        others.reverse()
    for other in others:
        limit = options.time_limit
        left = None if limit is None else max(limit - (time.perf_counter() - began), 0.0)
        yield replace(other, time_limit=left)


def tried(
    solver: Solver, model: Model, options: Options, watch: Watcher | None = None
) -> Floats | None:
    """A point of a model if the solver finds one; its failure proves nothing and breaks nothing."""
    try:
        return solver.solve(model, options, watch).values
    except SolverError:
        return None
