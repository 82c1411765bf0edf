"""Warm linear programs against programs solved from scratch."""

from __future__ import annotations

import numpy as np
import pytest
from highspy import HighsModelStatus as Ended
from scipy import sparse
from scipy.optimize import linprog

from tests.seeds import sampled
from tsplan.errors import SolverError
from tsplan.milp.lp import WarmLP
from tsplan.milp.model import Model

INF = np.inf


class Pair:
    """A warm program and a dense copy of it that is solved from scratch."""

    def __init__(self, seed: int, stop) -> None:
        self.random = random = np.random.default_rng(seed)
        columns, rows = int(random.integers(3, 25)), int(random.integers(2, 15))
        self.matrix = random.integers(-3, 4, (rows, columns)).astype(float)
        self.row_lower = random.integers(-6, 1, rows).astype(float)
        self.row_upper = self.row_lower + random.integers(0, 8, rows)
        self.cost = random.integers(-5, 6, columns).astype(float)
        self.lower, self.upper = np.zeros(columns), np.full(columns, 4.0)
        self.lp = WarmLP(self.model, stop)

    @property
    def model(self) -> Model:
        return Model(
            self.cost,
            self.lower,
            self.upper,
            np.ones(len(self.cost), dtype=bool),
            sparse.csr_array(self.matrix),
            self.row_lower,
            self.row_upper,
            offset=2.0,
        )

    def fix(self) -> None:
        columns = self.random.choice(len(self.cost), 2, replace=False)
        values = self.random.integers(0, 5, 2).astype(float)
        self.lower, self.upper = self.lower.copy(), self.upper.copy()
        self.lower[columns] = self.upper[columns] = values
        self.lp.bounds(columns, values, values)

    def release(self) -> None:
        count = len(self.cost)
        self.lower, self.upper = np.zeros(count), np.full(count, 4.0)
        self.lp.bounds(np.arange(count), 0.0, 4.0)

    def add(self) -> None:
        rows = self.random.integers(-2, 3, (2, len(self.cost))).astype(float)
        self.matrix = np.vstack([self.matrix, rows])
        self.row_lower = np.append(self.row_lower, [-INF, -9.0])
        self.row_upper = np.append(self.row_upper, [5.0, INF])
        self.lp.add_rows(sparse.csr_array(rows), self.row_lower[-2:], self.row_upper[-2:])

    def take_away(self) -> None:
        if len(self.matrix) < 3:
            return
        self.lp.delete_rows(np.array([0, 2]))
        self.matrix = np.delete(self.matrix, [0, 2], axis=0)
        self.row_lower = np.delete(self.row_lower, [0, 2])
        self.row_upper = np.delete(self.row_upper, [0, 2])

    def price(self) -> None:
        self.cost = self.random.integers(-5, 6, len(self.cost)).astype(float)
        self.lp.costs(np.arange(len(self.cost)), self.cost)

    def from_scratch(self) -> float | None:
        low, high = np.isfinite(self.row_lower), np.isfinite(self.row_upper)
        found = linprog(
            self.cost,
            np.vstack([self.matrix[high], -self.matrix[low]]),
            np.append(self.row_upper[high], -self.row_lower[low]),
            bounds=list(zip(self.lower, self.upper, strict=True)),
        )
        return float(found.fun) + 2.0 if found.status == 0 else None

    def compare(self) -> None:
        limit = 9.0 if self.random.random() < 0.5 else None
        cutoff = float(self.random.integers(-60, 20)) if self.random.random() < 0.5 else None
        found, expected = self.lp.solve(time_limit=limit, cutoff=cutoff), self.from_scratch()
        assert self.lp.row_count == len(self.matrix)
        if found.status == "optimal":
            assert found.objective == pytest.approx(expected, abs=1e-6)
            assert cutoff is None or found.objective <= cutoff
            assert self.model.with_integrality(np.zeros(len(self.cost), dtype=bool)).violation(
                found.values
            ) == pytest.approx(0.0, abs=1e-6)
            duals = found.reduced_costs + self.matrix.T @ found.row_duals
            assert duals == pytest.approx(self.cost, abs=1e-6)
        elif found.status == "infeasible":
            assert expected is None
        else:
            assert found.status == "cutoff"
            assert cutoff is not None
            assert expected is None or expected > cutoff - 1e-6
        if found.status != "optimal":
            assert found.objective == INF
            assert found.values is found.row_duals is found.reduced_costs is None


@pytest.mark.parametrize("seed", sampled(range(30), range(10)))
def test_changes_are_followed(seed: int) -> None:
    pair = Pair(seed, (lambda: False) if seed % 2 else None)
    changes = [pair.fix, pair.release, pair.add, pair.take_away, pair.price]
    for _ in range(12):
        changes[pair.random.integers(len(changes))]()
        pair.compare()


