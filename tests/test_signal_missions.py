"""Missions over signals: read from files, built in Python, and every mistake at its place."""

from __future__ import annotations

import pickle

import numpy as np
import pytest

from tests.missions import findings
from tsplan import Mission, SignalMission, load_signal_mission
from tsplan.errors import MissionError
from tsplan.logic import linear, parse
from tsplan.mission import Preference
from tsplan.signals import (
    Dynamics,
    Region,
    System,
    double_integrator,
    free_signals,
    single_integrator,
)
from tsplan.signals.aims import Aim
from tsplan.signals.linear_system import Limit
from tsplan.signals.signal_files import load_any_mission, signal_mission_from_text

MISSION = """\
format: tsplan-signals/1
name: reach
signals:
  x: {min: 0, max: 9, initial: 0}
  v: [-1, 1]
controls: {u: [-0.5, 0.5]}
dynamics: {A: [[1, 1], [0, 1]], B: [[0], [1]]}
outputs: {gap: "x - v"}
limits: ["|u| + |v| <= 1.2"]
regions: {goal: {x: [7, 8]}}
spec:
  language: stl
  formula: "F[0,9] in(goal) && G[0,9] gap <= 9"
objective: {robustness: 1, control_effort: 0.1}
horizon: 10
"""
ROBUST = Aim((("robustness", 1.0),))
GOAL = Region(x=(7, 8))


def changed(*pairs: str, text: str = MISSION) -> str:
    """A text in which every second of some pieces stands in place of the one before it."""
    for old, new in zip(pairs[::2], pairs[1::2], strict=True):
        assert old in text, old
        text = text.replace(old, new, 1)
    return text


def wrong(*pairs: str) -> list[str]:
    """What is wrong with the mission in which something was changed."""
    return [
        line.removeprefix("mission:")
        for line in findings(signal_mission_from_text, changed(*pairs))
    ]


def only(*pairs: str, place: str, words: str) -> None:
    """The one finding has this place and these words."""
    found = wrong(*pairs)
    assert len(found) == 1, found
    assert found[0].startswith(f"{place}: "), found
    assert words in found[0], found


def test_a_file():
    mission = signal_mission_from_text(MISSION)
    system = mission.system
    assert (mission.name, mission.horizon, mission.language) == ("reach", 10, "stl")
    assert dict(system.signals) == {"x": (0, 9), "v": (-1, 1)}
    assert dict(system.controls) == {"u": (-0.5, 0.5)}
    assert dict(system.initial) == {"x": (0, 0)}
    assert system.dynamics == Dynamics(((1, 1), (0, 1)), ((0,), (1,)), (0, 0))
    assert dict(system.outputs) == {"gap": ((("v", -1.0), ("x", 1.0)), 0.0)}
    assert system.limits == (Limit((), ((1.0, (("u", 1.0),)), (1.0, (("v", 1.0),))), 1.2),)
    assert mission.objective == (Aim((("robustness", 1.0), ("control_effort", 0.1))),)
    assert mission.formula is parse("F[0,9] (x >= 7 && x <= 8) && G[0,9] x - v <= 9", "stl")
    assert mission.regions == {"goal": GOAL}
    assert mission.parts == (
        ("F[0,9] in(goal)", GOAL.inside().eventually(0, 9)),
        ("G[0,9] gap <= 9", linear({"x": 1, "v": -1}, "<=", 9).always(0, 9)),
    )
    assert mission.warnings == ()
    assert pickle.loads(pickle.dumps(mission)) == mission


def test_files_are_told_apart_by_their_format(tmp_path):
    path = tmp_path / "mission.yaml"
    path.write_text(MISSION)
    assert load_any_mission(path) == load_signal_mission(path)
    (tmp_path / "map.yaml").write_text("states: {p: {}}\nedges: [[p, p, 1]]\n")
    team = "format: tsplan-mission/1\nmap: map.yaml\nteam: [{class: a, at: p}]\nspec: G[0,3] p\n"
    path.write_text(team)
    assert isinstance(load_any_mission(path), Mission)
    with pytest.raises(MissionError, match="this is a mission; what is wanted has signals"):
        load_signal_mission(path)
    with pytest.raises(MissionError, match="there is no such file"):
        load_any_mission(tmp_path / "none.yaml")


