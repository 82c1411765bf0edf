"""Witnesses that the same agents cannot both serve: gaps, timetables, plans of both encodings."""

from __future__ import annotations

import random
from itertools import combinations, pairwise, product
from typing import Any

import numpy as np
import pytest

from tests.module_missions import RULES, SHAPES
from tests.seeds import sampled, seed_blocks
from tsplan import Mission, plan
from tsplan.encode.assemble import tight
from tsplan.encode.class_columns import ClassColumns
from tsplan.encode.preparation import prepare
from tsplan.encode.rivals.module_gaps import ModuleGaps
from tsplan.encode.rivals.timetable import Timetables, Wanted
from tsplan.encode.rivals.travel_gaps import Stay, TravelGaps
from tsplan.encode.switches import Switch
from tsplan.mission import Group
from tsplan.ts import Edge, State, TransitionSystem

LABELS = "ABC"


def ring(rng: random.Random, count: int) -> TransitionSystem:
    """Some states in a ring with shortcuts; the first three have a label each."""
    labels = [frozenset(LABELS[n : n + 1]) for n in range(count)]
    states = [State(f"s{n}", labels=labels[n]) for n in range(count)]
    edges = [Edge(state.name, state.name, 1) for state in states]
    edges += [
        Edge(f"s{n}", f"s{m}", rng.randint(1, 3))
        for n in range(count)
        for m in range(count)
        if n != m and (m == (n + 1) % count or rng.random() < 0.3)
    ]
    return TransitionSystem.build(states, edges)


def team(rng: random.Random, system: TransitionSystem, most: int = 3) -> list[Group]:
    return [
        Group.of(
            f"g{number}",
            {rng.choice(list(system.states)): rng.randint(1, most)},
            set(rng.sample("uv", rng.randint(1, 2))),
        )
        for number in range(rng.randint(2, 3))
    ]


def task(rng: random.Random) -> str:
    needs = ",".join(f"({c},{rng.randint(1, 2)})" for c in rng.sample("uv", rng.randint(1, 2)))
    return f"T({rng.randint(0, 2)},{rng.choice(LABELS)},{{{needs}}})"


def wish(rng: random.Random) -> str:
    begin, length = rng.randint(0, 6), rng.randint(3, 8)
    inner = task(rng)
    kind = rng.random()
    if kind < 0.15:
        return f"G[{begin},{begin + 3}] F[0,4] {inner}"
    if kind < 0.3:
        inner = f"({inner} && F[1,{length}] {task(rng)})"
    elif kind < 0.4:
        return f"({inner} U[0,{length}] {task(rng)})"
    elif kind < 0.5:
        inner = f"({inner} || {task(rng)})"
    return f"F[{begin},{begin + length}] {inner}"


def rival_mission(seed: int) -> Mission:
    """Several tasks in near windows and a small team: many cannot all hold."""
    rng = random.Random(f"rivals {seed}")
    system = ring(rng, rng.randint(3, 4))
    return Mission.of(
        map=system,
        team=team(rng, system),
        formula=" && ".join(wish(rng) for _ in range(rng.randint(2, 3))),
        language="catl",
        objective=rng.choice([("availability", "travel"), ("travel",), ("availability",)]),
    )


def agree(seed: int) -> None:
    mission = rival_mission(seed)
    tightly, plainly = plan(mission), plan(mission, encoding="reference")
    assert tightly.status == plainly.status, str(mission.formula)
    assert [item.value for item in tightly.objective] == [item.value for item in plainly.objective]


@pytest.mark.parametrize("seed", sampled(range(400), range(2)))
def test_rival_tasks_agree_with_the_reference(seed: int) -> None:
    agree(seed)


# --- gaps --------------------------------------------------------------------------------------


def test_gaps_are_never_too_long() -> None:
    """With less time in between, no division of the agents serves both, whoever goes."""
    longer = 0
    for seed in range(12):
        rng = random.Random(seed)
        system = ring(rng, rng.randint(3, 5))
        crew = Mission.of(
            map=system, team=team(rng, system), formula="F[0,9] T(0,A,{(u,1)})", language="catl"
        )
        # the whole map for all: a class that a formula does not ask for keeps nothing of its own
        network = prepare(crew, switches=frozenset(Switch) - {Switch.REDUCTION}).unrolled()
        gaps = TravelGaps(network)
        places = [(0,), (1,), (2,), (0, 1)]
        amounts = [{"u": rng.randint(1, 3)}, {"u": rng.randint(1, 3), "v": rng.randint(1, 3)}]
        stays = [gaps.stay(site, need, rng.randint(0, 9)) for site in places for need in amounts]
        found = gaps.between(stays)
        for first, second in product(range(len(stays)), repeat=2):
            gap = int(found[first, second])
            if gap:
                longer += 1
                assert not served(gaps, stays[first], stays[second], gap - 1)
            one_each = len(stays[first].amounts) == len(stays[second].amounts) == 1
            apart = set(stays[first].states).isdisjoint(stays[second].states)
            alone = all(served(gaps, stay, stay, 0) for stay in (stays[first], stays[second]))
            if one_each and apart and alone and gap <= network.horizon:
                assert served(gaps, stays[first], stays[second], gap)
    assert longer > 30


