"""What several files of tests are given: a folder to work in, and every usable solver."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.missions import FILES
from tsplan.errors import SolverUnavailableError
from tsplan.milp.solver import Solver, installed, solver


@pytest.fixture
def folder(request: pytest.FixtureRequest, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder to work in, with the texts that the tests' module has in FILES, or a mission."""
    for name, text in getattr(request.module, "FILES", FILES).items():
        (tmp_path / name).write_text(text, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.fixture(params=installed())
def any_solver(request: pytest.FixtureRequest) -> Solver:
    """Every solver that is installed, PuLP's each on its own; skipped where it is not licensed."""
    try:
        return solver(request.param)
    except SolverUnavailableError as error:
        pytest.skip(str(error))
