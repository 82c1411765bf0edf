"""`tsplan plan`: plan a mission and print what the independent check accepted."""

from __future__ import annotations

import os
import sys
import time
from dataclasses import replace
from typing import TYPE_CHECKING

from tsplan.cli.arguments import Exit
from tsplan.cli.inputs import mission_of
from tsplan.errors import Finding, InputError, SolverError, nearest
from tsplan.results.plan import Plan, Status
from tsplan.results.planfile import save_plan

if TYPE_CHECKING:
    import argparse
    from pathlib import Path

    from tsplan.mission import Mission

_CODES = {
    Status.OPTIMAL: Exit.DONE,
    Status.FEASIBLE: Exit.DONE,
    Status.INFEASIBLE: Exit.INFEASIBLE,
    Status.NO_PLAN_FOUND: Exit.NO_PLAN,
    Status.ERROR: Exit.FAILED,
}
_PIPE_WIDTH = 120  # columns where there is no terminal to ask


def run(asked: argparse.Namespace) -> Exit:
    """Plan, show the plan, and say by the exit code how it ended."""
    _refuse_place(asked.output)
    began = time.perf_counter()
    mission = mission_of(asked.mission)
    loaded = time.perf_counter() - began
    _refuse_solver(asked.solver or mission.solver.name or "highs")
    try:
        plan = _timed(_planned(asked, mission), mission, loaded)
    except KeyboardInterrupt:
        sys.stderr.write("interrupted; there is no plan\n")
        return Exit.NO_PLAN
    if plan.has_paths and not plan.verified:
        raise SolverError("the plan that was found has not been checked; it is not shown")
    if asked.output is not None:
        save_plan(plan, asked.output)
    if asked.json:
        sys.stdout.write(plan.to_json())
    elif not asked.quiet:
        _summarise(plan)
    return _CODES[plan.status]


def _planned(asked: argparse.Namespace, mission: Mission) -> Plan:
    from tsplan.cli.progress import Progress  # noqa: PLC0415  (the solver's module comes first)
    from tsplan.cli.running import Order, planned  # noqa: PLC0415

    order = Order(
        solver=asked.solver,
        time_limit=asked.time_limit,
        gap=asked.gap,
        threads=asked.threads,
        seed=asked.seed,
        encoding=asked.encoding,
        without=tuple(asked.without),
    )
    with Progress(quiet=asked.quiet) as progress:
        return planned(mission, order, progress)


def _refuse_place(path: Path | None) -> None:
    """Say at once that the plan could not be written, not after the search."""
    if path is None:
        return
    folder = path.resolve().parent
    if path.is_dir():
        what = "cannot write the plan: this is a directory"
    elif not folder.is_dir():
        what = "cannot write the plan: its directory does not exist"
    elif not os.access(path if path.exists() else folder, os.W_OK):
        what = "cannot write the plan: no permission"
    else:
        return
    raise InputError([Finding(what, "choose another file", str(path))])


def _refuse_solver(name: str) -> None:
    """A misspelt solver is wrong usage; one that is missing or not licensed fails later."""
    from tsplan.milp.solver import SOLVERS  # noqa: PLC0415  (needs numpy and scipy)

    if name.partition(":")[0] not in SOLVERS:
        raise InputError([Finding(f"there is no solver '{name}'", nearest(name, SOLVERS))])


def _timed(plan: Plan, mission: Mission, loaded: float) -> Plan:
    """The plan with the seconds that reading the mission took."""
    timings = replace(
        plan.timings,
        load=loaded - mission.parse_seconds,
        parse=mission.parse_seconds,
        total=plan.timings.total + loaded,
    )
    return replace(plan, timings=timings)


def _summarise(plan: Plan) -> None:
    from rich.console import Console  # noqa: PLC0415  (slow to import)

    from tsplan.results.summary import print_summary  # noqa: PLC0415

    console = Console()
    print_summary(plan, console if console.is_terminal else Console(width=_PIPE_WIDTH))
