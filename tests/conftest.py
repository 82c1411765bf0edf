"""What several files of tests are given: a folder, a browser, and every usable solver.

Nothing is imported here that the job with rtamt, which has an environment of its own, does without.
"""

from __future__ import annotations

import gc
from collections import defaultdict
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
from hypothesis import HealthCheck, settings

# how long examples take says nothing on a busy machine; the job with rtamt has hypothesis, too
settings.register_profile("unhurried", deadline=None, suppress_health_check=[HealthCheck.too_slow])
settings.load_profile("unhurried")

if TYPE_CHECKING:
    from collections.abc import Iterator

    from tests.browser import Browser
    from tsplan.milp.solver import Solver


def pytest_configure(config: pytest.Config) -> None:
    """Make the tests that are marked `long` where `-m` asks for such, or for all."""
    from tests import seeds  # noqa: PLC0415  (not before hypothesis has its profile)

    marks = config.getoption("markexpr") or "True"
    seeds.whole = bool(eval(marks, {}, defaultdict(bool, long=True)))


def pytest_collection_finish() -> None:
    """Spare the garbage collector what was collected: it is there to the end."""
    gc.collect()
    gc.freeze()


@pytest.fixture
def folder(request: pytest.FixtureRequest, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder to work in, with the texts that the tests' module has in FILES, or a mission."""
    from tests.missions import FILES  # noqa: PLC0415  (not for the job with rtamt)

    for name, text in getattr(request.module, "FILES", FILES).items():
        (tmp_path / name).write_text(text, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.fixture(scope="session")
def chromium(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Browser]:
    """A headless browser, started once; skipped where there is none."""
    from tests.browser import Browser, browser_path  # noqa: PLC0415  (as above)

    if browser_path() is None:
        pytest.skip(
            "needs Chromium or Chrome: install one (Debian's package: chromium), or name its "
            "program in TSPLAN_BROWSER"
        )
    running = Browser(tmp_path_factory.mktemp("profile"))
    yield running
    running.close()


@pytest.fixture(scope="module")
def browser(chromium: Browser) -> Browser:
    """The headless browser for the tests of a module, as it is when it is started."""
    chromium.resize()
    chromium.prefer()
    return chromium


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    """Run tests over solvers with every one that is installed, PuLP's each on its own."""
    if "any_solver" in metafunc.fixturenames:
        from tsplan.milp.solver import installed  # noqa: PLC0415  (not for the job with rtamt)

        metafunc.parametrize("any_solver", installed(), indirect=True)


@pytest.fixture
def any_solver(request: pytest.FixtureRequest) -> Solver:
    """The solver of a name; skipped where it may not be used."""
    from tsplan.errors import SolverUnavailableError  # noqa: PLC0415  (as above)
    from tsplan.milp.solver import solver  # noqa: PLC0415

    try:
        return solver(request.param)
    except SolverUnavailableError as error:
        pytest.skip(str(error))
