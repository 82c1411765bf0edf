"""Why a trajectory holds, and how often it still does when it is shaken."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given

from tests.carts import REF, cart_mission, cart_run
from tests.seeds import quick, seeds
from tsplan.errors import InputError, PlanError
from tsplan.explanation.why.trajectory_reasons import explain_trajectory, explain_wishes
from tsplan.explanation.why.witness_tree import explain_on
from tsplan.logic import And, Iff, Implies, Linear, Not, horizon, linear, parse, walk
from tsplan.logic.evaluation import holds, margins, robustness
from tsplan.logic.traces import SignalTrace
from tsplan.mission.mission_parts import Preference
from tsplan.plans.outcomes import ObjectiveValue
from tsplan.protocol.disturbances import simulate_disturbed
from tsplan.signals.linear_system import System
from tsplan.signals.signal_mission import SignalMission
from tsplan.signals.trajectory import Trajectory
from tsplan.signals.trajectory_check import certify
from tsplan.testing.formula_strategies import formulas, signal_trace

MISSION = cart_mission()
FOUND = certify(MISSION, cart_run(ObjectiveValue("robustness", 0.5, 0.5)))
EXPECTED = """\
&&               holds at 0, robustness 0.5, critical: x >= 3 at 5; y >= 2 at 5; y <= 3 at 5
  F[0,5]         holds at 0, robustness 0.5, met at 5, critical: x >= 3 at 5; y >= 2 at 5; \
