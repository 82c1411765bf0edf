"""Capacities where they matter only, against everything that agents can do and the plain model."""

from __future__ import annotations

from dataclasses import replace
from itertools import product
from random import Random

import numpy as np
import pytest

import tsplan
from tests.joint_plans import best, small_enough
from tests.narrow_missions import narrow_mission, sliding
from tests.seeds import sampled, seed_blocks
from tests.test_brute_force import REFERENCE, compare
from tsplan import Mission
from tsplan.encode.class_graph import ClassGraph
from tsplan.encode.enforced_capacities import Enforced
from tsplan.encode.preparation import prepare
from tsplan.routing.single_agent import SingleAgent
from tsplan.search import capacity_relaxation, search
from tsplan.search.capacity_relaxation import CapacityRelaxation
from tsplan.ts.builders import grid


@pytest.fixture(autouse=True)
def _small_too(monkeypatch: pytest.MonkeyPatch) -> None:
    """Small models are relaxed as well."""
    monkeypatch.setattr(capacity_relaxation, "SMALL", 0)


def values(mission: Mission, **how: object) -> tuple[str, list[tuple[str, float | None]]]:
    plan = tsplan.plan(mission, **how)
    assert plan.verified or not plan.has_paths
    return str(plan.status), [(item.name, item.value) for item in plan.objective]


@pytest.mark.parametrize("seeds", seed_blocks(range(10), range(3_000), 30))
def test_teams_in_narrow_places_do_as_well_as_all_joint_plans(seeds: list[int]) -> None:
    for seed in seeds:
        mission = narrow_mission(seed, states=4, most_agents=3, steps=5)
        if mission is not None and small_enough(mission):
            compare(mission, {})


@pytest.mark.parametrize("seeds", seed_blocks(range(5_000, 5_002), range(5_000, 6_000), 20))
def test_larger_teams_do_as_well_by_the_reference(seeds: list[int]) -> None:
    for seed in seeds:
        mission = narrow_mission(seed, states=4, most_agents=7, steps=10)
        if mission is not None:
            assert values(mission) == values(mission, **REFERENCE)


@pytest.mark.parametrize("seeds", seed_blocks(range(3), range(2_000), 8))
def test_robots_that_make_room_for_each_other_do_as_well_by_the_reference(seeds: list[int]) -> None:
    for mission in map(sliding, seeds):
        assert values(mission) == values(mission, **REFERENCE)


@pytest.mark.long
def test_the_random_missions_are_of_all_kinds(monkeypatch: pytest.MonkeyPatch) -> None:
    rounds: list[Enforced] = []
    relaxed = CapacityRelaxation._relaxed

    def counted(self: CapacityRelaxation, held: Enforced) -> object:
        rounds.append(held)
        return relaxed(self, held)

    monkeypatch.setattr(CapacityRelaxation, "_relaxed", counted)
    plans = [tsplan.plan(sliding(seed)) for seed in range(24)]
    infeasible = sum(plan.status == "infeasible" for plan in plans)
    assert 4 <= infeasible <= 16
    assert sum(bool(held.states) for held in rounds) >= 3


def test_where_waits_are_narrow_agents_wait_next_to_them() -> None:
    # all three begin where one may wait, and only those next to it may wait as they like
    mission = narrow_mission(1882, states=4, most_agents=3, steps=5)
    assert mission is not None
    assert any(edge.is_wait and edge.zone for edge in mission.system.edges.values())
    compare(mission, {})


def test_some_narrow_missions_are_enumerated() -> None:
    made = [narrow_mission(seed, states=4, most_agents=3, steps=5) for seed in range(60)]
    tiny = [mission for mission in made if mission is not None and small_enough(mission)]
    assert len(tiny) >= 25
    assert 5 <= sum(best(mission) is None for mission in tiny) <= len(tiny) - 5


def aisle(length: int, robots: int) -> Mission:
    """Robots that start in a room and are wanted at the other end of an aisle, one cell wide."""
    wide = grid(3, length, labels={(1, length - 1): "end", (0, length - 1): "end"})
    room = {f"r{row}c{column}" for row in range(3) for column in range(2)}
    ends = {f"r{row}c{length - 1}" for row in range(3)}
    cells = room | ends | {f"r1c{column}" for column in range(length)}
    states = [replace(s, capacity=1) for s in wide.states.values() if s.name in cells]
    edges = [
        replace(edge, capacity=None if edge.is_wait else 1, both_ways=not edge.is_wait)
        for edge in wide.edges.values()
        if {edge.source, edge.target} <= cells
    ]
    system = type(wide).build(states, edges, name="aisle")
    start = dict.fromkeys(sorted(room)[:robots], 1)
    return Mission.of(
        map=system,
        team=[tsplan.Group.of("cart", start)],
        formula=f"F[0,{2 * length}] (sum(end) >= 2) && F[{length},{3 * length}] G[0,2] r0c0",
        language="mtl",
        objective=["travel"],
        horizon=3 * length + 4,
    )


