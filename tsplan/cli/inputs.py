"""Reading what a command is given."""

from __future__ import annotations

import sys
from dataclasses import replace
from typing import TYPE_CHECKING

from tsplan.errors import InputError
from tsplan.mission import load_mission
from tsplan.results.planfile import load_plan

if TYPE_CHECKING:
    from collections.abc import Iterable
    from pathlib import Path

    from tsplan.errors import Finding
    from tsplan.mission import Mission
    from tsplan.results.plan import Plan


def mission_of(path: Path) -> Mission:
    """The mission of a file, its warnings written to stderr."""
    mission = load_mission(path)
    warn(mission.warnings)
    return mission


def mission_and_plan(mission_path: Path, plan_path: Path) -> tuple[Mission, Plan]:
    """The mission and the plan of two files, or the findings of both."""
    findings: list[Finding] = []
    try:
        mission = mission_of(mission_path)
    except InputError as error:
        findings += error.findings
    try:
        plan = load_plan(plan_path)
    except InputError as error:
        findings += error.findings
    if findings:
        raise InputError(findings)
    return mission, plan


def warn(findings: Iterable[Finding]) -> None:
    """Write findings that do not stop the work, one a line."""
    for finding in findings:
        marked = replace(finding, message=f"warning: {finding.message}")
        sys.stderr.write(" ".join(str(marked).splitlines()) + "\n")
