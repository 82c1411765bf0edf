"""Sweeps on a cluster of Dask; what is said where it is not there."""

from __future__ import annotations

import importlib.util
import os
import signal

import pytest

import tsplan
from tests.command_line import here, posix
from tests.sweeping import ENDS, FILES, lines, table

__all__ = ["FILES"]  # for the folder

MANY = "format: tsplan-sweep/1\nmission: mission.yaml\nrepeat: 40\n"
there = importlib.util.find_spec("distributed") is not None
cluster = pytest.mark.skipif(not there, reason="needs Dask's distributed")


@pytest.mark.skipif(there, reason="needs that Dask is away")
def test_what_a_cluster_needs_is_said(folder):
    done = here("sweep", "sweep.yaml", "--dask", "local", folder=folder)
    assert done.code == 5
    assert done.err.endswith("which is not installed; pip install 'tsplan[cluster]'\n")


@cluster
@pytest.mark.long
def test_the_command_runs_on_a_local_cluster(folder):
    done = here("sweep", "sweep.yaml", "--dask", "local", "--jobs", "2", folder=folder)
    assert done.code == 0, done.err
    assert [row["status"] for row in table(folder / "sweep.csv")] == ENDS
    wrong = here("sweep", "sweep.yaml", "--fresh", "--dask", "nowhere", folder=folder)
    assert (wrong.code, "check the address" in wrong.err) == (5, True)


@posix
@cluster
@pytest.mark.long
def test_a_worker_that_is_killed_costs_no_run(folder):
    from distributed import Client, LocalCluster  # noqa: PLC0415  (may be missing)

    (folder / "many.yaml").write_text(MANY)
    options = {"n_workers": 2, "threads_per_worker": 1, "dashboard_address": None}
    with LocalCluster(**options) as place, Client(place) as client:
        workers = client.run(os.getpid)
        killed = []

        def kill(row):
            if len(lines(folder / "out.csv.journal")) == 3:
                killed.append(next(iter(workers.values())))
                os.kill(killed[0], signal.SIGKILL)

        executor = client.get_executor(pure=False)
        rows = tsplan.sweep("many.yaml", executor=executor, csv="out.csv", on_result=kill)
        assert killed
        assert killed[0] not in client.run(os.getpid).values()  # another has taken its place
    assert [row["status"] for row in rows] == ["optimal"] * 40
    assert len(lines(folder / "out.csv.journal")) == 40
