"""Missions: read from files, built in Python, and every mistake at its place."""

from __future__ import annotations

import pickle

import pytest

from tests.missions import read, wrong_in
from tsplan.errors import MissionError
from tsplan.logic import parse
from tsplan.mission import Group, Mission, SolverChoice, load_mission, mission_from_text
from tsplan.ts import Edge, State, TransitionSystem

MAP = """\
name: yard
waiting: true
states:
  dock: {labels: [home], capacity: 3}
  field: {labels: [green]}
  "01": {labels: [roof], needs: [fly]}
edges:
  - [dock, field, 2]
  - {from: field, to: dock, duration: {heavy: 3, default: 1}}
  - [field, "01", 1]
"""
MISSION = """\
format: tsplan-mission/1
name: look around
map: yard.yaml
team:
  - {class: scout, count: 2, at: dock, capabilities: [see]}
  - {class: heavy, at: {dock: 1, field: 2}, capabilities: [lift]}
  - {class: scout, at: field, capabilities: [see]}
spec:
  language: catl
  formula: |
    F[0,4] T(1, green, {(see,1)})
      && G[0,9] sum(home) >= 1
objective: [availability, travel]
horizon: 12
solver: {name: highs, time_limit: 60, gap: 0.0, threads: 2, seed: 1}
"""


FILES = {"yard.yaml": MAP}


def only(folder, text, place, *words):
    """The one finding of a text has this place and these words."""
    found = wrong_in(folder, text)
    assert len(found) == 1, found
    assert found[0].startswith(f"{place}: "), found
    for word in words:
        assert word in found[0]


def test_a_mission_file(folder):
    mission = read(folder, MISSION)
    assert (mission.name, mission.horizon, mission.language) == ("look around", 12, "catl")
    assert mission.objective == ("availability", "travel")
    assert mission.solver == SolverChoice("highs", 60, 0.0, 2, 1)
    assert mission.task_interval == "closed"
    assert [agent.id for agent in mission.agents] == [
        "scout-1", "scout-2", "heavy-1", "heavy-2", "heavy-3", "scout-3",
    ]  # fmt: skip
    assert [agent.start for agent in mission.agents] == ["dock"] * 3 + ["field"] * 3
    assert (mission.size, mission.having("see"), mission.having(None)) == (6, 3, 6)
    assert mission.capabilities == {"see", "lift"}
    assert mission.warnings == ()
    assert len(mission.digest) == 64
    assert "T(" in mission.text
    assert "T(" not in str(mission.goal)


def test_defaults(folder):
    text = (
        "format: tsplan-mission/1\nmap: yard.yaml\nteam: [{class: a, at: dock}]\n"
        "spec: {language: mtl, formula: 'F[0,3] green'}\n"
    )
    mission = read(folder, text)
    assert (mission.name, mission.horizon, mission.objective) == ("", 3, ("travel",))
    assert mission.solver == SolverChoice()
    assert mission.size == 1


def test_an_inline_map_and_a_text():
    inline = MISSION.replace(
        "map: yard.yaml", "map:\n" + "".join(f"  {line}\n" for line in MAP.splitlines())
    )
    assert mission_from_text(inline).system.name == "yard"


@pytest.mark.parametrize(
    ("formula", "expected"),
    [
        ("true", "true"),
        ("[home, 'F[0,2] green']", "home && F[0,2] green"),
        ("[false]", "false"),
        ("['home || green', true]", "(home || green) && true"),
    ],
)
def test_booleans_and_lists_of_formulas(folder, formula, expected):
    start = MISSION.index("  formula:")
    text = MISSION[:start] + f"  formula: {formula}\n"
    assert read(folder, text).formula is parse(expected, "catl")


def test_missions_can_be_sent_to_another_process(folder):
    mission = read(folder, MISSION)
    assert mission.goal is not None
    copy = pickle.loads(pickle.dumps(mission))
    assert copy.formula is mission.formula
    assert copy.agents == mission.agents
    assert copy.system.edges == mission.system.edges


