"""Cuts of visitors: agents that come again and again are counted once."""

from __future__ import annotations

import numpy as np
import pytest

from tests.seeds import sampled
from tsplan import Mission, plan
from tsplan.encode.assemble import tight
from tsplan.encode.encoded import Encoded
from tsplan.encode.preparation import prepare
from tsplan.encode.priced_objectives import Travel
from tsplan.encode.visitor_cuts import Separated, VisitorCuts
from tsplan.milp.lp import WarmLP
from tsplan.milp.model import Floats
from tsplan.milp.solution import Options
from tsplan.milp.solver import solver
from tsplan.mission import Group
from tsplan.testing import random_mission
from tsplan.ts import Edge, State, TransitionSystem

TO_AND_FRO = "F[6,16] T(1,A,{(c,4)}) && F[6,16] T(1,B,{(c,4)})"


def far_off() -> TransitionSystem:
    """s - a - b: six steps to the first, one to the next."""
    states = [State("s"), State("a", labels=frozenset("A")), State("b", labels=frozenset("B"))]
    edges = [Edge(name, name, 1) for name in ("s", "a", "b")]
    for near, far, steps in (("s", "a", 6), ("a", "b", 1)):
        edges += [Edge(near, far, steps), Edge(far, near, steps)]
    return TransitionSystem.build(states, edges)


def mission(formula: str = TO_AND_FRO, agents: int = 9) -> Mission:
    team = [Group.of("c", {"s": agents}, {"c"})]
    return Mission.of(map=far_off(), team=team, formula=formula, objective=["travel"])


def separated(encoded: Encoded, values: Floats) -> Separated | None:
    cuts = VisitorCuts(encoded.network, encoded.visits)
    return cuts.violated(values, encoded.model.size.columns)


def bound(encoded: Encoded, *, cuts: bool) -> float:
    """What the linear program says of the travel, perhaps with all cuts that it violates."""
    lp = WarmLP(encoded.model.with_objective(Travel().vector(encoded.setting, encoded)))
    while True:
        result = lp.solve()
        assert result.values is not None
        found = separated(encoded, result.values) if cuts else None
        if found is None:
            return result.objective
        assert (found.rows @ result.values < found.lower - 1e-4).all()
        lp.add_rows(found.rows, found.lower, np.full(len(found.lower), np.inf))


def test_a_few_agents_that_go_to_and_fro_are_not_many() -> None:
    encoded = tight(prepare(mission()))
    optimum = plan(mission()).objective[0].value
    assert optimum == 4 * (6 + 1)
    assert bound(encoded, cuts=False) < 0.7 * optimum
    assert bound(encoded, cuts=True) == pytest.approx(optimum)


def test_of_alternatives_each_asks_for_its_own_number() -> None:
    formula = "F[6,16] (T(1,A,{(c,4)}) || T(0,B,{(c,2)})) && F[6,16] T(0,A,{(c,3)})"
    encoded = tight(prepare(mission(formula)))
    optimum = plan(mission(formula)).objective[0].value
    assert optimum is not None
    assert bound(encoded, cuts=True) <= optimum + 1e-6


def test_a_window_under_an_always_asks_for_whole_visitors() -> None:
    formula = "G[6,30] F[0,6] T(0,A,{(c,2)}) && F[8,20] T(1,B,{(c,3)})"
    encoded = tight(prepare(mission(formula)))
    optimum = plan(mission(formula)).objective[0].value
    assert optimum is not None
    assert bound(encoded, cuts=False) <= bound(encoded, cuts=True) <= optimum + 1e-6


@pytest.mark.parametrize("seed", sampled(range(4000, 4400), range(4000, 4012)))
def test_no_plan_is_cut_off(seed: int) -> None:
    """The cuts that fractional points violate hold at every whole point that is tried."""
    encoded = tight(prepare(random_mission(seed)))
    if encoded.refuted or not encoded.visits:
        return
    random = np.random.default_rng(seed)
    for _ in range(3):
        model = encoded.model.with_objective(random.uniform(-1, 1, encoded.model.size.columns))
        relaxed = WarmLP(model).solve().values
        whole = solver("highs").solve(model, Options(time_limit=5.0, seed=0)).values
        if relaxed is None or whole is None:
            return
        assert separated(encoded, np.round(whole)) is None
        found = separated(encoded, relaxed)
        if found is not None:
            assert (found.rows @ np.round(whole) >= found.lower - 1e-6).all()
