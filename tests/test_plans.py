"""Plans as data and as JSON files."""

from __future__ import annotations

import json
import pickle
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.seeds import quick
from tsplan.errors import PlanError
from tsplan.plans.agent_plans import AgentPlan
from tsplan.plans.outcomes import MissionRef, ModelSize, ObjectiveValue, SolverUse, Status, Timings
from tsplan.plans.plan import Plan
from tsplan.plans.plan_file import load_plan, save_plan
from tsplan.stopping import StoppedBy

REF = MissionRef("farm", "0" * 64)
SEE = frozenset({"see"})
AGENTS = (
    AgentPlan("a-1", "a", SEE, ((0, 1, "p"), (3, 5, "q"))),
    AgentPlan("a-2", "a", SEE, ((0, 1, "p"), (3, 5, "q"))),
    AgentPlan("b_x", "b", frozenset(), ((0, 4, "q"),), "p"),
)
FULL = Plan(
    Status.FEASIBLE,
    REF,
    5,
    stopped_by=StoppedBy.GAP,
    objective=(ObjectiveValue("travel", 6, 5.5), ObjectiveValue("availability", None)),
    availability=1,
    agents=AGENTS,
    solver=SolverUse("highs", "1", {"seed": 1}),
    size=ModelSize(1, 2, 3, 4, 5, 6),
    timings=Timings(solve=1 / 3, total=1.5),
    notes=("tried twice",),
)


@pytest.mark.parametrize(
    ("status", "stopped_by", "agents"),
    [
        ("optimal", "gap", AGENTS),
        ("optimal", None, ()),
        ("feasible", None, AGENTS),
        ("feasible", "time_limit", ()),
        ("infeasible", "time_limit", ()),
        ("infeasible", None, AGENTS),
        ("no_plan_found", None, ()),
        ("no_plan_found", "gap", ()),
        ("no_plan_found", "memory", AGENTS),
        ("error", "gap", ()),
    ],
)
def test_impossible_outcomes_cannot_be_made(status, stopped_by, agents):
    with pytest.raises(PlanError):
        Plan(status, REF, 5, stopped_by=stopped_by, agents=agents)


@pytest.mark.parametrize(
    ("status", "stopped_by"),
    [
        ("infeasible", None),
        ("no_plan_found", "time_limit"),
        ("no_plan_found", "interrupt"),
        ("error", None),
        ("error", "memory"),
    ],
)
def test_outcomes_without_paths(status, stopped_by):
    plan = Plan(status, REF, 5, stopped_by=stopped_by)
    assert not plan.has_paths
    assert "agents" not in json.loads(plan.to_json())
    assert Plan.from_json(plan.to_json()) == plan
    with pytest.raises(PlanError):
        replace(plan, verified=True)


def test_json_is_the_documented_document():
    data = json.loads(FULL.to_json())
    assert list(data)[:9] == [
        "format",
        "status",
        "stopped_by",
        "mission",
        "horizon",
        "objective",
        "availability",
        "verified",
        "agents",
    ]
    assert data["format"] == "tsplan-plan/1"
    assert data["objective"][0] == {"name": "travel", "value": 6, "bound": 5.5}
    assert data["agents"][0] == {
        "id": "a-1",
        "class": "a",
        "capabilities": ["see"],
        "stays": [[0, 1, "p"], [3, 5, "q"]],
    }
    assert data["agents"][2]["heading"] == "p"
    assert Plan.from_json(FULL.to_json()) == FULL


def test_plans_can_be_pickled_after_use():
    assert FULL.counts().shape == (2, 6)
    assert pickle.loads(pickle.dumps(FULL)) == FULL


names = st.text(min_size=1, max_size=5)
paths = st.lists(st.tuples(st.integers(0, 3), st.integers(0, 3), names), min_size=1, max_size=4)


