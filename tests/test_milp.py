"""The array model and every installed solver on small models with known answers."""

from __future__ import annotations

import faulthandler
import os
import pickle
import signal
import threading
import time

import numpy as np
import pytest

from tsplan.errors import Finding, FormulaError, SolverError, SolverUnavailableError
from tsplan.milp.highs import Highs
from tsplan.milp.lp import WarmLP
from tsplan.milp.model import Draft, Model
from tsplan.milp.solution import Options, Progress, Solution, Status
from tsplan.milp.solver import Solver, solver
from tsplan.process.child_process import CrashError, run_guarded
from tsplan.stopping import StoppedBy


def knapsack(items: int, seed: int = 0, rows: int = 3) -> Model:
    random = np.random.default_rng(seed)
    draft = Draft()
    take = draft.columns(items, upper=1.0, integer=True)
    for _ in range(rows):
        weight = random.integers(10, 100, items).astype(float)
        draft.rows(
            np.zeros(items), take, weight, lower=-np.inf, upper=weight.sum() / 2, kind="load"
        )
    return draft.build().with_objective(-random.integers(10, 100, items).astype(float))


def simple(lower: float, upper: float, *, integer: bool = True) -> Model:
    """Minimise x + 2y with `lower <= x + y <= upper`, x and y between 0 and 5."""
    draft = Draft()
    both = draft.columns(2, upper=5.0, integer=integer)
    draft.rows([0, 0], both, [1.0, 1.0], lower=lower, upper=upper, kind="sum")
    return draft.build().with_objective(np.array([1.0, 2.0]), offset=0.5)


def test_entries_at_one_place_add_up_and_rows_are_tagged() -> None:
    draft = Draft()
    column = draft.columns(1, upper=9.0)
    draft.rows(
        [0, 0], [column[0], column[0]], [1.0, 2.0], lower=3.0, upper=3.0, kind="twice", step=4
    )
    model = draft.build()
    assert model.matrix.toarray().tolist() == [[3.0]]
    assert (model.tags[0].kind, model.tags[0].step) == ("twice", 4)
    assert model.violation(np.array([1.0])) == 0.0
    assert model.violation(np.array([2.0])) == 3.0


def test_a_known_optimum(any_solver: Solver) -> None:
    solution = any_solver.solve(simple(6.5, 9.0), Options())
    assert solution.status == Status.OPTIMAL
    assert solution.objective == pytest.approx(9.5)  # x = 5, y = 2, and the offset
    assert solution.values.tolist() == [5.0, 2.0]


def test_an_infeasible_model(any_solver: Solver) -> None:
    solution = any_solver.solve(simple(11.0, 12.0), Options())
    assert (solution.status, solution.values) == (Status.INFEASIBLE, None)


def test_rows_without_entries(any_solver: Solver) -> None:
    draft = Draft()
    draft.columns(1, upper=1.0, integer=True)
    draft.rows([], [], [], lower=1.0, upper=2.0, kind="empty")
    assert any_solver.solve(draft.build(), Options()).status == Status.INFEASIBLE


def test_a_model_without_columns(any_solver: Solver) -> None:
    assert any_solver.solve(Draft().build(), Options()).status == Status.OPTIMAL


def test_an_unbounded_model_is_an_error(any_solver: Solver) -> None:
    draft = Draft()
    free = draft.columns(2, lower=-np.inf)
    draft.rows([0, 0], free, [1.0, -1.0], lower=0.0, upper=1.0, kind="apart")
    with pytest.raises(SolverError, match=r"unbounded|failed"):
        any_solver.solve(draft.build().with_objective(np.array([1.0, 1.0])), Options())


@pytest.mark.parametrize("seed", range(4))
def test_solvers_agree_on_random_knapsacks(any_solver: Solver, seed: int) -> None:
    model = knapsack(18, seed)
    expected = Highs().solve(model, Options())
    found = any_solver.solve(model, Options(threads=1, seed=3))
    assert found.status == Status.OPTIMAL
    assert found.objective == pytest.approx(expected.objective)


def test_a_time_limit_holds_and_keeps_a_true_bound() -> None:
    model = knapsack(400, rows=30)
    began = time.perf_counter()
    solution = Highs().solve(model, Options(time_limit=0.5))
    assert time.perf_counter() - began < 3.0
    assert solution.stopped_by == StoppedBy.TIME_LIMIT
    assert solution.bound is None or solution.bound <= solution.objective


def test_the_first_point_is_enough_if_asked() -> None:
    solution = Highs().solve(knapsack(300, rows=20), Options(first=True))
    assert solution.status in (Status.FEASIBLE, Status.OPTIMAL)


