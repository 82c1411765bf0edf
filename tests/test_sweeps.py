"""Sweeps: rows, the journal and resuming from it, what fails, and who does the work."""

from __future__ import annotations

import json
import os
import signal
import time
from concurrent.futures import CancelledError, Executor, Future, ThreadPoolExecutor
from concurrent.futures.process import BrokenProcessPool

import pytest

import tsplan
from tests.command_line import posix
from tests.missions import FILES as MISSION_FILES
from tests.seeds import sampled
from tests.sweeping import ENDS, FILES, lines, table
from tsplan.errors import InputError, SolverError
from tsplan.signals.signal_files import signal_mission_from_text
from tsplan.sweeps.run_answer import answer_of
from tsplan.sweeps.sweep_draft import load_sweep
from tsplan.sweeps.sweep_rows import DTYPES, SweepResults, SweepRow
from tsplan.sweeps.sweeping import Sweeping
from tsplan.sweeps.worker_pool import WorkerPool

__all__ = ["FILES"]  # for the folder


class Told(Executor):
    """Does what it is told to with each of its jobs, and counts them."""

    def __init__(self, act):
        self.act = act
        self.jobs = 0

    def submit(self, job, /, *given, **named):
        self.jobs += 1
        future = Future()
        self.act(self.jobs, future, lambda: job(*given, **named))
        return future


def done(_number, future, job):
    future.set_result(job())


def test_a_row_says_how_a_run_ended_and_a_table_is_typed(folder):
    heard = []
    rows = tsplan.sweep("sweep.yaml", csv="out.csv", plans=folder, on_result=heard.append)
    assert isinstance(rows, SweepResults)
    assert list(rows) == heard
    assert [row["status"] for row in rows] == ENDS
    assert [row.failed for row in rows] == [end == "error" for end in ENDS]
    first, never, torn = rows[:3]
    assert first["value.travel"] == first["bound.travel"] == 1
    assert (first["horizon"], first["formula"], first["steps"]) == (6, "near", 6)
    assert (first["agents"], first["verified"], first["used.solver"]) == (2, True, "highs")
    assert first["seconds.wall"] >= first["seconds.total"] > 0
    assert (never["error"], never.get("value.travel")) == (None, None)
    assert torn["error_kind"] == "MissionError"
    assert torn["error"].startswith("sweep.yaml:8:18: ")
    with pytest.raises(KeyError):
        torn["nothing"]

    read = table(folder / "out.csv")
    assert [row["id"] for row in read] == [row.id for row in rows]
    assert tuple(read[0]) == rows.columns == tuple(rows.dtypes)
    assert set(rows.columns) == {*DTYPES, "horizon", "formula", "value.travel", "bound.travel"}
    readers = {"Int64": int, "Float64": float, "boolean": json.loads, "string": str}
    for row, cells in zip(rows, read, strict=True):
        for column, cell in cells.items():
            value = readers[rows.dtypes[column]](cell) if cell else None
            assert value == row.get(column), column
    assert rows.dtypes["horizon"] == "Int64"

    # the plan of each run that has one is there, with the mission that it is of
    plans = {path.stem for path in folder.glob("*.json")}
    assert plans == {row.id for row in rows if row["status"] == "optimal"}
    mission = tsplan.load_mission(folder / f"{first.id}.mission.yaml")
    plan = tsplan.load_plan(folder / f"{first.id}.json")
    assert tsplan.check(mission, plan).ok
    assert (plan.mission.sha256, mission.horizon) == (mission.digest, 6)


@pytest.mark.parametrize(
    ("values", "dtype", "cells"),
    [
        ([1, 2], "Int64", ["1", "2"]),
        ([1, 2.5], "Float64", ["1.0", "2.5"]),
        ([True, None], "boolean", ["true", ""]),
        ([True, 1], "string", ["true", "1"]),
        (["a", 'b,"c"'], "string", ["a", 'b,"c"']),
        ([["travel"], {"a": 1}], "string", ['["travel"]', '{"a": 1}']),
        ([2**63, 1], "Float64", [repr(2.0**63), "1.0"]),
    ],
)
def test_axes_have_the_type_of_all_their_values(tmp_path, values, dtype, cells):
    rows = SweepResults(SweepRow({"axis": value}, {"id": "x"}) for value in values)
    assert rows.dtypes["axis"] == dtype
    rows.to_csv(tmp_path / "t.csv")
    assert [row["axis"] for row in table(tmp_path / "t.csv")] == cells


def test_what_is_recorded_is_not_done_again(folder):
    journal = folder / "out.csv.journal"

    def swept(**options):
        executor = Told(done)
        rows = tsplan.sweep("sweep.yaml", executor=executor, csv="out.csv", **options)
        assert [row["status"] for row in rows] == ENDS
        assert [row["status"] for row in table(folder / "out.csv")] == ENDS
        return executor.jobs

    assert swept() == 6
    assert swept() == 0
    # the last line was not finished, and one before was torn
    whole = lines(journal)
    journal.write_text("\n".join([*whole[:3], whole[3][:50], *whole[4:5], whole[5][:-1]]))
    assert swept() == 2
    assert all(json.loads(line)["row"] for line in lines(journal)[:3] + lines(journal)[4:])
    assert len(lines(journal)) == 7
    assert swept() == 0
    assert swept(retry=True) == 2
    assert swept(fresh=True) == 6
    assert len(lines(journal)) == 6
    # what a run depends on has changed
    assert swept(time_limit=50) == 6
    text = MISSION_FILES["map.yaml"].replace("[A]", "[A, C]")
    (folder / "map.yaml").write_text(text)
    assert swept(time_limit=50) == 6
    assert swept(time_limit=50) == 0


