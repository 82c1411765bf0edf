"""`tsplan show`: pictures of plans, and why they hold."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.seeds import sampled
from tests.walks import walking
from tsplan import load_mission, save_plan
from tsplan.cli import main

pytest.importorskip("matplotlib")

ENVIRONMENTS = Path(__file__).parents[1] / "environments"


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """A folder with a mission, its map, and a plan of it."""
    for name in ("farm.yaml", "farm_harvest.yaml"):
        (tmp_path / name).write_bytes((ENVIRONMENTS / name).read_bytes())
    monkeypatch.chdir(tmp_path)
    save_plan(walking(load_mission("farm_harvest.yaml")), tmp_path / "plan.json")
    return tmp_path


def test_why_prints_the_tree_of_the_mission_beside_the_plan(folder, capsys):
    assert main(["show", "plan.json", "--why"]) == 0
    lines = capsys.readouterr().out.splitlines()
    plan, mission = (
        walking(load_mission("farm_harvest.yaml")),
        load_mission("farm_harvest.yaml"),
    )
    assert "\n".join(lines) == str(plan.explain(mission))
    assert lines[0].startswith("&&")
    assert any("T(2,fruit,{(Vis,2)})" in line for line in lines)


def test_why_needs_a_plan_and_its_mission(folder, capsys):
    assert main(["show", "farm.yaml", "--why"]) == 2
    assert "is about a plan" in capsys.readouterr().err
    (folder / "farm_harvest.yaml").rename(folder / "mission.txt")
    assert main(["show", "plan.json", "--why"]) == 2
    assert "--mission MISSION" in capsys.readouterr().err
    assert main(["show", "plan.json", "--why", "--mission", "mission.txt"]) == 0


VIEWS = ("page", "paths", "timeline", "requirements", "flow", "map")


@pytest.mark.parametrize("view", sampled(VIEWS, ["paths", "flow"]))
def test_every_view_can_be_written(folder, view):
    assert main(["show", "plan.json", "--view", view, "-o", f"{view}.svg"]) == 0
    drawn = (folder / f"{view}.svg").read_text(encoding="utf-8")
    assert ('id="path:' in drawn) == (view in ("page", "paths"))
    assert ('id="on the way"' in drawn) == (view in ("page", "timeline"))
    assert ('id="need"' in drawn) == (view in ("page", "requirements"))
    assert ('id="stays:' in drawn) == (view == "flow")


def test_without_its_mission_a_plan_has_a_timeline_only(folder, capsys):
    (folder / "farm_harvest.yaml").unlink()
    assert main(["show", "plan.json", "-o", "a.svg"]) == 0
    assert 'id="on the way"' in (folder / "a.svg").read_text(encoding="utf-8")
    assert main(["show", "plan.json", "--view", "paths", "-o", "b.svg"]) == 2
    assert "in no YAML file beside it" in capsys.readouterr().err


def test_why_and_a_picture_together(folder, capsys):
    assert main(["show", "plan.json", "--why", "--view", "timeline", "-o", "a.png"]) == 0
    assert (folder / "a.png").read_bytes().startswith(b"\x89PNG")
    assert "availability" in capsys.readouterr().out
