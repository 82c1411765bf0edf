"""What several files of tests are given: a small mission in a folder, and every usable solver."""

from __future__ import annotations

from pathlib import Path

import pytest

from tsplan.errors import SolverUnavailableError
from tsplan.milp.solver import Solver, installed, solver

MAP = "waiting: true\nstates: {p: {labels: [A]}, q: {labels: [B]}}\nedges: [[p, q, 1], [q, p, 1]]\n"
MISSION = """\
format: tsplan-mission/1
name: there and back
map: map.yaml
team: [{class: a, count: 2, at: p, capabilities: [see]}]
spec: {language: mtl, formula: "F[0,3] sum(B, see) >= 2 && F[4,6] sum(A) >= 2"}
objective: [travel]
"""


@pytest.fixture
def inside(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty folder to work in."""
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.fixture
def folder(inside: Path) -> Path:
    """A folder with a map of two states and a mission on it, to work in."""
    (inside / "map.yaml").write_text(MAP)
    (inside / "mission.yaml").write_text(MISSION)
    return inside


@pytest.fixture(params=installed())
def any_solver(request: pytest.FixtureRequest) -> Solver:
    """Every solver that is installed, PuLP's each on its own; skipped where it is not licensed."""
    try:
        return solver(request.param)
    except SolverUnavailableError as error:
        pytest.skip(str(error))
