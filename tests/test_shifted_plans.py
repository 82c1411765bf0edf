"""Plans whose errands are shifted in time, and the small programs that say what they cost."""

from __future__ import annotations

import re
from dataclasses import replace

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
from tsplan.milp.lp import WarmLP
from tsplan.milp.model import Ints
from tsplan.milp.solution import Options
from tsplan.milp.solver import solver
from tsplan.milp.target import Target
from tsplan.milp.what_if import WhatIf
from tsplan.mission import Mission
from tsplan.search.effort import Effort
from tsplan.search.routes import shifting
from tsplan.search.routes.errand_steps import Steps
from tsplan.search.routes.errands import errands_of
from tsplan.search.routes.links import links_of
from tsplan.search.routes.shifted_plans import ShiftedPlans, shifted_plans
from tsplan.search.search import Search

EFFORT = Effort(solver("highs"))


@pytest.fixture(autouse=True)
def few_turns(monkeypatch: pytest.MonkeyPatch) -> None:
    """These missions are small."""
    monkeypatch.setattr(shifting, "_TURNS", 60)


def made(plan: Mission) -> tuple[Encoded, Target, ShiftedPlans | None]:
    encoded = tight(prepare(plan))
    target = Travel().target(encoded.setting, encoded)
    return encoded, target, shifted_plans(encoded, target, EFFORT, Clock(60.0))


def cost_of(found: ShiftedPlans, begins: Ints) -> float | None:
    """What agents cost with given steps of all errands."""
    solution = EFFORT.solver.solve(found.program.held(begins), Options(time_limit=20.0, seed=0))
    return solution.objective


def held(encoded: Encoded, target: Target, found: ShiftedPlans, begins: Ints) -> float | None:
    """What the whole model costs with given steps of all errands."""
    upper = encoded.model.upper.copy()
    for errand, step in zip(found.program.errands, begins.tolist(), strict=True):
        upper[errand.columns[errand.steps != step]] = 0.0
    model = encoded.model.with_objective(target.vector).with_bounds(encoded.model.lower, upper)
    return EFFORT.solver.solve(model, Options(time_limit=20.0, seed=0)).objective


@pytest.mark.parametrize("seed", sampled(range(60), range(3)))
def test_with_steps_held_links_cost_what_the_whole_model_does(seed: int) -> None:
    """Nobody can be relieved within stays of a single step, so the two are equal there."""
    text = str(mission(seed).formula)
    short = re.sub(r"T\(\d+,", "T(0,", text.replace(" ", "")).replace(",1)})", ",2)})")
    for formula, equal in ((text, False), (short, True)):
        encoded, target, found = made(mission(seed, formula=formula))
        assert found is not None
        low, high = found.steps.ends
        random = np.random.default_rng(seed)
        for _ in range(3):
            begins = found.steps.begins(random.integers(low, high + 1))
            whole, linked = held(encoded, target, found, begins), cost_of(found, begins)
            assert linked is None or (whole is not None and whole <= linked + 1e-6)
            assert not equal or linked == (None if whole is None else pytest.approx(whole))


@pytest.mark.parametrize("seed", sampled(range(40), range(2)))
def test_shifted_plans_are_plans_of_the_whole_and_near_the_best(seed: int) -> None:
    plan = mission(seed, tasks=7)
    encoded, target, found = made(plan)
    assert found is not None
    search = Search(encoded, target, EFFORT, Clock(), lambda *_: None)
    values = []
    for flows in found.flows():
        point = search.adopt(flows)
        assert point is not None
        values.append(target.value(point))
    assert values == sorted(values, reverse=True)
    optimum = float(tsplan.plan(plan).objective[0].value or 0)
    assert optimum <= values[-1] <= 1.1 * optimum