@pytest.mark.parametrize(
    ("model", "axes", "a", "b"),
    [
        ("double-integrator", "x", ((1, 0.5), (0, 1)), ((0,), (0.5,))),
        ("single-integrator", "x, vx", ((1, 0), (0, 1)), ((0.5, 0), (0, 0.5))),
    ],
)
def test_models_by_name(model, axes, a, b):
    controls = "ux" if model.startswith("double") else "ux: [-1, 1], uvx"
    mission = signal_mission_from_text(
        "format: tsplan-signals/1\nsignals: {x: [0, 9], vx: [-1, 1]}\n"
        f"controls: {{{controls}: [-1, 1]}}\n"
        f"dynamics: {{model: {model}, axes: [{axes}], step: 0.5}}\nspec: F[0,3] x >= 5\n"
    )
    assert mission.system.dynamics == Dynamics(a, b, (0, 0))
    assert mission.horizon == 3


def test_models_in_python_are_those_of_files():
    robot = double_integrator(("x", "y"), position=(0, 10), speed=1, push=0.5)
    same = signal_mission_from_text(
        "format: tsplan-signals/1\n"
        "signals: {x: [0, 10], y: [0, 10], vx: {min: -1, max: 1, initial: 0}, vy: {min: -1, max: 1,"
        " initial: 0}}\ncontrols: {ux: [-0.5, 0.5], uy: [-0.5, 0.5]}\n"
        "dynamics: {model: double-integrator, axes: [x, y]}\nspec: F[0,3] x >= 5\n"
    ).system
    assert same == robot
    moved = robot.simulated([0, 1, 0, 0], np.array([[0.5, 0.0], [0.25, -0.5]]))
    assert moved[:, 2].tolist() == [0.5, 1.25, 0.5, -0.25]
    walker = single_integrator(("x",), position=(0, 5), speed=2, step=0.5)
    assert walker.simulated([1], np.array([[2.0]])).tolist() == [[1.0, 2.0]]
    assert free_signals(s=(0, 1)) == System({"s": (0, 1)})


SEVERAL = """\
format: tsplan-signals/1
signals: {x: [0, 9], y: [0, 9]}
controls: {ux: [-1, 1], uy: [-1, 1]}
dynamics: {model: single-integrator, axes: [x, y]}
outputs: {sum: x + y, apart: a_x - b_x}
limits: ["|ux| + |uy| <= 1", "|a_y - b_y| <= 5"]
regions: {goal: {x: [3, 4], y: [3, 4]}, meet: {a_x: [5, 6], b_x: [5, 6]}}
copies: {a: {initial: {x: 1, y: [0, 2]}}, b: }
spec: F[0,9] (in(a, goal) && out(b, goal)) && F[0,9] in(meet) && G[0,5] apart <= 4 && b_sum >= 1
objective: [control_effort: {ux: 2}]
"""


def test_several_robots():
    mission = signal_mission_from_text(SEVERAL)
    system = mission.system
    assert system.names == ("a_x", "a_y", "b_x", "b_y", "a_ux", "a_uy", "b_ux", "b_uy")
    assert dict(system.initial) == {"a_x": (1, 1), "a_y": (0, 2)}
    assert [str(limit) for limit in system.limits] == [
        "|a_ux| + |a_uy| <= 1",
        "|b_ux| + |b_uy| <= 1",
        "|a_y - b_y| <= 5",
    ]
    assert set(system.outputs) == {"a_sum", "b_sum", "apart"}
    assert mission.copies == ("a", "b")
    assert mission.regions["goal"] == Region(x=(3, 4), y=(3, 4))
    a, b = (Region(**{f"{n}_x": (3, 4), f"{n}_y": (3, 4)}) for n in "ab")
    assert mission.parts[0][1] is (a.inside() & b.outside()).eventually(0, 9)
    assert mission.parts[2:] == (
        ("G[0,5] apart <= 4", linear({"a_x": 1, "b_x": -1}, "<=", 4).always(0, 5)),
        ("b_sum >= 1", linear({"b_x": 1, "b_y": 1}, ">=", 1)),
    )
    assert mission.objective[0].efforts == {"control_effort": {"a_ux": 2.0, "b_ux": 2.0}}
    start = np.arange(4.0)
    step = system.simulated(start, np.array([[1.0], [0.5], [-1.0], [0.0]]))
    assert step[:, 1].tolist() == [1.0, 1.5, 1.0, 3.0]


