"""Models grow with what a mission describes, and no faster; and they stay exact."""

from __future__ import annotations

import random
from collections.abc import Callable

import pytest

from tests.seeds import long, sampled
from tsplan import Mission, plan
from tsplan.encode import (
    running_sums as sums,
)
from tsplan.encode import (
    selection,
)
from tsplan.encode import (
    until_release as switching,
)
from tsplan.encode.assemble import tight
from tsplan.encode.preparation import prepare
from tsplan.milp.model import Size
from tsplan.mission import Group
from tsplan.ts import Edge, State, TransitionSystem

LABELS = "ABCD"


def hub() -> TransitionSystem:
    """Four places around a hub, one to three steps away."""
    states = [State("hub"), *(State(f"at{name}", labels=frozenset(name)) for name in LABELS)]
    edges = [Edge(state.name, state.name, 1) for state in states]
    for far, name in enumerate(LABELS):
        edges += [Edge("hub", f"at{name}", 1 + far % 3), Edge(f"at{name}", "hub", 1 + far % 3)]
    return TransitionSystem.build(states, edges)


def one_cart(formula: str, objective: tuple[str, ...] = ("travel",)) -> Mission:
    return Mission.of(
        map=hub(),
        team=[Group.of("cart", {"atA": 1}, {"cart"})],
        formula=formula,
        language="mtl",
        objective=objective,
    )


def stops(number: int, window: int) -> str:
    """Places to be visited one after the other, each within a window after the one before."""
    formula = f"F[1,{window}] {LABELS[(number - 1) % 4]}"
    for place in range(number - 2, -1, -1):
        formula = f"F[{min(place, 1)},{window}] ({LABELS[place % 4]} && {formula})"
    return formula


def size(formula: str) -> Size:
    return tight(prepare(one_cart(formula))).model.size


@pytest.mark.parametrize(
    "formula",
    [
        long(lambda n: stops(4, n)),
        lambda n: f"F[0,{n}] B",
        lambda n: f"F[0,{n}] (B || C && D)",
        lambda n: f"F[0,{n}] G[0,{n}] B",
        lambda n: f"G[0,{n}] F[0,{n}] B",
        long(lambda n: f"F[0,{n}] G[0,{n}] F[0,{n}] B"),
        long(lambda n: f"F[0,{n}] G[0,{n}] (B || C)"),
        lambda n: f"!D U[0,{n}] B",
        long(lambda n: f"F[0,{n}] (A && (!D U[0,{n}] B))"),
        lambda n: f"F[0,{n}] (A && !(!D U[0,{n}] B))",
        lambda n: f"G[0,{n}] (!D U[0,{n}] B)",
    ],
    ids=range(11),
)
def test_columns_and_nonzeros_grow_with_windows_and_stops(formula: Callable[[int], str]) -> None:
    small, large = size(formula(80)), size(formula(320))
    assert large.columns <= 6 * small.columns
    assert large.rows <= 6 * small.rows
    assert large.nonzeros <= 6 * small.nonzeros


@pytest.mark.parametrize("number", sampled([4, 8, 16, 32], [4, 8]))
def test_stops_in_a_row_cost_so_much_for_each_step_of_each(number: int) -> None:
    found = size(stops(number, 20))
    steps = number * number * 20  # each stop may be made at any step up to its last
    assert found.columns <= 10 * steps
    assert found.nonzeros <= 60 * steps


def test_a_long_window_costs_a_few_entries_a_step() -> None:
    found = size("F[0,4000] B")
    assert found.nonzeros < 4000 * 60


def test_one_agent_somewhere_needs_no_witness() -> None:
    assert len(tight(prepare(one_cart("F[2,9] B"))).indicators) == 0
    assert len(tight(prepare(one_cart("F[2,9] (B && D)"))).indicators) > 0


def test_four_stops_in_a_row_are_planned() -> None:
    made = plan(one_cart(stops(4, 20), ("makespan",)), time_limit=60)
    assert made.status == "optimal"
    # B is 1 + 2 steps away, then C 2 + 3, then D 3 + 1
    assert made.objective[0].value == 12


