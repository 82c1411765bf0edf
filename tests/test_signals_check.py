"""The independent check of trajectories: what it measures, accepts and refuses."""

from __future__ import annotations

import json
import random
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.carts import (
    ARRIVAL,
    CART,
    CLEARANCE,
    CONTROLS,
    REF,
    SUM,
    cart_mission,
    cart_run,
)
from tests.seeds import quick
from tsplan.errors import PlanError, SolverError
from tsplan.logic import linear
from tsplan.mission import Preference
from tsplan.plans.outcomes import ObjectiveValue, Status
from tsplan.signals.aims import Aim
from tsplan.signals.linear_system import Dynamics, System
from tsplan.signals.signal_mission import SignalMission
from tsplan.signals.trajectory import Trajectory
from tsplan.signals.trajectory_check import certify, check
from tsplan.stopping import StoppedBy

MISSION = cart_mission()
ROBUST = ObjectiveValue("robustness", 0.5, 0.5)


def refused(mission, found):
    """What is wrong with a trajectory, in words; both judges refuse it."""
    report = check(mission, found)
    assert not report.ok
    assert not report.facts
    return [finding.message for finding in report.findings]


def test_everything_in_a_trajectory_is_measured():
    given = cart_run(ROBUST)
    found = certify(MISSION, given)
    assert found.verified
    assert found.status is Status.OPTIMAL
    assert found.notes == ()
    assert found.signals["x"] == (1, 1, 1.5, 2.25, 3, 3.5)
    assert found.signals["y"] == (2, 2, 2, 2.25, 2.5, 2.5)
    assert found.controls == {name: tuple(map(float, row)) for name, row in CONTROLS.items()}
    assert found.robustness == 0.5
    assert found.objective == (ROBUST,)
    assert [(part.text, part.robustness, part.fraction) for part in found.parts] == [
        (str(ARRIVAL), 0.5, 1),
        (str(CLEARANCE), 0.75, 1),
    ]
    report = check(MISSION, Trajectory.from_json(found.to_json()))
    assert report.ok
    assert report.values == {"robustness": 0.5}
    assert report.facts[-1] == "robustness is 0.5"


def test_a_weighted_sum_is_told_with_its_terms():
    mission = cart_mission(objective=(SUM, Aim((("control_effort", 1.0),))))
    found = certify(mission, cart_run(ObjectiveValue("J", -0.1, 1.0)))
    effort = 12.25 + 13.25 + 2.5 + 0.5
    moved = sum(abs(row).sum() for row in found.states)
    assert moved == pytest.approx(effort)
    assert [(item.name, item.bound) for item in found.objective] == [
        *(("J", 1.0), ("robustness", None), ("state_effort", None), ("control_effort", None)),
        ("control_effort", None),
    ]
    assert [item.value for item in found.objective] == pytest.approx(
        [0.5 - 0.01 * effort - 0.1 * 2, 0.5, effort, 2, 2]
    )
    assert (found.status, found.stopped_by) == (Status.FEASIBLE, StoppedBy.PRECISION)
    assert check(mission, found).ok


def test_efforts_may_be_of_some_signals_alone():
    aim = Aim(
        (("state_effort", 1.0), ("control_effort", 2.0)),
        {"state_effort": {"x": 1, "vy": 4}, "control_effort": {"uy": 1.0}},
    )
    found = certify(cart_mission(objective=(aim,)), cart_run())
    assert [item.value for item in found.objective] == [-(12.25 + 4 * 0.5 + 2 * 0.5), 14.25, 0.5]


def test_controls_beyond_their_bounds_are_brought_back_before_the_simulation():
    far = {**CONTROLS, "ux": (0.5 + 1e-7, *CONTROLS["ux"][1:])}
    assert certify(MISSION, cart_run(ROBUST, controls=far)).signals["vx"][1] == 0.5
    there = certify(MISSION, cart_run(ROBUST))
    words = refused(MISSION, replace(there, controls={**CONTROLS, "ux": (0.6,) * 5}))
    assert "at step 1 signal vx is 0.5, and the dynamics lead to 0.6 (and at 4 more steps)" in words
    assert "at step 0 control ux is 0.6, above its bound 0.5 (and at 4 more steps)" in words


def test_free_signals_are_brought_into_their_bounds():
    system = System({"x": (0, 5), "y": (0, 5)}, initial={"y": (1, 1)})
    mission = SignalMission(system, linear({"x": 1, "y": 1}, ">=", 6).eventually(0, 1), 1)
    given = Trajectory("optimal", REF, 1, signals={"y": (1 - 1e-7, 1.5), "x": (-1e-8, 5 + 1e-7)})
    found = certify(mission, given)
    assert list(found.signals.items()) == [("x", (0, 5)), ("y", (1, 1.5))]
    assert (found.robustness, found.status) == (0.5, Status.OPTIMAL)
    assert check(mission, found).ok


