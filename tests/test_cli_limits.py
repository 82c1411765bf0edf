"""`tsplan plan` obeys its limit and every wish to stop, and keeps the best plan it has."""

from __future__ import annotations

import faulthandler
import json
import multiprocessing
import os
import signal
import time
from dataclasses import replace
from pathlib import Path

import pytest

import tsplan
from tests.command_line import linux, posix, python, started
from tests.seeds import long, sampled
from tsplan.cli import main
from tsplan.process.grace_period import GracePeriod
from tsplan.run.events import FINISHING, Bound, Incumbent, Stage
from tsplan.run.isolate import Forward

MISSION = """\
format: tsplan-mission/1
name: there and back
map: {waiting: true, states: {p: {labels: [A]}, q: {labels: [B]}}, edges: [[p, q, 1], [q, p, 1]]}
team: [{class: a, count: 2, at: p}]
spec: {language: mtl, formula: "F[0,3] sum(B) >= 2 && F[4,6] sum(A) >= 2"}
objective: [travel]
"""
FILES = {"mission.yaml": MISSION}


@pytest.fixture(autouse=True)
def _impatient(monkeypatch):
    """Tests need not wait as long as people."""
    short = GracePeriod(0.2, 0.2, finishing=0.5, settling=0.2, poll=0.02)
    monkeypatch.setattr("tsplan.process.child_process.CHILD", short)


def planning(monkeypatch, then):
    """Let the child find a plan, tell of it, and then do something else."""
    honest = tsplan.plan

    def plan(mission, *, on_event, **options):
        with Path("tries").open("a") as file:
            file.write("x")
        made = honest(mission, **options)
        best = replace(made, status="feasible", stopped_by="interrupt")
        forward = Forward(on_event._send)
        forward(Incumbent("travel", 4.0, 2.0, 0.1, lambda: best))
        return then()

    monkeypatch.setattr("tsplan.run.planner.plan", plan)


def end(number):
    os.kill(os.getpid(), number)
    time.sleep(30)


def planned(*arguments):
    """The exit code and the plan that is printed."""
    code = main(["plan", "mission.yaml", "--json", "-o", "plan.json", *arguments])
    return code, json.loads(Path("plan.json").read_text())


@linux
def test_a_stopped_child_is_ended_and_its_best_plan_kept(folder, capsys, monkeypatch):
    planning(monkeypatch, lambda: end(signal.SIGSTOP))
    code, plan = planned("--time-limit", "1")
    assert code == 0
    assert (plan["status"], plan["stopped_by"], plan["verified"]) == (
        "feasible",
        "time_limit",
        True,
    )
    assert plan["objective"][0]["value"] == 4
    assert "did not stop in time" in capsys.readouterr().err


@linux
def test_a_stopped_child_without_a_plan_is_no_plan_found(folder, capsys, monkeypatch):
    monkeypatch.setattr("tsplan.run.planner.plan", lambda *_, **__: end(signal.SIGSTOP))
    code, plan = planned("--time-limit", "0.1", "--quiet")
    assert (code, plan["status"], plan["stopped_by"]) == (4, "no_plan_found", "time_limit")
    assert "there is no plan" in capsys.readouterr().err


def exhausted():
    raise MemoryError


def aborted():
    faulthandler.disable()  # the crash is meant, and need not be described
    os.write(2, b"terminate called after throwing an instance of 'std::bad_alloc'\n")
    os.kill(os.getpid(), signal.SIGABRT)


@linux
@pytest.mark.parametrize("way", [exhausted, aborted, lambda: end(signal.SIGKILL)])
@pytest.mark.parametrize("known", [False, True])
def test_a_child_out_of_memory_is_not_started_again(folder, capsys, monkeypatch, way, known):
    planning(monkeypatch, way)
    if not known:
        monkeypatch.setattr(Forward, "_hand_over", lambda *_: None)
    code, plan = planned()
    assert Path("tries").read_text() == "x"
    assert (code, plan["stopped_by"]) == (0 if known else 4, "memory")
    assert plan["verified"] == known
    assert "memory" in capsys.readouterr().err.splitlines()[-1]


