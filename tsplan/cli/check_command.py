"""`tsplan check`: judge a plan with the evaluator alone."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tsplan.checking.plan_check import check
from tsplan.cli.arguments import Exit
from tsplan.cli.inputs import mission_and_plan
from tsplan.cli.output import say
from tsplan.errors import clipped

if TYPE_CHECKING:
    import argparse


def run(options: argparse.Namespace) -> Exit:
    """Print what holds of a plan, or what does not."""
    mission, plan = mission_and_plan(options.mission, options.plan)
    report = check(mission, plan)
    for finding in report.findings:
        say(f"{options.plan}: {clipped(finding.message)}")
    if not report.ok:
        return Exit.REFUSED
    if not options.quiet:
        for fact in report.facts:
            say(fact)
        if plan.mission.sha256 != mission.digest:
            say("the mission file has changed since the plan was made")
        say("the plan is accepted")
    return Exit.DONE
