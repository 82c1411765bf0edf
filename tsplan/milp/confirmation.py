"""Answers that are not taken at a solver's word.

A solver that calls a point optimal with a bound that lies below it or with none, calls a model
infeasible, or returns a point that violates the model is asked again with other settings, each of
them at most once. What two runs say alike counts; what stays unclear is a point and a bound, and no
proof.
"""

from __future__ import annotations

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
class _Hearing:
    """What the runs so far say together."""

    point: Solution | None = None
    bound: float | None = None
    refutations: int = 0
    words: int = 0  # optima of the best point's value that no bound bears out
    trouble: SolverError | None = None

    def hear(self, found: Solution) -> Solution | None:
        """Take in one run; the answer, once it is clear."""
        if found.status is Status.INFEASIBLE:
            if self.point is not None:
                raise SolverError("one run calls a model infeasible of which another has a point")
            self.refutations += 1
            return found if self.refutations > 1 else None
        told = None if found.silent else found.bound
        if told is not None and (self.bound is None or told > self.bound):
            self.bound = told
        if self._improves(found):
            self.point, self.words = found, 0
        if found.silent and found.status is Status.OPTIMAL:
            return self._word(found)
        unclear = found.stopped_by is StoppedBy.PRECISION
        return None if unclear else self.together(found)

    def _improves(self, found: Solution) -> bool:
        """Whether a run has the best point so far, by more than rounding."""
        if found.objective is None:
            return False
        known = None if self.point is None else self.point.objective
        return known is None or found.objective < known - _SAME * max(1.0, abs(known))

    def _word(self, found: Solution) -> Solution | None:
        """Take in an optimum that is but a word; the answer, once two runs say the same."""
        assert self.point is not None
        assert self.point.objective is not None
        assert found.objective is not None
        best = self.point.objective
        if found.objective <= best + _SAME * max(1.0, abs(best)):
            self.words += 1
        return self.point if self.words > 1 and self.point.status is Status.OPTIMAL else None

    def together(self, last: Solution | None = None) -> Solution:
        """The best point and bound; how it ended is what the `last` run says, if it is clear."""
        point = self.point
        if last is not None and last is point:
            return last
        why = StoppedBy.PRECISION if last is None else last.stopped_by
        if point is None:
            return Solution(Status.UNKNOWN, why, bound=self.bound)
        assert point.objective is not None
        bound = self.bound
        if bound is not None and bound > point.objective:
            bound = None  # another run refutes it
        why = why or StoppedBy.PRECISION
        return replace(point, status=Status.FEASIBLE, stopped_by=why, bound=bound)


def confirmed(
    solver: Solver, model: Model, options: Options, watch: Watcher | None = None
) -> Solution:
    """Solve a model; see the module's text for what is asked a second time.

    FEASIBLE or UNKNOWN with `StoppedBy.PRECISION` is the end of a search that could not be made
    clear. Raises SolverError where every run fails, and where two runs contradict each other.
    """
    heard = _Hearing()
    runs = 0
    for asked in _settings(solver, options):
        runs += 1
        try:
            found = solver.solve(model, asked, watch)
        except SolverError as error:
            heard.trouble = error
            continue
        answer = heard.hear(found)
        if answer is not None:
            return answer
    if runs == 1 and heard.refutations:
        return Solution(Status.INFEASIBLE)  # there is no other setting to ask with
    if runs == 1 and heard.words and heard.point is not None:
        return heard.point
    if heard.point is None and not heard.refutations and heard.trouble is not None:
        raise heard.trouble
    return heard.together()


def _settings(solver: Solver, options: Options) -> Iterator[Options]:
    """The options as given; then with another seed, and without presolve, both without a start."""
    began = time.perf_counter()
    yield options
    fresh = replace(options, start=None)
    others = []
    if "seed" in solver.features or options.start is not None:
        others.append(replace(fresh, seed=((options.seed or 0) + 1) % _SEEDS))
    if "presolve" in solver.features:
        others.append(replace(fresh, presolve=False))
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
