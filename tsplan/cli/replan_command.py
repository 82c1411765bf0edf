"""`tsplan replan`: plan again from a step of a plan on, as things are there."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Any, cast

from tsplan.cli.arguments import Exit
from tsplan.cli.inputs import mission_to_solve, refuse_place, warn
from tsplan.cli.output import attempted, console
from tsplan.cli.plan_command import CODES, show
from tsplan.cli.progress import Progress
from tsplan.cli.told_explanation import Heard, explained
from tsplan.cli.world_options import world_given
from tsplan.errors import Finding, InputError, PlanError
from tsplan.explanation.report import WIDTH, Report
from tsplan.mission import Mission
from tsplan.plans.outcomes import Status
from tsplan.plans.plan_file import load_plan, save_plan
from tsplan.process.interrupt import Requests
from tsplan.replanning.replanner import left, planned_again
from tsplan.run.isolate import Order, Planning

if TYPE_CHECKING:
    import argparse

    from tsplan.milp.solver_choice import SolverChoice
    from tsplan.plans.plan import Plan
    from tsplan.plans.worlds import World


def run(options: argparse.Namespace) -> Exit:
    """Plan the rest, write the whole plan, show it, or say why there is none."""
    refuse_place(options.output, "the plan", [options.plan, options.world])
    refuse_place(options.rest, "the mission", [options.plan, options.world, options.mission])
    given, choice, _ = mission_to_solve(options, "the plan")
    if not isinstance(given, Mission):
        what = "a mission over signals is carried out by a controller"
        raise InputError([Finding(what, "see tsplan.Controller in docs/signals.md")])
    plan = load_plan(options.plan)
    world = world_given(options, given, plan)
    try:
        return _replanned(given, plan, world, choice, options)
    except PlanError as error:
        raise PlanError(_named(error, options)) from None


def _named(error: PlanError, options: argparse.Namespace) -> list[Finding]:
    """Findings without a place are about the plan and what is said of it."""
    return [replace(f, source=f.source or str(options.plan)) for f in error.findings]


def _replanned(
    mission: Mission, plan: Plan, world: World, choice: SolverChoice, options: argparse.Namespace
) -> Exit:
    objective = tuple(options.objective) or None
    found = left(mission, plan, world, objective)
    rest = found.rest.mission
    warn(rest.warnings)
    requests, unwritten = Requests(quiet=options.quiet), None
    with requests.heard():
        with Progress(quiet=options.quiet) as progress:

            def planner(asked: Mission, *, start: Plan) -> Plan:
                order = Order(asked, choice, anytime=options.anytime, start=start)
                return cast("Plan", Planning(progress, requests).plan(order))

            made = planned_again(mission, plan, found, planner=planner)
        if options.rest is not None:
            unwritten = attempted(partial(rest.save, options.rest))
        if options.output is not None and made.has_paths:
            unwritten = attempted(partial(save_plan, made, options.output)) or unwritten
    show(made, options)
    if made.status is Status.INFEASIBLE and not (options.quiet or options.json):
        _explain(rest, choice, world.step)
    if unwritten is not None:
        raise unwritten
    return CODES[made.status]


def _explain(rest: Mission, choice: SolverChoice, step: int) -> None:
    """Say why nothing can be saved, and what would help; its steps count from where it begins."""
    from tsplan.cli.output import say  # noqa: PLC0415  (after the plan)

    say(f"why nothing can be saved (its step 0 is step {step} of the plan):")
    report = Report(rest, console(WIDTH))
    requests: Any = Requests(what=b"what is known")
    with requests.heard(), Progress(quiet=False) as progress:
        heard = Heard(rest.name, report, progress)
        report.finish(explained(rest, choice, requests, heard))
