"""Missions that may hold in part, must and prefer: read, planned, written, judged and shown."""

from __future__ import annotations

import json
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import pytest

import tsplan
from tests.missions import findings
from tsplan.checking.plan_check import certify, check
from tsplan.cli import main
from tsplan.errors import MissionError, PlanError, SolverError
from tsplan.explanation import explain
from tsplan.logic import parse
from tsplan.mission import Group, Mission, Preference, mission_from_text
from tsplan.plans.plan import Plan
from tsplan.plans.plan_file import load_plan
from tsplan.plans.satisfaction import Depth
from tsplan.plans.summary import satisfaction_lines
from tsplan.ts import Edge, State, TransitionSystem

TEXT = """\
format: tsplan-mission/1
name: wishes
map:
  waiting: true
  states: {p: {labels: [A]}, q: {labels: [B]}, r: {labels: [C]}}
  edges:
    - {from: p, to: q, duration: 1, both_ways: true}
    - {from: q, to: r, duration: 2, both_ways: true}
team:
  - {class: a, count: 2, at: p, capabilities: [see]}
spec:
  language: mtl
  must: F[0,4] C
  prefer:
    - {name: stay, formula: "G[0,4] sum(A) >= 1", weight: 2}
    - {name: both, formula: "F[0,4] sum(C) >= 2", weight: 3, level: 1}
    - {formula: "G[0,4] sum(B) >= 1", weight: 0.5, partial: true}
objective: [travel]
"""
START = TEXT[: TEXT.index("spec:")]


def partial(formula: str, order: str = "weighted", rest: str = "travel") -> str:
    spec = f"spec: {{language: mtl, formula: '{formula}'}}\n"
    return f"{START}{spec}objective: [{{satisfaction: {order}}}, {rest}]\n"


FAR = "G[0,4] A && G[2,4] sum(A) >= 2 && F[0,4] sum(C) >= 2"


def wrong(text):
    return findings(mission_from_text, text, "m")


def test_must_and_prefer_are_read():
    mission = mission_from_text(TEXT)
    assert mission.formula is parse("F[0,4] C")
    assert mission.objective == ("preferences", "travel")
    stay, both, time_at_b = mission.prefer
    assert (stay.name, stay.weight, stay.level, stay.partial) == ("stay", 2, 0, False)
    assert (both.weight, both.level) == (3, 1)
    assert (time_at_b.name, time_at_b.weight) == ("G[0,4] sum(B) >= 1", Fraction(1, 2))
    assert time_at_b.partial
    assert not mission.partial
    assert mission.horizon == 4


def test_the_horizon_reaches_every_formula():
    mission = mission_from_text(TEXT.replace("G[0,4] sum(A)", "G[0,9] sum(A)"))
    assert mission.horizon == 9


def test_prefer_alone_demands_nothing():
    mission = mission_from_text(TEXT.replace("  must: F[0,4] C\n", ""))
    assert str(mission.formula) == "true"


@pytest.mark.parametrize("order", ["weighted", "hierarchical", "depth"])
def test_orders_are_read(order):
    mission = mission_from_text(partial("F[0,4] C", order))
    assert mission.objective == ("satisfaction", "travel")
    assert mission.satisfaction == order
    assert mission.partial
    assert mission_from_text(
        partial("F[0,4] C").replace("{satisfaction: weighted}", "satisfaction")
    )


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("must: F[0,4] C", "must: F[0,4] D", ["m:13:16:", "label 'D'"]),
        ('sum(A) >= 1"', 'sum(D) >= 1"', ["m:15:41:", "label 'D'"]),
        ('"G[0,4] sum(B) >= 1"', '"G[0,4 sum(B) >= 1"', ["m:17:"]),
        ("weight: 2", "weight: 0", ["m:15:", "at least 1e-09"]),
        ("weight: 2", "weigth: 2", ["unknown key 'weigth'", "'weight'"]),
        ("level: 1", "level: -1", ["at least 0"]),
        ("partial: true", "partial: 1", ["true or false"]),
        ("name: both", "name: stay", ["m:16:14:", "two preferences are called 'stay'"]),
        ("must: F[0,4] C", "must: F[0,4] C\n  formula: A", ["m:13:9:", "'formula' and as 'must'"]),
        ('formula: "F[0,4] sum(C) >= 2", ', "", ["'formula' is missing"]),
        ("[travel]", "[travel, preferences]", ["m:18:21:", "name it first"]),
        ("[travel]", "[{satisfaction: weighted}]", ["m:18:13:", "'partial: true'"]),
        ("[travel]", "[{satisfaction: heavy}]", ["m:18:13:", "no order of satisfaction"]),
        ("[travel]", "[{travel: 1}]", ["m:18:13:", "{satisfaction: weighted}"]),
        ("objective: [travel]", "horizon: 3", ["m:18:10:", "shorter than the formula's, 4"]),
    ],
)
def test_mistakes_are_found_at_their_places(old, new, words):
    assert old in TEXT
    found = "\n".join(wrong(TEXT.replace(old, new, 1)))
    for word in words:
        assert word in found


