"""`tsplan plan`: plan a mission and print what the independent check accepted."""

from __future__ import annotations

import sys
import time
from dataclasses import replace
from typing import TYPE_CHECKING

from tsplan.cli.arguments import Exit
from tsplan.cli.inputs import mission_of, refuse_place, refuse_solver
from tsplan.errors import SolverError
from tsplan.results.assigning import assign
from tsplan.results.plan import Plan, Status
from tsplan.results.planfile import save_plan

if TYPE_CHECKING:
    import argparse

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
    refuse_place(asked.output, "the plan")
    began = time.perf_counter()
    mission = mission_of(asked.mission)
    loaded = time.perf_counter() - began
    refuse_solver(asked.solver or mission.solver.name or "highs")
    try:
        plan = _timed(_planned(asked, mission), mission, loaded)
    except KeyboardInterrupt:
        sys.stderr.write("interrupted; there is no plan\n")
        return Exit.NO_PLAN
    if plan.has_paths and not plan.verified:
        raise SolverError("the plan that was found has not been checked; it is not shown")
    if asked.agents and plan.moves and not plan.agents:
        plan = assign(mission, plan, seed=asked.seed)
    if asked.output is not None:
        save_plan(plan, asked.output)
    if asked.json:
        sys.stdout.write(plan.to_json())
    elif not asked.quiet:
        _summarise(plan)
    if plan.status is Status.INFEASIBLE and not asked.quiet:
        sys.stderr.write(f"to see why, and what would help: tsplan explain {asked.mission}\n")
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