@quick
@given(st.lists(st.tuples(names, names, st.sets(names), paths), min_size=1, max_size=4))
def test_json_keeps_every_name(agents):
    made = []
    for number, (ident, class_name, able, pieces) in enumerate(agents):
        stays, step = [], 0
        for wait, length, state in pieces:
            stays.append((step, step + length, state))
            step += length + wait + 1
        made.append(AgentPlan(f"{ident}{number}", class_name, frozenset(able), tuple(stays)))
    plan = replace(FULL, agents=tuple(made), horizon=30)
    assert Plan.from_json(plan.to_json()) == plan


def test_states_and_counts_by_step():
    assert FULL.state_at(2) == {"a-1": None, "a-2": None, "b_x": "q"}
    assert FULL.agent["a-1"].state_at(9) is None
    assert FULL.states == ("p", "q")
    assert FULL.counts().tolist() == [[2, 2, 0, 0, 0, 0], [1, 1, 1, 3, 3, 2]]
    assert FULL.counts("see").tolist() == [[2, 2, 0, 0, 0, 0], [0, 0, 0, 2, 2, 2]]
    assert FULL.counts("see", states=["z"]).tolist() == [[0] * 6]
    assert [len(bundle.agents) for bundle in FULL.bundles] == [2, 1]


def test_equal_paths_are_one_bundle_even_as_other_objects():
    copies = tuple(replace(agent, stays=(*agent.stays,)) for agent in AGENTS)
    assert replace(FULL, agents=copies).bundles == FULL.bundles


def test_files_are_replaced_whole(tmp_path):
    place = tmp_path / "plan.json"
    save_plan(FULL, place)
    place.chmod(0o640)
    save_plan(replace(FULL, horizon=6), place)
    assert load_plan(place).horizon == 6
    assert place.stat().st_mode & 0o777 == 0o640
    assert [item.name for item in tmp_path.iterdir()] == ["plan.json"]


def test_a_place_that_cannot_be_written_is_a_finding(tmp_path):
    with pytest.raises(PlanError, match="cannot write"):
        save_plan(FULL, tmp_path / "missing" / "plan.json")


def changed(**entries):
    return json.dumps({**json.loads(FULL.to_json()), **entries})


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "this is not JSON"),
        ("{", "plan.json:1:2: this is not JSON"),
        ("[]", "plan"),
        ("{}", "no plan"),
        ('{"format": "tsplan-mission/1"}', "its format is 'tsplan-mission/1'"),
        ("[" * 100_000, "nested too deeply"),
        ('{"format": "tsplan-plan/1", "format": "tsplan-plan/1"}', "there twice"),
        ('{"format": NaN}', "NaN is not a JSON number"),
        (changed(horizon=-1), "horizon"),
        (changed(horizon=1.5), "horizon"),
        (changed(horizon=10**12), "horizon"),
        (changed(status="fine"), "status"),
        (changed(status="optimal"), "status optimal contradicts stopped_by gap"),
        (changed(agents=None), "needs the agents' paths"),
        (changed(colour="red"), "colour"),
        (changed(agents=[{"id": "a"}]), "agents[0].class"),
        (changed(verified="yes"), "verified"),
    ],
)
def test_what_is_no_plan_is_refused_in_words(text, words):
    with pytest.raises(PlanError) as caught:
        Plan.from_json(text, "plan.json")
    assert words in str(caught.value)
    assert all(finding.source == "plan.json" for finding in caught.value.findings)


def test_findings_in_a_plan_file_have_their_place():
    text = FULL.to_json().replace("[[0, 1, ", "[[7, 1, ", 1)
    line = next(n for n, row in enumerate(text.splitlines(), 1) if "[[7, 1, " in row)
    with pytest.raises(PlanError, match=f"plan.json:{line}:.*out of order"):
        Plan.from_json(text, "plan.json")


def test_missing_and_binary_files(tmp_path):
    with pytest.raises(PlanError, match="cannot read the plan"):
        load_plan(tmp_path / "none.json")
    (tmp_path / "binary.json").write_bytes(b"\xff\xfe\x00")
    with pytest.raises(PlanError, match="not UTF-8"):
        load_plan(tmp_path / "binary.json")
