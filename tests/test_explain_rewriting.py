"""`--fix`: the changed mission as a file loads, means the same, and keeps what it can."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

import tsplan
from tests.explaining import plain
from tests.seeds import sampled
from tsplan.explanation import explain
from tsplan.explanation.whynot.rewriting import rewritten
from tsplan.mission import Mission, SwarmBounds, load_mission, mission_from_text
from tsplan.plans.plan import Plan
from tsplan.testing import random_task_mission

FOLDER = Path(__file__).parents[1] / "environments"
QUICK = ("office_lift",)
INFEASIBLE = sampled(
    [
        *QUICK,
        "farm_overbooked",
        "office_closed",
        "office_double",
        "rescue_late",
        "site_late",
        "reef_thin",
    ],
    QUICK,
)
TEXT = """\
format: tsplan-mission/1
name: small      # keep me
map:
  waiting: true
  states:
    p: {labels: [A]}
    q: {labels: [B], capacity: 1}   # a narrow place
    r: {labels: [C]}
  edges:
    - {from: p, to: q, duration: 1, both_ways: true}
    - {from: q, to: r, duration: 2, both_ways: true}
team:
  - {class: a, count: 2, at: p, capabilities: [see]}  # two of them
spec:
  language: mtl
  formula: >
    F[0,4] A    # not a comment