@linux
def test_the_best_plan_survives_two_crashes(folder, capsys, monkeypatch):
    def crash():
        faulthandler.disable()
        end(signal.SIGSEGV)

    planning(monkeypatch, crash)
    code, plan = planned()
    assert Path("tries").read_text() == "xx"
    assert (code, plan["status"]) == (0, "feasible")
    assert any("SIGSEGV" in note for note in plan["notes"])


@linux
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_deaf_child_is_ended_soon_after_it_was_asked(folder, capsys, monkeypatch, number):
    def deaf():
        signal.signal(signal.SIGINT, signal.SIG_IGN)
        os.kill(os.getppid(), number)
        time.sleep(30)

    planning(monkeypatch, deaf)
    code, plan = planned()
    assert (code, plan["status"], plan["stopped_by"]) == (0, "feasible", "interrupt")


@linux
def test_ctrl_c_while_the_plan_is_written_loses_nothing(folder, capsys, monkeypatch):
    honest = tsplan.save_plan

    def interrupted(plan, path):
        os.kill(os.getpid(), signal.SIGINT)
        honest(plan, path)

    monkeypatch.setattr("tsplan.cli.plan_command.save_plan", interrupted)
    code, plan = planned()
    assert (code, plan["status"]) == (0, "optimal")


def test_ctrl_c_while_paths_are_made_loses_nothing(folder):
    def press(event):
        if isinstance(event, Stage) and event.name == FINISHING:
            signal.raise_signal(signal.SIGINT)

    plan = tsplan.plan(tsplan.load_mission("mission.yaml"), on_event=press)
    assert (plan.status, plan.stopped_by) == ("optimal", None)


@pytest.mark.parametrize("limit", [None, 1000.0])
def test_a_wish_to_stop_is_no_time_limit(folder, limit):
    pressed = []

    def press(event):
        if not pressed:  # a second time would interrupt for good
            pressed.append(event)
            signal.raise_signal(signal.SIGINT)

    for listener in (press, lambda _: True):
        plan = tsplan.plan(tsplan.load_mission("mission.yaml"), on_event=listener, time_limit=limit)
        assert plan.stopped_by in (None, "interrupt")
        assert plan.status in ("no_plan_found", "feasible", "optimal")


def test_memory_that_runs_out_in_process_leaves_the_best_plan(folder, monkeypatch):
    honest = tsplan.Problem.solve

    def solve(self, effort, clock, tell):
        assert honest(self, effort, clock, tell).point is not None
        raise MemoryError

    monkeypatch.setattr(tsplan.Problem, "solve", solve)
    plan = tsplan.plan(tsplan.load_mission("mission.yaml"))
    assert (plan.status, plan.stopped_by, plan.verified) == ("feasible", "memory", True)
    assert plan.objective[0].value == 4
    monkeypatch.setattr(tsplan.Problem, "prepared", lambda *_: exhausted())
    plan = tsplan.plan(tsplan.load_mission("mission.yaml"))
    assert (plan.status, plan.stopped_by) == ("no_plan_found", "memory")


def test_events_and_plans_never_carry_what_is_infinite(folder):
    from tsplan.run.mission_run import MissionRun  # noqa: PLC0415 - loads a solver

    heard = []
    mission = tsplan.load_mission("mission.yaml")
    run = MissionRun(tsplan.Problem(mission), tsplan.SolverChoice(), heard.append)
    run.tell("travel", None, float("inf"), float("-inf"))
    run.tell("travel", None, float("nan"), 3.0)
    run.tell("travel", None, 4.0, float("inf"))
    assert [type(event) for event in heard] == [Stage, Bound, Bound]
    assert [(e.objective, e.bound) for e in heard[1:]] == [(None, 3.0), (4.0, None)]


