"""`tsplan plan`: plan a mission of either kind and print what the independent check accepted."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any, cast

from tsplan.checking.assignment import assign
from tsplan.checking.fitting import refuse_pathless
from tsplan.cli.arguments import Exit
from tsplan.cli.inputs import mission_to_solve, refuse_place
from tsplan.cli.output import attempted, console, remark, say_json
from tsplan.cli.progress import Progress
from tsplan.errors import Finding, InputError, SolverError
from tsplan.mission import Mission
from tsplan.plans.outcomes import FOUND, Status
from tsplan.plans.plan import Plan
from tsplan.plans.plan_file import EachAgent, Written, load_plan, save_plan
from tsplan.process.child_process import may_have_children
from tsplan.process.interrupt import Requests
from tsplan.replanning.receding_horizon import plan_in_pieces
from tsplan.run.isolate import Order, Planning
from tsplan.signals.mission_order import order_for, with_reading
from tsplan.signals.trajectory_summary import trajectory_lines

if TYPE_CHECKING:
    import argparse

    from tsplan.signals.result_check import Result

CODES = {
    Status.OPTIMAL: Exit.DONE,
    Status.FEASIBLE: Exit.DONE,
    Status.INFEASIBLE: Exit.INFEASIBLE,
    Status.NO_PLAN_FOUND: Exit.NO_PLAN,
    Status.ERROR: Exit.FAILED,
}
"""How a command ends that plans, by what is known then."""


def run(options: argparse.Namespace) -> Exit:
    """Plan, write the plan, show it, and say by the exit code how it ended."""
    mission, choice, loaded = mission_to_solve(options, "the plan")
    refuse_place(options.certificate, "the certificate", [options.mission, options.output])
    order = order_for(mission, choice, options.encoding, tuple(options.without))
    order = replace(order, anytime=options.anytime, log=options.log_solver, start=_start(options))
    order = replace(order, certified=options.certified, certificate=options.certificate)
    requests, unwritten = Requests(quiet=options.quiet), None
    with requests.heard():
        if not (may_have_children() or options.quiet):
            remark("this process may start no other: a crash of the solver would end it")
        with Progress(quiet=options.quiet) as progress:
            made = _planned(Planning(progress, requests), order, options)
            plan = with_reading(made, mission, loaded)
        if plan.status in FOUND and not plan.verified:
            raise SolverError("the plan that was found has not been checked; it is not shown")
        if options.agents and isinstance(plan, Plan) and plan.moves and not plan.agents:
            plan = assign(cast("Mission", mission), plan, seed=options.seed)
        if options.output is not None:
            unwritten = attempted(lambda: save_plan(_written(plan, options), options.output))
    show(plan, options)
    if plan.status is Status.INFEASIBLE and not options.quiet:
        remark(f"to see why, and what would help: tsplan explain {options.mission}")
    if unwritten is not None:
        raise unwritten
    return CODES[plan.status]


def _planned(planning: Planning, order: Order, options: argparse.Namespace) -> Any:
    """The plan, in one piece or in windows."""
    if options.window is None:
        if options.commit is not None:
            raise InputError([Finding("--commit is for windows", "add --window STEPS")])
        return planning.plan(order)
    if not isinstance(order.mission, Mission) or order.start is not None:
        what = "missions over signals, and plans to start with, are planned in one piece"
        raise InputError([Finding(what, "leave --window out")])

    def planner(mission: Mission, *, time_limit: float | None = None, **_: Any) -> Plan:
        choice = replace(order.choice, time_limit=time_limit)
        return cast("Plan", planning.plan(replace(order, mission=mission, choice=choice)))

    commit = options.commit or max(options.window // 3, 1)
    limit = order.choice.time_limit
    limits: dict[str, Any] = {} if limit is None else {"time_limit": limit}
    return plan_in_pieces(order.mission, options.window, commit, planner=planner, **limits)


def _start(options: argparse.Namespace) -> Plan | None:
    """The plan that the search is to begin with."""
    if options.start is None:
        return None
    refuse_place(options.output, "the plan", [options.start])
    plan = load_plan(options.start)
    refuse_pathless(plan, str(options.start))
    return plan


def _written(plan: Result, options: argparse.Namespace) -> Written:
    """What is written as JSON: with `--agents` every agent has an entry of its own."""
    return EachAgent(plan) if options.agents and isinstance(plan, Plan) else plan


def show(plan: Result, options: argparse.Namespace) -> None:
    """Print a result as JSON or in words, unless nothing is to be said."""
    if options.json:
        say_json(_written(plan, options).to_json())
    elif not options.quiet:
        from tsplan.plans.summary import WIDTH, print_parts, summary  # noqa: PLC0415  (needs rich, slow)

        parts = summary(plan) if isinstance(plan, Plan) else trajectory_lines(plan)
        print_parts(parts, console(WIDTH))