objective: [travel]
"""


def mission(formula: str, **changes: str) -> Mission:
    text = TEXT.replace("F[0,4] A    # not a comment", formula)
    for old, new in changes.items():
        text = text.replace(old, new)
    return mission_from_text(text)


def written(original: Mission, number: int = 0) -> tuple[str, bool, Mission]:
    """The text after one change, whether comments were lost, and the changed mission."""
    change = explain(original).changes[number]
    here = Path()
    text, lost = rewritten(original, change.mission, here, here)
    return text, lost, change.mission


def same(read: Mission, changed: Mission) -> bool:
    return (
        read.formula is changed.formula
        and read.team == changed.team
        and read.horizon == changed.horizon
        and read.objective == changed.objective
        and read.swarm == changed.swarm
        and read.prefer == changed.prefer
        and read.task_interval == changed.task_interval
        and dict(read.system.edges) == dict(changed.system.edges)
        and dict(read.system.states) == dict(changed.system.states)
    )


@pytest.mark.parametrize("name", INFEASIBLE)
def test_every_change_of_the_environments_can_be_written_and_planned(name, tmp_path):
    original = load_mission(FOLDER / f"{name}.yaml")
    made = explain(original)
    assert made.changes
    for change in made.changes:
        text, lost = rewritten(original, change.mission, FOLDER, tmp_path)
        assert not lost
        (tmp_path / "fixed.yaml").write_text(text, encoding="utf-8")
        read = load_mission(tmp_path / "fixed.yaml")
        assert same(read, change.mission), change.text
        assert tsplan.plan(plain(read)).has_paths


def test_only_the_number_that_changes_is_exchanged():
    original = mission("F[0,2] C && G[0,1] A")
    text, lost, changed = written(original)
    assert changed.formula is mission_from_text(text).formula
    assert not lost
    assert text == original.origin.content.replace("F[0,2]", "F[0,3]")


def test_agents_are_added_in_their_entry_and_the_comment_beside_it_stays():
    original = mission("F[0,4] sum(C, see) >= 3", capacity="needs", **{"needs: 1": "needs: []"})
    change = next(c for c in explain(original).changes if c.kind == "add_agents")
    text, lost = rewritten(original, change.mission, Path(), Path())
    assert not lost
    assert "- {class: a, count: 3, at: p, capabilities: [see]}  # two of them" in text
    assert same(mission_from_text(text), change.mission)


def test_agents_at_another_state_become_an_entry_of_their_own():
    original = mission("F[0,1] C")
    change = next(c for c in explain(original).changes if c.kind == "add_agents")
    text, _ = rewritten(original, change.mission, Path(), Path())
    read = mission_from_text(text)
    assert read.team == change.mission.team
    assert len(read.team) == 2


def test_a_map_that_changes_is_written_anew_and_says_that_comments_are_gone():
    original = mission("F[0,3] min(B) >= 2")
    change = next(c for c in explain(original).changes if "capacity" in c.text)
    text, lost = rewritten(original, change.mission, Path(), Path())
    assert lost
    assert "# two of them" in text
    assert "# a narrow place" not in text
    assert mission_from_text(text).system.states["q"].capacity == 2


def test_a_bare_label_becomes_a_comparison_in_parentheses():
    text, _, changed = written(mission("F[0,4] (A && B && C)"))
    assert same(mission_from_text(text), changed)


@pytest.mark.parametrize("formula", ["F[0,2] C", "!(G[0,2] !C)"])
def test_a_horizon_that_is_given_grows_with_the_formula(formula):
    text = TEXT.replace("F[0,4] A    # not a comment", "F[0,2] C")
    original = mission_from_text(text + "horizon: 2  # no longer\n")
    text, lost, changed = written(original)
    assert not lost
    assert changed.horizon == 3
    assert "horizon: 3  # no longer" in text


def test_a_bound_of_a_swarm_is_exchanged_in_place():
    original = load_mission(FOLDER / "reef_thin.yaml")
    rules = replace(original.swarm, each={"swarm": SwarmBounds(3, 10)})
    text, lost = rewritten(original, replace(original, swarm=rules), FOLDER, FOLDER)
    assert not lost
    assert text == original.origin.content.replace("max_subswarms: 2", "max_subswarms: 3", 1)


@pytest.mark.parametrize("seed", sampled(range(200, 203), [201]))
def test_missions_that_come_from_python_are_written_whole(seed):
    original = random_task_mission(seed)
    for change in explain(original).changes:
        text, lost = rewritten(original, change.mission, Path(), Path())
        assert not lost
        assert same(mission_from_text(text), change.mission), change.text


WISHES = {
    "spec": {"must": "F[0,2] C"},
    "prefer": [
        {"name": "both", "formula": "F[0,4] sum(C) >= 2", "weight": 3, "level": 1},
        {"formula": "G[0,4] A", "weight": 0.5, "partial": True},
    ],
}


def test_wishes_and_orders_of_satisfaction_are_written_whole():
    system = mission("F[0,2] C").system
    team = [{"class": "a", "count": 2, "at": "p", "capabilities": ["see"]}]
    wished = Mission.of(
        map=system, team=team, must="F[0,2] C", prefer=WISHES["prefer"], language="mtl"
    )
    partial = Mission.of(
        map=system,
        team=team,
        formula="F[0,2] C",
        language="mtl",
        objective=[{"satisfaction": "depth"}, "travel"],
        task_interval="half-open",
        solver={"time_limit": 30},
    )
    for original in (wished, partial):
        for change in explain(original).changes:
            read = mission_from_text(rewritten(original, change.mission, Path(), Path()).text)
            assert same(read, change.mission)
            assert read.satisfaction == original.satisfaction
            assert read.solver == original.solver
            found = tsplan.plan(read)
            assert isinstance(found, Plan)
            assert found.has_paths


@pytest.mark.long
def test_swarms_are_written_whole():
    system = mission("F[0,2] C").system
    free = replace(system.states["q"], capacity=None)
    system = type(system).build(
        [free if s.name == "q" else s for s in system.states.values()], system.edges.values()
    )
    one = {"size": 9, "at": {"q": 9}, "max_subswarms": 2, "min_subswarm": 2}
    formula = "F[3,6] (A && B && C)"
    single = Mission.of(map=system, swarm=one, formula=formula, margin="5%")
    named = Mission.of(
        map=system,
        swarms=[{"name": "x", **one}, {"name": "y", "size": 3, "at": {"p": 3}}],
        formula="F[3,6] (sum(A, x) >= 2 && sum(B, x) >= 2 && sum(C, x) >= 2)",
        max_subswarms=3,
        margin=1,
    )
    for original in (single, named):
        made = explain(original)
        assert made.changes
        for change in made.changes:
            text = rewritten(original, change.mission, Path(), Path()).text
            assert same(mission_from_text(text), change.mission)
