"""Every installed solver, PuLP's each on its own, on small models with known answers."""

from __future__ import annotations

import itertools
import os
import signal
import sys
import threading
from collections.abc import Callable

import numpy as np
import pytest
from scipy import sparse

from tests.command_line import printed
from tests.seeds import sampled
from tsplan.errors import SolverError, SolverUnavailableError
from tsplan.milp.highs import load
from tsplan.milp.model import Model
from tsplan.milp.solution import Options, Progress, Status
from tsplan.milp.solver import Solver, available, installed, solver
from tsplan.stopping import StoppedBy

INF = np.inf
NAMES = installed()


@pytest.fixture
def highs() -> Solver:
    return solver("highs")


def made(cost, rows, row_lower, row_upper, *, lower=0.0, upper=INF, integer=True, offset=0.0):
    """A model from small lists."""
    cost = np.asarray(cost, dtype=float)
    count = len(cost)
    matrix = sparse.csr_array(np.asarray(rows, dtype=float).reshape(len(row_lower), count))
    return Model(
        cost,
        np.broadcast_to(np.asarray(lower, dtype=float), count).copy(),
        np.broadcast_to(np.asarray(upper, dtype=float), count).copy(),
        np.broadcast_to(np.asarray(integer), count).copy(),
        matrix,
        np.asarray(row_lower, dtype=float),
        np.asarray(row_upper, dtype=float),
        offset=offset,
    )


def hard(columns: int = 400, rows: int = 300) -> Model:
    """Takes much longer than any test waits, but has points that are easy to find."""
    random = np.random.default_rng(7)
    matrix = sparse.csr_array(
        sparse.random_array((rows, columns), density=12 / columns, format="csr", rng=random)
    )
    cost = random.integers(-9, -1, columns).astype(float)
    return Model(
        cost,
        np.zeros(columns),
        np.full(columns, 3.0),
        np.ones(columns, dtype=bool),
        matrix,
        np.full(rows, -INF),
        np.full(rows, 5.0),
    )


def random_model(seed: int) -> Model:
    """Small, bounded, often infeasible, with equalities, free sides and continuous columns."""
    random = np.random.default_rng(seed)
    columns, rows = int(random.integers(1, 6)), int(random.integers(0, 5))
    matrix = random.integers(-3, 4, (rows, columns))
    low = random.integers(-6, 4, rows).astype(float)
    high = low + random.integers(0, 6, rows)
    low[random.random(rows) < 0.3] = -INF
    high[random.random(rows) < 0.3] = INF
    return made(
        random.integers(-5, 6, columns),
        matrix,
        low,
        high,
        lower=random.integers(-2, 1, columns),
        upper=random.integers(1, 4, columns),
        integer=random.random(columns) < 0.7,
        offset=float(random.integers(-3, 4)),
    )


def by_enumeration(model: Model) -> float | None:
    """The least value of a model of integer columns alone; None if it has no point."""
    ranges = [range(int(a), int(b) + 1) for a, b in zip(model.lower, model.upper, strict=True)]
    points = (np.array(point, dtype=float) for point in itertools.product(*ranges))
    values = [model.objective @ p + model.offset for p in points if model.violation(p) < 1e-9]
    return min(values, default=None)


# --- known answers ---------------------------------------------------------------------------


def test_a_knapsack(any_solver: Solver) -> None:
    model = made([-10, -7, -5, -4], [[5, 4, 3, 1]], [-INF], [8], upper=1)
    solution = any_solver.solve(model, Options())
    assert (solution.status, solution.objective, solution.bound) == (Status.OPTIMAL, -16.0, -16.0)
    assert solution.values.tolist() == [0.0, 1.0, 1.0, 1.0]
    assert solution.gap == 0.0


def test_equalities_offsets_and_free_columns(any_solver: Solver) -> None:
    model = made([1, 1], [[1, 2]], [-7], [-7], lower=[-INF, -2], upper=[INF, 2], offset=10.0)
    solution = any_solver.solve(model, Options())
    assert solution.status == Status.OPTIMAL
    assert solution.objective == pytest.approx(-11 + 2 + 10)
    assert solution.values == pytest.approx([-11, 2])


