"""Bounds and plans by routes of single agents past the tasks of a mission."""

from __future__ import annotations

from dataclasses import replace
from itertools import islice

import numpy as np
import pytest

import tsplan
from tests.many_tasks import mission
from tests.seeds import sampled
from tsplan.clock import Clock
from tsplan.encode.assemble import tight
from tsplan.encode.encoded import Encoded
from tsplan.encode.preparation import prepare
from tsplan.encode.priced_objectives import Travel
from tsplan.milp.solution import Options, Status
from tsplan.milp.solver import solver
from tsplan.mission import Group, Mission
from tsplan.search import stages
from tsplan.search.effort import Effort
from tsplan.search.routes import route_plans
from tsplan.search.routes.cheapest_routes import CheapestRoutes
from tsplan.search.routes.errands import errands_of
from tsplan.search.routes.rewards import Prices, Rewards
from tsplan.search.routes.route_graph import RouteGraph
from tsplan.search.routes.route_plans import RoutePlans
from tsplan.search.routes.route_program import RouteProgram
from tsplan.search.search import Search
from tsplan.testing import random_mission
from tsplan.ts import Edge, State, TransitionSystem


def encoded_of(made: Mission) -> Encoded:
    return tight(prepare(made))


def plans(encoded: Encoded, many: int = 1) -> RoutePlans:
    target = Travel().target(encoded.setting, encoded)
    return RoutePlans(encoded, target, Effort(solver("highs")), Clock(30.0), many)


def best(made: Mission) -> float:
    value = tsplan.plan(made).objective[0].value
    assert value is not None
    return float(value)


@pytest.mark.parametrize("seed", sampled(range(100), range(1)))
def test_the_bound_is_below_the_best_plan_and_above_the_linear_program(seed: int) -> None:
    made = mission(seed)
    found = plans(encoded_of(made)).bound()
    optimum = best(made)
    assert found is not None
    assert 0.8 * optimum <= found <= optimum


TRICKY = {
    "alternatives": "F[6,14] (T(2,l0,{(x,3)}) || T(0,l1,{(y,2)})) && F[4,12] T(1,l2,{(x,2)})",
    "relieved": "F[4,24] T(14,l0,{(x,12)}) && F[8,22] T(1,l1,{(x,9)}) && F[8,22] T(1,l2,{(x,9)})",
    "covered": "G[6,22] F[0,7] T(0,l0,{(y,2)}) && F[8,20] T(1,l1,{(x,3)})",
    "in a row": "F[4,9] (T(1,l0,{(x,2)}) && F[2,9] T(1,l1,{(x,3)})) && F[8,16] T(2,l2,{(y,1)})",
    "at once": "F[6,14] (T(2,l0,{(x,3),(y,2)}) && T(2,l1,{(x,2)})) && F[0,20] T(3,l2,{(x,1)})",
    "until": "(T(0,l0,{(x,1)}) U[4,12] T(2,l1,{(y,2)})) && F[3,18] T(2,l2,{(x,2)})",
}


@pytest.mark.parametrize("formula", TRICKY.values(), ids=TRICKY)
def test_whatever_is_asked_for_the_bound_is_true(formula: str) -> None:
    made = mission(3, tasks=3, formula=formula, agents=12)
    encoded = encoded_of(made)
    plan = tsplan.plan(made)
    routes = plans(encoded)
    found = max([routes.bound() or 0, *islice(routes.raised(lambda: np.inf), 8)])
    if plan.objective:
        assert found <= float(plan.objective[0].value or 0)