@pytest.mark.parametrize(
    ("old", "new", "place", "words"),
    [
        ("green, {", "gren, {", "11:17", ["label 'gren'", "'green'"]),
        ("sum(home)", "sum(hom)", "12:21", ["label 'hom'", "'home'"]),
        ("at: dock,", "at: dok,", "5:34", ["no state 'dok'", "'dock'"]),
        ("dock: 1", "dck: 1", "6:30", ["no state 'dck'", "'dock'"]),
        ("dock: 1", "dock: 0", "6:31", ["at least 1"]),
        ("dock: 1", "dock: 2", "6:31", ["4 robots start at 'dock', which holds 3"]),
        ("dock: 1", "'01': 1", "6:31", ["may not be at '01'", "fly"]),
        ("count: 2", "count: 0", "5:27", ["at least 1"]),
        ("count: 2", "count: 1.5", "5:27", ["not a whole number"]),
        ("count: 2", "count: -3", "5:27", ["at least 1"]),
        ("count: 2", "count: two", "5:27", ["not a whole number"]),
        ("at: {dock", "count: 4, at: {dock", "6:27", ["count is 4", "hold 3"]),
        ("[availability, travel]", "[availabilty]", "13:13", ["'availabilty'", "'availability'"]),
        ("[availability, travel]", "[travel, travel]", "13:21", ["named twice"]),
        ("horizon: 12", "horizon: 8", "14:10", ["shorter than the formula's, 9", "at least 9"]),
        ("field: 2", "field: 99999999", "5:3", ["100,000,003 robots"]),
        ("G[0,9]", "G[0,9999999]", "10:12", ["9,999,999 steps"]),
        ("horizon: 12", "horizon: 2000000", "14:10", ["2,000,000 steps"]),
        ("horizon: 12", "horizon: -1", "14:10", ["at least 0"]),
        ("language: catl", "language: ltl", "9:13", ["'catl', 'mtl', 'stl' or 'wmtl'"]),
        ("time_limit: 60", "time_limit: 0", "15:35", ["more than 0"]),
        ("gap: 0.0", "gap: -1", "15:44", ["at least 0"]),
        ("threads: 2", "thread: 2", "15:49", ["unknown key 'thread'", "'threads'"]),
        ("format: tsplan-mission/1", "format: tsplan-mission/2", "1:9", ["tsplan-mission/1"]),
        ("{(see,1)})", "{(see,1)}, {(fuel, 2.5)})", "11:37", ["there is no resource 'fuel'"]),
        ("G[0,9]", "G[9,0]", "12:11", ["[0,9]"]),
        ("home) >= 1", "home) >= 30%", "12:17", ["percentage"]),
        ("map: yard.yaml", "maps: yard.yaml\nmap: yard.yaml", "3:1", ["unknown key", "'map'"]),
        ("map: yard.yaml", "map: 3", "3:6", ["neither a file name nor a map"]),
        ("class: scout, count", "class: [], count", "5:13", ["not text"]),
    ],
)
def test_one_mistake_is_one_finding_at_its_place(folder, old, new, place, words):
    assert old in MISSION
    only(folder, MISSION.replace(old, new, 1), place, *words)


def test_missing_parts_are_named(folder):
    assert [
        word
        for word in ("map", "team", "spec", "format")
        if any(f"'{word}' is missing" in line for line in wrong_in(folder, "name: x\n"))
    ] == ["map", "team", "spec", "format"]


def test_an_empty_team_is_refused(folder):
    start, stop = MISSION.index("team:"), MISSION.index("spec:")
    text = MISSION[:start] + "team: []\n" + MISSION[stop:]
    found = wrong_in(folder, text)
    assert any("team" in line for line in found)


def test_all_mistakes_are_reported_at_once(folder):
    text = (
        MISSION.replace("green, {", "gren, {")
        .replace("at: dock", "at: dok")
        .replace("horizon: 12", "horizon: 2")
        .replace("[availability, travel]", "[speed]")
    )
    found = wrong_in(folder, text)
    assert [line.split(":")[0] for line in found] == ["5", "11", "13", "14"]