@pytest.mark.parametrize(
    ("pairs", "place", "words"),
    [
        (("[0, 1]], B", "[0, 1, 2]], B"), "7:24", "row 2 of A has 3 numbers and there are 2"),
        (("[[0], [1]]", "[[0, 1], [1]]"), "7:37", "row 1 of B has 2 numbers and there is 1"),
        (("B: [[0], [1]]", "B: [[0]]"), "7:36", "B has 1 row and there are 2 signals (x, v)"),
        ((", B: [[0], [1]]", ""), "7:11", "'B' is missing and there are controls"),
        (("initial: 0", "initial: 12"), "4:32", "begins at 12, outside of its bounds 0 to 9"),
        (("initial: 0", "initial: [3, 2]"), "4:32", "the range 3 to 2 ends before it begins"),
        (("v: [-1, 1]", "v: [-1, 1, 2]"), "5:6", "a range has 2 numbers, not 3"),
        (("v: [-1, 1]", "v: [1, -1]"), "5:6", "write the smaller end first"),
        (("max: 9", "max: 1e21"), "4:20", "as good as infinite"),
        (("in(goal)", "in(gaol)"), "13:23", "no region 'gaol'; did you mean 'goal'?"),
        (("gap <= 9", "gop <= 9"), "13:39", "'gop'; did you mean 'gap'?"),
        (("gap <= 9", "x + (2*v - 3*w) <= 9"), "13:52", "signal or control 'w'"),
        (("gap <= 9", "x*v <= 9"), "13:41", "two signals are multiplied"),
        (("horizon: 10", "horizon: 3"), "15:10", "shorter than the formula's, 9; set it to at"),
        (("gap:", "x:", "gap", "x"), "8:14", "'x' is the name of a signal, too"),
        (("|u| + |v| <= 1.2", "|u| >= 1.2"), "9:11", "not convex; keep |...| on the small side"),
        (("|v| <= 1.2", "|w| <= 1.2"), "9:18", "there is no signal or control 'w'"),
        (("|u| + |v|", "|u + |v"), "9:16", "the end stands where"),
        (("|u| + |v|", "|u| + |v"), "9:17", "this bar is never closed"),
        (("|u| + |v|", "|u*v|"), "9:14", "two signals are multiplied"),
        (("|u| + |v| <=", "|u| + |v| <"), "9:11", "a limit includes its end; write <= or >="),
        (("|u| + |v| <= 1.2", "u"), "9:11", "is a number, not a formula"),
        (("x - v", "x >= v"), "8:19", "'>' in a sum; write a sum"),
        (("x - v", "x - q"), "8:21", "there is no signal or control 'q'"),
        (("x: [7, 8]", "x: [8, 7]"), "10:17", "the region's axis 'x' ends before it begins"),
        (("x: [7, 8]", "y: [7, 8]"), "10:17", "there is no signal or control 'y'"),
        (("robustness: 1", "robust: 1"), "14:13", "'robust'; did you mean 'robustness'?"),
        (("effort: 0.1", "effort: -1"), "14:28", "-1 is below 0"),
        (("effort: 0.1", "effort: {v: 1}"), "14:45", "there is no control 'v'"),
        (("control_effort: 0.1", "satisfaction: depth"), "14:1", "is not weighed against"),
        (("dynamics:", "#"), "6:11", "there are controls and no dynamics"),
        (("dynamics:", "dynamics: #"), "6:11", "there are controls and no dynamics"),
        (("format: tsplan-signals/1", "format: tsplan-signals/2"), "1:9", "'tsplan-signals/1'"),
    ],
)
def test_mistakes_have_places(pairs, place, words):
    only(*pairs, place=place, words=words)