y <= 3 at 5
    &&           holds at 5, robustness 0.5
      x >= 3     holds at 5, robustness 0.5, value 3.5
      x <= 5     holds at 5, robustness 1.5, value 3.5
      y >= 2     holds at 5, robustness 0.5, value 2.5
      y <= 3     holds at 5, robustness 0.5, value 2.5
  G[0,5]         holds at 0, robustness 0.75, tightest at 4, critical: y <= 3.25 at 4
    ||           holds at 0..5, robustness 0.75
      x <= 1.5   (not needed: holds at 0..5 but for 3..5, robustness -2, value 1..3.5)
      x >= 2.5   holds at 5, robustness 1, value 3.5
      y <= 3.25  holds at 0..4, robustness 0.75, value 2..2.5
      y >= 9     (not needed: fails at 0..5, robustness -7, value 2..2.5)"""


def stl(text):
    return parse(text, language="stl")


def test_the_tree_in_words():
    assert str(FOUND.explain(MISSION)) == EXPECTED
    assert str(FOUND.with_mission(MISSION).explain()) == EXPECTED


def test_preferred_formulas_have_trees_of_their_own():
    late = Preference(stl("G[4,5] x >= 3.25"), "be there soon")
    mission = cart_mission(prefer=(late,))
    (tree,) = explain_wishes(FOUND, mission).values()
    assert not tree.holds
    assert tree.critical == {stl("x >= 3.25"): (4,)}


def test_what_has_no_signals_is_not_explained():
    with pytest.raises(PlanError, match="has no signals"):
        explain_trajectory(Trajectory("infeasible", REF, 5), MISSION)


@pytest.mark.parametrize("weighting", ["product", "normalised"])
@pytest.mark.parametrize("bound", [1.0, 3.0])
def test_weights_are_multiplied_into_the_tree(weighting, bound):
    x, y = linear({"x": 1}, ">=", bound), linear({"y": 1}, ">=", 1)
    formula = And(
        (x.always(0, 2, [3.0, 1.0, 2.0]), y.eventually(0, 2, [1.0, 2.0, 1.0])), (1.0, 4.0)
    )
    mission = SignalMission(
        System({"x": (0, 9), "y": (0, 9)}), formula, 2, weighting=weighting, language="wstl"
    )
    found = Trajectory("feasible", REF, 2, "gap", signals={"x": (2, 3, 2), "y": (0, 2, 3)})
    tree = explain_trajectory(found, mission)
    by = robustness(formula, found.trace(), kind=weighting)[0]
    assert tree.worst == pytest.approx(by)
    assert tree.critical
    for atom, steps in tree.critical.items():
        assert set(robustness(atom, found.trace())[list(steps)]) == {tree.worst}


def test_equations_hold_as_closely_as_the_check_asks():
    formula = stl("G[0,1] x = 2")
    mission = SignalMission(System({"x": (0, 9)}), formula, 1)
    found = Trajectory("feasible", REF, 1, "gap", signals={"x": (2, 2 + 1e-9)})
    assert explain_trajectory(found, mission).holds
    assert not explain_on(formula, found.trace()).holds


def test_an_implication_rests_on_the_side_that_holds():
    formula, trace = stl("x >= 1 => y >= 2"), SignalTrace({"x": [0.5], "y": [2.25]})
    tree = explain_on(formula, trace)
    assert [child.needed for child in tree.children] == [True, False]


@quick
@given(formulas("stl"), seeds)
def test_random_trees_agree_with_the_evaluator(formula, seed):
    trace = signal_trace(seed, horizon(formula) + 1)
    tree = explain_on(formula, trace)
    assert tree.availability == (robustness(formula, trace)[0],)
    values = margins(formula, trace)
    atoms = [node.formula for _, node in tree.walk() if isinstance(node.formula, Linear)]
    for _, node in tree.walk():
        assert node.availability == tuple(values[node.formula][list(node.steps)])
        if isinstance(node.formula, Linear):
            assert node.counts == tuple(trace.total(node.formula.terms)[list(node.steps)])
    if atoms and np.isfinite(tree.worst) and not any(isinstance(n, Iff) for n in walk(formula)):
        assert tree.critical or any(isinstance(node, Not | Implies) for node in walk(formula))


# --- shaken --------------------------------------------------------------------------------------


def test_without_an_amplitude_nothing_changes():
    found = simulate_disturbed(MISSION, FOUND, amplitude=0.0, runs=3)
    assert (found.formula.times, found.bounds.times) == (3, 3)
    assert found.least == found.mean == pytest.approx(0.5)


def test_shaken_runs_are_those_of_the_system():
    amplitude = {"x": 0.5, "vy": 0.25}
    found = FOUND.simulate(MISSION, amplitude=amplitude, runs=200, seed=7)
    assert found == simulate_disturbed(MISSION, FOUND, amplitude=amplitude, runs=200, seed=7)
    random, system = np.random.default_rng(7), MISSION.system
    a, b, d = system.dynamics.arrays
    controls = np.array([FOUND[name] for name in system.controls])
    worth, inside = [], 0
    for noise in random.uniform(-1, 1, (200, 5, 4)) * [0.5, 0, 0, 0.25]:
        states = [FOUND.states[:, 0]]
        for step in range(5):
            states.append(a @ states[-1] + b @ controls[:, step] + d + noise[step])
        rows = dict(zip(system.signals, np.array(states).T, strict=True))
        worth.append(robustness(MISSION.formula, SignalTrace(rows))[0])
        inside += all(
            low <= row.min() and row.max() <= high
            for row, (low, high) in zip(rows.values(), system.signals.values(), strict=True)
        )
    assert 0 < found.formula.times < 200
    assert found.formula.times == sum(value >= 0 for value in worth)
    assert found.bounds.times == inside
    assert found.least == pytest.approx(min(worth))
    assert found.mean == pytest.approx(np.mean(worth))


def test_free_signals_are_shaken_where_they_are():
    formula = stl("G[0,2] x >= 1")
    mission = SignalMission(System({"x": (0, 4)}), formula, 2)
    planned = certify(mission, Trajectory("feasible", REF, 2, "gap", signals={"x": (2, 2, 2)}))
    assert simulate_disturbed(mission, planned, amplitude=1.0).formula.rate == 1
    found = simulate_disturbed(mission, planned, amplitude=2.0, runs=4000)
    assert found.formula.low < (3 / 4) ** 2 < found.formula.high


def test_what_cannot_be_shaken_is_said():
    with pytest.raises(InputError, match="there is no signal 'z'"):
        simulate_disturbed(MISSION, FOUND, amplitude={"z": 1.0})
    for size in (-1.0, float("nan")):
        with pytest.raises(InputError, match="no number from 0 on"):
            simulate_disturbed(MISSION, FOUND, amplitude=size)
    with pytest.raises(ValueError, match="at least one run"):
        simulate_disturbed(MISSION, FOUND, amplitude=1.0, runs=0)
    broken = cart_run(controls={"ux": (9,) * 5, "uy": (0,) * 5})
    with pytest.raises(PlanError, match="above its bound"):
        simulate_disturbed(MISSION, broken, amplitude=0.1)
    assert holds(MISSION.formula, FOUND.trace())[0]
