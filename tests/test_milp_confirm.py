"""Solvers are not believed: what they say wrongly is found out, or is no proof."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from pathlib import Path
from random import Random

import numpy as np
import pytest
from scipy import sparse

import tsplan
from tests.seeds import sampled
from tsplan.clock import Clock
from tsplan.encode.assemble import tight
from tsplan.encode.preparation import prepare
from tsplan.encode.priced_objectives import Travel
from tsplan.errors import SolverError
from tsplan.milp import highs
from tsplan.milp.confirmation import confirmed
from tsplan.milp.highs import Highs
from tsplan.milp.model import Model
from tsplan.milp.request import RawResult, Request
from tsplan.milp.solution import Options, Solution, Status
from tsplan.milp.solver import installed, solver
from tsplan.milp.target import Target
from tsplan.search import search
from tsplan.search.effort import Effort
from tsplan.search.standing import Standing
from tsplan.stopping import StoppedBy
from tsplan.testing import random_mission

ONCE_WRONG = sorted((Path(__file__).parent / "models").glob("*.json"))
AGGREGATOR = Path(__file__).parent / "models" / "aggregator.json"


def numbers(values: list[float | None], missing: float) -> np.ndarray:
    return np.array([missing if value is None else value for value in values], dtype=float)


def read(path: Path) -> tuple[Model, np.ndarray, float]:
    """A model that some release of a solver was wrong about, its start and its true optimum."""
    data = json.loads(path.read_text(encoding="utf-8"))
    entries = [(i, j, v) for i, row in enumerate(data["rows"]) for j, v in row]
    rows, columns, values = zip(*entries, strict=True)
    shape = (len(data["rows"]), len(data["objective"]))
    model = Model(
        numbers(data["objective"], 0.0),
        numbers(data["lower"], -np.inf),
        numbers(data["upper"], np.inf),
        np.array(data["integer"], dtype=bool),
        sparse.csr_array(sparse.coo_array((values, (rows, columns)), shape=shape)),
        numbers(data["row_lower"], -np.inf),
        numbers(data["row_upper"], np.inf),
    )
    return model, numbers(data["start"], 0.0), data["optimum"]


def fits(name: str, model: Model) -> bool:
    return name != "gurobi" or max(model.size.columns, model.size.rows) < 2000


@pytest.mark.parametrize("path", ONCE_WRONG, ids=lambda path: path.stem)
@pytest.mark.parametrize("name", installed())
def test_models_that_solvers_were_wrong_about(path: Path, name: str) -> None:
    model, start, optimum = read(path)
    found = confirmed(solver(name), model, Options(start=start, time_limit=30.0))
    assert (found.status, found.objective) == (Status.OPTIMAL, optimum)


@pytest.mark.parametrize("name", installed())
def test_models_that_some_rule_of_presolve_is_wrong_about(name: str) -> None:
    """Their neighbours are judged with presolve as without."""
    model, _, _ = read(AGGREGATOR)
    random = np.random.default_rng(3)  # HiGHS with all its rules calls a worse point optimal
    seen = set()
    for _ in range(10):
        kept = np.flatnonzero(random.random(model.size.rows) > random.choice([0.0, 0.02, 0.1]))
        costs = random.integers(0, 9, model.size.columns) * (
            random.random(model.size.columns) < 0.3
        )
        near = replace(
            model.with_objective(costs.astype(float)),
            matrix=model.matrix[kept],
            row_lower=model.row_lower[kept],
            row_upper=model.row_upper[kept],
            upper=np.where(random.random(model.size.columns) < 0.02, model.lower, model.upper),
        )
        expected = Highs().solve(near, Options(presolve=False))
        found = confirmed(solver(name), near, Options())
        assert (found.status, found.objective) == (expected.status, expected.objective)
        seen.add(found.status)
    assert Status.OPTIMAL in seen


def test_presolve_alone_proves_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    """HiGHS with all its rules is wrong about this model with every seed, and is found out."""
    model, start, optimum = read(AGGREGATOR)
    monkeypatch.setattr(highs, "rules_off", lambda _: 0)
    for seed in range(3):
        assert (
            Highs().solve(model, Options(seed=seed)).status is Status.INFEASIBLE
        )  # else go by lies
    found = confirmed(Highs(), model, Options(start=start))
    assert (found.status, found.objective) == (Status.OPTIMAL, optimum)


def knapsack(seed: int) -> Model:
    """A small model with points of many values; the least one is found by listing them."""
    random = np.random.default_rng(seed)
    return Model(
        -random.integers(1, 9, 5).astype(float),
        np.zeros(5),
        np.full(5, 2.0),
        np.ones(5, dtype=bool),
        sparse.csr_array(random.integers(1, 6, (2, 5)).astype(float)),
        np.full(2, -np.inf),
        np.array([9.0, 11.0]),
    )


def listed(model: Model) -> float:
    points = np.array(np.meshgrid(*[range(3)] * 5)).reshape(5, -1)
    good = (model.matrix @ points <= model.row_upper[:, None]).all(axis=0)
    return float((model.objective @ points[:, good]).min())


Lie = Callable[[Request, RawResult], RawResult]


def worse(question: Request, said: RawResult) -> RawResult:
    """A point that is not the best is called so; the bound stays what it is."""
    return replace(said, values=np.zeros_like(said.values))


def refuted(question: Request, said: RawResult) -> RawResult:
    return RawResult(Status.INFEASIBLE)


def outside(question: Request, said: RawResult) -> RawResult:
    return replace(said, values=said.values + 1.0)


def trouble(question: Request, said: RawResult) -> RawResult:
    raise SolverError("the arithmetic fails")


def split(question: Request, said: RawResult) -> RawResult:
    return replace(said, values=said.values - 0.6)


def silent(question: Request, said: RawResult) -> RawResult:
    """A worse point without any bound."""
    return RawResult(Status.OPTIMAL, np.zeros_like(said.values))


def high(question: Request, said: RawResult) -> RawResult:
    """A bound above the point."""
    return replace(said, values=np.zeros_like(said.values), bound=3.0)


@dataclass
class Liar:
    """HiGHS, whose answers are changed in the runs that `lies` lists."""

    lies: dict[int, Lie]
    runs: list[Options] = field(default_factory=list)
    name: str = "liar"
    features: frozenset[str] = Highs.features

    def solve(self, model: Model, options: Options, watch=None) -> Solution:
        lie = self.lies.get(len(self.runs))
        self.runs.append(options)
        found = Highs().solve(model, options, watch)
        if lie is None or found.values is None:
            return found
        question = Request(model, options)
        said = RawResult(Status.OPTIMAL, found.values, found.bound)
        return question.solution(lie(question, said), found.seconds)


@pytest.mark.parametrize("lie", [worse, refuted, outside, split, silent, high])
@pytest.mark.parametrize("seed", range(5))
def test_a_lie_is_found_out(lie: Lie, seed: int) -> None:
    model = knapsack(seed)
    liar = Liar({0: lie})
    found = confirmed(liar, model, Options())
    assert (found.status, found.objective) == (Status.OPTIMAL, listed(model))
    assert len(liar.runs) > 1


def test_each_setting_is_tried_once() -> None:
    liar = Liar(dict.fromkeys(range(9), worse))
    start = np.zeros(5)
    found = confirmed(liar, knapsack(0), Options(start=start, seed=7))
    assert (found.status, found.stopped_by) == (Status.FEASIBLE, StoppedBy.PRECISION)
    assert found.bound is not None
    assert found.bound <= listed(knapsack(0)) + 1e-6
    assert [run.start is None for run in liar.runs] == [False, True, True]
    assert [run.presolve for run in liar.runs] == [True, True, False]
    assert len({run.seed for run in liar.runs}) == 2


def test_points_and_refutations_contradict_each_other() -> None:
    with pytest.raises(SolverError, match="another has a point"):
        confirmed(Liar({0: worse, 1: refuted}), knapsack(1), Options())
    with pytest.raises(SolverError, match="violates"):
        confirmed(Liar(dict.fromkeys(range(9), outside)), knapsack(1), Options())


def test_an_optimum_without_a_bound_is_said_twice() -> None:
    def mute(question: Request, said: RawResult) -> RawResult:
        return replace(said, bound=None)

    liar = Liar(dict.fromkeys(range(9), mute))
    found = confirmed(liar, knapsack(0), Options())
    assert (found.status, found.objective) == (Status.OPTIMAL, listed(knapsack(0)))
    assert len(liar.runs) == 2
    liar = Liar({0: silent, 1: mute, 2: mute})
    found = confirmed(liar, knapsack(0), Options())
    assert (found.status, found.objective) == (Status.OPTIMAL, listed(knapsack(0)))
    liar = Liar({0: silent, 1: mute, 2: worse})
    found = confirmed(liar, knapsack(0), Options())
    assert (found.status, found.stopped_by) == (Status.FEASIBLE, StoppedBy.PRECISION)


def test_infeasible_is_said_twice() -> None:
    model = replace(knapsack(2), row_upper=np.array([-1.0, 11.0]), lower=np.full(5, -0.1))
    liar = Liar({})
    assert confirmed(liar, model, Options()).status is Status.INFEASIBLE
    assert [run.presolve for run in liar.runs] == [True, False]


@pytest.mark.parametrize("seed", range(3))
def test_lies_that_presolve_tells_with_every_seed_are_no_proof(seed: int) -> None:
    liar = Liar({0: refuted, 1: trouble, 2: refuted})
    found = confirmed(liar, knapsack(seed), Options())
    assert (found.status, found.stopped_by) == (Status.UNKNOWN, StoppedBy.PRECISION)
    assert [run.presolve for run in liar.runs] == [True, False, True]
    always = Liar({0: refuted, 1: refuted}, features=Highs.features - {"presolve"})
    assert confirmed(always, knapsack(seed), Options()).status is Status.INFEASIBLE


@pytest.mark.parametrize("step", [1.0, 0.0])
def test_a_bound_that_a_plan_refutes_is_no_proof(step: float) -> None:
    mission = random_mission(3)
    setting = prepare(mission)
    encoded = tight(setting)
    target = Target(Travel().vector(setting, encoded), step=step)
    effort = Effort(Highs())
    known = search.Search(encoded, target, effort, Clock(), lambda *_: None).minimise()
    assert known.proven
    fresh = Standing(target, lambda *_: None)
    fresh.accept(known.values, encoded.model)
    fresh.raise_bound(known.objective + 5.0)
    assert not fresh.done
    fresh.raise_bound(known.objective + 1e-9)  # rounding is no contradiction
    assert fresh.done


def test_a_first_point_is_enough() -> None:
    liar = Liar({})
    found = confirmed(liar, knapsack(3), Options(first=True))
    assert found.values is not None
    assert len(liar.runs) == 1


@pytest.mark.parametrize("block", sampled(range(4), range(2)))
def test_a_solver_that_lies_now_and_then_never_makes_a_wrong_plan(block: int, monkeypatch) -> None:
    """Plans are as good as without lies, or open; nothing wrong is ever called proven."""
    random = Random(block)
    told = 0

    def lying(made, model, options, watch=None):
        nonlocal told
        number = random.randrange(3)
        liar = Liar({number: random.choice([worse, refuted, outside, split, silent, high])})
        found = confirmed(liar, model, options, watch)
        told += len(liar.runs)
        return found

    for seed in range(400 + 15 * block, 415 + 15 * block):
        mission = random_mission(seed)
        monkeypatch.setattr(search, "confirmed", confirmed)
        right = tsplan.plan(mission)
        monkeypatch.setattr(search, "confirmed", lying)
        found = tsplan.plan(mission, without=("tree", "dive"))
        assert found.status in (right.status, "feasible", "no_plan_found")
        if found.status == "optimal":
            assert found.objective == right.objective
    assert told > 0
