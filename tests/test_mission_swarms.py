"""Missions of swarms: read from files and from Python, percentages, margins, every mistake."""

from __future__ import annotations

import pickle
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.missions import read, wrong_in
from tests.seeds import quick
from tsplan.errors import MissionError
from tsplan.logic import parse, tighten
from tsplan.mission import Group, Mission, SwarmBounds, SwarmRules

MAP = """\
name: yard
waiting: true
states:
  dock: {labels: [home]}
  field: {labels: [green], capacity: 100}
  roof: {labels: [roof], needs: [fly]}
edges:
  - [dock, field, 2]
  - {from: field, to: dock, duration: 1}
"""
ONE = """\
format: tsplan-mission/1
map: yard.yaml
swarm: {size: 120, at: {dock: 80, field: 40}, max_subswarms: 3, min_subswarm: 10}
margin: 5%
spec:
  language: mtl
  formula: "F[0,9] sum(green) >= 60% && G[0,9] !roof"
"""
TWO = """\
format: tsplan-mission/1
map: yard.yaml
swarms:
  - {name: scouts, size: 13, at: dock, max_subswarms: 2}
  - {name: heavies, size: 20, at: {field: 20}, min_subswarm: 4}
max_subswarms: 3
spec:
  language: mtl
  formula: |
    F[0,9] sum(green, scouts) > 40% && G[0,9] sum(home) <= 50%
      && F[0,5] sum(home, heavies) >= 25%
objective: [balance, makespan, moves]
"""


FILES = {"yard.yaml": MAP}


def test_one_swarm(folder):
    mission = read(folder, ONE)
    assert mission.team == (Group("swarm", frozenset(), (("dock", 80), ("field", 40))),)
    assert mission.swarm == SwarmRules({"swarm": SwarmBounds(3, 10)}, None, Fraction(1, 20))
    assert mission.objective == ("splits", "travel")
    assert mission.warnings == ()
    # 60 % of 120 with 6 agents of head-room; what is to be empty has none
    assert str(mission.goal) == "F[0,9] (sum(green) >= 78) && G[0,9] (sum(roof) <= 0)"
    assert str(mission.counted) == "F[0,9] (sum(green) >= 72) && G[0,9] !roof"
    assert pickle.loads(pickle.dumps(mission)).swarm == mission.swarm
    assert hash(mission)


def test_several_swarms(folder):
    mission = read(folder, TWO)
    assert mission.team == (
        Group("scouts", frozenset({"scouts"}), (("dock", 13),)),
        Group("heavies", frozenset({"heavies"}), (("field", 20),)),
    )
    assert mission.swarm == SwarmRules(
        {"scouts": SwarmBounds(2, 1), "heavies": SwarmBounds(None, 4)}, 3, 0
    )
    assert mission.objective == ("balance", "makespan", "moves")
    # 40 % of 13 is 5.2, 50 % of all 33 is 16.5, 25 % of 20 is 5
    assert str(mission.goal) == (
        "F[0,9] (sum(green,scouts) >= 6) && G[0,9] (sum(home) <= 16)"
        " && F[0,5] (sum(home,heavies) >= 5)"
    )


def test_a_margin_in_agents_and_defaults(folder):
    mission = read(folder, ONE.replace("margin: 5%", "margin: 7"))
    assert mission.swarm.margin == 7
    assert str(mission.goal).startswith("F[0,9] (sum(green) >= 79)")
    mission = read(folder, TWO.replace("margin", "").replace("objective", "#"))
    assert mission.swarm.margin == 0


def test_from_python(folder):
    made = Mission.of(
        map=str(folder / "yard.yaml"),
        swarms=[{"name": "a", "size": 3, "at": "dock"}, {"name": "b", "size": 2, "at": "dock"}],
        max_subswarms=4,
        margin="2.5%",
        formula="F[0,3] sum(green, a) >= 50%",
    )
    assert made.language == "mtl"
    assert made.swarm.together == 4
    assert made.swarm.margin == Fraction(1, 40)
    assert str(made.goal) == "F[0,3] (sum(green,a) >= 3)"
    big = Mission.of(
        map=made.system, swarm={"size": 10**6, "at": {"dock": 10**6}}, formula="F[0,3] green"
    )
    assert big.size == 10**6
    assert "agents" not in vars(big)
    with pytest.raises(MissionError, match="rules are not about the swarms"):
        Mission("", made.system, made.team, "mtl", "", made.formula, 3, (), swarm=SwarmRules({}))