def test_ranges_of_rows_hold_on_both_sides(any_solver: Solver) -> None:
    model = made([1], [[2]], [5], [9], upper=20)
    assert any_solver.solve(model, Options()).objective == 3.0
    assert any_solver.solve(model.with_objective(np.array([-1.0])), Options()).objective == -4.0


def test_a_linear_program(any_solver: Solver) -> None:
    model = made([-1, -1], [[2, 1], [1, 3]], [-INF, -INF], [4, 6], integer=False)
    solution = any_solver.solve(model, Options())
    assert solution.status == Status.OPTIMAL
    assert solution.objective == pytest.approx(-2.8)
    assert solution.bound == pytest.approx(-2.8)


@pytest.mark.parametrize(
    "model",
    [
        made([1, 1], [[1, 1]], [3], [9], upper=1),
        made([1], [[2]], [3], [3], upper=9),
        made([1], [[1]], [-INF], [5], lower=2, upper=1),
        made([1], [[1]], [5], [4]),
        made([1], [[0]], [1], [2]),
        made([], np.zeros((1, 0)), [1], [2]),
        made([1, 1], [[1, -1]], [0.3], [0.6], upper=5),
        # infeasible, and its objective falls without end where its rows are left out
        made([-1, 0], [[0, 1]], [2], [3], upper=[INF, 1]),
    ],
    ids=["sum", "odd", "column", "row", "empty row", "no columns", "between", "ray"],
)
def test_infeasible_models(any_solver: Solver, model: Model) -> None:
    solution = any_solver.solve(model, Options())
    assert solution.status == Status.INFEASIBLE
    assert solution.values is solution.objective is solution.bound is None


@pytest.mark.parametrize("integer", [True, False])
@pytest.mark.parametrize("columns", [1, 2])
def test_unbounded_models_are_refused(any_solver: Solver, columns: int, *, integer: bool) -> None:
    rows = [[1, -1]] if columns == 2 else np.zeros((0, 1))
    sides = ([0], [1]) if columns == 2 else ([], [])
    model = made([-1] * columns, rows, *sides, integer=integer)
    with pytest.raises(SolverError, match="unbounded"):
        any_solver.solve(model, Options())


def test_models_without_columns_or_rows(any_solver: Solver) -> None:
    nothing = any_solver.solve(made([], np.zeros((0, 0)), [], [], offset=3.0), Options())
    assert (nothing.status, nothing.objective) == (Status.OPTIMAL, 3.0)
    free = any_solver.solve(made([2, -1], np.zeros((0, 2)), [], [], lower=1, upper=4), Options())
    assert (free.status, free.objective) == (Status.OPTIMAL, -2.0)
    assert free.values.tolist() == [1.0, 4.0]


def test_a_model_without_an_objective(any_solver: Solver) -> None:
    model = made([0, 0], [[1, 1]], [3], [3], upper=2)
    solution = any_solver.solve(model, Options())
    assert (solution.status, solution.objective) == (Status.OPTIMAL, 0.0)
    assert model.violation(solution.values) == 0.0


def test_whole_numbers_are_whole(any_solver: Solver) -> None:
    solution = any_solver.solve(made([1, 2], [[3, 7]], [31.3], [INF]), Options())
    assert (solution.values == np.round(solution.values)).all()


@pytest.mark.parametrize("seed", sampled([*range(15), *range(100, 600)], range(3)))
def test_solvers_agree_on_random_models(any_solver: Solver, highs: Solver, seed: int) -> None:
    model = random_model(seed)
    expected, found = highs.solve(model, Options()), any_solver.solve(model, Options())
    assert found.status == expected.status
    if expected.objective is not None:
        # columns that are not whole may use a solver's tolerance of 1e-6, each for what it is worth
        slack = 1e-6 * max(1.0, float(np.abs(model.objective).sum()))
        assert found.objective == pytest.approx(expected.objective, abs=slack)
        assert model.violation(found.values) <= 1e-5


