"""Reading what a command is given."""

from __future__ import annotations

import os
import sys
from dataclasses import replace
from typing import TYPE_CHECKING

from tsplan.errors import Finding, InputError, nearest
from tsplan.mission import load_mission

if TYPE_CHECKING:
    from collections.abc import Iterable
    from pathlib import Path

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


def refuse_place(path: Path | None, what: str) -> None:
    """Say at once that a file could not be written, not after the search."""
    if path is None:
        return
    folder = path.resolve().parent
    if path.is_dir():
        why = "this is a directory"
    elif not folder.is_dir():
        why = "its directory does not exist"
    elif not os.access(path if path.exists() else folder, os.W_OK):
        why = "no permission"
    else:
        return
    raise InputError([Finding(f"cannot write {what}: {why}", "choose another file", str(path))])


def refuse_solver(name: str) -> None:
    """A misspelt solver is wrong usage; one that is missing or not licensed fails later."""
    from tsplan.milp.solver import SOLVERS  # noqa: PLC0415  (needs numpy and scipy)

    if name.partition(":")[0] not in SOLVERS:
        raise InputError([Finding(f"there is no solver '{name}'", nearest(name, SOLVERS))])
