"""Appointments: what goals say of them, tours, routes and ways, against everything there is."""

from __future__ import annotations

from dataclasses import replace
from itertools import permutations, product
from random import Random

import numpy as np
import pytest

import tsplan
from tests.narrow_missions import narrow_mission, sliding
from tests.seeds import seed_blocks
from tests.test_brute_force import REFERENCE
from tsplan import Mission
from tsplan.clock import Clock
from tsplan.encode.encoded import Setting
from tsplan.encode.preparation import prepare
from tsplan.milp.solver import solver
from tsplan.mission import Group
from tsplan.routing.appointments import Agenda, agenda_of
from tsplan.routing.calls import apart, calls_of, joined
from tsplan.routing.distances import Distances
from tsplan.routing.routes import Pricing, Visits
from tsplan.routing.tours import TourPlanner
from tsplan.search import capacity_relaxation
from tsplan.search.capacity_relaxation import CapacityRelaxation
from tsplan.search.effort import Effort
from tsplan.search.met_routes import MetRoutes
from tsplan.search.route_bound import RouteBound, Stops, Windows
from tsplan.search.route_tree import RouteTree, highest, split
from tsplan.ts.builders import grid


def planned(formula: str, *, robots: int = 3) -> Setting:
    """A row of five cells with a label at either end, and robots in the middle."""
    system = grid(1, 5, labels={(0, 0): "a", (0, 4): "b"})
    states = [replace(state, capacity=2) for state in system.states.values()]
    team = [
        Group.of("cart", {"r0c2": 1, "r0c1": robots - 2}, {"c"}),
        Group.of("eye", {"r0c3": 1}, {"e"}),
    ]
    mission = Mission.of(
        map=system.rebuilt(states, system.edges.values()),
        team=team,
        formula=formula,
        language="mtl",
        objective=["travel"],
        horizon=20,
    )
    return prepare(mission)


def spans(agenda: Agenda | None) -> list[tuple[int, int, list[tuple[int, tuple[int, ...]]]]]:
    assert agenda is not None
    return [
        (item.first, item.last, [(need.many, need.after) for need in item.needs])
        for item in agenda.appointments
    ]


@pytest.mark.parametrize(
    ("formula", "expected"),
    [
        ("F[2,5] (sum(a,c) >= 2)", [(2, 5, [(2, (0,))])]),
        ("F[1,2] F[3,4] (sum(a,c) >= 1)", [(4, 6, [(1, (0,))])]),
        ("F[0,4] G[1,2] (sum(a,c) >= 1)", [(0, 4, [(1, (1, 2))])]),
        ("G[3,4] (sum(a,c) >= 1)", [(0, 0, [(1, (3, 4))])]),
        (
            "F[0,4] (sum(a,c) >= 1 && sum(b,e) >= 1) && F[5,9] (sum(b) >= 2)",
            [(0, 4, [(1, (0,)), (1, (0,))]), (5, 9, [(2, (0,))])],
        ),
    ],
)
def test_conjunctions_of_eventualities_are_agendas(formula: str, expected: object) -> None:
    assert spans(agenda_of(planned(formula))) == expected


@pytest.mark.parametrize(
    "formula",
    [
        "F[0,4] (sum(a) >= 1) || F[0,4] (sum(b) >= 1)",
        "G[0,4] F[0,4] (sum(a) >= 1)",
        "(sum(b) <= 0) U[1,4] (sum(a) >= 1)",
        "F[0,4] (sum(a) >= 1 && F[1,3] (sum(b) >= 1))",
        "F[0,4] (sum(a) >= 1 && sum(b) <= 0)",
        "G[0,4] (sum(b) <= 0)",
    ],
)
def test_what_leaves_more_open_is_no_agenda(formula: str) -> None:
    assert agenda_of(planned(formula)) is None


def test_what_is_allowed_at_most_is_a_quota() -> None:
    agenda = agenda_of(planned("F[0,9] (sum(a) >= 1) && G[2,4] (sum(b,e) <= 0)"))
    assert agenda is not None
    (quota,) = agenda.quotas
    assert (quota.most, quota.steps.tolist(), len(quota.able)) == (0, [2, 3, 4], 1)


def bounds_of(setting: Setting, agenda: Agenda, unit: float = 1.0) -> list[float]:
    """What the tree of routes proves, of plans whose prices are multiples of a unit."""
    prices = [item.graph.travel.astype(float) for item in setting.classes]
    distances = Distances.of(setting, agenda, prices)
    routes = RouteBound(agenda, distances, dict(setting.arrays.capacity), unit)
    tours = TourPlanner(agenda, distances, dict(setting.arrays.capacity)).best(Clock(), 20)
    if tours is not None:
        routes.begin_with(tours)
    return list(RouteTree(routes, Windows.of(agenda)).raised(Clock(5.0), lambda: 1e6))


