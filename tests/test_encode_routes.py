"""What stops in a row cost to travel is known before any flow, and never more than it is."""

from __future__ import annotations

from random import Random

import pytest

import tsplan
from tests.seeds import seed_blocks
from tests.test_encode_agree import answer
from tsplan import Mission
from tsplan.encode.assemble import tight
from tsplan.encode.preparation import prepare
from tsplan.encode.priced_objectives import Travel
from tsplan.milp.lp import WarmLP
from tsplan.mission import Group
from tsplan.ts import Edge, State, TransitionSystem

PLACES = "ABCD"


def town(random: Random) -> TransitionSystem:
    """Four places around a hub, some of them joined to each other as well."""
    states = [State("hub"), *(State(f"at{p}", labels=frozenset({p})) for p in PLACES)]
    edges = [Edge(state.name, state.name) for state in states]
    for place in PLACES:
        there, back = random.randint(1, 3), random.randint(1, 3)
        edges += [Edge("hub", f"at{place}", there), Edge(f"at{place}", "hub", back)]
    for one in PLACES:
        for two in PLACES:
            if one != two and random.random() < 0.2:
                edges.append(Edge(f"at{one}", f"at{two}", random.randint(1, 4)))
    return TransitionSystem.build(states, edges)


def stop(random: Random) -> str:
    """What is asked for at one stop: so many there, now or for a while, here or there."""
    place = random.choice(PLACES)
    count = f"sum({place}) >= {random.choice([1, 1, 2])}"
    kind = random.random()
    if kind < 0.2:
        return f"G[0,{random.randint(1, 2)}] {count}"
    if kind < 0.3:
        return f"({count} || {random.choice(PLACES)})"
    return count


def chain(random: Random, length: int) -> str:
    """Stops one after the other, now and then with a branch."""
    window = f"F[{random.randint(0, 1)},{random.randint(2, 5)}]"
    if length == 1:
        return f"{window} {stop(random)}"
    rest = chain(random, length - 1)
    if random.random() < 0.2:
        rest = f"{rest} && {chain(random, 1)}"
    return f"{window} ({stop(random)} && {rest})"


def errand(seed: int) -> Mission:
    """A few agents with stops in a row, and another errand beside it now and then."""
    random = Random(seed)
    text = chain(random, random.randint(2, 3))
    if random.random() < 0.3:
        text = f"({text}) {random.choice(['&&', '||'])} ({chain(random, 2)})"
    start = random.choice(["hub", "atA", "atB"])
    team = [Group.of("cart", {start: random.randint(1, 3)})]
    order = random.choice([("travel",), ("travel", "makespan"), ("availability", "travel")])
    return Mission.of(map=town(random), team=team, formula=text, language="mtl", objective=order)


def routed(mission: Mission) -> bool:
    """Whether the tight model knows what some stops in a row cost to travel."""
    return any(tag.kind == "route" for tag in tight(prepare(mission)).model.tags)


def compare(seed: int) -> bool:
    mission = errand(seed)
    assert answer(tsplan.plan(mission)) == answer(tsplan.plan(mission, encoding="reference")), seed
    return routed(mission)


def test_routes_change_no_answer() -> None:
    seen = [compare(seed) for seed in range(60_010, 60_023)]
    assert seen.count(True) >= 4


@pytest.mark.parametrize(
    "seeds", seed_blocks((), [*range(60_000, 60_010), 60_023, *range(61_000, 62_000)], 10)
)
def test_routes_change_no_answer_on_many(seeds: list[int]) -> None:
    for seed in seeds:
        compare(seed)


@pytest.mark.long
def test_eight_stops_in_a_row_are_proven_by_the_first_linear_program() -> None:
    ways = [("hub", "atA", 2), ("hub", "atB", 3), ("hub", "atC", 1), ("hub", "atD", 1)]
    names = ["hub", *(f"at{p}" for p in PLACES)]
    states = [State(n, labels=frozenset({n[-1]}) if n != "hub" else frozenset()) for n in names]
    edges = [Edge(n, n) for n in names]
    edges += [Edge(*pair, w) for a, b, w in ways for pair in ((a, b), (b, a))]
    text = "D"
    for place in reversed("ABCDABC"):
        text = f"{place} && F[1,20] ({text})"
    mission = Mission.of(
        map=TransitionSystem.build(states, edges),
        team=[Group.of("cart", {"atD": 1})],
        formula=f"F[0,20] ({text})",
        language="mtl",
        objective=["travel"],
    )
    setting = prepare(mission)
    encoded = tight(setting)
    vector = Travel().vector(setting, encoded)
    first = WarmLP(encoded.model.with_objective(vector)).solve()
    # twice 3 + 5 + 4 + 2 steps, from D to A to B to C to D
    assert first.objective == pytest.approx(28)
    plan = tsplan.plan(mission, time_limit=60)
    assert (plan.status, plan.objective[0].value) == ("optimal", 28)
