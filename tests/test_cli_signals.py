"""The command line on missions over signals: the same commands, the file decides."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.seeds import long
from tests.walks import walking
from tsplan import load_mission, load_signal_mission, load_trajectory, save_plan
from tsplan.cli import main
from tsplan.signals.result_check import check, load_result

ENVIRONMENTS = Path(__file__).parents[1] / "environments"
MISSION = """\
format: tsplan-signals/1
name: reach
signals: {x: {min: 0, max: 10, initial: 1}, y: {min: 0, max: 10, initial: 2}}
controls: {ux: [-1, 1], uy: [-1, 1]}
dynamics: {A: [[1, 0], [0, 1]], B: [[1, 0], [0, 1]]}
regions: {goal: {x: [4, 6], y: [4, 6]}, wall: {x: [2, 3], y: [3, 9]}}
spec: "F[0,6] in(goal) && G[0,6] out(wall)"
objective: {robustness: 1}
"""


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """A folder with a mission over signals, and one for a team with its plan."""
    for name in ("farm.yaml", "farm_harvest.yaml"):
        (tmp_path / name).write_bytes((ENVIRONMENTS / name).read_bytes())
    (tmp_path / "reach.yaml").write_text(MISSION, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    save_plan(walking(load_mission("farm_harvest.yaml")), tmp_path / "plan.json")
    return tmp_path


@pytest.fixture
def planned(folder, capsys):
    """The same with the trajectory of the mission, and what planning it said."""
    assert main(["plan", "reach.yaml", "-o", "found.json"]) == 0
    return capsys.readouterr()


def test_plan_finds_writes_and_tells_a_trajectory(planned, folder):
    found = load_trajectory("found.json")
    assert (found.status, found.verified, found.horizon) == ("optimal", True, 6)
    assert found.robustness == pytest.approx(1)
    assert found.timings.total >= found.timings.load > 0
    lines = planned.out.splitlines()
    assert lines[0] == "reach: optimal trajectory (accepted by the independent check)"
    assert lines[1] == "  robustness 1 (proven: no trajectory does better)"
    assert "    F[0,6] in(goal): robustness 1" in lines
    ends = [f"{found.signals['x'][step]:g}" for step in (0, 6)]
    assert any(line.split()[:3] == ["x", *ends] for line in lines)
    assert "best 1" in planned.err


def test_json_is_the_file_alone(folder, capsys):
    assert main(["plan", "reach.yaml", "--json", "--quiet"]) == 0
    told = capsys.readouterr()
    assert json.loads(told.out)["format"] == "tsplan-trajectory/1"
    assert told.err == ""


def test_the_reference_encoding_agrees(folder, capsys):
    assert main(["plan", "reach.yaml", "--encoding", "reference", "-o", "other.json"]) == 0
    assert load_trajectory("other.json").robustness == pytest.approx(1)


def test_what_cannot_be_has_its_exit_code(folder, capsys):
    (folder / "far.yaml").write_text(MISSION.replace("F[0,6]", "F[0,2]"), encoding="utf-8")
    assert main(["plan", "far.yaml", "-o", "none.json"]) == 3
    assert "no trajectory satisfies the mission" in capsys.readouterr().out
    assert load_result("none.json").status == "infeasible"
    assert main(["show", "none.json", "-o", "none.png"]) == 2
    assert "has no signals" in capsys.readouterr().err
    (folder / "bad.yaml").write_text(MISSION.replace("in(goal)", "in(gaol)"), encoding="utf-8")
    assert main(["plan", "bad.yaml"]) == 2
    assert "bad.yaml:7" in capsys.readouterr().err


def test_check_accepts_it_and_finds_what_is_wrong(planned, folder, capsys):
    assert main(["check", "reach.yaml", "found.json"]) == 0
    assert capsys.readouterr().out.splitlines()[-1] == "the trajectory is accepted"
    text = (folder / "found.json").read_text(encoding="utf-8")
    data = json.loads(text)
    data["signals"]["x"][3] += 0.25
    (folder / "bent.json").write_text(json.dumps(data), encoding="utf-8")
    assert main(["check", "reach.yaml", "bent.json"]) == 1
    assert "bent.json: at step 3 signal x is" in capsys.readouterr().out
    (folder / "reach.yaml").write_text(MISSION + "# touched\n", encoding="utf-8")
    assert main(["check", "reach.yaml", "found.json"]) == 0
    assert "the mission file has changed since the trajectory was made" in capsys.readouterr().out


@pytest.mark.parametrize("command", [["check"], ["simulate", "--amplitude", "1"], ["show"]])
def test_missions_and_results_of_different_kinds(planned, folder, capsys, command):
    pairs = [("reach.yaml", "plan.json"), ("farm_harvest.yaml", "found.json")]
    for mission, result in pairs:
        if command == ["show"]:
            code = main(["show", result, "--mission", mission, "-o", "picture.png"])
        else:
            code = main([command[0], mission, result, *command[1:]])
        assert code == 2
        told = capsys.readouterr().err
        noun = "plan" if result == "plan.json" else "trajectory"
        assert f"{result}: this is a {noun}, and the mission is one" in told


def test_check_in_python_takes_both(planned, folder):
    team, plan = load_mission("farm_harvest.yaml"), load_result("plan.json")
    signals, found = load_signal_mission("reach.yaml"), load_result("found.json")
    assert check(signals, found).ok
    assert check(team, plan).values is not None
    for mission, result in ((signals, plan), (team, found)):
        with pytest.raises(ValueError, match="and the mission is one"):
            check(mission, result)


def test_simulate_shakes_it(planned, folder, capsys):
    arguments = ["simulate", "reach.yaml", "found.json", "--runs", "200", "--seed", "3"]
    assert main([*arguments, "--amplitude", "0.3"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[0].startswith("200 runs (seed 3): the controls as planned")
    assert lines[1].startswith("the formula held in ")
    assert main([*arguments, "--amplitude", "x=0.01", "--amplitude", "y=0"]) == 0
    assert "the formula held in 200 of them: 100.0%" in capsys.readouterr().out
    for wrong, words in (
        ([], "as in --amplitude 0.1"),
        (["--amplitude", "1", "--amplitude", "x=2"], "name the signal of each"),
        (["--amplitude", "z=1"], "there is no signal 'z'"),
        (["--amplitude", "x=much"], "is not a number"),
    ):
        assert main([*arguments, *wrong]) == 2
        assert words in capsys.readouterr().err
    assert main(["simulate", "farm_harvest.yaml", "plan.json", "--amplitude", "1"]) == 2


def test_show_why(planned, folder, capsys):
    assert main(["show", "found.json", "--why"]) == 0
    tree = capsys.readouterr().out
    mission = load_signal_mission("reach.yaml")
    assert tree == f"{load_trajectory('found.json').explain(mission)}\n"
    assert "critical: " in tree.splitlines()[0]


@pytest.mark.parametrize(
    ("file", "view", "wanted", "absent"),
    [
        long("found.json", "page", ("path:", "chosen", "region:goal"), ()),
        long("found.json", "signals", ("chosen", "threshold"), ("path:",)),
        ("found.json", "plane", ("path:", "region:wall"), ("threshold",)),
        ("reach.yaml", "page", ("start", "window", "region:goal"), ("chosen",)),
    ],
)
@pytest.mark.usefixtures("planned")
def test_pictures_of_missions_and_trajectories(folder, file, view, wanted, absent):
    pytest.importorskip("matplotlib")
    assert main(["show", file, "--view", view, "-o", "drawn.svg"]) == 0
    drawn = (folder / "drawn.svg").read_text(encoding="utf-8")
    assert all(f'id="{name}' in drawn for name in wanted)
    assert not any(f'id="{name}' in drawn for name in absent)


def test_a_trajectory_is_drawn_without_its_mission(planned, folder, capsys):
    pytest.importorskip("matplotlib")
    assert main(["show", "found.json", "--view", "flow", "-o", "drawn.svg"]) == 2
    assert "there is no view 'flow' of signals" in capsys.readouterr().err
    (folder / "reach.yaml").unlink()
    assert main(["show", "found.json", "-o", "alone.svg"]) == 0
    drawn = (folder / "alone.svg").read_text(encoding="utf-8")
    assert 'id="path:' in drawn
    assert 'id="threshold"' not in drawn


def test_view_and_animate(planned, folder, capsys):
    pytest.importorskip("matplotlib")
    image = pytest.importorskip("PIL.Image")
    assert main(["view", "found.json", "-o", "page.html"]) == 0
    assert "optimal trajectory" in (folder / "page.html").read_text(encoding="utf-8")
    given = ["animate", "found.json", "-o", "moving.gif", "--fps", "2", "--size", "480x300"]
    assert main(given) == 0
    with image.open(folder / "moving.gif") as film:
        assert film.size == (480, 300)
        pictures = []
        for number in (0, film.n_frames - 1):
            film.seek(number)
            pictures.append(film.convert("RGB").tobytes())
    assert pictures[0] != pictures[1]
    one = MISSION.split("controls", maxsplit=1)[0].replace(", y: {min: 0, max: 10, initial: 2}", "")
    (folder / "one.yaml").write_text(one + "spec: F[0,2] x >= 5\n", encoding="utf-8")
    assert main(["plan", "one.yaml", "-o", "one.json", "--quiet"]) == 0
    for name in ("one.gif", "one.html"):
        assert main(["animate", "one.json", "-o", name, "--fps", "1"]) == 0
