"""Control by planning: what is steered, what is claimed of it, and what the world may do."""

from __future__ import annotations

import random

import numpy as np
import pytest

import tsplan
from tests.seeds import long, sampled, seed_blocks
from tsplan.errors import InputError, MissionError, PlanError, SolverError
from tsplan.logic import parse
from tsplan.logic.evaluation import SignalTrace, holds, robustness
from tsplan.milp.highs import Highs
from tsplan.plans.outcomes import Status
from tsplan.protocol.disturbances import simulate_controlled, simulate_disturbed
from tsplan.run.problem import Tuning
from tsplan.signals import Region, System, double_integrator, free_signals
from tsplan.signals.least_violation import remaining
from tsplan.signals.synthesiser import synthesise_mission
from tsplan.signals.trajectory_check import check
from tsplan.stopping import StoppedBy
from tsplan.testing.random_signals import random_signal_mission

PLANE = double_integrator(("x", "y"), position=(0, 10), speed=1, push=0.5)
GOAL, WALL = Region(x=(7, 8), y=(8, 9)), Region(x=(3, 5), y=(4, 6))
START = {"x": 1.0, "y": 2.0, "vx": 0.0, "vy": 0.0}
LINE = double_integrator(("x",), position=(0, 10), speed=2, push=1)


def plane_mission(steps=12, **given):
    formula = GOAL.inside().eventually(0, steps) & WALL.outside().always(0, steps)
    given = {"objective": ["robustness"], "start": START, **given}
    return tsplan.SignalMission.of(system=PLANE, formula=formula, **given)


def line_mission(text="F[0,8] x >= 6", **given):
    given = {"objective": ["robustness"], "start": {"x": 1, "vx": 0}, **given}
    return tsplan.SignalMission.of(system=LINE, formula=parse(text, "stl"), **given)


def steered(controller, system, state, noise=0.0, seed=0, **options):
    """All steps of a run in which every signal is shaken."""
    rng, steps = np.random.default_rng(seed), []
    while not controller.done:
        steps.append(controller.step(state, **options))
        if not controller.done:
            led = system.led(state, steps[-1].control)
            state = {name: value + noise * rng.uniform(-1, 1) for name, value in led.items()}
    return steps


@pytest.mark.parametrize(
    "objective",
    [
        ["robustness"],
        long(["robustness", "control_effort"]),
        long({"robustness": 1, "control_effort": 0.1}),
        ["control_effort"],
        [],
    ],
)
def test_without_disturbances_the_optimum_of_the_open_loop_is_kept(objective):
    mission = plane_mission(10, objective=objective)
    planned = tsplan.synthesise(mission)
    controller = tsplan.Controller(mission)
    steps = steered(controller, PLANE, START)
    assert [step.number for step in steps] == list(range(11))
    assert all(step.holds and step.status is Status.OPTIMAL for step in steps)
    assert all(step.violation == 0 for step in steps)
    found = controller.trajectory
    assert found.verified
    assert check(mission, found).ok
    wanted = [item.value for item in planned.objective]
    assert [item.value for item in found.objective] == pytest.approx(wanted, abs=1e-5)


def test_the_past_is_what_was_measured_and_applied():
    controller = tsplan.Controller(plane_mission())
    first = controller.step(START)
    measured = {"x": 1.25, "y": 2.5, "vx": 0.25, "vy": 0.5}
    second = controller.step(measured, applied={"ux": 0.125, "uy": 0.375})
    later = PLANE.led(measured, second.control)
    controller.step(later)
    run = controller.trajectory
    assert run["x"][:3].tolist() == [1.0, 1.25, later["x"]]
    assert run["uy"][:2].tolist() == [0.375, second["uy"]]
    assert (first.number, second.number) == (0, 1)
    # the dynamics lead on from there
    for step in range(2, 12):
        state = {name: run[name][step] for name in PLANE.signals}
        led = PLANE.led(state, {name: run[name][step] for name in PLANE.controls})
        assert all(run[name][step + 1] == pytest.approx(value) for name, value in led.items())
    # what was claimed is what the evaluator says of the past and the plan
    assert run.robustness == robustness(plane_mission().formula, run.trace())[0]
    assert not run.verified
    assert check(plane_mission(), run).findings