@pytest.mark.parametrize("seeds", seed_blocks(range(8), range(1_500), 16))
def test_routes_never_cost_more_than_the_best_plan(seeds: list[int]) -> None:
    reached = judged = 0
    for seed in seeds:
        made = sliding(seed) if seed % 3 else narrow_mission(seed, states=4, most_agents=4, steps=6)
        if made is None:
            continue
        mission = replace(made, objective=("travel",))
        setting = prepare(mission)
        agenda = agenda_of(setting)
        plan = None if agenda is None else tsplan.plan(mission, **REFERENCE)
        if agenda is None or plan is None or not plan.has_paths:
            continue
        found = bounds_of(setting, agenda, float(seed % 2))
        best = plan.objective[0].value
        assert best is not None
        assert found == sorted(found)
        assert all(bound <= best + 1e-6 for bound in found)
        judged += 1
        reached += bool(found) and found[-1] >= best - 1e-6
    assert judged >= 2
    assert reached >= 1


def stays(seed: int) -> Mission:
    """Robots on a small floor that are wanted for several steps each, some at the same cells."""
    random = Random(seed)
    labels = {(0, 0): "a", (0, 1): "a", (random.randint(0, 1), 3): "b", (1, 0): "c"}
    system = grid(2, 4, labels=labels)
    states = [replace(state, capacity=1) for state in system.states.values()]
    parts = []
    for label in random.sample(["a", "b", "c", "a"], random.randint(2, 3)):
        first = random.randint(0, 4)
        wanted = f"sum({label},c) >= {random.randint(1, 2 if label == 'a' else 1)}"
        if random.random() < 0.3:
            wanted = f"({wanted} && sum(a,e) >= 1)" if label == "b" else wanted
        parts.append(
            f"F[{first},{first + random.randint(0, 4)}] G[0,{random.randint(0, 3)}] {wanted}"
        )
    both = {"c", "e"} if random.random() < 0.3 else {"c"}
    team = [Group.of("cart", {"r0c2": 1, "r1c2": 1}, both), Group.of("eye", {"r1c1": 1}, {"e"})]
    return Mission.of(
        map=system.rebuilt(states, system.edges.values()),
        team=team,
        formula=" && ".join(parts),
        language="mtl",
        objective=["travel"],
        horizon=11,
    )


@pytest.mark.parametrize("seeds", seed_blocks(range(5), range(400), 10))
def test_routes_that_stay_never_cost_more_than_the_best_plan(seeds: list[int]) -> None:
    judged = 0
    for seed in seeds:
        mission = stays(seed)
        setting = prepare(mission)
        agenda, plan = agenda_of(setting), tsplan.plan(mission, without=["capacities"])
        if agenda is None or not plan.has_paths:
            continue
        best = plan.objective[0].value
        assert best is not None
        assert plan.objective[0].bound == best
        assert all(bound <= best + 1e-6 for bound in bounds_of(setting, agenda))
        judged += 1
    assert judged >= 2


@pytest.mark.parametrize("seed", range(12))
def test_routes_that_meet_keep_their_appointments(seed: int) -> None:
    setting = prepare(stays(seed))
    agenda = agenda_of(setting)
    assert agenda is not None
    prices = [item.graph.travel.astype(float) for item in setting.classes]
    distances = Distances.of(setting, agenda, prices)
    routes = RouteBound(agenda, distances, dict(setting.arrays.capacity), 1.0)
    tree = RouteTree(routes, Windows.of(agenda))
    bounds = list(tree.raised(Clock(5.0), lambda: np.inf))
    met = MetRoutes(routes, Effort(solver("highs")))
    chosen = met.chosen(tree.met or tree.windows, Clock(5.0), 0)
    meeting = None if chosen is None else met.meeting(chosen, 0.0)
    if chosen is None or meeting is None:
        return
    assert met.price(chosen) >= bounds[-1] - 1e-6 or tree.met is None
    for item, time, groups in zip(agenda.appointments, meeting.times, meeting.serving, strict=True):
        assert item.first <= time <= item.last
        for need, group in zip(item.needs, groups, strict=True):
            assert len(set(group)) == need.many
            assert all(int(distances.kind[agent]) in need.able for agent in group)


def test_a_stay_is_a_call_when_it_begins_and_one_when_it_ends() -> None:
    formula = "F[0,4] G[0,3] (sum(a,c) >= 1) && F[2,9] (sum(b,e) >= 1)"
    setting = planned(formula)
    agenda = agenda_of(setting)
    assert agenda is not None
    calls = calls_of(agenda)
    assert [(call.appointment, call.after) for call in calls] == [(0, 0), (0, 3), (1, 0)]
    table = apart(calls)
    assert table[0].tolist() == [0, 3, 0]
    assert table[1].tolist() == [np.inf, 0, 0]
    prices = [item.graph.travel.astype(float) for item in setting.classes]
    distances = Distances.of(setting, agenda, prices)
    carts = next(kind for kind in agenda.needs[0].able)
    assert joined(calls, carts, distances).tolist() == [0, 0, 2]  # carts see to nothing else
    both = planned("F[0,4] G[0,9] (sum(a) >= 1) && F[2,9] (sum(b) >= 1)")
    agenda = agenda_of(both)
    assert agenda is not None
    distances = Distances.of(both, agenda, prices[:1])
    assert joined(calls_of(agenda), carts, distances).tolist() == [0, 1, 2]  # there and back


