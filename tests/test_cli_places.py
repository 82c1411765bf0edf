"""No command writes over what it reads, whatever the file is called; pictures need no display."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from tests.command_line import command as command_line
from tests.missions import MAP
from tests.seeds import long, sampled
from tsplan.cli import main

MISSION = """\
format: tsplan-mission/1
name: there and back
map: map.svg
team: [{class: a, count: 2, at: p}]
spec: {language: mtl, formula: "F[0,3] sum(B) >= 2"}
"""


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """Files whose names end as those of pictures do, and other names of the same files."""
    monkeypatch.chdir(tmp_path)
    Path("map.svg").write_text(MAP)
    Path("mission.svg").write_text(MISSION)
    assert main(["plan", "mission.svg", "-o", "plan.svg", "--quiet"]) == 0
    Path("none.yaml").write_text(MISSION.replace(">= 2", ">= 3"))
    for name in ("map", "mission", "plan"):
        os.link(f"{name}.svg", f"{name}-hard.svg")
        Path(f"{name}-soft.svg").symlink_to(f"{name}.svg")
    return tmp_path


def content():
    return {path.name: path.read_bytes() for path in Path().iterdir()}


@pytest.mark.parametrize("suffix", sampled(["", "-hard", "-soft"], ["-soft"]))
@pytest.mark.parametrize(
    ("command", "inputs"),
    [
        ("plan mission.svg -o", ("mission", "map")),
        ("explain none.yaml --fix 1 -o", ("map",)),
        ("show map.svg -o", ("map",)),
        ("show mission.svg -o", ("mission", "map")),
        ("show plan.svg --mission mission.svg -o", ("mission", "map", "plan")),
        ("view plan.svg --mission mission.svg -o", ("mission", "map", "plan")),
    ],
)
def test_no_input_is_written_over(folder, capsys, command, inputs, suffix):
    if command.startswith("show"):
        pytest.importorskip("matplotlib")
    before = content()
    for name in inputs:
        assert main([*command.split(), f"{name}{suffix}.svg"]) == 2
        err = capsys.readouterr().err
        assert f"{name}{suffix}.svg: cannot write" in err
        assert "read by the same command" in err
    assert content() == before


def test_moving_pictures_are_not_written_over_inputs(folder, capsys):
    pytest.importorskip("matplotlib")
    Path("plan.gif").write_bytes(Path("plan.svg").read_bytes())
    assert main(["animate", "plan.gif", "--mission", "mission.svg", "-o", "plan.gif"]) == 2
    assert "read by the same command" in capsys.readouterr().err


def test_the_mission_beside_a_plan_is_an_input_too(folder, capsys):
    pytest.importorskip("matplotlib")
    Path("mission.yaml").symlink_to("mission.svg")
    assert main(["view", "plan.svg", "-o", "map-hard.svg"]) == 2
    assert main(["show", "plan.svg", "-o", "mission.svg"]) == 2
    assert capsys.readouterr().err.count("read by the same command") == 2


def test_an_output_may_be_written_again(folder):
    assert main(["plan", "mission.svg", "-o", "plan.svg", "--quiet"]) == 0
    assert main(["plan", "mission.svg", "-o", "plan-soft.svg", "--quiet"]) == 0
    assert main(["plan", "mission.svg", "-o", os.devnull, "--quiet"]) == 0


@pytest.mark.parametrize(
    ("backend", "command"),
    [
        long("nonsense", "show mission.svg -o new.png"),
        long("module://matplotlib_inline.backend_inline", "animate plan.svg -o new.gif"),
    ],
)
def test_the_backend_of_a_notebook_does_not_matter(folder, backend, command):
    pytest.importorskip("matplotlib")
    more = ["--mission", "mission.svg"] if command.startswith("animate") else []
    done = command_line(*command.split(), *more, MPLBACKEND=backend)
    assert done.code == 0, done.err
    assert Path(command.split()[-1]).stat().st_size > 500


def test_the_environment_is_left_as_it_was(folder, monkeypatch):
    pytest.importorskip("matplotlib")
    monkeypatch.setenv("MPLBACKEND", "svg")
    assert main(["show", "map.svg", "-o", "new.svg"]) == 0
    assert os.environ["MPLBACKEND"] == "svg"
