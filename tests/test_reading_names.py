"""Names: one form for spellings that Unicode calls equal, and states that stand for labels."""

from __future__ import annotations

import unicodedata

import pytest

import tsplan
from tsplan import Edge, Group, Mission, State, TransitionSystem, parse
from tsplan.cli import main
from tsplan.errors import MapError, MissionError
from tsplan.logic import Count
from tsplan.logic import evaluation as evaluate
from tsplan.logic.traces import CountTrace, SignalTrace
from tsplan.mission import load_mission, mission_from_text
from tsplan.plans.plan_file import load_plan
from tsplan.ts.io.map_files import load_map

ONE, TWO = "caf\u00e9", "cafe\u0301"
MISSION = """\
format: tsplan-mission/1
name: names
map: {waiting: true, states: {STATE: {labels: [LABEL], needs: [ABLE]}, b: {labels: [b]}},
  edges: [[STATE, b, {CLASS: 1}], [b, STATE, 1]]}
team: [{class: CLASS, count: 2, at: b, capabilities: [ABLE]}]
spec: {language: mtl, formula: 'F[0,3] sum("LABEL", "ABLE") >= 2'}
"""


def written(**spellings):
    text = MISSION
    for word in ("STATE", "LABEL", "ABLE", "CLASS"):
        text = text.replace(word, spellings.get(word, ONE + word.lower()))
    return text


def mixed():
    """Every name of a mission in one form where it is defined and in the other where it is used."""
    text, parts = written(), []
    for number, part in enumerate(text.split(ONE)):
        parts += [part, (ONE, TWO)[number % 2]]
    return "".join(parts[:-1])


def test_both_spellings_are_one_name(tmp_path):
    assert TWO in mixed()
    mission = mission_from_text(mixed())
    assert not mission.warnings
    assert mission.team == mission_from_text(written()).team
    assert tsplan.plan(mission).status == "optimal"
    (tmp_path / "map.yaml").write_text(f"states: {{{ONE}: {{}}, {TWO}: {{}}}}", "utf-8")
    with pytest.raises(MapError, match=f"the key '{ONE}' appears twice"):
        load_map(tmp_path / "map.yaml")


def test_places_are_found_in_either_form():
    text = written().replace('F[0,3] sum("', f'F[0,3] sum("{TWO}x')
    with pytest.raises(MissionError) as caught:
        mission_from_text(text, "m")
    assert f"m:6:45: no state of the map has the label '{ONE}x" in str(caught.value)


def test_plan_files_may_spell_names_in_either_form(tmp_path):
    (tmp_path / "m.yaml").write_text(written(), encoding="utf-8")
    mission = load_mission(tmp_path / "m.yaml")
    text = tsplan.plan(mission).to_json()
    assert ONE in text
    escaped = text.replace(ONE, "cafe\\u0301")
    for spelled in (text, unicodedata.normalize("NFD", text), escaped, "\ufeff" + text):
        (tmp_path / "p.json").write_text(spelled, encoding="utf-8")
        assert tsplan.check(mission, load_plan(tmp_path / "p.json")).ok
    assert main(["check", str(tmp_path / "m.yaml"), str(tmp_path / "p.json")]) == 0


def test_names_given_in_python_are_compared_alike():
    system = TransitionSystem.build(
        [State(TWO, frozenset({TWO})), State("b")], [Edge(ONE, "b", {TWO: 2}), Edge("b", TWO)]
    )
    assert system.labels == {ONE: (ONE,)}
    assert system.edges[ONE, "b"].duration_for(ONE) == 2
    group = Group.of(TWO, {TWO: 1}, [TWO])
    mission = Mission.of(map=system, team=[group], formula=f'sum("{ONE}", "{TWO}") >= 1')
    assert mission.team[0] == Group.of(ONE, {ONE: 1}, [ONE])
    assert Count("sum", TWO, None, ">=", 1) is parse(f'sum("{ONE}") >= 1')
    counts = CountTrace({None: [[1, 0]]}, {TWO: [0]})
    assert evaluate.robustness(parse(f'sum("{TWO}") >= 1'), counts).tolist() == [0, -1]
    signals = SignalTrace({TWO: [3.0]})
    assert evaluate.robustness(parse(f'"{ONE}" >= 1', "stl"), signals).tolist() == [2]


def test_a_map_file_may_spell_its_name_in_either_form(tmp_path):
    name = f"{TWO}.yaml"
    (tmp_path / name).write_text("waiting: true\nstates: {a: {labels: [a]}}\n", encoding="utf-8")
    text = f"format: tsplan-mission/1\nmap: {ONE}.yaml\nteam: [{{class: r, at: a}}]\nspec: a\n"
    assert mission_from_text(text, folder=tmp_path).system.labels == {"a": ("a",)}