def test_objectives_out_of_place():
    text = partial("F[0,4] C").replace(
        "[{satisfaction: weighted}, travel]", "[travel, satisfaction]"
    )
    assert "name it first" in wrong(text)[0]
    text = partial("F[0,4] C").replace("{satisfaction: weighted}", "preferences")
    assert "none are there" in wrong(text)[0]
    assert "'formula' is missing" in wrong(START + "spec: {language: mtl}\n")[0]


SYSTEM = TransitionSystem.build(
    [State("p", frozenset({"A"})), State("q", frozenset({"B"}))],
    [Edge("p", "p"), Edge("q", "q"), Edge("p", "q", 2), Edge("q", "p", 2)],
)


def test_missions_are_built_in_python():
    wish = Preference(parse("G[0,3] A"), "G[0,3] A", Fraction(3, 2), "home", 1, partial=True)
    mission = Mission.of(
        map=SYSTEM,
        team=[Group.of("a", {"p": 1})],
        must="F[0,3] B",
        prefer=[wish, {"formula": "F[0,5] A"}],
        language="mtl",
        objective=[],
    )
    assert mission.prefer[0] == wish
    assert mission.prefer[1].weight == 1
    assert (mission.horizon, mission.objective) == (5, ("preferences",))
    plan = tsplan.plan(mission)
    assert plan.status == "optimal"
    # home at step 0 of 0..3 for sure, and at 1 if it leaves as late as it can
    assert [item.fraction for item in plan.preferences] == [Fraction(1, 2), 1]
    partly = Mission.of(
        map=SYSTEM,
        team=[Group.of("a", {"p": 1})],
        formula="A && B",
        language="mtl",
        objective=[{"satisfaction": "depth"}],
    )
    assert tsplan.plan(partly).satisfaction.fraction == Fraction(1, 2)


def test_a_feasible_mission_is_satisfied_wholly():
    for order in ("weighted", "hierarchical", "depth"):
        mission = mission_from_text(partial("F[0,4] C && G[0,4] A", order))
        plan = tsplan.plan(mission)
        assert (plan.status, plan.satisfaction.fraction) == ("optimal", 1)
        assert [(o.name, o.value, o.bound) for o in plan.objective] == [
            ("satisfaction", 1, 1),
            ("travel", 3, 3),
        ]
        assert plan.availability == 0
        assert plan.satisfaction.availability == 0


def test_what_holds_is_told_with_when():
    plan = tsplan.plan(mission_from_text(partial(FAR)))
    assert plan.status == "optimal"
    # G A and G two at A by staying, against two at C from step 3 on: 2/3 by staying
    assert plan.satisfaction.fraction == Fraction(2, 3)
    told = {node.text: (node.met, *node.steps) for node in plan.satisfaction.nodes}
    assert told["G[0,4] A"] == (True, 0, 4)
    assert told["G[2,4] (sum(A) >= 2)"] == (True, 2, 4)
    assert not told["F[0,4] (sum(C) >= 2)"][0]
    assert plan.availability < 0
    assert plan.satisfaction.availability == 0
    lines = satisfaction_lines(plan)
    assert lines[0] == "  satisfied: 2/3 (weighted)"
    assert any("not met: F[0,4] (sum(C) >= 2)" in line for line in lines)


def test_the_availability_of_what_is_satisfied_can_be_an_objective():
    plan = tsplan.plan(mission_from_text(partial(FAR, rest="availability, travel")))
    assert [(o.name, o.value) for o in plan.objective][1:] == [("availability", 0), ("travel", 0)]
    assert check(mission_from_text(partial(FAR, rest="availability, travel")), plan).ok


def test_the_reference_encoding_plans_what_was_settled():
    for text in (TEXT, partial(FAR), partial("F[0,4] C && G[0,4] A")):
        mission = mission_from_text(text)
        plan = tsplan.plan(mission, encoding="reference")
        assert plan.status == "optimal"
        assert plan.objective[0] == tsplan.plan(mission).objective[0]