def test_all_mistakes_are_told_at_once():
    found = wrong(
        *("initial: 0", "initial: 10", "u: [", "u: [a, ", "A: [[1", "A: [[1, 2"),
        *("F[0,9] in(goal)", "F[0,9] in(home)", "horizon: 10", "horizon: 2", "robust", "robot"),
    )
    assert [line.split(": ")[0] for line in found] == ["6:15", "13:23", "14:13"]
    found = wrong("initial: 0", "initial: 10", "in(goal)", "in(home)", "robust", "robot")
    assert [line.split(": ")[0] for line in found] == ["4:32", "13:23", "14:13"]


def test_what_is_wrong_elsewhere_is_not_told_of_the_formula():
    assert len(wrong("x - v", "x - v -")) == 1
    assert len(wrong("signals:", "singals:")) == 2
    assert len(wrong("regions: {goal: {x: [7, 8]}}", "regions: {goal: 3}")) == 1


def test_signals_of_several_robots_are_named_with_the_robot():
    base = changed("in(a, goal)", "in(goal)", "b_sum", "sum", text=SEVERAL)
    found = findings(signal_mission_from_text, base)
    assert any("'x'; say of which robot: a_x, or in(a, region)" in line for line in found)
    assert any("'sum'; say of which robot: a_sum" in line for line in found)
    text = changed("y: [0, 2]", "y: [0, 12], z: 1", text=SEVERAL)
    found = findings(signal_mission_from_text, text)
    assert [line.split(": ")[0] for line in found] == ["mission:8:33", "mission:8:45"]


def test_what_a_region_speaks_of_is_told_where_it_is_written():
    text = changed("in(a, goal)", "in(c, goal)", text=SEVERAL)
    found = findings(signal_mission_from_text, text)
    line, column = next(
        (number, at + 1)
        for number, written in enumerate(text.splitlines(), start=1)
        if (at := written.find("in(c, goal)")) >= 0
    )
    assert found
    assert {line_.split(": ")[0] for line_ in found} == {f"mission:{line}:{column}"}


@pytest.mark.parametrize(
    ("formula", "told"),
    [
        ("x >= 3 || v >= 1", {"x >= 3": "x"}),
        ("!(x >= 3 && v >= 1)", {"x >= 3": "x"}),
        ("F[0,3] x + v <= 2", {"v + x <= 2": "x"}),
        ("G[0,3] x >= 3", {}),
        ("F[2,2] x >= 3", {}),
        ("x != 3", {"x != 3": "x"}),
        ("v >= 0 || v <= -0.5", {}),
        ("(v >= 0) U[0,3] (x >= 2)", {"x >= 2": "x"}),
    ],
)
def test_signals_without_bounds_where_a_choice_needs_them(formula, told):
    pairs = ("min: 0, max: 9, ", "", "F[0,9] in(goal) && G[0,9] gap <= 9", formula)
    free = (
        *pairs,
        "{initial: 0}",
        "{}",
        "objective: {robustness: 1, control",
        "objective: {control",
    )
    if not told:
        assert signal_mission_from_text(changed(*free)).warnings == ()
        return
    found = wrong(*free)
    assert len(found) == 1
    ((node, name),) = told.items()
    assert f"'{node}' need not hold, and '{name}' in it has no bounds" in found[0]
    assert f"give '{name}' a min and a max" in found[0]
    # where a signal can get to by bounded controls from where it begins is bounded all the same
    assert signal_mission_from_text(changed(*pairs)).horizon == 10


def test_what_may_hold_in_part_needs_bounds_everywhere():
    pairs = ("{min: 0, max: 9, initial: 0}", "{}", "F[0,9] in(goal) && ", "")
    assert signal_mission_from_text(changed(*pairs)).satisfaction is None
    found = wrong(
        *pairs, "objective: {robustness: 1, control_effort: 0.1}", "objective: [satisfaction]"
    )
    assert "need not hold" in found[0]
    wish = 'must: "v <= 1"\n  prefer: [{formula: x >= 3}]'
    found = wrong(*pairs, 'formula: "G[0,9] gap <= 9"', wish)
    assert found == [
        "14:22: 'x >= 3' need not hold, and 'x' in it has no bounds; give 'x' a min and a max"
    ]


