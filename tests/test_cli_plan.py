"""`tsplan plan` from one end to the other: output, exit codes, crashes and interruption."""

from __future__ import annotations

import faulthandler
import json
import os
import signal
import time

import pytest

import tsplan
from tests.command_line import linux, started
from tests.missions import MISSION
from tests.seeds import long
from tsplan.cli import main
from tsplan.cli.progress import Progress
from tsplan.plans.outcomes import MissionRef
from tsplan.run.events import Bound, Incumbent, Stage
from tsplan.run.isolate import Forward


def test_a_plan_is_printed_written_and_checked(folder, capsys):
    assert main(["plan", "mission.yaml", "-o", "plan.json"]) == 0
    out, err = capsys.readouterr()
    assert "there and back: optimal plan (accepted by the independent check)" in out
    assert "travel 4 (proven: no plan does better)" in out
    assert "a-1..2" in out
    assert "Traceback" not in err
    data = json.loads((folder / "plan.json").read_text())
    assert data["verified"] is True
    assert data["timings"]["load"] > 0
    assert main(["check", "mission.yaml", "plan.json"]) == 0


def test_ideas_are_switched_off_by_name(folder, capsys):
    off = ["--without", "visits", "--without", "reduction"]
    assert main(["plan", "mission.yaml", "--json", "--quiet", *off]) == 0
    full = json.loads(capsys.readouterr().out)
    assert main(["plan", "mission.yaml", "--json", "--quiet"]) == 0
    usual = json.loads(capsys.readouterr().out)
    values = [[(o["name"], o["value"], o["bound"]) for o in x["objective"]] for x in (full, usual)]
    assert values[0] == values[1]
    assert full["size"]["rows"] != usual["size"]["rows"]
    assert main(["plan", "mission.yaml", "--without", "visit"]) == 2
    assert "visits" in capsys.readouterr().err


def test_json_alone_on_stdout(folder, capsys):
    assert main(["plan", "mission.yaml", "--json", "--quiet", "--seed", "1"]) == 0
    out, err = capsys.readouterr()
    assert json.loads(out)["status"] == "optimal"
    assert err == ""


def test_quiet_prints_nothing(folder, capsys):
    assert main(["plan", "mission.yaml", "--quiet", "--encoding", "reference"]) == 0
    assert capsys.readouterr() == ("", "")


def test_infeasible_is_three(folder, capsys):
    (folder / "mission.yaml").write_text(MISSION.replace("F[0,3] sum(B", "F[0,0] sum(B"))
    assert main(["plan", "mission.yaml", "-o", "plan.json"]) == 3
    assert "infeasible" in capsys.readouterr().out
    assert "agents" not in json.loads((folder / "plan.json").read_text())
    assert main(["check", "mission.yaml", "plan.json"]) == 1


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["--solver", "higs"], "there is no solver 'higs'; did you mean 'highs'?"),
        (["-o", "none/plan.json"], "its directory does not exist"),
        (["-o", "."], "this is a directory"),
    ],
)
def test_bad_usage_is_found_before_the_search(folder, capsys, arguments, words):
    assert main(["plan", "mission.yaml", *arguments]) == 2
    assert words in capsys.readouterr().err


def test_warnings_are_shown_and_do_not_stop(folder, capsys):
    text = MISSION.replace("sum(B, see)", "sum(B, sea)").replace(" >= 2 &&", " <= 2 &&")
    (folder / "mission.yaml").write_text(text)
    assert main(["plan", "mission.yaml", "--quiet"]) == 0
    assert "warning: no robot has the capability 'sea'" in capsys.readouterr().err


def crash():
    """What a fault of native code does."""
    faulthandler.disable()  # it is meant, and need not be described
    os.kill(os.getpid(), signal.SIGSEGV)


@linux
def test_a_crash_is_retried_and_said(folder, capsys, monkeypatch):
    honest = tsplan.plan

    def crashing(mission, **options):
        if options["threads"] != 1:
            crash()
        return honest(mission, **options)

    monkeypatch.setattr("tsplan.run.planner.plan", crashing)
    assert main(["plan", "mission.yaml", "--time-limit", "20"]) == 0
    out, err = capsys.readouterr()
    assert "SIGSEGV" in err
    assert "trying once more with one thread" in err
    assert "this is the second, with one thread and seed 1" in " ".join(out.split())


@linux
def test_two_crashes_are_a_failure_in_words(folder, capsys, monkeypatch):
    monkeypatch.setattr("tsplan.run.planner.plan", lambda *_, **__: crash())
    assert main(["plan", "mission.yaml"]) == 5
    out, err = capsys.readouterr()
    assert out == ""
    assert "crashed (SIGSEGV)" in err
    assert "Traceback" not in err


