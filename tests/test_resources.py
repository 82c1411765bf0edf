"""Resources: what missions and plans say of them, what is refused, and what executions pay."""

from __future__ import annotations

from dataclasses import replace
from math import inf

import pytest

import tsplan
from tests.resource_missions import SENSE, random_resource_mission
from tests.seeds import seed_blocks
from tsplan import Group, Mission, logic
from tsplan.checking.plan_check import check
from tsplan.encode.assemble import tight
from tsplan.encode.model_objectives import model_objective
from tsplan.encode.preparation import prepare
from tsplan.encode.still_flows import needed, still_model
from tsplan.errors import MissionError
from tsplan.milp.solution import Options
from tsplan.milp.solver import solver
from tsplan.mission import Resource, mission_from_text
from tsplan.plans.supplies import Cargo, ExecutedTask
from tsplan.search import stages
from tsplan.search.straight_plans import StraightPlans

TEXT = """\
format: tsplan-mission/1
map:
  waiting: true
  states: {yard: {}, road: {}, wall: {labels: [site]}, tower: {labels: [site]}}
  edges: [{from: yard, to: road, duration: 1, both_ways: true},
    {from: road, to: wall, duration: 1, both_ways: true},
    {from: road, to: tower, duration: 2, both_ways: true}]
resources:
  - {name: brick, at: {yard: 6}, indivisible: true}
  - {name: water, at: {yard: 2.5}}
  - {name: drill, at: {yard: 1}, indivisible: true, consumed: false}
team:
  - {class: man, count: 2, at: yard, capabilities: [lay], carries: {brick: 1, water: 0.5, drill: 1}}
  - {class: truck, at: yard, carries: 4}
spec:
  language: catl
  formula: 'FORMULA'
objective: [haulage, travel]
horizon: 8
"""
ONCE = "F[0,4] T(1, wall, {(lay, 1)}, {(brick, 2)})"


def mission(formula: str, *changes: tuple[str, str]) -> Mission:
    text = TEXT
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    return mission_from_text(text.replace("FORMULA", formula))


def values(plan: tsplan.Plan) -> dict[str, float | None]:
    return {item.name: item.value for item in plan.objective}


# --- what executions pay -----------------------------------------------------------------------


@pytest.mark.parametrize("encoding", ["tight", "reference"])
@pytest.mark.parametrize(
    ("formula", "haulage", "executed"),
    [
        (ONCE, 4, 1),
        ("G[3,4] T(1, wall, {(lay, 1)}, {(brick, 2)})", 8, 2),
        ("F[0,6] T(1, site, {(lay, 1)}, {(brick, 1)})", 5, 2),  # both sites at one step
        ("F[0,4] T(1, wall, {(lay, 1)}, {(brick, 1), (brick, 1)})", 4, 1),
        (f"{ONCE} && {ONCE}", 4, 1),  # one formula, whichever way it is asked for
        ("F[0,4] T(1, wall, {(lay, 1)}, {(water, 0.75)})", 1.5, 1),
        ("F[0,2] T(0, wall, {}, {(drill, 1)}) && F[4,6] T(0, tower, {}, {(drill, 1)})", 5, 2),
    ],
)
def test_what_is_executed_is_paid(encoding, formula, haulage, executed):
    made = mission(formula)
    plan = tsplan.plan(made, encoding=encoding)
    assert plan.status == "optimal"
    assert values(plan)["haulage"] == haulage
    assert len(plan.executions) == executed
    assert tsplan.Plan.from_json(plan.to_json()) == plan
    assert check(made, plan).ok


@pytest.mark.parametrize("encoding", ["tight", "reference"])
@pytest.mark.parametrize(
    "formula",
    [
        "G[2,5] T(1, wall, {(lay, 1)}, {(brick, 2)})",  # eight of six
        "G[3,4] T(1, wall, {}, {(drill, 1)})",  # in use at step 4 twice
        "F[0,1] T(0, wall, {}, {(drill, 1)})",  # too far
        "F[0,6] T(0, site, {}, {(drill, 1)})",  # at both sites
    ],
)
def test_more_than_there_is_cannot_be(encoding, formula):
    assert tsplan.plan(mission(formula), encoding=encoding).status == "infeasible"


def test_a_tool_serves_one_execution_after_the_other():
    first, second = (
        "F[0,3] T(1, wall, {}, {(drill, 1)})",
        "G[5,5] T(1, wall, {(lay,1)}, {(drill, 1)})",
    )
    plan = tsplan.plan(mission(f"{first} && {second}"))
    assert plan.status == "optimal"
    assert values(plan)["haulage"] == 2


