"""Synthesis over signals: what is found, what is proven, and what is said where nothing is."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import tsplan
from tests.seeds import seed_blocks
from tsplan.encode.witness import WitnessRules
from tsplan.errors import MissionError
from tsplan.logic import parse
from tsplan.milp.solver import installed
from tsplan.plans.outcomes import Status
from tsplan.run.events import Bound, Incumbent
from tsplan.signals import Region, System, double_integrator, free_signals
from tsplan.signals.signal_model import signal_model
from tsplan.signals.synthesiser import synthesise_mission
from tsplan.stopping import StoppedBy
from tsplan.testing.random_signals import random_signal_mission

PLANE = double_integrator(("x", "y"), position=(0, 10), speed=1, push=0.5)
GOAL, WALL = Region(x=(7, 8), y=(8, 9)), Region(x=(3, 5), y=(4, 6))
START = {"x": 1, "y": 2}


def reach_avoid(steps=12):
    return GOAL.inside().eventually(0, steps) & WALL.outside().always(0, steps)


def free(text, language="stl", system=None, **given):
    system = system or free_signals(x=(0, 10), y=(0, 10))
    formula = parse(text, language)
    return tsplan.synthesise(formula, system, **given)


@pytest.mark.parametrize("solver", installed())
def test_every_solver_finds_the_same_optimum(solver):
    found = tsplan.synthesise(reach_avoid(), PLANE, start=START, solver=solver)
    assert (found.status, found.verified) == (Status.OPTIMAL, True)
    assert found.robustness == pytest.approx(0.5, abs=1e-6)


def test_objectives_are_pursued_in_order():
    order = ["robustness", "control_effort"]
    found = tsplan.synthesise(reach_avoid(10), PLANE, start=START, objective=order)
    values = {item.name: item.value for item in found.objective}
    assert found.status is Status.OPTIMAL
    assert values == pytest.approx({"robustness": 0.5, "control_effort": 2.5}, abs=1e-6)
    terms = {"robustness": 1, "control_effort": 0.1}
    found = tsplan.synthesise(reach_avoid(10), PLANE, start=START, objective=terms)
    assert found.objective[0].name == "J"
    assert found.objective[0].value == pytest.approx(0.25, abs=1e-6)


def test_any_trajectory_is_as_good_as_another_without_objectives():
    found = tsplan.synthesise(reach_avoid(), PLANE, start=START, objective=[])
    assert (found.status, found.objective) == (Status.OPTIMAL, ())
    assert found.robustness >= 0


def test_what_cannot_hold_is_infeasible():
    assert free("G[0,3] x >= 4 && F[1,2] x <= 3").status is Status.INFEASIBLE
    assert free("F[0,3] x >= 11").status is Status.INFEASIBLE
    late = tsplan.synthesise(GOAL.inside().eventually(0, 3), PLANE, start=START)
    assert (late.status, late.stopped_by) == (Status.INFEASIBLE, None)


def test_a_strict_predicate_has_no_border():
    assert free("x > 10").status is Status.INFEASIBLE
    assert free("x >= 10").status is Status.OPTIMAL
    slow = System({"x": (0, 10)}, initial={"x": (0, 0)})
    assert free("x > 0", system=slow).status is Status.INFEASIBLE
    # the border does not belong to the trajectories, but they come as close as can be told
    found = free("F[0,2] x > 4", objective=["state_effort"])
    assert found.status is Status.OPTIMAL
    assert 4.0 < found["x"].max() < 4.00001


def test_an_equation_holds_within_a_millionth_of_its_range():
    found = free("G[0,3] x = 3 && F[0,3] x + y = 7")
    assert found.status is Status.OPTIMAL
    assert np.abs(found["x"] - 3).max() < 1e-5
    assert found.robustness == pytest.approx(0.0, abs=2e-5)
    # a strict comparison beside it has a margin of its own
    found = free("x = 3 && F[0,2] y > 4", objective=["state_effort"])
    assert found["y"].max() > 4


def test_weights_scale_what_parts_are_worth():
    assert free("&&^[0.5, 1] (x >= 4, y >= 4)", "wstl").robustness == pytest.approx(3.0)
    halved = free("&&^[0.25, 0.75] (x >= 4, y >= 4)", "wstl", weighting="normalised")
    assert halved.robustness == pytest.approx(1.5)


def test_the_structural_bound_is_half_the_width_of_a_box():
    mission = tsplan.SignalMission.of(
        system=PLANE, start=START, formula=reach_avoid(), objective=["robustness"]
    )
    assert tsplan.Synthesis(mission).setting().ideal == pytest.approx(0.5)


def test_restrictions_have_fewer_choices_and_only_trajectories_of_the_whole():
    mission = tsplan.SignalMission.of(system=PLANE, start=START, formula=reach_avoid(16))
    setting = tsplan.Synthesis(mission).setting()
    whole = signal_model(setting, (0.0, 0.5)).model.size
    blocked = signal_model(setting, (0.0, 0.5), WitnessRules(block=4, stride=2)).model.size
    assert blocked.integers < whole.integers / 2
    assert blocked.columns - blocked.integers == whole.columns - whole.integers


def test_own_constraints_and_terms():
    mission = tsplan.SignalMission.of(
        system=free_signals(x=(0, 10)), formula=parse("F[0,3] x >= 4", "stl"), objective=[]
    )
    problem = tsplan.Synthesis(mission)
    problem.add(problem.value("x", 2) <= problem.value("x", 1) - 1.5, "falling")
    problem.add(sum(problem.value("x", step) for step in range(4)) == 9)
    problem.maximise(problem.value("x", 2))
    found = tsplan.synthesise(problem)
    assert found["x"].sum() == pytest.approx(9)
    assert found["x"][2] == pytest.approx(found["x"][1] - 1.5)
    assert found["x"][2] == pytest.approx(3.75)
    assert problem.native("highs").getNumCol() == problem.model.size.columns


@pytest.mark.parametrize(
    ("wrong", "words"),
    [
        (lambda p: p.value("z", 1), "signal or control 'z'"),
        (lambda p: p.value("x", 9), "step"),
        (lambda p: p.add(p.value("x", 1)), "not a constraint"),
        (lambda p: p.add(p.value("x", 1) < 3), "'<' and '>'"),
        (lambda p: p.minimise(3), "not an objective"),
    ],
)
def test_own_terms_that_mean_nothing_are_refused(wrong, words):
    mission = tsplan.SignalMission.of(
        system=free_signals(x=(0, 10)), formula=parse("F[0,3] x >= 4", "stl")
    )
    with pytest.raises(MissionError, match=words):
        wrong(tsplan.Synthesis(mission))


def test_parts_hold_as_far_as_possible():
    text = "F[0,6] (x >= 5 && y >= 5) && G[3,6] x <= 2 && F[0,4] y >= 3"
    system = double_integrator(("x", "y"), position=(0, 10), speed=1, push=1)
    mission = tsplan.SignalMission.of(
        system=system,
        start={"x": 0, "y": 0},
        formula=text,
        language="stl",
        objective=[{"satisfaction": "weighted"}, "robustness"],
    )
    found = tsplan.synthesise(mission)
    assert (found.status, found.verified) == (Status.OPTIMAL, True)
    # x may be 5 for the first part at the cost of the second, or half of the first is left out
    assert found.fraction == pytest.approx(2.5 / 3)
    by_depth = replace(mission, satisfaction="hierarchical")
    found = tsplan.synthesise(by_depth)
    assert found.status is Status.OPTIMAL
    assert all(item.value == item.bound for item in found.depths)
    assert found.depths[1].value == 2


def test_preferred_formulas_beside_what_must():
    mission = tsplan.SignalMission.of(
        system=free_signals(x=(0, 10)),
        must="G[0,4] x <= 6",
        prefer=[
            {"formula": "F[0,4] x >= 7", "weight": 5},
            {"formula": "F[0,2] x >= 5", "weight": 2},
            {"formula": "G[0,4] x <= 4", "weight": 1},
        ],
        language="stl",
    )
    found = tsplan.synthesise(mission)
    assert found.status is Status.OPTIMAL
    assert found.objective[0] == tsplan.plans.outcomes.ObjectiveValue("preferences", 2.0, 2.0)


def test_a_run_tells_of_what_it_finds_and_stops_when_asked():
    heard = []

    def listen(event):
        heard.append(event)
        return isinstance(event, Incumbent)

    hard = tsplan.SignalMission.of(
        system=PLANE, start=START, formula=reach_avoid(14), objective=["control_effort"]
    )
    found = synthesise_mission(hard, on_event=listen)
    assert (found.status, found.stopped_by) == (Status.FEASIBLE, StoppedBy.INTERRUPT)
    (first, *_) = [event for event in heard if isinstance(event, Incumbent)]
    assert first.plan().verified
    heard.clear()
    synthesise_mission(hard, on_event=lambda event: heard.append(event) or False)
    bounds = [event for event in heard if isinstance(event, Bound) and event.bound is not None]
    assert all(bound.bound <= 10 for bound in bounds)


def test_no_time_is_no_plan():
    found = synthesise_mission(
        tsplan.SignalMission.of(system=PLANE, start=START, formula=reach_avoid()), time_limit=1e-6
    )
    assert (found.status, found.stopped_by) == (Status.NO_PLAN_FOUND, StoppedBy.TIME_LIMIT)


BLOCKS = seed_blocks(range(40_000, 40_010), range(40_000, 42_000), 20)


@pytest.mark.parametrize("language", ["stl", "wstl"])
@pytest.mark.parametrize("block", BLOCKS)
def test_the_tight_encoding_says_what_the_reference_says(language, block):
    for seed in block:
        mission = random_signal_mission(seed, language=language)
        tight, plain = (
            synthesise_mission(mission, encoding=name, threads=1) for name in ("tight", "reference")
        )
        if StoppedBy.PRECISION in (tight.stopped_by, plain.stopped_by):
            continue  # on a border, which a solver meets or misses
        assert tight.status == plain.status, seed
        for one, other in zip(tight.objective[:1], plain.objective[:1], strict=True):
            assert one.value == pytest.approx(other.value, rel=1e-4, abs=1e-4), seed


@pytest.mark.parametrize("switch", ["outlook", "sharing", "families", "blocks"])
@pytest.mark.parametrize("block", seed_blocks(range(42_000, 42_002), range(42_000, 42_012), 8))
def test_switching_methods_off_changes_no_answer(switch, block):
    for seed in block:
        mission = random_signal_mission(seed)
        every, fewer = (
            synthesise_mission(mission, without=without, threads=1) for without in ((), (switch,))
        )
        assert every.status == fewer.status, seed
        values = [[item.value for item in found.objective[:1]] for found in (every, fewer)]
        assert values[0] == pytest.approx(values[1], abs=1e-5), seed
    plane = tsplan.SignalMission.of(system=PLANE, start=START, formula=reach_avoid(16))
    whole, without = (synthesise_mission(plane, without=names) for names in ((), (switch,)))
    assert whole.robustness == pytest.approx(without.robustness, abs=1e-6)
