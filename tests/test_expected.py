"""Uncertain moves: expected numbers are planned, checked and simulated as they are meant.

Backward induction, an enumeration of all policies without chance, and the reference encoding judge.
"""

from __future__ import annotations

import random
from dataclasses import replace
from itertools import product
from pathlib import Path

import numpy as np
import pytest

import tsplan
from tests.seeds import sampled
from tests.slippery import (
    availability,
    grid_mission,
    most_likely,
    random_map,
    slippery_grid,
)
from tsplan.document import parse_document
from tsplan.errors import InputError, MapError, MissionError, PlanError
from tsplan.mission import Group, Mission, mission_from_text
from tsplan.plans.plan import Plan
from tsplan.plans.policies import Choice
from tsplan.plans.policy_table import policy_table
from tsplan.ts import Action, State, TransitionSystem
from tsplan.ts.io.map_files import map_from_document, map_text
from tsplan.ts.io.tsplan_yaml import map_to_yaml

TEN = "G[10,10] (sum(goal) >= 4) && G[8,9] (sum(side) >= 2)"
NEAR = {"abs": 1e-6}


@pytest.mark.parametrize("encoding", ["tight", "reference"])
def test_one_agent_comes_to_the_far_corner_as_likely_as_can_be(encoding):
    mission = grid_mission(5, 1, "G[10,10] (sum(goal) >= 0)")
    assert availability(mission, encoding=encoding) == pytest.approx(0.6777995264, abs=1e-8)


@pytest.mark.long
def test_chance_serves_two_places_better_than_one_choice_for_all():
    chancy = grid_mission(5, 10, TEN, horizon=12)
    firm = grid_mission(5, 10, TEN, horizon=12, policy="deterministic")
    assert availability(chancy) == pytest.approx(1.6039374, abs=1e-7)
    plan = tsplan.plan(firm, time_limit=60)
    assert plan.availability == pytest.approx(1.5700357, abs=1e-7)
    assert {choice.probability for policy in plan.policies for choice in policy.choices} == {1.0}


def test_where_nothing_is_asked_for_there_is_no_end_of_it():
    mission = grid_mission(3, 2, "true", horizon=2)
    plan = tsplan.plan(mission)
    assert (plan.status, plan.availability) == ("optimal", None)
    assert Plan.from_json(plan.to_json()).objective[0].value is None
    assert tsplan.plan(grid_mission(3, 2, "G[0,1] sum(goal) >= 1")).status == "infeasible"
    here = tsplan.plan(grid_mission(3, 2, "sum(goal) >= 0"))
    assert here.counts(states=["r0c0"]).tolist() == [[2.0]]


@pytest.mark.long
@pytest.mark.parametrize("formula", ["G[40,40] (sum(goal) >= 4)", "F[30,40] (sum(goal) >= 4)"])
def test_a_grid_of_a_hundred_and_forty_four_cells(formula):
    mission = grid_mission(12, 10, f"{formula} && G[18,20] (sum(side) >= 2)")
    assert availability(mission) == pytest.approx(5.9787951, abs=1e-5)


# --- judges ------------------------------------------------------------------------------------


def chance_mission(seed: int, formula: str, count: int = 1, **more: object) -> Mission:
    given = {"objective": ["availability"], "language": "mtl", **more}
    team = [Group.of("bot", {"s0": count})]
    return Mission.of(
        map=random_map(seed), team=team, formula=formula, dynamics="expected", **given
    )


@pytest.mark.parametrize("seed", sampled(range(400), range(20)))
def test_backward_induction_is_no_better(seed):
    horizon = 1 + seed % 6
    mission = chance_mission(seed, f"G[{horizon},{horizon}] (sum(A) >= 0)")
    system = mission.system
    best = most_likely(system, "s0", horizon, lambda state, _: state in system.labels["A"])
    found = availability(mission)
    # where agents have to be on the way at the end, nobody is anywhere
    assert found == pytest.approx(best, **NEAR)