def test_a_window_of_many_steps_is_planned() -> None:
    made = plan(one_cart("F[0,4000] B"), time_limit=60)
    assert (made.status, made.objective[0].value) == ("optimal", 3)


# --- the shorter forms say the same as those written out, and as the reference encoding -----------


@pytest.fixture
def shortest(monkeypatch: pytest.MonkeyPatch) -> None:
    """Chains, relays and running totals wherever they can be, however small the mission."""
    monkeypatch.setattr(sums, "_WORTH", 0)
    monkeypatch.setattr(selection, "_WRITTEN", 0)
    monkeypatch.setattr(switching, "_FEW", 0)
    monkeypatch.setattr(switching, "_COPIES", 0)


def formula_of(rng: random.Random, depth: int) -> str:
    """Eventualities, untils and releases inside each other."""
    if depth == 0:
        return rng.choice(["", "", "!"]) + rng.choice(LABELS)
    low = rng.randint(0, 2)
    window = f"[{low},{low + rng.randint(0, 3)}]"
    left, right = formula_of(rng, depth - 1), formula_of(rng, depth - 1)
    return rng.choice(
        [
            f"F{window} ({left})",
            f"F{window} ({left} && {right})",
            f"G{window} ({left})",
            f"(({left}) U{window} ({right}))",
            f"!((!({left})) U{window} (!({right})))",
            f"(({left}) || ({right}))",
        ]
    )


def small(rng: random.Random) -> Mission:
    """One or two agents on a few states, and a formula of some depth."""
    count = rng.randint(2, 4)
    labels = [set[str]() for _ in range(count)]
    for name in LABELS:
        labels[rng.randrange(count)].add(name)
    states = [State(f"s{n}", labels=frozenset(mine)) for n, mine in enumerate(labels)]
    edges = [Edge(state.name, state.name, 1) for state in states]
    edges += [
        Edge(f"s{n}", f"s{m}", rng.randint(1, 2))
        for n in range(count)
        for m in range(count)
        if n != m and (m == (n + 1) % count or rng.random() < 0.5)
    ]
    return Mission.of(
        map=TransitionSystem.build(states, edges),
        team=[Group.of("r", {"s0": rng.randint(1, 2)}, {"r"})],
        formula=formula_of(rng, rng.randint(2, 3)),
        language="mtl",
        objective=("travel",),
    )


def agree(seed: int) -> None:
    mission = small(random.Random(seed))
    tightly, plainly = plan(mission), plan(mission, encoding="reference")
    assert tightly.status == plainly.status, str(mission.formula)
    assert [item.value for item in tightly.objective] == [item.value for item in plainly.objective]


@pytest.mark.usefixtures("shortest")
@pytest.mark.parametrize("seed", sampled(range(600), range(5)))
def test_short_forms_agree_with_the_reference(seed: int) -> None:
    agree(seed)


@pytest.mark.long
@pytest.mark.parametrize("seed", range(600, 1000))
def test_nested_formulas_agree_with_the_reference_on_many(seed: int) -> None:
    agree(seed)


def test_the_way_between_two_stops_is_known_before_any_flow() -> None:
    """B is three steps from A: one cart cannot be there sooner, of two the other can."""
    formula = "F[0,9] (A && F[1,9] (B && F[1,9] C))"
    alone = one_cart(formula)
    kinds = {tag.kind for tag in tight(prepare(alone)).model.tags}
    assert "precedence" in kinds
    two = Mission.of(
        map=hub(), team=[Group.of("cart", {"atA": 2}, {"cart"})], formula=formula, language="mtl"
    )
    kinds = {tag.kind for tag in tight(prepare(two)).model.tags}
    assert "precedence" not in kinds


def test_a_second_stop_that_may_come_first_is_not_spaced_out() -> None:
    """What the first witness needs lies five steps later, so the agent may be at B before."""
    formula = "F[0,3] F[0,1] (G[6,6] A && F[1,2] (B && F[1,9] C))"
    mission = one_cart(formula)
    assert plan(mission).status == plan(mission, encoding="reference").status