def test_agents_may_relieve_each_other() -> None:
    """One of them holds a place until the other comes, who had to be elsewhere before."""
    lengths = {("west", "s"): 2, ("s", "l0"): 2, ("l0", "east"): 2}
    names = ["west", "s", "l0", "east"]
    edges = [Edge(name, name, 1) for name in names]
    for (one, other), steps in lengths.items():
        edges += [Edge(one, other, steps), Edge(other, one, steps)]
    states = [State(name, labels=frozenset([name])) for name in names]
    formula = "F[2,3] T(0,west,{(x,1)}) && F[4,5] T(8,l0,{(x,1)}) && F[9,10] T(0,east,{(y,1)})"
    made = Mission.of(
        map=TransitionSystem.build(states, edges),
        team=[Group.of("one", {"s": 1}, {"x", "y"}), Group.of("other", {"s": 1}, {"x"})],
        formula=formula,
        objective=["travel"],
    )
    encoded = encoded_of(made)
    assert best(made) == 10
    assert plans(encoded).bound() in range(6, 11)


@pytest.mark.parametrize("seed", sampled(range(6000, 7000), range(6000, 6012)))
def test_no_random_mission_has_a_plan_below_its_bound(seed: int) -> None:
    made = random_mission(seed)
    encoded = encoded_of(made)
    if encoded.refuted or not errands_of(encoded):
        return
    target = Travel().target(encoded.setting, encoded)
    routes = RoutePlans(encoded, target, Effort(solver("highs")), Clock(20.0), many=1)
    found = max([routes.bound(), *islice(routes.raised(lambda: np.inf), 8)], key=lambda b: b or 0)
    asked = encoded.model.with_objective(target.vector)
    solution = solver("highs").solve(asked, Options(time_limit=10.0, seed=0))
    if found is not None and solution.status is Status.OPTIMAL:
        assert solution.values is not None
        assert found <= target.value(solution.values)