def test_a_start_is_used() -> None:
    model = knapsack(40)
    best = Highs().solve(model, Options())
    again = Highs().solve(model, Options(start=best.values, first=True))
    assert again.objective <= best.objective + 1e-6


def test_a_watcher_stops_the_search() -> None:
    seen: list[Progress] = []

    def watch(progress: Progress) -> bool:
        seen.append(progress)
        return progress.values is not None

    solution = Highs().solve(knapsack(400, rows=30), Options(time_limit=20.0), watch)
    assert solution.stopped_by == StoppedBy.INTERRUPT
    assert solution.status == Status.FEASIBLE
    assert seen


def test_ctrl_c_keeps_the_incumbent() -> None:
    timer = threading.Timer(0.7, lambda: os.kill(os.getpid(), signal.SIGINT))
    timer.start()
    began = time.perf_counter()
    solution = Highs().solve(knapsack(400, rows=30), Options(time_limit=20.0))
    assert time.perf_counter() - began < 5.0
    assert (solution.status, solution.stopped_by) == (Status.FEASIBLE, StoppedBy.INTERRUPT)


def test_a_misspelt_option_is_refused() -> None:
    with pytest.raises(SolverError, match="mip_rel_gapp"):
        Highs().solve(knapsack(5), Options(extra={"mip_rel_gapp": 0.1}))


def test_threads_may_change_between_solves() -> None:
    model = knapsack(30)
    values = {Highs().solve(model, Options(threads=threads)).objective for threads in (1, 2, 1)}
    assert len(values) == 1


def test_the_log_is_streamed() -> None:
    lines: list[str] = []
    Highs().solve(knapsack(20), Options(log=lines.append))
    assert any("HiGHS" in line or "Presolv" in line for line in lines)


def test_a_small_licence_is_refused_in_words() -> None:
    try:
        gurobi = solver("gurobi")
    except SolverUnavailableError as error:  # the licence that comes with a release runs out
        pytest.skip(str(error))
    with pytest.raises(SolverUnavailableError, match=r"2500 columns.*licence"):
        gurobi.solve(knapsack(2500), Options())


def test_unknown_solvers_are_named() -> None:
    with pytest.raises(SolverUnavailableError, match="did you mean 'highs'"):
        solver("higs")
    pytest.importorskip("pulp")
    with pytest.raises(SolverUnavailableError, match="NO_SUCH_CMD"):
        solver("pulp:NO_SUCH_CMD")


@pytest.mark.parametrize(
    ("status", "stopped", "values"),
    [
        (Status.OPTIMAL, StoppedBy.TIME_LIMIT, np.zeros(1)),
        (Status.INFEASIBLE, None, np.zeros(1)),
        (Status.UNKNOWN, None, None),
        (Status.OPTIMAL, None, None),
    ],
)
def test_impossible_solutions_cannot_be_made(status, stopped, values) -> None:
    with pytest.raises(ValueError, match=r"go together|stopped"):
        Solution(status, stopped, values)


def test_warm_programs_follow_their_bounds_and_rows() -> None:
    lp = WarmLP(simple(6.5, 9.0, integer=False))
    assert lp.solve().objective == pytest.approx(8.5)
    lp.bounds(np.array([0]), np.array([0.0]), np.array([2.0]))
    assert lp.solve().objective == pytest.approx(11.5)
    assert lp.solve(cutoff=9.0).status in ("cutoff", "optimal")
    lp.bounds(np.array([1]), np.array([0.0]), np.array([1.0]))
    assert lp.solve().status == "infeasible"


def _answers(number: int, send) -> int:
    send("half way")
    return 2 * number


def _crashes(number: int, send) -> int:
    faulthandler.disable()  # the crash is meant, and need not be described
    os.kill(os.getpid(), number)
    return 0


def _fails(number: int, send) -> int:
    raise SolverError("in words")


def test_a_guarded_job_answers_and_sends_events() -> None:
    events: list[object] = []
    assert run_guarded(_answers, 4, events.append) == 8
    assert events == ["half way"]


@pytest.mark.parametrize("number", [signal.SIGSEGV, signal.SIGKILL])
def test_a_crash_becomes_a_message(number: int) -> None:
    with pytest.raises(CrashError, match=signal.Signals(number).name):
        run_guarded(_crashes, int(number))


def test_a_guarded_error_is_raised_here() -> None:
    with pytest.raises(SolverError, match="in words"):
        run_guarded(_fails, 0)


def test_input_errors_survive_the_way_between_processes() -> None:
    error = FormulaError([Finding("wrong", "mend it", "f.yaml", 1, 2)])
    again = pickle.loads(pickle.dumps(error))
    assert (type(again), again.findings) == (FormulaError, error.findings)
