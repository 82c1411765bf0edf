"""A search that is stopped after any of its events leaves a plan that stands, or honestly none."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import pytest

import tsplan
from tests.seeds import sampled
from tsplan import Mission
from tsplan.checking.plan_check import check, objective_values
from tsplan.mission import load_mission
from tsplan.mission.objectives import OBJECTIVES
from tsplan.plans.plan import Plan
from tsplan.run.events import Event, Incumbent, Stage
from tsplan.testing import random_mission

FOLDER = Path(__file__).parents[1] / "environments"
MISSIONS = sorted(path.stem for path in FOLDER.glob("*_*.yaml"))
QUICK = ("farm_shortage", "reef_watch", "office_double")  # few stops of them do
CROWD = """\
format: tsplan-mission/1
map:
  waiting: true
  states: {home: {}, left: {labels: [l]}, right: {labels: [r]}, far: {labels: [f]}}
  edges: [[home, left, 1], [left, right, 2], [right, home, 1], [right, far, 2], [left, home, 3]]
team: [{class: cart, count: 5, at: home}, {class: van, count: 3, at: {left: 1, home: 2}}]
spec: {language: mtl, formula: "F[0,6] sum(l) >= 2 && F[3,8] G[0,1] sum(r) >= 3"}
objective: [agents, availability, travel, makespan]
"""
SHARED = """\
format: tsplan-mission/1
map:
  waiting: true
  states: {port: {}, reef: {labels: [r]}, bank: {labels: [b]}}
  edges: [[port, reef, 2], [reef, port, 2], [port, bank, 1], [bank, port, 1], [reef, bank, 3]]
swarm: {size: 30, at: port}
spec: {language: mtl, formula: "F[0,5] sum(r) >= 40% && F[2,8] G[0,1] sum(b) >= 50%"}
objective: [moves, balance, travel, makespan]
"""
WISHES = """\
format: tsplan-mission/1
map:
  waiting: true
  states: {p: {}, q: {labels: [q]}, r: {labels: [r]}, s: {labels: [s]}}
  edges: [[p, q, 1], [q, p, 1], [p, r, 2], [r, p, 2], [q, s, 2], [s, r, 1]]
team: [{class: cart, count: 2, at: p}]
spec:
  language: mtl
  must: F[0,3] q
  prefer:
    - {name: both, formula: "F[0,6] (r && s)", weight: 2.5}
    - {name: stay, formula: "G[2,6] sum(q) >= 2", weight: 0.7, partial: true}
    - {name: late, formula: "F[6,8] s", level: 1}
objective: [availability, makespan]
"""


def planned(mission: Mission, stop: int | None) -> tuple[Plan, list[Event]]:
    """The plan of a run that is stopped by the event of this number, and the events till then."""
    events: list[Event] = []

    def listen(event: Event) -> bool:
        events.append(event)
        return len(events) - 1 == stop

    return tsplan.plan(mission, on_event=listen), events


def judge(mission: Mission, plan: Plan) -> None:
    """What is said of a plan is so, and bounds are on the right side of its values."""
    if not plan.has_paths:
        assert plan.status in ("infeasible", "no_plan_found")
        return
    assert plan.verified
    assert check(mission, plan).ok
    actual = objective_values(mission, plan)
    for item in plan.objective:
        value = actual[item.name]
        assert item.value == (value if math.isfinite(value) else None)
        if plan.status == "optimal" and item.name != "satisfaction":
            assert item.bound == item.value
        if item.bound is not None and item.value is not None:
            assert math.isfinite(item.bound)
            assert (item.value <= item.bound) or OBJECTIVES[item.name].sense == "minimise"
            assert (item.value >= item.bound) or OBJECTIVES[item.name].sense == "maximise"


def agree(mission: Mission, event: Event) -> None:
    """An event speaks of its stage's objective: the value is that of its plan."""
    if isinstance(event, Stage):
        return
    for number in (event.objective, event.bound, event.gap):
        assert number is None or math.isfinite(number)
    if isinstance(event, Incumbent) and event.plan is not None and event.stage in OBJECTIVES:
        plan = event.plan()
        assert plan.verified
        actual = objective_values(mission, plan)[event.stage]
        assert event.objective == (actual if math.isfinite(actual) else None)
    if event.objective is not None and event.bound is not None and event.stage in OBJECTIVES:
        over = event.objective > event.bound
        assert event.objective == event.bound or over == (
            OBJECTIVES[event.stage].sense == "minimise"
        )


def stop_everywhere(mission: Mission, every: int = 1) -> int:
    """Stop a mission after every event in turn; the number of events."""
    whole, events = planned(mission, None)
    judge(mission, whole)
    for event in events:
        agree(mission, event)
    for number in range(0, len(events), every):
        plan, heard = planned(mission, number)
        judge(mission, plan)
        if plan.status in ("feasible", "no_plan_found"):
            assert plan.stopped_by == "interrupt"
        if any(isinstance(event, Incumbent) for event in heard):
            assert plan.has_paths
    return len(events)


@pytest.mark.parametrize("every", sampled([1, 4, 10], [10]))
@pytest.mark.parametrize("text", [CROWD, SHARED, WISHES], ids=["team", "swarm", "wishes"])
def test_every_stop_leaves_a_plan_that_stands(text: str, every: int, tmp_path: Path) -> None:
    path = tmp_path / "mission.yaml"
    path.write_text(text, encoding="utf-8")
    assert stop_everywhere(load_mission(path), every) >= 5


@pytest.mark.parametrize("seed", sampled(range(7000, 7012), range(7000, 7002)))
def test_every_stop_of_random_missions(seed: int) -> None:
    mission = random_mission(seed, states=4, most_agents=4, steps=8)
    stop_everywhere(replace(mission, objective=("agents", "availability", "cost", "makespan")))


@pytest.mark.parametrize("name", sampled(MISSIONS, ["office_double"]))
def test_every_stop_of_the_environments(name: str) -> None:
    stop_everywhere(load_mission(FOLDER / f"{name}.yaml"), every=5 if name in QUICK else 1)


@pytest.mark.long
@pytest.mark.parametrize("first", ["availability", "travel", "cost", "makespan", "agents"])
@pytest.mark.parametrize("second", ["availability", "travel", "cost", "makespan", "agents"])
@pytest.mark.parametrize("name", ["farm_patrol", "office_delivery", "rescue_evacuation"])
def test_every_stop_of_all_pairs_of_objectives(name: str, first: str, second: str) -> None:
    mission = load_mission(FOLDER / f"{name}.yaml")
    objective = (first,) if first == second else (first, second)
    stop_everywhere(replace(mission, objective=objective), every=3)


@pytest.mark.long
@pytest.mark.parametrize("seed", range(7100, 7400))
def test_every_stop_of_many_random_missions(seed: int) -> None:
    mission = random_mission(seed)
    objectives = ("agents", "availability", "cost", "makespan", "travel")
    shift = seed % len(objectives)
    stop_everywhere(replace(mission, objective=objectives[shift:] + objectives[:shift]))
