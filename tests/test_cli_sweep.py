"""`tsplan sweep`: what it prints and writes, going on after an end, and its exit codes."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from contextlib import suppress
from pathlib import Path

import pytest

from tests.command_line import (
    MISTAKES,
    PATIENCE,
    here,
    linux,
    on_terminal,
    posix,
    surroundings,
    terminals,
)
from tests.sweeping import ENDS, FILES, lines, table

__all__ = ["FILES"]  # for the folder

MANY = """\
format: tsplan-sweep/1
mission: mission.yaml
repeat: 400
"""


def test_a_table_is_printed_and_each_run_told(folder):
    done = here("sweep", "sweep.yaml", "-o", "out.csv", folder=folder)
    assert done.code == 0, done.err
    assert not any(word in done.out + done.err for word in MISTAKES)
    told = done.err.splitlines()
    assert [line.split("]")[0] for line in told] == [f"[{n}/6" for n in range(1, 7)]
    assert told[0].startswith("[1/6] horizon 6, formula near: optimal, travel 1, ")
    assert ": failed: sweep.yaml:8:18: this '(' is never closed" in told[2]
    head, *rows = done.out.splitlines()
    assert head.split() == ["horizon", "formula", "status", "travel", "seconds"]
    assert [row.split()[:3] for row in rows[:3]] == [
        ["6", "near", "optimal"],
        ["6", "never", "infeasible"],
        ["6", "torn", "MissionError"],
    ]
    assert rows[-2:] == ["6 runs: 2 optimal, 2 infeasible, 2 failed", "results in out.csv"]
    assert [row["status"] for row in table(folder / "out.csv")] == ENDS


def test_the_summary_as_json_says_it_all_and_nothing_is_done_twice(folder):
    first = here("sweep", "sweep.yaml", "--quiet", folder=folder)
    assert (first.code, first.out, first.err) == (0, "", "")
    done = here("sweep", "sweep.yaml", "--json", folder=folder)
    assert done.err == "6 of 6 runs are recorded already in sweep.csv.journal\n"
    said = json.loads(done.out)
    assert said["outcomes"] == {"optimal": 2, "infeasible": 2, "failed": 2}
    assert (said["runs"], said["recorded"], said["csv"]) == (6, 6, "sweep.csv")
    assert [row["status"] for row in said["rows"]] == ENDS
    assert list(said["dtypes"]) == list(said["rows"][0])
    retried = here("sweep", "sweep.yaml", "--retry", folder=folder)
    assert retried.err.splitlines()[0].startswith("4 of 6 runs are recorded already")
    assert len(lines(folder / "sweep.csv.journal")) == 8


def test_a_folder_is_swept(folder):
    done = here("sweep", ".", "-o", "out.csv", "--time-limit", "50", folder=folder)
    assert done.code == 0, done.err
    [row] = table(folder / "out.csv")
    assert (row["mission"], row["status"]) == ("mission.yaml", "optimal")
    assert json.loads(row["used.options"])["time_limit"] < 50


def test_a_plot_is_drawn(folder):
    pytest.importorskip("matplotlib")
    done = here("sweep", "sweep.yaml", "--plot", "times.svg", folder=folder)
    assert done.code == 0, done.err
    drawn = (folder / "times.svg").read_text()
    for word in ("seconds of a run", "horizon", "formula", "near", "infeasible", "failed"):
        assert word in drawn


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["nothing.yaml"], "nothing.yaml: there is no such file"),
        (["mission.yaml"], "this is a mission; name it as the 'mission' of a sweep"),
        (["sweep.yaml", "-o", "no/out.csv"], "cannot write the results: its directory does not"),
        (["sweep.yaml", "-o", "sweep.yaml"], "cannot write the results: this file is read by"),
        (["sweep.yaml", "--plot", "out.gif"], "pictures cannot be written as '.gif'"),
        (["sweep.yaml", "--plans", "map.yaml"], "plans cannot be kept: "),
        (["sweep.yaml", "--solver", "higs"], "there is no solver 'higs'; did you mean 'highs'?"),
    ],
)
def test_what_cannot_be_done_is_said_before_any_run(folder, arguments, words):
    done = here("sweep", *arguments, folder=folder)
    assert done.code == 2
    [line] = done.err.splitlines()
    assert words in line
    assert not list(folder.glob("*.csv"))


@posix
def test_ctrl_c_keeps_what_is_done_and_says_how_to_go_on(folder, monkeypatch):
    from tsplan.cli.sweep_progress import SweepProgress  # noqa: PLC0415  (changed here)

    with monkeypatch.context() as change:
        stop = signal.SIGTERM
        change.setattr(SweepProgress, "tell", lambda *_: signal.raise_signal(stop))
        done = here("sweep", "sweep.yaml", folder=folder)
    assert done.code == 130
    last = "interrupted; 6 runs: 1 optimal, 5 open; sweep again to go on"
    assert done.err.splitlines()[-1] == last
    assert len(table(folder / "sweep.csv")) == 1
    done = here("sweep", "sweep.yaml", folder=folder)
    assert (done.code, len(done.err.splitlines())) == (0, 6)
    assert [row["status"] for row in table(folder / "sweep.csv")] == ENDS


@terminals
@pytest.mark.long
def test_a_terminal_gets_a_bar(folder):
    done = on_terminal("sweep", "sweep.yaml", "--jobs", "2", folder=folder)
    assert done.code == 0
    assert "6/6" in done.err
    assert not any(word in done.out + done.err for word in MISTAKES)


def begun(folder: Path, *arguments: str) -> subprocess.Popen[bytes]:
    """A sweep that has recorded some runs, or some more of them, by now."""
    journal, began = folder / "many.csv.journal", time.monotonic()
    enough = 4 + (len(lines(journal)) if journal.exists() else 0)
    process = subprocess.Popen(
        [sys.executable, "-m", "tsplan", "sweep", "many.yaml", "--jobs", "2", *arguments],
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        cwd=folder,
        env=surroundings({}),
        start_new_session=True,
    )
    while not journal.exists() or len(lines(journal)) < enough:
        assert process.poll() is None
        assert time.monotonic() - began < PATIENCE
        time.sleep(0.02)
    return process


def alive_in_group(group: int) -> list[int]:
    """The processes of a session that still run."""
    found = []
    for place in Path("/proc").iterdir():
        with suppress(OSError, ValueError):
            state, _, _, session = (place / "stat").read_text().rpartition(")")[2].split()[:4]
            if int(session) == group and state != "Z":
                found.append(int(place.name))
    return found


def ended(group: int) -> bool:
    """Whether all processes of a session end, sooner or later."""
    began = time.monotonic()
    while alive_in_group(group):
        if time.monotonic() - began > PATIENCE:
            return False
        time.sleep(0.05)
    return True


@linux
@pytest.mark.long
def test_a_killed_sweep_leaves_no_process_and_loses_what_was_in_flight_alone(folder):
    (folder / "many.yaml").write_text(MANY)
    with begun(folder) as process:
        process.kill()
        process.communicate()
    assert ended(process.pid)
    recorded = len(lines(folder / "many.csv.journal"))
    assert not (folder / "many.csv").exists()
    with begun(folder) as process:
        os.killpg(process.pid, signal.SIGINT)  # as a terminal does: the workers get it, too
        _, said = process.communicate(timeout=PATIENCE)
    assert process.returncode == 130
    assert ended(process.pid)
    kept = lines(folder / "many.csv.journal")
    assert len(kept) >= recorded
    assert len({json.loads(line)["row"]["id"] for line in kept}) == len(kept)
    assert all(json.loads(line)["row"]["status"] == "optimal" for line in kept)
    assert len(table(folder / "many.csv")) == len(kept)
    assert b"interrupted; 400 runs: " in said


@linux
@pytest.mark.long
def test_workers_that_are_killed_are_replaced(folder):
    (folder / "many.yaml").write_text(MANY.replace("400", "60"))
    with begun(folder, "--json") as process:
        for child in Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split():
            words = Path(f"/proc/{child}/cmdline").read_bytes()
            if b"spawn_main" in words:
                os.kill(int(child), signal.SIGKILL)
        process.communicate(timeout=PATIENCE)
    assert process.returncode == 0
    ends = [row["error_kind"] or row["status"] for row in table(folder / "many.csv")]
    assert len(ends) == 60
    assert 1 <= ends.count("CrashError") <= 2
    assert ends.count("optimal") == 60 - ends.count("CrashError")
    again = here("sweep", "many.yaml", "--retry", "--quiet", folder=folder)
    assert again.code == 0
    assert {row["status"] for row in table(folder / "many.csv")} == {"optimal"}
