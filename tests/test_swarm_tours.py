"""Tours of weighted tokens bound what swarms travel, and swarms that never split go as one."""

from __future__ import annotations

from itertools import pairwise, product
from random import Random

import numpy as np
import pytest

import tsplan
from tests.joint_plans import best
from tests.test_swarm_tokens import ring
from tsplan import Mission
from tsplan.clock import Clock
from tsplan.encode.assemble import tight
from tsplan.encode.groups.lone_groups import lone
from tsplan.encode.groups.token_service import Servants, Task
from tsplan.encode.groups.token_stops import Choices, Stop
from tsplan.encode.groups.token_tours import Call, Journey, Tours
from tsplan.encode.groups.token_weights import Origin, Wanted, weightings
from tsplan.encode.model_objectives import Splits
from tsplan.encode.preparation import prepare
from tsplan.encode.priced_objectives import Travel
from tsplan.encode.switches import ALL_SWITCHES, Switch
from tsplan.milp.solver import solver
from tsplan.search.effort import Effort
from tsplan.search.group_travel import GroupTravel
from tsplan.search.question import Kept
from tsplan.ts import Edge, State, TransitionSystem

PLACE = (0,), None


def journey(random: Random) -> Journey:
    """A random map of three nodes, on which waiting is not possible everywhere."""
    pairs = [pair for pair in product(range(3), repeat=2) if random.random() < 0.8] or [(0, 0)]
    tail, head = np.array(pairs).T
    duration = np.array([1 if a == b else random.choice([1, 1, 2, 3]) for a, b in pairs])
    price = np.where(tail == head, 0.0, duration)
    barred = np.array([[random.random() < 0.1 for _ in range(3)] for _ in range(6)])
    return Journey(random.randrange(3), tail, head, duration, price, barred)


def all_ways(given: Journey) -> list[tuple[float, list[int]]]:
    """The price and the nodes of every way, -1 between two of them."""
    found = []

    def go(node: int, step: int, price: float, at: list[int]) -> None:
        if given.barred[step, node]:
            return
        at = [*at, node]
        if step == given.horizon:
            found.append((price, at))
            return
        for edge in np.flatnonzero(given.tail == node).tolist():
            lasting = int(given.duration[edge])
            between = [-1] * (min(step + lasting, given.horizon + 1) - step - 1)
            paid = price + given.price[edge]
            if step + lasting > given.horizon:
                found.append((paid, at + between))
            else:
                go(int(given.head[edge]), step + lasting, paid, at + between)

    go(given.start, 0, 0.0, [])
    return found


def makes(at: list[int], call: Call) -> bool:
    return any(all(at[k] in call.nodes for k in range(a, b + 1)) for a, b in call.runs)


@pytest.mark.parametrize("seed", range(40))
def test_the_table_has_the_price_of_every_set_of_calls(seed: int) -> None:
    random = Random(seed)
    given = journey(random)
    calls = []
    for _ in range(3):
        long = random.choice([0, 0, 1, 2])
        begins = random.sample(range(6 - long), random.randint(1, 3))
        nodes = random.sample(range(3), 1 if long else random.randint(0, 2))
        calls.append(Call(tuple(nodes), tuple((a, a + long) for a in begins)))
    ways = all_ways(given)
    tours = Tours(given, calls)
    for wanted, cost in enumerate(tours.costs.tolist()):
        mine = [call for number, call in enumerate(calls) if wanted >> number & 1]
        able = [price for price, at in ways if all(makes(at, call) for call in mine)]
        assert cost == min(able, default=np.inf)
        if able:
            way = tours.way(wanted)
            assert given.price[way.edge].sum() == cost
            at = way.at.tolist() + [-1] * (6 - len(way.at))
            assert all(makes(at, call) for call in mine)


def shares(sets: int, tokens: int) -> list[tuple[int, ...]]:
    """Every way in which tokens may make calls."""
    return list(product(range(sets), repeat=tokens))