@pytest.mark.parametrize("seed", sampled(range(60), range(8)))
def test_no_policy_without_chance_is_better(seed):
    draw = random.Random(seed)
    names = ["s0", "s1"]
    actions = []
    for name in names:
        for number in range(2):
            eighth = draw.randint(0, 8)
            outcomes = {"s0": eighth / 8, "s1": 1 - eighth / 8}
            actions.append(Action(name, f"a{number}", outcomes))
    states = [State("s0", frozenset("A")), State("s1", frozenset("B"))]
    system = TransitionSystem.build(states, [], actions=actions)
    mission = Mission.of(
        map=system,
        team=[Group.of("bot", {"s0": 2})],
        formula="G[1,1] sum(A) >= 0 && G[2,2] sum(B) >= 0 && F[1,3] sum(A) >= 0",
        language="mtl",
        objective=["availability"],
        dynamics="expected",
        policy="deterministic",
    )
    best = -np.inf
    nodes = [(name, step) for step in range(3) for name in names]
    for chosen in product(range(2), repeat=len(nodes)):
        policy = dict(zip(nodes, chosen, strict=True))
        at = [{"s0": 2.0, "s1": 0.0}]
        for step in range(3):
            after = {"s0": 0.0, "s1": 0.0}
            for name in names:
                action = system.actions[name, f"a{policy[name, step]}"]
                for target, chance in action.outcomes:
                    after[target] += at[-1][name] * chance
            at.append(after)
        best = max(best, min(at[1]["s0"], at[2]["s1"], max(a["s0"] for a in at[1:4])))
    assert availability(mission) == pytest.approx(best, **NEAR)


PARTS = (
    "F[{a},{b}] sum(A) >= {m}",
    "G[{a},{b}] sum(B) <= {m}",
    "(sum(A) >= 1 || sum(B) >= {m})",
    "F[{a},{b}] G[0,1] max(B) >= {m}",
    "G[0,{a}] F[0,2] sum(A) >= 1",
    "(sum(B) >= 0) U[{a},{b}] sum(A) >= {m}",
    "min(A) >= 0",
    "!(F[{a},{b}] sum(B) >= 3)",
)


@pytest.mark.parametrize("seed", sampled(range(600), range(8)))
def test_both_encodings_agree(seed):
    draw = random.Random(seed)
    parts = []
    for part in draw.sample(PARTS, draw.randint(1, 2)):
        low = draw.randint(0, 3)
        parts.append(part.format(a=low, b=low + draw.randint(0, 2), m=draw.randint(1, 2)))
    objective = draw.choice((["availability"], ["availability", "cost"], ["travel"]))
    policy = draw.choice((None, None, "deterministic"))
    mission = chance_mission(
        seed, " && ".join(f"({part})" for part in parts), 3, objective=objective, policy=policy
    )
    plans = [tsplan.plan(mission, time_limit=60, encoding=e) for e in ("tight", "reference")]
    statuses = [plan.status for plan in plans]
    assert statuses in (["optimal"] * 2, ["infeasible"] * 2)
    for one, other in zip(plans[0].objective, plans[1].objective, strict=True):
        assert one.value == pytest.approx(other.value, rel=1e-5, abs=1e-5)


# --- the check ---------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def planned() -> tuple[Mission, Plan]:
    mission = grid_mission(5, 10, TEN, horizon=12)
    return mission, tsplan.plan(mission)


def with_choices(plan: Plan, choices: list[Choice]) -> Plan:
    (policy,) = plan.policies
    return replace(plan, policies=(replace(policy, choices=tuple(choices)),))


def test_a_plan_is_read_as_it_is_written(planned):
    mission, plan = planned
    read = Plan.from_json(plan.to_json())
    assert read == plan
    assert tsplan.check(mission, read).ok
    assert plan.counts().sum(axis=0) == pytest.approx(10)
    assert plan.agents == ()


def test_forged_policies_are_refused(planned):
    mission, plan = planned
    choices = list(plan.policies[0].choices)
    first = choices[0]
    assert first[:3] == (0, "r0c0", "down")

    def words(forged: Plan) -> str:
        report = tsplan.check(mission, forged)
        assert not report.ok
        return "\n".join(finding.message for finding in report.findings)

    late = next(place for place, choice in enumerate(choices) if choice[:3] == (11, "r4c4", "left"))
    other = [*choices[:late], choices[late]._replace(action="up"), *choices[late + 1 :]]
    assert "expected at" in words(with_choices(plan, other))
    half = [first._replace(probability=0.5), *choices[1:]]
    assert "with probability 0.5 in all" in words(with_choices(plan, half))
    strange = [first._replace(action="fly"), *choices[1:]]
    assert "which is no action there" in words(with_choices(plan, strange))
    assert "has no action at r0c0 at step 0" in words(with_choices(plan, choices[1:]))
    assert "has no policy" in words(
        replace(plan, policies=(replace(plan.policies[0], class_name="x"),))
    )
    assert "claims availability" in words(replace(plan, availability=plan.availability + 0.1))
    better = replace(plan.objective[0], value=2.0, bound=2.0)
    assert "claims availability" in words(replace(plan, objective=(better,)))
    rosy = dict(plan.policies[0].expected)
    rosy["r4c4"] = (*rosy["r4c4"][:-1], 9.0)
    assert "said to be expected" in words(
        replace(plan, policies=(replace(plan.policies[0], expected=rosy),))
    )