def test_a_formula_is_read_even_when_the_rest_is_wrong(folder):
    found = wrong_in(folder, MISSION.replace("count: 2", "count: x").replace("G[0,9]", "G[0,9"))
    assert [line.split(":")[0] for line in found] == ["5", "12"]


def test_places_in_quoted_and_listed_formulas(folder):
    start = MISSION.index("  formula:")
    text = MISSION[:start] + "  formula: ['home', \"F[0,2] gren\"]\n"
    only(folder, text, "10:29", "'gren'")
    text = MISSION[:start] + "  formula: [home, 3]\n"
    only(folder, text, "10:19", "not a text")
    text = MISSION[:start] + "  formula: []\n"
    only(folder, text, "10:12", "empty")


def test_a_broken_map_is_said_once_and_labels_are_left_alone(folder):
    (folder / "yard.yaml").write_text(MAP.replace("[dock, field, 2]", "[dock, feld, 1.5]"))
    found = wrong_in(
        folder, MISSION.replace("green, {", "gren, {").replace("horizon: 12", "horizon: 2")
    )
    assert any("yard.yaml" in line for line in found)
    assert any(line.startswith("3:6: the map cannot be used") for line in found)
    assert any(line.startswith("14:10") for line in found)
    assert not any("gren" in line for line in found)
    (folder / "yard.yaml").unlink()
    found = wrong_in(folder, MISSION)
    assert len(found) == 2
    assert "no such file" in found[0]


def test_a_file_that_cannot_be_read(folder):
    with pytest.raises(MissionError, match="no such file"):
        load_mission(folder / "none.yaml")
    (folder / "mission.yaml").write_bytes(b"\xff")
    with pytest.raises(MissionError, match="not UTF-8"):
        load_mission(folder / "mission.yaml")
    only(folder, MISSION + "name: again\n", "16:1", "twice")


@pytest.mark.parametrize("text", ["", "3", "[]", "team", "- a\n- b\n"])
def test_a_file_that_is_no_mapping(folder, text):
    assert wrong_in(folder, text)


@pytest.mark.parametrize(
    ("old", "new", "place", "words"),
    [
        ("(see,1)", "(sea,1)", (11, 26), ["capability 'sea'", "'see'"]),
        ("heavy, at", "hevy, at", (3, 6), ["class 'heavy'", "'hevy'"]),
        ("at: field, capabilities: [see]", "at: field", (7, None), ["other capabilities"]),
    ],
)
def test_warnings_do_not_stop_the_mission(folder, old, new, place, words):
    mission = read(folder, MISSION.replace(old, new, 1))
    assert len(mission.warnings) == 1
    warning = mission.warnings[0]
    assert warning.line == place[0]
    assert warning.column == place[1] or place[1] is None
    for word in words:
        assert word in str(warning)


def test_a_capability_nobody_has_makes_the_goal_no_easier(folder):
    mission = read(folder, MISSION.replace("(see,1)", "(sea,1)", 1))
    assert mission.having("sea") == 0
    assert "sea" in str(mission.goal)


def test_signals_are_refused_in_a_team_mission(folder):
    start = MISSION.index("spec:")
    text = MISSION[:start] + "spec: {language: stl, formula: 'G[0,3] 2*x - y >= 3'}\n"
    only(folder, text, "8:40", "signals", "sum(A) >= 2")


def test_half_open_tasks_need_a_step(folder):
    text = MISSION.replace("T(1,", "T(0,") + "task_interval: half-open\n"
    only(folder, text, "11:12", "half-open")


YARD = TransitionSystem.build(
    [State("p", frozenset({"A"})), State("q", frozenset({"B"}))],
    [Edge("p", "p"), Edge("q", "q"), Edge("p", "q", 2)],
)