def test_an_aisle_is_passed_one_after_the_other_without_the_whole_model(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(CapacityRelaxation, "_whole", lambda _: pytest.fail("not needed"))
    plan = tsplan.plan(aisle(8, 4))
    assert plan.status == "optimal"
    assert plan.verified


def test_agents_that_are_booked_are_planned_with_all_capacities() -> None:
    map_ = grid(2, 3, labels={(0, 2): "a", (1, 2): "b"})
    states = [replace(state, capacity=2) for state in map_.states.values()]
    mission = Mission.of(
        map=map_.rebuilt(states, map_.edges.values()),
        team=[tsplan.Group.of("cart", {"r0c0": 2}, {"u"})],
        formula="F[0,8] T(1,a,{(u,1)}) && F[0,8] T(1,b,{(u,1)})",
        language="catl",
        objective=["travel"],
        booking="exclusive",
    )
    plan = tsplan.plan(mission)
    assert (plan.status, plan.verified, len(plan.executions)) == ("optimal", True, 2)
    assert values(mission) == values(mission, **REFERENCE)


def test_capacities_that_are_not_enforced_are_left_out() -> None:
    mission = aisle(6, 3)
    loose = prepare(mission, enforced=Enforced())
    assert loose.arrays.capacity == ()
    assert loose.arrays.group_capacity == ()
    assert all((item.graph.group == -1).all() for item in loose.classes)
    some = Enforced().also(states=[2], groups=[1])
    held = prepare(mission, enforced=some)
    assert held.arrays.capacity == ((2, 1),)
    whole = prepare(mission)
    for item, full in zip(held.classes, whole.classes, strict=True):
        np.testing.assert_array_equal(item.graph.group == 0, full.graph.group == 1)
    assert Enforced() < some
    assert not some < Enforced()


def random_graph(random: Random) -> ClassGraph:
    states = random.randint(2, 4)
    pairs = [(a, b) for a, b in product(range(states), repeat=2) if random.random() < 0.7]
    tail, head = np.array(pairs or [(0, 0)]).T
    edges = len(tail)
    return ClassGraph(
        frozenset(),
        np.eye(states, dtype=np.int64)[0],
        tail,
        head,
        np.array([random.choice([1, 1, 2, 3]) for _ in range(edges)]),
        np.zeros(edges),
        np.zeros(edges),
        np.full(edges, -1),
    )


def test_the_cheapest_way_of_one_agent_is_that_of_all_its_ways() -> None:
    found = 0
    for seed in range(120):
        random = Random(seed)
        numbers = np.random.default_rng(seed)
        graph, horizon = random_graph(random), random.randint(1, 5)
        states = len(graph.start)
        at = numbers.integers(0, 4, (horizon + 1, states)).astype(float)
        entering = numbers.integers(0, 5, (horizon, len(graph.tail))).astype(float)
        duties = {
            step: numbers.random(states) < 0.7
            for step in range(horizon + 1)
            if random.random() < 0.3
        }
        prices = numbers.integers(0, 3, len(graph.tail)).astype(float)
        costs = list(all_costs(graph, horizon, at, entering + prices, duties))
        alone = SingleAgent(0, graph, horizon, prices)
        entries = *np.nonzero(entering), entering[entering > 0]
        way = alone.cheapest(0, duties, at, entries)
        again = alone.cheapest(0, duties, at, entries)
        assert (way is None) == (again is None)
        assert way is None or again is None or way[1] == again[1]
        assert (way is None) == (not costs)
        if way is None:
            continue
        walk, cost = way
        assert cost == min(costs)
        where = walk.states(graph, horizon)
        assert all(where[step] >= 0 and mask[where[step]] for step, mask in duties.items())
        found += 1
    assert found >= 40


def all_costs(graph, horizon, at, entering, duties):
    """What every way from state 0 costs that ends at some state at the horizon."""
    stack = [(0, 0, 0.0)]
    while stack:
        state, step, cost = stack.pop()
        if step in duties and not duties[step][state]:
            continue
        if step == horizon:
            yield cost
            continue
        for edge in np.flatnonzero(graph.tail == state).tolist():
            end = step + int(graph.duration[edge])
            passed = any(step < due < end for due in duties)
            if end <= horizon and not passed:
                to = int(graph.head[edge])
                stack.append((to, end, cost + entering[step, edge] + at[end, to]))


@pytest.mark.parametrize("limit", sampled([0.02, 0.05, 0.1], [0.05]))
def test_no_bound_is_told_that_the_best_plan_refutes_where_time_is_up(
    limit: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(search, "_SLOW", -1.0)
    for mission in (aisle(8, 4), sliding(15), sliding(12)):
        told: list[float] = []

        def hear(event: object, told: list[float] = told) -> None:
            bound = getattr(event, "bound", None)
            told += [] if bound is None else [bound]

        best = tsplan.plan(mission)
        plan = tsplan.plan(mission, time_limit=limit, on_event=hear)
        first = best.objective[0]
        assert first.value is not None
        assert all(bound <= first.value for bound in told)
        assert all(item.bound is None or item.bound <= first.value for item in plan.objective[:1])