@pytest.mark.parametrize("text", ["F[0,2] a", "sum(a) >= 1"])
def test_a_byte_order_mark_is_no_part_of_anything(tmp_path, text):
    assert parse("\ufeff" + text) is parse(text)
    map_text = "\ufeffwaiting: true\nstates: {a: {labels: [a]}}\n"
    mission = (
        f"\ufeffformat: tsplan-mission/1\nmap: m.yaml\nteam: [{{class: r, at: a}}]\nspec: {text}\n"
    )
    (tmp_path / "m.yaml").write_text(map_text, encoding="utf-8")
    (tmp_path / "mission.yaml").write_text(mission, encoding="utf-8")
    made = load_mission(tmp_path / "mission.yaml")
    plan = "\ufeff" + tsplan.plan(made).to_json()
    assert tsplan.check(made, tsplan.Plan.from_json(plan)).ok


# --- names of states ---

YARD = """\
format: tsplan-mission/1
map: {waiting: true, states: {dock: {labels: [home]}, gate: {}, east: {labels: [gate2]}},
  edges: [[dock, gate, 1], [gate, east, 1], [east, dock, 1]]}
team: [{class: r, count: 2, at: dock, capabilities: [see]}]
spec: {language: catl, formula: "F[0,4] T(1, gate, {(see, 2)})"}
"""


def test_a_state_stands_for_a_label_that_no_state_has(tmp_path):
    mission = mission_from_text(YARD)
    assert mission.system.labels["gate"] == ("gate",)
    plan = tsplan.plan(mission)
    assert plan.status == "optimal"
    assert tsplan.check(mission, plan).ok
    assert "gate" in str(plan.explain(mission))
    assert plan.requirements(mission)
    swarm = YARD.replace("team: [{class: r, count: 2", "swarm: {size: 2").replace(
        ", capabilities: [see]}]", "}"
    )
    swarm = swarm.replace("catl", "mtl").replace("T(1, gate, {(see, 2)})", "sum(gate) >= 2")
    assert tsplan.plan(mission_from_text(swarm)).status == "optimal"
    (tmp_path / "m.yaml").write_text(YARD.replace("F[0,4]", "F[0,0]"))
    assert main(["explain", str(tmp_path / "m.yaml"), "--json"]) == 0


def test_states_in_preferences_and_in_missions_from_python():
    text = (
        YARD.replace("formula: ", "prefer: [{formula: ").replace(")})", ")})").replace('"}', '"}]}')
    )
    assert tsplan.plan(mission_from_text(text)).preferences[0].met
    system = mission_from_text(YARD.replace("T(1, gate, {(see, 2)})", "home")).system
    assert "gate" not in system.labels
    mission = Mission.of(map=system, team=[Group.of("r", {"dock": 1})], formula="F[0,3] gate")
    assert mission.system.labels["gate"] == ("gate",)
    assert "gate" not in system.labels
    kept = Mission.of(map=system, team=[Group.of("r", {"dock": 1})], formula="F[0,3] home")
    assert kept.system is system


def test_a_label_comes_before_a_state_of_its_name_and_that_is_said():
    mission = mission_from_text(YARD.replace("gate2", "gate"))
    assert mission.system.labels["gate"] == ("east",)
    (warning,) = mission.warnings
    assert "'gate' is the label of east, and also the name of a state without it" in str(warning)
    own = YARD.replace("gate: {}", "gate: {labels: [gate]}").replace("gate2", "gate")
    assert not mission_from_text(own).warnings


def test_a_name_that_is_neither_is_told_with_the_closest_of_both():
    with pytest.raises(MissionError, match="has the label 'gat'; did you mean 'gate'"):
        mission_from_text(YARD.replace("1, gate", "1, gat"))


# --- the short form of a spec ---


@pytest.mark.parametrize("spec", ["F[0,4] home", "[home, 'F[0,4] home']", "|\n  F[0,4]\n  home"])
def test_a_formula_alone_is_a_spec(spec):
    head = YARD[: YARD.index("spec:")]
    mission = mission_from_text(f"{head}spec: {spec}\n")
    assert mission.language == "catl"
    assert tsplan.plan(mission).status == "optimal"


def test_mistakes_in_a_formula_alone_have_their_place():
    head = YARD[: YARD.index("spec:")]
    with pytest.raises(MissionError, match="m:5:14: no state of the map has the label 'hom'"):
        mission_from_text(f"{head}spec: F[0,4] hom\n", "m")
    with pytest.raises(MissionError, match=r"m:5:7: YAML takes '!' for a tag.*put the formula"):
        mission_from_text(f"{head}spec: ! home\n", "m")


def test_the_language_of_a_formula_alone_is_that_of_its_kind():
    head = YARD[: YARD.index("team:")]
    swarm = f"{head}swarm: {{size: 4, at: dock}}\nspec: F[0,4] sum(home) >= 50%\n"
    assert mission_from_text(swarm).language == "mtl"


def test_changes_to_a_formula_alone_are_written_in_its_place(tmp_path, capsys):
    head = YARD[: YARD.index("spec:")]
    (tmp_path / "m.yaml").write_text(f"{head}spec: 'F[0,0] sum(gate) >= 1'\n")
    out = str(tmp_path / "fixed.yaml")
    assert main(["explain", str(tmp_path / "m.yaml"), "--fix", "1", "-o", out, "--json"]) == 0
    assert "spec: " in (tmp_path / "fixed.yaml").read_text()
    assert tsplan.plan(load_mission(out)).status == "optimal"
