"""Telling never costs the plan: streams that are closed, full, of another encoding, or left."""

from __future__ import annotations

import json
import subprocess
import sys
from contextlib import redirect_stdout
from pathlib import Path

import pytest

import tsplan
from tests.command_line import MISTAKES, PATIENCE, here, posix, surroundings
from tests.seeds import long, sampled
from tsplan.cli import main
from tsplan.cli.progress import Progress
from tsplan.run.events import Bound, Incumbent, Stage

MISSION = """\
format: tsplan-mission/1
name: "仓库 :car: \\x1b[31m"
map:
  waiting: true
  states: {":key:": {labels: ["入口"]}, "b\\x07": {labels: ["[b]"]}}
  edges: [[":key:", "b\\x07", 1], ["b\\x07", ":key:", 1]]
team: [{class: "é😀", count: 2, at: ":key:"}]
spec: {language: mtl, formula: 'F[0,3] "[b]" && F[4,6] sum("入口") >= 2'}
objective: [travel]
"""
full = pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs a device that is full")


FILES = {"mission.yaml": MISSION}


def shell(line, **variables):
    """Run a line of shell in which `tsplan` is the command line; buffered, as users have it."""
    tool = f'tsplan() {{ "{sys.executable}" -m tsplan "$@"; }}; set -o pipefail; '
    return subprocess.run(
        ["bash", "-c", tool + line],
        capture_output=True,
        check=False,
        timeout=PATIENCE,
        env=surroundings({"PYTHONUNBUFFERED": "", **variables}),
    )


def written(folder):
    """The plan that was written, which has to be whole."""
    plan = json.loads((folder / "plan.json").read_text(encoding="utf-8"))
    (folder / "plan.json").unlink()
    return plan["status"] == "optimal" and plan["verified"]


@posix
@pytest.mark.parametrize(
    ("redirection", "code"),
    [
        pytest.param(">/dev/full", 6, marks=[full, pytest.mark.long]),
        pytest.param("2>/dev/full", 0, marks=[full, pytest.mark.long]),
        long(">&-", 0),
        long("2>&-", 0),
        (">&- 2>&- <&-", 0),
        long("| head -1 >/dev/null", 0),
        long("2> >(head -1 >/dev/null)", 0),
        long("| true", 0),
    ],
)
def test_streams_cost_words_and_not_the_plan(folder, redirection, code):
    done = shell(f"tsplan plan mission.yaml -o plan.json {redirection}")
    said = (done.stdout + done.stderr).decode()
    assert done.returncode == code, said
    assert not any(word in said for word in MISTAKES)
    assert written(folder)
    if code == 6:
        last = done.stderr.decode().splitlines()[-1]
        assert last == "cannot write to the standard output: No space left on device"


FULL = "cannot write to the standard output: No space left on device\n"


@posix
@full
@pytest.mark.parametrize("unbuffered", sampled(["", "1"], [""]))
def test_a_full_stdout_is_said_buffered_or_not(unbuffered):
    done = shell("tsplan parse 'F[0,2] a' --language mtl >/dev/full", PYTHONUNBUFFERED=unbuffered)
    assert (done.returncode, done.stderr.decode()) == (6, FULL)


@full
@pytest.mark.parametrize(
    "line",
    [
        "check mission.yaml plan.json",
        "show plan.json --why",
        "explain mission.yaml --quiet",
        "explain mission.yaml --quiet --json",
        "lint map.yaml",
    ],
)
def test_every_command_says_that_stdout_is_full(folder, capsys, line):
    assert main(["plan", "mission.yaml", "-o", "plan.json", "--quiet"]) == 0
    (folder / "map.yaml").write_text("waiting: true\nstates: {p: {}}\nedges: []\n")
    with Path("/dev/full").open("w", encoding="utf-8") as stream, redirect_stdout(stream):
        assert main(line.split()) == 6
    assert capsys.readouterr().err == FULL