@pytest.mark.parametrize("seed", sampled(range(40), range(15)))
def test_highs_agrees_with_enumeration(highs: Solver, seed: int) -> None:
    model = random_model(seed)
    model = model.with_integrality(np.ones_like(model.integer))
    expected, found = by_enumeration(model), highs.solve(model)
    assert (found.status == Status.INFEASIBLE) == (expected is None)
    assert found.objective is None or found.objective == pytest.approx(expected)


# --- options ---------------------------------------------------------------------------------


def test_a_cutoff_asks_only_for_better_points(any_solver: Solver) -> None:
    model = made([3, 5], [[2, 3]], [17], [INF], upper=9, offset=1.0)
    best = any_solver.solve(model, Options()).objective
    assert any_solver.solve(model, Options(cutoff=best)).status == Status.INFEASIBLE
    assert any_solver.solve(model, Options(cutoff=best - 1.5)).status == Status.INFEASIBLE
    for cutoff in (best + 0.5, best + 40):
        again = any_solver.solve(model, Options(cutoff=cutoff))
        assert (again.status, again.objective) == (Status.OPTIMAL, pytest.approx(best))
    first = any_solver.solve(model, Options(cutoff=best + 0.5, first=True))
    assert first.objective == pytest.approx(best)
    none = any_solver.solve(model, Options(cutoff=best, first=True))
    assert none.status == Status.INFEASIBLE


def test_a_cutoff_over_a_search(highs: Solver) -> None:
    model = hard(30, 20)
    best = highs.solve(model)
    assert highs.solve(model, Options(cutoff=best.objective - 0.5)).status == Status.INFEASIBLE
    above = highs.solve(model, Options(cutoff=best.objective + 0.5))
    assert above.objective == pytest.approx(best.objective)


def test_a_start_is_never_lost(any_solver: Solver) -> None:
    model = hard()
    start = np.zeros(400)
    start[0] = 1.0
    solution = any_solver.solve(model, Options(start=start, time_limit=0.2))
    assert solution.status == Status.FEASIBLE
    assert solution.objective <= model.objective[0]


def test_a_start_that_is_no_point_does_no_harm(any_solver: Solver) -> None:
    model = made([1, 2], [[1, 1]], [3], [INF], upper=5)
    solution = any_solver.solve(model, Options(start=np.array([0.0, 0.5])))
    assert (solution.status, solution.objective) == (Status.OPTIMAL, 3.0)


def test_a_time_limit_holds(any_solver: Solver) -> None:
    model = hard()
    solution = any_solver.solve(model, Options(time_limit=0.3))
    assert solution.stopped_by == StoppedBy.TIME_LIMIT
    assert solution.status in (Status.FEASIBLE, Status.UNKNOWN)
    if solution.values is not None:
        assert model.violation(solution.values) <= 1e-5
        assert solution.bound is None or solution.bound < solution.objective


@pytest.mark.parametrize("limit", [0.0, 0.2])
def test_highs_is_on_time_while_it_presolves(highs: Solver, limit: float) -> None:
    random = np.random.default_rng(0)
    columns, rows, each = 20_000, 1500, 8
    place = random.integers(0, rows, columns * each)
    entries = (np.ones(columns * each), (place, np.repeat(np.arange(columns), each)))
    matrix = sparse.csr_array(sparse.coo_array(entries, shape=(rows, columns)))
    model = made(random.integers(1, 30, columns), np.zeros((0, columns)), [], [], upper=1)
    model = Model(
        model.objective,
        model.lower,
        model.upper,
        model.integer,
        matrix,
        np.ones(rows),
        np.full(rows, 2.0),
    )
    solution = highs.solve(model, Options(time_limit=limit))
    # it is left behind where it does not hear that its time is up, before its search has begun
    assert (solution.stopped_by, solution.nodes) == (StoppedBy.TIME_LIMIT, 0)


def test_the_first_point_ends_the_search() -> None:
    model = hard()
    for name in NAMES:
        chosen = solver(name)
        if "first" not in chosen.features:
            continue
        solution = chosen.solve(model, Options(first=True, time_limit=30.0))
        assert (solution.status, solution.stopped_by) == (Status.FEASIBLE, None), name
        assert model.violation(solution.values) <= 1e-5


