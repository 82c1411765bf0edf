"""Missions whose formulas have weights: read, written, refused, changed."""

import pickle

import numpy as np
import pytest

import tsplan
from tsplan.errors import MissionError
from tsplan.explanation.whynot.formula_places import Sources
from tsplan.explanation.whynot.mission_numbers import Number
from tsplan.explanation.whynot.occurrences import Occurrence
from tsplan.logic import parse
from tsplan.mission import Mission, Preference, mission_from_text

TEXT = """format: tsplan-mission/1
map:
  states: {p: {labels: [A]}, q: {labels: [B]}, r: {labels: [C]}}
  edges: [[p, q, 1], [q, r, 1], [p, p, 1], [q, q, 1], [r, r, 1]]
team: [{class: a, count: 2, at: p}]
spec:
  language: wmtl
  formula: "F[0,3] sum(B) >= 2 &&^w F[0,1]^late C"
  weights: {w: [1, 3], late: {0: 1, 1: 2}}
objective: [{satisfaction: weighted}]
"""
FORMULA = parse("&&^[1, 3] (F[0,3] sum(B) >= 2, F[0,1]^[1, 2] C)", "wmtl")
SHARED = """spec:
  language: wmtl
  must: F[0,3] B
  prefer:
    - {formula: "A &&^w F[0,1]^2 B", partial: true}
    - {formula: "C ||^w A", partial: true, name: other}
  weights: {w: [1, 3]}
"""


def changed(old, new):
    assert old in TEXT
    return TEXT.replace(old, new)


def made(formula, **weights):
    read = mission_from_text(TEXT)
    return Mission.of(
        map=read.system,
        team=read.team,
        formula=formula,
        language="wmtl",
        weights=weights or None,
        objective=[{"satisfaction": "weighted"}],
    )


def test_weights_stand_in_the_file():
    mission = mission_from_text(TEXT)
    assert mission.formula is FORMULA
    assert mission.warnings == ()
    assert pickle.loads(pickle.dumps(mission)) == mission
    written = mission.to_yaml()
    assert 'formula: "F[0,3] sum(B) >= 2 &&^w F[0,1]^late C"' in written
    assert 'weights: {late: {"0": 1, "1": 2}, w: [1, 3]}' in written
    assert mission_from_text(written) == mission


def test_formulas_share_weights():
    text = TEXT[: TEXT.index("spec:")] + SHARED
    mission = mission_from_text(text)
    assert [soft.formula for soft in mission.prefer] == [
        parse("&&^[1, 3] (A, F[0,1]^2 B)", "wmtl"),
        parse("||^[1, 3] (C, A)", "wmtl"),
    ]
    assert mission_from_text(mission.to_yaml()) == mission


@pytest.mark.parametrize(
    ("old", "new", "place", "message", "remedy"),
    [
        ("{satisfaction: weighted}", "availability", "8:43", "weights have no effect", "satisf"),
        ("w: [1, 3]", "w: [1, 3, 4]", "8:34", "3 weights are given for parts 0 to 1", "part"),
        ("w: [1, 3]", "w: [1, 0]", "9:16", "'0' is no weight", "above 0"),
        ("w: [1, 3]", "w: .inf", "9:16", "no weight", "above 0"),
        ("w: [1, 3]", "ww: [1, 3]", "8:34", "no weights 'w' are given", "did you mean 'ww'"),
        ("{0: 1, 1: 2}", "{0: 1}", "8:43", "no weight is given for step 1", "from 0 to 1"),
        ("{0: 1, 1: 2}", "{x: 1}", "9:30", "'x' is no step or part", "{3: 0.5"),
        ("wmtl", "mtl", "8:34", "'^' begins a weight", "the language wmtl"),
        ("wmtl", "wstl", "7:13", "language: 'wstl' should be", "'wmtl'"),
    ],
)
def test_what_does_not_fit_is_told_at_its_place(old, new, place, message, remedy):
    with pytest.raises(MissionError) as caught:
        mission_from_text(changed(old, new))
    found = caught.value.findings[0]
    assert f"{found.line}:{found.column}" == place
    assert message in found.message
    assert remedy in found.remedy


