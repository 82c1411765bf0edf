"""Solvers that lie on purpose: about statuses, bounds, points, multipliers and rays."""

from __future__ import annotations

from dataclasses import replace
from random import Random
from types import SimpleNamespace
from typing import Any

import numpy as np

from tsplan.milp import solver as registry
from tsplan.milp.highs import Highs
from tsplan.milp.lp import LPResult, WarmLP
from tsplan.milp.request import RawResult, Request
from tsplan.milp.solution import Status

OFTEN = 0.4


def shaken(random: Random, numbers: Any) -> Any:
    """Numbers of which some are others."""
    made = np.array(numbers, dtype=np.float64)
    for place in random.sample(range(len(made)), k=min(len(made), random.randint(0, 5))):
        made[place] += random.choice([-3.0, -1.0, -0.5, 0.5, 1.0, 7.0])
    return made


def lying_solver(random: Random) -> type[Highs]:
    """A solver of integer programs of whose answers many are false."""

    class Lying(Highs):
        name = "lying"

        def answer(self, request: Request) -> RawResult:
            honest = super().answer(request)
            lie = random.choice(("status", "bound", "point", "nothing"))
            if random.random() > OFTEN or lie == "nothing":
                return honest
            if lie == "status":
                return replace(honest, status=random.choice([Status.OPTIMAL, Status.INFEASIBLE]))
            if lie == "bound":
                known = 0.0 if honest.bound is None else honest.bound
                return replace(honest, bound=known + random.choice([-5.0, 1.0, 4.0]))
            values = None if honest.values is None else shaken(random, honest.values)
            return replace(honest, values=values)

    return Lying


def lie(monkeypatch: Any, seed: int) -> None:
    """Let the solver `lying`, and all linear programs, lie by chance."""
    random = Random(seed)
    kind = lying_solver(random)
    monkeypatch.setattr(registry, "SOLVERS", {**registry.SOLVERS, "lying": kind})
    honest, multipliers, ray = WarmLP.solve, WarmLP.multipliers, WarmLP.ray

    def solve(self: WarmLP, time_limit: float | None = None, cutoff: float | None = None) -> Any:
        result = honest(self, time_limit, cutoff)
        if random.random() > OFTEN or result.status == "limit":
            return result
        if result.status == "optimal" and random.random() < OFTEN:
            told = SimpleNamespace(
                col_value=shaken(random, result.values), row_dual=shaken(random, result.row_duals)
            )
            return LPResult("optimal", result.objective + random.choice([-4.0, 2.0]), 0.0, told)
        status = random.choice(("infeasible", "cutoff"))
        return LPResult(status, float("inf"), 0.0)

    def dishonest(of: Any) -> Any:
        def told(self: WarmLP) -> Any:
            numbers = of.fget(self)
            if numbers is None or random.random() > OFTEN:
                return numbers
            return shaken(random, numbers)

        return property(told)

    monkeypatch.setattr(WarmLP, "solve", solve)
    monkeypatch.setattr(WarmLP, "multipliers", dishonest(multipliers))
    monkeypatch.setattr(WarmLP, "ray", dishonest(ray))