@pytest.mark.parametrize("seed", sampled(range(20), range(1)))
def test_routes_are_plans_of_the_whole_each_better_than_before(
    seed: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    made = mission(seed, tasks=7)
    monkeypatch.setattr(route_plans, "shifted_plans", lambda *_: None)
    encoded = encoded_of(made)
    routes = plans(encoded)
    search = Search(encoded, routes.target, routes.effort, Clock(), lambda *_: None)
    values = []
    for flows in islice(routes.flows(), 2):
        point = search.adopt(flows)
        assert point is not None
        assert encoded.model.violation(point) < 1e-6
        values.append(routes.target.value(point))
    assert values == sorted(values, reverse=True)
    optimum = best(made)
    assert optimum <= values[-1] <= 1.3 * optimum


def test_where_routes_are_fractions_their_steps_make_a_plan(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(route_plans, "shifted_plans", lambda *_: None)
    monkeypatch.setattr(RouteProgram, "flows", lambda *_: None)
    encoded = encoded_of(mission(1, tasks=6))
    routes = plans(encoded)
    search = Search(encoded, routes.target, routes.effort, Clock(), lambda *_: None)
    point = search.adopt(next(routes.flows()))
    assert point is not None
    assert encoded.model.violation(point) < 1e-6


@pytest.mark.parametrize("parts", [False, True])
def test_the_cheapest_route_is_what_its_columns_cost_less_what_it_is_credited_with(
    *, parts: bool
) -> None:
    encoded = encoded_of(mission(5, tasks=7))
    vector = Travel().target(encoded.setting, encoded).vector
    errands = errands_of(encoded)
    random = np.random.default_rng(1)
    network = encoded.network
    for group, item in enumerate(network.classes):
        own = {k: errand for k, errand in enumerate(errands) if group in errand.classes}
        graph = RouteGraph.of(item, network.horizon, own, {})
        rewards = Rewards(graph, own, len(errands), parts=parts)
        cheapest = CheapestRoutes(group, graph, rewards, vector, 1)
        stay = np.array([errand.stay for errand in errands])
        prices = Prices(*(random.integers(0, 30, len(errands)) * stay for _ in range(3)))
        fees = random.integers(0, 5, len(graph.starts))
        solved = cheapest.solve(prices, fees)
        worth = []
        for route in solved.below(10**9):
            earned = sum(part * prices[way][k] for (way, k), part in route.credits.items())
            worth.append(route.cost + fees[route.start] - earned)
            assert route.cost == vector[route.columns].sum()
        assert min(worth) == pytest.approx(solved.least)


def test_what_the_routes_say_changes_no_answer(monkeypatch: pytest.MonkeyPatch) -> None:
    usual = tsplan.plan(mission(2)).objective
    monkeypatch.setattr(stages, "WIDE", 0)  # every model counts as large
    monkeypatch.setattr(route_plans, "MANY", 1)
    asked = []
    bound = RoutePlans.bound
    monkeypatch.setattr(RoutePlans, "bound", lambda self: asked.append(1) or bound(self))
    assert tsplan.plan(mission(2)).objective == usual
    assert asked
    asked.clear()
    assert tsplan.plan(mission(2), without=["routes"]).objective == usual
    assert not asked


def test_routes_that_run_an_errand_again_are_remembered_away() -> None:
    encoded = encoded_of(mission(1, tasks=8, agents=40))
    target = Travel().target(encoded.setting, encoded)
    program = RouteProgram(encoded.network, target.vector, errands_of(encoded), Clock(20.0))
    bounds, routed = [], program.solve(0.5)
    while program.remember(routed, 10**7):
        bounds.append(routed.bound)
        routed = program.solve(0.5)
    used = [route for route, share in zip(routed.routes, routed.used, strict=True) if share > 1e-6]
    assert not any(route.repeats for route in used)
    assert [*bounds, routed.bound] == sorted([*bounds, routed.bound])


def test_where_more_than_the_formula_has_to_be_kept_there_are_no_errands() -> None:
    encoded = encoded_of(mission(0))
    assert errands_of(encoded)
    assert not errands_of(replace(encoded, setting=replace(encoded.setting, delay=1)))


@pytest.mark.parametrize("seed", sampled(range(60), range(3)))
def test_bounds_by_halves_of_windows_rise_and_are_true(seed: int) -> None:
    made = mission(seed)
    routes = plans(encoded_of(made))
    first, optimum = routes.bound(), best(made)
    assert first is not None
    bounds = [first, *islice(routes.raised(lambda: optimum), 12)]
    assert bounds == sorted(bounds)
    assert bounds[-1] <= optimum


def test_agents_who_have_to_be_together_lift_the_bound_in_halves() -> None:
    """One of them comes by early, the other late; one has to come again for them to meet."""
    names = ["p", "w", "e"]
    edges = [Edge(name, name, 1) for name in names]
    for one, other in (("p", "w"), ("p", "e")):
        edges += [Edge(one, other, 4), Edge(other, one, 4)]
    formula = (
        "F[4,16] T(0,p,{(x,2)}) && F[9,10] T(1,e,{(y,1)}) && F[9,10] T(1,e,{(z,1)})"
        " && F[19,20] T(1,w,{(z,1)})"
    )
    made = Mission.of(
        map=TransitionSystem.build([State(n, labels=frozenset([n])) for n in names], edges),
        team=[Group.of("one", {"w": 1}, {"x", "y"}), Group.of("other", {"e": 1}, {"x", "z"})],
        formula=formula,
        objective=["travel"],
    )
    routes = plans(encoded_of(made))
    first, optimum = routes.bound(), best(made)
    assert first is not None
    bounds = [first, *routes.raised(lambda: optimum)]
    assert first < bounds[-1] == optimum == 20


def test_routes_are_credited_in_narrower_windows_with_what_they_still_run() -> None:
    encoded = encoded_of(mission(1, tasks=8, agents=40))
    target = Travel().target(encoded.setting, encoded)
    errands = errands_of(encoded)
    program = RouteProgram(encoded.network, target.vector, errands, Clock(20.0))
    routed = program.solve(0.5)
    low, high = errands[0].ends
    narrow = (errands[0].within(low, (low + high) // 2), *errands[1:])
    program.narrowed(narrow, routed.routes, errands)
    for before, after in zip(routed.routes, program.pool, strict=True):
        assert {part for key, part in after.credits.items() if not key[1]} <= {1.0}
        others = {key: part for key, part in before.credits.items() if key[1]}
        assert others == {key: part for key, part in after.credits.items() if key[1]}
    assert program.solve(0.5).bound >= routed.bound