def test_missions_are_built_in_python():
    mission = Mission.of(
        map=YARD,
        team=[Group.of("a", {"p": 2}, ["see"]), {"class": "b", "count": 1, "at": "q"}],
        formula=parse("F[0,5] B", "mtl") & parse("A", "mtl"),
        language="mtl",
        objective=("availability",),
        solver=SolverChoice(seed=3),
        name="demo",
    )
    assert (mission.name, mission.horizon, mission.size) == ("demo", 5, 3)
    assert mission.solver.seed == 3
    assert mission.system is YARD
    same = Mission.of(
        map=YARD,
        team=[{"class": "a", "at": {"p": 2}, "capabilities": ["see"]}, Group.of("b", {"q": 1})],
        formula=["F[0,5] B", "A"],
        language="mtl",
        solver={"seed": 3},
    )
    assert same.formula is mission.formula
    assert same.team == mission.team


def test_maps_are_found_by_path(folder):
    mission = Mission.of(
        map=folder / "yard.yaml", team=[Group.of("a", {"dock": 1})], formula="true"
    )
    assert mission.system.name == "yard"


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"team": []}, "team"),
        ({"team": [Group.of("a", {"z": 1})]}, "no state 'z'"),
        ({"team": [Group.of("a", {})]}, "no start state"),
        ({"team": [Group.of("a", {"p": -1})]}, "at least 1"),
        ({"formula": "F[0,2] C"}, "label 'C'"),
        ({"formula": "F[0,2 A"}, "mission"),
        ({"objective": ("fun",)}, "unknown objective 'fun'"),
        ({"horizon": 1}, "shorter than the formula's, 4"),
        ({"language": "ltl"}, "'catl', 'mtl', 'stl' or 'wmtl'"),
    ],
)
def test_mistakes_in_python_are_the_same(options, words):
    values = {"map": YARD, "team": [Group.of("a", {"p": 1})], "formula": "F[0,4] B"} | options
    with pytest.raises(MissionError) as caught:
        Mission.of(**values)
    assert words in str(caught.value)
    assert all(finding.line is None for finding in caught.value.findings)


def test_the_constructor_checks_too(folder):
    mission = read(folder, MISSION)
    parts = {
        "name": "x",
        "system": mission.system,
        "team": mission.team,
        "language": "catl",
        "text": mission.text,
        "formula": mission.formula,
    }
    assert Mission(**parts, horizon=9).objective == ("travel",)
    with pytest.raises(MissionError, match="horizon: the horizon 8 is shorter"):
        Mission(**parts, horizon=8)
    with pytest.raises(MissionError, match=r"team\[0\].at.moon: the map has no state 'moon'"):
        Mission(**(parts | {"team": (Group.of("a", {"moon": 1}),)}), horizon=9)


def test_names_of_any_letters_survive_python_values():
    names = ("🚀", "中文", "\\ud83d\\ude80", "\u2028 line", 'a "b"')
    waits = [Edge(name, name) for name in names]
    system = TransitionSystem.build([State(name, frozenset({name})) for name in names], waits)
    mission = Mission.of(
        map=system, team=[{"class": "🚀", "at": dict.fromkeys(names, 1)}], formula="true"
    )
    assert [agent.start for agent in mission.agents] == list(names)
    assert mission.agents[0].class_name == "🚀"


def test_a_map_that_is_neither_made_nor_named_is_refused():
    with pytest.raises(MissionError, match=r"type 'list'.*TransitionSystem, a networkx graph or"):
        Mission.of(map=["a"], team=[], formula="a")


def test_a_map_may_be_given_as_a_file_has_it():
    team = [{"class": "cart", "count": 1, "at": "a"}]
    mission = Mission.of(map={"states": {"a": {"labels": ["x"]}}}, team=team, formula="x")
    assert mission.system.labels["x"] == ("a",)
    with pytest.raises(MissionError, match="mission: states: a list is not a mapping"):
        Mission.of(map={"states": ["a"]}, team=team, formula="a")