def test_depths_are_counted():
    plan = tsplan.plan(mission_from_text(partial(FAR, "hierarchical")))
    assert plan.satisfaction.depths == (Depth(0, 0, 0), Depth(1, 2, 2), Depth(2, 0, 0))
    assert any("2 at depth 1" in line for line in satisfaction_lines(plan))


def test_preferences_go_by_level_first():
    plan = tsplan.plan(mission_from_text(TEXT))
    stay, both, at_b = plan.preferences
    assert not stay.met
    assert both.met
    assert at_b.fraction == Fraction(2, 5)  # one agent may follow the other a step or two later
    assert plan.objective[0].value == pytest.approx(3 + 0.2)
    assert plan.objective[0].bound == pytest.approx(3 + 0.2)
    assert any(
        line.startswith("  both: met (weight 3, level 1)") for line in satisfaction_lines(plan)
    )


def test_what_must_hold_can_be_impossible():
    plan = tsplan.plan(mission_from_text(TEXT.replace("F[0,4] C", "F[0,2] C")))
    assert plan.status == "infeasible"
    assert (plan.satisfaction, plan.preferences) == (None, ())


@pytest.mark.parametrize("text", [TEXT, partial(FAR), partial(FAR, "hierarchical")])
def test_plans_are_written_and_read_again(text):
    mission = mission_from_text(text)
    plan = tsplan.plan(mission)
    copy = Plan.from_json(plan.to_json())
    assert copy.satisfaction == plan.satisfaction
    assert copy.preferences == plan.preferences
    assert check(mission, copy).ok
    assert copy.to_json() == plan.to_json()


def test_faulty_plan_files():
    data = json.loads(tsplan.plan(mission_from_text(partial(FAR))).to_json())
    for key, value, words in [
        ("exact", "3/2", "not between 0 and 1"),
        ("exact", "1/0", "exact"),
        ("exact", "1/2", "is not 1/2"),
        ("order", "odd", "order"),
    ]:
        changed = {**data, "satisfaction": {**data["satisfaction"], key: value}}
        with pytest.raises(PlanError, match=words):
            Plan.from_json(json.dumps(changed))


def refused(mission: Mission, plan: Plan, words: str) -> None:
    report = check(mission, plan)
    assert any(words in str(finding) for finding in report.findings), report.findings


def test_false_claims_are_refused():
    mission = mission_from_text(partial(FAR))
    plan = tsplan.plan(mission)
    made = plan.satisfaction
    assert check(mission, plan).ok
    refused(mission, replace(plan, satisfaction=None), "says nothing")
    for change, words in [
        ({"fraction": Fraction(1)}, "claims satisfaction 1 and has 2/3"),
        ({"availability": 3}, "claims availability 3"),
        ({"order": "depth"}, "claims the order depth"),
        ({"nodes": made.nodes[:-1]}, "each part"),
    ]:
        refused(mission, replace(plan, satisfaction=replace(made, **change)), words)
    better = replace(plan.objective[0], value=1.0, bound=1.0)
    refused(mission, replace(plan, objective=(better, plan.objective[1])), "satisfaction 1.0")
    with pytest.raises(SolverError, match="satisfaction"):
        certify(mission, replace(plan, objective=(better, plan.objective[1])))
    by_depth = mission_from_text(partial(FAR, "hierarchical"))
    plan = tsplan.plan(by_depth)
    for depths, words in [
        ((Depth(0, 1, 1), Depth(1, 0, 0), Depth(2, 0, 0)), "by depth 0, 2, 0"),
        ((Depth(0, 0, 0), Depth(1, 2, 1), Depth(2, 0, 0)), "more than their bound"),
        ((Depth(0, 0, 0), Depth(1, 2, 3), Depth(2, 0, 0)), "called optimal"),
    ]:
        changed = replace(plan, satisfaction=replace(plan.satisfaction, depths=depths))
        refused(by_depth, changed, words)


def test_false_preferences_are_refused():
    mission = mission_from_text(TEXT)
    plan = tsplan.plan(mission)
    first = replace(plan.preferences[0], fraction=Fraction(1))
    refused(mission, replace(plan, preferences=(first, *plan.preferences[1:])), "'stay' is not so")
    refused(mission, replace(plan, preferences=()), "not the mission's")
    refused(replace(mission, formula=parse("G[0,4] C")), plan, "does not hold")


