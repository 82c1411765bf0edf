"""A solver is added by one class and one line in the registry; this follows the recipe."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest

import tsplan
from tests.test_milp_solvers import INF, made
from tsplan.milp import solver as registry
from tsplan.milp.model import Model
from tsplan.milp.request import RawResult, Request
from tsplan.milp.solution import Status
from tsplan.milp.solver import Availability, Solver, available, installed, solver
from tsplan.ts.builders import grid


class Listing(Solver):
    """Tries every point."""

    name = "listing"
    features = frozenset()
    asked = 0

    def availability(self) -> Availability:
        return Availability(version="1")

    def native(self, model: Model) -> Model:
        return model

    def answer(self, request: Request) -> RawResult:
        Listing.asked += 1
        ends = zip(request.model.lower.tolist(), request.model.upper.tolist(), strict=True)
        listed = map(request.rounded, product(*(np.arange(low, high + 1) for low, high in ends)))
        points = [point for point in listed if point is not None]
        if not points:
            return RawResult(Status.INFEASIBLE)
        best = min(points, key=request.objective)
        return RawResult(Status.OPTIMAL, best, request.objective(best))


@pytest.fixture(autouse=True)
def added(monkeypatch) -> None:
    """The line in the registry."""
    monkeypatch.setattr(registry, "SOLVERS", {**registry.SOLVERS, "listing": Listing})
    Listing.asked = 0


def test_it_is_found_and_answers_as_the_others_do() -> None:
    assert installed()[-1] == "listing"
    assert available()["listing"].usable
    model = made([-2, -3], [[1, 2], [3, 1]], [-INF, -INF], [7, 9], upper=4)
    for each in (model, model.with_row(np.ones(2), 9, INF, "too much")):
        mine, known = (solver(name).solve(each) for name in ("listing", "highs"))
        assert (mine.status, mine.objective) == (known.status, known.objective)
    assert Listing.asked == 2


def test_missions_are_planned_with_it() -> None:
    corridor = grid(1, 3, labels={(0, 2): "dock"}, name="corridor")
    mission = tsplan.Mission.of(
        map=corridor,
        team=[tsplan.Group.of("cart", {"r0c0": 1})],
        formula="F[0,2] dock",
        language="mtl",
        objective=["travel"],
    )
    plan = tsplan.plan(mission, solver="listing", without=("tree", "dive"))
    assert (plan.status, plan.solver.name, plan.objective[0].value) == ("optimal", "listing", 2)
    assert Listing.asked
