"""`tsplan execute`: carry out a plan, by chance many times or with real robots, and replan."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, cast

from tsplan.checking.fitting import refuse_misfit
from tsplan.cli.arguments import Exit
from tsplan.cli.inputs import any_mission_of, files_of, refuse_place, refuse_solver
from tsplan.cli.output import attempted, remark, say, say_json
from tsplan.cli.progress import Progress
from tsplan.draw.matplotlib_loading import library
from tsplan.draw.picture_files import kind_of, save_picture
from tsplan.draw.trial_chart import draw_trial
from tsplan.errors import Finding, InputError, PlanError
from tsplan.milp.solver_choice import SolverChoice
from tsplan.mission import Mission
from tsplan.plans.plan_file import load_plan, save_plan
from tsplan.process.interrupt import Requests
from tsplan.replanning.execution import Executed, Execution
from tsplan.replanning.execution_journal import ExecutionJournal, Kept
from tsplan.replanning.execution_trial import SECONDS, execute, refuse_inexecutable
from tsplan.replanning.robot_process import RobotProcess, RobotsError
from tsplan.run.isolate import Order, Planning

if TYPE_CHECKING:
    import argparse

    from tsplan.plans.plan import Plan
    from tsplan.replanning.execution_trial import TrialRun
    from tsplan.replanning.robot_fleet import Seen


def run(options: argparse.Namespace) -> Exit:
    """Carry out the plan, and tell what came of it."""
    if options.robots is not None and options.plot is not None:
        remedy = "show what happened with tsplan show PLAN --executed FILE"
        raise InputError([Finding("--plot is for runs by chance", remedy)])
    if options.robots is None and (options.journal or options.output):
        remedy = "name the robots with --robots, or leave these out"
        raise InputError([Finding("-o and --journal are for one execution by robots", remedy)])
    mission = any_mission_of(options.mission)
    if not isinstance(mission, Mission):
        what = "a mission over signals is carried out by a controller"
        raise InputError([Finding(what, "see tsplan.Controller in docs/signals.md")])
    refuse_inexecutable(mission)
    plan = load_plan(options.plan)
    try:
        refuse_misfit(plan, mission, str(options.plan))
    except PlanError:
        if not plan.replanned:
            raise
    if options.robots is not None:
        return _with_robots(mission, plan, options)
    return _by_chance(mission, plan, options)


def _by_chance(mission: Mission, plan: Plan, options: argparse.Namespace) -> Exit:
    if options.plot is not None:
        kind_of(options.plot)
        library("figure")
        refuse_place(options.plot, "the picture", [options.plan, *files_of(mission)])
    shown = None if options.quiet else _Shown(options.runs)
    trial = execute(
        mission,
        plan,
        runs=options.runs,
        seed=options.seed or 0,
        delay=options.delay,
        loss=options.loss,
        close=options.close,
        replanning=options.replanning,
        time_limit=options.time_limit or SECONDS,
        on_run=shown,
    )
    if options.json:
        say_json(trial.to_json())
    else:
        say(str(trial))
    if options.plot is not None and trial.runs:
        save_picture(draw_trial(trial), options.plot, tell=remark)
    return Exit.DONE if trial.runs else Exit.INTERRUPTED


class _Shown:
    """Tells on stderr how far the runs are, every tenth of them."""

    def __init__(self, runs: int) -> None:
        self._runs = runs
        self._done = 0

    def __call__(self, run: TrialRun) -> None:
        self._done += 1
        if self._done % max(self._runs // 10, 1) == 0:
            remark(f"{self._done} of {self._runs} runs")


def _with_robots(mission: Mission, plan: Plan, options: argparse.Namespace) -> Exit:
    """One execution by another process, which goes on where its journal ends."""
    inputs = [options.plan, *files_of(mission)]
    for place, what in ((options.output, "the plan"), (options.journal, "the journal")):
        refuse_place(place, what, inputs)
    choice = SolverChoice(options.solver, options.time_limit or SECONDS).over(mission.solver)
    refuse_solver(choice.name or "highs")
    journal = None if options.journal is None else ExecutionJournal(options.journal)
    kept = None if journal is None else journal.read(mission.digest)
    fleet, requests = RobotProcess(options.robots, options.patience), Requests(quiet=options.quiet)

    def planner(asked: Mission, *, start: Plan) -> Plan:
        with requests.heard(), Progress(quiet=options.quiet) as progress:
            return cast(
                "Plan", Planning(progress, requests).plan(Order(asked, choice, start=start))
            )

    def keep(seen: Seen, changed: Plan | None) -> None:
        if journal is not None:
            journal.keep(seen, changed)
        if not options.quiet and changed is not None:
            remark(f"step {seen.step}: the plan is another one from here on")

    if journal is not None:
        journal.begin(plan)
    asked = planner if options.replanning else None
    execution = Execution(mission, plan if kept is None else kept.plan, fleet, asked, keep)
    try:
        _resume(execution, kept)
        done = execution.run()
    except RobotsError as error:
        again = "; the same command goes on from there" if journal is not None else ""
        raise RobotsError(f"{error} (step {execution.step} was the last{again})") from None
    finally:
        fleet.end()
    return _told(done, options)


def _resume(execution: Execution, kept: Kept | None) -> None:
    """Take in what a journal has seen that is not in its plan yet."""
    if kept is None:
        return
    for seen in kept.seen:
        execution.take(seen)


def _told(done: Executed, options: argparse.Namespace) -> Exit:
    unwritten = None
    plan = replace(done.plan, notes=(*done.plan.notes, "this is what happened"))
    if options.output is not None:
        unwritten = attempted(lambda: save_plan(plan, options.output))
    otherwise = f"{done.adapted} steps otherwise, planned again {len(done.replanned)} times"
    say(f"{done.verdict}; {otherwise}")
    if unwritten is not None:
        raise unwritten
    return Exit.DONE if done.met or done.satisfaction is not None else Exit.REFUSED