def large(columns: int = 1500, rows: int = 800) -> Model:
    random = np.random.default_rng(3)
    matrix = sparse.csr_array(
        sparse.random_array((rows, columns), density=10 / columns, format="csr", rng=random)
    )
    return Model(
        -random.integers(1, 9, columns).astype(float),
        np.zeros(columns),
        np.full(columns, 3.0),
        np.zeros(columns, dtype=bool),
        matrix,
        np.full(rows, -INF),
        np.full(rows, 5.0),
    )


def test_a_time_limit_ends_a_solve_and_the_next_goes_on() -> None:
    lp = WarmLP(large())
    assert lp.solve(time_limit=0.01).status == "limit"
    assert lp.solve(time_limit=0.0).status == "limit"
    assert lp.solve().status == "optimal"
    # the limits of later solves are their own, though HiGHS counts all seconds together
    assert lp.solve(time_limit=5.0).status == "optimal"


def test_a_wish_to_stop_ends_a_solve(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("tsplan.milp.lp._QUIET", 0.0)  # asked from the first iteration on
    wish = False
    lp = WarmLP(large(), lambda: wish)
    wish = True
    assert lp.solve().status == "limit"
    wish = False
    assert lp.solve().status == "optimal"
    lp.costs(np.arange(1500), -np.random.default_rng(9).integers(1, 99, 1500).astype(float))
    wish = True
    assert lp.solve().status == "limit"


def test_results_stay_what_they_were() -> None:
    pair = Pair(2, None)
    pair.release()
    first = pair.lp.solve()
    pair.price()
    pair.lp.solve()
    again = WarmLP(Pair(2, None).model).solve()
    assert first.objective == pytest.approx(again.objective)
    assert first.objective == pytest.approx(Pair(2, None).cost @ first.values + 2.0)


def test_unbounded_programs_are_errors() -> None:
    model = Model(
        np.array([-1.0]),
        np.zeros(1),
        np.full(1, INF),
        np.zeros(1, dtype=bool),
        sparse.csr_array((0, 1)),
        np.zeros(0),
        np.zeros(0),
    )
    with pytest.raises(SolverError, match="nbounded"):
        WarmLP(model).solve()


@pytest.mark.parametrize(("low", "status"), [(0.0, "optimal"), (1.0, "infeasible")])
def test_programs_without_columns(low: float, status: str) -> None:
    nothing = np.zeros(0)
    model = Model(
        nothing,
        nothing,
        nothing,
        np.zeros(0, dtype=bool),
        sparse.csr_array((1, 0)),
        np.array([low]),
        np.array([2.0]),
        offset=3.0,
    )
    found = WarmLP(model).solve()
    assert found.status == status
    if status == "optimal":
        assert (found.objective, found.values.tolist()) == (3.0, [])


def test_bad_changes_are_errors() -> None:
    lp = WarmLP(large(10, 5))
    with pytest.raises(SolverError, match="refused"):
        lp.bounds(np.array([10]), 0.0, 1.0)
    with pytest.raises(SolverError, match="refused"):
        lp.delete_rows(np.array([7]))


def test_solving_again_costs_little(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("tsplan.milp.lp._QUIET", INF)  # however slow this machine is
    asked: list[int] = []
    lp = WarmLP(large(60, 40), lambda: bool(asked.append(1)))
    lp.solve()
    first, asked[:] = lp._highs.getInfo().simplex_iteration_count, []
    iterations = 0
    for number in range(200):
        lp.bounds(np.array([number % 60]), 0.0, float(number % 2))
        lp.solve(time_limit=1e9, cutoff=1e9)
        iterations += lp._highs.getInfo().simplex_iteration_count
    assert asked == []  # nobody is called back
    assert iterations < 200 * first / 4  # the last basis is gone on from


@pytest.mark.parametrize("seed", range(5))
def test_what_presolve_calls_infeasible_is_solved_without_it(seed: int, monkeypatch) -> None:
    pair = Pair(seed, None)
    right = pair.lp.solve()
    fresh = Pair(seed, None).lp
    run, presolved = fresh._run, []

    def lying(until: float) -> Ended:
        presolved.append(fresh._highs.getOptionValue("presolve")[1] != "off")
        ended = run(until)
        return Ended.kInfeasible if len(presolved) == 1 else ended

    monkeypatch.setattr(fresh, "_run", lying)
    found = fresh.solve()
    assert (found.status, found.objective) == (right.status, pytest.approx(right.objective))
    assert presolved == [True, False]
