"""Trajectories as data and as JSON files."""

from __future__ import annotations

import json
import pickle
import random
import re
from contextlib import suppress
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import tsplan
from tests.missions import findings
from tests.seeds import quick
from tsplan.errors import InputError, PlanError
from tsplan.plans.outcomes import MissionRef, ObjectiveValue, SolverUse, Status, Timings
from tsplan.signals.trajectory import PartValue, Trajectory
from tsplan.stopping import StoppedBy

REF = MissionRef("cart", "0" * 64)
SIGNALS = {"x": (0.0, 1.5, 2.0), "v": (1.5, 0.5, -0.25)}
CONTROLS = {"u": (-1.0, -0.75)}
FULL = Trajectory(
    Status.FEASIBLE,
    REF,
    2,
    stopped_by=StoppedBy.GAP,
    objective=(ObjectiveValue("J", 0.25, 0.5), ObjectiveValue("robustness", 0.5)),
    robustness=0.5,
    agm=0.125,
    fraction=0.0,
    preference=1.0,
    verified=True,
    signals=SIGNALS,
    controls=CONTROLS,
    parts=(PartValue("F[0,2] x >= 1.5", 0.5, 1.0), PartValue("true", None, 1.0)),
    solver=SolverUse("highs", "1", {"seed": 1}),
    timings=Timings(solve=0.25),
    notes=("a note",),
)


@pytest.mark.parametrize(
    ("status", "stopped_by", "signals", "verified"),
    [
        ("optimal", "gap", SIGNALS, False),
        ("optimal", None, {}, False),
        ("feasible", None, SIGNALS, False),
        ("feasible", "time_limit", {}, False),
        ("infeasible", "time_limit", {}, False),
        ("infeasible", None, SIGNALS, False),
        ("no_plan_found", "memory", SIGNALS, False),
        ("no_plan_found", "time_limit", {}, True),
    ],
)
def test_impossible_outcomes_cannot_be_made(status, stopped_by, signals, verified):
    with pytest.raises(PlanError, match=f"status {status}"):
        Trajectory(status, REF, 2, stopped_by=stopped_by, signals=signals, verified=verified)


def test_everything_wrong_with_the_values_is_told_at_once():
    wrong = {"signals": {"x": (0.0, 1.0), "u": (0.0, float("nan"), 1.0)}, "controls": CONTROLS}
    told = findings(lambda: Trajectory("optimal", REF, 2, **wrong))
    assert told == [
        "signal x has 2 values and not 3; the horizon is 2",
        "signal u is no finite number at step 1",
        "'u' is both a signal and a control",
    ]


def test_json_is_the_documented_document():
    data = json.loads(FULL.to_json())
    assert list(data) == [
        *("format", "status", "stopped_by", "mission", "horizon", "objective", "robustness"),
        *("agm", "fraction", "preference", "verified", "signals", "controls", "parts", "solver"),
        *("size", "timings", "notes"),
    ]
    assert data["format"] == "tsplan-trajectory/1"
    assert data["objective"][0] == {"name": "J", "value": 0.25, "bound": 0.5}
    assert data["fraction"] == 0
    assert data["signals"] == {"x": [0, 1.5, 2], "v": [1.5, 0.5, -0.25]}
    assert data["controls"] == {"u": [-1, -0.75]}
    assert data["parts"][0] == {"text": "F[0,2] x >= 1.5", "robustness": 0.5, "fraction": 1}
    assert Trajectory.from_json(FULL.to_json()) == FULL
    assert pickle.loads(pickle.dumps(FULL)) == FULL


def test_what_there_is_not_is_left_out():
    bare = replace(FULL, fraction=None, preference=None, parts=(), notes=(), controls={})
    assert not {"fraction", "preference", "parts", "notes"} & json.loads(bare.to_json()).keys()
    assert Trajectory.from_json(bare.to_json()) == bare
    none = Trajectory(Status.INFEASIBLE, REF, 2)
    assert json.loads(none.to_json())["signals"] == {}
    assert Trajectory.from_json(none.to_json()) == none


numbers = st.floats(allow_nan=False, allow_infinity=False)


@quick
@given(st.dictionaries(st.text(min_size=1), st.tuples(numbers, numbers), min_size=1), numbers)
def test_every_value_comes_back_as_it_was(signals, value):
    made = Trajectory("optimal", REF, 1, signals=signals, robustness=value)
    read = Trajectory.from_json(made.to_json())
    assert read == made
    assert [row.tobytes() for row in (read.states + 0.0)] == [
        row.tobytes() for row in (made.states + 0.0)
    ]


def test_signals_and_controls_are_found_by_name():
    assert FULL["x"].tolist() == [0, 1.5, 2]
    assert FULL["u"].tolist() == [-1, -0.75]
    assert FULL.states.shape == (2, 3)
    assert FULL.trace().signal("u").tolist() == [-1, -0.75, -0.75]
    given = Trajectory("optimal", REF, 1, signals={"x": np.array([1, 2])})
    assert given.signals == {"x": (1.0, 2.0)}
    with pytest.raises(InputError, match="no signal 'xx'; did you mean 'x'"):
        FULL["xx"]


def test_files_of_trajectories_are_read_back(tmp_path):
    place = tmp_path / "found.json"
    tsplan.save_trajectory(FULL, place)
    assert tsplan.load_trajectory(place) == FULL
    with pytest.raises(PlanError, match="its format is 'tsplan-trajectory/1'"):
        tsplan.load_plan(place)
    with pytest.raises(PlanError, match="cannot read the trajectory: there is no such file"):
        tsplan.load_trajectory(tmp_path / "none.json")
    place.write_text("format: tsplan-mission/1\n")
    with pytest.raises(PlanError, match="this is no trajectory: it is a mission"):
        tsplan.load_trajectory(place)


def test_everything_wrong_with_a_file_is_told_with_its_place():
    data = json.loads(FULL.to_json())
    data["signals"]["x"][1] = "1.5"
    data["controls"]["u"] = [True, 2]
    data["horizon"] = -1
    data["speed"] = 3
    told = findings(Trajectory.from_json, json.dumps(data, indent=1), "found.json")
    placed = [re.fullmatch(r"found\.json:\d+:\d+: (\S+): .*", line) for line in told]
    assert {match[1] for match in placed} == {"signals.x[1]", "controls.u[0]", "horizon", "speed"}


def places(data):
    """Every container of a document with each of its keys."""
    keys = data if isinstance(data, dict) else range(len(data)) if isinstance(data, list) else ()
    for key in keys:
        yield data, key
        yield from places(data[key])


def test_forged_files_are_read_or_refused():
    draw = random.Random(7)
    values = [None, True, -1, 1e300, "x", [], {}, [1], {"x": [0, 1, 2]}, 2, 10**400]
    read = 0
    for _ in range(400):
        data = json.loads(FULL.to_json())
        container, key = draw.choice(list(places(data)))
        container[key] = draw.choice(values)
        with suppress(PlanError):
            again = Trajectory.from_json(json.dumps(data))
            assert Trajectory.from_json(again.to_json()) == again
            read += 1
    assert 20 < read < 380
