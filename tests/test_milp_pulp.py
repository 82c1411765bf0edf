"""What PuLP 3 and PuLP 4 say, and what is made of it; neither has to be installed."""

from __future__ import annotations

import subprocess
import sys
import threading
import time
from types import SimpleNamespace

import numpy as np
import pytest

from tsplan.errors import SolverError, SolverUnavailableError
from tsplan.milp.model import Model
from tsplan.milp.pulp_terms import UnclearError, raw_result
from tsplan.milp.request import RawResult, Request
from tsplan.milp.solution import Options, Status
from tsplan.process.descendants import INTERRUPT, KILL, Descendants
from tsplan.stopping import StoppedBy


@pytest.mark.parametrize(
    ("status", "sol_status", "claim"),
    [
        (1, 1, Status.OPTIMAL),
        (1, 2, Status.UNKNOWN),  # "Optimal", but stopped by its time limit
        (0, 0, Status.UNKNOWN),
        (0, -1, Status.UNKNOWN),  # PuLP's translation of "not solved" is no proof
        (-1, -1, Status.INFEASIBLE),
        (-1, 0, Status.INFEASIBLE),
        (-2, -2, Status.INFEASIBLE),
    ],
)
def test_pulp_3(status: int, sol_status: int, claim: Status) -> None:
    problem = SimpleNamespace(status=status, sol_status=sol_status)
    assert raw_result(problem, status).status is claim


@pytest.mark.parametrize(
    ("status", "claim", "stopped_by"),
    [
        (1, Status.OPTIMAL, None),
        (-7, Status.OPTIMAL, None),
        (-4, Status.UNKNOWN, StoppedBy.TIME_LIMIT),
        (-5, Status.UNKNOWN, StoppedBy.MEMORY),
        (-10, Status.UNKNOWN, None),
        (-11, Status.UNKNOWN, None),
        (-1, Status.INFEASIBLE, None),
        (-2, Status.INFEASIBLE, None),
    ],
)
def test_pulp_4(status: int, claim: Status, stopped_by: StoppedBy | None) -> None:
    stats = SimpleNamespace(status=status, has_solution=True, best_bound=1e9, status_str="")
    said = raw_result(object(), stats)
    assert (said.status, said.stopped_by, said.bound) == (claim, stopped_by, None)


def test_no_answer_is_an_error() -> None:
    with pytest.raises(SolverError, match="without an answer"):
        raw_result(SimpleNamespace(status=-3, sol_status=-1), -3)
    for status in (0, -3, -12):
        stats = SimpleNamespace(status=status, has_solution=False, best_bound=None, status_str="?")
        with pytest.raises(SolverError, match="without an answer"):
            raw_result(object(), stats)


@pytest.mark.parametrize("point", [None, np.array([3.0])])
def test_either_infeasible_or_unbounded_is_asked_again(monkeypatch, point) -> None:
    from tests.test_milp_solvers import made  # noqa: PLC0415
    from tsplan.milp.pulp import _Solve  # noqa: PLC0415

    asked: list[Model] = []

    def run(_: _Solve, model: Model) -> RawResult:
        asked.append(model)
        if model.objective.any():
            raise UnclearError("PuLP's solver ended without an answer (Undefined)")
        return RawResult(Status.INFEASIBLE if point is None else Status.OPTIMAL, point)

    monkeypatch.setattr(_Solve, "_run", run)
    falling = made([-1], [[1]], [2], [np.inf])
    if point is None:
        answered = _Solve("ANY", Request(falling, Options())).answer()
        assert answered.status is Status.INFEASIBLE
    else:
        with pytest.raises(SolverError, match="unbounded"):
            _Solve("ANY", Request(falling, Options())).answer()
    assert len(asked) == 2
    bounded = made([-1], [[1]], [2], [np.inf], upper=[9])
    with pytest.raises(UnclearError):
        _Solve("ANY", Request(bounded, Options())).answer()


def test_a_missing_backend_is_refused_with_those_that_are_there() -> None:
    pytest.importorskip("pulp")
    from tsplan.milp.pulp import Pulp, backends  # noqa: PLC0415 - only where PuLP is

    missing = Pulp("NO_SUCH_CMD")
    state = missing.availability()
    assert state.installed
    assert not state.usable
    assert all(name in state.remedy for name in backends())
    assert missing.features == frozenset()
    with pytest.raises(SolverUnavailableError, match="PuLP finds here"):
        missing.native(None)


def test_a_point_with_few_digits_is_polished() -> None:
    pytest.importorskip("pulp")
    from tests.test_milp_solvers import made  # noqa: PLC0415
    from tsplan.milp.pulp import _polished  # noqa: PLC0415 - only where PuLP is

    model = made([1, 0], [[1e6, -1]], [0], [0], upper=[9, 1e8], integer=[False, True], lower=[0, 7])
    point = _polished(model, np.array([7.1e-6, 7.0]))
    assert model.violation(point) <= 1e-6
    assert _polished(model.with_bounds(model.lower, np.array([0.0, 9.0])), np.ones(2)) is None


@pytest.mark.skipif(sys.platform != "linux", reason="needs /proc")
def test_offspring_are_this_threads_processes_alone() -> None:
    descendants = Descendants()
    descendants.send(INTERRUPT)  # nobody yet
    descendants.thread = threading.get_native_id()
    command = [sys.executable, "-c", "import time; time.sleep(30)"]
    mine = subprocess.Popen(command, stderr=subprocess.DEVNULL)
    time.sleep(0.1)
    descendants.send(KILL)
    assert mine.wait(5) < 0