def test_a_gap_ends_the_search(any_solver: Solver) -> None:
    if "gap" not in any_solver.features:
        pytest.skip("the solver takes no gap")
    model = hard(30, 20)
    solution = any_solver.solve(model, Options(gap=0.5))
    assert solution.status in (Status.FEASIBLE, Status.OPTIMAL)
    if solution.status == Status.FEASIBLE:
        assert solution.stopped_by == StoppedBy.GAP
    if solution.bound is not None:
        assert solution.gap <= 0.5


def test_an_absolute_gap_counts_as_none(highs: Solver) -> None:
    model = hard(30, 20)
    best = highs.solve(model)
    near = highs.solve(model, Options(absolute_gap=0.999))
    assert near.status == Status.OPTIMAL
    assert near.objective == pytest.approx(best.objective)


def test_seeds_and_threads_may_change_between_solves(any_solver: Solver) -> None:
    model = hard(20, 15)
    found = [
        any_solver.solve(model, Options(seed=seed, threads=threads)).objective
        for seed, threads in ((1, 1), (2, 2), (None, None), (3, 1))
    ]
    assert found == pytest.approx([found[0]] * 4)


def test_solves_of_different_threads_may_run_at_once(highs: Solver) -> None:
    model, found = hard(25, 18), []

    def work(threads: int) -> None:
        found.append(highs.solve(model, Options(threads=threads)).objective)

    workers = [threading.Thread(target=work, args=(1 + n % 2,)) for n in range(4)]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    assert found == pytest.approx([highs.solve(model).objective] * 4)


def test_a_misspelt_option_is_refused(any_solver: Solver) -> None:
    with pytest.raises(SolverError, match="no_such_thing"):
        any_solver.solve(made([1], [[1]], [1], [2]), Options(extra={"no_such_thing": 1}))


def test_options_of_the_solver_itself(highs: Solver) -> None:
    model = hard(30, 20)
    assert highs.solve(model, Options(extra={"presolve": "off"})).status == Status.OPTIMAL
    with pytest.raises(SolverError, match="did you mean 'presolve'"):
        highs.solve(model, Options(extra={"presolv": "off"}))
    with pytest.raises(SolverError, match="presolve"):
        highs.solve(model, Options(extra={"presolve": "sometimes"}))
    with pytest.raises(SolverError, match="mip_rel_gap"):
        highs.solve(model, Options(extra={"mip_rel_gap": "small"}))


def test_logs_are_streamed(any_solver: Solver) -> None:
    if "log" not in any_solver.features:
        pytest.skip("the solver hands no log over")
    lines: list[str] = []
    any_solver.solve(hard(30, 20), Options(log=lines.append))
    assert any(line.strip() for line in lines)
    assert not any("\n" in line for line in lines)


# --- interruption ----------------------------------------------------------------------------


def test_a_wish_to_stop_is_heard(any_solver: Solver) -> None:
    if any_solver.name in ("pulp:HiGHS", "pulp:GUROBI"):
        pytest.skip("PuLP cannot stop what runs within this process")
    asked = itertools.count()
    options = Options(time_limit=20.0, stop=lambda: next(asked) >= 3)
    assert any_solver.solve(hard(), options).stopped_by == StoppedBy.INTERRUPT


def pressing() -> Callable[[Progress], bool]:
    """A watcher that has Ctrl-C pressed soon after it has heard of the first point."""
    pressed: list[threading.Timer] = []

    def watch(progress: Progress) -> bool:
        if progress.values is not None and not pressed:
            pressed.append(threading.Timer(0.05, os.kill, (os.getpid(), signal.SIGINT)))
            pressed[0].start()
        return False

    return watch


@pytest.mark.parametrize("name", ["highs", "gurobi"])
def test_ctrl_c_keeps_the_incumbent(name: str) -> None:
    if name not in NAMES:
        pytest.skip("the solver may not be used here")
    solution = solver(name).solve(hard(), Options(time_limit=20.0), pressing())
    assert (solution.status, solution.stopped_by) == (Status.FEASIBLE, StoppedBy.INTERRUPT)