def test_chance_is_refused_where_there_may_be_none(planned):
    _, plan = planned
    firm = grid_mission(5, 10, TEN, horizon=12, policy="deterministic")
    report = tsplan.check(firm, plan)
    assert any("leaves it to chance" in finding.message for finding in report.findings)


def test_a_formula_that_does_not_hold_is_refused(planned):
    _, plan = planned
    more = grid_mission(5, 10, TEN.replace(">= 4", ">= 7"), horizon=12)
    report = tsplan.check(more, plan)
    assert any("the formula does not hold" in finding.message for finding in report.findings)


# --- what follows ------------------------------------------------------------------------------


def test_agents_are_expected_where_they_come_by_chance(planned):
    mission, plan = planned
    found = plan.simulate(mission, runs=4000, seed=1)
    assert found == plan.simulate(mission, runs=4000, seed=1)
    assert 0.7 < found.formula.rate < 0.9
    assert found.stray_mean < 0.6


def test_head_room_makes_success_likely():
    formula = "G[10,10] (sum(goal) >= 12) && G[8,9] (sum(side) >= 5)"
    plain = grid_mission(5, 40, formula, horizon=10)
    margin = tsplan.margin_for(plain, 0.9)
    mission = grid_mission(5, 40, formula, horizon=10, margin=margin)
    plan = tsplan.plan(mission)
    assert plan.status == "optimal"
    assert plan.availability >= margin
    assert plan.simulate(mission, runs=500).formula.rate >= 0.9


def test_a_summary_says_what_is_done_where(planned):
    table, *_ = policy_table(planned[1])
    actions = list(table.columns[4].cells)
    assert any("%" in cell.plain for cell in actions)
    assert next(iter(table.columns[2].cells)).plain == "r0c0"


def test_the_policy_is_drawn(planned):
    mission, plan = planned
    figure, axes = plan.plot(mission)
    drawn = {artist.get_gid() for artist in axes.get_children()}
    assert {"policy", "heads"} <= drawn
    plan.plot(mission, view="requirements")
    with pytest.raises(InputError, match="no timeline"):
        plan.plot(mission, view="timeline")
    assert figure is not None


# --- files and findings ------------------------------------------------------------------------

MAP = """\
states: {q1: {}, q2: {labels: [goal]}}
actions:
  q1:
    go: {q2: 0.9, q1: 0.1}
    wait: {q1: 1}
  q2: {wait: {to: {q2: 1.0}, duration: 2, cost: 0.5}}
"""
MISSION = """\
format: tsplan-mission/1
map:
%s
team: [{class: cart, count: 2, at: q1}]
spec: {language: mtl, formula: "F[0,3] sum(goal) >= 1"}
objective: [%s]
dynamics: %s
"""


def text(objective: str = "availability", dynamics: str = "expected", map_text: str = MAP) -> str:
    inside = "".join(f"  {line}\n" for line in map_text.splitlines()).rstrip()
    return MISSION % (inside, objective, dynamics)


def read_map(content: str) -> TransitionSystem:
    return map_from_document(parse_document(content, "map.yaml"))


def test_maps_and_missions_are_written_as_they_are_read():
    system = read_map(MAP)
    assert system.actions["q2", "wait"] == Action("q2", "wait", {"q2": 1.0}, 2, 0.5)
    assert set(system.edges) == {("q1", "q2"), ("q1", "q1"), ("q2", "q2")}
    assert read_map(map_to_yaml(system)) == system
    mission = mission_from_text(text())
    assert mission_from_text(mission.to_yaml()) == mission
    firm = mission_from_text(text() + "policy: deterministic\nmargin: 50%\n")
    assert firm.expected.deterministic
    assert mission_from_text(firm.to_yaml()) == firm
    grid = slippery_grid(3)
    assert read_map(map_to_yaml(grid)) == grid


def test_the_example_of_the_page_is_planned():
    page = (Path(__file__).parents[1] / "docs" / "uncertain.md").read_text(encoding="utf-8")
    mission = mission_from_text(page.split("```yaml\n")[1].split("```")[0])
    plan = tsplan.plan(mission)
    assert plan.status == "optimal"
    assert 0 < plan.availability < 6
    assert mission_from_text(mission.to_yaml()) == mission


def test_waits_are_added_where_nobody_can_stay():
    system = read_map("waiting: true\n" + MAP.replace("    wait: {q1: 1}\n", ""))
    assert system.actions["q1", "wait"].is_wait
    assert len(system.actions) == 3


