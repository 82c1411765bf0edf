"""Missions of robots and swarms together: read from files and from Python, and every mistake."""

from __future__ import annotations

from fractions import Fraction

import pytest

from tests.missions import read, wrong_in
from tests.test_mission_swarms import MAP
from tsplan.errors import MissionError
from tsplan.mission import Group, Mission, SwarmBounds, SwarmRules
from tsplan.ts import Edge, State, TransitionSystem

MIXED = """\
format: tsplan-mission/1
map: yard.yaml
team:
  - {class: drone, count: 3, at: dock, capabilities: [fly]}
  - {class: cart, at: {dock: 1, field: 2}}
swarms:
  - {name: scouts, size: 13, at: dock, max_subswarms: 2}
  - {name: heavies, size: 20, at: {field: 20}, min_subswarm: 4}
max_subswarms: 3
margin: 10%
spec:
  formula: F[0,9] (sum(green, scouts) > 40% && sum(roof, fly) >= 1 && sum(home, cart) >= 50%)
  language: catl
objective: [splits, availability]
"""


FILES = {"yard.yaml": MAP}


def test_robots_and_swarms(folder):
    mission = read(folder, MIXED)
    assert mission.warnings == ()
    assert mission.team == (
        Group("drone", frozenset({"fly"}), (("dock", 3),)),
        Group("cart", frozenset({"cart"}), (("dock", 1), ("field", 2))),
        Group("scouts", frozenset({"scouts"}), (("dock", 13),)),
        Group("heavies", frozenset({"heavies"}), (("field", 20),)),
    )
    each = {"scouts": SwarmBounds(2, 1), "heavies": SwarmBounds(None, 4)}
    assert mission.swarm == SwarmRules(each, 3, Fraction(1, 10))
    assert mission.group_bounds("heavies") == SwarmBounds(None, 4)
    assert mission.group_bounds("drone") is None
    # 40 % of 13 is 5.2, with 2 agents of head-room; 1 of 3 and 50 % of 3 have 1
    assert str(mission.goal) == (
        "F[0,9] (sum(green,scouts) >= 8 && sum(roof,fly) >= 2 && sum(home,cart) >= 3)"
    )
    assert [agent.id for agent in mission.agents][2:5] == ["drone-3", "cart-1", "cart-2"]


def test_a_percentage_without_a_name_is_one_of_everybody(folder):
    mission = read(folder, MIXED.replace("sum(home, cart) >= 50%", "sum(home) >= 50%"))
    assert "sum(home) >= 20" in str(mission.counted)  # of 6 robots and 33 in swarms: 19.5


def test_one_swarm_beside_a_team_and_defaults(folder):
    text = MIXED.replace("swarms:\n  - {name: scouts, ", "swarm: {").replace("  - {name: h", "#")
    text = text.replace("max_subswarms: 3\n", "").replace("scouts", "swarm")
    text = text.replace("objective: [splits, availability]\n", "").replace("  language: catl\n", "")
    short = text.replace("spec:\n  formula: ", "spec: ")
    for mission in (read(folder, text + "  language: mtl\n"), read(folder, short)):
        assert mission.swarm == SwarmRules({"swarm": SwarmBounds(2, 1)}, None, Fraction(1, 10))
        assert mission.team[-1] == Group("swarm", frozenset({"swarm"}), (("dock", 13),))
        assert mission.objective == ("splits", "travel")
    assert mission.language == "catl"


def test_from_python(folder):
    system = read(folder, MIXED).system
    made = Mission.of(
        map=system,
        team=[{"class": "cart", "at": "dock"}, Group.of("drone", {"dock": 2}, ["fly"])],
        swarm={"size": 10, "at": "field"},
        formula="F[0,3] sum(green, swarm) >= 50% && F[0,3] sum(green, cart) >= 1",
        objective=["moves", "agents"],
    )
    assert made.language == "catl"
    assert made.swarm == SwarmRules({"swarm": SwarmBounds()})
    assert [group.class_name for group in made.team] == ["cart", "drone", "swarm"]
    assert str(made.goal) == "F[0,3] (sum(green,swarm) >= 5) && F[0,3] (sum(green,cart) >= 1)"
    again = Mission(
        "", system, made.team, "catl", made.text, made.formula, 3, made.objective, swarm=made.swarm
    )
    assert again.team == made.team
    with pytest.raises(MissionError, match="rules are not about the swarms"):
        Mission(
            "",
            system,
            made.team,
            "catl",
            "",
            made.formula,
            3,
            swarm=SwarmRules({"x": SwarmBounds()}),
        )