def test_each_row_is_recorded_before_it_is_told(folder):
    seen = []
    journal = folder / "out.csv.journal"
    tsplan.sweep("sweep.yaml", csv="out.csv", on_result=lambda _: seen.append(len(lines(journal))))
    assert seen == [1, 2, 3, 4, 5, 6]


@pytest.mark.parametrize("error", [BrokenProcessPool("gone"), MemoryError(), RuntimeError("odd")])
def test_runs_that_are_lost_are_rows_and_the_sweep_goes_on(folder, error):
    def act(number, future, job):
        if number == 3:
            raise BrokenProcessPool("no more")
        if number == 2:
            future.set_exception(error)
        else:
            done(number, future, job)

    rows = tsplan.sweep("sweep.yaml", executor=Told(act), csv="out.csv")
    kinds = [None, "CrashError", "CrashError", None, None, "MissionError"]
    assert [row["error_kind"] for row in rows] == kinds
    assert "worker" in rows[2]["error"]
    assert len(table(folder / "out.csv")) == 6


def test_runs_that_an_executor_drops_are_left_open(folder):
    def act(number, future, job):
        if number == 2:
            future.cancel()
            future.set_running_or_notify_cancel()
        else:
            done(number, future, job)

    with pytest.raises(SolverError, match="1 runs were cancelled"):
        tsplan.sweep("sweep.yaml", executor=Told(act), csv="out.csv")
    assert len(table(folder / "out.csv")) == 5
    executor = Told(done)
    assert len(tsplan.sweep("sweep.yaml", executor=executor, csv="out.csv")) == 6
    assert executor.jobs == 1


def test_errors_of_solvers_and_of_the_program_are_rows(folder, monkeypatch):
    first = load_sweep("sweep.yaml")[0]
    missing = first.chosen(tsplan.SolverChoice("pulp:NOT_THERE"))
    row = answer_of(missing).row
    assert (row["status"], row["error_kind"]) == ("error", "SolverUnavailableError")
    limited = answer_of(first.chosen(tsplan.SolverChoice(time_limit=1e-6))).row
    assert limited["stopped_by"] in ("time_limit", None)

    def broken(*_):
        raise ZeroDivisionError

    monkeypatch.setattr("tsplan.sweeps.run_answer.order_for", broken)
    row = answer_of(first).row
    assert row["error"].startswith("internal error in broken, line ")


@pytest.mark.parametrize("threads", sampled([False, True], [False]))
def test_missions_of_both_kinds_are_swept(threads):
    team = tsplan.Mission.of(
        map=tsplan.TransitionSystem.build([tsplan.State("p")], [tsplan.Edge("p", "p", 1)]),
        team=[{"class": "a", "at": "p"}],
        formula="F[0,2] p",
        name="team",
    )
    text = 'format: tsplan-signals/1\nname: wave\nsignals: {x: [0, 9]}\nspec: "F[0,3] x >= 5"\n'
    wave = signal_mission_from_text(text)
    with ThreadPoolExecutor(2) if threads else Told(done) as executor:
        rows = tsplan.sweep([team, wave], executor=executor)
    assert [(row["mission"], row["status"]) for row in rows] == [
        ("team", "optimal"),
        ("wave", "optimal"),
    ]
    assert rows[1]["robustness"] == pytest.approx(4)
    assert rows[0]["value.travel"] == 0
    assert "value.robustness" in rows.columns
    assert [run["mission"] for run in tsplan.sweep([wave, wave], executor=Told(done))] == [1, 2]


@pytest.mark.parametrize("options", [{"jobs": 0}, {"time_limit": -1}, {"seed": 1.5}])
def test_options_are_checked_before_anything_is_done(options):
    with pytest.raises(InputError):
        tsplan.sweep([], **options)


@posix
def test_ctrl_c_keeps_what_is_done(folder):
    def stop(_):
        signal.raise_signal(signal.SIGINT)

    with pytest.raises(KeyboardInterrupt):
        tsplan.sweep("sweep.yaml", csv="out.csv", on_result=stop)
    assert len(table(folder / "out.csv")) == len(lines(folder / "out.csv.journal")) == 1
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
    assert len(tsplan.sweep("sweep.yaml", csv="out.csv")) == 6


@posix
def test_a_run_that_was_interrupted_is_not_recorded(folder, monkeypatch):
    def interrupted(run, keep, requests=None):
        row = answer_of(run, keep).row
        return type("", (), {"row": SweepRow(row.axes, {**row.cells, "stopped_by": "interrupt"})})

    monkeypatch.setattr("tsplan.sweeps.sweeping.answer_of", interrupted)
    sweeping = Sweeping(load_sweep("sweep.yaml"))
    with pytest.raises(KeyboardInterrupt):
        sweeping.work()
    assert sweeping.results == ()


@posix
def test_a_worker_that_dies_takes_its_own_job_alone():
    pool = WorkerPool(2)
    dying, other = pool.submit(os._exit, 3), pool.submit(pow, 2, 3)
    assert other.result() == 8
    with pytest.raises(BrokenProcessPool):
        dying.result()
    again = [pool.submit(os.getpid), pool.submit(os.getpid)]
    assert len({future.result() for future in again} - {os.getpid()}) == 2
    began, asleep = time.monotonic(), pool.submit(time.sleep, 600)
    pool.shutdown(cancel_futures=True)
    with pytest.raises((BrokenProcessPool, CancelledError)):
        asleep.result()
    assert time.monotonic() - began < 300  # it was not waited for
