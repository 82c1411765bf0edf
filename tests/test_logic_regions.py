"""Regions and named expressions in formulas over signals."""

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.seeds import quick
from tsplan import logic
from tsplan.errors import FormulaError
from tsplan.logic import linear, parse, parse_with_places
from tsplan.signals.region import Region

GOAL = Region(x=(7, 8), y=(8, 9))
WALL = {"x": (3, 5)}
REGIONS = {"goal": GOAL, "wall": WALL, "the gap": {"gap": (0, 1)}}
GAP = {"gap": ({"s1": 1, "s2": -1}, 0.0), "lift": ((("h", 0.1), ("v", 2), ("h", 0.2)), 0.1)}
ODD = {
    "late": {"x": (2, 1)},
    "none": {},
    "number": {"x": 3},
    "wide": {"x": (0, float("inf"))},
    "many": dict.fromkeys("uvxy", (0, 1)),
}


def read(text, language="stl"):
    return parse(text, language, regions=REGIONS, definitions=GAP)


@pytest.mark.parametrize("language", ["stl", "wstl"])
@pytest.mark.parametrize(
    ("text", "formula"),
    [
        ("in(goal)", GOAL.inside()),
        ("F[0,2] out( goal ) && !clear(wall)", None),
        ("in(wall)", linear({"x": 1}, ">=", 3) & linear({"x": 1}, "<=", 5)),
        ("clear(goal)", GOAL.clear()),
        ("in(a, wall)", Region(a_x=(3, 5)).inside()),
        ("out(clear, wall)", Region(clear_x=(3, 5)).outside()),
        ("(" * 30 + "in(goal)" + ")" * 30, GOAL.inside()),
        ("X in(wall)", Region(x=(3, 5)).inside().eventually(1, 1)),
        ('in("the gap")', None),
        ("in > 2", linear({"in": 1}, ">", 2)),
        ("in + 2*out - clear < (in)", linear({"out": 2, "clear": -1}, "<", 0)),
        ("2*gap - s1 >= 1", linear({"s1": 1, "s2": -2}, ">=", 1)),
        ("(1 + gap)/2 < -gap", linear({"s1": 1.5, "s2": -1.5}, "<", -0.5)),
        ("lift >= 0.4", linear({"h": 0.3, "v": 2}, ">=", 0.3)),
    ],
)
def test_what_regions_and_names_stand_for(language, text, formula):
    made = read(text, language)
    assert parse(str(made), language) is made
    if formula is not None:
        assert made is formula


def test_a_region_over_a_named_expression():
    assert read('in("the gap")') is read("gap >= 0 && gap <= 1")
    assert read('clear("the gap")') is read("G[0,1] gap <= 0 || G[0,1] gap >= 1")


@quick
@given(st.tuples(*[st.integers(-3, 9)] * 4), st.tuples(*[st.integers(-3, 9)] * 4))
def test_regions_mean_what_they_say(xs, ys):
    trace = logic.SignalTrace({"x": np.array(xs, float), "y": np.array(ys, float)})
    box = {"x": (0, 4), "y": (2, 6)}
    points = list(zip(xs, ys, strict=True))

    def values(word):
        return logic.holds(parse(f"{word}(b)", "stl", regions={"b": box}), trace).tolist()

    assert values("in") == [0 <= x <= 4 and 2 <= y <= 6 for x, y in points]
    assert values("out") == [not (0 < x < 4 and 2 < y < 6) for x, y in points]
    sides = [{x <= 0: 0, x >= 4: 1}.items() | {y <= 2: 2, y >= 6: 3}.items() for x, y in points]
    beyond = [{side for holds, side in found if holds} for found in sides]
    assert values("clear") == [bool(a & b) for a, b in pairwise(beyond)]


def test_what_is_said_of_a_region_is_one_occurrence():
    text = "x > 1 && F[0,2] in( a , wall)"
    formula, written = parse_with_places(text, "stl", regions=REGIONS)
    below = written.children[1].children[0]
    assert below.formula is formula.children[1].children[0]
    assert text[slice(*below.span)] == "in( a , wall)"
    assert text[slice(*written[1, 0, "robot"])] == "a"
    assert text[slice(*written[1, 0, "region"])] == "wall"
    assert below.children == ()
    assert written.get((1, 0, 1)) is None


@pytest.mark.parametrize(
    ("text", "column", "message", "remedy"),
    [
        ("F[0,2] in(gaol)", 11, "no region 'gaol'", "did you mean 'goal'"),
        ("in(goal, wlal)", 10, "no region 'wlal'", "did you mean 'wall'"),
        ("in(late)", 1, "ends before it begins", "least and greatest"),
        ("!out(none)", 2, "1 to 3 axes, not 0", "least and greatest"),
        ("in(many)", 1, "1 to 3 axes, not 4", "least and greatest"),
        ("in(number)", 1, "'number' is no region", "least and greatest"),
        ("in(wide)", 1, "not finite", "least and greatest"),
        ("in(goal) > 2", 1, "'in(goal)' is a formula", "both sides"),
        ("x > in(goal)", 5, "'in(goal)' is a formula", "both sides"),
        ("broken > 1", 1, "'broken' stands for no linear", "finite"),
        ("gap", 1, "'gap' is a number", "compare it"),
        ("gap*x > 1", 5, "two signals are multiplied", "linear"),
    ],
)
def test_what_cannot_be_meant_is_told(text, column, message, remedy):
    broken = {**GAP, "broken": ({"x": float("nan")}, 0)}
    with pytest.raises(FormulaError) as caught:
        parse(text, "stl", regions={**REGIONS, **ODD}, definitions=broken)
    (found,) = caught.value.findings
    assert found.column == column
    assert message in found.message
    assert remedy in found.remedy


def test_a_region_is_a_mapping_of_its_ends():
    assert dict(GOAL) == {"x": (7.0, 8.0), "y": (8.0, 9.0)}
    assert len(GOAL) == 2
    with pytest.raises(ValueError, match="not finite"):
        Region(x=(0, float("inf")))