@pytest.mark.parametrize(
    ("base", "change", "place", "words"),
    [
        (ONE, ("size: 120", "size: 100"), "3:15", ["size is 100", "hold 120", "write 120"]),
        (ONE, ("size: 120, ", ""), "3:8", ["'size' is missing"]),
        (ONE, ("size: 120", "size: 0"), "3:15", ["at least 1"]),
        (ONE, ("at: {dock", "at: {dok"), "3:30", ["no state 'dok'", "'dock'"]),
        (ONE, ("dock: 80, field: 40", "dock: 10, field: 110"), "3:47", ["which holds 100"]),
        (ONE, ("max_subswarms: 3", "max_subswarms: 0"), "3:60", ["at least 1"]),
        (ONE, ("max_subswarms", "max_subswarm"), "3:45", ["unknown key", "'max_subswarms'"]),
        (ONE, ("margin: 5%", "margin: 0.05"), "4:9", ["'0.05' is no head-room", "5%"]),
        (ONE, ("margin: 5%", "margin: 120%"), "4:9", ["no head-room"]),
        (ONE, ("margin: 5%", "margin: -1"), "4:9", ["no head-room"]),
        (ONE, ("margin: 5%", "max_subswarms: 3"), "4:1", ["several swarms", "inside 'swarm'"]),
        (ONE, ("margin: 5%", "min_subswarm: 3"), "4:1", ["one swarm", "inside the swarm"]),
        (ONE, ("margin: 5%", "objective: [split]"), "4:13", ["'split'", "'splits'"]),
        (ONE, ("sum(green)", "sum(green, scouts)"), "7:30", ["no swarm 'scouts'", "has no name"]),
        (ONE, ("60%", "160%"), "7:33", ["100"]),
        (ONE, ("dock: 80", "roof: 80"), "3:26", ["may not be at 'roof'", "start elsewhere"]),
        (TWO, ("green, scouts", "green, scout"), "9:23", ["no swarm 'scout'", "'scouts'"]),
        (TWO, ("name: heavies", "name: scouts"), "5:12", ["several swarms"]),
        (TWO, ("size: 13", "size: a"), "4:26", ["whole number"]),
        (TWO, ("name: scouts, ", ""), "4:5", ["'name' is missing"]),
    ],
)
def test_one_mistake_is_found_at_its_place(folder, base, change, place, words):
    assert change[0] in base
    found = wrong_in(folder, base.replace(*change, 1))
    line = next((line for line in found if line.startswith(f"{place}: ")), str(found))
    assert all(word in line for word in words), line


def test_a_swarm_may_satisfy_in_part_and_prefer(folder):
    wish = ONE + '  prefer:\n    - {formula: "F[0,2] home", level: 2}\n'
    made = read(folder, wish)
    assert made.objective[0] == "preferences"
    assert [item.level for item in made.prefer] == [2]
    soft = read(folder, ONE.replace("margin: 5%\n", "") + "objective: [{satisfaction: depth}]\n")
    assert (soft.partial, soft.satisfaction) == (True, "depth")


@pytest.mark.parametrize(
    ("change", "more", "words"),
    [
        ("margin: 5%\n", "objective: [{satisfaction: depth}]\n", "8:13: a margin is head-room of"),
        ("", "objective: [splits, {satisfaction: depth}]\n", "7:21: 'satisfaction' comes after"),
        ("", "objective: [preferences]\n", "7:13: 'preferences' are an objective and none are"),
        ("", '  prefer: [{formula: "F[0,2] hom"}]\n', "7:30: no state of the map has the label"),
        (
            "",
            '  prefer: [{formula: "F[0,20] home"}]\nhorizon: 12\n',
            "8:10: the horizon 12 is",
        ),
        ("", '  prefer: [{formula: "F[0,2] sum(home, x) > 1"}]\n', "7:40: there is no swarm 'x'"),
        ("", '  prefer: [{formula: "home", weight: 0}]\n', "7:38: "),
    ],
)
def test_a_mistake_about_what_is_preferred_is_found_at_its_place(folder, change, more, words):
    text = ONE.replace("margin: 5%\n", change) + more
    found = wrong_in(folder, text)
    assert any(line.startswith(words) for line in found), found


def test_what_is_said_of_swarms_needs_one(folder):
    team = (
        "format: tsplan-mission/1\nmap: yard.yaml\nteam: [{class: a, at: dock}]\nmargin: 5%\n"
        "max_subswarms: 2\nobjective: [splits, travel]\n"
        "spec: {language: mtl, formula: 'F[0,3] sum(green) >= 40%'}\n"
    )
    found = wrong_in(folder, team)
    assert [line.split(": ")[0] for line in found] == ["4:1", "5:1", "6:13", "7:40"]
    assert "is for swarms, and this mission is for a team" in found[2]
    assert "percentage" in found[3]


@pytest.mark.parametrize(
    ("base", "change", "place", "words"),
    [
        (ONE, ("max_subswarms: 3", "max_subswarms: 1"), "3:62", "starts in 2 places"),
        (ONE, ("min_subswarm: 10", "min_subswarm: 50"), "3:42", "40 agents start at 'field'"),
        (ONE, ("min_subswarm: 10", "min_subswarm: 500"), "3:79", "500 agents"),
        (TWO, ("max_subswarms: 3", "max_subswarms: 1"), "6:16", "start in 2 places, and together"),
    ],
)
def test_hopeless_bounds_are_warnings(folder, base, change, place, words):
    assert change[0] in base
    mission = read(folder, base.replace(*change, 1))
    (warning,) = mission.warnings
    assert f"{warning.line}:{warning.column}" == place
    assert words in warning.message
    assert "no plan is possible" in warning.remedy


@quick
@given(
    bound=st.integers(-2, 12),
    total=st.integers(0, 10),
    spare=st.integers(0, 12),
    relation=st.sampled_from([">=", "<="]),
)
def test_tightening_never_asks_for_what_cannot_be(bound, total, spare, relation):
    def possible(formula):
        low, high = (formula.bound, total) if formula.relation == ">=" else (0, formula.bound)
        return [count for count in range(total + 1) if low <= count <= high]

    atom = parse(f"sum(A) {relation} {bound}")
    before = possible(atom)
    after = possible(tighten(atom, lambda _: total, lambda _: spare))
    assert set(after) <= set(before)
    assert bool(after) == bool(before)
    # away from what is certain anyway, every demand keeps its distance
    for count in after:
        if 0 < count < total and len(before) <= total:
            assert all(abs(count - other) > spare for other in set(range(total + 1)) - set(before))
