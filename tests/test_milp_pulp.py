"""What PuLP 3 and PuLP 4 say, and what is made of it; neither has to be installed."""

from __future__ import annotations

import subprocess
import sys
import time
from types import SimpleNamespace

import numpy as np
import pytest

from tsplan.errors import SolverError, SolverUnavailableError
from tsplan.milp.descendants import Offspring
from tsplan.milp.model import Model
from tsplan.milp.pulp_terms import UnclearError, told
from tsplan.milp.solution import Options
from tsplan.milp.verdict import Ending, Question, Verdict
from tsplan.stopping import StoppedBy


@pytest.mark.parametrize(
    ("status", "sol_status", "verdict"),
    [
        (1, 1, Verdict.SOLVED),
        (1, 2, Verdict.ENDED),  # "Optimal", but stopped by its time limit
        (0, 0, Verdict.ENDED),
        (0, -1, Verdict.ENDED),  # PuLP's translation of "not solved" is no proof
        (-1, -1, Verdict.REFUTED),
        (-1, 0, Verdict.REFUTED),
        (-2, -2, Verdict.REFUTED),
    ],
)
def test_pulp_3(status: int, sol_status: int, verdict: Verdict) -> None:
    problem = SimpleNamespace(status=status, sol_status=sol_status)
    assert told(problem, status).verdict is verdict


@pytest.mark.parametrize(
    ("status", "verdict", "stopped_by"),
    [
        (1, Verdict.SOLVED, None),
        (-7, Verdict.SOLVED, None),
        (-4, Verdict.ENDED, StoppedBy.TIME_LIMIT),
        (-5, Verdict.ENDED, StoppedBy.MEMORY),
        (-10, Verdict.ENDED, None),
        (-11, Verdict.ENDED, None),
        (-1, Verdict.REFUTED, None),
        (-2, Verdict.REFUTED, None),
    ],
)
def test_pulp_4(status: int, verdict: Verdict, stopped_by: StoppedBy | None) -> None:
    stats = SimpleNamespace(status=status, has_solution=True, best_bound=1e9, status_str="")
    said = told(object(), stats)
    assert (said.verdict, said.stopped_by, said.bound) == (verdict, stopped_by, None)


def test_no_answer_is_an_error() -> None:
    with pytest.raises(SolverError, match="without an answer"):
        told(SimpleNamespace(status=-3, sol_status=-1), -3)
    for status in (0, -3, -12):
        stats = SimpleNamespace(status=status, has_solution=False, best_bound=None, status_str="?")
        with pytest.raises(SolverError, match="without an answer"):
            told(object(), stats)


@pytest.mark.parametrize("point", [None, np.array([3.0])])
def test_either_infeasible_or_unbounded_is_asked_again(monkeypatch, point) -> None:
    from tests.test_milp_solvers import made  # noqa: PLC0415
    from tsplan.milp.pulp import _Solve  # noqa: PLC0415

    asked: list[Model] = []

    def run(_: _Solve, model: Model) -> Ending:
        asked.append(model)
        if model.objective.any():
            raise UnclearError("PuLP's solver ended without an answer (Undefined)")
        return Ending(Verdict.REFUTED if point is None else Verdict.SOLVED, point)

    monkeypatch.setattr(_Solve, "_run", run)
    falling = made([-1], [[1]], [2], [np.inf])
    if point is None:
        ending = _Solve("ANY", Question(falling, Options()), 0.0).ending()
        assert ending.verdict is Verdict.REFUTED
    else:
        with pytest.raises(SolverError, match="unbounded"):
            _Solve("ANY", Question(falling, Options()), 0.0).ending()
    assert len(asked) == 2
    bounded = made([-1], [[1]], [2], [np.inf], upper=[9])
    with pytest.raises(UnclearError):
        _Solve("ANY", Question(bounded, Options()), 0.0).ending()


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
    offspring = Offspring()
    offspring.interrupt()  # nobody yet
    offspring.mine()
    command = [sys.executable, "-c", "import time; time.sleep(30)"]
    mine = subprocess.Popen(command, stderr=subprocess.DEVNULL)
    time.sleep(0.1)
    offspring.kill()
    assert mine.wait(5) < 0