@posix
@pytest.mark.long
def test_the_encoding_of_the_surroundings_will_do(folder):
    done = shell("tsplan plan mission.yaml -o plan.json", PYTHONIOENCODING="ascii")
    assert done.returncode == 0, done.stderr
    assert "\\u4ed3\\u5e93 :car:" in done.stdout.decode("ascii")
    assert written(folder)


@pytest.mark.parametrize(
    "encoding", sampled(["cp1252", "ascii", "utf-8", "utf-16"], ["ascii", "utf-16"])
)
def test_any_encoding_will_do(folder, encoding):
    done = here("plan", "mission.yaml", "-o", "plan.json", encoding=encoding)
    assert done.code == 0, done.err
    assert ":car:" in done.out
    assert ("仓库" if encoding.startswith("utf") else "\\u4ed3\\u5e93") in done.out
    plan = json.loads(here("plan", "mission.yaml", "--json", "--quiet", encoding=encoding).out)
    assert plan["agents"][0]["class"] == "é😀"
    assert plan["mission"]["name"] == "仓库 :car: \x1b[31m"
    for line in ("explain mission.yaml", "check mission.yaml plan.json"):
        done = here(*line.split(), encoding=encoding)
        assert done.code == 0, done.err
    assert written(folder)


def test_names_are_shown_as_written_with_controls_escaped(folder, capsys):
    assert main(["plan", "mission.yaml", "-o", "plan.json"]) == 0
    out = capsys.readouterr().out
    assert "仓库 :car: \\x1b[31m: optimal plan" in out
    assert ":key::0" in out
    assert "b\\x07" in out
    assert main(["show", "plan.json", "--why"]) == 0
    text = (folder / "mission.yaml").read_text(encoding="utf-8")
    # nobody can be in time, and the places are named with what they hold of control characters
    (folder / "mission.yaml").write_text(text.replace("F[0,3]", "F[0,0]"), encoding="utf-8")
    assert main(["explain", "mission.yaml"]) == 0
    assert main(["check", "mission.yaml", "plan.json"]) == 1
    seen = capsys.readouterr()
    assert "at 'b\\x07'" in seen.out
    assert ":car:" in seen.out
    assert "\x1b" not in out + seen.out + seen.err
    assert "\x07" not in out + seen.out + seen.err
    assert "\x9b" not in out + seen.out + seen.err


def test_a_plan_that_cannot_be_written_is_shown_all_the_same(folder, capsys, monkeypatch):
    def refused(*_):
        raise tsplan.PlanError([tsplan.Finding("cannot write: it is full", "", "plan.json")])

    monkeypatch.setattr("tsplan.cli.plan_command.save_plan", refused)
    assert main(["plan", "mission.yaml", "-o", "plan.json", "--json"]) == 2
    out, err = capsys.readouterr()
    assert json.loads(out)["status"] == "optimal"
    assert "it is full" in err.splitlines()[-1]


class _Broken:
    """A stream that fails whatever is done with it."""

    encoding = "utf-8"

    def __getattr__(self, name):
        raise RuntimeError(name)


@pytest.mark.parametrize("terminal", [False, True])
def test_progress_never_raises(monkeypatch, terminal):
    monkeypatch.setattr("sys.stderr", _Broken())
    if terminal:
        monkeypatch.setattr("tsplan.cli.output.Stream.isatty", lambda _: True)
    with Progress() as progress:
        progress.tell(Stage("travel", 0.0))
        progress.tell(Bound("travel", float("inf"), float("nan"), 0.1))
        progress.tell(Incumbent("travel", float("inf"), -float("inf"), 0.1))


def test_an_error_of_the_users_listener_stops_the_search_and_is_raised(folder):
    mission = tsplan.load_mission("mission.yaml")
    heard = []

    def listen(event):
        heard.append(event)
        raise LookupError("mine")

    with pytest.raises(LookupError, match="mine"):
        tsplan.plan(mission, on_event=listen)
    assert len(heard) == 1