def test_wrong_weights_do_not_hide_what_else_is_wrong():
    text = changed("[1, 3]", "-1").replace("late C", "late D")
    with pytest.raises(MissionError) as caught:
        mission_from_text(text)
    assert [(f.line, f.column) for f in caught.value.findings] == [(8, 49), (9, 16)]


def test_weights_that_nothing_names_are_a_warning():
    mission = mission_from_text(changed("w: [1, 3]", "w: [1, 3], v: 3"))
    (told,) = mission.warnings
    assert (told.line, told.column) == (9, 27)
    assert "the weights 'v'" in told.message
    assert "v: 3" not in mission.to_yaml()


def test_preferences_have_weights_only_in_part():
    text = TEXT[: TEXT.index("spec:")] + SHARED.replace("partial: true, name", "name")
    with pytest.raises(MissionError, match="weights have no effect") as caught:
        mission_from_text(text)
    (found,) = caught.value.findings
    assert "partial: true" in found.remedy


def test_weights_from_python_may_be_of_any_kind():
    text = "A &&^w (F[0,2]^f B &&^n C)"
    mission = made(text, w=np.array([1, 0.5]), f=lambda step: 1 / (step + 1), n=(2, np.float32(3)))
    inner = "&&^[2, 3] (F[0,2]^[1, 0.5, 0.3333333333333333] B, C)"
    assert mission.formula is parse(f"&&^[1, 0.5] (A, {inner})", "wmtl")
    assert pickle.loads(pickle.dumps(mission)) == mission
    assert mission.text == text
    again = mission_from_text(mission.to_yaml())
    assert (again.formula, again.text) == (mission.formula, text)
    soft = Preference(mission.formula, text, partial=True)
    wished = Mission.of(
        map=mission.system,
        team=mission.team,
        must="A",
        prefer=[soft],
        language="wmtl",
        weights=mission.weights,
    )
    assert wished.prefer[0].formula is mission.formula
    assert wished.prefer[0].text == text


def test_a_formula_of_python_keeps_its_weights():
    mission = made(FORMULA)
    assert mission.formula is FORMULA
    assert mission_from_text(mission.to_yaml()).formula is FORMULA
    with pytest.raises(MissionError, match="no weights 'w' are given"):
        made("A &&^w B")
    with pytest.raises(MissionError, match="the weight of step 0 is -1"):
        made("F[0,2]^w B", w=lambda step: step - 1)


def test_explanations_find_what_is_written_with_weights():
    sources = Sources(mission_from_text(TEXT))
    assert sources.text(Occurrence((1,))) == "F[0,1]^late C"
    assert sources.place(Occurrence((1, 0))).column == 49


@pytest.mark.parametrize(("far", "status"), [("late C", "explained"), ("late A", "feasible")])
def test_a_weighted_mission_is_planned_and_explained(far, status):
    mission = mission_from_text(changed("late C", far))
    plan = tsplan.plan(mission)
    assert plan.status == "optimal"
    assert "F[0,1]^[1, 2]" in str(plan.explain(mission))
    found = tsplan.explain(mission)
    assert found.status == status


def test_the_ends_of_a_weighted_window_move():
    mission = made("A &&^2 F[1,2]^[3, 4] B")
    for end, value, window in (
        ("high", 4, "F[1,4]^[3, 4, 4, 4]"),
        ("high", 1, "F[1,1]^3"),
        ("low", 0, "F[0,2]^[3, 3, 4]"),
    ):
        moved = Number("formula", ((1,), end)).put(mission, value)
        assert moved.formula is parse(f"A &&^2 {window} B", "wmtl")