@pytest.mark.parametrize("seed", range(12))
def test_the_cheapest_numbers_of_agents_are_at_a_corner(seed: int) -> None:
    random = Random(seed)
    wanted = [Wanted(random.randint(1, 6), frozenset([0])) for _ in range(3)]
    stops = [Stop(PLACE, want.amount, ((n, n),)) for n, want in enumerate(wanted)]
    tasks = [
        Task(stop, 1 << n, 1 << n, want, changes=False)
        for n, (stop, want) in enumerate(zip(stops, wanted, strict=True))
    ]
    price = [random.randint(0, 5) for _ in wanted]
    costs = np.array(
        [
            sum(price[n] for n in range(3) if calls >> n & 1) - 2 * (calls.bit_count() > 1)
            for calls in range(8)
        ],
        dtype=np.float64,
    ).clip(0)
    costs = np.array([min(costs[m] for m in range(8) if m & c == c) for c in range(8)])
    origin, tokens = Origin(0, 0, 7, 1), random.choice([2, 3])
    least = np.inf
    for weighting in weightings([origin], tokens - 1, wanted) or ():
        prices = [weight * costs for weight in weighting.weights]
        found = Servants(weighting, [0] * tokens, prices).cheapest(tasks, np.inf)
        least = min(least, np.inf if found is None else found.price)
    expected = np.inf
    for weights in product(range(1, 8), repeat=tokens):
        if sum(weights) == origin.agents:
            for made in shares(8, tokens):
                held = [
                    sum(w for w, m in zip(weights, made, strict=True) if m >> n & 1)
                    for n in range(3)
                ]
                if all(h >= want.amount for h, want in zip(held, wanted, strict=True)):
                    paid = sum(w * costs[m] for w, m in zip(weights, made, strict=True))
                    expected = min(expected, paid)
    assert least == pytest.approx(expected)


def travelling(seed: int) -> Mission:
    """Agents at one or two places of a ring, wanted at places together, for longer, one by one."""
    random = Random(seed)
    parts = []
    for _ in range(random.randint(1, 3)):
        low = random.randint(0, 2)
        one, other = random.sample("ABCD", 2)
        kinds = [
            f"({one} && {other})",
            f"(sum({one}) >= 2 && {other})",
            f"G[0,1] {one}",
            f"sum({one}) >= {random.randint(1, 3)}",
            f"(!{one} && {other})",
            f"({one} && F[0,1] {other})",
        ]
        parts.append(f"F[{low},{random.randint(low, 2)}] {random.choice(kinds)}")
    a, b = random.sample("abcd", 2)
    return Mission.of(
        map=ring(),
        swarm={
            "size": 3,
            "at": random.choice([{a: 3}, {a: 3}, {a: 1, b: 2}]),
            "max_subswarms": random.choice([None, 2, 3]),
            "min_subswarm": random.choice([1, 1, 2]),
        },
        formula=" && ".join(parts),
        objective=["splits", "travel"],
        horizon=3,
    )


def bound(mission: Mission, splits: float, seconds: float = 20.0) -> float:
    """What is known of the travel of plans of so many splits."""
    setting = prepare(mission)
    kept = Kept().and_also(Splits(), splits)
    effort = Effort(solver("highs"), switches=ALL_SWITCHES - {Switch.LONE})
    encoded = kept.narrowed(setting, tight(setting))
    travel = GroupTravel(encoded, Travel(), effort, Clock(seconds), lambda _: None)
    return max(travel.bounds(int(splits), np.inf), default=0.0)


def compared(seeds: range) -> tuple[int, int]:
    """How often the bound is met, and how often something splits; it is never too high."""
    met = split = 0
    for seed in seeds:
        mission = travelling(seed)
        expected = best(mission)
        if expected is not None:
            told = bound(mission, expected[0])
            assert told <= expected[1] + 1e-6
            met += told > expected[1] - 1
            split += expected[0] > 0
    return met, split


def test_no_plan_of_so_many_splits_travels_less() -> None:
    met, split = compared(range(60_005, 60_009))
    assert met >= 3
    assert split >= 2


@pytest.mark.long
def test_no_plan_of_many_missions_travels_less() -> None:
    met, split = compared(range(60_009, 60_200))
    assert met >= 50
    assert split >= 20


def line(**changes) -> Mission:
    """A line r - s - p - q with a long way round from r to q; two agents begin at s."""
    names = ["r", "s", "p", "q"]
    states = [State(name, labels=frozenset({name.upper()})) for name in names]
    edges = [Edge(name, name) for name in names] + [Edge("r", "q", 4)]
    for one, other in pairwise(names):
        edges += [Edge(one, other), Edge(other, one)]
    given = {
        "swarm": {"size": 2, "at": {"s": 2}},
        "formula": "F[1,1] R && G[1,8] P && F[4,8] Q",
        "objective": ["splits", "travel"],
    } | changes
    system = TransitionSystem.build(states, edges)
    return Mission.of(map=system, **{key: value for key, value in given.items() if value})


def test_where_tokens_would_meet_and_part_the_whole_problem_decides() -> None:
    swarm = {"size": 3, "at": {"s": 3}}
    mission = line(swarm=swarm, formula="F[1,1] R && G[1,8] sum(P) >= 2 && F[4,8] Q")
    assert bound(mission, 1) == 6  # the one by way of p, where two others are
    plan = tsplan.plan(mission)
    assert (plan.status, [item.value for item in plan.objective]) == ("optimal", [1, 7])