def served(gaps: TravelGaps, first: Stay, second: Stay, later: int) -> bool:
    """Whether agents can be divided so that both get what they need, by trying every division."""
    classes = gaps._network.classes
    ways = []
    for number, item in enumerate(classes):
        agents = item.graph.agents
        away = item.graph.lengths.distances(list(first.states))[:, list(second.states)].min()
        here = agents if number in first.classes else 0
        there = agents if number in second.classes else 0
        shares = product(range(here + 1), range(there + 1))
        ways.append([(a, b) for a, b in shares if a + b <= agents or away <= later])
    return any(
        all(
            sum(each[side] for each, item in zip(way, classes, strict=True) if has(item, c)) >= m
            for side, stay in enumerate((first, second))
            for c, m in stay.amounts
        )
        for way in product(*ways)
    )


def has(item: ClassColumns, capability: str | None) -> bool:
    return capability in item.graph.capabilities


# --- modules -----------------------------------------------------------------------------------


def module_mission(seed: int) -> Mission:
    """Several tasks in near windows for a few modules that are rebuilt in one place or two."""
    rng = random.Random(f"rival modules {seed}")
    system = ring(rng, rng.randint(3, 5))
    rules = [
        dict(rule, duration=rng.randint(1, 2), at=rng.sample(list(system.states), 2))
        for rule in RULES
    ]
    crew: list[dict[str, Any]] = [
        {"class": "cube", "count": rng.randint(3, 5), "at": "s0", "configuration": "one"}
    ]
    if rng.random() < 0.3:
        crew.append({"class": "cart", "at": "s1", "capabilities": [rng.choice("uv")]})
    shapes = {
        name: {**shape, "duration": rng.choice([1, 1, 1.5])} for name, shape in SHAPES.items()
    }
    return Mission.of(
        map=system,
        team=crew,
        configurations=shapes,
        reconfigure=rules,
        formula=" && ".join(wish(rng) for _ in range(rng.randint(2, 3))),
        language="catl",
        objective=rng.choice([("travel",), ()]),
    )


def agree_on_modules(seeds: list[int]) -> int:
    """How many of the missions the gaps alone refute; all have plans just if they are said to."""
    refuted = 0
    for seed in seeds:
        mission = module_mission(seed)
        tightly, plainly = plan(mission), plan(mission, encoding="reference")
        assert tightly.status == plainly.status, (seed, str(mission.formula))
        values = [[item.value for item in made.objective] for made in (tightly, plainly)]
        assert values[0] == values[1], (seed, str(mission.formula))
        told = {
            tight(prepare(mission, switches=frozenset(Switch) - without)).refuted
            for without in ({Switch.RIVALS}, set())
        }
        refuted += len(told) > 1
    return refuted


@pytest.mark.parametrize("seeds", seed_blocks(range(2), range(300), 6))
def test_rival_tasks_of_modules_agree_with_the_reference(seeds: list[int]) -> None:
    agree_on_modules(seeds)


def test_modules_have_ways_in_every_structure_and_are_rebuilt_on_them() -> None:
    """Three of four modules lift at one end, and two look at the other: rebuilt half-way."""
    system = line_of(["A", "dock", "B"])
    rules = [{"from": "one", "to": "trio", "duration": 2, "at": ["dock"]}]
    rules.append({"from": "trio", "to": "one", "duration": 4, "at": ["dock"]})
    mission = Mission.of(
        map=system,
        team=[{"class": "cube", "count": 4, "at": "dock", "configuration": "one"}],
        configurations={
            "one": {"modules": 1, "capabilities": ["look"]},
            "trio": {"modules": 3, "capabilities": ["lift"], "duration": 2},
        },
        reconfigure=rules,
        formula="F[0,30] T(0,A,{(lift,1)}) && F[0,30] T(0,B,{(look,2)})",
        language="catl",
    )
    setting = prepare(mission)
    network = setting.unrolled()
    number = setting.arrays.number
    gaps = TravelGaps(network)
    lift, look, one = (
        gaps.stay((number[place],), {name: amount}, 30)
        for place, name, amount in (("A", "lift", 1), ("B", "look", 2), ("B", "look", 1))
    )
    found = ModuleGaps(network, setting.changes).between([lift, look, one])
    # 3 steps as a trio take 6, 4 to be taken apart, 3 one by one; the other way 3, 2 and 6
    assert found.tolist() == [[0, 13, 0], [11, 0, 0], [0, 0, 0]]
    assert not gaps.between([lift, look, one]).any()


def line_of(labels: list[str]) -> TransitionSystem:
    """States named by their labels, three steps from each to the next and back."""
    states = [State(name, labels=frozenset({name})) for name in labels]
    edges = [Edge(name, name, 1) for name in labels]
    edges += [Edge(*ends, 3) for pair in pairwise(labels) for ends in (pair, pair[::-1])]
    return TransitionSystem.build(states, edges)