def test_stocks_are_told_over_time():
    plan = tsplan.plan(mission(ONCE))
    stock = {(item.resource, item.state): item for item in plan.stocks}
    (execution,) = plan.executions
    wall = stock["brick", "wall"]
    assert wall.at(execution.step) == 2
    assert wall.at(execution.step + 1) == 0
    assert stock["brick", "yard"].at(0) == 6
    assert stock["brick", "yard"].at(8) == 4


def test_reserve_is_what_is_left_at_the_tightest_execution():
    plan = tsplan.plan(mission(ONCE, ("[haulage, travel]", "[reserve, haulage]")))
    assert plan.status == "optimal"
    assert values(plan)["reserve"] == 4  # all six are at the wall
    none = tsplan.plan(mission("true", ("[haulage, travel]", "[reserve, haulage]")))
    assert none.status == "optimal"
    assert values(none) == {"reserve": None, "haulage": 0}


def test_half_a_piece_of_room_carries_nothing_of_it():
    formula = "F[0,2] T(0, wall, {}, {(brick, 5)})"
    for room, status in (("2.5", "infeasible"), ("3.0", "optimal")):
        trucks = ("at: yard, carries: 4", f"count: 2, at: yard, carries: {room}")
        made = mission(formula, trucks, ("{brick: 1, w", "{brick: 0, w"))
        assert tsplan.plan(made).status == status


def test_what_is_preferred_may_be_elsewhere():
    wish = "prefer: [{formula: 'F[2,2] sum(yard) >= 2'}]"
    text = TEXT.replace("formula: 'FORMULA'", f"must: '{ONCE}'\n  {wish}")
    plan = tsplan.plan(mission_from_text(text))
    assert plan.status == "optimal"
    assert values(plan) == {"preferences": 1, "haulage": 4, "travel": 4}


def test_robots_that_start_elsewhere_in_an_explanation_carry_what_they_can():
    made = mission(
        "F[0,2] T(0, wall, {}, {(brick, 2)})",
        ("{class: truck, at: yard", "{class: truck, at: tower"),
        ("{brick: 1, water: 0.5, drill: 1}", "{drill: 1}"),
    )
    explained = tsplan.explain(made)
    kinds = [part.kind for conflict in explained.conflicts for part in conflict.parts]
    assert "start" in kinds  # from the yard it could be done
    added = next(change for change in explained.changes if change.kind == "add_agents")
    assert added.proven
    assert added.mission.team[-1].carries == 4


def test_carriers_that_cannot_wait_may_be_on_their_way_at_the_end():
    formula = "F[0,4] T(0, wall, {}, {(brick, 2)})"
    made = mission(
        formula,
        ("waiting: true", "waiting: false"),
        ("duration: 1, both", "duration: 2, both"),
        ("horizon: 8", "horizon: 5"),
    )
    plan = tsplan.plan(made)
    assert plan.status == "optimal"
    assert plan.objective == tsplan.plan(made, encoding="reference").objective


# --- missions ----------------------------------------------------------------------------------


def test_a_mission_is_written_and_made_as_it_is_read():
    made = mission(ONCE)
    assert mission_from_text(made.to_yaml()) == made
    assert made.resources[2] == Resource.of("drill", {"yard": 1}, indivisible=True, consumed=False)
    tool = {"name": "drill", "at": {"yard": 1}, "indivisible": True, "consumed": False}
    again = Mission.of(
        map=made.system,
        team=[
            Group.of("man", {"yard": 2}, ["lay"], {"brick": 1, "water": 0.5, "drill": 1}),
            {"class": "truck", "at": "yard", "carries": 4},
        ],
        resources=[*made.resources[:2], tool],
        formula=ONCE,
        objective=["haulage", "travel"],
        horizon=8,
    )
    assert again == made


@pytest.mark.parametrize(
    ("change", "place", "words"),
    [
        (("(brick, 2)", "(bick, 2)"), "17:45", "there is no resource 'bick'; did you mean 'brick'"),
        (("(brick, 2)", "(brick, 1.5)"), "17:52", "comes in whole pieces, and 1.5 is no whole"),
        (("{yard: 6}", "{yard: 1.5}"), "9:30", "comes in whole pieces"),
        (("{yard: 6}", "{yrd: 6}"), "9:29", "the map has no state 'yrd'"),
        (("{yard: 6}", "{yard: -1}"), "9:30", "0"),
        (("name: water", "name: brick"), "10:12", "two resources are called 'brick'"),
        (("{brick: 1, w", "{brik: 1, w"), "13:75", "there is no resource 'brik'"),
        (("{brick: 1, w", "{brick: 0.5, w"), "13:76", "less than one piece"),
        (("carries: 4", "carries: -4"), "14:39", "below 0"),
        (("carries: 4", "carries: much"), "14:39", "not a finite number"),
        (("F[0,4]", "! F[0,4]"), "17:22", "under a negation"),
        (("F[0,4]", "wall <=> F[0,4]"), "17:29", "under a negation"),
        (("[haulage, travel]", "[{satisfaction: weighted}]"), "17:20", "holds in part"),
    ],
)
def test_bad_input_has_its_place(change, place, words):
    with pytest.raises(MissionError) as caught:
        mission_from_text(TEXT.replace("FORMULA", ONCE).replace(*change))
    told = [f"{f.line}:{f.column} {f.message}; {f.remedy}" for f in caught.value.findings]
    assert any(line.startswith(f"{place} ") and words in line for line in told), told


