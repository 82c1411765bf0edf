"""Bounds in whole numbers: true whatever multipliers are named, and worth what fractions say."""

from __future__ import annotations

from fractions import Fraction
from math import inf, isfinite

import numpy as np
import pytest
from hypothesis import given

from tests.lying import lie
from tests.seeds import quick, seeds
from tsplan.milp.exact_rows import COARSE, FINE, ExactRows, implied_most
from tsplan.milp.lp import WarmLP
from tsplan.milp.model import Draft, Model
from tsplan.milp.proven_lp import ProvenLP, Tally, float_below


def drawn(random: np.random.Generator, scale: float = 1.0) -> tuple[Model, np.ndarray]:
    """A program of rows that a drawn point meets, and that point."""
    rows, columns = random.integers(1, 6), random.integers(1, 8)
    point = random.integers(0, 5, columns).astype(np.float64)
    matrix = random.integers(-3, 4, (rows, columns)) * (random.random((rows, columns)) < 0.6)
    worth = matrix * scale @ point
    lower = np.where(random.random(rows) < 0.4, -inf, worth - random.integers(0, 3, rows))
    upper = np.where(random.random(rows) < 0.4, inf, worth + random.integers(0, 3, rows))
    draft = Draft()
    draft.columns(int(columns), 0.0, 5.0, integer=True)
    index, column = np.nonzero(np.ones_like(matrix))
    draft.rows(
        index, column, (matrix * scale)[index, column], lower=lower, upper=upper, kind="drawn"
    )
    costs = random.integers(-4, 9, columns) * scale
    return draft.build().with_objective(costs), point


def by_fractions(model: Model, row_of: dict[int, Fraction], priced: bool) -> Fraction:
    """The same bound, worked out number by number."""
    reduced = [Fraction(c) if priced else Fraction(0) for c in model.objective.tolist()]
    total = Fraction(0)
    for row, factor in row_of.items():
        side = model.row_lower[row] if factor > 0 else model.row_upper[row]
        total += factor * Fraction(float(side))
        begin, end = model.matrix.indptr[row], model.matrix.indptr[row + 1]
        for place in range(begin, end):
            entry = Fraction(float(model.matrix.data[place]))
            reduced[model.matrix.indices[place]] -= factor * entry
    ends = zip(reduced, model.lower.tolist(), model.upper.tolist(), strict=True)
    return total + sum(min(d * Fraction(low), d * Fraction(high)) for d, low, high in ends)


@quick
@given(seeds)
def test_any_multipliers_give_a_true_bound(seed):
    random = np.random.default_rng(seed)
    scale = float(random.choice([1.0, 0.5, 0.1, 1e6, 1e15]))
    model, point = drawn(random, scale)
    exact = ExactRows.of(model)
    duals = random.normal(0, random.choice([1.0, 100.0, 1e12]), len(model.row_lower))
    for digits in (COARSE, FINE):
        for priced in (True, False):
            found = exact.bounded(duals, model.lower, model.upper, priced=priced, digits=digits)
            assert found is not None
            factors = dict(found.multipliers.fractions())
            assert found.value == by_fractions(model, factors, priced)
            worth = sum(
                Fraction(float(c)) * Fraction(x)
                for c, x in zip(model.objective, point.tolist(), strict=True)
            )
            assert found.value <= (worth if priced else 0)
            assert all(
                isfinite(model.row_lower[row] if factor > 0 else model.row_upper[row])
                for row, factor in factors.items()
            )


def test_equations_bound_what_they_define():
    draft = Draft()
    x = draft.columns(2, upper=3.0)
    totals = draft.columns(2)
    draft.define(totals[:1], (0, x, 2.0), kind="total")
    draft.define(totals[1:], (0, totals[:1], 1.0), (0, x[:1], -1.0), constant=4.0, kind="total")
    free = draft.columns(1)
    draft.sums((0, free, 1.0), (0, x[:1], 1.0), lower=0.0, kind="no equation")
    assert implied_most(draft.build()).tolist() == [3.0, 3.0, 12.0, 16.0, inf]


def test_a_column_without_a_bound_leaves_nothing_to_say():
    draft = Draft()
    x = draft.columns(1)
    draft.sums((0, x, 1.0), lower=2.0, kind="least")
    model = draft.build().with_objective(np.array([-1.0]))
    exact = ExactRows.of(model)
    assert exact.bounded(np.array([1.0]), model.lower, model.upper) is None
    priced = ExactRows.of(model.with_objective(np.array([1.0])))
    found = priced.bounded(np.array([1.0]), model.lower, model.upper)
    assert found is not None
    assert found.value == 2


@quick
@given(seeds)
def test_proven_programs_say_what_plain_ones_do(seed):
    random = np.random.default_rng(seed)
    model, _ = drawn(random)
    if seed % 3 == 0:  # mostly without a point
        model = model.with_row(np.ones(len(model.lower)), 5 * len(model.lower) - 1.0, inf, "much")
    tally = Tally()
    plain, proven = WarmLP(model).solve(), ProvenLP(model, tally=tally).solve()
    assert proven.status == plain.status
    assert (tally.verified, tally.unproven) == (1, 0)
    if plain.status == "optimal":
        assert proven.objective == pytest.approx(plain.objective, abs=1e-4)
        assert proven.objective <= plain.objective + 1e-9 * max(1.0, abs(plain.objective))


@pytest.mark.parametrize("seed", range(40))
def test_a_lying_program_proves_nothing_wrong(seed, monkeypatch):
    random = np.random.default_rng(seed)
    model, point = drawn(random)
    if seed % 3 == 0:
        model = model.with_row(np.ones(len(model.lower)), 5 * len(model.lower) - 1.0, inf, "much")
    truth = WarmLP(model).solve()
    lie(monkeypatch, seed)
    lp = ProvenLP(model)
    for _ in range(5):
        told = lp.solve(cutoff=float(model.objective @ point) + 1)
        if told.status == "optimal":
            assert told.objective <= truth.objective + 1e-9
        elif told.status in ("infeasible", "cutoff"):
            below = truth.objective > model.objective @ point + 1
            assert truth.status == "infeasible" or (told.status == "cutoff" and below)


def test_the_double_below_a_fraction_is_not_above_it():
    for number in (Fraction(1, 3), Fraction(-1, 3), Fraction(10**20 + 1), Fraction(7)):
        assert Fraction(float_below(number)) <= number
        assert float_below(number) == pytest.approx(float(number))