@pytest.mark.parametrize(
    ("change", "place", "words"),
    [
        (("name: scouts", "name: cart"), "7:12", ["class of the team is called 'cart'"]),
        (("name: scouts", "name: heavies"), "7:12", ["several swarms are called 'heavies'"]),
        (("swarms:", "swarm: {size: 3, at: dock}\nswarms:"), "7:1", ["'swarms' beside 'swarm'"]),
        (("swarms:", "min_subswarm: 3\nswarms:"), "6:1", ["inside the swarm"]),
        (("name: scouts, size", "name: scouts, count"), "7:20", ["unknown key 'count'"]),
        (("count: 3, at: dock", "count: 3, at: {dock: 2}"), "4:27", ["hold 2"]),
        (("at: {field: 20}", "at: {fild: 20}"), "8:41", ["no state 'fild'"]),
        (("at: {field: 20}", "at: {roof: 20}"), "8:41", ["'heavies' may not be at 'roof'"]),
        (("field: 2}}", "field: 90}}"), "8:41", ["110 robots start", "holds 100"]),
        (("[splits,", "[split,"), "14:13", ["'split'", "'splits'"]),
        (("[splits,", "[travel, travel,"), "14:21", ["twice"]),
    ],
)
def test_one_mistake_is_found_at_its_place(folder, change, place, words):
    assert change[0] in MIXED
    found = wrong_in(folder, MIXED.replace(*change, 1))
    line = next((line for line in found if line.startswith(f"{place}: ")), str(found))
    assert all(word in line for word in words), line


@pytest.mark.parametrize(
    ("change", "place", "words"),
    [
        (("sum(roof, fly)", "sum(roof, flies)"), "12:58", "no robot has the capability 'flies'"),
        (("[fly]", "[fly, cart]"), "12:81", "'cart' is a capability, and also the name of a class"),
        (("[fly]", "[fly, scouts]"), "12:31", "'scouts' is a capability, and also the name"),
        (("max_subswarms: 3", "max_subswarms: 1"), "9:16", "start in 2 places"),
        (("size: 13", "min_subswarm: 14, size: 13"), "7:34", "needs 14 agents"),
    ],
)
def test_what_is_doubtful_is_a_warning_at_its_place(folder, change, place, words):
    assert change[0] in MIXED
    (warning,) = read(folder, MIXED.replace(*change, 1)).warnings
    assert f"{warning.line}:{warning.column}" == place
    assert words in warning.message


def test_a_name_that_is_both_is_the_capability_of_others(folder):
    text = MIXED.replace("[fly]", "[fly, cart, scouts]")
    mission = read(folder, text)
    able = {group.class_name: group.capabilities for group in mission.team}
    assert able["drone"] == {"fly", "cart", "scouts"}
    assert able["cart"] == able["scouts"] == frozenset()
    assert mission.having("scouts") == 3


def test_a_class_is_a_capability_of_every_mission():
    yard = TransitionSystem.build(
        [State("a", labels=frozenset({"A"})), State("b", needs=frozenset({"cart"}))],
        [Edge("a", "a", 1), Edge("a", "b", 1)],
    )
    team = [Group.of("cart", {"a": 2}), Group.of("drone", {"a": 1}, ["fly"])]
    mission = Mission.of(map=yard, team=team, formula="F[0,2] sum(A, drone) >= 1")
    assert mission.warnings == ()
    assert [sorted(group.capabilities) for group in mission.team] == [["cart"], ["drone", "fly"]]
    silent = Mission.of(
        map=yard, team=[*team, Group.of("x", {"a": 1}, ["cart"])], formula="F[0,2] A"
    )
    assert [sorted(group.capabilities) for group in silent.team] == [[], ["fly"], ["cart"]]
