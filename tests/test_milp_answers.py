"""What is believed of a solver, and what cannot be said at all."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest
from scipy import sparse

from tsplan.errors import SolverError
from tsplan.milp.highs import Highs
from tsplan.milp.model import Model
from tsplan.milp.request import RawResult, Request
from tsplan.milp.solution import Options, Progress, Solution, Status, presolved
from tsplan.stopping import StoppedBy

REASONS = [StoppedBy.TIME_LIMIT, StoppedBy.INTERRUPT, StoppedBy.MEMORY]


def model() -> Model:
    """Minimise 2x + y + 1 with x + y >= 3, both whole numbers between 0 and 5: 4 at (0, 3)."""
    return Model(
        np.array([2.0, 1.0]),
        np.zeros(2),
        np.full(2, 5.0),
        np.ones(2, dtype=bool),
        sparse.csr_array(np.ones((1, 2))),
        np.array([3.0]),
        np.array([np.inf]),
        offset=1.0,
    )


def answer(said: RawResult, **options) -> Solution:
    return Request(model(), Options(**options)).solution(said, 0.5)


BEST, GOOD = np.array([0.0, 3.0]), np.array([1.0, 2.0])


EVERY = [
    Status,
    [None, *StoppedBy],
    [False, True],
    [None, 1.0, 2.0, np.inf],
    [None, 1.0, 2.0, np.inf, np.nan],
]


def test_only_possible_solutions_can_be_made() -> None:
    made = 0
    for status, stopped, found, objective, bound in product(*EVERY):
        values = np.zeros(1) if found else None
        try:
            solution = Solution(status, stopped, values, objective, bound)
        except ValueError:
            continue
        made += 1
        assert (solution.values is None) == (solution.objective is None)
        assert found == (status in (Status.OPTIMAL, Status.FEASIBLE))
        if status in (Status.OPTIMAL, Status.INFEASIBLE):
            assert stopped is None
        assert stopped != StoppedBy.WINDOW
        if status == Status.UNKNOWN:
            assert stopped in {*REASONS, StoppedBy.PRECISION}
        if bound is not None:
            assert np.isfinite(bound)
            assert status != Status.INFEASIBLE
            assert objective is None or bound <= objective
    assert made


@pytest.mark.parametrize(
    "wrong",
    [
        {"time_limit": float("nan")},
        {"gap": -0.1},
        {"absolute_gap": -1.0},
        {"threads": 0},
        {"seed": -1},
        {"seed": 2**31},
        {"cutoff": float("nan")},
    ],
)
def test_options_that_mean_nothing_are_refused(wrong) -> None:
    with pytest.raises(ValueError, match=r"not a number|negative|thread|seed"):
        Options(**wrong)


def test_gaps_are_relative_to_the_objective() -> None:
    assert Progress(50.0, 45.0, 1.0).gap == pytest.approx(0.1)
    assert Progress(-50.0, -55.0, 1.0).gap == pytest.approx(0.1)
    assert Progress(0.0, 0.0, 1.0).gap == 0.0
    assert Progress(None, 45.0, 1.0).gap is None


def test_an_optimum_has_its_objective_as_bound() -> None:
    found = answer(RawResult(Status.OPTIMAL, BEST))
    assert (found.status, found.objective, found.bound) == (Status.OPTIMAL, 4.0, 4.0)
    assert found.seconds == 0.5


def test_integers_are_rounded() -> None:
    found = answer(RawResult(Status.OPTIMAL, np.array([1e-7, 3.0 - 1e-7]), 4.0 - 1e-8))
    assert found.values.tolist() == [0.0, 3.0]
    assert (found.objective, found.status) == (4.0, Status.OPTIMAL)


def test_a_point_that_only_fits_unrounded_is_none() -> None:
    tight = Request(
        Model(
            np.ones(2),
            np.zeros(2),
            np.full(2, 5e6),
            np.array([True, False]),
            sparse.csr_array(np.array([[10.0, -1e7]])),
            np.zeros(1),
            np.zeros(1),
        ),
        Options(),
    )
    point = np.array([1.000004, 1.000004e-6])
    assert tight.rounded(point) is None


class Sloppy(Highs):
    """Takes less than a millionth for nothing in the first column, and makes use of it."""

    points: tuple[list[float], ...] = ([1e-6, 1e-3],)

    def answer(self, request):
        if not request.model.integer.any():
            return super().answer(request)
        return RawResult(Status.OPTIMAL, np.array(self.points[0]), -1e-3)


def test_what_a_large_factor_makes_of_a_millionth_is_taken_back() -> None:
    switched = Model(  # the second column is at most 1000 times the first, which costs 10
        np.array([10.0, -1.0]),
        np.zeros(2),
        np.array([1.0, 9.0]),
        np.array([True, False]),
        sparse.csr_array(np.array([[1000.0, -1.0]])),
        np.zeros(1),
        np.array([np.inf]),
    )
    found = Sloppy().solve(switched)
    assert found.values.tolist() == [0.0, 0.0]
    assert (found.status, found.stopped_by) == (Status.FEASIBLE, StoppedBy.PRECISION)
    broken = Sloppy()
    broken.points = ([1e-6, 1.0],)
    with pytest.raises(SolverError, match="violates"):
        broken.solve(switched)


@pytest.mark.parametrize(
    "point", [[0.0, 2.0], [0.0, 6.0], [0.5, 2.5], [np.nan, 3.0], [np.inf, 3.0], [3.0]]
)
def test_a_point_that_violates_the_model_is_an_error(point) -> None:
    with pytest.raises(SolverError, match="violates"):
        answer(RawResult(Status.OPTIMAL, np.array(point)))


def test_what_stopped_a_solve_is_kept_with_what_is_known() -> None:
    for reason in REASONS:
        found = answer(RawResult(Status.UNKNOWN, GOOD, 2.0, reason, 7))
        assert (found.status, found.stopped_by, found.bound) == (Status.FEASIBLE, reason, 2.0)
        assert found.nodes == 7
        nothing = answer(RawResult(Status.UNKNOWN, None, 2.0, reason))
        assert (nothing.status, nothing.stopped_by, nothing.bound) == (Status.UNKNOWN, reason, 2.0)


def test_infinite_bounds_are_none() -> None:
    for bound in (-np.inf, np.inf, np.nan):
        assert answer(RawResult(Status.UNKNOWN, GOOD, bound, StoppedBy.TIME_LIMIT)).bound is None


def test_a_bound_that_a_point_refutes_is_not_believed() -> None:
    found = answer(RawResult(Status.UNKNOWN, GOOD, 9.0, StoppedBy.TIME_LIMIT))
    assert (found.status, found.stopped_by) == (Status.FEASIBLE, StoppedBy.TIME_LIMIT)
    assert (found.objective, found.bound) == (5.0, None)
    found = answer(RawResult(Status.OPTIMAL, GOOD, 5.0), start=BEST)
    assert (found.status, found.stopped_by) == (Status.FEASIBLE, StoppedBy.PRECISION)
    assert (found.objective, found.bound) == (4.0, None)


def test_an_optimum_that_its_own_bound_does_not_bear_out_is_none() -> None:
    found = answer(RawResult(Status.OPTIMAL, GOOD, 2.0))
    assert (found.status, found.stopped_by) == (Status.FEASIBLE, StoppedBy.PRECISION)
    assert (found.objective, found.bound) == (5.0, 2.0)
    # the point as the solver gave it is worth less than the whole one
    silent = answer(RawResult(Status.OPTIMAL, np.array([1.0 - 1e-4, 2.0 + 1e-4])))
    assert (silent.status, silent.stopped_by) == (Status.FEASIBLE, StoppedBy.PRECISION)
    assert silent.bound < silent.objective == 5.0


def test_a_gap_is_what_ended_a_search_that_left_one() -> None:
    left = answer(RawResult(Status.OPTIMAL, GOOD, 4.0), gap=0.5)
    assert (left.status, left.stopped_by, left.bound) == (Status.FEASIBLE, StoppedBy.GAP, 4.0)
    closed = answer(RawResult(Status.OPTIMAL, BEST, 4.0), gap=0.5)
    assert (closed.status, closed.stopped_by) == (Status.OPTIMAL, None)
    silent = answer(RawResult(Status.OPTIMAL, GOOD), gap=0.5)
    assert (silent.stopped_by, silent.bound) == (StoppedBy.GAP, None)
    whole = answer(RawResult(Status.OPTIMAL, GOOD, 4.1), absolute_gap=0.999)
    assert (whole.status, whole.bound) == (Status.OPTIMAL, 4.1)


def test_a_first_point_was_stopped_by_nothing() -> None:
    found = answer(RawResult(Status.UNKNOWN, GOOD, 1.0), first=True)
    assert (found.status, found.stopped_by) == (Status.FEASIBLE, None)
    with pytest.raises(SolverError, match="without a reason"):
        answer(RawResult(Status.UNKNOWN), first=True)


def test_a_better_start_is_the_answer() -> None:
    for values in (None, GOOD):
        found = answer(RawResult(Status.UNKNOWN, values, 2.0, StoppedBy.TIME_LIMIT), start=BEST)
        assert found.values.tolist() == BEST.tolist()
    found = answer(RawResult(Status.UNKNOWN, BEST, 2.0, StoppedBy.TIME_LIMIT), start=GOOD)
    assert found.values.tolist() == BEST.tolist()
    useless = np.array([0.0, 1.0])
    found = answer(RawResult(Status.UNKNOWN, None, 2.0, StoppedBy.TIME_LIMIT), start=useless)
    assert found.status == Status.UNKNOWN


def test_a_solver_may_not_deny_a_point_that_is_known() -> None:
    assert answer(RawResult(Status.INFEASIBLE)).status == Status.INFEASIBLE
    with pytest.raises(SolverError, match="a point is known"):
        answer(RawResult(Status.INFEASIBLE), start=GOOD)
    assert answer(RawResult(Status.INFEASIBLE), start=GOOD, cutoff=5.0).status == Status.INFEASIBLE


def test_points_that_do_not_beat_the_cutoff_are_none() -> None:
    assert answer(RawResult(Status.OPTIMAL, BEST), cutoff=4.0).status == Status.INFEASIBLE
    assert answer(RawResult(Status.OPTIMAL, BEST), cutoff=4.1).status == Status.OPTIMAL
    stopped = answer(RawResult(Status.UNKNOWN, GOOD, 9.0, StoppedBy.TIME_LIMIT), cutoff=5.0)
    assert (stopped.status, stopped.bound) == (Status.UNKNOWN, 5.0)


def test_the_cutoff_as_a_row() -> None:
    question = Request(model(), Options(cutoff=5.0))
    assert question.cut().size.rows == 2
    assert question.cut().violation(GOOD) > 0
    assert question.cut().violation(BEST) == 0
    plain = Request(model(), Options())
    assert plain.cut() is plain.model


def test_some_models_need_no_solver() -> None:
    assert presolved(model()) is None
    crossed = model().with_bounds(np.array([0.0, 2.0]), np.array([5.0, 1.0]))
    assert presolved(crossed).status == Status.INFEASIBLE