def test_a_formula_too_large_for_its_depths_is_refused():
    deep = "A"
    for _ in range(18):
        deep = f"({deep}) <=> B"
    mission = mission_from_text(partial(f"({deep}) && F[0,4] sum(C) >= 9", "hierarchical"))
    with pytest.raises(MissionError, match="weighted"):
        tsplan.plan(mission)


def test_a_formula_whose_tree_is_vast_is_told_in_part():
    deep = "A"
    for _ in range(10):
        deep = f"({deep}) <=> B"
    mission = mission_from_text(partial(f"({deep}) && F[0,4] sum(C) >= 9"))
    plan = tsplan.plan(mission)
    assert plan.satisfaction.fraction == Fraction(1, 2)
    assert len(plan.satisfaction.nodes) == 5000
    assert check(mission, Plan.from_json(plan.to_json())).ok


def test_explanations_speak_about_what_must_hold():
    wished = mission_from_text(TEXT)
    assert explain(wished).status == "feasible"
    impossible = mission_from_text(TEXT.replace("F[0,4] C", "F[0,2] C"))
    made = explain(impossible)
    assert [part.text for conflict in made.conflicts for part in conflict.parts] == [
        "F[0,2] C",
        "the agents of class a start at 'p'",
    ]
    assert {change.mission.prefer for change in made.changes} == {impossible.prefer}
    assert {change.mission.objective for change in made.changes} == {impossible.objective}
    assert all(tsplan.plan(change.mission).has_paths for change in made.changes)


def test_a_formula_that_holds_in_part_is_explained_as_a_whole():
    mission = mission_from_text(partial(FAR))
    made = explain(mission)
    assert made.status == "explained"
    assert made.conflicts
    assert all(change.mission.partial for change in made.changes)
    shares = [tsplan.plan(change.mission).satisfaction.fraction for change in made.changes]
    assert set(shares) == {1}


def test_an_interrupted_search_keeps_true_bounds():
    mission = mission_from_text(partial(FAR))
    stopped = tsplan.plan(mission, on_event=lambda _: True)
    if stopped.satisfaction is not None:
        assert stopped.satisfaction.fraction <= Fraction(2, 3)
    if stopped.status == "optimal":  # what was begun may end with the proof
        assert stopped.satisfaction.fraction == Fraction(2, 3)
    else:
        assert stopped.status in ("no_plan_found", "feasible")
        assert stopped.stopped_by == "interrupt"


def test_the_command_line(tmp_path, capsys):
    place, made = tmp_path / "m.yaml", tmp_path / "plan.json"
    place.write_text(TEXT)
    assert main(["plan", str(place), "-o", str(made)]) == 0
    said = capsys.readouterr().out
    assert "both: met (weight 3, level 1)" in said
    assert "stay: " in said
    assert main(["check", str(place), str(made)]) == 0
    assert "preference 'both' is met" in capsys.readouterr().out
    place.write_text(partial(FAR))
    assert main(["plan", str(place), "-o", str(made), "--quiet"]) == 0
    assert main(["check", str(place), str(made)]) == 0
    assert "holds in part, with satisfaction 2/3" in capsys.readouterr().out
    made.write_text(made.read_text().replace('"exact": "2/3"', '"exact": "2/3 "'))
    assert main(["check", str(place), str(made)]) == 2


FALSE = """\
format: tsplan-mission/1
map: {waiting: true, states: {p: {labels: [A]}, q: {labels: [B]}}, edges: [[p, q, 1], [q, p, 1]]}
team: [{class: a, count: 2, at: p}]
spec: {language: mtl, formula: "false"}
objective: [{satisfaction: weighted}, availability]
"""


def test_what_is_plainly_false_has_no_robots_to_spare(tmp_path, capsys):
    mission_file, plan_file = str(tmp_path / "mission.yaml"), str(tmp_path / "plan.json")
    Path(mission_file).write_text(FALSE)
    assert main(["plan", mission_file, "-o", plan_file]) == 0
    assert main(["check", mission_file, plan_file]) == 0
    assert main(["show", plan_file, "--why"]) == 0
    assert main(["view", plan_file, "-o", str(tmp_path / "page.html")]) == 0
    seen = capsys.readouterr()
    assert "availability open" in seen.out
    assert "availability is open" in seen.out
    page = (tmp_path / "page.html").read_text(encoding="utf-8")
    notebook = load_plan(plan_file)._repr_html_()
    assert "unbounded" not in seen.out + seen.err + page + notebook