def slow_reading(path):
    while True:
        try:
            time.sleep(0.01)
        except Exception:  # noqa: BLE001 - readers may catch what goes wrong
            continue


@pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="needs the system's timer")
def test_the_limit_holds_while_the_mission_is_read(folder, capsys, monkeypatch):
    monkeypatch.setattr("tsplan.cli.inputs.load_any_mission", slow_reading)
    monkeypatch.setattr("tsplan.cli.inputs._READING", 0.0)
    for command in ("plan", "explain"):
        assert main([command, "mission.yaml", "--time-limit", "0.2"]) == 4
        assert capsys.readouterr().err == "the time limit was reached while the mission was read\n"
    assert signal.getitimer(signal.ITIMER_REAL) == (0.0, 0.0)


BACKGROUND = """
import os, signal, sys
import tsplan.run.isolate as running, tsplan.run.planner as planner
from tsplan.cli import main

for name in sys.argv[1:]:
    signal.signal(getattr(signal, name), signal.SIG_IGN)
honest = planner.plan
def hit(mission, **options):
    for name in sys.argv[1:]:
        os.kill(os.getppid(), getattr(signal, name))
        if name == "SIGHUP":
            os.kill(os.getpid(), signal.SIGHUP)
    return honest(mission, **options)
planner.plan = hit
sys.exit(main(["plan", "mission.yaml", "-o", "plan.json"]))
"""


@linux
@pytest.mark.parametrize(
    "names", sampled([("SIGHUP",), ("SIGINT",), ("SIGHUP", "SIGINT")], [("SIGHUP", "SIGINT")])
)
def test_what_is_ignored_stays_ignored(folder, names):
    done = python("-c", BACKGROUND, *names)
    assert done.code == 0, done.err
    assert "stopping" not in done.err
    assert json.loads(Path("plan.json").read_text())["status"] == "optimal"


READING = """
import sys, time
import tsplan.cli.inputs
from tsplan.cli import main

def slow(path):
    print("reading", flush=True)
    time.sleep(60)

tsplan.cli.inputs.load_any_mission = slow
sys.exit(main(["plan", "mission.yaml"]))
"""


@posix
@pytest.mark.parametrize(("number", "code"), [long(signal.SIGTERM, -15), (signal.SIGINT, 130)])
def test_signals_end_the_reading(folder, number, code):
    with started(READING) as process:
        assert process.stdout.readline() == "reading\n"
        process.send_signal(number)
        _, err = process.communicate(timeout=20)
    assert process.returncode == code
    assert err in ("", "interrupted\n")


def in_a_worker(codes):
    codes.put(main(["plan", "mission.yaml", "-o", "plan.json"]))
    codes.put(main(["explain", "mission.yaml", "--json"]))


@linux
def test_the_command_line_works_inside_a_daemonic_worker(folder):
    context = multiprocessing.get_context("fork")
    codes = context.SimpleQueue()
    worker = context.Process(target=in_a_worker, args=(codes,), daemon=True)
    worker.start()
    assert (codes.get(), codes.get()) == (0, 0)
    worker.join(10)
    assert json.loads((folder / "plan.json").read_text())["verified"]


def test_backends_of_pulp_hear_a_wish_to_stop(folder, monkeypatch):
    pytest.importorskip("pulp")
    from tsplan.milp.pulp import Pulp  # noqa: PLC0415 - only where PuLP is

    if not Pulp().availability().usable:
        pytest.skip("PuLP finds no solver here")
    heard = []
    honest = Pulp.solve

    def solve(self, model, options=None, watch=None):
        heard.append(options.stop is not None and options.stop() is False)
        return honest(self, model, options, watch)

    monkeypatch.setattr(Pulp, "solve", solve)
    off = ("tree", "dive")
    plan = tsplan.plan(tsplan.load_mission("mission.yaml"), solver="pulp", without=off)
    assert plan.status == "optimal"
    assert heard
    assert all(heard)