def test_disturbances_are_answered():
    mission = plane_mission(14)
    steps = steered(tsplan.Controller(mission), PLANE, START, noise=0.05, seed=3)
    assert steps[-1].holds
    assert steps[-1].robustness > 0
    # nothing answers them in the open loop
    rng = np.random.default_rng(3)
    planned, state = tsplan.synthesise(mission), dict(START)
    for step in range(14):
        led = PLANE.led(state, {name: planned[name][step] for name in PLANE.controls})
        state = {name: value + 0.05 * rng.uniform(-1, 1) for name, value in led.items()}
    assert state != pytest.approx({name: planned[name][-1] for name in PLANE.signals}, abs=1e-3)


def test_no_time_leads_the_last_plan_on():
    mission = plane_mission()
    plan = tsplan.synthesise(mission)
    controller = tsplan.Controller(mission, plan=plan)
    steps = steered(controller, PLANE, START, deadline=0)
    for step in steps[:-1]:
        assert (step.status, step.stopped_by) == (Status.FEASIBLE, StoppedBy.TIME_LIMIT)
        assert not step.fresh
        assert step.control == {name: plan[name][step.number] for name in PLANE.controls}
    assert steps[-1].holds
    assert controller.trajectory.states.tolist() == plan.states.tolist()


def test_without_a_plan_and_time_the_controls_rest():
    low = System(LINE.signals, {"ux": (0.25, 1)}, LINE.dynamics)
    mission = tsplan.SignalMission.of(
        system=low, formula=parse("F[0,8] x >= 6", "stl"), start={"x": 1, "vx": 0}, objective=[]
    )
    step = tsplan.Controller(mission).step({"x": 1, "vx": 0}, deadline=0)
    assert step.control == {"ux": 0.25}
    assert (step.status, step.fresh) == (Status.FEASIBLE, False)  # as it happens
    rest = tsplan.Controller(line_mission()).step({"x": 1, "vx": 0}, deadline=0)
    assert rest.control == {"ux": 0.0}
    assert (rest.status, rest.holds) == (Status.NO_PLAN_FOUND, False)
    assert rest.violation == pytest.approx(5)


@pytest.mark.parametrize("error", [SolverError("it broke"), MemoryError()])
def test_a_solver_that_fails_leaves_the_last_plan(monkeypatch, error):
    mission = line_mission(objective=["control_effort"])
    controller = tsplan.Controller(mission, plan=tsplan.synthesise(mission))

    def broken(*_):
        raise error

    monkeypatch.setattr(Highs, "answer", broken)
    state = {"x": 1.0, "vx": 0.0}
    calm = controller.step(state)
    assert calm.holds
    # the last plan does not do after this, and nothing better is found
    thrown = controller.step({"x": 0.5, "vx": 0.0})
    assert thrown.control.keys() == {"ux"}
    assert (thrown.status, thrown.holds) == (Status.NO_PLAN_FOUND, False)
    assert thrown.notes


def test_what_cannot_be_kept_is_missed_by_little():
    mission = line_mission("F[0,4] x >= 6")
    controller = tsplan.Controller(mission)
    assert controller.step({"x": 1, "vx": 0}).status is Status.OPTIMAL
    step = controller.step({"x": 1, "vx": 0})  # it did not move
    # x comes to 1 + 0 + 1 + 2 at step 4
    assert (step.status, step.stopped_by, step.holds) == (Status.INFEASIBLE, None, False)
    assert step["ux"] == pytest.approx(1)
    assert step.violation == pytest.approx(2)
    assert step.robustness == pytest.approx(-2)
    assert not controller.trajectory.verified


def test_bounds_are_left_no_more_than_must_be():
    mission = line_mission("G[0,8] x <= 9", objective=["control_effort"])
    controller = tsplan.Controller(mission)
    controller.step({"x": 1, "vx": 0})
    step = controller.step({"x": 1, "vx": -3})
    assert step.status is Status.INFEASIBLE
    assert step["ux"] == pytest.approx(1)
    # x is -2, -4, -5, -5, -4, -2, 0 then if it turns as fast as it can
    assert step.violation == pytest.approx(22, rel=1e-5)
    # back within its bounds it is steered as before
    fine = controller.step({"x": 1, "vx": 0})
    assert fine.holds


def test_what_the_past_has_lost_does_not_hide_what_can_be_kept():
    mission = line_mission("G[0,8] x <= 4 && F[0,8] x >= 3", start={"x": 1, "vx": 0})
    controller = tsplan.Controller(mission)
    controller.step({"x": 1, "vx": 0})
    controller.step({"x": 6, "vx": 0})  # lost for good
    step = controller.step({"x": 6, "vx": 0})
    assert (step.status, step.robustness) == (Status.INFEASIBLE, -2)
    # but it is on its way back
    assert step["ux"] == pytest.approx(-1)
    assert controller.trajectory["x"][-1] <= 4 + 1e-6