def test_all_that_is_wrong_with_resources_is_told_at_once():
    text = TEXT.replace("FORMULA", ONCE).replace("(brick, 2)", "(bick, 2)")
    text = text.replace("{yard: 2.5}", "{yrd: 2.5}").replace("drill: 1}}", "drll: 1}}")
    with pytest.raises(MissionError) as caught:
        mission_from_text(text)
    assert len(caught.value.findings) == 3


def test_what_cannot_be_brought_is_warned_of():
    made = mission("F[0,4] T(1, wall, {}, {(brick, 9)})")
    assert "9 of 'brick' are needed, and there are 6" in str(made.warnings[0])
    nobody = ("carries: 4", "carries: 0"), ("{brick: 1, w", "{w")
    idle = mission("F[0,4] T(1, wall, {}, {(brick, 1)})", *nobody)
    assert "no robot carries 'brick'" in str(idle.warnings[0])


def test_objectives_of_amounts_need_resources():
    start, stop = TEXT.index("resources:"), TEXT.index("team:")
    text = (TEXT[:start] + TEXT[stop:]).replace("FORMULA", "F[0,4] wall")
    for carried in (", carries: {brick: 1, water: 0.5, drill: 1}", ", carries: 4"):
        text = text.replace(carried, "")
    with pytest.raises(MissionError, match="'haulage' is about resources"):
        mission_from_text(text)


# --- forged plans ------------------------------------------------------------------------------


def forged() -> list[tuple[str, str]]:
    return [
        ("more", "can carry"),
        ("wait", "enters no edge then but a wait"),
        ("part", "no whole number"),
        ("unknown", "which the mission does not have"),
        ("stranger", "is not in the plan"),
        ("twice", "twice"),
        ("nothing there", "lie there"),
        ("no cargo", "lie there"),
        ("other task", "no such task"),
        ("other state", "does not have the label"),
        ("late", "beyond the horizon"),
        ("unstaffed", "agents for lay"),
        ("unexecuted", "does not hold"),
        ("stocks", "account of stocks"),
        ("haulage", "claims haulage"),
    ]


def forge(plan: tsplan.Plan, how: str) -> tsplan.Plan:
    (done,), cargo = plan.executions, plan.cargo
    first = cargo[0]
    haulage, travel = plan.objective
    changed = {
        "more": {"cargo": (replace(first, amount=5.0), *cargo[1:])},
        "wait": {"cargo": (*cargo, Cargo(first.agent, 7, "brick", 1.0))},
        "part": {"cargo": (replace(first, amount=0.5), *cargo[1:])},
        "unknown": {"cargo": (replace(first, resource="gold"), *cargo[1:])},
        "stranger": {"cargo": (replace(first, agent="nobody"), *cargo[1:])},
        "twice": {"executions": (done, done)},
        "nothing there": {"cargo": (*cargo, replace(cargo[-1], resource="drill", amount=1.0))},
        "no cargo": {"cargo": ()},
        "other task": {"executions": (replace(done, task="T(1,wall,{},{(brick,1)})"),)},
        "other state": {"executions": (replace(done, state="road"),)},
        "late": {"executions": (replace(done, step=8),)},
        "unstaffed": {"executions": (done, replace(done, step=0))},
        "unexecuted": {"executions": ()},
        "stocks": {"stocks": plan.stocks[1:]},
        "haulage": {"objective": (replace(haulage, value=1.0, bound=1.0), travel)},
    }
    return replace(plan, **changed[how])


@pytest.mark.parametrize(("how", "words"), forged())
def test_forged_plans_are_refused(how, words):
    made = mission(ONCE)
    plan = tsplan.plan(made)
    report = check(made, forge(plan, how))
    assert not report.ok
    assert any(words in str(finding) for finding in report.findings), report.findings


# --- both encodings ----------------------------------------------------------------------------