@linux
@pytest.mark.parametrize(
    ("error", "outcome"),
    [
        (tsplan.MissionError([tsplan.Finding("no good", "do better")]), (2, "no good; do better")),
        (tsplan.SolverError("the solver is tired"), (5, "the solver is tired")),
        (KeyError("lost"), (5, "please report")),
    ],
)
def test_errors_in_the_child_arrive_whole(folder, capsys, monkeypatch, error, outcome):
    def failing(*_, **__):
        raise error

    monkeypatch.setattr("tsplan.run.planner.plan", failing)
    code, words = outcome
    assert main(["plan", "mission.yaml"]) == code
    err = capsys.readouterr().err
    assert words in err
    assert len(err.strip().splitlines()) == 1


@linux
def test_an_unchecked_plan_is_not_shown(folder, capsys, monkeypatch):
    def careless(mission, **options):
        ref = MissionRef("m", "")
        paths = (tsplan.AgentPlan("a-1", "a", frozenset(), ((0, 6, "p"),)),)
        return tsplan.Plan("optimal", ref, 6, agents=paths)

    monkeypatch.setattr("tsplan.run.planner.plan", careless)
    assert main(["plan", "mission.yaml", "-o", "plan.json"]) == 5
    assert not (folder / "plan.json").exists()
    assert "not shown" in capsys.readouterr().err


SLOW = """
import sys, time
import tsplan.run.planner
from tsplan.cli import main
from tsplan.run.events import Stage
from tsplan.plans.outcomes import MissionRef
from tsplan.plans.plan import Plan

def slow(mission, *, on_event, **options):
    told = False
    while True:
        try:
            if not told:
                told = True
                on_event(Stage("sleeping", 0.0))
            time.sleep(60)
        except KeyboardInterrupt:
            if STUBBORN:
                continue
            return Plan("no_plan_found", MissionRef("m", ""), 6, stopped_by="interrupt")

tsplan.run.planner.plan = slow
sys.exit(main(["plan", "mission.yaml"]))
"""


@linux
@pytest.mark.parametrize(
    ("number", "stubborn"),
    [
        (signal.SIGINT, True),
        long(signal.SIGTERM, False),
        long(signal.SIGINT, False),
        long(signal.SIGTERM, True),
    ],
)
def test_a_signal_stops_the_search_in_order(folder, number, stubborn):
    with started(f"STUBBORN = {stubborn}\n{SLOW}") as process:
        assert "sleeping" in process.stderr.readline()
        process.send_signal(number)
        assert process.stderr.readline() == "\n"
        assert "once more to stop at once" in process.stderr.readline()
        if stubborn:
            process.send_signal(number)  # at once: still the same request
            time.sleep(0.7)
            process.send_signal(number)
        out, err = process.communicate(timeout=20)
    assert process.returncode == 4
    if stubborn:
        assert "interrupted; there is no plan" in err
    else:
        assert "no plan found, search ended when interrupted" in out


def test_progress_in_plain_lines(capsys):
    with Progress() as progress:
        progress.tell(Stage("travel", 0.1))
        progress.tell(Bound("travel", None, 40.0, 0.2))
        progress.tell(Incumbent("travel", 50.0, 45.0, 0.3))
    lines = capsys.readouterr().err.splitlines()
    assert lines[0].startswith("travel  ")
    assert "travel  best 50  bound 45  gap 10.0%" in lines[-1]
    with Progress(quiet=True) as progress:
        progress.tell(Stage("travel", 0.1))
    assert capsys.readouterr().err == ""


def test_progress_on_a_terminal_is_one_live_line(capsys, monkeypatch):
    monkeypatch.setattr("sys.stderr.isatty", lambda: True)
    with Progress() as progress:
        progress.tell(Incumbent("travel", 50.0, 45.0, 0.3))
        progress.note("by the way")
        assert str(progress._rendered()).startswith("travel  best 50  bound 45  gap 10.0%")
    assert "by the way" in capsys.readouterr().err


@pytest.mark.parametrize("anytime", [True, False])
def test_without_anytime_the_first_plan_asks_the_search_to_stop(anytime):
    sent = []
    forward = Forward(sent.append, anytime=anytime)
    assert not forward(Stage("travel", 0.0))
    assert not forward(Bound("travel", None, 2.0, 0.1))
    assert forward(Incumbent("travel", 4.0, 2.0, 0.3)) is not anytime
    assert len(sent) > 1


def test_a_first_plan_alone_is_checked_too(folder, capsys):
    assert main(["plan", "mission.yaml", "--no-anytime", "--json", "--quiet"]) == 0
    assert json.loads(capsys.readouterr().out)["verified"] is True