@pytest.mark.parametrize("steps", sampled([8, 12], [8]))
def test_formulas_that_may_hold_in_part(steps):
    mission = plane_mission(steps, objective=["satisfaction", "robustness"])
    assert mission.satisfaction is not None
    steps = steered(tsplan.Controller(mission), PLANE, START, noise=0.02)
    assert all(step.holds for step in steps)


def test_weights_count_in_what_is_told():
    mission = tsplan.SignalMission.of(
        system=LINE,
        formula="&&^w (F[0,6] x >= 6, G[0,6] x <= 9)",
        language="wstl",
        weights={"w": [0.5, 0.25]},
        start={"x": 1, "vx": 0},
        objective=["robustness"],
    )
    controller = tsplan.Controller(mission)
    steps = steered(controller, LINE, {"x": 1.0, "vx": 0.0})
    assert steps[-1].robustness == pytest.approx(tsplan.synthesise(mission).robustness, abs=1e-6)


def test_own_constraints_are_kept_from_now_on():
    problem = tsplan.Synthesis(line_mission())
    problem.add(problem.value("ux", 0) + problem.value("ux", 1) <= 0.5, "gently")
    controller = tsplan.Controller(problem)
    steps = steered(controller, LINE, {"x": 1.0, "vx": 0.0})
    assert steps[0]["ux"] + steps[1]["ux"] <= 0.5 + 1e-6
    again = tsplan.Controller(problem)
    again.step({"x": 1, "vx": 0})
    pushed = again.step({"x": 1, "vx": 0}, applied={"ux": 1})
    assert pushed["ux"] <= -0.5 + 1e-6


def test_misuse_is_told_and_changes_nothing():
    controller = tsplan.Controller(line_mission("F[0,1] x >= 0"))
    with pytest.raises(InputError, match="step\\(measured\\) first"):
        _ = controller.trajectory
    with pytest.raises(InputError) as caught:
        controller.step({"x": float("nan"), "y": 1}, applied={"ux": 0})
    assert [finding.message for finding in caught.value.findings] == [
        "signal vx has no value",
        "signal x is nan, which is no finite number",
        "the system has no signal 'y'",
        "nothing was applied before the first step",
    ]
    for deadline in (-1, float("nan"), "soon"):
        with pytest.raises(InputError, match="deadline"):
            controller.step({"x": 1, "vx": 0}, deadline)
    assert controller.step({"x": np.float64(1), "vx": 0}).number == 0
    with pytest.raises(InputError, match="no signals by name"):
        controller.step([1, 0])
    assert controller.step({"x": 1, "vx": 0}).control == {}
    with pytest.raises(InputError, match="ended at step 1"):
        controller.step({"x": 1, "vx": 0})


def test_what_cannot_be_steered_is_refused():
    free = tsplan.SignalMission.of(system=free_signals(x=(0, 9)), formula=parse("x > 1", "stl"))
    with pytest.raises(MissionError, match="nothing steers"):
        tsplan.Controller(free)
    with pytest.raises(PlanError, match="ends at step 12 and the mission at step 8"):
        tsplan.Controller(line_mission(), plan=tsplan.synthesise(plane_mission()))
    with pytest.raises(SolverError, match="no solver 'cplox'"):
        tsplan.Controller(line_mission(), solver="cplox")


def test_what_is_left_of_a_formula_looks_at_later_steps_alone():
    rng, lost = random.Random(0), 0
    for seed in range(60):
        mission = random_signal_mission(seed)
        goal = tsplan.Synthesis(mission).setting().goal
        step = rng.randrange(mission.horizon + 1)
        left = remaining(goal, step)
        names = mission.system.names
        for _ in range(5):
            rows = np.array(
                [[rng.uniform(-5, 5) for _ in range(mission.horizon + 1)] for _ in names]
            )
            trace = dict(zip(names, rows, strict=True))
            whole, part = (_holds(node, trace) for node in (goal, left))
            assert part or not whole
            lost += part and not whole
    assert lost


def _holds(formula, values):
    return bool(holds(formula, SignalTrace(values))[0])


