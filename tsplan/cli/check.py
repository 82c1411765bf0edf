"""`tsplan check`: judge a plan with the evaluator alone."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING

from tsplan.cli.arguments import Exit
from tsplan.cli.inputs import mission_and_plan
from tsplan.errors import clipped
from tsplan.results.checking import check

if TYPE_CHECKING:
    import argparse


def run(asked: argparse.Namespace) -> Exit:
    """Print what holds of a plan, or what does not."""
    mission, plan = mission_and_plan(asked.mission, asked.plan)
    report = check(mission, plan)
    for finding in report.findings:
        sys.stdout.write(f"{asked.plan}: {clipped(finding.message)}\n")
    if not report.ok:
        return Exit.REFUSED
    if not asked.quiet:
        for fact in report.facts:
            sys.stdout.write(f"{fact}\n")
        if plan.mission.sha256 != mission.digest:
            sys.stdout.write("the mission file has changed since the plan was made\n")
        sys.stdout.write("the plan is accepted\n")
    return Exit.DONE
