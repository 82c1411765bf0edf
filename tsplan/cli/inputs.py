"""Reading what a command is given."""

from __future__ import annotations

import sys
from dataclasses import replace
from typing import TYPE_CHECKING

from tsplan.mission import load_mission

if TYPE_CHECKING:
    from collections.abc import Iterable
    from pathlib import Path

    from tsplan.errors import Finding
    from tsplan.mission import Mission


def mission_of(path: Path) -> Mission:
    """The mission of a file, its warnings written to stderr."""
    mission = load_mission(path)
    warn(mission.warnings)
    return mission


def warn(findings: Iterable[Finding]) -> None:
    """Write findings that do not stop the work, one a line."""
    for finding in findings:
        marked = replace(finding, message=f"warning: {finding.message}")
        sys.stderr.write(" ".join(str(marked).splitlines()) + "\n")