LOMAP = """\
!Ts
name: mdp
graph:
  nodes: {a: {prop: !!set {x: null}}, b: {}}
  edges:
  - [a, b, {weight: 2, control: go, prob: 0.75}]
  - [a, a, {weight: 2, control: go, prob: 0.25}]
  - [b, b, {weight: 1, control: rest, prob: 1}]
"""


def test_maps_of_lomap_have_controls_and_probabilities():
    system = read_map(LOMAP)
    assert system.actions["a", "go"] == Action("a", "go", {"b": 0.75, "a": 0.25}, 2)
    assert read_map(map_text(system)) == system
    wrong = LOMAP.replace("weight: 2, control: go, prob: 0.25", "weight: 1, control: go, prob: 0.2")
    with pytest.raises(MapError, match="another weight"):
        read_map(wrong)


@pytest.mark.parametrize(
    ("given", "wanted", "words"),
    [
        ("q1: 0.1}", "q1: 0.3}", "map.yaml:4:5: the probabilities of 'go' at 'q1' add up to 1.2"),
        ("go: {q2", "go: {q3", "map.yaml:4:10: 'go' at 'q1' leads to 'q3', which is no state"),
        ("q2: 0.9", "q2: 1.9", "map.yaml:4:10: 'go' at 'q1' leads to 'q2' with 1.9"),
        ("  q2: {wait", "  q9: {wait", "no state is called 'q9'"),
        ("duration: 2", "duration: 0", "map.yaml:6:30: 'wait' at 'q2' takes 0 steps"),
        ("cost: 0.5", "cost: -1", "map.yaml:6:43: 'wait' at 'q2' costs -1"),
        ("cost: 0.5", "price: 1", "map.yaml:6:43: an action has no 'price'"),
        ("actions:", "edges: [[q1, q2, 1]]\nactions:", "the map has edges beside its actions"),
        ("  q2: {wait: {to: {q2: 1.0}, duration: 2, cost: 0.5}}\n", "", "which has no action"),
    ],
)
def test_maps_that_are_wrong_are_refused_at_their_place(given, wanted, words):
    assert given in MAP
    with pytest.raises(MapError) as caught:
        read_map(MAP.replace(given, wanted))
    assert words in str(caught.value)


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (text("makespan"), "11:13: objective 'makespan' has no expected value"),
        (text(dynamics="certain"), "the outcomes of the map's actions are uncertain"),
        (text(map_text="states: {q1: {}}\nedges: [[q1, q1, 1]]\n"), "the map has no actions"),
        (text(dynamics="certain") + "policy: deterministic\n", "'policy' is about uncertain"),
        (text(map_text=MAP.replace("q1: {}", "q1: {capacity: 1}")), "'q1' has a capacity"),
        (
            text().replace("formula:", "must:").replace('1"}', '1", prefer: [{formula: goal}]}'),
            "preferences",
        ),
    ],
)
def test_missions_that_do_not_fit_are_refused(content, words):
    with pytest.raises(MissionError) as caught:
        mission_from_text(content)
    assert words in str(caught.value)


def test_what_needs_whole_agents_is_refused_in_words(planned):
    mission, _ = planned
    problem = tsplan.Problem(mission)
    with pytest.raises(MissionError, match="expected"):
        problem.add(problem.count("goal", step=3) >= 1)
    with pytest.raises(MissionError, match="expected"):
        tsplan.explain(mission)
    team = mission_from_text(
        text(
            dynamics="certain",
            map_text="waiting: true\nstates: {q1: {}, q2: {labels: [goal]}}\n"
            "edges: [[q1, q2, 1]]\n",
        ).replace("[availability]", "[travel]")
    )
    with pytest.raises(PlanError, match="can be simulated"):
        tsplan.plan(team).simulate(team)


def test_classes_with_needs_keep_to_where_they_may_be():
    states = [State("a"), State("b", frozenset({"goal"}), needs=frozenset({"swim"}))]
    actions = [
        Action("a", "dive", {"b": 0.5, "a": 0.5}),
        Action("a", "wait", {"a": 1}),
        Action("b", "wait", {"b": 1}),
    ]
    system = TransitionSystem.build(states, [], actions=actions)
    team = [Group.of("duck", {"a": 1}, ["swim"]), Group.of("hen", {"a": 1})]
    mission = Mission.of(
        map=system,
        team=team,
        formula="G[2,2] sum(goal) >= 0",
        language="mtl",
        objective=["availability"],
        dynamics="expected",
    )
    plan = tsplan.plan(mission)
    assert plan.availability == pytest.approx(0.75, **NEAR)
    assert [policy.class_name for policy in plan.policies] == ["duck", "hen"]
    assert plan.counts("swim", states=["b"])[0, 2] == pytest.approx(0.75, **NEAR)