@pytest.mark.parametrize(
    ("formula", "warned"),
    [("x = 3", True), ("!(x = 3)", False), ("F[0,2] !(x != 3)", True), ("x != 3", False)],
)
def test_equations_have_no_robustness_to_maximise(formula, warned):
    mission = signal_mission_from_text(changed("F[0,9] in(goal)", formula))
    assert [item.line for item in mission.warnings] == [13] * warned
    assert all("robustness of 0" in item.message for item in mission.warnings)
    plain = changed("F[0,9] in(goal)", formula, "robustness: 1, ", "")
    assert signal_mission_from_text(plain).warnings == ()


WEIGHTED = (
    *(
        "language: stl",
        "language: wstl",
        "F[0,9] in",
        "F[0,2]^w in",
        '0,9] gap <= 9"',
        '0,9] gap <= 9"',
    ),
    *("  formula", "  weights: {w: [1, 2, 0.5]}\n  weighting: normalised\n  formula"),
)


def test_weights():
    mission = signal_mission_from_text(changed(*WEIGHTED))
    assert mission.weighting == "normalised"
    assert mission.formula.children[0].weights == (1.0, 2.0, 0.5)
    by_step = changed(*WEIGHTED, "[1, 2, 0.5]", "{0: 1, 1: 2, 2: 0.5}")
    assert signal_mission_from_text(by_step).formula is mission.formula
    (warning,) = signal_mission_from_text(changed(*WEIGHTED, "2, 0.5]", "2, 0.5], z: 1")).warnings
    assert (warning.line, warning.message) == (13, "no operator of the formula has the weights 'z'")


@pytest.mark.parametrize(
    ("pairs", "place", "words"),
    [
        (("2, 0.5]", "2, 0]"), "13:16", "w: '0' is no weight; write a number above 0"),
        (("2, 0.5]", "2, 0.5, 3]"), "15:19", "4 weights are given for steps 0 to 2, 3 needed"),
        (("[1, 2, 0.5]", "{0: 1, 1: 2, b: 3}"), "13:16", "'b' is no step or part"),
        (("[1, 2, 0.5]", "{0: 1, 2: 2}"), "15:19", "no weight is given for step 1"),
        (("^w", "^v"), "15:19", "no weights 'v' are given; known: w"),
        (("normalised", "normal"), "14:14", "'product' or 'normalised'"),
        (("wstl", "stl"), "15:19", "read the formula in the language wstl"),
    ],
)
def test_mistakes_in_weights(pairs, place, words):
    only(*WEIGHTED, *pairs, place=place, words=words)


def test_objectives():
    def aims(given: str) -> tuple[Aim, ...]:
        text = changed("{robustness: 1, control_effort: 0.1}", given)
        return signal_mission_from_text(text).objective

    effort = Aim((("control_effort", 1.0),))
    assert aims("[robustness, control_effort]") == (ROBUST, effort)
    assert aims("[{robustness: 2, state_effort: {x: 0.5}}, control_effort]") == (
        Aim((("robustness", 2.0), ("state_effort", 1.0)), {"state_effort": {"x": 0.5}}),
        effort,
    )
    assert aims("[]") == ()
    assert signal_mission_from_text(changed("objective: {", "#")).objective == (ROBUST,)
    text = changed("{robustness: 1, control_effort: 0.1}", "[satisfaction: depth, robustness]")
    mission = signal_mission_from_text(text)
    assert (mission.satisfaction, mission.objective[1]) == ("depth", ROBUST)
    wish = "must: x >= 0\n  prefer: [{formula: v >= 1, weight: 2, name: fast}]"
    text = changed('formula: "F[0,9] in(goal) && G[0,9] gap <= 9"', wish)
    mission = signal_mission_from_text(text)
    assert [aim.name for aim in mission.objective] == ["preferences", "J"]
    assert mission.prefer == (Preference(parse("v >= 1", "stl"), weight=2, name="fast"),)


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ("3", "'3' is no objective"),
        ("[3]", "'3' is no objective"),
        ("[robustness, robustness]", "named twice"),
        ("[robustness, satisfaction]", "'satisfaction' comes after other objectives"),
        ("[satisfaction: width]", "'width' is no order of satisfaction"),
        ("[preferences]", "'preferences' are an objective and none are there"),
        ("{robustness: 0}", "the sum weighs nothing"),
        ("{robustness: {x: 1}}", "'robustness' has no factors of signals"),
        ("{state_effort: {}}", "'state_effort' is of no signal"),
        ("{state_effort: {x: -1}}", "-1 is below 0"),
    ],
)
def test_mistakes_in_objectives(given, words):
    found = wrong("{robustness: 1, control_effort: 0.1}", given)
    assert len(found) == 1, found
    assert words in found[0]


