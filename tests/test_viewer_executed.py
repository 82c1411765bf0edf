"""What the page is told of what happened beside the plan, and how it is opened at a step."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from tests.fence_missions import fence
from tests.walks import walking, write_walks
from tests.yards import yard
from tsplan import InputError, PlanError, Trajectory, load_any_mission, load_mission
from tsplan import plan as plan_for
from tsplan.cli import main
from tsplan.plans.outcomes import MissionRef
from tsplan.viewer import page
from tsplan.viewer.page_data import page_data

ENVIRONMENTS = Path(__file__).parents[1] / "environments"


def members(track):
    return {} if track is None else track["ids"]


@pytest.mark.parametrize("seed", [0, pytest.param(1, marks=pytest.mark.long)])
def test_every_agent_stands_beside_itself(seed):
    mission = load_mission(ENVIRONMENTS / "farm_harvest.yaml")
    plan, happened = walking(mission, seed, still=0.6), walking(mission, seed + 9, still=0.6)
    data = page_data(mission, plan, happened)
    planned = data["planned"]["tracks"]
    assert len(planned) == len(data["tracks"])
    for one, other in zip(data["tracks"], planned, strict=True):
        assert members(one) == members(other)
    names = [name for track in data["tracks"] for name in track["ids"]]
    assert sorted(names) == sorted(agent.id for agent in mission.agents)
    states = list(mission.system.states)
    for tracks, each in ((data["tracks"], happened), (planned, plan)):
        for track in tracks:
            for name in track["ids"]:
                agent = next(agent for agent in each.agents if agent.id == name)
                stops = [track["stops"][n : n + 3] for n in range(0, len(track["stops"]), 4)]
                stays = [(a, b, states[s]) for a, b, s in stops if a <= each.horizon]
                assert stays == [*agent.stays]


def test_agents_that_one_of_both_does_not_know_stand_alone():
    mission, plan = yard()
    lone = replace(plan, agents=plan.agents[1:])
    data = page_data(mission, lone, plan)
    assert [members(track) for track in data["planned"]["tracks"]] == [{}, ["man-1", "man-2"]]
    data = page_data(mission, plan, lone)
    assert [track["ids"] for track in data["tracks"]] == [["man-1", "man-2"]]
    assert [members(track) for track in data["planned"]["tracks"]] == [
        ["man-1", "man-2"],
        ["cart-1"],
    ]


def test_the_formula_is_judged_by_what_happened():
    mission, plan = yard()
    late = ((0, 0, "gate"), (2, 3, "shed"), (5, 8, "field"))
    happened = replace(plan, agents=(replace(plan.agents[0], stays=late), *plan.agents[1:]))
    assert all(part["failed"] is None for part in page_data(mission, plan)["formula"])
    rows = page_data(mission, plan, happened)["formula"]
    assert any(part["failed"] is not None for part in rows)
    (chart,) = (c for part in rows for c in part["charts"] if part["depth"] and "crop" in c["text"])
    assert chart["counts"] == ((0, 0), (5, 1))
    assert chart["planned"] == ((0, 0), (4, 1), (7, 0))


def test_what_happened_has_to_be_of_the_same_mission():
    mission, plan = yard()
    other = load_mission(ENVIRONMENTS / "farm_harvest.yaml")
    with pytest.raises(PlanError, match="has no state"):
        page_data(mission, plan, walking(other))
    with pytest.raises(PlanError, match="has no state"):
        plan.plot(mission, executed=walking(other))


def test_structures_stand_beside_themselves():
    mission = fence()
    plan = plan_for(mission)
    data = page_data(mission, plan, plan)
    for one, other in zip(data["tracks"], data["planned"]["tracks"], strict=True):
        assert one == other
    assert data["freights"] == data["planned"]["freights"]


def test_durations_are_told_where_they_differ():
    mission, plan = yard()
    told = page_data(mission, plan)["map"]
    assert told["usual"] == "2 steps if not marked"
    assert sorted(edge["words"] for edge in told["edges"]) == ["", "", "1-3"]


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    write_walks(tmp_path)
    return tmp_path


def test_the_page_opens_at_a_step(folder, monkeypatch, capsys):
    opened = []
    monkeypatch.setattr("webbrowser.open", lambda url: opened.append(url) or True)
    monkeypatch.setattr("tempfile.tempdir", str(folder))
    assert main(["view", "plan.json", "--step", "12", "--executed", "trace.json"]) == 0
    assert opened[0].endswith(".html#step=12")
    mission = load_mission("farm_harvest.yaml")
    written = Path(opened[0].removeprefix("file://").partition("#")[0])
    assert '"planned":{"tracks"' in written.read_text(encoding="utf-8")
    capsys.readouterr()
    assert main(["view", "plan.json", "--step", "2.5", "-o", "a.html"]) == 0
    assert capsys.readouterr().out.strip().endswith("a.html#step=2.5")
    plan = walking(mission)
    plan.view(mission, step=3)
    assert opened[1].endswith("#step=3")
    plan.view(mission, "b.html", executed=walking(mission, 3))
    assert "executed" in (folder / "b.html").read_text(encoding="utf-8")
    with pytest.raises(InputError, match="there is no step 99"):
        plan.view(mission, "b.html", step=99)


@pytest.mark.parametrize(
    ("asked", "words"),
    [
        (["--step", "99"], "there is no step 99"),
        (["--step", "x"], "--step"),
        (["--executed", "none.json"], "none.json"),
        (["--executed", "trace.json", "-o", "trace.json"], "read by the same command"),
    ],
)
def test_what_cannot_be_viewed_is_refused(folder, capsys, asked, words):
    assert main(["view", "plan.json", *asked]) == 2
    assert words in capsys.readouterr().err


def test_trajectories_have_nothing_beside_them():
    _, plan = yard()
    mission = load_any_mission(ENVIRONMENTS / "signals" / "trajectory.yaml")
    trajectory = Trajectory("feasible", MissionRef("", ""), 1, "gap", signals={"x": (0.0, 1.0)})
    with pytest.raises(InputError, match="beside it is a trajectory"):
        page(mission, trajectory, plan)