def test_limits_bar_the_way() -> None:
    """The long way round is the only one where nobody may be at p."""
    formula = "F[0,8] (R && S) && F[4,8] Q && G[0,8] !P"
    assert bound(line(formula=formula), 1) == 5
    assert [item.value for item in tsplan.plan(line(formula=formula)).objective] == [1, 5]


def test_too_many_stops_are_not_all_made() -> None:
    """Those left out make the bound no higher."""
    parts = [f"F[{n},{n + 4}] {'RSPQ'[n % 4]}" for n in range(20)]
    mission = line(formula=" && ".join(parts), swarm={"size": 1, "at": "s"})
    plan = tsplan.plan(mission)
    assert 0 < bound(mission, 0, 0.5) <= plan.objective[1].value


def test_stops_that_share_a_step_are_made_by_two() -> None:
    """Where X is a single state; where it is two, others may be there by the time."""
    for states, count in (("p", 1), ("ps", 0)):
        names = ["r", "s", "p"]
        system = TransitionSystem.build(
            [
                State(n, labels=frozenset({n.upper()} | ({"X"} if n in states else set())))
                for n in names
            ],
            [Edge(a, b) for a, b in product(names, repeat=2)],
        )
        swarm = {"size": 4, "at": "s"}
        formula = "F[0,3] (G[0,2] X && G[2,2] R)"
        mission = Mission.of(map=system, swarm=swarm, formula=formula, horizon=5)
        choices = Choices(prepare(mission), 2)
        bounds = choices.bounds
        assert bounds is not None
        assert len(choices.apart(choices.certain(bounds))) == count
        assert len(choices.stops(choices.certain(bounds))) == 2


# --- swarms that need not split ------------------------------------------------------------------


SEQUENCE = "F[0,2] (sum(R) >= {most} && F[0,5] (Q && F[0,2] S)) && G[0,6] F[0,3] (P || R)"


@pytest.mark.parametrize("objective", [["splits", "travel"], ["travel"], ["travel", "splits"]])
def test_a_swarm_that_need_not_split_goes_as_one_agent(objective: list[str]) -> None:
    most = None if objective[0] == "splits" else 1
    swarm = {"size": 30, "at": "s", "max_subswarms": most}
    plan = tsplan.plan(line(formula=SEQUENCE.format(most="60%"), swarm=swarm, objective=objective))
    team = [{"class": "a", "count": 1, "at": "s"}]
    alone = {"swarm": None, "team": team, "language": "mtl", "objective": ["travel"]}
    single = tsplan.plan(line(formula=SEQUENCE.format(most=1), **alone), encoding="reference")
    values = {item.name: item.value for item in plan.objective}
    assert plan.status == "optimal"
    assert values["travel"] == 30 * single.objective[0].value
    assert values.get("splits", 0) == 0


def test_several_swarms_and_robots_that_need_not_split() -> None:
    given = {
        "swarm": None,
        "swarms": [
            {"name": "gliders", "size": 5, "at": "s"},
            {"name": "crawlers", "size": 3, "at": "q"},
        ],
        "team": [{"class": "tug", "count": 2, "at": "r"}],
        "formula": "F[0,6] sum(R, gliders) >= 4 && F[2,8] (sum(R, crawlers) >= 1 && "
        "sum(S, tug) >= 1) && G[0,8] sum(P, gliders) <= 2",
        "language": "mtl",
    }
    plan = tsplan.plan(line(**given))
    assert [item.value for item in plan.objective] == [0, 5 * 1 + 3 * 3 + 1]
    assert plan.status == "optimal"


def test_a_swarm_that_cannot_do_without_splits_has_no_plan_as_one_agent() -> None:
    swarm = {"size": 4, "at": "s", "max_subswarms": 1}
    mission = line(swarm=swarm, formula="F[0,4] (R && P)", objective=["travel"])
    assert tsplan.plan(mission).status == "infeasible"


def test_swarms_are_no_single_agents_where_counts_or_starts_say_more() -> None:
    two = {"size": 4, "at": {"s": 3, "q": 1}}
    assert lone(prepare(line(swarm=two))) is None
    several = {
        "swarm": None,
        "swarms": [{"name": "a", "size": 2, "at": "s"}, {"name": "b", "size": 3, "at": "q"}],
    }
    assert lone(prepare(line(**several))) is None
    own = {"formula": "F[0,8] sum(R, a) >= 2", "language": "mtl"}
    assert lone(prepare(line(**several, **own))) is not None
