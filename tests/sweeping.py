"""A small sweep as files, and what is asked of the tables of sweeps."""

from __future__ import annotations

import csv
from pathlib import Path

from tests.missions import FILES as MISSION_FILES

SWEEP = """\
format: tsplan-sweep/1
mission: mission.yaml
axes:
  parameters: {horizon: [6, 7]}
  formulas:
    near: F[0,3] B
    never: F[0,3] sum(B) >= 3
    torn: F[0,3] (B
"""
FILES = {**MISSION_FILES, "sweep.yaml": SWEEP}
ENDS = ["optimal", "infeasible", "error"] * 2


def table(path: Path) -> list[dict[str, str]]:
    """The rows of a CSV file."""
    with path.open(encoding="utf-8", newline="") as stream:
        return list(csv.DictReader(stream))


def lines(path: Path) -> list[str]:
    """The lines of a journal."""
    return path.read_text(encoding="utf-8").splitlines()