CART = System(
    {"x": (0, 9), "v": (-1, 1)},
    {"u": (-0.5, 0.5)},
    Dynamics(((1, 1), (0, 1)), ((0,), (1,)), (0, 0)),
)


def test_missions_are_built_in_python():
    mission = SignalMission.of(
        system=CART,
        outputs={"gap": "x - v"},
        limits=["|u| + |v| <= 1.2"],
        start={"x": np.float64(0)},
        regions={"goal": GOAL},
        formula="F[0,9] in(goal) && G[0,9] gap <= 9",
        objective={"robustness": 1, "control_effort": 0.1},
        horizon=np.int64(10),
        name="reach",
    )
    assert mission == signal_mission_from_text(MISSION)
    wide = SignalMission.of(signals={"x": (0, np.inf)}, start={"x": 1}, formula="G[0,2] x >= 0")
    assert wide.system == System({"x": (0, np.inf)}, initial={"x": (1, 1)})


def test_formulas_of_python_are_taken_as_they_are():
    reach = GOAL.inside().eventually(0, 9, lambda step: step + 1)
    mission = SignalMission.of(
        system=CART,
        formula=[reach, "G[0,2]^w v <= gap"],
        outputs={"gap": "x + 1"},
        weights={"w": lambda step: 0.5 * step + 1},
        objective=[Aim((("robustness", 1.0),)), "control_effort"],
        prefer=[Preference(linear({"gap": 1}, ">=", 3), weight=2)],
    )
    assert mission.language == "wstl"
    slow = linear({"x": 1, "v": -1}, ">=", -1).always(0, 2, [1, 1.5, 2])
    assert [part for _, part in mission.parts] == [reach, slow]
    assert mission.prefer[0].formula is linear({"x": 1}, ">=", 2)


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"formula": "F[0,2 x >= 3"}, "mission"),
        ({"formula": "y >= 3"}, "no signal or control 'y'"),
        ({"start": {"x": 12}}, "begins at 12"),
        ({"start": {"y": 1}}, "there is no signal 'y'; known: v, x"),
        ({"horizon": 1}, "shorter than the formula's, 4"),
        ({"language": "mtl"}, "'stl' or 'wstl'"),
        ({"objective": ["fun"]}, "unknown objective 'fun'"),
        ({"weights": {"w": -1}}, "is no weight"),
        ({"limits": ["|u| >= 1"]}, "not convex"),
        ({"dynamics": {"A": [[1]], "B": [[1]]}}, "A has 1 row"),
    ],
)
def test_mistakes_in_python_are_the_same(options, words):
    with pytest.raises(MissionError) as caught:
        SignalMission.of(**({"system": CART, "formula": "F[0,4] x >= 3"} | options))
    assert words in str(caught.value)
    assert all(finding.line is None for finding in caught.value.findings)


def test_the_constructor_checks_too():
    far = linear({"x": 1}, ">=", 3).eventually(0, 4)
    assert SignalMission(CART, far, 4).parts == ((str(far), far),)
    with pytest.raises(MissionError, match="horizon: the horizon 3 is shorter"):
        SignalMission(CART, far, 3)
    named = System(CART.signals, outputs={"gap": ((("x", 1.0),), 0.0)})
    with pytest.raises(MissionError, match="'gap' is an output, and not written out"):
        SignalMission(named, linear({"gap": 1}, ">=", 3), 0)
    with pytest.raises(MissionError, match="is about a control, and there is none"):
        SignalMission(CART, linear({"u": 1}, ">=", 0), 0)
    with pytest.raises(MissionError, match="counts robots"):
        SignalMission(CART, parse("sum(A) >= 2"), 0)
    bent = System(CART.signals, limits=(Limit((), ((-1.0, (("x", 1.0),)),), 1.0),))
    with pytest.raises(MissionError, match=r"limits\[0\]: '-1\*\|x\| <= 1' is not convex"):
        SignalMission(bent, far, 4)
