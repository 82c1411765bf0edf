"""`tsplan check`: judge a plan with the evaluator alone."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING

from tsplan.cli.arguments import Exit
from tsplan.cli.inputs import mission_of
from tsplan.errors import InputError
from tsplan.results.checking import check
from tsplan.results.planfile import load_plan

if TYPE_CHECKING:
    import argparse

    from tsplan.errors import Finding
    from tsplan.mission import Mission
    from tsplan.results.plan import Plan


def run(asked: argparse.Namespace) -> Exit:
    """Print what holds of a plan, or what does not."""
    mission, plan = _both(asked)
    report = check(mission, plan)
    for finding in report.findings:
        sys.stdout.write(f"{asked.plan}: {finding.message}\n")
    if not report.ok:
        return Exit.REFUSED
    if not asked.quiet:
        for fact in report.facts:
            sys.stdout.write(f"{fact}\n")
        if plan.mission.sha256 != mission.digest:
            sys.stdout.write("the mission file has changed since the plan was made\n")
        sys.stdout.write("the plan is accepted\n")
    return Exit.DONE


def _both(asked: argparse.Namespace) -> tuple[Mission, Plan]:
    """The mission and the plan, or the findings of both."""
    findings: list[Finding] = []
    try:
        mission = mission_of(asked.mission)
    except InputError as error:
        findings += error.findings
    try:
        plan = load_plan(asked.plan)
    except InputError as error:
        findings += error.findings
    if findings:
        raise InputError(findings)
    return mission, plan