FORMULAS = {
    "at once": "F[6,14] (T(2,l0,{(x,3),(y,2)}) && T(2,l1,{(x,2)})) && F[0,20] T(3,l2,{(x,1)})",
    "at one place": "F[4,20] T(2,l0,{(x,3)}) && F[6,14] T(1,l0,{(x,4)}) && F[5,9] T(2,l0,{(y,2)})",
    "in a row": "F[4,9] (T(1,l0,{(x,2)}) && F[2,9] T(1,l1,{(x,3)})) && F[8,16] T(2,l2,{(y,1)})",
    "alternatives": "F[6,14] (T(2,l0,{(x,3)}) || T(0,l1,{(y,2)})) && F[4,12] T(1,l2,{(x,2)})",
    "covered": "G[6,22] F[0,7] T(0,l0,{(y,2)}) && F[8,20] T(1,l1,{(x,3)})",
}


@pytest.mark.parametrize("formula", FORMULAS.values(), ids=FORMULAS)
def test_whatever_is_asked_for_what_is_adopted_is_a_plan(formula: str) -> None:
    plan = mission(3, tasks=3, formula=formula)
    encoded, target, found = made(plan)
    optimum = float(tsplan.plan(plan).objective[0].value or 0)
    search = Search(encoded, target, EFFORT, Clock(), lambda *_: None)
    for flows in () if found is None else found.flows():
        point = search.adopt(flows)
        if point is not None:
            assert encoded.model.violation(point) < 1e-6
            assert target.value(point) >= optimum


def test_errands_with_the_same_witnesses_begin_together() -> None:
    encoded, _, found = made(mission(3, tasks=3, formula=FORMULAS["at once"]))
    assert found is not None
    errands = found.program.errands
    assert len(errands) == len(errands_of(encoded, whole=True)) - 1 == 4
    assert len(set(found.steps.event.tolist())) == 2
    first = errands[0]
    other = replace(first, columns=first.columns[1:], steps=first.steps[1:])
    assert Steps.of([first, other]) is None
    assert Steps.of([first, replace(first, steps=first.steps + 2)]) is not None


def test_where_ways_have_no_single_price_there_are_no_links() -> None:
    encoded, target, found = made(mission(0))
    assert found is not None
    errands, network = found.program.errands, encoded.network
    item = network.classes[0]
    wait = int(np.flatnonzero(item.graph.wait)[0])
    edge, _, column = item.unrolled()
    standing = target.vector.copy()
    standing[column[edge == wait]] = 1.0
    assert links_of(network, errands, standing) is None
    late = target.vector.copy()
    late[column[-1]] += 1.0
    assert links_of(network, errands, late) is None
    wide = replace(errands[0], states=np.array([0, 1]))
    assert links_of(network, (wide, *errands[1:]), target.vector) is None


def test_what_is_asked_is_what_a_program_from_scratch_says() -> None:
    _, _, found = made(mission(4, tasks=8))
    assert found is not None
    model, asked = found.program.model, WhatIf(found.program.model)
    random = np.random.default_rng(0)
    low, high = found.steps.ends
    for turn in range(30):
        wanted = found.program.open(found.steps.begins(random.integers(low, high + 1)))
        upper = np.where(wanted, np.inf, 0.0)
        scratch = WarmLP(model.with_bounds(model.lower, upper)).solve()
        assert asked.ask(wanted, scratch.objective - 1.0) is None
        asked.drop()
        value = asked.ask(wanted)
        assert value == pytest.approx(scratch.objective)
        if turn % 2:
            asked.drop()
            continue
        answer = asked.keep()
        assert answer.value == pytest.approx(scratch.objective)
        assert float(model.objective @ answer.values) == pytest.approx(scratch.objective)
        assert not answer.values[~wanted].any()


def test_shifts_keep_to_the_windows_and_drag_along_what_is_linked(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(shifting, "_DRAGGED", 1.0)
    _, _, found = made(mission(5, tasks=9))
    assert found is not None
    search = shifting.Shifting(found.program, found.steps, Clock(), found.steps.middle)
    low, high = found.steps.ends
    steps = search.steps
    for _ in range(200):
        tried = search._shifted(steps)
        assert ((low <= tried) & (tried <= high)).all()
        if search._accepted(tried, np.inf):
            steps = tried
    begins = found.steps.begins(steps)
    assert search._answer.value == pytest.approx(cost_of(found, begins) or np.nan)