def test_of_very_many_stays_only_the_beginnings_are_calls() -> None:
    agenda = agenda_of(planned("F[0,4] G[0,3] (sum(a,c) >= 1)"))
    assert agenda is not None
    many = Agenda(agenda.appointments * 40)
    assert [call.after for call in calls_of(many)] == [0] * 40
    assert [call.after for call in calls_of(agenda, ends=False)] == [0]


def test_of_several_trees_the_highest_bound_counts() -> None:
    trees = [iter([1.0, 5.0]), iter([3.0]), iter([2.0, 4.0, 6.0])]
    bounds = list(highest(trees))
    assert bounds == sorted(bounds)
    assert (len(bounds), bounds[-1]) == (6, 6.0)


@pytest.mark.parametrize("seeds", seed_blocks([5, 6, 7], range(1_200), 8))
def test_plans_by_appointments_alone_are_plans(
    seeds: list[int], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(capacity_relaxation, "SMALL", 0)
    monkeypatch.setattr(CapacityRelaxation, "_by_rounds", lambda _: None)
    monkeypatch.setattr(CapacityRelaxation, "_finish", lambda _: None)
    found = 0
    for seed in seeds:
        plan = tsplan.plan(sliding(seed, 12), time_limit=0.5)
        assert plan.verified or not plan.has_paths
        found += plan.has_paths
    assert found >= 1


def test_routes_are_the_cheapest_of_all_routes() -> None:
    for seed in range(40):
        random, numbers = Random(seed), np.random.default_rng(seed)
        needs, places = random.randint(2, 4), random.randint(3, 5)
        steps = numbers.integers(1, 6, (places, places)).astype(float)
        np.fill_diagonal(steps, 0.0)
        prices = steps + numbers.integers(0, 2, steps.shape) * (steps > 0)
        every = [(n, p) for n, p in product(range(needs), range(places)) if random.random() < 0.6]
        if not every:
            continue
        need, place = np.array(every).T
        first = numbers.integers(0, 6, len(every)).astype(float)
        visits = Visits(need, place, first, first + numbers.integers(0, 8, len(every)))
        worth = numbers.integers(0, 9, len(every)).astype(float)
        starts = np.array([0, 1])
        between = np.zeros((needs, needs))
        same = np.arange(needs)
        if seed % 2:  # the last two are both ends of a stay
            between[-2, -1], between[-1, -2], same[-1] = random.randint(0, 4), np.inf, same[-2]
        pricing = Pricing(visits, starts, steps, prices, between, same)
        least, routes = pricing.cheapest(worth)
        tables = steps, prices, between, same
        for number, start in enumerate(starts.tolist()):
            costs = [
                cost
                for length in range(1, needs + 1)
                for route in permutations(range(len(every)), length)
                if (cost := reduced(route, start, visits, tables, worth)) is not None
            ]
            assert least[number] == min([0.0, *costs])
        for route in [*routes, *pricing.some(worth)]:
            cost = reduced(route.visits, route.start, visits, tables, worth)
            assert cost == route.reduced < 0


def reduced(route, start, visits, tables, worth):
    """What a route costs less what it is worth, None if it is late or serves a need twice."""
    steps, prices, between, same = tables
    needs = [int(visits.need[visit]) for visit in route]
    if len(set(needs)) < len(needs):
        return None
    for place, one in enumerate(needs):
        if any(same[one] == same[other] for other in needs[place + 2 :]):
            return None  # something else came between both ends of a stay
    now, place, cost, before = 0.0, start, 0.0, None
    for visit in route:
        there, need = int(visits.place[visit]), int(visits.need[visit])
        least = 0.0 if before is None else between[before, need]
        now = max(now + max(steps[place, there], least), visits.first[visit])
        before = need
        if now > visits.last[visit]:
            return None
        cost += prices[place, there] - worth[visit]
        place = there
    return cost


def test_a_window_is_split_where_two_routes_do_not_meet() -> None:
    windows = Windows((0, 0), (20, 20))
    late, early = Stops((0, 1), (3.0, 9.0)), Stops((1, 0), (1.0, 15.0))
    parts = split(windows, [late, early])
    assert parts is not None
    first, second = parts
    sides = [(w.first[n], w.last[n]) for w in (first, second) for n in range(2)]
    cut = [pair for pair in sides if pair != (0, 20)]
    assert len(cut) == 2
    assert cut[0][1] + 1 == cut[1][0]
    assert split(windows, [late]) is None
