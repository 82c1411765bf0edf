"""The array model and every installed solver on small models with known answers."""

from __future__ import annotations

import pickle

import numpy as np
import pytest

from tests.seeds import sampled
from tsplan.errors import Finding, FormulaError, SolverUnavailableError
from tsplan.milp.highs import Highs
from tsplan.milp.model import Draft, Model
from tsplan.milp.solution import Options, Solution, Status
from tsplan.milp.solver import Solver, solver
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


@pytest.mark.parametrize("seed", sampled(range(2), [0]))
def test_solvers_agree_on_random_knapsacks(any_solver: Solver, seed: int) -> None:
    model = knapsack(18, seed)
    expected = Highs().solve(model, Options())
    found = any_solver.solve(model, Options(threads=1, seed=3))
    assert found.status == Status.OPTIMAL
    assert found.objective == pytest.approx(expected.objective)


def test_a_start_is_used() -> None:
    model = knapsack(40)
    best = Highs().solve(model, Options())
    again = Highs().solve(model, Options(start=best.values, first=True))
    assert again.objective <= best.objective + 1e-6


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


def test_input_errors_survive_the_way_between_processes() -> None:
    error = FormulaError([Finding("wrong", "mend it", "f.yaml", 1, 2)])
    again = pickle.loads(pickle.dumps(error))
    assert (type(again), again.findings) == (FormulaError, error.findings)