def test_a_trajectory_that_falls_short_of_its_claims_is_called_optimal_no_longer():
    found = certify(MISSION, cart_run(ObjectiveValue("robustness", 0.75, 0.75)))
    assert (found.status, found.stopped_by) == (Status.FEASIBLE, StoppedBy.PRECISION)
    assert found.objective == (ObjectiveValue("robustness", 0.5, 0.75),)
    assert found.notes == ("the search claimed robustness 0.75, and the trajectory has 0.5",)
    assert check(MISSION, found).ok


def test_a_bound_that_the_trajectory_refutes_is_left_out():
    found = certify(MISSION, cart_run(ObjectiveValue("robustness", 0.25, 0.25)))
    assert (found.status, found.stopped_by) == (Status.FEASIBLE, StoppedBy.PRECISION)
    assert found.objective == (ObjectiveValue("robustness", 0.5, None),)
    (note,) = found.notes
    assert note == "the trajectory has robustness 0.5, better than the bound 0.25 of the search"


def test_a_search_that_was_ended_keeps_its_reason_and_its_bound():
    given = cart_run(
        ObjectiveValue("robustness", None, 1.5), status="feasible", stopped_by="time_limit"
    )
    found = certify(MISSION, given)
    assert found.stopped_by is StoppedBy.TIME_LIMIT
    assert found.objective == (ObjectiveValue("robustness", 0.5, 1.5),)
    assert certify(MISSION, Trajectory("infeasible", REF, 5)).verified is False


def test_what_a_system_does_not_allow_is_told_with_step_and_bound():
    system = replace(
        CART,
        signals={**CART.signals, "x": (0, 3), "vy": (-0.125, 0.125)},
        initial={**CART.initial, "y": (2.5, 3)},
        limits=(replace(CART.limits[0], bound=0.375),),
    )
    found = certify(MISSION, cart_run())
    words = refused(cart_mission(system=system), found)
    limit = "|ux| + |uy| <= 0.375"
    assert words[:4] == [
        "at step 5 signal x is 3.5, above its bound 3",
        "at step 0 signal y is 2, below its start 2.5",
        "at step 2 signal vy is 0.25, above its bound 0.125 (and at 1 more step)",
        f"at step 0 the left side of {limit} is 0.5 (and at 3 more steps)",
    ]
    with pytest.raises(SolverError, match=r"at step 5 signal x is 3\.5, above its bound 3"):
        certify(cart_mission(system=system), cart_run())


def test_formulas_that_do_not_hold_are_told_by_their_parts():
    late = ARRIVAL & linear({"x": 1}, "<", 3.5).always(0, 5)
    mission = cart_mission(late, ARRIVAL)
    assert refused(mission, certify(MISSION, cart_run(ROBUST)))[:2] == [
        "the formula does not hold (its robustness is 0, and a comparison is strict)",
        f"the part {late} does not hold (its robustness is 0, and a comparison is strict)",
    ]
    far = linear({"x": 1}, ">=", 4).eventually(0, 5)
    with pytest.raises(SolverError, match=r"its robustness is -0\.5.*\n.*x >= 4\) does not hold"):
        certify(cart_mission(ARRIVAL, far), cart_run())


def test_what_need_not_hold_as_a_whole_is_measured_in_part():
    near = linear({"x": 1}, "<=", 3).always(0, 5)
    mission = cart_mission(
        ARRIVAL,
        near,
        satisfaction="weighted",
        objective=(Aim((("satisfaction", 1.0),)), Aim((("robustness", 1.0),))),
    )
    found = certify(mission, cart_run(ObjectiveValue("satisfaction", None, 1.0)))
    assert found.fraction == pytest.approx(1 / 2 + 5 / 12)
    assert found.robustness == -0.5
    assert [part.fraction for part in found.parts] == pytest.approx([1, 5 / 6])
    assert [item.value for item in found.objective] == pytest.approx([11 / 12, 0])
    assert check(mission, found).ok
    assert "in part" in check(mission, found).facts[3]


def test_preferred_formulas_are_parts_and_worth_their_weight():
    near, far = linear({"x": 1}, "<=", 3).always(0, 5), linear({"y": 1}, ">=", 2).always(0, 5)
    wishes = (Preference(near, "near", 3, partial=True), Preference(far, "far", 2))
    aims = (Aim((("preferences", 1.0),)), Aim((("robustness", 1.0),)))
    found = certify(cart_mission(prefer=wishes, objective=aims), cart_run())
    assert [part.text for part in found.parts][2:] == ["near", "far"]
    assert [item.value for item in found.objective] == pytest.approx([3 * 5 / 6 + 2, 0])


def test_other_signals_and_horizons_are_refused():
    found = certify(MISSION, cart_run(ROBUST))
    a = (*((*row, 0) for row in CART.dynamics.a), (0, 0, 0, 0, 1))
    moved = Dynamics(a, (*CART.dynamics.b, (0, 0)), (0,) * 5)
    other = replace(CART, signals={**CART.signals, "z": (0, 1)}, dynamics=moved)
    assert refused(cart_mission(system=other, horizon=6), found) == [
        "the trajectory ends at step 5 and the mission at step 6",
        "signal z has no values",
    ]
    more = {**CONTROLS, "uz": CONTROLS["ux"]}
    assert refused(MISSION, replace(found, controls=more)) == ["the system has no control uz"]
    assert refused(MISSION, Trajectory("infeasible", REF, 5)) == [
        "a trajectory of status infeasible has no signals to check"
    ]