@pytest.mark.parametrize("seeds", seed_blocks(range(5), range(1000), 40))
def test_a_step_is_worth_as_much_as_planning_anew(seeds):
    """The past as equations, without a start: the same optimum, where the controls are random."""
    for seed in seeds:
        mission = random_signal_mission(seed, language=("stl", "wstl")[seed % 2])
        if mission.system.dynamics is None or not mission.system.controls:
            continue
        _compare(mission, random.Random(seed))


def _unkept(system, past):
    """Whether what was applied breaks a limit, which plans may not and the world may."""
    for state, control in past:
        values = {**state, **control}
        for limit in system.limits:
            parts = [(1.0, limit.terms, float), *((by, terms, abs) for by, terms in limit.absolute)]
            if not set(limit.names) <= values.keys():
                continue
            total = sum(by * size(sum(f * values[n] for n, f in t)) for by, t, size in parts)
            if total > limit.bound:
                return True
    return False


def _compare(mission, rng):
    system = mission.system
    state = {name: rng.uniform(*system.begins(name)) for name in system.signals}
    controller, past = tsplan.Controller(mission), []
    for now in range(mission.horizon):
        applied = {n: rng.uniform(*ends) for n, ends in system.controls.items()} if now else None
        if applied:
            state = system.led(past[-1][0], applied)
            past[-1] = past[-1][0], applied
        if _unkept(system, [*past, (state, {})]):
            return
        if any(not low <= state[n] <= high for n, (low, high) in system.signals.items()):
            return
        past.append((state, {}))
        step = controller.step(state, applied=applied)
        problem = tsplan.Synthesis(mission)
        for at, (signals, controls) in enumerate(past):
            for name, value in {**signals, **controls}.items():
                problem.add(problem.value(name, at) == value)
        anew = synthesise_mission(problem)
        close = (step.robustness or 0) < 1e-5 and step.status is not Status.OPTIMAL
        assert step.holds == anew.has_signals or close, (mission.text, past)
        if step.holds and anew.has_signals and mission.objective:
            assert step.status == anew.status
            mine = controller.trajectory.objective[0].value
            assert mine == pytest.approx(anew.objective[0].value, abs=1e-5)


@pytest.mark.parametrize("seeds", seed_blocks(range(2), range(600), 30))
def test_disturbed_steps_are_judged_alike_by_both_encodings(seeds):
    for seed in seeds:
        mission = random_signal_mission(seed, language=("stl", "wstl")[seed % 2])
        system, rng = mission.system, np.random.default_rng(seed)
        if system.dynamics is None or not system.controls:
            continue
        state = {name: rng.uniform(*system.begins(name)) for name in system.signals}
        controllers = [
            tsplan.Controller(tsplan.Synthesis(mission, Tuning.named(encoding)))
            for encoding in ("tight", "reference")
        ]
        applied = None
        while not controllers[0].done:
            one, other = (controller.step(state, applied=applied) for controller in controllers)
            applied = one.control  # another may be as good, but the past is to be the same
            assert one.holds == other.holds
            assert one.violation <= other.violation + 1e-4
            found, plain = (controller.trajectory for controller in controllers)
            if one.holds and mission.objective:
                assert found.objective[0].value == pytest.approx(plain.objective[0].value, abs=1e-4)
            if not one.control:
                break
            led = system.led(state, one.control)
            state = {name: value + rng.uniform(-0.3, 0.3) for name, value in led.items()}


@pytest.mark.long
def test_a_controller_keeps_what_is_shaken_on_its_way():
    mission = plane_mission(14)
    plan = tsplan.synthesise(mission)
    blind = simulate_disturbed(mission, plan, amplitude=0.1, runs=8, seed=2)
    led = simulate_controlled(mission, plan, amplitude=0.1, runs=8, seed=2)
    assert led.formula.rate > blind.formula.rate
    assert led.mean > blind.mean
    # without disturbances there is nothing between them
    calm = simulate_controlled(mission, plan, amplitude=0.0, runs=1)
    assert calm.formula.rate == 1
    assert calm.mean == pytest.approx(plan.robustness, abs=1e-6)


def test_what_is_missed_is_the_least_of_all_choices():
    """Of F over predicates that face each other, the step at which least is missed is found."""
    system = System(LINE.signals, LINE.controls, LINE.dynamics)
    formula = parse("F[2,5] (x <= 1 && x >= 2)", "stl")
    mission = tsplan.SignalMission.of(system=system, formula=formula, start={"x": 6, "vx": 0})
    step = tsplan.Controller(mission).step({"x": 6, "vx": 0})
    assert (step.status, step.robustness) == (Status.INFEASIBLE, pytest.approx(-0.5, abs=1e-6))
