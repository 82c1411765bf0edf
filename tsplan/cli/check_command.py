"""`tsplan check`: judge a plan or a trajectory with the evaluator alone."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tsplan.cli.arguments import Exit
from tsplan.cli.inputs import mission_and_result
from tsplan.cli.output import say
from tsplan.errors import clipped
from tsplan.signals.result_check import check

if TYPE_CHECKING:
    import argparse


def run(options: argparse.Namespace) -> Exit:
    """Print what holds of a plan or a trajectory, or what does not."""
    mission, result = mission_and_result(options.mission, options.plan)
    report = check(mission, result)
    for finding in report.findings:
        say(f"{options.plan}: {clipped(finding.message)}")
    if not report.ok:
        return Exit.REFUSED
    if not options.quiet:
        for fact in report.facts:
            say(fact)
        if result.mission.sha256 != mission.digest:
            say(f"the mission file has changed since the {report.noun} was made")
        say(report.verdict)
    return Exit.DONE