@pytest.mark.parametrize("seeds", seed_blocks(range(5000, 5002), range(5000, 6000), 10))
@pytest.mark.parametrize("parted", [False, True])
def test_both_encodings_agree_on_random_missions(seeds: list[int], parted: bool) -> None:
    for seed in seeds:
        made = random_resource_mission(seed, states=4, robots=4, steps=6, most=4, parted=parted)
        plans = [tsplan.plan(made, encoding=name, time_limit=30) for name in ("tight", "reference")]
        assert plans[0].status == plans[1].status
        told = [[inf if o.value is None else o.value for o in plan.objective] for plan in plans]
        assert told[0] == pytest.approx(told[1], rel=1e-6), made.text


@pytest.mark.parametrize("seeds", seed_blocks(range(7000, 7010), range(7010, 7400), 10))
@pytest.mark.parametrize("parted", [False, True])
def test_straight_ways_cost_no_better_plan(monkeypatch, seeds: list[int], parted: bool) -> None:
    monkeypatch.setattr(stages, "LARGE", -1)
    found = 0
    flows = StraightPlans.flows

    def counted(*given):
        nonlocal found
        for item in flows(*given):
            found += 1
            yield item

    monkeypatch.setattr(StraightPlans, "flows", counted)
    for seed in seeds:
        made = random_resource_mission(seed, states=4, robots=4, steps=6, most=4, parted=parted)
        plans = [tsplan.plan(made, without=names) for names in ((), ("straight",))]
        assert plans[0].status == plans[1].status
        told = [[inf if o.value is None else o.value for o in plan.objective] for plan in plans]
        assert told[0] == pytest.approx(told[1], rel=1e-6), made.text
    assert found


def test_what_straight_ways_leave_out_is_found_all_the_same(monkeypatch):
    """Each robot has to be back: things are handed over where nothing lies or is wanted."""
    monkeypatch.setattr(stages, "LARGE", -1)
    text = """
format: tsplan-mission/1
map:
  waiting: true
  states: {yard: {labels: [home]}, road: {}, wall: {labels: [site]}}
  edges: [{from: yard, to: road, duration: 1, both_ways: true},
    {from: road, to: wall, duration: 1, both_ways: true}]
resources: [{name: brick, at: {yard: 1}, indivisible: true}]
team:
  - {class: keeper, at: yard, capabilities: [keep], carries: 1}
  - {class: mason, at: wall, capabilities: [lay], carries: 1}
spec:
  language: catl
  formula: 'G[2,2] T(0, home, {(keep, 1)}) && G[2,2] T(0, site, {(lay, 1)}, {(brick, 1)})'
objective: [travel]
"""
    plan = tsplan.plan(mission_from_text(text))
    assert plan.status == "optimal"
    assert values(plan)["travel"] == 4


@pytest.mark.parametrize("seeds", seed_blocks(range(8000, 8005), range(8000, 8400), 10))
def test_what_must_be_moved_at_all_bounds_what_is_moved(seeds: list[int]) -> None:
    reached = []
    for seed in seeds:
        made = random_resource_mission(seed, states=4, robots=3, steps=6, parted=seed % 3 == 0)
        for name in ("travel", "haulage"):
            asked = replace(made, objective=(name,))
            plan = tsplan.plan(asked)
            if plan.status != "optimal":
                continue
            encoded = tight(prepare(asked))
            vector = model_objective(name).target(encoded.setting, encoded).vector
            model = still_model(encoded, vector)
            least = solver("highs").solve(model, Options()).objective
            assert least <= plan.objective[0].value + 1e-6, made.text
            reached.append(least / max(plan.objective[0].value, 1e-6))
    assert max(reached) == pytest.approx(1.0)


def test_what_is_asked_for_in_any_case():
    a, b, c = (logic.at_least(label) for label in "abc")
    assert needed((a & b).always(0, 2).eventually(1, 5)) == {a: 3, b: 3}
    assert needed((a & b) | (a.eventually(0, 3) & c)) == {a: 1}
    assert needed(c.until(a.eventually(0, 2), 1, 4)) == {a: 1}
    assert needed(a.release(b, 0, 3)) == {}
    assert needed(a.eventually(0, 3).always(0, 9)) == {a: 1}


@pytest.mark.long
def test_the_random_missions_are_of_all_kinds():
    made = [random_resource_mission(seed) for seed in range(100)]
    plans = [tsplan.plan(item) for item in made]
    assert sum(plan.status == "infeasible" for plan in plans) >= 10
    assert sum(bool(plan.cargo) for plan in plans) >= 10
    assert {name for item in made for name in item.objective} == set(SENSE)


def test_executions_of_a_plan_are_records():
    plan = tsplan.plan(mission(ONCE))
    assert isinstance(plan.executions[0], ExecutedTask)
    assert all(isinstance(item, Cargo) for item in plan.cargo)