# --- timetables --------------------------------------------------------------------------------


def test_timetables_rule_out_what_is_in_none() -> None:
    """All sets of up to seven columns are tried."""
    kinds = set()
    for seed in range(200):
        rng = random.Random(seed)
        count = rng.randint(3, 7)
        every = range(1, 1 << count)
        wanted = [
            Wanted(rng.choice([None, None, rng.choice(every)]), rng.choice(every)) for _ in range(4)
        ]
        excluded = [0] * count
        for one, other in combinations(range(count), 2):
            if rng.random() < 0.4:
                excluded[one] |= 1 << other
                excluded[other] |= 1 << one
        possible = rng.choice(every) | rng.choice(every)
        answers = [
            ones
            for ones in range(1 << count)
            if not ones & ~possible
            and all(not ones & excluded[n] for n in range(count) if ones >> n & 1)
            and all(ones & w.members or not (w.parents is None or ones & w.parents) for w in wanted)
        ]
        asked = int(np.bitwise_or.reduce([w.members for w in wanted]))
        used = int(np.bitwise_or.reduce([0, *answers]))
        found = Timetables(wanted, excluded, possible).ruled_out()
        assert found == (asked & ~used if answers else None)
        few = Timetables(wanted, excluded, possible, tries=rng.randint(0, 6)).ruled_out()
        assert not answers if few is None else not few & used
        kinds.add("none" if found is None else "some" if found else "all")
    assert kinds == {"none", "some", "all"}


# --- rows --------------------------------------------------------------------------------------


def crossing(formula: str, carts: int = 1) -> Mission:
    """Two places that are five steps apart, and a cart or more in the middle of one of the ways."""
    states = [State("a", labels={"A"}), State("b", labels={"B"}), State("c", labels={"C"})]
    edges = [Edge(state.name, state.name, 1) for state in states]
    edges += [Edge(x, y, 5) for x, y in ("ab", "ba", "bc", "cb", "ac", "ca")]
    return Mission.of(
        map=TransitionSystem.build(states, edges),
        team=[Group.of("cart", {"a": carts}, {"u"})],
        formula=formula,
        language="catl",
        objective=("availability", "travel"),
    )


def test_three_places_in_too_short_a_time_are_refuted_without_a_linear_program() -> None:
    """Any two of the tasks fit into the window, all three do not."""
    three = " && ".join(f"F[0,9] T(1,{label},{{(u,1)}})" for label in LABELS)
    assert tight(prepare(crossing(three))).refuted
    assert not tight(prepare(crossing(three, carts=2))).refuted
    assert tight(prepare(crossing(three.replace("[0,9]", "[0,11]")))).refuted
    assert not tight(prepare(crossing(three.replace("[0,9]", "[0,12]")))).refuted


def test_rows_are_written_where_witnesses_are_rivals_alone() -> None:
    two = "F[0,15] T(1,B,{(u,1)}) && F[0,15] T(1,C,{(u,1)})"
    assert "rivals" in {tag.kind for tag in tight(prepare(crossing(two))).model.tags}
    assert "rivals" not in {tag.kind for tag in tight(prepare(crossing(two, 2))).model.tags}
    without = prepare(crossing(two), switches=frozenset(Switch) - {Switch.RIVALS})
    assert "rivals" not in {tag.kind for tag in tight(without).model.tags}


def test_a_window_that_a_rival_takes_up_has_a_way_out() -> None:
    """While the cart is at B nobody is at C, whose windows are covered before and after."""
    mission = crossing("F[6,9] T(1,B,{(u,1)}) && G[2,4] F[0,12] T(0,C,{(u,1)})")
    assert "rivals" in {tag.kind for tag in tight(prepare(mission)).model.tags}
    plans = [plan(mission), plan(mission, encoding="reference")]
    assert plans[0].status == plans[1].status
    assert [o.value for o in plans[0].objective] == [o.value for o in plans[1].objective]


def test_agents_that_come_late_may_relieve_those_who_leave() -> None:
    """The quick one comes later, relieves the slow one, and both are at B in time.

    Whoever begins the task at A could not be at B after its end, but whoever ends it can.
    """
    states = [State("a", labels={"A"}), State("b", labels={"B"}), State("far")]
    edges = [Edge(state.name, state.name, 1) for state in states]
    edges += [Edge("far", "a", 4), Edge("a", "b", {"slow": 5, "quick": 1})]
    mission = Mission.of(
        map=TransitionSystem.build(states, edges),
        team=[Group.of("slow", {"a": 1}, {"u"}), Group.of("quick", {"far": 1}, {"u"})],
        formula="F[0,1] T(6,A,{(u,1)}) && F[8,9] T(0,B,{(u,2)})",
        language="catl",
        objective=("travel",),
    )
    tightly, plainly = plan(mission), plan(mission, encoding="reference")
    assert str(tightly.status) == str(plainly.status) == "optimal"
    assert [o.value for o in tightly.objective] == [o.value for o in plainly.objective] == [10.0]