@pytest.mark.parametrize("name", ["highs", "gurobi"])
def test_a_handler_of_the_programs_own_hears_ctrl_c(name: str) -> None:
    if name not in NAMES:
        pytest.skip("the solver may not be used here")
    heard: list[int] = []
    former = signal.signal(signal.SIGINT, lambda number, _: heard.append(number))
    try:
        options = Options(time_limit=20.0, stop=lambda: bool(heard))
        solution = solver(name).solve(hard(), options, pressing())
    finally:
        signal.signal(signal.SIGINT, former)
    assert heard == [signal.SIGINT]
    assert solution.stopped_by == StoppedBy.INTERRUPT


def test_watchers_hear_in_the_calling_thread_and_may_stop() -> None:
    for name in ("highs", "gurobi"):
        if name not in NAMES:
            continue
        model, seen = hard(), []

        def watch(progress: Progress, seen=seen) -> bool:
            assert threading.current_thread() is threading.main_thread()
            seen.append(progress)
            return progress.values is not None and progress.bound is not None

        solution = solver(name).solve(model, Options(time_limit=20.0), watch)
        assert (solution.status, solution.stopped_by) == (Status.FEASIBLE, StoppedBy.INTERRUPT)
        last = seen[-1]
        assert model.violation(last.values) <= 1e-5
        assert model.objective @ last.values == pytest.approx(last.objective)
        assert last.gap >= 0
        assert last.bound <= solution.objective


def test_an_error_in_a_watcher_comes_through(highs: Solver) -> None:
    def watch(_: Progress) -> bool:
        raise LookupError("mine")

    with pytest.raises(LookupError, match="mine"):
        highs.solve(hard(), Options(time_limit=20.0), watch)
    assert highs.solve(made([1], [[1]], [1], [2])).objective == 1.0


# --- availability ----------------------------------------------------------------------------


def test_highs_is_always_there() -> None:
    assert "highs" in NAMES
    assert available()["highs"].version


def test_a_licence_that_is_too_small_is_refused_in_words() -> None:
    if "gurobi" not in NAMES:
        pytest.skip("gurobipy is not usable here")
    count, said = 2500, ""
    model = made(-np.ones(count), np.ones((1, count)), [-INF], [9], upper=1)
    try:
        solver("gurobi").solve(model, Options())
    except SolverUnavailableError as error:
        said = str(error)
    else:
        pytest.skip("the licence here allows such models")
    assert "too small for 2500 columns" in said
    assert "--solver highs" in said


def test_models_go_into_native_objects(any_solver: Solver) -> None:
    native = any_solver.native(made([1, 2], [[1, 1]], [1], [2]))
    assert type(native).__name__ in ("Highs", "Model", "LpProblem")


def test_no_solver_is_imported_unasked() -> None:
    code = (
        "import sys, tsplan, tsplan.milp.solver as s; s.solver('highs');"
        "print(*sorted({'gurobipy', 'pulp'} & set(sys.modules)))"
    )
    assert printed(code).strip() == ""


def test_what_is_missing_is_said(monkeypatch) -> None:
    for name, module in (("gurobi", "gurobipy"), ("pulp", "pulp")):
        monkeypatch.setattr(f"tsplan.milp.{name}.find_spec", lambda _: None)
        with pytest.raises(SolverUnavailableError, match=rf"installed; pip install .*{name}"):
            solver(name)
        assert not available()[name].installed, module
    assert installed() == ["highs"]


def calls(work: Callable[[], object]) -> int:
    """How many functions of Python and of native code are called while some work is done."""
    seen = itertools.count()
    sys.setprofile(lambda _, event, __: next(seen) if event in ("call", "c_call") else None)
    try:
        work()
    finally:
        sys.setprofile(None)
    return next(seen)


def test_highs_loads_columns_all_at_once() -> None:
    models = [made(np.ones(count), np.ones((1, count)), [0], [1]) for count in (10, 100_000)]
    few, many = [calls(lambda model=model: load(model)) for model in models]
    assert many == few