def test_unstable_systems_are_refused_where_the_simulation_leads_away():
    wild = System({"x": (-1, 1)}, {}, Dynamics(((3.0,),), ((),), (0.0,)), {"x": (-1, 1)})
    mission = SignalMission(wild, linear({"x": 1}, ">=", -1).eventually(0, 40), 40)
    stays = Trajectory("optimal", REF, 40, signals={"x": (1e-9,) * 41})
    assert (
        "at step 7 signal x is 1e-09, and the dynamics lead to 2.187e-06 (and at 33"
        in (refused(mission, stays)[0])
    )
    with pytest.raises(SolverError) as caught:
        certify(mission, stays)
    assert "at step 19 signal x is 1.162261467, above its bound 1 (and at 21" in str(caught.value)
    assert "at step 7 signal x is 2.187e-06, where the search had 1e-09" in str(caught.value)
    endless = replace(mission, horizon=900)
    longer = Trajectory("optimal", REF, 900, signals={"x": (0.5,) * 901})
    assert "signal x is no finite number at step 647" in refused(endless, longer)[1]
    with pytest.raises(PlanError, match="no finite number"):
        certify(endless, longer)


def claims(data):
    """Every number of a trajectory file that the check can know better, with a value far off."""
    for kind in ("signals", "controls"):
        for name, row in data[kind].items():
            yield from (((kind, name), step, row[step] + 0.01) for step in range(len(row)))
    for place, item in enumerate(data["objective"]):
        yield ("objective", place), "value", item["value"] + 0.01
    for place, part in enumerate(data["parts"]):
        yield ("parts", place), "robustness", part["robustness"] + 0.01
        yield ("parts", place), "fraction", part["fraction"] - 0.01
        yield ("parts", place), "text", "other"
    yield (), "robustness", data["robustness"] + 0.01
    yield (), "horizon", 4
    yield ("objective", 0), "bound", None
    yield ("objective", 0), "bound", 0.0
    yield ("objective", 0), "bound", 10.0
    yield ("objective", 0), "name", "speed"


def test_every_wrong_number_of_a_file_is_found():
    sums = cart_mission(objective=(SUM,))
    first = certify(sums, cart_run(ObjectiveValue("J", None, 10.0)))
    true = first.objective[0]
    found = certify(sums, cart_run(replace(true, bound=true.value)))
    assert found.status is Status.OPTIMAL
    text = found.to_json()
    for path, key, value in claims(json.loads(text)):
        data = json.loads(text)
        place = data
        for step in path:
            place = place[step]
        place[key] = value
        try:
            forged = Trajectory.from_json(json.dumps(data))
        except PlanError:
            continue  # more or fewer values than the horizon asks for
        assert not check(sums, forged).ok, (path, key)


matrices = st.integers(0, 2**32 - 1)


@quick
@given(matrices)
def test_signals_are_what_powers_of_the_matrix_say(seed):
    draw = np.random.default_rng(seed)
    n, m, last = draw.integers(1, 4), draw.integers(0, 3), int(draw.integers(0, 6))
    a, b, d = draw.normal(size=(n, n)), draw.normal(size=(n, m)), draw.normal(size=n)
    u, start = draw.uniform(-1, 1, (m, last)), draw.uniform(-1, 1, n)
    whole = tuple(tuple(map(float, row)) for row in a), tuple(tuple(map(float, r)) for r in b)
    wide = {f"x{i}": (-1e4, 1e4) for i in range(n)}
    system = System(wide, {f"u{i}": (-1, 1) for i in range(m)}, Dynamics(*whole, tuple(d)))
    powers = [np.linalg.matrix_power(a, k) for k in range(last + 1)]
    rows = [
        powers[k] @ start + sum((powers[k - 1 - j] @ (b @ u[:, j] + d) for j in range(k)), 0)
        for k in range(last + 1)
    ]
    mission = SignalMission(system, linear({"x0": 1}, ">=", -1e4).always(0, last), last)
    given = Trajectory(
        "optimal",
        REF,
        last,
        signals=dict(zip(wide, np.array(rows).T, strict=True)),
        controls=dict(zip(system.controls, u, strict=True)),
    )
    found = certify(mission, given)
    assert np.allclose(found.states, np.array(rows).T, rtol=1e-9, atol=1e-9)
    assert found.robustness == pytest.approx(1e4 + min(row[0] for row in rows))
    assert check(mission, found).ok
    if last and m:
        name = random.Random(seed).choice(list(system.controls))
        far = {**found.controls, name: (-found.controls[name][0], *found.controls[name][1:])}
        moved = 2 * abs(found.controls[name][0]) * np.abs(b[:, int(name[1:])]).max()
        if moved > 0.03:  # a millionth of the range is 0.02
            assert not check(mission, replace(found, controls=far)).ok
